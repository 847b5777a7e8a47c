"""Contractors of many boxes: no root inside, exactly one, or a smaller box that holds every root.

For a system F of n equations, a box X, its middle m, enclosures J of the Jacobian over X and r of
|x − m| for x in X:

- every root in X satisfies 0 ∈ F(X), and |F(m)| ≤ |J| r row by row, the mean value theorem;
- with any matrix Y, A = Y J and b = Y F(m), it lies in N_i = m_i − (b_i ± Σ_{j≠i} |A_ij| r_j) /
  A_ii, which is interval Newton with a step of Gauss and Seidel's method in each component;
- if N lies in the interior of X, there is exactly one root in X. There is one by Miranda's theorem,
  since component i of Y F has different signs on the two faces of X at the ends of x_i. There is no
  other since then min A_ii w_i > Σ_{j≠i} |A_ij| w_j for the half-widths w, so that every matrix in
  A is regular, and the difference of two roots would be in the kernel of one.
"""

from dataclasses import dataclass
from types import ModuleType

import numpy as np

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

try:
    from . import _contractors as compiled
except ImportError:  # there was no compiler
    compiled = None  # type: ignore[assignment]  # a module or nothing
#: How many unknowns compiled code has room for.
MOST = 0 if compiled is None else compiled.MOST


def available() -> bool:
    """Whether the extension module was built."""
    return compiled is not None


def compiled_for(n: int) -> ModuleType | None:
    """The extension module for so many unknowns, if it was built."""
    return compiled if n <= MOST else None


@dataclass(frozen=True)
class Newton:
    """One step for N boxes."""

    # −low and high of the operator's result, (2, n, N), infinite where A_ii may be 0
    ends: FloatArray
    noise: FloatArray  #: half the width of Y F(m), which does not shrink with the box, (n, N)
    none: BoolArray  #: where |Y F(m)| > |A| r in some row, so that there is no root, (N,)


def distance(ends: FloatArray, middle: FloatArray) -> FloatArray:
    """|x − m| over boxes of shape (2, n, N)."""
    return np.maximum(*rounded_outward(ends_around(-middle, ends)))


def newton(values: Intervals, slopes: Intervals, middle: FloatArray, reach: FloatArray) -> Newton:
    """The step of interval Newton, from F(m), shape (n, N), J, shape (n, n, N), m and r, shape (n,
    N).
    """
    if (step := _compiled(values, slopes, middle, reach, rows=False)) is not None:
        return step
    Y = inverse(slopes.middle)
    return _newton_step(
        product(Y, slopes.ends), product(Y, values.ends[:, :, None])[:, :, 0], middle, reach
    )


def by_rows(
    values: Intervals, slopes: Intervals, middle: FloatArray, reach: FloatArray
) -> FloatArray:
    """The operator with the unit matrix for Y: ends of its result."""
    step = _compiled(values, slopes, middle, reach, rows=True)
    return (_newton_step(slopes.ends, values.ends, middle, reach) if step is None else step).ends


def _compiled(
    values: Intervals, slopes: Intervals, middle: FloatArray, reach: FloatArray, rows: bool
) -> Newton | None:
    """The step by compiled code, if it was built, with an inverse or by ``rows``."""
    n, count = middle.shape
    extension = compiled_for(n)
    if extension is None:
        return None
    ends, noise, none = np.empty((2, n, count)), np.empty((n, count)), np.empty(count, np.bool_)
    extension.newton(
        np.ascontiguousarray(values.ends),
        np.ascontiguousarray(slopes.ends),
        np.ascontiguousarray(middle),
        np.ascontiguousarray(reach),
        n,
        rows,
        ends,
        noise,
        none,
    )
    return Newton(ends, noise, none)


def by_each_row(
    values: Intervals, slopes: Intervals, middle: FloatArray, reach: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """The operator with every cyclic permutation of the rows: each unknown by each row, without a
    matrix.

    Where J is nearly singular, its inverse mixes rows until none of them tells anything; but a
    single row tells how the unknowns depend on each other along the direction that is left. Gives
    ends, and boxes without a root, where some |F_i(m)| > |J_i| r.
    """
    n = middle.shape[0]
    every = np.arange(n)
    ends, none = np.full((2, *middle.shape), np.inf), np.zeros(middle.shape[1], dtype=bool)
    for shift in range(n):
        rows = (every + shift) % n
        A, b = slopes.ends[:, rows], values.ends[:, rows]
        turned = A[1, every, every] < 0  # a row times −1, so that its diagonal may be divided by
        step = _newton_step(
            np.where(turned[:, None], A[::-1], A), np.where(turned, b[::-1], b), middle, reach
        )
        ends, none = np.fmin(ends, step.ends), none | step.none
    return ends, none


def _newton_step(A: FloatArray, b: FloatArray, middle: FloatArray, reach: FloatArray) -> Newton:
    n = middle.shape[0]
    magnitude = np.maximum(A[0], A[1])
    diagonal = np.arange(n)
    own = magnitude[diagonal, diagonal] * reach
    magnitude[diagonal, diagonal] = 0.0
    # Products and sums of what is not negative lose at most n/2 units, the bound itself another
    # one; twice as much is added.
    radius = (magnitude * reach).sum(axis=1) * (1 + 2 * (n + 1) * EPS) + TINY
    least, most = -A[0, diagonal, diagonal], A[1, diagonal, diagonal]
    ends = rounded_outward(b[::-1] + radius)
    ends = rounded_outward(np.where(ends >= 0, ends / least, ends / most))
    ends = rounded_outward(ends_around(middle, ends))
    noise = 0.5 * width_of(b)
    none = np.logical_or.reduce(-np.minimum(b[0], b[1]) > rounded_outward(radius + own, 2))
    return Newton(np.where(least > 0, ends, np.inf), noise, none)


def no_unit_vector(rest: Intervals, factors: Intervals) -> BoolArray:
    """Boxes where G + M u = 0 for no unit vector u of two components: G of shape (n, N), M of shape
    (n, 2, N).

    With any P, u = −P G − (P M − 1) u, so that |u + P G| is at most the sum of |P M − 1| by rows,
    since |u_i| ≤ 1.
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
    """Boxes, shape (2, n, N), of which the one lies in the interior of the other; around 0 radii
    may stand for that.
    """
    return np.logical_and.reduce(inner < outer, axis=(0, 1))


def within(inner: FloatArray, outer: FloatArray) -> BoolArray:
    """Boxes of which the one lies in the other, its border included."""
    return np.logical_and.reduce(inner <= outer, axis=(0, 1))


def apart(one: FloatArray, other: FloatArray) -> BoolArray:
    """Boxes that have no common point."""
    return np.logical_or.reduce(one + other[::-1] < 0, axis=(0, 1))


def inverse(matrices: FloatArray) -> FloatArray:
    """Inverses of matrices of shape (n, n, N), roughly; the unit matrix where there is none."""
    n = matrices.shape[0]
    if (extension := compiled_for(n)) is not None:
        made = np.empty(matrices.shape)
        extension.inverse(np.ascontiguousarray(matrices, dtype=float), n, made)
        return made
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
    """By Gauss's and Jordan's elimination with the largest pivot of each column."""
    n, _, count = matrices.shape
    every, finite = np.arange(count), np.isfinite(matrices).all(axis=(0, 1))
    unit = np.broadcast_to(np.eye(n)[:, :, None], matrices.shape)
    # Of what is not finite there is no inverse, nor of a 0.
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
    """Ends of Y times a matrix of intervals of shape (2, n, columns, N)."""
    n = Y.shape[1]
    total = np.zeros(1)
    size = np.zeros(1)
    for k in range(n):
        part = scaled(ends[:, None, k], Y[None, :, k, None])
        total, size = total + part, size + np.abs(part)
    # n products, each rounded, and n − 1 sums: less than n units of 2⁻⁵² of the sum of the sizes.
    return total + (size * ((n + 1) * EPS) + TINY)
