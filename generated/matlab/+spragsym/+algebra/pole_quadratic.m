function [result1, result2, result3] = pole_quadratic(mu0, alpha, sigma, beta)
%POLE_QUADRATIC  Coefficients of e0 + e1 T + e2 T², whose roots T = tan θ₀ are the poles. Returns e0, e1, e2, elements one
%  after the other. Source: determinant of the linear model. Operations: 7.
  w0 = beta + 1;
  result1 = w0.*(alpha + sigma);
  result2 = -mu0.*sigma;
  result3 = alpha.*(sigma + w0);
end
