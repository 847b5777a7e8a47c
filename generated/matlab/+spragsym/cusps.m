function found = cusps(p)
%CUSPS  All cusps in contact with 0 < theta0 < pi and mu0 >= 0, by ascending mu0: f = f' = f'' = 0.
%  found = spragsym.cusps(p) with kappa, alpha, sigma and beta, one number each; theta0 and mu0 of p are not used
%
%  The result has the columns theta0, mu0, theta, L, x and y. In double precision and without proof; the Python package proves.
  given = spragsym.one_set(p, {'theta0', 'mu0'});
  if given.alpha == 1 + given.beta
    rows = without_a(given);
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
  ends = [s * (1 - 1e-6), min(s * (1 + 1e-6), 1)];
  if excess(ends(1), given) * excess(ends(2), given) < 0
    s = fzero(@(sine) excess(sine, given), ends);
  end
end

function value = excess(s, given)
  [s0, over_cosine] = spragsym.algebra.cusp_point(s, given.fixed{:});
  value = over_cosine ^ 2 * (1 - s) * (1 + s) - (1 - s0) * (1 + s0);
end

function rows = without_a(given)
% alpha = 1 + beta: f'' = 0 on a fold means 3 sin^2 theta = 2, whatever the friction.
  s = sqrt(2 / 3);
  rows = zeros(0, 5);
  for c = [-1, 1] / sqrt(3)
    coefficients = cell(1, 5);
    [coefficients{:}] = spragsym.algebra.fold_quartic(c, s, given.fixed{:});
    for mu0 = spragsym.positive_roots([coefficients{:}])
      [s0, c0] = spragsym.algebra.fold_angles(c, s, mu0, given.fixed{:});
      rows(end + 1, :) = [c, s, c0, s0, mu0]; %#ok<AGROW>
    end
  end
end
