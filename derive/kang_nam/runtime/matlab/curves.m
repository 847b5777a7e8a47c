function found = curves(kind, directions, given)
%CURVES  Curves of folds or of flutter onsets in the plane of theta0 and mu0: what bifurcation_set and flutter_boundary stand on.
%  found = spragsym.curves('folds' or 'onsets', directions, given)
%
%  In a direction theta friction is eliminated; all points there are the positive roots of a polynomial in tan(theta0/2).
%  Between neighbouring directions with the same number of roots the k-th belongs to the k-th. Where their number changes, more
%  directions are put in between until the place is known to rounding; two roots that are born or vanish together are joined
%  there. In double precision and without proof: what two curves that all but touch do, rounding may decide. Where far more
%  columns or curves come up than regular sets have, all is rounding, and an error says so.
  columns = refined(kind, columns_at(directions(:)', kind, given), given);
  parts = joined(columns);
  found = struct('theta0', {}, 'mu0', {}, 'theta', {}, 'L', {}, 'x', {}, 'y', {});
  for k = 1:numel(parts)
    pieces = with_friction(parts{k}, kind, given);
    for i = 1:numel(pieces)
      done = completed(pieces{i}, given);
      if numel(done.theta) > 1
        found(end + 1) = done; %#ok<AGROW>
      end
    end
  end
  if numel(found) > 32
    indistinct(given);
  end
end

function indistinct(given)
  error('spragsym:range', ['kappa = %s, alpha = %s, sigma = %s, beta = %s: curves lie closer together there than double ' ...
        'precision can tell, as with hardly any preload; spragsym.folds gives the folds along one parameter'], ...
        spragsym.input.shown(given.kappa), spragsym.input.shown(given.alpha), spragsym.input.shown(given.sigma), ...
        spragsym.input.shown(given.beta));
end

function columns = columns_at(directions, kind, given)
  columns = arrayfun(@(theta) column(theta, kind, given), directions, 'UniformOutput', false);
  columns = [columns{:}];
end

function result = column(theta, kind, given)
% All points in one direction, rows of theta, theta0 and mu0 by ascending theta0; signs of the polynomial at theta0 = 0 and pi.
  polynomial = spragsym.turns(kind, theta, given);
  polynomial = polynomial / max(abs(polynomial));
  theta0 = 2 * atan(spragsym.positive_roots(polynomial))';
  result.theta = theta;
  result.points = [theta + 0 * theta0, theta0, spragsym.turn_friction(kind, theta, theta0, given)];
  result.ends = sign(polynomial([1, end]));
end

function far = gap(one, other)
% Distances of points in the plane, friction without bound brought into a bounded range.
  far = max(abs(one(:, 2) - other(:, 2)), abs(squeezed(one(:, 3)) - squeezed(other(:, 3))));
end

function value = squeezed(mu0)
  value = mu0 ./ (1 + abs(mu0));
end

function same = same_kind(one, other)
  same = size(one.points, 1) == size(other.points, 1) && all(one.ends == other.ends);
end

function columns = refined(kind, columns, given)
% More columns, so that of each two neighbours the points go on in order, or no double is left in between.
  finest = 1e-13;
  stride = 0.04;
  settled = false(1, numel(columns) - 1);
  while ~all(settled)
    for k = find(~settled)
      [one, other] = deal(columns(k), columns(k + 1));
      settled(k) = other.theta - one.theta < finest || ...
                   (same_kind(one, other) && all(gap(one.points, other.points) < stride));
    end
    open = find(~settled);
    if numel(columns) + numel(open) > 30000
      indistinct(given);
    end
    middles = arrayfun(@(k) 0.5 * (columns(k).theta + columns(k + 1).theta), open);
    fresh = columns_at(middles, kind, given);
    [~, order] = sort([1:numel(columns), open + 0.5]);
    columns = [columns, fresh]; %#ok<AGROW>
    columns = columns(order);
    halves = sort([1:numel(settled), open + 0.5]);
    settled = settled(floor(halves));
  end
end

function pairs = links(before, now)
% Rows [i, j]: the i-th point of one column goes on as the j-th of the next.
  stride = 0.04;
  count = size(now.points, 1);
  if same_kind(before, now)
    pairs = [1:count; 1:count]';
    return
  end
  pairs = zeros(0, 2);
  [i, j] = ndgrid(1:size(before.points, 1), 1:count);
  far = abs(before.points(i(:), 2) - now.points(j(:), 2));
  [far, order] = sort(far);
  for k = 1:numel(order)
    pair = [i(order(k)), j(order(k))];
    if far(k) < stride && ~any(pairs(:, 1) == pair(1)) && ~any(pairs(:, 2) == pair(2))
      pairs(end + 1, :) = pair; %#ok<AGROW>
    end
  end
end

function pairs = couples(points, linked)
% Neighbours in a column without a link to the next one: they are born or vanish together in between.
  stride = 0.04;
  free = setdiff(1:size(points, 1), linked);
  pairs = zeros(0, 2);
  while numel(free) > 1
    [nearest, k] = min(diff(points(free, 2)));
    if nearest > stride
      break
    end
    pairs(end + 1, :) = free([k, k + 1]); %#ok<AGROW>
    free([k, k + 1]) = [];
  end
end

function found = joined(columns)
% Curves through the points of neighbouring columns, each an array of points in order; a closed one ends with its first.
  counts = arrayfun(@(one) size(one.points, 1), columns);
  first = cumsum([0, counts]);
  points = cat(1, columns.points);
  pairs = cell(1, 0);
  for k = 1:numel(columns) - 1
    linked = links(columns(k), columns(k + 1));
    pairs{end + 1} = [first(k) + linked(:, 1), first(k + 1) + linked(:, 2)]; %#ok<AGROW>
    if ~same_kind(columns(k), columns(k + 1))
      pairs{end + 1} = first(k) + couples(columns(k).points, linked(:, 1)); %#ok<AGROW>
      pairs{end + 1} = first(k + 1) + couples(columns(k + 1).points, linked(:, 2)); %#ok<AGROW>
    end
  end
  pairs = cat(1, pairs{:});
  neighbours = zeros(size(points, 1), 2);
  for k = 1:size(pairs, 1)
    [one, other] = deal(pairs(k, 1), pairs(k, 2));
    neighbours(one, 1 + (neighbours(one, 1) > 0)) = other;
    neighbours(other, 1 + (neighbours(other, 1) > 0)) = one;
  end
  left = true(size(points, 1), 1);
  open = find(neighbours(:, 1) > 0 & neighbours(:, 2) == 0)';
  found = {};
  for start = [open, find(all(neighbours > 0, 2))']
    if left(start)
      [along, left] = walk(start, neighbours, left);
      if neighbours(start, 2) > 0
        along(end + 1) = start; %#ok<AGROW>
      end
      found{end + 1} = points(along, :); %#ok<AGROW>
    end
  end
end

function [along, left] = walk(start, neighbours, left)
  along = zeros(1, 0);
  while start > 0
    left(start) = false;
    along(end + 1) = start; %#ok<AGROW>
    next = neighbours(start, :);
    next = next(next > 0);
    next = next(left(next));
    start = 0;
    if ~isempty(next)
      start = next(1);
    end
  end
end

function parts = with_friction(curve, kind, given)
% The parts of a curve with mu0 >= 0, each begun and ended where mu0 = 0.
  parts = {};
  good = curve(:, 3) >= 0;
  starts = find(good & ~[false; good(1:end - 1)])';
  stops = find(good & ~[good(2:end); false])';
  for k = 1:numel(starts)
    part = curve(starts(k):stops(k), :);
    if starts(k) > 1
      part = [without_friction(curve(starts(k) - 1, :), part(1, :), kind, given); part]; %#ok<AGROW>
    end
    if stops(k) < size(curve, 1)
      part = [part; without_friction(part(end, :), curve(stops(k) + 1, :), kind, given)]; %#ok<AGROW>
    end
    parts{end + 1} = part; %#ok<AGROW>
  end
end

function row = without_friction(one, other, kind, given)
% The point between two at which friction is zero; none where it runs through infinity instead.
  row = zeros(0, 3);
  if one(1) == other(1) || min(abs([one(3), other(3)])) > 1e3 || one(3) * other(3) >= 0
    return
  end
  near = @(theta) nearest(column(theta, kind, given), one, other);
  ends = [near(one(1)); near(other(1))];
  if ends(1, 3) * ends(2, 3) < 0
    theta = fzero(@(theta) [0, 0, 1] * near(theta)', sort([one(1), other(1)]));
    row = near(theta);
    row = [row(abs(row(3)) < 1e-6, 1:2), zeros(abs(row(3)) < 1e-6, 1)];
  end
end

function row = nearest(at, one, other)
% The point of a column that lies on the way from one to the other.
  expected = one(2) + (other(2) - one(2)) * (at.theta - one(1)) / (other(1) - one(1));
  [~, k] = min(abs(at.points(:, 2) - expected));
  row = at.points(k, :);
end

function done = completed(curve, given)
% A curve with the states on it; those out of contact are left out.
  [theta, theta0, mu0] = deal(curve(:, 1), curve(:, 2), curve(:, 3));
  [L, x, y] = spragsym.algebra.state(cos(theta), sin(theta), cos(theta0), sin(theta0), given.kappa, given.sigma, given.beta, 1);
  good = L > 0 & y < 0 & isfinite(mu0);
  done = struct('theta0', theta0(good), 'mu0', mu0(good), 'theta', theta(good), 'L', L(good), 'x', x(good), 'y', y(good));
end
