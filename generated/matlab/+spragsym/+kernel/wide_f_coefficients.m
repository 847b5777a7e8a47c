function result = wide_f_coefficients(cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
%WIDE_F_COEFFICIENTS  a, b, d, m of f(θ) = a sin θ cos θ + b cos θ + d sin θ − m sin² θ = q sin θ F_x(θ, L(θ)).
  B = spragsym.kernel.dd_add(beta, nbar);
  a_f = spragsym.kernel.dd_multiply(sigma, spragsym.kernel.dd_add(B, spragsym.kernel.dd_negative(alpha)));
  p = spragsym.kernel.dd_add(alpha, sigma);
  b_f = spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative(p), spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(B, ...
      sin0), kappa));
  M = spragsym.kernel.dd_multiply(mu0, nbar);
  q = spragsym.kernel.dd_add(B, sigma);
  d_f = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(M, spragsym.kernel.dd_add(spragsym.kernel.dd_negative(kappa), ...
      spragsym.kernel.dd_multiply(sigma, sin0))), spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(alpha, cos0), q));
  m_f = spragsym.kernel.dd_multiply(M, sigma);
  result.value0 = a_f;
  result.value1 = b_f;
  result.value2 = d_f;
  result.value3 = m_f;
end
