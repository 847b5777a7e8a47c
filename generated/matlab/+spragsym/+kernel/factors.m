function result = factors(e, resolved)
%FACTORS  The two real quadratic factors of the quartic in t.
  over = 1.0 ./ e.e4;
  A1 = e.e1 .* over;
  A2 = e.e2 .* over;
  A3 = e.e3 .* over;
  y = -4.0 .* over .* spragsym.kernel.simple_root(resolved);
  width = sqrt(y .* y + 4.0);
  large = 0.5 .* (abs(y) + width);
  small = 1.0 ./ large;
  q2 = spragsym.kernel.where(y > 0.0, large, small);
  q1 = -spragsym.kernel.where(y > 0.0, small, large);
  inverse = 1.0 ./ width;
  result = spragsym.kernel.polish(A1, A2, A3, (A1 - A3 .* q1) .* inverse, q1, (A3 .* q2 - A1) .* inverse, q2);
end
