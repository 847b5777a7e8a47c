"""States in which friction holds a mass where nothing moves: curves of equilibria, whose ends and
turns are proved.

With the friction coefficient h μ_s, where h in [−1, 1] is the share of the static one that is used,
a state of sticking is an equilibrium at one h, and the other way round. So these states form
curves, which begin and end at h = ±1 or where the contact opens, and may turn back in h at folds.
On a curve a coordinate is least and largest at its ends, or where it turns back itself: there the
slopes of the forces by the other coordinates and h are singular.

|F| ≤ μ_s N holds nothing where N ≤ 0. A contact that opens has no such state, and one that presses
on either of two faces rubs with |N|, by which the same states stick as by N, with shares of the
other sign. Any other given normal force is nowhere negative, or its page is refused: states in
which it is 0 are left out. It is so all along a curve, since a state with N = 0 is one without
friction, at every h.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError, ModelError, ParameterError
from ..core.questions import Method, question
from ..models.forces import named
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import determinant
from ..numerics.interval_arrays import Intervals, ends_around, scale_of
from ..numerics.vectors import TURN, apart
from ..results.points import Points, StickingStates
from ..statics.balance import NEGLIGIBLE
from ..statics.forces import Evaluation
from .defining_systems import Augmented, Condition, Family, slope
from .paths import QuasiStaticContinuation
from .points import arranged, isolated, nothing
from .shares import belt_speeds, held
from .sticking_regions import NotLinear, line, region
from .sticking_sets import Patches, Touches, sets, sets_of


@question
def sticking_states(p: ParameterSet, *, method: Method = "auto") -> StickingStates:
    """All states in which friction holds the mass where the belt stands still, V = 0: intervals of
    each coordinate.

    Parameters
    ----------
    p : Parameters
        Of a model whose page says what friction ``holds``, scalars.
    method
        As for :func:`spragsym.equilibria`.

    Returns
    -------
    StickingStates
        A row for each connected set of states, with the least and the largest value of each
        coordinate in it. Where several frictions hold, of forces that are linear, the set is a
        parallelepiped: ``measure`` is its length, area or volume in the displacements that friction
        opposes. Beside contacts that open, and of other forces, the ends are enclosed, without
        ``measure``, see :mod:`spragsym.bifurcation.sticking_sets`; where states meet in folds over
        the shares of friction that are used, ``complete`` is False, and ``remarks`` say that what
        is told as one set may be several.

    Raises
    ------
    ModelError
        For a model in which friction holds nothing.
    ParameterError
        Where the belt moves, or a parameter is missing or an array.
    ConvergenceError
        Where folds, or states at a limit of the force, are not all decided, as where they only just
        touch that limit, or where the sign of a given normal force is not known.

    Notes
    -----
    Source: |F| ≤ μ_s N and N > 0 with the force of friction F and the normal force N, see
    :mod:`spragsym.bifurcation.sticking`.

    Examples
    --------
    >>> import spragsym as ss
    >>> p = ss.load("coulomb_stick_slip").Parameters(mu_s=0.6, mu_k=0.4, V=0.0)
    >>> found = ss.sticking_states(p)
    >>> found.x_low, found.x_high
    (array([-0.6]), array([0.6]))
    """
    model = p.model
    holding = [entry for entry in model.frictions if entry["holds"]]
    if not holding:
        raise ModelError(
            f"in {model.name} friction holds nothing; a page says what it holds by "
            "page.friction(…, holds=…)"
        )
    for speed, entry in zip(belt_speeds(p), model.frictions, strict=False):
        if np.any(speed):
            belt = entry["belt"]
            raise ParameterError(
                f"the belt moves at {belt} = {speed}, and what sticks rides with it; take "
                f"parameters with {belt} = 0"
            )
    own, names = held(p), [entry["name"] for entry in holding]
    beside = any(entry["border"] and entry["name"] not in names for entry in model.contacts)
    if len(holding) > 1 or beside:
        try:
            return region(p, own)
        except NotLinear:
            return sets(p, own)
    if (found := line(p, own)) is not None:
        return found
    share = named("held", names[0])
    turns = [_turns(own, share, index) for index in range(len(model.coordinates))]
    try:
        continuation = QuasiStaticContinuation(
            own,
            share,
            np.unique(np.concatenate([[-1.0, 1.0], *(points[share] for points in turns)])),
        )
        return _sets(p, Touches(model, own, True), continuation, turns)
    except ConvergenceError as error:
        raise ConvergenceError(
            "not all states of sticking are told apart over the share of the static "
            "coefficient of friction that is used, from "
            "-1 to 1: some may only just touch the limit of friction, or nearly; change a "
            "parameter by some thousandths"
        ) from error


def _turns(own: ParameterSet, share: str, index: int) -> Points:
    """Points where a coordinate turns back along the states, by the share that is used."""
    family = Family.of(own, (share,))

    def equations(at: Evaluation) -> Sequence[Any]:
        columns = [len(at.q) if k == index else k for k in range(len(at.q))]
        return (determinant([[slope(row, column) for column in columns] for row in at.forces()]),)

    system = Augmented(family, Condition(equations, order=1))
    # A small box in contact: what is 0 all over it is 0 for all states.
    small = Intervals.between(*(np.full((system.n, 1), end) for end in (-0.5 - 2.0**-20, -0.5)))
    if (
        system.values(small, system.fixed(1), ()).magnitude[-1, 0] <= NEGLIGIBLE
    ):  # the others and h do not move it
        return arranged(family, nothing(family), "turn")
    return isolated(family, system.condition, "turn")


def _sets(
    p: ParameterSet, it: Touches, continuation: QuasiStaticContinuation, turns: Sequence[Points]
) -> StickingStates:
    """Connected sets of states that are followed from node to node, with the folds and borders at
    which they end.
    """
    eq, balance = continuation.eq, continuation.balance
    # Numbers of the first state of each node, then of folds and borders.
    first = np.concatenate([[0], np.cumsum(eq.count)])
    q = np.concatenate(
        [np.array([column[eq.states] for column in eq.coordinates.values()]), continuation.q],
        axis=1,
    )
    labels, comes_around = np.arange(q.shape[1]), np.zeros(q.shape, dtype=bool)

    def link(node: int, slot: int, goal: int, target: int) -> None:
        """Join the sets of a state and of another one on its curve, or of the point at which it
        vanishes; angles go on there.
        """
        one, other = (
            int(first[at] + there if there >= 0 else first[-1] + ~there)
            for at, there in ((node, slot), (goal, target))
        )
        follow = balance.periodic and target >= 0
        moved = (
            continuation.moved(node, slot, goal)
            if follow
            else apart(q[:, other], q[:, one], balance.periodic)
        )
        off = TURN * np.round((q[:, one] + moved - q[:, other]) / TURN)
        behind = labels == labels[other]
        if behind[one]:
            comes_around[:, one] |= off != 0
        else:
            q[:, behind] += off[:, None]
        labels[behind] = labels[one]

    for node in range(1, continuation.mesh.size):
        goals = [continuation.followed(node, slot) for slot in range(eq.count[node - 1])]
        for slot, goal in enumerate(goals):
            link(node - 1, slot, node, goal)
        for slot in sorted({*range(eq.count[node])} - {*goals}):
            link(node, slot, node - 1, ~continuation.vanishing(node, slot, node - 1))
    error = np.concatenate([eq.error[eq.states], continuation.turns.error])
    ends, share = ends_around(q, error * scale_of(q)), np.zeros((1, error.size))
    pressed = it.pressed(Patches(share, share, ends, ends, np.ones(error.size, dtype=bool)))
    sets = [labels == label for label in np.unique(labels[pressed])]
    if any(not pressed[one].all() for one in sets):
        raise ConvergenceError("the normal force is 0 in some of connected states of sticking")
    low, high = (
        np.array([most(q[:, one], axis=1) for one in sets]).reshape(-1, len(q))
        for most in (np.min, np.max)
    )
    for k in balance.periodic:
        before = TURN * np.floor(low[:, k] / TURN + 0.5)
        low[:, k], high[:, k] = low[:, k] - before, high[:, k] - before
        whole = [bool(comes_around[k, one].any()) for one in sets]
        low[whole, k], high[whole, k] = -0.5 * TURN, 0.5 * TURN
    columns = np.stack([low.T, high.T], axis=1).reshape(2 * len(q), len(sets))
    largest = np.array([error[one].max() for one in sets])
    found = sets_of(p, [*map(Intervals.point, columns)], error=largest)
    parts = [continuation.turns, *turns]
    remarks = dict.fromkeys(
        [*eq.remarks, *(remark for points in parts for remark in points.remarks)]
    )
    complete = bool(eq.whole.all()) and all(points.complete for points in parts)
    return replace(found, complete=complete, remarks=tuple(remarks))
