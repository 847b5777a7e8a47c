"""Interval Newton contractors, for many boxes at once: a box contains no root, exactly one, or all
its roots are in a smaller box.

For a system F of n equations, a box X, its middle m, enclosures J of the Jacobian over X and r of
|x − m| for x in X:

- every root in X satisfies 0 ∈ F(X), and |F(m)| ≤ |J| r row by row, the mean value theorem;
- with any matrix Y, A = Y J and b = Y F(m), every root is in N_i = m_i − (b_i ± Σ_{j≠i} |A_ij| r_j)
  / A_ii: interval Newton with a Jacobi step in each component (Hansen and Sengupta's method without
  the use of new components);
- if N is in the interior of X, there is exactly one root in X. There is one by Miranda's theorem,
  since component i of Y F has different signs on the two faces of X at the ends of x_i. There is no
  other since then min A_ii w_i > Σ_{j≠i} |A_ij| w_j for the half-widths w, so that every matrix in
  A is regular, and the difference of two roots would be in the kernel of one.

Y is an approximate inverse of the midpoint of J (preconditioning), or a permutation.
"""

from dataclasses import dataclass
from types import ModuleType

import numpy as np

from ..core.extensions import extension
from .interval_arrays import (
    EPS,
    TINY,
    BoolArray,
    FloatArray,
    Intervals,
    ends_around,
    quiet,
    rounded_outward,
    scaled,
    width_of,
)

compiled = extension("numerics._contractors")
#: Maximum number of unknowns of compiled code, 0 without it.
MOST = 0 if compiled is None else compiled.MOST


def available() -> bool:
    """True if the extension module was built."""
    return compiled is not None


def compiled_for(n: int) -> ModuleType | None:
    """The extension module, if it was built and can handle n unknowns."""
    return compiled if n <= MOST else None


@dataclass(frozen=True)
class Newton:
    """Result of an interval Newton step for N boxes."""

    ends: FloatArray  #: −low and high of N, (2, n, N), infinite where A_ii may be 0
    noise: FloatArray  #: half the width of Y F(m), which does not shrink with the box, (n, N)
    none: BoolArray  #: True if |Y F(m)| > |A| r in some row, so that there is no root, (N,)


def distance(ends: FloatArray, middle: FloatArray) -> FloatArray:
    """Upper bound of |x − m| over boxes (2, n, N), with m of shape (n, N)."""
    return np.maximum(*rounded_outward(ends_around(-middle, ends)))


def newton(values: Intervals, slopes: Intervals, middle: FloatArray, radius: FloatArray) -> Newton:
    """Preconditioned interval Newton step, from F(m), (n, N), J, (n, n, N), and m and r, (n, N)."""
    if (step := _compiled(values, slopes, middle, radius, rows=False)) is not None:
        return step
    Y = inverse(slopes.middle)
    A, b = product(Y, slopes.ends), product(Y, values.ends[:, :, None])[:, :, 0]
    return _newton_step(A, b, middle, radius)


def by_rows(
    values: Intervals, slopes: Intervals, middle: FloatArray, radius: FloatArray
) -> FloatArray:
    """Ends of the interval Newton step without preconditioning, Y = 1, (2, n, N)."""
    step = _compiled(values, slopes, middle, radius, rows=True)
    if step is None:
        step = _newton_step(slopes.ends, values.ends, middle, radius)
    return step.ends


def _compiled(
    values: Intervals, slopes: Intervals, middle: FloatArray, radius: FloatArray, rows: bool
) -> Newton | None:
    """The step by compiled code, None if it was not built; without preconditioning if ``rows``."""
    n, count = middle.shape
    extension = compiled_for(n)
    if extension is None:
        return None
    ends, noise, none = np.empty((2, n, count)), np.empty((n, count)), np.empty(count, np.bool_)
    given = map(np.ascontiguousarray, (values.ends, slopes.ends, middle, radius))
    extension.newton(*given, n, rows, ends, noise, none)
    return Newton(ends, noise, none)


def by_each_row(
    values: Intervals, slopes: Intervals, middle: FloatArray, radius: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Intersection of the steps with every cyclic permutation for Y: each unknown is contracted by
    each equation. Its ends, (2, n, N), and the mask of boxes without a root, (N,).

    If J is nearly singular, preconditioning mixes the rows so that none contracts any more. A
    single row still relates the unknowns along the direction of the kernel.
    """
    n = middle.shape[0]
    diagonal = np.arange(n)
    ends, none = np.full((2, *middle.shape), np.inf), np.zeros(middle.shape[1], dtype=bool)
    for shift in range(n):
        rows = (diagonal + shift) % n
        A, b = slopes.ends[:, rows], values.ends[:, rows]
        negative = A[1, diagonal, diagonal] < 0  # multiply these rows by −1: A_ii must be positive
        A, b = np.where(negative[:, None], A[::-1], A), np.where(negative, b[::-1], b)
        step = _newton_step(A, b, middle, radius)
        ends, none = np.fmin(ends, step.ends), none | step.none
    return ends, none


def _newton_step(A: FloatArray, b: FloatArray, middle: FloatArray, radius: FloatArray) -> Newton:
    """The step N from ends of A, (2, n, n, N), and b, (2, n, N)."""
    n = middle.shape[0]
    magnitude = np.maximum(A[0], A[1])
    diagonal = np.arange(n)
    own = magnitude[diagonal, diagonal] * radius
    magnitude[diagonal, diagonal] = 0.0
    # Rounding of the products and sums of non-negative numbers is at most n/2 units, that of the
    # bound one more; twice as much is added.
    others = (magnitude * radius).sum(axis=1) * (1 + 2 * (n + 1) * EPS) + TINY
    least, most = -A[0, diagonal, diagonal], A[1, diagonal, diagonal]
    ends = rounded_outward(b[::-1] + others)
    ends = rounded_outward(np.where(ends >= 0, ends / least, ends / most))
    ends = rounded_outward(ends_around(middle, ends))
    noise = 0.5 * width_of(b)
    none = np.logical_or.reduce(-np.minimum(b[0], b[1]) > rounded_outward(others + own, 2))
    return Newton(np.where(least > 0, ends, np.inf), noise, none)


def no_unit_vector(rest: Intervals, factors: Intervals) -> BoolArray:
    """Mask of boxes over which G + M u = 0 has no solution u of length 1 with two components: G of
    shape (n, N), M of shape (n, 2, N).

    For any matrix P, u = −P G − (P M − 1) u. Since |u_i| ≤ 1, |u + P G| is at most the row sum of
    |P M − 1|. P is the pseudo-inverse of the midpoint of M.
    """
    m = factors.middle
    gram = (m[:, :, None] * m[:, None]).sum(axis=0)
    P = (inverse(gram)[:, None] * m[None]).sum(axis=2)
    off = product(P, factors.ends)
    off[:, [0, 1], [0, 1]] = rounded_outward(
        off[:, [0, 1], [0, 1]] + np.array([1.0, -1.0])[:, None, None]
    )
    slack = np.maximum(off[0], off[1]).sum(axis=1) * (1 + 4 * EPS)
    u = Intervals(rounded_outward(product(P, rest.ends[:, :, None])[:, :, 0] + slack))
    square = u[0].squared() + u[1].squared()
    return (square.low > 1) | (square.high < 1)


def inside(inner: FloatArray, outer: FloatArray) -> BoolArray:
    """Mask of boxes (2, n, N) in the interior of others; for boxes around 0, radii may be given."""
    return np.logical_and.reduce(inner < outer, axis=(0, 1))


def within(inner: FloatArray, outer: FloatArray) -> BoolArray:
    """Mask of boxes that are subsets of others."""
    return np.logical_and.reduce(inner <= outer, axis=(0, 1))


def apart(one: FloatArray, other: FloatArray) -> BoolArray:
    """Mask of boxes without a common point."""
    return np.logical_or.reduce(one + other[::-1] < 0, axis=(0, 1))


def inverse(matrices: FloatArray) -> FloatArray:
    """Approximate inverses of matrices (n, n, N); the unit matrix for singular ones."""
    n = matrices.shape[0]
    if (extension := compiled_for(n)) is not None:
        out = np.empty(matrices.shape)
        extension.inverse(np.ascontiguousarray(matrices, dtype=float), n, out)
        return out
    with quiet():
        if n == 1:
            out = 1 / matrices
        elif n == 2:
            (a, b), (c, d) = matrices
            out = np.array([[d, -b], [-c, a]]) / (a * d - b * c)
        else:
            out = _inverse_by_elimination(matrices)
    good = np.isfinite(out).all(axis=(0, 1))
    return out if good.all() else np.where(good, out, np.eye(n)[:, :, None])


def _inverse_by_elimination(matrices: FloatArray) -> FloatArray:
    """Inverses by Gauss–Jordan elimination with partial pivoting."""
    n, _, count = matrices.shape
    every, finite = np.arange(count), np.isfinite(matrices).all(axis=(0, 1))
    unit = np.broadcast_to(np.eye(n)[:, :, None], matrices.shape)
    # Matrices with infinite entries are replaced by 0, which has no inverse either.
    work = np.concatenate([np.where(finite, matrices, 0.0), unit], axis=1)
    for k in range(n):
        pivot = k + np.abs(work[k:, k]).argmax(axis=0)
        row = work[pivot, :, every].T
        work[pivot, :, every] = work[k].T
        factors = work[:, k] / row[k]
        factors[k] = 0.0
        work -= factors[:, None] * row
        work[k] = row
    diagonal = np.arange(n)
    return work[:, n:] / work[diagonal, diagonal][:, None]


def product(Y: FloatArray, ends: FloatArray) -> FloatArray:
    """Ends of the product of Y, (n, n, N), and interval matrices, (2, n, columns, N)."""
    n = Y.shape[1]
    total = np.zeros(1)
    size = np.zeros(1)
    for k in range(n):
        part = scaled(ends[:, None, k], Y[None, :, k, None])
        total, size = total + part, size + np.abs(part)
    # n rounded products and n − 1 sums: an error below n · 2⁻⁵² × (sum of absolute values).
    return total + (size * ((n + 1) * EPS) + TINY)
