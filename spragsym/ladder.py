"""One point with as many digits as it takes: interval arithmetic proves the count and the digits of every equilibrium.

Parameters are exact rationals. The sign of the discriminant gives the number of real roots of the quartic in t = tan(θ/2); each
is then enclosed between two numbers where f has opposite signs. What an interval can't decide is tried again with twice the
bits, up to :data:`MAXIMUM_BITS`; a discriminant that still holds 0 then is reported as a fold.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath

from . import kernel
from .errors import ConvergenceError
from .intervals import Arithmetic, Interval, arithmetic, sign

#: Bits of the first try, and those at which a discriminant that holds 0 is taken for a fold: the latter, and as many again for
#: each power of two between the parameters, since the discriminant is of the sixth degree in coefficients of theirs.
FIRST_BITS, MAXIMUM_BITS, BITS_A_SPREAD = 128, 4096, 8


@dataclass(frozen=True)
class State:
    """One equilibrium; ``error`` bounds |error| / max(1, |value|) of the four, ``stability`` is a code of Stability."""

    theta: Any
    L: Any
    x: Any
    y: Any
    stability: int
    error: Any


@dataclass(frozen=True)
class Settled:
    """All equilibria of one point, ascending in θ, and whether it is a fold to the last digit tried."""

    states: tuple[State, ...]
    fold: bool
    bits: int


class _TooCoarse(Exception):
    """An interval can't decide at this precision."""


def equilibria(
    theta0: Any, mu0: Any, kappa: Any, alpha: Any, sigma: Any, beta: Any, *, contact: bool = True, digits: int = 17,
    arith: Arithmetic | None = None,
) -> Settled:  # fmt: skip
    """All equilibria of one point, to ``digits`` digits.

    Parameters are anything that :class:`fractions.Fraction` takes exactly: float, int, str, Fraction; ``theta0`` may be a
    function of the arithmetic that returns an interval.
    """
    arith = arith or arithmetic()
    rational = [Fraction(value) for value in (mu0, kappa, alpha, sigma, beta)]
    bits, most = max(FIRST_BITS, int(3.4 * digits) + 64), _most_bits(theta0, rational)
    while True:
        with arith.precision(bits):
            try:
                return _settle(arith, theta0, rational, contact, digits, bits, bits >= most)
            except (_TooCoarse, ZeroDivisionError) as reason:
                if bits >= most:
                    raise ConvergenceError(
                        f"{bits} bits do not settle theta0={theta0}, mu0={mu0}, kappa={kappa}, alpha={alpha}, sigma={sigma}, "
                        f"beta={beta}: {reason}; move the point off the boundary that it is on"
                    ) from None
        bits *= 2


def _most_bits(theta0: Any, rational: list[Fraction]) -> int:
    """The bits at which trying ends."""
    given = [Fraction(1), *rational, *([] if callable(theta0) else [Fraction(theta0)])]
    powers = [value.numerator.bit_length() - value.denominator.bit_length() for value in given if value]
    return MAXIMUM_BITS + BITS_A_SPREAD * (max(powers) - min(powers))


def _settle(
    arith: Arithmetic, theta0: Any, rational: list[Fraction], contact: bool, digits: int, bits: int, last: bool
) -> Settled:
    angle = theta0(arith) if callable(theta0) else arith.exact(Fraction(theta0))
    values = (*arith.cos_sin(angle), *map(arith.exact, rational), int(contact))
    trig = kernel.f_coefficients(*values)
    P, Q = kernel.depressed(*kernel.resolvent(*trig))
    discriminant = sign(arith, P * P * P + Q * Q)
    fold = discriminant == 0
    if fold and not last:
        raise _TooCoarse("the discriminant holds 0")
    roots = _fold_roots(arith, trig) if fold else _enclosed_roots(arith, trig, 4 if discriminant < 0 else 2, bits)
    states = [state for root in roots for state in _state(arith, root, trig, values, digits, fold)]
    if contact and len(states) % 2 == 0:
        raise _TooCoarse("an even number of equilibria in contact")
    return Settled(tuple(sorted(states, key=lambda state: state.theta)), fold, bits)


# ------------------------------------------------------------------------------------------------------- roots


def _middle(arith: Arithmetic, value: Interval) -> mpmath.mpf:
    low, high = arith.ends(value)
    return (low + high) / 2


def _approximate_roots(arith: Arithmetic, trig: tuple[Interval, ...]) -> list[mpmath.mpc]:
    """All four roots in t of the quartic with the middles of its coefficients; a cusp next by asks for twice the digits."""
    middles = [_middle(arith, value) for value in trig]
    with mpmath.extraprec(mpmath.mp.prec):
        p1, q1, p2, q2 = _split(middles)
    return [root for p, q in ((p1, q1), (p2, q2)) for root in _quadratic(p, q)]


def _split(trig: list[mpmath.mpf]) -> list[mpmath.mpf]:
    """The factors in closed form: as :func:`spragsym.kernel.factors`, with functions of any precision."""
    _, e1, _, e3, e4 = kernel.t_quartic(*trig)
    r0, r1, r2 = kernel.resolvent(*trig)
    P, Q = kernel.depressed(r0, r1, r2)
    D = P**3 + Q**2
    if D > 0:
        u = mpmath.cbrt(abs(Q) + mpmath.sqrt(D))
        z = u - P / u
    else:
        root = mpmath.sqrt(-P)
        z = 2 * root * mpmath.cos(mpmath.acos(min(abs(Q) / root**3, mpmath.mpf(1))) / 3) if P else mpmath.mpf(0)
    y = -4 / e4 * ((-z if Q > 0 else z) - r2 / 3)
    A1, A3 = e1 / e4, e3 / e4
    width = mpmath.sqrt(y * y + 4)
    large = (abs(y) + width) / 2
    q1, q2 = (-1 / large, large) if y > 0 else (-large, 1 / large)
    return [(A1 - A3 * q1) / width, q1, (A3 * q2 - A1) / width, q2]


def _quadratic(p: mpmath.mpf, q: mpmath.mpf) -> tuple[mpmath.mpc, mpmath.mpc]:
    """Roots of t² + p t + q, the larger first; q is never 0."""
    root = mpmath.sqrt(p * p / 4 - q)
    large = -(p / 2 + root) if p > 0 else root - p / 2
    return large, q / large


def _enclosed_roots(arith: Arithmetic, trig: tuple[Interval, ...], number: int, bits: int) -> list[Interval]:
    """Disjoint intervals in t, each with a change of sign of f: as many as there are real roots, so one root in each."""
    approximate = sorted(_approximate_roots(arith, trig), key=lambda root: abs(mpmath.im(root)) / abs(root))[:number]
    intervals = sorted((_enclose(arith, trig, mpmath.re(root), bits) for root in approximate), key=lambda ends: ends[0])
    if any(left[1] >= right[0] for left, right in itertools.pairwise(intervals)):
        raise _TooCoarse("two roots share an interval")
    return [arith.between(*ends) for ends in intervals]


def _enclose(
    arith: Arithmetic, trig: tuple[Interval, ...], root: mpmath.mpf, bits: int
) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Ends of an interval around ``root`` at which the quartic has opposite signs."""
    quartic = kernel.t_quartic(*trig)
    for lost in range(16, bits, 16):
        width = abs(root) * mpmath.ldexp(1, lost - bits)
        low, high = root - width, root + width
        if sign(arith, _horner(quartic, arith.between(low, low))) * sign(arith, _horner(quartic, arith.between(high, high))) < 0:
            return low, high
    raise _TooCoarse("no change of sign around a root")


def _horner(coefficients: tuple[Interval, ...], t: Interval) -> Interval:
    value = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        value = value * t + coefficient
    return value


def _fold_roots(arith: Arithmetic, trig: tuple[Interval, ...]) -> list[Interval]:
    """Roots at a fold: the two that can't be told apart share one interval, twice."""
    roots = sorted(_approximate_roots(arith, trig), key=lambda root: mpmath.re(root))
    gaps = [abs(right - left) for left, right in itertools.pairwise(roots)]
    first = gaps.index(min(gaps))
    one, other = roots[first], roots[first + 1]
    middle, width = mpmath.re(one + other) / 2, abs(one - other) + abs(one) * mpmath.sqrt(mpmath.ldexp(1, -mpmath.mp.prec))
    double = arith.between(middle - width, middle + width)
    others = roots[:first] + roots[first + 2 :]
    simple = [arith.between(*_enclose(arith, trig, mpmath.re(root), mpmath.mp.prec - 10)) for root in others]
    return [double, double, *simple]


# ------------------------------------------------------------------------------------------------------ states


def _state(
    arith: Arithmetic, t: Interval, trig: tuple[Interval, ...], values: tuple[Any, ...], digits: int, fold: bool
) -> list[State]:
    """The equilibrium at t, or nothing where the root is none."""
    cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar = values
    s = 2 * t / (1 + t * t)
    c = (1 - t) * (1 + t) / (1 + t * t)
    L, x, y = kernel.state(c, s, cos0, sin0, kappa, sigma, beta, nbar)
    sides = sign(arith, L), sign(arith, y) * (-1 if nbar else 1)
    if -1 in sides:
        return []
    if 0 in sides:
        raise _TooCoarse("L or y holds 0")
    ends = [arith.ends(value) for value in (2 * arith.atan(t), L, x, y)]
    middles = [(low + high) / 2 for low, high in ends]
    error = max((high - low) / 2 / max(1, abs(middle)) for (low, high), middle in zip(ends, middles, strict=True))
    if error > mpmath.mpf(10) ** -digits and not fold:
        raise _TooCoarse(f"an error of {mpmath.nstr(error, 2)}")
    code = _stability(arith, c, s, L, trig, values, fold)
    # Adding the rounding of the middle, and of a float made of it.
    rounding = mpmath.ldexp(1, -min(mpmath.mp.prec - 4, 53 if digits <= 17 else mpmath.mp.prec))
    return [State(middles[0], middles[1], middles[2], middles[3], code, error + rounding)]


def _stability(
    arith: Arithmetic, c: Interval, s: Interval, L: Interval, trig: tuple[Interval, ...], values: tuple[Any, ...], fold: bool
) -> int:
    _, _, mu0, _, alpha, sigma, beta, nbar = values
    (K11, K12), (K21, K22) = kernel.stiffness(c, s, L, mu0, alpha, sigma, beta, nbar)
    trace, _, flutter = (sign(arith, value) for value in kernel.invariants(K11, K12, K21, K22))
    slope = sign(arith, kernel.f_slope(c, s, *trig))
    if flutter < 0:
        return 3
    if flutter == 0 or (slope == 0 and not fold) or (slope > 0 and trace == 0):
        raise _TooCoarse("a stability boundary")
    # On a fold one λ is 0; the others decide, as they do on the stable side.
    return 2 if slope < 0 or trace < 0 else 1
