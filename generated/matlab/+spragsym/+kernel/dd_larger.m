function result = dd_larger(x, y)
%DD_LARGER  The larger of two.
  result = spragsym.kernel.dd_where(spragsym.kernel.dd_less(y, x), x, y);
end
