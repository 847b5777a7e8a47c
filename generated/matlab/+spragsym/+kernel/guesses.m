function result = guesses(point, line, u)
%GUESSES  The roots that may be equilibria.
%
%  In contact only positive ones: with sin θ < 0 < L, y = sin θ₀ − L sin θ would be positive. The first factor has a root of
%  either sign; those of the second are complex, or both negative, or both positive.
  INFINITY = Inf;
  e = spragsym.kernel.quartic(line.a, line.b, line.d, line.m);
  resolved = spragsym.kernel.cubic(line.a, line.b, line.d, line.m);
  D = spragsym.kernel.discriminant(line, resolved, u);
  halves = spragsym.kernel.factors(e, resolved);
  first = spragsym.kernel.root_pair(halves.p1, halves.q1);
  second = spragsym.kernel.root_pair(halves.p2, halves.q2);
  contact = point.nbar > 0.0;
  spared = (D.value > D.error) | (contact & spragsym.kernel.one_positive(line, e, u));
  real = second.discriminant >= 0.0;
  more = real & (~spared);
  % A sorting network; places without a root go to the end.
  low = spragsym.kernel.where(contact, INFINITY, spragsym.kernel.smaller(first.large, first.small));
  high = spragsym.kernel.larger(first.large, first.small);
  third = spragsym.kernel.where(more, second.large, INFINITY);
  fourth = spragsym.kernel.where(more, second.small, INFINITY);
  a1 = spragsym.kernel.smaller(low, high);
  a2 = spragsym.kernel.larger(low, high);
  b1 = spragsym.kernel.smaller(third, fourth);
  b2 = spragsym.kernel.larger(third, fourth);
  inner = spragsym.kernel.larger(a1, b1);
  outer = spragsym.kernel.smaller(a2, b2);
  count = spragsym.kernel.where(contact, 1.0, 2.0) + spragsym.kernel.where(more, 2.0, 0.0);
  result.t0 = spragsym.kernel.smaller(a1, b1);
  result.t1 = spragsym.kernel.smaller(inner, outer);
  result.t2 = spragsym.kernel.larger(inner, outer);
  result.t3 = spragsym.kernel.larger(a2, b2);
  result.count = count;
  result.certain = spared | real;
end
