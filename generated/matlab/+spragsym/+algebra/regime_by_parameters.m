function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10, result11, result12, ...
    result13, result14, result15, result16] = regime_by_parameters(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, ...
    V, d, nbar, side)
%REGIME_BY_PARAMETERS  Derivatives of regime_rhs with respect to θ₀ (in radians), μ₀, κ, α, σ, β, V, d. Returns ((∂x″/∂θ₀,
%  …), (∂y″/∂θ₀, …)), elements one after the other. Source: (8)–(10). Operations: 60.
  w0 = -x;
  w1 = cos0 + w0;
  w1_2 = w1.*w1;
  w2 = -y;
  w3 = sin0 + w2;
  w3_2 = w3.*w3;
  L = sqrt(w1_2 + w3_2);
  w4 = 1./L;
  L_2 = L.*L;
  w5 = L - 1;
  w6 = sigma.*w5./L_2;
  w7 = sigma.*w1.*w4 - w1.*w6;
  w8 = sigma.*w4.*w5;
  w9 = w1.*w4;
  w10 = V - vx;
  w11 = exp(-d.*side.*w10);
  w12 = nbar.*y;
  side_2 = side.*side;
  w13 = mu0.*side_2.*w11.*w12;
  w14 = sigma.*w3.*w4 - w3.*w6;
  w15 = w3.*w4;
  result1 = cos0.*w3.*w4.*w7 - sin0.*(w7.*w9 + w8);
  result2 = -side.*w12.*(1 - w11);
  result3 = 0;
  result4 = w0;
  result5 = w5.*w9;
  result6 = 0;
  result7 = -d.*w13;
  result8 = -w10.*w13;
  result9 = cos0.*(w14.*w15 + w8) - sin0.*w14.*w9;
  result10 = 0;
  result11 = -1;
  result12 = 0;
  result13 = w15.*w5;
  result14 = w2;
  result15 = 0;
  result16 = 0;
end
