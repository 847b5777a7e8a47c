// The units in which the page shows numbers: those of a file, or the model's own.

import { degrees, radians } from "./numbers.js";
import { symbolOf } from "./symbols.js";

/** The model's own units, each as the value of the model's 1 and a name. A file's have `parameters` too: the quantity shown, the value of 1, the unit. */
export const OWN = { length: [1, ""], time: [1, ""], force: [1, ""], parameters: {} };

/**
 * The parameters as they are shown: as `symbol` in `unit`, of which 1 is `one` of the model's parameter `own`; `low` and `high` are the ends of the
 * slider in that unit. An angle is shown in degrees.
 */
export function parametersIn(units, entries) {
  return entries.map((entry) => {
    const own = symbolOf(entry.name);
    const [symbol, size, unit] = units.parameters[entry.name] ?? [own, entry.angle ? degrees(1) : 1, entry.angle ? "degrees" : ""];
    const [low, high] = [entry.low, entry.high].map((end) => (entry.angle ? end : end * size));
    return { ...entry, own, symbol, unit, one: entry.angle ? radians(1) : 1 / size, low, high };
  });
}

/** The coordinates as they are shown: `size` is the value of the model's 1 in `unit`, `rate` that of the model's rate 1 in `rate_unit`. Angles in radians. */
export function coordinatesIn({ length: [long, length], time: [lasting, time] }, coordinates) {
  return coordinates.map(({ name, angle }) => {
    const [size, unit] = angle ? [1, "rad"] : [long, length];
    return { name, symbol: symbolOf(name), angle, size, unit, rate: size / lasting, rate_unit: time && `${unit}/${time}` };
  });
}

/** A shown number in the model's units, and back. */
export const inward = ({ one }, value) => value * one;
export const outward = ({ one }, value) => value / one;
/** A name with its unit. */
export const measured = (text, unit) => text + (unit && ` in ${unit}`);

/** Pixels beside a vertical axis: as many as its widest number takes. */
export const beside = (_, numbers) => Math.max(46, 18 + 7 * Math.max(...(numbers ?? []).map((text) => text.length)));
