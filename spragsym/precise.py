"""The same answers with as many digits as wanted, from parameters taken exactly, each with a proof.

A parameter is an int, a str such as ``"0.007"`` or ``"7/1000"``, a :class:`fractions.Fraction`, an mpmath number or a float, and
is taken to be exactly the rational number that it writes.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

import mpmath

from . import ladder
from .solver import Stability
from .errors import ParameterError, ParameterTypeError
from .intervals import Arithmetic, Interval
from .parameters import RANGES, Range

#: What is taken exactly.
Exact: TypeAlias = int | float | str | Fraction | mpmath.mpf

#: Digits beyond which a request is taken for a mistake.
MOST_DIGITS = 1000
_NUMBER = re.compile(r"\s*[+-]?(\d{1,400}(/\d{1,400})?|(\d{1,400}\.?\d{0,400}|\.\d{1,400})([eE][+-]?\d{1,3})?)\s*")


@dataclass(frozen=True)
class PreciseEquilibrium:
    """One equilibrium; ``theta`` in radians, ``error`` a proved bound on |error| / max(1, |value|) of the four numbers."""

    theta: mpmath.mpf
    L: mpmath.mpf
    x: mpmath.mpf
    y: mpmath.mpf
    stability: Stability
    error: mpmath.mpf
    fold: bool


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
    exact = _from_mpf(value) if isinstance(value, mpmath.mpf) else Fraction(value)
    below = exact <= Fraction(allowed.low) if allowed.open_low else exact < Fraction(allowed.low)
    # π is irrational and its float lies below it: a rational beyond the float but below π is not worth a doubt.
    if below or (allowed.high != float("inf") and exact >= Fraction(allowed.high)):
        raise ParameterError(f"{name} = {value} is not in {allowed}" + (f": {allowed.remedy}" if allowed.remedy else ""))
    return exact


def _from_mpf(value: mpmath.mpf) -> Fraction:
    negative, mantissa, exponent, _ = value._mpf_
    return Fraction(-int(mantissa) if negative else int(mantissa)) * Fraction(2) ** int(exponent)


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
        Interval arithmetic to use; python-flint's where installed, otherwise mpmath's.

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
    >>> import mpmath; mpmath.nstr(state.x, 30)
    '1.21742364817816844590957746961'
    """
    digits = as_digits(dps)
    if (theta0 is None) == (theta0_deg is None):
        raise ParameterError("give one of theta0 (radians) and theta0_deg (degrees)")
    angle: Any
    if theta0 is not None:
        angle = as_exact("theta0", theta0, RANGES["theta0"])
    else:
        assert theta0_deg is not None
        degrees = as_exact("theta0_deg", theta0_deg, Range(0.0, 180.0, open_low=True))

        def angle(arith: Arithmetic) -> Interval:
            return arith.exact(degrees / 180) * arith.pi()

    given = {"mu0": mu0, "kappa": kappa, "alpha": alpha, "sigma": sigma, "beta": beta}
    exact = [as_exact(name, value, RANGES[name]) for name, value in given.items()]
    found = ladder.equilibria(angle, *exact, contact=contact, digits=digits, arith=arith)
    with mpmath.workdps(digits + 5):
        return tuple(
            PreciseEquilibrium(
                +state.theta, +state.L, +state.x, +state.y, Stability(state.stability), state.error, found.fold
            )
            for state in found.states
        )
