"""The lowest fold: the friction below which the state of small deformation jumps at no inclination."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray

from ..display import Shown
from ..exact.adaptive_bits import as_floats, decided, with_enough_bits
from ..exact.intervals import Arithmetic, Interval, arithmetic
from ..parameters import Parameters
from . import cusp_proofs, turning_proofs
from .fixed_parameters import FIXED
from .fold_enclosures import Point


@dataclass(frozen=True, eq=False)
class CriticalFriction(Shown, NDArrayOperatorsMixin):
    """The friction of the lowest fold, where it is, and of which kind; it calculates, compares and prints as ``mu0``.

    Numbers for one point, arrays of the shape of the parameters for many; angles are radians.

    ``kind`` is ``"cusp"``, or ``"turn"`` where the curve of folds turns back in μ₀, or ``"end"`` where it is lowest as θ₀
    goes to 0; it is empty where no fold ends that state, and then ``mu0`` is infinite and ``theta0`` NaN. ``error`` bounds
    \\|error\\| / max(1, \\|value\\|) of ``mu0`` and ``theta0``.
    """

    mu0: Any
    theta0: Any
    kind: Any
    error: Any

    @property
    def shape(self) -> tuple[int, ...]:
        """Of the parameters."""
        return np.shape(self.mu0)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.mu0, dtype=dtype, copy=copy)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        return getattr(ufunc, method)(*(one.mu0 if isinstance(one, CriticalFriction) else one for one in inputs), **options)

    def __float__(self) -> float:
        return float(self.mu0)

    def __round__(self, digits: int | None = None) -> Any:
        return round(self.mu0, digits)

    def __format__(self, spec: str) -> str:
        return format(self.mu0, spec)

    def __str__(self) -> str:
        return str(self.mu0)

    def __len__(self) -> int:
        return len(self.mu0)

    def __getitem__(self, index: Any) -> CriticalFriction:
        kind = self.kind[index]
        values = (self.mu0[index], self.theta0[index], self.error[index])
        mu0, theta0, error = values if np.ndim(values[0]) else map(float, values)
        return CriticalFriction(mu0, theta0, kind if np.ndim(kind) else str(kind), error)


def critical_friction(p: Parameters) -> CriticalFriction:
    """The lowest fold: the least friction at which the state of small deformation ends at any 0 < θ₀ < π.

    Below it that state, followed from μ₀ = 0 at any inclination, never jumps. It may be lower than every cusp, since a curve of
    folds that leaves its cusp upward may turn back below it; see :func:`cusp_friction`.

    Parameters
    ----------
    p : Parameters
        κ, α, σ, β, scalars or arrays; ``theta0`` and ``mu0`` are not used.

    Returns
    -------
    CriticalFriction
        To be used as the number or array ``mu0``, with its angle, kind and error; infinite where no fold ends that state: then no
        friction makes that state jump.

    Raises
    ------
    ParameterError
        For parameters that are missing.
    ConvergenceError
        At parameters so close to a coincidence that 6144 bits do not tell it from one.

    Notes
    -----
    Source: the ledger, "The lowest fold". Candidates are the cusps, the points f = f′ = f_θ₀ = 0 with f″ < 0, whose sin θ is a
    root of a polynomial of degree 9, and the folds at θ₀ = 0; all are isolated exactly, and the least is the answer. A cusp
    counts also where it is degenerate in (θ₀, μ₀). Of several that agree to 25 digits, a cusp is named first.

    Examples
    --------
    >>> found = critical_friction(Parameters.article())
    >>> print(found, found.kind, np.degrees(found.theta0).round(6))
    0.20093178180509003 cusp 68.020959
    >>> below = critical_friction(Parameters(kappa=0.02, alpha=0.5, sigma=2.0, beta=0.0))
    >>> print(below.kind)
    turn
    """
    columns = np.broadcast_arrays(*(getattr(p, name) for name in FIXED))
    found = [_lowest(*map(float, point)) for point in zip(*(column.flat for column in columns), strict=True)]
    shape = columns[0].shape
    if not shape:
        return CriticalFriction(*found[0])
    parts = list(zip(*found, strict=True)) or [()] * 4
    mu0, theta0, error = (np.array(parts[place], dtype=float).reshape(shape) for place in (0, 1, 3))
    return CriticalFriction(mu0, theta0, np.array(parts[2], dtype=np.str_).reshape(shape), error)


def _lowest(*values: float) -> tuple[float, float, str, float]:
    """Friction, angle, kind and error of one point."""
    arith = arithmetic()
    exact = tuple(map(Fraction, values))

    def attempt(bits: int) -> tuple[float, float, str, float]:
        least: tuple[Fraction, Point, str] | None = None
        for point, kind in _candidates(arith, exact, bits):
            above = arith.ends(point.parameters[1])[1]
            if least is None or above < least[0] - abs(least[0]) / 10**25:
                least = above, point, kind
        if least is None:
            return math.inf, math.nan, "", 0.0
        (mu0, theta0), error = as_floats(arith, (least[1].parameters[1], least[1].parameters[0]))
        return mu0, theta0, least[2], error

    return with_enough_bits(arith, 40, attempt, "the lowest fold")


def _candidates(arith: Arithmetic, exact: tuple[Fraction, ...], bits: int) -> Iterator[tuple[Point, str]]:
    for point in cusp_proofs.cusps(arith, exact, bits):
        if _leans_forward(arith, point.parameters[0]) and not _negative(arith, point.parameters[1]):
            yield point, "cusp"
    yield from ((point, "turn") for point in turning_proofs.turning_points(arith, exact, bits))
    yield from ((point, "end") for point in turning_proofs.level_folds(arith, exact, bits))


def _leans_forward(arith: Arithmetic, theta0: Interval) -> bool:
    """Whether 0 < θ₀ < π/2, of an angle in (−π, π]; exactly 0 and π are known as such."""
    if not any(arith.ends(theta0)) or decided(arith, theta0, "θ₀ = 0 on a cusp") < 0:
        return False
    return decided(arith, arith.pi() - 2 * theta0, "θ₀ = π/2 on a cusp") > 0


def _negative(arith: Arithmetic, mu0: Interval) -> bool:
    """Whether the friction of a cusp is negative; 0, that of an upright one with α = 0, is known exactly."""
    return any(arith.ends(mu0)) and decided(arith, mu0, "μ₀ = 0 on a cusp") < 0
