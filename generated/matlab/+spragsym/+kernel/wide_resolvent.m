function result = wide_resolvent(a_f, b_f, d_f, m_f)
%WIDE_RESOLVENT  Coefficients of the cubic r0 + r1 ℓ + r2 ℓ² + ℓ³ with the discriminant of the quartic in t.
  a_f_2 = spragsym.kernel.dd_multiply(a_f, a_f);
  b_f_2 = spragsym.kernel.dd_multiply(b_f, b_f);
  d_f_2 = spragsym.kernel.dd_multiply(d_f, d_f);
  result.value0 = spragsym.kernel.dd_scaled(spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative(b_f), ...
      spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(a_f, d_f), spragsym.kernel.dd_multiply(b_f, m_f))), 0.25);
  result.value1 = ...
      spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_scaled(spragsym.kernel.dd_negative(a_f_2), 0.25), ...
      spragsym.kernel.dd_scaled(b_f_2, 0.25)), spragsym.kernel.dd_scaled(d_f_2, 0.25));
  result.value2 = spragsym.kernel.dd_negative(m_f);
end
