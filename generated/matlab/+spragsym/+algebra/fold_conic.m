function [result1, result2, result3, result4] = fold_conic(cos, sin, kappa, alpha, sigma, beta)
%FOLD_CONIC  All folds at a given θ, friction eliminated: E0 + E1 sin θ₀ + E2 sin² θ₀ + Ec cos θ₀ = 0, for any α ≥ 0.
%  Returns E0, E1, E2, Ec, elements one after the other. Source: f = f′ = 0. Operations: 32.
  B = beta + 1;
  a_f = sigma.*(B - alpha);
  p = alpha + sigma;
  q = B + sigma;
  sin_2 = sin.*sin;
  w0 = kappa + sigma.*sin.*(2 - sin_2);
  sin_3 = sin.*sin_2;
  w1 = B.*p;
  result1 = -a_f.*sin_2.*(kappa.*sin + sigma) + kappa.*p.*w0;
  result2 = -sigma.*(-a_f.*sin_3 + kappa.*p) + w0.*w1;
  result3 = -sigma.*w1;
  result4 = -alpha.*cos.*q.*sigma.*sin_2;
end
