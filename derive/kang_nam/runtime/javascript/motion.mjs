// ------------------------------------------------------------------------------------------------------------ motion

const PIECES = 3;
const SECANTS = 2;

/**
 * The motion (8)-(11) at given parameters: its right-hand side, regimes and a step. A state is [x, y, x', y'].
 *
 * @param {object} parameters as of `equilibria`
 * @param {object} drive V, the belt's speed, and d > 0, the steepness of the friction law (10) in creep
 * @returns {object} rhs(state), regime(state), energy(state) and step(state, h)
 */
export function motion(parameters, drive) {
  const point = point_of(parameters_of(parameters), 1);
  known("numbers of the drive", drive, ["V", "d"]);
  const run = { ...point, V: checked("V", drive.V), d: checked("d", drive.d) };
  return Object.freeze({
    /** d/dtau of a state: [x', y', x'', y'']. */
    rhs: (state) => {
      const { contact, side } = regime_at(run, numbers("state", state, 4));
      return rate(run, contact, side, state);
    },
    /** The smooth regime that the motion goes on in: contact or lift-off; side 1 with the mass slower than the belt, else -1. */
    regime: (state) => regime_at(run, numbers("state", state, 4)),
    /** Energy of a state with the springs, the preload and the contact. */
    energy: (state) => {
      const [x, y, vx, vy] = numbers("state", state, 4);
      const { cos0, sin0, kappa, alpha, sigma, beta } = run;
      return algebra.energy(x, y, vx, vy, cos0, sin0, kappa, alpha, sigma, beta, y < 0 ? 1 : 0);
    },
    /**
     * One step of length h > 0 by the classical Runge-Kutta method, of fourth order across the kinks.
     *
     * The vector field is kinked where y = 0 and where x' = V. A step that ends on the other side of a kink is cut there, at
     * most twice, and goes on in the new regime. Not seen: a kink that is crossed and crossed back within one step, and a third
     * kink in one step; each costs an error of order h^3.
     */
    step: (state, h) => stepped(run, numbers("state", state, 4), h),
  });
}

function rate(run, contact, side, state) {
  const [x, y, vx, vy] = state;
  const { cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d } = run;
  const nbar = contact ? 1 : 0;
  const [ax, ay] = algebra.regime_rhs(x, y, vx, vy, cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d, nbar, side);
  return [vx, vy, ax, ay];
}

/** The sign of the first of three that is not zero. */
function leading_sign(value, first, second) {
  const deciding = Math.abs(value) > 0 ? value : Math.abs(first) > 0 ? first : second;
  return deciding > 0 ? 1 : -1;
}

/** By the state, and on a kink by where the state is headed, for which the regime does not matter: forces are continuous there. */
function regime_at(run, state) {
  const now = rate(run, state[1] < 0, run.V >= state[2] ? 1 : -1, state);
  return {
    contact: leading_sign(state[1], state[3], now[3]) < 0,
    side: leading_sign(run.V - state[2], -now[2], 1),
  };
}

function advanced(state, h, now) {
  return state.map((value, i) => value + h * now[i]);
}

/** One classical Runge-Kutta step in one smooth regime. */
function runge_kutta(run, { contact, side }, h, state) {
  const k1 = rate(run, contact, side, state);
  const k2 = rate(run, contact, side, advanced(state, 0.5 * h, k1));
  const k3 = rate(run, contact, side, advanced(state, 0.5 * h, k2));
  const k4 = rate(run, contact, side, advanced(state, h, k3));
  return state.map((value, i) => value + (h / 6) * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]));
}

/** Distances to the two kinks, positive inside the regime: into or above the belt, behind or ahead of it. */
function distances(run, { contact, side }, state) {
  return [contact ? -state[1] : state[1], side * (run.V - state[2])];
}

/** The kink that a step from distances `before` to `after` crosses first, or -1, and a guess at which share of the step. */
function crossed(before, after) {
  let kink = -1;
  let share = 1;
  for (let i = 0; i < 2; i++) {
    if (before[i] > 0 && after[i] < 0) {
      const at = before[i] / (before[i] - after[i]);
      if (at < share) {
        share = at;
        kink = i;
      }
    }
  }
  return { kink, share };
}

/** As far as the first kink, or to the end of h: the state there, what is left of h, and the regime beyond. */
function piece(run, regime, h, state, last) {
  const before = distances(run, regime, state);
  let next = runge_kutta(run, regime, h, state);
  const after = distances(run, regime, next);
  let { kink, share } = crossed(before, after);
  if (last || kink < 0) {
    return { state: next, left: 0, regime };
  }
  // Regula falsi on the step itself: each pass gains an order in h.
  let [low, high, at_low, at_high] = [0, 1, before[kink], after[kink]];
  for (let pass = 0; pass < SECANTS; pass++) {
    next = runge_kutta(run, regime, share * h, state);
    const at = distances(run, regime, next)[kink];
    if (at > 0) {
      [low, at_low] = [share, at];
    } else {
      [high, at_high] = [share, at];
    }
    if (pass < SECANTS - 1 && at_low > at_high) {
      share = low + ((high - low) * at_low) / (at_low - at_high);
    }
  }
  const { contact, side } = regime;
  return { state: next, left: (1 - share) * h, regime: kink === 0 ? { contact: !contact, side } : { contact, side: -side } };
}

function stepped(run, state, h) {
  if (typeof h !== "number") {
    throw new TypeError(`h = ${shown(h)} is of type ${typeof h}; it must be a number in (0, Infinity)`);
  }
  if (!(h > 0 && h < Infinity)) {
    throw new RangeError(`h = ${h} is not in (0, Infinity)`);
  }
  let at = { state: Array.from(state), left: h, regime: regime_at(run, state) };
  for (let i = 0; i < PIECES && at.left > 0; i++) {
    at = piece(run, at.regime, at.left, at.state, i === PIECES - 1);
  }
  if (!at.state.every(Number.isFinite)) {
    throw new RangeError(`h = ${h} leads from [${Array.from(state)}] out of what double can hold: h is too long, or L = 0`);
  }
  return at.state;
}
