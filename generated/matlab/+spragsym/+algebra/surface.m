function result1 = surface(cos, sin, cos0, sin0, kappa, alpha, sigma, beta)
%SURFACE  μ₀ on the equilibrium surface over (θ, θ₀): f is linear in μ₀. Returns mu0, elements one after the other. Source:
%  (14), (15). Operations: 22.
  B = beta + 1;
  a_f = sigma.*(B - alpha);
  p = alpha + sigma;
  b_f = -p.*(B.*sin0 + kappa);
  q = B + sigma;
  result1 = (a_f.*cos.*sin + alpha.*cos0.*q.*sin + b_f.*cos)./(sin.*(kappa - sigma.*(-sin + sin0)));
end
