// What the page shows, in one object, and the one way to change it.

import { follow } from "./follow.js";

const LONGEST_PATH = 3000;
/** The parameters of the plane. */
const PLANE = ["theta0", "mu0"];

/** A store over the exported solver. Listeners are called once per change with the kinds of what changed. */
export function createStore({ equilibria, NAMES }) {
  const solve = (point) => equilibria(point, { contact: true });
  const listeners = [];
  let state = null;

  const tell = (...kinds) => listeners.forEach((listener) => listener(state, new Set(kinds)));

  /** Equilibria in both regimes at the point itself. */
  function look(point) {
    return { contact: solve(point), liftoff: equilibria(point, { contact: false }) };
  }

  /** Put the page at a point, without a way there: on the state nearest to `theta`, else on that of small deformation. */
  function place(point, theta = null) {
    const found = look(point);
    const { theta: at, decided } = follow(solve, point, point, null);
    const stable = found.contact.states.filter(({ stability }) => stability !== "divergent");
    const wanted = theta === null ? at : stable.map((s) => s.theta).sort((a, b) => Math.abs(a - theta) - Math.abs(b - theta))[0] ?? at;
    state = {
      point: { ...point }, anchor: { ...point }, theta: wanted, decided, found,
      path: wanted === null ? [] : [{ theta0: point.theta0, mu0: point.mu0, theta: wanted, jump: false }], jumps: 0, last: null,
    };
    tell("place", "point", "family");
  }

  /** Move the point slowly on a straight way; the state follows. `base` is an earlier state of the store to start from instead. */
  function move(change, base = state) {
    const to = { ...state.point, ...change };
    const way = follow(solve, base.anchor, to, base.theta);
    const samples = way.samples.map(({ point, theta, jump }) => ({ theta0: point.theta0, mu0: point.mu0, theta, jump, point }));
    const jumped = samples.filter((sample) => sample.jump);
    const family = NAMES.some((name) => !["theta0", "mu0"].includes(name) && to[name] !== state.point[name]);
    const anchor = way.decided ? to : way.samples.length ? way.samples.at(-1).point : base.anchor;
    const before = samples.length && jumped.length ? previous(base, samples, NAMES.filter((name) => to[name] !== base.anchor[name])) : null;
    state = {
      point: to, anchor: { ...anchor }, theta: way.theta, decided: way.decided, found: look(to),
      path: [...base.path, ...samples.filter(({ theta }) => theta !== null).map(({ point, ...kept }) => kept)].slice(-LONGEST_PATH),
      jumps: base.jumps + jumped.length, last: before ?? (jumped.length ? null : base.last),
    };
    tell("point", ...(family ? ["family"] : []), ...(jumped.length ? ["jump"] : []));
  }

  /** The directions before and after the last jump of a way, and where it was: the plane's two parameters, or those that changed. */
  function previous(base, samples, changed) {
    const i = samples.findLastIndex((sample) => sample.jump);
    const names = changed.every((name) => PLANE.includes(name)) ? PLANE : changed;
    const fold = Object.fromEntries(names.map((name) => [name, samples[i].point[name]]));
    return { from: i > 0 ? samples[i - 1].theta : base.theta, to: samples[i].theta, fold };
  }

  /** Forget the path. */
  function forget() {
    state = { ...state, path: state.path.slice(-1), jumps: 0, last: null };
    tell("point");
  }

  return { get: () => state, listen: (listener) => listeners.push(listener), place, move, forget };
}

/** The state that the mass is on, or null. */
export function current({ found, theta }) {
  const { states } = found.contact;
  if (theta === null || !states.length) {
    return null;
  }
  return states.reduce((best, state) => (Math.abs(state.theta - theta) < Math.abs(best.theta - theta) ? state : best));
}
