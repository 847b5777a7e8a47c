function [result1, result2, result3, result4] = stiffness(cos, sin, L, mu0, alpha, sigma, beta, nbar)
%STIFFNESS  K, the Jacobian of (F_x, F_y). Returns ((K11, K12), (K21, K22)), elements one after the other. Source: (28).
%  Operations: 14.
  p = alpha + sigma;
  M = mu0.*nbar;
  B = beta + nbar;
  q = B + sigma;
  sin_2 = sin.*sin;
  w0 = sigma./L;
  w1 = cos.*sin.*w0;
  cos_2 = cos.*cos;
  result1 = p - sin_2.*w0;
  result2 = M + w1;
  result3 = w1;
  result4 = -cos_2.*w0 + q;
end
