"""The value of a parameter at which a motion from a given start changes its fate, and the saddle
that it then hovers at.
"""

from __future__ import annotations

import math
from bisect import insort
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError
from ..core.progress import doing
from ..core.questions import model_of
from ..models.field import Field
from ..models.parameters import FloatArray, ParameterSet, Ranges, varied_range
from ..motion.options import MotionOptions
from ..motion.regimes import Outcome
from ..motion.scales import MotionScales
from ..motion.simulation import state_of
from ..numerics.vectors import apart, magnitude
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

    Both attractors are there on both sides: each was followed to the other side, and is stable
    there. An attractor that itself ends or loses its stability is no change of fate, but an event
    of its branch.

    Attributes
    ----------
    vary : str
    value : float
        Of that parameter.
    error : float
        Estimate: the last bracket, and twice how much a tolerance ten times as small, and a start
        moved by that, move it.
    saddle : str
        "equilibrium" or "cycle", which repels in one direction only by its eigenvalues or
        multipliers and their errors; or "unknown".
    state : ndarray, shape (m,)
        The saddle's: of a cycle, where its first coordinate is largest; of an unknown one, where
        the motions begin to part.
    growth : float
        The saddle's eigenvalue, or for a cycle the logarithm of its multiplier over its period. NaN
        for an unknown one.
    distance : float
        How near the motion comes to that, in units of the motion, which are 1 for numbers of a
        common size.
    below, above : Outcome
        What the start comes to on either side.
    others : ndarray, shape (k, 2)
        Other intervals of the bracket, as far as was looked, at whose ends the fates differ: where
        there are any, fates alternate. Those may be several fates on one side, none of which is on
        the other: an irregular transient ends anywhere.
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
    start: ArrayLike | None = None,
    backend: str | None = None,
    options: MotionOptions | None = None,
    **values: float | None,
) -> FateBoundary:
    """The value of a parameter at which a start changes its fate, and which saddle it then hovers
    at.

    Bisection on the attractors that the motion comes to, which are proved by Newton's method and
    their eigenvalues or multipliers, and followed from one side to the other: a cycle and what it
    becomes by doubling its period are one attractor. What has not settled by t = 40 000 is no fate,
    nor is what motions that begin within rounding do not share.

    Parameters
    ----------
    p : Parameters of any model
        Scalars; the one that varies is replaced.
    vary : str
        A parameter of the model, of the article's theta0, mu0, kappa, alpha, sigma, beta, V or d.
    between : mapping
        Its range, by its name, with different fates at its ends. Where there are several changes
        between them, one is found, and ``others`` tells of those that were seen.
    start : array_like, optional
        Coordinates, then rates, of the article's model x, y, x', y'; 0 where it is left out.
    options : MotionOptions, optional
        Numbers by which fates are told.
    **values : float, optional
        Parameters in place of those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    FateBoundary

    Raises
    ------
    ParameterError
        Where both ends have the same fate.
    ConvergenceError
        Where the motion is undecided at an end and nothing is seen to change between; where what
        changes is the attractor itself, which ends or loses its stability; where motions between
        stay undecided; where fates alternate on both sides more closely than rounding can tell; and
        where 5e6 of the motion's units of time leave it open. It says what the start comes to on
        either side, of each change that was seen.

    Notes
    -----
    Source: (8)–(11) with (10) as the friction law; the stable manifold of a saddle separates the
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
    for share in (0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98):  # where an end is undecided
        if next(samples.changes(), None) is None:
            samples.sample(low + share * (high - low))
    found = _first(samples)
    if isinstance(found, FateBoundary):
        return found
    ends = samples.sample(low), samples.sample(high)  # with what has turned out to be one attractor
    if not found and ends[0].label == ends[1].label >= 0:
        raise samples.no_change(*ends)
    why = (
        "; ".join(dict.fromkeys(found))
        or f"{samples.described(*ends)}; give values at which the motion settles"
    )
    raise ConvergenceError(f"between = ({low:g}, {high:g}): {why}")


@dataclass(frozen=True)
class _Fate:
    """Fate of the start at a value; equal labels are attractors of which one is the other,
    followed; −1 is undecided.
    """

    value: float
    precision: tuple[float, float]
    verdict: FateVerdict
    label: int


@dataclass(frozen=True)
class _FateSamples:
    """Fates by value, as far as was asked; to which values no attractor could be followed."""

    system: System
    vary: str
    start: FloatArray
    known: list[_Fate] = attribute(default_factory=list)
    lost: list[float] = attribute(default_factory=list)

    @property
    def size(self) -> float:
        """The largest of the values, by which shares of them are meant."""
        return max(abs(self.known[0].value), abs(self.known[-1].value))

    def scales(self, value: float) -> MotionScales:
        """Units of the motion at a value."""
        return self.at(value).scales(self.start)

    def at(self, value: float) -> System:
        """The system at a value."""
        return self.system.at(self.vary, value)

    @property
    def rough(self) -> tuple[float, float]:
        """Tolerance of the motions by which a bracket is narrowed, and how far the start is
        moved.
        """
        return self.system.options.rtol, 0.0

    @property
    def fine(self) -> tuple[float, float]:
        """Those by which that is done anew; the difference tells the error."""
        return self.system.options.finer_rtol, 0.0

    def sample(self, value: float, precision: tuple[float, float] | None = None) -> _Fate:
        """The fate at a value, by a tolerance, from a start that is moved by so much."""
        precision = precision or self.rough
        for before in self.known:
            if (before.value, before.precision) == (value, precision):
                return before
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
        found = _Fate(
            value, precision, verdict, self._label(value, verdict) if verdict.decided else -1
        )
        insort(self.known, found, key=lambda each: each.value)
        return found

    def verified(self, fate: _Fate) -> _Fate:
        """A fate, or an undecided one where rounding decides it."""
        if fate.label >= 0:
            verdict = verified(
                self.at(fate.value),
                self.start,
                fate.verdict,
                # whatever labels they have: two may turn out to be one later
                lambda beside: (
                    self.at(fate.value).same_limit(fate.verdict.outcome, beside.outcome)
                    or self._label(fate.value, beside) == fate.label
                ),
            )
            if not verdict.decided:
                self.known[self.known.index(fate)] = fate = replace(fate, verdict=verdict, label=-1)
        return fate

    def _label(self, value: float, verdict: FateVerdict) -> int:
        """Label of the attractor among those that are known, or a new one; should it be a known one
        after all, that shows later.

        To follow an attractor in vain takes seconds: only the likeliest is, and not any more after
        some failures.
        """
        alike = [each for each in self.known if each.verdict.kind == verdict.kind]
        nearest = {
            each.label: each for each in sorted(alike, key=lambda each: -abs(each.value - value))
        }
        for label, each in nearest.items():
            if self.at(value).same_limit(each.verdict.outcome, verdict.outcome):
                return label

        def difference(fate: _Fate) -> tuple[float, float]:
            """Difference of two periods, as a logarithm, 0 for what has none; and of two states."""
            one, other = fate.verdict.outcome, verdict.outcome
            off = apart(
                one.rest or one.cycle, other.rest or other.cycle, self.system.field.periodic
            )
            states = self.scales(value).states[: len(off)]
            periods = one.period > 0 and other.period > 0
            return (
                abs(math.log(one.period / other.period)) if periods else 0.0,
                float(np.abs(off / states).max(initial=0.0)),
            )

        likeliest = min(nearest.values(), key=difference, default=None)
        # Failures after which no cycle is followed.
        most_failures = 8
        # Cycles whose periods are less apart, as a logarithm, may be one that is
        # followed.
        if (
            likeliest is not None
            and difference(likeliest)[0] < 0.5
            and len(self.lost) < most_failures
        ):
            try:
                if same(self.followed(likeliest, value), attractor(self.at(value), verdict)):
                    return likeliest.label
            except ConvergenceError:
                self.lost.append(value)
        return 1 + max((each.label for each in self.known), default=-1)

    def followed(self, fate: _Fate, value: float) -> Attractor:
        """The attractor of a fate, at another value."""
        return followed(self.attractor(fate), self.at(value))

    def attractor(self, fate: _Fate) -> Attractor:
        """The attractor of a fate."""
        return attractor(self.at(fate.value), fate.verdict)

    def merge(self, one: int, other: int) -> None:
        """Two attractors have turned out to be one."""
        self.known[:] = [
            replace(each, label=one) if each.label == other else each for each in self.known
        ]

    def change(self, low: float, high: float) -> tuple[_Fate, _Fate] | None:
        """Two values that differ in their fates, if they still do, or the first such neighbours
        between.
        """
        ends = self.sample(low), self.sample(high)
        if ends[0].label != ends[1].label:
            return ends
        return next(
            (pair for pair in self.changes() if low <= pair[0].value and pair[1].value <= high),
            None,
        )

    def changes(self) -> Iterator[tuple[_Fate, _Fate]]:
        """Neighbours of different fates, with nothing that is decided between; first those with
        nothing at all between.
        """
        rough = self.rough
        decided = [each for each in self.known if each.label >= 0 and each.precision == rough]
        pairs = [(a, b) for a, b in pairwise(decided) if a.label != b.label]
        yield from sorted(
            pairs,
            key=lambda pair: any(pair[0].value < each.value < pair[1].value for each in self.known),
        )

    def no_change(self, low: _Fate, high: _Fate) -> ParameterError:
        """Error: both ends of the bracket have one fate."""
        other = next((each for each in self.known if each.label not in (-1, low.label)), None)
        one, another = low.verdict.described(), high.verdict.described()
        ends = (
            f"{one} at both ends"
            if one == another
            else f"{one} at one end and to {another} at the other"
        )
        return ParameterError(
            f"between = ({low.value:g}, {high.value:g}): the start comes to {ends}, which is "
            "one attractor"
            + (f", and to {other.verdict.described()} at {other.value:g} between" if other else "")
            + "; give values of different fates"
        )

    def described(self, low: _Fate, high: _Fate) -> str:
        """Fates of the start on two sides."""
        return " and ".join(
            f"it comes to {each.verdict.described()} at {self.vary} = {each.value:.12g}"
            for each in (low, high)
        )

    def inside(self, *values: float) -> list[float]:
        """Values that lie in the bracket, of some."""
        return [value for value in values if self.known[0].value <= value <= self.known[-1].value]


@dataclass(frozen=True)
class _Bracket:
    """Two values, at one of which alone the start has the fate ``kept``."""

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
        """Middle of the bracket."""
        return (self.low.value + self.high.value) / 2

    @property
    def sides(self) -> list[bool | None]:
        """Whether the fate is ``kept`` at either value; None where it is undecided."""
        return [
            each.label == self.kept if each.label >= 0 else None for each in (self.low, self.high)
        ]

    def narrowed(self, width: float, precision: tuple[float, float] | None = None) -> _Bracket:
        """A narrower bracket, as far as motions are decided."""
        found = self
        while found.width > width:
            for share in (0.5, 0.38, 0.62, 0.25, 0.75):  # as far as motions are undecided
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
        """The bracket found again about a value, by the tolerance and from the start of another
        precision, narrowed.
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

    def resolved(self, value: float, error: float, shares: tuple[int, ...]) -> bool:
        """Whether next to a value, and somewhat farther off, the fate is ``kept`` on its own side
        only: at ``shares`` of its error, the nearest first.

        Farther off it may be another one, but not by one tolerance only. What is undecided says
        nothing.
        """
        for times in shares:
            for sign, own in zip((-1, 1), self.sides, strict=True):
                places = self.samples.inside(value + sign * times * error)
                samples = [
                    self.samples.sample(inner, precision)
                    for inner in places
                    for precision in (self.samples.rough, self.samples.fine)
                ]
                found = {each.label == self.kept for each in samples if each.label >= 0}
                if len(found) > 1 or (times == shares[0] and not found <= {own}):
                    return False
        return True

    def alternating(self, value: float, width: float) -> ConvergenceError:
        """Error: fates alternate, so that no value is the boundary."""
        return ConvergenceError(
            f"{self.samples.described(self.low, self.high)}, and between the two fates alternate "
            "more closely than rounding can tell: "
            f"within {width:.1g} of {self.samples.vary} = {value:.15g} motions by the "
            f"tolerances {self.samples.rough[0]:g} and {self.samples.fine[0]:g} do "
            "not have one and the same change"
        )


class _TooLong(ConvergenceError):
    """Motions were followed for longer than one call may take."""


def _first(samples: _FateSamples) -> FateBoundary | list[str]:
    """The first of the changes that are seen which is a boundary, or why each of them is none."""
    why: list[str] = []
    for low, high in [(one.value, other.value) for one, other in samples.changes()]:
        for side in (0, 1):  # either fate may be the one whose end is looked for
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
    """End of the fate that is kept between two values; ConvergenceError where that is no boundary.

    None where both sides turn out to have one attractor, which is known from then on.
    """
    samples = bracket.samples
    bracket = bracket.narrowed(samples.system.options.bracket * samples.size)
    low, high = bracket.low, bracket.high
    # No answer is given beyond this share of the values.
    too_wide = 1e-8
    wide = bracket.width > too_wide * samples.size
    try:
        met = (
            _doubles(samples, low, high)
            if wide
            else any(
                same(samples.followed(one, other.value), samples.attractor(other))
                for one, other in ((low, high), (high, low))
            )
        )
    except ConvergenceError as why:
        raise ConvergenceError(
            f"{samples.described(low, high)}, but this is no boundary of basins: {why}"
        ) from why
    if met:
        samples.merge(low.label, high.label)
        return None
    if wide:
        low, high = samples.verified(low), samples.verified(high)
        raise ConvergenceError(f"{samples.described(low, high)}, and between those it is undecided")
    # The middle by a finer tolerance; how much that, and a start moved by it, change it, with a
    # margin, is its error.
    fine = bracket.rebracketed(bracket.middle, samples.fine, too_wide)
    # How far the place may lie that is found from a start which is moved, as a share of the values:
    # the error says how far.
    farthest_place = 1e-5
    once_more = (samples.fine[0], samples.fine[0])
    moved, value = bracket.rebracketed(fine.middle, once_more, farthest_place), fine.middle
    error = max(fine.width, moved.width) + 2 * (
        abs(value - bracket.middle) + abs(moved.middle - value)
    )
    error += 4 * float(np.spacing(abs(value)))
    shares = (3, 6, 12)
    if not bracket.resolved(value, error, shares):
        raise bracket.alternating(value, shares[-1] * error)
    # Beside the value it is looked whether fates alternate.
    asides = (sign * aside * samples.size for aside in (1e-8, 1e-6) for sign in (-1, 1))
    for inside in samples.inside(*(value + aside for aside in asides)):
        samples.sample(inside)
    kind, state, growth, distance = _saddle(bracket)
    away = [(a.value, b.value) for a, b in samples.changes() if a.value < b.value]
    # What the error reaches is this one.
    others = {(a, b) for a, b in away if b < value - error or a > value + error}
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
    """Whether one of two cycles comes out of the other, of half its period, by a doubling between:
    a single attractor.
    """
    short, long = sorted((low, high), key=lambda each: each.verdict.outcome.period)
    # Periods whose ratio is this close to 2 may be those of a cycle and of what it becomes
    # by a doubling.
    if not abs(long.verdict.outcome.period / short.verdict.outcome.period / 2 - 1) <= 0.05:
        return False  # or one of them is no cycle, and has no period
    try:
        single, double = samples.attractor(short), samples.attractor(long)
        # Beyond where the other one is, since the range tells how long steps are as well.
        bounds = (
            (low.value, samples.known[-1].value)
            if long is low
            else (samples.known[0].value, high.value)
        )
        assert single.orbit
        assert double.orbit
        # Points of a branch that are followed to tell.
        branch = cycle_branch(double.orbit, samples.vary, between={samples.vary: bounds}, points=40)
        between = (branch.values >= low.value) & (branch.values <= high.value)
        for end in branch.of("end"):
            if (
                end.how == MERGES
                and low.value < end.value < high.value
                and branch.stable[between].all()
            ):
                met = followed_cycle(single.orbit, samples.at(end.value).values)
                return same_cycle(met, end.cycle)
    except ConvergenceError:
        pass  # what can't be followed between is not known to be one attractor, and both fates stay
    return False


def _saddle(bracket: _Bracket) -> tuple[str, FloatArray, float, float]:
    """At what the motions of a narrow bracket hover before they part: its kind, a state of it, its
    growth, how near they come.
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
    off_by = np.abs(one(times) - other(times)) / scales.states[:, None]
    parted = times[off_by.max(axis=0) > options.parted]
    own, until = system.scaled(scales), float(parted.min(initial=t_end)) / scales.time
    hovering = own.flow.plain(samples.start / scales.states, own.constants, until)
    turns = [extremum for extremum in hovering.extrema if extremum.border == -1]
    states = np.array([*(extremum.state for extremum in turns), hovering.state])
    rests: dict[float, Saddle] = {}
    for state in states:
        with suppress(ConvergenceError):
            saddle = saddle_near(system, scales.states * state)
            away = magnitude(apart(state, saddle.state / scales.states, periodic))
            if saddle.attracts and away < options.hovers:
                rests[away] = saddle
    if rests:
        off, rest = min(rests.items())
        return "equilibrium", rest.state, rest.growth, off
    extent = np.ptp(states, axis=0).max()
    for begin, end in returns(hovering.extrema, periodic):
        with suppress(ConvergenceError):
            cycle = cycle_at(own, begin.state, end.t - begin.t)
            growth = growth_of_cycle(cycle)
            near = distance(cycle, scales.states * begin.state)
            if growth is not None and near < options.hovers * extent:
                return "cycle", cycle.state, growth, near
    return "unknown", scales.states * states[-1], math.nan, math.nan
