// ----------------------------------------------------------------------------------------------- roots of polynomials

function evaluate(coefficients, x) {
  let value = 0;
  for (let i = coefficients.length - 1; i >= 0; i--) {
    value = value * x + coefficients[i];
  }
  return value;
}

/** Where a continuous function changes its sign between two places at which it has different ones, to the last bit or so. */
function bisected(value_at, one, other) {
  let [low, high] = one < other ? [one, other] : [other, one];
  let at_low = value_at(low);
  let at_high = value_at(high);
  for (let pass = 0; pass < 200; pass++) {
    // Regula falsi on every second pass; halving on the others sees to it that the interval shrinks.
    const falsi = low + ((high - low) * at_low) / (at_low - at_high);
    const middle = pass % 2 === 0 && falsi > low && falsi < high ? falsi : 0.5 * (low + high);
    if (!(middle > low && middle < high)) {
      break;
    }
    const value = value_at(middle);
    if (value === 0) {
      return middle;
    }
    if (value > 0 === at_low > 0) {
      [low, at_low] = [middle, value];
    } else {
      [high, at_high] = [middle, value];
    }
  }
  return Math.abs(at_low) < Math.abs(at_high) ? low : high;
}

/**
 * Real roots of a polynomial, lowest power first, in [low, high], ascending. Between two neighbouring roots of its derivative it
 * is monotone, so that no root is missed but one that rounding can't tell from none.
 */
function roots_between(coefficients, low, high) {
  if (coefficients.length < 2) {
    return [];
  }
  const slope = coefficients.slice(1).map((value, i) => value * (i + 1));
  const ends = [low, ...roots_between(slope, low, high), high];
  const found = [];
  for (let i = 0; i + 1 < ends.length; i++) {
    const [left, right] = [evaluate(coefficients, ends[i]), evaluate(coefficients, ends[i + 1])];
    if (left === 0 && ends[i] !== found.at(-1)) {
      found.push(ends[i]);
    }
    if ((left < 0 && right > 0) || (left > 0 && right < 0)) {
      found.push(bisected((x) => evaluate(coefficients, x), ends[i], ends[i + 1]));
    }
  }
  if (evaluate(coefficients, high) === 0 && found.at(-1) !== high) {
    found.push(high);
  }
  return found;
}

/** Angles in (0, pi), ascending, whose tan(angle/2) is a root. */
function angles(coefficients) {
  const first = roots_between(coefficients, 0, 1).filter((v) => v > 0);
  const second = roots_between([...coefficients].reverse(), 0, 1).filter((u) => u > 0 && u < 1);
  return [...first.map((v) => 2 * arctangent(v)), ...second.reverse().map((u) => Math.PI - 2 * arctangent(u))];
}
