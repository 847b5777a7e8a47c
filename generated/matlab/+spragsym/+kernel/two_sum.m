function result = two_sum(a, b)
%TWO_SUM  a + b, exactly (Knuth).
  s = a + b;
  of_b = s - a;
  of_a = s - of_b;
  result.high = s;
  result.low = a - of_a + (b - of_b);
end
