function found = positive_roots(coefficients)
%POSITIVE_ROOTS  Positive roots of a polynomial, lowest power first, ascending, in a row.
%  Eigenvalues of its companion matrix, of which those are real whose imaginary part is 0, with three Newton steps.
  found = zeros(1, 0);
  degree = numel(coefficients) - 1;
  while degree > 0 && coefficients(degree + 1) == 0
    degree = degree - 1;
  end
  companion = zeros(degree);
  companion(2:degree + 1:end) = 1;
  companion(:, end) = -coefficients(1:degree) / coefficients(degree + 1);
  if degree < 1 || ~all(isfinite(companion(:)))
    return
  end
  all_roots = eig(companion).';
  found = sort(real(all_roots(imag(all_roots) == 0 & real(all_roots) > 0)));
  for pass = 1:3 * ~isempty(found)
    value = coefficients(degree + 1);
    slope = 0;
    for k = degree:-1:1
      slope = slope .* found + value;
      value = value .* found + coefficients(k);
    end
    steps = value ./ slope;
    edges = [0, found, Inf];
    gaps = min(edges(2:end - 1) - edges(1:end - 2), edges(3:end) - edges(2:end - 1));
    good = abs(steps) < 0.5 * gaps;
    found(good) = found(good) - steps(good);
  end
end
