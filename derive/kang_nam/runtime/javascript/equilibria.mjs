// -------------------------------------------------------------------------------------------------------- parameters

// What to do about a value out of its range, where the range alone does not say it.
const REMEDIES = {
  theta0: ": angles are radians, strictly between 0 and pi",
  mu0: ": a belt that runs the other way is the mirror image: give the supplement of theta0",
  kappa: ": without preload nothing presses the mass on the belt",
  sigma: ": without the inclined spring there is no sprag",
};

/** The parameters of a point, checked; those in `spanned` are not used and may be left out. */
function parameters_of(given, spanned = []) {
  known("parameters", given, NAMES);
  const values = {};
  for (const name of NAMES) {
    values[name] = spanned.includes(name) && given[name] === undefined ? NaN : checked(name, given[name], REMEDIES[name]);
  }
  return values;
}

// -------------------------------------------------------------------------------------------------------- equilibria

// Error per value that status "ok" vouches for.
const TOLERANCE = 1e-12;

const STABILITIES = Object.freeze(["none", "stable", "divergent", "flutter"]);

/** A point of one regime, as the kernel takes it. */
function point_of(given, nbar) {
  const { cosine, sine } = cosine_and_sine(given.theta0);
  const { mu0, kappa, alpha, sigma, beta } = given;
  return { cos0: cosine, sin0: sine, mu0, kappa, alpha, sigma, beta, nbar };
}

/*
 * Statics use + - * / of doubles, comparisons and Math.sqrt; sine, cosine, arc tangent and cube root are computed by the kernel's
 * own statements, so that what `equilibria` vouches for has the bits of the C library under -std=c99. No error bound depends on
 * Math.sqrt or on the cube root, which only serve to guess where a root is.
 */

/**
 * All equilibria of one regime with their stability, by ascending theta: roots of (12), (13) with (22)-(25).
 *
 * status is "ok" where the number, the kinds and twelve digits are vouched for; where double precision can't, close to a fold, to a
 * cusp or to the onset of flutter, double-double arithmetic decides. "uncertain" where that can't either, closer still, with hardly
 * any preload, or far from the scale of the article: then the states are the best guess, which may be none at all;
 * "out_of_range" where double can't carry the problem, without states.
 *
 * @param {object} parameters theta0 in (0, pi), mu0 >= 0, kappa > 0, alpha >= 0, sigma > 0, beta >= 0
 * @param {object} [options] contact: true for states with y < 0, false for those with y >= 0
 * @returns {object} status, count and states; error bounds |error| of theta, L, x and y, each over max(1, |exact value|)
 */
export function equilibria(parameters, options = {}) {
  const given = parameters_of(parameters);
  const { contact = true } = known("options", options, ["contact"]);
  if (typeof contact !== "boolean") {
    throw new TypeError(`contact = ${shown(contact)} is of type ${typeof contact}; it must be true or false`);
  }
  const point = point_of(given, contact ? 1 : 0);
  const line = balance(point);
  if (!representable(line)) {
    return { status: "out_of_range", count: 0, states: [] };
  }
  const found = answer(guesses(point, line, UNIT_ROUNDOFF), contact, PLAIN, (t) => at_root(t, point, line, UNIT_ROUNDOFF));
  return found.status === "ok" ? found : (settled_widely(given, contact) ?? found);
}

/** What is asked of the roots of f, as doubles and as double-doubles. */
const PLAIN = { apart, leading: (t) => t };
const WIDELY = { apart: wide_apart, leading: dd_leading };

// Roundings of a double that theta, L, x and y are off by when they are stored: the arc tangent is within one unit in the last
// place, and its argument is rounded.
const STORED = 4 * UNIT_ROUNDOFF;

/** The answer by double-double arithmetic, or null where that leaves the point open too. */
function settled_widely(given, contact) {
  const { cosine_high, cosine_low, sine_high, sine_low } = dd_cosine_and_sine(given.theta0);
  const [mu0, kappa, alpha, sigma, beta, nbar] = [
    given.mu0, given.kappa, given.alpha, given.sigma, given.beta, contact ? 1 : 0,
  ].map((value) => paired(value, 0));
  const point = { cos0: paired(cosine_high, cosine_low), sin0: paired(sine_high, sine_low), mu0, kappa, alpha, sigma, beta, nbar };
  const line = wide_balance(point);
  const all = wide_guesses(point, line, WIDE_ROUNDOFF);
  if (!(all.certain && wide_representable(line) && wide_moderate(point))) {
    return null;
  }
  const found = answer(all, contact, WIDELY, (t) => {
    const at = wide_at_root(t, point, line, WIDE_ROUNDOFF);
    return { ...at, error: at.error + STORED };
  });
  return found.status === "ok" ? found : null;
}

/** The states at guessed roots; "ok" if these certainly are different ones, each certainly an equilibrium or certainly none. */
function answer(all, contact, { apart, leading }, root_at) {
  const states = [];
  let certain = all.certain;
  let before;
  for (const t of [all.t0, all.t1, all.t2, all.t3].slice(0, all.count)) {
    const at = root_at(t);
    // Two proved roots are different when the intervals that hold them are; in contact all lie above t = 0.
    const separate = before ? apart(before.t, before.radius, t, at.radius) : !contact || leading(t) > 0;
    const sure = at.outsider || (at.member && at.known && at.error <= TOLERANCE);
    certain = certain && sure && separate;
    before = { t, radius: at.radius };
    const clear = contact ? -at.y : at.y;
    if (Number.isFinite(at.L + at.x + at.y) && at.L > 0 && (clear > 0 || (!contact && clear >= 0))) {
      const error = Number.isFinite(at.error) ? at.error : Infinity;
      states.push({ theta: 2 * arctangent(leading(t)), L: at.L, x: at.x, y: at.y, stability: STABILITIES[at.code], error });
    }
  }
  // Roots that may be one can have changed places.
  states.sort((one, other) => one.theta - other.theta);
  // All roots seen, the count stands, which in contact is one or three.
  const stands = certain && (!contact || states.length % 2 === 1);
  return { status: stands ? "ok" : "uncertain", count: states.length, states };
}
