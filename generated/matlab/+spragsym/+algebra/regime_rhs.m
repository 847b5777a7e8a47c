function [result1, result2] = regime_rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
%REGIME_RHS  x″ and y″ in a smooth regime: contact (nbar = 1) or not (0), belt ahead (side = 1) or behind (−1). Returns x″,
%  y″, elements one after the other. Source: (8)–(10). Operations: 32.
  w0 = cos0 - x;
  base0 = w0;
  base0_2 = base0.*base0;
  w1 = sin0 - y;
  base2 = w1;
  base2_2 = base2.*base2;
  L = sqrt(base0_2 + base2_2);
  w2 = 1./L;
  w3 = L - 1;
  w4 = nbar.*y;
  result1 = -alpha.*x - mu0.*side.*w4.*(1 - exp(-d.*side.*(V - vx))) + sigma.*w0.*w2.*w3;
  result2 = -beta.*y - kappa + sigma.*w1.*w2.*w3 - w4;
end
