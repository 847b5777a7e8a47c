function [result1, result2, result3] = flutter_quadratic(cos, sin, mu0, alpha, sigma, beta)
%FLUTTER_QUADRATIC  Coefficients of e0 + e1 L + e2 L², which is L² times the discriminant of (27), in contact. Returns e0,
%  e1, e2, elements one after the other. Source: (27). Operations: 14.
  B = beta + 1;
  M = mu0;
  sigma_2 = sigma.*sigma;
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  w0 = -B + alpha;
  w0_2 = w0.*w0;
  result1 = sigma_2;
  result2 = 2.*sigma.*(2.*M.*cos.*sin + w0.*(cos_2 - sin_2));
  result3 = w0_2;
end
