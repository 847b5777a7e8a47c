function [result1, result2, result3, result4, result5, result6, result7, result8, result9, result10, result11, result12, ...
    result13, result14, result15, result16] = regime_by_parameters(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, ...
    V, d, nbar, side)
%REGIME_BY_PARAMETERS  Derivatives of regime_rhs by all parameters, an angle as the angle. Returns ((∂q_1″/∂p_1, …), …),
%  elements one after the other. Source: (8)–(10). Operations: 52.
  w1 = -x;
  w2 = cos0 + w1;
  w2_2 = w2.*w2;
  w3 = -y;
  w4 = sin0 + w3;
  w4_2 = w4.*w4;
  l1 = sqrt(w2_2 + w4_2);
  w0 = 1./l1;
  c1 = w0.*w2;
  s1 = w0.*w4;
  s1_2 = s1.*s1;
  w5 = -sin0;
  w6 = sin0.*w0;
  w7 = cos0.*w0;
  w8 = c1.*s1;
  w9 = V - vx;
  w10 = exp(-d.*side.*w9);
  w11 = nbar.*y;
  w12 = -cos0;
  w13 = mu0.*w10.*w11;
  c1_2 = c1.*c1;
  result1 = sigma.*(s1_2.*w6 + w5 + w7.*w8);
  result2 = side.*w11.*(w10 - 1);
  result3 = 0;
  result4 = w1;
  result5 = -c1 - w12 - x;
  result6 = 0;
  result7 = -d.*w13;
  result8 = -w13.*w9;
  result9 = sigma.*(-c1_2.*w7 - w12 - w6.*w8);
  result10 = 0;
  result11 = -1;
  result12 = 0;
  result13 = -s1 - w5 - y;
  result14 = w3;
  result15 = 0;
  result16 = 0;
end
