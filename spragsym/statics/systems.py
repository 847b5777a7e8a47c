"""Base classes of systems F(x, p) = 0 whose roots are states of a model.

A system says which residuals vanish at a state. This module evaluates them over many boxes at once,
from recorded tapes, and puts together the plan by which compiled code excludes and contracts boxes.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any, ClassVar, TypeAlias
from weakref import WeakKeyDictionary

import numpy as np

from ..numerics import contractors, jets, plans
from ..numerics.arithmetic import Matrix, Number
from ..numerics.boxes import EquationSystem
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, Shape, stacked
from ..numerics.plans import Border, Exclusions, LineTapes, Plan, Side
from ..numerics.tape import NotRecorded, Tape, Tapes
from .forces import Evaluation, Values
from .namespaces import FREE, XP
from .options import SearchOptions

if TYPE_CHECKING:
    from .balance import Balance

#: A function to record on a tape: from unknowns, further arguments and prepared parameters, all
#: over boxes, to a list of entries.
Rows: TypeAlias = Callable[..., Sequence[Any]]
#: Such a function behind the key of its tape.
Entries: TypeAlias = tuple[Hashable, Rows]
#: Forces, or their Jacobian by rows, from an evaluation.
OfState: TypeAlias = Callable[[Evaluation], Sequence[Any]]
#: Lengths of springs so large that terms with 1/length vanish from the stiffness.
ENDLESS = Intervals.between([1e290], [1e308])
#: A linearization over boxes: values at points, slopes over the boxes, the points, and bounds on
#: the distances of the boxes' ends from them.
Linear: TypeAlias = tuple[Intervals, Intervals, FloatArray, FloatArray]


class StateSystem(EquationSystem):
    """A system F(x, p) = 0 whose roots are states of a model.

    :meth:`conditions` gives F, for any number type: floats, intervals over boxes, balls, or jets.
    """

    balance: Balance
    n: int  #: number of unknowns
    #: Highest derivative by the unknowns that the residuals themselves contain.
    order = 0

    @property
    def options(self) -> SearchOptions:
        """Options of the search, those of the balance."""
        return self.balance.search_options

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation of the generated functions at unknowns ``q``, in the number type of
        ``values``.
        """
        raise NotImplementedError

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Residuals F at a state, in the number type of the unknowns."""
        raise NotImplementedError

    def prepared(self, bounds: Intervals) -> Intervals:
        """Arguments of the generated functions over boxes of parameters, shape (arguments, N)."""
        return self.balance.prepared(bounds)

    def prepared_at(self, given: FloatArray) -> Intervals:
        """Arguments of the generated functions at points of the parameters."""
        return self.prepared(Intervals.point(given))

    def state(
        self,
        unknowns: Intervals | Sequence[Number],
        parameters: Intervals,
        sides: Sequence[int] | None = None,
    ) -> Evaluation:
        """The evaluation over boxes; the unknowns are intervals or jets of intervals."""
        at = self.at(list(unknowns), self.balance.arguments(parameters), parameters.shape[1:])
        at.sides = sides
        return at

    def equations(self, unknowns: Sequence[Any], parameters: Intervals) -> Sequence[Any]:
        """Residuals F over boxes."""
        return self.conditions(self.state(unknowns, parameters), unknowns)

    def identity(self) -> Hashable:
        """Key by which systems of one class and model share their tapes; None to share none."""
        return None

    #: Tapes by the generated module of a model, then by class and identity of the system.
    _tapes: ClassVar[WeakKeyDictionary[ModuleType, dict[Hashable, Tapes]]] = WeakKeyDictionary()

    @cached_property
    def tapes(self) -> Tapes:
        """Recorded functions of the system."""
        identity, algebra = self.identity(), self.balance.model.algebra
        if identity is None or not isinstance(algebra, ModuleType):
            return Tapes()
        of_model = self._tapes.setdefault(algebra, {})
        return of_model.setdefault((type(self), identity), Tapes())

    def taped(self, key: Hashable, rows: Rows, *given: Intervals) -> Intervals:
        """Entries over boxes by their tape. ``given`` are the unknowns, further arguments and,
        last, the prepared parameters.
        """
        parameters = given[-1]
        return self.tapes.evaluated(key, rows, *given, vanishing=self.balance.vanishing(parameters))

    def of_state(self, key: Hashable, rows: Rows) -> Entries:
        """Entries whose rows take unknowns and parameters, from entries whose rows take an
        evaluation.
        """

        def from_unknowns(unknowns: Sequence[Number], *rest: Any) -> Sequence[Any]:
            *others, parameters = rest
            return rows(self.state(unknowns, parameters), *others)

        return key, from_unknowns

    def value_entries(self, sides: Sequence[int]) -> Entries:
        """Entries of F, with the torsion angles on the given sides of the rays where they jump."""

        def rows(unknowns: Sequence[Number], parameters: Intervals) -> Sequence[Any]:
            given = jets.variables(list(unknowns), self.order) if self.order else list(unknowns)
            found = self.conditions(self.state(given, parameters, sides), given)
            return [jets.constant(value) for value in found]

        return ("values", *sides), rows

    def values(self, unknowns: Intervals, parameters: Intervals, sides: Sequence[int]) -> Intervals:
        """Residuals F over boxes, with the torsion angles on the given sides of their jumps."""
        return self.taped(*self.value_entries(sides), unknowns, parameters)

    def slope_entries(self) -> Entries:
        """Entries of the Jacobian ∂F/∂x, row by row."""

        def rows(unknowns: Sequence[Number], parameters: Intervals) -> Sequence[Any]:
            return [entry for row in self.slopes_over(unknowns, parameters) for entry in row]

        return "slopes", rows

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Enclosure of the Jacobian ∂F/∂x, shape (equations, n, N)."""
        entries = self.taped(*self.slope_entries(), unknowns, parameters)
        n = unknowns.shape[0]
        shape = 2, entries.shape[0] // n, n, *unknowns.shape[1:]
        return Intervals(entries.ends.reshape(shape))

    def slopes_over(self, unknowns: Any, parameters: Intervals) -> Matrix:
        """The Jacobian ∂F/∂x over boxes, as rows, by automatic differentiation with jets."""
        given = jets.variables(list(unknowns), self.order + 1)
        rows = self.equations(given, parameters)
        return [jets.gradient(row, unknowns.shape[0]) for row in rows]

    def directed_entries(self) -> Entries:
        """Entries of the linearization of the forces in the coordinates, with frozen spring
        directions.

        The rows give the forces at points ``near``, then their slopes over the boxes.
        """
        balance = self.balance

        def rows(
            unknowns: Sequence[Number], near: Sequence[Number], parameters: Intervals
        ) -> Sequence[Any]:
            at = self.state(unknowns, parameters, balance.any_side)
            return linear_rows(at, list(near), Evaluation.forces, lambda at: at.slopes)

        return "directed", rows

    def directed(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Boxes of coordinates that hold the same roots, by one interval Newton step on the forces.

        Directions and lengths of springs are frozen at their enclosures over the boxes, so that the
        forces are nearly linear in the coordinates.
        """
        n = self.balance.n
        near = unknowns[:n].middle
        entries = self.taped(*self.directed_entries(), unknowns, Intervals.point(near), parameters)
        lines = as_linear(entries, unknowns.ends[:, :n], near)
        return np.fmin(contractors.newton(*lines).ends, unknowns.ends[:, :n])

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Enclosure of F over boxes; a torsion angle that jumps in a box has any value there."""
        return self.values(unknowns, parameters, self.balance.any_side)

    def excluded(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes without a root.

        Where a torsion angle jumps in a box, F must have no zero on either side of the jump.
        """
        boxes = Boxes(self, unknowns, parameters)
        out = self.without_state(boxes)
        if self.balance.torsions:
            turnings = boxes.taped(*self.turning_entries())
            rows = np.flatnonzero(~out & np.logical_or.reduce(np.isnan(turnings.ends[0])))
            for sides in self.every_side if rows.size else ():
                may_vanish = np.logical_and.reduce(
                    self.values(unknowns[:, rows], parameters[:, rows], sides).holds_zero()
                )
                rows = rows[~may_vanish]
            out[rows] = True
        return out

    def turning_entries(self) -> Entries:
        """Entries of the angles of torsion springs; NaN in boxes where they jump."""
        return "turnings", lambda at: at.directions[3 * self.balance.springs :]

    @property
    def every_side(self) -> Iterable[tuple[int, ...]]:
        """All combinations of sides of the rays where torsion angles jump."""
        return itertools.product((1, -1), repeat=len(self.balance.torsions))

    def without_state(self, boxes: Boxes) -> BoolArray:
        """Boxes without a state, by geometry: those beyond a contact's border."""
        return self.balance.sides(list(boxes.taped(*GAPS)))[1]

    # ----------------------------------------------------------------------------------------------
    # plans

    #: Whether plans contract boxes by :meth:`directed`.
    contracts = False
    #: Whether :meth:`lines_at` asks for a singular stiffness too; plans are cached by it.
    singular = False

    def plan(self, parameters: Intervals) -> Plan | None:
        """Plan by which compiled code examines boxes; None if it can't be compiled or recorded."""
        if plans.compiled_for(self.n) is None:
            return None
        # Parameters of nodes without points are NaN.
        vanishing = self.balance.vanishing(Intervals(np.nan_to_num(parameters.ends)))
        key = *vanishing, *self.borders(), self.singular
        if key not in self.tapes.plans:
            try:
                self.tapes.plans[key] = self._planned(vanishing)
            except NotRecorded:
                self.tapes.plans[key] = None
        return self.tapes.plans[key]

    def _planned(self, vanishing: Sequence[bool]) -> Plan | None:
        """The plan for parameters of which those marked ``vanishing`` are 0."""
        n, coordinates, parameters = self.n, self.balance.n, len(vanishing)

        def made(entries: Entries, *between: int, of_state: bool = True) -> Tape:
            entries = self.of_state(*entries) if of_state else entries
            return self.tapes.tape(*entries, (n, *between, parameters), vanishing)

        values = made(self.value_entries(self.balance.any_side), of_state=False)
        slopes = made(self.slope_entries(), of_state=False)
        directed = None
        if self.contracts:
            directed = made(self.directed_entries(), coordinates, of_state=False)
        tapes = values, slopes, directed
        return plans.planned(n, coordinates, parameters, tapes, self.exclusions(made))

    def exclusions(self, made: Callable[..., Tape]) -> Exclusions:
        """The tests of :meth:`excluded` as tapes; ``made`` records the tape of entries."""
        balance, borders, lines = self.balance, self.borders(), self.lines_at(made)
        sides = self.every_side if balance.torsions else ()
        return Exclusions(
            made(GAPS) if borders else None,
            borders,
            made(ANCHORS) if lines else None,
            lines,
            self.arcs,
            made(self.turning_entries()) if balance.torsions else None,
            [made(self.value_entries(side), of_state=False) for side in sides],
        )

    #: Arcs that cover the unit circle: −low and high of cosine and sine, shape (2, 2, arcs); none
    #: where :meth:`lines_at` needs none.
    arcs = np.zeros((2, 2, 0))

    def borders(self) -> list[Border]:
        """For each contact that opens, the side of its border to search and the slack beyond it."""
        open_ = Side.OPEN_AND_OFF if self.balance.apart else Side.OPEN
        kinds = [Side.TOUCHING if closed else open_ for closed in self.balance.closed]
        return list(zip(kinds, self.balance.slacks, strict=True))

    def lines_at(self, made: Callable[..., Tape]) -> list[LineTapes]:
        """Tapes for boxes near the anchors of springs, one of each spring; none by default."""
        return []


class WithoutTapes(StateSystem):
    """A system that excludes boxes without tapes: its plan has no exclusions."""

    def exclusions(self, made: Callable[..., Tape]) -> Exclusions:
        """No exclusions."""
        return Exclusions()

    def excluded_without_plan(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """All boxes that are excluded, since no plan excludes any."""
        return self.excluded(unknowns, parameters)


#: Entries of the gaps of contacts that open, and of the vectors to the anchors of springs.
GAPS: Entries = "gap", lambda at: at.gaps() or [0]
ANCHORS: Entries = "anchors", lambda at: [part for line in at.geometry for part in line[:2]]


@dataclass
class Boxes:
    """Boxes of a system's unknowns, shape (n, N), and the prepared parameters of each."""

    system: StateSystem
    unknowns: Intervals
    parameters: Intervals

    @property
    def shape(self) -> Shape:
        """(N,)."""
        return self.unknowns.shape[1:]

    @cached_property
    def state(self) -> Evaluation:
        """The evaluation over all the boxes."""
        return self.system.state(self.unknowns, self.parameters)

    @cached_property
    def anchors(self) -> list[tuple[Intervals, Intervals]]:
        """The vector from the mass to the anchor of each spring."""
        parts = list(self.taped(*ANCHORS))
        return list(zip(parts[::2], parts[1::2], strict=True))

    def some(self, rows: IntArray) -> Boxes:
        """The boxes of the given numbers."""
        return Boxes(self.system, self.unknowns[:, rows], self.parameters[:, rows])

    def taped(self, key: Hashable, rows: Rows, *more: Intervals) -> Intervals:
        """Entries from an evaluation over the boxes, with more arguments for each box."""
        entries = self.system.of_state(key, rows)
        return self.system.taped(*entries, self.unknowns, *more, self.parameters)


def at_anchors(
    boxes: Boxes, among: BoolArray, excludes: Callable[[Boxes, int], BoolArray]
) -> BoolArray:
    """Boxes that a test ``excludes`` near the anchor of a spring, among those marked in ``among``.

    A box is near if its distance from the anchor is at most its size. Farther away the direction of
    the spring is known well enough for the equations themselves.
    """
    out = np.zeros(boxes.shape, dtype=bool)
    for spring, (dx, dy) in enumerate(boxes.anchors):
        near = np.hypot(dx.mignitude, dy.mignitude) <= dx.width + dy.width
        rows = np.flatnonzero(among & ~out & near)
        if rows.size:
            out[rows] = excludes(boxes.some(rows), spring)
    return out


def as_linear(found: Intervals, ends: FloatArray, near: FloatArray) -> Linear:
    """The linearization that contractors take, from its evaluated entries.

    ``found`` are forces at points ``near`` and, behind them, slopes over the boxes ``ends``.
    """
    n, shape = near.shape[0], near.shape[1:]
    rows = found.shape[0] // (n + 1)
    slopes = Intervals(found.ends[:, rows:].reshape(2, rows, n, *shape))
    return found[:rows], slopes, near, contractors.distance(ends, near)


def linear(
    at: Evaluation, near: FloatArray, forces: OfState, slopes: OfState | None = None
) -> Linear:
    """The linearization of ``forces`` about points ``near``, over the boxes of an evaluation.

    Directions and lengths of springs are frozen at their enclosures over the boxes. Other arguments
    are those of :func:`linear_rows`.
    """
    found = linear_rows(at, list(Intervals.point(near)), forces, slopes)
    return as_linear(stacked(found, at.shape), at.box.ends, near)


def linear_rows(
    at: Evaluation, near: Sequence[Any], forces: OfState, slopes: OfState | None = None
) -> list[Any]:
    """Entries of :func:`linear`: forces at ``near``, then their slopes over the boxes, row by row.

    The slopes are those of the generated function ``slopes``, unless it is None or can't be used;
    then they come from jets.
    """
    fixed = at.directions
    if slopes is None or at.xp is FREE or at.balance.torsions:  # their forces contain a length
        moved = replace(at, q=jets.variables(at.q, 1), fixed=fixed)
        rows: Matrix = [jets.gradient(row, len(at.q)) for row in forces(moved)]
    else:
        # Directions change in proportion to 1/length. Endless lengths make these terms 0 to
        # rounding: the stiffness at frozen directions, sharper than by jets through the laws.
        lengths = range(2, 3 * at.balance.springs, 3)
        far = [ENDLESS if index in lengths else part for index, part in enumerate(fixed)]
        rows = slopes(replace(at, fixed=far))
    at_points = replace(at, q=near, fixed=fixed)
    return [*forces(at_points), *(entry for row in rows for entry in row)]
