function result = wide_simple_root(a, b, d, m)
%WIDE_SIMPLE_ROOT  The real root of the resolvent cubic farthest from the mean of the three, to full relative
%  accuracy.
  resolvent_results = spragsym.kernel.wide_resolvent(a, b, d, m);
  r0 = resolvent_results.value0;
  r1 = resolvent_results.value1;
  r2 = resolvent_results.value2;
  it = spragsym.kernel.wide_depressed(r0, r1, r2);
  % Newton's step squares the error, so that more than a double would be lost on the start.
  z = spragsym.kernel.outermost(it.P.high, it.Q.high);
  x = spragsym.kernel.dd_add_double(spragsym.kernel.dd_negative(spragsym.kernel.dd_divide(r2, ...
      spragsym.kernel.paired(3.0, 0.0))), z);
  slope = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add( ...
      spragsym.kernel.dd_multiply_double(x, 3.0), spragsym.kernel.dd_scaled(r2, 2.0)), x), r1);
  step = spragsym.kernel.dd_divide(spragsym.kernel.dd_add(spragsym.kernel.dd_multiply( ...
      spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(spragsym.kernel.dd_add(x, r2), x), r1), x), ...
      r0), slope);
  result = spragsym.kernel.dd_add(x, spragsym.kernel.dd_negative(spragsym.kernel.dd_where( ...
      spragsym.kernel.dd_less(spragsym.kernel.dd_absolute(step), spragsym.kernel.paired(abs(z), 0.0)), ...
      step, spragsym.kernel.paired(0.0, 0.0))));
end
