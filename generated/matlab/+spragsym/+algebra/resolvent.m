function [result1, result2, result3] = resolvent(a_f, b_f, d_f, m_f)
%RESOLVENT  Coefficients of the cubic r0 + r1 ℓ + r2 ℓ² + ℓ³ with the discriminant of the quartic in t. Returns r0, r1, r2,
%  elements one after the other. Source: (12), (13) eliminated. Operations: 15.
  a_f_2 = a_f.*a_f;
  b_f_2 = b_f.*b_f;
  d_f_2 = d_f.*d_f;
  result1 = -b_f.*(a_f.*d_f + b_f.*m_f)./4;
  result2 = -a_f_2./4 + b_f_2./4 + d_f_2./4;
  result3 = -m_f;
end
