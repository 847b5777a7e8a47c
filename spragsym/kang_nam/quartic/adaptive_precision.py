"""All equilibria of one point in interval arithmetic of adaptive precision, with certified count
and digits.

Parameters are exact rationals. The sign of the discriminant gives the number of real roots of the
quartic in t = tan(θ/2); each is enclosed between two numbers at which f has opposite signs. If an
interval can't decide, the bits are doubled, up to :data:`MAXIMUM_BITS`; if the discriminant still
contains 0 then, the point is reported as a fold.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

from ...core.errors import ConvergenceError
from ...core.questions import NotInClosedForm
from ...generated.quantities import PARAMETERS
from ...numerics import balls
from ...numerics.balls import Ball, Interval, UndecidedSign, as_mpf, as_numbers
from ...numerics.polynomials import derivative, evaluate, on_circle, roots_on_the_line, squarefree
from ...results.equilibria import EquilibriumType
from ...results.precise_states import PreciseEquilibria, PreciseEquilibrium
from .. import kernel
from ..parameters import Parameters

#: Bits at which a discriminant that contains 0 is taken for a fold.
MAXIMUM_BITS = 4096


def precise_equilibria(
    _p: Parameters, exact: Mapping[str, Any], contact: bool | None, digits: int
) -> PreciseEquilibria:
    """All equilibria of one point; source: f(θ) = 0, (12)–(13) eliminated."""
    if not isinstance(contact, bool | None):
        raise NotInClosedForm  # the general algorithm says what contact may be
    values = (exact[name] for name in PARAMETERS)
    return equilibria(*values, contact=contact is not False, digits=digits)


def equilibria(*exact: Any, contact: bool = True, digits: int = 17) -> PreciseEquilibria:
    """All equilibria of one point, ascending in θ, to ``digits`` digits.

    Parameters, θ₀, μ₀, κ, α, σ and β, are anything that :class:`fractions.Fraction` takes exactly:
    float, int, str, Fraction; θ₀ may be a function of the arithmetic that returns an interval.
    """
    theta0, rational = exact[0], [Fraction(value) for value in exact[1:]]
    spread = _spread(theta0, rational)
    # A parameter far below the others makes the deciding quantities small: more bits are needed.
    bits = max(128, 96 + spread, int(3.4 * digits) + 64)
    # The discriminant is of the sixth degree in coefficients of the parameters.
    most = MAXIMUM_BITS + 8 * spread
    while True:
        with balls.precision(bits):
            try:
                return _settle(theta0, rational, contact, digits, bits, bits >= most)
            except UndecidedSign as reason:
                if bits >= most:
                    raise ConvergenceError(
                        f"{bits} bits do not settle {named(exact)}: {reason}; move the point "
                        "off the boundary that it is on"
                    ) from None
        bits *= 2


def named(point: Iterable[Any]) -> str:
    """A point as text, for errors."""
    return ", ".join(f"{name}={value}" for name, value in zip(PARAMETERS, point, strict=True))


def _spread(theta0: Callable[[], Ball] | Fraction, rational: list[Fraction]) -> int:
    """The base-2 logarithm of the ratio of the largest parameter to the smallest."""
    given = [Fraction(1), *rational, *([] if callable(theta0) else [Fraction(theta0)])]
    powers = [
        value.numerator.bit_length() - value.denominator.bit_length() for value in given if value
    ]
    return max(powers) - min(powers)


def _settle(
    theta0: Callable[[], Ball] | Fraction,
    rational: list[Fraction],
    contact: bool,
    digits: int,
    bits: int,
    last: bool,
) -> PreciseEquilibria:
    """One attempt with given bits; with ``last``, a discriminant that contains 0 is a fold."""
    angle = theta0() if callable(theta0) else balls.exact(Fraction(theta0))
    values = (*balls.cos_sin(angle), *map(balls.exact, rational), int(contact))
    trig = kernel.f_coefficients(*values)
    P, Q = kernel.depressed(*kernel.resolvent(*trig))
    discriminant = balls.sign(P * P * P + Q * Q)
    fold = discriminant == 0
    if fold and not last:
        raise UndecidedSign("the discriminant holds 0")
    quartic = kernel.t_quartic(*trig)
    roots = (
        _fold_roots(trig, quartic, bits)
        if fold
        else _enclosed_roots(quartic, bits, all_real=discriminant < 0)
    )
    # With rational parameters equality is exact where θ₀ drops out: off the belt without other
    # springs L = 1 ± κ/σ at θ = ±90°.
    _, kappa, alpha, sigma, beta = rational
    shrunk = not contact and alpha == beta == 0 and kappa == sigma
    states = [state for root in roots for state in _state(root, trig, values, digits, fold, shrunk)]
    if contact and len(states) % 2 == 0:
        raise UndecidedSign("an even number of equilibria in contact")
    return PreciseEquilibria(tuple(sorted(states, key=lambda state: state.theta)), True, {})


# ------------------------------------------------------------------------------------------------
# roots


def _places(polynomial: tuple[Interval, ...], bits: int) -> list[Interval]:
    """Real roots of the polynomial of the middles of coefficients."""
    lowest = min(value.exp for value in polynomial)
    middles = squarefree(tuple(value.mid << value.exp - lowest for value in polynomial))
    return [balls.middle(root.interval()) for root in roots_on_the_line(middles, bits)]


def _enclosed_roots(quartic: tuple[Interval, ...], bits: int, *, all_real: bool) -> list[Interval]:
    """Disjoint intervals in t, each with a change of sign of f: as many as there are real roots,
    four or two, so one in each.
    """
    found = [_enclose(quartic, root, bits) for root in _places(quartic, bits)]
    if len(found) != (4 if all_real else 2):
        raise UndecidedSign("the middles of coefficients have other roots")
    for (low, high), (other_low, other_high) in itertools.combinations(found, 2):
        if balls.sign(low - other_high) <= 0 and balls.sign(other_low - high) <= 0:
            raise UndecidedSign("two roots share an interval")
    return [balls.union(*ends) for ends in found]


def _enclose(quartic: tuple[Interval, ...], root: Interval, bits: int) -> tuple[Interval, Interval]:
    """Numbers below and above ``root`` at which the quartic has opposite signs."""
    size = -root if balls.sign(root) < 0 else root
    for lost in range(16, bits, 16):
        width = size * balls.exact(Fraction(1, 1 << bits - lost))
        low, high = balls.middle(root - width), balls.middle(root + width)
        if balls.sign(evaluate(quartic, low)) * balls.sign(evaluate(quartic, high)) < 0:
            return low, high
    raise UndecidedSign("no change of sign around a root")


def _fold_roots(
    trig: tuple[Interval, ...], quartic: tuple[Interval, ...], bits: int
) -> list[Interval]:
    """Roots at a fold: the two that can't be told apart share one interval, twice. All four
    multiply to −1.
    """
    slope = derivative(quartic)
    bend = derivative(slope)
    flat = [*_places(slope, bits), *_places(bend, bits)]
    flattest = min(flat, key=lambda t: max(map(abs, balls.ends(evaluate(quartic, t)))))
    three, two = (
        flattest * balls.between(1 - off, 1 + off)
        for off in (Fraction(16, 1 << bits // alike) for alike in (3, 2))
    )
    double = two if balls.sign(evaluate(bend, three)) else three  # at a cusp three are alike
    third = kernel.landing(double, trig, balls.sqrt)
    return [double, double, third, -1 / (double * double * third)]


# ------------------------------------------------------------------------------------------------
# states


def _state(
    t: Interval,
    trig: tuple[Interval, ...],
    values: tuple[Any, ...],
    digits: int,
    fold: bool,
    shrunk: bool,
) -> list[PreciseEquilibrium]:
    """The equilibrium at a root t; none if the root is no equilibrium, or if ``shrunk`` and L
    = 0.
    """
    cos0, sin0, _, kappa, _, *springs, nbar = values
    c, s, _ = on_circle(t)
    state = kernel.state(c, s, cos0, sin0, kappa, *springs, nbar)
    sides = balls.sign(state[0]), balls.sign(state[2]) * (-1 if nbar else 1)
    if -1 in sides or (shrunk and not sides[0]):
        return []
    if 0 in sides:
        raise UndecidedSign("L or y holds 0")
    found, error, _ = as_numbers((2 * balls.atan(t), *state), None if fold else digits)
    numbers = dict(zip(("theta", "L", "x", "y"), found, strict=True))
    return [
        PreciseEquilibrium(
            numbers,
            EquilibriumType(_stability(c, s, state[0], trig, values, fold)),
            as_mpf(error),
            fold,
        )
    ]


def _stability(
    c: Interval,
    s: Interval,
    L: Interval,
    trig: tuple[Interval, ...],
    values: tuple[Any, ...],
    fold: bool,
) -> int:
    _, _, mu0, _, *others = values
    trace, _, flutter = map(balls.sign, kernel.invariants(c, s, L, mu0, *others))
    slope = balls.sign(kernel.f_slope(c, s, *trig))
    if flutter < 0:
        return 3
    if flutter == 0 or (slope == 0 and not fold) or (slope >= 0 and trace == 0):
        raise UndecidedSign("a stability boundary")
    # On a fold one λ is 0; the others decide, as they do on the stable side.
    return 2 if slope < 0 or trace < 0 else 1
