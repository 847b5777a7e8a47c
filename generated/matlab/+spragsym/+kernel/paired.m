function result = paired(high, low)
%PAIRED  The number of which both parts are known.
  result.high = high;
  result.low = low;
end
