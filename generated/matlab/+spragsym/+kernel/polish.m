function result = polish(A1, A2, A3, p1, q1, p2, q2)
%POLISH  One Newton step on both factors of t⁴ + A3 t³ + A2 t² + A1 t − 1 at once.
%
%  The change of the second factor is the remainder over the first, modulo the second. q1 q2 = −1 is kept by setting the
%  smaller from the larger.
  INFINITY = Inf;
  r3 = A3 - (p1 + p2);
  r2 = A2 - (q1 + q2) - p1 .* p2;
  r1 = A1 - p1 .* q2 - p2 .* q1;
  r0 = -1.0 - q1 .* q2;
  s1 = r3 .* (p2 .* p2 - q2) - r2 .* p2 + r1;
  s0 = (r3 .* p2 - r2) .* q2 + r0;
  du = p1 - p2;
  dv = q1 - q2;
  dw = dv - du .* p2;
  inverse = 1.0 ./ (dv .* dw + du .* du .* q2);
  dp2 = (s1 .* dv - s0 .* du) .* inverse;
  dq2 = (s0 .* dw + s1 .* du .* q2) .* inverse;
  dp1 = r3 - dp2;
  dq1 = r2 - dq2 - p2 .* dp1 - p1 .* dp2;
  % Where three roots meet, the factors share a root and the step is not reliable.
  new_q1 = q1 + dq1;
  new_q2 = q2 + dq2;
  good = (new_q1 < 0.0) & (new_q2 > 0.0) & (abs(dp1 + dp2 + dq1 + dq2) < INFINITY);
  q1 = spragsym.kernel.where(good, new_q1, q1);
  q2 = spragsym.kernel.where(good, new_q2, q2);
  larger_second = -q1 < q2;
  inverse_q = -1.0 ./ spragsym.kernel.where(larger_second, q2, q1);
  result.p1 = spragsym.kernel.where(good, p1 + dp1, p1);
  result.q1 = spragsym.kernel.where(larger_second, inverse_q, q1);
  result.p2 = spragsym.kernel.where(good, p2 + dp2, p2);
  result.q2 = spragsym.kernel.where(larger_second, q2, inverse_q);
end
