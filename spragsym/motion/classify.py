"""Classification of the limit of a motion, for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how
alike two parts of a window look: lift-off for good where the model knows it, rest at an equilibrium
by its linearization with the damping of the friction law, and cycles by the closed orbit itself and
its multipliers (:mod:`.return_map`), in this order.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from ..core.errors import ConvergenceError
from ..models.field import Field, Mode, Values
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import BoolArray, ComplexArray
from ..numerics.vectors import in_one_turn, magnitude
from .holding import held_in_every_phase
from .measures import KEPT_EXTREMA, MotionStatistics
from .problem import Event, Problem
from .regimes import Outcome, Regime
from .return_map import Onward, leads, on_cycle

#: Events of the contact.
CONTACT = [Event.CONTACT_LOST, Event.CONTACT_REGAINED, Event.FACE_LEFT, Event.FACE_REGAINED]


def classify(statistics: MotionStatistics, onward: Onward) -> Outcome:
    """The outcome of a motion, from what was measured of it after its transient, and how it goes
    on.

    All is judged in units of the
    motion's own (:mod:`.scales`), and told in those of the model. The outcome is without
    ``equilibrium``, which :func:`~spragsym.statics.search.rest_index` finds for many at once.
    """
    problem = onward.problem
    field, constants = problem.field, problem.constants
    # Forces are enclosed in units of the model.
    enclosed = field.clock and not field.natural
    if enclosed and held_in_every_phase(field, constants, statistics.last):
        rest = tuple(statistics.last[: len(field.coordinates) - 1].tolist())
        return Outcome(
            Regime.EQUILIBRIUM, rest=rest, rate=np.inf, distance=0.0, names=field.components
        )
    scales = problem.own_scales
    if not scales.trivial:
        there = replace(onward, problem=scales.problem(problem))
        return scales.outcome(classify(scales.inverse.statistics(statistics), there))
    apart = not statistics.events[CONTACT].any()
    if (
        apart
        and problem.field.airborne
        and problem.field.airborne(problem.constants, statistics.last)
    ):
        found = Outcome(Regime.LIFT_OFF)
    else:
        sought = (
            at_rest(each, other.problem) or on_cycle(each, other)
            for each, other in _led(statistics, onward)
        )
        found = next(filter(None, sought), Outcome())
    return replace(found, names=problem.field.components)


def _led(statistics: MotionStatistics, onward: Onward) -> Iterator[tuple[MotionStatistics, Onward]]:
    """Statistics of a motion, and where its leading coordinate tells of no rounds what the other
    ones tell.
    """
    yield statistics, onward
    if leads(statistics, onward.problem):
        return
    for lead in range(1, len(statistics.last) // 2):
        other = onward.with_lead(lead)
        with suppress(ConvergenceError):
            yield (
                other.statistics(statistics.first[None], statistics.end - statistics.begin)[0],
                other,
            )


def at_rest(statistics: MotionStatistics, problem: Problem) -> Outcome | None:
    """At rest in the neighbourhood of an equilibrium that keeps it there, or decaying to one."""
    options, tol = problem.options, problem.options.settled
    still = (
        abs(statistics.last[statistics.lead] - statistics.first[statistics.lead]) <= 4 * tol
        and statistics.reach[1] - statistics.reach[0] <= 4 * tol
    )
    # On a belt that stands still the law of friction is smooth where x' changes its sign.
    kinks = bool((statistics.events if problem.belt > 0 else statistics.events[CONTACT]).any())
    decaying = len(statistics.maxima) >= options.decay_maxima and not kinks
    if not (still or decaying):
        return None
    n = len(statistics.last) // 2
    rest = rest_near(problem, statistics.last[:n] if still else statistics.means)
    if rest is None:
        return None
    position = tuple(in_one_turn(rest.state[:n], problem.field.periodic).tolist())
    growth = -rest.rate
    late = statistics.maxima[statistics.maxima_t >= (statistics.begin + statistics.end) / 2]
    distance = magnitude(np.vstack([late, statistics.last]) - rest.state)
    # Real parts up to this are 0 but for rounding.
    if (
        still
        and distance <= tol
        and growth <= 1e-12
        and _stays(statistics, rest, options.noise * problem.rtol, kinks)
    ):
        return Outcome(
            Regime.EQUILIBRIUM, rest=position, rate=max(0.0, rest.rate), distance=distance
        )
    if (
        decaying
        and rest.decay > 0
        and _decays(statistics, rest, options.decay_maxima)
        and not _persists(statistics, rest, options.noise * problem.rtol)
    ):
        regime = Regime.EQUILIBRIUM if distance <= tol else Regime.APPROACHES_EQUILIBRIUM
        return Outcome(regime, rest=position, rate=rest.decay, distance=distance)
    return None


@dataclass(frozen=True)
class Equilibrium:
    """An equilibrium and its linearization with the damping of the friction law.

    Where frictions hold there is a whole set of equilibria, of as many dimensions as ``held`` of
    them: so many of the ``values`` are 0 along it, and deviations of what sticks end at once, and
    have none.
    """

    state: FloatArray
    values: ComplexArray
    vectors: ComplexArray
    held: int

    @property
    def rate(self) -> float:
        """Of the approach, exp(−rate τ): infinite where nothing is left to decay."""
        return -float(self.values.real[~self._along].max(initial=-np.inf))

    @property
    def decay(self) -> float:
        """As ``rate``, of all parts of a motion that anything damps or drives."""
        return -float(self.values.real[~self._along & ~self.undamped].max(initial=-np.inf))

    @property
    def undamped(self) -> BoolArray:
        """Which parts go on as they are, but for rounding."""
        sizes = np.abs(self.values)
        return ~self._along & (np.abs(self.values.real) <= 1e-12 * sizes.max())

    @property
    def _along(self) -> BoolArray:
        """The values along a set of equilibria, which say nothing of an approach."""
        out = np.zeros(self.values.size, dtype=bool)
        out[np.argsort(np.abs(self.values))[: self.held]] = True
        return out


def spectrum_at_rest(
    field: Field, constants: Values, state: FloatArray, mode: Mode
) -> tuple[ComplexArray, ComplexArray]:
    """Eigenvalues and eigenvectors of the linearized motion in a mode; where friction holds, of
    what moves in it, in which no speed slides.
    """
    from scipy.linalg import null_space  # heavy, and a refusal does not need it

    numbers = state.tolist()
    moving = np.eye(field.size)
    for border in field.stays(mode):
        assert border.slopes is not None
        across = np.array(border.slopes(numbers, constants, mode), dtype=float)[: field.size]
        moving = moving @ null_space((across @ moving)[None])
    values, vectors = np.linalg.eig(moving.T @ field.matrix(numbers, constants, mode) @ moving)
    return values, moving @ vectors


def rest_near(problem: Problem, position: FloatArray) -> Equilibrium | None:
    """The equilibrium in contact that Newton's method finds from a place, at the friction μ(V);
    None where it finds none.

    Where friction holds the mass at the place, as on a belt that stands still, it is the nearest of
    all at which it does.
    """
    field, constants = problem.field, problem.constants
    still = [*position.tolist(), *np.zeros(len(position))]
    here = field.initial_mode(still, constants)
    mode = here if field.stays(here) else field.mode_at_rest(still, constants)
    try:
        state = equilibrium_near(field, constants, position, mode)
    except ConvergenceError:
        return None
    if any(
        border.sign(mode) * border.level(state, constants, mode) < 0
        for border in field.borders
        if border.kink
    ):
        return None
    return Equilibrium(
        state, *spectrum_at_rest(field, constants, state, mode), len(field.stays(mode))
    )


def equilibrium_near(
    field: Field, constants: Values, position: FloatArray, kept: Mode | None = None
) -> FloatArray:
    """The state of rest that Newton's method finds from a place, in a mode that is kept, or in
    those of the states.
    """
    q, n = np.array(position, dtype=float), len(position)
    # Steps of Newton's method, at most.
    most_steps = 40
    # Newton's method has gone astray beyond this, in units of the motion.
    far = 1e6
    for _ in range(most_steps):
        state = [*q.tolist(), *[0.0] * n]
        mode = kept or field.initial_mode(state, constants)
        pull = field.rates(state, constants, mode)[n:]
        slopes = field.matrix(state, constants, mode)[n:, :n]
        try:  # along what holds nothing changes
            # Singular values that are less than this share of the largest are 0
            # where friction holds.
            step = (
                np.linalg.lstsq(slopes, -pull, 1e-10)[0]
                if field.stays(mode)
                else np.linalg.solve(slopes, -pull)
            )
        except np.linalg.LinAlgError as error:
            raise ConvergenceError("there is no equilibrium near") from error
        q = q + step
        if not magnitude(q) < far or magnitude(step) < 1e-15 * (1 + magnitude(q)):
            break
    if magnitude(q) < far and magnitude(step) < 1e-12:
        return np.concatenate([q, np.zeros(n)])
    raise ConvergenceError("there is no equilibrium near")


def _stays(statistics: MotionStatistics, rest: Equilibrium, noise: float, kinks: bool) -> bool:
    """Whether as little is left as the linearization says: a cycle beside the equilibrium may be
    small too, in the model's units.

    Beyond a kink the linearization says nothing, unless the decay is seen.
    """
    inverse = np.linalg.pinv(rest.vectors)
    before, after = (
        np.sum(np.abs(inverse @ (state - rest.state)) ** 2)
        for state in (statistics.first, statistics.last)
    )
    noise *= _unit(rest)
    # Squares that are larger than this many times what a linear decay leaves of them have
    # not decayed.
    left = 4.0 * before * math.exp(2 * rest.values.real.max() * (statistics.end - statistics.begin))
    return bool(after <= noise**2 or (after <= left and (left < before or not kinks)))


def _persists(statistics: MotionStatistics, rest: Equilibrium, noise: float) -> bool:
    """Whether the motion has parts that nothing damps, as far as eigenvalues say, however small
    they are beside the others.
    """
    inverse = np.linalg.pinv(rest.vectors)
    parts = np.abs(inverse[rest.undamped] @ (statistics.last - rest.state))
    return bool((parts > noise * _unit(rest)).any())


def _unit(rest: Equilibrium) -> float:
    """What the noise of a motion's states, of size 1 and more, is in parts of eigenvectors."""
    return (1e-3 + magnitude(rest.state)) * float(np.linalg.norm(np.linalg.pinv(rest.vectors), 2))


def _decays(statistics: MotionStatistics, rest: Equilibrium, fewest: int) -> bool:
    """Whether the parts of the motion in the eigenvectors die out as their eigenvalues say, within
    a factor of two.

    The squares of the two halves are compared under Hann windows, which hide unfinished beats.
    """
    modes = np.abs(np.linalg.pinv(rest.vectors) @ (statistics.maxima - rest.state).T) ** 2
    since = (
        statistics.begin
        if len(statistics.maxima_t) < KEPT_EXTREMA
        else float(statistics.maxima_t[0])
    )
    window = statistics.end - since
    share = (statistics.maxima_t - since) / window
    if not fewest // 2 - 1 <= np.count_nonzero(share < 0.5) <= len(share) - fewest // 2 + 1:
        return False
    hann = np.sin(2 * np.pi * share) ** 2
    first, second = (
        (hann * part * modes).sum(axis=1) / (hann * part).sum()
        for part in (share < 0.5, share >= 0.5)
    )
    expected = first * np.exp(rest.values.real * window)  # two times half the window
    before, after, linear = first.sum(), second.sum(), expected.sum()
    # A decay that is too slow to show in the window does not count: the first of the three
    # conditions.
    # Smallest decay of the squares over half a window that can be measured.
    return bool(
        0 < linear < before * (1 - 1e-3)
        and after > 0
        and 0.5 < np.log(after / before) / np.log(linear / before) < 2
    )
