function result = wide_guesses(point, line, u)
%WIDE_GUESSES  The roots that may be equilibria.
%
%  In contact only positive ones: with sin θ < 0 < L, y = sin θ₀ − L sin θ would be positive. The first factor has a root of
%  either sign; those of the second are complex, or both negative, or both positive.
  INFINITY = Inf;
  e = spragsym.kernel.wide_quartic(line.a, line.b, line.d, line.m);
  resolved = spragsym.kernel.wide_cubic(line.a, line.b, line.d, line.m);
  D = spragsym.kernel.wide_discriminant(line, resolved, u);
  halves = spragsym.kernel.wide_factors(e, resolved);
  first = spragsym.kernel.wide_root_pair(halves.p1, halves.q1);
  second = spragsym.kernel.wide_root_pair(halves.p2, halves.q2);
  contact = point.nbar.high > 0.0;
  spared = (D.value > D.error) | (contact & spragsym.kernel.wide_one_positive(line, e, u));
  real = second.discriminant.high >= 0.0;
  more = real & (~spared);
  % A sorting network; places without a root go to the end.
  low = spragsym.kernel.dd_where(contact, spragsym.kernel.paired(INFINITY, 0.0), spragsym.kernel.dd_smaller(first.large, ...
      first.small));
  high = spragsym.kernel.dd_larger(first.large, first.small);
  third = spragsym.kernel.dd_where(more, second.large, spragsym.kernel.paired(INFINITY, 0.0));
  fourth = spragsym.kernel.dd_where(more, second.small, spragsym.kernel.paired(INFINITY, 0.0));
  a1 = spragsym.kernel.dd_smaller(low, high);
  a2 = spragsym.kernel.dd_larger(low, high);
  b1 = spragsym.kernel.dd_smaller(third, fourth);
  b2 = spragsym.kernel.dd_larger(third, fourth);
  inner = spragsym.kernel.dd_larger(a1, b1);
  outer = spragsym.kernel.dd_smaller(a2, b2);
  count = spragsym.kernel.where(contact, 1.0, 2.0) + spragsym.kernel.where(more, 2.0, 0.0);
  result.t0 = spragsym.kernel.dd_smaller(a1, b1);
  result.t1 = spragsym.kernel.dd_smaller(inner, outer);
  result.t2 = spragsym.kernel.dd_larger(inner, outer);
  result.t3 = spragsym.kernel.dd_larger(a2, b2);
  result.count = count;
  result.certain = spared | real;
end
