function result = dd_leading(x)
%DD_LEADING  The double nearest to x.
  result = x.high;
end
