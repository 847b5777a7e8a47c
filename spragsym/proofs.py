"""Folds and cusps of exactly given parameters, with a proof that there are no more: real-root counting, no starting points.

On a fold two relations hold that are linear in every parameter but θ₀ (derived: ``fold_lines_*``), so that eliminating the one
that varies leaves a polynomial in t = tan(θ/2); on a cusp ``cusp_polynomial`` in sin θ remains. Sturm's count says how many real
roots there are, exactly over rationals and with intervals where cos θ₀ and sin θ₀ enter.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeVar

from . import kernel, polynomials
from .errors import ConvergenceError
from .generated import catastrophe as _catastrophe
from .intervals import Arithmetic, Interval, sign
from .parameters import NAMES
from .polynomials import Undecided

#: Bits of the first try and of the last.
FIRST_BITS, MAXIMUM_BITS = 192, 6144

T = TypeVar("T")


@dataclass(frozen=True)
class Point:
    """A point of the surface with f = f′ = 0, in intervals: parameters in the order of ``NAMES``, direction and state."""

    parameters: tuple[Interval, ...]
    theta: Interval
    L: Interval
    x: Interval
    y: Interval


def with_enough_bits(arith: Arithmetic, digits: int, attempt: Callable[[int], T], what: str) -> T:
    """Run ``attempt(bits)`` with more and more bits until every sign that it needs is decided."""
    bits = max(FIRST_BITS, int(3.4 * digits) + 96)
    while True:
        with arith.precision(bits):
            try:
                return attempt(bits)
            except (Undecided, ZeroDivisionError) as reason:
                if bits >= MAXIMUM_BITS:
                    raise ConvergenceError(
                        f"{what}: {bits} bits do not decide it ({reason}); the parameters are degenerate, "
                        "change one of them a little"
                    ) from None
        bits *= 2


def decided(arith: Arithmetic, value: Interval, what: str) -> int:
    """The sign of an interval that must have one."""
    result = sign(arith, value)
    if result == 0:
        raise Undecided(what)
    return result


def angle(arith: Arithmetic, cosine: Interval, sine: Interval) -> Interval:
    """The angle in (−π, π] with that cosine and sine, from the half that the arc tangent is good at."""
    low, high = arith.ends(cosine)
    if low > 0:
        return arith.atan(sine / cosine)
    side = decided(arith, sine, "an angle of 0 or π")
    if high < 0:
        return arith.atan(sine / cosine) + side * arith.pi()
    return side * arith.pi() / 2 - arith.atan(cosine / sine)


# ------------------------------------------------------------------------------------------------------- cusps


def cusp_sines(
    kappa: Fraction, alpha: Fraction, sigma: Fraction, beta: Fraction, *, bits: int
) -> tuple[tuple[Fraction, ...], list[tuple[Fraction, Fraction]], int]:
    """The polynomial of the cusps, an interval around each of its roots in (−1, 1), and their number by Sturm. α ≠ 1 + β."""
    coefficients = (
        _catastrophe.cusp_polynomial(kappa, alpha, sigma, beta) if alpha else _catastrophe.cusp_cubic(kappa, sigma, beta)
    )
    polynomial = tuple(Fraction(value) for value in coefficients)
    one = Fraction(1)
    simple = polynomials.squarefree(polynomial)
    chain = polynomials.sturm_chain(simple, polynomials.exact_sign)
    count = polynomials.count_between(chain, -one, one, polynomials.exact_sign) - (polynomials.evaluate(simple, one) == 0)
    roots = polynomials.real_roots(simple, -one, one, polynomials.exact_sign, Fraction, bits)
    roots = [root for root in roots if root != (one, one)]
    if len(roots) != count:
        raise ArithmeticError("isolation and Sturm's count disagree")  # can't happen: both are exact
    return polynomial, roots, count


def cusps(arith: Arithmetic, exact: tuple[Fraction, ...], bits: int) -> Iterator[Point]:
    """Every cusp in contact with L > 0, for exact κ, α, σ, β; both mirror images, θ₀ in (−π, π], μ₀ of either sign."""
    kappa, alpha, sigma, beta = exact
    values = tuple(map(arith.exact, exact))
    if alpha == 1 + beta:
        yield from _cusps_without_a(arith, values, bits)
        return
    sines = [arith.between(low, high) for low, high in cusp_sines(kappa, alpha, sigma, beta, bits=bits - 32)[1]]
    # With α = 0 the second fold relation has the factor cos θ besides the cubic: a cusp at μ₀ = 0 and θ = ±π/2.
    sines += [] if alpha else [arith.exact(Fraction(1)), arith.exact(Fraction(-1))]
    for s in sines:
        upright = not alpha and sign(arith, 1 - s * s) == 0
        width = arith.exact(Fraction(0)) if upright else arith.sqrt(1 - s * s)
        for c in (width,) if upright else (width, -width):
            s0, friction = _catastrophe.cusp_sine(s, *values)
            if alpha:
                _, ratio, _ = _catastrophe.cusp_point(s, *values)
                cosines = [ratio * c]
            else:
                gap = 1 - s0 * s0
                if decided(arith, gap, "sin θ₀ = 1 on a cusp") < 0:
                    continue
                cosines = [arith.sqrt(gap), -arith.sqrt(gap)]
            for c0 in cosines:
                yield from _in_contact(arith, c, s, c0, s0, friction * c, values)


def _cusps_without_a(arith: Arithmetic, values: tuple[Interval, ...], bits: int) -> Iterator[Point]:
    """α = 1 + β: a = 0, and f″ = 0 on a fold means 3 sin² θ = 2, whatever the friction."""
    third = arith.exact(Fraction(1, 3))
    for s_sign in (1, -1):
        s = s_sign * arith.sqrt(2 * third)
        for c_sign in (1, -1):
            c = c_sign * arith.sqrt(third)
            quartic = _catastrophe.fold_quartic(c, s, *values)
            for mu0 in _interval_roots(arith, quartic, bits):
                s0, c0 = _catastrophe.fold_angles(c, s, mu0, *values)
                yield from _in_contact(arith, c, s, c0, s0, mu0, values)


def _interval_roots(arith: Arithmetic, polynomial: tuple[Interval, ...], bits: int) -> Iterator[Interval]:
    """All real roots of a polynomial with interval coefficients."""
    half = bits // 2
    one = Fraction(1)
    for chart, backward in ((polynomial, False), (tuple(reversed(polynomial)), True)):
        for low, high in polynomials.real_roots(chart, -one, one, lambda v: sign(arith, v), arith.exact, half):
            if backward and (low <= 0 <= high or abs(low) == 1 or abs(high) == 1):
                continue
            root = arith.between(low, high)
            yield 1 / root if backward else root


def _in_contact(
    arith: Arithmetic, c: Interval, s: Interval, c0: Interval, s0: Interval, mu0: Interval, values: tuple[Interval, ...]
) -> Iterator[Point]:
    """The point with its state, if it is in contact with L > 0."""
    kappa, alpha, sigma, beta = values
    L, x, y = kernel.state(c, s, c0, s0, kappa, sigma, beta, 1)
    if decided(arith, L, "L = 0") > 0 and decided(arith, y, "y = 0") < 0:
        yield Point((angle(arith, c0, s0), mu0, kappa, alpha, sigma, beta), angle(arith, c, s), L, x, y)


def is_versal(arith: Arithmetic, point: Point) -> bool:
    """Whether f‴ ≠ 0 and (θ₀, μ₀) unfold f fully there: then the cusp is one in the sense of catastrophe theory."""
    theta0, mu0, *values = point.parameters
    c, s = arith.cos_sin(point.theta)
    c0, s0 = arith.cos_sin(theta0)
    (f_theta0, slope_theta0), (f_mu, slope_mu), *_ = _catastrophe.unfolding(c, s, c0, s0, mu0, *values)
    trig = kernel.f_coefficients(c0, s0, mu0, *values, 1)
    third = kernel.f_third(c, s, *trig)
    return sign(arith, third) != 0 and sign(arith, f_theta0 * slope_mu - f_mu * slope_theta0) != 0


# ------------------------------------------------------------------------------------------------------- folds

_LINES = {
    "mu0": _catastrophe.fold_lines_mu0,
    "kappa": _catastrophe.fold_lines_kappa,
    "alpha": _catastrophe.fold_lines_alpha,
    "sigma": _catastrophe.fold_lines_sigma,
    "beta": _catastrophe.fold_lines_beta,
}
#: Degree in t of the eliminated fold condition: two cubics in cos θ, sin θ where θ₀ varies, half of that otherwise.
_DEGREE_IN_THETA0, _DEGREE = 12, 6


def _on_circle(t: Any) -> tuple[Any, Any, Any]:
    """cos θ, sin θ and 1 + t² at t = tan(θ/2)."""
    scale = 1 + t * t
    return (1 - t * t) / scale, 2 * t / scale, scale


def folds(arith: Arithmetic, vary: str, exact: dict[str, Fraction], bits: int) -> Iterator[Point]:
    """Every fold in contact with L > 0 along one parameter, the others given exactly; 0 < θ < π, where contact is."""
    if vary == "theta0":
        yield from _folds_in_theta0(arith, exact, bits)
        return
    fixed = {name: arith.exact(exact[name]) for name in NAMES if name != vary}
    c0, s0 = arith.cos_sin(fixed.pop("theta0"))
    others = [fixed[name] for name in NAMES[1:] if name != vary]
    lines = _LINES[vary]

    def eliminated(t: Fraction) -> Interval:
        c, s, scale = (arith.exact(value) for value in _on_circle(t))
        u1, w1, u2, w2 = lines(c, s, c0, s0, *others)
        return (u1 * w2 - u2 * w1) * scale ** (_DEGREE // 2)

    polynomial = polynomials.interpolate(eliminated, _DEGREE, arith.exact)
    for t in _positive_roots(arith, polynomial, lambda v: sign(arith, v), arith.exact, bits // 2):
        c, s, _ = _on_circle(t)
        u1, w1, u2, w2 = lines(c, s, c0, s0, *others)
        value = -u1 / w1 if sign(arith, w1) else -u2 / w2
        found = {**fixed, vary: value}
        for point in _in_contact(arith, c, s, c0, s0, found["mu0"], tuple(found[name] for name in NAMES[2:])):
            yield Point((arith.exact(exact["theta0"]), *point.parameters[1:]), point.theta, point.L, point.x, point.y)


def _folds_in_theta0(arith: Arithmetic, exact: dict[str, Fraction], bits: int) -> Iterator[Point]:
    """s₀² + c₀² = 1 on the fold is exact in rationals; with α = 0, where cos θ₀ is free, it is the second relation."""
    mu0, kappa, alpha, sigma, beta = (exact[name] for name in ("mu0", "kappa", "alpha", "sigma", "beta"))

    def eliminated(t: Fraction) -> Fraction:
        c, s, scale = _on_circle(t)
        if alpha:
            s0, c0 = _catastrophe.fold_angles(c, s, mu0, kappa, alpha, sigma, beta)
            return Fraction((s0**2 + c0**2 - 1) * scale ** (_DEGREE_IN_THETA0 // 2))
        e0, e1, e2 = _catastrophe.fold_quadratic(c, s, kappa, sigma, beta)
        return Fraction((e0 + mu0 * (e1 + mu0 * e2)) * scale ** (_DEGREE_IN_THETA0 // 2))

    polynomial = polynomials.squarefree(polynomials.interpolate(eliminated, _DEGREE_IN_THETA0, Fraction))
    values = tuple(arith.exact(value) for value in (kappa, alpha, sigma, beta))
    friction = arith.exact(mu0)
    for t in _positive_roots(arith, polynomial, polynomials.exact_sign, Fraction, bits - 32):
        c, s, _ = _on_circle(t)
        if alpha:
            s0, c0 = _catastrophe.fold_angles(c, s, friction, *values)
            cosines = [c0]
        else:
            s0 = _catastrophe.fold_sine(c, s, friction, *values)
            gap = 1 - s0 * s0
            if decided(arith, gap, "sin θ₀ = 1 on a fold") < 0:
                continue
            cosines = [arith.sqrt(gap), -arith.sqrt(gap)]
        for c0 in cosines:
            yield from _in_contact(arith, c, s, c0, s0, friction, values)


def _positive_roots(
    arith: Arithmetic, polynomial: tuple[Any, ...], signs: Callable[[Any], int], number: Callable[[Fraction], Any], bits: int
) -> Iterator[Interval]:
    """Roots t > 0 as intervals: those up to a little over 1, and beyond as reciprocals of the reversed polynomial's.

    The ends of the two charts are no round numbers, where Sturm functions of symmetric parameters vanish.
    """
    below, between = Fraction(-1, 7), Fraction(13, 11)
    for low, high in polynomials.real_roots(polynomial, below, between, signs, number, bits):
        if low > 0 or high > 0:
            yield arith.between(low, high)
    backward = tuple(reversed(polynomial))
    for low, high in polynomials.real_roots(backward, below, 1 / between, signs, number, bits):
        if low > 0 or high > 0:
            yield 1 / arith.between(low, high)
