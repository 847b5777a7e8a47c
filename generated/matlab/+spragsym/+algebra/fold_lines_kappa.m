function [result1, result2, result3, result4] = fold_lines_kappa(cos, sin, cos0, sin0, mu0, alpha, sigma, beta)
%FOLD_LINES_KAPPA  The two fold relations as lines in kappa: u1 + w1 kappa = 0 and u2 + w2 kappa = 0. Returns u1, w1, u2,
%  w2, elements one after the other. Source: f = f′ = 0. Operations: 44.
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w0 = alpha.*sin0;
  w1 = sigma.*sin0;
  cos_2 = cos.*cos;
  w2 = alpha.*cos0;
  cos_3 = cos.*cos_2;
  w3 = cos_3.*sigma;
  w4 = mu0.*sigma.*sin;
  result1 = -alpha.*sigma.*sin_3 + beta.*sigma.*sin_3 - beta.*w0 - beta.*w1 + cos.*mu0.*sigma.*sin_2 + sigma.*sin_3 - w0 - ...
      w1;
  result2 = -alpha - sigma;
  result3 = -alpha.*w3 + beta.*w2 + beta.*w3 - cos_2.*w4 + mu0.*w1 + sigma.*w2 + w2 + w3 - w4;
  result4 = -mu0;
end
