% A motion of @library@ from rest at its base values: coordinates, rates and energy, and whether
% the contact is closed. By the classical Runge-Kutta method, which across a kink is of first order.
count = @count@;
names = {@shown_names@};
% @names@, an angle by its cosine and sine
given = {@arguments@};
state = [@start@]';
h = 0.01;
for k = 0:2000
  if mod(k, 400) == 0
    at = num2cell(state);
    [border{1:@borders@}] = @library@.algebra.borders(at{:}, given{:});
    energy = @library@.algebra.energy(at{:}, given{:}, @pushing@);
    shown = [names; at'];
    fprintf('time %5.1f%s  energy %+.9f  @texts@\n', h * k, sprintf('  %s %+.9f', shown{:}), energy, @touching@);
  end
  [next, slope] = deal(state, zeros(2 * count, 1));
  for stage = [0, 0.5, 0.5, 1; 1 / 6, 1 / 3, 1 / 3, 1 / 6]
    at = num2cell(state + stage(1) * h * slope);
    [accelerations{1:count}] = @library@.algebra.rhs(at{:}, given{:});
    slope = [vertcat(at{count + 1:end}); vertcat(accelerations{:})];
    next = next + stage(2) * h * slope;
  end
  state = next;
end
