function result1 = fold_sine(cos, sin, mu0, kappa, alpha, sigma, beta)
%FOLD_SINE  sin θ₀ of the fold through θ at friction μ₀, for any α ≥ 0. Returns sin0, elements one after the other. Source:
%  f = f′ = 0. Operations: 16.
  B = beta + 1;
  p = alpha + sigma;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  result1 = (B.*sigma.*sin_3 - kappa.*p + sigma.*sin_2.*(-alpha.*sin + cos.*mu0))./(B.*p);
end
