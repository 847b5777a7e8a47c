function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10] = ...
    cusp_polynomial(kappa, alpha, sigma, beta)
%CUSP_POLYNOMIAL  Coefficients of e0 + … + e9 s⁹, whose real roots s = sin θ in (−1, 1) are all cusps. Needs α
%  > 0 and α ≠ 1 + β.
%  Returns e0, …, e9, elements one after the other.
%
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%
%  Source: f = f′ = f″ = 0. Operations: 103.
  B = beta + 1;
  p = alpha + sigma;
  g0 = -4.*B.*p.*sigma;
  k = kappa.*p;
  q = B + sigma;
  r = alpha.*q;
  w0 = B - alpha;
  width = w0;
  g1 = -6.*k.*q;
  a_f = sigma.*w0;
  g4 = 3.*r.*sigma;
  g0_2 = g0.*g0;
  width_2 = width.*width;
  w1 = g0_2.*width_2;
  k_2 = k.*k;
  r_2 = r.*r;
  w2 = k_2.*r_2;
  w3 = 16.*r_2;
  B_2 = B.*B;
  p_2 = p.*p;
  w4 = B_2.*p_2;
  w5 = g0.*width_2;
  w6 = g1.*w5;
  g1_2 = g1.*g1;
  w7 = g1_2.*width_2;
  w8 = 3.*w1;
  w9 = r_2.*w4;
  w10 = a_f.*k;
  w11 = 216.*w2;
  w12 = 216.*w9;
  w13 = 2.*g4;
  w14 = r_2.*w10;
  w15 = g1.*width_2;
  a_f_2 = a_f.*a_f;
  w16 = a_f_2.*r_2;
  g4_2 = g4.*g4;
  result1 = w1 + 16.*w2 - w3.*w4;
  result2 = 2.*w6;
  result3 = -96.*w2 + w7 - w8 + 96.*w9;
  result4 = w10.*w3 - 7.*w6;
  result5 = w11 - w12 + w13.*w5 - 4.*w7 + w8;
  result6 = w13.*w15 - 72.*w14 + 8.*w6;
  result7 = -4.*g4.*w5 - w1 - w11 + w12 + 4.*w16 + 21.*w7./4;
  result8 = 108.*a_f.*k.*r_2 - 5.*g4.*w15 - 3.*w6;
  result9 = 2.*g0.*g4.*width_2 + g4_2.*width_2 + 81.*k_2.*r_2 - 12.*w16 - 9.*w7./4 - 81.*w9;
  result10 = 3.*g1.*g4.*width_2 - 54.*w14;
end
