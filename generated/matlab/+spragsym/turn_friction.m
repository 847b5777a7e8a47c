function mu0 = turn_friction(kind, theta, theta0, given)
%TURN_FRICTION  The friction of folds, or of flutter onsets, at theta and some theta0.
  c = cos(theta);
  s = sin(theta);
  if strcmp(kind, 'folds')
    [u1, w1, u2, w2] = spragsym.algebra.fold_lines_mu0(c, s, cos(theta0), sin(theta0), given.fixed{:});
    % From the relation that does not lose it: the first has the factor cos theta.
    if abs(c) > 0.3
      mu0 = -u1 ./ w1;
    else
      mu0 = -u2 ./ w2;
    end
  else
    L = spragsym.algebra.state(c, s, cos(theta0), sin(theta0), given.kappa, given.sigma, given.beta, 1);
    mu0 = spragsym.algebra.flutter_friction(c, s, L, given.alpha, given.sigma, given.beta);
  end
end
