"""A cycle from a state near it, or from a motion that approaches it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from typing import Any

import numpy as np

from ..bifurcation.onsets import Onsets
from ..errors import ConvergenceError, ParameterError, ParameterTypeError
from ..models.field import Field
from ..models.parameters import FINITE, FloatArray, ParameterSet, as_number
from ..motion import Trajectory
from ..motion.flows import Flow
from ..motion.regimes import Outcome, Regime
from ..motion.segment import Turn
from ..motion.shooting import Guess, Loop, across, error_of, extent, rate, solved, split
from .births import born_at
from .orbit import Cycle, cycle_of
from .system import System

#: Returns of a motion are looked at over this time, then over longer ones.
STAGES = (400.0, 3000.0, 20000.0)

#: Most returns of one stretch of motion that are tried.
TRIES = 8

#: A return that misses by more than this share of the motion's extent is not tried.
FAR = 0.3


#: A closed orbit of a smaller extent is rest, as is one whose extent is not so many of its errors.
LEAST, SURE = 1e-9, 100.0

#: So long a motion tells whether a coordinate moves, and a coordinate that moves by such a share of another stands still.
LOOK, STILL = 200.0, 1e-9

#: Turns that are alike to so much, or both ends of a stage without turns, are of a motion at rest.
STANDS = 1e-9

#: Parameters beyond this are named where a motion can't be followed.
STEEP = 1e8


#: What a motion does for which no cycle is found, in words.
COMES_TO = {
    Regime.EQUILIBRIUM: "it is at rest", Regime.APPROACHES_EQUILIBRIUM: "it decays to rest",
    Regime.LIFT_OFF: "it has lifted off for good", Regime.LIMIT_CYCLE: "it is on a cycle that Newton's method did not close",
    Regime.APPROACHES_CYCLE: "it nears a cycle that Newton's method did not close", Regime.UNSETTLED: "it is unsettled",
    Regime.FAILED: "it can't be followed",
}  # fmt: skip


def cycle(
    p: ParameterSet | None = None, near: Any = None, *, V: float | None = None, d: float | None = None,
    backend: str | None = None, patient: bool = True, onset: Onsets | None = None, index: int = 0, amplitude: float | None = None,
) -> Cycle:  # fmt: skip
    """The cycle near a state, or the one that a motion approaches, or the one that is born at an onset of flutter.

    Newton's method on the flow and its derivatives, by multiple shooting; the orbit may lose contact and overtake the belt as
    often as it likes, as the field is continuous there.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    near : array_like, Trajectory or Cycle, optional
        A state near the cycle, stable or not, coordinates, then rates, of the article's model x, y, x', y'; or a motion whose end
        approaches it; or a cycle for other values of the parameters. 0 where left out.
    V, d : float, optional
        In place of those of ``p``.
    backend : {"heyoka", "scipy"}, optional
        As for :func:`~spragsym.simulate`.
    patient : bool
        Whether to follow the motion from a state that is not near a cycle, for up to 20 000 time units.
    onset : Onsets, optional
        Of ``model.flutter_onsets``. They know their model and its parameters: ``p``, ``V``, ``d`` and ``near`` are left out.
    index : int
        The number of the onset among them.
    amplitude : float, optional
        Of the cycle that is born there: half of the range of the coordinate that moves most, to a thousandth; see
        :func:`spragsym.orbits.births.born_at`. The parameter along which the onsets were found takes the value that
        belongs to it.

    Returns
    -------
    Cycle

    Raises
    ------
    ConvergenceError
        Where there is no cycle near: it says what the motion comes to instead.

    Notes
    -----
    Source: (8)–(11). What is found is a cycle to the error that is told; that there are no others is not.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.cycle(ss.Parameters.article(theta0=np.radians(42)), V=0.5, d=10.0)
    >>> round(found.period, 6), found.stable
    (34.26737, True)
    >>> model = ss.load("stick_slip")
    >>> onsets = ss.flutter_onsets(model.Parameters(), vary="V")
    >>> born = ss.cycle(onset=onsets, index=1, amplitude=0.05)
    >>> str(onsets.criticality[1]), born.stable, bool(born.parameters["V"] > onsets.V[1])
    ('dangerous', False, True)
    """
    if onset is not None:
        if p is not None or near is not None:
            raise ParameterTypeError("an onset knows its parameters and its state; leave out p and near, or the onset")
        if not isinstance(onset, Onsets):
            raise ParameterTypeError(f"onset = {onset!r:.60} is no result of ss.flutter_onsets(...)")
        return born_at(onset, index, amplitude, backend)
    if p is None:
        raise ParameterTypeError("p is missing; give parameters, or the onset of a model")
    return cycle_near(System.of(p, backend, V=V, d=d), near, patient=patient)


def cycle_near(system: System, near: Any = None, *, patient: bool = True) -> Cycle:
    """:func:`cycle` of any system."""
    field, flow = system.field, system.flow
    if isinstance(near, Cycle):
        near.require(field, "near")
        return _checked(_towards(flow, near.loop.guess, system.values))
    settled = isinstance(near, Trajectory)
    approached = near is None or settled
    start = near.state[:, -1] if isinstance(near, Trajectory) else _state(field, near)
    constants = system.constants
    if not np.isfinite(rate(field, start, constants)).all():
        raise ParameterError(f"near = {start.tolist()}: the motion is not defined there; give another state")
    for stage in STAGES if patient or settled else STAGES[:1]:
        try:
            passage = flow.plain(start, constants, stage, loose=True)
        except ConvergenceError as error:
            raise ConvergenceError(f"the motion can't be followed: {error}{_steep(system)}") from error
        found = _by_returns(system, list(passage.turns), from_start=stage == STAGES[0], stable=approached)
        if found is not None:
            return _checked(found)
        # A cycle whose period is longer than the stage may not have turned yet: it moves on all the same.
        late = [turn.state for turn in passage.turns[-4:]] if len(passage.turns) > 1 else [start, passage.state]
        start = passage.state
        if np.ptp(late, axis=0).max() < STANDS:
            break
    try:
        outcome = system.motion(start, 2000.0).outcome(1000.0)
    except ConvergenceError as error:
        raise ConvergenceError(f"no cycle was found near the motion, which could not be followed: {error}") from error
    if outcome.limit == Regime.LIMIT_CYCLE and (patient or settled):
        with suppress(ConvergenceError):
            return cycle_at(system, np.array(outcome.cycle), outcome.period)
    raise ConvergenceError(_why(system, start, stage, outcome))


def cycle_at(system: System, state: FloatArray, period: float) -> Cycle:
    """The cycle of about a period near a state: Newton's method and nothing else."""
    return _checked(_from_guess(system.flow, Guess(state[None], period, system.values)))


def _steep(system: System) -> str:
    """What may be too much for an integrator."""
    value, name = max((abs(value), name) for name, value in system.named())
    return f"; {name} = {value:g} is larger than it can carry: give a smaller one" if value > STEEP else ""


def _towards(flow: Flow, known: Guess, values: tuple[float, ...], halvings: int = 6) -> Loop:
    """The closed orbit at other values of the parameters, by steps half as wide where Newton's method fails."""
    try:
        return _from_guess(flow, Guess(known.states, known.period, values))
    except ConvergenceError:
        if halvings == 0 or values == known.values:
            raise
    middle = tuple((a + b) / 2 for a, b in zip(known.values, values, strict=True))
    between = _towards(flow, known, middle, halvings - 1)
    return _towards(flow, between.guess, values, halvings - 1)


def _checked(loop: Loop) -> Cycle:
    if _rests(loop):
        raise ConvergenceError(
            "there is no cycle near: what Newton's method finds is rest, at "
            f"{np.round(loop.states[0], 9).tolist()}; start farther from it"
        )
    return cycle_of(loop)


def _rests(loop: Loop) -> bool:
    """Whether a closed orbit is an equilibrium, which closes after any period, as an orbit beside it nearly does."""
    return extent(loop) <= max(LEAST, SURE * error_of(loop))


def _state(field: Field, near: Any) -> FloatArray:
    state = np.zeros(field.size) if near is None else np.asarray(near, dtype=object)
    if state.shape != (field.size,):
        raise ParameterError(f"near has the shape {state.shape}; give a state of {field.size} numbers, a trajectory or a cycle")
    return np.array([as_number("near", value, FINITE) for value in state.tolist()])


def _by_returns(system: System, turns: list[Turn], *, from_start: bool, stable: bool) -> Loop | None:
    """The first closed orbit that Newton's method finds from two states, largest in x, that are alike."""
    for first, second in islice(_pairs([turn for turn in turns if turn.border == -1], from_start), TRIES):
        try:
            loop = _from_guess(system.flow, Guess(first.state[None], second.t - first.t, system.values))
        except ConvergenceError:
            continue
        # What a motion approaches is stable; near a state that is given there may be either.
        if not _rests(loop) and not (stable and np.abs(loop.multipliers.others).max() > 1):
            return loop
    return None


def _pairs(turns: list[Turn], from_start: bool) -> Iterator[tuple[Turn, Turn]]:
    """Pairs of alike highest states: from the first one on, nearest first, and from the last one back, fewest returns first.

    Of two that there are, as of a long period, their distance is seen against that of the lowest ones.
    """
    highest = [turn for turn in turns if turn.direction < 0]
    if len(highest) < 2:
        return
    states = np.array([turn.state for turn in highest])
    scale = np.ptp(states if len(highest) > 2 else [turn.state for turn in turns], axis=0)
    scale = np.maximum(scale, 1e-2 * scale.max() + 1e-300)
    if from_start and len(highest) > 2:
        away = np.abs((states[1:] - states[0]) / scale).max(axis=1)
        for i in np.argsort(away)[: TRIES // 2]:
            if away[i] < FAR:
                yield highest[0], highest[i + 1]
    away = np.abs((states[:-1] - states[-1]) / scale).max(axis=1)[::-1]
    best = np.inf
    for k, distance in enumerate(away[: min(len(away), 60)]):
        if distance < min(FAR, 0.5 * best):
            best = distance
            yield highest[-2 - k], highest[-1]


def _from_guess(flow: Flow, guess: Guess) -> Loop:
    """Newton's method from a guess, in as many stretches as its growth asks for; it may not go far."""
    loop = split(flow, guess)
    turns = [turn.state for turn in loop.turns()]
    # A guess that begins at a turn may count it at neither end.
    reach = 0.5 * float(np.ptp([loop.states[0], *turns], axis=0).max()) if turns else np.inf
    return solved(flow, loop.guess, across(loop), reach=reach)


def _why(system: System, state: FloatArray, span: float, outcome: Outcome) -> str:
    """What became of a motion that no cycle was found for."""
    told = "no cycle was found near the motion"
    if still := stands_still(system, state):
        return f"{told}: {still}"
    places = [f"{name} = {value:.6g}" for name, value in zip(system.field.coordinates, outcome.rest, strict=False)]
    return (
        f"{told}, followed for up to {span:g} time units: {COMES_TO[outcome.regime]}"
        + (f" at {', '.join(places)}" if places else "")
        + "; give a state nearer to a cycle, as near=simulate(p, t_end=…) of a longer motion, or ask fate(p) what it comes to"
    )


def stands_still(system: System, state: FloatArray) -> str:
    """Reason: nothing moves, or the first coordinate stands still while others move; empty where it moves.

    Returns of a motion are looked at where its first coordinate is largest: there are none then.
    """
    names = system.field.coordinates
    try:
        moved = np.ptp(system.motion(state, LOOK).state[: len(names)], axis=1)
    except ConvergenceError:
        return ""
    if not moved.any():
        return "nothing moves from where it begins, a state of equilibrium; begin beside it"
    if not moved[0] <= STILL * moved.max() or moved.max() <= LEAST:
        return ""
    first, most = names[0], names[int(moved.argmax())]
    return (
        f"{first} stands still while {most} moves, and cycles are looked for where the first coordinate is largest; "
        f"write a model page whose first coordinate is {most}"
    )
