"""The same answers with as many digits as wanted, from parameters taken exactly, each with a proof.

A parameter is an int, a str such as ``"0.007"`` or ``"7/1000"``, a :class:`fractions.Fraction`, an mpmath number or a float, and
is taken to be exactly the rational number that it writes.

Results are ``mpmath.mpf`` with every bit that they were computed with, some more than the digits asked for; nothing is rounded
once a bound is known. The bound is on the numbers as they stand, whatever ``mpmath.mp.dps`` is. But what mpmath makes of them is
rounded to the ``dps`` of that moment: set it before subtracting two results, and before ``+value``, which rounds as well. No
precision of mpmath's or of python-flint's is set or read here, so results depend neither on them nor on other threads.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from typing import Any, ClassVar, TypeAlias

import mpmath

from .errors import ParameterError, ParameterTypeError
from .exact.adaptive_bits import with_enough_bits
from .exact.decimals import Decimal, around, exactly
from .exact.intervals import Arithmetic, Interval, arithmetic, as_mpf, rounded_up
from .exact.polynomials import Undecided
from .kang_nam.catastrophe import cusp_proofs
from .kang_nam.catastrophe.fold_enclosures import Point
from .kang_nam.statics import adaptive_precision
from .parameters import RANGES, Range
from .results.equilibria import Stability

#: What is taken exactly.
Exact: TypeAlias = int | float | str | Fraction | mpmath.mpf

#: Digits beyond which a request is taken for a mistake.
MOST_DIGITS = 1000
_NUMBER = re.compile(r"\s*[+-]?(\d{1,400}(/\d{1,400})?|(\d{1,400}\.?\d{0,400}|\.\d{1,400})([eE][+-]?\d{1,3})?)\s*")


class _Written:
    """Gives a dataclass its numbers in decimals, and a ``repr`` that is made of these."""

    #: Names of the numbers.
    NUMBERS: ClassVar[tuple[str, ...]]

    def _bound(self, value: mpmath.mpf) -> Fraction:
        raise NotImplementedError

    def decimals(self, digits: int | None = None) -> dict[str, Decimal]:
        """The numbers in decimals, each with a bound on its error that covers the rounding to these digits too.

        ``digits`` are significant ones; by default as many as are proved.
        """
        return {name: around(getattr(self, name), self._bound(getattr(self, name)), digits) for name in self.NUMBERS}

    def __repr__(self) -> str:
        numbers = [f"{name}={decimal}" for name, decimal in self.decimals().items()]
        others = [
            f"{field.name}={getattr(self, field.name)!r}"
            for field in fields(self)  # type: ignore[arg-type]
            if field.name not in (*self.NUMBERS, "error", "radius")
        ]
        return f"{type(self).__name__}({', '.join([*numbers, *others])})"


@dataclass(frozen=True, repr=False)
class PreciseEquilibrium(_Written):
    """One equilibrium; ``theta`` in radians, ``error`` a proved bound on |error| / max(1, |value|) of the four as they stand.

    ``print`` writes decimals with bounds that hold for these digits, and so does :meth:`decimals`. ``fold`` says that it is a
    fold to the last digit that could be tried; only then may ``error`` be above 10^−dps.
    """

    theta: mpmath.mpf
    L: mpmath.mpf
    x: mpmath.mpf
    y: mpmath.mpf
    stability: Stability
    error: mpmath.mpf
    fold: bool

    NUMBERS = ("theta", "L", "x", "y")

    def _bound(self, value: mpmath.mpf) -> Fraction:
        return exactly(self.error) * max(Fraction(1), abs(exactly(value)))


@dataclass(frozen=True)
class _Degrees:
    """An angle that is exact in degrees, and in radians an interval."""

    value: Fraction

    def __call__(self, arith: Arithmetic) -> Interval:
        return arith.exact(self.value / 180) * arith.pi()

    def __str__(self) -> str:
        return f"{self.value} degrees"


def as_exact(name: str, value: Exact, allowed: Range) -> Fraction:
    """The rational number that ``value`` writes, or an error that names the argument."""
    if isinstance(value, bool) or not isinstance(value, int | float | str | Fraction | mpmath.mpf):
        raise ParameterTypeError(
            f"{name} = {value!r} is of type {type(value).__name__}; give an int, a str, a Fraction, an mpf or a float"
        )
    if isinstance(value, str):
        if not _NUMBER.fullmatch(value):
            raise ParameterTypeError(f"{name} = {value[:40]!r} is not a number such as '0.007' or '7/1000'")
        if re.search(r"/0*$", value.strip()):
            raise ParameterError(f"{name} = {value[:40]!r} divides by zero")
    elif isinstance(value, mpmath.mpf | float) and not mpmath.isfinite(value):
        raise ParameterError(f"{name} = {value} is not a finite number in {allowed}")
    exact = exactly(value)
    below = exact <= Fraction(allowed.low) if allowed.open_low else exact < Fraction(allowed.low)
    # π is irrational and its float lies below it: a rational beyond the float but below π is not worth a doubt.
    if below or (allowed.high != float("inf") and exact >= Fraction(allowed.high)):
        raise ParameterError(f"{name} = {value} is not in {allowed}" + (f": {allowed.remedy}" if allowed.remedy else ""))
    return exact


def as_digits(dps: int) -> int:
    """``dps`` as a number of digits that makes sense."""
    if isinstance(dps, bool) or not isinstance(dps, int):
        raise ParameterTypeError(f"dps = {dps!r} is not an integer; give a number of decimal digits")
    if not 1 <= dps <= MOST_DIGITS:
        raise ParameterError(f"dps = {dps} is not in [1, {MOST_DIGITS}]; give a number of decimal digits")
    return dps


def equilibria(
    theta0: Exact | None = None, mu0: Exact = "0.5", kappa: Exact = "0.007", alpha: Exact = "0.007", sigma: Exact = "0.1",
    beta: Exact = 0, *, theta0_deg: Exact | None = None, contact: bool = True, dps: int = 50, arith: Arithmetic | None = None,
) -> tuple[PreciseEquilibrium, ...]:  # fmt: skip
    """All equilibria of one point to ``dps`` digits, count and digits proved by interval arithmetic.

    Parameters
    ----------
    theta0, mu0, kappa, alpha, sigma, beta : int, str, Fraction, mpf or float
        Taken exactly; the article's base values where left out.
    theta0_deg : int, str, Fraction, mpf or float, optional
        θ₀ in degrees, instead of ``theta0`` in radians.
    contact : bool
        True for n̄ = 1 (y < 0), False for n̄ = 0 (y ≥ 0).
    dps : int
        Decimal digits, 1 to 1000.
    arith : Arithmetic, optional
        Interval arithmetic to use, another than :class:`spragsym.exact.intervals.Balls`.

    Returns
    -------
    tuple of PreciseEquilibrium
        Ascending in ``theta``.

    Raises
    ------
    ParameterError, ParameterTypeError
        For what is not a number, or out of range.
    ConvergenceError
        For a point on a stability boundary that no number of digits can settle.

    Notes
    -----
    Source: f(θ) = 0, (12)–(13) eliminated.

    Examples
    --------
    >>> from spragsym import precise
    >>> state, = precise.equilibria(theta0_deg="49", dps=30)
    >>> str(state.decimals()["x"]), str(state.decimals(digits=6)["x"])
    ('1.21742364817816844590957746961466093475851094892 ± 2.9e-45', '1.21742 ± 3.7e-06')
    """
    digits = as_digits(dps)
    if (theta0 is None) == (theta0_deg is None):
        raise ParameterError("give one of theta0 (radians) and theta0_deg (degrees)")
    angle: Any
    if theta0 is not None:
        angle = as_exact("theta0", theta0, RANGES["theta0"])
    else:
        assert theta0_deg is not None
        angle = _Degrees(as_exact("theta0_deg", theta0_deg, Range(0.0, 180.0, open_low=True)))
    given = {"mu0": mu0, "kappa": kappa, "alpha": alpha, "sigma": sigma, "beta": beta}
    exact = [as_exact(name, value, RANGES[name]) for name, value in given.items()]
    found = adaptive_precision.equilibria(angle, *exact, contact=contact, digits=digits, arith=arith)
    return tuple(
        PreciseEquilibrium(state.theta, state.L, state.x, state.y, Stability(state.stability), state.error, found.fold)
        for state in found.states
    )


# ------------------------------------------------------------------------------------------------------- cusps


@dataclass(frozen=True, repr=False)
class PreciseCusp(_Written):
    """One cusp; ``radius`` bounds |error| of each of the six numbers as they stand, angles in radians.

    ``versal`` says that it is one in the sense of catastrophe theory: f‴ ≠ 0 and θ₀, μ₀ unfold f, both proved.
    """

    theta0: mpmath.mpf
    mu0: mpmath.mpf
    theta: mpmath.mpf
    L: mpmath.mpf
    x: mpmath.mpf
    y: mpmath.mpf
    radius: mpmath.mpf
    versal: bool

    NUMBERS = ("theta0", "mu0", "theta", "L", "x", "y")

    def _bound(self, _: mpmath.mpf) -> Fraction:
        return exactly(self.radius)


@dataclass(frozen=True)
class CuspProof(Sequence[PreciseCusp]):
    """All cusps, and why there are no more.

    Attributes
    ----------
    cusps : tuple of PreciseCusp
        Those in contact with L > 0, sorted by ``mu0``.
    polynomial : tuple of Fraction
        Lowest power first; its roots s = sin θ in [−1, 1] (without ±1 for α = 0) are all cusps. Empty for α = 1 + β, where
        3 s² = 2 instead.
    sines : tuple of (Fraction, Fraction)
        Disjoint intervals, each proved to hold one of its real roots.
    count : int
        Number of different real roots there by Sturm's theorem, which ``sines`` matches: the proof.
    """

    cusps: tuple[PreciseCusp, ...]
    polynomial: tuple[Fraction, ...]
    sines: tuple[tuple[Fraction, Fraction], ...]
    count: int  # type: ignore[assignment]  # not Sequence's count

    def __getitem__(self, index: Any) -> Any:
        return self.cusps[index]

    def __len__(self) -> int:
        return len(self.cusps)


def cusps(
    kappa: Exact = "0.007", alpha: Exact = "0.007", sigma: Exact = "0.1", beta: Exact = 0, *, dps: int = 40,
    arith: Arithmetic | None = None,
) -> CuspProof:  # fmt: skip
    """All cusps to ``dps`` digits, with enclosures and the proof that there are no more.

    Parameters
    ----------
    kappa, alpha, sigma, beta : int, str, Fraction, mpf or float
        Taken exactly; the article's base values where left out.
    dps : int
        Decimal digits, 1 to 1000.
    arith : Arithmetic, optional
        Interval arithmetic to use, another than :class:`spragsym.exact.intervals.Balls`.

    Returns
    -------
    CuspProof
        A sequence of cusps with θ₀ in (−π, π] and μ₀ of either sign; empty where there is none.

    Notes
    -----
    Source: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ with rational coefficients.

    Examples
    --------
    >>> from spragsym import precise
    >>> found = precise.cusps(dps=30)
    >>> len(found), found.count, str(found[2].decimals(25)["mu0"]), found[2].versal
    (4, 2, '0.2009317818050900185134401 ± 4.8e-26', True)
    """
    digits = as_digits(dps)
    given = {"kappa": kappa, "alpha": alpha, "sigma": sigma, "beta": beta}
    exact = tuple(as_exact(name, value, RANGES[name]) for name, value in given.items())
    chosen = arith or arithmetic()

    def attempt(bits: int) -> list[PreciseCusp]:
        return [_cusp(chosen, point, digits) for point in cusp_proofs.cusps(chosen, exact, bits)]

    found = with_enough_bits(chosen, digits, attempt, "cusps")
    ordered = tuple(sorted(found, key=lambda one: (one.mu0, one.theta0)))
    if exact[1] == 1 + exact[3]:
        return CuspProof(ordered, (), (), 0)
    polynomial, sines, count = cusp_proofs.cusp_sines(*exact, bits=64)
    return CuspProof(ordered, polynomial, tuple(sines), count)


def _cusp(arith: Arithmetic, point: Point, digits: int) -> PreciseCusp:
    middles, radius = [], Fraction(0)
    for interval in (*point.parameters[:2], point.theta, point.L, point.x, point.y):
        low, high = arith.ends(interval)
        middle = (low + high) / 2
        half = rounded_up(high - middle)
        if half > Fraction(1, 10**digits) * max(Fraction(1), abs(middle)):
            raise Undecided(f"an error of {float(half):.1e}")
        radius = max(radius, half)
        middles.append(as_mpf(middle))
    theta0, mu0, theta, L, x, y = middles
    return PreciseCusp(theta0, mu0, theta, L, x, y, as_mpf(radius), cusp_proofs.is_versal(arith, point))


def prove_cycle(cycle: Any, **options: Any) -> Any:
    """Prove that a cycle exists, is the only one near, and is stable or not: see :func:`spragsym.cycles.proofs.prove_cycle`."""
    from .cycles import proofs

    return proofs.prove_cycle(cycle, **options)
