function [result1, result2] = f_magnitudes(cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
%F_MAGNITUDES  Sums of the absolute values of the terms of a and d, against which their rounding errors are
%  measured.
%  Returns |a|, |d|, elements one after the other.
%
%  cos0: cos θ₀
%  sin0: sin θ₀
%  mu0: friction coefficient at full slip
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%  nbar: 1 in contact, 0 in lift-off
%
%  Source: rounding-error analysis. Operations: 12.
  B = beta + nbar;
  M = mu0.*nbar;
  q = B + sigma;
  result1 = sigma.*(B + alpha);
  result2 = M.*(kappa + sigma.*sin0) + alpha.*q.*abs(cos0);
end
