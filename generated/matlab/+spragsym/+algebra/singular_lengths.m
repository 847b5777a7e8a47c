function [result1, result2] = singular_lengths(alpha, sigma, beta, nbar)
%SINGULAR_LENGTHS  Spring lengths at which D is singular and (20) cannot give the state.
%  Returns L at which D11 = 0, L at which D22 = 0, elements one after the other.
%
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%  nbar: 1 in contact, 0 in lift-off
%
%  Source: (17). Operations: 5.
  result1 = sigma./(alpha + sigma);
  result2 = sigma./(beta + nbar + sigma);
end
