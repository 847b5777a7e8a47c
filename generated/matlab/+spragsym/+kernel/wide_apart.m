function result = wide_apart(low, low_radius, high, high_radius)
%WIDE_APART  Whether two intervals in θ around 2 atan(low) < 2 atan(high) are disjoint: dθ = 2 dt/(1 + t²).
  low_square = low.high .* low.high;
  high_square = high.high .* high.high;
  result = 2.0 .* spragsym.kernel.dd_leading(spragsym.kernel.dd_add(high, spragsym.kernel.dd_negative(low))) > (low_radius + ...
      high_radius) .* (1.0 + spragsym.kernel.larger(low_square, high_square));
end
