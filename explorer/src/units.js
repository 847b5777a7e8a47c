// In which units the page shows what it computes: a file's, or the model's own.

import { degrees, radians } from "./numbers.js";
import { symbolOf } from "./symbols.js";

/** The model's own units; of each what 1 is, and its name. Those of a file have `parameters` too: quantity, what 1 is, unit. */
export const OWN = { length: [1, ""], time: [1, ""], force: [1, ""], parameters: {} };

/**
 * The parameters as they are shown: `symbol` in `unit`, of which one is `one` of the model's `own`; `low` and `high` are ends of the
 * slider, in that unit. An angle is in degrees.
 */
export function parametersIn(units, entries) {
  return entries.map((entry) => {
    const own = symbolOf(entry.name);
    const [symbol, size, unit] = units.parameters[entry.name] ?? [own, entry.angle ? degrees(1) : 1, entry.angle ? "degrees" : ""];
    const [low, high] = [entry.low, entry.high].map((end) => (entry.angle ? end : end * size));
    return { ...entry, own, symbol, unit, one: entry.angle ? radians(1) : 1 / size, low, high };
  });
}

/** The coordinates and their rates as they are shown: what 1 of the model's is there, and the unit. An angle is in radians. */
export function coordinatesIn({ length: [long, length], time: [lasting, time] }, coordinates) {
  return coordinates.map(({ name, angle }) => {
    const [size, unit] = angle ? [1, "rad"] : [long, length];
    return { name, symbol: symbolOf(name), angle, size, unit, rate: size / lasting, rate_unit: time && `${unit}/${time}` };
  });
}

/** A number that is shown as one of the model, and back. */
export const inward = ({ one }, value) => value * one;
export const outward = ({ one }, value) => value / one;
/** What something is called, with its unit. */
export const measured = (text, unit) => text + (unit && ` in ${unit}`);

/** Room beside an axis that goes up: as much as its widest number takes. */
export const beside = (_, numbers) => Math.max(46, 18 + 7 * Math.max(...(numbers ?? []).map((text) => text.length)));
