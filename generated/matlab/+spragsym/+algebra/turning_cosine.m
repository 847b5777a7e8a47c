function result1 = turning_cosine(sin, sin0, kappa, alpha, sigma, beta)
%TURNING_COSINE  cos θ cos θ₀ where the curve of folds turns back in μ₀. Needs α > 0. Returns cos cos0, elements one after
%  the other. Source: f = f_θ₀ = 0. Operations: 11.
  p = alpha + sigma;
  w0 = sigma.*sin;
  result1 = alpha.*sin.*(sigma - sin0.*(kappa + w0))./(alpha.*w0 + kappa.*p);
end
