// Equilibria at the article's base values, the folds, and some steps of the motion. Run with `node example.mjs`.
import { BASE, bifurcation_set, equilibria, motion } from "./spragsym.mjs";

const point = { ...BASE, theta0: (49 / 180) * Math.PI };
for (const contact of [true, false]) {
  const { status, count, states } = equilibria(point, { contact });
  console.log(`${contact ? "contact" : "lift-off"}: ${count}, ${status}`);
  for (const { theta, L, x, y, stability, error } of states) {
    const numbers = [theta, L, x, y].map((value) => value.toFixed(12)).join("  ");
    console.log(`  theta, L, x, y  ${numbers}  error ${error.toExponential(0)}  ${stability}`);
  }
}

const { curves, cusps } = bifurcation_set(BASE);
console.log(`${curves.length} curves of folds, cusps at friction ${cusps.map((cusp) => cusp.mu0.toFixed(9)).join(", ")}`);

const { step } = motion(point, { V: 0.5, d: 10 });
let state = [0, 0, 0, 0];
for (let i = 0; i <= 1000; i++) {
  if (i % 200 === 0) {
    console.log(`time ${(0.05 * i).toFixed(1)}  x ${state[0].toFixed(9)}  y ${state[1].toFixed(9)}`);
  }
  state = step(state, 0.05);
}
