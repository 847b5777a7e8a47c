function [result1, result2, result3, result4] = fold_lines_alpha(cos, sin, cos0, sin0, mu0, kappa, sigma, beta)
%FOLD_LINES_ALPHA  The two fold relations as lines in alpha: u1 + w1 alpha = 0 and u2 + w2 alpha = 0. Returns u1, w1, u2,
%  w2, elements one after the other. Source: f = f′ = 0. Operations: 34.
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w0 = beta.*sin0 + kappa + sin0;
  cos_2 = cos.*cos;
  cos_3 = cos.*cos_2;
  w1 = cos_3.*sigma;
  w2 = mu0.*sigma;
  w3 = sin.*w2;
  result1 = sigma.*(beta.*sin_3 + cos.*mu0.*sin_2 + sin_3 - w0);
  result2 = -sigma.*sin_3 - w0;
  result3 = beta.*w1 - cos_2.*w3 - kappa.*mu0 + sin0.*w2 + w1 - w3;
  result4 = beta.*cos0 + cos0.*sigma + cos0 - w1;
end
