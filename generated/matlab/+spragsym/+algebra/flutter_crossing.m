function [result1, result2] = flutter_crossing(cos, sin, L, cos0, sin0, mu0, alpha, sigma, beta)
%FLUTTER_CROSSING  N, J: L² times the discriminant changes by N/J per unit of θ₀, along equilibria in contact. Returns N, J,
%  elements one after the other. Source: (27), (14), (15). Operations: 60.
  M = mu0;
  p = alpha + sigma;
  w0 = M.*sin;
  a_L = -cos.*p - w0;
  w1 = -sigma;
  a_theta = -L.*M.*cos + sin.*(L.*p + w1);
  a_theta0 = M.*cos0 - alpha.*sin0;
  B = beta + 1;
  q = B + sigma;
  b_L = -q.*sin;
  b_theta = -cos.*(L.*q + w1);
  b_theta0 = B.*cos0;
  w2 = -B + alpha;
  w2_2 = w2.*w2;
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  w3 = cos_2 - sin_2;
  d_L = 2.*L.*w2_2 + 2.*sigma.*(2.*cos.*w0 + w2.*w3);
  d_theta = 4.*L.*sigma.*(M.*w3 - cos.*sin.*(-2.*B + 2.*alpha));
  result1 = d_L.*(a_theta.*b_theta0 - a_theta0.*b_theta) + d_theta.*(-a_L.*b_theta0 + a_theta0.*b_L);
  result2 = a_L.*b_theta - a_theta.*b_L;
end
