function result = dd_add_double(x, y)
%DD_ADD_DOUBLE  x + y with a double y (algorithm 4).
  s = spragsym.kernel.two_sum(x.high, y);
  result = spragsym.kernel.fast_two_sum(s.high, x.low + s.low);
end
