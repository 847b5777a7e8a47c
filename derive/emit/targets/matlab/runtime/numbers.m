function value = numbers(quantity, value, count, name)
%NUMBERS  Real numbers in the range of a quantity as a column, or an error that names it.
%  With a count other than [] there must be exactly that many. An error names NAME where it is given, else the quantity.
  [ends, text, remedy] = @library@.checks.range(quantity);
  if nargin < 4
    name = quantity;
  end
  if ~isnumeric(value) || ~isreal(value) || isempty(value)
    error('@library@:type', '%s = %s must be real numbers in %s', name, @library@.checks.shown(value), text);
  end
  value = double(value(:));
  if nargin > 2 && ~isempty(count) && numel(value) ~= count
    error('@library@:size', '%s has %d numbers in [%s]; it must be %d', name, numel(value), text, count);
  end
  low = value > ends(1) | (~ends(3) & value == ends(1));
  high = value < ends(2) | (~ends(4) & value == ends(2));
  wrong = find(~(low & high & isfinite(value)), 1);
  if ~isempty(wrong)
    place = '';
    if numel(value) > 1
      place = sprintf('(%d)', wrong);
    end
    if ~isfinite(value(wrong))
      remedy = '';
    end
    error('@library@:range', '%s%s = %s is not in %s%s', name, place, @library@.checks.shown(value(wrong)), text, remedy);
  end
end
