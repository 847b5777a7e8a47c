// The motion of a model in time, by its exported field: in each smooth regime by the classical Runge-Kutta method, and cut where
// the regime ends: at the contact's border, where mass and belt have the same speed, where the force of friction that holds the mass
// comes to a limit, or where a torsion spring's torque jumps.

const HALVINGS = 40;
/** Kinks in one step; beyond them the step ends in the regime that it is in, at the error of a kink. */
const PIECES = 6;
/** Where a motion that begins at rest on the border goes, by half the square of a short time. */
const AHEAD = 1e-6;
/** Sliding speeds up to this are 0 where friction holds. */
const STILL = 2e-12;

/** What a panel runs: `regime(state)`, `step(state, h)` and `pieces(state, longest)` at one point. A state is coordinates, then rates. */
export function fieldOf(algebra, about, balance) {
  const n = about.coordinates.length;
  const near = Array(about.layers).fill(1);
  const lifts = Boolean(about.apart);
  const holds = Boolean(algebra.grip);

  function called(name, state, { contact, side, ways }) {
    // A law with a root has no value beyond the border, where it has come down to 0.
    const pushing = contact && (about.polynomial || balance.gap(state.slice(0, n)) <= 0) ? 1 : 0;
    return algebra[name](...state, ...balance.motion, pushing, side, ...near, ...ways);
  }

  const rate = (state, mode) => [...state.slice(n), ...called("regime_rhs", state, mode)];

  const borders = (state) => algebra.borders(...state, ...balance.motion);

  /** Of each torsion spring, on a way: not positive where its turning is counted on the other way. */
  const turned = (state, ways) => (ways.length ? algebra.turning_borders(...state, ...balance.motion, ...ways) : []);

  /** On which way the turning of each torsion spring is counted: by its sine. */
  function waysOf(state) {
    const [forward, backward] = [1, -1].map((way) => turned(state, Array(about.torsions).fill(way)));
    return forward.map((level, i) => (level >= backward[i] ? 1 : -1));
  }

  /** The regime where nothing slides: sticking (side 0), if there is contact and the force of friction is within its limits. */
  function held(state, mode) {
    const [ahead, behind] = called("grip", state, mode);
    const sticks = mode.contact && Math.min(ahead, behind) >= 0 && Math.max(ahead, behind) > 0;
    return { ...mode, side: sticks ? 0 : ahead < behind ? 1 : -1 };
  }

  /** By the state, and on a border by where it is headed. */
  function regime(state) {
    const still = holds && Math.abs(borders(state)[1]) <= STILL;
    return still ? held(state, sliding(state)) : sliding(state);
  }

  function sliding(state) {
    const [gap, slip] = borders(state);
    const ways = waysOf(state);
    const guess = { contact: !lifts || gap < 0, side: slip >= 0 ? 1 : -1, ways };
    if (gap !== 0 && slip !== 0) {
      return guess;
    }
    const accelerations = rate(state, guess).slice(n);
    const headed = algebra.border_rates(...state, ...accelerations, ...balance.motion);
    const bent = headed[0] || balance.gap(state.slice(0, n).map((value, i) => value + AHEAD * accelerations[i]));
    return { contact: !lifts || gap < 0 || (gap === 0 && bent < 0), side: slip > 0 || (slip === 0 && headed[1] >= 0) ? 1 : -1, ways };
  }

  function rungeKutta(state, h, mode) {
    const along = (k, share) => state.map((value, i) => value + share * h * k[i]);
    const k1 = rate(state, mode);
    const k2 = rate(along(k1, 0.5), mode);
    const k3 = rate(along(k2, 0.5), mode);
    const k4 = rate(along(k3, 1), mode);
    return state.map((value, i) => value + (h / 6) * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]));
  }

  /** Which borders lie behind a state that was in a regime. */
  function beyond(state, mode) {
    const { contact, side, ways } = mode;
    const [gap, slip] = borders(state);
    const slips = side ? side * slip < 0 : called("grip", state, mode).some((margin) => margin < 0);
    return { contact: lifts && (contact ? gap > 0 : gap < 0), side: slips, ways: turned(state, ways).map((level) => level < 0) };
  }

  /** The regime behind the borders that lie behind a state. */
  function behind(state, mode, past) {
    const next = { ...mode, contact: mode.contact !== past.contact, ways: mode.ways.map((way, i) => (past.ways[i] ? -way : way)) };
    if (holds && (past.side || (past.contact && mode.side === 0))) {
      return held(state, next);
    }
    return { ...next, side: past.side ? -mode.side : mode.side };
  }

  /** The state without the sliding speed that rounding, or a border that is crossed late, leaves where the mass sticks. */
  function stopped(state) {
    const slip = borders(state)[1];
    const still = Array(n).fill(0);
    const change = (accelerations) => algebra.border_rates(...state, ...accelerations, ...balance.motion)[1];
    const along = still.map((_, i) => change(still.map((__, k) => Number(k === i))) - change(still));
    const size = along.reduce((sum, value) => sum + value * value, 0);
    return [...state.slice(0, n), ...along.map((value, i) => state[n + i] - (slip * value) / size)];
  }

  const crossed = (found) => found.contact || found.side || found.ways.some(Boolean);

  function step(state, h) {
    let [at, left, mode] = [state, h, regime(state)];
    for (let piece = 0; piece < PIECES && left > 0; piece++) {
      let next = rungeKutta(at, left, mode);
      if (!crossed(beyond(next, mode)) || piece === PIECES - 1) {
        at = mode.side === 0 ? stopped(next) : next;
        break;
      }
      let [low, high] = [0, left];
      for (let i = 0; i < HALVINGS; i++) {
        const middle = (low + high) / 2;
        [low, high] = crossed(beyond(rungeKutta(at, middle, mode), mode)) ? [low, middle] : [middle, high];
      }
      next = rungeKutta(at, high, mode);
      const after = behind(next, mode, beyond(next, mode));
      [at, left] = [mode.side * after.side === 0 ? stopped(next) : next, left - high];
      mode = after;
    }
    if (!at.every(Number.isFinite)) {
      throw new RangeError("The motion leaves what double precision can hold, or a spring has no length.");
    }
    return at;
  }

  /** In how many steps a time is cut, by the largest rates of the linearized field. */
  function pieces(state, time, longest) {
    const q = state.slice(0, n);
    const size = (rows) => Math.max(...rows.map((row) => row.reduce((sum, entry) => sum + Math.abs(entry), 0)));
    const fastest = Math.max(1, Math.sqrt(size(balance.stiffness(q, true))) + size(balance.damping(q, true)));
    return Math.min(1000, Math.ceil((time / longest) * (Number.isFinite(fastest) ? fastest : 1)));
  }

  return { regime, step, pieces };
}
