function [mu0, theta0, kind] = critical_friction(p)
%CRITICAL_FRICTION  The lowest fold: below its friction the state of small deformation jumps at no inclination.
%  [mu0, theta0, kind] = spragsym.critical_friction(p) with kappa, alpha, sigma and beta, one number each
%
%  kind is 'cusp', 'turn' where the curve of folds turns back in mu0, 'end' where it is lowest as theta0 goes to 0, or '' where
%  no fold ends it: then mu0 is Inf and theta0 NaN. In double precision and without proof; the Python package proves.
  given = spragsym.fold_set(p, {'theta0', 'mu0'});
  found = spragsym.cusps(p);
  ahead = found.theta0 < 0.5 * pi;
  rows = [found.theta0(ahead), found.mu0(ahead), ones(sum(ahead), 1)];
  if given.alpha > 0
    curves = spragsym.curves('folds', linspace(1e-9, pi - 1e-9, 513), given);
    for k = 1:numel(curves)
      rows = [rows; falling(spragsym.changes(curves(k), @(at) tilt(at, given), given), 2, given)]; %#ok<AGROW>
    end
  end
  rows = [rows; falling(level(given), 3, given)];
  kinds = {'cusp', 'turn', 'end'};
  [mu0, least] = min([rows(:, 2); Inf]);
  [theta0, kind] = deal(NaN, '');
  if least <= size(rows, 1)
    [theta0, kind] = deal(rows(least, 1), kinds{rows(least, 3)});
  end
end

function rows = falling(at, code, given)
% theta0, mu0 and a code of those folds, rows of theta, theta0 and mu0, at which the lower two of three states meet.
  c0 = cos(at(:, 2));
  [a, b, d, m] = spragsym.algebra.f_coefficients(c0, sin(at(:, 2)), at(:, 3), given.fixed{:}, 1);
  good = spragsym.algebra.f_curvature(cos(at(:, 1)), sin(at(:, 1)), a, b, d, m) < 0 & at(:, 3) > 0 & c0 > 0;
  rows = [at(good, [2, 3]), code + 0 * at(good, 1)];
end

function value = tilt(at, given)
% The derivative of f by theta0.
  change = cell(4, 6);
  [change{:}] = spragsym.algebra.f_changes(cos(at(:, 2)), sin(at(:, 2)), at(:, 3), given.fixed{:});
  value = spragsym.algebra.f(cos(at(:, 1)), sin(at(:, 1)), change{:, 1});
end

function at = level(given)
% The folds along mu0 at theta0 = 0.
  [line, change, coefficients] = deal(cell(1, 4), cell(4, 6), cell(1, 7));
  [line{:}] = spragsym.algebra.f_coefficients(1, 0, 0, given.fixed{:}, 1);
  [change{:}] = spragsym.algebra.f_changes(1, 0, 0, given.fixed{:});
  [coefficients{:}] = spragsym.algebra.fold_sextic(line{:}, change{:, 2});
  theta = 2 * atan(spragsym.positive_roots([coefficients{:}]))';
  [c, s] = deal(cos(theta), sin(theta));
  at = [theta, 0 * theta, -spragsym.algebra.f(c, s, line{:}) ./ spragsym.algebra.f(c, s, change{:, 2})];
end
