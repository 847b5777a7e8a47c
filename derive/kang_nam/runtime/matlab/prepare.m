function model = prepare(p, V, d)
%PREPARE  Parameters of one point and of its drive, checked once before any number of calls for the motion.
%  model = spragsym.prepare(p, V, d) with the belt's speed V and the steepness d > 0 of the friction law (10) in creep
%
%  A state is [x; y; x'; y'], with time in units of sqrt(m/k_c). What takes a model: spragsym.rhs, spragsym.regime,
%  spragsym.regime_rhs, spragsym.kinks, spragsym.step, spragsym.energy.
  given = spragsym.checks.parameters(p);
  if numel(given.theta0) ~= 1
    error('spragsym:size', 'the motion is that of one point; p has %d', numel(given.theta0));
  end
  model = spragsym.point(given, 1);
  model = rmfield(model, 'nbar');
  model.V = spragsym.checks.numbers('V', V, 1);
  model.d = spragsym.checks.numbers('d', d, 1);
end
