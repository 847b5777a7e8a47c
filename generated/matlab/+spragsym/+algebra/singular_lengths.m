function [result1, result2] = singular_lengths(alpha, sigma, beta, nbar)
%SINGULAR_LENGTHS  Spring lengths at which D is singular and (20) cannot give the state. Returns L at which D11 = 0, L at
%  which D22 = 0, elements one after the other. Source: (17). Operations: 5.
  result1 = sigma./(alpha + sigma);
  result2 = sigma./(beta + nbar + sigma);
end
