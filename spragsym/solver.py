"""All equilibria of many parameter points, each with its stability and a bound on its error."""

from __future__ import annotations

import enum
import itertools
import math
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import backends, kernel
from .display import Result
from .errors import ConvergenceError
from .generated import stability as _stability
from .parameters import NAMES, FloatArray, Parameters

#: Digits that every equilibrium has: |error| ≤ TOLERANCE · max(1, |value|).
TOLERANCE = 1e-12
#: Points solved at a time, so that intermediate arrays stay in cache.
BLOCK = 8192
#: The same for the compiled solver.
COMPILED_BLOCK = 1 << 14


class Stability(enum.IntEnum):
    """Type of an equilibrium by the roots λ of det(λ² I + K) = 0, (27)."""

    NONE = 0  #: no equilibrium in this slot
    STABLE = 1  #: all λ imaginary
    DIVERGENT = 2  #: a real positive λ
    FLUTTER = 3  #: a complex pair with a positive real part


@dataclass(frozen=True)
class Equilibria(Result):
    """Every equilibrium of every parameter point.

    Attributes
    ----------
    count : ndarray of int
        Number of equilibria; the shape of the parameters.
    theta, L, x, y : ndarray
        Direction of the spring in radians, its length and the displacement, over L_0. One more axis than the parameters, of
        length 3 in contact and 4 in lift-off; ascending ``theta``, NaN beyond ``count``.
    stability : ndarray of int8
        Codes of :class:`Stability`, of the shape of ``theta``.
    error : ndarray
        Bound on |error| / max(1, |value|) of theta, L, x and y, the largest of the four.
    escalated : ndarray of bool
        Points that float64 could not settle and more digits did.
    fold : ndarray of bool
        Points that are a fold to the last digit that could be tried: one state stands in two slots.
    undecided : ndarray of bool
        Points without an answer, whose ``count`` is 0 and whose slots are empty; :meth:`reason` says why.
    reasons : dict
        The reason for each of them, by its position in ``count.flat``.
    """

    parameters: Parameters
    contact: bool
    count: NDArray[np.int64]
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    stability: NDArray[np.int8]
    error: FloatArray
    escalated: NDArray[np.bool_]
    fold: NDArray[np.bool_]
    undecided: NDArray[np.bool_]
    reasons: Mapping[int, str]

    def reason(self, *index: int) -> str:
        """Why the point of that index has no answer; empty where it has one."""
        return self.reasons.get(int(np.arange(self.count.size).reshape(self.count.shape)[index]), "")

    def decided(self) -> Equilibria:
        """Itself, for what needs all points; :class:`ConvergenceError` with the first reason where one has no answer."""
        for reason in self.reasons.values():
            raise ConvergenceError(reason)
        return self

    @cached_property
    def eigenvalues(self) -> NDArray[np.complex128]:
        """The four λ of (27) at every equilibrium, on one more axis; NaN beyond ``count``."""
        p = self.parameters
        mu0, alpha, sigma, beta = (value[..., None] for value in p.broadcast("mu0", "alpha", "sigma", "beta"))
        K = _stability.stiffness(np.cos(self.theta), np.sin(self.theta), self.L, mu0, alpha, sigma, beta, int(self.contact))
        trace, determinant, discriminant = _stability.invariants(*K[0], *K[1])
        # λ² = −κ for the two eigenvalues κ of K, the larger first, the other from their product.
        root = np.sqrt(discriminant.astype(complex))
        large = 0.5 * (trace + np.where(trace < 0, -root, root))
        with np.errstate(invalid="ignore"):  # empty slots
            small = determinant / large
        frequencies = np.stack([np.sqrt(-large), np.sqrt(-small)], axis=-1)
        return np.concatenate([frequencies, -frequencies], axis=-1)


def equilibria(p: Parameters, contact: bool = True) -> Equilibria:
    """All equilibria: steady sliding in contact, or at rest in lift-off.

    Parameters
    ----------
    p : Parameters
        Any shape; ``theta0`` and ``mu0`` are needed.
    contact : bool
        True for n̄ = 1 (y < 0), False for n̄ = 0 (y ≥ 0).

    Returns
    -------
    Equilibria
        One or three in contact, up to four in lift-off, with |error| ≤ 1e-12 max(1, |value|). Points of an array that have no
        answer are marked ``undecided``.

    Raises
    ------
    ConvergenceError
        For a single point that lies on a border that no number of digits can settle, as where L = 0, or whose length or
        displacement float64 can't carry.

    Notes
    -----
    Source: the quartic in t = tan(θ/2) of f(θ) = q sin θ F_x, (12)–(13) eliminated; stability by (27)–(28). The count is proved:
    the sign of the discriminant with a bound on its rounding error, each root by Newton–Kantorovich. Where float64 can't, the
    point is solved again with more digits: extended precision where the machine has it, then intervals.

    Examples
    --------
    >>> import numpy as np
    >>> eq = equilibria(Parameters.article(theta0=np.radians([30.0, 49.0])))
    >>> eq.count
    array([3, 1])
    >>> eq.stability[0]
    array([1, 2, 1], dtype=int8)
    >>> print(np.round(eq.x[1], 6))
    [1.217424      nan      nan]
    """
    p.require("theta0", "mu0")
    shape, slots = p.shape, 3 if contact else 4
    size = int(np.prod(shape))
    out = _Slots(size, slots)
    backend, threads = backends.chosen(size)
    if backend == "numba":
        method, length, given = _by_numba, COMPILED_BLOCK, _given(p, p.theta0)
    else:
        method, length, given = _by_numpy, BLOCK, _given(p, *_directions(p.theta0))

    def block(begin: int) -> NDArray[np.int64]:
        end = min(begin + length, size)
        with np.errstate(all="ignore"):
            return begin + method([_slice(value, begin, end) for value in given], contact, out.rows(begin, end))

    # glibc gives freed memory back to the system and faults it in again until it has seen one large block freed.
    np.empty(1 << 19)
    begins = range(0, size, length)
    if threads > 1 and len(begins) > 1:
        with ThreadPoolExecutor(threads) as pool:
            unsettled = list(pool.map(block, begins))
    else:
        unsettled = [block(begin) for begin in begins]
    left = np.concatenate([np.empty(0, dtype=np.int64), *unsettled])
    reasons = _escalate(p, contact, out, left) if left.size else {}
    if reasons and not shape:
        raise ConvergenceError(reasons[0])
    undecided = np.zeros(size, dtype=np.bool_)
    undecided[list(reasons)] = True
    return Equilibria(
        parameters=p,
        contact=contact,
        count=out.count.reshape(shape),
        **{
            name: np.moveaxis(getattr(out, name).T.reshape(slots, *shape), 0, -1)
            for name in ("theta", "L", "x", "y", "stability", "error")
        },
        escalated=out.escalated.reshape(shape),
        fold=out.fold.reshape(shape),
        undecided=undecided.reshape(shape),
        reasons=reasons,
    )


# ------------------------------------------------------------------------------------------------- the storage


class _Slots:
    """Result arrays, one row a point, in memory slot by slot, since most points use only the first."""

    _COLUMNS = ("theta", "L", "x", "y", "stability", "error", "count", "escalated", "fold")

    def __init__(self, size: int, slots: int) -> None:
        self.theta, self.L, self.x, self.y, self.error = (np.full((slots, size), np.nan).T for _ in range(5))
        self.stability = np.zeros((slots, size), dtype=np.int8).T
        self.count = np.zeros(size, dtype=np.int64)
        self.escalated = np.zeros(size, dtype=np.bool_)
        self.fold = np.zeros(size, dtype=np.bool_)

    def rows(self, begin: int, end: int) -> _Slots:
        """A view of some rows."""
        view = object.__new__(_Slots)
        for name in self._COLUMNS:
            setattr(view, name, getattr(self, name)[begin:end])
        return view

    def put(self, rows: NDArray[np.int64], other: _Slots) -> None:
        """Copy all rows of ``other`` into the given rows."""
        for name in self._COLUMNS:
            getattr(self, name)[rows] = getattr(other, name)


@dataclass(frozen=True)
class Columns:
    """Parameters of one block, each an array of its length or one number for all."""

    size: int
    cos0: Any
    sin0: Any
    mu0: Any
    kappa: Any
    alpha: Any
    sigma: Any
    beta: Any

    def values(self) -> tuple[Any, ...]:
        """In the order that the kernel takes."""
        return self.cos0, self.sin0, self.mu0, self.kappa, self.alpha, self.sigma, self.beta

    def take(self, rows: NDArray[Any]) -> Columns:
        """Some of the points."""
        return Columns(int(rows.size), *(value[rows] if np.ndim(value) else value for value in self.values()))


def _given(p: Parameters, *angles: NDArray[np.float64]) -> list[Any]:
    """θ₀, or its cosine and sine, and the other parameters, each a float or an array of the common shape."""
    return [
        value.item() if value.size == 1 else value.reshape(-1) if value.shape == p.shape else np.broadcast_to(value, p.shape)
        for value in (*angles, p.mu0, p.kappa, p.alpha, p.sigma, p.beta)
    ]


def _directions(theta0: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """cos θ₀ and sin θ₀, once for each θ₀ given, before they are broadcast; block by block, which stays in the cache."""
    cos0, sin0 = np.empty(theta0.size), np.empty(theta0.size)
    for begin in range(0, theta0.size, BLOCK):
        some = slice(begin, begin + BLOCK)
        cos0[some], sin0[some] = kernel.cosine_and_sine(theta0.flat[some])
    return cos0.reshape(theta0.shape), sin0.reshape(theta0.shape)


def _slice(value: Any, begin: int, end: int) -> Any:
    """A range of points in C order; of a float, the float, and of an array that is broadcast, a copy of that range only."""
    if isinstance(value, float):
        return value
    return value[begin:end] if value.ndim == 1 else value.flat[begin:end]


# ----------------------------------------------------------------------------------------------- one float type


def solve(columns: Columns, contact: bool, out: _Slots, dtype: type[np.floating[Any]]) -> NDArray[np.int64]:
    """Solve a block in one float type, write what is settled to ``out``, and return the indices of what is not."""
    n, nbar = columns.size, int(contact)
    u = dtype(np.finfo(dtype).eps / 2)
    values = columns.values()
    trig = np.broadcast_arrays(*kernel.f_coefficients(*values, nbar), *kernel.f_magnitudes(*values, nbar), np.empty(n))[:-1]
    a, b, d, m, a_sum, d_sum = trig
    D, D_error = kernel.discriminant(a, b, d, m, a_sum, d_sum, u)
    p1, q1, p2, q2 = kernel.factors(a, b, d, m)
    large, small, _ = kernel.root_pair(p1, q1)

    def at(ts: list[Any], rows: NDArray[np.int64] | None = None) -> list[Root]:
        some, points = (trig, values) if rows is None else ([value[rows] for value in trig], columns.take(rows).values())
        return [Root(t, *kernel.at_root(*(t, *some, *points, nbar, u))) for t in ts]

    # The first factor has one positive and one negative root. The second matters where it may have real roots; in contact only
    # where these may be positive, since no equilibrium in contact has sin θ < 0.
    ts = [np.where(large > 0.0, large, small)]
    paired = ~(D > D_error)
    if contact:
        paired &= ~kernel.lone(a, b, d, m, a_sum, d_sum, u)
    else:
        ts.insert(0, np.where(large > 0.0, small, large))
    settled = _fill(out, slice(None), at(ts), ~paired, contact, u)
    pairs = np.flatnonzero(paired)
    if pairs.size:
        one, other, _ = kernel.root_pair(p2[pairs], q2[pairs])
        roots = _ascending([*(t[pairs] for t in ts), one, other])
        settled[pairs] = _fill(out, pairs, at(roots, pairs), True, contact, u)
    return np.flatnonzero(~(settled & kernel.normal(*values[1:])))


def _by_numpy(values: list[Any], contact: bool, out: _Slots) -> NDArray[np.int64]:
    """:func:`solve` in float64."""
    return solve(Columns(out.count.size, *values), contact, out, np.float64)


def _by_numba(values: list[Any], contact: bool, out: _Slots) -> NDArray[np.int64]:
    """The same by the compiled kernel."""
    from . import compiled

    return compiled.solve(values, contact, TOLERANCE, out)


def _ascending(values: list[Any]) -> list[Any]:
    """Each point's values in ascending order: bubble sort over arrays, for three or four of them. NaN spreads."""
    values = list(values)
    for last in range(len(values) - 1, 0, -1):
        for i in range(last):
            values[i], values[i + 1] = np.minimum(values[i], values[i + 1]), np.maximum(values[i], values[i + 1])
    return values


class Root(NamedTuple):
    """tan(θ/2), and what :func:`spragsym.kernel.at_root` returns there."""

    t: Any
    L: Any
    x: Any
    y: Any
    radius: Any
    error: Any
    member: Any
    outsider: Any
    code: Any

    def parts(self, rounding: float) -> tuple[tuple[str, Any], ...]:
        """Columns of the result and their values."""
        return (
            ("theta", 2.0 * np.arctan(self.t)), ("L", self.L), ("x", self.x), ("y", self.y), ("error", self.error + rounding),
            ("stability", self.code),
        )  # fmt: skip


def _fill(out: _Slots, rows: Any, roots: list[Root], wanted: Any, contact: bool, u: np.floating[Any]) -> NDArray[np.bool_]:
    """Put the equilibria among the roots of each wanted point, given in ascending order, into its slots.

    Returns which points are settled: every root an equilibrium with its digits or certainly none, all of them different, and
    in contact an odd number of equilibria.
    """
    rounding = 0.0 if u > 1e-17 else 1.2e-16  # what is lost when a wider type is stored as float64
    settled: NDArray[np.bool_] = wanted
    count: Any = 0
    for root in roots:
        settled = settled & ((root.member & (root.error <= TOLERANCE - rounding) & (root.code > 0)) | root.outsider)
        count = count + root.member
    if contact:
        settled = settled & (count % 2 == 1) & (roots[0].t > 0.0)
    for below, above in itertools.pairwise(roots):
        # Two proved roots are different when the intervals that hold them are.
        settled = settled & kernel.apart(below.t, below.radius, above.t, above.radius)

    if len(roots) == 1:
        # What is not settled is written again by whoever settles it: in contact there is always a first equilibrium.
        for name, values in roots[0].parts(rounding):
            getattr(out, name)[rows, 0] = values
    else:
        index = np.arange(len(out.count))[rows]
        every = settled & (count == len(roots))
        _scatter_all(out, index, roots, np.flatnonzero(every), rounding)
        _scatter(out, index, roots, settled & ~every, rounding)
    out.count[rows] = np.where(settled, count, 0)
    return settled


def _scatter_all(out: _Slots, index: NDArray[np.int64], roots: list[Root], here: NDArray[np.int64], rounding: float) -> None:
    """Points whose roots are all equilibria."""
    for slots in zip(*(root.parts(rounding) for root in roots), strict=True):
        getattr(out, slots[0][0])[index[here], : len(roots)] = np.stack([values[here] for _, values in slots], axis=-1)


def _scatter(out: _Slots, index: NDArray[np.int64], roots: list[Root], chosen: NDArray[np.bool_], rounding: float) -> None:
    """Points some of whose roots are no equilibria: each goes to the first free slot."""
    place = np.zeros(chosen.size, dtype=np.int64)
    for root in roots:
        here = np.flatnonzero(chosen & root.member)
        for name, values in root.parts(rounding):
            getattr(out, name)[index[here], place[here]] = values[here]
        place += root.member


# -------------------------------------------------------------------------------------------------- more digits


def _escalate(p: Parameters, contact: bool, out: _Slots, rows: NDArray[np.int64]) -> dict[int, str]:
    """Solve the given points again, in the machine's widest type and then, what that can't settle, in intervals.

    Returns why points are left without an answer, by row.
    """
    theta0, mu0, kappa, alpha, sigma, beta = (
        np.broadcast_to(getattr(p, name), p.shape).flat[rows]
        for name in NAMES
    )
    out.escalated[rows] = True
    left = np.arange(rows.size)
    if _extended_precision():
        wide = theta0.astype(np.longdouble)
        columns = Columns(
            rows.size, np.cos(wide), np.sin(wide), *(value.astype(np.longdouble) for value in (mu0, kappa, alpha, sigma, beta))
        )
        again = _Slots(rows.size, out.theta.shape[-1])
        again.escalated[:] = True
        with np.errstate(all="ignore"):
            left = solve(columns, contact, again, np.longdouble)
        out.put(rows, again)
    reasons = {}
    if left.size:
        from . import ladder

        for row in left:
            point = tuple(float(value[row]) for value in (theta0, mu0, kappa, alpha, sigma, beta))
            try:
                _store(out, int(rows[row]), point, ladder.equilibria(*point, contact=contact))
            except ConvergenceError as reason:
                _clear(out, int(rows[row]))
                reasons[int(rows[row])] = str(reason)
    return reasons


def _extended_precision() -> bool:
    """Whether long double is the 80-bit type, with its 64-bit significand."""
    return bool(np.finfo(np.longdouble).nmant == 63)


def _clear(out: _Slots, row: int) -> None:
    """Empty slots, whatever an attempt with fewer digits has left there."""
    for values in (out.theta, out.L, out.x, out.y, out.error):
        values[row] = np.nan
    out.stability[row], out.count[row], out.fold[row] = 0, 0, False


def _store(out: _Slots, row: int, point: tuple[float, ...], found: Any) -> None:
    """States rounded to float64, by at most half a unit in the last place, which the error includes."""
    _clear(out, row)
    out.count[row] = len(found.states)
    out.fold[row] = found.fold
    for slot, state in enumerate(found.states):
        out.theta[row, slot], out.L[row, slot], out.x[row, slot], out.y[row, slot] = state.theta, state.L, state.x, state.y
        out.stability[row, slot] = state.stability
        out.error[row, slot] = float(state.error) + 1.2e-16
        if not np.isfinite(out.L[row, slot] + out.x[row, slot] + out.y[row, slot]):
            named = ", ".join(f"{name}={value}" for name, value in zip(NAMES, point, strict=True))
            raise ConvergenceError(
                f"log10 L = {_log10(state.L):.6g} at an equilibrium of {named} is beyond float64; spragsym.precise carries it"
            )


def _log10(value: Any) -> float:
    """The logarithm of an mpf, of any size."""
    _, mantissa, exponent, _ = value._mpf_
    return math.log10(mantissa) + int(exponent) * math.log10(2)
