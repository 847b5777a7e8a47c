function result1 = flutter_without_alpha(cos, sin, mu0, kappa, sigma, beta)
%FLUTTER_WITHOUT_ALPHA  The same for α = 0: zero at the θ of every flutter onset, where L = −u2/w2. Returns condition,
%  elements one after the other. Source: (27), (14), (15). Operations: 32.
  sigma_2 = sigma.*sigma;
  e0 = sigma_2;
  B = beta + 1;
  M = mu0;
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  e1 = 2.*sigma.*(-B.*(cos_2 - sin_2) + 2.*M.*cos.*sin);
  B_2 = B.*B;
  e2 = B_2;
  w0 = 1./B;
  w3 = sigma.*sin;
  u2 = M.*w0.*(kappa + w3) - cos.*sigma;
  p = sigma;
  w2 = -M.*w0.*w3 + cos.*p;
  u2_2 = u2.*u2;
  w2_2 = w2.*w2;
  result1 = e0.*w2_2 - e1.*u2.*w2 + e2.*u2_2;
end
