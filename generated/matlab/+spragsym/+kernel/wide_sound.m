function result = wide_sound(point)
%WIDE_SOUND  Whether the bounds below can count on relative rounding errors.
  % A parameter that is smaller, but not 0, may lose digits to underflow, which no count of roundings covers.
  SMALLEST_PARAMETER = 1e-250;
  sin0 = point.sin0.high;
  kappa = point.kappa.high;
  sigma = point.sigma.high;
  across = (sin0 > SMALLEST_PARAMETER) & (kappa > SMALLEST_PARAMETER) & (sigma > SMALLEST_PARAMETER);
  result = across & spragsym.kernel.ordinary(point.mu0.high) & spragsym.kernel.ordinary(point.alpha.high) & ...
      spragsym.kernel.ordinary(point.beta.high);
end
