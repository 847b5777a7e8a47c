"""Classification of the long-run behaviour of a motion, for trajectories, sweeps and basins.

:func:`classify` takes statistics of a motion after its transient and returns an :class:`Outcome`.
It looks for a limit, in this order: lift-off for good, if the model brings a closed-form criterion;
an equilibrium; a cycle (:mod:`.return_map`). A limit is accepted if the motion approaches it at the
rate of its own linearization: by the eigenvalues at the equilibrium, which include the slope of the
friction law, or by the Floquet multipliers of the closed orbit. That two parts of the motion look
alike is not enough.
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
from .holding import held_ahead, held_in_every_phase
from .measures import KEPT_EXTREMA, MotionStatistics
from .problem import Event, Problem
from .regimes import Outcome, Regime
from .return_map import Onward, leads, on_cycle

#: Events of the contact.
CONTACT = [Event.CONTACT_LOST, Event.CONTACT_REGAINED, Event.FACE_LEFT, Event.FACE_REGAINED]


def classify(statistics: MotionStatistics, onward: Onward) -> Outcome:
    """The outcome of a motion, from its statistics after the transient; ``onward`` continues it.

    The computation is in the motion's own units (:mod:`.scales`), the outcome in those of the
    problem. The index ``equilibrium`` is not set: :func:`~spragsym.statics.search.rest_index` finds
    it for many outcomes at once.
    """
    problem = onward.problem
    field, constants = problem.field, problem.constants
    # The proof encloses forces in units of the model.
    if field.clock and not field.natural:
        last, n = statistics.last, len(field.coordinates) - 1
        regime, rate = Regime.EQUILIBRIUM, math.inf
        rest: FloatArray | None = last
        if not held_in_every_phase(field, constants, last):
            reach = problem.options.settled
            rest = held_ahead(field, constants, statistics.first, last, reach)
            regime, rate = Regime.APPROACHES_EQUILIBRIUM, 0.0
        if rest is not None:
            place, distance = tuple(rest[:n].tolist()), magnitude(rest[:n] - last[:n])
            return Outcome(regime, rest=place, rate=rate, distance=distance, names=field.components)
    scales = problem.own_scales
    if not scales.trivial:
        in_scales = replace(onward, problem=scales.problem(problem))
        return scales.outcome(classify(scales.inverse.statistics(statistics), in_scales))
    no_contact = not statistics.events[CONTACT].any()
    if no_contact and field.airborne and field.airborne(constants, statistics.last):
        return Outcome(Regime.LIFT_OFF, names=field.components)
    for each, continued in _with_leads(statistics, onward):
        found = at_rest(each, continued.problem) or on_cycle(each, continued)
        if found:
            return replace(found, names=field.components)
    return Outcome(names=field.components)


def _with_leads(
    statistics: MotionStatistics, onward: Onward
) -> Iterator[tuple[MotionStatistics, Onward]]:
    """The statistics of a motion; then, if its leading coordinate shows no oscillation, those with
    each other coordinate as the leading one, for which the motion is integrated again.
    """
    yield statistics, onward
    if leads(statistics, onward.problem):
        return
    duration = statistics.end - statistics.begin
    for lead in range(1, len(statistics.last) // 2):
        other = onward.with_lead(lead)
        with suppress(ConvergenceError):
            yield other.statistics(statistics.first[None], duration)[0], other


def at_rest(statistics: MotionStatistics, problem: Problem) -> Outcome | None:
    """The outcome of a motion that rests at an equilibrium, which does not repel it, or decays to
    one; None for other motions.
    """
    options, tol = problem.options, problem.options.settled
    still = (
        abs(statistics.last[statistics.lead] - statistics.first[statistics.lead]) <= 4 * tol
        and statistics.reach[1] - statistics.reach[0] <= 4 * tol
    )
    # On a belt at rest the friction law is smooth where x' changes sign.
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
    noise = options.noise * problem.rtol
    # A growth rate up to 1e-12 is 0 up to rounding.
    neighbour = still and distance <= tol and growth <= 1e-12
    if neighbour and _stays(statistics, rest, noise, kinks):
        return Outcome(
            Regime.EQUILIBRIUM, rest=position, rate=max(0.0, rest.rate), distance=distance
        )
    if (
        decaying
        and rest.decay > 0
        and _decays(statistics, rest, options.decay_maxima)
        and not _persists(statistics, rest, noise)
    ):
        regime = Regime.EQUILIBRIUM if distance <= tol else Regime.APPROACHES_EQUILIBRIUM
        return Outcome(regime, rest=position, rate=rest.decay, distance=distance)
    return None


@dataclass(frozen=True)
class Equilibrium:
    """An equilibrium with the eigenvalues and eigenvectors of its linearization, which includes the
    slope of the friction law.

    If frictions hold, it belongs to a continuum of equilibria, of dimension ``held``: this many
    eigenvalues, along the continuum, are 0. Deviations across a sticking contact end at once, and
    have no eigenvalue.
    """

    state: FloatArray
    values: ComplexArray
    vectors: ComplexArray
    held: int

    @property
    def rate(self) -> float:
        """Rate of the approach exp(−rate τ), of the slowest mode; infinite without modes."""
        return -float(self.values.real[~self._along].max(initial=-np.inf))

    @property
    def decay(self) -> float:
        """The same without the :attr:`undamped` modes."""
        return -float(self.values.real[~self._along & ~self.undamped].max(initial=-np.inf))

    @property
    def undamped(self) -> BoolArray:
        """Mask of the modes that neither grow nor decay, up to rounding."""
        sizes = np.abs(self.values)
        return ~self._along & (np.abs(self.values.real) <= 1e-12 * sizes.max())

    @property
    def _along(self) -> BoolArray:
        """Mask of the eigenvalues along the continuum of equilibria."""
        mask = np.zeros(self.values.size, dtype=bool)
        mask[np.argsort(np.abs(self.values))[: self.held]] = True
        return mask


def spectrum_at_rest(
    field: Field, constants: Values, state: FloatArray, mode: Mode
) -> tuple[ComplexArray, ComplexArray]:
    """Eigenvalues and eigenvectors of the linearized motion in a mode.

    If the mode sticks, the linearization is restricted to the subspace without sliding.
    """
    from scipy.linalg import null_space  # slow to import

    numbers = state.tolist()
    basis = np.eye(field.size)
    for border in field.stays(mode):
        assert border.slopes is not None
        normal = np.array(border.slopes(numbers, constants, mode), dtype=float)[: field.size]
        basis = basis @ null_space((normal @ basis)[None])
    values, vectors = np.linalg.eig(basis.T @ field.matrix(numbers, constants, mode) @ basis)
    return values, basis @ vectors


def rest_near(problem: Problem, position: FloatArray) -> Equilibrium | None:
    """The equilibrium found by Newton's method from a position, (n,), with the friction μ(V): the
    nearer of that in contact and that in the mode of the position; None if there is none.

    If friction holds the mass at the position, as on a belt at rest, it is the nearest of the
    equilibria in which friction holds.
    """
    field, constants = problem.field, problem.constants
    numbers = position.tolist()
    here, found = field.resting_mode(numbers, constants), list[tuple[float, FloatArray, Mode]]()
    sliding = here
    if not field.stays(here):
        sliding = field.mode_at_rest(field.at_rest(numbers, constants), constants)
    for mode in dict.fromkeys((sliding, here)):
        with suppress(ConvergenceError):
            state = equilibrium_near(field, constants, position, mode)
            if all(
                border.sign(mode) * border.level(state, constants, mode) >= 0
                for border in field.borders
                if border.kink
            ):
                found.append((magnitude(state[: len(position)] - position), state, mode))
    if not found:
        return None
    _, state, mode = min(found, key=lambda one: one[0])
    return Equilibrium(
        state, *spectrum_at_rest(field, constants, state, mode), len(field.stays(mode))
    )


def equilibrium_near(
    field: Field, constants: Values, position: FloatArray, kept: Mode | None = None
) -> FloatArray:
    """The state of rest found by Newton's method from a position, (2 n,).

    In the mode ``kept``, or else in the mode of each iterate. Raises ConvergenceError if there is
    none.
    """
    q, n = np.array(position, dtype=float), len(position)
    most_steps = 40
    # Newton's method has diverged beyond this, in units of the motion.
    far = 1e6
    for _ in range(most_steps):
        state = [*q.tolist(), *[0.0] * n]
        mode = kept or field.resting_mode(state[:n], constants)
        residual = field.rates(state, constants, mode)[n:]
        jacobian = field.matrix(state, constants, mode)[n:, :n]
        try:
            if field.stays(mode):
                # Friction holds a continuum of equilibria: take the nearest. The Jacobian's
                # singular values along it are 0 up to rounding.
                step = np.linalg.lstsq(jacobian, -residual, 1e-10)[0]
            else:
                step = np.linalg.solve(jacobian, -residual)
        except np.linalg.LinAlgError as error:
            raise ConvergenceError("there is no equilibrium near") from error
        q = q + step
        if not magnitude(q) < far or magnitude(step) < 1e-15 * (1 + magnitude(q)):
            break
    if magnitude(q) < far and magnitude(step) < 1e-12:
        return np.concatenate([q, np.zeros(n)])
    raise ConvergenceError("there is no equilibrium near")


def _stays(statistics: MotionStatistics, rest: Equilibrium, noise: float, kinks: bool) -> bool:
    """True if the deviation from an equilibrium is noise, or has decayed as the linearization
    predicts. A small cycle around the equilibrium does not.

    After crossing ``kinks`` the linearization does not hold: then a decay must be visible.
    """
    inverse = np.linalg.pinv(rest.vectors)
    before, after = (
        np.sum(np.abs(inverse @ (state - rest.state)) ** 2)
        for state in (statistics.first, statistics.last)
    )
    noise *= _amplification(rest)
    duration = statistics.end - statistics.begin
    # Four times the squared deviation that a linear decay leaves.
    bound = 4.0 * before * math.exp(2 * rest.values.real.max() * duration)
    return bool(after <= noise**2 or (after <= bound and (bound < before or not kinks)))


def _persists(statistics: MotionStatistics, rest: Equilibrium, noise: float) -> bool:
    """True if the motion has components in undamped modes above the noise."""
    inverse = np.linalg.pinv(rest.vectors)
    components = np.abs(inverse[rest.undamped] @ (statistics.last - rest.state))
    return bool((components > noise * _amplification(rest)).any())


def _amplification(rest: Equilibrium) -> float:
    """Factor from the relative noise of states to that of their components in eigenvectors."""
    return (1e-3 + magnitude(rest.state)) * float(np.linalg.norm(np.linalg.pinv(rest.vectors), 2))


def _decays(statistics: MotionStatistics, rest: Equilibrium, fewest: int) -> bool:
    """True if the components of the motion in the eigenvectors decay as their eigenvalues predict,
    within a factor of two of the rate.

    The mean squares over the first and the second half of the motion are compared, under Hann
    windows, which suppress unfinished beats. At least about half of the ``fewest`` maxima must be
    in each half.
    """
    squares = np.abs(np.linalg.pinv(rest.vectors) @ (statistics.maxima - rest.state).T) ** 2
    begin = statistics.begin
    if len(statistics.maxima_t) >= KEPT_EXTREMA:  # earlier maxima were dropped
        begin = float(statistics.maxima_t[0])
    window = statistics.end - begin
    share = (statistics.maxima_t - begin) / window
    if not fewest // 2 - 1 <= np.count_nonzero(share < 0.5) <= len(share) - fewest // 2 + 1:
        return False
    hann = np.sin(2 * np.pi * share) ** 2
    first, second = (
        (hann * half * squares).sum(axis=1) / (hann * half).sum()
        for half in (share < 0.5, share >= 0.5)
    )
    # Squares decay twice as fast, over half the window.
    expected = first * np.exp(rest.values.real * window)
    before, after, linear = first.sum(), second.sum(), expected.sum()
    return bool(
        0 < linear < before * (1 - 1e-3)  # else the decay is too slow or too fast to be measured
        and after > 0
        and 0.5 < np.log(after / before) / np.log(linear / before) < 2
    )
