// The states of a model, searched by Newton's method from many starts. What is found is a state; that it is all is not proved.

import { kindOf, solved } from "./kinds.js";

/** Directions of the springs that a search begins from, all together; coordinates that it begins from without springs. */
const STARTS = 192;
const PLAIN = [-0.5, 0, 0.5];
const STEPS = 40;
/** Newton's method has arrived when a step is no longer than this, relative to the coordinates; states closer than SAME are one. */
const ARRIVED = 1e-12;
const SAME = 1e-7;
/** No step of Newton's method is longer. */
const LONGEST = 0.5;

/** A state near `q`, or null. `along` holds the springs' directions fixed. */
export function newton(balance, about, q, contact, along) {
  const gap = about.polynomial ? -1 : about.coordinates.findIndex(({ name }) => name === about.gap);
  let at = q;
  for (let i = 0; i < STEPS; i++) {
    const held = along ?? balance.directions(at);
    const step = solved(balance.stiffness(at, contact, held), balance.forces(at, contact, held));
    const length = step ? Math.max(...step.map(Math.abs)) : NaN;
    if (!Number.isFinite(length)) {
      return null;
    }
    const share = along || length <= LONGEST ? 1 : LONGEST / length;
    const next = at.map((value, k) => value - share * step[k]);
    if (contact && gap >= 0 && next[gap] >= 0) {
      next[gap] = at[gap] / 2; // the law has no root beyond the border
    }
    const moved = Math.max(...next.map((value, k) => Math.abs(value - at[k])));
    at = next;
    if (moved <= ARRIVED * Math.max(1, ...at.map(Math.abs))) {
      return at;
    }
  }
  return null;
}

/** All combinations of one entry of each list. */
function products(lists) {
  return lists.reduce((found, list) => found.flatMap((head) => list.map((entry) => [...head, entry])), [[]]);
}

function starts(balance, about, contact) {
  const rest = about.coordinates.map(({ name }) => (name === about.gap ? (contact ? -0.01 : 0.01) : 0));
  const springs = balance.vectors(rest).length;
  if (!springs) {
    return products(about.coordinates.map(() => PLAIN)).map((q) => q.map((value, k) => value + rest[k]));
  }
  const each = Math.max(8, Math.round(STARTS ** (1 / springs)));
  const angles = Array.from({ length: each }, (_, k) => (2 * Math.PI * (k + 0.5)) / each - Math.PI);
  return products(Array.from({ length: springs }, () => angles))
    .map((held) => newton(balance, about, rest, contact, balance.held(held))).filter(Boolean);
}

/** Whether a state lies on the side of the contact that it was searched on. */
export function belongs(balance, about, q, contact) {
  if (!about.unilateral || about.gap === null) {
    return true;
  }
  const gap = balance.gap(q);
  return contact ? gap <= 0 : gap > 0;
}

/** One state with its kind. */
export function described(balance, q, contact) {
  const along = balance.directions(q);
  return { q, contact, stability: kindOf(balance.mass(q), balance.stiffness(q, contact, along)), along };
}

/** States found at a point, in contact first, by ascending first coordinate. */
export function search(balance, about) {
  const found = [];
  for (const contact of about.unilateral && about.gap !== null ? [true, false] : [true]) {
    const mine = [];
    for (const start of starts(balance, about, contact)) {
      const q = newton(balance, about, start, contact);
      const far = (other) => Math.max(...q.map((value, k) => Math.abs(value - other[k]) / Math.max(1, Math.abs(value))));
      if (q && belongs(balance, about, q, contact) && !mine.some((other) => far(other) < SAME)) {
        mine.push(q);
      }
    }
    found.push(...mine.sort((a, b) => a[0] - b[0]).map((q) => described(balance, q, contact)));
  }
  return found;
}
