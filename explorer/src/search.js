// The states of a model, searched by Newton's method from many starts. Everything found is a state; that there are no others is not proved.

import { kindOf, solved, stabilityOf } from "./kinds.js";

/** Combinations of the springs' directions that a search tries, and the mismatch below which it begins from all of them. */
const STARTS = 576;
const CLOSE = 1e-3;
/** A search also begins around every anchor: at these distances, in so many directions. */
const [RADII, AROUND] = [[0.05, 0.2, 0.5], 12];
/** Values of every coordinate that a search of a model without springs begins from: with one or two coordinates, and with more. */
const PLAIN = [-3, -2, -1.3, -0.8, -0.4, -0.15, 0, 0.15, 0.4, 0.8, 1.3, 2, 3];
const FEW = [-0.5, 0, 0.5];
/** Further values of an angle at which whole turns are not the same place, as a torsion spring counts them. */
const FARTHER = [-11, -8, -6, -4.5, 4.5, 6, 8, 11];
const STEPS = 40;
/** Newton's method has converged when a step is no longer than ARRIVED, relative to the coordinates; states closer than SAME are one. */
const ARRIVED = 1e-12;
const SAME = 1e-7;
/** More states than this in one regime are one that is so nearly multiple that Newton's method ends all around it. */
const MANY = 24;
/** The longest step of Newton's method. */
const LONGEST = 0.5;

/** The state in a regime to which Newton's method leads from `q`, or null. Given `along`, the springs' directions are held there. */
export function newton(balance, about, q, regime, along) {
  const rooted = about.contacts.flatMap(({ border, polynomial }, k) => (polynomial || !about.regimes[regime].touching[k] ? [] : about.coordinates.findIndex(({ name }) => name === border))).filter((place) => place >= 0);
  let at = q;
  for (let i = 0; i < STEPS; i++) {
    const held = along ?? balance.directions(at);
    const step = solved(balance.stiffness(at, regime, held), balance.forces(at, regime, held));
    const length = step ? Math.max(...step.map(Math.abs)) : NaN;
    if (!Number.isFinite(length)) {
      return null;
    }
    const share = along || length <= LONGEST ? 1 : LONGEST / length;
    const next = at.map((value, k) => value - share * step[k]);
    for (const gap of rooted.filter((place) => next[place] >= 0)) {
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

/** All combinations of one entry of each list, the last entry changing fastest. */
function products(lists) {
  return lists.reduce((found, list) => found.flatMap((head) => list.map((entry) => [...head, entry])), [[]]);
}

/** How far the springs' directions at `q` are from the held angles that led there: 0 at a state, at most 1 for each spring. */
function mismatch(balance, q, held) {
  const along = balance.directions(q);
  return held.reduce((sum, angle, i) => sum + 0.5 * (1 - along[3 * i] * Math.cos(angle) - along[3 * i + 1] * Math.sin(angle)), 0);
}

/** Places around the springs' anchors, where directions change faster than a grid of directions resolves. */
function aroundAnchors(balance, rest) {
  return balance.vectors(rest).flatMap(([dx, dy]) => RADII.flatMap((radius) => Array.from({ length: AROUND }, (_, k) => {
    const turn = (2 * Math.PI * (k + 0.5)) / AROUND;
    return rest.map((value, i) => value + (i === 0 ? dx + radius * Math.cos(turn) : i === 1 ? dy + radius * Math.sin(turn) : 0));
  })));
}

/**
 * Places where Newton's method begins. With the springs' directions held the balance has one solution. Over a grid of held directions the solutions
 * are taken whose own directions agree best with the held ones.
 */
function starts(balance, about, regime) {
  const gaps = Object.fromEntries(about.contacts.map(({ border }, k) => [border, about.regimes[regime].touching[k] ? -0.01 : 0.01]));
  const rest = about.coordinates.map(({ name }) => gaps[name] ?? 0);
  const springs = balance.vectors(rest).length;
  // Directions that a rod has, and no mass on a belt, do not make the balance linear.
  const usual = rest.length > 2 ? FEW : PLAIN;
  const lists = about.coordinates.map(({ angle, turns }) => (angle && !Object.keys(turns).length && rest.length < 4 ? [...usual, ...FARTHER] : usual));
  const plain = springs && about.drawn ? [] : products(lists);
  const places = plain.map((q) => q.map((value, k) => value + rest[k]));
  if (!springs) {
    return places;
  }
  const each = Math.max(8, Math.round(STARTS ** (1 / springs)));
  const angles = Array.from({ length: each }, (_, k) => (2 * Math.PI * (k + 0.5)) / each - Math.PI);
  const nodes = products(Array.from({ length: springs }, () => angles)).map((held) => {
    const q = newton(balance, about, rest, regime, balance.held(held));
    return { q, far: q ? mismatch(balance, q, held) : Infinity };
  });
  const neighbours = (at) => Array.from({ length: springs }, (_, i) => each ** i).flatMap((stride) => {
    const place = Math.floor(at / stride) % each;
    return [at + (((place + 1) % each) - place) * stride, at + (((place + each - 1) % each) - place) * stride];
  });
  const chosen = nodes.filter(({ q, far }, at) => q && (far < CLOSE || neighbours(at).every((other) => far <= nodes[other].far))).map(({ q }) => q);
  return [...places, ...chosen, ...aroundAnchors(balance, rest)];
}

/** Whether every contact touches at a state just where its regime says. */
export function belongs(balance, about, q, regime) {
  const { touching } = about.regimes[regime];
  return balance.gaps(q).every((gap, k) => about.contacts[k].border === null || (touching[k] ? gap <= 0 : gap > 0));
}

/** The same place with every angle that has whole turns between −π and π; coordinates that turn with it are moved along. */
function once({ coordinates }, q) {
  const place = q && [...q];
  for (const [k, { turns }] of place ? coordinates.entries() : []) {
    const whole = 2 * Math.PI * Math.round(place[k] / (2 * Math.PI));
    for (const [other, count] of Object.entries(turns)) {
      place[other] -= count * whole;
    }
  }
  return place;
}

/** One state with its stability; `told` is the kind without damping where a proof has decided it. */
export function described(balance, q, regime, told = null) {
  const along = balance.directions(q);
  const [mass, gyroscopic, stiffness] = [balance.mass(q), balance.gyroscopic(q), balance.stiffness(q, regime, along)];
  const undamped = told ?? kindOf(mass, stiffness, gyroscopic);
  return { q, regime, undamped, ...stabilityOf(mass, balance.damping(q, regime), stiffness, undamped, gyroscopic), along };
}

/**
 * The states found at a point in some regimes, by default in all, in the order of the regimes and in each by ascending first coordinate. Where they
 * can't be told apart the list is empty and has the property `undecided`.
 */
export function search(balance, about, regimes = about.regimes.map((_, regime) => regime)) {
  const found = [];
  for (const regime of regimes) {
    const mine = [];
    for (const start of starts(balance, about, regime)) {
      const q = once(about, newton(balance, about, start, regime));
      const far = (other) => Math.max(...q.map((value, k) => Math.abs(value - other[k]) / Math.max(1, Math.abs(value))));
      if (q && belongs(balance, about, q, regime) && !mine.some((other) => far(other) < SAME)) {
        mine.push(q);
      }
    }
    if (mine.length > MANY) {
      return Object.assign([], { undecided: true });
    }
    found.push(...mine.sort((a, b) => a[0] - b[0]).map((q) => described(balance, q, regime)));
  }
  return found;
}
