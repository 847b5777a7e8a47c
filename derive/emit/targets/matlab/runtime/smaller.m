function result = smaller(one, other)
%SMALLER  The smaller of two, element by element; the second where they do not compare.
  result = @library@.kernel.where(one < other, one, other);
end
