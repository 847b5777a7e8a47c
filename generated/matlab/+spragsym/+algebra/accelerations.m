function [result1, result2] = accelerations(x, y, L, mu, n, cos0, sin0, kappa, alpha, sigma, beta)
%ACCELERATIONS  x″ and y″ for a given friction coefficient and contact force.
%  Returns x″, y″, elements one after the other.
%
%  x: displacement along the belt over L_0
%  y: displacement across the belt over L_0, negative into the belt
%  L: spring length over L_0
%  mu: friction coefficient at the current sliding speed
%  n: contact force N / (k_c L_0)
%  cos0: cos θ₀
%  sin0: sin θ₀
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%
%  Source: (8), (9) corrected. Operations: 18.
  w0 = 1./L;
  w1 = L - 1;
  result1 = -alpha.*x + mu.*n + sigma.*w0.*w1.*(cos0 - x);
  result2 = -beta.*y - kappa + n + sigma.*w0.*w1.*(sin0 - y);
end
