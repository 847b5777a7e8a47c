function result1 = friction(vx, mu0, V, d)
%FRICTION  The friction coefficient at the speed x' of the mass.
%  Returns mu, elements one after the other.
%
%  vx: dx/dτ
%  mu0: friction coefficient at full slip
%  V: belt speed over L_0 sqrt(k_c/m)
%  d: steepness of the friction law in creep, times L_0 sqrt(k_c/m)
%
%  Source: (10). Operations: 9.
  w0 = V - vx;
  result1 = mu0.*(1 - exp(-d.*abs(w0))).*sign(w0);
end
