function [result1, result2, result3] = flutter_elimination(cos, sin, mu0, kappa, alpha, sigma, beta)
%FLUTTER_ELIMINATION  X, Y, Z: X² = Y Z at the θ of every flutter onset in contact, and L = X/Y is its length. Returns X, Y,
%  Z, elements one after the other. Source: (27), (14), (15). Operations: 56.
  sigma_2 = sigma.*sigma;
  e0 = sigma_2;
  B = beta + 1;
  w5 = -B + alpha;
  w5_2 = w5.*w5;
  e2 = w5_2;
  w0 = 1./B;
  w3 = sigma.*sin;
  w4 = kappa + w3;
  u1 = -w0.*w4;
  M = mu0;
  u2 = M.*w0.*w4 - cos.*sigma;
  q = B + sigma;
  w1 = q.*sin.*w0;
  p = alpha + sigma;
  w2 = -M.*w0.*w3 + cos.*p;
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  e1 = 2.*sigma.*(2.*M.*cos.*sin + w5.*(cos_2 - sin_2));
  alpha_2 = alpha.*alpha;
  w1_2 = w1.*w1;
  w2_2 = w2.*w2;
  w6 = alpha_2.*w1_2 + w2_2;
  u1_2 = u1.*u1;
  u2_2 = u2.*u2;
  w7 = alpha_2.*(u1_2 - 1) + u2_2;
  w8 = 2.*alpha_2.*u1.*w1 + 2.*u2.*w2;
  result1 = e0.*w6 - e2.*w7;
  result2 = -e1.*w6 + e2.*w8;
  result3 = -e0.*w8 + e1.*w7;
end
