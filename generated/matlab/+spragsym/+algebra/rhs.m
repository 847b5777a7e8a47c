function [result1, result2] = rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d)
%RHS  x″ and y″, kinked where y = 0 and where x' = V. Returns x″, y″, elements one after the other. Source: (8)–(11).
%  Operations: 36.
  w0 = cos0 - x;
  base0 = w0;
  base0_2 = base0.*base0;
  w1 = sin0 - y;
  base2 = w1;
  base2_2 = base2.*base2;
  L = sqrt(base0_2 + base2_2);
  w2 = 1./L;
  w3 = L - 1;
  w4 = V - vx;
  w5 = y./2 - abs(y)./2;
  result1 = -alpha.*x - mu0.*w5.*(1 - exp(-d.*abs(w4))).*sign(w4) + sigma.*w0.*w2.*w3;
  result2 = -beta.*y - kappa + sigma.*w1.*w2.*w3 - w5;
end
