// The stability of a state, by the eigenvalues of its linearization, without damping and with it.

import { determinant, EigenvalueDecomposition, Matrix, solve } from "ml-matrix";

/** Squared frequencies with an imaginary part below this share of the largest count as real. */
const REAL = 1e-13;

/** With gyroscopic terms, roots with a real part above this share of the largest root grow; double roots are known no better. */
const GROWS = 1e-7;

/** The kind without damping, "stable", "divergent" or "flutter", as in the Python package; from the matrices, the gyroscopic one undefined if there is none. */
export function kindOf(mass, stiffness, gyroscopic) {
  if (gyroscopic) {
    const { realEigenvalues, imaginaryEigenvalues } = spectrum(mass, gyroscopic, stiffness);
    const limit = GROWS * Math.max(...realEigenvalues.map((real, i) => Math.hypot(real, imaginaryEigenvalues[i])));
    const growing = imaginaryEigenvalues.filter((_, i) => realEigenvalues[i] > limit);
    return growing.some((imaginary) => Math.abs(imaginary) > limit) ? "flutter" : growing.length ? "divergent" : "stable";
  }
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(solve(new Matrix(mass), new Matrix(stiffness)));
  const size = Math.max(...realEigenvalues.map((real, i) => Math.hypot(real, imaginaryEigenvalues[i])));
  const complex = imaginaryEigenvalues.map((imaginary) => Math.abs(imaginary) > REAL * size);
  if (complex.some(Boolean)) {
    return "flutter";
  }
  return realEigenvalues.some((real) => real < 0) ? "divergent" : "stable";
}

/** Entries above this make eigenvalues of the companion matrix inaccurate unless rates are scaled. */
const STIFF = 1e6;
/** A growth rate below this share of the frequency is practically neutral, as in the Python package. */
const NEUTRAL = 1e-4;

/** The stability with dampers and the slope of the friction law, "stable", "neutral" or "unstable", and the rate at which small deviations grow. */
export function stabilityOf(mass, damping, stiffness, undamped, gyroscopic) {
  if (![damping, stiffness].flat(2).every(Number.isFinite)) {
    return { stability: "", rate: NaN };
  }
  if (!damping.flat().some(Boolean)) {
    const rate = undamped === "stable" ? 0 : gyroscopic ? fastest(mass, gyroscopic, stiffness).rate : withoutDamping(mass, stiffness);
    return { stability: rate ? "unstable" : "neutral", rate };
  }
  const by_rates = gyroscopic ? damping.map((row, i) => row.map((entry, j) => entry + gyroscopic[i][j])) : damping;
  const { rate, frequency } = fastest(mass, by_rates, stiffness);
  return { stability: Math.abs(rate) <= NEUTRAL * frequency ? "neutral" : rate < 0 ? "stable" : "unstable", rate };
}

/** The largest real part of the roots λ without damping: λ² = −κ for the eigenvalues κ of M⁻¹ K. */
function withoutDamping(mass, stiffness) {
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(solve(new Matrix(mass), new Matrix(stiffness)));
  return Math.max(...realEigenvalues.map((real, i) => Math.sqrt((Math.hypot(real, imaginaryEigenvalues[i]) - real) / 2)));
}

/** All roots λ of det(λ² M + λ B + K) = 0, where B holds damping and gyroscopic terms. */
function spectrum(mass, damping, stiffness) {
  const n = mass.length;
  const [from_damping, from_stiffness] = [damping, stiffness].map((part) => solve(new Matrix(mass), new Matrix(part)).mul(-1));
  const companion = Matrix.zeros(2 * n, 2 * n);
  const stiffest = from_stiffness.to1DArray().reduce((most, entry) => Math.max(most, Math.abs(entry)), 0);
  const scale = stiffest > STIFF ? Math.sqrt(stiffest) : 1; // of rates; none that makes the matrix orthogonal, where QR steps stand still
  companion.setSubMatrix(Matrix.eye(n).mul(scale), 0, n).setSubMatrix(from_stiffness.div(scale), n, 0).setSubMatrix(from_damping, n, n);
  return new EigenvalueDecomposition(companion);
}

/** Real part and frequency of the root with the largest real part. */
function fastest(mass, damping, stiffness) {
  const { realEigenvalues, imaginaryEigenvalues } = spectrum(mass, damping, stiffness);
  const rate = Math.max(...realEigenvalues);
  const frequencies = imaginaryEigenvalues.map((imaginary, i) => (Math.abs(imaginary) > 1e-9 * Math.hypot(realEigenvalues[i], imaginary) ? Math.abs(imaginary) : Infinity));
  const own = frequencies[realEigenvalues.indexOf(rate)];
  const frequency = Number.isFinite(own) ? own : Math.min(...frequencies); // the lowest, where the fastest does not oscillate
  return { rate, frequency: Number.isFinite(frequency) ? frequency : 0 };
}

/** Solves the linear system of a Newton step; null where the matrix is singular. */
export function solved(matrix, right) {
  try {
    return solve(new Matrix(matrix), Matrix.columnVector(right)).to1DArray();
  } catch {
    return null;
  }
}

/** The sign of a stiffness matrix's determinant, in which two states that meet at a fold differ. */
export function turning(matrix) {
  return Math.sign(determinant(new Matrix(matrix)));
}
