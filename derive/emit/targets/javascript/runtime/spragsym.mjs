/**
 * Equilibria, stability, folds and motion of the sprag-slip oscillator. One ES module without dependencies, for node and browsers.
 *
 * @header@
 *
 * Angles are radians; lengths, times and forces are dimensionless: text after (9) of the article. Names are those of the Python
 * package and of the C library. Bad input throws: TypeError for what is no number or has an unknown name, RangeError for a number
 * out of its range.
 *
 * Statics use + - * / of doubles, comparisons and Math.sqrt; sine, cosine, arc tangent and cube root are computed here by the
 * kernel's own statements. ECMAScript rounds every operation to double, so that `equilibria` gives the bits of the C library
 * under -std=c99, on every engine whose Math.sqrt is that of IEEE 754. No error bound depends on Math.sqrt or on the cube root,
 * which only serve to guess where a root is. Motion uses Math.exp as well, which an engine may round in its own way.
 *
 * @module spragsym
 */

/** The derivation that this was generated from: the head of a hash of its sources. */
export const SOURCE = "@source@";

/** Names of the parameters, in the order in which the algebra takes them. */
export const NAMES = Object.freeze(@names@);

/** The article's base values; theta0 is its control parameter. */
export const BASE = Object.freeze(@base@);

/** Allowed values of the parameters, and of the belt speed V and the friction law's steepness d. */
export const RANGES = Object.freeze(@ranges@);

// ------------------------------------------------------------------------------------------------ generated algebra

// @algebra@

// ------------------------------------------------------------------------------------------------------- the kernel

// @kernel@
