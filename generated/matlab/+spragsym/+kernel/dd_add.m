function result = dd_add(x, y)
%DD_ADD  x + y (algorithm 6).
  s = spragsym.kernel.two_sum(x.high, y.high);
  t = spragsym.kernel.two_sum(x.low, y.low);
  v = spragsym.kernel.fast_two_sum(s.high, s.low + t.high);
  result = spragsym.kernel.fast_two_sum(v.high, t.low + v.low);
end
