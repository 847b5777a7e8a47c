function result = simple_root(a, b, d, m)
%SIMPLE_ROOT  The real root of the resolvent cubic farthest from the mean of the three, to full relative
%  accuracy.
  [r0, r1, r2] = spragsym.algebra.resolvent(a, b, d, m);
  it = spragsym.kernel.depressed(r0, r1, r2);
  % Newton's step squares the error, so that more than a double would be lost on the start.
  z = spragsym.kernel.outermost(it.P, it.Q);
  x = z - r2 ./ 3.0;
  slope = (3.0 .* x + 2.0 .* r2) .* x + r1;
  step = (((x + r2) .* x + r1) .* x + r0) ./ slope;
  result = x - spragsym.kernel.where(abs(step) < abs(z), step, 0.0);
end
