function result1 = friction_power(y, vx, mu0, V, d, nbar, side)
%FRICTION_POWER  Rate at which friction changes that energy. Returns power, elements one after the other. Source: (8).
%  Operations: 12.
  result1 = -mu0.*nbar.*side.*vx.*y.*(1 - exp(-d.*side.*(V - vx)));
end
