function [result1, result2] = f_magnitudes(cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar)
%F_MAGNITUDES  Sums of the absolute values of the terms of a and d, against which their rounding errors are measured.
%  Returns |a|, |d|, elements one after the other. Source: rounding-error analysis. Operations: 12.
  B = beta + nbar;
  M = mu0.*nbar;
  q = B + sigma;
  result1 = sigma.*(B + alpha);
  result2 = M.*(kappa + sigma.*sin0) + alpha.*q.*abs(cos0);
end
