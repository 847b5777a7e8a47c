"""The bifurcation set of a model in the plane of two parameters: curves of folds, and their cusps.

In the space of coordinates and both parameters a curve of folds is smooth even at a cusp; only its
image in the plane has a point there. So curves are computed in that space. All folds on a grid of
lines in the plane are found and proved, and neighbours are joined to chains. A Hermite cubic
between two neighbours, with their tangents, predicts further points until a chain is smooth.
Pseudo-arclength continuation extends chains to the ends of the ranges.

Points are proved; that two neighbours lie on one curve is not. A test decides it: the distance of
the curve's point half-way from the Hermite cubic, over the distance of the neighbours, falls with
the third power of that distance on one curve, and grows otherwise.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from ..core.progress import doing
from ..core.questions import Method, question
from ..core.remarks import Remark
from ..models.parameters import ParameterSet, Ranges, as_count
from ..numerics import contractors
from ..numerics.arithmetic import is_zero
from ..numerics.chains import link, walked
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    ends_around,
    quiet,
    scale_of,
    width_of,
)
from ..numerics.jets import gradient, variables
from ..numerics.vectors import norm
from ..results import BifurcationSet, Curve, Points
from ..statics.balance import Balance
from ..statics.options import SearchOptions
from ..statics.precise_balance import on_side
from ..statics.search import of_ranges
from .borders import kinds_of_borders, openings
from .defining_systems import (
    FOLD,
    Augmented,
    Condition,
    Family,
    blocks_of,
    both,
    touch,
    touch_turn,
    turn,
)
from .folds import cusps, folds
from .options import ContinuationOptions
from .points import Found, isolated, listed, search, which
from .singularities import even_one

#: Mask of pairs of states, (n + 2, N) each, that may be neighbours on a curve.
Alike: TypeAlias = Callable[[FloatArray, FloatArray], BoolArray]

#: A point is on a line if it is nearer than this, over the range of the parameter.
ON_LINE = 1e-9


@question
def bifurcation_set(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    n: int | None = None,
    *,
    between: Ranges | None = None,
    within: Ranges | None = None,
    options: ContinuationOptions | None = None,
    method: Method = "auto",
) -> BifurcationSet:
    """Curves in the plane of two parameters on which the number of equilibria in contact changes.

    These are all curves of folds, with their cusps; with several contacts, also curves of border
    folds.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the values of those that vary are not used.
    vary : pair of str, optional
        Two parameters, by default θ₀ and μ₀.
    n : int, optional
        Number of lines in each direction, by default 60, on which all folds are found and proved;
        one more is added wherever none passes between two extrema of curves. With closed forms,
        about the number of directions θ to solve at, at least 2000.
    between, within, method
        As for :func:`spragsym.folds`, with ranges of both parameters.
    options : ContinuationOptions, optional
        Tolerances and limits of the curves, and of the search below them.

    Returns
    -------
    BifurcationSet

    Raises
    ------
    ParameterError
        For unknown parameters, or ranges that leave those allowed.
    ConvergenceError
        For the article's model with hardly any preload, κ about 10⁻⁷ of σ or of 1 + β, where
        float64 can't separate folds.

    Notes
    -----
    Source: F = 0 and det K = 0 along the lines, all searched at once. Extrema of curves in the
    second parameter, cusps among them, and ends of curves:
    :func:`spragsym.bifurcation.bifurcation_sets.extrema`. If all of these are known, no curve is
    missed, however small. Points in between: :class:`FoldCurves`. Two points can be neighbours only
    if no line on which all folds are known separates them. The article's model:
    :mod:`spragsym.kang_nam.bifurcation_sets`.

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
    options = options or ContinuationOptions()
    families = Family.every(p, vary, between, within, options.given_search)
    special = list(extrema(p, vary, between or {}, within, options.given_search))
    curves, parts, borders = list[Curve](), list[OnLines](), list[tuple[str, Points]]()
    for family in families:
        balance = family.balance
        ends = [points.select(_of_folds(kind, points, balance)) for kind, points in special]
        more = np.concatenate([rows_of(family, points) for points in ends], axis=1)
        parts.append(on_lines(family, FOLD, n, more, more[-1], options))
        curves += [_curve(family, chain) for chain in parts[-1].chains]
        for contact, other in openings(families, family):
            near, ends = family.beyond(contact), [*border_extrema(family, contact)]
            borders += [("border", points) for points in ends]
            none = np.empty((balance.n + 2, 0))  # ends may be empty
            more = np.concatenate([none, *(rows_of(near, points) for points in ends)], axis=1)
            parts.append(on_lines(near, touch(contact), n, more, more[-1], options))
            for chain in parts[-1].chains:
                enclosures = ends_around(chain, options.half_width * scale_of(chain))
                passes = kinds_of_borders(near, enclosures, other) == "passes"
                cuts = np.flatnonzero(np.diff(passes)) + 1
                pieces = zip(np.split(chain, cuts, axis=1), np.split(passes, cuts), strict=True)
                curves += [_curve(near, piece) for piece, goes_on in pieces if not goes_on.any()]
    undecided = np.concatenate([found.undecided for found in parts])
    special += borders
    decided = all(found.whole for found in parts) and not undecided.shape[0]
    complete = decided and all(points.complete for _, points in special)
    cut = of_ranges(family.endless, vary, family.spans)
    said = dict.fromkeys(remark for found in parts for remark in found.remarks)
    remarks = (*said, *_said(special, cut))
    return BifurcationSet(
        family.vary, tuple(curves), special[0][1], complete, parts[0].lines, undecided, remarks
    )


def _of_folds(kind: str, points: Points, balance: Balance) -> BoolArray:
    """Mask of the points on curves of folds of one combination of touching contacts."""
    if not balance.model.has_regimes:
        return np.ones(len(points), dtype=bool)
    # Points at the ends of a range include border points.
    inside = (kind != "end") | (points.at_border == "")
    return (points.touching == balance.touching) & inside


def _curve(family: Family, states: FloatArray) -> Curve:
    """A chain of states as a curve with named columns."""
    return Curve(family.named(states) | which(family.balance, states.shape[1]))


def _said(parts: Sequence[tuple[str, Points]], cut: tuple[str, ...]) -> Iterator[str]:
    """Remarks on ranges that are ``cut``, then each other remark once, with the kinds of points
    that it concerns.
    """
    yield from cut
    said: dict[str, dict[str, None]] = {}
    where = {
        "cusp": "of cusps",
        "turn": "where curves turn back",
        "end": "where curves end",
        "border": "where curves leave the contact",
    }
    for kind, points in parts:
        for text in points.remarks:
            said.setdefault(text, {})[where[kind]] = None
    yield from (
        Remark("{}: {}", ", ".join(kinds), text) for text, kinds in said.items() if text not in cut
    )


def extrema(
    p: ParameterSet,
    vary: Sequence[str],
    between: Ranges,
    within: Ranges | None = None,
    options: SearchOptions | None = None,
) -> Iterator[tuple[str, Points]]:
    """Extreme values in the second parameter, and ends, of curves of folds, by kind, each proved.

    Arguments are those of :func:`spragsym.folds`. Kinds are ``"cusp"``; ``"turn"``, a limit point
    of the curve: F = 0, det K = 0 and w · ∂F/∂v = 0 for the first parameter v, with w K = 0;
    ``"end"``, at either end of the range of v; and ``"border"``, where folds reach the border of a
    contact. With several contacts, points of all combinations of touching contacts are among them,
    and border points at the ends.
    """
    over, along = vary
    families = Family.every(p, vary, between, within, options)
    rest = {name: ends for name, ends in between.items() if name != over}
    with doing("cusps over {} and {}", *vary):
        found = cusps(p, vary, between=between, within=within, options=options)
    yield "cusp", found
    # If no state depends on one of the parameters, curves are straight along it.
    bends = set(vary) <= set(p.model.balanced)
    for one in families if bends else ():
        for block in blocks_of(one):
            yield "turn", isolated(one, turn(even_one(one, block), block), "turn")
    low, high = families[0].spans[0].tolist()
    for end in (low, high):
        value = p.ranges[over].reached(end, high - low)
        at_end = p.replace(**{over: value})
        yield "end", folds(at_end, along, between=rest, within=within, options=options)
    for one in families if bends else ():
        for contact in one.balance.opens:
            yield "border", isolated(one.beyond(contact), both(FOLD, touch(contact)), "border")


def border_extrema(family: Family, contact: int) -> Iterator[Points]:
    """Extreme values in the second parameter, and ends, of curves on which the gap of a touching
    contact is 0.
    """
    over, balance, near = family.vary[0], family.balance, family.beyond(contact)
    if over not in balance.balanced:
        return
    if _moves_border(near, contact):
        yield isolated(near, touch_turn(contact), "border")
    closed = [other for other in balance.opens if balance.indicators[other] and other > contact]
    for other in closed:  # the curve of one contact ends at that of another
        yield isolated(family.beyond(), both(touch(contact), touch(other)), "border")
    low, high = family.spans[0].tolist()
    for end in (low, high):
        value = family.p.ranges[over].reached(end, high - low)
        yield isolated(near.fixed(over, value), touch(contact), "border")


def _moves_border(near: Family, contact: int) -> bool:
    """Whether states at the gap 0 of a contact may depend on the first parameter.

    The contact's force is 0 there, so that the states are also those of the open contact, on which
    the stiffness of the contact has no effect.
    """
    balance, over = near.balance.across(contact), near.vary[0]
    if over in balance.angles or balance.springs:
        return True
    moved = variables([Intervals.point(np.full(1, 0.5))] * (balance.n + 1), 1)
    values = {**balance.over(near.over[:, :1]), over: moved[-1]}
    try:
        with quiet():
            at = balance.at(moved[:-1], values, (1,))
            rows = [*at.rows("forces"), at.gap(contact)]
    except ZeroDivisionError:  # a law that has no value there
        return True
    return not all(is_zero(gradient(row, balance.n + 1)[-1]) for row in rows)


def rows_of(family: Family, found: Points) -> FloatArray:
    """Coordinates and both parameters of points, shape (n + 2, points)."""
    names = (*family.balance.coordinates, *family.vary)
    return np.array([found[name] for name in names]).reshape(len(names), -1)


@dataclass(frozen=True)
class OnLines:
    """Points of a condition on lines, as ordered chains along curves.

    ``lines`` are the values of each parameter, ``undecided`` the undecided boxes on the lines, and
    ``whole`` whether the regions hold all equilibria.
    """

    curves: FoldCurves
    chains: list[FloatArray]
    lines: dict[str, FloatArray]
    undecided: FloatArray
    whole: bool
    remarks: tuple[str, ...]


def any_pair(one: FloatArray, _: FloatArray) -> BoolArray:
    """All pairs."""
    return np.ones(one.shape[1], dtype=bool)


def on_lines(
    family: Family,
    condition: Condition,
    n: int,
    more: FloatArray,
    apart: Iterable[float] = (),
    options: ContinuationOptions | None = None,
    alike: Alike = any_pair,
) -> OnLines:
    """All points of a condition on ``n`` lines of either parameter, joined to curves.

    ``more`` are further points of the curves. There will be a line of the first parameter between
    any two values of the second in ``apart``. Only neighbours that are ``alike`` are joined.
    """
    rows, left, lines, decided, whole, error = [], [], {}, {}, True, 0.0
    balance, vary, spans = family.balance, family.vary, family.spans
    families = list[Family]()
    for across in (1, 0):
        # Not at the ends of the range, which are often degenerate.
        low, high = spans[across]
        values = low + (high - low) * (np.arange(n) + 0.5) / n
        if across == 1:
            values = np.sort(np.append(values, _between(apart, spans[across], values)))
        lines[vary[across]] = values
        families.append(family.fixed(vary[across], values))
    effort = _effort(families, condition)
    for across, each in zip((1, 0), families, strict=True):
        values = lines[vary[across]]
        with doing("{} lines along {}", values.size, *each.vary):
            found = _on_each(each, condition, *effort)
        whole &= bool(found.whole.all())
        decided[across] = ~np.isin(np.arange(values.size), found.roots.undecided_point)
        error = max(error, found.roots.error.max(initial=0.0))
        rows.append(
            np.insert(found.roots.middle, balance.n + across, values[found.roots.point], axis=0)
        )
        line = values[found.roots.undecided_point]
        left.append(
            np.insert(found.roots.undecided, balance.n + across, Intervals.point(line).ends, axis=1)
        )
    states = np.concatenate([*rows, more], axis=1)
    undecided, remarks = listed(family, np.concatenate(left, axis=2))
    curves = FoldCurves(
        Augmented(family, condition),
        unknown_scales(states, spans, error),
        options or ContinuationOptions(),
        alike,
    )
    over_lines = [lines[name] for name in vary], [decided[k] for k in (0, 1)]
    with doing("curves through {} points", states.shape[1]):
        pairs = _pairs(states[balance.n :], *over_lines, spans)
        pairs = pairs[:, curves.alike(*(states[:, ends] for ends in pairs))]
        # From line to line distances in the parameters count most: coordinates get one scale, that
        # of the largest change.
        largest = np.append(np.full(balance.n, curves.scale[: balance.n].max()), curves.scale[-2:])
        coarse = replace(curves, scale=largest)
        chains = [states[:, places] for places in _chains(coarse, states, pairs)]
        # Neighbours may lie on different curves: these are separated before they are extended.
        parts = [piece for chain in chains for piece in curves.smooth(chain)]
        chains = [piece for chain in curves.joined(parts) for piece in curves.smooth(chain)]
    return OnLines(
        curves,
        chains,
        lines,
        undecided,
        whole,
        tuple(Remark("on lines: {}", text) for text in remarks),
    )


def unknown_scales(states: FloatArray, spans: FloatArray, error: float) -> FloatArray:
    """Scales of the unknowns: of coordinates their range over the states, of both parameters their
    ranges.

    ``states`` has the shape (n + 2, number), and ``error`` bounds their errors. A coordinate that
    hardly varies gets the scale of the others, so that branches which differ in it alone are still
    separated.
    """
    rows = states[: len(states) - 2]
    reach = np.ptp(rows, axis=1) if states.size else np.ones(len(rows))
    size = np.abs(rows).max(axis=1, initial=0.0)
    # These coordinates vary by rounding only.
    still = reach <= np.maximum(1e-9 * size, 1e3 * error * scale_of(size))
    usual = np.where(still, 0.0, reach).max(initial=0.0) or size.max(initial=1e-9)
    return np.append(np.where(still, usual, reach), np.ptp(spans, axis=1))


def _effort(families: Sequence[Family], condition: Condition) -> tuple[int, int]:
    """The budget of boxes for one line, and how many undecided lines are searched again one by one.

    Unless the options give a budget, four lines in the midst of the plane are tried. If nothing is
    found and nothing decided on any of them, the budget is a tenth and no line is searched again.
    """
    balance, usual = families[0].balance, 20_000
    budget = balance.options.budget
    if budget is None and balance.n <= 3:  # all lines take hardly longer than a few
        return usual, 4
    for part, lines in itertools.product((0.35, 0.65), families if budget is None else ()):
        line = [int(part * lines.given.shape[1])]
        roots = search(replace(lines, given=lines.given[:, line]), condition, usual).roots
        if roots.point.size or not roots.undecided_point.size:
            return usual, 4
    return (budget, 4) if budget else (usual // 10, 0)


def _on_each(lines: Family, condition: Condition, budget: int, tries: int) -> Found:
    """All points on lines, searched at once; lines with small undecided boxes are searched again
    one by one.

    A line with wide undecided boxes has spent its budget, and is not searched again. After
    ``tries`` failures in sequence the others are not either.
    """
    found = search(lines, condition, budget)
    roots, undecided = found.roots, 0
    boxes = roots.undecided
    wide = (width_of(boxes) > lines.balance.options.small * scale_of(boxes)).any(axis=(0, 1))
    spent = roots.undecided_point[wide]
    for line in np.setdiff1d(roots.undecided_point, spent)[:, None]:
        if undecided == tries:
            break
        alone = search(replace(lines, given=lines.given[:, line]), condition, budget).roots
        undecided = undecided + 1 if alone.undecided_point.size else 0
        roots = roots.of(line, others=True).concatenated(alone.numbered(line))
    return replace(found, roots=roots)


def _between(values: Iterable[float], span: FloatArray, lines: FloatArray) -> FloatArray:
    """Middles of the intervals between successive values of a range in which no line lies."""
    ends = np.unique([*span, *values])
    empty = np.searchsorted(lines, ends[:-1], "right") == np.searchsorted(lines, ends[1:], "left")
    return 0.5 * (ends[:-1] + ends[1:])[empty & (np.diff(ends) > ON_LINE * np.ptp(span))]


# ------------------------------------------------------------------------------------------------
# chains of points


def _pairs(
    places: FloatArray, lines: Sequence[FloatArray], decided: Sequence[BoolArray], spans: FloatArray
) -> IntArray:
    """Pairs of points that may be neighbours on a curve, shape (2, pairs), by their parameters.

    A curve has a known point where it crosses a ``decided`` line, so that such a line separates no
    neighbours. Among many points, only pairs at most two strips apart are taken.
    """
    bounds = [_strips(*each) for each in zip(places, lines, spans, strict=True)]
    one, other = _close(np.array([first for first, _ in bounds]))
    near = np.ones(one.size, dtype=bool)
    for (first, last), sure in zip(bounds, decided, strict=True):
        count = np.concatenate([[0], np.cumsum(sure)])
        begin = np.minimum(last[one], last[other])
        end = np.maximum(begin, np.maximum(first[one], first[other]))
        near &= count[begin] == count[end]
    return np.array([one[near], other[near]])


def _strips(places: FloatArray, lines: FloatArray, span: FloatArray) -> tuple[IntArray, IntArray]:
    """First and last strip between lines that holds each point; they differ for a point on
    a line.
    """
    tolerance = ON_LINE * np.ptp(span)
    first = np.searchsorted(lines, places - tolerance, "left").astype(int)
    return first, np.searchsorted(lines, places + tolerance, "right").astype(int)


def _close(cells: IntArray) -> IntArray:
    """All pairs of points; of many points, pairs that differ by at most two in both numbers of
    ``cells``, shape (2, points).
    """
    few = 2000  # all pairs of these fit into memory
    if cells.shape[1] <= few:
        return np.array(np.triu_indices(cells.shape[1], 1))
    from scipy.spatial import KDTree  # heavy, and few points do not need it

    pairs: IntArray = KDTree(cells.T).query_pairs(2.5, p=np.inf, output_type="ndarray").T
    return pairs


def _chains(folds: FoldCurves, states: FloatArray, pairs: IntArray) -> list[IntArray]:
    """Indices of points in order along curves.

    Each point is linked to at most one point ahead and one behind along its tangent. The best links
    of ``pairs``, shape (2, number), come first: short ones along both tangents.
    """
    count = states.shape[1]
    scaled, tangent = states / folds.scale[:, None], folds.tangents(states)
    one, other = pairs
    gap = scaled[:, other] - scaled[:, one]
    distance = np.linalg.norm(gap, axis=0)
    ahead = np.array([(gap * tangent[:, one]).sum(axis=0), (-gap * tangent[:, other]).sum(axis=0)])
    with quiet():
        straight = np.abs(ahead) / distance
        cost = (distance / straight**2).sum(axis=0)
    near = (straight > 0.5).all(axis=0) & (distance > 1e-12)
    # Side 0 of a point lies ahead along its tangent, side 1 behind; each takes one link, the
    # nearest pairs first.
    cost, one, other, *sides = np.array([cost, one, other, *np.where(ahead > 0, 0, 1)])[:, near]
    links: list[set[int]] = [set() for _ in range(count)]
    free = np.ones((count, 2), dtype=bool)
    order = np.lexsort((other, one, cost))
    for ends in np.array([one, sides[0], other, sides[1]])[:, order].T.astype(int).tolist():
        ports = (ends[0], ends[1]), (ends[2], ends[3])
        if free[ports[0]] and free[ports[1]]:
            link(links, [(ends[0], ends[2])])
            free[ports[0]] = free[ports[1]] = False
    return walked(links)


@dataclass(frozen=True)
class FoldCurves:
    """Curves of a defining system in the plane of two parameters, with scales of its unknowns."""

    system: Augmented
    scale: FloatArray
    options: ContinuationOptions
    #: Which pairs of points may be neighbours, where curves cross.
    alike: Alike

    @property
    def spans(self) -> FloatArray:
        """Ranges of both parameters, shape (2, 2)."""
        return self.system.family.spans

    def smooth(self, states: FloatArray) -> list[FloatArray]:
        """A chain, shape (n + 2, number), refined by points between neighbours until it is smooth.

        It is split where neighbours turn out to lie on different curves.
        """
        off = np.full(states.shape[1] - 1, np.nan)
        for left in range(self.options.refinements, -1, -1):
            rows = np.flatnonzero(np.isnan(off))
            found, off[rows], bent = self._between(states[:, rows], states[:, rows + 1])
            more = (bent | (off[rows] > self.options.deviation)) & self._in_range(found)
            chord = (states[:, rows + 1] - states[:, rows]) / self.scale[:, None]
            more[more] = self._proved(found[:, more], chord[:, more], off[rows][more])
            if not left or not more.any():
                break
            rows = rows[more]
            off[rows] = np.nan
            states = np.insert(states, rows + 1, found[:, more], axis=1)
            off = np.insert(off, rows + 1, np.nan)
        return np.split(states, np.flatnonzero(off > self.options.deviation) + 1, axis=1)

    def _between(
        self, one: FloatArray, two: FloatArray
    ) -> tuple[FloatArray, FloatArray, BoolArray]:
        """Points half-way between pairs of points, by Newton's method from the Hermite cubic; not
        proved.

        Also returns their distances from the cubic, over those of the pairs, infinite where
        Newton's method fails; and whether the curve is bent in the plane of the parameters.
        """
        middle, chord, length = self._cubic(one, two, 0.5)
        with quiet():
            found = self._projected(middle * self.scale[:, None], chord / length)
            off = np.linalg.norm(found / self.scale[:, None] - middle, axis=0) / length
        off = np.where(length > 0, np.nan_to_num(off, nan=np.inf), 0.0)
        strays = ~(self.alike(one, found) & self.alike(found, two))  # onto another curve
        found, off = np.where(strays, np.nan, found), np.where(strays, 0.0, off)
        off = np.where(self.alike(one, two), off, np.inf)
        centre = 0.5 * (one + two) / self.scale[:, None]
        bent = np.linalg.norm((middle - centre)[-2:], axis=0) > self.options.smoothness
        return found, off, bent & (length > 0)

    def _cubic(
        self, one: FloatArray, two: FloatArray, share: float | FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Points on the Hermite cubics between pairs of points, at a share of the way, with the
        chords and their lengths; all over the scales.
        """
        start, end = (states / self.scale[:, None] for states in (one, two))
        chord = end - start
        length = np.linalg.norm(chord, axis=0)
        ahead, behind = (
            part * np.sign((part * chord).sum(axis=0)) * length
            for part in (self.tangents(one), self.tangents(two))
        )
        rest = 1.0 - share
        straight = start + share**2 * (3.0 - 2.0 * share) * chord
        return straight + share * rest * (rest * ahead - share * behind), chord, length

    def joined(self, chains: Sequence[FloatArray]) -> list[FloatArray]:
        """Chains extended at both ends: to the end of a range, or to the end of another chain,
        which is then part of it.
        """
        left, out = list(chains), list[FloatArray]()
        while left:
            chain = left.pop(0)
            for side in (1, -1):
                on = True
                while on and not (chain.shape[1] > 2 and (chain[:, 0] == chain[:, -1]).all()):
                    chain, on = self._beyond(chain, (left, out), side)
                chain = chain[:, ::-1]
            out.append(chain)
        return out

    def _beyond(
        self, chain: FloatArray, groups: Sequence[list[FloatArray]], side: int
    ) -> tuple[FloatArray, bool]:
        """A chain extended at its last point by pseudo-arclength continuation, and whether it has
        reached its own beginning or another chain.

        The other chain is appended, and removed from its group.
        """
        ahead = [
            (others, k, other[:, ::way])
            for others in groups
            for k, other in enumerate(others)
            for way in (1, -1)
        ]
        ahead += [([chain], 0, chain[:, :1])] if chain.shape[1] > 2 else []
        firsts = np.array([further[:, 0] for *_, further in ahead]).reshape(-1, len(self.scale)).T
        path, end, pace = [chain], chain[:, -1], self.options.pace
        before = chain[:, -2] if chain.shape[1] > 1 else None
        for _ in range(self.options.paces):
            along = self.tangents(end[:, None])[:, 0]
            along = along * (
                side if before is None else np.sign(along @ ((end - before) / self.scale))
            )
            start, stop = self._within(end, end + pace * along * self.scale)
            # Newton's method in the plane across the step or, at an end of a range, at that value.
            normal = along if stop is None else np.eye(len(end))[stop]
            found, good = self.on_curve(start[:, None], normal[:, None], np.array([pace]))
            if stop is not None:
                found[stop] = start[stop]
            if (
                not (good[0] and self._in_range(found)[0])
                or abs(self.tangents(found)[:, 0] @ along) < self.options.turn
                or self._between(end[:, None], found)[1][0] > self.options.deviation
            ):
                pace *= 0.5
                if pace < self.options.least_pace:
                    break
                continue
            met = np.flatnonzero(self._lie_between(firsts, end[:, None], found))
            if met.size:
                others, k, further = ahead[met[0]]
                del others[k]
                return np.concatenate([*path, further], axis=1), True
            path.append(found)
            if stop is not None:
                break
            before, end, pace = end, found[:, 0], 1.5 * pace
        return np.concatenate(path, axis=1), False

    def _within(self, end: FloatArray, to: FloatArray) -> tuple[FloatArray, int | None]:
        """The point ``to``, or that on the way to it at which a parameter reaches the end of its
        range, and the index of this parameter.
        """
        way, (low, high) = to - end, self.spans.T
        last = np.where(way[-2:] > 0, high, low)
        with quiet():
            share = np.where(
                (way[-2:] != 0) & (last != end[-2:]), (last - end[-2:]) / way[-2:], np.inf
            )
        number = int(share.argmin())
        if not share[number] <= 1:
            return to, None
        start, slot = end + share[number] * way, len(end) - 2 + number
        start[slot] = last[number]
        return start, slot

    def _lie_between(self, points: FloatArray, one: FloatArray, two: FloatArray) -> BoolArray:
        """Mask of the points that lie on the curve between two of its points, or at the second, and
        have the same direction.
        """
        chord, away = (two - one) / self.scale[:, None], (points - one) / self.scale[:, None]
        length = norm(chord[:, 0])
        share = (away * chord).sum(axis=0) / length**2
        lie = (1e-9 < share) & (share <= 1 + 1e-6)
        lie[lie] = self.alike(np.repeat(one, lie.sum(), axis=1), points[:, lie])
        lie[lie] = np.linalg.norm(away[:, lie] - share[lie] * chord, axis=0) <= 0.5 * length
        if lie.any():
            off = self._cubic(one, two, share[lie])[0] - points[:, lie] / self.scale[:, None]
            alike = np.abs((self.tangents(points[:, lie]) * chord).sum(axis=0))
            lie[lie] = (np.linalg.norm(off, axis=0) <= 2 * self.options.deviation * length) & (
                alike >= self.options.turn * length
            )
        return lie

    def tangents(self, states: FloatArray) -> FloatArray:
        """Unit tangents of the curve, over the scales; 0 where there is none."""
        slopes = np.moveaxis(
            self._slopes(Intervals.point(states)).middle * self.scale[None, :, None], -1, 0
        )
        finite: BoolArray = np.logical_and.reduce(np.isfinite(slopes), axis=(1, 2))
        *_, rows = np.linalg.svd(np.where(finite[:, None, None], slopes, 0.0))
        return rows[:, -1].T * finite

    def on_curve(
        self, start: FloatArray, normal: FloatArray, near: FloatArray
    ) -> tuple[FloatArray, BoolArray]:
        """Points of the curve in planes through ``start`` with the given normals, and which are
        proved.

        Normals are over the scales. A point farther than half of ``near`` from ``start`` is not
        proved, and points may lie beyond the ranges.
        """
        states = self._projected(start, normal)
        with quiet():
            off = np.linalg.norm((states - start) / self.scale[:, None], axis=0) / near
        return states, self._proved(states, normal, off)

    def _proved(self, states: FloatArray, normal: FloatArray, off: FloatArray) -> BoolArray:
        """Mask of states that are proved to be next to a point of the curve in contact.

        The unknown of the largest component of the normal keeps its value. States whose distance
        ``off`` from the prediction exceeds one half are not proved.
        """
        good = off <= 0.5
        good[good] = self.enclosed(states[:, good], np.abs(normal[:, good]).argmax(axis=0))[1]
        return good

    def _projected(self, start: FloatArray, normal: FloatArray) -> FloatArray:
        """Points of the curve in planes through ``start`` with the given normals, by Newton's
        method.
        """
        states, scale, given = start, self.scale[:, None], self.system.fixed(start.shape[1])
        rows, off = np.empty((len(scale), *start.shape)), np.empty(start.shape)
        rows[-1] = normal
        with quiet():
            for _ in range(self.options.newton_steps):
                at = Intervals.point(states)
                rows[:-1] = self.system.jacobian(at, given).middle * scale
                off[:-1] = self.system.residuals(at, given).middle
                off[-1] = (normal * (states - start) / scale).sum(axis=0)
                step = (contractors.inverse(rows) * off).sum(axis=1) * scale
                states = states - step
                if (np.abs(step) <= 1e-14 * np.abs(states)).all():  # rounding is what is left
                    break
        return states

    def _in_range(self, states: FloatArray) -> BoolArray:
        """Mask of the states with both parameters in their ranges."""
        low, high = self.spans[:, :1], self.spans[:, 1:]
        return np.logical_and.reduce((low <= states[-2:]) & (states[-2:] <= high), axis=0)

    def enclosed(self, states: FloatArray, fixed: IntArray) -> tuple[FloatArray, BoolArray]:
        """Boxes around points of the curve, shape (2, n + 2, N), and which are proved to hold one
        in contact.

        ``fixed`` is, for each point, the index of the unknown that keeps its value.
        """
        count, columns = len(self.scale), np.arange(states.shape[1])
        free = (
            np.array([np.delete(np.arange(count), index) for index in fixed], dtype=int)
            .reshape(-1, count - 1)
            .T
        )
        radius = self.options.half_width * scale_of(states)
        radius[fixed, columns] = 0.0
        wide = ends_around(states, radius)
        slopes = self._slopes(Intervals(wide)).ends[:, :, free, columns]
        reach = contractors.distance(wide, states)[free, columns]
        parameters = self.system.fixed(states.shape[1])
        values = self.system.residuals(Intervals.point(states), parameters)
        step = contractors.newton(values, Intervals(slopes), states[free, columns], reach)
        closed = on_side(self.system, parameters, wide)[0]
        good = closed & contractors.inside(step.ends, wide[:, free, columns])
        wide[:, free, columns] = np.fmin(step.ends, wide[:, free, columns])
        return wide, good

    def _slopes(self, states: Intervals) -> Intervals:
        """The Jacobian of the system over boxes of states."""
        with quiet():
            return self.system.jacobian(states, self.system.fixed(states.shape[1]))
