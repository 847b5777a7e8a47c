"""States in which friction holds a mass where nothing moves: curves of equilibria, whose ends and turns are proved.

With the friction coefficient h μ_s, where h in [−1, 1] is the share of the static one that is used, a state of sticking is an
equilibrium at one h, and the other way round. So these states form curves, which begin and end at h = ±1 or where the contact
opens, and may turn back in h at folds. On a curve a coordinate is least and largest at its ends, or where it turns back itself:
there the slopes of the forces by the other coordinates and h are singular.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np
from scipy.sparse.csgraph import connected_components

from ..errors import ConvergenceError, ModelError, ParameterError
from ..models.field import TURN, apart
from ..models.model import Model, parameter_class
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import determinant
from ..numerics.interval_arrays import FloatArray, IntArray, Intervals
from ..questions import Method, question
from ..results.points import Points, StickingStates
from ..statics.balance import NOTHING
from ..statics.forces import State
from .defining_systems import Augmented, Condition, Family, slope
from .paths import Way
from .points import arranged, isolated, nothing

#: The share of the static friction coefficient that is used, a parameter of its own.
HELD = "held"
#: A small box in contact: what is 0 all over it is 0 for all states.
SMALL = -0.5 - 2.0**-20, -0.5


@question
def sticking_states(p: ParameterSet, *, method: Method = "auto") -> StickingStates:
    """All states in which friction holds the mass where the belt stands still, V = 0: intervals of each coordinate.

    Parameters
    ----------
    p : Parameters
        Of a model whose page says what friction ``holds``, scalars.
    method
        As for :func:`spragsym.equilibria`.

    Returns
    -------
    StickingStates
        A row for each connected set of states, with the least and the largest value of each coordinate in it.

    Raises
    ------
    ModelError
        For a model in which friction holds nothing.
    ParameterError
        Where the belt moves, or a parameter is missing or an array.
    ConvergenceError
        Where points at which a set ends or turns back are not all decided.

    Notes
    -----
    Source: |F| ≤ μ_s N with the force of friction F and the normal force N, see :mod:`spragsym.bifurcation.sticking`.

    Examples
    --------
    >>> import spragsym as ss
    >>> p = ss.load("coulomb_stick_slip").Parameters(mu_s=0.6, mu_k=0.4, V=0.0)
    >>> found = ss.sticking_states(p)
    >>> found.x_low, found.x_high
    (array([-0.6]), array([0.6]))
    """
    model = p.model
    if not hasattr(model.algebra, "friction_held"):
        raise ModelError(f"in {model.name} friction holds nothing; a page says what it holds by page.friction(…, holds=…)")
    speed = model.algebra.borders(*np.zeros(2 * len(model.coordinates)), *model.arguments(p, "motion"))[1]
    if np.any(speed):
        belt = model.about["friction"]["belt"]
        raise ParameterError(
            f"the belt moves at {belt} = {speed}, and what sticks rides with it; take parameters with {belt} = 0"
        )
    own = _held(model)(**{name: getattr(p, name) for name in p.ranges})
    turns = [_turns(own, place) for place in range(len(model.coordinates))]
    way = Way(own, HELD, np.unique(np.concatenate([[-1.0, 1.0], *(getattr(points, HELD) for points in turns)])))
    return _sets(p, way, turns)


def _held(model: Model) -> Any:
    """The class of parameters of a model whose friction coefficient is a parameter: the share of the static one that is used."""
    algebra, about, arguments = model.algebra, dict(model.about), model.about["arguments"]
    law = {
        "friction_at_rest": lambda *given: algebra.friction_held(*given)[0],
        "friction_by_parameters": lambda *given: (*[0] * len(model.parameters), algebra.friction_held(*given)[1]),
    }
    share: dict[str, Any] = {"name": HELD, "meaning": "share of the static friction coefficient that is used", "unit": "1"}
    share |= {"domain": "[-1, 1]", "low": -1.0, "high": 1.0, "low_open": False, "high_open": False, "base": 0.0, "role": "both"}
    about["parameters"] = [*about["parameters"], share]
    about["arguments"] = arguments | {name: [*arguments["motion"], HELD] for name in law}
    kind: Any = parameter_class(about, model.where)
    module: Any = SimpleNamespace(**vars(algebra) | law)
    kind._model = Model(model.where, about, lambda: module, kind)
    return kind


def _turns(own: Any, place: int) -> Points:
    """Where a coordinate turns back along the states."""
    family = Family.of(own, (HELD,))

    def equations(at: State) -> Sequence[Any]:
        columns = [len(at.q) if k == place else k for k in range(len(at.q))]
        return (determinant([[slope(row, column) for column in columns] for row in at.forces()]),)

    system = Augmented(family, Condition(equations, order=1))
    small = Intervals.between(*(np.full((system.n, 1), end) for end in SMALL))
    if system.values(small, system.fixed(1), ()).magnitude[-1, 0] <= NOTHING:  # the others and h do not move it
        return arranged(family, nothing(family), "turn")
    found = isolated(family, system.condition, "turn")
    if not found.decided:
        name = family.balance.coordinates[place]
        raise ConvergenceError(f"where {name} turns back along the states is not all decided: {'; '.join(found.remarks)}")
    return found


def _sets(p: Any, way: Way, turns: Sequence[Points]) -> StickingStates:
    """Connected sets of states that are followed from stop to stop, with the folds and borders at which they end."""
    eq, balance = way.eq, way.balance
    first = np.concatenate([[0], np.cumsum(eq.count)])  # numbers of states, stop by stop, then those of folds and borders
    q = np.concatenate([np.array([column[eq.states] for column in eq.coordinates.values()]), way.q], axis=1)
    links, moved = [], []

    def link(stop: int, slot: int, goal: int, place: int) -> None:
        """A state and another one on its curve, or the point at which it vanishes."""
        one, other = (int(first[at] + there if there >= 0 else first[-1] + ~there) for at, there in ((stop, slot), (goal, place)))
        links.append((one, other))
        follow = balance.around and place >= 0
        moved.append(way.moved(stop, slot, goal) if follow else apart(q[:, other], q[:, one], balance.around))

    for stop in range(1, way.stops.size):
        goals = [way.followed(stop, slot) for slot in range(eq.count[stop - 1])]
        for slot, goal in enumerate(goals):
            link(stop - 1, slot, stop, goal)
        for slot in sorted({*range(eq.count[stop])} - {*goals}):
            link(stop, slot, stop - 1, ~way.vanishing(stop, stop - 1, slot))
    signs = np.zeros((len(links), q.shape[1]))
    for row, ends in enumerate(links):
        signs[row, ends] = -1.0, 1.0
    count, labels = connected_components(signs.T @ signs, directed=False)
    sets = [np.flatnonzero(labels == label) for label in range(count)]
    if balance.around:
        _go_on(q, sets, signs, np.array(moved), balance.around)
    error = np.concatenate([eq.error[eq.states], way.turns.error])
    found = {
        f"{name}_{end}": np.array([most(q[k, one]) for one in sets])
        for k, name in enumerate(balance.coordinates)
        for end, most in (("low", np.min), ("high", np.max))
    }
    order = np.lexsort([*found.values()][::-1])
    parts = [way.turns, *turns]
    remarks = dict.fromkeys([*eq.remarks, *(remark for points in parts for remark in points.remarks)])
    complete = bool(eq.whole.all()) and all(points.complete for points in parts)
    largest = np.array([error[one].max() for one in sets])
    return StickingStates(p, largest[order], complete, tuple(remarks), {name: end[order] for name, end in found.items()})


def _go_on(q: FloatArray, sets: Sequence[IntArray], signs: FloatArray, moved: FloatArray, around: Sequence[int]) -> None:
    """Angles that come around are put where they go on from the first of their set; all of the turn where a set goes around."""
    seen = np.linalg.lstsq(signs, moved)[0].T
    strays = np.abs(signs @ seen.T - moved) > 1.0
    for k, one in itertools.product(around, sets):
        q[k, one] += TURN * np.round((seen[k, one] - seen[k, one[0]] - (q[k, one] - q[k, one[0]])) / TURN)
        q[k, one] -= TURN * np.floor(q[k, one].min() / TURN + 0.5)
        if signs[strays[:, k]][:, one].any():
            q[k, one] = np.where(one == one[0], -0.5 * TURN, 0.5 * TURN)
