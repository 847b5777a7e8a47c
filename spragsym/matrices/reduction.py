"""Reduction of models of matrices by modes and static corrections."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from scipy.linalg import eigh
from scipy.linalg.lapack import zgetrf, zgetrs
from scipy.sparse import csc_array, issparse
from scipy.sparse.linalg import LinearOperator, eigsh, splu

from ..numerics.definite import Pencil
from ..numerics.interval_arrays import ComplexArray, FloatArray


def basis(given: dict[str, Any], modes: int, corrections: int) -> tuple[FloatArray, float]:
    """A basis of modes without friction and damping and of static corrections to what the other
    matrices do, orthonormal by M, and the highest frequency of the modes in rad/s.

    Source: corrections are the largest principal directions of K⁻¹ F Φ and K⁻¹ Fᵀ Φ for friction
    and further stiffnesses F, and of K⁻¹ C Φ ω for dampings C, beside the modes Φ.
    """
    M, K = given["M"], 0.5 * (given["K"] + given["K"].T)
    # A shift far below the modes solves for bodies that nothing holds as well.
    shift = 1e-7 * float(abs(K.diagonal()).sum() / abs(M.diagonal()).sum())
    solve = _solver(K + shift * M)
    if issparse(M) and modes < M.shape[0] // 2:
        inverse = LinearOperator(M.shape, matvec=solve, dtype=float)
        squares, shapes = eigsh(K, modes, M, sigma=-shift, OPinv=inverse)
    else:
        dense = [one.toarray() if issparse(one) else one for one in (K, M)]
        squares, shapes = eigh(*dense, subset_by_index=(0, modes - 1))
    rates = np.sqrt(np.maximum(squares, 0.0))
    forces = list[FloatArray]()
    for name, one in given.items():
        if name in ("M", "K"):
            continue
        for each in (one, one.T):
            force = each @ shapes
            forces.append(force * rates if name in ("C", "G") else force)
    static = solve(np.hstack(forces))
    for _ in range(2):
        static -= shapes @ (shapes.T @ (M @ static))
    scales = np.sqrt(np.einsum("ij,ij->j", static, M @ static))
    large = scales > 1e-12 * scales.max(initial=0.0)
    static = static[:, large]
    squares, mixed = np.linalg.eigh(static.T @ (M @ static))
    kept = np.flatnonzero(squares > 1e-12 * squares.max(initial=0.0))[::-1][:corrections]
    static = static @ (mixed[:, kept] / np.sqrt(squares[kept]))
    return np.hstack([shapes, static]), float(rates[-1])


def _solver(matrix: Any) -> Callable[[FloatArray], FloatArray]:
    if issparse(matrix):
        solve: Callable[[FloatArray], FloatArray] = splu(csc_array(matrix)).solve
        return solve
    from scipy.linalg import cho_factor, cho_solve

    factor = cho_factor(matrix)
    return lambda right: cho_solve(factor, right)


def onset_of_whole(
    whole: Pencil, growth: float, guess: tuple[float, float, int], space: FloatArray
) -> float:
    """The parameter of an onset of a large model, from that of a reduced one; NaN if it is lost.

    ``guess`` has its value, |Im λ| and direction there; ``space`` is spanned by right and left
    vectors of the two modes that are nearest.

    Source: G. Sleijpen and H. van der Vorst, SIAM Review 42 (2000) 267, with an exact
    preconditioner. Both modes are kept: Newton's method for one of them fails where they merge.
    """
    value, rate, direction = guess
    for turn in range(12):
        space = np.linalg.qr(space)[0]
        small = whole.within(space)
        found = _nearest_onset(small, growth, value, rate, direction)
        if found is None:
            break
        moved, (value, rate) = abs(found[0] - value), found
        if turn and moved <= 1e-11 * abs(value):
            return value
        s = complex(growth, rate)
        away = 1e-4 * float(np.abs(small.nearest(value, s)[0]).max() or 1.0)
        solvers = inverse(whole.dynamic_stiffness(s + away, value))
        parts = list[ComplexArray]()
        for every, few, solve in zip(
            (whole, whole.transposed), (small, small.transposed), solvers, strict=True
        ):
            for own, q in zip(*few.nearest(value, s), strict=True):
                shape = space @ q
                parts += [shape, solve(every.dynamic_stiffness(own, value) @ shape)]
        both = np.array([one / max(float(np.linalg.norm(one)), 1e-300) for one in parts]).T
        space = np.hstack([both.real, both.imag])
    return float("nan")


def _nearest_onset(
    small: Pencil, growth: float, value: float, rate: float, direction: int
) -> tuple[float, float] | None:
    """The value and |Im λ| of the onset that is nearest to a value, by LAPACK and bisection."""

    def growing(t: float) -> int:
        own = small.eigenbasis(t)[0]
        return int(((own.real > growth) & (np.abs(own.imag - rate) <= 0.05 * rate)).sum())

    steps = 0.2 * (abs(value) or 1.0) * np.append(0.0, 10.0 ** np.arange(-9.0, 0.1, 0.25))
    before = [growing(value)] * 2
    for near, far in itertools.pairwise(steps):
        for place, side in enumerate((1, -1)):
            ends, count = [value + side * near, value + side * far], growing(value + side * far)
            if (count - before[place]) * side * direction > 0:
                for _ in range(60):
                    middle = 0.5 * (ends[0] + ends[1])
                    ends[int(growing(middle) != before[place])] = middle
                own = small.eigenbasis(ends[0])[0]
                at = np.abs(own - complex(growth, rate)).argmin()
                return ends[0], float(abs(own[at].imag))
            before[place] = count
    return None


def inverse(L: Any) -> tuple[Callable[..., ComplexArray], Callable[..., ComplexArray]]:
    """What solves a system of L, and one of Lᵀ; LinAlgError if it is singular."""
    if issparse(L):
        try:
            factor = splu(csc_array(L))
        except RuntimeError as error:
            raise np.linalg.LinAlgError(str(error)) from error
        return factor.solve, partial(factor.solve, trans="T")
    lu, pivots, singular = zgetrf(L)
    if singular:
        raise np.linalg.LinAlgError("it is singular")
    return (
        lambda right: zgetrs(lu, pivots, right)[0],
        lambda right: zgetrs(lu, pivots, right, trans=1)[0],
    )
