function result = separation(one, other, point, line, u)
%SEPARATION  f at a direction between two positive roots.
  % a count of roundings
  COUNT_F = 21.0;
  % a count of roundings
  COUNT_STATE = 18.0;
  t = sqrt(one .* other);
  at = spragsym.kernel.direction(t);
  c_size = abs(at.cosine);
  f_size = spragsym.algebra.f(c_size, at.sine, line.a_size, abs(line.b), line.d_size, -abs(line.m));
  value = spragsym.algebra.f(at.cosine, at.sine, line.a, line.b, line.d, line.m);
  error = COUNT_F .* u .* f_size;
  % y < 0 where σ sin θ > σ sin θ₀ − κ.
  depth = point.sigma .* (at.sine - point.sin0) + point.kappa;
  margin = COUNT_STATE .* u .* (point.sigma .* (at.sine + point.sin0) + point.kappa);
  result.t = t;
  result.positive = value > error;
  result.negative = value < -error;
  result.inside = depth > margin;
  result.outside = depth < -margin;
end
