function result = smaller(one, other)
%SMALLER  The smaller of two, element by element; the second where they do not compare.
  result = spragsym.kernel.where(one < other, one, other);
end
