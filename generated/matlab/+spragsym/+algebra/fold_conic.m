function [result1, result2, result3, result4] = fold_conic(cos, sin, kappa, alpha, sigma, beta)
%FOLD_CONIC  All folds at a given θ, friction eliminated: E0 + E1 sin θ₀ + E2 sin² θ₀ + Ec cos θ₀ = 0, for any
%  α ≥ 0.
%  Returns E0, E1, E2, Ec, elements one after the other.
%
%  cos: cos θ
%  sin: sin θ
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%
%  Source: f = f′ = 0. Operations: 31.
  B = beta + 1;
  a_f = sigma.*(B - alpha);
  p = alpha + sigma;
  q = B + sigma;
  cos_2 = cos.*cos;
  cos_4 = cos_2.*cos_2;
  sin_2 = sin.*sin;
  w0 = sigma.*sin_2;
  w1 = kappa + sigma.*sin.*(cos_2 + 1);
  sin_3 = sin.*sin_2;
  w2 = -a_f.*sin_3 + kappa.*p;
  w3 = B.*p;
  result1 = -a_f.*cos_4.*w0 + w1.*w2;
  result2 = -sigma.*w2 + w1.*w3;
  result3 = -sigma.*w3;
  result4 = -alpha.*cos.*q.*w0;
end
