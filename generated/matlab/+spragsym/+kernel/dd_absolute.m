function result = dd_absolute(x)
%DD_ABSOLUTE  |x|, exactly.
  result.high = abs(x.high);
  result.low = spragsym.kernel.where(x.high < 0.0, -x.low, x.low);
end
