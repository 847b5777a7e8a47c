function [result1, result2] = rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d)
%RHS  Accelerations, kinked where a border is zero. Returns (q_1″, …), elements one after the other. Source: (8)–(11).
%  Operations: 39.
  w1 = cos0 - x;
  w1_2 = w1.*w1;
  w3 = sin0 - y;
  w3_2 = w3.*w3;
  l1 = sqrt(w1_2 + w3_2);
  w0 = 1./l1;
  c1 = w0.*w1;
  w2 = V - vx;
  side = sign(w2);
  mu = mu0.*side.*(1 - exp(-d.*side.*w2));
  below = 1 - sign(y);
  nbar = below./2;
  s1 = w0.*w3;
  result1 = -c1.*sigma + cos0.*sigma - mu.*nbar.*y - x.*(alpha + sigma);
  result2 = -kappa - s1.*sigma + sigma.*sin0 - y.*(beta + nbar + sigma);
end
