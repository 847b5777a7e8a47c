function result = stability(at, L, slope, uncertainty, point)
%STABILITY  1 stable, 2 divergent, 3 flutter, by (27).
%
%  The sign of det K is that of f′, which is known where the root is proved. ``uncertainty`` bounds the errors of cos θ, and
%  of sin θ and L over themselves.
  COUNT_K = 9.0;  % a count of roundings
  [K11, K12, K21, K22] = spragsym.algebra.stiffness(at.cosine, at.sine, L, point.mu0, point.alpha, point.sigma, point.beta, ...
      point.nbar);
  [wide_trace, ~, wide_flutter] = spragsym.algebra.invariants(K11, K12, K21, K22);
  trace = wide_trace;
  flutter = wide_flutter;
  sigma = point.sigma;
  nbar = point.nbar;
  pull = sigma ./ abs(L);
  % N + 2 pull.
  size = point.alpha + point.beta + nbar + 2.0 .* sigma + 3.0 .* pull;
  margin = COUNT_K .* uncertainty .* size;
  saddle = slope < 0.0;
  fluttering = flutter < 0.0;
  code = spragsym.kernel.where(saddle, 2.0, spragsym.kernel.where(fluttering, 3.0, spragsym.kernel.where(trace > 0.0, 1.0, ...
      2.0)));
  % Far from a vanishing discriminant, and from a vanishing trace where that decides.
  far = abs(flutter) > margin .* (size + 1.5 .* point.mu0 .* nbar);
  result.code = code;
  result.certain = saddle | (far & (fluttering | (abs(trace) > margin)));
end
