function result = dd_multiply_double(x, y)
%DD_MULTIPLY_DOUBLE  x y with a double y (algorithm 7).
  c = spragsym.kernel.two_product(x.high, y);
  v = spragsym.kernel.fast_two_sum(c.high, x.low .* y);
  result = spragsym.kernel.fast_two_sum(v.high, v.low + c.low);
end
