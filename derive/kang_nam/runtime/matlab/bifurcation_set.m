function found = bifurcation_set(p, n)
%BIFURCATION_SET  Every curve of folds in the plane of theta0 and mu0, for 0 < theta0 < pi and mu0 >= 0, and the cusps on them.
%  found = spragsym.bifurcation_set(p) or spragsym.bifurcation_set(p, n) with n directions to begin with, at least 8
%
%  p holds kappa, alpha, sigma and beta, one number each; its theta0 and mu0 are not used. found.curves is an array of structures
%  with columns theta0, mu0, theta, L, x, y in order along each curve; found.cusps is what spragsym.cusps gives.
  if nargin < 2
    n = 512;
  end
  given = spragsym.fold_set(p, {'theta0', 'mu0'});
  directions = linspace(1e-9, pi - 1e-9, spragsym.input.whole('n', n, 8) + 1);
  found.curves = spragsym.curves('folds', unique([directions, hidden(directions, given)]), given);
  found.cusps = spragsym.cusps(p);
end

function found = hidden(directions, given)
% Directions between neighbours at which curves are born and vanish unseen: zoom in on where the indicator nears zero.
  value = indicator(directions, given);
  near = abs(value);
  middle = 2:numel(value) - 1;
  dips = near(middle) <= near(middle - 1) & near(middle) <= near(middle + 1) & ...
         sign(value(middle)) == sign(value(middle - 1)) & sign(value(middle)) == sign(value(middle + 1));
  found = zeros(1, 0);
  for k = middle(dips)
    found = [found, zoomed(directions(k - 1), directions(k + 1), given)]; %#ok<AGROW>
  end
end

function found = zoomed(low, high, given)
  found = zeros(1, 0);
  for pass = 1:6
    fine = linspace(low, high, 33);
    value = indicator(fine, given);
    found = fine(sign(value) ~= sign(value(1)));
    [~, best] = min(abs(value));
    if ~isempty(found) || best == 1 || best == 33
      return
    end
    [low, high] = deal(fine(best - 1), fine(best + 1));
  end
end

function value = indicator(theta, given)
% A number that changes its sign where two roots of the fold polynomial meet: its discriminant over the terms of that.
  [e0, e1, e2, ec] = spragsym.algebra.fold_conic(cos(theta), sin(theta), given.fixed{:});
  if given.alpha == 0
    value = (4 * e0 .* e2 - e1 .^ 2) ./ (4 * abs(e0 .* e2) + e1 .^ 2);
    return
  end
  e = [e0 + ec; 2 * e1; 4 * e2 + 2 * e0; 2 * e1; e0 - ec];
  e = e ./ repmat(max(abs(e)), 5, 1);
  [e0, e1, e2, e3, e4] = deal(e(1, :), e(2, :), e(3, :), e(4, :), e(5, :));
  P = 12 * e4 .* e0 - 3 * e3 .* e1 + e2 .^ 2;
  Q = 72 * e4 .* e2 .* e0 + 9 * e3 .* e2 .* e1 - 27 * (e4 .* e1 .^ 2 + e0 .* e3 .^ 2) - 2 * e2 .^ 3;
  value = (4 * P .^ 3 - Q .^ 2) ./ (4 * abs(P) .^ 3 + Q .^ 2);
end
