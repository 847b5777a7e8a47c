function result = simple_root(it)
%SIMPLE_ROOT  The real root of the resolvent cubic farthest from the mean of the three, to full relative accuracy.
  % Newton's step squares the error, so that more than a double would be lost on the start.
  z = spragsym.kernel.outermost(it.P, it.Q);
  x = z - it.r2 ./ 3.0;
  slope = (3.0 .* x + 2.0 .* it.r2) .* x + it.r1;
  step = (((x + it.r2) .* x + it.r1) .* x + it.r0) ./ slope;
  result = x - spragsym.kernel.where(abs(step) < abs(z), step, 0.0);
end
