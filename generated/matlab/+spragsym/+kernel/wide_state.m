function result = wide_state(cos_theta, sin_theta, cos0, sin0, kappa, sigma, beta, nbar)
%WIDE_STATE  Spring length and displacement at an equilibrium with direction θ.
  B = spragsym.kernel.dd_add(beta, nbar);
  q = spragsym.kernel.dd_add(B, sigma);
  w0 = spragsym.kernel.dd_divide(spragsym.kernel.paired(1.0, 0.0), q);
  L = spragsym.kernel.dd_divide(spragsym.kernel.dd_multiply(w0, ...
      spragsym.kernel.dd_add(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(B, sin0), kappa), ...
      spragsym.kernel.dd_multiply(sigma, sin_theta))), sin_theta);
  result.value0 = L;
  result.value1 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative(L), cos_theta), cos0);
  result.value2 = spragsym.kernel.dd_multiply(w0, spragsym.kernel.dd_add(spragsym.kernel.dd_negative(kappa), ...
      spragsym.kernel.dd_multiply(sigma, spragsym.kernel.dd_add(spragsym.kernel.dd_negative(sin_theta), sin0))));
end
