// The state of the page in one object, and the ways to change it.

const LONGEST_PATH = 3000;
/** States whose coordinates agree to this are one. */
const SAME = 1e-6;

export const near = (a, b) => Math.max(...a.map((value, i) => Math.abs(value - b[i]))) < SAME;

/**
 * A store over a source of states: `look(point)` gives the states at a point, `begin(point, q)` the one on which a page begins, and
 * `carry(from, to, state)` the one to which a state leads on a way. Listeners are called once for every change, with the new state of the page and what
 * happened: `placed` there without a way, or `jumped` on it.
 */
export function createStore({ look, begin, carry }) {
  const listeners = [];
  let now = null;

  function become(next, happened) {
    const found = look(next.point);
    const { state } = next;
    if (state && next.decided && !found.undecided && !found.states.some((one) => one.regime === state.regime && near(one.q, state.q))) {
      found.states.push(state); // carried along, and not found anew
    }
    now = { ...next, found };
    listeners.forEach((listener) => listener(now, { placed: false, jumped: false, ...happened }));
  }

  /** Put the page at a point, without a way there, on the state nearest to `q`, or without `q` nearest to no deformation. */
  function place(point, q = null) {
    const { state, decided } = begin(point, q);
    become({ point: { ...point }, anchor: { ...point }, state, decided, path: state ? [{ point, q: state.q, jump: false }] : [], jumps: 0, last: null }, { placed: true });
  }

  /** Move the point on a straight way that the state follows. `base` is an earlier state of the page to start from instead. */
  function move(change, base = now) {
    const to = { ...now.point, ...change };
    const { state, decided, samples } = carry(base.anchor, to, base.state);
    const jumps = samples.filter(({ jump }) => jump).length;
    become({
      point: to, anchor: decided ? to : samples.at(-1)?.point ?? base.anchor, state, decided,
      path: [...base.path, ...samples.filter(({ q }) => q)].slice(-LONGEST_PATH),
      jumps: base.jumps + jumps, last: jumps && base.state ? lastOf(base, samples, to) : jumps ? null : base.last,
    }, { jumped: jumps > 0 });
  }

  /** The last jump of a way: the coordinates before and after it, and the values there of the parameters that change on the way. */
  function lastOf(base, samples, to) {
    const i = samples.findLastIndex(({ jump }) => jump);
    const changed = Object.keys(to).filter((name) => to[name] !== base.anchor[name]);
    return { from: i > 0 ? samples[i - 1].q : base.state.q, to: samples[i].q, at: Object.fromEntries(changed.map((name) => [name, samples[i].point[name]])) };
  }

  /** Forget the path. */
  function forget() {
    become({ ...now, path: now.path.slice(-1), jumps: 0, last: null });
  }

  return { get: () => now, listen: (listener) => listeners.push(listener), place, move, forget };
}

/** The state found at the point in which the mass is, or null: that of its regime nearest to the carried state. */
export function current({ found, state }) {
  const far = (one) => Math.hypot(...one.q.map((value, k) => value - state.q[k]));
  return state && found.states.filter(({ regime }) => regime === state.regime).sort((a, b) => far(a) - far(b))[0] || null;
}
