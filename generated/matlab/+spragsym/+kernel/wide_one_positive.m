function result = wide_one_positive(line, e, u)
%WIDE_ONE_POSITIVE  Whether certainly exactly one root in t is positive: Descartes' rule with e0 < 0 < e4, e2 ≤ 0 and e1 <
%  0.
  COUNT_E1 = 10.0;  % a count of roundings
  result = e.e1.high < -2.0 .* COUNT_E1 .* u .* (line.a_size + line.d_size);
end
