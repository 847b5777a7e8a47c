function [result1, result2] = fold_residuals(cos, sin, a_f, b_f, d_f, m_f)
%FOLD_RESIDUALS  Both are zero exactly where f = f′ = 0. Returns b − b(fold), d − d(fold), elements one after the other.
%  Source: f = f′ = 0. Operations: 14.
  sin_2 = sin.*sin;
  cos_2 = cos.*cos;
  cos_3 = cos.*cos_2;
  result1 = b_f + sin_2.*(a_f.*sin + cos.*m_f);
  result2 = a_f.*cos_3 + d_f - m_f.*sin.*(cos_2 + 1);
end
