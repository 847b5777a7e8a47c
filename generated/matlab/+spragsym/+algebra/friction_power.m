function result1 = friction_power(y, vx, mu0, V, d, nbar, side)
%FRICTION_POWER  Rate at which friction changes that energy. Returns power, elements one after the other. Source: (8).
%  Operations: 12.
  mu = mu0.*side.*(1 - exp(-d.*side.*(V - vx)));
  result1 = -mu.*nbar.*vx.*y;
end
