// A motion of @library@ from rest at its base values: coordinates, rates and energy, and whether
// the contact is closed. Run with `node example_@library@.mjs`.
import { algebra } from "./@library@.mjs";

const COUNT = @count@;
const NAMES = [@shown_names@];
// @names@, an angle by its cosine and sine
const given = [@arguments@];

const rates = (state) => [...state.slice(COUNT), ...algebra.rhs(...state, ...given)];
const moved = (state, slope, h) => state.map((value, i) => value + h * slope[i]);

/** One step of the classical Runge-Kutta method; across a kink it is of first order. */
function step(state, h) {
  const k1 = rates(state);
  const k2 = rates(moved(state, k1, 0.5 * h));
  const k3 = rates(moved(state, k2, 0.5 * h));
  const k4 = rates(moved(state, k3, h));
  return state.map((value, i) => value + (h / 6) * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
}

let state = [@start@];
const h = 0.01;
for (let i = 0; i <= 2000; i++) {
  if (i % 400 === 0) {
    const border = algebra.borders(...state, ...given);
    const energy = algebra.energy(...state, ...given, @pushing@);
    const shown = NAMES.map((name, k) => `${name} ${state[k].toFixed(9)}`).join("  ");
    console.log(`time ${(h * i).toFixed(1)}  ${shown}  energy ${energy.toFixed(9)}  ${@touching@}`);
  }
  state = step(state, h);
}
