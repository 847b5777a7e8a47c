function state = step(model, h, state)
%STEP  One step of length h > 0 by the classical Runge-Kutta method, of fourth order across the kinks.
%  state = spragsym.step(model, h, state)
%
%  A step that ends on the other side of a kink, y = 0 or x' = V, is cut there, at most twice, and goes on in the new regime. Not
%  seen: a kink that is crossed and crossed back within one step, and a third kink in one step; each costs an error of order h^3.
  pieces = 3;
  if ~isnumeric(h) || ~isscalar(h) || ~isreal(h) || ~(h > 0) || isinf(h)
    error('spragsym:range', 'h = %s is not in (0, Inf)', spragsym.checks.shown(h));
  end
  if ~isnumeric(state) || ~isreal(state) || numel(state) ~= 4 || ~all(isfinite(state(:)))
    error('spragsym:type', 'state must be four finite numbers, x, y and their rates');
  end
  state = state(:);
  start = state;
  left = h;
  regime = spragsym.regime(model, state);
  for k = 1:pieces
    if left > 0
      [state, left, regime] = piece(model, regime, left, state, k == pieces);
    end
  end
  if ~all(isfinite(state))
    error('spragsym:range', 'h = %s leads from [%s] out of what double can hold: h is too long, or L = 0', ...
          spragsym.checks.shown(h), num2str(start'));
  end
end

function [next, left, regime] = piece(model, regime, h, state, last)
% As far as the first kink, or to the end of h: the state there, what is left of h, and the regime beyond.
  before = spragsym.kinks(model, regime, state);
  next = runge_kutta(model, regime, h, state);
  after = spragsym.kinks(model, regime, next);
  share = ones(2, 1);
  crossed = before > 0 & after < 0;
  share(crossed) = before(crossed) ./ (before(crossed) - after(crossed));
  [share, kink] = min(share);
  left = 0;
  if last || ~(share < 1)
    return
  end
  % Regula falsi on the step itself: each pass gains an order in h.
  low = 0;
  high = 1;
  at_low = before(kink);
  at_high = after(kink);
  secants = 2;
  for pass = 1:secants
    next = runge_kutta(model, regime, share * h, state);
    at = spragsym.kinks(model, regime, next);
    if at(kink) > 0
      low = share;
      at_low = at(kink);
    else
      high = share;
      at_high = at(kink);
    end
    if pass < secants && at_low > at_high
      share = low + (high - low) * at_low / (at_low - at_high);
    end
  end
  regime = spragsym.beyond(regime, kink);
  left = (1 - share) * h;
end

function next = runge_kutta(model, regime, h, state)
% One classical step in one smooth regime.
  k1 = spragsym.regime_rhs(model, regime, state);
  k2 = spragsym.regime_rhs(model, regime, state + 0.5 * h * k1);
  k3 = spragsym.regime_rhs(model, regime, state + 0.5 * h * k2);
  k4 = spragsym.regime_rhs(model, regime, state + h * k3);
  next = state + h / 6 * (k1 + 2 * (k2 + k3) + k4);
end
