function [result1, result2, result3, result4, result5, result6, result7] = fold_sextic(a_f, b_f, d_f, m_f, a_v, b_v, d_v, ...
    m_v)
%FOLD_SEXTIC  Coefficients of e0 + … + e6 t⁶ = (1 + t²)³ (f′ f_v − f f_v′) with t = tan(θ/2), whose roots are all folds
%  along a parameter v but θ₀; minus its sign is that of dv/dθ on the surface. Returns e0, …, e6, elements one after the
%  other. Source: f = f′ = 0. Operations: 34.
  ab = a_f.*b_v - a_v.*b_f;
  bd = b_f.*d_v - b_v.*d_f;
  bm = b_f.*m_v - b_v.*m_f;
  am = a_f.*m_v - a_v.*m_f;
  dm = d_f.*m_v - d_v.*m_f;
  ad = a_f.*d_v - a_v.*d_f;
  w0 = 4.*bm;
  w1 = 3.*bd;
  w2 = 3.*ab - 4.*dm;
  result1 = ab - bd;
  result2 = w0;
  result3 = 4.*am - w1 - w2;
  result4 = -8.*ad;
  result5 = 4.*am - w1 + w2;
  result6 = w0;
  result7 = -ab - bd;
end
