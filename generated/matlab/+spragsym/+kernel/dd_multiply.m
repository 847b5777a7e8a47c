function result = dd_multiply(x, y)
%DD_MULTIPLY  x y (algorithm 10).
  c = spragsym.kernel.two_product(x.high, y.high);
  crossed = x.high .* y.low + x.low .* y.high;
  result = spragsym.kernel.fast_two_sum(c.high, c.low + crossed);
end
