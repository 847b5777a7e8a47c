% Hands the right-hand side to ode45, from kink to kink: the mass leaves the belt or meets it (y = 0), or has its speed (x' = V).
p = spragsym.article('theta0', 49/180*pi);
model = spragsym.prepare(p, 0.5, 10);
state = zeros(4, 1);
regime = spragsym.regime(model, state);
[time, stop] = deal(0, 50);
[times, states] = deal(time, state');
while time < stop
  options = odeset('RelTol', 1e-10, 'AbsTol', 1e-12, 'Events', @(t, z) spragsym.kinks(model, regime, z));
  [t, z, ~, ~, kinks] = ode45(@(t, z) spragsym.regime_rhs(model, regime, z), [time, stop], state, options);
  times = [times; t(2:end)];
  states = [states; z(2:end, :)];
  [time, state] = deal(t(end), z(end, :)');
  if time < stop
    regime = spragsym.beyond(regime, kinks(end));
    fprintf('time %.6f: x = %.6f, contact %d\n', time, state(1), regime.contact);
  end
end
fprintf('time %.6f: x = %.6f, y = %.6f\n', time, state(1), state(2));
figure
plot(times, states(:, 1), times, states(:, 2));
xlabel('\tau');
legend('x', 'y');
