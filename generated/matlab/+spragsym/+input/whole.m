function value = whole(name, value, least)
%WHOLE  A whole number of at least so much, or an error that names it.
  if ~isnumeric(value) || ~isscalar(value) || ~isreal(value) || ~isfinite(value) || value ~= floor(value) || value < least
    error('spragsym:range', '%s = %s is not a whole number >= %d', name, spragsym.input.shown(value), least);
  end
end
