function result = moderate(point)
%MODERATE  Whether double-double arithmetic is as good as its bounds say at this point.
  % Between these, numbers are far enough from underflow and overflow for the exact products of double-double arithmetic.
  SMALLEST_WIDE = 1e-50;
  sin0 = point.sin0;
  across = (sin0 > SMALLEST_WIDE) & spragsym.kernel.tame(point.kappa) & spragsym.kernel.tame(point.sigma) & ...
      spragsym.kernel.tame(point.beta);
  result = across & spragsym.kernel.tame(point.mu0) & spragsym.kernel.tame(point.alpha);
end
