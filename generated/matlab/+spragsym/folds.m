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
  rows = zeros(0, 3);
  for k = 1:numel(curves)
    along = [curves(k).theta, curves(k).theta0, curves(k).mu0];
    rows = [rows; meetings(along, 2 + strcmp(held, 'mu0'), value, given)]; %#ok<AGROW>
  end
  rows = sortrows(rows, 2 + strcmp(vary, 'mu0'));
  [L, x, y] = spragsym.algebra.state(cos(rows(:, 1)), sin(rows(:, 1)), cos(rows(:, 2)), sin(rows(:, 2)), given.kappa, ...
                                     given.sigma, given.beta, 1);
  found = struct('theta0', rows(:, 2), 'mu0', rows(:, 3), 'theta', rows(:, 1), 'L', L, 'x', x, 'y', y);
end

function rows = meetings(along, held, value, given)
% Rows of theta, theta0, mu0 where a curve has the value in the column that is held.
  rows = zeros(0, 3);
  off = along(:, held) - value;
  for k = find(off(1:end - 1) == 0)'
    rows(end + 1, :) = along(k, :); %#ok<AGROW>
  end
  for k = find(off(1:end - 1) .* off(2:end) < 0)'
    [one, other] = deal(along(k, :), along(k + 1, :));
    near = @(theta) nearest(theta, one, other, given);
    at = @(theta) near(theta) * ((1:3)' == held) - value;
    row = one;
    if one(1) ~= other(1) && at(one(1)) * at(other(1)) < 0
      row = near(fzero(at, sort([one(1), other(1)])));
    end
    row(held) = value;
    rows(end + 1, :) = row; %#ok<AGROW>
  end
end

function row = nearest(theta, one, other, given)
% The fold in a direction that lies on the way from one to the other.
  theta0 = 2 * atan(spragsym.positive_roots(spragsym.turns('folds', theta, given)))';
  expected = one(2) + (other(2) - one(2)) * (theta - one(1)) / (other(1) - one(1));
  [~, k] = min(abs(theta0 - expected));
  row = [theta, theta0(k), spragsym.turn_friction('folds', theta, theta0(k), given)];
end
