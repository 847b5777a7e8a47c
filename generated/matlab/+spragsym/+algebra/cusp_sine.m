function [result1, result2] = cusp_sine(sin, kappa, alpha, sigma, beta)
%CUSP_SINE  sin θ₀, and μ₀ over cos θ, on a cusp, for any α ≥ 0. Returns sin0, mu0/cos, elements one after the other.
%  Source: f = f′ = f″ = 0. Operations: 19.
  B = beta + 1;
  p = alpha + sigma;
  w0 = B - alpha;
  a_f = sigma.*w0;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w1 = 1./(3.*sin_2 - 2);
  result1 = (-kappa + sigma.*sin_3.*w0.*w1./p)./B;
  result2 = 3.*a_f.*sin.*w1./sigma;
end
