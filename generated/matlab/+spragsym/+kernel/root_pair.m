function result = root_pair(p, q)
%ROOT_PAIR  The two roots of t² + p t + q without cancellation.
  half = 0.5 .* p;
  quarter = half .* half - q;
  radical = sqrt(spragsym.kernel.larger(quarter, 0.0));
  large = -half - spragsym.kernel.where(half > 0.0, radical, -radical);
  result.large = large;
  result.small = q ./ large;
  result.discriminant = quarter;
end
