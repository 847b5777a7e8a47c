// Where the reference state ends first, in a sentence.

import { degrees, written } from "../numbers.js";

const KINDS = { cusp: "a cusp", turn: "where the curve of folds turns back", end: "as θ₀ goes to 0" };

/** Of the curves as curvesOf gives them; empty where these are null. */
export function lowestFold(shapes) {
  if (!shapes) {
    return "";
  }
  const { theta0, mu0, kind } = shapes.lowest;
  return kind
    ? `The reference state ends first at μ₀ = ${written(mu0, 6)} at θ₀ = ${written(degrees(theta0), 5)}°, ${KINDS[kind]}. Below that friction it jumps at no inclination (in double precision, not proved).`
    : "No fold ends the reference state, at any inclination and friction (in double precision, not proved).";
}
