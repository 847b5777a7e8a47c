function result = fast_two_sum(a, b)
%FAST_TWO_SUM  a + b, exactly where |a| ≥ |b| or a = 0 (Dekker).
  s = a + b;
  result.high = s;
  result.low = b - (s - a);
end
