function result1 = critical_friction_squared(alpha, sigma, beta)
%CRITICAL_FRICTION_SQUARED  μ_cr²: for α, μ₀ > 0 there is a pole if and only if μ₀ ≥ μ_cr. Returns mu_cr², elements one
%  after the other. Source: article, Section 3. Operations: 9.
  sigma_2 = sigma.*sigma;
  w0 = beta + 1;
  result1 = 4.*alpha.*w0.*(alpha + sigma).*(sigma + w0)./sigma_2;
end
