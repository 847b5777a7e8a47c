"""The bifurcation set of a model in the plane of two parameters: curves of folds, and the cusps on them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..models.parameters import ParameterSet, as_count
from ..numerics.certified_roots import concatenated
from ..numerics.chains import link, walked
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals
from ..progress import doing
from ..questions import Method, question
from ..remarks import Remark
from ..results.bifurcation_sets import BifurcationSet, Curve
from ..results.points import Points
from ..statics.remarks import kinds_of, of_ranges, summed
from .bifurcation_conditions import FOLD, FOLD_ON_BORDER, TURN
from .cusps import cusps
from .defining_systems import Augmented, Condition
from .families import Family
from .fold_curves import FoldCurves
from .folds import folds
from .points import OVER_BORDER, Found, isolated, search

#: Rounds in which points are joined to those next to them.
ROUNDS = 4
#: Boxes looked at for one line of the plane.
BUDGET = 20_000
#: Extrema and ends of curves, as remarks call them.
_WHERE = {
    "cusp": "of cusps",
    "turn": "where curves turn back",
    "end": "where curves end",
    "border": "where curves leave the contact",
}
#: Lines one after the other that stay undecided alone, after which no other is searched alone.
ENOUGH = 4
#: How near a line counts as on it, over the range of the parameter.
ON_LINE = 1e-9


@question
def bifurcation_set(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    n: int | None = None,
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
    within: Mapping[str, tuple[float, float]] | None = None,
    method: Method = "auto",
) -> BifurcationSet:
    """Where the number of equilibria in contact changes in the plane of two parameters: every curve of folds, and the cusps.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; those that vary are not used.
    vary : pair of str, optional
        Two parameters, θ₀ and μ₀ unless told otherwise.
    n : int, optional
        Lines in each direction, 60 unless told otherwise, and one more wherever none of them passes between two extrema of
        curves; on each all folds are found and proved. Of closed forms about how many directions θ to solve at, 2000, 600 at
        least.
    between, within, method
        As for :func:`spragsym.folds`, ranges of the two.

    Returns
    -------
    BifurcationSet

    Raises
    ------
    ParameterError
        For parameters that the model has not, or ranges that leave theirs.
    ConvergenceError
        Of the article's model with hardly any preload, κ some 10⁻⁷ of σ or of 1 + β, where float64 can't tell folds apart.

    Notes
    -----
    Source: F = 0 and det K = 0 along these lines, all searched at once; extrema of curves in the second parameter, cusps among
    them, and ends of curves by :func:`spragsym.bifurcation.bifurcation.extrema`: where all of these are known, no curve
    is missed, however small it is. Points between by :mod:`spragsym.bifurcation.fold_curves`. Two points are neighbours
    only if no line separates them on which all folds are known.
    Of the article's model: :mod:`spragsym.kang_nam.folds.bifurcation_sets`.

    Examples
    --------
    >>> import spragsym as ss
    >>> found = ss.bifurcation_set(ss.Parameters.article())
    >>> len(found), round(float(found.cusps.mu0[0]), 12)
    (2, 0.200931781805)
    """
    n = 60 if n is None else n
    vary = p.model.two(vary)
    as_count("n", n, 2)
    family = Family.of(p, vary, between, within)
    known = list(extrema(p, vary, between or {}, within))
    more = np.concatenate([rows_of(family, points) for _, points in known], axis=1)
    found = on_lines(family, FOLD, n, more, more[-1])
    names, states = (*vary, *family.balance.coordinates), family.balance.n
    curves = [Curve(dict(zip(names, [*chain[states:], *chain[:states]], strict=True))) for chain in found.chains]
    complete = found.whole and not found.undecided.shape[0] and all(points.complete for _, points in known)
    cut = of_ranges(family.endless, family.spans[[family.vary.index(name) for name in family.endless]])
    remarks = (*found.remarks, *_said(known, cut))
    return BifurcationSet(family.vary, tuple(curves), known[0][1], complete, found.lines, found.undecided, remarks)


def _said(known: Sequence[tuple[str, Points]], cut: tuple[str, ...]) -> Iterator[str]:
    """Remarks: ranges that are ``cut``, and each other remark on extrema and ends of curves once, with the points it concerns."""
    yield from cut
    said: dict[str, dict[str, None]] = {}
    for kind, points in known:
        for text in points.remarks:
            said.setdefault(text, {})[_WHERE[kind]] = None
    yield from (Remark("{}: {}", ", ".join(kinds), text) for text, kinds in said.items() if text not in cut)


@dataclass(frozen=True)
class OnLines:
    """Points of a kind on lines, in order along curves, and the lines; boxes that are left, and what is known of them."""

    curves: FoldCurves
    chains: list[FloatArray]
    lines: dict[str, FloatArray]
    undecided: FloatArray
    whole: bool
    remarks: tuple[str, ...]


def on_lines(
    family: Family, condition: Condition, n: int, more: FloatArray, apart: FloatArray | None = None
) -> OnLines:  # fmt: skip
    """All points of a kind on ``n`` lines of either parameter, joined to curves; ``more`` points belong to them as well.

    Between any two of the values ``apart`` of the second parameter there is a line of the first one.
    """
    rows, left, lines, decided, whole = [], [], {}, {}, True
    balance, vary, spans = family.balance, family.vary, family.spans
    for along, across in ((0, 1), (1, 0)):
        # Inside of the range: its ends are often degenerate.
        values = spans[across, 0] + (spans[across, 1] - spans[across, 0]) * (np.arange(n) + 0.5) / n
        if across == 1 and apart is not None:
            values = np.sort(np.append(values, _between(apart, spans[across], values)))
        lines[vary[across]] = values
        column = np.repeat(family.given, values.size, axis=1)
        column[balance.parameters.index(vary[across])] = values
        with doing("{} lines along {}", values.size, vary[along]):
            found = _on_each(replace(family, vary=(vary[along],), given=column, spans=spans[along : along + 1]), condition)
        whole &= bool(found.whole.all())
        decided[across] = np.delete(values, found.roots.left_point)
        rows.append(_with_line(found.roots.middle, values[found.roots.point], along))
        ends = np.stack([-found.roots.left[0], found.roots.left[1]])
        left.append(np.stack([_with_line(end, values[found.roots.left_point], along) for end in ends], axis=-1))
    states = np.concatenate([*rows, more], axis=1)
    undecided = np.moveaxis(np.concatenate(left, axis=1), 1, 0)
    boxes = np.moveaxis(undecided, 0, -1)
    boxes = np.stack([-boxes[:, 0], boxes[:, 1]])
    varied = dict(zip(vary, Intervals(boxes[:, balance.n :]), strict=True))
    remarks = summed(kinds_of(balance, np.repeat(family.given, boxes.shape[2], axis=1), boxes, varied))
    reach = max(float(np.ptp(states[: balance.n], axis=1).max()), 1e-9) if states.size else 1.0
    curves = FoldCurves(Augmented(family, condition), np.concatenate([np.full(balance.n, reach), spans[:, 1] - spans[:, 0]]))
    near = np.logical_and(*(_no_line_between(states[balance.n + k], decided[k], spans[k]) for k in (0, 1)))
    joined = curves.joined([states[:, places] for places in _chains(curves, states, near)], [lines[name] for name in vary])
    chains = [curves.smooth(chain) for chain in joined]
    return OnLines(curves, chains, lines, undecided, whole, tuple(Remark("on lines: {}", text) for text in remarks))


def _on_each(lines: Family, condition: Condition) -> Found:
    """All points on lines, searched at once; each line of which boxes are left again alone, with all that decides one line."""
    found = search(lines, condition, BUDGET)
    open_ = np.unique(found.roots.left_point)
    parts, undecided = [], 0
    for line in open_:
        if undecided == ENOUGH:
            break
        alone = search(replace(lines, given=lines.given[:, [line]]), condition, BUDGET).roots
        undecided = undecided + 1 if alone.left_point.size else 0
        parts.append(replace(alone, point=np.full_like(alone.point, line), left_point=np.full_like(alone.left_point, line)))
    again = open_[: len(parts)]
    return replace(found, roots=concatenated([found.roots.of(again, others=True), *parts], lines.balance.n + 1))


def _between(values: FloatArray, span: FloatArray, lines: FloatArray) -> FloatArray:
    """Middles of the intervals between values next to each other, in a range, in which no line is; none where two are alike."""
    ends = np.unique([*span, *values])
    empty = np.searchsorted(lines, ends[:-1], "right") == np.searchsorted(lines, ends[1:], "left")
    return 0.5 * (ends[:-1] + ends[1:])[empty & (np.diff(ends) > ON_LINE * np.ptp(span))]


def _with_line(middle: FloatArray, line: FloatArray, along: int) -> FloatArray:
    """Coordinates and both parameters in their order, from coordinates, the one that varied and the line's."""
    pair = [middle[-1:], line[None]]
    return np.concatenate([middle[:-1], *(pair if along == 0 else pair[::-1])])


def rows_of(family: Family, found: Points) -> FloatArray:
    """Coordinates and both parameters of points, shape (n + 2, points)."""
    names = (*family.balance.coordinates, *family.vary)
    return np.array([getattr(found, name) for name in names]).reshape(len(names), -1)


# ------------------------------------------------------------------------------------------------------- order of points


def _no_line_between(places: FloatArray, lines: FloatArray, span: FloatArray) -> BoolArray:
    """Whether no line separates two points, for every pair: where a curve crosses a line, there is a point of its own."""
    room = ON_LINE * (span[1] - span[0])
    first, last = np.searchsorted(lines, places - room, "left"), np.searchsorted(lines, places + room, "right")
    return np.maximum.outer(first, first) <= np.minimum.outer(last, last)


def _chains(folds: FoldCurves, states: FloatArray, near: BoolArray) -> list[IntArray]:
    """Points in order along curves: each is joined to the next ones ahead and behind along its tangent, if they agree.

    ``near`` says which two may be neighbours, shape (points, points).
    """
    count = states.shape[1]
    if count < 2:
        return [np.arange(count)] if count else []
    place, tangent = states / folds.scale[:, None], folds.tangents(states)
    gap = place[:, None, :] - place[:, :, None]
    distance = np.linalg.norm(gap, axis=0)
    ahead = (gap * tangent[:, :, None]).sum(axis=0)
    with np.errstate(all="ignore"):
        straight = np.abs(ahead) / distance
        cost = np.where(near & (straight > 0.5) & (distance > 1e-12), distance / straight**2, np.inf)
    # Side 0 of a point lies ahead along its tangent, side 1 behind; each takes one link.
    cost = np.stack([np.where(sign * ahead > 0, cost, np.inf) for sign in (1, -1)])
    links: list[set[int]] = [set() for _ in range(count)]
    free = np.ones((2, count), dtype=np.bool_)
    for _ in range(ROUNDS):
        _link(cost, free, links)
    return walked(links)


def _link(cost: FloatArray, free: BoolArray, links: list[set[int]]) -> None:
    """Join points that are each other's nearest on sides that are free."""
    count = free.shape[1]
    # The side of the other point on which this one lies.
    back = np.isfinite(cost[1]).T.astype(np.int64)
    open_there = np.where(back == 1, free[1][None], free[0][None])
    near = np.where(free[:, :, None] & open_there[None], cost, np.inf)
    nearest = near.argmin(axis=2)
    for side in (0, 1):
        for one in range(count):
            other = int(nearest[side, one])
            if not np.isfinite(near[side, one, other]) or not free[side, one]:
                continue
            there = int(back[one, other])
            if free[there, other] and nearest[there, other] == one:
                link(links, [(one, other)])
                free[side, one] = free[there, other] = False


def extrema(
    p: Any, vary: Sequence[str], between: Mapping[str, tuple[float, float]],
    within: Mapping[str, tuple[float, float]] | None = None,
) -> Iterator[tuple[str, Points]]:  # fmt: skip
    """Where curves of folds have extreme values of the second parameter or end, by kind, each proved; arguments as of ``folds``.

    Kinds are ``"cusp"``; ``"turn"``: F = 0, det K = 0 and w · ∂F/∂v = 0 for the first parameter v, with w K = 0; ``"end"``, at
    either end of the range of v; and ``"border"``, where folds leave a contact that opens.
    """
    over, along = vary
    family, rest = Family.of(p, vary, between, within), {name: ends for name, ends in between.items() if name != over}
    with doing("cusps over {} and {}", *vary):
        found = cusps(p, vary, between=between, within=within)
    yield "cusp", found
    # Where no state depends on one of the two, curves are straight along it.
    bends = set(vary) <= set(family.balance.balanced)
    if bends:
        yield "turn", isolated(family, TURN, "turn")
    low, high = family.spans[0].tolist()
    for end in (low, high):
        value = p.ranges[over].reached(end, high - low)
        yield "end", folds(p.replace(**{over: value}), along, between=rest, within=within)
    if family.balance.opens and bends:
        yield "border", isolated(Family.of(p, vary, between, within, room=OVER_BORDER), FOLD_ON_BORDER, "border")
