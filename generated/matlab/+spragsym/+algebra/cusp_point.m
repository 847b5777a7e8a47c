function [result1, result2, result3] = cusp_point(sin, kappa, alpha, sigma, beta)
%CUSP_POINT  sin θ₀, and cos θ₀ and μ₀ over cos θ, on a cusp. Needs α > 0 for the second. Returns sin0, cos0/cos, mu0/cos,
%  elements one after the other. Source: f = f′ = f″ = 0. Operations: 45.
  B = beta + 1;
  p = alpha + sigma;
  q = B + sigma;
  w0 = B - alpha;
  a_f = sigma.*w0;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w2 = 1./B;
  w3 = 1./p;
  w1 = 3.*sin_2 - 2;
  w4 = 1./w1;
  sin_4 = sin_2.*sin_2;
  w1_2 = w1.*w1;
  w5 = 3.*q;
  result1 = w2.*(-kappa + sigma.*sin_3.*w0.*w3.*w4);
  result2 = w0.*w2.*w3.*(-4.*B.*p.*sigma.*(1 - sin_2) + alpha.*sigma.*sin_4.*w5 + kappa.*p.*sin.*w1.*w5)./(alpha.*q.*w1_2);
  result3 = 3.*a_f.*sin.*w4./sigma;
end
