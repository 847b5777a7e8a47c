function rate = regime_rhs(model, regime, state)
%REGIME_RHS  d/dtau of a state in one smooth regime, continued beyond its borders.
%  rate = spragsym.regime_rhs(model, regime, state) with a model of spragsym.prepare and a regime of spragsym.regime
  rate = zeros(4, 1);
  rate(1) = state(3);
  rate(2) = state(4);
  [rate(3), rate(4)] = spragsym.algebra.regime_rhs(state(1), state(2), state(3), state(4), model.cos0, model.sin0, ...
      model.mu0, model.kappa, model.alpha, model.sigma, model.beta, model.V, model.d, double(regime.contact), regime.side);
end
