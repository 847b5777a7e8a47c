"""The balance of forces of a model over boxes of coordinates and parameters, as the search asks for
it, and with many digits.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from operator import mul
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np

from ..models.forces import presses_either
from ..models.model import OPPOSITE, Model, Touching, label_of
from ..models.quantities import Unit
from ..numerics import balls, contractors, jets
from ..numerics.arithmetic import Matrix, Number, is_zero
from ..numerics.balls import ball
from ..numerics.interval_arrays import BoolArray, FloatArray, Intervals
from ..numerics.plans import LineTapes
from ..numerics.precise_roots import Digits
from ..numerics.tape import Tape
from .forces import Evaluation, Forces, Values, filled
from .systems import Boxes, Entries, StateSystem, at_anchors, linear

#: What is smaller than this for all states is 0, but for the room that sums of intervals leave.
NEGLIGIBLE = 1e-290
#: The argument by which a length among the unknowns is measured, where there is one.
SCALE = "l/scale"

#: Ends of parameters that lie in a range.
Spans: TypeAlias = Mapping[str, tuple[Fraction, Fraction]]


class Balance(Forces, StateSystem):
    """Forces as the search asks for them: unknowns are the coordinates.

    Parameters of the search are those of the model, in its order; :meth:`prepared` turns them into
    the arguments of the generated functions, once for each node of the tree of points.
    """

    #: Arguments that follow from units, by parameter.
    factors: Mapping[str, str] = MappingProxyType({})

    def identity(self) -> Hashable:
        """Contact, the law of friction, and how far beyond the border states count."""
        return *self.pushing, self.law, *self.rooms

    def across(self, contact: int) -> Balance:
        """The balance beyond the border of that contact, where the others are as here."""
        each = zip(self.model.contacts, self.pushing, strict=True)
        touching = tuple(
            label_of(it) for k, (it, one) in enumerate(each) if bool(one) != (k == contact)
        )
        return Balance(self.model, touching, self.law, self.options).extended(
            self.beyond, self.room
        )

    def extended(self, contact: int | None = None, room: float = 1e-3) -> Balance:
        """The same balance, where states count that far beyond the border of that contact too, or
        of the one that it was extended beyond: those on the border are then inside.
        """
        other = Balance(self.model, self.contact, self.law, self.options)
        other.beyond = self.beyond if contact is None else contact
        other.room, other.border = room, other.border + room
        other.rooms = [room if other.beyond in (None, k) else 0.0 for k in other.opens]
        return other

    @property
    def touching(self) -> str:
        """Names of the contacts that touch, and of those whose opposite face does."""
        each = zip(self.model.contacts, self.pushing, strict=True)
        return ", ".join(
            label_of(it) if one else f"{OPPOSITE} of {it['name']}".removesuffix(" of ")
            for it, one in each
            if one or presses_either(it)
        )

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """The forces."""
        return at.forces()

    @property
    def anywhere(self) -> list[int]:
        """``sides`` for what needs no derivatives: turnings that jump in a box have any value
        there.
        """
        return [0] * len(self.torsions)

    def guessed(self, middles: FloatArray, parameters: Intervals) -> FloatArray:
        """Newton's method in floats."""
        values = dict(zip(self.codes, parameters.middle, strict=True))
        q = middles
        for _ in range(4):
            at = self.at(list(q), values, xp=np)
            slopes = filled(at.slopes, middles.shape[1:])
            forces = filled([at.forces()], middles.shape[1:])
            q = q - (contractors.inverse(slopes) * forces).sum(axis=1)
        return q

    def slopes_over(self, unknowns: Sequence[Number], parameters: Intervals) -> Matrix:
        """Stiffness over boxes."""
        return self.state(unknowns, parameters).slopes

    def vanishing(self, parameters: Intervals) -> list[bool]:
        """Prepared parameters that are 0 in all boxes."""
        there: BoolArray = np.logical_or.reduce(parameters.ends, axis=(0, 2))
        return [not one for one in there.tolist()]

    def nothing_at(self, boxes: Boxes) -> BoolArray:
        """Boxes on the other side of the contact's border, or where no unit vector balances the
        other forces.
        """
        out = super().nothing_at(boxes)
        return out | at_anchors(boxes, ~out, no_direction)

    contracts = True

    def lines_at(self, made: Callable[..., Tape]) -> list[LineTapes]:
        """Tapes of forces by the direction of each spring."""
        return [LineTapes(made(direction_entries(spring))) for spring in range(self.springs)]

    def abandoned(
        self, unknowns: Intervals, parameters: Intervals, times: float = 1.0
    ) -> BoolArray:
        """Small boxes around the anchor of a spring that resists turning: its force has no bound
        there.
        """
        if not self.torsions:
            return np.zeros(parameters.shape[1:], dtype=bool)
        return self.at_poles(Boxes(self, unknowns, parameters), times * self.options.pole)

    @property
    def covered_by_plan(self) -> bool:
        """True without torsion springs."""
        return not self.torsions

    def at_poles(self, at: Evaluation | Boxes, width: float) -> BoolArray:
        """Whether boxes up to a width hold a pole."""
        out = np.zeros(at.shape, dtype=bool)
        for dx, dy in at.anchors if self.torsions else ():
            out |= dx.holds_zero() & dy.holds_zero() & (np.maximum(dx.width, dy.width) < width)
        return out

    # --------------------------------------------------------------------------------------------
    # contraction

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Smaller boxes with the same roots: the coordinates that balance the forces of springs
        with these directions.
        """
        return self.directed(unknowns, parameters)

    def with_directions(self, at: Evaluation) -> FloatArray:
        """Smaller boxes with the same roots, for springs of the given directions, whatever their
        lengths.
        """
        step = contractors.newton(
            *linear(at, at.box.middle, Evaluation.forces, lambda at: at.slopes)
        )
        return np.fmin(step.ends, at.box.ends)

    def by_rows(self, at: Evaluation) -> FloatArray:
        """Bounds on each coordinate from its own row and from forces near 0, where slopes are
        unknown.
        """
        given = linear(at, at.box.nearest_to_zero, Evaluation.rows, Evaluation.stiffness)
        return np.fmin(contractors.by_rows(*given), at.box.ends)


def direction_entries(spring: int) -> Entries:
    """G and M of F = G + M (c, s) with the direction (c, s) of a spring."""
    first = 3 * spring

    def rows(at: Evaluation) -> Sequence[Any]:
        def forces(*direction: Any) -> Sequence[Any]:
            fixed = [*at.directions[:first], *direction, *at.directions[first + 2 :]]
            return replace(at, fixed=fixed).forces()

        none, cover = (Intervals(np.full((2, *at.shape), size)) for size in (0.0, 1.0))
        moved = forces(*jets.variables([cover, cover], 1))
        return [*forces(none, none), *(entry for row in moved for entry in jets.gradient(row, 2))]

    return ("no direction", spring), rows


def no_direction(boxes: Boxes, spring: int) -> BoolArray:
    """Boxes where F = G + M (c, s) is not 0 for any unit vector (c, s) of a spring, wherever its
    anchor is.
    """
    n = boxes.system.balance.n
    found = boxes.taped(*direction_entries(spring))
    M = Intervals(found.ends[:, n:].reshape(2, n, 2, *boxes.shape))
    return contractors.no_unit_vector(found[:n], M)


class PreciseBalance(Digits):
    """A system of states at one point of the parameters that do not vary, of balls or jets of
    balls.

    ``given`` are those parameters, of a system with a scale with that behind them, and ``spans``
    parameters that lie in a range.
    """

    def __init__(
        self, system: StateSystem, given: FloatArray, bits: int, spans: Spans = MappingProxyType({})
    ) -> None:
        self.system = system
        self.balance = system.balance
        self.bits = bits
        self.order = system.order
        with balls.precision(bits):
            between = {name: balls.between(*ends) for name, ends in spans.items()}
        numbers = zip([*self.balance.parameters, SCALE], np.nan_to_num(given), strict=False)
        values = {
            name: between[name] if name in spans else ball(float(number), bits)
            for name, number in numbers
        }
        self.arguments = self.balance.arguments_of(values, balls.XP)

    def equations(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Residuals of the balance at a state."""
        return self.system.conditions(self.state(unknowns), unknowns)

    def slopes(self, unknowns: Sequence[Any]) -> Matrix:
        """Slopes of it: of forces alone the stiffness, as it is generated."""
        return (
            self.state(unknowns).slopes if self.system is self.balance else super().slopes(unknowns)
        )

    def state(self, unknowns: Sequence[Any]) -> Evaluation:
        """The evaluation at unknowns."""
        return self.system.at(unknowns, self.arguments, xp=balls.XP)


class BalanceInUnits(Balance):
    """The balance with units among its parameters, after those of the model: dimensional analysis,
    p = P u₁^e₁ u₂^e₂ ….

    P is a parameter as the base values of the page's units make it dimensionless, and u is a unit's
    value over its base value. Many parameters depend on one unit; the chain rule keeps that, where
    boxes of the parameters themselves would take each for its own.
    """

    def __init__(
        self,
        model: Model,
        units: Mapping[str, Unit],
        law: str = "friction_at_rest",
        contact: Touching = True,
    ) -> None:
        super().__init__(model, contact, law)
        self.units = units
        powers = {
            unit: [name for name in self.balanced if name in one.powers]
            for unit, one in units.items()
        }
        #: Parameters of the balance that depend on each unit; a unit on which none does matters to
        #: the motion alone.
        self.scaling = {unit: names for unit, names in powers.items() if names}
        self.factors = {  # p/P as arguments of their own
            name: f"{name}/P"
            for name in self.parameters
            if any(name in unit.powers for unit in units.values())
        }
        self.parameters += units
        #: Those that are asked for: the law at rest depends on nothing of the motion.
        self.needed = [
            name for name in self.factors if law != "friction_at_rest" or name in self.balanced
        ]
        self.codes += [*units, *(self.factors[name] for name in self.needed)]

    def identity(self) -> Hashable:
        """Identity of the balance, and how parameters depend on units."""
        powers = ((name, *sorted(unit.powers.items())) for name, unit in self.units.items())
        return super().identity(), *powers

    def scaled(
        self, values: Values, xp: object = np, names: Iterable[str] | None = None
    ) -> dict[str, Any]:
        """P and u by name, of any number type, with the page's parameters p in place of P, all or
        some, and beside them p/P.
        """
        found = dict(values)
        for name in self.factors if names is None else names:
            code = self.factors[name]
            powers = (
                (values[key], unit.powers[name])
                for key, unit in self.units.items()
                if name in unit.powers
            )
            found[code] = reduce(mul, (_power(value, power, xp) for value, power in powers))
            found[name] = _times(values[name], found[code])
        return found

    def arguments_of(self, values: Values, xp: object) -> dict[str, Any]:
        """Arguments of the generated functions, units and p/P by name, of any number type."""
        return super().with_angles(self.scaled(values, xp, self.needed), xp)

    def prepared_beside(
        self, prepared: FloatArray, fixed: FloatArray, moved: Mapping[str, Intervals]
    ) -> Intervals:
        """All prepared anew: what follows from one parameter may follow from a unit too."""
        if not self.factors:
            return super().prepared_beside(prepared, fixed, moved)
        bounds = Intervals.point(fixed)
        for name, part in moved.items():
            bounds.ends[:, self.parameters.index(name)] = part.ends
        return self.prepared(bounds)

    def by_parameters(
        self, at: Evaluation, names: Sequence[str], rows: str = "forces_by_parameters"
    ) -> list[list[Any]]:
        """Derivatives by P, and by u: Σ e p/u ∂/∂p over the parameters that depend on it."""
        needed = sorted({part for name in names for part in self.scaling.get(name, [name])})
        return [
            [self._slope(name, dict(zip(needed, row, strict=True)), at.values) for name in names]
            for row in super().by_parameters(at, needed, rows)
        ]

    def _slope(self, name: str, slopes: Mapping[str, Any], values: Values) -> Number:
        if name in self.units:
            powers = self.units[name].powers
            return (
                sum(slopes[key] * values[key] * powers[key] for key in self.scaling[name])
                / values[name]
            )
        return slopes[name] * values[self.factors[name]] if name in self.factors else slopes[name]


def _power(value: Number, power: float, xp: Any) -> Number:
    whole = int(power)
    if whole == power:
        return value**whole if whole > 0 else 1 / value**-whole
    return xp.exp(power * xp.log(value))


def _times(value: Number, factor: Number) -> Number:
    """Their product; what is 0, and an end that is, stays so."""
    if is_zero(value):
        return value
    product = value * factor
    if isinstance(value, Intervals):
        return Intervals(np.where(value.ends == 0, 0.0, product.ends))
    return product
