// Numbers as people type and read them.

const DEGREE = Math.PI / 180;

export const radians = (degrees) => degrees * DEGREE;
export const degrees = (angle) => angle / DEGREE;

/**
 * The value of a typed number: with a decimal point or comma in any script's form, and a hyphen or a true minus sign. NaN for anything else, numbers
 * with both point and comma among them, since one of the two may separate thousands.
 */
export function parsed(text) {
  const plain = text.trim().replace(/[,٫،，﹐]/g, ",").replace(/[．。]/g, ".").replace(/[−–]/g, "-").replace(/[\s\u00a0\u202f]+/g, " ");
  if (!/^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?$/.test(plain)) {
    return NaN;
  }
  return Number(plain.replace(",", "."));
}

/** A number to be read: with at most so many significant digits, without trailing zeros. */
export function written(value, digits = 6) {
  if (value === null || value === undefined || Number.isNaN(value)) {
    return "–";
  }
  return String(Number(value.toPrecision(digits))).replace("-", "−");
}

/** The same for an input or a link, with a plain minus; with 17 digits it reads back as the same double. */
export function typed(value, digits = 10) {
  return String(Number(value.toPrecision(digits)));
}
