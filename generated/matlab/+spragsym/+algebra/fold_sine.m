function result1 = fold_sine(cos, sin, mu0, kappa, alpha, sigma, beta)
%FOLD_SINE  sin θ₀ of the fold through θ at friction μ₀, for any α ≥ 0.
%  Returns sin0, elements one after the other.
%
%  cos: cos θ
%  sin: sin θ
%  mu0: friction coefficient at full slip
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%
%  Source: f = f′ = 0. Operations: 16.
  B = beta + 1;
  p = alpha + sigma;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  result1 = (B.*sigma.*sin_3 - kappa.*p + sigma.*sin_2.*(-alpha.*sin + cos.*mu0))./(B.*p);
end
