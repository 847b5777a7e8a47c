function [distance, terminal, direction] = kinks(model, regime, state)
%KINKS  Distances to the two kinks of the vector field, positive inside a regime: y = 0 and x' = V.
%  odeset('Events', @(time, state) spragsym.kinks(model, regime, state)) makes ode45 stop where the motion leaves its regime.
  distance = zeros(2, 1);
  if regime.contact
    distance(1) = -state(2);
  else
    distance(1) = state(2);
  end
  distance(2) = regime.side * (model.V - state(3));
  terminal = ones(2, 1);
  direction = -ones(2, 1);
end
