function rows = changes(curve, value_at, given)
%CHANGES  The points of a curve of folds at which a function of them is zero or changes its sign: rows of theta, theta0, mu0.
  along = [curve.theta, curve.theta0, curve.mu0];
  values = value_at(along);
  rows = along(values == 0, :);
  for k = find(values(1:end - 1) .* values(2:end) < 0)'
    [one, other] = deal(along(k, :), along(k + 1, :));
    near = @(theta) nearest(theta, one, other, given);
    row = one;
    % Two that are born together stand at one direction; the place between them is known to rounding.
    if one(1) ~= other(1) && value_at(near(one(1))) * value_at(near(other(1))) < 0
      row = near(fzero(@(theta) value_at(near(theta)), sort([one(1), other(1)])));
    end
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
