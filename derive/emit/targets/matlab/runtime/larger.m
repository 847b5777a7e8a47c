function result = larger(one, other)
%LARGER  The larger of two, element by element; the second where they do not compare.
  result = @library@.kernel.where(one > other, one, other);
end
