function [result1, result2, result3] = pole_quadratic(mu0, alpha, sigma, beta)
%POLE_QUADRATIC  Coefficients of e0 + e1 T + e2 T², whose roots T = tan θ₀ are the poles.
%  Returns e0, e1, e2, elements one after the other.
%
%  mu0: friction coefficient at full slip
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%
%  Source: determinant of the linear model. Operations: 7.
  w0 = beta + 1;
  result1 = w0.*(alpha + sigma);
  result2 = -mu0.*sigma;
  result3 = alpha.*(sigma + w0);
end
