function [result1, result2, result3, result4, result5] = fold_quartic(cos, sin, kappa, alpha, sigma, beta)
%FOLD_QUARTIC  Coefficients of e0 + … + e4 μ₀⁴, whose real roots are all folds at a given θ. Needs α > 0. Returns e0, e1,
%  e2, e3, e4, elements one after the other. Source: f = f′ = 0. Operations: 52.
  B = beta + 1;
  q = B + sigma;
  cos_2 = cos.*cos;
  cos_3 = cos.*cos_2;
  w0 = 1./(alpha.*q);
  w1 = sigma.*w0;
  g0 = cos_3.*w1.*(-B + alpha);
  p = alpha + sigma;
  sin_2 = sin.*sin;
  sin_3 = sin.*sin_2;
  w2 = 1./(B.*p);
  u0 = w2.*(B.*sigma.*sin_3 - alpha.*sigma.*sin_3 - kappa.*p);
  w3 = sigma.*sin;
  g1 = w0.*(cos_2.*w3 + kappa - sigma.*u0 + w3);
  u1 = cos.*sigma.*sin_2.*w2;
  g2 = -u1.*w1;
  g0_2 = g0.*g0;
  u0_2 = u0.*u0;
  w4 = 2.*g0;
  g1_2 = g1.*g1;
  u1_2 = u1.*u1;
  g2_2 = g2.*g2;
  result1 = g0_2 + u0_2 - 1;
  result2 = g1.*w4 + 2.*u0.*u1;
  result3 = g1_2 + g2.*w4 + u1_2;
  result4 = 2.*g1.*g2;
  result5 = g2_2;
end
