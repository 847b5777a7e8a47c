function result = dd_scaled(x, power)
%DD_SCALED  x times a power of two, exactly.
  result.high = x.high .* power;
  result.low = x.low .* power;
end
