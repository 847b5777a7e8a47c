function result = wide_polish(A1, A2, A3, p1, q1, p2, q2)
%WIDE_POLISH  One Newton step on both factors of t⁴ + A3 t³ + A2 t² + A1 t − 1 at once.
%
%  The change of the second factor is the remainder over the first, modulo the second. q1 q2 = −1 is kept by setting the
%  smaller from the larger.
  INFINITY = Inf;
  r3 = spragsym.kernel.dd_add(A3, spragsym.kernel.dd_negative(spragsym.kernel.dd_add(p1, p2)));
  r2 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(A2, spragsym.kernel.dd_negative(spragsym.kernel.dd_add(q1, q2))), ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p1, p2)));
  r1 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(A1, spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p1, q2))), ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p2, q1)));
  r0 = spragsym.kernel.dd_add_double(spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(q1, q2)), -1.0);
  s1 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(r3, ...
      spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(p2, p2), spragsym.kernel.dd_negative(q2))), ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(r2, p2))), r1);
  s0 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(r3, p2), ...
      spragsym.kernel.dd_negative(r2)), q2), r0);
  du = spragsym.kernel.dd_add(p1, spragsym.kernel.dd_negative(p2));
  dv = spragsym.kernel.dd_add(q1, spragsym.kernel.dd_negative(q2));
  dw = spragsym.kernel.dd_add(dv, spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(du, p2)));
  inverse = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), ...
      spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(dv, dw), ...
      spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(du, du), q2)));
  dp2 = spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(s1, dv), ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(s0, du))), inverse);
  dq2 = spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(s0, dw), ...
      spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(s1, du), q2)), inverse);
  dp1 = spragsym.kernel.dd_add(r3, spragsym.kernel.dd_negative(dp2));
  dq1 = spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_add(r2, spragsym.kernel.dd_negative(dq2)), ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p2, dp1))), ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(p1, dp2)));
  % Where three roots meet, the factors share a root and the step is not reliable.
  new_q1 = spragsym.kernel.dd_add(q1, dq1);
  new_q2 = spragsym.kernel.dd_add(q2, dq2);
  good = (new_q1.high < 0.0) & (new_q2.high > 0.0) & spragsym.kernel.dd_less(spragsym.kernel.dd_absolute( ...
      spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_add(dp1, dp2), dq1), dq2)), ...
      spragsym.kernel.paired(INFINITY, 0.0));
  q1 = spragsym.kernel.dd_where(good, new_q1, q1);
  q2 = spragsym.kernel.dd_where(good, new_q2, q2);
  larger_second = spragsym.kernel.dd_less(spragsym.kernel.dd_negative(q1), q2);
  inverse_q = spragsym.kernel.dd_divide(spragsym.kernel.paired(-1.0, 0.0), spragsym.kernel.dd_where(larger_second, q2, q1));
  result.p1 = spragsym.kernel.dd_where(good, spragsym.kernel.dd_add(p1, dp1), p1);
  result.q1 = spragsym.kernel.dd_where(larger_second, inverse_q, q1);
  result.p2 = spragsym.kernel.dd_where(good, spragsym.kernel.dd_add(p2, dp2), p2);
  result.q2 = spragsym.kernel.dd_where(larger_second, q2, inverse_q);
end
