// A state that follows a straight way through the parameters: it stays on its sheet of equilibria until the sheet ends, then it jumps.

import { belongs, described, newton, search } from "./search.js";
import { turning } from "./kinds.js";
import { touchingIn } from "./states.js";

/** The steps of a way over a parameter's whole range, the most of any way, and how often a step may be halved. */
const STEPS = 200;
const MOST = 400;
const HALVINGS = 14;
/** A way is given up after so many tried steps or jumps, as where the numbers are far from 1 and the state is lost again and again. */
const PATIENCE = 3000;
const JUMPS = 8;
/** The largest change of a coordinate in one step. */
const LONGEST = 0.05;

/** The state that a jump leads to: the nearest that is not divergent. */
export function landing(states, q) {
  const far = (state) => Math.hypot(...state.q.map((value, k) => value - q[k]));
  const left = states.filter(({ undamped }) => undamped !== "divergent");
  return left.sort((a, b) => far(a) - far(b))[0] ?? null;
}

/** The regimes in which something touches and exactly one contact is changed: those that a state enters where a contact opens or closes. */
function beside(about, regime) {
  const { touching } = about.regimes[regime];
  return touchingIn(about).filter((other) => about.regimes[other].touching.filter((one, k) => one !== touching[k]).length === 1);
}

/**
 * The same state a little further on the way, in a regime beside its own where a contact opens or closes, or null if it is not found. `sign` is that of the
 * stiffness matrix's determinant, which the states that meet at a fold do not share.
 */
function next(balance, about, { q, regime, sign }) {
  const close = (at) => at && Math.max(...at.map((value, k) => Math.abs(value - q[k]))) <= LONGEST;
  const own = newton(balance, about, q, regime);
  if (!close(own)) {
    return null;
  }
  const tried = belongs(balance, about, own, regime) ? [regime] : beside(about, regime);
  const reached = tried.map((other) => ({ q: other === regime ? own : newton(balance, about, q, other), regime: other, sign }));
  return reached.find((one) => close(one.q) && belongs(balance, about, one.q, one.regime) && turning(balance.stiffness(one.q, one.regime)) === sign) ?? null;
}

/**
 * Carries `state` from one point to another. `at(point)` gives the balance at a point, `spans` the length of each parameter's slider.
 * Returns the state at the end, null if there is none, and samples of the way, each `{ point, q, jump }`, without `q` where there is no state.
 */
export function carry(at, about, from, to, state, spans) {
  const samples = [];
  const done = (reached) => ({ state: reached, decided: true, samples });
  if (!state) {
    const reached = landing(search(at(to), about), about.coordinates.map(() => 0));
    samples.push({ point: to, q: reached?.q, jump: false });
    return done(reached);
  }
  const size = Math.max(...Object.keys(spans).map((name) => Math.abs(to[name] - from[name]) / spans[name]));
  const longest = 1 / Math.max(1, Math.min(MOST, Math.ceil(STEPS * size)));
  const shortest = longest * 2 ** -HALVINGS;
  const between = (share) => Object.fromEntries(Object.keys(to).map((name) => [name, share >= 1 ? to[name] : from[name] + share * (to[name] - from[name])]));
  let [share, step, jumps] = [0, longest, 0];
  let now = { ...state, sign: turning(at(from).stiffness(state.q, state.regime)) };
  for (let tried = 0; share < 1; tried++) {
    if (tried === PATIENCE || jumps === JUMPS) {
      const reached = landing(search(at(to), about), now.q);
      samples.push({ point: to, q: reached?.q, jump: true });
      return done(reached);
    }
    const end = Math.min(1, share + step);
    const point = between(end);
    const balance = at(point);
    const further = next(balance, about, now);
    if (!further && step > shortest) {
      step /= 2;
      continue;
    }
    if (further) {
      now = further;
    } else {
      const reached = landing(search(balance, about), now.q);
      jumps += 1;
      if (!reached) {
        samples.push({ point, jump: true });
        return done(null);
      }
      now = { ...reached, sign: turning(balance.stiffness(reached.q, reached.regime)) };
    }
    samples.push({ point, q: now.q, jump: !further });
    [share, step] = [end, Math.min(2 * step, longest)];
  }
  return done(described(at(to), now.q, now.regime));
}
