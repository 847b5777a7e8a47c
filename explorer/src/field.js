// The motion of a model in time, by its exported field. Each smooth regime is integrated by the classical Runge-Kutta method until it ends:
// where a contact opens or closes, where sliding stops or turns back, where the friction force in sticking comes to its limit, or where a torsion
// spring's torque jumps.

import { solved } from "./kinds.js";

/** How often a step is halved to find where a regime ends. */
const HALVINGS = 40;
/** Ends of regimes in one step, for each contact; beyond them the step is finished in its last regime, without regard to further ends. */
const PIECES = 6;
/** Half the square of the short time after which a motion that begins at rest on a border is looked at, to see where it goes. */
const AHEAD = 1e-6;
/** A friction that can stick counts as sticking up to this sliding speed. */
const STILL = 2e-12;

/** How many frictions of some sides slip. */
const slipping = (sides) => sides.reduce((sum, side) => sum + Math.abs(side), 0);

/** All combinations of sides of so many frictions (0 sticks, ±1 slides), those in which most stick first. */
function choices(count) {
  const all = Array.from({ length: count }).reduce((found) => found.flatMap((head) => [0, 1, -1].map((side) => [...head, side])), [[]]);
  return all.sort((a, b) => slipping(a) - slipping(b));
}

/**
 * The field at one point of the parameters, as a motion runs it: `regime(state)`, `step(state, h)` and `pieces(state, time, longest)`; `transition` is the
 * rule by which dry frictions go on, as it is generated for all targets. A state holds coordinates, then rates. A regime, or mode, says which contacts are `touching`, in which direction each friction slides (`sides`: ±1, 0 where it sticks),
 * and in which direction the turning of each torsion spring is counted (`ways`: ±1).
 */
export function fieldOf(algebra, transition, about, balance) {
  const n = about.coordinates.length;
  const near = Array(about.layers).fill(1);
  const { contacts, frictions } = about;
  /** The regimes of states to which steps have come: where several are possible, the one that the motion is in. */
  const reached = new WeakMap();
  /** Indices of the frictions that can stick, in the order in which the exported `grip` has them. */
  const holding = frictions.flatMap(({ holds }, j) => (holds ? j : []));

  function called(name, state, { touching, sides, ways }) {
    // A law with a root has no value beyond the border, where it has come down to 0.
    const rooted = contacts.some(({ polynomial }) => !polynomial);
    const gaps = rooted ? balance.gaps(state.slice(0, n)) : [];
    const pushing = touching.map((touches, k) => (touches && (contacts[k].polynomial || gaps[k] <= 0) ? 1 : 0));
    return algebra[name](...state, ...balance.motion, ...pushing, ...sides, ...near, ...ways);
  }

  const rate = (state, mode) => [...state.slice(n), ...called("regime_rhs", state, mode)];

  /** Gaps of all contacts, and sliding speeds of all frictions. */
  function borders(state) {
    const levels = algebra.borders(...state, ...balance.motion);
    return { gaps: levels.slice(0, contacts.length), slips: levels.slice(contacts.length) };
  }

  /** The rates of the same at given accelerations: of gaps, and of sliding speeds. */
  function headed(state, accelerations) {
    const rates = algebra.border_rates(...state, ...accelerations, ...balance.motion);
    return { gaps: rates.slice(0, contacts.length), slips: rates.slice(contacts.length) };
  }

  /** Of each torsion spring a number that is negative once its turning has to be counted in the other direction. */
  const turned = (state, ways) => (ways.length ? algebra.turning_borders(...state, ...balance.motion, ...ways) : []);

  /** In which direction the turning of each torsion spring is counted at a state. */
  function waysOf(state) {
    const [forward, backward] = [1, -1].map((way) => turned(state, Array(about.torsions).fill(way)));
    return forward.map((level, i) => (level >= backward[i] ? 1 : -1));
  }

  const withSides = (mode, chosen, sides) => ({ ...mode, sides: mode.sides.map((side, j) => (chosen.includes(j) ? sides[chosen.indexOf(j)] : side)) });

  /** The largest share of its limit that a chosen friction lacks for a mode to agree with its own accelerations. */
  function lacking(state, mode, chosen) {
    const margins = called("grip", state, mode);
    const { slips } = headed(state, called("regime_rhs", state, mode));
    return Math.max(...chosen.map((j) => {
      const row = 2 * holding.indexOf(j);
      return transition.lacks(mode.sides[j], margins[row], margins[row + 1], slips[j]);
    }));
  }

  /** ΔᵀM Δ of the change Δ of the accelerations from those before. */
  function change(state, mode, before) {
    const by = called("regime_rhs", state, mode).map((value, i) => value - before[i]);
    return balance.mass(state.slice(0, n)).reduce((sum, row, i) => sum + by[i] * row.reduce((part, entry, k) => part + entry * by[k], 0), 0);
  }

  /** The mode with sides of the chosen frictions that agree with its own accelerations, by the rule of all targets; `before` are the accelerations until then. */
  function settled(state, mode, chosen, before = Array(n).fill(0)) {
    let found = { mode, slips: 0, lack: Infinity, by: Infinity };
    for (const sides of choices(chosen.length)) {
      const slips = slipping(sides);
      if (found.lack === 0 && slips > found.slips) {
        break;
      }
      const one = withSides(mode, chosen, sides);
      const lack = lacking(state, one, chosen);
      const by = lack ? 0 : change(state, one, before);
      if (transition.displaces(slips, lack, by, found.slips, found.lack, found.by)) {
        found = { mode: one, slips, lack, by };
      }
    }
    if (found.lack === Infinity) {
      throw new RangeError("The forces have no value at this state.");
    }
    return found.mode;
  }

  /** The regime of a state; on a border that of the motion that follows. */
  function regime(state) {
    if (reached.has(state)) {
      return reached.get(state);
    }
    const { slips } = borders(state);
    const still = holding.filter((j) => Math.abs(slips[j]) <= STILL);
    return still.length ? settled(state, sliding(state), still) : sliding(state);
  }

  /** The same where every friction slides. */
  function sliding(state) {
    const { gaps, slips } = borders(state);
    const closed = (k, level) => contacts[k].border === null || level < 0;
    const guess = { touching: gaps.map((gap, k) => closed(k, gap)), sides: slips.map((slip) => (slip >= 0 ? 1 : -1)), ways: waysOf(state) };
    if (![...gaps, ...slips].includes(0)) {
      return guess;
    }
    const accelerations = rate(state, guess).slice(n);
    const rates = headed(state, accelerations);
    const later = balance.gaps(state.slice(0, n).map((value, i) => value + AHEAD * accelerations[i]));
    return {
      ...guess,
      touching: gaps.map((gap, k) => closed(k, gap === 0 ? rates.gaps[k] || later[k] : gap)),
      sides: slips.map((slip, j) => (slip > 0 || (slip === 0 && rates.slips[j] >= 0) ? 1 : -1)),
    };
  }

  function rungeKutta(state, h, mode) {
    const along = (k, share) => state.map((value, i) => value + share * h * k[i]);
    const k1 = rate(state, mode);
    const k2 = rate(along(k1, 0.5), mode);
    const k3 = rate(along(k2, 0.5), mode);
    const k4 = rate(along(k3, 1), mode);
    return state.map((value, i) => value + (h / 6) * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]));
  }

  /** Which borders of its regime a state has passed: of contacts, of frictions, and of torsion springs. */
  function beyond(state, mode) {
    const { gaps, slips } = borders(state);
    const margins = mode.sides.includes(0) ? called("grip", state, mode) : [];
    const lost = (j) => margins.slice(2 * holding.indexOf(j), 2 * holding.indexOf(j) + 2).some((margin) => margin < 0);
    return {
      touching: gaps.map((gap, k) => contacts[k].border !== null && (mode.touching[k] ? gap > 0 : gap < 0)),
      sides: mode.sides.map((side, j) => (side ? side * slips[j] < 0 : lost(j))),
      ways: turned(state, mode.ways).map((level) => level < 0),
    };
  }

  /** The regime after the borders that are `past`. Frictions that stick, or hardly slide, are decided together with those that pass a border. */
  function behind(state, mode, past) {
    const next = {
      touching: mode.touching.map((touches, k) => touches !== past.touching[k]),
      sides: mode.sides.map((side, j) => (past.sides[j] ? -side : side)),
      ways: mode.ways.map((way, i) => (past.ways[i] ? -way : way)),
    };
    const come = holding.filter((j) => past.sides[j] || (past.touching[frictions[j].contact] && mode.sides[j] === 0));
    if (!come.length) {
      return next;
    }
    const { slips } = borders(state);
    const chosen = holding.filter((j) => come.includes(j) || mode.sides[j] === 0 || Math.abs(slips[j]) <= STILL);
    return settled(state, next, chosen, called("regime_rhs", state, mode));
  }

  /** The state with the sliding speeds of the frictions that stick set to 0, of which rounding and late crossings leave some. */
  function stopped(state, stuck) {
    const still = Array(n).fill(0);
    const [from, ...each] = [still, ...still.map((_, i) => still.map((__, k) => Number(k === i)))].map((accelerations) => headed(state, accelerations).slips);
    const along = stuck.map((j) => each.map((change) => change[j] - from[j]));
    const products = along.map((one) => along.map((other) => one.reduce((sum, value, i) => sum + value * other[i], 0)));
    const { slips } = borders(state);
    const back = stuck.length ? solved(products, stuck.map((j) => slips[j])) : [];
    return [...state.slice(0, n), ...still.map((_, i) => state[n + i] - back.reduce((sum, share, row) => sum + share * along[row][i], 0))];
  }

  const crossed = (found) => [...found.touching, ...found.sides, ...found.ways].some(Boolean);

  function step(state, h) {
    let [at, left, mode] = [state, h, regime(state)];
    const most = PIECES * contacts.length;
    for (let piece = 0; piece < most && left > 0; piece++) {
      let next = rungeKutta(at, left, mode);
      if (!crossed(beyond(next, mode)) || piece === most - 1) {
        at = stopped(next, holding.filter((j) => mode.sides[j] === 0));
        break;
      }
      let [low, high] = [0, left];
      for (let i = 0; i < HALVINGS; i++) {
        const middle = (low + high) / 2;
        [low, high] = crossed(beyond(rungeKutta(at, middle, mode), mode)) ? [low, middle] : [middle, high];
      }
      next = rungeKutta(at, high, mode);
      const after = behind(next, mode, beyond(next, mode));
      [at, left] = [stopped(next, holding.filter((j) => mode.sides[j] * after.sides[j] === 0)), left - high];
      mode = after;
    }
    if (!at.every(Number.isFinite)) {
      throw new RangeError("The motion leaves what double precision can hold, or a spring has no length.");
    }
    reached.set(at, mode);
    return at;
  }

  /** The number of steps into which a time is cut: each `longest`, less where the linearized field has rates above 1. */
  function pieces(state, time, longest) {
    const q = state.slice(0, n);
    const size = (rows) => Math.max(...rows.map((row) => row.reduce((sum, entry) => sum + Math.abs(entry), 0)));
    const fastest = Math.max(1, Math.sqrt(size(balance.stiffness(q, 0))) + size(balance.damping(q, 0)));
    return Math.min(1000, Math.ceil((time / longest) * (Number.isFinite(fastest) ? fastest : 1)));
  }

  return { regime, step, pieces };
}
