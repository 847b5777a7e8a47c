function [result1, result2, result3, result4] = f_in_differences(cos, sin, cos0, sin0, mu0, kappa, alpha, sigma, beta)
%F_IN_DIFFERENCES  f, f′ and their derivatives by μ₀ in contact, with sin θ − sin θ₀ and cos θ₀ − cos θ kept together: over
%  a box of parameters, or near small deformation, little is lost. Returns f, f′, f_μ₀, f′_μ₀, elements one after the other.
%  Source: (12), (13) eliminated. Operations: 47.
  B = beta + 1;
  w0 = sin - sin0;
  w1 = B.*w0 - kappa;
  w2 = kappa + sigma.*w0;
  w3 = -sin.*w2;
  w4 = -cos + cos0;
  w5 = sigma.*sin;
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  w6 = cos.*(-w2 - w5);
  result1 = alpha.*(B.*(-cos.*sin0 + cos0.*sin) - cos.*kappa + w4.*w5) + cos.*sigma.*w1 + mu0.*w3;
  result2 = alpha.*(B.*(cos.*cos0 + sin.*sin0) + kappa.*sin + sigma.*(cos.*w4 + sin_2)) + mu0.*w6 + sigma.*(B.*cos_2 - ...
      sin.*w1);
  result3 = w3;
  result4 = w6;
end
