function [result1, result2, result3, result4] = fold_lines_beta(cos, sin, cos0, sin0, mu0, kappa, alpha, sigma)
%FOLD_LINES_BETA  The two fold relations as lines in beta: u1 + w1 beta = 0 and u2 + w2 beta = 0. Returns u1, w1, u2, w2,
%  elements one after the other. Source: f = f′ = 0. Operations: 37.
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w0 = sigma.*sin0;
  w1 = alpha.*sin0 - sigma.*sin_3 + w0;
  cos_2 = cos.*cos;
  w2 = alpha.*cos0;
  cos_3 = cos.*cos_2;
  w3 = cos_3.*sigma;
  w4 = mu0.*sigma.*sin;
  w5 = w2 + w3;
  result1 = -alpha.*kappa - alpha.*sigma.*sin_3 + cos.*mu0.*sigma.*sin_2 - kappa.*sigma - w1;
  result2 = -w1;
  result3 = -alpha.*w3 - cos_2.*w4 - kappa.*mu0 + mu0.*w0 + sigma.*w2 - w4 + w5;
  result4 = w5;
end
