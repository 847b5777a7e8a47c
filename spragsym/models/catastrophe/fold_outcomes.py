"""What ends at the folds along a parameter, when, and where it jumps to: from the equilibria on both sides of each fold."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...errors import ConvergenceError
from ...results.equilibria import Equilibria, Stability
from ...results.points import Ended, Points, nothing_ends
from ..mechanics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.foremost import foremost
from .branches import Along, links
from .paths import BESIDE

#: Where two states meet and nothing more is known.
UNDECIDED = "undecided"


def ended(points: Points) -> Ended:
    """Columns ``ends``, ``when`` and ``after`` of points: empty for all but folds along one parameter."""
    found = nothing_ends(len(points), points.columns)
    for row in np.flatnonzero(points.kind == "fold") if len(points.vary) == 1 else ():
        try:
            ends, when, after = _at(points, int(row))
        except ConvergenceError:
            ends, when, after = UNDECIDED, UNDECIDED, {}
        found.ends[row], found.when[row] = ends, when
        for name, value in after.items():
            found.after[name][row] = value
    return found


def _at(points: Points, row: int) -> tuple[str, str, dict[str, float]]:
    """Of one fold: which of the two states that meet is stable, which way they vanish, and what takes the place of that one."""
    (vary,), p, at = points.vary, points.parameters.of(points.parameters.model.search), getattr(points, points.vary[0])
    value, model = float(at[row]), p.model
    stops = _beside(points, row, value)
    eq = equilibria(p.replace(**{vary: stops}))
    (pairs,) = links(Along(Balance(model, contact=True), p, vary, at, points.kind), stops, eq)
    met = [slot for slot in range(int(eq.count[0])) if slot not in pairs]
    when, side = ("up", 0) if met else ("down", 1)
    met = met or [slot for slot in range(int(eq.count[1])) if slot not in pairs.values()]
    if len(met) != 2 or not eq.decided.all():
        raise ConvergenceError(f"the states that meet at {vary} = {value:.17g} are not told apart")
    stable = [eq.stability[side, slot] == Stability.STABLE for slot in met]
    if sum(stable) != 1:
        return "", when, {}
    return ("lower", "upper")[stable.index(True)], when, _after(points, row, eq, 1 - side)


def _beside(points: Points, row: int, value: float) -> Any:
    """Values on both sides of a fold, within the parameter's range and nearer than any other fold."""
    vary, at = points.vary[0], getattr(points, points.vary[0])
    allowed = points.parameters.ranges[vary]
    ends = np.array([*np.delete(at, row), allowed.low, allowed.high])
    room = min(BESIDE * max(1.0, abs(value)), 0.25 * float(np.abs(ends - value).min()))
    if not room > 0:
        raise ConvergenceError(f"{vary} = {value:.17g} is two folds, or an end of the range")
    return np.array([value - room, value + room])


def _after(points: Points, row: int, eq: Equilibria, beyond: int) -> dict[str, float]:
    """The nearest equilibrium that is stable beyond the fold, as it is at the value of the fold."""
    vary, names = points.vary[0], points.parameters.model.coordinates
    before = np.array([getattr(points, name)[row] for name in names])
    slots = [slot for slot in range(int(eq.count[beyond])) if eq.stability[beyond, slot] == Stability.STABLE]
    if not slots:
        return {}
    behind = np.array([eq.coordinates[name][beyond, slots] for name in names])
    apart = np.linalg.norm(behind - before[:, None], axis=0)
    goal = behind[:, foremost(apart, behind, eq.error[beyond, slots] + points.error[row])]
    here = equilibria(points.parameters.replace(**{vary: float(getattr(points, vary)[row])}), method="search")
    states = np.array([here.coordinates[name][: int(here.count)] for name in names])
    if not states.size:
        raise ConvergenceError(f"the states at {vary} = {getattr(points, vary)[row]:.17g} are not told apart")
    slot = int(np.linalg.norm(states - goal[:, None], axis=0).argmin())
    return {name: float(getattr(here, name)[slot]) for name in points.columns}
