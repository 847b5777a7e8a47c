function result1 = damping(y, mu0, V, d, nbar)
%DAMPING  ∂F_x/∂x' at steady sliding. Returns C11, elements one after the other. Source: (8), (10) linearized. Operations:
%  7.
  result1 = -d.*mu0.*nbar.*y.*exp(-V.*d);
end
