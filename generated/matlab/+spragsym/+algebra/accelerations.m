function [result1, result2] = accelerations(x, y, L, mu, n, cos0, sin0, kappa, alpha, sigma, beta)
%ACCELERATIONS  x″ and y″ for a given friction coefficient and contact force. Returns x″, y″, elements one after the other.
%  Source: (8), (9) corrected. Operations: 18.
  w0 = 1./L;
  w1 = L - 1;
  result1 = -alpha.*x + mu.*n + sigma.*w0.*w1.*(cos0 - x);
  result2 = -beta.*y - kappa + n + sigma.*w0.*w1.*(sin0 - y);
end
