function [result1, result2, result3, result4] = reference_lines(cos, sin, mu0, kappa, alpha, sigma, beta)
%REFERENCE_LINES  u1, w1, u2, w2 of sin θ₀ = u1 + w1 L and α cos θ₀ = u2 + w2 L, in contact at given θ and μ₀. Returns u1,
%  w1, u2, w2, elements one after the other. Source: (14), (15). Operations: 18.
  B = beta + 1;
  q = B + sigma;
  M = mu0;
  p = alpha + sigma;
  w0 = 1./B;
  w1 = sigma.*sin;
  w2 = kappa + w1;
  result1 = -w0.*w2;
  result2 = q.*sin.*w0;
  result3 = M.*w0.*w2 - cos.*sigma;
  result4 = -M.*w0.*w1 + cos.*p;
end
