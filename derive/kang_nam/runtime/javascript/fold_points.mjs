// ------------------------------------------------------------------------------------------ folds along a parameter
//
// f is linear in every parameter v but theta0, so that f = f' = 0 leaves a polynomial in t = tan(theta/2) alone. In double precision
// and without proof, as the curves.

// Below this alpha over 1 + beta + sigma two roots of the polynomial for theta0 lie so close together, as the folds at theta0 and at
// pi - theta0 do without alpha, that its coefficients can't tell them; the curves of folds can.
const LEAST_ALPHA = 1e-6;

/**
 * The folds in contact along one parameter, the others fixed: f = f' = 0.
 *
 * @param {object} parameters all but the one that varies
 * @param {object} [options] vary: the name of one of the six
 * @returns {object[]} the six parameters, theta, L, x and y of each, by ascending value of what varies
 */
export function folds(parameters, options = {}) {
  const { vary = "theta0" } = known("options", options, ["vary"]);
  if (!NAMES.includes(vary)) {
    throw new RangeError(`vary = ${shown(vary)} is not among ${NAMES.map((name) => `"${name}"`).join(", ")}`);
  }
  const given = fold_parameters(parameters, [vary]);
  const rough = vary === "theta0" ? folds_in_theta0(given) : folds_in(vary, given);
  return rough
    .flatMap((guess) => fold_at(sharpened(guess, vary, given), vary, given))
    .sort((one, other) => one[vary] - other[vary]);
}

/** A fold with its state; none where what varies is out of its range, or where the state is out of contact. */
function fold_at({ theta, value, settled }, vary, given) {
  const { low, high } = ends(vary);
  if (!(value > low && value < high)) {
    return [];
  }
  const at = { ...given, [vary]: value };
  const state = state_at(...turned(theta), ...turned(at.theta0), at);
  if (state && !settled) {
    throw new RangeError(
      `a fold near ${vary} = ${value} can't be told from its neighbours in double precision; the Python package's folds can`,
    );
  }
  return state ? [{ ...at, theta, ...state }] : [];
}

/** Coefficients a, b, d, m of f at a point in contact. */
function line_at({ theta0, mu0, kappa, alpha, sigma, beta }) {
  return algebra.f_coefficients(...turned(theta0), mu0, kappa, alpha, sigma, beta, 1);
}

/** Their derivatives by one of the parameters. */
function change_at({ theta0, mu0, kappa, alpha, sigma, beta }, vary) {
  return algebra.f_changes(...turned(theta0), mu0, kappa, alpha, sigma, beta)[NAMES.indexOf(vary)];
}

/** Directions and values of all folds along a parameter that f is linear in. */
function folds_in(vary, given) {
  const without = { ...given, [vary]: 0 };
  const [line, change] = [line_at(without), change_at(without, vary)];
  if (symmetric(vary, given)) {
    return [[0.5 * TURN, -algebra.f_slope(0, 1, ...line) / algebra.f_slope(0, 1, ...change)]];
  }
  return angles(scaled(algebra.fold_sextic(...line, ...change))).map((theta) => {
    const [c, s] = turned(theta);
    return [theta, -algebra.f(c, s, ...line) / algebra.f(c, s, ...change)];
  });
}

/** Whether f has the factor cos theta: without friction and alpha nothing tells left from right, and equilibria meet upright only. */
function symmetric(vary, { mu0, alpha }) {
  return vary !== "mu0" && vary !== "alpha" && mu0 === 0 && alpha === 0;
}

/** Directions and values of all folds along theta0, whose sine and cosine are known in a direction: where both squares add up to 1. */
function folds_in_theta0(given) {
  const values = [given.mu0, ...fixed_of(given)];
  const [sines, cosines] = algebra.fold_cubics(...values);
  if (given.alpha === 0) {
    const directions = symmetric("theta0", given) ? [0.5 * TURN] : angles(scaled(cosines));
    return directions.flatMap((theta) => {
      const theta0 = Math.asin(algebra.fold_sine(...turned(theta), ...values));
      return [[theta, theta0], [theta, TURN - theta0]];
    });
  }
  const { alpha, sigma, beta } = given;
  if (alpha < LEAST_ALPHA * (1 + beta + sigma)) {
    const curves = curves_of(FOLDS, directions_for(DIRECTIONS, given), given);
    const found = curves.flatMap((curve) => changes(curve, (at) => at.mu0 - given.mu0, given));
    return found.map(({ theta, theta0 }) => [theta, theta0]);
  }
  const width = alpha * (beta + 1 + sigma);
  const scale = (alpha + sigma) * (beta + 1) * width;
  const squares = product(cosines, cosines).map((value, i) => value + width * width * product(sines, sines)[i]);
  [1, 6, 15, 20, 15, 6, 1].forEach((binomial, i) => {
    squares[2 * i] -= scale * scale * binomial;
  });
  return angles(scaled(squares)).map((theta) => {
    const [sine, cosine] = algebra.fold_angles(...turned(theta), ...values);
    return [theta, Math.atan2(sine, cosine)];
  });
}

/** The product of two polynomials. */
function product(one, other) {
  const result = new Array(one.length + other.length - 1).fill(0);
  one.forEach((left, i) => other.forEach((right, j) => {
    result[i + j] += left * right;
  }));
  return result;
}

/**
 * A fold to all its digits, of which the polynomial has lost some: Newton's steps for the direction by f' and for the value by f.
 * Settled, if they come to an end.
 */
function sharpened([theta, value], vary, given) {
  if (symmetric(vary, given)) {
    return { theta, value, settled: true };
  }
  const allowed = (v) => Number.isFinite(v) && (vary !== "theta0" || (v > 0 && v < TURN));
  for (let pass = 0; pass < 30 && allowed(value); pass++) {
    const [c, s] = turned(theta);
    const at = { ...given, [vary]: value };
    const line = line_at(at);
    const turn = algebra.f_slope(c, s, ...line) / algebra.f_curvature(c, s, ...line);
    const rise = algebra.f(c, s, ...line) / algebra.f(c, s, ...change_at(at, vary));
    if (!(Math.abs(turn) < 0.01 * s && Math.abs(rise) < 0.01 * Math.abs(value))) {
      break;
    }
    [theta, value] = [theta - turn, value - rise];
    if (Math.abs(turn) < 1e-9 * s && Math.abs(rise) < 1e-12 * Math.abs(value)) {
      return { theta, value, settled: true };
    }
  }
  return { theta, value, settled: false };
}
