"""The reference state: the equilibrium of small deformation that is followed unless another is
chosen.

Choices of the smallest or nearest state break ties by the coordinates, so that the answer does not
depend on rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from operator import mul
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..models.forces import named, undecorated
from ..models.model import Model
from ..models.parameters import ParameterSet
from ..numerics import boxes, contractors
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    Intervals,
    Shape,
    hulls_of,
    matrix,
    quiet,
    scale_of,
    stacked,
)
from ..numerics.jets import gradient, variables
from ..results import Equilibria, EquilibriumType
from . import stability
from .balance import Balance
from .equilibria import equilibria
from .forces import as_intervals
from .namespaces import XP

#: A strain energy is convex at the origin if the least eigenvalue of its stiffness there exceeds
#: this share of the largest.
LEAST_CONVEXITY = 1e-6
#: Strain energies that differ by less than this share of the largest are equal.
SAME_ENERGY = 1e-9
#: A contact touches at the origin if its gap there is at most this, in the page's own length: a gap
#: that is 0 has rounding errors.
TOUCHES = 1e-12


def reference_state(eq: Equilibria, near: Mapping[str, float] | None = None) -> IndexArray:
    """Slot of the stable equilibrium of least strain energy, for each point; where none is stable,
    of least strain energy among all.

    ``eq`` are equilibria in contact, of any shape, with slots as the last axis. With
    ``near``, a value for each coordinate, the nearest state is chosen instead.

    Strain energy is that of springs, torsion springs, contact and the page's potentials, without
    applied forces. Where it is convex at the origin of the coordinates, its second-order expansion
    there is used, of several contacts with those that touch there. A spring that has flipped, as in
    a truss that snapped through, then counts as deformed even if it is relaxed again. Of states of
    equal energy, as mirror images, the one with the smaller |first coordinate| is taken, then the
    one with larger coordinates.
    """
    q = list(eq.coordinates.values())
    stable = eq.undamped == EquilibriumType.STABLE
    among = np.where(stable.any(axis=-1, keepdims=True), stable, ~np.isnan(q[0]))
    return chosen_state(eq.parameters, q, eq.error, among, near)


def reference_place(
    p: ParameterSet, near: Mapping[str, float] | None, where: str
) -> tuple[FloatArray, str, float]:
    """Coordinates of the reference state at one point, its touching contacts, and a bound on its
    error.

    The contacts are empty if the model has only one combination. Raises ConvergenceError, which
    names ``where``, if no state is known to be stable.
    """
    eq = equilibria(p)
    if not eq.decided or not (eq.undamped == EquilibriumType.STABLE).any():
        raise ConvergenceError(f"no state {where}")
    slot = reference_state(eq, near)
    touching = str(eq.touching[slot]) if p.model.has_regimes else ""
    state = np.array([eq.coordinates[name][slot] for name in p.model.coordinates])
    return state, touching, float(eq.error[slot])


def nearest_state(
    eq: Equilibria,
    near: Mapping[str, float],
    among: BoolArray | bool = True,
    error: float | FloatArray = 0.0,
) -> IndexArray:
    """Slot of the equilibrium nearest to given coordinates, for each point.

    Only states marked in ``among`` are considered; ``error`` bounds the errors of coordinates.
    """
    q = [eq.coordinates[name] for name in near]
    return _nearest(
        q,
        [row - value for row, value in zip(q, near.values(), strict=True)],
        error,
        ~np.isnan(q[0]) & among,
    )


def _nearest(
    q: Sequence[FloatArray], off: Sequence[FloatArray], error: FloatArray | float, among: BoolArray
) -> IndexArray:
    """Slot of the least distance ``off`` among those marked."""
    return least_slot(np.where(among, np.linalg.norm(off, axis=0), np.inf), np.array(q), error)


def chosen_state(
    p: ParameterSet,
    q: Sequence[FloatArray],
    error: FloatArray,
    among: BoolArray,
    near: Mapping[str, float] | None,
) -> IndexArray:
    """Slot of the reference state, or of the state nearest to ``near``, from coordinates.

    ``q`` and ``error`` have slots as the last axis; ``among`` marks the slots to choose from.
    """
    model = p.model
    if near is not None:
        return _nearest(
            q,
            [q[model.coordinates.index(name)] - value for name, value in near.items()],
            error,
            among,
        )
    (_, example), *_ = model.cases()
    # Parameters of the motion may be missing: any value serves, since strain ignores them.
    missing = {name: example[name] for name in model.parameters if p[name] is None}
    given = [value[..., None] for value in model.arguments(p.replace(**missing), "motion")]
    energy, shape = undecorated(model.algebra.strain_energy), (*p.shape, 1)
    with quiet():  # empty slots are NaN
        strain = energy(*q, *given, *_pushing(model, p, q), xp=np)
        state = np.array(q)
        pushing = _pushing(model, p, np.zeros((len(q), *shape)), TOUCHES)
        touching = [one if isinstance(one, int) else Intervals.point(one) for one in pushing]
        arguments = [*map(Intervals.point, given), *touching]
        expansion = _at_origin(lambda q: energy(*q, *arguments, xp=XP), len(q), shape)
        at_origin, slope, stiffness = (part.middle for part in expansion)
        at_origin = np.nan_to_num(np.abs(at_origin))
        quadratic = (state[:, None] * stiffness * state).sum(axis=(0, 1))
        second_order = (slope * state).sum(axis=0) + 0.5 * quadratic
    convex = np.asarray(np.isfinite(stiffness).all(axis=(0, 1)) & _has_stiffness(model))
    low, high = _stiffest(stiffness, convex)
    convex &= low > LEAST_CONVEXITY * high
    strain = np.where(convex, second_order, strain)
    strain = np.where(among & np.isfinite(strain), strain, np.inf)
    sizes = np.abs(strain).max(axis=-1, keepdims=True, initial=0.0, where=np.isfinite(strain))
    largest = np.maximum(sizes, at_origin)  # two states may both be relaxed, but for rounding
    # Strain energies of mirror images differ by rounding.
    least = strain <= strain.min(axis=-1, keepdims=True, initial=np.inf) + SAME_ENERGY * largest
    return least_slot(np.where(least & among, np.abs(q[0]), np.inf), np.array(q), error)


def _at_origin(energy: Callable[[Any], Any], n: int, shape: Shape) -> tuple[Intervals, ...]:
    """Enclosures of the strain energy, its gradient and its Hessian where all coordinates are 0."""
    series, every = energy(variables([Intervals.point(np.zeros(shape))] * n, 2)), range(n)
    rows = [[series.derivative(i, j) for j in every] for i in every]
    value, slope = stacked([series.value], shape)[0], stacked(gradient(series, n), shape)
    return value, slope, matrix(rows, shape)


@cache
def _has_stiffness(model: Model) -> bool:
    """Whether the strain energy has a Hessian at the origin, with all contacts touching.

    A power law with an exponent between 1 and 2 has none, for any parameters.
    """
    (_, point), *_ = model.cases()
    given = [*map(Intervals.point, np.reshape(model.arguments(point, "motion"), (-1, 1)))]
    energy, indicators = undecorated(model.algebra.strain_energy), [1] * len(model.contacts)
    with quiet():
        *_, found = _at_origin(
            lambda q: energy(*q, *given, *indicators, xp=XP), len(model.coordinates), (1,)
        )
    return bool(np.isfinite(found.middle).all())


def _stiffest(stiffness: FloatArray, among: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Least eigenvalue, and largest by absolute value, of matrices (n, n, …); 0 where not
    ``among``.
    """
    roots = np.linalg.eigvalsh(np.moveaxis(np.where(among, stiffness, 0.0), (0, 1), (-2, -1)))
    return roots[..., 0], np.abs(roots).max(axis=-1)


def is_reference(
    balance: Balance, bounds: Intervals, ends: FloatArray, box: FloatArray
) -> BoolArray:
    """Boxes in which the one state is proved to be the reference state, for all their parameters.

    ``bounds`` are ranges of parameters, shape (P, N), ``ends`` boxes with one stable state for each
    parameter, and ``box`` boxes that hold all states.

    Source: a box around the state holds every state that may be the reference state. If the
    enclosure of K over that box is regular, K (a − b) = 0 excludes a second state b.
    """
    parameters = balance.prepared(bounds)
    with quiet():
        codes, proved = stability.types_over(balance, parameters, ends)
        own = proved & (codes == EquilibriumType.STABLE)
        if _has_stiffness(balance.model):
            rivals, convex = _little_strained(balance, parameters, ends, box)
            return own & convex & _one_at_most(balance, parameters, rivals)
        alone = np.zeros_like(own)
        for narrow in (2.0**-4, 2.0**-6):  # wider boxes decide most, in a fifth of the time
            rows = np.flatnonzero(own & ~alone)
            if rows.size:
                selected = bounds[:, rows], ends.take(rows, axis=2), box.take(rows, axis=2)
                rivals = _less_strained(balance, *selected, narrow)
                alone[rows] = _one_at_most(balance, parameters[:, rows], rivals)
    return own & alone


def _one_at_most(balance: Balance, parameters: Intervals, box: FloatArray) -> BoolArray:
    """Boxes that hold at most one state: the interval matrix K is regular over them.

    That is so if |1 − Y K| < 1 in the maximum norm, for the inverse Y of the middle of K.
    """
    K = balance.jacobian(Intervals(box), parameters)
    minus_one = Intervals.point(-np.eye(balance.n)[:, :, None])
    residual = Intervals(contractors.product(contractors.inverse(K.middle), K.ends)) + minus_one
    # Far more than the roundings of a product and a sum of n numbers.
    return residual.magnitude.sum(axis=1).max(axis=0) < 1 - 1e-9


def _strain_energy(
    balance: Balance, parameters: Intervals, pushing: Sequence[Any]
) -> Callable[[Sequence[Any]], Any]:
    """The strain energy as a function of coordinates, for boxes of prepared parameters; ``pushing``
    is 1 for each contact that stores energy, else 0.
    """
    values, shape = balance.arguments(parameters), parameters.shape[1:]
    return lambda q: balance.at(q, values, shape).call("strain_energy", q, *pushing)


def _little_strained(
    balance: Balance, parameters: Intervals, ends: FloatArray, box: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Boxes around the states of no more strain energy than that in ``ends``, to second order.

    These states lie in an ellipsoid ½ qᵀ S q + s · q ≤ const about the origin. Also returns where S
    is proved to be positive definite.
    """
    n, shape = balance.n, parameters.shape[1:]
    pushing = _pushing_at_origin(balance, parameters)
    energy = _strain_energy(balance, parameters, pushing)
    value, slope, stiffness = _at_origin(energy, n, shape)

    def strain(q: Intervals) -> FloatArray:
        rows = [sum(map(mul, row, q), 2 * one) for one, row in zip(slope, stiffness, strict=True)]
        return (sum(map(mul, rows, q), 0 * value) * 0.5).magnitude

    error = 0.5 * n * stiffness.width.max(axis=(0, 1))
    low, high = _stiffest(stiffness.middle, np.isfinite(error))
    convex = low - error > LEAST_CONVEXITY * (high + error)
    S = np.where(convex, stiffness.middle - error * np.eye(n)[:, :, None], np.eye(n)[:, :, None])
    semi_axes = np.sqrt(np.diagonal(np.linalg.inv(np.moveaxis(S, 2, 0)), axis1=1, axis2=2)).T
    # Energies are equal up to a share of the largest energy of all states.
    largest = np.maximum(strain(Intervals(box)), value.magnitude)
    linear = (slope.magnitude * semi_axes).sum(axis=0)
    t = linear + np.sqrt(linear**2 + 2 * (strain(Intervals(ends)) + 2 * SAME_ENERGY * largest))
    # S is no worse conditioned than 1/LEAST_CONVEXITY, so that a thousandth covers all roundings.
    return np.minimum(1.001 * t * semi_axes, balance.border[:, :, None]), convex


def _less_strained(
    balance: Balance, bounds: Intervals, ends: FloatArray, box: FloatArray, narrow: float
) -> FloatArray:
    """Hulls of each box and of all other states that may be the reference state, by a search.

    Boxes that the search leaves are dropped if they have more strain energy or are proved not to be
    stable. The search does not cut boxes narrower than ``narrow``.
    """
    # The budget is many times what a box takes whose state is told from all others at all.
    found = boxes.search(balance, box, bounds.low, bounds.high, budget=2000, narrow=narrow)
    row, point = found.points.below(found.every.nodes)
    every, parameters = found.every.ends.take(row, axis=2), balance.prepared(bounds)
    own_parameters = parameters[:, point]
    codes, proved = stability.types_over(balance, own_parameters, every)
    strain = _strain_energy(balance, own_parameters, balance.indicators)(list(Intervals(every)))
    own = _strain_energy(balance, parameters, balance.indicators)(list(Intervals(ends))).high
    largest = np.zeros(own.shape)
    np.maximum.at(largest, point, strain.magnitude)
    more = strain.low > (own + 2 * SAME_ENERGY * largest)[point]
    rivals = np.flatnonzero(~(more | (proved & (codes != EquilibriumType.STABLE))))
    return np.maximum(ends, hulls_of(every[:, :, rivals], point[rivals], ends.shape[2]))


def _pushing(
    model: Model, p: ParameterSet, q: Sequence[FloatArray] | FloatArray, largest: float = 0.0
) -> list[Any]:
    """For each contact 1 where it touches in the states, its gap being at most ``largest``, else 0;
    1 in all of them if the model has no regimes.
    """
    if not model.has_regimes:
        return [1]
    statics = [value[..., None] for value in model.arguments(p)]
    return [
        1.0 * (getattr(model.algebra, named("contact_gap", entry["name"]))(*q, *statics) <= largest)
        if entry["border"]
        else 1
        for entry in model.contacts
    ]


def _pushing_at_origin(balance: Balance, parameters: Intervals) -> list[Any]:
    """For each contact, enclosures of whether it touches where all coordinates are 0, over boxes of
    prepared parameters.
    """
    if not balance.model.has_regimes:
        return [1]
    values, shape = balance.arguments(parameters), parameters.shape[1:]
    at = balance.at([Intervals.point(np.zeros(shape))] * balance.n, values, shape)
    gaps = {k: as_intervals(at.gap(k), shape) for k in balance.opens}
    return [
        Intervals.between(1.0 * (gaps[k].high <= TOUCHES), 1.0 * (gaps[k].low <= TOUCHES))
        if k in gaps
        else 1
        for k in range(len(balance.contacts))
    ]


def least_slot(measure: FloatArray, states: FloatArray, error: FloatArray | float) -> IndexArray:
    """Slot of the least measure; of equal measures, that of the state with the largest coordinates.

    ``measure`` has the shape (..., slots) and is infinite in slots that do not take part.
    ``states`` are coordinates, (n, ..., slots), compared one after the other. ``error`` bounds the
    error of a coordinate over max(1, |coordinate|).

    Examples
    --------
    >>> h = np.array([-0.2, 0.5, 0.2])
    >>> x = np.array([-6e-19, 0.0, 1e-17])
    >>> int(least_slot(np.abs(x), np.array([x, h]), np.full(3, 1e-16)))
    1
    """
    sizes = scale_of(states).max(axis=0)
    # Several error bounds, since sizes and distances are rounded too.
    tolerance = 8 * np.nan_to_num(error * sizes).max(axis=-1, keepdims=True, initial=0.0)
    candidates = np.isfinite(measure)
    for values in (measure, *-states):
        least = values.min(axis=-1, keepdims=True, initial=np.inf, where=candidates)
        candidates &= values <= least + tolerance
    return candidates.argmax(axis=-1)
