function [result1, result2, result3, result4, result5, result6, result7, result8] = regime_jacobian(x, y, vx, ...
    vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side)
%REGIME_JACOBIAN  Derivatives of regime_rhs with respect to x, y, x', y'.
%  Returns ((∂x″/∂x, …), (∂y″/∂x, …)), elements one after the other.
%
%  x: displacement along the belt over L_0
%  y: displacement across the belt over L_0, negative into the belt
%  vx: dx/dτ
%  vy: dy/dτ
%  cos0: cos θ₀
%  sin0: sin θ₀
%  mu0: friction coefficient at full slip
%  kappa: preload F_L / (k_c L_0)
%  alpha: stiffness ratio k_x / k_c
%  sigma: stiffness ratio k / k_c
%  beta: stiffness ratio k_y / k_c
%  V: belt speed over L_0 sqrt(k_c/m)
%  d: steepness of the friction law in creep, times L_0 sqrt(k_c/m)
%  nbar: 1 in contact, 0 in lift-off
%  side: sign of V − x': 1 where the belt is ahead of the mass, −1 where the mass is ahead
%
%  Source: (8)–(10). Operations: 42.
  w2 = cos0 - x;
  base0 = w2;
  base0_2 = base0.*base0;
  w1 = sin0 - y;
  base2 = w1;
  base2_2 = base2.*base2;
  L = sqrt(base0_2 + base2_2);
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
