// What a state of the article's model is called: stable only where nothing grows; (27) stands beside it.

import { wordOf } from "./models/kinds.js";

export const SIGNS = { stable: "●", divergent: "▲", flutter: "≈", marginal: "○" };

const UNIT = [[1, 0], [0, 1]];

/** The word for a state with the friction law's own damping at belt speed V and steepness d, and the rate at which it grows. */
export function worded(algebra, { mu0, alpha, sigma, beta }, { theta, L, y, stability }, contact, { V, d }) {
  const nbar = contact ? 1 : 0;
  const damping = [[algebra.damping(y, mu0, V, d, nbar), 0], [0, 0]];
  return wordOf(UNIT, damping, algebra.stiffness(Math.cos(theta), Math.sin(theta), L, mu0, alpha, sigma, beta, nbar), stability);
}
