"""All equilibria of any model by branch and prune, each proved, with bounds on their errors.

Each combination of touching contacts is searched on its own. Boxes that remain undecided are
returned too, with the reason in plain words.
"""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ParameterError, ParameterTypeError
from ..core.questions import question
from ..core.remarks import At, Remark
from ..display import own_name
from ..models import Model
from ..models.field import SETTLED_SHARE
from ..models.model import Touching, label_of
from ..models.parameters import ParameterSet, Ranges
from ..numerics import certified_roots
from ..numerics.certified_roots import Roots, in_order
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    Int8Array,
    IntArray,
    Intervals,
    Shape,
    quiet,
    scale_of,
    spans_of,
    width_of,
)
from ..numerics.vectors import state_difference
from ..results import Equilibria, Undecided
from . import stability
from .balance import NEGLIGIBLE, Balance
from .forces import as_intervals, belt_speeds
from .namespaces import XP
from .nearer import FOUND, nearer
from .options import SearchOptions
from .polar import around_anchors, stiff_points, turned_points
from .precise_balance import (
    decided_at_edges,
    on_contact_side,
    reduced_by_turns,
    refined,
    refined_in_digits,
)
from .regions import region, requested_region
from .states import Held

#: The argument ``contact``: one combination of touching contacts, as a key of ``Model.regimes`` or
#: as names; None for all combinations in which something touches.
ContactArgument: TypeAlias = Touching | Sequence[str] | None


def equilibria_by_search(
    p: ParameterSet,
    contact: ContactArgument,
    within: Ranges | None,
    options: SearchOptions | None = None,
) -> Equilibria:
    """Answer of :func:`spragsym.equilibria` by one search for each combination of contacts."""
    balances = balances_of(p.model, within, options, contact=contact)
    requested = requested_region(p.model, within)
    given = columns(p, balances[0].parameters)
    parts = [(balance, *roots_of(balance, given, requested)) for balance in balances]
    return _arranged(p, parts)


def balances_of(
    model: Model,
    within: Ranges | None = None,
    options: SearchOptions | None = None,
    *,
    contact: ContactArgument = None,
    law: str = "friction_at_rest",
) -> list[Balance]:
    """The balance of each combination of touching contacts that ``contact`` asks for.

    Combinations whose states all lie outside the ranges ``within`` are left out, but at least one
    remains.
    """
    if contact is None:
        # The combination False counts as contact if some contact never opens.
        combinations = [key for key in model.regimes if key or not model.lifts_off]
    else:
        combinations = [_combination(model, contact)]
    balances = [Balance(model, key, law, options=options) for key in combinations]
    for balance in balances:
        balance.apart = len(balances) > 1
    requested = requested_region(model, within)
    if requested is None:
        return balances
    inside = [one for one in balances if (width_of(np.minimum(requested, one.border)) >= 0).all()]
    return inside or balances[:1]


def number_of(balances: Sequence[Balance], touching: str) -> int:
    """Index of the balance in which these contacts touch; 0 if ``touching`` is empty."""
    return next(k for k, one in enumerate(balances) if touching in ("", one.touching))


def balance_of(model: Model, contact: ContactArgument) -> Balance:
    """The balance of the one combination that ``contact`` means.

    Raises ParameterError if it is left out and the model has several.
    """
    balance, *others = balances_of(model, contact=contact)
    if others:
        raise ParameterError(
            f"contact is left out: say {', '.join(map(repr, model.regimes))}, for states in "
            f"{', '.join(model.regimes.values())}"
        )
    return balance


def _combination(model: Model, contact: ContactArgument) -> Touching:
    """The combination of touching contacts as a key of :attr:`spragsym.models.Model.regimes`."""
    names = [entry["name"] for entry in model.contacts]
    if isinstance(contact, list | tuple) and len(names) > 1 and {*contact} <= {*names}:
        opening = [label_of(entry) for entry in model.contacts if entry["border"]]
        some = tuple(name for name in opening if name in contact)
        return some if 0 < len(some) < len(opening) else bool(some) or not opening
    if not isinstance(contact, int | np.bool_) or contact not in (0, 1):
        besides = f", nor some of {', '.join(names)}, as ({names[0]!r},)" if len(names) > 1 else ""
        raise ParameterTypeError(
            f"contact = {contact!r:.60} is neither True, for states in contact, nor False, "
            f"for lift-off{besides}"
        )
    if not contact and False not in model.regimes:
        why = (
            "has no contact that could open"
            if all(entry["gap"] is None for entry in model.contacts)
            else "has a contact that never opens"
        )
        raise ParameterError(
            f"contact = False: this model {why}, so it has no lift-off; leave contact out"
        )
    return bool(contact)


@question
def rest_index(p: ParameterSet, places: FloatArray) -> Int8Array:
    """Slot of the equilibrium, with friction μ(V), at which each motion has come to rest; −1 for
    none.

    ``places`` are the coordinates of the motions, with the shape of ``p`` behind the first axis,
    and NaN for a motion that does not rest.
    """
    places = np.broadcast_to(
        places, (len(places), *np.broadcast_shapes(p.shape, np.shape(places)[1:]))
    )
    out = np.full(places.shape[1:], -1, dtype=np.int8)
    rows = np.isfinite(places).all(axis=0)
    if not rows.any():
        return out
    balances = balances_of(p.model, law="friction_at_speed")
    balance, states = balances[0], places[:, rows]
    given = np.array([np.broadcast_to(p[name], rows.shape)[rows] for name in balance.parameters])
    given = given.reshape(len(balance.parameters), states.shape[1])
    found, *others = (roots_of(one, given)[0] for one in balances)
    found = found.concatenated(*others)
    order, slot = _in_slots(found)
    found = found.select(order)
    point = found.point
    off = state_difference(found.middle.T, states[:, point].T, balance.periodic)
    distance = np.linalg.norm(off, axis=1) / (1 + np.linalg.norm(states[:, point], axis=0))
    index = np.full(states.shape[1], -1)
    # Of several roots near a motion, the nearest is written last and remains.
    nearest_last = np.argsort(-distance, kind="stable")
    near = nearest_last[distance[nearest_last] <= SETTLED_SHARE]
    index[point[near]] = slot[near]
    out[rows] = index
    return out


def steady_states(p: ParameterSet) -> Iterator[tuple[str, FloatArray, FloatArray]]:
    """The states of steady sliding for scalar parameters, with the friction μ(V) of a motion: of
    each combination of contacts its name, the places of its states and bounds of their errors.
    """
    for contact, name in p.model.regimes.items():
        (balance,) = balances_of(p.model, contact=contact, law="friction_at_speed")
        found, _, _ = roots_of(balance, columns(p, balance.parameters))
        found = found.select(_in_slots(found)[0])
        yield name, found.middle.T, found.error


def columns(p: ParameterSet, names: list[str]) -> FloatArray:
    """The named parameters as an array of shape (parameters, points)."""
    return np.array([value.reshape(-1) for value in p.broadcast(*names)]).reshape(
        len(names), int(np.prod(p.shape))
    )


def float_candidates(balance: Balance, given: FloatArray, requested: FloatArray | None) -> Roots:
    """Roots at all points that one search in floats decides; those in undecided boxes are missing.

    They may lie on either side of the contact's border.
    """
    box, _ = region(balance, Intervals.point(given), requested)
    return certified_roots.search(balance, box, given, given, budget=8000)


def roots_of(
    balance: Balance, given: FloatArray, requested: FloatArray | None = None
) -> tuple[Roots, FloatArray, BoolArray]:
    """All roots at all points, the searched boxes, and where these are proved to hold all
    equilibria.

    ``given`` are parameters, shape (parameters, points), and ``requested`` is a user's box.
    """
    box, complete = region(balance, Intervals.point(given), requested)
    in_angles, found_in_angles = turned_points(balance, given, box)
    in_tension, found_in_tension = stiff_points(balance, given, box)
    rest = np.flatnonzero(~(found_in_angles | found_in_tension))
    others = nearer(balance, given[:, rest], box[:, :, rest], _by_boxes).numbered(rest)
    found = refined(balance, given, in_angles.concatenated(in_tension, others))
    found = decided_at_edges(balance, given, on_contact_side(balance, given, found))
    return reduced_by_turns(balance.periodic, found), box, complete


def _in_slots(found: Roots) -> tuple[IndexArray, IntArray]:
    """The order of roots by point and coordinates, and the slot of each sorted root at its
    point.
    """
    order = in_order(found.middle, found.error, found.point)
    point = found.point[order]
    return order, np.arange(point.size) - np.searchsorted(point, point)


def _by_boxes(balance: Balance, given: FloatArray, box: FloatArray) -> Roots:
    """Roots at all points by a search over boxes of coordinates.

    Boxes that the search leaves undecided are refined in ball arithmetic, then searched in polar
    coordinates around anchors.
    """
    if not given.shape[1]:
        return Roots.none(balance.n)
    narrow = balance.options.narrow or 2.0**-19  # ball arithmetic decides narrower boxes
    found = certified_roots.search(balance, box, given, given, narrow=narrow)
    refined = refined_in_digits(balance, given, box, found)
    return around_anchors(balance, given, box, refined)


def _arranged(
    p: ParameterSet, parts: Sequence[tuple[Balance, Roots, FloatArray, BoolArray]]
) -> Equilibria:
    """Results of all combinations of touching contacts as columns, one slot for each state.

    ``parts`` are balances with their roots, the regions that were searched, and masks of the points
    whose region holds all states.
    """
    balance, given = parts[0][0], columns(p, parts[0][0].parameters)
    searched = np.max([part for *_, part, _ in parts], axis=0)
    complete: BoolArray = np.logical_and.reduce([whole for *_, whole in parts])
    still = _still(p, [one for one, *_ in parts])
    classified, touching, reasons = list[tuple[Any, ...]](), list[str](), list[str]()
    untold = list[str]()
    for own, roots, _, _ in parts:
        at = given[:, roots.point]
        classified.append(stability.classified(own, roots.middle, at, roots.ends))
        untold += _untold(own, roots.middle, at, classified[-1][2])
        touching += [own.touching] * roots.point.size
        reasons += kinds_of(own, given[:, roots.undecided_point], roots.undecided)
    found = parts[0][1].concatenated(*(roots for _, roots, *_ in parts[1:]))
    order, slot = _in_slots(found)
    found = found.select(order)
    codes, proved, eigenvalues = map(np.concatenate, zip(*classified, strict=True))
    count = np.bincount(found.point, minlength=given.shape[1])
    decided = np.ones(count.size, dtype=bool)
    decided[found.undecided_point] = False

    def placed(values: NDArray[Any], empty: float | str) -> NDArray[Any]:
        """A column of all points and slots from values of the sorted roots."""
        slots, entry = max(1, int(count.max(initial=0))), values.shape[1:]
        out = np.full((count.size, slots, *entry), empty, dtype=values.dtype)
        out[found.point, slot] = values
        return out.reshape(*p.shape, slots, *entry)

    ours = {
        "undamped": placed(codes[order], 0),
        "marginal": placed(~proved[order], False),
        "eigenvalues": placed(eigenvalues[order], np.nan),
        "error": placed(found.error, np.nan),
        "region": np.moveaxis(spans_of(searched), 0, 1).reshape(*p.shape, balance.n, 2),
        "whole": complete.reshape(p.shape) & ~still,
    }
    if p.model.has_regimes:
        ours["touching"] = placed(np.array(touching, dtype=str)[order], "")
    held = {own_name(p.model, name): column for name, column in ours.items()}
    for name, coordinate in zip(balance.coordinates, found.middle, strict=True):
        held[name] = placed(coordinate, np.nan)
    return Equilibria(
        p,
        balance.contact if len(parts) == 1 else None,
        count.reshape(p.shape),
        decided.reshape(p.shape),
        _undecided_boxes(found, reasons, p.shape),
        (
            *summed(reasons),
            *untold,
            *((HELD,) if still.any() else ()),
            *((FOUND,) if KINDS["wide"] in reasons else ()),
            *of_region(balance, searched, complete),
        ),
        Held(held, found.ends),
    )


#: The remark on points at which a belt stands still on which friction holds.
HELD = (
    "a belt stands still on which friction holds: listed are states at the coefficient of sliding; "
    "those that friction holds form sets around them, which sticking_states gives"
)


def _still(p: ParameterSet, balances: Sequence[Balance]) -> BoolArray:
    """Points at which a belt stands still on which friction holds, of a contact that touches."""
    out = np.zeros(p.shape, dtype=bool)
    each = zip(p.model.frictions, belt_speeds(p), strict=False)
    for entry, speed in each if any(entry["holds"] for entry in p.model.frictions) else ():
        touches = any(one.indicators[one.contacts.index(entry["name"])] for one in balances)
        if entry["holds"] and touches:
            out |= np.broadcast_to(speed, p.shape) == 0
    return out


def _untold(
    balance: Balance, states: FloatArray, given: FloatArray, undamped: NDArray[Any]
) -> Iterator[str]:
    """A remark on states that have no finite eigenvalues, with the values that are to blame."""
    rows = np.flatnonzero(stability.without_eigenvalues(balance, states, given, undamped))
    if not rows.size:
        return
    first = rows[0]
    far = np.flatnonzero(stability.extreme(given[:, first]))
    values = [At(balance.parameters[k], (float(given[k, first]),), "g") for k in far] or [
        At(name, (float(value),), "g", unit="rad" * balance.model.is_angle(name))
        for name, value in zip(balance.coordinates, states[:, first], strict=True)
    ]
    why = (
        "masses, stiffnesses or dampers leave the range of floats"
        if far.size
        else "the kinetic energy is not positive for all rates there, or forces have no slope"
    )
    yield Remark(
        f"{rows.size} of {undamped.shape[0]} states have no eigenvalues, and no stability, at "
        + ", ".join(["{}"] * len(values))
        + f": {why}",
        *values,
    )


def _undecided_boxes(found: Roots, reasons: Sequence[str], shape: Shape) -> tuple[Undecided, ...]:
    """The undecided boxes of a search with their reasons; points form an array of that shape."""
    lows, highs = -found.undecided[0].T, found.undecided[1].T
    out = []
    for point, low, high, reason in zip(found.undecided_point, lows, highs, reasons, strict=True):
        index = tuple(map(int, np.unravel_index(point, shape)))
        out.append(Undecided(index, tuple(low.tolist()), tuple(high.tolist()), reason))
    return tuple(out)


#: Reasons why a box is undecided: where it lies and what it may hold. The first that applies is
#: given.
KINDS = {
    "free": (
        "along which no force acts on one of the coordinates at these parameters: a line of "
        "states, or none"
    ),
    "pole": (
        "at an end of a spring that resists turning: its force has no bound there, and no search "
        "decides what is beside it"
    ),
    "anchor": (
        "at the anchor of a spring, where its force has no value: an equilibrium may be nearer to "
        "it than floats tell"
    ),
    "border": (
        "where the contact just touches: whether what is there lies on this side of the border is "
        "not known"
    ),
    "place": (
        "no wider than one place is to floats: a double root may be there, two very near ones, or "
        "none"
    ),
    "line": (
        "where the equations nearly hold: a line of roots, a degenerate one as of a pitchfork that "
        "changes its side, or none"
    ),
    "wide": (
        "left from a search that ended before it was small enough to be decided: a smaller range "
        "or a smaller box helps, or in Python more seconds, or a larger budget, of ss.SearchOptions"
    ),
}


def summed(kinds: Sequence[str]) -> tuple[str, ...]:
    """One sentence for each reason, with the number of undecided boxes."""
    sentences = []
    for kind, number in Counter(kinds).items():
        count = f"{number} of {len(kinds)}" if number < len(kinds) else f"{number}"
        sentences.append(f"{count} undecided {'box' if len(kinds) == 1 else 'boxes'} {kind}")
    return tuple(sentences)


def kinds_of(
    balance: Balance,
    given: FloatArray,
    undecided: FloatArray,
    varied: Mapping[str, Any] | None = None,
) -> list[str]:
    """The reason of :data:`KINDS` for each undecided box.

    ``given`` are parameters, shape (parameters, boxes), and ``undecided`` the boxes as −low and
    high, shape (2, unknowns, boxes). Unknowns are the coordinates and then parameters that vary,
    whose intervals ``varied`` holds by name.
    """
    count, n = undecided.shape[2], balance.n
    if not count:
        return []
    with quiet():
        values = balance.over(Intervals.point(np.nan_to_num(given))) | balance.with_angles(
            varied or {}, XP
        )
        at = balance.at(list(Intervals(undecided[:, :n])), values, (count,))
        pole, anchor = balance.at_poles(at, np.inf), np.zeros(count, dtype=bool)
        for dx, dy in at.anchors:
            anchor |= dx.holds_zero() & dy.holds_zero()
        border = np.zeros(count, dtype=bool)
        for gap in at.gaps():
            border |= as_intervals(gap, at.shape).holds_zero()
        width = (width_of(undecided) / scale_of(undecided).max(axis=0)).max(axis=0)
        free: BoolArray = np.zeros(count, dtype=bool)
        if varied is None:
            forces = balance.residuals(Intervals(undecided), balance.prepared_at(given))
            free = np.logical_or.reduce(forces.magnitude <= NEGLIGIBLE) & (width > 1e-9)
    small = width <= 1e-3
    *kinds, wide = KINDS.values()
    return np.select(
        [free, pole, anchor & small, border & small, width <= 1e-9, small], kinds, wide
    ).tolist()


def of_region(balance: Balance, region: FloatArray, whole: BoolArray) -> tuple[str, ...]:
    """Remarks where a region is not proved to hold all equilibria; ``region`` is −low and high,
    shape (2, n, points), and ``whole`` the proof.
    """
    if whole.all():
        return ()
    open_ = np.flatnonzero(~whole)
    hull = region[:, :, open_].max(axis=2)
    where = f" at {open_.size} of {whole.size} points" if whole.size > 1 else ""
    ends = zip(balance.coordinates, -hull[0], hull[1], strict=True)
    places = [
        At(name, (float(low), float(high)), unit="rad" * balance.model.is_angle(name))
        # A wider one about 0 is no bound, but the limit of the search.
        if high - low < 1e12 or not low < 0 < high
        else Remark(f"any {name}")
        for name, low, high in ends
    ]
    within = ", ".join(["{}"] * len(places))
    return (Remark(f"searched within {within}{where}; there may be others beyond it", *places),)


def of_ranges(cut: Sequence[str], names: Sequence[str], ends: FloatArray) -> tuple[str, ...]:
    """Remarks on the parameters ``cut``, whose infinite ranges were searched only up to ``ends``,
    shape (parameters, 2).
    """
    return tuple(
        Remark(
            "searched {}, a part of its range, which has no end; there may be others beyond it",
            At(name, (low, high)),
        )
        for name, (low, high) in zip(names, ends.tolist(), strict=True)
        if name in cut
    )
