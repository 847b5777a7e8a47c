"""The balance of forces F(q, p) = 0 of a model, as a system for branch and prune over boxes of
coordinates and parameters, and as a system in ball arithmetic at one point of the parameters.
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

#: A force whose enclosure is smaller than this is 0: rounding outward makes enclosures of 0 wider.
NEGLIGIBLE = 1e-290
#: Name of the argument that scales an unknown length, in systems that have one.
SCALE = "l/scale"

#: Lower and upper end of parameters that vary in a range, by name.
Spans: TypeAlias = Mapping[str, tuple[Fraction, Fraction]]


class Balance(Forces, StateSystem):
    """The forces of a model as a system F(q, p) = 0 whose unknowns are the coordinates q.

    Parameters of the search are those of the model, in the model's order. :meth:`prepared` turns
    them into the arguments of the generated functions, once for each node of the tree of points.
    """

    #: Name of the argument p/P, by the name of each parameter p that depends on a unit.
    factors: Mapping[str, str] = MappingProxyType({})

    def identity(self) -> Hashable:
        """Touching contacts, friction law and margins beyond the borders, on which tapes depend."""
        return *self.indicators, self.law, *self.slacks

    def across(self, contact: int) -> Balance:
        """The balance with the state of one contact switched between open and touching."""
        entries = zip(self.model.contacts, self.indicators, strict=True)
        touching = tuple(
            label_of(entry) for k, (entry, one) in enumerate(entries) if bool(one) != (k == contact)
        )
        return Balance(self.model, touching, self.law, self.options).extended(
            *self.beyond, slack=self.slack
        )

    def extended(self, *contacts: int, slack: float = 1e-3) -> Balance:
        """The same balance, where states up to ``slack`` beyond the borders of contacts are
        accepted too.

        States on these borders are then in the interior. Without contacts, the borders are those
        that this balance is extended beyond already, or else those of every contact.
        """
        other = Balance(self.model, self.contact, self.law, self.options)
        other.beyond = contacts or self.beyond
        other.slack, other.border = slack, other.border + slack
        other.slacks = [slack if k in (other.beyond or other.opens) else 0.0 for k in other.opens]
        return other

    @property
    def touching(self) -> str:
        """Labels of the touching contacts, separated by commas.

        A contact that presses on either of two faces always appears, with the face that touches.
        """
        entries = zip(self.model.contacts, self.indicators, strict=True)
        return ", ".join(
            label_of(entry) if one else f"{OPPOSITE} of {entry['name']}".removesuffix(" of ")
            for entry, one in entries
            if one or presses_either(entry)
        )

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """The forces, which vanish at an equilibrium."""
        return at.forces()

    @property
    def any_side(self) -> list[int]:
        """``sides`` of an evaluation in which a torsion angle may have any value in [−π, π] in
        boxes where it jumps. Only values are valid with it, no derivatives.
        """
        return [0] * len(self.torsions)

    def guessed(self, middles: FloatArray, parameters: Intervals) -> FloatArray:
        """Approximate roots, by four steps of Newton's method in floats from the middles of
        boxes.
        """
        values = dict(zip(self.codes, parameters.middle, strict=True))
        q = middles
        for _ in range(4):
            at = self.at(list(q), values, xp=np)
            slopes = filled(at.slopes, middles.shape[1:])
            forces = filled([at.forces()], middles.shape[1:])
            q = q - (contractors.inverse(slopes) * forces).sum(axis=1)
        return q

    def slopes_over(self, unknowns: Sequence[Number], parameters: Intervals) -> Matrix:
        """The Jacobian ∂F/∂q over boxes, from the generated stiffness."""
        return self.state(unknowns, parameters).slopes

    def vanishing(self, parameters: Intervals) -> list[bool]:
        """For each prepared parameter, whether it is 0 in all boxes."""
        nonzero: BoolArray = np.logical_or.reduce(parameters.ends, axis=(0, 2))
        return [not one for one in nonzero.tolist()]

    def without_state(self, boxes: Boxes) -> BoolArray:
        """Boxes without a state: those beyond a contact's border, and those near the anchor of a
        spring whose force can't balance the other forces in any direction.
        """
        out = super().without_state(boxes)
        return out | at_anchors(boxes, ~out, no_direction)

    contracts = True

    def lines_at(self, made: Callable[..., Tape]) -> list[LineTapes]:
        """One tape of :func:`direction_entries` for each spring, for boxes near its anchor."""
        return [LineTapes(made(direction_entries(spring))) for spring in range(self.springs)]

    def abandoned(
        self, unknowns: Intervals, parameters: Intervals, times: float = 1.0
    ) -> BoolArray:
        """Boxes narrower than ``times`` the option ``pole`` that hold the anchor of a torsion
        spring.

        The force of such a spring is unbounded at its anchor, so that halving never decides the
        box.
        """
        if not self.torsions:
            return np.zeros(parameters.shape[1:], dtype=bool)
        return self.at_poles(Boxes(self, unknowns, parameters), times * self.options.pole)

    @property
    def covered_by_plan(self) -> bool:
        """True without torsion springs: a plan does not know their poles."""
        return not self.torsions

    def at_poles(self, at: Evaluation | Boxes, width: float) -> BoolArray:
        """Boxes narrower than ``width`` that hold the anchor of a spring, if there are torsion
        springs.
        """
        out = np.zeros(at.shape, dtype=bool)
        for dx, dy in at.anchors if self.torsions else ():
            out |= dx.holds_zero() & dy.holds_zero() & (np.maximum(dx.width, dy.width) < width)
        return out

    # --------------------------------------------------------------------------------------------
    # contraction

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Boxes that hold the same roots, by one interval Newton step with frozen spring
        directions.
        """
        return self.directed(unknowns, parameters)

    def with_directions(self, at: Evaluation) -> FloatArray:
        """The contraction of :meth:`contracted` for an evaluation whose directions are given, of
        springs of any length.
        """
        step = contractors.newton(
            *linear(at, at.box.middle, Evaluation.forces, lambda at: at.slopes)
        )
        return np.fmin(step.ends, at.box.ends)

    def by_rows(self, at: Evaluation) -> FloatArray:
        """Boxes that hold the same roots, from bounds on each coordinate by its own row.

        The rows are linearized about the point nearest to 0, for boxes where the stiffness is
        unbounded.
        """
        lines = linear(at, at.box.nearest_to_zero, Evaluation.rows, Evaluation.stiffness)
        return np.fmin(contractors.by_rows(*lines), at.box.ends)


def direction_entries(spring: int) -> Entries:
    """Entries of G and M in F = G + M (c, s), where (c, s) is the direction of one spring."""
    first = 3 * spring

    def rows(at: Evaluation) -> Sequence[Any]:
        def forces(*direction: Any) -> Sequence[Any]:
            fixed = [*at.directions[:first], *direction, *at.directions[first + 2 :]]
            return replace(at, fixed=fixed).forces()

        zero = Intervals(np.zeros((2, *at.shape)))
        any_component = Intervals(np.ones((2, *at.shape)))  # [−1, 1]
        moved = forces(*jets.variables([any_component, any_component], 1))
        return [*forces(zero, zero), *(entry for row in moved for entry in jets.gradient(row, 2))]

    return ("no direction", spring), rows


def no_direction(boxes: Boxes, spring: int) -> BoolArray:
    """Boxes in which F = G + M (c, s) vanishes for no unit vector (c, s), the direction of one
    spring.

    A box may hold the anchor of that spring, where the direction is undefined.
    """
    n = boxes.system.balance.n
    found = boxes.taped(*direction_entries(spring))
    M = Intervals(found.ends[:, n:].reshape(2, n, 2, *boxes.shape))
    return contractors.no_unit_vector(found[:n], M)


class PreciseBalance(Digits):
    """A system of states in ball arithmetic, at one point of the parameters.

    ``given`` are the parameters of the balance, followed by the scale of a length among the
    unknowns if the system has one. Parameters in ``spans`` are balls that cover a range instead.
    """

    def __init__(
        self, system: StateSystem, given: FloatArray, bits: int, spans: Spans = MappingProxyType({})
    ) -> None:
        self.system = system
        self.balance = system.balance
        self.bits = bits
        self.order = system.order
        with balls.precision(bits):
            ranges = {name: balls.between(*ends) for name, ends in spans.items()}
        numbers = zip([*self.balance.parameters, SCALE], np.nan_to_num(given), strict=False)
        values = {name: ball(float(number), bits) for name, number in numbers}
        self.arguments = self.balance.arguments_of(values | ranges, balls.XP)

    def equations(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Residuals of the system at a state, balls or jets of balls as the unknowns are."""
        return self.system.conditions(self.state(unknowns), unknowns)

    def slopes(self, unknowns: Sequence[Any]) -> Matrix:
        """Jacobian of the system; that of the balance itself is the generated stiffness."""
        if self.system is self.balance:
            return self.state(unknowns).slopes
        return super().slopes(unknowns)

    def state(self, unknowns: Sequence[Any]) -> Evaluation:
        """The evaluation of the system's functions at unknowns."""
        return self.system.at(unknowns, self.arguments, xp=balls.XP)


class BalanceInUnits(Balance):
    """The balance with the sizes of units as further parameters, by dimensional analysis.

    A parameter of the page is p = P u₁^e₁ u₂^e₂ …. P is its dimensionless value in the base units
    of the page, and u is the size of a unit over its base value. Many parameters depend on one
    unit. The search varies P and u, so that interval arithmetic keeps this dependence; with boxes
    of p itself, each parameter would vary on its own.
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
        #: Parameters of the balance that depend on each unit. Without such parameters, a unit
        #: matters to the motion alone and is left out.
        self.scaling = {unit: names for unit, names in powers.items() if names}
        self.factors = {
            name: f"{name}/P"
            for name in self.parameters
            if any(name in unit.powers for unit in units.values())
        }
        self.parameters += units
        #: Parameters that need p/P: the law at rest does not depend on parameters of the motion.
        self.needed = [
            name for name in self.factors if law != "friction_at_rest" or name in self.balanced
        ]
        self.codes += [*units, *(self.factors[name] for name in self.needed)]

    def identity(self) -> Hashable:
        """Identity of the balance, and the exponents of the units."""
        powers = ((name, *sorted(unit.powers.items())) for name, unit in self.units.items())
        return super().identity(), *powers

    def scaled(
        self, values: Values, xp: object = np, names: Iterable[str] | None = None
    ) -> dict[str, Any]:
        """Values with P replaced by p, and with the factors p/P added, of any number type.

        ``values`` are P and u by name; ``names`` are the parameters to replace, by default all that
        depend on a unit.
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
        """Arguments of the generated functions, with units and p/P, by name, of any number type."""
        return super().with_angles(self.scaled(values, xp, self.needed), xp)

    def prepared_beside(
        self, prepared: FloatArray, fixed: FloatArray, moved: Mapping[str, Intervals]
    ) -> Intervals:
        """Prepared parameters where some have moved; all are computed again, since an argument may
        depend on a parameter and on a unit.
        """
        if not self.factors:
            return super().prepared_beside(prepared, fixed, moved)
        bounds = Intervals.point(fixed)
        for name, part in moved.items():
            bounds.ends[:, self.parameters.index(name)] = part.ends
        return self.prepared(bounds)

    def by_parameters(
        self, at: Evaluation, names: Sequence[str], rows: str = "forces_by_parameters"
    ) -> list[list[Any]]:
        """Derivatives of the rows by P, and by units: ∂/∂u = Σ e p/u ∂/∂p over parameters that
        depend on u.
        """
        needed = sorted({part for name in names for part in self.scaling.get(name, [name])})
        return [
            [self._slope(name, dict(zip(needed, row, strict=True)), at.values) for name in names]
            for row in super().by_parameters(at, needed, rows)
        ]

    def _slope(self, name: str, slopes: Mapping[str, Any], values: Values) -> Number:
        """The derivative of one row by P or by u, from its ``slopes`` ∂/∂p (chain rule)."""
        if name in self.units:
            powers = self.units[name].powers
            return (
                sum(slopes[key] * values[key] * powers[key] for key in self.scaling[name])
                / values[name]
            )
        return slopes[name] * values[self.factors[name]] if name in self.factors else slopes[name]


def _power(value: Number, power: float, xp: Any) -> Number:
    """``value**power``; exact powers are products, others go through exp and log."""
    whole = int(power)
    if whole == power:
        return value**whole if whole > 0 else 1 / value**-whole
    return xp.exp(power * xp.log(value))


def _times(value: Number, factor: Number) -> Number:
    """The product of ``value`` and ``factor``, exactly 0 where ``value`` or its end is 0."""
    if is_zero(value):
        return value
    product = value * factor
    if isinstance(value, Intervals):
        return Intervals(np.where(value.ends == 0, 0.0, product.ends))
    return product
