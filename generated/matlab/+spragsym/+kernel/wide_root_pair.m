function result = wide_root_pair(p, q)
%WIDE_ROOT_PAIR  The two roots of t² + p t + q without cancellation.
  half = spragsym.kernel.dd_scaled(p, 0.5);
  quarter = spragsym.kernel.dd_add(spragsym.kernel.dd_multiply(half, half), spragsym.kernel.dd_negative(q));
  radical = spragsym.kernel.dd_sqrt(spragsym.kernel.dd_larger(quarter, spragsym.kernel.paired(0.0, 0.0)));
  large = spragsym.kernel.dd_add(spragsym.kernel.dd_negative(half), ...
      spragsym.kernel.dd_negative(spragsym.kernel.dd_where(half.high > 0.0, radical, ...
      spragsym.kernel.dd_negative(radical))));
  result.large = large;
  result.small = spragsym.kernel.dd_divide(q, large);
  result.discriminant = quarter;
end
