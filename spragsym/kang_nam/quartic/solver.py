"""All equilibria of arrays of points, with stability and error bounds: blocks of points in float64,
and what that can't settle with more digits.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import BackendError, ConvergenceError, one_of
from ...core.questions import NotInClosedForm
from ...core.type_variables import T
from ...generated.quantities import PARAMETERS
from ...models.load import USUAL
from ...models.parameters import as_count
from ...numerics.columns import reuse_memory
from ...numerics.interval_arrays import (
    BoolArray,
    ComplexArray,
    FloatArray,
    Int8Array,
    IntArray,
    quiet,
)
from ...results import EquilibriumType
from ...results.equilibria import Equilibria, Undecided
from ...statics.states import Linearizing
from .. import kernel
from ..parameters import Parameters
from . import block, compiled
from .block import COLUMNS, Slots

if TYPE_CHECKING:
    from ...statics.stability import Linearized

#: Points of a block, or up to twice as many: large beside the overhead of calls, and for NumPy to
#: compute in place, which it does from 256 KB on; small enough for the cache.
BLOCK = 1 << 15


@dataclass(frozen=True)
class _Closed(Linearizing):
    """The source of columns for equilibria in closed form."""

    p: Parameters
    contact: bool
    slots: Slots
    escalated: IntArray  #: indices of points that float64 did not settle
    fold: IntArray  #: indices of points that are folds

    @property
    def more(self) -> tuple[str, ...]:
        """Names of columns that only closed forms have."""
        return ("escalated", "fold")

    def column(self, name: str) -> NDArray[Any] | None:
        """A column of the kernel, or one derived from these; None for another name."""
        match name:
            case "escalated" | "fold":
                return self._flags(name)
            case "eigenvalues":
                return self._eigenvalues()
            case "marginal":
                return self._marginal()
        return self._padded(name) if name in COLUMNS else None

    def linearized(self, eq: Equilibria, states: tuple[IntArray, ...]) -> Linearized:
        """The linearization, with the sign of the growth by the theorem of
        ``derive/kang_nam/routh.py``.
        """
        found = super().linearized(eq, states)
        # It is proved for the article's friction law and no other damping.
        applies = self.contact and eq.parameters.model.where == USUAL
        return found.with_sign(self._grows(eq, states, found.sign)) if applies else found

    def _grows(self, eq: Equilibria, states: tuple[IntArray, ...], sign: Int8Array) -> Int8Array:
        """The sign of the growth of states in contact; as given where the theorem does not apply.

        A state is stable exactly if det K > 0 and K₁₂ K₂₁ > 0, that is, cos θ > 0 or σ sin θ cos θ
        + μ₀ L < 0. Of (27)'s types only divergence has det K < 0. What is undecided by the bound on
        the error of θ and L is as given.
        """
        mu0, sigma, speed, steepness = (
            np.broadcast_to(value[..., None], eq.undamped.shape)[states]
            for value in self.p.broadcast("mu0", "sigma", "V", "d")
        )
        theta, L = eq["theta"][states], eq["L"][states]
        c, s = kernel.cos_sin(theta)
        off = eq.error[states] * np.maximum(np.maximum(theta, L), 1.0) + 2.0**-50
        pull = sigma * s * c + mu0 * L
        # Rounding of the products is below the bound of the larger of both terms.
        off_pull = off * (sigma + mu0 * np.maximum(L, 1.0))
        apart = (c > off) | (pull < -off_pull)
        meets = (c < -off) & (pull > off_pull)
        code = eq.undamped[states]
        known = (mu0 > 0) & (speed > 0) & (steepness > 0) & ~eq.marginal[states]
        divergent = code == EquilibriumType.DIVERGENT
        verdict = np.select([divergent | meets, apart], [1, -1], sign)
        return np.where(known, verdict, sign).astype(np.int8)

    def _flags(self, name: str) -> BoolArray:
        flags = np.zeros(math.prod(self.p.shape), dtype=bool)
        flags[getattr(self, name)] = True
        return flags.reshape(self.p.shape)

    def _padded(self, name: str) -> NDArray[Any]:
        return np.moveaxis(
            self.slots.padded(name).T.reshape(self.slots.slots, *self.p.shape), 0, -1
        )

    def _marginal(self) -> BoolArray:
        """A mask of the two slots that hold the same state at a fold."""
        theta = self._padded("theta")
        alike = (theta[..., :-1] == theta[..., 1:]) & self._flags("fold")[..., None]
        none = np.zeros_like(alike[..., :1])
        return np.concatenate([alike, none], axis=-1) | np.concatenate([none, alike], axis=-1)

    def _eigenvalues(self) -> ComplexArray:
        """The four λ of (27)."""
        others = (value[..., None] for value in self.p.broadcast("mu0", "alpha", "sigma", "beta"))
        theta, L = map(self._padded, ("theta", "L"))
        with quiet():  # empty slots; parameters near the largest floats overflow
            trace, determinant, discriminant = kernel.invariants(
                *kernel.cos_sin(theta), L, *others, int(self.contact)
            )
            # λ² = −κ for the two eigenvalues κ of K, the larger first, the other from their
            # product.
            root = np.sqrt(discriminant.astype(complex))
            large = 0.5 * (trace + np.where(trace < 0, -root, root))
            frequencies = np.stack([np.sqrt(-large), np.sqrt(-determinant / large)], axis=-1)
        return np.concatenate([frequencies, -frequencies], axis=-1)


def equilibria(p: Parameters, contact: bool = True) -> Equilibria:
    """The closed form of :func:`spragsym.equilibria`: the quartic in t = tan(θ/2) of f(θ) = q sin θ
    F_x.

    Notes
    -----
    Source: (12)–(13) eliminated; stability by (27)–(28). The count is proved: the sign of the
    discriminant with a bound on its rounding error, each root by Newton–Kantorovich. Where float64
    can't, the point is solved again with more digits: in double-double arithmetic, and what that
    can't settle in intervals.
    """
    if not isinstance(contact, int | np.bool_):
        raise NotInClosedForm  # the general algorithm says what contact may be
    p.require("theta0", "mu0")
    out = Slots(math.prod(p.shape), 3 if contact else 4)
    backend = chosen()
    unsettled = _in_blocks(
        p,
        1 << (15 if backend is compiled else 16),
        lambda values, begin, size: begin + backend.solve(values, contact, out, begin, size),
    )
    escalated = np.concatenate([np.empty(0, dtype=int), *unsettled])
    fold, reasons = _escalate(p, contact, out, escalated) if escalated.size else (escalated, {})
    if reasons and not p.shape:
        raise ConvergenceError(reasons[0])
    decided = np.ones(p.shape, dtype=bool)
    decided.flat[list(reasons)] = False
    undecided = tuple(
        Undecided(
            tuple(map(int, np.unravel_index(number, p.shape))),
            (-math.inf,) * 2,
            (math.inf,) * 2,
            reason,
        )
        for number, reason in reasons.items()
    )
    remarks = (
        f"{len(reasons)} of {decided.size} points have no answer; the first: {one.reason}"
        for one in undecided[:1]
    )
    source = _Closed(p, contact, out, escalated, fold)
    return Equilibria(
        p, contact, out.count.reshape(p.shape), decided, undecided, tuple(remarks), source
    )


def count(p: Parameters) -> Int8Array:
    """The closed form of :func:`spragsym.count`.

    Notes
    -----
    Source: the sign of the discriminant of the quartic in t = tan(θ/2) and Descartes' rule say how
    many of its roots are positive, and Budan's theorem how many of three are in contact, all with
    bounds on rounding errors; what is left is solved.
    """
    p.require("theta0", "mu0")
    backend = chosen()
    blocks = _in_blocks(
        p,
        1 << (17 if backend is compiled else 19),
        lambda values, _, size: backend.count(values, size),
    )
    counts = np.concatenate([np.empty(0, dtype=np.int8), *blocks])
    open_ones = np.flatnonzero(counts == 0)
    if open_ones.size:
        open_points = Parameters(*(column.flat[open_ones] for column in p.broadcast(*PARAMETERS)))
        counts[open_ones] = equilibria(open_points).require_decided().count
    return counts.reshape(p.shape)


# ------------------------------------------------------------------------------------------------
# float64


def _in_blocks(
    p: Parameters, a_thread: int, work: Callable[[list[FloatArray], int, int], T]
) -> list[T]:
    """The results of ``work(values, begin, size)`` for all blocks of points, in order.

    Values are arrays of the block's size, or of one number. Every thread has at least ``a_thread``
    points.
    """
    given = [_column(p, name) for name in PARAMETERS]
    size = math.prod(p.shape)
    threads = max(1, min(_choice.threads, size // a_thread))
    # Every thread has the same number of blocks of equal length, at least BLOCK if possible.
    share = size / threads
    length = max(1, math.ceil(share / max(1, share // BLOCK)))

    def one(begin: int) -> T:
        part = slice(begin, begin + length)
        return work(
            [values if values.size == 1 else values[part] for values in given],
            begin,
            min(length, size - begin),
        )

    reuse_memory()
    begins = range(0, size, length)
    if threads > 1:
        with ThreadPoolExecutor(threads) as pool:
            return list(pool.map(one, begins))
    return [one(begin) for begin in begins]


def _column(p: Parameters, name: str) -> FloatArray:
    """A parameter as a contiguous array: of one number, or broadcast to the common shape."""
    value: FloatArray = p[name]
    return np.ascontiguousarray(
        value if value.size == 1 else np.broadcast_to(value, p.shape)
    ).reshape(-1)


# ------------------------------------------------------------------------------------------------
# more digits


def _escalate(
    p: Parameters, contact: bool, out: Slots, rows: IntArray
) -> tuple[IntArray, dict[int, str]]:
    """Solve points again, in double-double arithmetic, and those that this does not settle in
    interval arithmetic.

    Returns the rows of folds, and the reasons of points without an answer, by row.
    """
    given = [column.flat[rows] for column in p.broadcast(*PARAMETERS)]
    remaining = _solve_widely(given, contact, out, rows)
    folds: list[int] = []
    reasons: dict[int, str] = {}
    if remaining.size:
        from . import adaptive_precision

        for row in remaining:
            point = [float(value[row]) for value in given]
            try:
                found = adaptive_precision.equilibria(*point, contact=contact)
                columns = _columns(found, adaptive_precision.named(point))
            except ConvergenceError as reason:
                reasons[int(rows[row])] = str(reason)
                continue
            folds += [int(rows[row])] * any(state.fold for state in found)
            if found:
                out.put(rows[row : row + 1], len(found), columns)
    return np.array(folds, dtype=int), reasons


def _solve_widely(given: list[FloatArray], contact: bool, out: Slots, rows: IntArray) -> IntArray:
    """Solve the points of ``rows`` in double-double arithmetic; return the positions in ``rows`` of
    those that are not settled.
    """
    backend = chosen()
    again = Slots(rows.size, out.slots)
    open_ = []
    wide_block = 1 << 12  # smaller, since double-double arithmetic has more intermediate arrays
    for begin in range(0, rows.size, wide_block):
        values = [value[begin : begin + wide_block] for value in given]
        open_.append(begin + backend.solve_widely(values, contact, again, begin, values[0].size))
    out.put(rows, again.count, {name: again.padded(name).T for name in COLUMNS})
    return np.concatenate(open_)


def _columns(found: Sequence[Any], point: str) -> dict[str, NDArray[Any]]:
    """Columns of shape (states, 1) of states rounded to float64; the error includes the rounding.

    Raises
    ------
    ConvergenceError
        If a spring length is beyond float64.
    """
    from mpmath import log10  # of numbers beyond float64

    for state in found:
        if not math.isfinite(float(state.L)):  # |x| and |y| are at most 1 + L
            raise ConvergenceError(
                f"log10 L = {float(log10(state.L)):.6g} at an equilibrium of {point} is "
                "beyond float64; "
                "spragsym.precise carries it"
            )
    columns = {
        name: np.array([[float(getattr(state, name))] for state in found]) for name in COLUMNS
    }
    return columns | {"error": columns["error"] + 1.2e-16}


# ------------------------------------------------------------------------------------------------
# backends


@dataclass
class _Choice:
    name: str = "auto"
    threads: int = 1


_choice = _Choice()


def set_backend(name: str, threads: int = 1) -> None:
    """Choose how :func:`spragsym.equilibria` solves points; counts are the same, and digits within
    the bounds.

    Parameters
    ----------
    name : {"auto", "numpy", "compiled"}
        ``"auto"``, the default, takes the compiled solver where a C compiler was at hand on
        installation, as in the wheels, and NumPy otherwise.
    threads : int
        Threads that solve blocks of points; results do not depend on it.

    Raises
    ------
    ParameterError
        For another name or a number of threads below 1.
    BackendError
        For ``"compiled"`` where it was not built.

    Examples
    --------
    >>> set_backend("numpy")
    >>> get_backend()
    'numpy'
    >>> set_backend("auto")
    """
    one_of("backend", name, ("auto", "numpy", "compiled"))
    threads = as_count("threads", threads)
    if name == "compiled" and not compiled.available():
        raise BackendError(
            "the backend 'compiled' was not built, for want of a C compiler or for a "
            "derivation that has changed since; "
            "install spragsym again, with a compiler, or install a wheel"
        )
    _choice.name, _choice.threads = name, threads


def get_backend() -> str:
    """The name of the backend that :func:`set_backend` has set; ``"auto"`` by default.

    Returns
    -------
    str

    Examples
    --------
    >>> get_backend() in ("auto", "numpy", "compiled")
    True
    """
    return _choice.name


def chosen() -> ModuleType:
    """The module of the backend that is used."""
    return compiled if _choice.name != "numpy" and compiled.available() else block
