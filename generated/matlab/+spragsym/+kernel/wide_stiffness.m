function result = wide_stiffness(cos_theta, sin_theta, L, mu0, alpha, sigma, beta, nbar)
%WIDE_STIFFNESS  K, the Jacobian of (F_x, F_y).
  p = spragsym.kernel.dd_add(alpha, sigma);
  M = spragsym.kernel.dd_multiply(mu0, nbar);
  B = spragsym.kernel.dd_add(beta, nbar);
  q = spragsym.kernel.dd_add(B, sigma);
  sin_2 = spragsym.kernel.dd_multiply(sin_theta, sin_theta);
  w0 = spragsym.kernel.dd_divide(sigma, L);
  w1 = spragsym.kernel.dd_multiply(spragsym.kernel.dd_multiply(cos_theta, sin_theta), w0);
  cos_2 = spragsym.kernel.dd_multiply(cos_theta, cos_theta);
  result.value0 = spragsym.kernel.dd_add(p, spragsym.kernel.dd_negative(spragsym.kernel.dd_multiply(sin_2, w0)));
  result.value1 = spragsym.kernel.dd_add(M, w1);
  result.value2 = w1;
  result.value3 = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_negative(cos_2), w0), q);
end
