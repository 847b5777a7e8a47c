function [result1, result2, result3] = state(cos, sin, cos0, sin0, kappa, sigma, beta, nbar)
%STATE  Spring length and displacement at an equilibrium with direction θ. Returns L, x, y, elements one after the other.
%  Source: (4), (5), (13) or (15). Operations: 15.
  B = beta + nbar;
  q = B + sigma;
  w0 = 1./q;
  L = w0.*(B.*sin0 + kappa + sigma.*sin)./sin;
  result1 = L;
  result2 = -L.*cos + cos0;
  result3 = w0.*(-kappa + sigma.*(-sin + sin0));
end
