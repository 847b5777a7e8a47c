function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10, result11, result12] = ...
    unfolding(cos, sin, cos0, sin0, mu0, kappa, alpha, sigma, beta)
%UNFOLDING  ∂f/∂v and ∂f′/∂v for v = θ₀, μ₀, κ, α, σ, β in turn. Returns ((f_θ₀, f′_θ₀), …, (f_β, f′_β)), elements one after
%  the other. Source: f = f′ = 0. Operations: 90.
  w0 = alpha + sigma;
  w1 = cos0.*(alpha.*beta + beta.*sigma + w0);
  w2 = alpha.*sin0;
  w3 = -beta.*w2 + cos0.*mu0.*sigma - sigma.*w2 - w2;
  w4 = sigma.*sin;
  w5 = sigma.*sin0;
  w6 = kappa - w5;
  w7 = mu0.*sin;
  w10 = beta.*sin0 + kappa + sin0;
  w8 = beta + 1;
  w9 = sigma + w8;
  sin_2 = sin.*sin;
  w11 = sigma.*sin_2;
  cos_2 = cos.*cos;
  w12 = cos_2.*sigma;
  w13 = sin.*w10;
  w14 = alpha.*cos0;
  w15 = mu0.*sin0 + w14;
  w16 = alpha.*sin;
  w17 = -alpha + w8;
  result1 = -cos.*w1 + sin.*w3;
  result2 = cos.*w3 + sin.*w1;
  result3 = sin.*(-w4 - w6);
  result4 = cos.*(-2.*w4 - w6);
  result5 = -cos.*w0 - w7;
  result6 = -cos.*mu0 + sin.*w0;
  result7 = -cos.*(w10 + w4) + cos0.*sin.*w9;
  result8 = cos.*cos0.*w9 + w11 - w12 + w13;
  result9 = cos.*(beta.*sin + sin - w10 - w16) - mu0.*sin_2 + sin.*w15;
  result10 = cos.*(w15 - 2.*w7) + cos_2.*w17 - sin_2.*w17 + w13;
  result11 = cos.*(-w2 + w4 - w5) + cos0.*w16;
  result12 = cos.*w14 + sin.*sin0.*w0 - w11 + w12;
end
