function [result1, result2, result3, result4] = fold_lines_mu0(cos, sin, cos0, sin0, kappa, alpha, sigma, beta)
%FOLD_LINES_MU0  The two fold relations as lines in mu0: u1 + w1 mu0 = 0 and u2 + w2 mu0 = 0. Returns u1, w1, u2, w2,
%  elements one after the other. Source: f = f′ = 0. Operations: 41.
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w0 = alpha.*sin0;
  w1 = sigma.*sin0;
  w2 = alpha.*cos0;
  cos_2 = cos.*cos;
  cos_3 = cos.*cos_2;
  w3 = cos_3.*sigma;
  w4 = sigma.*sin;
  result1 = -alpha.*kappa - alpha.*sigma.*sin_3 + beta.*sigma.*sin_3 - beta.*w0 - beta.*w1 - kappa.*sigma + sigma.*sin_3 - ...
      w0 - w1;
  result2 = cos.*sigma.*sin_2;
  result3 = -alpha.*w3 + beta.*w2 + beta.*w3 + sigma.*w2 + w2 + w3;
  result4 = -cos_2.*w4 - kappa + w1 - w4;
end
