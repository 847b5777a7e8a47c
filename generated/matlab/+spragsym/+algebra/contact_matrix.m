function [result1, result2, result3, result4] = contact_matrix(L, mu0, alpha, sigma, beta)
%CONTACT_MATRIX  D of the balance in contact. Returns ((D11, D12), (D21, D22)), elements one after the other. Source: (17),
%  (18). Operations: 12.
  p = alpha + sigma;
  M = mu0;
  B = beta + 1;
  q = B + sigma;
  w0 = -sigma;
  result1 = -L.*p - w0;
  result2 = -L.*M;
  result3 = 0;
  result4 = -L.*q - w0;
end
