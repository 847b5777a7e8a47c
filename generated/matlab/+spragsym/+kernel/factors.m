function result = factors(a, b, d, m)
%FACTORS  The two real quadratic factors of the quartic in t.
  [~, e1, e2, e3, e4] = spragsym.algebra.t_quartic(a, b, d, m);
  over = 1.0 ./ e4;
  A1 = e1 .* over;
  A2 = e2 .* over;
  A3 = e3 .* over;
  y = -4.0 .* over .* spragsym.kernel.simple_root(a, b, d, m);
  width = sqrt(y .* y + 4.0);
  large = 0.5 .* (abs(y) + width);
  small = 1.0 ./ large;
  q2 = spragsym.kernel.where(y > 0.0, large, small);
  q1 = -spragsym.kernel.where(y > 0.0, small, large);
  inverse = 1.0 ./ width;
  result = spragsym.kernel.polish(A1, A2, A3, (A1 - A3 .* q1) .* inverse, q1, (A3 .* q2 - A1) .* inverse, q2);
end
