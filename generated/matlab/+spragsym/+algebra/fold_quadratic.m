function [result1, result2, result3] = fold_quadratic(cos, sin, kappa, sigma, beta)
%FOLD_QUADRATIC  The same for α = 0: e0 + e1 μ₀ + e2 μ₀², and sin θ₀ as for α > 0. Returns e0, e1, e2, elements one after
%  the other. Source: f = f′ = 0. Operations: 23.
  B = beta + 1;
  B_2 = B.*B;
  cos_2 = cos.*cos;
  cos_3 = cos.*cos_2;
  sigma_2 = sigma.*sigma;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w0 = B.*sigma;
  w1 = sin.*w0;
  result1 = B_2.*cos_3.*sigma_2;
  result2 = -sigma.*(B.*kappa + cos_2.*w1 + kappa.*sigma - sin_3.*w0 + w1);
  result3 = cos.*sigma_2.*sin_2;
end
