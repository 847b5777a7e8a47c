// Numbers as people type them, and as they read them.

const DEGREE = Math.PI / 180;

export const radians = (degrees) => degrees * DEGREE;
export const degrees = (angle) => angle / DEGREE;

/**
 * A number as it is typed: with a point or a comma before the decimals, in any script's form of either, with a true minus sign.
 * Returns NaN for everything else, numbers with both point and comma included, since one of them may part thousands.
 */
export function parsed(text) {
  const plain = text.trim().replace(/[,٫،，﹐]/g, ",").replace(/[．。]/g, ".").replace(/[−–]/g, "-").replace(/[\s\u00a0\u202f]+/g, " ");
  if (!/^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?$/.test(plain)) {
    return NaN;
  }
  return Number(plain.replace(",", "."));
}

/** A number in at most that many significant digits, without trailing zeros. */
export function written(value, digits = 6) {
  if (value === null || value === undefined || Number.isNaN(value)) {
    return "–";
  }
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

/** The same for an input or a link: it reads back as the same double where `digits` is 17. */
export function typed(value, digits = 10) {
  return String(Number(value.toPrecision(digits)));
}
