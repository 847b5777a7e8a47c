function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10, result11, result12, ...
    result13, result14] = fold_cubics(mu0, kappa, alpha, sigma, beta)
%FOLD_CUBICS  Coefficients in t = tan(θ/2) of (1 + t²)³ times p B sin θ₀ and p B q α cos θ₀, on the fold through θ at
%  friction μ₀. Returns (S0, …, S6), (C0, …, C6), elements one after the other. Source: f = f′ = 0. Operations: 35.
  p = alpha + sigma;
  M = mu0;
  m_f = M.*sigma;
  B = beta + 1;
  a_f = sigma.*(B - alpha);
  w0 = kappa.*p;
  w1 = -w0;
  w2 = 4.*m_f;
  w3 = 3.*w0;
  w4 = w2 - w3;
  w5 = 8.*a_f;
  w6 = -w2 - w3;
  w7 = m_f.*w0;
  w8 = M.*kappa;
  w9 = B.*p;
  w10 = w2.*w9;
  w11 = 3.*a_f;
  w12 = 3.*w8;
  result1 = w1;
  result2 = 0;
  result3 = w4;
  result4 = w5;
  result5 = w6;
  result6 = 0;
  result7 = w1;
  result8 = w7 + w9.*(-a_f + w8);
  result9 = w10;
  result10 = -m_f.*w4 + w9.*(w11 + w12);
  result11 = -m_f.*w5;
  result12 = -m_f.*w6 + w9.*(-w11 + w12);
  result13 = w10;
  result14 = w7 + w9.*(a_f + w8);
end
