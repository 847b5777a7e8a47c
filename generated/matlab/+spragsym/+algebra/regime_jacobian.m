function [result1, result2, result3, result4, result5, result6, result7, result8] = regime_jacobian(x, y, vx, vy, cos0, ...
    sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
%REGIME_JACOBIAN  Derivatives of regime_rhs by the coordinates and the rates. Returns ((∂q_1″/∂q_1, …, ∂q_1″/∂v_1, …), …),
%  elements one after the other. Source: (8)–(10). Operations: 40.
  w1 = sin0 - y;
  w1_2 = w1.*w1;
  w2 = cos0 - x;
  w2_2 = w2.*w2;
  l1 = sqrt(w1_2 + w2_2);
  w0 = 1./l1;
  s1 = w0.*w1;
  c1 = w0.*w2;
  w3 = exp(-d.*side.*(V - vx));
  mu = mu0.*side.*(1 - w3);
  s1_2 = s1.*s1;
  w4 = c1.*s1.*sigma.*w0;
  c1_2 = c1.*c1;
  result1 = -alpha + sigma.*(s1_2.*w0 - 1);
  result2 = -mu.*nbar - w4;
  result3 = d.*mu0.*nbar.*w3.*y;
  result4 = 0;
  result5 = -w4;
  result6 = -beta - nbar + sigma.*(c1_2.*w0 - 1);
  result7 = 0;
  result8 = 0;
end
