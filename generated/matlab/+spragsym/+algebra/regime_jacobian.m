function [result1, result2, result3, result4, result5, result6, result7, result8] = regime_jacobian(x, y, vx, vy, cos0, ...
    sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
%REGIME_JACOBIAN  Derivatives of regime_rhs with respect to x, y, x', y'. Returns ((∂x″/∂x, …), (∂y″/∂x, …)), elements one
%  after the other. Source: (8)–(10). Operations: 42.
  w1 = sin0 - y;
  w1_2 = w1.*w1;
  w2 = cos0 - x;
  w2_2 = w2.*w2;
  L = sqrt(w1_2 + w2_2);
  w0 = 1./L;
  pull = sigma.*w0;
  sin = w0.*w1;
  cos = w0.*w2;
  w3 = exp(-d.*side.*(V - vx));
  mu = mu0.*side.*(1 - w3);
  side_2 = side.*side;
  slope = -d.*mu0.*side_2.*w3;
  sin_2 = sin.*sin;
  w4 = cos.*pull.*sin;
  cos_2 = cos.*cos;
  result1 = -alpha + pull.*sin_2 - sigma;
  result2 = -mu.*nbar - w4;
  result3 = -nbar.*slope.*y;
  result4 = 0;
  result5 = -w4;
  result6 = -beta + cos_2.*pull - nbar - sigma;
  result7 = 0;
  result8 = 0;
end
