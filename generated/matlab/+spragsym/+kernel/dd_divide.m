function result = dd_divide(x, y)
%DD_DIVIDE  x / y (algorithm 17).
  t = x.high ./ y.high;
  r = spragsym.kernel.dd_multiply_double(y, t);
  rest = x.high - r.high + (x.low - r.low);
  result = spragsym.kernel.fast_two_sum(t, rest ./ y.high);
end
