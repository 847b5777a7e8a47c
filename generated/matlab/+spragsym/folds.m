function found = folds(p, vary, n)
%FOLDS  The folds along theta0 or mu0 with the other one fixed: where a curve of spragsym.bifurcation_set meets that value.
%  found = spragsym.folds(p) or spragsym.folds(p, 'mu0') or spragsym.folds(p, vary, n)
%
%  The result has the columns theta0, mu0, theta, L, x and y, by ascending value of what varies.
  if nargin < 2
    vary = 'theta0';
  end
  if nargin < 3
    n = 512;
  end
  if ~any(strcmp(vary, {'theta0', 'mu0'}))
    error('spragsym:range', 'vary = %s is not among ''theta0'' and ''mu0''', spragsym.input.shown(vary));
  end
  given = spragsym.one_set(p, {vary});
  held = setdiff({'theta0', 'mu0'}, {vary});
  held = held{1};
  value = given.(held);
  whole_set = spragsym.bifurcation_set(p, n);
  curves = whole_set.curves;
  column = 2 + strcmp(held, 'mu0');
  rows = zeros(0, 3);
  for k = 1:numel(curves)
    rows = [rows; spragsym.changes(curves(k), @(at) at(:, column) - value, given)]; %#ok<AGROW>
  end
  rows(:, column) = value;
  rows = sortrows(rows, 2 + strcmp(vary, 'mu0'));
  [L, x, y] = spragsym.algebra.state(cos(rows(:, 1)), sin(rows(:, 1)), cos(rows(:, 2)), sin(rows(:, 2)), given.kappa, ...
                                     given.sigma, given.beta, 1);
  found = struct('theta0', rows(:, 2), 'mu0', rows(:, 3), 'theta', rows(:, 1), 'L', L, 'x', x, 'y', y);
end
