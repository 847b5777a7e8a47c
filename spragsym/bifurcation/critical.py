"""The critical load: the least value of one parameter at which the followed state ends, over a
range of another.

Candidates are isolated: cusps, limit points of curves of folds and of borders, and ends of the
range. At each of them, in ascending order, the state is followed to decide whether it ends there.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from contextlib import nullcontext, suppress
from dataclasses import dataclass, replace

import numpy as np

from ..core.errors import ConvergenceError, ParameterError, one_of
from ..core.progress import doing
from ..core.questions import Method, question
from ..core.remarks import At, Remark
from ..models.parameters import FloatArray, ParameterSet, Ranges, as_ranges, varied_range
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import scale_of
from ..results import CriticalLoad, Equilibria, Points
from ..statics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.reference_state import nearest_state, reference_place, reference_state
from ..statics.search import balances_of, number_of, of_ranges
from .bifurcation_sets import border_extrema, extrema
from .crossings import border_arrivals, followed_across
from .defining_systems import Family, given_column
from .folds import cusps, folds
from .paths import ModelEnd, first_end
from .points import escapes
from .tubes import Tubes


@dataclass(frozen=True)
class _Candidate:
    """A value of ``vary`` at which the state may end, with the value ``where`` of ``over``."""

    value: float
    where: float
    kind: str
    error: float

    def ties(self, other: _Candidate) -> bool:
        """Whether the two values are equal to within four times their error bounds."""
        return abs(self.value - other.value) <= 4.0 * (self.error + other.error) * max(
            1.0, abs(self.value)
        )


@question
def critical_friction(
    p: ParameterSet,
    vary: str | None = None,
    over: str | None = None,
    *,
    between: Ranges | None = None,
    method: Method = "auto",
) -> CriticalLoad:
    """The least friction, over all inclinations, at which the followed state ends; or the least
    ``vary`` over all values of ``over``.

    Below it the state, followed from the lower end of ``vary`` at any ``over``, goes on; other
    states may meet in folds there. It may lie below the lowest cusp, since a curve of folds that
    rises from its cusp may turn back; see :func:`cusp_friction`. Where it is the lower end itself,
    as 0 for the article's model with α = 0 and κ < 1 + β, it is an infimum: the state ends at
    values as near to it as one likes, and not at it.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; arrays too with closed forms. The values of the two that vary are not
        used.
    vary, over : str, optional
        Two parameters: that along which the state is followed, by default mu0, and that over whose
        range the least value is taken, by default theta0.
    between, method
        Their ranges, and the method, as for :func:`spragsym.folds`.

    Returns
    -------
    CriticalLoad
        Usable as the number or array ``mu0``, with its angle, kind and error; infinite if no fold
        ends the state.

    Raises
    ------
    ParameterError
        For parameters that are missing.
    ConvergenceError
        At parameters of the article's model so near to a coincidence that 6144 bits do not separate
        them from it.

    Notes
    -----
    The followed state is the reference state at the lower ends of both ranges, and what it becomes
    along ``over`` there, proved by tubes; at another value of ``over`` another state may be the
    reference state, which :func:`spragsym.jump_value` follows. It may end on curves of folds, and
    on curves on which a contact is lost or regained. The least value on a piece of these curves is
    at a cusp; at a limit point of the curve, F = 0, det K = 0, w · ∂F/∂over = 0 with w K = 0; where
    the piece ends on a border; or at an end of the range of ``over``. All of these are isolated. In
    ascending order, the state is followed along ``vary`` at each of them, to decide whether it ends
    there. Below the first one at which it ends, no piece begins on which it could end. The
    article's model: :mod:`spragsym.kang_nam.lowest_fold`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> found = ss.critical_friction(ss.Parameters.article())
    >>> print(found, found.kind, np.degrees(found.theta0).round(6))
    0.20093178180509003 cusp 68.020959
    >>> p = ss.load("inclined_belt").Parameters()
    >>> found = ss.critical_friction(p, between={"mu0": (0.0, 0.5)})
    >>> round(found.mu0, 6), found.kind, found.complete
    (0.207376, 'cusp', True)
    """
    vary, over = p.model.rising_over(vary, over)
    if not isinstance(vary, str) or not isinstance(over, str) or vary == over:
        raise ParameterError(f"vary = {vary!r}, over = {over!r}; give two different parameters")
    search_of = _CandidateSearch(p, vary, over, between)
    try:
        found = search_of.lowest()
    except ConvergenceError as error:
        (why,) = error.args  # a remark keeps its units
        return CriticalLoad(
            vary, over, search_of.low, math.nan, "undecided", math.nan, False, (why,)
        )
    remarks, open_from = search_of.remarks, search_of.open_from
    if found.value > open_from:
        # A smaller range, up to the known end or a part of what has no end, may be decided.
        least, size = search_of.low, search_of.high - search_of.low
        part = 0.1 * size if vary in search_of.endless else math.inf
        part = min(part, 1.1 * (found.value - least))
        if part < 0.9 * size:
            smaller = {**(between or {}), vary: (least, least + part)}
            again = critical_friction(p, vary, over, between=smaller)
            if math.isfinite(again.value) and again.kind != "undecided":
                return again
        text = (
            "candidates from {} on are not all decided: the state may end there; ss.certify(p, "
            "'no jump', between=…) may prove for a range that it does not"
        )
        remarks.append(Remark(text, At(vary, (open_from,), ".6g")))
        if math.isfinite(found.value):
            text = f"it ends at the {found.kind} at {{}}, {{}}, if not before"
            unit = "rad" * p.model.is_angle(over)
            ends = At(vary, (found.value,), ".6g"), At(over, (found.where,), ".6g", unit)
            remarks.append(Remark(text, *ends))
        found = _Candidate(open_from, math.nan, "undecided", math.nan)
    cut = [name for name in search_of.endless if name == over or not math.isfinite(found.value)]
    # Combinations of contacts may share remarks.
    remarks = list(dict.fromkeys([*remarks, *of_ranges(cut, (over, vary), search_of.spans)]))
    complete = not remarks and found.kind != "undecided"
    return CriticalLoad(
        vary, over, found.value, found.where, found.kind, found.error, complete, tuple(remarks)
    )


def lowest_of_followed(p: ParameterSet, *, method: Method = "auto") -> CriticalLoad:
    """:func:`critical_friction` of the state that is followed at the inclination of ``p``, if that
    has a value: ConvergenceError where another one is followed from the least inclination on.
    """
    found = critical_friction(p, method=method)
    vary, over = p.model.rising_over(None, None)
    if found.kind == "undecided" or p[over] is None:
        return found
    search_of, place = _CandidateSearch(p, vary, over, None), float(p[over])
    first = float(search_of.spans[0, 0])
    search_of.begin([first, place])
    eq, slot = search_of.begun_at(place)
    if slot != reference_state(eq, p.followed):
        unit = "rad" * p.model.is_angle(over)
        ends = (At(over, (value,), ".6g", unit) for value in (first, place))
        raise ConvergenceError(Remark("at {} another state is followed than at {}", *ends))
    return found


@question
def cusp_friction(
    p: ParameterSet,
    vary: str | None = None,
    over: str | None = None,
    *,
    between: Ranges | None = None,
    method: Method = "auto",
) -> float | FloatArray:
    """The least friction at a cusp in the plane of friction and inclination, or of ``vary`` and
    ``over``; infinite without a cusp.

    Whether a state can end is decided by :func:`critical_friction`, since folds may lie below their
    cusps.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars or arrays; the two that vary are not used.
    vary, over, between, method
        As for :func:`critical_friction`.

    Returns
    -------
    float or ndarray
        Of the shape of the parameters that are used.

    Raises
    ------
    ParameterError
        For parameters that are missing.
    ConvergenceError
        If a lower cusp is not excluded, or none is found in the searched part of an infinite range.

    Notes
    -----
    Source: :func:`spragsym.cusps`. Beyond the searched part of a range there may be other cusps,
    but no lower ones.

    Examples
    --------
    >>> import spragsym as ss
    >>> print(ss.cusp_friction(ss.Parameters.article()))
    0.20093178180509003
    """
    vary, over = p.model.rising_over(vary, over)
    used = [name for name in p.ranges if name not in (vary, over) and p[name] is not None]
    shape = np.broadcast_shapes(*(p[name].shape for name in used))
    columns = {name: np.broadcast_to(p[name], shape) for name in used}
    points = (p.replace(**selected_rows(columns, index)) for index in np.ndindex(shape))
    found = [_lowest_cusp(point, vary, over, between) for point in points]
    return np.reshape(found, shape) if shape else found[0]


def _lowest_cusp(p: ParameterSet, vary: str, over: str, between: Ranges | None) -> float:
    """The least value of ``vary`` at a cusp, at one point; ConvergenceError if a lower one is
    possible.
    """
    found = cusps(p, (over, vary), between=between)
    inside = np.logical_and(*(p.ranges[name].inside(found[name]) for name in (vary, over)))
    value = float(found[vary][inside].min(initial=math.inf))
    if (
        _least_left(found, vary) < value
        or not found.whole
        or (not math.isfinite(value) and found.endless)
    ):
        where = f", the lowest of those at {vary} = {value:.12g}" if len(found) else ""
        raise ConvergenceError(
            f"{len(found)} cusps were found{where}; whether there is a lower one: "
            f"{'; '.join(found.remarks)}"
        )
    return value


def _least_left(found: Points, vary: str) -> float:
    """The least value of a varying parameter in undecided boxes; infinite without any."""
    ends = found.undecided[:, found.vary.index(vary) - len(found.vary), 0]
    return float(ends.min(initial=math.inf))


@question
def critical_value(
    p: ParameterSet,
    vary: str,
    *,
    between: Ranges,
    along: str | None = None,
    over: str | None = None,
    method: Method = "auto",
) -> float:
    """The value of a parameter at which :func:`critical_friction` equals the friction of ``p``.

    On one side of this value the state jumps at no inclination.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars with ``mu0``; the value of the parameter that varies is not used.
    vary : str
        The parameter to change.
    between : mapping
        Its range, with :func:`critical_friction` above the friction of ``p`` at one end and below
        at the other; ranges of the other two parameters as for :func:`critical_friction`.
    along, over : str, optional
        As ``vary`` and ``over`` of :func:`critical_friction`.
    method : str, optional
        As for :func:`critical_friction`.

    Returns
    -------
    float
        With a relative error of 1e-13.

    Raises
    ------
    ParameterError, ParameterTypeError
        For a parameter that can't change, a range with the critical friction on one side of that of
        ``p``, and parameters that are no scalars.
    ConvergenceError
        If the critical friction is undecided at a value in between.

    Notes
    -----
    Source: a root of :func:`critical_friction` minus the value of ``p``, by Brent's method.

    Examples
    --------
    >>> import spragsym as ss
    >>> print(f"{ss.critical_value(ss.Parameters.article(), 'beta', between={'beta': (1, 2)}):.9f}")
    1.632329272
    """
    from scipy.optimize import brentq

    rising, over = p.model.rising_over(along, over, "along")
    for argument, name in (("along", rising), ("over", over)):
        one_of(argument, name, p.model.parameters)
    if vary not in p.ranges or vary in (rising, over):
        others = ", ".join(name for name in p.ranges if name not in (rising, over))
        raise ParameterError(
            f"vary = {vary!r} can't be what changes where {rising} rises over {over}; choose "
            f"one of {others}"
        )
    (level,) = p.scalars(rising)
    allowed = {name: p.model.any_of(name) for name in (vary, rising, over)}
    given = as_ranges("between", between, allowed)
    own = {vary: given.pop(vary)} if vary in given else {}
    low, high = varied_range(vary, own, p.ranges[vary])

    def lowest(value: float) -> float:
        with doing("lowest end at {} = {:.6g}", vary, value):
            found = critical_friction(p.replace(**{vary: value}), rising, over, between=given)
        if found.kind == "undecided":
            raise ConvergenceError(
                f"at {vary} = {value:.12g} the lowest end is undecided: {'; '.join(found.remarks)}"
            )
        return float(found.value)

    def excess(value: float) -> float:
        return math.atan(lowest(value)) - math.atan(level)  # finite where there is no fold

    if excess(low) * excess(high) > 0:
        ends = ", ".join(
            f"{_in_words(lowest(value))} at {vary} = {value:g}" for value in (low, high)
        )
        raise ParameterError(
            f"between: the critical {rising} is {ends}, both on one side of {rising} = "
            f"{level:g}; widen it"
        )
    root = float(brentq(excess, low, high, xtol=1e-300, rtol=8.9e-16, maxiter=1000))
    if abs(excess(root)) > 1e-9:
        below, above = (
            lowest(max(float(np.nextafter(root, end)), p.ranges[vary].low))
            for end in (-math.inf, math.inf)
        )
        raise ConvergenceError(
            f"the critical {rising} jumps across {level:g} at {vary} = {root:.12g}, from "
            f"{_in_words(below)} to "
            f"{_in_words(above)}: there it has no value between; try a range on one side"
        )
    return root


def _in_words(value: float) -> str:
    """A critical value as text."""
    return "infinite (there is no fold)" if math.isinf(value) else f"{value:.6g}"


def carried(
    balance: Balance,
    p: ParameterSet,
    name: str,
    values: FloatArray,
    q: FloatArray,
    error: float,
) -> FloatArray:
    """The state at a monotonic sequence of values of a parameter, shape (n, values), proved by
    tubes.

    ``q`` is the state at the first value, with an ``error`` relative to max(1, |coordinate|).
    """
    tubes = Tubes.of_points(balance, name, given_column(p, balance.parameters, (name,)))
    here = tubes.place(np.append(q, values[0])[:, None], error=error)
    states = [q]
    for value in values[1:].tolist():
        tubes, here = followed_across(tubes, here, np.array([value]))
        if not here.proved[0] or here.v[0] != value:
            text = "the state can't be followed from {} to {}: it is lost beyond {}"
            ends = [float(values[0]), float(values[-1]), float(here.v[0])]
            for end in border_arrivals(tubes, here, np.array([value])):  # none that passes is left
                text = "the state that is followed from {} does not reach {}: it ends at {}"
                text += ", where a contact is lost or regained"
                ends[2] = float(end.z[-1, 0])
            unit = "rad" * p.model.is_angle(name)
            text += f"; give between with a range of {name} on one side"
            raise ConvergenceError(Remark(text, *(At(name, (end,), ".6g", unit) for end in ends)))
        states.append(here.z[:-1, 0])
    return np.stack(states, axis=1)


class _CandidateSearch:
    """The search for the critical load: its candidates, and whether the state ends at each."""

    def __init__(self, p: ParameterSet, vary: str, over: str, between: Ranges | None) -> None:
        families = Family.every(p, (over, vary), between)
        self.p, self.vary, self.over, self.spans = p, vary, over, families[0].spans.copy()
        for span, name in zip(self.spans, (over, vary), strict=True):
            span[:] = [p.ranges[name].reached(float(end), span[1] - span[0]) for end in span]
        self.endless = families[0].endless
        self.families = [replace(one, spans=self.spans) for one in families]
        self.low, self.high = map(float, self.spans[1])
        #: For values of ``over``, up to where the state was followed, and its end.
        self.followed = dict[float, tuple[float, ModelEnd | None]]()
        #: From this value on candidates may be missing; and remarks on what is not proved.
        self.open_from, self.remarks = math.inf, list[str]()

    def lowest(self) -> _Candidate:
        """The lowest candidate at which the followed state ends; of infinite value if it ends at
        none.
        """
        candidates = self.candidates()
        first, last = self.spans[0].tolist()
        sides = itertools.chain(*(self.beside(one) for one in candidates))
        places = {first, last, *itertools.chain(*sides)}
        self.begin(sorted(value for value in places if first <= value <= last))
        for one in candidates:
            above = (k.value for k in candidates if k.value > one.value and not k.ties(one))
            limit = min(above, default=self.high)
            if one.value >= self.high:
                break
            with doing(
                "whether the state ends at the {} at {} = {:.6g}", one.kind, self.vary, one.value
            ):
                outcome = self.ends_at(one, limit)
            if outcome is None:
                at = At(self.over, (one.where,), ".6g")
                self.remarks.append(
                    Remark(f"whether the state ends at the {one.kind} at {{}} is not decided", at)
                )
                return replace(one, kind="undecided")
            if outcome:
                return one
        return _Candidate(math.inf, math.nan, "", 0.0)

    def candidates(self) -> list[_Candidate]:
        """All candidates, ascending by value."""
        found: list[_Candidate] = []
        for kind, points in self.points():
            columns = (one.tolist() for one in (points[self.vary], points[self.over], points.error))
            found += [
                _Candidate(value, where, kind, error)
                for value, where, error in zip(*columns, strict=True)
            ]
            self.open_from = min(self.open_from, _least_left(points, self.vary))
            if not points.whole:
                self.remarks.append(
                    f"of the kind {kind} not all states are known to lie in what was searched"
                )
        return sorted(found, key=lambda one: one.value)

    def points(self) -> Iterator[tuple[str, Points]]:
        """Limit points and ends of curves of folds, and of the borders of contacts, by kind."""
        both, whole = (self.over, self.vary), True
        between = dict(zip(both, map(tuple, self.spans.tolist()), strict=True))
        for kind, points in extrema(self.p, both, between):
            whole &= points.whole and bool(np.isfinite(points.region).all())
            if kind == "cusp":  # the first kind
                found = points
            # A cusp that points along ``over`` is a limit point too, and counts once.
            yield kind, self._elsewhere(points, found) if kind == "turn" else points

        for family in self.families:
            if not whole:
                yield "infinity", escapes(family)
                for end in self.spans[0].tolist():
                    yield "infinity", escapes(family.fixed(self.over, end))
            for contact in family.balance.opens:
                if family.balance.indicators[contact]:
                    for points in border_extrema(family, contact):
                        yield "border", points

    def _elsewhere(self, points: Points, others: Points) -> Points:
        """The points that differ from all ``others`` by more than their error bounds."""
        names = (*self.p.model.coordinates, *points.vary)
        here, there = (np.array([each[name] for name in names]) for each in (points, others))
        off = np.abs(here[:, :, None] - there[:, None]) / scale_of(here[:, :, None])
        apart = off.max(axis=0) > 4.0 * (points.error[:, None] + others.error)
        return points.select(apart.all(axis=1))

    def beside(self, one: _Candidate) -> list[list[float]]:
        """Values of ``over`` at which to decide whether the state ends at a candidate.

        For a cusp these are pairs of values on either side, ever nearer to it.
        """
        length = float(np.ptp(self.spans[0]))
        if one.kind != "cusp":
            return [[one.where]]
        distances = (share * length for share in (1e-3, 1e-4, 1e-5))
        return [[one.where - distance, one.where + distance] for distance in distances]

    def begin(self, places: list[float]) -> None:
        """Compute the states at the lower end of ``vary``, at all values of ``over`` where they are
        followed.
        """
        here = self.p.replace(**{self.vary: self.low})
        where = (
            f"at {self.over} = {places[0]:.6g}, {self.vary} = {self.low:.6g} is known to be stable"
        )
        first, touching, error = reference_place(
            here.replace(**{self.over: places[0]}), self.p.followed, where
        )
        balances = balances_of(self.p.model)
        balance = balances[number_of(balances, touching)]
        states = carried(balance, here, self.over, np.array(places), first, error)
        self.beginning = dict(zip(places, states.T, strict=True))

    def begun_at(self, value: float) -> tuple[Equilibria, int]:
        """The equilibria at the lower end of ``vary`` at one value of ``over``, and the slot of the
        state.
        """
        eq = equilibria(self.p.replace(**{self.over: value, self.vary: self.low}))
        near = dict(zip(self.p.model.coordinates, self.beginning[value], strict=True))
        return eq, int(nearest_state(eq, near))

    def end_at(self, value: float, limit: float) -> ModelEnd | None:
        """The end of the state at one value of ``over``, below a limit; None if it does not end."""
        reached, end = self.followed.get(value, (self.low, None))
        if end is None and reached < limit:
            # Of many candidates at one value, as after each turn of an angle, few are followed to.
            ahead = limit + (limit - self.low) * (reached > self.low)
            for reached in sorted({limit, min(ahead, self.high)}, reverse=True):
                with suppress(ConvergenceError) if reached > limit else nullcontext():
                    end = self._first_end(value, reached)
                    break
            self.followed[value] = reached, end
        return end if end is not None and end.value <= limit else None

    def _first_end(self, value: float, limit: float) -> ModelEnd | None:
        """The end of the state at one value of ``over``, followed up to a limit."""
        here, (_, slot) = self.p.replace(**{self.over: value}), self.begun_at(value)
        return first_end(here, self.vary, (self.low, limit), start=slot)

    def ends_at(self, one: _Candidate, above: float) -> bool | None:
        """Whether the state ends at a candidate; None if that is undecided. It ends at no lower
        one.

        At a cusp its two folds are sought beside it: up to the next candidate ``above`` no other
        piece of a curve begins.
        """
        # States are followed a little beyond the candidate.
        limit = min(one.value + 0.05 * max(1.0, abs(one.value)), self.high)
        try:
            if one.kind != "cusp":
                end = self.end_at(one.where, limit)
                return end is not None and _Candidate(end.value, one.where, "", end.error).ties(one)
            limit = min(limit, 0.5 * (one.value + above))
            for sides in self.beside(one):
                counts = [self.folds_below(side, limit) for side in sides if side in self.beginning]
                if len(counts) == 2 and abs(counts[0] - counts[1]) == 2:
                    return self.end_at(sides[int(np.argmax(counts))], limit) is not None
        except ConvergenceError:
            pass
        return None

    def folds_below(self, value: float, limit: float) -> int:
        """The number of folds below a limit at one value of ``over``."""
        found = folds(
            self.p.replace(**{self.over: value}), self.vary, between={self.vary: (self.low, limit)}
        )
        if not found.decided:
            raise ConvergenceError("folds beside a cusp are not all decided")
        return len(found)
