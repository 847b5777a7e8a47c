function result = one_or_three(all, point, u)
%ONE_OR_THREE  The number of equilibria in contact by the roots that were guessed, 1 or 3; 0 where that is
%  open.
%
%  At most three roots have sin θ > 0. f is negative at θ = 0 and at the lower end of the directions in
%  contact, positive at their upper end and at θ = π. Three equilibria are certain where f is positive and,
%  farther up, negative, both in contact. One is certain where there are no three roots, and where f changes
%  its sign twice out of contact, so that two of the roots lie there.
  line = spragsym.kernel.balance_(point);
  lower = spragsym.kernel.separation(all.t0, all.t1, point, line, u);
  upper = spragsym.kernel.separation(all.t1, all.t2, point, line, u);
  three = lower.positive & lower.inside & upper.negative & upper.inside & (lower.t < upper.t);
  below = lower.positive & lower.outside & (lower.t < 1.0);
  above = upper.negative & upper.outside & (upper.t > 1.0);
  alone = (all.count < 2.0) | below | above;
  number = spragsym.kernel.where(alone, 1.0, spragsym.kernel.where(three, 3.0, 0.0));
  result = spragsym.kernel.where(all.certain, spragsym.kernel.where(spragsym.kernel.sound(point), ...
      spragsym.kernel.where(spragsym.kernel.representable(line), number, 0.0), 0.0), 0.0);
end
