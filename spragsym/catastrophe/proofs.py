"""Folds and cusps of exactly given parameters, with a proof that there are no more: real-root counting, no starting points.

On a fold two relations hold that are linear in every parameter but θ₀ (derived: ``fold_lines_*``), so that eliminating the one
that varies leaves a polynomial in t = tan(θ/2); on a cusp ``cusp_polynomial`` in sin θ remains. Its real
roots are isolated exactly over rationals (Descartes), and with intervals where cos θ₀ and sin θ₀ enter (Sturm).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeVar

from ..errors import ConvergenceError
from ..exact import polynomials
from ..exact.intervals import Arithmetic, Interval, sign
from ..exact.polynomials import Undecided
from ..generated import catastrophe as _catastrophe
from ..parameters import NAMES
from ..statics import kernel

#: Bits of the first try and of the last.
FIRST_BITS, MAXIMUM_BITS = 192, 6144
#: What an interval may be off by when it becomes a float.
_LARGEST_ERROR = Fraction(1, 10**15)

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


def as_floats(arith: Arithmetic, intervals: Iterable[Interval]) -> tuple[list[float], float]:
    """The middles of intervals as floats, infinite beyond float64, and a bound on |error| / max(1, |value|) of all of them."""
    values, worst = [], Fraction(0)
    for low, high in map(arith.ends, intervals):
        middle = (low + high) / 2
        worst = max(worst, (high - low) / 2 / max(Fraction(1), abs(middle)))
        try:
            values.append(float(middle))
        except OverflowError:
            values.append(math.inf if middle > 0 else -math.inf)
    if worst > _LARGEST_ERROR:
        raise Undecided("an interval wider than a float may be off")
    # Half a unit in the last place of a float, and what is lost in this sum.
    return values, float(worst) * (1 + 2.0**-40) + 1.2e-16


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


@dataclass(frozen=True)
class _Sine:
    """sin θ on a cusp: an interval (low, high] around one root of an exact polynomial, or low = high."""

    polynomial: polynomials.Polynomial
    low: Fraction
    high: Fraction

    def sign_of(self, arith: Arithmetic, value: Interval, exactly: Callable[[Fraction], Fraction], what: str) -> int:
        """The sign of an interval, 0 where a function of sin θ is 0 exactly that has no poles but those at 3 sin² θ = 2."""
        result = sign(arith, value)
        return 0 if result == 0 and self._is_zero(exactly) else decided(arith, value, what)

    def _is_zero(self, exactly: Callable[[Fraction], Fraction]) -> bool:
        if self.low == self.high:
            return exactly(self.low) == 0
        numerator = polynomials.interpolate(lambda s: exactly(s) * (3 * s * s - 2) ** 2, 10, Fraction)
        return polynomials.has_root(polynomials.common_divisor(self.polynomial, numerator), self.low, self.high)


def cusp_sines(
    kappa: Fraction, alpha: Fraction, sigma: Fraction, beta: Fraction, *, bits: int
) -> tuple[tuple[Fraction, ...], list[tuple[Fraction, Fraction]], int]:
    """The polynomial of the cusps, an interval around each of its roots, and their number by Sturm. α ≠ 1 + β.

    Roots in [−1, 1], and for α = 0 in (−1, 1).
    """
    polynomial, simple = _cusp_polynomial(kappa, alpha, sigma, beta)
    chain = polynomials.sturm_chain(simple, polynomials.exact_sign)
    count = polynomials.count_between(chain, -_ONE, _ONE, polynomials.exact_sign)
    at_ends = [polynomials.evaluate(simple, end) == 0 for end in (-_ONE, _ONE)]
    count += at_ends[0] if alpha else -at_ends[1]
    roots = _cusp_roots((kappa, alpha, sigma, beta), bits)
    if len(roots) != count:
        raise ArithmeticError("isolation and Sturm's count disagree")  # can't happen: both are exact
    return polynomial, roots, count


_ONE = Fraction(1)


@lru_cache(maxsize=64)
def _cusp_polynomial(kappa: Fraction, alpha: Fraction, sigma: Fraction, beta: Fraction) -> tuple[polynomials.Polynomial, ...]:
    """The polynomial of the cusps in sin θ, and the same with every root once."""
    coefficients = (
        _catastrophe.cusp_polynomial(kappa, alpha, sigma, beta) if alpha else _catastrophe.cusp_cubic(kappa, sigma, beta)
    )
    polynomial = tuple(Fraction(value) for value in coefficients)
    return polynomial, polynomials.squarefree(polynomial)


def _cusp_roots(exact: tuple[Fraction, ...], bits: int) -> list[tuple[Fraction, Fraction]]:
    """Intervals as of :func:`cusp_sines`."""
    _, simple = _cusp_polynomial(*exact)
    roots = polynomials.real_roots(simple, -_ONE, _ONE, polynomials.exact_sign, Fraction, bits)
    if not exact[1]:
        return [root for root in roots if root != (_ONE, _ONE)]
    return [(-_ONE, -_ONE), *roots] if polynomials.evaluate(simple, -_ONE) == 0 else roots


def cusps(arith: Arithmetic, exact: tuple[Fraction, ...], bits: int) -> Iterator[Point]:
    """Every cusp in contact with L > 0, for exact κ, α, σ, β; both mirror images, θ₀ in (−π, π], μ₀ of either sign."""
    _, alpha, _, beta = exact
    if alpha == 1 + beta:
        yield from _cusps_without_a(arith, tuple(map(arith.exact, exact)), bits)
        return
    polynomial, roots = _cusp_polynomial(*exact)[0], _cusp_roots(exact, bits - 32)
    if not alpha:
        # The second fold relation has the factor cos θ besides the cubic: a cusp at μ₀ = 0 and θ = ±π/2.
        roots += [(Fraction(1), Fraction(1)), (Fraction(-1), Fraction(-1))]
    for low, high in roots:
        yield from _cusps_at(arith, exact, _Sine(polynomial, low, high))


def _cusps_at(arith: Arithmetic, exact: tuple[Fraction, ...], sine: _Sine) -> Iterator[Point]:
    """The cusps of one sin θ. What is 0 exactly, as cos θ₀ or y may be at a coincidence of parameters, is known to be."""
    alpha = exact[1]
    values = tuple(map(arith.exact, exact))
    s, zero = arith.between(sine.low, sine.high), arith.exact(Fraction(0))
    s0, friction = _catastrophe.cusp_sine(s, *values)
    L = _cusp_length(s, *values)
    sides = (
        sine.sign_of(arith, L, lambda s: _cusp_length(s, *exact), "L = 0 on a cusp"),
        sine.sign_of(arith, s0 - L * s, lambda s: _cusp_y(s, *exact), "y = 0 on a cusp"),
    )
    if sides != (1, -1):
        return
    upright = sine.low == sine.high and abs(sine.low) == 1
    width = zero if upright else arith.sqrt(1 - s * s)
    flat = sine.sign_of(arith, s, lambda s: s, "sin θ = 0 on a cusp") == 0
    flat0 = sine.sign_of(arith, s0, lambda s: _catastrophe.cusp_sine(s, *exact)[0], "sin θ₀ = 0 on a cusp") == 0
    s = zero if flat else s
    friction = zero if flat else friction
    for c in (width,) if upright else (width, -width):
        if alpha:
            cosines = [_catastrophe.cusp_point(s, *values)[1] * c]
        else:
            gap = 1 - s0 * s0
            inside = sine.sign_of(arith, gap, lambda s: 1 - _catastrophe.cusp_sine(s, *exact)[0] ** 2, "cos θ₀ = 0 on a cusp")
            cosines = [] if inside < 0 else [arith.sqrt(gap), -arith.sqrt(gap)] if inside else [zero]
        for c0 in cosines:
            angles = (_angle_or_level(arith, c0, s0, flat0), _angle_or_level(arith, c, s, flat))
            yield Point((angles[0], friction * c, *values), angles[1], L, c0 - L * c, s0 - L * s)


def _angle_or_level(arith: Arithmetic, cosine: Interval, sine: Interval, level: bool) -> Interval:
    """The angle in (−π, π], 0 or π where the sine is known to be 0."""
    if not level:
        return angle(arith, cosine, sine)
    return arith.exact(Fraction(0)) if decided(arith, cosine, "cos θ = 0") > 0 else arith.pi()


def _cusp_length(s: Any, kappa: Any, alpha: Any, sigma: Any, beta: Any) -> Any:
    """L on a cusp: (σ s + B s₀ + κ)/(q s) with −b/p for B s₀ + κ, which is a s³ + m s² c over p there."""
    p, B = alpha + sigma, 1 + beta
    return sigma * (1 + (B - alpha) * s * s / (p * (3 * s * s - 2))) / (B + sigma)


def _cusp_y(s: Fraction, *exact: Fraction) -> Fraction:
    return Fraction(_catastrophe.cusp_sine(s, *exact)[0] - _cusp_length(s, *exact) * s)


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
    for chart, limit, backward in ((polynomial, _BETWEEN, False), (tuple(reversed(polynomial)), 1 / _BETWEEN, True)):
        for low, high in polynomials.real_roots(chart, -limit, limit, lambda v: sign(arith, v), arith.exact, bits // 2):
            yield _Root(low, high, backward).interval(arith)


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


@dataclass(frozen=True)
class Fold:
    """A point at which equilibria meet along one parameter, and what the signs of f's derivatives say there, proved.

    f is negative at the lower end of the directions in contact and positive at the upper one (the theorem of
    one or three), so that at a double root the sign of f″ tells on which side the third root lies.
    """

    point: Point
    kind: str  #: "fold", "pitchfork", "cusp" or "touch"
    side: int  #: 1 where there are three equilibria above the value of the parameter and one below it, −1 the reverse, else 0
    upper: bool  #: those that meet are the upper two of three in θ


@dataclass(frozen=True)
class _Direction:
    """t = tan(θ/2) at a root of the eliminated polynomial: its multiplicity, 3 for more, and whether f″ = 0 there."""

    t: Interval
    multiplicity: int = 1
    flat: bool = False
    is_zero: Callable[[Callable[[Fraction], Fraction]], bool] = lambda _: False  #: for a function like those eliminated, exactly


def folds(arith: Arithmetic, vary: str, exact: dict[str, Fraction], bits: int) -> Iterator[Fold]:
    """Every fold in contact with L > 0 along one parameter, the others given exactly; 0 < θ, θ₀ < π, where contact is."""
    if vary == "theta0":
        yield from _folds_in_theta0(arith, exact, bits)
        return
    fixed = {name: arith.exact(exact[name]) for name in NAMES if name != vary}
    c0, s0 = arith.cos_sin(fixed.pop("theta0"))
    others = [fixed[name] for name in NAMES[1:] if name != vary]
    for direction in _directions(arith, vary, exact, (c0, s0, *others), bits):
        c, s, _ = _on_circle(direction.t)
        u1, w1, u2, w2 = _LINES[vary](c, s, c0, s0, *others)
        value = -u1 / w1 if sign(arith, w1) else -u2 / w2
        found = {**fixed, vary: value}
        for point in _in_contact(arith, c, s, c0, s0, found["mu0"], tuple(found[name] for name in NAMES[2:])):
            exactly = Point((arith.exact(exact["theta0"]), *point.parameters[1:]), point.theta, point.L, point.x, point.y)
            yield _classified(arith, vary, exactly, (c, s, c0, s0), direction)


def _directions(
    arith: Arithmetic, vary: str, exact: dict[str, Fraction], values: tuple[Interval, ...], bits: int
) -> list[_Direction]:
    """All folds along a parameter other than θ₀, by their directions."""
    c0, s0, *others = values
    try:
        polynomial = polynomials.interpolate(_eliminated(vary, c0, s0, others, arith.exact), _DEGREE, arith.exact)
        roots = _positive_roots(polynomial, lambda v: sign(arith, v), arith.exact, bits // 2)
        return [_Direction(root.interval(arith)) for root in roots]
    except Undecided:
        common = _independent_of_theta0(vary, exact)
        if common is None:
            raise
        return _with_multiplicity(arith, common, _curvature(vary, exact), bits) if common else []


def _eliminated(
    vary: str, c0: Any, s0: Any, others: Sequence[Any], number: Callable[[Fraction], Any]
) -> Callable[[Fraction], Any]:
    """u₁ w₂ − u₂ w₁ times (1 + t²)³: zero at the folds, a polynomial in t."""

    def value(t: Fraction) -> Any:
        c, s, scale = (number(part) for part in _on_circle(t))
        u1, w1, u2, w2 = _LINES[vary](c, s, c0, s0, *others)
        return (u1 * w2 - u2 * w1) * scale ** (_DEGREE // 2)

    return value


def _independent_of_theta0(vary: str, exact: dict[str, Fraction]) -> polynomials.Polynomial | None:
    """The eliminated polynomial is g(θ₀) P(t): P, exactly, and () where there is no fold; nothing where it is not of that form.

    This is the form that it takes where it has multiple roots whatever θ₀ is, as for μ₀ = α = 0 and for μ₀ = 0, α = 1 + β.
    Its coefficients are of degree 4 in v = tan(θ₀/2), so that five values of v prove the form, or that all of it is 0.
    g(θ₀) ≠ 0, since v is transcendental for a rational θ₀ (Lindemann).
    """
    others = [exact[name] for name in NAMES[1:] if name != vary]
    common: polynomials.Polynomial = ()
    for v in _SAMPLES:
        c0, s0, _ = _on_circle(v)
        polynomial = polynomials.primitive(
            polynomials.interpolate(_eliminated(vary, c0, s0, others, Fraction), _DEGREE, Fraction)
        )
        if common and polynomial and polynomial not in (common, tuple(-value for value in common)):
            return None
        common = common or polynomial
    if not common and _lines_meet(vary, others):
        raise ConvergenceError(f"folds along {vary} are not isolated at these parameters: change one of the others a little")
    return common


#: Five different values of v, none of them special.
_SAMPLES = tuple(Fraction(number, 7) for number in range(1, 6))


def _lines_meet(vary: str, others: list[Fraction]) -> bool:
    """Whether two fold relations that are one and the same can hold at all.

    Where they are w₁ (λ − λ₀) = 0 and w₂ (λ − λ₀) = 0 with one λ₀ for all θ, f would be 0 for all θ at λ₀, and no parameters in
    their ranges have that (b < 0). What is left is w₁ = w₂ = 0: not for a transcendental v if not for some rational one.
    """
    rows = [
        _LINES[vary](*_on_circle(Fraction(number, 5))[:2], *_on_circle(v)[:2], *others)
        for number in range(-3, 4)
        for v in _SAMPLES
    ]
    ratio = next((-u1 / w1 if w1 else -u2 / w2 for u1, w1, u2, w2 in rows if w1 or w2), None)
    if ratio is None or any(u1 + ratio * w1 or u2 + ratio * w2 for u1, w1, u2, w2 in rows):
        return True
    c0, s0, _ = _on_circle(_SAMPLES[0])
    slopes = [
        polynomials.interpolate(_scaled(lambda c, s, place=place: _LINES[vary](c, s, c0, s0, *others)[place]), _DEGREE, Fraction)
        for place in (1, 3)
    ]
    common = polynomials.common_divisor(*slopes)
    return not common or bool(_positive_roots(polynomials.squarefree(common), polynomials.exact_sign, Fraction, 64))


def _scaled(function: Callable[..., Fraction], power: int = _DEGREE // 2) -> Callable[[Fraction], Fraction]:
    """A polynomial in cos θ and sin θ as one in t, times a power of 1 + t²."""

    def value(t: Fraction) -> Fraction:
        c, s, scale = _on_circle(t)
        return Fraction(function(c, s) * scale**power)

    return value


def _curvature(vary: str, exact: dict[str, Fraction]) -> list[polynomials.Polynomial]:
    """Polynomials in t, all zero where f″ = 0 on a fold: μ₀ (3 sin² θ − 2) = 3 (1 + β − α) sin θ cos θ, times (1 + t²)²."""
    even, odd = tuple(map(Fraction, (-2, 0, 8, 0, -2))), tuple(map(Fraction, (0, 2, 0, -2, 0)))
    if vary in ("alpha", "beta"):  # 1 + β − α is no rational there
        return [tuple(exact["mu0"] * value for value in even), odd]
    gap = 1 + exact["beta"] - exact["alpha"]
    return [tuple(exact["mu0"] * one - 3 * gap * other for one, other in zip(even, odd, strict=True))]


def _with_multiplicity(
    arith: Arithmetic, polynomial: polynomials.Polynomial, curvature: list[polynomials.Polynomial], bits: int
) -> list[_Direction]:
    """The positive roots of an exact polynomial, each with its multiplicity."""
    repeated = polynomials.common_divisor(polynomial, polynomials.derivative(polynomial))
    again = polynomials.common_divisor(repeated, polynomials.derivative(repeated))
    found = []
    for root in _positive_roots(polynomials.without(polynomial, repeated), polynomials.exact_sign, Fraction, bits - 32):
        multiplicity, flat = 1, False
        if root.is_of(repeated):
            multiplicity = 3 if root.is_of(again) else 2
            flat = all(root.is_of(polynomials.common_divisor(repeated, one)) for one in curvature)

        def is_zero(function: Callable[[Fraction], Fraction], root: _Root = root) -> bool:
            other = polynomials.interpolate(function, _DEGREE_IN_THETA0, Fraction)
            return root.is_of(polynomials.common_divisor(polynomial, other))

        found.append(_Direction(root.interval(arith), multiplicity, flat, is_zero))
    return found


def _classified(
    arith: Arithmetic, vary: str, point: Point, angles: tuple[Interval, ...], direction: _Direction, *, across: bool = True
) -> Fold:
    """The kind of a fold, from signs of the derivatives of f by θ and by the parameter λ that varies.

    The multiplicity of its root is the number of times that f = 0 and f′ = 0 meet there. Once: then f_λ f″ ≠ 0, a fold.
    More often: f_λ = 0 ("touch": two equilibria meet, and their number is the same on both sides) or f″ = 0. With f″ = 0 it is 2
    where f_λ ≠ 0 ("cusp": three meet in one, and one is on both sides), since f‴ ≠ 0 for a quartic in t with a negative root;
    3 is a pitchfork. ``across`` says that f_λ = 0 only if f_{sin θ₀} is, which fails at θ₀ = π/2 where f knows sin θ₀ alone.
    """
    trig = kernel.f_coefficients(angles[2], angles[3], *point.parameters[1:], 1)
    if direction.flat and direction.multiplicity == 2 and across:
        return Fold(point, "cusp", 0, False)
    slope, cross = _catastrophe.unfolding(*angles, *point.parameters[1:])[NAMES.index(vary)]
    if direction.flat and across:
        third = decided(arith, kernel.f_third(*angles[:2], *trig), "f‴ on a pitchfork")
        return Fold(point, "pitchfork", -third * decided(arith, cross, "f′ by the parameter on a pitchfork"), False)
    curvature = decided(arith, kernel.f_curvature(*angles[:2], *trig), "f″ on a fold") if not direction.flat else 0
    if direction.multiplicity > 1 or not across:
        return Fold(point, "touch", 0, curvature > 0)
    return Fold(point, "fold", -curvature * decided(arith, slope, "f by the parameter on a fold"), curvature > 0)


def _folds_in_theta0(arith: Arithmetic, exact: dict[str, Fraction], bits: int) -> Iterator[Fold]:
    """s₀² + c₀² = 1 on the fold is exact in rationals; with α = 0, where cos θ₀ is free, it is the second relation."""
    given = tuple(exact[name] for name in ("mu0", "kappa", "alpha", "sigma", "beta"))
    mu0, kappa, alpha, sigma, beta = given

    def sine(c: Any, s: Any, values: tuple[Any, ...]) -> Any:
        friction, kappa, alpha, sigma, beta = values
        return _catastrophe.fold_sine(c, s, friction, kappa, alpha, sigma, beta)

    def eliminated(c: Fraction, s: Fraction) -> Fraction:
        if alpha:
            s0, c0 = _catastrophe.fold_angles(c, s, mu0, kappa, alpha, sigma, beta)
            return Fraction(s0**2 + c0**2 - 1)
        e0, e1, e2 = _catastrophe.fold_quadratic(c, s, kappa, sigma, beta)
        return Fraction(e0 + mu0 * (e1 + mu0 * e2))

    half = _DEGREE_IN_THETA0 // 2
    polynomial = polynomials.primitive(polynomials.interpolate(_scaled(eliminated, half), _DEGREE_IN_THETA0, Fraction))
    if not polynomial and (mu0 or alpha != 1 + beta):  # for μ₀ = 0 and α = 1 + β tan θ is a number: there is no fold
        raise ConvergenceError("folds along theta0 are not isolated at these parameters: change one of them a little")
    values = tuple(map(arith.exact, given))
    for direction in _with_multiplicity(arith, polynomial, _curvature("theta0", exact), bits):
        c, s, _ = _on_circle(direction.t)
        s0 = sine(c, s, values)
        if _sign_or_zero(arith, s0, direction, _scaled(lambda c, s: sine(c, s, given), half), "sin θ₀ = 0 on a fold") <= 0:
            continue
        upright = False
        if alpha:
            cosines = [_catastrophe.fold_angles(c, s, *values)[1]]
        else:
            gap = 1 - s0 * s0
            beyond = _scaled(lambda c, s: 1 - sine(c, s, given), half)
            side = _sign_or_zero(arith, gap, direction, beyond, "sin θ₀ = 1 on a fold")
            upright = side == 0
            cosines = [] if side < 0 else [arith.exact(Fraction(0))] if upright else [arith.sqrt(gap), -arith.sqrt(gap)]
        for c0 in cosines:
            for point in _in_contact(arith, c, s, c0, s0, values[0], values[1:]):
                yield _classified(arith, "theta0", point, (c, s, c0, s0), direction, across=not upright)


def _sign_or_zero(
    arith: Arithmetic, value: Interval, direction: _Direction, exactly: Callable[[Fraction], Fraction], what: str
) -> int:
    """The sign of an interval, and 0 where it holds 0 and ``exactly`` vanishes in that direction."""
    result = sign(arith, value)
    return 0 if result == 0 and direction.is_zero(exactly) else decided(arith, value, what)


@dataclass(frozen=True)
class _Root:
    """A real root of a polynomial in (low, high], or of the reversed polynomial: then it is the reciprocal."""

    low: Fraction
    high: Fraction
    backward: bool = False

    def interval(self, arith: Arithmetic) -> Interval:
        """Around the root."""
        value = arith.between(self.low, self.high)
        return 1 / value if self.backward else value

    def is_of(self, polynomial: polynomials.Polynomial) -> bool:
        """Whether it is one of a divisor of its polynomial."""
        chart = tuple(reversed(polynomial)) if self.backward else polynomial
        return polynomials.has_root(chart, self.low, self.high)


#: Ends of the two charts: no round numbers, where Sturm functions of symmetric parameters vanish.
_BELOW, _BETWEEN = Fraction(-1, 7), Fraction(13, 11)


def _positive_roots(
    polynomial: tuple[Any, ...], signs: Callable[[Any], int], number: Callable[[Fraction], Any], bits: int
) -> list[_Root]:
    """Roots t > 0: those up to a little over 1, and beyond as reciprocals of the reversed polynomial's."""
    found: list[_Root] = []
    if len(polynomial) <= 1:
        return found
    for chart, limit, backward in ((polynomial, _BETWEEN, False), (tuple(reversed(polynomial)), 1 / _BETWEEN, True)):
        for low, high in polynomials.real_roots(chart, _BELOW, limit, signs, number, bits):
            if high > 0:
                found.append(_Root(low, high, backward))
    return found
