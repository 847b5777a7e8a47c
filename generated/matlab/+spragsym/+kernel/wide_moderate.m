function result = wide_moderate(point)
%WIDE_MODERATE  Whether double-double arithmetic is as good as its bounds say at this point.
  % Between these, numbers are far enough from underflow and overflow for the exact products of double-double arithmetic.
  SMALLEST_WIDE = 1e-50;
  sin0 = point.sin0.high;
  across = (sin0 > SMALLEST_WIDE) & spragsym.kernel.tame(point.kappa.high) & spragsym.kernel.tame(point.sigma.high) & ...
      spragsym.kernel.tame(point.beta.high);
  result = across & spragsym.kernel.tame(point.mu0.high) & spragsym.kernel.tame(point.alpha.high);
end
