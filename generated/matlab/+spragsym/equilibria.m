function found = equilibria(p, contact)
%EQUILIBRIA  All equilibria of every point with their stability and a bound on their errors.
%  found = spragsym.equilibria(p) for those in contact, y < 0
%  found = spragsym.equilibria(p, false) for those in lift-off, y >= 0
%
%  p is a structure with theta0 in (0, pi), mu0 >= 0, kappa > 0, alpha >= 0, sigma > 0 and beta >= 0; see spragsym.article. Each
%  field holds one number or n of them. The result is a structure:
%
%  status     n x 1; 0: the number, the kinds and twelve digits are vouched for; 1: double precision can't vouch for them, close
%             to a fold or to the onset of flutter, with hardly any preload, or far from the scale of the article: the best
%             guess is given, which may be none at all; 3: double can't carry the problem, nothing is given
%  count      n x 1, how many equilibria
%  theta, L, x, y   n x 3 in contact, n x 4 in lift-off: a column for each equilibrium, by ascending theta, NaN beyond count
%  stability  of the same size: 0 none, 1 stable, 2 divergent, 3 flutter
%  error      of the same size: a bound on |error| of theta, L, x and y, each over max(1, |exact value|); Inf if none is known
%
%  Roots of (12), (13) with (22)-(25). The operations are those of the C library in double precision.
  tolerance = 1e-12;
  u = 0.5 * eps;
  if nargin < 2
    contact = true;
  end
  if ~isscalar(contact) || ~(islogical(contact) || isequal(contact, 0) || isequal(contact, 1))
    error('spragsym:type', 'contact = %s must be true or false', spragsym.input.shown(contact));
  end
  contact = logical(contact);
  given = spragsym.input.parameters(p);
  points = numel(given.theta0);
  point = spragsym.point(given, double(contact));
  line = spragsym.kernel.balance_(point);
  good = spragsym.kernel.representable(line);
  guessed = spragsym.kernel.guesses(point, line, u);
  slots = 4 - contact;
  names = {'theta', 'L', 'x', 'y', 'stability', 'error'};
  for k = 1:numel(names)
    found.(names{k}) = NaN(points, slots);
  end
  found.stability(:) = 0;
  count = zeros(points, 1);
  certain = guessed.certain & true(points, 1);
  last_t = zeros(points, 1);
  last_radius = zeros(points, 1);
  for slot = 1:slots
    rows = find(good & guessed.count >= slot);
    if isempty(rows)
      break
    end
    t = guessed.(sprintf('t%d', slot - 1))(rows);
    root = spragsym.kernel.at_root(t, taken(point, rows), taken(line, rows), u);
    % Two proved roots are different when the intervals that hold them are; in contact all lie above t = 0.
    if slot > 1
      separate = spragsym.kernel.apart(last_t(rows), last_radius(rows), t, root.radius);
    else
      separate = ~contact | t > 0;
    end
    sure = root.outsider | (root.member & root.known & root.error <= tolerance);
    certain(rows) = certain(rows) & sure & separate;
    last_t(rows) = t;
    last_radius(rows) = root.radius;
    if contact
      clear_of = root.y < 0;
    else
      clear_of = root.y >= 0;
    end
    keep = isfinite(root.L + root.x + root.y) & root.L > 0 & clear_of;
    count(rows(keep)) = count(rows(keep)) + 1;
    place = rows(keep) + points * (count(rows(keep)) - 1);
    found.theta(place) = 2 * spragsym.kernel.arctangent(t(keep));
    found.L(place) = root.L(keep);
    found.x(place) = root.x(keep);
    found.y(place) = root.y(keep);
    found.stability(place) = root.code(keep);
    bound = root.error(keep);
    bound(~isfinite(bound)) = Inf;
    found.error(place) = bound;
  end
  found = in_order(found, names);
  found.count = count;
  found.status = double(~(certain & (~contact | mod(count, 2) == 1)));
  found.status(~good) = 3;
  found = orderfields(found, [{'status', 'count'}, names]);
end

function some = taken(record, rows)
% The rows of every column of a structure; numbers stand for all rows.
  names = fieldnames(record);
  for k = 1:numel(names)
    value = record.(names{k});
    if isscalar(value)
      some.(names{k}) = value;
    else
      some.(names{k}) = value(rows);
    end
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
