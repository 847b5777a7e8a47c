function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10, result11, result12, ...
    result13, result14, result15, result16, result17, result18, result19, result20, result21, result22, result23, result24] ...
    = f_changes(cos0, sin0, mu0, kappa, alpha, sigma, beta)
%F_CHANGES  Derivatives of a, b, d, m of f in contact by v = θ₀, μ₀, κ, α, σ, β in turn. Returns ((a_θ₀, b_θ₀, d_θ₀, m_θ₀),
%  …, (a_β, b_β, d_β, m_β)), elements one after the other. Source: (12), (13) eliminated. Operations: 26.
  w0 = alpha + sigma;
  w1 = beta + 1;
  w2 = sigma + w1;
  w3 = -kappa - sin0.*w1;
  w4 = alpha.*cos0;
  result1 = 0;
  result2 = -cos0.*w0.*w1;
  result3 = -alpha.*sin0.*w2 + cos0.*mu0.*sigma;
  result4 = 0;
  result5 = 0;
  result6 = 0;
  result7 = -kappa + sigma.*sin0;
  result8 = sigma;
  result9 = 0;
  result10 = -w0;
  result11 = -mu0;
  result12 = 0;
  result13 = -sigma;
  result14 = w3;
  result15 = cos0.*w2;
  result16 = 0;
  result17 = -alpha + w1;
  result18 = w3;
  result19 = mu0.*sin0 + w4;
  result20 = mu0;
  result21 = sigma;
  result22 = -sin0.*w0;
  result23 = w4;
  result24 = 0;
end
