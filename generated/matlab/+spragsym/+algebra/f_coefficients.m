function [result1, result2, result3, result4] = f_coefficients(cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
%F_COEFFICIENTS  a, b, d, m of f(θ) = a sin θ cos θ + b cos θ + d sin θ − m sin² θ = q sin θ F_x(θ, L(θ)). Returns a, b, d,
%  m, elements one after the other. Source: (12), (13) eliminated. Operations: 17.
  B = beta + nbar;
  a_f = sigma.*(B - alpha);
  p = alpha + sigma;
  b_f = -p.*(B.*sin0 + kappa);
  M = mu0.*nbar;
  q = B + sigma;
  d_f = M.*(-kappa + sigma.*sin0) + alpha.*cos0.*q;
  m_f = M.*sigma;
  result1 = a_f;
  result2 = b_f;
  result3 = d_f;
  result4 = m_f;
end
