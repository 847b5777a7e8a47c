function [result1, result2] = regime_rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
%REGIME_RHS  Accelerations in a smooth regime, continued beyond its borders. Returns (q_1″, …), elements one after the
%  other. Source: (8)–(10). Operations: 35.
  w1 = cos0 - x;
  w1_2 = w1.*w1;
  w2 = sin0 - y;
  w2_2 = w2.*w2;
  l1 = sqrt(w1_2 + w2_2);
  w0 = 1./l1;
  c1 = w0.*w1;
  mu = mu0.*side.*(1 - exp(-d.*side.*(V - vx)));
  s1 = w0.*w2;
  result1 = -c1.*sigma + cos0.*sigma - mu.*nbar.*y - x.*(alpha + sigma);
  result2 = -kappa - s1.*sigma + sigma.*sin0 - y.*(beta + nbar + sigma);
end
