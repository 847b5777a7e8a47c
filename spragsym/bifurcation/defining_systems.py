"""Defining systems of folds, cusps and onsets over a family of equilibria.

The unknowns are the coordinates together with the parameters that vary. The equations are the
balance of forces F = 0 and as many conditions as parameters vary: a fold has one condition, det K =
0; a cusp has two, det K = 0 and no change of det K along the null vector of K. Derivatives come
from jets over intervals. Two roots too near for float64 are separated in ball arithmetic.

Around the anchor of a spring K is unbounded, but may be proved to be regular. A spring of length l
and direction n adds R/l to the stiffness K∞ of all else. R = −k r t t′ has rank one in the
coordinates of its end, with the undeformed length r and t normal to n. So l det K = l det K∞ + Σ
cofactors of K∞ × R, which is smooth at l = 0 for each direction.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
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

#: −low and high of cosine and sine on arcs of directions, each π/16 wide: 32 make a full turn, and
#: one more covers rounding.
DIRECTIONS = stacked(
    [
        of(Intervals.between(np.pi / 16 * np.arange(33), np.pi / 16 * np.arange(1, 34)))
        for of in (XP.cos, XP.sin)
    ],
    (33,),
).ends


@dataclass(frozen=True)
class Family:
    """A family of balances: some parameters vary over ranges, the others are fixed at one or many
    points.

    ``given`` are all parameters, shape (parameters, points), NaN for those in ``vary``. ``spans``
    are the ranges of these, shape (number, 2); ``endless`` names those whose infinite range was
    cut. ``requested`` is the region of coordinates that the user asks for.
    """

    p: Any
    balance: Balance
    vary: tuple[str, ...]
    given: FloatArray
    spans: FloatArray
    requested: FloatArray | None = None
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
        """The family of a set of parameters, of the balance in contact unless another is given."""
        # Curves may begin and end on a border, so states on it are accepted.
        balance = Balance(p.model) if balance is None else balance.extended(slack=balance.slack)
        between = between or {}
        spans, requested = ranges(p, vary, between), requested_region(p.model, within)
        given = given_column(p, balance.parameters, vary)
        # Infinite ranges without a limit in ``between`` are cut.
        endless = tuple(
            name
            for name in vary
            if name not in between and math.inf in map(abs, _ends(p.model, name))
        )
        return cls(p, balance, tuple(vary), given, spans, requested, endless)

    @classmethod
    def every(
        cls,
        p: ParameterSet,
        vary: Sequence[str],
        between: Ranges | None = None,
        within: Ranges | None = None,
        options: SearchOptions | None = None,
    ) -> list[Self]:
        """The families of all combinations of touching contacts."""
        balances = balances_of(p.model, within, options)
        return [cls.of(p, vary, between, within, balance) for balance in balances]

    def in_lift_off(self, between: Ranges | None, within: Ranges | None) -> list[Self]:
        """The family of the states in which no contact touches, where one of several may."""
        model, options = self.p.model, self.balance.options
        if len(model.contacts) == 1 or not model.lifts_off:
            return []
        balances = balances_of(model, within, options, contact=False)
        return [self.of(self.p, self.vary, between, within, balance) for balance in balances]

    def beyond(self, *contacts: int) -> Self:
        """The same family with states a little beyond the borders of contacts accepted; without
        any, of the borders that the balance is extended beyond already, or of all.
        """
        return replace(self, balance=self.balance.extended(*contacts))

    def fixed(self, name: str, values: float | FloatArray) -> Self:
        """The family with one of its varying parameters fixed, at one value or at many."""
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
        """All parameters, shape (parameters, points), where those that vary have the given
        values.
        """
        points = np.broadcast_shapes(self.given.shape[1:], values.shape[1:])
        out = np.array(np.broadcast_to(self.given, (len(self.given), *points)))
        out[[self.balance.parameters.index(name) for name in self.vary]] = values
        return out

    def named(self, z: FloatArray) -> dict[str, FloatArray]:
        """Values of the varying parameters and of the coordinates by name, from unknowns of shape
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
        """Enclosures of all parameters over the ranges."""
        return Intervals.between(self.begin, self.at(self.spans[:, 1:]))

    def is_affine(self) -> bool:
        """Whether the forces are affine in the coordinates: then the states are a point, a line, or
        none, and no two of them meet.
        """
        balance = self.balance
        if balance.springs:
            return False
        with quiet():
            values = balance.over(self.over[:, :1])
            q = variables([Intervals.point(np.full(1, 0.5))] * balance.n, 2)
            try:
                rows = balance.at(q, values, (1,)).rows("forces")
            except ZeroDivisionError:  # a law that has no value there
                return False
        return all(is_linear(row) for row in rows if isinstance(row, Jet))


def ranges(p: ParameterSet, vary: Sequence[str], between: Ranges) -> FloatArray:
    """Lower and upper ends of the varying parameters, shape (number, 2); infinite ends are cut."""
    model = p.model
    for name in vary:
        model.require_parameter(name)
    given, rows = as_ranges("between", between, {name: model.any_of(name) for name in vary}), []
    for name in vary:
        own = _ends(model, name)
        # It replaces an infinite end.
        far = 10.0 * max(1.0, abs(model.base.get(name, 0.0)), largest(p, name))
        finite = [end if math.isfinite(end) else math.copysign(far, end) for end in own]
        ends = given.get(name, finite)
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


def _ends(model: Model, name: str) -> tuple[float, float]:
    """Lower and upper end of the range that the page allows."""
    allowed = model.Parameters.ranges[name]
    return allowed.low, allowed.high


def given_column(p: ParameterSet, names: Sequence[str], vary: Sequence[str]) -> FloatArray:
    """Scalar parameters as one column, NaN for those in ``vary``; ParameterError if another has no
    value.
    """
    fixed = [name for name in names if name not in vary]
    for name in fixed:
        if p[name] is None:
            raise ParameterError(
                f"{name} has no value while {' and '.join(vary)} varies; use "
                f"p.replace({name}=...), or vary it"
            )
    values = dict(zip(fixed, p.scalars(*fixed), strict=True))
    return np.array([[values.get(name, np.nan)] for name in names])


#: Numbers of the coordinates of a diagonal block of K; None for all.
Block: TypeAlias = tuple[int, ...] | None


@dataclass(frozen=True)
class Condition:
    """Conditions on a state in addition to the balance, one for each unknown parameter.

    ``equations`` gives the values that must vanish; they contain derivatives up to ``order``.
    ``singular`` says that one of them is det K, ``touching`` is the number of a contact whose gap
    is one of them. ``pairs`` says that a pair of eigenvalues crosses, and ``block`` restricts K to
    a block of coordinates. ``excluded`` are boxes in which an additional inequality can't hold,
    ``abandoned`` boxes that halving would never decide.
    """

    equations: Callable[[Evaluation], Sequence[Any]]
    order: int = 0
    singular: bool = False
    touching: int | None = None
    pairs: bool = False
    block: Block = None
    excluded: Callable[[Evaluation], BoolArray] | None = None
    abandoned: Callable[[Evaluation], BoolArray] | None = None


#: Fold: det K = 0.
FOLD = Condition(lambda at: (determinant(at.slopes),), singular=True)


@cache
def touch(contact: int) -> Condition:
    """The condition that the gap of a contact is 0."""
    return Condition(lambda at: (at.gap(contact),), touching=contact)


@cache
def both(one: Condition, other: Condition) -> Condition:
    """The conditions of both, on one state."""
    return Condition(
        lambda at: (*one.equations(at), *other.equations(at)),
        order=max(one.order, other.order),
        singular=one.singular or other.singular,
        touching=other.touching if one.touching is None else one.touching,
    )


@cache
def cusp(column: int, block: Block = None) -> Condition:
    """Cusp: det K = 0, and the derivative of det K along the null vector v of K is 0.

    If K has rank n − 1, the nonzero columns of its adjugate are multiples of v; the given column
    stands for v. States at which this column vanishes are roots too;
    :func:`spragsym.bifurcation.singularities.told_apart` separates them from cusps. With a
    ``block``, the determinant is that of the block.
    """

    def equations(at: Evaluation) -> Sequence[Any]:
        K = at.slopes
        return _determinant_of(K, block), change(K, column, block)

    return Condition(equations, order=1, singular=True)


@cache
def turn(line: int, block: Block = None) -> Condition:
    """Limit point of a curve of folds in the second parameter: det K = 0 and w · ∂F/∂v = 0.

    v is the first parameter, and w the left null vector of K, for which row ``line`` of the
    adjugate stands. States at which it vanishes are roots too. With a ``block``, the determinant is
    that of the block.
    """

    def equations(at: Evaluation) -> Sequence[Any]:
        K, rows = at.slopes, at.forces()
        pushed = [slope(row, len(K)) * cofactor(K, i, line) for i, row in enumerate(rows)]
        return _determinant_of(K, block), sum(pushed)

    return Condition(equations, order=1, singular=True)


def blocks_of(
    family: Family, by_rates: Callable[[Evaluation], Matrix] | None = None
) -> list[tuple[int, ...]]:
    """Diagonal blocks of coordinates, such that det K is the product of the blocks' determinants.

    With ``by_rates``, C + G or G, that holds for det(λ² M + λ (C + G) + K). If the determinant of
    one block is 0, the null vectors of K may have no component in other blocks.
    """
    at = _of_structure(family)
    with quiet():
        return coupled(at.slopes, *([at.mass(), by_rates(at)] if by_rates else []))


def _of_structure(family: Family) -> Evaluation:
    """An evaluation at an arbitrary state, for finding entries that are 0 by structure."""
    system = Augmented(family, FOLD)
    with quiet():
        return system.state(list(Intervals(np.zeros((2, system.n, 1)))), system.fixed(1))


@cache
def within_block(condition: Condition, block: Block) -> Condition:
    """The condition with M, C + G and K restricted to a block of :func:`blocks_of`."""
    if block is None:
        return condition

    def within(rows: Callable[[Evaluation], Any]) -> Callable[[Evaluation], Any]:
        return lambda at: rows(replace(at, part=block))

    excluded = condition.excluded and within(condition.excluded)
    return replace(condition, equations=within(condition.equations), excluded=excluded, block=block)


@cache
def fold_of(block: Block) -> Condition:
    """Fold in a block: the determinant of the block of K is 0."""
    return Condition(lambda at: (_determinant_of(at.slopes, block),))


def _determinant_of(K: Matrix, block: Block) -> Number:
    """The determinant of K, or of a block of it."""
    return determinant(K if block is None else part_of(K, block))


@cache
def touch_turn(contact: int) -> Condition:
    """Limit point in the second parameter of a curve on which the gap of a contact is 0.

    The condition is that the Jacobian of forces and gap by the coordinates and the first parameter
    is singular.
    """

    def equations(at: Evaluation) -> Sequence[Any]:
        gap = at.gap(contact)
        rows, n = [*at.forces(), gap], len(at.q)
        return gap, determinant([[slope(row, k) for k in range(n + 1)] for row in rows])

    return Condition(equations, order=1, touching=contact)


def _discriminant(at: Evaluation) -> Sequence[Any]:
    """The discriminant of det(K + κ M) in κ, up to a factor; with gyroscopic forces, of det(κ M + λ
    G + K) as a polynomial in κ = λ².
    """
    coefficients = characteristic(at.stiffness(), at.mass())
    if at.balance.gyroscopic:
        coefficients = characteristic(at.stiffness(), at.gyroscopic(), at.mass())[::2]
    if len(coefficients) == 3:
        c, b, a = coefficients
        return (b * b - 4 * a * c,)
    return (resultant(coefficients, derivative(coefficients)),)


#: Undamped flutter: two roots κ = −λ² of det(K − κ M) meet, or, with G and a symmetric K, of
#: det(λ² M + λ G + K). The discriminant of that polynomial is 0.
FLUTTER = Condition(_discriminant)


@cache
def paired(row: int) -> Condition:
    """All λ without damping come in pairs ± λ: number ``row`` of the odd coefficients of det(λ² M +
    λ G + K) is 0, and no other is proved not to be.
    """

    def others(at: Evaluation) -> BoolArray:
        rest = [constant(one) for k, one in enumerate(at.unpaired()) if k != row]
        differ: BoolArray = np.logical_or.reduce(~stacked([0, *rest], at.shape).holds_zero())
        return differ

    return Condition(lambda at: at.unpaired()[row : row + 1], excluded=others)


#: Hopf point: two roots λ of det(λ² M + λ (C + G) + K) have the sum 0, so that the last but one of
#: Hurwitz's determinants is 0.
HOPF = Condition(lambda at: (hurwitz(_characteristic(None, at)),), pairs=True)


def _characteristic(along: int | None, at: Evaluation) -> list[Any]:
    """Coefficients of det(λ² M + λ C + K), the lowest first.

    If C has one entry c only, that of the coordinate ``along``, the odd coefficients are
    proportional to c and the even ones do not depend on it. Then c is replaced by 1, since
    conditions on the coefficients would also hold where c is 0.
    """
    K = at.stiffness()
    places = range(len(K))
    C = at.by_rates() if along is None else [[int(i == j == along) for j in places] for i in places]
    return characteristic(K, C, at.mass())


@cache
def undamped_mode(along: int) -> Condition:
    """:data:`HOPF` if only the coordinate ``along`` is damped: a mode in which it does not move.

    Then det(λ² M + λ C + K) = A(λ²) + λ c B(λ²), where c is the only entry of C and B a minor of K
    + λ² M. There is a pair ± i ω exactly if A and B have a common root, for any c ≠ 0.
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
    """The damping of the coordinate ``along`` is 0. If nothing else damps, every pair of
    eigenvalues crosses there.
    """
    return Condition(lambda at: (at.damping()[along][along],))


#: The slope of the friction law in steady sliding is 0, so that nothing damps if dampers do not.
#: Boxes where the slope is proved to be nonzero are excluded, however small it is.
NO_SLOPE = Condition(lambda at: at.slopes_of_friction(), excluded=lambda at: at.slope_has_a_sign())


@cache
def of_kind(kind: str, along: int | None) -> Condition:
    """The condition of a codimension-two point by its name in MatCont; ``along`` is that of
    :func:`_characteristic`.

    BT: two roots λ are 0. ZH: one root is 0, and two others have the sum 0. HH, of two coordinates:
    two pairs with the sum 0.
    """
    # What vanishes there, from the coefficients of the polynomial, the lowest first.
    vanishing: Mapping[str, Callable[[Sequence[Any]], Sequence[Any]]] = {
        "BT": lambda a: a[:2],
        "ZH": lambda a: (a[0], hurwitz(a[1:])),
        "HH": lambda a: a[1::2],
    }
    return Condition(lambda at: vanishing[kind](_characteristic(along, at)))


def change(K: Matrix, column: int, block: Block = None) -> Number:
    """The derivative of det K, or of a block's determinant, along a column of the adjugate of K.

    The entries of K are jets whose first variables are the coordinates.
    """
    value = _determinant_of(K, block)
    moved = [slope(value, i) * cofactor(K, column, i) for i in range(len(K))]
    return sum(moved)


def slope(value: Number, variable: int) -> Number:
    """The derivative of a jet by one of its variables; 0 for a constant."""
    return value.differentiated(variable) if isinstance(value, Jet) else 0


class OfFamily(StateSystem):
    """A system whose unknowns are the coordinates and then the varying parameters of a family."""

    def __init__(self, family: Family) -> None:
        self.family, self.balance = family, family.balance
        self.n = self.balance.n + len(family.vary)
        self.limits = np.pad(
            self.balance.limits, ((0, 0), (0, len(family.vary))), constant_values=np.inf
        )

    def fixed(self, count: int) -> Intervals:
        """Prepared parameters for ``count`` boxes, at one point of the fixed parameters."""
        return Intervals(np.repeat(self._begin.ends, count, axis=2))

    @cached_property
    def _begin(self) -> Intervals:
        return self.prepared_at(self.family.begin)

    def parted(
        self, unknowns: Sequence[Any], fixed: Values, xp: object
    ) -> tuple[list[Any], dict[str, Any]]:
        """Coordinates, and arguments in which the varying parameters have their unknown values."""
        n = self.balance.n
        changed = dict(zip(self.family.vary, unknowns[n:], strict=True))
        return list(unknowns[:n]), {**fixed, **self.balance.with_angles(changed, xp)}


class Augmented(OfFamily):
    """The defining system: balance and condition."""

    def __init__(self, family: Family, condition: Condition) -> None:
        super().__init__(family)
        self.condition, self.order = condition, condition.order

    def identity(self) -> Hashable:
        """Identity of the balance, the varying parameters and the condition."""
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
        """The evaluation at unknowns; the varying parameters in ``values`` are replaced."""
        return Evaluation(self.balance, *self.parted(q, values, xp), shape, xp)

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """The forces, followed by the condition's equations."""
        return [*at.forces(), *self.condition.equations(at)]

    def slopes_over(self, unknowns: Sequence[Number], parameters: Intervals) -> Matrix:
        """The Jacobian by coordinates and varying parameters over boxes."""
        at = self.state(variables(list(unknowns), self.condition.order + 1), parameters)
        # Derivatives by the coordinates are the generated stiffness: sharper than jets, and finite
        # where a law like Hertz's begins.
        n = self.balance.n
        rows = [
            [constant(entry) for entry in row] + gradient(force, self.n)[n:]
            for row, force in zip(at.slopes, at.forces(), strict=True)
        ]
        return rows + [gradient(value, self.n) for value in self.condition.equations(at)]

    def without_state(self, boxes: Boxes) -> BoolArray:
        """Boxes without a state, or whose states are proved not to fulfil the condition."""
        out = super().without_state(boxes)
        out = out | at_anchors(boxes, ~out, no_direction)
        if self.condition.excluded is not None:
            out = out | self.condition.excluded(boxes.state)
        return out | at_anchors(boxes, ~out, _regular) if self.singular else out

    contracts, arcs = True, DIRECTIONS

    @property
    def singular(self) -> bool:  # type: ignore[override]  # of a condition
        """Whether the condition includes det K = 0; then boxes near anchors may be excluded
        by it.
        """
        return self.condition.singular and not self.balance.torsions

    def lines_at(self, made: Callable[..., Tape]) -> list[LineTapes]:
        """Tapes for boxes near anchors: the forces by a spring's direction, and det K on arcs of
        directions.
        """
        lines = self.balance.springs
        forces = [made(direction_entries(line)) for line in range(lines)]
        if not self.singular:
            return [LineTapes(tape) for tape in forces]
        directions = [made(_known_direction(line)) for line in range(lines)]
        regular = [made(_determinant_entries(line), 2) for line in range(lines)]
        return [LineTapes(*tapes) for tapes in zip(forces, directions, regular, strict=True)]

    def excluded_without_plan(self, unknowns: Intervals, parameters: Intervals) -> BoolArray | None:
        """Boxes that the condition's inequality excludes."""
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
        """Boxes that the balance or the condition abandons."""
        out = np.zeros(parameters.shape[1:], dtype=bool)
        if self.balance.torsions:
            boxes = Boxes(self, unknowns, parameters)
            out |= self.balance.at_poles(boxes, times * self.options.pole)
        if self.condition.abandoned is not None:
            out |= self.condition.abandoned(self.state(unknowns, parameters))
        return out

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Boxes with the coordinates contracted by the balance, over the box of parameters."""
        ends = self.directed(unknowns, parameters)
        return np.concatenate([ends, unknowns.ends[:, self.balance.n :]], axis=1)


def refined_roots(system: Augmented, region: FloatArray, found: Roots) -> Roots:
    """The roots of a search along one parameter, after ball arithmetic has treated undecided and
    inaccurate ones.
    """
    count = found.undecided.shape[2]
    # So many boxes do not lie around isolated points.
    if system.condition.order or count > 400:
        return found
    with quiet():
        if system.abandoned(Intervals(found.undecided), system.fixed(count)).any():
            return found  # no precision decides a pole
    return refined_in_digits(system, system.family.begin, region, found, most=12)


def _regular(boxes: Boxes, spring: int) -> BoolArray:
    """Boxes near the anchor of a spring in which det K is proved to be nonzero for any direction.

    Arcs a quarter of a turn apart are tried first: most boxes that can't be excluded fail there.
    """
    out = np.ones(boxes.shape, dtype=bool)
    every = np.arange(DIRECTIONS.shape[-1])
    # Fewer boxes take NumPy hardly longer on all arcs than on some.
    for arcs in (every,) if out.size < 64 else (every[::8], every):
        rows = np.flatnonzero(out)
        out[rows] = _regular_along(boxes.some(rows), spring, arcs)
    return out


def _known_direction(spring: int) -> Entries:
    """Entries of cosine and sine of a spring's direction over boxes."""
    return ("direction", spring), lambda at: at.directions[3 * spring : 3 * spring + 2]


def _determinant_entries(spring: int) -> Entries:
    """Entries of det K times the length of a spring, for directions on arcs."""
    first = 3 * spring

    def rows(at: Evaluation, arcs: Iterable[Number]) -> Sequence[Any]:
        def slopes(length: Number) -> list[Any]:
            fixed = [*at.directions[:first], *arcs, length, *at.directions[first + 3 :]]
            return [list(row) for row in replace(at, fixed=fixed).slopes]

        K = slopes(ENDLESS)
        R = slopes(Jet.variable(Intervals.point([1.0]), 0, 1))
        size = range(len(K))
        rank_one = -sum(cofactor(K, i, j) * gradient(R[i][j], 1)[0] for i in size for j in size)
        return [rank_one + determinant(K) * at.directions[first + 2]]

    return ("regular", spring), rows


def _regular_along(boxes: Boxes, spring: int, numbers: IntArray) -> BoolArray:
    """Boxes in which det K is nonzero for all directions of the spring on the arcs of these
    numbers.
    """
    (count,) = boxes.shape
    every, turns = np.tile(np.arange(count), numbers.size), np.repeat(numbers, count)
    arcs, values = DIRECTIONS[:, :, turns], boxes.taped(*_known_direction(spring))
    possible = np.flatnonzero(~contractors.apart(arcs, values[:, every].ends))
    on_arcs = Intervals(arcs[:, :, possible])
    found = boxes.some(every[possible]).taped(*_determinant_entries(spring), on_arcs)
    return np.bincount(every[possible], found[0].holds_zero(), count) == 0
