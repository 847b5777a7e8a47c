"""Sticking states: equilibria held by dry friction where nothing moves, as curves with proved ends.

Let the friction coefficient be h μ_s, where h in [−1, 1] is the share of the static coefficient
that is used. Then each sticking state is an equilibrium for one h, and conversely. So sticking
states form curves, which begin and end at h = ±1 or where the contact opens, and have limit points
in h at folds. A coordinate is extreme at the ends of a curve or at its own limit points, where the
Jacobian of the forces by the other coordinates and h is singular.

|F| ≤ μ_s N holds nothing where N ≤ 0. A contact that opens has no sticking state there. A contact
that presses on either of two faces has friction by |N|: the same states stick as by N, with shares
of the other sign. Any other prescribed normal force is never negative, or its page is refused;
states in which it is 0 are excluded. They are whole curves, since a state with N = 0 is one without
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
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    ends_around,
    quiet,
    scale_of,
)
from ..numerics.vectors import TURN, state_difference
from ..results.points import Points, StickingStates
from ..statics.balance import NEGLIGIBLE
from ..statics.forces import Evaluation, belt_speeds, resting
from .defining_systems import Augmented, Condition, Family, slope
from .paths import QuasiStaticContinuation
from .points import arranged, isolated, nothing
from .shares import held
from .sticking_regions import NotLinear, line, region
from .sticking_sets import Patches, StickingSystem, sets, sets_of


@question
def sticking_states(p: ParameterSet, *, method: Method = "auto") -> StickingStates:
    """All states in which friction holds what lies on belts at rest, V = 0, as intervals of each
    coordinate.

    Where other belts move, their frictions slide: then some parts stick and others slide.

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
        coordinate. With several frictions and linear forces, the set is a parallelepiped, and
        ``measure`` is its length, area or volume in the displacements that friction opposes. With
        contacts that open, or other forces, the ends are enclosed, without ``measure``, see
        :mod:`spragsym.bifurcation.sticking_sets`. If states meet in folds over the shares of
        friction, ``complete`` is False, and ``remarks`` say that one set may in fact be several.

    Raises
    ------
    ModelError
        For a model without friction that holds.
    ParameterError
        If all belts move on which friction holds, or a parameter is missing or an array.
    ConvergenceError
        If folds, or states at a limit of the force, are not all decided, as where states just touch
        that limit, or if the sign of a prescribed normal force is not known.

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
    if not any(entry["holds"] for entry in model.frictions):
        raise ModelError(
            f"in {model.name} friction holds nothing; a page says what it holds by "
            "page.friction(…, holds=…)"
        )
    names = resting(p)
    if not names:
        told = zip(belt_speeds(p), model.frictions, strict=False)
        belt, speed = next((entry["belt"], speed) for speed, entry in told if entry["holds"])
        raise ParameterError(
            f"the belt moves at {belt} = {speed}, and what sticks rides with it; take "
            f"parameters with {belt} = 0"
        )
    own = held(p, names)
    others_open = any(entry["border"] and entry["name"] not in names for entry in model.contacts)
    if len(names) > 1 or others_open:
        try:
            return region(p, own)
        except NotLinear:
            return sets(p, own)
    found = line(p, own)
    if found is not None:
        return found
    share = named("held", names[0])
    turns = [_turns(own, share, index) for index in range(len(model.coordinates))]
    mesh = np.unique(np.concatenate([[-1.0, 1.0], *(points[share] for points in turns)]))
    try:
        continuation = QuasiStaticContinuation(own, share, mesh)
        return _sets(p, StickingSystem(model, own, True), continuation, turns)
    except ConvergenceError as error:
        raise ConvergenceError(
            "not all states of sticking are told apart over the share of the static "
            "coefficient of friction that is used, from "
            "-1 to 1: some may only just touch the limit of friction, or nearly; change a "
            "parameter by some thousandths"
        ) from error


def _turns(own: ParameterSet, share: str, index: int) -> Points:
    """Limit points of one coordinate along the sticking states, by the share that is used."""
    family = Family.of(own, (share,))

    def equations(at: Evaluation) -> Sequence[Any]:
        columns = [len(at.q) if k == index else k for k in range(len(at.q))]
        return (determinant([[slope(row, column) for column in columns] for row in at.forces()]),)

    system = Augmented(family, Condition(equations, order=1))
    # If the determinant is 0 all over a small box in contact, it is 0 by structure: the coordinate
    # does not depend on the others and h.
    small = Intervals.between(*(np.full((system.n, 1), end) for end in (-0.5 - 2.0**-20, -0.5)))
    if system.values(small, system.fixed(1), ()).magnitude[-1, 0] <= NEGLIGIBLE:
        return arranged(family, nothing(family), "turn")
    return isolated(family, system.condition, "turn")


def _connected(
    continuation: QuasiStaticContinuation,
) -> tuple[FloatArray, IntArray, BoolArray]:
    """Coordinates of the states at all nodes of the mesh of shares, followed by the folds and
    borders at which states vanish, (n, N); the label of the connected set of each, (N,); and the
    mask of periodic angles that make a turn along a closed set, (n, N).

    States are connected by continuation from node to node. Periodic angles are continuous along a
    set.
    """
    eq, balance = continuation.eq, continuation.balance
    # Index of the first state of each node, and of the first fold or border.
    first = np.concatenate([[0], np.cumsum(eq.count)])
    states = np.array([column[eq.states] for column in eq.coordinates.values()])
    q = np.concatenate([states, continuation.q], axis=1)
    labels, comes_around = np.arange(q.shape[1]), np.zeros(q.shape, dtype=bool)

    def index(node: int, location: int) -> int:
        """Index of a slot at a node, or of the fold or border ``~location``."""
        return int(first[node] + location if location >= 0 else first[-1] + ~location)

    def link(node: int, slot: int, goal: int, target: int) -> None:
        """Join the sets of a state and of its continuation at the node ``goal``."""
        one, other = index(node, slot), index(goal, target)
        if balance.periodic and target >= 0:
            change = continuation.moved(node, slot, goal)
        else:
            change = state_difference(q[:, other], q[:, one], balance.periodic)
        with quiet():  # at infinity nothing is turned
            turns = TURN * np.round(np.nan_to_num(q[:, one] + change - q[:, other]) / TURN)
        joined = labels == labels[other]
        if joined[one]:
            comes_around[:, one] |= turns != 0
        else:
            q[:, joined] += turns[:, None]
        labels[joined] = labels[one]

    for node in range(1, continuation.mesh.size):
        goals = [continuation.followed(node, slot) for slot in range(eq.count[node - 1])]
        for slot, goal in enumerate(goals):
            link(node - 1, slot, node, goal)
        for slot in sorted({*range(eq.count[node])} - {*goals}):
            link(node, slot, node - 1, ~continuation.vanishing(node, slot, node - 1))
    return q, labels, comes_around


def _sets(
    p: ParameterSet,
    system: StickingSystem,
    continuation: QuasiStaticContinuation,
    turns: Sequence[Points],
) -> StickingStates:
    """Connected sets of sticking states with one share; ``turns`` are the points at which a
    coordinate has an extremum.
    """
    eq, balance = continuation.eq, continuation.balance
    q, labels, comes_around = _connected(continuation)
    error = np.concatenate([eq.error[eq.states], continuation.turns.error])
    far, pressed = ~np.isfinite(q).all(axis=0), np.zeros(error.size, dtype=bool)
    near, share = q[:, ~far], np.zeros((1, np.count_nonzero(~far)))
    ends = ends_around(near, error[~far] * scale_of(near))
    pressed[~far] = system.pressed(Patches(share, share, ends, ends, np.ones(share.size, bool)))
    sets = [labels == label for label in np.unique(labels[pressed])]
    if any(not (pressed | far)[one].all() for one in sets):
        raise ConvergenceError("the normal force is 0 in some of connected states of sticking")
    low, high = (
        np.array([most(q[:, one], axis=1) for one in sets]).reshape(-1, len(q))
        for most in (np.fmin.reduce, np.fmax.reduce)
    )
    for k in balance.periodic:
        turns_before = TURN * np.floor(low[:, k] / TURN + 0.5)
        low[:, k] -= turns_before
        high[:, k] -= turns_before
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
    if np.isnan(q[:, far]).any():
        remarks[
            "where states run to infinity, limits of what stays finite are not among the ends"
        ] = None
        complete = False
    return replace(found, complete=complete, remarks=tuple(remarks))
