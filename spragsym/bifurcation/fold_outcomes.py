"""Outcome of folds along a parameter, from the normal form: the state that ends, the direction, and the state after the jump.

With K v = 0 and w K = 0 the states near a fold are q + s v, where w · ∂F/∂λ δλ + ½ w · D²F(v, v) s² = 0 up to higher order, and
det K changes by s ∇(det K) · v. At a regular fold none of these numbers is 0, and each is enclosed over the fold's box.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..numerics.arithmetic import cofactor
from ..numerics.interval_arrays import FloatArray, Intervals, stacked
from ..numerics.jets import constant, gradient, variables
from ..results.equilibria import Stability
from ..results.points import Ended, Points, nothing_ends, nowhere
from ..statics.equilibria import equilibria
from ..statics.reference_state import nearest_state
from ..statics.stability import with_a_zero
from .bifurcation_conditions import FOLD, change
from .defining_systems import Augmented
from .families import Family

#: Where two states meet and nothing more is known.
UNDECIDED = "undecided"
#: Errors of a fold beyond it where its two states are gone for certain.
BEYOND = 4.0


def ended(points: Points) -> Ended:
    """Columns ``ends``, ``when`` and ``after`` of points: empty for all but folds along one parameter."""
    found = replace(nothing_ends(points), after=_afterwards)
    for row in np.flatnonzero(points.kind == "fold") if len(points.vary) == 1 else ():
        try:
            found.ends[row], found.when[row] = _at(points, int(row))
        except ConvergenceError:
            found.ends[row] = found.when[row] = UNDECIDED
    return found


def _at(points: Points, row: int) -> tuple[str, str]:
    """Outcome of one fold: which of the two states is stable, and in which direction they vanish."""
    family = Family.of(points.parameters.of(points.parameters.model.search), points.vary)
    z = np.array([float(getattr(points, name)[row]) for name in (*family.balance.coordinates, *family.vary)])
    size = points.error[row] * np.maximum(1.0, np.abs(z))
    side, lower = _normal_form(family, Intervals(np.stack([size - z, size + z])[:, :, None]))
    when = "up" if side < 0 else "down"
    if with_a_zero(family.balance, z[:-1, None], family.at(z[-1:, None])) != Stability.STABLE:
        return "", when
    return "lower" if lower else "upper", when


def _normal_form(family: Family, box: Intervals) -> tuple[int, bool]:
    """On which side of a fold its two states are, 1 or −1 as the parameter goes, and whether det K > 0 in the lower one."""
    system, balance = Augmented(family, FOLD), family.balance
    with np.errstate(all="ignore"):
        at = system.state(variables(list(box), 1), system.fixed(1), (1,))
        K, n = at.stiffness(), balance.n
        rows = balance.by_coordinate("forces", at.q, at.directions, at.values)
        adjugate = [[constant(cofactor(K, j, i)) for j in range(n)] for i in range(n)]
        sizes = np.abs([[stacked([entry], (1,))[0].middle[0] for entry in line] for line in adjugate])
        r, c = np.unravel_index(int(sizes.argmax()), sizes.shape)
        pushed = sum(gradient(force, n + 1)[n] * w for force, w in zip(rows, adjugate[r], strict=True))
        curved = constant(change(K, int(c)))
        bent = curved * adjugate[r][c]
        side = -_sign(pushed) * _sign(bent)
        first = next((sign for sign in (_sign(line[c]) for line in adjugate) if sign), 0)
    if not side or not first:
        raise ConvergenceError("the normal form at the fold is not known well enough")
    return side, first * _sign(curved) < 0


def _sign(value: Any) -> int:
    """1 or −1 where it is known, else 0."""
    number = stacked([value], (1,))[0]
    return int(number.low[0] > 0) - int(number.high[0] < 0)


def _afterwards(points: Points) -> dict[str, FloatArray]:
    """Column ``after``, a search at each fold at which a stable state ends."""
    found = nowhere(points)
    for row in np.flatnonzero(np.isin(points.ends, ("lower", "upper"))):
        for name, value in _after(points, int(row), 1 if points.when[row] == "up" else -1).items():
            found[name][row] = value
    return found


def _after(points: Points, row: int, forward: int) -> dict[str, float]:
    """The nearest equilibrium that is stable beyond the fold, as near to it as the two that meet are gone for certain."""
    vary = points.vary[0]
    value, allowed = float(getattr(points, vary)[row]), points.parameters.ranges[vary]
    beyond = value + forward * BEYOND * max(1.0, abs(value)) * float(points.error[row])
    beyond = beyond if allowed.low < beyond < allowed.high else value
    here = equilibria(points.parameters.replace(**{vary: beyond}), method="search")
    stable = here.stability == Stability.STABLE
    if not (here.decided and stable.any()):
        return {}
    before = {name: float(getattr(points, name)[row]) for name in points.parameters.model.coordinates}
    slot = nearest_state(here, before, stable, here.error + points.error[row])
    return {name: float(getattr(here, name)[slot]) for name in points.columns}
