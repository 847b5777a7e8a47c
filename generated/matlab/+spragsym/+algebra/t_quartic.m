function [result1, result2, result3, result4, result5] = t_quartic(a_f, b_f, d_f, m_f)
%T_QUARTIC  Coefficients of (1 + t²)² f = e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ with t = tan(θ/2). Returns e0, e1, e2, e3, e4,
%  elements one after the other. Source: (12), (13) eliminated. Operations: 7.
  result1 = b_f;
  result2 = 2.*(a_f + d_f);
  result3 = -4.*m_f;
  result4 = 2.*(-a_f + d_f);
  result5 = -b_f;
end
