function result1 = surface(cos, sin, cos0, sin0, kappa, alpha, sigma, beta)
%SURFACE  μ₀ on the equilibrium surface over (θ, θ₀): f is linear in μ₀.
%  Returns mu0, elements one after the other.
%
%  cos: cos θ
%  sin: sin θ
%  cos0: cos θ₀
%  sin0: sin θ₀
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%
%  Source: (14), (15). Operations: 22.
  B = beta + 1;
  a_f = sigma.*(B - alpha);
  p = alpha + sigma;
  b_f = -p.*(B.*sin0 + kappa);
  q = B + sigma;
  result1 = (a_f.*cos.*sin + alpha.*cos0.*q.*sin + b_f.*cos)./(sin.*(kappa - sigma.*(-sin + sin0)));
end
