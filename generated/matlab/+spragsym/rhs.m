function rate = rhs(model, state)
%RHS  d/dtau of a state, in the regime that the motion goes on in there: (8)-(11).
%  rate = spragsym.rhs(model, state) with a model of spragsym.prepare and state = [x; y; x'; y']
%
%  ode45(@(time, state) spragsym.rhs(model, state), ...) integrates across the kinks as they come; to stop at them, see
%  spragsym.kinks.
  rate = spragsym.regime_rhs(model, spragsym.regime(model, state), state);
end
