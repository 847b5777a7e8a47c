function [result1, result2] = residuals(cos, sin, L, cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
%RESIDUALS  F_x and F_y at spring length L and direction θ.
%  Returns F_x, F_y, elements one after the other.
%
%  cos: cos θ
%  sin: sin θ
%  L: spring length over L_0
%  cos0: cos θ₀
%  sin0: sin θ₀
%  mu0: friction coefficient at full slip
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%  nbar: 1 in contact, 0 in lift-off
%
%  Source: (12)–(15). Operations: 17.
  w0 = sigma.*(1 - L);
  w1 = -L.*sin + sin0;
  result1 = alpha.*(-L.*cos + cos0) + cos.*w0 + mu0.*nbar.*w1;
  result2 = kappa + sin.*w0 + w1.*(beta + nbar);
end
