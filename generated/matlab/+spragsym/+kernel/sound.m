function result = sound(point)
%SOUND  Whether the bounds below can count on relative rounding errors.
  % A parameter that is smaller, but not 0, may lose digits to underflow, which no count of roundings covers.
  SMALLEST_PARAMETER = 1e-250;
  positive = (point.sin0 > SMALLEST_PARAMETER) & (point.kappa > SMALLEST_PARAMETER) & (point.sigma > ...
      SMALLEST_PARAMETER);
  result = positive & spragsym.kernel.ordinary(point.mu0) & spragsym.kernel.ordinary(point.alpha) & ...
      spragsym.kernel.ordinary(point.beta);
end
