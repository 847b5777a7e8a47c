function [result1, result2, result3, result4, result5, result6] = flutter_cubic(cos, sin, kappa, alpha, sigma, ...
    beta)
%FLUTTER_CUBIC  Flutter onsets in contact at a given θ: cos θ₀ (g0 + g1 sin θ₀) = k0 + k1 sin θ₀ + … + k3 sin³
%  θ₀.
%  Returns g0, g1, k0, k1, k2, k3, elements one after the other.
%
%  cos: cos θ
%  sin: sin θ
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%
%  Source: (27), (14), (15). Operations: 59.
  B = beta + 1;
  q = B + sigma;
  w0 = sigma.*sin;
  w1 = kappa + w0;
  w2 = 1./q;
  w3 = w2./sin;
  l0 = w1.*w3;
  l1 = B.*w3;
  sigma_2 = sigma.*sigma;
  e0 = sigma_2;
  cos_2 = cos.*cos;
  sin_2 = sin.*sin;
  w4 = -B + alpha;
  e1 = 2.*sigma.*w4.*(cos_2 - sin_2);
  base3 = w4;
  base3_2 = base3.*base3;
  e2 = base3_2;
  w5 = 4.*cos_2;
  m1 = -sigma_2.*sin.*w5;
  p = alpha + sigma;
  m2 = p.*w0.*w5;
  y0 = -w1.*w2;
  y1 = sigma.*w2;
  w6 = 4.*alpha.*cos.*w0;
  w7 = l0.*m2;
  w8 = e2.*l0;
  w9 = e0 + l0.*(e1 + w8);
  w10 = l1.*(e1 + 2.*w8);
  l1_2 = l1.*l1;
  w11 = e2.*l1_2;
  result1 = l0.*w6;
  result2 = l1.*w6;
  result3 = l0.*(m1 + w7) + w9.*y0;
  result4 = l1.*(m1 + 2.*w7) + w10.*y0 + w9.*y1;
  result5 = l1_2.*m2 + w10.*y1 + w11.*y0;
  result6 = w11.*y1;
end
