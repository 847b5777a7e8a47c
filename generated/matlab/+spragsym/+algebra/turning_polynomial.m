function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10] = ...
    turning_polynomial(kappa, alpha, sigma, beta)
%TURNING_POLYNOMIAL  Coefficients of e0 + … + e9 s⁹, among whose roots s = sin θ in (0, 1] are all points at which the curve
%  of folds turns back in μ₀. Needs α > 0. Returns e0, …, e9, elements one after the other. Source: f = f′ = f_θ₀ = 0.
%  Operations: 280.
  B = beta + 1;
  w0 = alpha + sigma;
  w0_2 = w0.*w0;
  w0_4 = w0_2.*w0_2;
  w2 = (B - kappa).*(B + kappa);
  w0_3 = w0.*w0_2;
  kappa_2 = kappa.*kappa;
  w3 = alpha.*kappa_2;
  sigma_2 = sigma.*sigma;
  w4 = alpha.*sigma_2;
  w5 = kappa_2.*sigma;
  w6 = 2.*w5;
  w7 = 2.*sigma;
  B_2 = B.*B;
  alpha_2 = alpha.*alpha;
  sigma_3 = sigma.*sigma_2;
  sigma_4 = sigma_2.*sigma_2;
  w10 = 3.*B_2;
  w11 = 2.*alpha;
  w8 = B_2.*alpha_2;
  w12 = sigma_2.*w8;
  w13 = B_2.*sigma_3;
  w14 = alpha.*w13;
  w15 = kappa_2.*w4;
  w16 = 2.*B;
  kappa_4 = kappa_2.*kappa_2;
  w17 = kappa_4.*sigma_2;
  w18 = kappa_2.*sigma_3;
  w19 = B.*w18;
  w20 = kappa_4.*sigma;
  w21 = alpha_2.*sigma_3;
  w22 = B.*w21;
  w23 = alpha.*w6;
  w24 = -B_2.*w23 + w11.*w20 + w17 + 2.*w19 + 4.*w22;
  w9 = -kappa_2.*w8;
  w25 = B.*kappa_4;
  w26 = alpha.*w25;
  w27 = 6.*alpha;
  w28 = sigma_3.*w3;
  w29 = 4.*w12 + w19 + 2.*w22 - 6.*w28;
  w30 = 3.*w13;
  w31 = alpha.*w30 - alpha_2.*kappa_2.*w10 + sigma.*w25;
  alpha_3 = alpha.*alpha_2;
  w32 = B_2.*alpha_3;
  w33 = alpha_3.*sigma_2;
  w34 = B.*alpha_2;
  w35 = 8.*w34;
  w36 = kappa_2.*sigma_2;
  w37 = B.*w36;
  w38 = B.*w5;
  w39 = alpha.*w38;
  w40 = sigma_2.*w0;
  w41 = kappa.*w40;
  w42 = alpha_2.*w36;
  w43 = 4.*B;
  w44 = alpha_3.*sigma_3 + 4.*sigma.*w32 + w33.*w43;
  w45 = 5.*kappa_2;
  w46 = B_2.*w5;
  w1 = B + sigma;
  w1_2 = w1.*w1;
  result1 = kappa.*w0_4.*w2.*(kappa - sigma).*(kappa + sigma);
  result2 = w0_3.*w2.*w7.*(3.*w3 - w4 + w6);
  result3 = -kappa.*w0_2.*(2.*B.*alpha_2.*kappa_2.*sigma - B.*sigma_4.*w11 + B_2.*kappa_2.*sigma_2 + ...
      20.*alpha.*kappa_2.*sigma_3 + 15.*alpha_2.*kappa_2.*sigma_2 - alpha_2.*sigma_4 + 5.*kappa_2.*sigma_4 - sigma_4.*w10 - ...
      13.*w12 - 16.*w14 - w15.*w16 - w24 - w9);
  result4 = -w0_2.*w7.*(4.*B.*alpha_2.*kappa_2.*sigma - 3.*B.*w15 + 7.*B_2.*alpha.*kappa_2.*sigma + 3.*B_2.*kappa_2.*sigma_2 ...
      + 9.*alpha_2.*kappa_2.*sigma_2 - 3.*w17 - w20.*w27 - w26 - w29 - w31);
  result5 = -w41.*(12.*B.*alpha_2.*sigma_2 + 14.*B.*alpha_3.*sigma + 25.*B_2.*w4 - 28.*alpha_2.*w5 - kappa_2.*w35 + ...
      35.*sigma.*w8 - 34.*w15 - 8.*w18 + 8.*w21 + w30 + 13.*w32 + 10.*w33 - 2.*w37 - 8.*w39);
  result6 = -2.*w40.*(8.*w12 + w24 + 2.*w26 - 10.*w28 + w31 - 7.*w34.*w5 - 14.*w42 + w44);
  result7 = w41.*(16.*B.*alpha_2.*sigma_2 - B.*sigma_3.*w27 + 5.*B_2.*alpha.*sigma_2 + 14.*B_2.*alpha_2.*sigma + ...
      B_2.*sigma_3 - B_2.*w3 + 12.*alpha_2.*sigma_3 - sigma_3.*w45 - 13.*w15 - 6.*w37 - 14.*w39 - w46);
  result8 = 2.*sigma_3.*(-B.*w4.*w45 + B_2.*w36 + alpha.*w46 + w14 + w29 - w35.*w5 - 7.*w42 + w44 + w9);
  result9 = -kappa.*sigma_3.*w1.*(B.*alpha_2.*sigma + 5.*alpha_2.*sigma_2 - w16.*w3 - w23 - w36 - w38 - w4.*w43);
  result10 = 2.*sigma_4.*w1_2.*w3;
end
