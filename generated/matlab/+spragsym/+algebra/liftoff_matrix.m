function [result1, result2, result3, result4] = liftoff_matrix(L, alpha, sigma, beta)
%LIFTOFF_MATRIX  D of the balance in lift-off. Returns ((D11, D12), (D21, D22)), elements one after the other. Source: (24).
%  Operations: 9.
  p = alpha + sigma;
  B = beta;
  q = B + sigma;
  w0 = -sigma;
  result1 = -L.*p - w0;
  result2 = 0;
  result3 = 0;
  result4 = -L.*q - w0;
end
