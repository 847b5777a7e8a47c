// The range of a parameter on an axis, in the unit of its slider.

import { outward } from "./units.js";

/** Share of a range that a point keeps from an end that is not allowed. */
const EDGE = 1e-4;
/** The largest end of a range: its products with the number of columns are finite. */
const LARGEST = 1e305;
/** The ends that a parameter is allowed, undefined where there is none. */
const ends = (field) => [field.range.low, field.range.high].map((end) => (end === undefined ? undefined : outward(field, end)));

/** The ends of the allowed range; where it is infinite the end of the slider, or for a value beyond that the next power of 2, below 0 twice the value. */
export function spanOf(field, value) {
  const [[least, most], at] = [ends(field), outward(field, value)];
  const low = least ?? (at < field.low ? Math.max(-LARGEST, 2 * at) : field.low);
  return [low, most ?? (at > field.high ? Math.min(LARGEST, 2 ** Math.ceil(Math.log2(at) + 0.07)) : field.high)];
}

/** The value, moved into a range and off ends that are not allowed. */
export function kept(field, [low, high], value) {
  const [least, most] = ends(field);
  const room = EDGE * (high - low);
  const [first, last] = [low + (least === low && field.range.low_open ? room : 0), high - (most === high && field.range.high_open ? room : 0)];
  return Math.min(last, Math.max(first, value));
}
