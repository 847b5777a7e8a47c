function result1 = damping(y, mu0, V, d, nbar)
%DAMPING  ∂F_x/∂x' at steady sliding.
%  Returns C11, elements one after the other.
%
%  y: displacement across the belt over L_0, negative into the belt
%  mu0: friction coefficient at full slip
%  V: belt speed over L_0 sqrt(k_c/m)
%  d: steepness of the friction law in creep, times L_0 sqrt(k_c/m)
%  nbar: 1 in contact, 0 in lift-off
%
%  Source: (8), (10) linearized. Operations: 7.
  result1 = -d.*mu0.*nbar.*y.*exp(-V.*d);
end
