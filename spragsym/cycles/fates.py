"""The value of a parameter at which a motion from a given start changes its fate, and the saddle that it then hovers at."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..display import Result
from ..dynamics.field import Field
from ..dynamics.flows import carrier
from ..dynamics.passage import Fly
from ..dynamics.regimes import ATTRACTOR, Outcome, Regime
from ..errors import ConvergenceError, ParameterError
from ..parameters import FINITE, FloatArray, Parameters, as_number
from .finding import cycle_near
from .saddles import Saddle, saddle_near, side
from .sprag import SPRAG

#: A motion is judged at the first of these times, and again at the next as long as it is unsettled.
JUDGED = (2000.0, 10_000.0)

#: Bisection by verdicts ends at this share of the bracket where the saddle is an equilibrium.
NARROW = 1e-4

#: A motion that comes as close as this to an equilibrium hovers at it.
CLOSE = 0.05


@dataclass(frozen=True, eq=False)
class FateBoundary(Result):
    """Where a start changes its fate.

    Attributes
    ----------
    vary : str
    value : float
        Of that parameter.
    error : float
        Estimate: how much the last refinement and another tolerance change it.
    saddle : str
        "equilibrium" or "cycle", or "unknown".
    state : ndarray, shape (m,)
        The saddle's: of a cycle, where its first coordinate is largest.
    growth : float
        The saddle's eigenvalue, or for a cycle the logarithm of its multiplier over its period.
    distance : float
        How near the motion comes to that.
    below, above : Outcome
        What the start comes to on either side.
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


def fate_boundary(
    p: Parameters, *, vary: str, bracket: tuple[float, float], V: float | None = None, d: float | None = None,
    start: Any = (0.0, 0.0, 0.0, 0.0), backend: str | None = None,
) -> FateBoundary:  # fmt: skip
    """The value of a parameter at which a start changes its fate, and which saddle it then hovers at.

    Bisection on what the classifier says of the motion; then, where the saddle is an equilibrium, the value at which the
    motion never leaves along the direction of growth, followed to longer and longer times.

    Parameters
    ----------
    p : Parameters
        Scalars; the one that varies is replaced.
    vary : str
        theta0, mu0, kappa, alpha, sigma, beta, V or d.
    bracket : tuple of float
        Two values with different fates. Where there are several changes between them, one is found.
    V, d : float, optional
        In place of those of ``p``.
    start : array_like of 4 numbers
        x, y, x', y'.

    Returns
    -------
    FateBoundary

    Raises
    ------
    ParameterError
        Where both ends have the same fate.

    Notes
    -----
    Source: (8)–(11) with (10) as the friction law; a saddle's stable manifold separates the fates.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article()
    >>> found = ss.fate_boundary(p, vary="theta0", bracket=(0.72101, 0.72102), V=0.5, d=10.0)
    >>> round(found.value, 8), found.saddle
    (0.72101173, 'equilibrium')
    """
    if vary not in SPRAG.parameters:
        raise ParameterError(f"vary = {vary!r} is not one of {', '.join(SPRAG.parameters)}")
    values = p.given(V=V, d=d).replace(**{vary: bracket[0]}).scalars(*p.ranges)
    state = np.array([as_number("start", value, FINITE) for value in start])
    low, high = (as_number("bracket", value, FINITE) for value in bracket)
    return boundary_of(SPRAG, values, vary, (low, high), state, backend)


def boundary_of(
    field: Field, values: tuple[float, ...], vary: str, bracket: tuple[float, float], start: FloatArray,
    backend: str | None = None,
) -> FateBoundary:  # fmt: skip
    """As :func:`fate_boundary`, of any field."""
    index = field.parameters.index(vary)
    fly, name = carrier(field, backend)

    def at(value: float) -> tuple[float, ...]:
        field.check(vary, value)
        return (*values[:index], value, *values[index + 1 :])

    def judged(value: float) -> Outcome:
        return verdict(field, at(value), start, name)

    low, high = sorted(bracket)
    below, above = judged(low), judged(high)
    if fate(below) == fate(above):
        raise ParameterError(
            f"bracket = ({low:g}, {high:g}): the start comes to {below.regime.name} at both ends; give values of different fates"
        )
    width = high - low

    def narrowed(share: float) -> None:
        nonlocal low, high, below, above
        while high - low > share * width and low < (low + high) / 2 < high:
            middle = (low + high) / 2
            outcome = judged(middle)
            if fate(outcome) == fate(below):
                low, below = middle, outcome
            else:
                high, above = middle, outcome

    narrowed(NARROW)
    nearest, duration, distance = _hovering(field, fly, at(low), start, 400.0)
    saddle = saddle_near(field, at(low), nearest) if distance < CLOSE else None
    if saddle is not None:
        value, error = _polished(field, fly, at, (low, high), start, duration, saddle)
        saddle = saddle_near(field, at(value), saddle.state) or saddle  # it moves with the parameter
        return FateBoundary(vary, value, error, "equilibrium", saddle.state, saddle.growth, distance, below, above)
    narrowed(1e-14)
    try:
        apart = _apart(field, at(low), at(high), start, name)
        cycle = cycle_near(field, at(low), apart, name, patient=False)
    except ConvergenceError:
        return FateBoundary(vary, (low + high) / 2, high - low, "unknown", nearest, float("nan"), distance, below, above)
    growth = float(np.log(np.abs(cycle.multipliers[1])) / cycle.period)
    off = float(np.abs(apart - cycle.state).max())
    return FateBoundary(vary, (low + high) / 2, high - low, "cycle", cycle.state, growth, off, below, above)


def fate(outcome: Outcome) -> tuple[Regime, int, float]:
    """What makes two motions' ends the same: kind, equilibrium, period."""
    kind = ATTRACTOR.get(outcome.regime, outcome.regime)
    return kind, outcome.equilibrium, round(outcome.period, 2) if outcome.period > 0 else 0.0


def verdict(field: Field, values: tuple[float, ...], start: FloatArray, backend: str) -> Outcome:
    """What a motion comes to, judged later where it is unsettled."""
    outcome = Outcome()
    for t_end in JUDGED:
        outcome = field.simulate(values, start, t_end, backend=backend, rtol=1e-12).outcome(0.5 * t_end)
        if outcome.regime not in (Regime.UNSETTLED, Regime.FAILED):
            break
    return outcome


def _hovering(
    field: Field, fly: Fly, values: tuple[float, ...], start: FloatArray, span: float
) -> tuple[FloatArray, float, float]:
    """The state nearest to an equilibrium that the motion passes, when, and how far from it: among its turns."""
    best = (np.array(start), 0.0, np.inf)
    none = np.zeros((2, len(field.parameters)))
    for turn in fly(start, field.constants(values), span, none).turns:
        try:
            saddle = saddle_near(field, values, turn.state)
        except ConvergenceError:
            continue
        if saddle is not None:
            off = float(np.abs(turn.state - saddle.state).max())
            if off < best[2]:
                best = (turn.state, turn.t, off)
    return best


def _polished(
    field: Field, fly: Fly, at: Any, bracket: tuple[float, float], start: FloatArray, duration: float, near: Saddle
) -> tuple[float, float]:  # fmt: skip
    """The value at which the motion does not leave along the direction of growth, for longer and longer times."""

    def off(value: float, span: float) -> float:
        values = at(value)
        saddle = saddle_near(field, values, near.state)
        if saddle is None:
            raise ConvergenceError("the saddle has gone")
        return side(field, fly, values, start, span, saddle if saddle.measure @ near.direction > 0 else _turned(saddle))[0]

    low, high = bracket
    value, change = (low + high) / 2, high - low
    span = duration
    for _ in range(60):
        one, other = value, value + max(1e-3 * change, 4e-16 * (1 + abs(value)))
        a, b = off(one, span), off(other, span)
        for _ in range(8):
            if a == b or abs(other - one) <= 2e-16 * abs(other):
                break
            one, other, a = other, other - b * (other - one) / (b - a), b
            if abs(other - value) > 100 * (change + 1e-12):
                return value, change
            b = off(other, span)
        moved, value = abs(other - value), other
        change = max(moved, 1e-16)
        if moved < 1e-13 * (1 + abs(value)):
            return value, max(moved, 1e-14 * (1 + abs(value)))
        span += 2 / near.growth
    return value, change


def _turned(saddle: Saddle) -> Saddle:
    return Saddle(saddle.state, saddle.growth, -saddle.direction, -saddle.measure)


def _apart(field: Field, low: tuple[float, ...], high: tuple[float, ...], start: FloatArray, backend: str) -> FloatArray:
    """Where two motions are shortly before they part."""
    one, other = (field.simulate(values, start, 2000.0, backend=backend, rtol=1e-12) for values in (low, high))
    times = np.linspace(0.0, 2000.0, 20001)
    off = np.abs(one(times) - other(times)).max(axis=0)
    parted = int(np.argmax(off > 1e-4)) if (off > 1e-4).any() else len(times) - 1
    state: FloatArray = one(times[max(parted - 400, 0)])
    return state
