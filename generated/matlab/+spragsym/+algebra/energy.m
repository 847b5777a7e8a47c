function result1 = energy(x, y, vx, vy, cos0, sin0, kappa, alpha, sigma, beta, nbar)
%ENERGY  Kinetic and stored energy, applied forces and contact included. Returns energy, elements one after the other.
%  Source: (1), (2). Operations: 29.
  base0 = cos0 - x;
  base0_2 = base0.*base0;
  base2 = sin0 - y;
  base2_2 = base2.*base2;
  l1 = sqrt(base0_2 + base2_2);
  base8 = l1 - 1;
  base8_2 = base8.*base8;
  vx_2 = vx.*vx;
  vy_2 = vy.*vy;
  y_2 = y.*y;
  w0 = y_2./2;
  x_2 = x.*x;
  result1 = alpha.*x_2./2 + base8_2.*sigma./2 + beta.*w0 + kappa.*y + nbar.*w0 + vx_2./2 + vy_2./2;
end
