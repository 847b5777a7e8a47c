"""The balance of forces of a model over boxes of coordinates and parameters, as the search asks for it."""

import itertools
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from operator import mul
from typing import Any, TypeAlias

import numpy as np

from ..models.quantities import Unit
from ..numerics import contractors, jets
from ..numerics.arithmetic import Matrix
from ..numerics.boxes import POLE, System
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, Shape, matrix, stacked
from .forces import Forces, Model, Values
from .namespaces import FREE, XP

#: Sizes of a box from an anchor up to which it is asked whether any direction of the spring balances the forces.
AWAY = 1.0
#: Steps of Newton's method from the middle of a box that has one root.
GUESSES = 4
#: What is smaller than this for all states is 0, but for the room that sums of intervals leave.
NOTHING = 1e-290

#: Which of some boxes, by their numbers, are excluded on the given sides of the jumps of turnings.
Excluded: TypeAlias = Callable[[IntArray, Sequence[int]], BoolArray]
Linear: TypeAlias = tuple[Intervals, Intervals, FloatArray, FloatArray]


class Balance(Forces, System):
    """Forces as the search asks for them: unknowns are the coordinates.

    Parameters of the search are those of the model, in its order; :meth:`prepared` turns them into the arguments of the
    generated functions, once for each node of the tree of points.
    """

    #: Whether forces contain a length, once that was asked.
    _lengths: bool | None = None

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Forces over boxes, shape (n, N)."""
        q, values, shape = self._taken(unknowns, parameters)
        return stacked(self.call("forces", q, self.directions(q, values, shape, sides=self.anywhere), values), shape)

    @property
    def anywhere(self) -> list[int]:
        """``sides`` for what needs no derivatives: turnings that jump in a box have any value there."""
        return [0] * len(self.torsions)

    def guessed(self, middles: FloatArray, parameters: Intervals) -> FloatArray:
        """Newton's method in floats."""
        values = dict(zip(self.codes, parameters.middle, strict=True))
        q = middles
        for _ in range(GUESSES):
            directions = self.plain_directions(list(q), values, np)
            forces, rows = (self.call(name, list(q), directions, values, np) for name in ("forces", "forces_jacobian"))
            J = contractors.inverse(np.array([[entry + 0.0 * q[0] for entry in row] for row in rows]))
            q = q - (J * np.array([force + 0.0 * q[0] for force in forces])[None]).sum(axis=1)
        return q

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Stiffness over boxes, shape (n, n, N)."""
        q, values, shape = self._taken(unknowns, parameters)
        rows = self.call("forces_jacobian", q, self.directions(q, values, shape), values)
        return matrix(rows, shape)

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes on the other side of the contact's border, or where no unit vector balances the other forces."""
        return self.nothing_at(*self._taken(unknowns, parameters))

    def nothing_at(self, q: Sequence[Intervals], values: Values, shape: Shape) -> BoolArray:
        """Whether nothing acts at coordinates, with their arguments."""
        out = self.beyond_border(q, values, shape)
        for spring, (dx, dy) in enumerate(self.anchors(q, values, shape)):
            # Farther from the anchor the direction is known so well that the forces themselves tell.
            rows = np.flatnonzero(~out & (np.hypot(dx.mignitude, dy.mignitude) <= AWAY * (dx.width + dy.width)))
            if rows.size:
                out[rows] = self._no_direction([part[rows] for part in q], taken(values, rows), rows.shape, spring)

        def unbalanced(rows: IntArray, sides: Sequence[int]) -> BoolArray:
            place, some = [part[rows] for part in q], taken(values, rows)
            forces = self.call("forces", place, self.directions(place, some, rows.shape, sides=sides), some)
            return ~np.logical_and.reduce(stacked(forces, rows.shape).holds_zero())

        return out | self.beside_jumps(q, values, ~out, unbalanced)

    def beside_jumps(self, q: Sequence[Intervals], values: Values, among: BoolArray, excluded: Excluded) -> BoolArray:
        """Boxes in which a turning jumps, and that are excluded on each side of the jump."""
        out = np.zeros(among.shape, dtype=np.bool_)
        if not self.torsions or not among.any():
            return out
        turnings = self.directions(q, values, among.shape)[3 * self.springs :]
        jumps = np.logical_or.reduce([np.isnan(phi.ends[0]) for phi in turnings])
        rows = np.flatnonzero(among & jumps)
        if rows.size:
            every = itertools.product((1, -1), repeat=len(self.torsions))
            out[rows] = np.logical_and.reduce([excluded(rows, sides) for sides in every])
        return out

    def beyond_border(self, q: Sequence[Any], values: Values, shape: Shape) -> BoolArray:
        """Boxes that lie on the other side of the contact's border."""
        if not self.opens:
            return np.zeros(shape, dtype=np.bool_)
        return self.sides(stacked([self.gap(q, values)], shape)[0])[1]

    def sides(self, gap: Intervals) -> tuple[BoolArray, BoolArray]:
        """Gaps on this side of the contact's border or on it, and gaps beyond it."""
        if self.contact:
            return gap.high <= self.room, gap.low > self.room
        return gap.low >= -self.room, gap.high < -self.room

    def gap_over(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """The gap of the contact over boxes, shape (N,)."""
        q, values, shape = self._taken(unknowns, parameters)
        return stacked([self.gap(q, values)], shape)[0]

    def _no_direction(self, q: Sequence[Intervals], values: Values, shape: Shape, spring: int) -> BoolArray:
        """Boxes where F = G + M (c, s) is not 0 for any unit vector (c, s) of a spring, wherever its anchor is."""
        directions = self.directions(q, values, shape)
        place = 3 * spring
        cover = Intervals(np.ones((2, *shape)))
        directions[place], directions[place + 1] = (jets.Jet.variable(cover, number, 1) for number in (0, 1))
        rows = [jets.gradient(row, 2) for row in self.call("forces", q, directions, values)]
        M = matrix(rows, shape)
        directions[place] = directions[place + 1] = Intervals(np.zeros((2, *shape)))
        G = stacked(self.call("forces", q, directions, values), shape)
        return contractors.no_unit_vector(G, M)

    def given_up(self, unknowns: Intervals, parameters: Intervals, width: float = POLE) -> BoolArray:
        """Small boxes around the anchor of a spring that resists turning: its force has no bound there."""
        return self.at_poles(*self._taken(unknowns, parameters), width)

    def at_poles(self, q: Sequence[Any], values: Values, shape: Shape, width: float) -> BoolArray:
        """Whether boxes up to a width hold a pole, with their arguments."""
        out = np.zeros(shape, dtype=np.bool_)
        if self._lengths:
            for dx, dy in self.anchors(q, values, shape):
                out |= dx.holds_zero() & dy.holds_zero() & (np.maximum(dx.width, dy.width) < width)
        return out

    def anchors(self, q: Sequence[Any], values: Values, shape: Shape) -> list[tuple[Intervals, Intervals]]:
        """The vectors from the mass to the anchors of all springs."""
        return [(stacked([dx], shape)[0], stacked([dy], shape)[0]) for dx, dy, _ in self.geometry(q, values)]

    # -------------------------------------------------------------------------------------------- contraction

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Smaller boxes with the same roots: the coordinates that balance the forces of springs with these directions."""
        q, values, shape = self._taken(unknowns, parameters)
        return self.with_directions(unknowns, values, self.directions(q, values, shape, sides=self.anywhere))

    def with_directions(self, unknowns: Intervals, values: Values, directions: Sequence[Any]) -> FloatArray:
        """Smaller boxes with the same roots, for springs of the given directions, whatever their lengths."""
        step = contractors.newton(*self._linear(unknowns, unknowns.middle, values, directions))
        return np.fmin(step.ends, unknowns.ends)

    def by_rows(self, unknowns: Intervals, values: Values, directions: Sequence[Any]) -> FloatArray:
        """Bounds on each coordinate from its own row and from forces near 0, where slopes are unknown."""
        near = unknowns.nearest_to_zero
        return np.fmin(contractors.by_rows(*self._linear(unknowns, near, values, directions, self.by_coordinate)), unknowns.ends)

    def with_waves(self, unknowns: Intervals, values: Values, directions: Sequence[Any]) -> FloatArray:
        """The balance with cosines and sines of the coordinates as free unknowns, as directions are."""
        near = unknowns.nearest_to_zero
        given = self.linear(unknowns, near, lambda q: self.by_coordinate("forces", q, directions, values, FREE))
        return np.fmin(contractors.by_rows(*given), unknowns.ends)

    def linear(self, unknowns: Intervals, at: FloatArray, forces: Callable[[list[Any]], Sequence[Any]]) -> Linear:
        """What contractors take: forces at points of the boxes, slopes over the boxes, the points and distances from them."""
        shape = unknowns.shape[1:]
        slopes = matrix([jets.gradient(row, self.n) for row in forces(jets.variables(list(unknowns), 1))], shape)
        return stacked(forces(list(Intervals.point(at))), shape), slopes, at, contractors.distance(unknowns.ends, at)

    def _linear(
        self,
        unknowns: Intervals,
        at: FloatArray,
        values: Values,
        directions: Sequence[Any],
        call: Callable[..., Any] | None = None,
    ) -> Linear:
        """:meth:`linear` with directions and lengths fixed."""
        shape, call = unknowns.shape[1:], call or self.call
        if self._lengths_matter(unknowns, values, directions):
            return self.linear(unknowns, at, lambda q: call("forces", q, directions, values))
        # What directions change by goes with one over the length, and of these lengths that is 0 to rounding. So no law is asked
        # for a derivative that its stiffness has in a sharper form.
        endless = Intervals.between(np.full(shape, 1e290), np.full(shape, 1e308))
        far = [endless if self._is_length(i) else part for i, part in enumerate(directions)]
        slopes = matrix(call("forces_jacobian", list(unknowns), far, values), shape)
        forces = stacked(call("forces", list(Intervals.point(at)), directions, values), shape)
        return forces, slopes, at, contractors.distance(unknowns.ends, at)

    def _lengths_matter(self, unknowns: Intervals, values: Values, directions: Sequence[Any]) -> bool:
        """Whether the forces contain a length, as those of torsion springs do: then they are unknown where it is. Asked once."""
        if self._lengths is None and unknowns.shape[1]:
            one = np.zeros(1, dtype=np.int64)
            unknown = Intervals(np.full((2, 1), np.nan))
            parts = [unknown if self._is_length(i) else part[one] for i, part in enumerate(directions)]
            forces = self.call("forces", [part[one] for part in unknowns], parts, taken(values, one))
            self._lengths = bool(np.isnan(stacked(forces, (1,)).ends).all(axis=(0, 2)).any())
        return bool(self._lengths)

    def _is_length(self, place: int) -> bool:
        return place < 3 * self.springs and place % 3 == 2

    def _taken(self, unknowns: Intervals, parameters: Intervals) -> tuple[list[Intervals], dict[str, Any], tuple[int, ...]]:
        return list(unknowns), self.arguments(parameters), unknowns.shape[1:]


def taken(values: Values, rows: IntArray) -> dict[str, Any]:
    """The arguments of some boxes."""
    return {name: value[rows] if isinstance(value, Intervals) else value for name, value in values.items()}


@dataclass
class State:
    """Coordinates, directions, arguments of one evaluation, all of one number type, and what follows from them."""

    balance: Balance
    q: Sequence[Any]
    values: Values
    shape: Shape
    upright: Sequence[int] = ()
    xp: Any = XP
    sides: Sequence[int] | None = None

    @cached_property
    def directions(self) -> list[Any]:
        """Cosine, sine and length of every spring, and turnings."""
        if self.xp is XP:
            return self.balance.directions(self.q, self.values, self.shape, self.upright, self.sides)
        return self.balance.plain_directions(self.q, self.values, self.xp)

    def forces(self) -> Sequence[Any]:
        """Rows of the balance."""
        return self.balance.call("forces", self.q, self.directions, self.values, self.xp)

    def slopes(self) -> Matrix:
        """Derivatives of the rows of the balance: det K is their determinant, and K v is 0 where theirs is."""
        return self._slopes

    @cached_property
    def _slopes(self) -> Matrix:
        return self.balance.call("forces_jacobian", self.q, self.directions, self.values, self.xp)

    def stiffness(self) -> Matrix:
        """The stiffness matrix K."""
        if not self.balance.sums:
            return self._slopes
        return self.balance.by_coordinate("forces_jacobian", self.q, self.directions, self.values, self.xp)

    def gap(self) -> Any:
        """The gap of the contact."""
        return self.balance.gap(self.q, self.values, self.xp)

    def mass(self) -> Matrix:
        """The mass matrix M."""
        return self.balance.mass(self.q, self.values, self.xp)

    def damping(self) -> Matrix:
        """C: dampers and slope of the friction law."""
        return self.balance.damping(self.q, self.directions, self.values, xp=self.xp)

    def slope(self) -> Any:
        """Slope of the friction law."""
        return self.balance.slope(self.values, self.xp)


class BalanceInUnits(Balance):
    """The balance with units among its parameters, after those of the model: dimensional analysis, p = P u₁^e₁ u₂^e₂ ….

    P is a parameter as the base values of the page's units make it dimensionless, and u is a unit's value over its base value.
    Many parameters depend on one unit; the chain rule keeps that, where boxes of the parameters themselves would take each for
    its own.
    """

    def __init__(self, model: Model, contact: bool, units: Mapping[str, Unit], law: str = "friction_at_rest") -> None:
        super().__init__(model, contact, law)
        self.units = units
        #: Parameters of the balance that depend on each unit; a unit on which none does matters to the motion alone.
        self.scaling = {unit: [name for name in self.balanced if name in one.powers] for unit, one in units.items()}
        self.matter = [unit for unit, names in self.scaling.items() if names]
        #: p/P as arguments of their own, by parameter.
        self.factors = {name: f"{name}/P" for name in self.parameters if any(name in unit.powers for unit in units.values())}
        self.parameters += units
        #: Those that are asked for: the law at rest depends on nothing of the motion.
        self.needed = [name for name in self.factors if law != "friction_at_rest" or name in self.balanced]
        self.codes += [*units, *(self.factors[name] for name in self.needed)]

    def scaled(self, values: Values, xp: Any = np, names: Iterable[str] | None = None) -> dict[str, Any]:
        """P and u by name, of any number type, with the page's parameters p in place of P, all or some, and beside them p/P."""
        found = dict(values)
        for name in self.factors if names is None else names:
            code = self.factors[name]
            powers = ((values[key], unit.powers[name]) for key, unit in self.units.items() if name in unit.powers)
            found[code] = reduce(mul, (_power(value, power, xp) for value, power in powers))
            found[name] = _times(values[name], found[code])
        return found

    def prepared(self, bounds: Intervals) -> Intervals:
        """Arguments of the generated functions, units and p/P."""
        found = self.scaled(dict(zip(self.parameters, bounds, strict=True)), XP, self.needed)
        shape = bounds.shape[1:]
        known = super().prepared(stacked([found[name] for name in self.parameters], shape))
        return Intervals(np.concatenate([known.ends, *(found[self.factors[name]].ends[:, None] for name in self.needed)], axis=1))

    def arguments_of(self, values: Values, xp: Any) -> dict[str, Any]:
        """Arguments by name, of any number type."""
        return super().arguments_of(self.scaled(values, xp, self.needed), xp)

    def by_parameters(
        self, names: Sequence[str], q: Sequence[Any], directions: Sequence[Any], values: Values, xp: Any = XP
    ) -> list[list[Any]]:
        """Derivatives by P, and by u: Σ e p/u ∂/∂p over the parameters that depend on it."""
        needed = sorted({part for name in names for part in self.scaling.get(name, [name])})
        rows = super().by_parameters(needed, q, directions, values, xp)
        return [[self._slope(name, dict(zip(needed, row, strict=True)), values) for name in names] for row in rows]

    def _slope(self, name: str, slopes: Mapping[str, Any], values: Values) -> Any:
        if name in self.units:
            powers = self.units[name].powers
            return sum(slopes[key] * values[key] * powers[key] for key in self.scaling[name]) / values[name]
        return slopes[name] * values[self.factors[name]] if name in self.factors else slopes[name]


def _power(value: Any, power: float, xp: Any) -> Any:
    whole = int(power)
    if whole == power:
        return value**whole if whole > 0 else 1 / value**-whole
    return xp.exp(power * xp.log(value))


def _times(value: Any, factor: Any) -> Any:
    """Their product; what is 0, and an end that is, stays so."""
    if isinstance(value, int) and not value:
        return value
    product = value * factor
    return Intervals(np.where(value.ends == 0, 0.0, product.ends)) if isinstance(value, Intervals) else product
