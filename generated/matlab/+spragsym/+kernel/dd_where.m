function result = dd_where(chosen, x, y)
%DD_WHERE  x where the flag is set, y elsewhere.
  result.high = spragsym.kernel.where(chosen, x.high, y.high);
  result.low = spragsym.kernel.where(chosen, x.low, y.low);
end
