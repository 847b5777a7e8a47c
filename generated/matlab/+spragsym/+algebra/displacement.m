function [result1, result2] = displacement(cos0, sin0, mu0, kappa, alpha, sigma, beta)
%DISPLACEMENT  x and y at steady sliding with the spring's angle held at θ₀. Returns x, y, elements one after the other.
%  Source: (12), (13) linearized. Operations: 20.
  sin0_2 = sin0.*sin0;
  cos0_2 = cos0.*cos0;
  w0 = cos0_2.*sigma;
  w1 = cos0.*sigma.*sin0;
  w2 = alpha + w0;
  determinant = alpha.*beta + alpha.*sigma.*sin0_2 + beta.*w0 - mu0.*w1 + w2;
  w3 = kappa./determinant;
  result1 = w3.*(mu0 + w1);
  result2 = -w2.*w3;
end
