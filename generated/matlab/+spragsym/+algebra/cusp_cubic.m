function [result1, result2, result3, result4] = cusp_cubic(kappa, sigma, beta)
%CUSP_CUBIC  The same for α = 0: e0 + e1 s + e2 s² + e3 s³. Returns e0, e1, e2, e3, elements one after the other. Source: f
%  = f′ = f″ = 0. Operations: 9.
  B = beta + 1;
  w0 = 4.*B.*sigma;
  w1 = kappa.*(B + sigma);
  result1 = -w0;
  result2 = -6.*w1;
  result3 = w0;
  result4 = 9.*w1;
end
