function result = wide_stability(at, L, slope, uncertainty, point)
%WIDE_STABILITY  1 stable, 2 divergent, 3 flutter, by (27).
%
%  The sign of det K is that of f′, which is known where the root is proved. ``uncertainty`` bounds the errors of cos θ, and
%  of sin θ and L over themselves.
  COUNT_K = 9.0;  % a count of roundings
  stiffness_results = spragsym.kernel.wide_stiffness(at.cosine, at.sine, L, point.mu0, point.alpha, point.sigma, point.beta, ...
      point.nbar);
  K11 = stiffness_results.value0;
  K12 = stiffness_results.value1;
  K21 = stiffness_results.value2;
  K22 = stiffness_results.value3;
  invariants_results = spragsym.kernel.wide_invariants(K11, K12, K21, K22);
  wide_trace = invariants_results.value0;
  wide_flutter = invariants_results.value2;
  trace = wide_trace.high;
  flutter = wide_flutter.high;
  sigma = point.sigma.high;
  nbar = point.nbar.high;
  pull = sigma ./ abs(L.high);
  % N + 2 pull.
  size = point.alpha.high + point.beta.high + nbar + 2.0 .* sigma + 3.0 .* pull;
  margin = COUNT_K .* uncertainty .* size;
  saddle = slope < 0.0;
  fluttering = flutter < 0.0;
  code = spragsym.kernel.where(saddle, 2.0, spragsym.kernel.where(fluttering, 3.0, spragsym.kernel.where(trace > 0.0, 1.0, ...
      2.0)));
  % Far from a vanishing discriminant, and from a vanishing trace where that decides.
  far = abs(flutter) > margin .* (size + 1.5 .* point.mu0.high .* nbar);
  result.code = code;
  result.certain = saddle | (far & (fluttering | (abs(trace) > margin)));
end
