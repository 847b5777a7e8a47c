function result = wide_quartic(a, b, d, m)
%WIDE_QUARTIC  The quartic in t = tan(θ/2) whose roots are those of f.
  t_quartic_results = spragsym.kernel.wide_t_quartic(a, b, d, m);
  e0 = t_quartic_results.value0;
  e1 = t_quartic_results.value1;
  e2 = t_quartic_results.value2;
  e3 = t_quartic_results.value3;
  e4 = t_quartic_results.value4;
  result.e0 = e0;
  result.e1 = e1;
  result.e2 = e2;
  result.e3 = e3;
  result.e4 = e4;
end
