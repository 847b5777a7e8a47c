function result = wide_balance(point)
%WIDE_BALANCE  f of the point: coefficients and sizes over the largest coefficient.
  f_coefficients_results = spragsym.kernel.wide_f_coefficients(point.cos0, point.sin0, point.mu0, point.kappa, point.alpha, ...
      point.sigma, point.beta, point.nbar);
  a = f_coefficients_results.value0;
  b = f_coefficients_results.value1;
  d = f_coefficients_results.value2;
  m = f_coefficients_results.value3;
  [a_size, d_size] = spragsym.algebra.f_magnitudes(point.cos0.high, point.sin0.high, point.mu0.high, point.kappa.high, ...
      point.alpha.high, point.sigma.high, point.beta.high, point.nbar.high);
  % m = μ₀ σ n̄ is not negative.
  scale = spragsym.kernel.larger(spragsym.kernel.larger(abs(a.high), abs(b.high)), spragsym.kernel.larger(abs(d.high), ...
      m.high));
  over = 1.0 ./ scale;
  result.a = spragsym.kernel.dd_multiply_double(a, over);
  result.b = spragsym.kernel.dd_multiply_double(b, over);
  result.d = spragsym.kernel.dd_multiply_double(d, over);
  result.m = spragsym.kernel.dd_multiply_double(m, over);
  result.a_size = a_size .* over;
  result.d_size = d_size .* over;
  result.scale = scale;
end
