"""Search for bifurcation points of equilibria along one or two parameters, of all kinds alike.

The module also finds the parameter values at which a state runs to infinity.

Ends of ranges. At an end of a range all states may be degenerate, or a law may have no value; then
the end stays undecided. Example: without the inclined spring, σ = 0, the two directions of the
article's model are decoupled, and that across the belt is undamped. All states at this end are on
the border of stability, but none is an onset. A box that reaches down to such an end at 0 is never
decided. In the logarithm of a positive parameter all of its orders of magnitude are alike: each is
decided, down to :attr:`Logarithmic.least`.

Infinity. With q = u/w and |u| = 1, the rows of the balance are G(u, w, λ) up to powers of w, see
:mod:`spragsym.statics.namespaces`. At a regular root of G = 0, |u|² = 1 with w = 0, in the unknowns
u and λ, one curve of states begins, λ = λ* + λ' w + …. For w → 0 its state runs to infinity along
u; the sign of λ' says on which side of λ* it exists.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.progress import doing
from ..core.remarks import At, Remark
from ..display import own_name
from ..models.model import label_of
from ..models.parameters import Ranges
from ..numerics import boxes, certified_roots, contractors
from ..numerics.arithmetic import Number, determinant
from ..numerics.certified_roots import Roots, distinct, in_order, stepped
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    Shape,
    quiet,
    scale_of,
    spans_of,
    stacked,
    width_of,
)
from ..numerics.jets import Jet, constant, gradient, order_of, variables
from ..results.points import Points
from ..statics import stability
from ..statics.balance import NEGLIGIBLE, Balance
from ..statics.forces import SEARCHED_ANGLE, Evaluation, Values, as_intervals
from ..statics.namespaces import XP, NoChart, Scaled, ScaledFunctions
from ..statics.precise_balance import on_contact_side, reduced_by_turns
from ..statics.regions import region
from ..statics.search import kinds_of, of_ranges, of_region, summed
from ..statics.systems import WithoutTapes
from .defining_systems import Augmented, Condition, Family, OfFamily, refined_roots, slope
from .lines_of_states import is_singular, lines_of_states


@dataclass(frozen=True)
class Found:
    """Result of a search: roots, the region of each point, and whether it holds all equilibria."""

    roots: Roots
    region: FloatArray
    whole: BoolArray
    #: Reason why boxes are undecided, if it is known and the same for all.
    why: str | None = None


def isolated(family: Family, condition: Condition, kind: str) -> Points:
    """Points of one condition along one parameter, or in the plane of two."""
    with doing("points of the kind {} over {}", kind, " and ".join(family.vary)):
        found = search(family, condition)
    return arranged(family, found, kind)


def search(family: Family, condition: Condition, budget: int | None = None) -> Found:
    """All points at which a condition holds; ``budget`` is the number of boxes for one point of the
    fixed parameters.
    """
    balance = family.balance
    alone = family.given.shape[1] == len(family.vary) == 1  # one point, along one parameter
    if condition.singular and family.is_affine():
        return _of_affine_forces(family)
    if condition.touching is None:
        searched, whole = _region(family, balance)
    else:
        # States on the border, where the contact's force is 0, are also states of the open contact.
        either = (balance, balance.across(condition.touching))
        for in_pieces, each in itertools.product((False, True), either):  # pieces take long
            searched, whole = _region(family, each, in_pieces=in_pieces)
            if whole.all():
                break
    system, fixed = Augmented(family, condition), family.begin
    if budget is None and system.options.budget is None:
        budget = _usual_budget(system)
    from_least = alone and begins_at_zero(system, searched)
    wide = _between(searched, Logarithmic.low, searched[1, -1, 0]) if from_least else searched
    roots = certified_roots.search(system, wide, fixed, fixed, budget=budget)
    if from_least:
        roots = _joined(_by_logarithm(system, searched), roots)
        searched = _between(searched, Logarithmic.least, searched[1, -1, 0])
    if alone:
        roots = refined_roots(system, searched, roots)
    roots = reduced_by_turns(balance.periodic, on_contact_side(system, fixed, roots))
    if alone:
        roots = roots.select(undecided=~shared(system, roots.undecided))
    return Found(roots, searched, whole)


def _usual_budget(system: OfFamily) -> int:
    """Boxes for about a second of work: with more unknowns a box costs more."""
    return 200_000 if system.n <= 3 else 1_000_000 if system.n == 4 else 500_000


def all_of(parts: Sequence[Found]) -> Found:
    """The results of several searches along the same parameters, as one."""
    roots, *others = (one.roots for one in parts)
    region = np.minimum.reduce([one.region for one in parts])
    whole = np.logical_and.reduce([one.whole for one in parts])
    return Found(roots.concatenated(*others), region, whole, parts[0].why)


def nothing(family: Family) -> Found:
    """The result of a search that is known to have no points."""
    return Found(Roots.none(family.balance.n + len(family.vary)), *_region(family, family.balance))


def _region(
    family: Family, balance: Balance, *, in_pieces: bool = True
) -> tuple[FloatArray, BoolArray]:
    """The region of coordinates and varying parameters, and whether it holds all equilibria."""
    searched, whole = region(balance, family.over, family.requested, in_pieces=in_pieces)
    return with_sides(searched, family.spans), whole


def with_sides(region: FloatArray, spans: FloatArray) -> FloatArray:
    """A region of coordinates, extended by the ranges ``spans`` of varying parameters."""
    sides = np.stack([-spans[:, 0], spans[:, 1]])[:, :, None]
    return np.concatenate(
        [region, np.broadcast_to(sides, (*sides.shape[:2], region.shape[2]))], axis=1
    )


def _between(region: FloatArray, low: float, high: float) -> FloatArray:
    """The region with another range of its one varying parameter."""
    return with_sides(region[:, :-1], np.array([[low, high]]))


def _of_affine_forces(family: Family) -> Found:
    """The result for affine forces: no two states meet, so that nothing is found.

    Parameters at which states may form a line remain undecided.
    """
    n, count = family.balance.n, family.given.shape[1]
    values, point = lines_of_states(family)
    roots, whole = Roots.none(n + len(family.vary)), np.ones(count, dtype=bool)
    if not point.size:
        return Found(roots, with_sides(np.full((2, n, count), np.inf), family.spans), whole)
    searched, whole = _region(family, family.balance)
    near = np.broadcast_to(searched, (*searched.shape[:2], count))[:, :n, point]
    left = roots.with_undecided(np.concatenate([near, values], axis=1), point)
    where = "where det K is 0 in every state: equilibria there form lines, or there are none"
    return Found(left, searched, whole, where)


def matrices(family: Family, z: FloatArray, damping: bool = True) -> tuple[FloatArray, ...]:
    """M, C + G and K at coordinates and varying parameters z, shape (n + number, N); each of shape
    (N, n, n). Without ``damping``, G replaces C + G.
    """
    n = family.balance.n
    return stability.linearization(family.balance, z[:n], family.at(z[n:]), damping)


def arranged(
    family: Family,
    found: Found,
    kind: str | NDArray[np.str_],
    more: Mapping[str, FloatArray] | None = None,
    remarks: tuple[str, ...] = (),
) -> Points:
    """The points of a search as a result, sorted by the varying parameters.

    ``kind`` is one for all points or one for each, ``more`` are further columns.
    """
    balance, vary = family.balance, family.vary
    n, middle, undecided = balance.n, found.roots.middle, found.roots.undecided
    order = in_order(np.concatenate([middle[n:], middle[:n]]), found.roots.error, found.roots.point)
    more = which(balance, order.size) | dict(more or {})
    values = family.named(middle[:, order]) | selected_rows(more, order)
    box = spans_of(found.region[:, :, 0])
    open_boxes, kinds = listed(family, undecided, found.why)
    remarks += (*kinds, *of_region(balance, found.region[:, :n], found.whole))
    remarks += of_ranges(family.endless, vary, box[n:])
    return Points(
        family.p,
        vary,
        np.broadcast_to(kind, order.shape)[order],
        found.roots.error[order],
        box,
        bool(found.whole.all()),
        family.endless,
        open_boxes,
        remarks,
        values,
    )


def which(balance: Balance, size: int) -> dict[str, Any]:
    """Columns ``touching`` and ``at_border``, for a model with several combinations of contacts."""
    if not balance.model.has_regimes:
        return {}
    touching, at_border = (own_name(balance.model, name) for name in ("touching", "at_border"))
    label = ", ".join(label_of(balance.model.contacts[k]) for k in balance.beyond)
    return {touching: np.full(size, balance.touching), at_border: np.full(size, label)}


def together(parts: Sequence[Points]) -> Points:
    """Points of several combinations of contacts as one result, sorted by the parameters that
    vary.
    """
    first, *others = parts
    if not others:
        return first
    names = (*first.vary, *first.parameters.model.coordinates)
    values = {
        name: np.concatenate([part._values[name] for part in parts]) for name in first._values
    }
    error = np.concatenate([part.error for part in parts])
    order = in_order(
        np.array([values[name] for name in names]), error, np.zeros(error.size, dtype=int)
    )
    region = np.stack([part.region for part in parts])
    return replace(
        first,
        kind=np.concatenate([part.kind for part in parts])[order],
        error=error[order],
        region=np.stack([region[:, :, 0].min(axis=0), region[:, :, 1].max(axis=0)], axis=-1),
        whole=all(part.whole for part in parts),
        undecided=np.concatenate([part.undecided for part in parts]),
        remarks=tuple(dict.fromkeys(remark for part in parts for remark in part.remarks)),
        _values={name: column[order] for name, column in values.items()},
    )


#: The kinds of points at states in which no contact touches, as a remark names them.
IN_WORDS = {
    "fold": "a fold",
    "pitchfork": "a pitchfork",
    "detected": "an onset, seen by floats and not proved,",
    "hopf": "an onset",
    "flutter": "an onset",
}
OTHERS_IN_LIFT_OFF = "whether there are others where no contact touches is not decided"


def in_lift_off(
    family: Family,
    between: Ranges | None,
    within: Ranges | None,
    search_of: Callable[[Family], Points],
) -> Iterator[Remark]:
    """Remarks on points along one parameter at states in which no contact touches: they are not
    listed.
    """
    (vary,) = family.vary
    for found in map(search_of, family.in_lift_off(between, within)):
        for kind, value in zip(found.kind.tolist(), found[vary].tolist(), strict=True):
            text = f"where no contact touches is {IN_WORDS[kind]} at {{}}, which is not listed"
            yield Remark(text, At(vary, (value,), ".6g"))
        if not (found.decided and found.whole):
            yield Remark(OTHERS_IN_LIFT_OFF)


def listed(
    family: Family, undecided: FloatArray, why: str | None = None
) -> tuple[FloatArray, tuple[str, ...]]:
    """Undecided boxes, shape (2, unknowns, boxes), as lower and upper ends, and one sentence for
    each reason. ``why`` is the reason if it is known for all.
    """
    balance, vary = family.balance, family.vary
    varied = dict(zip(vary, Intervals(undecided[:, balance.n :]), strict=True))
    given = np.repeat(family.given, undecided.shape[2], axis=1)
    kinds = summed(
        [why] * undecided.shape[2] if why else kinds_of(balance, given, undecided, varied)
    )
    if len(vary) == 1 and (why or undecided.shape[2] > 200):  # too many to list each
        undecided = merged(undecided)
    return np.moveaxis(spans_of(undecided), 1, 0), kinds


def merged(undecided: FloatArray) -> FloatArray:
    """Hulls of the undecided boxes whose ranges of the parameter meet: thousands may cover one line
    of equilibria.
    """
    if not undecided.shape[2]:
        return undecided
    undecided = undecided[:, :, np.argsort(-undecided[0, -1])]
    low, reached = -undecided[0, -1], np.maximum.accumulate(undecided[1, -1])
    return np.maximum.reduceat(
        undecided, np.flatnonzero(np.concatenate([[True], low[1:] > reached[:-1]])), axis=2
    )


def of_ends(
    family: Family, found: Found, reason: Callable[[float, FloatArray], str | None]
) -> tuple[str, ...]:
    """Remarks on undecided boxes at an end of the range of one parameter; ``reason`` gives the text
    for them, or None for no remark.
    """
    undecided, remarks = found.roots.undecided, []
    for end in (-float(found.region[0, -1, 0]), float(found.region[1, -1, 0])):
        here = undecided[:, :, (-undecided[0, -1] <= end) & (end <= undecided[1, -1])]
        why = reason(end, here) if here.shape[2] else None
        if why is not None:
            text = (
                f"{here.shape[2]} of {undecided.shape[2]} undecided boxes hold the end {{}} of the "
                f"range{why}"
            )
            remarks.append(Remark(text, At(family.vary[0], (end,), "g")))
    return tuple(remarks)


def shared(system: Augmented, left: FloatArray) -> BoolArray:
    """Undecided boxes whose only root is proved to be at an end of the range where all states are
    roots.

    ``system`` is along one parameter, with a condition of order 0; ``left`` are the boxes, shape
    (2, n + 1, N).
    """
    out = np.zeros(left.shape[2], dtype=bool)
    if system.condition.order or not out.size:
        return out
    wide = left + (0.25 * width_of(left) + 1e-11 * scale_of(left).max(axis=0))
    with quiet():
        for end in system.family.spans[0]:
            here = np.flatnonzero((-left[0, -1] <= end) & (end <= left[1, -1]))
            if not here.size:
                continue
            own, parameters = wide[:, :, here], _at_end(system, end, here.size)
            out[here] |= (
                _one_root(system, system.fixed(here.size), own)
                & _one_root(system.balance, parameters, own[:, :-1])
                & vanishes(system, end, own)
            )
    return out


def vanishes(system: Augmented, end: float, ends: FloatArray) -> BoolArray:
    """Boxes over whose coordinates the condition is identically 0 at the end of the parameter's
    range.
    """
    count, (vary,) = ends.shape[2], system.family.vary
    exactly = end == 0 and vary not in system.balance.angles  # products with it are exactly 0
    value = 0 if exactly else Intervals.point(np.full(count, end))
    try:
        with quiet():
            at = system.state([*Intervals(ends[:, :-1]), value], _at_end(system, end, count))
            values = stacked(system.condition.equations(at), (count,))
    except ZeroDivisionError:  # a law that has no value there
        return np.zeros(count, dtype=bool)
    return np.logical_and.reduce(values.magnitude <= NEGLIGIBLE)


def _at_end(system: Augmented, end: float, count: int) -> Intervals:
    """Prepared parameters with this value of the varying one, for ``count`` boxes."""
    return system.prepared_at(system.family.at(np.full((1, count), end)))


def _one_root(system: boxes.EquationSystem, parameters: Intervals, wide: FloatArray) -> BoolArray:
    """Boxes that are proved to hold exactly one root."""
    return contractors.inside(stepped(system, wide, parameters).ends, wide)


class Logarithmic(Augmented):
    """A defining system whose unknown is the logarithm of its parameter."""

    #: Least value that is searched.
    least = 2.0**-300
    #: The logarithm is searched up to this value.
    high = 2.0**-9
    #: The parameter itself is searched from this value on, so that the two searches overlap.
    low = 2.0**-10

    def parted(self, unknowns: Sequence[Any], *given: Any) -> tuple[list[Any], dict[str, Any]]:
        """Coordinates, and arguments with the parameter from its logarithm."""
        return super().parted([*unknowns[:-1], XP.exp(unknowns[-1])], *given)


def begins_at_zero(system: Augmented, region: FloatArray) -> bool:
    """Whether the parameter's range begins at 0, which it may not take, and the search can't decide
    there.
    """
    (vary,) = system.family.vary
    allowed = system.balance.model.Parameters.ranges[vary]
    if (
        allowed.low != 0
        or not allowed.open_low
        or region[0, -1, 0] != 0
        or region[1, -1, 0] <= Logarithmic.high
        or vary in system.balance.angles
    ):
        return False
    small = Intervals(_between(region, 0.0, Logarithmic.low))
    with quiet():
        condition = system.residuals(small, _at_end(system, Logarithmic.low, 1)).ends[:, -1]
    return bool(vanishes(system, 0.0, region)[0] or not np.isfinite(condition).all())


def _by_logarithm(system: Augmented, region: FloatArray) -> Roots:
    """All roots with a parameter from :attr:`Logarithmic.least` to :attr:`Logarithmic.high`, as
    boxes of the parameter itself.
    """
    by_logarithm, given = Logarithmic(system.family, system.condition), system.family.begin
    ends = _between(region, np.log(Logarithmic.least), np.log(Logarithmic.high))
    found = certified_roots.search(by_logarithm, ends, given, given, budget=100_000)
    return replace(
        found,
        ends=_exponential(found.ends),
        alone=_exponential(found.alone),
        undecided=_exponential(found.undecided),
    )


def _joined(small: Roots, large: Roots) -> Roots:
    """Roots of the search by logarithm and of that by the parameter itself, each once.

    Boxes that one search leaves undecided in the range of the other are dropped.
    """
    return distinct(
        small.select(undecided=-small.undecided[0, -1] <= Logarithmic.low).concatenated(
            large.select(undecided=large.undecided[1, -1] >= Logarithmic.high)
        )
    )


def _exponential(ends: FloatArray) -> FloatArray:
    """Boxes of the parameter, from boxes of its logarithm."""
    with quiet():
        return np.concatenate([ends[:, :-1], Intervals(ends[:, -1:]).exp().ends], axis=1)


def escapes(family: Family) -> Points:
    """Values of a parameter at which a state in contact runs to infinity; in the plane of two
    parameters, limit points of the curve of these values in the second.

    The kind is ``"infinity up"`` if the state exists above the value, ``"infinity down"`` if below.
    Coordinates are infinite, or NaN where they stay finite. Every point is proved. Of affine forces
    there are others only in ``undecided``, boxes of directions and parameters; of other forces,
    whose states are not known to lie in what is searched, there may be others. A corner of the
    curve, where a direction at infinity meets the border of another contact, is not among them.
    """
    balance, n, affine = family.balance, family.balance.n, family.is_affine()
    if affine and is_singular(balance, family):  # then there are no states but lines
        found, side = Roots.none(n + len(family.vary)), np.empty(0, dtype=int)
    else:
        found, side = _directions(family)
    undecided = found.undecided if affine else found.undecided[:, :, :0]
    z = found.middle
    away = _places(balance, z[:n])
    kind = np.select([side > 0, side < 0], ["infinity up", "infinity down"], "infinity")
    columns = family.named(np.concatenate([away, z[n:]])) | which(balance, kind.size)
    return Points(
        family.p,
        family.vary,
        kind,
        found.error,
        family.spans,
        True,
        (),
        np.moveaxis(spans_of(undecided), 1, 0),
        (),
        columns,
    )


def _places(balance: Balance, directions: FloatArray) -> FloatArray:
    """Infinite coordinates along each direction; NaN for coordinates that stay finite, by a
    component below 1e-6.
    """
    away = np.where(np.abs(directions) < 1e-6, np.nan, np.copysign(np.inf, directions))
    away[list(balance.periodic)] = np.nan
    return away


def _directions(family: Family) -> tuple[Roots, IntArray]:
    """Directions of states at infinity with their parameter values, and the side on which each
    state exists: 1, −1, or 0 if unknown.

    With two parameters, limit points of the curve of values in the second are searched instead.
    """
    balance, system = family.balance, _AtInfinity(family, turns=len(family.vary) > 1)
    # A box that holds the unit sphere.
    sides = np.full((2, balance.n, 1), 1.0 + 2.0**-6)
    sides[:, list(balance.periodic)] = SEARCHED_ANGLE
    found = Roots.none(system.n)
    with suppress(NoChart), quiet():
        box, budget = with_sides(sides, family.spans), _usual_budget(system)
        found = certified_roots.search(system, box, family.begin, family.begin, budget=budget)
        if not system.order:
            parameters = system.fixed(found.point.size)
            behind = system.behind_borders(Intervals(found.ends), parameters)
            found = found.select(np.flatnonzero(~behind))
        return found, system.side(Intervals(found.ends), system.fixed(found.point.size))
    return found, np.empty(0, dtype=int)


def slopes_at_infinity(
    balance: Balance, vary: str, given: FloatArray, error: float, before: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Derivatives of G = 0, |u|² = 1 where a state runs to infinity: by u, shape (n + 1, n), and by
    all parameters, shape (n + 1, P); NaN where the direction is not found.

    ``given`` are the parameters, shape (P,), of which ``vary`` is known to within ``error``.
    ``before`` are the coordinates there, as columns of :func:`escapes`.
    """
    names, column = tuple(balance.parameters), given[:, None].copy()
    value = given[names.index(vary)]
    tolerance = error + 1e-9 * abs(value)
    column[names.index(vary)] = np.nan
    span = np.array([[value - tolerance, value + tolerance]])
    found, _ = _directions(Family(None, balance, (vary,), column, span))
    n, z = balance.n, found.middle
    same = np.array_equal(_places(balance, z[:n, :1]), before[:, None], equal_nan=True)
    if found.point.size != 1 or not same:
        return np.full((n + 1, n), np.nan), np.full((n + 1, len(names)), np.nan)

    def slopes_by(*others: str) -> FloatArray:
        """Derivatives by u, by ``vary``, and by other parameters."""
        some = [names.index(name) for name in (vary, *others)]
        fixed = given[:, None].copy()
        fixed[some] = np.nan
        family = Family(None, balance, (vary, *others), fixed, np.zeros((len(some), 2)))
        system = _AtInfinity(family)
        point = Intervals.point(np.concatenate([z[:n], given[some, None]]))
        rows = system.slopes(point, system.prepared_at(given[:, None]))
        return np.array(
            [[as_intervals(entry, (1,)).middle[0] for entry in row[:-1]] for row in rows]
        )

    # As soon as a parameter is not 0 it may change the largest power of the forces: only where it
    # does not, there is a slope by it.
    others = [name for name in names if name != vary]
    some = [name for name in others if given[names.index(name)]]
    known, by_p = slopes_by(*some), np.full((n + 1, len(names)), np.nan)
    by_p[:, [names.index(name) for name in (vary, *some)]] = known[:, n:]
    for name in set(others).difference(some):
        own = slopes_by(name)
        if np.allclose(own[:, :-1], known[:, : n + 1], 1e-9):
            by_p[:, names.index(name)] = own[:, -1]
    return known[:, :n], by_p


class _AtInfinity(OfFamily, WithoutTapes):
    """The system G = 0 at w = 0, |u|² = 1; unknowns are u, periodic angles and the varying
    parameters.

    With ``turns``, for limit points in the second of two parameters, the Jacobian of G and |u|² by
    u and the first parameter is singular too.
    """

    def __init__(self, family: Family, turns: bool = False) -> None:
        super().__init__(family)
        self.order, self.limits = int(turns), np.inf

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation at q = u/w, for intervals or jets, in which w is one more variable."""
        order = order_of(*q)
        w = Jet.variable(0, self.n, order)
        u, arguments = self.parted(q, values, xp)
        scaled = {
            name: value if isinstance(value, int) else Scaled(value, 0, w)
            for name, value in arguments.items()
        }
        periodic = self.balance.periodic
        coordinates = [Scaled(part, int(i not in periodic), w) for i, part in enumerate(u)]
        return self.balance.at(coordinates, scaled, xp=ScaledFunctions())

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> Sequence[Any]:
        """G, |u|² − 1 and, at limit points, the determinant."""
        far = set(range(self.balance.n)) - set(self.balance.periodic)
        rows = [*map(_regular, at.rows("forces")), sum((unknowns[i] ** 2 for i in far), -1)]
        if not self.order:
            return rows
        return [*rows, determinant([[slope(row, k) for k in range(self.n - 1)] for row in rows])]

    def excluded(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes of directions in which the contact opens."""
        gaps = map(_regular, self.state(list(unknowns), parameters).gaps() or [0])
        shape = unknowns.shape[1:]
        return self.balance.sides([as_intervals(constant(gap), shape) for gap in gaps])[1]

    def side(self, unknowns: Intervals, parameters: Intervals) -> IntArray:
        """Side of the parameter value on which the state exists, 1 or −1; 0 if unknown, or with two
        parameters.
        """
        if self.order:
            return np.zeros(unknowns.shape[1], dtype=int)
        slopes = self.slopes(unknowns, parameters)
        # λ' by Cramer's rule: its sign is the product of those of two determinants.
        numerator = determinant([[*row[: self.n - 1], -row[self.n]] for row in slopes])
        denominator = determinant([row[: self.n] for row in slopes])
        return stacked([numerator, denominator], unknowns.shape[1:]).signs.prod(axis=0)

    def slopes(self, unknowns: Intervals, parameters: Intervals) -> list[list[Number]]:
        """Derivatives of each equation by the unknowns and by w."""
        equations = self.equations(variables(list(unknowns), 1), parameters)
        return [gradient(row, self.n + 1) for row in equations]

    def behind_borders(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Directions whose states lie beyond a contact's border: a touching contact opens, or an
        open one closes.

        A gap that is 0 in the direction itself depends on the finite coordinates. Then the sign of
        its derivative along the curve of states decides, by the Schur complement of the equations.
        """
        slopes, shape = self.slopes(unknowns, parameters), unknowns.shape[1:]
        regular = determinant([row[: self.n] for row in slopes])
        sides = list[Intervals]()
        for gap in self.state(variables(list(unknowns), 1), parameters).gaps():
            row = _regular(gap)
            ahead = as_intervals(constant(row), shape)
            along = determinant([*slopes, gradient(row, self.n + 1)])
            signs = stacked([along, regular], shape).signs.prod(axis=0)
            slope_ends = np.where(signs == 0, 1.0, [-signs, signs])
            sides.append(Intervals(np.where(ahead.signs == 0, slope_ends, ahead.ends)))
        return self.balance.sides(sides or [Intervals.point(np.ones(shape))])[1]


def _regular(row: Number) -> Number:
    """The coefficient of a number's power of w."""
    return row.value if isinstance(row, Scaled) else row
