function result1 = friction_power(y, vx, mu0, V, d, nbar, side)
%FRICTION_POWER  Rate at which friction changes that energy.
%  Returns power, elements one after the other.
%
%  y: displacement across the belt over L_0, negative into the belt
%  vx: dx/dτ
%  mu0: friction coefficient at full slip
%  V: belt speed over L_0 sqrt(k_c/m)
%  d: steepness of the friction law in creep, times L_0 sqrt(k_c/m)
%  nbar: 1 in contact, 0 in lift-off
%  side: sign of V − x': 1 where the belt is ahead of the mass, −1 where the mass is ahead
%
%  Source: (8). Operations: 12.
  result1 = -mu0.*nbar.*side.*vx.*y.*(1 - exp(-d.*side.*(V - vx)));
end
