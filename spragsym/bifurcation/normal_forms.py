"""Normal form of a Hopf point: the first Lyapunov coefficient, with a proved bound on its error.

At a Hopf point of u′ = F(u), let A q = i ω q, Aᵀ p = −i ω p, ⟨q, q⟩ = ⟨p, q⟩ = 1, and let B and C
be the second and third derivatives of F. Then

    l₁ = Re [⟨p, C(q, q, q̄)⟩ − 2 ⟨p, B(q, A⁻¹ B(q, q̄))⟩
             + ⟨p, B(q̄, (2 i ω − A)⁻¹ B(q, q))⟩] / (2 ω)

(Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, section 5.4). The state u is the
coordinates, then their rates, in the model's units. One point is computed in ball arithmetic around
it, so that the result holds the exact coefficient; l₁ alone, at many points at once, in intervals.

Derivatives come from Taylor polynomials: along u = z q + z̄ q̄ + ½ g z² + h z z̄ + ½ ḡ z̄², with g
= (2 i ω − A)⁻¹ B(q, q) and h = −A⁻¹ B(q, q̄), the coefficient of z² z̄ in F is half of the bracket.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from ..models.field import Mode
from ..models.forces import presses_either, undecorated
from ..numerics import balls, contractors
from ..numerics.arithmetic import (
    Complex,
    Matrix,
    Number,
    as_complex,
    dot,
    linear_solution,
)
from ..numerics.balls import XP, Ball, UndecidedSign, ball
from ..numerics.interval_arrays import (
    ComplexArray,
    FloatArray,
    Intervals,
    Shape,
    ends_around,
    quiet,
    rounded_outward,
    scale_of,
)
from ..numerics.jets import Jet, gradient, variables
from ..statics import namespaces
from ..statics.balance import Balance, PreciseBalance
from ..statics.forces import Values

#: Bits of all balls; the box around the point leaves about fifty significant ones.
BITS = 106


@dataclass(frozen=True)
class NormalForm:
    """Normal form of a Hopf point; each ``…_error`` bounds the absolute error of the number before
    it.

    Attributes
    ----------
    omega, omega_error : float
        The frequency ω.
    lyapunov, lyapunov_error : float
        The first Lyapunov coefficient l₁.
    crossing, crossing_error : float
        d Re λ / d parameter of the pair, along the equilibrium: if it is not 0, the pair crosses
        the imaginary axis.
    q, p : ndarray of complex
        The eigenvector of i ω, of length 1, and that of Aᵀ for −i ω, with ⟨p, q⟩ = p̄ᵀ q = 1.
    reach : float
        |z| of u = z q + z̄ q̄ at which a sliding speed first reaches 0, to first order, in floats;
        infinite without friction.
    others : int
        How many other λ have a positive real part; −1 where that is undecided.
    along, square, mean : ndarray
        Floats: ∂u/∂parameter of the equilibrium, and g and h as defined above in this module.
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
    others: int


def normal_form(
    balance: Balance,
    given: FloatArray,
    state: FloatArray,
    vary: Sequence[str],
    radii: FloatArray,
) -> NormalForm:
    """The normal form at a Hopf point that is proved to lie in a box.

    ``balance`` has the touching contacts and, by its ``law``, the friction of the equilibrium:
    ``"friction_at_rest"``, as in statics, or ``"friction_at_speed"``, at the speed of the belt. The
    motion's laws are shifted by constants so that they agree with it. ``given`` are all parameters,
    ``state`` the coordinates, and ``vary`` the parameters along which the point was found; the
    crossing is by the first. ``radii`` are the half-widths of the box, of coordinates and then of
    ``vary``.

    Raises UndecidedSign, with the reason, if the point is not proved to be a generic Hopf point.
    """
    point = _in_balls(balance, given, state, vary, radii)
    _require_smooth(point)
    A, by_parameter = point.linear()
    pair = _pair(A)
    lyapunov, crossing, q, p, along, square, mean = point.form(pair, by_parameter)
    return NormalForm(
        *_float(pair.omega),
        *_float(lyapunov),
        *_float(crossing),
        _floats(q),
        _floats(p),
        _reach([_float(term)[0] for term in point.slips(q)]),
        _floats(along).real,
        _floats(square),
        _floats(mean).real,
        pair.others,
    )


def growing_beside(
    balance: Balance,
    given: FloatArray,
    state: FloatArray,
    vary: Sequence[str],
    radii: FloatArray,
    critical: int,
) -> int:
    """How many λ have a positive real part at a point at which ``critical`` others are known to lie
    on the imaginary axis; −1 where that is undecided. Arguments as for :func:`normal_form`.
    """
    try:
        point = _in_balls(balance, given, state, vary, radii)
        _require_smooth(point)
        own, radius = _discs(_diagonal(point.linear()[0])[0])
    except (UndecidedSign, ZeroDivisionError, np.linalg.LinAlgError):
        return -1
    beside = np.abs(own.real) > radius
    distance = np.abs(own[beside, None] - own[~beside]) * (1 - _ROUNDING)
    apart = (distance > radius[beside, None] + radius[~beside]).all()
    decided = apart and np.count_nonzero(~beside) == critical
    return int((own.real > radius).sum()) if decided else -1


class _Side:
    """A factor ±1 of unknown sign, whose square is 1: all other algebra with it is an error."""

    def __mul__(self, other: object) -> Number:
        return 1 if other is self else NotImplemented


@dataclass(frozen=True)
class _Point:
    """The field F around a state of steady sliding in one mode, for balls or intervals and jets of
    them.

    ``vary`` is the parameter that is a variable, and ``parameter`` its value. ``known`` converts a
    number to the type of the others.
    """

    balance: Balance
    mode: Mode
    vary: str
    state: Sequence[Any]
    values: Mapping[str, Any]
    parameter: Any
    xp: Any
    known: Callable[[Any], Any]
    shape: Shape = ()

    def field(self, u: Sequence[Any], parameter: Number) -> list[Any]:
        """F at u: the rates, then the accelerations, with friction laws shifted to those of the
        equilibrium.
        """
        values = {**self.values, **self.balance.with_angles({self.vary: parameter}, self.xp)}
        accelerations = self.balance.model.field.acceleration(
            u, self._constants(values), self.mode, self.xp
        )
        n = self.balance.n
        shifts = self._shift(u[:n], values)
        return [*u[n:], *(a + shift for a, shift in zip(accelerations, shifts, strict=True))]

    def slips(self, q: Sequence[Complex]) -> list[Any]:
        """For each friction of a touching contact, the sliding speed and its derivatives by a and
        b, along 2 (a Re q − b Im q).
        """
        found = list[Any]()
        borders = self._borders([Jet(terms, 1) for terms in self._along(q)])
        for index in self.felt:
            slip = borders[index]
            terms = slip.terms if isinstance(slip, Jet) else {}
            found += [terms.get(key, 0) for key in ((), (0,), (1,))]
        return found

    @property
    def felt(self) -> dict[int, Mapping[str, Any]]:
        """Frictions of touching contacts, by their index among borders and in the mode."""
        names, indicators = self.balance.contacts, self.balance.indicators
        return {
            index: friction
            for index, friction in enumerate(self.balance.model.frictions, len(names))
            if indicators[names.index(friction["name"])]
            or presses_either(self.balance.model.contacts[names.index(friction["name"])])
        }

    def linear(self) -> tuple[list[list[Any]], list[Any]]:
        """The Jacobian A, and ∂F/∂parameter."""
        *u, parameter = variables([*self.state, self.parameter], 1)
        slopes = [
            list(map(self.known, gradient(row, len(u) + 1))) for row in self.field(u, parameter)
        ]
        return [row[:-1] for row in slopes], [row[-1] for row in slopes]

    def form(self, pair: _Pair, by_parameter: Sequence[Any]) -> tuple[Any, ...]:
        """l₁, d Re λ/d parameter, q, p, ∂u/∂parameter, g and h, for a pair ± i ω and
        ∂F/∂parameter.
        """
        q, left = pair.vector(self.xp), pair.left
        along = pair.solved([-entry for entry in by_parameter])
        path = self._along(q)
        for terms, slope in zip(path, along, strict=True):
            terms[(2,)] = slope.re
        rows = self.field([Jet(terms, 2) for terms in path], Jet({(): self.parameter, (2,): 1}, 2))
        orders = (0, 0), (0, 1), (1, 1), (0, 2), (1, 2)
        aa, ab, bb, ac, bc = (self._terms(rows, *order) for order in orders)
        # B(q, q) is twice the coefficient of z², B(q, q̄) that of z z̄, for z = a + i b.
        twice = [Complex((x - z) / 2, -y / 2) for x, y, z in zip(aa, ab, bb, strict=True)]
        mean = pair.solved([-(x + z) / 2 for x, z in zip(aa, bb, strict=True)])
        square = pair.solved(twice, shifted=True)
        path = self._along(q)
        for terms, g, m in zip(path, square, mean, strict=True):
            terms |= {(0, 0): m.re + g.re, (0, 1): -2 * g.im, (1, 1): m.re - g.re}
        rows = self.field([Jet(terms, 3) for terms in path], self.parameter)
        aaa, aab, abb, bbb = (
            self._terms(rows, *order) for order in ((0, 0, 0), (0, 0, 1), (0, 1, 1), (1, 1, 1))
        )
        cubic = [
            Complex((3 * x + z) / 8, -(y + 3 * w) / 8)
            for x, y, z, w in zip(aaa, aab, abb, bbb, strict=True)
        ]
        scale = dot(left, q)
        # The coefficient of z c, where c is the change of the parameter: d(A q)/dc.
        by_change = [Complex(x / 2, -y / 2) for x, y in zip(ac, bc, strict=True)]
        return (
            (dot(left, cubic) / scale).re / pair.omega,
            (dot(left, by_change) / scale).re,
            q,
            [(entry / scale).conjugate() for entry in left],
            [entry.re for entry in along],
            square,
            [entry.re for entry in mean],
        )

    def required(self) -> Iterator[tuple[Any, str]]:
        """Numbers that are positive where the field has third derivatives, each with a message for
        where it is not.
        """
        model, kink = self.balance.model, "line {} of the model page, has a kink"
        borders = self._borders(self.state)
        for index, contact in enumerate(model.contacts):
            if contact["border"]:
                yield (
                    borders[index] * (1 - 2 * self.mode[index]),
                    "the state lies on the border of contact, where the law of line "
                    f"{contact['line']} of the model page has a kink",
                )
        for index, friction in self.felt.items():
            line, law = friction["line"], "the sliding speed is 0, where the law of friction, "
            why = law + kink.format(line)
            if friction["holds"]:
                why = (
                    f"the belt of line {line} of the model page stands still, and friction holds "
                    "what rests on it: this is an onset of sliding, as that belt begins to move; "
                    "give it a speed, or see what moves beside what is held by ss.simulate"
                )
            yield borders[index], why
        sides = self.mode[len(self.mode) - model.field.torsion_sides :]
        if sides:
            levels = undecorated(model.algebra.turning_borders)(
                *self.state, *self._constants(self.values), *sides, xp=self.xp
            )
            for level in levels:
                yield level, "a torsion spring is turned by π, where its torque jumps"

    def asks_for_the_side(self) -> bool:
        """Whether a friction law depends on the sign of the slip otherwise than by its square.

        Then algebra with :class:`_Side` is an error.
        """
        sides = [_Side() if k in self.felt else one for k, one in enumerate(self.mode)]
        try:
            self.balance.model.field.acceleration(
                self.state, self._constants(self.values), sides, self.xp
            )
        except TypeError:
            return True
        return False

    def _along(self, q: Sequence[Complex]) -> list[dict[tuple[int, ...], Any]]:
        """Terms of the state along 2 (a Re q − b Im q), as a jet in a and b."""
        return [
            {(): u, (0,): 2 * z.re, (1,): -2 * z.im} for u, z in zip(self.state, q, strict=True)
        ]

    def _terms(self, rows: Sequence[Any], *numbers: int) -> list[Any]:
        """The coefficient of a product of variables, in each row."""
        return [
            self.known(row.terms.get(numbers, 0) if isinstance(row, Jet) else 0) for row in rows
        ]

    def _borders(self, u: Sequence[Any]) -> Sequence[Any]:
        """The gaps, then the sliding speeds."""
        found: Sequence[Any] = undecorated(self.balance.model.algebra.borders)(
            *u, *self._constants(self.values), xp=self.xp
        )
        return found

    def _constants(self, values: Values) -> list[Any]:
        """Arguments of the motion, in order."""
        return [values[name] for name in self.balance.model.about["arguments"]["motion"]]

    def _shift(self, q: Sequence[Any], values: Values) -> Sequence[Any]:
        """Accelerations by the difference between the equilibrium's friction and the laws at the
        belt's speed.

        Rows of forces are linear in the friction coefficients.
        """
        balance = self.balance
        if not balance.model.frictions or balance.law == "friction_at_speed":
            return [0] * balance.n
        at = balance.at(q, values, self.shape, self.xp)
        laws = at.of_frictions("friction_at_speed")
        differences = [mu - law for mu, law in zip(at.frictions, laws, strict=True)]

        def forces(*friction: int) -> Sequence[Any]:
            first = [*q, *at.directions]
            return at.call("forces", first, *friction, *balance.indicators, kind="statics")

        zero = [0] * len(differences)
        without, total = forces(*zero), [0] * balance.n
        for index, difference in enumerate(differences):
            with_unit = forces(*zero[:index], 1, *zero[index + 1 :])
            rows = zip(total, with_unit, without, strict=True)
            total = [value + (b - a) * difference for value, a, b in rows]
        return linear_solution([list(map(self.known, row)) for row in at.mass()], total)


def _in_balls(
    balance: Balance, given: FloatArray, state: FloatArray, vary: Sequence[str], radii: FloatArray
) -> _Point:
    """The field around one state in ball arithmetic; arguments as for :func:`normal_form`."""
    point = [*state, *(given[balance.parameters.index(name)] for name in vary)]
    ends = [
        (Fraction(x) - Fraction(r), Fraction(x) + Fraction(r))
        for x, r in zip(point, radii, strict=True)
    ]
    with balls.precision(BITS):
        q = [balls.between(*each) for each in ends[: balance.n]]
    spans = dict(zip(vary, ends[balance.n :], strict=True))
    values = PreciseBalance(balance, given, BITS, spans).arguments
    return _Point(
        balance,
        _mode(balance, given, state),
        vary[0],
        [*q, *(_ball(0) for _ in q)],
        values,
        values[vary[0]],
        XP,
        _ball,
    )


def _mode(balance: Balance, given: FloatArray, state: FloatArray) -> Mode:
    """The full mode of a state at rest, with the touching contacts of the balance."""
    motion, rates = balance.model.field, [0.0] * len(state)
    floats = [*map(float, state), *rates]
    found = motion.exact(motion.mode_at_rest(floats, motion.constants(given.tolist())))
    return *balance.indicators, *found[len(balance.indicators) :]


def _require_smooth(point: _Point) -> None:
    """Raise :class:`UndecidedSign` unless the field is proved to have third derivatives at the
    state.
    """
    for level, why in point.required():
        at_rest = why.startswith("the sliding speed")
        if not balls.sign(level) > 0 and not (at_rest and not point.asks_for_the_side()):
            raise UndecidedSign(why)


def _reach(slips: Sequence[float]) -> float:
    """Least |z| at which a sliding speed reaches 0, from each speed followed by its two
    derivatives.
    """
    found = [math.inf]
    for speed, by_a, by_b in zip(slips[::3], slips[1::3], slips[2::3], strict=True):
        change = math.hypot(by_a, by_b)
        found.append(abs(speed) / change if change else math.inf)
    return min(found)


@dataclass(frozen=True)
class _Pair:
    """A pair ± i ω of a matrix A = X Z X⁻¹, where X are approximate eigenvectors.

    ``z`` is the eigenvector of i ω in the basis X, and ``inverse`` is X⁻¹. Linear systems are
    solved in this basis, where Z is nearly diagonal and no pivoting is needed. ``others`` are the
    other λ with a positive real part, −1 where that is undecided.
    """

    omega: Any
    z: Sequence[Complex]
    X: Matrix
    Z: Matrix
    inverse: Matrix
    others: int = -1

    @property
    def left(self) -> list[Complex]:
        """The eigenvector of Aᵀ for i ω, of any length."""
        return [dot(column, self.z) for column in zip(*self.inverse, strict=True)]

    def vector(self, xp: Any) -> list[Complex]:
        """The eigenvector of A for i ω, of length 1."""
        q = [dot(row, self.z) for row in self.X]
        length = xp.sqrt(sum(entry.squared() for entry in q))
        return [entry / length for entry in q]

    def solved(self, values: Sequence[Any], shifted: bool = False) -> list[Complex]:
        """Solution x of A x = values or, if ``shifted``, of (2 i ω − A) x = values."""
        Z = self.Z
        if shifted:
            twice = Complex(0, 2 * self.omega)
            Z = [
                [-entry + twice if i == j else -entry for j, entry in enumerate(row)]
                for i, row in enumerate(Z)
            ]
        within = linear_solution(Z, [dot(row, values) for row in self.inverse])
        return [dot(row, within) for row in self.X]


def _in_basis(A: Matrix, X: Matrix, R: Matrix) -> tuple[Matrix, Matrix]:
    """X⁻¹ A X and X⁻¹, from an approximate inverse R of X."""
    near_unit = _matrix_product(R, X)
    columns = [linear_solution(near_unit, column) for column in zip(*R, strict=True)]
    inverse = list(zip(*columns, strict=True))
    return _matrix_product(inverse, _matrix_product(A, X)), inverse


def _pair(A: Sequence[Sequence[Ball]]) -> _Pair:
    """The pair ± i ω of all matrices in A that have two eigenvalues with the sum 0."""
    bounds, X, Z, inverse = _diagonal(A)
    ends, others = _isolated(bounds)
    with balls.precision(BITS):
        omega, *z = (balls.between(Fraction(-low), Fraction(high)) for low, high in ends.T)
    return _Pair(omega, _complexes(z), X, Z, inverse, others)


def _diagonal(A: Sequence[Sequence[Ball]]) -> tuple[FloatArray, Matrix, Matrix, Matrix]:
    """Bounds on the parts of a nearly diagonal Z, as for :func:`_isolated`, with X, Z and X⁻¹ of A
    = X Z X⁻¹.
    """
    _, vectors = np.linalg.eig(np.array([_floats(row).real for row in A]))
    X, R = (
        [[Complex(_ball(float(one.real)), _ball(float(one.imag))) for one in row] for row in rows]
        for rows in (vectors, np.linalg.pinv(vectors))
    )
    Z, inverse = _in_basis(A, X, R)
    numbers = np.array([[list(map(_float, (one.re, one.im))) for one in row] for row in Z])
    bounds = rounded_outward(ends_around(numbers[..., 0], numbers[..., 1]))
    return bounds, X, Z, inverse


#: Relative error of complex operations on middles of intervals.
_ROUNDING = 2.0**-50


def _off_diagonal(Z: FloatArray) -> FloatArray:
    """Bounds on the entries beside the diagonal, and on it those of its distance from its
    middle.
    """
    own = Z[:, range(Z.shape[1]), range(Z.shape[1])]
    off = Intervals(Z).magnitude.sum(axis=-1)
    np.fill_diagonal(off, contractors.distance(own, Intervals(own).middle).sum(axis=-1))
    return off


def _discs(Z: FloatArray) -> tuple[ComplexArray, FloatArray]:
    """Centres and radii of Gershgorin's discs, which hold the eigenvalues."""
    size, off = range(Z.shape[1]), _off_diagonal(Z)
    parts = Intervals(Z[:, size, size]).middle
    middle = parts[:, 0] + 1j * parts[:, 1]
    radius = np.maximum(off.sum(axis=0), off.sum(axis=1)) + np.abs(middle) * _ROUNDING
    return middle, radius * (1 + 4 * _ROUNDING)


def _isolated(Z: FloatArray) -> tuple[FloatArray, int]:
    """Enclosures of ω and of the eigenvector of i ω, for nearly diagonal matrices that have two
    eigenvalues with the sum 0.

    ``Z`` are ends of the real and imaginary parts of the entries, shape (2, n, n, 2). Returns −low
    and high of ω, then of the parts of the eigenvector's entries, shape (2, 1 + 2 n); and how many
    other eigenvalues have a positive real part, −1 where that is undecided.

    Gershgorin's discs hold the eigenvalues. If the disc of i ω meets no other, its eigenvector has
    the entry 1 at the index of the disc, and entries of at most size 1 elsewhere. Raises
    UndecidedSign unless there is just one such pair.
    """
    n, rounding, off = Z.shape[1], _ROUNDING, _off_diagonal(Z)
    size, own = range(n), Z[:, range(n), range(n)]
    middle, radius = _discs(Z)

    def apart(i: int, centre: complex, j: int) -> bool:
        """Whether the disc i, moved to that centre, does not meet the disc j."""
        return abs(centre - middle[j]) * (1 - rounding) > radius[i] + radius[j]

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
    # (Z_jj − λ) z_j = −Σ Z_jl z_l: two iterations from the bound |z_l| ≤ 1.
    distance = np.abs(middle - middle[k]) * (1 - rounding) - radius - radius[k]
    distance[k], off[k, k], spread = np.inf, 0.0, np.ones(n)
    for _ in range(2):
        spread[k] = 0.0
        spread = (off[:, k] + off @ spread) / distance * (1 + 4 * rounding)
    out = np.empty((2, 1 + 2 * n))
    out[:, 0] = rounded_outward(own[:, k, 1] + off[k] @ spread * (1 + 4 * rounding))
    out[:, 1::2] = out[:, 2::2] = spread
    out[:, 1 + 2 * k] += (-1.0, 1.0)
    beside = ~np.isin(size, (k, conjugate))
    growing = middle.real[beside] > radius[beside]
    decided = growing | (middle.real[beside] < -radius[beside])
    return out, int(growing.sum()) if decided.all() else -1


# ------------------------------------------------------------------------------------------------
# many points


@dataclass(frozen=True)
class Coefficient:
    """l₁ of a Hopf point and d Re λ / d parameter, with bounds on their errors, and ``reach`` and
    ``others`` as in :class:`NormalForm`.
    """

    lyapunov: float
    lyapunov_error: float
    crossing: float
    crossing_error: float
    reach: float
    others: int


def coefficients(
    balance: Balance, given: FloatArray, ends: FloatArray, vary: Sequence[str]
) -> list[Coefficient | str | None]:
    """l₁ of many Hopf points by interval arithmetic.

    ``given`` are parameters, shape (P, N), and ``ends`` boxes of coordinates and then of the
    varying parameters, with one point proved in each. An entry is the reason if a point is not
    proved to be generic, and None if :func:`normal_form` may know more.
    """
    n, bounds = balance.n, Intervals.point(given).ends
    bounds[:, [balance.parameters.index(name) for name in vary]] = ends[:, n:]
    middles = Intervals(ends[:, :n]).middle
    modes = [_mode(balance, *each) for each in zip(given.T, middles.T, strict=True)]
    found: list[Coefficient | str | None] = [None] * len(modes)
    for mode in set(modes):
        rows = np.array([k for k, one in enumerate(modes) if one == mode])
        with quiet():
            prepared = balance.prepared(Intervals(bounds[:, :, rows]))
            several = _InMode(balance, mode, vary[0])
            of_mode = several.coefficients(Intervals(ends[:, : n + 1, rows]), prepared)
        for k, one in zip(rows.tolist(), of_mode, strict=True):
            found[k] = one
    return found


@dataclass(frozen=True)
class _InMode:
    """Points of one mode in interval arithmetic, in boxes of coordinates and of the parameter
    ``vary``.
    """

    balance: Balance
    mode: Mode
    vary: str

    def coefficients(
        self, boxes: Intervals, parameters: Intervals
    ) -> list[Coefficient | str | None]:
        """l₁ of each point; the reason or None where it is not proved, as in
        :func:`coefficients`.
        """
        size = 2 * self.balance.n
        # Rounding is negligible beside the width of wide boxes, and comparable to that of bounded
        # ones: there ball arithmetic would not help.
        share = (boxes.width / scale_of(boxes.middle)).max(axis=0)
        wide, bounded = share > 2.0**-40, share > 2.0**-48
        out: list[Coefficient | str | None] = [None] * boxes.shape[1]
        linear = self._taped("linear", self._linear, boxes, parameters)
        A, levels = linear[: size**2], linear[size**2 :]
        smooth = (levels.low > 0).all(axis=0) & np.isfinite(A.ends).all(axis=(0, 1))
        rows = np.flatnonzero(smooth)
        matrices = np.moveaxis(A.middle[:, rows].reshape(size, size, -1), -1, 0)
        _, X = np.linalg.eig(matrices)
        basis = _rows_of(X), _rows_of(np.linalg.pinv(X))
        Z = self.balance.tapes.evaluated("basis", _entries_in_basis, A[:, rows], *basis)
        pairs, others = list[FloatArray](), list[int]()
        shown = list[int]()
        for k, entries in enumerate(np.moveaxis(Z.ends[:, : 2 * size**2], -1, 0)):
            try:
                pair, beside = _isolated(entries.reshape(2, size, size, 2))
                pairs.append(pair)
                others.append(beside)
                shown.append(k)
            except UndecidedSign as reason:
                out[rows[k]] = str(reason) if wide[rows[k]] else None
        rows = rows[shown]
        if not rows.size:
            return out
        known = Intervals(np.stack(pairs, axis=-1))
        asked = boxes[:, rows], basis[0][:, shown], Z[:, shown], known, parameters[:, rows]
        found = self._taped("form", self._form, *asked)
        middle = found.middle
        error, off = contractors.distance(found.ends[:, :2], middle[:2])
        for k, row in enumerate(rows.tolist()):
            size = abs(middle[0, k])
            # Even an error 32 times smaller would leave the sign open.
            undecidable = bounded[row] and 32 * size < error[k]
            if np.isfinite(error[k]) and (wide[row] or undecidable or size > error[k]):
                value, crossing, *slips = middle[:, k].tolist()
                numbers = value, float(error[k]), crossing, float(off[k])
                out[row] = Coefficient(*numbers, _reach(slips), others[k])
        return out

    def _taped(self, name: str, rows: Callable[..., Sequence[Any]], *given: Intervals) -> Intervals:
        return self.balance.taped((name, self.mode, self.vary), rows, *given)

    def _at(self, boxes: Intervals, parameters: Intervals) -> _Point:
        """The field over boxes."""
        *state, parameter = boxes
        return _Point(
            self.balance,
            self.mode,
            self.vary,
            [*state, *(0 for _ in state)],
            self.balance.arguments(parameters),
            parameter,
            namespaces.XP,
            lambda value: value,
            parameters.shape[1:],
        )

    def _linear(self, boxes: Intervals, parameters: Intervals) -> list[Any]:
        """A, row by row, then the numbers of :meth:`_Point.required`."""
        point = self._at(boxes, parameters)
        A, _ = point.linear()
        return [*(entry for row in A for entry in row), *(level for level, _ in point.required())]

    def _form(
        self, boxes: Intervals, X: Intervals, Z: Intervals, pair: Intervals, parameters: Intervals
    ) -> list[Any]:
        """l₁ and the crossing, then the sliding speeds and their derivatives along the pair."""
        point, entries, (omega, *z) = self._at(boxes, parameters), list(Z), pair
        half = len(entries) // 2
        basis = [_square(part) for part in (list(X), entries[:half], entries[half:])]
        _, by_parameter = point.linear()
        known = _Pair(omega, _complexes(z), basis[0], basis[1], basis[2])
        *numbers, q, _, _, _, _ = point.form(known, by_parameter)
        return [*numbers, *point.slips(q)]


def _entries_in_basis(A: Intervals, X: Intervals, R: Intervals) -> list[Any]:
    """Real and imaginary parts of X⁻¹ A X and X⁻¹, row by row, from those of X and R."""
    entries, size = list(A), math.isqrt(A.shape[0])
    rows = [entries[size * row : size * (row + 1)] for row in range(size)]
    found = _in_basis(rows, _square(list(X)), _square(list(R)))
    return [part for it in found for row in it for one in row for part in (one.re, one.im)]


def _rows_of(matrices: ComplexArray) -> Intervals:
    """Entries of matrices, shape (N, n, n), as rows of real and imaginary parts."""
    parts = np.stack([matrices.real, matrices.imag], axis=-1)
    return Intervals.point(np.moveaxis(parts, 0, -1).reshape(-1, len(matrices)))


def _complexes(parts: Sequence[Any]) -> list[Complex]:
    """Complex numbers from alternating real and imaginary parts."""
    return [Complex(re, im) for re, im in zip(parts[::2], parts[1::2], strict=True)]


def _square(parts: Sequence[Any]) -> list[list[Complex]]:
    """A square matrix from the parts of its entries, row by row."""
    flat = _complexes(parts)
    size = math.isqrt(len(flat))
    return [flat[size * row : size * (row + 1)] for row in range(size)]


def _matrix_product(one: Matrix, other: Matrix) -> list[list[Complex]]:
    """The matrix product."""
    return [[dot(row, column) for column in zip(*other, strict=True)] for row in one]


def _ball(value: Any) -> Any:
    """A number as a ball that holds it exactly; balls and jets of balls as they are."""
    return value if isinstance(value, Ball | Jet) else ball(value, BITS)


def _floats(values: Sequence[Any]) -> ComplexArray:
    """The middles of balls or of complex numbers."""
    return np.array([complex(_float(z.re)[0], _float(z.im)[0]) for z in map(as_complex, values)])


def _float(value: Number) -> tuple[float, float]:
    """The nearest float, and a bound on its distance from everything in the ball."""
    low, high = balls.ends(_ball(value))
    middle = float((low + high) / 2)
    most = max(abs(high - Fraction(middle)), abs(Fraction(middle) - low))
    return middle, math.nextafter(float(most), math.inf) if most else 0.0
