"""A second route to what the check decides: Newton's law on the free body, in complex numbers, at
50 digits.

Nothing here uses the symbolic derivation. The spring's pull is a vector along the line to its
anchor, equilibria are found by Newton's method on the sum of forces, and the forces themselves are
compared with differences of the energy. It confirms the algebra of a corrected row and computes
what a misprint would cost.
"""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from numbers import Rational
from typing import Any

import mpmath
from mpmath import mpf

from . import article
from . import nomenclature as nm

DIGITS = 50


@dataclass(frozen=True)
class ParameterPoint:
    """Numbers for the parameters; ``theta0_deg`` in degrees, the rest exact rationals."""

    theta0_deg: Rational = Fraction(49)  #: of Figure 7a
    mu0: Rational = article.BASE[nm.mu0]
    kappa: Rational = article.BASE[nm.kappa]
    alpha: Rational = article.BASE[nm.alpha]
    sigma: Rational = article.BASE[nm.sigma]
    beta: Rational = article.BASE[nm.beta]

    def number(self, name: str, arithmetic: mpmath.MPContext = mpmath.mp) -> mpf:
        """A parameter in the working precision; the angle in radians."""
        value = getattr(self, "theta0_deg" if name == "theta0" else name)
        exact = arithmetic.mpf(value.numerator) / value.denominator
        return exact * arithmetic.pi / 180 if name == "theta0" else exact


def anchor(point: ParameterPoint, arithmetic: mpmath.MPContext = mpmath.mp) -> mpmath.mpc:
    """Place at which the inclined spring is held, over L_0."""
    return arithmetic.expj(point.number("theta0", arithmetic))


def forces(
    point: ParameterPoint, x: mpf, y: mpf, contact: mpf, arithmetic: mpmath.MPContext = mpmath.mp
) -> tuple[mpf, mpf]:
    """Minus the sum of forces on the mass at rest, over k_c L_0; ``contact`` is the contact
    stiffness over k_c.
    """
    sigma, alpha, mu0, beta, kappa = (
        point.number(name, arithmetic) for name in ("sigma", "alpha", "mu0", "beta", "kappa")
    )
    spring = anchor(point, arithmetic) - arithmetic.mpc(x, y)
    pull = sigma * (abs(spring) - 1) * spring / abs(spring)
    push = -contact * y
    return alpha * x - pull.real - mu0 * push, beta * y - pull.imag - push + kappa


def energy_slope_y(point: ParameterPoint, x: mpf, y: mpf, contact: mpf) -> mpf:
    """∂/∂y of the energy of springs, contact and preload, by numerical differentiation."""

    def energy(height: mpf) -> mpf:
        stretch = abs(anchor(point) - mpmath.mpc(x, height)) - 1
        springs = point.number("sigma") * stretch**2 + (point.number("beta") + contact) * height**2
        return springs / 2 + point.number("kappa") * height

    return mpmath.diff(energy, y)


@cache
def equilibria(point: ParameterPoint, contact: int | Fraction = 1) -> list[tuple[mpf, mpf]]:
    """Rest positions (x, y) in contact, or in lift-off for ``contact=0``, sorted by x.

    Newton's method from a grid of starting points, first in floats, then in the precision of the
    first call. There may be states that it does not find.
    """

    def root(arithmetic: mpmath.MPContext, start: tuple[Any, Any], **options: Any) -> Sequence[mpf]:
        stiffness = arithmetic.mpf(Fraction(contact).numerator) / Fraction(contact).denominator
        return arithmetic.findroot(
            lambda x, y: forces(point, x, y, stiffness, arithmetic), start, **options
        )

    found: list[tuple[mpf, mpf]] = []
    # Spring vectors to start from: directions all around, two lengths.
    starts = [
        cmath.rect(length, (2 * step + 1) * cmath.pi / 8)
        for length in (1, 0.5)
        for step in range(8)
    ]
    for start in starts:
        position = anchor(point, mpmath.fp) - start
        try:
            rough = root(mpmath.fp, (position.real, position.imag), maxsteps=10)
        except (ValueError, ZeroDivisionError):
            continue
        if (rough[1] < 0) == (contact > 0) and all(
            abs(rough[0] - x) + abs(rough[1] - y) > 1e-7 for x, y in found
        ):
            found.append(tuple(root(mpmath.mp, tuple(map(mpf, rough)))))
    return sorted(found)


def spring_length(point: ParameterPoint, x: mpf, y: mpf) -> mpf:
    """Distance from the anchor to the mass, as a distance in the complex plane."""
    return abs(anchor(point) - mpmath.mpc(x, y))


def show(value: mpf, digits: int = 12) -> str:
    """A number for the ledger."""
    return str(mpmath.nstr(value, digits))
