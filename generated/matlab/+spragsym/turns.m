function polynomial = turns(kind, theta, given)
%TURNS  Coefficients of the polynomial in tan(theta0/2) whose positive roots are all folds, or all flutter onsets, at theta.
  c = cos(theta);
  s = sin(theta);
  if strcmp(kind, 'folds')
    [e0, e1, e2, ec] = spragsym.algebra.fold_conic(c, s, given.fixed{:});
    polynomial = [e0 + ec, 2 * e1, 4 * e2 + 2 * e0, 2 * e1, e0 - ec];
  else
    [g0, g1, k0, k1, k2, k3] = spragsym.algebra.flutter_cubic(c, s, given.fixed{:});
    middle = 3 * k0 + 4 * k2;
    polynomial = [g0 - k0, 2 * (g1 - k1), g0 - middle, -4 * k1 - 8 * k3, -g0 - middle, -2 * (g1 + k1), -g0 - k0];
  end
end
