function result = ordinary(parameter)
%ORDINARY  Whether a parameter is 0 or large enough for relative rounding errors.
  % A parameter that is smaller, but not 0, may lose digits to underflow, which no count of roundings covers.
  SMALLEST_PARAMETER = 1e-250;
  result = (parameter > SMALLEST_PARAMETER) | (parameter <= 0.0);
end
