/**
 * @summary@
 * One ES module without dependencies, for node and browsers.
 *
 * @header@
 *
 * @names_and_errors@
 *
 * Where no sine, exponential or square root is written below, every engine gives the same bits: ECMAScript rounds each of + - * /
 * to double. Math.sqrt is that of IEEE 754 in the engines known; Math.exp may differ in its last bit from engine to engine.
 *
 * @module @library@
 */

/** Head of the SHA-256 of what was emitted together. */
export const SOURCE = "@source@";

/** Names of the parameters, in the order in which the algebra takes them. */
export const NAMES = Object.freeze(@names@);

/** Base values of the parameters that have one. */
export const BASE = Object.freeze(@base@);

/** Allowed values of what the algebra takes, from low to high; an end that is not there is infinite. */
export const RANGES = Object.freeze(@ranges@);

// ------------------------------------------------------------------------------------------------ generated algebra

// @symbols@

/** The generated algebra, by the names that it has in Python. */
export const algebra = Object.freeze({
// @algebra@
});
