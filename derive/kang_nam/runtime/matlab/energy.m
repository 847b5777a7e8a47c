function value = energy(model, state)
%ENERGY  Energy of a state with the springs, the preload and the contact.
%  value = spragsym.energy(model, state)
  value = spragsym.algebra.energy(state(1), state(2), state(3), state(4), model.cos0, model.sin0, model.kappa, ...
                                  model.alpha, model.sigma, model.beta, double(state(2) < 0));
end
