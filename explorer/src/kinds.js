// Of which kind a state is, by the roots of its linearization, without damping and with it.

import { determinant, EigenvalueDecomposition, Matrix, solve } from "ml-matrix";

/** Squares of roots with an imaginary part below this share of the largest are real. */
const REAL = 1e-13;

/** "stable", "divergent" or "flutter", as the Python package says it, from mass and stiffness matrices. */
export function kindOf(mass, stiffness) {
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(solve(new Matrix(mass), new Matrix(stiffness)));
  const size = Math.max(...realEigenvalues.map((real, i) => Math.hypot(real, imaginaryEigenvalues[i])));
  const complex = imaginaryEigenvalues.map((imaginary) => Math.abs(imaginary) > REAL * size);
  if (complex.some(Boolean)) {
    return "flutter";
  }
  return realEigenvalues.some((real) => real < 0) ? "divergent" : "stable";
}

/** From where on eigenvalues are lost without a scale of rates. */
const STIFF = 1e6;
/** A growth rate below this share of the largest root is none that floats see. */
const SEEN = 1e-12;

/** What a page calls a state: "stable" only where nothing grows, with dampers and the slope of the friction law; and at what rate. */
export function wordOf(mass, damping, stiffness, undamped) {
  if (![damping, stiffness].flat(2).every(Number.isFinite)) {
    return { word: "marginal", rate: NaN };
  }
  if (!damping.flat().some(Boolean)) {
    return { word: undamped, rate: undamped === "stable" ? 0 : withoutDamping(mass, stiffness) };
  }
  const { rate, swings, size } = fastest(mass, damping, stiffness);
  const seen = Math.abs(rate) > SEEN * size;
  return { word: seen ? (rate < 0 ? "stable" : swings ? "flutter" : "divergent") : "marginal", rate };
}

/** The largest real part of the roots λ of λ² = −κ, of which the linearization has no others. */
function withoutDamping(mass, stiffness) {
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(solve(new Matrix(mass), new Matrix(stiffness)));
  return Math.max(...realEigenvalues.map((real, i) => Math.sqrt((Math.hypot(real, imaginaryEigenvalues[i]) - real) / 2)));
}

/** The root of largest real part, with dampers and the slope of the friction law, from mass, damping and stiffness matrices. */
function fastest(mass, damping, stiffness) {
  const n = mass.length;
  const [from_damping, from_stiffness] = [damping, stiffness].map((part) => solve(new Matrix(mass), new Matrix(part)).mul(-1));
  const companion = Matrix.zeros(2 * n, 2 * n);
  const stiffest = from_stiffness.to1DArray().reduce((most, entry) => Math.max(most, Math.abs(entry)), 0);
  const scale = stiffest > STIFF ? Math.sqrt(stiffest) : 1; // of rates; none that makes the matrix orthogonal, where QR steps stand still
  companion.setSubMatrix(Matrix.eye(n).mul(scale), 0, n).setSubMatrix(from_stiffness.div(scale), n, 0).setSubMatrix(from_damping, n, n);
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(companion);
  const rate = Math.max(...realEigenvalues);
  const size = Math.max(...realEigenvalues.map((real, i) => Math.hypot(real, imaginaryEigenvalues[i])));
  return { rate, swings: Math.abs(imaginaryEigenvalues[realEigenvalues.indexOf(rate)]) > 1e-9 * size, size };
}

/** Solves the linear system of a Newton step; null where the matrix is singular. */
export function solved(matrix, right) {
  try {
    return solve(new Matrix(matrix), Matrix.columnVector(right)).to1DArray();
  } catch {
    return null;
  }
}

/** The sign of a determinant, in which a state and the one that it meets at a fold differ. */
export function turning(matrix) {
  return Math.sign(determinant(new Matrix(matrix)));
}
