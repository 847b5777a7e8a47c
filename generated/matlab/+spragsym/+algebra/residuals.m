function [result1, result2] = residuals(cos, sin, L, cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
%RESIDUALS  F_x and F_y at spring length L and direction θ. Returns F_x, F_y, elements one after the other. Source:
%  (12)–(15). Operations: 17.
  w0 = sigma.*(1 - L);
  w1 = -L.*sin + sin0;
  result1 = alpha.*(-L.*cos + cos0) + cos.*w0 + mu0.*nbar.*w1;
  result2 = kappa + sin.*w0 + w1.*(beta + nbar);
end
