"""Edge tracking by bisection: the value of a parameter at which the motion from a given start
changes its fate, and the edge state (saddle) at which it hovers there.

Fates are sampled at values of the parameter (:class:`_FateSamples`), and labelled: equal labels are
the same attractor, continued from one value to the other. A bracket between two labels is narrowed
by bisection (:class:`_Bracket`). It is accepted as a boundary if both attractors exist on both
sides (:func:`_boundary`). The same bracket is found again with a finer tolerance and a shifted
start, which gives the error. The motions at both ends of the last bracket stay together until they
leave the saddle (:func:`_saddle`).
"""

from __future__ import annotations

import math
import time
from bisect import insort
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from itertools import pairwise

import numpy as np

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError
from ..core.progress import doing
from ..core.questions import model_of
from ..models.field import Field
from ..models.parameters import FloatArray, ParameterSet, Ranges, varied_range
from ..motion.options import MotionOptions
from ..motion.regimes import Outcome
from ..motion.scales import MotionScales
from ..motion.simulation import Start, state_of
from ..numerics.vectors import magnitude, state_difference
from ..results.result import Result
from .branch import cycle_branch
from .events import MERGES
from .finding import (
    Attractor,
    attractor,
    cycle_at,
    followed,
    followed_cycle,
    returns,
    same,
)
from .orbit import distance, same_cycle
from .system import (
    FateVerdict,
    Saddle,
    System,
    growth_of_cycle,
    judged,
    saddle_near,
    verified,
)


@dataclass(frozen=True, eq=False)
class FateBoundary(Result):
    """The value of a parameter at which a motion changes its fate, and the edge state there.

    Both attractors exist on both sides of the value: each was continued to the other side, and is
    stable there. If an attractor itself ends or loses its stability, that is an event of its
    branch, and no boundary.

    Attributes
    ----------
    vary : str
        The parameter.
    value : float
        Its value at the boundary.
    error : float
        Error estimate: width of the last bracket, plus twice the changes of the value by a
        tolerance ten times as small and by a start shifted by that.
    saddle : str
        "equilibrium" or "cycle", if its eigenvalues or multipliers with their errors show exactly
        one unstable direction; else "unknown".
    state : ndarray, shape (m,)
        State of the saddle; of a cycle the one with the largest first coordinate. If unknown, the
        state at which the motions begin to diverge.
    growth : float
        Unstable eigenvalue of the saddle, or for a cycle ln |μ| / T; NaN if unknown.
    distance : float
        Smallest distance of the motion from the saddle, in units of the motion.
    below, above : Outcome
        Limits of the motion on either side.
    others : ndarray, shape (k, 2)
        Other intervals within the range, among the sampled values, whose ends have different fates.
        They may differ between several fates of one side: an irregular transient ends anywhere.
    """

    vary: str
    value: float
    error: float
    saddle: str
    state: FloatArray
    growth: float
    distance: float
    below: Outcome
    above: Outcome
    others: FloatArray
    model: Field = attribute(repr=False)


@in_usual_state
def fate_boundary(
    p: ParameterSet,
    vary: str,
    *,
    between: Ranges,
    start: Start | None = None,
    backend: str | None = None,
    options: MotionOptions | None = None,
    **values: float | None,
) -> FateBoundary:
    """The value of a parameter at which the motion from a start changes its fate, and the saddle at
    which it hovers there.

    Bisection between different attractors. These are computed by Newton's method, checked by their
    eigenvalues or multipliers, and continued from one side to the other; a cycle and the one that
    it becomes by a period doubling count as one attractor. A motion that has not settled by t = 40
    000, or whose fate depends on rounding, is undecided.

    Parameters
    ----------
    p : Parameters of any model
        Scalars; the value of ``vary`` is ignored.
    vary : str
        Name of the parameter; for the article's model theta0, mu0, kappa, alpha, sigma, beta, V or
        d.
    between : mapping
        Range of the parameter, by its name, with different fates at its ends. If there are several
        changes in it, one is found, and ``others`` lists those that were seen.
    start : array_like or mapping, optional
        Initial state, coordinates, then rates; by default 0.
    options : MotionOptions, optional
        Tolerances by which fates are recognized.
    **values : float, optional
        Values of parameters that replace those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    FateBoundary

    Raises
    ------
    ParameterError
        If both ends have the same fate.
    ConvergenceError
        If no boundary was found. Reasons: the motion is undecided at an end, and no change is seen
        in between; the attractor itself ends or loses its stability; motions in between are
        undecided; the fates alternate more closely than rounding can resolve; or motions of a
        total time of 5e6, in the motion's unit, or 30 s of processor time were not enough
        (``longest`` and ``seconds`` of the options). The message states the limits on either side
        of each change that was seen.

    Notes
    -----
    Source: (8)–(11) with (10) as the friction law. The stable manifold of the saddle separates the
    fates.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article()
    >>> found = ss.fate_boundary(p, "theta0", between={"theta0": (0.72101, 0.72102)}, V=0.5, d=10.0)
    >>> round(found.value, 8), found.saddle
    (0.72101173, 'equilibrium')
    """
    model = model_of(p)
    model.require_answered("fate_boundary")
    model.require_parameter(vary)
    low, high = varied_range(vary, between, model.any_of(vary))
    system = System.of(p.given(**values).replace(**{vary: low}), backend, options)
    samples = _FateSamples(system, vary, state_of(model, start))
    ends = samples.verified(samples.sample(low)), samples.verified(samples.sample(high))
    for share in (0.2, 0.4, 0.6, 0.8):
        samples.sample(low + share * (high - low))
    if ends[0].label == ends[1].label >= 0:
        raise samples.no_change(*ends)
    more = (0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98)  # if no change is seen, but fates are decided
    for share in more if any(each.label >= 0 for each in samples.known) else ():
        if next(samples.changes(), None) is None:
            samples.sample(low + share * (high - low))
    found = _first(samples)
    if isinstance(found, FateBoundary):
        return found
    ends = samples.sample(low), samples.sample(high)  # labels may have been merged
    if not found and ends[0].label == ends[1].label >= 0:
        raise samples.no_change(*ends)
    why = (
        "; ".join(dict.fromkeys(found))
        or f"{samples.described(*ends)}; give values at which the motion settles"
    )
    raise ConvergenceError(f"between = ({low:g}, {high:g}): {why}")


@dataclass(frozen=True)
class _Fate:
    """Fate of the start at a value of the parameter. ``precision`` is the relative tolerance and
    the shift of the start. Equal labels are the same attractor, continued; −1 is undecided.
    """

    value: float
    precision: tuple[float, float]
    verdict: FateVerdict
    label: int


@dataclass(frozen=True)
class _FateSamples:
    """The fates sampled so far, sorted by value, and the values to which the continuation of an
    attractor failed (``lost``).
    """

    system: System
    vary: str
    start: FloatArray
    known: list[_Fate] = attribute(default_factory=list)
    lost: list[float] = attribute(default_factory=list)
    begun: float = attribute(default_factory=time.thread_time)

    @property
    def size(self) -> float:
        """The largest absolute value of the range, to which relative widths refer."""
        return max(abs(self.known[0].value), abs(self.known[-1].value))

    def scales(self, value: float) -> MotionScales:
        """Units of the motion at a value."""
        return self.at(value).scales(self.start)

    def at(self, value: float) -> System:
        """The system at a value."""
        return self.system.at(self.vary, value)

    @property
    def rough(self) -> tuple[float, float]:
        """Precision of the bisection: relative tolerance, and no shift of the start."""
        return self.system.options.rtol, 0.0

    @property
    def fine(self) -> tuple[float, float]:
        """Precision of a second bisection; the difference of both is part of the error."""
        return self.system.options.finer_rtol, 0.0

    def sample(self, value: float, precision: tuple[float, float] | None = None) -> _Fate:
        """The fate at a value, with a precision, by default :attr:`rough`; computed once."""
        precision = precision or self.rough
        for before in self.known:
            if (before.value, before.precision) == (value, precision):
                return before
        self.in_time()
        scales = self.scales(value)
        longest = self.system.options.longest * scales.time
        if sum(each.verdict.t for each in self.known) > longest:
            raise _TooLong(
                f"motions of {longest:g} in all leave it open whether there are "
                "others; give a narrower range"
            )
        with doing(
            "the motion at {} = {:.12g}, after {} others", self.vary, value, len(self.known)
        ):
            start = self.start + precision[1] * scales.states
            verdict = judged(self.at(value), start, rtol=precision[0])
        label = self._label(value, verdict) if verdict.decided else -1
        found = _Fate(value, precision, verdict, label)
        insort(self.known, found, key=lambda each: each.value)
        return found

    def in_time(self) -> None:
        """Raise ConvergenceError if the processor time of the search is over."""
        seconds = self.system.options.seconds
        if time.thread_time() - self.begun > seconds:
            at = ", ".join(
                f"{each.verdict.described()} at {self.vary} = {each.value:.12g}"
                for each in (*self.known[:1], *self.known[-1:])
                if each.label >= 0
            )
            raise _TooLong(
                f"{seconds:g} s of processor time were not enough"
                f"{f', in which it was seen to come to {at}' if at else ''}; give a narrower "
                "range, or more seconds of ss.MotionOptions"
            )

    def verified(self, fate: _Fate) -> _Fate:
        """The fate, made undecided if rounding may change it."""
        if fate.label < 0:
            return fate
        self.in_time()

        def alike(neighbour: FateVerdict) -> bool:
            # The limits are compared too: labels of one attractor may differ until they are merged.
            limit = self.at(fate.value).same_limit(fate.verdict.outcome, neighbour.outcome)
            return bool(limit or self._label(fate.value, neighbour) == fate.label)

        verdict = verified(self.at(fate.value), self.start, fate.verdict, alike)
        if verdict.decided:
            return fate
        undecided = replace(fate, verdict=verdict, label=-1)
        self.known[self.known.index(fate)] = undecided
        return undecided

    def _label(self, value: float, verdict: FateVerdict) -> int:
        """Label of the same attractor at another value, or a new label if none is known.

        A failing continuation takes seconds: so only the most similar attractor is continued, and
        none after eight failures. A new label that belongs to a known attractor is merged later.
        """
        alike = [each for each in self.known if each.verdict.kind == verdict.kind]
        nearest = {
            each.label: each for each in sorted(alike, key=lambda each: -abs(each.value - value))
        }
        for label, each in nearest.items():
            if self.at(value).same_limit(each.verdict.outcome, verdict.outcome):
                return label

        def difference(fate: _Fate) -> tuple[float, float]:
            """Difference of the logarithms of the periods, 0 without; difference of the states."""
            one, other = fate.verdict.outcome, verdict.outcome
            between = state_difference(
                one.rest or one.cycle, other.rest or other.cycle, self.system.field.periodic
            )
            states = self.scales(value).states[: len(between)]
            periods = 0.0
            if one.period > 0 and other.period > 0:
                periods = abs(math.log(one.period / other.period))
            return periods, float(np.abs(between / states).max(initial=0.0))

        similar = min(nearest.values(), key=difference, default=None)
        if similar is not None and difference(similar)[0] < 0.5 and len(self.lost) < 8:
            try:
                if same(self.followed(similar, value), attractor(self.at(value), verdict)):
                    return similar.label
            except ConvergenceError:
                self.lost.append(value)
        return 1 + max((each.label for each in self.known), default=-1)

    def followed(self, fate: _Fate, value: float) -> Attractor:
        """The attractor of a fate, continued to another value."""
        return followed(self.attractor(fate), self.at(value))

    def attractor(self, fate: _Fate) -> Attractor:
        """The attractor of a fate."""
        return attractor(self.at(fate.value), fate.verdict)

    def merge(self, one: int, other: int) -> None:
        """Give all fates with the label ``other`` the label ``one``."""
        self.known[:] = [
            replace(each, label=one) if each.label == other else each for each in self.known
        ]

    def change(self, low: float, high: float) -> tuple[_Fate, _Fate] | None:
        """The fates at two values, if they differ; else the first change between them, or None."""
        ends = self.sample(low), self.sample(high)
        if ends[0].label != ends[1].label:
            return ends
        return next(
            (pair for pair in self.changes() if low <= pair[0].value and pair[1].value <= high),
            None,
        )

    def changes(self) -> Iterator[tuple[_Fate, _Fate]]:
        """Pairs of neighbouring decided fates that differ; first those without an undecided fate in
        between.
        """
        rough = self.rough
        decided = [each for each in self.known if each.label >= 0 and each.precision == rough]
        pairs = [(a, b) for a, b in pairwise(decided) if a.label != b.label]
        yield from sorted(
            pairs,
            key=lambda pair: any(pair[0].value < each.value < pair[1].value for each in self.known),
        )

    def no_change(self, low: _Fate, high: _Fate) -> ParameterError:
        """The error of a range whose ends have the same fate."""
        other = next((each for each in self.known if each.label not in (-1, low.label)), None)
        between = (
            f", and to {other.verdict.described()} at {other.value:g} between" if other else ""
        )
        one, another = low.verdict.described(), high.verdict.described()
        ends = f"{one} at both ends"
        if one != another:
            ends = f"{one} at one end and to {another} at the other"
        return ParameterError(
            f"between = ({low.value:g}, {high.value:g}): the start comes to {ends}, which is "
            f"one attractor{between}; give values of different fates"
        )

    def described(self, low: _Fate, high: _Fate) -> str:
        """The fates at two values as text."""
        return " and ".join(
            f"it comes to {each.verdict.described()} at {self.vary} = {each.value:.12g}"
            for each in (low, high)
        )

    def inside(self, *values: float) -> list[float]:
        """Those of the values that are within the range."""
        return [value for value in values if self.known[0].value <= value <= self.known[-1].value]


@dataclass(frozen=True)
class _Bracket:
    """Two values of the parameter; at exactly one of them the fate has the label ``kept``."""

    samples: _FateSamples
    low: _Fate
    high: _Fate
    kept: int

    @property
    def width(self) -> float:
        """Width of the bracket."""
        return self.high.value - self.low.value

    @property
    def middle(self) -> float:
        """Midpoint of the bracket."""
        return (self.low.value + self.high.value) / 2

    @property
    def sides(self) -> list[bool | None]:
        """For both values: True if the fate is ``kept``, False if another, None if undecided."""
        return [
            each.label == self.kept if each.label >= 0 else None for each in (self.low, self.high)
        ]

    def narrowed(self, width: float, precision: tuple[float, float] | None = None) -> _Bracket:
        """The bracket narrowed by bisection to a width, or until motions inside are undecided."""
        found = self
        while found.width > width:
            for share in (0.5, 0.38, 0.62, 0.25, 0.75):  # other shares if the midpoint is undecided
                middle = found.low.value + share * found.width
                if not found.low.value < middle < found.high.value:
                    return found
                fate = self.samples.sample(middle, precision)
                if fate.label >= 0:
                    break
            else:
                return found
            is_low = (fate.label == self.kept) == found.sides[0]
            found = replace(found, low=fate) if is_low else replace(found, high=fate)
        return found

    def rebracketed(self, near: float, precision: tuple[float, float], most: float) -> _Bracket:
        """A narrow bracket around a value with another precision.

        It is searched for up to the relative distance ``most``; ConvergenceError if there is none.
        """
        size = self.samples.size
        half, most = max(self.width, self.samples.system.options.bracket * size), most * size
        while half < most:
            found = replace(
                self,
                low=self.samples.sample(near - half, precision),
                high=self.samples.sample(near + half, precision),
            )
            if found.sides == self.sides:
                return found.narrowed(1e-15 * size, precision)
            half *= 8
        raise self.alternating(near, most)

    def resolved(self, value: float, error: float, multiples: tuple[int, ...]) -> bool:
        """True if the fates near a value do not alternate.

        They are sampled with both precisions on both sides, at ``multiples`` of the error, nearest
        first. At the nearest multiple each side must have its own fate; at the others both
        precisions must agree. Undecided fates are ignored.
        """
        for multiple in multiples:
            for sign, own in zip((-1, 1), self.sides, strict=True):
                samples = [
                    self.samples.sample(inner, precision)
                    for inner in self.samples.inside(value + sign * multiple * error)
                    for precision in (self.samples.rough, self.samples.fine)
                ]
                found = {each.label == self.kept for each in samples if each.label >= 0}
                if len(found) > 1 or (multiple == multiples[0] and not found <= {own}):
                    return False
        return True

    def alternating(self, value: float, width: float) -> ConvergenceError:
        """The error of fates that alternate near a value, so that there is no single boundary."""
        return ConvergenceError(
            f"{self.samples.described(self.low, self.high)}, and between the two fates alternate "
            "more closely than rounding can tell: "
            f"within {width:.1g} of {self.samples.vary} = {value:.15g} motions by the "
            f"tolerances {self.samples.rough[0]:g} and {self.samples.fine[0]:g} do "
            "not have one and the same change"
        )


class _TooLong(ConvergenceError):
    """The motions take more than ``longest`` or ``seconds`` of ``MotionOptions``."""


def _first(samples: _FateSamples) -> FateBoundary | list[str]:
    """The first sampled change that is a boundary; else the reason why each of them is not."""
    why: list[str] = []
    for low, high in [(one.value, other.value) for one, other in samples.changes()]:
        for side in (0, 1):  # the fate whose end is searched for
            while (change := samples.change(low, high)) is not None:
                try:
                    found = _boundary(_Bracket(samples, *change, change[side].label))
                except ConvergenceError as error:
                    why.append(str(error))
                    if isinstance(error, _TooLong):
                        return why
                    break
                if found is not None:
                    return found
    return why


def _boundary(bracket: _Bracket) -> FateBoundary | None:
    """The boundary in a bracket; ConvergenceError if it is none, with the reason.

    None if both sides have the same attractor; their labels are then merged.
    """
    samples = bracket.samples
    bracket = bracket.narrowed(samples.system.options.bracket * samples.size)
    low, high = bracket.low, bracket.high
    # Largest relative width of a bracket that is accepted.
    too_wide = 1e-8
    wide = bracket.width > too_wide * samples.size
    try:
        if wide:
            is_same = _doubles(samples, low, high)
        else:
            is_same = any(
                same(samples.followed(one, other.value), samples.attractor(other))
                for one, other in ((low, high), (high, low))
            )
    except ConvergenceError as why:
        raise ConvergenceError(
            f"{samples.described(low, high)}, but this is no boundary of basins: {why}"
        ) from why
    if is_same:
        samples.merge(low.label, high.label)
        return None
    if wide:
        low, high = samples.verified(low), samples.verified(high)
        raise ConvergenceError(f"{samples.described(low, high)}, and between those it is undecided")
    # The value is that of a finer tolerance. Its error: how much the tolerance, and a start shifted
    # by it, change the value, with a factor of 2.
    fine = bracket.rebracketed(bracket.middle, samples.fine, too_wide)
    value, shifted_precision = fine.middle, (samples.fine[0], samples.fine[0])
    shifted = bracket.rebracketed(value, shifted_precision, 1e-5)
    change = abs(value - bracket.middle) + abs(shifted.middle - value)
    error = max(fine.width, shifted.width) + 2 * change
    error += 4 * float(np.spacing(abs(value)))
    multiples = (3, 6, 12)
    if not bracket.resolved(value, error, multiples):
        raise bracket.alternating(value, multiples[-1] * error)
    # Samples nearby show whether fates alternate there.
    offsets = (sign * offset * samples.size for offset in (1e-8, 1e-6) for sign in (-1, 1))
    for inside in samples.inside(*(value + offset for offset in offsets)):
        samples.sample(inside)
    kind, state, growth, distance = _saddle(bracket)
    changes = [(a.value, b.value) for a, b in samples.changes() if a.value < b.value]
    others = {(a, b) for a, b in changes if b < value - error or a > value + error}
    return FateBoundary(
        samples.vary,
        value,
        error,
        kind,
        state,
        growth,
        distance,
        low.verdict.outcome,
        high.verdict.outcome,
        np.array(sorted(others)).reshape(-1, 2),
        samples.system.field,
    )


def _doubles(samples: _FateSamples, low: _Fate, high: _Fate) -> bool:
    """True if one of two cycles becomes the other by a period doubling between the two values; then
    they count as one attractor.

    The branch of the doubled cycle is followed to its end, which must be at the period doubling of
    the other cycle, with all cycles in between stable.
    """
    short, long = sorted((low, high), key=lambda each: each.verdict.outcome.period)
    if not abs(long.verdict.outcome.period / short.verdict.outcome.period / 2 - 1) <= 0.05:
        return False  # also if one of them is no cycle: then its period is NaN
    try:
        single, double = samples.attractor(short), samples.attractor(long)
        # The range extends beyond the two values, because steps are proportional to it.
        bounds = samples.known[0].value, high.value
        if long is low:
            bounds = low.value, samples.known[-1].value
        assert single.orbit
        assert double.orbit
        branch = cycle_branch(double.orbit, samples.vary, between={samples.vary: bounds}, points=40)
        between = (branch.values >= low.value) & (branch.values <= high.value)
        for end in branch.of("end"):
            if (
                end.how == MERGES
                and low.value < end.value < high.value
                and branch.stable[between].all()
            ):
                continued = followed_cycle(single.orbit, samples.at(end.value).values)
                return same_cycle(continued, end.cycle)
    except ConvergenceError:
        pass  # not known to be the same
    return False


def _saddle(bracket: _Bracket) -> tuple[str, FloatArray, float, float]:
    """The saddle near which the motions of a narrow bracket stay until they diverge: its kind, a
    state of it, its growth rate, and the smallest distance of the motions.

    Saddle equilibria are searched for by Newton's method from each extremum of the motion before
    that time; then saddle cycles from close returns.
    """
    samples = bracket.samples
    system, periodic = samples.at(bracket.middle), samples.system.field.periodic
    scales = samples.scales(bracket.middle)
    options = system.options
    t_end = options.times[0] * scales.time
    one, other = (
        samples.at(each.value).motion(samples.start, t_end, rtol=options.finer_rtol)
        for each in (bracket.low, bracket.high)
    )
    times = np.linspace(0.0, t_end, int(10 * options.times[0]) + 1)
    difference = np.abs(one(times) - other(times)) / scales.states[:, None]
    diverged = times[difference.max(axis=0) > options.parted]
    own, until = system.scaled(scales), float(diverged.min(initial=t_end)) / scales.time
    hovering = own.flow.plain(samples.start / scales.states, own.constants, until)
    extrema = [extremum for extremum in hovering.extrema if extremum.border == -1]
    states = np.array([*(extremum.state for extremum in extrema), hovering.state])
    saddles: dict[float, Saddle] = {}
    for state in states:
        with suppress(ConvergenceError):
            saddle = saddle_near(system, scales.states * state)
            away = magnitude(state_difference(state, saddle.state / scales.states, periodic))
            if saddle.attracts and away < options.hovers:
                saddles[away] = saddle
    if saddles:
        nearest, saddle = min(saddles.items())
        return "equilibrium", saddle.state, saddle.growth, nearest
    extent = np.ptp(states, axis=0).max()
    for begin, end in returns(hovering.extrema, periodic):
        with suppress(ConvergenceError):
            cycle = cycle_at(own, begin.state, end.t - begin.t)
            growth = growth_of_cycle(cycle)
            near = distance(cycle, scales.states * begin.state)
            if growth is not None and near < options.hovers * extent:
                return "cycle", cycle.state, growth, near
    return "unknown", scales.states * states[-1], math.nan, math.nan
