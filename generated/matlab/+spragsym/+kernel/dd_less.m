function result = dd_less(x, y)
%DD_LESS  Whether x < y, by the sign of the difference: low parts decide only where high ones are the same or next to each
%  other.
  result = x.high - y.high + (x.low - y.low) < 0.0;
end
