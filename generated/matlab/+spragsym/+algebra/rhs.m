function [result1, result2] = rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d)
%RHS  x″ and y″, kinked where y = 0 and where x' = V. Returns x″, y″, elements one after the other. Source: (8)–(11).
%  Operations: 36.
  w0 = cos0 - x;
  w0_2 = w0.*w0;
  w1 = sin0 - y;
  w1_2 = w1.*w1;
  L = sqrt(w0_2 + w1_2);
  w2 = 1./L;
  w3 = L - 1;
  w4 = V - vx;
  w5 = y./2 - abs(y)./2;
  result1 = -alpha.*x - mu0.*w5.*(1 - exp(-d.*abs(w4))).*sign(w4) + sigma.*w0.*w2.*w3;
  result2 = -beta.*y - kappa + sigma.*w1.*w2.*w3 - w5;
end
