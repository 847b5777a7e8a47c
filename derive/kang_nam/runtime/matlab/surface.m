function found = surface(p, theta, theta0)
%SURFACE  The equilibrium surface, explicitly: the friction at which theta is the direction of an equilibrium in contact.
%  found = spragsym.surface(p, theta, theta0) with arrays of one size, or a number for one of them
%
%  p holds kappa, alpha, sigma and beta, one number each; its theta0 and mu0 are not used. The result has the fields mu0 (of
%  either sign), L, x, y and stability (codes of spragsym.equilibria), of the size of the arrays; NaN and code 0 where there is no
%  state in contact with finite friction.
  given = spragsym.one_set(p, {'theta0', 'mu0'});
  shape = size(theta);
  if isscalar(theta)
    shape = size(theta0);
  end
  theta = spragsym.checks.numbers('theta0', theta, [], 'theta');
  theta0 = spragsym.checks.numbers('theta0', theta0);
  if ~isscalar(theta) && ~isscalar(theta0) && numel(theta) ~= numel(theta0)
    error('spragsym:size', 'theta has %d numbers and theta0 %d; give one number or as many', numel(theta), numel(theta0));
  end
  theta = theta + zeros(size(theta0));
  theta0 = theta0 + zeros(size(theta));
  at = spragsym.kernel.cosine_and_sine(theta);
  along = spragsym.kernel.cosine_and_sine(theta0);
  mu0 = spragsym.algebra.surface(at.cosine, at.sine, along.cosine, along.sine, given.fixed{:});
  [L, x, y] = spragsym.algebra.state(at.cosine, at.sine, along.cosine, along.sine, given.kappa, given.sigma, given.beta, 1);
  [a, b, d, m] = spragsym.algebra.f_coefficients(along.cosine, along.sine, mu0, given.fixed{:}, 1);
  slope = spragsym.algebra.f_slope(at.cosine, at.sine, a, b, d, m);
  point = spragsym.point(struct('theta0', theta0, 'mu0', mu0, 'kappa', given.kappa, 'alpha', given.alpha, ...
                                'sigma', given.sigma, 'beta', given.beta), 1);
  kind = spragsym.kernel.stability(at, L, slope, 0, point);
  good = L > 0 & y < 0 & isfinite(mu0);
  code = kind.code;
  code(~good) = 0;
  found = struct('mu0', mu0, 'L', L, 'x', x, 'y', y);
  names = fieldnames(found);
  for k = 1:numel(names)
    found.(names{k})(~good) = NaN;
    found.(names{k}) = reshape(found.(names{k}), shape);
  end
  found.stability = reshape(code, shape);
end
