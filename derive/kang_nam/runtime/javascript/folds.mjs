// ------------------------------------------------------------------------------- surface, folds, cusps: for plotting
//
// In double precision and without proofs: what two curves that all but touch do, rounding may decide. The Python package proves.

const TURN = Math.PI;
// How close to their ends the first and last directions are at which curves are looked for.
const NEAREST = 1e-9;
// A cell of directions is halved until the k-th root of one side goes on as the k-th of the other, or it is this narrow.
const FINEST = 1e-13;
// A step in theta0, or in mu0/(1 + mu0), over which neighbours are not joined unseen.
const STRIDE = 0.04;

// Columns and curves beyond which what is found is rounding: regular sets have some thousand of the one and a handful of the other.
const MOST_COLUMNS = 30000;
const MOST_CURVES = 32;
// About how many directions the curves are looked for at unless told otherwise.
const DIRECTIONS = 512;

// The least kappa, over the larger of sigma and 1 + beta, at which f and its derivatives know where contact begins.
const LEAST_PRELOAD = 1e-12;

/** The parameters of folds, checked; those in `spanned` are not used. */
function fold_parameters(parameters, spanned) {
  const given = parameters_of(parameters, spanned);
  const least = LEAST_PRELOAD * larger(given.sigma, 1 + given.beta);
  if (given.kappa < least) {
    throw new RangeError(
      `kappa = ${given.kappa} is too small beside sigma and 1 + beta for folds in double precision; ` +
        `give at least ${least}, or ask the Python package`,
    );
  }
  return given;
}

/** kappa, alpha, sigma and beta, in the order in which the algebra takes them. */
function fixed_of(given) {
  return [given.kappa, given.alpha, given.sigma, given.beta];
}

/** cos and sin of an angle in (0, pi), as [cos, sin]. */
function turned(angle) {
  const { cosine, sine } = cosine_and_sine(angle);
  return [cosine, sine];
}

/**
 * The equilibrium surface, explicitly: the friction at which theta is the direction of an equilibrium in contact.
 *
 * @param {object} parameters kappa, alpha, sigma and beta; theta0 and mu0 are not used
 * @param {number} theta direction, in (0, pi)
 * @param {number} theta0 inclination of the undeformed spring, in (0, pi)
 * @returns {object} mu0 of either sign, L, x, y and stability; null where there is no state in contact with finite friction
 */
export function surface(parameters, theta, theta0) {
  const given = parameters_of(parameters, ["theta0", "mu0"]);
  checked("theta0", theta0);
  const [c, s] = turned(inside("theta", theta));
  const [c0, s0] = turned(theta0);
  const mu0 = algebra.surface(c, s, c0, s0, ...fixed_of(given));
  const at = Number.isFinite(mu0) ? state_at(c, s, c0, s0, given) : null;
  if (!at) {
    return null;
  }
  const point = point_of({ ...given, theta0, mu0 }, 1);
  const [a, b, d, m] = algebra.f_coefficients(c0, s0, mu0, ...fixed_of(given), 1);
  const { code } = stability({ cosine: c, sine: s }, at.L, algebra.f_slope(c, s, a, b, d, m), 0, point);
  return { mu0, ...at, stability: STABILITIES[code] };
}

/** A direction in (0, pi). */
function inside(name, value) {
  if (typeof value !== "number") {
    throw new TypeError(`${name} = ${shown(value)} is of type ${typeof value}; it must be a number in (0, pi)`);
  }
  if (!(value > 0 && value < TURN)) {
    throw new RangeError(`${name} = ${value} is not in (0, pi): angles are radians, strictly between 0 and pi`);
  }
  return value;
}

/** L, x and y of the state in contact in a direction; null where there is none. */
function state_at(c, s, c0, s0, given) {
  const [L, x, y] = algebra.state(c, s, c0, s0, given.kappa, given.sigma, given.beta, 1);
  return L > 0 && y < 0 ? { L, x, y } : null;
}

/**
 * All cusps in contact with 0 < theta0 < pi and mu0 >= 0, by ascending mu0: f = f' = f'' = 0.
 *
 * @param {object} parameters kappa, alpha, sigma and beta; theta0 and mu0 are not used
 * @returns {object[]} theta0, mu0, theta, L, x and y of each
 */
export function cusps(parameters) {
  const given = fold_parameters(parameters, ["theta0", "mu0"]);
  return cusps_on(given.alpha > 0 ? curves_of(FOLDS, directions_for(DIRECTIONS, given), given) : [], given);
}

/** The cusps on curves of folds, or without alpha, by themselves. */
function cusps_on(curves, given) {
  const found = given.alpha > 0 ? curves.flatMap((curve) => bends(curve, given)) : cusps_without_alpha(given);
  return found.sort((one, other) => one.mu0 - other.mu0 || one.theta0 - other.theta0);
}

/**
 * Where f'' changes its sign along a curve of folds. The polynomial in sin theta that cusps are roots of is no help in double
 * precision: near alpha = 1 + beta all its roots come to have 3 sin^2 theta = 2, and with a small alpha its coefficients cancel.
 */
function bends(curve, given) {
  return changes(curve, (at) => bend(at, given), given).flatMap(({ theta, theta0, mu0 }) => {
    const [[c, s], [c0, s0]] = [turned(theta), turned(theta0)];
    return written({ c, s, c0, s0, mu0 }, given);
  });
}

/** f'' at a fold. */
function bend({ theta, theta0, mu0 }, given) {
  const [a, b, d, m] = algebra.f_coefficients(...turned(theta0), mu0, ...fixed_of(given), 1);
  return algebra.f_curvature(...turned(theta), a, b, d, m);
}

/** Without alpha the curves of theta0 and of pi - theta0 meet in their cusps, which a cubic in sin theta gives. */
function cusps_without_alpha(given) {
  const { kappa, sigma, beta } = given;
  const found = [];
  for (const s of [...roots_between(algebra.cusp_cubic(kappa, sigma, beta), 0, 1).filter((s) => s > 0 && s < 1), 1]) {
    const [s0, over_cosine] = algebra.cusp_sine(s, ...fixed_of(given));
    const width = Math.sqrt((1 - s) * (1 + s));
    const away = Math.sqrt(larger((1 - s0) * (1 + s0), 0));
    for (const c of width > 0 ? [width, -width] : [0]) {
      for (const c0 of s0 > 0 && s0 <= 1 ? new Set([away, -away]) : []) {
        found.push({ c, s, c0, s0, mu0: over_cosine * c + 0 });
      }
    }
  }
  return found.flatMap((at) => written(at, given));
}

/** A cusp as it is handed out; none where it is out of contact, or friction negative. */
function written({ c, s, c0, s0, mu0 }, given) {
  const at = s0 > 0 && mu0 >= 0 ? state_at(c, s, c0, s0, given) : null;
  return at ? [{ theta0: Math.atan2(s0, c0), mu0, theta: Math.atan2(s, c), ...at }] : [];
}

// ------------------------------------------------------------------------------------------------------------- curves

/** Coefficients, over the largest. */
function scaled(coefficients) {
  const largest = Math.max(...coefficients.map(Math.abs));
  return coefficients.map((value) => value / largest);
}

/** All folds at a direction: a quartic in tan(theta0/2), from the conic that is left without friction. */
function fold_polynomial(theta, fixed) {
  const [e0, e1, e2, ec] = algebra.fold_conic(...turned(theta), ...fixed);
  return scaled([e0 + ec, 2 * e1, 4 * e2 + 2 * e0, 2 * e1, e0 - ec]);
}

/** The friction of the fold at (theta, theta0), from the relation that does not lose it: the first has the factor cos theta. */
function fold_friction(theta, theta0, fixed) {
  const [c, s] = turned(theta);
  const [u1, w1, u2, w2] = algebra.fold_lines_mu0(c, s, ...turned(theta0), ...fixed);
  return Math.abs(c) > 0.3 ? -u1 / w1 : -u2 / w2;
}

/** A number that changes its sign where two roots of the fold polynomial meet: its discriminant over the terms of that. */
function fold_indicator(theta, fixed) {
  if (fixed[1] === 0) {
    const [e0, e1, e2] = algebra.fold_conic(...turned(theta), ...fixed);
    return (4 * e0 * e2 - e1 * e1) / (4 * Math.abs(e0 * e2) + e1 * e1);
  }
  const [e0, e1, e2, e3, e4] = fold_polynomial(theta, fixed);
  const P = 12 * e4 * e0 - 3 * e3 * e1 + e2 * e2;
  const Q = 72 * e4 * e2 * e0 + 9 * e3 * e2 * e1 - 27 * (e4 * e1 * e1 + e0 * e3 * e3) - 2 * e2 * e2 * e2;
  return (4 * P * P * P - Q * Q) / (4 * Math.abs(P * P * P) + Q * Q);
}

/** All onsets of flutter at a direction: a sextic in tan(theta0/2). */
function flutter_polynomial(theta, fixed) {
  const [g0, g1, k0, k1, k2, k3] = algebra.flutter_cubic(...turned(theta), ...fixed);
  const middle = 3 * k0 + 4 * k2;
  return scaled([g0 - k0, 2 * (g1 - k1), g0 - middle, -4 * k1 - 8 * k3, -g0 - middle, -2 * (g1 + k1), -g0 - k0]);
}

function flutter_friction(theta, theta0, fixed) {
  const [c, s] = turned(theta);
  const [kappa, alpha, sigma, beta] = fixed;
  const [L] = algebra.state(c, s, ...turned(theta0), kappa, sigma, beta, 1);
  return algebra.flutter_friction(c, s, L, alpha, sigma, beta);
}

/** What a curve is made of: its polynomial at a direction and the friction at one of the roots. */
const FOLDS = { polynomial: fold_polynomial, friction: fold_friction };
const ONSETS = { polynomial: flutter_polynomial, friction: flutter_friction };

/** All points of the curves in one direction, by ascending theta0, and which signs the polynomial has at theta0 = 0 and pi. */
function column(theta, kind, fixed) {
  const polynomial = kind.polynomial(theta, fixed);
  const points = angles(polynomial).map((theta0) => ({ theta, theta0, mu0: kind.friction(theta, theta0, fixed) }));
  return { theta, points, ends: [Math.sign(polynomial[0]), Math.sign(polynomial.at(-1))] };
}

/** Distance of two points in the plane, friction without bound brought into a bounded range. */
function gap(one, other) {
  const squeezed = (mu0) => mu0 / (1 + Math.abs(mu0));
  return Math.max(Math.abs(one.theta0 - other.theta0), Math.abs(squeezed(one.mu0) - squeezed(other.mu0)));
}

function same_kind(one, other) {
  return one.points.length === other.points.length && one.ends.every((sign, i) => sign === other.ends[i]);
}

/** Why curves are not drawn. */
function indistinct([kappa, alpha, sigma, beta]) {
  const where = `kappa = ${kappa}, alpha = ${alpha}, sigma = ${sigma}, beta = ${beta}`;
  return new RangeError(
    `${where}: curves lie closer together there than double precision can tell, as with hardly any preload; ` +
      "`folds` gives the folds along one parameter",
  );
}

/**
 * Columns between two, so that of each two neighbours the points go on in order, or no double is left in between; as many at most
 * as `room` has left.
 */
function between(one, other, kind, fixed, room) {
  const smooth = same_kind(one, other) && one.points.every((point, i) => gap(point, other.points[i]) < STRIDE);
  if (smooth || other.theta - one.theta < FINEST) {
    return [];
  }
  room.left -= 1;
  if (room.left < 0) {
    throw indistinct(fixed);
  }
  const middle = column(0.5 * (one.theta + other.theta), kind, fixed);
  return [...between(one, middle, kind, fixed, room), middle, ...between(middle, other, kind, fixed, room)];
}

/** Pairs [i, j] of the points of two neighbouring columns that belong together. */
function links(before, now) {
  if (same_kind(before, now)) {
    return now.points.map((_, i) => [i, i]);
  }
  const pairs = before.points.flatMap((one, i) =>
    now.points.map((other, j) => ({ i, j, far: Math.abs(one.theta0 - other.theta0) })),
  );
  return matched(pairs);
}

/** Of pairs { i, j, far } those that are nearest, each i and each j once, none farther than a stride. */
function matched(pairs) {
  const taken = [];
  for (const { i, j, far } of pairs.sort((one, other) => one.far - other.far)) {
    if (far < STRIDE && taken.every(([k, l]) => k !== i && l !== j)) {
      taken.push([i, j]);
    }
  }
  return taken;
}

/** Neighbours in a column without a link to the next one: they are born or vanish together in between. */
function couples(points, linked) {
  const free = points.filter((_, i) => !linked.includes(i));
  const found = [];
  while (free.length > 1) {
    const gaps = free.slice(1).map((point, i) => point.theta0 - free[i].theta0);
    const nearest = gaps.indexOf(Math.min(...gaps));
    if (gaps[nearest] > STRIDE) {
      break;
    }
    found.push(free.splice(nearest, 2));
  }
  return found;
}

/** Curves through the points of neighbouring columns, each an array of points in order; a closed one ends with its first. */
function joined(columns) {
  const neighbours = new Map(columns.flatMap((one) => one.points.map((point) => [point, []])));
  const join = ([one, other]) => {
    neighbours.get(one).push(other);
    neighbours.get(other).push(one);
  };
  for (let k = 0; k + 1 < columns.length; k++) {
    const [before, now] = [columns[k], columns[k + 1]];
    const found = links(before, now);
    found.forEach(([i, j]) => join([before.points[i], now.points[j]]));
    couples(before.points, found.map(([i]) => i)).forEach(join);
    couples(now.points, found.map(([, j]) => j)).forEach(join);
  }
  const left = new Set(neighbours.keys());
  const walk = (start) => {
    const curve = [];
    for (let point = start; point; point = neighbours.get(point).find((next) => left.has(next))) {
      left.delete(point);
      curve.push(point);
    }
    return curve;
  };
  const open = [...left].filter((point) => neighbours.get(point).length === 1);
  const curves = open.filter((point) => left.has(point)).map(walk);
  for (const point of left) {
    curves.push([...walk(point), point]);
  }
  return curves.filter((curve) => curve.length > 1);
}

/** Directions between neighbours at which curves are born and vanish unseen: zoom in on where the indicator nears zero. */
function hidden(directions, fixed) {
  const value = directions.map((theta) => fold_indicator(theta, fixed));
  const found = [];
  for (let i = 1; i + 1 < directions.length; i++) {
    const size = Math.abs(value[i]);
    const dip = size <= Math.abs(value[i - 1]) && size <= Math.abs(value[i + 1]);
    if (dip && Math.sign(value[i - 1]) === Math.sign(value[i]) && Math.sign(value[i]) === Math.sign(value[i + 1])) {
      found.push(...zoomed(directions[i - 1], directions[i + 1], fixed));
    }
  }
  return found;
}

function zoomed(low, high, fixed) {
  for (let pass = 0; pass < 6; pass++) {
    const fine = spread(low, high, 32);
    const value = fine.map((theta) => fold_indicator(theta, fixed));
    const crossed = fine.filter((_, i) => Math.sign(value[i]) !== Math.sign(value[0]));
    if (crossed.length > 0) {
      return crossed;
    }
    const sizes = value.map(Math.abs);
    const best = sizes.indexOf(Math.min(...sizes));
    if (best === 0 || best === 32) {
      return [];
    }
    [low, high] = [fine[best - 1], fine[best + 1]];
  }
  return [];
}

/** Numbers from low to high in equal steps. */
function spread(low, high, steps) {
  return Array.from({ length: steps + 1 }, (_, i) => low + ((high - low) * i) / steps);
}

/** All curves of a kind over about n directions between two, cut to mu0 >= 0 and to states in contact. */
function curves_of(kind, directions, given) {
  const fixed = fixed_of(given);
  const coarse = directions.map((theta) => column(theta, kind, fixed));
  const room = { left: MOST_COLUMNS };
  const columns = coarse.flatMap((one, i) => (i ? [...between(coarse[i - 1], one, kind, fixed, room), one] : [one]));
  const curves = joined(columns)
    .flatMap((curve) => with_friction(curve, kind, fixed))
    .map((curve) => completed(curve, given))
    .filter((curve) => curve.theta.length > 1);
  if (curves.length > MOST_CURVES) {
    throw indistinct(fixed);
  }
  return curves;
}

/** The parts of a curve with mu0 >= 0, each begun and ended where mu0 = 0. */
function with_friction(curve, kind, fixed) {
  const parts = [];
  let part = [];
  curve.forEach((point, i) => {
    const before = curve[i - 1];
    const changes = before && before.mu0 >= 0 !== point.mu0 >= 0;
    const end = changes ? without_friction(before, point, kind, fixed) : [];
    if (point.mu0 >= 0) {
      part.push(...end, point);
    } else if (part.length > 0) {
      parts.push([...part, ...end]);
      part = [];
    }
  });
  return [...parts, part].filter((one) => one.length > 1);
}

/** The point of a curve in a direction between those of two of its points. */
function on_the_way(one, other, kind, fixed) {
  return (theta) => {
    const share = (theta - one.theta) / (other.theta - one.theta);
    const expected = one.theta0 + (other.theta0 - one.theta0) * share;
    const far = (point) => Math.abs(point.theta0 - expected);
    const { points } = column(theta, kind, fixed);
    return points.length > 0 ? points.reduce((best, point) => (far(best) <= far(point) ? best : point)) : other;
  };
}

/** The point between two at which friction is zero; none where it runs through infinity instead. */
function without_friction(one, other, kind, fixed) {
  if (one.theta === other.theta || Math.min(Math.abs(one.mu0), Math.abs(other.mu0)) > 1e3) {
    return [];
  }
  const at = on_the_way(one, other, kind, fixed);
  const theta = bisected((middle) => at(middle).mu0, one.theta, other.theta);
  const point = at(theta);
  return Math.abs(point.mu0) < 1e-6 ? [{ ...point, theta, mu0: 0 }] : [];
}

/** A curve as columns, with the states on it; those out of contact are left out. */
function completed(curve, given) {
  const rows = curve.flatMap(({ theta, theta0, mu0 }) => {
    const at = Number.isFinite(mu0) ? state_at(...turned(theta), ...turned(theta0), given) : null;
    return at ? [{ theta0, mu0, theta, ...at }] : [];
  });
  return Object.fromEntries(["theta0", "mu0", "theta", "L", "x", "y"].map((name) => [name, rows.map((row) => row[name])]));
}

/**
 * Every curve of folds in the plane of theta0 and mu0, for 0 < theta0 < pi and mu0 >= 0, and the cusps on them.
 *
 * @param {object} parameters kappa, alpha, sigma and beta; theta0 and mu0 are not used
 * @param {object} [options] n: how many directions to begin with, at least 8; where curves are long, more are put in between
 * @returns {object} curves, each of arrays theta0, mu0, theta, L, x, y in order along it; cusps
 */
export function bifurcation_set(parameters, options = {}) {
  const given = fold_parameters(parameters, ["theta0", "mu0"]);
  const { n = DIRECTIONS } = known("options", options, ["n"]);
  const curves = curves_of(FOLDS, directions_for(whole("n", n, 8), given), given);
  return { curves, cusps: n < DIRECTIONS ? cusps(parameters) : cusps_on(curves, given) };
}

/** About n directions at which folds are looked for. */
function directions_for(n, given) {
  const even = spread(NEAREST, TURN - NEAREST, n);
  return [...even, ...hidden(even, fixed_of(given))].sort((one, other) => one - other);
}

/**
 * Every curve of flutter onsets in contact, for 0 < theta0 < pi and mu0 >= 0, as far as n directions show them.
 *
 * @param {object} parameters kappa, alpha, sigma and beta; theta0 and mu0 are not used
 * @param {object} [options] n: how many directions to begin with, at least 8
 * @returns {object[]} curves as of `bifurcation_set`
 */
export function flutter_boundary(parameters, options = {}) {
  const given = parameters_of(parameters, ["theta0", "mu0"]);
  const { n = DIRECTIONS } = known("options", options, ["n"]);
  const even = spread(0.5 * TURN, TURN, whole("n", n, 8)).slice(1, -1);
  const towards = spread(Math.log(NEAREST), Math.log(0.25 * TURN), n >> 2).map(Math.exp);
  const ends = towards.flatMap((distance) => [0.5 * TURN + distance, TURN - distance]);
  return curves_of(ONSETS, [...even, ...ends].sort((one, other) => one - other), given);
}

/** The points of a curve of folds at which a function of them is zero or changes its sign. */
function changes(curve, value_at, given) {
  const points = curve.theta.map((theta, k) => ({ theta, theta0: curve.theta0[k], mu0: curve.mu0[k] }));
  const values = points.map(value_at);
  const found = points.filter((_, k) => values[k] === 0);
  for (let k = 0; k + 1 < points.length; k++) {
    if (values[k] * values[k + 1] < 0) {
      const [one, other] = [points[k], points[k + 1]];
      const at = on_the_way(one, other, FOLDS, fixed_of(given));
      // Two that are born together stand at one direction; the place between them is known to rounding.
      found.push(one.theta === other.theta ? one : at(bisected((theta) => value_at(at(theta)), one.theta, other.theta)));
    }
  }
  return found;
}
