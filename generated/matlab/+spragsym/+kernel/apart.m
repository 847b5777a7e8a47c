function result = apart(low, low_radius, high, high_radius)
%APART  Whether two intervals in θ around 2 atan(low) < 2 atan(high) are disjoint: dθ = 2 dt/(1 + t²).
  low_square = low .* low;
  high_square = high .* high;
  result = 2.0 .* (high - low) > (low_radius + high_radius) .* (1.0 + spragsym.kernel.larger(low_square, high_square));
end
