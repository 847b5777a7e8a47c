function result = wide_cubic(a, b, d, m)
%WIDE_CUBIC  The resolvent of the quartic in t, and the same without its quadratic term.
  resolvent_results = spragsym.kernel.wide_resolvent(a, b, d, m);
  r0 = resolvent_results.value0;
  r1 = resolvent_results.value1;
  r2 = resolvent_results.value2;
  it = spragsym.kernel.wide_depressed(r0, r1, r2);
  result.r0 = r0;
  result.r1 = r1;
  result.r2 = r2;
  result.P = it.P;
  result.Q = it.Q;
end
