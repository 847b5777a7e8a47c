function result = wide_t_quartic(a_f, b_f, d_f, m_f)
%WIDE_T_QUARTIC  Coefficients of (1 + t²)² f = e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ with t = tan(θ/2).
  result.value0 = b_f;
  result.value1 = spragsym.kernel.dd_scaled(spragsym.kernel.dd_add(a_f, d_f), 2.0);
  result.value2 = spragsym.kernel.dd_scaled(m_f, -4.0);
  result.value3 = spragsym.kernel.dd_scaled(spragsym.kernel.dd_add(spragsym.kernel.dd_negative(a_f), d_f), 2.0);
  result.value4 = spragsym.kernel.dd_negative(b_f);
end
