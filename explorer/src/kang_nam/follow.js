// The quasi-static state along a straight way through the parameters: it stays on its sheet of equilibria until the sheet ends at a fold.
//
// Equilibria before and after a step are matched in their order by theta. A step is halved until the match is clear, so that two folds are
// stepped over unseen only where they are closer than FINEST of the way, or less on a long way.

const FINEST = 2 ** -30;
/** A match is clear if every other one moves the states this many times further; where there is no other, if they move less than this share of their gaps. */
const CLEARLY = 4;
const SHARE = 0.3;
/** The largest change of a state's direction in one step, radians; steps with more are halved. */
const LONGEST = 0.1;
/** A fold is located within this share of a first step. */
const LOCATED = 2 ** -14;
/** The largest change of each parameter in a first step. */
const FIRST = { theta0: 0.035, mu0: 0.02, kappa: 0.002, alpha: 0.05, sigma: 0.02, beta: 0.1 };

/** The largest number of first steps of a way, however far apart the typed values are. */
const MOST = 200;

/** The point at a share of the way; the ends exactly. */
export function between(from, to, share) {
  if (share >= 1) {
    return { ...to };
  }
  return Object.fromEntries(Object.keys(to).map((name) => [name, from[name] + share * (to[name] - from[name])]));
}

/** All choices of n of the numbers 0 … m − 1, each ascending. */
function picks(m, n, from = 0) {
  if (n === 0) {
    return [[]];
  }
  const found = [];
  for (let first = from; first <= m - n; first++) {
    found.push(...picks(m, n - 1, first + 1).map((rest) => [first, ...rest]));
  }
  return found;
}

/**
 * Which of the directions `after` continue which of `before`: pairs of ranks, and whether that is clear (`sure`). Both lists ascend, and every direction
 * of the shorter is matched.
 */
export function matched(before, after) {
  const turned = before.length > after.length;
  const [few, many] = turned ? [after, before] : [before, after];
  const cost = (ranks) => Math.max(0, ...ranks.map((rank, i) => Math.abs(many[rank] - few[i])));
  const ways = picks(many.length, few.length).map((ranks) => ({ ranks, moved: cost(ranks) })).sort((a, b) => a.moved - b.moved);
  const [best, other] = ways;
  const gap = Math.min(...[before, after].flatMap((list) => list.slice(1).map((theta, i) => theta - list[i])));
  const apart = other ? other.moved > CLEARLY * best.moved : best.moved < SHARE * gap;
  const pairs = best.ranks.map((rank, i) => (turned ? [rank, i] : [i, rank]));
  return { pairs, sure: apart && best.moved < LONGEST };
}

/** The state a jump leads to: the nearest in direction that is not divergent. */
function landing(states, theta) {
  const left = states.filter(({ stability }) => stability !== "divergent");
  return left.sort((a, b) => Math.abs(a.theta - theta) - Math.abs(b.theta - theta))[0] ?? null;
}

/** Whether the model is its own mirror image at a point. */
const mirrored = ({ mu0, alpha }) => mu0 === 0 && alpha === 0;

/** The state after a pitchfork: the nearest that is not divergent, of two about as near that of larger x. */
function beside(states, theta) {
  const near = landing(states, theta);
  const two = states.filter(({ stability }) => stability !== "divergent");
  return two.reduce((best, state) => (Math.abs(Math.abs(state.theta - theta) - Math.abs(near.theta - theta)) < LONGEST && state.x > best.x ? state : best), near);
}

/**
 * Follows the state in direction theta on the straight way between two points. `solve` gives the equilibria at a point.
 *
 * Returns the samples on the way, each `{ point, state, jump }` with null for a state where nothing is left, and `decided`, false if
 * the end is undecided in double precision: then the last sample is the last that was decided.
 */
export function follow(solve, from, to, theta) {
  const angles = ({ states }) => states.map((state) => state.theta);
  const size = Math.max(...Object.keys(FIRST).map((name) => Math.abs(to[name] - from[name]) / FIRST[name]));
  const longest = 1 / Math.max(1, Math.min(MOST, Math.ceil(size)));
  const located = LOCATED / Math.max(1, size);
  const finest = Math.min(FINEST, located);
  const samples = [];
  // Where double precision can't decide, even after the shortest step, longer and longer steps look for a point beyond that is decided.
  const shortest = longest * 2 ** -12;
  let [at, step, here, now, across] = [0, longest, solve(from), theta, false];
  if (here.status !== "ok" || now === null) {
    return settled(solve, to, now, samples);
  }
  while (at < 1) {
    const end = at + step >= 1 ? 1 : at + step;
    const point = between(from, to, end);
    const there = solve(point);
    if (there.status !== "ok") {
      across ||= step <= shortest;
      if (across && end === 1) {
        return { samples, decided: false };
      }
      step = across ? 3 * step : step / 2;
      continue;
    }
    const { pairs, sure } = matched(angles(here), angles(there));
    if (!sure && !across && step > finest) {
      step /= 2;
      continue;
    }
    const rank = nearest(here.states, now);
    const pair = pairs.find(([before]) => before === rank);
    if (!pair && !across && step > located) {
      step /= 2;
      continue;
    }
    // Without friction and the spring along the belt two states meet a third at once, a pitchfork: nothing jumps there.
    const fork = (mirrored(from) && mirrored(to) && (!pair || (there.states[pair[1]].stability === "divergent" && here.states[rank].stability !== "divergent")));
    const next = fork ? beside(there.states, now) : pair ? there.states[pair[1]] : landing(there.states, now);
    samples.push({ point, state: next ?? null, jump: !pair && !fork });
    if (!next) {
      return settled(solve, to, null, samples);
    }
    [at, here, now, step, across] = [end, there, next.theta, Math.min(2 * step, longest), false];
  }
  return { samples, decided: true };
}

/** The rank of the state nearest to a direction. */
export function nearest(states, theta) {
  let best = 0;
  states.forEach((state, i) => {
    if (Math.abs(state.theta - theta) < Math.abs(states[best].theta - theta)) {
      best = i;
    }
  });
  return best;
}

/** Ends a way on which there is no state to follow: with the state at its end nearest to the last one, or else to no deformation. */
function settled(solve, to, theta, samples) {
  const { status, states } = solve(to);
  const state = status === "ok" ? landing(states, theta ?? to.theta0) : null;
  if (state) {
    samples.push({ point: { ...to }, state, jump: true });
  }
  return { samples, decided: status === "ok" };
}
