function found = equilibria(p, contact)
%EQUILIBRIA  All equilibria of every point with their stability and a bound on their errors.
%  found = spragsym.equilibria(p) for those in contact, y < 0
%  found = spragsym.equilibria(p, false) for those in lift-off, y >= 0
%
%  p is a structure with theta0 in (0, pi), mu0 >= 0, kappa > 0, alpha >= 0, sigma > 0 and beta >= 0; see spragsym.article. Each
%  field holds one number or n of them. The result is a structure:
%
%  status     n x 1; 0: the number, the kinds and twelve digits are vouched for; where double precision can't, close to a fold, to
%             a cusp or to the onset of flutter, double-double arithmetic decides; 1: that can't either, closer still, with
%             hardly any preload, or far from the scale of the article: the best guess is given, which may be none at all;
%             3: double can't carry the problem, nothing is given
%  count      n x 1, how many equilibria
%  theta, L, x, y   n x 3 in contact, n x 4 in lift-off: a column for each equilibrium, by ascending theta, NaN beyond count
%  stability  of the same size: 0 none, 1 stable, 2 divergent, 3 flutter
%  error      of the same size: a bound on |error| of theta, L, x and y, each over max(1, |exact value|); Inf if none is known
%
%  Roots of (12), (13) with (22)-(25). The operations are those of the C library.
  if nargin < 2
    contact = true;
  end
  if ~isscalar(contact) || ~(islogical(contact) || isequal(contact, 0) || isequal(contact, 1))
    error('spragsym:type', 'contact = %s must be true or false', spragsym.checks.shown(contact));
  end
  contact = logical(contact);
  given = spragsym.checks.parameters(p);
  point = spragsym.point(given, double(contact));
  found = answers(point, plainly(), contact, numel(given.theta0));
  found.status(~spragsym.kernel.representable(spragsym.kernel.balance_(point))) = 3;
  open = find(found.status == 1);
  if ~isempty(open)
    again = answers(wide_point(taken(given, open), double(contact)), widely(), contact, numel(open));
    settled = again.status == 0;
    names = fieldnames(found);
    for k = 1:numel(names)
      found.(names{k})(open(settled), :) = again.(names{k})(settled, :);
    end
  end
end

function way = plainly()
% The kernel on doubles.
  way = struct('balance', @(point) spragsym.kernel.balance_(point), ...
               'carried', @(point, line) spragsym.kernel.representable(line), ...
               'guesses', @(point, line) spragsym.kernel.guesses(point, line, 0.5 * eps), ...
               'at_root', @(t, point, line) spragsym.kernel.at_root(t, point, line, 0.5 * eps), ...
               'apart', @spragsym.kernel.apart, 'leading', @(t) t, 'stored', 0);
end

function way = widely()
% The kernel on double-doubles. Stored as doubles, theta, L, x and y are off by some roundings more: the arc tangent is within one
% unit in the last place, and its argument is rounded.
  u = @WIDE_ROUNDOFF@;
  way = struct('balance', @(point) spragsym.kernel.wide_balance(point), ...
               'carried', @(point, line) spragsym.kernel.wide_representable(line) & spragsym.kernel.wide_moderate(point), ...
               'guesses', @(point, line) spragsym.kernel.wide_guesses(point, line, u), ...
               'at_root', @(t, point, line) spragsym.kernel.wide_at_root(t, point, line, u), ...
               'apart', @spragsym.kernel.wide_apart, 'leading', @spragsym.kernel.dd_leading, 'stored', 2 * eps);
end

function point = wide_point(given, nbar)
% Checked parameters as the kernel takes them on double-doubles.
  along = spragsym.kernel.dd_cosine_and_sine(given.theta0);
  point = struct('cos0', spragsym.kernel.paired(along.cosine_high, along.cosine_low), ...
                 'sin0', spragsym.kernel.paired(along.sine_high, along.sine_low));
  names = {'mu0', 'kappa', 'alpha', 'sigma', 'beta'};
  for k = 1:numel(names)
    point.(names{k}) = spragsym.kernel.paired(given.(names{k}), 0);
  end
  point.nbar = spragsym.kernel.paired(nbar, 0);
end

function found = answers(point, way, contact, points)
% What one kind of number says about every point.
  tolerance = 1e-12;
  line = way.balance(point);
  good = way.carried(point, line);
  guessed = way.guesses(point, line);
  slots = 4 - contact;
  found = struct('status', zeros(points, 1), 'count', zeros(points, 1));
  names = {'theta', 'L', 'x', 'y', 'stability', 'error'};
  for k = 1:numel(names)
    found.(names{k}) = NaN(points, slots);
  end
  found.stability(:) = 0;
  certain = guessed.certain & good & true(points, 1);
  last_t = [];
  last_radius = zeros(points, 1);
  for slot = 1:slots
    rows = find(good & guessed.count >= slot);
    if isempty(rows)
      break
    end
    all_t = guessed.(sprintf('t%d', slot - 1));
    t = taken(all_t, rows);
    root = way.at_root(t, taken(point, rows), taken(line, rows));
    root.error = root.error + way.stored;
    % Two proved roots are different when the intervals that hold them are; in contact all lie above t = 0.
    if slot > 1
      separate = way.apart(taken(last_t, rows), last_radius(rows), t, root.radius);
    else
      separate = ~contact | way.leading(t) > 0;
    end
    sure = root.outsider | (root.member & root.known & root.error <= tolerance);
    certain(rows) = certain(rows) & sure & separate;
    last_t = all_t;
    last_radius(rows) = root.radius;
    if contact
      clear_of = root.y < 0;
    else
      clear_of = root.y >= 0;
    end
    keep = isfinite(root.L + root.x + root.y) & root.L > 0 & clear_of;
    found.count(rows(keep)) = found.count(rows(keep)) + 1;
    place = rows(keep) + points * (found.count(rows(keep)) - 1);
    theta = 2 * spragsym.kernel.arctangent(way.leading(t));
    found.theta(place) = theta(keep);
    found.L(place) = root.L(keep);
    found.x(place) = root.x(keep);
    found.y(place) = root.y(keep);
    found.stability(place) = root.code(keep);
    bound = root.error(keep);
    bound(~isfinite(bound)) = Inf;
    found.error(place) = bound;
  end
  found = in_order(found, names);
  found.status = double(~(certain & (~contact | mod(found.count, 2) == 1)));
end

function some = taken(record, rows)
% The rows of a column, or of every column of a structure; numbers stand for all rows.
  if isstruct(record)
    names = fieldnames(record);
    for k = 1:numel(names)
      some.(names{k}) = taken(record.(names{k}), rows);
    end
  elseif isscalar(record)
    some = record;
  else
    some = record(rows);
  end
end

function found = in_order(found, names)
% Roots that may be one can have changed places.
  [~, order] = sort(found.theta, 2);
  points = size(order, 1);
  place = repmat((1:points)', 1, size(order, 2)) + points * (order - 1);
  for k = 1:numel(names)
    found.(names{k}) = reshape(found.(names{k})(place), size(place));
  end
end
