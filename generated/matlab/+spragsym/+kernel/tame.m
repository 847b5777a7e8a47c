function result = tame(parameter)
%TAME  Whether a parameter is 0 or far from underflow and overflow.
  % Between these, numbers are far enough from underflow and overflow for the exact products of double-double arithmetic.
  SMALLEST_WIDE = 1e-50;
  LARGEST_WIDE = 1e+50;
  result = (parameter < LARGEST_WIDE) & ((parameter > SMALLEST_WIDE) | (parameter <= 0.0));
end
