function result = dd_negative(x)
%DD_NEGATIVE  −x, exactly.
  result.high = -x.high;
  result.low = -x.low;
end
