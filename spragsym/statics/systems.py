"""Systems whose roots are states of a model: what is asked of many boxes goes by tape."""

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

#: Entries over boxes, from unknowns, whatever else, and parameters.
Rows: TypeAlias = Callable[..., Sequence[Any]]
#: Entries with the key of their tape among those of a system.
Entries: TypeAlias = tuple[Hashable, Rows]
#: Rows at a state, of forces or of slopes.
OfState: TypeAlias = Callable[[Evaluation], Sequence[Any]]
#: Lengths of which nothing is left in K.
ENDLESS = Intervals.between([1e290], [1e308])
Linear: TypeAlias = tuple[Intervals, Intervals, FloatArray, FloatArray]


class StateSystem(EquationSystem):
    """A system of which the roots are states of a model: what vanishes at a state, over boxes or
    with many digits.
    """

    balance: Balance
    n: int  #: how many unknowns there are
    #: How many derivatives the equations themselves are made of.
    order = 0

    @property
    def options(self) -> SearchOptions:
        """Options of the search for states, which are those of the balance."""
        return self.balance.search_options

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation at unknowns, of any number type as the arguments are."""
        raise NotImplementedError

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Residuals at a state, of the number type of the unknowns."""
        raise NotImplementedError

    def prepared(self, bounds: Intervals) -> Intervals:
        """Prepared parameters of the balance."""
        return self.balance.prepared(bounds)

    def prepared_at(self, given: FloatArray) -> Intervals:
        """Prepared parameters of points."""
        return self.prepared(Intervals.point(given))

    def state(
        self,
        unknowns: Intervals | Sequence[Number],
        parameters: Intervals,
        sides: Sequence[int] | None = None,
    ) -> Evaluation:
        """The evaluation over boxes, whose unknowns are intervals or jets of them."""
        at = self.at(list(unknowns), self.balance.arguments(parameters), parameters.shape[1:])
        at.sides = sides
        return at

    def equations(self, unknowns: Sequence[Any], parameters: Intervals) -> Sequence[Any]:
        """Residuals over boxes."""
        return self.conditions(self.state(unknowns, parameters), unknowns)

    def identity(self) -> Hashable:
        """Identity that tells the system from others of its class and model: tapes are those of all
        with the same, or its own without one.
        """
        return None

    #: Of every model's systems, as long as its functions are loaded.
    _tapes: ClassVar[WeakKeyDictionary[ModuleType, dict[Hashable, Tapes]]] = WeakKeyDictionary()

    @cached_property
    def tapes(self) -> Tapes:
        """Tapes of what is asked over boxes."""
        identity, algebra = self.identity(), self.balance.model.algebra
        if identity is None or not isinstance(algebra, ModuleType):
            return Tapes()
        of_model = self._tapes.setdefault(algebra, {})
        return of_model.setdefault((type(self), identity), Tapes())

    def taped(self, key: Hashable, rows: Rows, *given: Intervals) -> Intervals:
        """Rows over boxes, from unknowns and whatever else, and parameters as the last."""
        parameters = given[-1]
        return self.tapes.evaluated(key, rows, *given, vanishing=self.balance.vanishing(parameters))

    def of_state(self, key: Hashable, rows: Rows) -> Entries:
        """Entries that follow from a state, and perhaps from more for each box."""

        def noted(unknowns: Sequence[Number], *rest: Any) -> Sequence[Any]:
            *others, parameters = rest
            return rows(self.state(unknowns, parameters), *others)

        return key, noted

    def value_entries(self, sides: Sequence[int]) -> Entries:
        """Residuals on the given sides of the rays where torsion angles jump."""

        def rows(unknowns: Sequence[Number], parameters: Intervals) -> Sequence[Any]:
            given = jets.variables(list(unknowns), self.order) if self.order else list(unknowns)
            found = self.conditions(self.state(given, parameters, sides), given)
            return [jets.constant(value) for value in found]

        return ("values", *sides), rows

    def values(self, unknowns: Intervals, parameters: Intervals, sides: Sequence[int]) -> Intervals:
        """Residuals over boxes, on the given sides."""
        return self.taped(*self.value_entries(sides), unknowns, parameters)

    def slope_entries(self) -> Entries:
        """∂F/∂x, row by row."""

        def rows(unknowns: Sequence[Number], parameters: Intervals) -> Sequence[Any]:
            return [entry for row in self.slopes_over(unknowns, parameters) for entry in row]

        return "slopes", rows

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Enclosure of ∂F/∂x, shape (equations, n, N)."""
        entries = self.taped(*self.slope_entries(), unknowns, parameters)
        n = unknowns.shape[0]
        shape = 2, entries.shape[0] // n, n, *unknowns.shape[1:]
        return Intervals(entries.ends.reshape(shape))

    def slopes_over(self, unknowns: Any, parameters: Intervals) -> Matrix:
        """∂F/∂x over boxes, by rows: by jets, if nothing sharper is known."""
        given = jets.variables(list(unknowns), self.order + 1)
        rows = self.equations(given, parameters)
        return [jets.gradient(row, unknowns.shape[0]) for row in rows]

    def directed_entries(self) -> Entries:
        """Forces of springs with the directions over the boxes, near them and by coordinates."""
        balance = self.balance

        def rows(
            unknowns: Sequence[Number], near: Sequence[Number], parameters: Intervals
        ) -> Sequence[Any]:
            at = self.state(unknowns, parameters, balance.anywhere)
            return linear_rows(at, list(near), Evaluation.forces, lambda at: at.slopes)

        return "directed", rows

    def directed(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Boxes of coordinates that balance the forces of springs with the directions over the
        boxes.
        """
        n = self.balance.n
        near = unknowns[:n].middle
        found = self.taped(*self.directed_entries(), unknowns, Intervals.point(near), parameters)
        given = as_linear(found, unknowns.ends[:, :n], near)
        return np.fmin(contractors.newton(*given).ends, unknowns.ends[:, :n])

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Residuals on any side: torsion angles that jump in a box have any value there."""
        return self.values(unknowns, parameters, self.balance.anywhere)

    def excluded(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes where no state is; where a torsion angle jumps in a box, what vanishes is asked on
        each side of the jump.
        """
        boxes = Boxes(self, unknowns, parameters)
        out = self.nothing_at(boxes)
        if self.balance.torsions:
            turnings = boxes.taped(*self.turning_entries())
            rows = np.flatnonzero(~out & np.logical_or.reduce(np.isnan(turnings.ends[0])))
            for sides in self.every_side if rows.size else ():
                still = np.logical_and.reduce(
                    self.values(unknowns[:, rows], parameters[:, rows], sides).holds_zero()
                )
                rows = rows[~still]
            out[rows] = True
        return out

    def turning_entries(self) -> Entries:
        """Angles of torsion springs."""
        return "turnings", lambda at: at.directions[3 * self.balance.springs :]

    @property
    def every_side(self) -> Iterable[tuple[int, ...]]:
        """Sides of the rays where torsion angles jump."""
        return itertools.product((1, -1), repeat=len(self.balance.torsions))

    def nothing_at(self, boxes: Boxes) -> BoolArray:
        """Boxes beyond the contact's border."""
        return self.balance.sides(list(boxes.taped(*GAPS)))[1]

    # ----------------------------------------------------------------------------------------------
    # plans

    #: Whether boxes are contracted by :meth:`directed`.
    contracts = False
    #: What of :meth:`lines_at` depends on the system beside its identity.
    singular = False

    def plan(self, parameters: Intervals) -> Plan | None:
        """Tapes of all that is asked of boxes."""
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
        n, some, parameters = self.n, self.balance.n, len(vanishing)

        def made(entries: Entries, *between: int, of_state: bool = True) -> Tape:
            entries = self.of_state(*entries) if of_state else entries
            return self.tapes.tape(*entries, (n, *between, parameters), vanishing)

        return plans.planned(
            n,
            some,
            parameters,
            (
                made(self.value_entries(self.balance.anywhere), of_state=False),
                made(self.slope_entries(), of_state=False),
                made(self.directed_entries(), some, of_state=False) if self.contracts else None,
            ),
            self.exclusions(made),
        )

    def exclusions(self, made: Callable[..., Tape]) -> Exclusions:
        """Exclusions of :meth:`excluded`, by tapes that are ``made`` of entries."""
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

    #: Ends of cosine and sine of directions on arcs, of which :meth:`lines_at` may ask.
    arcs = np.zeros((2, 2, 0))

    def borders(self) -> list[Border]:
        """Borders of the contacts that open."""
        open_ = Side.OPEN_AND_OFF if self.balance.apart else Side.OPEN
        kinds = [Side.TOUCHING if closed else open_ for closed in self.balance.closed]
        return list(zip(kinds, self.balance.rooms, strict=True))

    def lines_at(self, made: Callable[..., Tape]) -> list[LineTapes]:
        """Tapes of springs, for boxes at their anchors."""
        return []


class WithoutTapes(StateSystem):
    """A system of which no tape excludes boxes."""

    def exclusions(self, made: Callable[..., Tape]) -> Exclusions:
        """None."""
        return Exclusions()

    def excluded_without_plan(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes that are excluded for any reason."""
        return self.excluded(unknowns, parameters)


#: Gaps of the contacts that open, and vectors to the anchors of springs.
GAPS: Entries = "gap", lambda at: at.gaps() or [0]
ANCHORS: Entries = "anchors", lambda at: [part for line in at.geometry for part in line[:2]]


@dataclass
class Boxes:
    """Boxes of a system's unknowns, shape (n, N), with the prepared parameters of each."""

    system: StateSystem
    unknowns: Intervals
    parameters: Intervals

    @property
    def shape(self) -> Shape:
        """(N,)."""
        return self.unknowns.shape[1:]

    @cached_property
    def state(self) -> Evaluation:
        """The evaluation over all of them."""
        return self.system.state(self.unknowns, self.parameters)

    @cached_property
    def anchors(self) -> list[tuple[Intervals, Intervals]]:
        """The vectors from the mass to the anchors of all springs."""
        parts = list(self.taped(*ANCHORS))
        return list(zip(parts[::2], parts[1::2], strict=True))

    def some(self, rows: IntArray) -> Boxes:
        """Some of the boxes."""
        return Boxes(self.system, self.unknowns[:, rows], self.parameters[:, rows])

    def taped(self, key: Hashable, rows: Rows, *more: Intervals) -> Intervals:
        """Entries that follow from a state, and perhaps from more intervals for each box."""
        entries = self.system.of_state(key, rows)
        return self.system.taped(*entries, self.unknowns, *more, self.parameters)


def at_anchors(
    boxes: Boxes, among: BoolArray, excludes: Callable[[Boxes, int], BoolArray]
) -> BoolArray:
    """Boxes of which something is told of all directions of a spring, among those that are no
    farther from its anchor than their size.

    Farther from there the direction is known so well that the equations themselves tell.
    """
    out = np.zeros(boxes.shape, dtype=bool)
    for spring, (dx, dy) in enumerate(boxes.anchors):
        near = np.hypot(dx.mignitude, dy.mignitude) <= dx.width + dy.width
        rows = np.flatnonzero(among & ~out & near)
        if rows.size:
            out[rows] = excludes(boxes.some(rows), spring)
    return out


def as_linear(found: Intervals, ends: FloatArray, near: FloatArray) -> Linear:
    """Entries as contractors take them: forces at points near, slopes over the boxes, and with them
    the points and distances.
    """
    n, shape = near.shape[0], near.shape[1:]
    rows = found.shape[0] // (n + 1)
    slopes = Intervals(found.ends[:, rows:].reshape(2, rows, n, *shape))
    return found[:rows], slopes, near, contractors.distance(ends, near)


def linear(
    at: Evaluation, near: FloatArray, forces: OfState, slopes: OfState | None = None
) -> Linear:
    """Linear system that contractors take: forces at points of the boxes, slopes over the boxes,
    the points and distances from them.

    Directions and lengths are those of the boxes. Arguments as of :func:`linear_rows`.
    """
    found = linear_rows(at, list(Intervals.point(near)), forces, slopes)
    return as_linear(stacked(found, at.shape), at.box.ends, near)


def linear_rows(
    at: Evaluation, near: Sequence[Any], forces: OfState, slopes: OfState | None = None
) -> list[Any]:
    """Entries of :func:`linear`: forces, and then their slopes, row by row; by the generated
    ``slopes``, where there are some, no length counts and no wave is a free unknown.
    """
    fixed = at.directions
    if slopes is None or at.xp is FREE or at.balance.torsions:  # their forces contain a length
        moved = replace(at, q=jets.variables(at.q, 1), fixed=fixed)
        rows: Matrix = [jets.gradient(row, len(at.q)) for row in forces(moved)]
    else:
        # What directions change by goes with one over the length, and of these lengths that is 0
        # to rounding. So no law is asked for a derivative that its stiffness has in a sharper form.
        lengths = range(2, 3 * at.balance.springs, 3)
        far = [ENDLESS if index in lengths else part for index, part in enumerate(fixed)]
        rows = slopes(replace(at, fixed=far))
    there = replace(at, q=near, fixed=fixed)
    return [*forces(there), *(entry for row in rows for entry in row)]
