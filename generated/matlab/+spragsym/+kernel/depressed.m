function result = depressed(r0, r1, r2)
%DEPRESSED  The resolvent r0 + r1 ℓ + r2 ℓ² + ℓ³ without its quadratic term; P³ + Q² < 0: four real roots in t.
  mean = r2 ./ 3.0;
  result.P = (r1 - r2 .* mean) ./ 3.0;
  result.Q = 0.5 .* (r0 - mean .* (r1 - 2.0 .* mean .* mean));
end
