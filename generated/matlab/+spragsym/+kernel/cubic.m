function result = cubic(a, b, d, m)
%CUBIC  The resolvent of the quartic in t, and the same without its quadratic term.
  [r0, r1, r2] = spragsym.algebra.resolvent(a, b, d, m);
  it = spragsym.kernel.depressed(r0, r1, r2);
  result.r0 = r0;
  result.r1 = r1;
  result.r2 = r2;
  result.P = it.P;
  result.Q = it.Q;
end
