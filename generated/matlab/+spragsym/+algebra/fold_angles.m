function [result1, result2] = fold_angles(cos, sin, mu0, kappa, alpha, sigma, beta)
%FOLD_ANGLES  sin θ₀ and cos θ₀ of the fold through θ at friction μ₀. Needs α > 0. Returns sin0, cos0, elements one after
%  the other. Source: f = f′ = 0. Operations: 34.
  B = beta + 1;
  p = alpha + sigma;
  q = B + sigma;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w0 = B.*sigma;
  w1 = (-kappa.*p + sigma.*sin_2.*(-alpha.*sin + cos.*mu0) + sin_3.*w0)./(B.*p);
  cos_2 = cos.*cos;
  cos_3 = cos.*cos_2;
  w2 = mu0.*sigma;
  w3 = sin.*w2;
  result1 = w1;
  result2 = (alpha.*cos_3.*sigma + cos_2.*w3 - cos_3.*w0 + kappa.*mu0 - w1.*w2 + w3)./(alpha.*q);
end
