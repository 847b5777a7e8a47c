function found = folds(p, vary)
%FOLDS  The folds in contact along one parameter with the others fixed: f = f' = 0.
%  found = spragsym.folds(p) along theta0, or spragsym.folds(p, vary) with the name of one of the six parameters
%
%  p holds one number each; the one that varies may be left out. The result has the columns theta0, mu0, kappa, alpha, sigma,
%  beta, theta, L, x and y, by ascending value of what varies. In double precision and without proof; the Python package proves.
%
%  f is linear in every parameter but theta0, so that f = f' = 0 leaves a polynomial in tan(theta/2) alone.
  names = {'theta0', 'mu0', 'kappa', 'alpha', 'sigma', 'beta'};
  if nargin < 2
    vary = 'theta0';
  end
  if ~any(strcmp(vary, names))
    error('spragsym:range', 'vary = %s is not among %s', spragsym.input.shown(vary), strjoin(names, ', '));
  end
  given = spragsym.fold_set(p, {vary});
  if strcmp(vary, 'theta0')
    guesses = in_theta0(given);
  else
    guesses = in_parameter(vary, given);
  end
  rows = zeros(0, 10);
  for k = 1:size(guesses, 1)
    rows = [rows; fold_at(guesses(k, :), vary, given, names)]; %#ok<AGROW>
  end
  rows = sortrows(rows, find(strcmp(vary, names)));
  names = [names, {'theta', 'L', 'x', 'y'}];
  for k = 1:numel(names)
    found.(names{k}) = rows(:, k);
  end
end

function guesses = in_parameter(vary, given)
% Directions and values of all folds along a parameter that f is linear in.
  given.(vary) = 0;
  [line, change] = around(given, vary);
  if symmetric(vary, given)
    theta = 0.5 * pi;
    value = -spragsym.algebra.f_slope(0, 1, line{:}) / spragsym.algebra.f_slope(0, 1, change{:});
  else
    coefficients = cell(1, 7);
    [coefficients{:}] = spragsym.algebra.fold_sextic(line{:}, change{:});
    theta = directions([coefficients{:}]);
    [c, s] = turned(theta);
    value = -spragsym.algebra.f(c, s, line{:}) ./ spragsym.algebra.f(c, s, change{:});
  end
  guesses = [theta, value];
end

function guesses = in_theta0(given)
% Directions and values of all folds along theta0, whose sine and cosine are known in a direction: both squares add up to 1.
  values = [{given.mu0}, given.fixed];
  % Two roots lie so close together below this, as the folds at theta0 and at pi - theta0 do without alpha, that the coefficients
  % can't tell them; the curves of folds can.
  if given.alpha > 0 && given.alpha < 1e-6 * (1 + given.beta + given.sigma)
    guesses = zeros(0, 2);
    curves = spragsym.curves('folds', linspace(1e-9, pi - 1e-9, 513), given);
    for k = 1:numel(curves)
      rows = spragsym.changes(curves(k), @(at) at(:, 3) - given.mu0, given);
      guesses = [guesses; rows(:, 1:2)]; %#ok<AGROW>
    end
    return
  end
  parts = cell(1, 14);
  [parts{:}] = spragsym.algebra.fold_cubics(values{:});
  sines = [parts{1:7}];
  cosines = [parts{8:14}];
  if given.alpha == 0
    theta = 0.5 * pi;
    if ~symmetric('theta0', given)
      theta = directions(cosines);
    end
    [c, s] = turned(theta);
    theta0 = asin(spragsym.algebra.fold_sine(c, s, values{:}) + 0 * c);
    guesses = [theta, theta0; theta, pi - theta0];
    guesses = guesses(imag(guesses(:, 2)) == 0, :);
    return
  end
  width = given.alpha * (given.beta + 1 + given.sigma);
  scale = (given.alpha + given.sigma) * (given.beta + 1) * width;
  squares = width ^ 2 * conv(sines, sines) + conv(cosines, cosines);
  squares(1:2:end) = squares(1:2:end) - scale ^ 2 * [1, 6, 15, 20, 15, 6, 1];
  theta = directions(squares);
  [c, s] = turned(theta);
  [sine, cosine] = spragsym.algebra.fold_angles(c, s, values{:});
  guesses = [theta, atan2(sine, cosine)];
end

function row = fold_at(guess, vary, given, names)
% A fold with its state; none where what varies is out of its range, or where the state is out of contact.
  row = zeros(0, 10);
  [theta, value, settled] = sharpened(guess(1), guess(2), vary, given);
  ends = spragsym.input.range(vary);
  if ~(value > ends(1) && value < ends(2))
    return
  end
  given.(vary) = value;
  [c, s] = turned(theta);
  [c0, s0] = turned(given.theta0);
  [L, x, y] = spragsym.algebra.state(c, s, c0, s0, given.kappa, given.sigma, given.beta, 1);
  if L > 0 && y < 0
    if ~settled
      error('spragsym:range', ['a fold near %s = %s can''t be told from its neighbours in double precision; the Python ' ...
            'package''s folds can'], vary, spragsym.input.shown(value));
    end
    values = cellfun(@(name) given.(name), names);
    row = [values, theta, L, x, y];
  end
end

function [theta, value, settled] = sharpened(theta, value, vary, given)
% To all digits, of which the polynomial has lost some: Newton's steps for the direction by f' and for the value by f. Settled, if
% they come to an end.
  settled = symmetric(vary, given);
  for pass = 1:30 * ~settled
    if ~isfinite(value) || (strcmp(vary, 'theta0') && ~(value > 0 && value < pi))
      return
    end
    given.(vary) = value;
    [line, change] = around(given, vary);
    [c, s] = turned(theta);
    turn = spragsym.algebra.f_slope(c, s, line{:}) / spragsym.algebra.f_curvature(c, s, line{:});
    rise = spragsym.algebra.f(c, s, line{:}) / spragsym.algebra.f(c, s, change{:});
    if ~(abs(turn) < 0.01 * s && abs(rise) < 0.01 * abs(value))
      return
    end
    theta = theta - turn;
    value = value - rise;
    if abs(turn) < 1e-9 * s && abs(rise) < 1e-12 * abs(value)
      settled = true;
      return
    end
  end
end

function yes = symmetric(vary, given)
% Whether f has the factor cos theta: without friction and alpha nothing tells left from right, and equilibria meet upright only.
  yes = ~any(strcmp(vary, {'mu0', 'alpha'})) && given.mu0 == 0 && given.alpha == 0;
end

function [line, change] = around(given, vary)
% Coefficients a, b, d, m of f at a point in contact, and their derivatives by one of the parameters.
  [c0, s0] = turned(given.theta0);
  values = {c0, s0, given.mu0, given.kappa, given.alpha, given.sigma, given.beta};
  line = cell(1, 4);
  [line{:}] = spragsym.algebra.f_coefficients(values{:}, 1);
  changes = cell(1, 24);
  [changes{:}] = spragsym.algebra.f_changes(values{:});
  place = find(strcmp(vary, {'theta0', 'mu0', 'kappa', 'alpha', 'sigma', 'beta'}));
  change = changes(4 * place - 3:4 * place);
end

function theta = directions(coefficients)
% Angles in (0, pi), a column, whose tan(theta/2) is a root.
  theta = 2 * atan(spragsym.positive_roots(coefficients / max(abs(coefficients))))';
end

function [c, s] = turned(angle)
  along = spragsym.kernel.cosine_and_sine(angle);
  c = along.cosine;
  s = along.sine;
end
