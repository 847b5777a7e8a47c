// Of which kind a state is, by the roots of its linearization without damping.

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

/** Largest real part of the roots with dampers and the slope of the friction law, from mass, damping and stiffness matrices. */
export function growth(mass, damping, stiffness) {
  const n = mass.length;
  const [from_damping, from_stiffness] = [damping, stiffness].map((part) => solve(new Matrix(mass), new Matrix(part)).mul(-1));
  const companion = Matrix.zeros(2 * n, 2 * n);
  companion.setSubMatrix(Matrix.eye(n), 0, n).setSubMatrix(from_stiffness, n, 0).setSubMatrix(from_damping, n, n);
  return Math.max(...new EigenvalueDecomposition(companion).realEigenvalues);
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
