function result = balance_(point)
%BALANCE_  f of the point: coefficients and sizes over the largest coefficient.
  [a, b, d, m] = spragsym.algebra.f_coefficients(point.cos0, point.sin0, point.mu0, point.kappa, point.alpha, point.sigma, ...
      point.beta, point.nbar);
  [a_size, d_size] = spragsym.algebra.f_magnitudes(point.cos0, point.sin0, point.mu0, point.kappa, point.alpha, point.sigma, ...
      point.beta, point.nbar);
  % m = μ₀ σ n̄ is not negative.
  scale = spragsym.kernel.larger(spragsym.kernel.larger(abs(a), abs(b)), spragsym.kernel.larger(abs(d), m));
  over = 1.0 ./ scale;
  result.a = a .* over;
  result.b = b .* over;
  result.d = d .* over;
  result.m = m .* over;
  result.a_size = a_size .* over;
  result.d_size = d_size .* over;
  result.scale = scale;
end
