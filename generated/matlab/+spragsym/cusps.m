function found = cusps(p)
%CUSPS  All cusps in contact with 0 < theta0 < pi and mu0 >= 0, by ascending mu0: f = f' = f'' = 0.
%  found = spragsym.cusps(p) with kappa, alpha, sigma and beta, one number each; theta0 and mu0 of p are not used
%
%  The result has the columns theta0, mu0, theta, L, x and y. In double precision and without proof; the Python package proves.
  given = spragsym.fold_set(p, {'theta0', 'mu0'});
  if given.alpha > 0
    rows = along_folds(given);
  else
    rows = without_alpha(given);
  end
  % cos theta, sin theta, cos theta0, sin theta0, mu0
  rows = rows(rows(:, 4) > 0 & rows(:, 5) >= 0, :);
  [L, x, y] = spragsym.algebra.state(rows(:, 1), rows(:, 2), rows(:, 3), rows(:, 4), given.kappa, given.sigma, given.beta, 1);
  table = [atan2(rows(:, 4), rows(:, 3)), rows(:, 5), atan2(rows(:, 2), rows(:, 1)), L, x, y];
  table = sortrows(table(L > 0 & y < 0, :), [2, 1]);
  found = struct('theta0', table(:, 1), 'mu0', table(:, 2), 'theta', table(:, 3), 'L', table(:, 4), 'x', table(:, 5), ...
                 'y', table(:, 6));
end

function rows = without_alpha(given)
% The curves of theta0 and of pi - theta0 meet in their cusps, which a cubic in sin theta gives.
  coefficients = cell(1, 4);
  [coefficients{:}] = spragsym.algebra.cusp_cubic(given.kappa, given.sigma, given.beta);
  sines = spragsym.positive_roots([coefficients{:}]);
  rows = zeros(0, 5);
  for s = [sines(sines < 1), 1]
    [s0, friction] = spragsym.algebra.cusp_sine(s, given.fixed{:});
    width = sqrt((1 - s) * (1 + s));
    away = sqrt(max((1 - s0) * (1 + s0), 0));
    for c = unique([-width, width])
      for c0 = unique([-away, away])
        if s0 <= 1
          rows(end + 1, :) = [c, s, c0, s0, friction * c + 0]; %#ok<AGROW>
        end
      end
    end
  end
end

function rows = along_folds(given)
% Where f'' changes its sign along the folds. The polynomial in sin theta that cusps are roots of is no help in double precision:
% near alpha = 1 + beta all its roots come to have 3 sin^2 theta = 2, and with a small alpha its coefficients cancel.
  curves = spragsym.curves('folds', linspace(1e-9, pi - 1e-9, 513), given);
  rows = zeros(0, 5);
  for k = 1:numel(curves)
    found = spragsym.changes(curves(k), @(at) bend(at, given), given);
    rows = [rows; cos(found(:, 1)), sin(found(:, 1)), cos(found(:, 2)), sin(found(:, 2)), found(:, 3)]; %#ok<AGROW>
  end
end

function value = bend(at, given)
  [a, b, d, m] = spragsym.algebra.f_coefficients(cos(at(:, 2)), sin(at(:, 2)), at(:, 3), given.fixed{:}, 1);
  value = spragsym.algebra.f_curvature(cos(at(:, 1)), sin(at(:, 1)), a, b, d, m);
end
