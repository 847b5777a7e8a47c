function [result1, result2] = regime_rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
%REGIME_RHS  x″ and y″ in a smooth regime: contact (nbar = 1) or not (0), belt ahead (side = 1) or behind (−1). Returns x″,
%  y″, elements one after the other. Source: (8)–(10). Operations: 32.
  w0 = cos0 - x;
  w0_2 = w0.*w0;
  w1 = sin0 - y;
  w1_2 = w1.*w1;
  L = sqrt(w0_2 + w1_2);
  w2 = 1./L;
  w3 = L - 1;
  w4 = nbar.*y;
  result1 = -alpha.*x - mu0.*side.*w4.*(1 - exp(-d.*side.*(V - vx))) + sigma.*w0.*w2.*w3;
  result2 = -beta.*y - kappa + sigma.*w1.*w2.*w3 - w4;
end
