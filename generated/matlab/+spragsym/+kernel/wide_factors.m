function result = wide_factors(e, resolved)
%WIDE_FACTORS  The two real quadratic factors of the quartic in t.
  over = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), e.e4);
  A1 = spragsym.kernel.dd_multiply(e.e1, over);
  A2 = spragsym.kernel.dd_multiply(e.e2, over);
  A3 = spragsym.kernel.dd_multiply(e.e3, over);
  y = spragsym.kernel.dd_multiply(spragsym.kernel.dd_scaled(over, -4.0), spragsym.kernel.wide_simple_root(resolved));
  width = spragsym.kernel.dd_sqrt(spragsym.kernel.dd_add_double(spragsym.kernel.dd_multiply(y, y), 4.0));
  large = spragsym.kernel.dd_scaled(spragsym.kernel.dd_add(spragsym.kernel.dd_absolute(y), width), 0.5);
  small = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), large);
  q2 = spragsym.kernel.dd_where(y.high > 0.0, large, small);
  q1 = spragsym.kernel.dd_negative(spragsym.kernel.dd_where(y.high > 0.0, small, large));
  inverse = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), width);
  result = spragsym.kernel.wide_polish(A1, A2, A3, spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(A1, ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(A3, q1))), inverse), q1, ...
      spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(A3, q2), ...
      spragsym.kernel.dd_negative(A1)), inverse), q2);
end
