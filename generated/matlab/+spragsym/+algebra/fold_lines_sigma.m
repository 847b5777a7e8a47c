function [result1, result2, result3, result4] = fold_lines_sigma(cos, sin, cos0, sin0, mu0, kappa, alpha, beta)
%FOLD_LINES_SIGMA  The two fold relations as lines in sigma: u1 + w1 sigma = 0 and u2 + w2 sigma = 0. Returns u1, w1, u2,
%  w2, elements one after the other. Source: f = f′ = 0. Operations: 33.
  w0 = beta.*sin0 + kappa + sin0;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w1 = alpha.*cos0;
  cos_2 = cos.*cos;
  cos_3 = cos.*cos_2;
  w2 = mu0.*sin;
  result1 = -alpha.*w0;
  result2 = -alpha.*sin_3 + beta.*sin_3 + cos.*mu0.*sin_2 + sin_3 - w0;
  result3 = beta.*w1 - kappa.*mu0 + w1;
  result4 = -alpha.*cos_3 + beta.*cos_3 - cos_2.*w2 + cos_3 + mu0.*sin0 + w1 - w2;
end
