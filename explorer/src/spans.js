// What a drawing spans of a parameter, in the unit of its slider.

import { outward } from "./units.js";

/** Share of a span that a point keeps from an end that is not allowed. */
const EDGE = 1e-4;
/** No drawing spans more: products with the number of its columns are numbers too. */
const LARGEST = 1e305;
/** The ends that a parameter is allowed, undefined where there is none. */
const ends = (field) => [field.range.low, field.range.high].map((end) => (end === undefined ? undefined : outward(field, end)));

/** All that is allowed where that ends, else as far as the slider reaches, and twice as far as often as the value of now needs. */
export function spanOf(field, value) {
  const [[least, most], at] = [ends(field), outward(field, value)];
  const low = least ?? (at < field.low ? Math.max(-LARGEST, 2 * at) : field.low);
  return [low, most ?? (at > field.high ? Math.min(LARGEST, 2 ** Math.ceil(Math.log2(at) + 0.07)) : field.high)];
}

/** A value moved into a span, off ends that are not allowed. */
export function kept(field, [low, high], value) {
  const [least, most] = ends(field);
  const room = EDGE * (high - low);
  const [first, last] = [low + (least === low && field.range.low_open ? room : 0), high - (most === high && field.range.high_open ? room : 0)];
  return Math.min(last, Math.max(first, value));
}
