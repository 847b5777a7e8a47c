"""The critical friction: the least at which the reference state ends, over 0 < θ₀ < π."""

import math
from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from ..core.questions import NotInClosedForm
from ..generated import catastrophe as _catastrophe
from ..numerics import balls, polynomials
from ..numerics.balls import as_floats, decided, sign, with_enough_bits
from ..numerics.polynomials import RootOf, on_circle
from ..results import CriticalLoad
from . import kernel
from .cusps import proved_cusps
from .folds import Angles, SurfacePoint, in_contact, lines_and_sextic, unfolded, with_multiplicity
from .kernel import Fixed
from .parameters import Parameters


def critical_friction(
    p: Parameters, vary: str | None = None, over: str | None = None
) -> CriticalLoad:
    """The closed form of :func:`spragsym.critical_friction` as friction rises at any 0 < θ₀ < π; of
    arrays too.

    Notes
    -----
    Source: the ledger, "The critical friction". Candidates are the cusps, the points f = f′ = f_θ₀
    = 0 with f″ < 0, whose sin θ is a root of a polynomial of degree 9, and the folds at θ₀ = 0; all
    are isolated exactly, and the least is the answer. A cusp counts also where it is degenerate in
    (θ₀, μ₀). Of several that agree to 25 digits, a cusp is named first.

    Examples
    --------
    >>> critical_friction(Parameters(kappa=0.02, alpha=0.5, sigma=2.0, beta=0.0)).kind
    'turn'
    """
    if vary not in (None, "mu0") or over not in (None, "theta0") or p.followed is not None:
        raise NotInClosedForm
    columns = np.broadcast_arrays(*(p[name] for name in Fixed._fields))
    return CriticalLoad(
        "mu0", "theta0", *np.vectorize(_lowest, otypes=[float, float, str, float])(*columns)
    )[()]  # numbers of one point


def _lowest(*values: float) -> tuple[float, float, str, float]:
    """The critical friction of one set of parameters: friction, angle, kind and error."""
    exact = tuple(map(Fraction, values))

    def attempt(bits: int) -> tuple[float, float, str, float]:
        least: tuple[Fraction, SurfacePoint, str] | None = None
        for point, kind in _candidates(exact, bits):
            above = balls.ends(point.parameters[1])[1]
            if least is None or above < least[0] - abs(least[0]) / 10**25:
                least = above, point, kind
        if least is None:
            return math.inf, math.nan, "", 0.0
        (mu0, theta0), error = as_floats((least[1].parameters[1], least[1].parameters[0]))
        return mu0, theta0, least[2], error

    return with_enough_bits(40, attempt, "the critical friction")


def _candidates(exact: tuple[Fraction, ...], bits: int) -> Iterator[tuple[SurfacePoint, str]]:
    """The points among which it is, with their kinds."""
    for point in proved_cusps(exact, bits):
        theta0, mu0, *_ = point.parameters
        # θ₀ of a level cusp, and the friction of an upright one with α = 0, are exactly 0.
        inclined = not balls.is_exactly_zero(theta0) and decided(theta0, "θ₀ = 0 on a cusp") > 0
        leans_forward = inclined and decided(balls.pi() - 2 * theta0, "θ₀ = π/2 on a cusp") > 0
        if leans_forward and (balls.is_exactly_zero(mu0) or decided(mu0, "μ₀ = 0 on a cusp") > 0):
            yield point, "cusp"
    yield from ((point, "turn") for point in turning_points(exact, bits))
    yield from ((point, "end") for point in level_folds(exact, bits))


def turning_points(exact: tuple[Fraction, ...], bits: int) -> Iterator[SurfacePoint]:
    """Every point with f = f′ = f_θ₀ = 0, f″ < 0, 0 < θ₀ < π/2 and μ₀ > 0, for exact κ, α, σ, β;
    none for α = 0.

    f″ < 0 means that the lower two of three states meet in θ, so that rising friction ends the
    lowest one.
    """
    if not exact[1]:
        return
    polynomial = polynomials.squarefree(_catastrophe.turning_polynomial(*exact))
    for root in polynomials.real_roots(polynomial, Fraction(0), Fraction(1), bits - 32):
        yield from _turning_at(exact, RootOf(polynomial, *root))


def _turning_at(exact: tuple[Fraction, ...], sine: RootOf) -> Iterator[SurfacePoint]:
    """The turning point at a value of sin θ, if it satisfies the inequalities."""
    values = tuple(map(balls.exact, exact))
    s = sine.interval()
    numerator, denominator = _catastrophe.turning_sine(s, *values)
    s0 = numerator / denominator

    def ratio(s: Fraction) -> tuple[Fraction, Fraction]:
        return _catastrophe.turning_sine(s, *exact)

    degree = 6  # of sin θ₀ in sin θ
    if sine.sign_of(s0, lambda s: ratio(s)[0], degree, "sin θ₀ = 0 at a turn") <= 0:
        return
    if (
        sine.sign_of(1 - s0, lambda s: ratio(s)[1] - ratio(s)[0], degree, "sin θ₀ = 1 at a turn")
        <= 0
    ):
        return
    c0 = balls.sqrt(1 - s0 * s0)
    angles = Angles(_catastrophe.turning_cosine(s, s0, *values) / c0, s, c0, s0)
    mu0 = _catastrophe.surface(*angles, *values)
    trig = kernel.f_coefficients(c0, s0, mu0, *values, 1)

    def cusp(s: Fraction) -> Fraction:
        above, below = ratio(s)
        return (above - below * Fraction(_catastrophe.cusp_sine(s, *exact)[0])) * (3 * s * s - 2)

    curvature = kernel.f_curvature(angles.c, s, *trig)
    # f″ times the denominator of sin θ₀ has degree 9 in sin θ.
    if sine.sign_of(curvature, cusp, 9, "f″ = 0 at a turn") < 0:
        for point in in_contact(angles, mu0, *values):
            if decided(mu0, "μ₀ = 0 at a turn") > 0:
                yield point


def level_folds(exact: tuple[Fraction, ...], bits: int) -> Iterator[SurfacePoint]:
    """Every fold at θ₀ = 0 with f″ < 0 and μ₀ > 0, and every cusp there from which folds with θ₀ >
    0 start.
    """
    level = Fraction(1), Fraction(0)
    polynomial = polynomials.primitive(lines_and_sextic("mu0", *level, exact)[2])
    values = tuple(map(balls.exact, exact))
    for direction in with_multiplicity(polynomial, [], bits):
        c, s, _ = on_circle(direction.t)
        angles = Angles(c, s, *map(balls.exact, level))
        mu0 = _catastrophe.surface(*angles, *values)
        curvature = kernel.f_curvature(
            c, s, *kernel.f_coefficients(angles.c0, angles.s0, mu0, *values, 1)
        )
        end = (
            sign(curvature)
            if direction.multiplicity > 1
            else decided(curvature, "f″ = 0 on a fold at θ₀ = 0")
        )
        if end == 0:
            end = decided(unfolded(angles, mu0, *values), "how a cusp at θ₀ = 0 opens")
        if end < 0 and decided(mu0, "μ₀ = 0 on a fold at θ₀ = 0") > 0:
            yield from in_contact(angles, mu0, *values)
