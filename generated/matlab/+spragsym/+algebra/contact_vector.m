function [result1, result2] = contact_vector(cos0, sin0, mu0, kappa, alpha, beta)
%CONTACT_VECTOR  b of the balance in contact. Returns b1, b2, elements one after the other. Source: (19), (A10), (A11).
%  Operations: 8.
  result1 = -alpha.*cos0 - mu0.*sin0;
  result2 = -beta.*sin0 - kappa - sin0;
end
