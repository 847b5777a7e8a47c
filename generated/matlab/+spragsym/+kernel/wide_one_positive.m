function result = wide_one_positive(line, u)
%WIDE_ONE_POSITIVE  Whether certainly exactly one root in t is positive: Descartes' rule with e0 < 0 < e4, e2
%  ≤ 0 and e1 < 0.
  % a count of roundings
  COUNT_E1 = 10.0;
  t_quartic_results = spragsym.kernel.wide_t_quartic(line.a, line.b, line.d, line.m);
  e1 = t_quartic_results.value1;
  result = e1.high < -2.0 .* COUNT_E1 .* u .* (line.a_size + line.d_size);
end
