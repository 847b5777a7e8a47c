function result = dd_smaller(x, y)
%DD_SMALLER  The smaller of two.
  result = spragsym.kernel.dd_where(spragsym.kernel.dd_less(x, y), x, y);
end
