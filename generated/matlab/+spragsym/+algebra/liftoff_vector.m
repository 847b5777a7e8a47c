function [result1, result2] = liftoff_vector(cos0, sin0, kappa, alpha, beta)
%LIFTOFF_VECTOR  b of the balance in lift-off. Returns b3, b4, elements one after the other. Source: (25), (A12), (A13).
%  Operations: 5.
  result1 = -alpha.*cos0;
  result2 = -beta.*sin0 - kappa;
end
