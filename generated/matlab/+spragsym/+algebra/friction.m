function result1 = friction(vx, mu0, V, d)
%FRICTION  The friction coefficient at the speed x' of the mass. Returns mu, elements one after the other. Source: (10).
%  Operations: 9.
  w0 = V - vx;
  result1 = mu0.*(1 - exp(-d.*abs(w0))).*sign(w0);
end
