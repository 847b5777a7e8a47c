function found = cusps(p)
%CUSPS  All cusps in contact with 0 < theta0 < pi and mu0 >= 0, by ascending mu0: f = f' = f'' = 0.
%  found = spragsym.cusps(p) with kappa, alpha, sigma and beta, one number each; theta0 and mu0 of p are not used
%
%  The result has the columns theta0, mu0, theta, L, x and y. In double precision and without proof; the Python package proves.
  given = spragsym.one_set(p, {'theta0', 'mu0'});
  % Closer to alpha = 1 + beta the coefficients of the polynomial leave too few digits.
  if abs(given.alpha - (1 + given.beta)) < 0.05 * (1 + given.beta)
    rows = along_folds(given);
  else
    rows = by_sine(given);
  end
  % cos theta, sin theta, cos theta0, sin theta0, mu0
  rows = rows(rows(:, 4) > 0 & rows(:, 5) >= 0, :);
  [L, x, y] = spragsym.algebra.state(rows(:, 1), rows(:, 2), rows(:, 3), rows(:, 4), given.kappa, given.sigma, given.beta, 1);
  table = [atan2(rows(:, 4), rows(:, 3)), rows(:, 5), atan2(rows(:, 2), rows(:, 1)), L, x, y];
  table = sortrows(table(L > 0 & y < 0, :), [2, 1]);
  found = struct('theta0', table(:, 1), 'mu0', table(:, 2), 'theta', table(:, 3), 'L', table(:, 4), 'x', table(:, 5), ...
                 'y', table(:, 6));
end

function rows = by_sine(given)
% From the roots of a polynomial in sin theta.
  coefficients = cell(1, 10);
  if given.alpha > 0
    [coefficients{:}] = spragsym.algebra.cusp_polynomial(given.fixed{:});
  else
    coefficients = cell(1, 4);
    [coefficients{:}] = spragsym.algebra.cusp_cubic(given.kappa, given.sigma, given.beta);
  end
  sines = spragsym.positive_roots([coefficients{:}]);
  sines = sines(sines < 1);
  if given.alpha == 0
    sines(end + 1) = 1;
  end
  rows = zeros(0, 5);
  for k = 1:numel(sines)
    s = sines(k);
    if given.alpha > 0
      s = sharpened(s, given);
    end
    [s0, friction] = spragsym.algebra.cusp_sine(s, given.fixed{:});
    width = sqrt((1 - s) * (1 + s));
    for c = unique([-width, width])
      if given.alpha > 0
        [~, over_cosine] = spragsym.algebra.cusp_point(s, given.fixed{:});
        cosines = over_cosine * c;
      elseif abs(s0) <= 1
        away = sqrt((1 - s0) * (1 + s0));
        cosines = unique([-away, away]);
      else
        cosines = [];
      end
      for c0 = cosines
        rows(end + 1, :) = [c, s, c0, s0, friction * c + 0]; %#ok<AGROW>
      end
    end
  end
end

function s = sharpened(s, given)
% A root to more digits, which the polynomial's coefficients have lost: where cos^2 + sin^2 of theta0 is 1.
  % The nearer alpha is to 1 + beta, the more are lost.
  for width = [1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3]
    ends = [s * (1 - width), min(s * (1 + width), 1)];
    if excess(ends(1), given) * excess(ends(2), given) < 0
      s = fzero(@(sine) excess(sine, given), ends);
      return
    end
  end
end

function value = excess(s, given)
  [s0, over_cosine] = spragsym.algebra.cusp_point(s, given.fixed{:});
  value = over_cosine ^ 2 * (1 - s) * (1 + s) - (1 - s0) * (1 + s0);
end

function rows = along_folds(given)
% Close to alpha = 1 + beta all cusps come to have 3 sin^2 theta = 2: where f'' changes its sign along the folds.
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
