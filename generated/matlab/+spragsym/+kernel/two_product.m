function result = two_product(a, b)
%TWO_PRODUCT  a b, exactly (Dekker, Veltkamp).
  SPLITTER = 134217729.0;  % 2^27 + 1 splits a double into two halves of 26 bits.
  p = a .* b;
  big_a = SPLITTER .* a;
  high_a = big_a - (big_a - a);
  low_a = a - high_a;
  big_b = SPLITTER .* b;
  high_b = big_b - (big_b - b);
  low_b = b - high_b;
  result.high = p;
  result.low = high_a .* high_b - p + high_a .* low_b + low_a .* high_b + low_a .* low_b;
end
