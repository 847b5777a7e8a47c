"""Normal form of a Hopf point: the first Lyapunov coefficient, with a bound on its error that is
proved.

At a Hopf point of u′ = F(u), with A q = i ω q, Aᵀ p = −i ω p, ⟨q, q⟩ = ⟨p, q⟩ = 1, B and C the
second and third derivatives of F,

    l₁ = Re [⟨p, C(q, q, q̄)⟩ − 2 ⟨p, B(q, A⁻¹ B(q, q̄))⟩ + ⟨p, B(q̄, (2 i ω − A)⁻¹ B(q, q))⟩] / (2
    ω)

(Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, section 5.4). The state u is the
coordinates, then their rates, in the model's units. Everything is computed in balls around the
point, so that the exact coefficient lies in the result.

Derivatives come from Taylor polynomials: along u = z q + z̄ q̄ + ½ g z² + h z z̄ + ½ ḡ z̄², with g
= (2 i ω − A)⁻¹ B(q, q) and h = −A⁻¹ B(q, q̄), the coefficient of z² z̄ in F is half of what stands
in brackets.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from ..models import Model
from ..models.field import undecorated
from ..numerics import balls
from ..numerics.arithmetic import Complex, Matrix, Number, as_complex, solved
from ..numerics.balls import XP, Ball, UndecidedSign, ball
from ..numerics.interval_arrays import ComplexArray, FloatArray
from ..numerics.jets import Jet, constant, gradient, variables
from ..statics.balance import Balance, PreciseBalance
from ..statics.forces import Values

#: Bits of all balls; the box around the point has some fifty of them.
BITS = 106
#: Room for the rounding of middles to floats, relatively.
ROOM = 2.0**-50


@dataclass(frozen=True)
class NormalForm:
    """Normal form of a Hopf point; every ``…_error`` bounds the absolute error of the number before
    it.

    Attributes
    ----------
    omega, omega_error : float
        ω.
    lyapunov, lyapunov_error : float
        l₁.
    crossing, crossing_error : float
        d Re λ / d parameter of the pair, along the equilibrium: it crosses the imaginary axis if
        that is not 0.
    q, p : ndarray of complex
        The eigenvector of i ω, of length 1, and that of Aᵀ for −i ω, with ⟨p, q⟩ = p̄ᵀ q = 1.
    reach : float
        |z| of u = z q + z̄ q̄ at which the sliding speed would come to 0, to first order, in
        floats; infinite without friction.
    along, square, mean : ndarray
        Of floats: ∂u/∂parameter of the equilibrium, g and h of the module's first lines.
    """

    omega: float
    omega_error: float
    lyapunov: float
    lyapunov_error: float
    crossing: float
    crossing_error: float
    q: ComplexArray
    p: ComplexArray
    reach: float
    along: FloatArray
    square: ComplexArray
    mean: FloatArray


def normal_form(
    model: Model,
    given: FloatArray,
    state: FloatArray,
    vary: str | Sequence[str],
    radii: FloatArray,
    law: str = "friction_at_rest",
) -> NormalForm:
    """The normal form at a Hopf point that is proved to lie in a box.

    ``given`` are the parameters in the order of the model, ``state`` the coordinates, ``vary`` the
    parameter along which the point was found, or several, of which the first tells the pair's
    crossing; ``radii`` are half-widths of the box, of the coordinates and then of these. ``law`` is
    the friction of the equilibrium: ``"friction_at_rest"``, as statics takes it, or
    ``"friction_at_speed"``, that at the belt's speed; the motion's law is shifted by a constant so
    that it passes through it. Undecided, and the text says why, where this is no generic Hopf
    point, or is not shown to be one.
    """
    point = _Point(model, given, state, (vary,) if isinstance(vary, str) else vary, radii, law)
    point.require_smooth()
    A, by_parameter = point.linear()
    omega, q, left = _pair(A)
    along = _solved(A, [-entry for entry in by_parameter])

    # Σ of second order in a, b and c: along 2 (a Re q − b Im q), and along the equilibrium with c.
    path = [
        Jet({(): u, (0,): 2 * z.re, (1,): -2 * z.im, (2,): slope}, 2)
        for u, z, slope in zip(point.state, q, along, strict=True)
    ]
    rows = point.field(path, Jet({(): point.parameter, (2,): 1}, 2))

    def term(*numbers: int) -> list[Ball]:
        return [_ball(row.terms.get(numbers, 0) if isinstance(row, Jet) else 0) for row in rows]

    aa, ab, bb, ac, bc = term(0, 0), term(0, 1), term(1, 1), term(0, 2), term(1, 2)
    # B(q, q) is twice the coefficient of z², B(q, q̄) that of z z̄, for z = a + i b.
    twice = [Complex((x - z) / 2, -y / 2) for x, y, z in zip(aa, ab, bb, strict=True)]
    mean = _solved(A, [-(x + z) / 2 for x, z in zip(aa, bb, strict=True)])
    shifted = [
        [Complex(-entry, 2 * omega if i == j else _ball(0)) for j, entry in enumerate(row)]
        for i, row in enumerate(A)
    ]
    square = _solved(shifted, twice)
    scale = _product(left, q)
    # The coefficient of z c: d(A q)/dc.
    crossing = (
        _product(left, [Complex(x / 2, -y / 2) for x, y in zip(ac, bc, strict=True)]) / scale
    ).re

    path = [
        Jet(
            {
                (): u,
                (0,): 2 * z.re,
                (1,): -2 * z.im,
                (0, 0): m + g.re,
                (0, 1): -2 * g.im,
                (1, 1): m - g.re,
            },
            3,
        )
        for u, z, g, m in zip(point.state, q, square, mean, strict=True)
    ]
    rows = point.field(path, point.parameter)
    aaa, aab, abb, bbb = term(0, 0, 0), term(0, 0, 1), term(0, 1, 1), term(1, 1, 1)
    cubic = [
        Complex((3 * x + z) / 8, -(y + 3 * w) / 8)
        for x, y, z, w in zip(aaa, aab, abb, bbb, strict=True)
    ]
    lyapunov = (_product(left, cubic) / scale).re / omega
    return NormalForm(
        *_float(omega),
        *_float(lyapunov),
        *_float(crossing),
        _floats(q),
        _floats([entry / scale for entry in left]).conjugate(),
        point.reach(path),
        _floats(along).real,
        _floats(square),
        _floats(mean).real,
    )


class _Side:
    """1 or −1, it is not said which: all that is known is its square."""

    def __mul__(self, other: object) -> Any:
        return 1 if other is self else NotImplemented


class _Point:
    """The field around a state at steady sliding, of balls and jets of balls."""

    def __init__(
        self,
        model: Model,
        given: FloatArray,
        state: FloatArray,
        vary: Sequence[str],
        radii: FloatArray,
        law: str,
    ) -> None:
        self.model, self.vary, self.balance = model, vary[0], Balance(model, True, law)
        self.n = self.balance.n
        at = [*state, *(given[self.balance.parameters.index(name)] for name in vary)]
        ends = [
            (Fraction(x) - Fraction(r), Fraction(x) + Fraction(r))
            for x, r in zip(at, radii, strict=True)
        ]
        with balls.precision(BITS):
            q = [balls.between(*each) for each in ends[: self.n]]
        spans = dict(zip(vary, ends[self.n :], strict=True))
        self.values: dict[str, Any] = PreciseBalance(self.balance, given, BITS, spans).arguments
        self.parameter: Ball = self.values[self.vary]
        self.state = [*q, *(_ball(0) for _ in q)]
        self.motion = model.field
        floats = [float(value) for value in state] + [0.0] * self.n
        mode = self.motion.mode_at_rest(floats, self.motion.constants(given.tolist()))
        self.mode = self.motion.exact(mode)

    def field(self, u: Sequence[Any], parameter: Number) -> list[Any]:
        """F: the rates, then the accelerations, with the law of friction shifted to that of the
        equilibrium.
        """
        values = self._values(parameter)
        accelerations = self.motion.acceleration(u, self._constants(values), self.mode, XP)
        return [
            *u[self.n :],
            *(a + s for a, s in zip(accelerations, self._shift(u[: self.n], values), strict=True)),
        ]

    def reach(self, path: Sequence[Jet]) -> float:
        """Size of a and b, along a path in them, at which the sliding speed would come to 0."""
        if self.model.friction_law is None:
            return math.inf
        _, slip = undecorated(self.model.algebra.borders)(
            *path, *self._constants(self.values), xp=XP
        )
        terms = slip.terms if isinstance(slip, Jet) else {}
        rest, one, other = (_float(terms.get(key, 0))[0] for key in ((), (0,), (1,)))
        change = math.hypot(one, other)
        return abs(rest) / change if change else math.inf

    def linear(self) -> tuple[list[list[Ball]], list[Ball]]:
        """A, and ∂F/∂parameter."""
        *u, parameter = variables([*self.state, self.parameter], 1)
        slopes = [list(map(_ball, gradient(row, len(u) + 1))) for row in self.field(u, parameter)]
        return [row[:-1] for row in slopes], [row[-1] for row in slopes]

    def require_smooth(self) -> None:
        """:class:`UndecidedSign` where the field has no third derivatives at the state, or is not
        shown to have them.
        """
        constants = self._constants(self.values)
        gap, slip = undecorated(self.model.algebra.borders)(*self.state, *constants, xp=XP)
        contact = self.model.contact
        if contact["border"] and not balls.sign(gap) * (2 * self.mode[0] - 1) < 0:
            line = contact["line"]
            raise UndecidedSign(
                f"the state lies on the border of contact, where the law of line {line} of "
                "the model page has a kink"
            )
        if (
            self.model.friction_law is not None
            and not balls.sign(slip) > 0
            and self._asks_for_the_side()
        ):
            line = self.model.friction_law["line"]
            raise UndecidedSign(
                f"the sliding speed is 0, where the law of friction, line {line} of the model "
                "page, has a kink"
            )
        ways = self.mode[len(self.mode) - self.motion.torsion_sides :]
        if ways:
            levels = undecorated(self.model.algebra.turning_borders)(
                *self.state, *constants, *ways, xp=XP
            )
            if not all(balls.sign(level) > 0 for level in levels):
                raise UndecidedSign("a torsion spring is turned by π, where its torque jumps")

    def _asks_for_the_side(self) -> bool:
        """Whether the law depends on the side of slip = 0 otherwise than by its square: algebra
        with it is then an error.
        """
        try:
            self.motion.acceleration(
                self.state,
                self._constants(self.values),
                (self.mode[0], _Side(), *self.mode[2:]),
                XP,
            )
        except TypeError:
            return True
        return False

    def _values(self, parameter: Number) -> Mapping[str, Any]:
        """Arguments of generated functions by name."""
        return self.values | self.balance.with_angles({self.vary: parameter}, XP)

    def _constants(self, values: Values) -> list[Any]:
        return [values[name] for name in self.model.about["arguments"]["motion"]]

    def _shift(self, q: Sequence[Any], values: Values) -> Sequence[Any]:
        """Accelerations, linear in it, by what the friction of the equilibrium is larger than the
        law at the belt's speed.
        """
        balance = self.balance
        if self.model.friction_law is None or balance.law == "friction_at_speed":
            return [0] * self.n
        at = balance.at(q, values, xp=XP)
        (mu,) = at.frictions
        more = mu - at.call("friction_at_speed", ())
        with_unit, without = (
            at.call("forces", [*q, *at.directions], mu, *balance.pushing, kind="statics")
            for mu in (1, 0)
        )
        missing = [(b - a) * more for a, b in zip(with_unit, without, strict=True)]
        return _solved([list(map(_ball, row)) for row in at.mass()], list(map(_ball, missing)))


def _pair(A: Sequence[Sequence[Ball]]) -> tuple[Ball, list[Complex], list[Complex]]:
    """ω, the eigenvector of length 1 and the left one, of all matrices in A that have two
    eigenvalues with the sum 0.

    With the matrix X of approximate eigenvectors, X⁻¹ A X is nearly diagonal, and Gershgorin's
    discs hold the eigenvalues. Where the disc of i ω meets no other, the eigenvector is X z with z
    = 1 in the place of the disc and less elsewhere.
    """
    _, vectors = np.linalg.eig(np.array([_floats(row).real for row in A]))
    X, size = [[_complex(entry) for entry in row] for row in vectors], range(len(A))
    columns = [*zip(*X, strict=True)]
    Z = [
        *zip(*(_solved(X, [_product(row, column) for row in A]) for column in columns), strict=True)
    ]
    middle = _floats([Z[k][k] for k in size])
    wide = np.array([_size(Z[k][k] - _complex(middle[k])) for k in size])
    off = np.array([[0.0 if i == j else _size(Z[i][j]) for j in size] for i in size])
    radius = (np.maximum(off.sum(axis=0), off.sum(axis=1)) + wide + np.abs(middle) * ROOM) * (
        1 + ROOM
    )

    def apart(i: int, place: complex, j: int) -> bool:
        """Whether the disc i, moved to another place, does not meet the disc j."""
        return abs(place - middle[j]) * (1 - ROOM) > radius[i] + radius[j]

    sums = [(i, j) for i in size for j in size if i <= j and not apart(i, -middle[i], j)]
    if len(sums) != 1:
        many = "more than one pair of eigenvalues may have the sum 0: no generic Hopf point"
        raise UndecidedSign(many if sums else "no two eigenvalues have the sum 0: no Hopf point")
    k, conjugate = sums[0] if middle[sums[0][0]].imag > 0 else sums[0][::-1]
    isolated = all(apart(i, middle[i], j) for i in (k, conjugate) for j in size if j != i)
    isolated &= all(apart(k, middle[k].conjugate(), j) for j in size if j != conjugate)
    if k == conjugate or not isolated or not middle[k].imag > radius[k]:
        raise UndecidedSign(
            "the two eigenvalues with the sum 0 are not shown to be an isolated pair ± iω"
        )
    omega = Z[k][k].im + _around(float(radius[k]))
    # (Z_jj − λ) z_j = −Σ Z_jl z_l, where no |z_l| is larger than 1.
    spread = [
        0.0
        if j == k
        else float(
            radius[j]
            / (abs(middle[j] - middle[k]) * (1 - ROOM) - radius[j] - radius[k])
            * (1 + ROOM)
        )
        for j in size
    ]
    z = [Complex(_ball(int(j == k)) + _around(spread[j]), _around(spread[j])) for j in size]
    q = [_product(row, z) for row in X]
    length = balls.sqrt(sum((entry.squared() for entry in q), _ball(0)))
    left = _solved(columns, z)
    return omega, [entry / length for entry in q], left


def _solved(rows: Matrix, values: Sequence[Any]) -> list[Any]:
    """Solution of a linear system; the largest pivots first."""

    def choose(table: list[list[Any]], k: int) -> None:
        best = max(range(k, len(table)), key=lambda i: _about(table[i][k]))
        table[k], table[best] = table[best], table[k]

    return solved(rows, values, choose)


def _about(value: Any) -> float:
    """Size, roughly."""
    value = constant(value)
    if isinstance(value, Complex):
        return _about(value.re) + _about(value.im)
    return math.ldexp(abs(value.mid), value.exp) if isinstance(value, Ball) else abs(value)


def _product(row: Sequence[Any], column: Sequence[Any]) -> Complex:
    return sum((a * b for a, b in zip(row, column, strict=True)), _complex(0))


def _size(value: Complex) -> float:
    """Bound on |z|."""
    most = sum(max(map(abs, balls.ends(part))) for part in (value.re, value.im))
    return math.nextafter(float(most), math.inf)


def _around(radius: float) -> Ball:
    """All numbers up to that size."""
    with balls.precision(BITS):
        return balls.between(Fraction(-radius), Fraction(radius))


def _ball(value: Any) -> Any:
    """A number as a ball that holds it exactly; balls and jets of balls as they are."""
    return value if isinstance(value, Ball | Jet) else ball(value, BITS)


def _complex(value: complex) -> Complex:
    return Complex(_ball(float(value.real)), _ball(float(value.imag)))


def _floats(values: Sequence[Any]) -> ComplexArray:
    """The middles of balls or of complex numbers."""
    return np.array([complex(_float(z.re)[0], _float(z.im)[0]) for z in map(as_complex, values)])


def _float(value: Number) -> tuple[float, float]:
    """The nearest float, and a bound on its distance from everything in the ball."""
    low, high = balls.ends(_ball(value))
    middle = float((low + high) / 2)
    most = max(abs(high - Fraction(middle)), abs(Fraction(middle) - low))
    return middle, math.nextafter(float(most), math.inf) if most else 0.0
