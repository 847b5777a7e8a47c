"""Defining systems of folds, cusps and onsets over a family of equilibria: coordinates and
parameters are unknowns together.

The forces vanish, and as many conditions hold as there are parameters: det K = 0 with one parameter
is a fold; with two, and with no change of det K along the direction that K maps to 0, a cusp.
Derivatives come from jets over intervals. Where two points lie so near to each other that float64
does not tell them apart, the same is evaluated in balls.

K has no bound in a box around the anchor of a spring, and may be regular there. A spring of length
l whose line has the direction n adds R/l to K, and R, −k r t t′ in its end with the undeformed
length r and t across n, has rank one. So l det K = l det K∞ + Σ cofactors of K∞ × R, which is
smooth at l = 0 for each direction.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any, Self, TypeAlias

import numpy as np

from ..core.errors import ParameterError
from ..models import Model
from ..models.parameters import ParameterSet, Ranges, as_ranges, largest
from ..numerics import contractors
from ..numerics.arithmetic import (
    Matrix,
    Number,
    Polynomial,
    characteristic,
    cofactor,
    coupled,
    determinant,
    hurwitz,
    part_of,
    pencil,
    resultant,
    trimmed,
)
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    Shape,
    quiet,
    stacked,
)
from ..numerics.jets import Jet, constant, gradient, is_linear, variables
from ..numerics.plans import LineTapes
from ..numerics.polynomials import derivative
from ..numerics.tape import Tape
from ..statics.balance import Balance, direction_entries, no_direction
from ..statics.forces import Evaluation, Values
from ..statics.namespaces import XP
from ..statics.options import SearchOptions
from ..statics.precise_balance import refined_in_digits
from ..statics.regions import requested_region
from ..statics.search import balances_of
from ..statics.systems import ENDLESS, Boxes, Entries, StateSystem, at_anchors

#: Arcs of directions, π/16 wide, looked at one by one: 32 are a full turn, one more covers what
#: rounding leaves.
ARCS = np.arange(33)
#: Ends of cosine and sine on each of them.
DIRECTIONS = stacked(
    [of(Intervals.between(np.pi / 16 * ARCS, np.pi / 16 * (ARCS + 1))) for of in (XP.cos, XP.sin)],
    ARCS.shape,
).ends


@dataclass(frozen=True)
class Family:
    """Family of systems that is searched: parameters that vary over ranges, at one point of the
    others or at many.

    ``given`` are all parameters, shape (parameters, points), NaN for those that vary; ``spans`` the
    ranges of these, shape (number, 2), and ``endless`` those of them whose range was cut; ``asked``
    is a region of the coordinates by hand.
    """

    p: Any
    balance: Balance
    vary: tuple[str, ...]
    given: FloatArray
    spans: FloatArray
    asked: FloatArray | None = None
    endless: tuple[str, ...] = ()

    @classmethod
    def of(
        cls,
        p: ParameterSet,
        vary: Sequence[str],
        between: Ranges | None = None,
        within: Ranges | None = None,
        balance: Balance | None = None,
    ) -> Self:
        """Of a set of parameters, by the balance in contact unless another one is given."""
        # Curves may begin and end on a border: states on it count.
        balance = Balance(p.model) if balance is None else balance.extended(slack=balance.slack)
        between = between or {}
        spans, asked = ranges(p, vary, between), requested_region(p.model, within)
        given = given_column(p, balance.parameters, vary)
        # Of these nobody has said how far they are searched.
        endless = tuple(
            name
            for name in vary
            if name not in between and math.inf in map(abs, _ends(p.model, name))
        )
        return cls(p, balance, tuple(vary), given, spans, asked, endless)

    @classmethod
    def every(
        cls,
        p: ParameterSet,
        vary: Sequence[str],
        between: Ranges | None = None,
        within: Ranges | None = None,
        options: SearchOptions | None = None,
    ) -> list[Self]:
        """Of every combination of contacts that touch."""
        balances = balances_of(p.model, within, options)
        return [cls.of(p, vary, between, within, balance) for balance in balances]

    def beyond(self, contact: int | None = None) -> Self:
        """The same where states a little beyond the border of a contact, or of all, count too."""
        return replace(self, balance=self.balance.extended(contact))

    def fixed(self, name: str, values: float | FloatArray) -> Self:
        """The same at one value, or at many, of a parameter that varies here."""
        row, number = self.balance.parameters.index(name), self.vary.index(name)
        given = np.repeat(self.given, np.size(values), axis=1)
        given[row] = values
        return replace(
            self,
            p=self.p.replace(**{name: values}),
            vary=tuple(one for one in self.vary if one != name),
            given=given,
            spans=np.delete(self.spans, number, axis=0),
            endless=tuple(one for one in self.endless if one != name),
        )

    def at(self, values: FloatArray) -> FloatArray:
        """All parameters where those that vary have these values, shape (number, points)."""
        points = np.broadcast_shapes(self.given.shape[1:], values.shape[1:])
        out = np.array(np.broadcast_to(self.given, (len(self.given), *points)))
        out[[self.balance.parameters.index(name) for name in self.vary]] = values
        return out

    def named(self, z: FloatArray) -> dict[str, FloatArray]:
        """Values of what varies and of coordinates by name, from coordinates and parameters, shape
        (n + number, …).
        """
        n = self.balance.n
        return dict(zip((*self.vary, *self.balance.coordinates), [*z[n:], *z[:n]], strict=True))

    @property
    def begin(self) -> FloatArray:
        """All parameters at the lower ends of the ranges."""
        return self.at(self.spans[:, :1])

    @property
    def over(self) -> Intervals:
        """All parameters over the ranges."""
        return Intervals.between(self.begin, self.at(self.spans[:, 1:]))

    def is_affine(self) -> bool:
        """Whether the forces are affine in the coordinates, by structure: there is one state, none,
        or a line, and no two meet.
        """
        balance = self.balance
        if balance.springs:
            return False
        with quiet():
            values = balance.over(self.over[:, :1])
            try:
                rows = balance.at(
                    variables([Intervals.point(np.full(1, 0.5))] * balance.n, 2), values, (1,)
                ).rows("forces")
            except ZeroDivisionError:  # a law that has no value there
                return False
        return all(is_linear(row) for row in rows if isinstance(row, Jet))


def ranges(p: ParameterSet, vary: Sequence[str], between: Ranges) -> FloatArray:
    """Lower and upper ends of the parameters that vary, shape (number, 2)."""
    model = p.model
    for name in vary:
        model.require_parameter(name)
    given, rows = as_ranges("between", between, {name: model.any_of(name) for name in vary}), []
    for name in vary:
        own, far = _ends(model, name), _far(p, name)
        ends = given.get(
            name, [end if math.isfinite(end) else math.copysign(far, end) for end in own]
        )
        if ends[0] < own[0] or ends[1] > own[1]:
            (domain,) = (
                entry["domain"] for entry in model.about["parameters"] if entry["name"] == name
            )
            raise ParameterError(
                f"between[{name!r}] = {between[name]} leaves the range of {name}, {domain}; "
                "stay within it"
            )
        rows.append(ends)
    return np.array(rows, dtype=float).reshape(-1, 2)


def _far(p: ParameterSet, name: str) -> float:
    """End of the range of a parameter that has none: ten times the largest of 1, its base value
    and its own.
    """
    return 10.0 * max(1.0, abs(p.model.base.get(name, 0.0)), largest(p, name))


def _ends(model: Model, name: str) -> tuple[float, float]:
    allowed = model.Parameters.ranges[name]
    return allowed.low, allowed.high


def given_column(p: ParameterSet, names: Sequence[str], vary: Sequence[str]) -> FloatArray:
    """Scalar parameters as one column, NaN for those that vary."""
    fixed = [name for name in names if name not in vary]
    for name in fixed:
        if p[name] is None:
            raise ParameterError(
                f"{name} has no value while {' and '.join(vary)} varies; use "
                f"p.replace({name}=...), or vary it"
            )
    values = dict(zip(fixed, p.scalars(*fixed), strict=True))
    return np.array([[values.get(name, np.nan)] for name in names])


#: Coordinates of a block of K; None of all.
Block: TypeAlias = tuple[int, ...] | None


@dataclass(frozen=True)
class Condition:
    """Condition on a state beside the balance.

    ``equations`` are the values that must vanish, one for each unknown parameter; jets carry
    ``order`` more derivatives. ``singular`` and ``touching``: one of them is det K = 0, or that the
    gap of the contact of that number is 0. ``pairs``: a pair of eigenvalues crosses, of a ``block``
    of coordinates. ``excluded`` are boxes in which an inequality that is asked for can't hold,
    ``abandoned`` those that halving would never decide.
    """

    equations: Callable[[Evaluation], Sequence[Any]]
    order: int = 0
    singular: bool = False
    touching: int | None = None
    pairs: bool = False
    block: Block = None
    excluded: Callable[[Evaluation], BoolArray] | None = None
    abandoned: Callable[[Evaluation], BoolArray] | None = None


#: det K = 0.
FOLD = Condition(lambda at: (determinant(at.slopes),), singular=True)


@cache
def touch(contact: int) -> Condition:
    """The gap of a contact is 0."""
    return Condition(lambda at: (at.gap(contact),), touching=contact)


@cache
def both(one: Condition, other: Condition) -> Condition:
    """Two conditions on one state."""
    return Condition(
        lambda at: (*one.equations(at), *other.equations(at)),
        order=max(one.order, other.order),
        singular=one.singular or other.singular,
        touching=other.touching if one.touching is None else one.touching,
    )


@cache
def cusp(column: int, block: Block = None) -> Condition:
    """det K = 0, and K v = 0 for a direction v along which det K does not change.

    Where K has rank n − 1 the columns of its adjugate that are not 0 are multiples of v. One of
    them is taken: points where that one is 0 are roots as well, which
    :func:`spragsym.bifurcation.singularities.told_apart` tells from cusps. With a ``block`` it is
    the determinant of that which is 0.
    """

    def equations(at: Evaluation) -> Sequence[Any]:
        K = at.slopes
        return _determinant_of(K, block), change(K, column, block)

    return Condition(equations, order=1, singular=True)


@cache
def turn(line: int, block: Block = None) -> Condition:
    """The curve of folds turns back in the second parameter: det K = 0, and so is the force along w
    that the first parameter v brings, w · ∂F/∂v with w K = 0.

    A line of the adjugate stands for w: points where it is 0 are roots as well.
    """

    def equations(at: Evaluation) -> Sequence[Any]:
        K, rows = at.slopes, at.forces()
        pushed = [slope(row, len(K)) * cofactor(K, i, line) for i, row in enumerate(rows)]
        return _determinant_of(K, block), sum(pushed)

    return Condition(equations, order=1, singular=True)


def blocks_of(
    family: Family, by_rates: Callable[[Evaluation], Matrix] | None = None
) -> list[tuple[int, ...]]:
    """Blocks of coordinates each of which acts in the balances of all others of its block, directly
    or through others: det K is the product of their determinants; with ``by_rates``, C + G or G,
    det(λ² M + λ (C + G) + K) is.

    Where one of these is 0, the directions v and w of K v = 0 and w K = 0 need not have a part
    along a coordinate of another block.
    """
    at = _of_structure(family)
    with quiet():
        return coupled(at.slopes, *([at.mass(), by_rates(at)] if by_rates else []))


def _of_structure(family: Family) -> Evaluation:
    """A state of no meaning: of it the entries of matrices that are 0 by structure are looked
    up.
    """
    system = Augmented(family, FOLD)
    with quiet():
        return system.state(list(Intervals(np.zeros((2, system.n, 1)))), system.fixed(1))


@cache
def within_block(condition: Condition, block: Block) -> Condition:
    """A condition on M, C + G and K, on the parts of these that belong to a block of
    :func:`blocks_of`.
    """
    if block is None:
        return condition
    return replace(
        condition, equations=lambda at: condition.equations(replace(at, part=block)), block=block
    )


@cache
def fold_of(block: Block) -> Condition:
    """The determinant of a block of K is 0."""
    return Condition(lambda at: (_determinant_of(at.slopes, block),))


def _determinant_of(K: Matrix, block: Block) -> Number:
    return determinant(K if block is None else part_of(K, block))


@cache
def touch_turn(contact: int) -> Condition:
    """The gap of a contact is 0, and the curve on which it is turns back in the second parameter:
    the determinant of the slopes of forces and gap by the coordinates and the first one is 0.
    """

    def equations(at: Evaluation) -> Sequence[Any]:
        gap = at.gap(contact)
        rows, n = [*at.forces(), gap], len(at.q)
        return gap, determinant([[slope(row, k) for k in range(n + 1)] for row in rows])

    return Condition(equations, order=1, touching=contact)


def _discriminant(at: Evaluation) -> Sequence[Any]:
    """The discriminant of det(K + κ M) in κ, with G of det(κ M + λ G + K) in κ = λ², but for a
    factor.
    """
    coefficients = characteristic(at.stiffness(), at.mass())
    if at.balance.gyroscopic:
        coefficients = characteristic(at.stiffness(), at.gyroscopic(), at.mass())[::2]
    if len(coefficients) == 3:
        c, b, a = coefficients
        return (b * b - 4 * a * c,)
    return (resultant(coefficients, derivative(coefficients)),)


#: Two roots κ = −λ² of det(K − κ M) meet, or with G and a symmetric K of det(λ² M + λ G + K): the
#: discriminant of that polynomial is 0.
FLUTTER = Condition(_discriminant)
#: Two roots λ of det(λ² M + λ (C + G) + K) have the sum 0: the last but one of Hurwitz's
#: determinants is 0.
HOPF = Condition(lambda at: (hurwitz(_characteristic(None, at)),), pairs=True)


def _characteristic(along: int | None, at: Evaluation) -> list[Any]:
    """Coefficients of det(λ² M + λ C + K), the lowest first.

    Where C has one entry c, of the coordinate ``along``, the odd ones are c times what they are for
    c = 1, and the even ones do not depend on it. Then 1 stands for c: else conditions on them hold
    where c is 0.
    """
    K = at.stiffness()
    places = range(len(K))
    C = at.by_rates() if along is None else [[int(i == j == along) for j in places] for i in places]
    return characteristic(K, C, at.mass())


@cache
def undamped_mode(along: int) -> Condition:
    """:data:`HOPF` where only the coordinate ``along`` is damped, by any amount: a mode in which it
    does not move.

    Then det(λ² M + λ C + K) = A(λ²) + λ c B(λ²) with the only entry c of C, and B a minor of K + λ²
    M. A pair ± i ω is where A and B have a common root, however small c is; it is divided out.
    """

    def equations(at: Evaluation) -> Sequence[Any]:
        """The resultant of B and A, less a multiple of B: it does not depend on the entry in row
        and column ``along``.
        """
        rows = pencil(at.stiffness(), at.mass())
        B = cofactor(rows, along, along)
        rows[along][along] = Polynomial([0])
        return (resultant(trimmed(B), trimmed(determinant(rows))),)

    return Condition(equations)


@cache
def no_damping(along: int) -> Condition:
    """The damping of the coordinate ``along`` is 0: if nothing else damps, every pair of the state
    crosses.
    """
    return Condition(lambda at: (at.damping()[along][along],))


#: The slope of the friction law at steady sliding is 0: if nothing else damps, nothing damps there.
#: A slope with a sign, however small it is, has no root.
NO_SLOPE = Condition(lambda at: at.slopes_of_friction(), excluded=lambda at: at.slope_has_a_sign())
#: Kinds of points in the plane, as MatCont calls them, with what vanishes there of the
#: coefficients, the lowest first. BT: two roots λ are 0. ZH: one is, and two others have the sum 0.
#: HH: all four of two coordinates come in pairs with the sum 0.
KINDS: Mapping[str, Callable[[Sequence[Any]], Sequence[Any]]] = {
    "BT": lambda a: a[:2],
    "ZH": lambda a: (a[0], hurwitz(a[1:])),
    "HH": lambda a: a[1::2],
}


@cache
def of_kind(kind: str, along: int | None) -> Condition:
    """Points of one of the :data:`KINDS`; ``along`` as of :func:`_characteristic`."""
    return Condition(lambda at: KINDS[kind](_characteristic(along, at)))


def change(K: Matrix, column: int, block: Block = None) -> Number:
    """Change of det K, or of that of a block, along a column of the adjugate, from entries that are
    jets in the coordinates first.
    """
    value = _determinant_of(K, block)
    moved = [slope(value, i) * cofactor(K, column, i) for i in range(len(K))]
    return sum(moved)


def slope(value: Number, variable: int) -> Number:
    """The derivative of what may be a number."""
    return value.differentiated(variable) if isinstance(value, Jet) else 0


class OfFamily(StateSystem):
    """A system whose unknowns are the coordinates, then the parameters that vary."""

    def __init__(self, family: Family) -> None:
        self.family, self.balance = family, family.balance
        self.n = self.balance.n + len(family.vary)
        self.limits = np.pad(
            self.balance.limits, ((0, 0), (0, len(family.vary))), constant_values=np.inf
        )

    def fixed(self, count: int) -> Intervals:
        """Prepared parameters of so many boxes at one point of the parameters that do not vary."""
        return Intervals(np.repeat(self._begin.ends, count, axis=2))

    @cached_property
    def _begin(self) -> Intervals:
        return self.prepared_at(self.family.begin)

    def parted(
        self, unknowns: Sequence[Any], fixed: Values, xp: object
    ) -> tuple[list[Any], dict[str, Any]]:
        """Coordinates, and arguments with those that vary in place of the fixed ones; of any number
        type.
        """
        n = self.balance.n
        changed = dict(zip(self.family.vary, unknowns[n:], strict=True))
        return list(unknowns[:n]), {**fixed, **self.balance.with_angles(changed, xp)}


class Augmented(OfFamily):
    """Balance and condition."""

    def __init__(self, family: Family, condition: Condition) -> None:
        super().__init__(family)
        self.condition, self.order = condition, condition.order

    def identity(self) -> Hashable:
        """Identity of the balance, the parameters that vary, and the condition."""
        return (
            type(self.balance),
            self.balance.identity(),
            self.family.vary,
            self.condition.equations,
            self.order,
        )

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation at unknowns of any number type, from arguments of which those that vary
        are replaced.
        """
        return Evaluation(self.balance, *self.parted(q, values, xp), shape, xp)

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Forces and condition."""
        return [*at.forces(), *self.condition.equations(at)]

    def slopes_over(self, unknowns: Sequence[Number], parameters: Intervals) -> Matrix:
        """Their slopes by coordinates and parameters."""
        at = self.state(variables(list(unknowns), self.condition.order + 1), parameters)
        # By the coordinates the stiffness itself, which is sharper, and finite where a law like
        # Hertz's begins.
        n = self.balance.n
        rows = [
            [constant(entry) for entry in row] + gradient(force, self.n)[n:]
            for row, force in zip(at.slopes, at.forces(), strict=True)
        ]
        return rows + [gradient(value, self.n) for value in self.condition.equations(at)]

    def without_state(self, boxes: Boxes) -> BoolArray:
        """Boxes where no state is, or without what the condition asks for."""
        out = super().without_state(boxes)
        out = out | at_anchors(boxes, ~out, no_direction)
        if self.condition.excluded is not None:
            out = out | self.condition.excluded(boxes.state)
        return out | at_anchors(boxes, ~out, _regular) if self.singular else out

    contracts, arcs = True, DIRECTIONS

    @property
    def singular(self) -> bool:  # type: ignore[override]  # of a condition
        """True where det K = 0 is asked for, which is known of directions at anchors."""
        return self.condition.singular and not self.balance.torsions

    def lines_at(self, made: Callable[..., Tape]) -> list[LineTapes]:
        """Tapes of forces by direction, and of det K for directions on an arc."""
        lines = self.balance.springs
        forces = [made(direction_entries(line)) for line in range(lines)]
        if not self.singular:
            return [LineTapes(tape) for tape in forces]
        directions = [made(_known_direction(line)) for line in range(lines)]
        regular = [made(_determinant_entries(line), 2) for line in range(lines)]
        return [LineTapes(*tapes) for tapes in zip(forces, directions, regular, strict=True)]

    def excluded_without_plan(self, unknowns: Intervals, parameters: Intervals) -> BoolArray | None:
        """Boxes that the condition rules out by itself."""
        if self.condition.excluded is None:
            return None
        return self.condition.excluded(self.state(unknowns, parameters))

    @property
    def covered_by_plan(self) -> bool:
        """True where neither the condition nor torsion springs have tests of their own."""
        plain = self.condition.excluded is None and self.condition.abandoned is None
        return plain and not self.balance.torsions

    def abandoned(
        self, unknowns: Intervals, parameters: Intervals, times: float = 1.0
    ) -> BoolArray:
        """Boxes that the balance gives up, and those that the condition gives up."""
        out, also = np.zeros(parameters.shape[1:], dtype=bool), self.condition.abandoned
        if self.balance.torsions:
            boxes = Boxes(self, unknowns, parameters)
            out |= self.balance.at_poles(boxes, times * self.options.pole)
        return out if also is None else out | also(self.state(unknowns, parameters))

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """The coordinates contracted by the balance over the box of parameters."""
        ends = self.directed(unknowns, parameters)
        return np.concatenate([ends, unknowns.ends[:, self.balance.n :]], axis=1)


def refined_roots(system: Augmented, region: FloatArray, found: Roots) -> Roots:
    """Roots that a search along one parameter in a region has left open, or knows to few digits
    only, again with many digits.
    """
    # Boxes beyond which they lie around no points.
    if system.condition.order or found.undecided.shape[2] > 400:
        return found
    with quiet():
        if system.abandoned(
            Intervals(found.undecided), system.fixed(found.undecided.shape[2])
        ).any():
            return found  # no number of digits tells what is there
    return refined_in_digits(system, system.family.begin, region, found, most=12)


def _regular(boxes: Boxes, spring: int) -> BoolArray:
    """Boxes at the anchor of a spring in which det K is not 0, whatever its direction is.

    Most of those in which it may be 0 show it in a direction along an axis already, a fourth of a
    turn apart.
    """
    out = np.ones(boxes.shape, dtype=bool)
    # Boxes that are looked at in one go, as NumPy takes hardly longer for them than for one.
    for arcs in (ARCS,) if out.size < 64 else (ARCS[::8], ARCS):
        rows = np.flatnonzero(out)
        out[rows] = _regular_along(boxes.some(rows), spring, arcs)
    return out


def _known_direction(spring: int) -> Entries:
    """Cosine and sine of a spring over boxes."""
    return ("direction", spring), lambda at: at.directions[3 * spring : 3 * spring + 2]


def _determinant_entries(spring: int) -> Entries:
    """det K times the length of a spring, for directions on arcs."""
    first = 3 * spring

    def rows(at: Evaluation, arcs: Any) -> Sequence[Any]:
        def slopes(length: Number) -> list[Any]:
            fixed = [*at.directions[:first], *arcs, length, *at.directions[first + 3 :]]
            return [list(row) for row in replace(at, fixed=fixed).slopes]

        K = slopes(ENDLESS)
        R = slopes(Jet.variable(Intervals.point([1.0]), 0, 1))
        size = range(len(K))
        pushed = -sum(cofactor(K, i, j) * gradient(R[i][j], 1)[0] for i in size for j in size)
        return [pushed + determinant(K) * at.directions[first + 2]]

    return ("regular", spring), rows


def _regular_along(boxes: Boxes, spring: int, numbers: IntArray) -> BoolArray:
    """Boxes in which det K is not 0 for directions of the spring on these arcs."""
    (count,) = boxes.shape
    every, turns = np.tile(np.arange(count), numbers.size), np.repeat(numbers, count)
    arcs, values = DIRECTIONS[:, :, turns], boxes.taped(*_known_direction(spring))
    possible = np.flatnonzero(~contractors.apart(arcs, values[:, every].ends))
    on_arcs = Intervals(arcs[:, :, possible])
    found = boxes.some(every[possible]).taped(*_determinant_entries(spring), on_arcs)
    return np.bincount(every[possible], found[0].holds_zero(), count) == 0
