"""The reference state, that of small deformation, from which a state is followed unless another one
is chosen; the states' order.

Which is "the smallest" or "the nearest" state, and which the first, does not depend on rounding
where two are alike to within their errors.
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
from .namespaces import XP

#: Least eigenvalue of the stiffness at the origin over the largest, from which on a strain energy
#: is convex there.
LEAST_CONVEXITY = 1e-6
#: Difference of strain energies that are alike, over the largest.
SAME_ENERGY = 1e-9


def reference_state(eq: Equilibria, near: Mapping[str, float] | None = None) -> IndexArray:
    """The slot of the stable equilibrium of least strain energy, for each point; where none is
    stable, of any of least strain.

    ``eq`` is in contact, of any shape, slots are the last axis; ``near`` are coordinates to which
    it is the nearest, instead. Strain energy is that of springs, torsion springs, contact and the
    page's potentials, without applied forces. Where it is convex at the origin of the coordinates,
    it is taken to second order there, so that a spring that flipped over, as that of a truss which
    snapped, counts as deformed though it may be relaxed again. Of equal energies, as those of
    mirror images, the state of smaller first coordinate is taken, by size, then the one of larger
    coordinates.
    """
    q = list(eq.coordinates.values())
    stable = eq.undamped == EquilibriumType.STABLE
    among = np.where(stable.any(axis=-1, keepdims=True), stable, ~np.isnan(q[0]))
    return chosen_state(eq.parameters, q, eq.error, among, near)


def reference_place(
    p: ParameterSet, near: Mapping[str, float] | None, where: str
) -> tuple[FloatArray, str, float]:
    """Coordinates of the reference state of one point, the contacts that touch, of several, and a
    bound on its error; an exception, which says ``where``, if none is known to be stable.
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
    """The slot of the equilibrium that is nearest to a state, for each point, among all or some;
    distances have these errors.
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
    return least_slot(np.where(among, np.linalg.norm(off, axis=0), np.inf), np.array(q), error)


def chosen_state(
    p: ParameterSet,
    q: Sequence[FloatArray],
    error: FloatArray,
    among: BoolArray,
    near: Mapping[str, float] | None,
) -> IndexArray:
    """The chosen state from coordinates, slots last, bounds on their errors, and the slots to
    choose from.
    """
    model = p.model
    if near is not None:
        return _nearest(
            q,
            [q[model.coordinates.index(name)] - value for name, value in near.items()],
            error,
            among,
        )
    (_, point), *_ = model.cases()
    # Of the motion: not felt here.
    missing = {name: point[name] for name in model.parameters if p[name] is None}
    given = [value[..., None] for value in model.arguments(p.replace(**missing), "motion")]
    energy, shape = undecorated(model.algebra.strain_energy), (*p.shape, 1)
    with quiet():  # beyond ``count`` there are no numbers
        strain = energy(*q, *given, *_pushing(model, p, q), xp=np)
        state = np.array(q)
        here = [*map(Intervals.point, given), *[1] * len(model.contacts)]
        at_origin, slope, stiffness = (
            part.middle for part in _at_origin(lambda q: energy(*q, *here, xp=XP), len(q), shape)
        )
        at_origin = np.nan_to_num(np.abs(at_origin))
        second = (slope * state).sum(axis=0) + 0.5 * (state[:, None] * stiffness * state).sum(
            axis=(0, 1)
        )
    convex = np.asarray(np.isfinite(stiffness).all(axis=(0, 1)) & _has_stiffness(model))
    low, most = _stiffest(stiffness, convex)
    convex &= low > LEAST_CONVEXITY * most
    strain = np.where(convex, second, strain)
    strain = np.where(among & np.isfinite(strain), strain, np.inf)
    sizes = np.abs(strain).max(axis=-1, keepdims=True, initial=0.0, where=np.isfinite(strain))
    largest = np.maximum(sizes, at_origin)  # two states may both be relaxed, but for rounding
    # Strain energies of mirror images differ by rounding.
    least = strain <= strain.min(axis=-1, keepdims=True, initial=np.inf) + SAME_ENERGY * largest
    return least_slot(np.where(least & among, np.abs(q[0]), np.inf), np.array(q), error)


def _at_origin(energy: Callable[[Any], Any], n: int, shape: Shape) -> tuple[Intervals, ...]:
    """Strain energy where all coordinates are 0, its slopes and its stiffness, enclosed."""
    series, every = energy(variables([Intervals.point(np.zeros(shape))] * n, 2)), range(n)
    rows = [[series.derivative(i, j) for j in every] for i in every]
    value, slope = stacked([series.value], shape)[0], stacked(gradient(series, n), shape)
    return value, slope, matrix(rows, shape)


@cache
def _has_stiffness(model: Model) -> bool:
    """Whether the strain energy has a stiffness at the origin of the coordinates, where all
    contacts touch: that of a power between 1 and 2 has none, at whatever parameters.
    """
    (_, point), *_ = model.cases()
    given = [*map(Intervals.point, np.reshape(model.arguments(point, "motion"), (-1, 1)))]
    energy, pushing = undecorated(model.algebra.strain_energy), [1] * len(model.contacts)
    with quiet():
        *_, found = _at_origin(
            lambda q: energy(*q, *given, *pushing, xp=XP), len(model.coordinates), (1,)
        )
    return bool(np.isfinite(found.middle).all())


def _stiffest(stiffness: FloatArray, among: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Least eigenvalue, and largest by size, of matrices (n, n, …); 0 where not ``among``."""
    roots = np.linalg.eigvalsh(np.moveaxis(np.where(among, stiffness, 0.0), (0, 1), (-2, -1)))
    return roots[..., 0], np.abs(roots).max(axis=-1)


def is_reference(
    balance: Balance, bounds: Intervals, ends: FloatArray, box: FloatArray
) -> BoolArray:
    """Boxes, each with one stable state for all parameters within its ``bounds``, shape (P, N), in
    which that is proved to be the reference state; ``box`` are boxes that hold all states.

    Source: what may be the reference state lies in a box about the one that is asked for. Two
    states in that would be a and b with K (a − b) = 0, K within its bounds over the box.
    """
    parameters = balance.prepared(bounds)
    with quiet():
        codes, proved = stability.types_over(balance, parameters, ends)
        own = proved & (codes == EquilibriumType.STABLE)
        if _has_stiffness(balance.model):
            reach, convex = _little_strained(balance, parameters, ends, box)
            return own & convex & _one_at_most(balance, parameters, reach)
        alone = np.zeros_like(own)
        for narrow in (2.0**-4, 2.0**-6):  # wider boxes tell it of most, in a fifth of the time
            if (rows := np.flatnonzero(own & ~alone)).size:
                some = bounds[:, rows], ends.take(rows, axis=2), box.take(rows, axis=2)
                reach = _less_strained(balance, *some, narrow)
                alone[rows] = _one_at_most(balance, parameters[:, rows], reach)
    return own & alone


def _one_at_most(balance: Balance, parameters: Intervals, reach: FloatArray) -> BoolArray:
    """Boxes in which no two states are, K being regular over them."""
    K = balance.jacobian(Intervals(reach), parameters)
    one = Intervals.point(-np.eye(balance.n)[:, :, None])
    left = Intervals(contractors.product(contractors.inverse(K.middle), K.ends)) + one
    # Far more than the roundings of a product and a sum of n numbers.
    return left.magnitude.sum(axis=1).max(axis=0) < 1 - 1e-9


def _strain_energy(balance: Balance, parameters: Intervals) -> Callable[[Sequence[Any]], Any]:
    """Strain energy at coordinates, for boxes of prepared parameters."""
    values, shape = balance.arguments(parameters), parameters.shape[1:]
    return lambda q: balance.at(q, values, shape).call("strain_energy", q, *balance.pushing)


def _little_strained(
    balance: Balance, parameters: Intervals, ends: FloatArray, box: FloatArray
) -> tuple[FloatArray, BoolArray]:
    """Boxes that hold all of no more strain energy to second order, ½ qᵀ S q + s · q, an ellipsoid
    about the origin; and where that is proved to be one.
    """
    n, shape = balance.n, parameters.shape[1:]
    value, slope, stiffness = _at_origin(_strain_energy(balance, parameters), n, shape)

    def strain(q: Intervals) -> FloatArray:
        rows = [sum(map(mul, row, q), 2 * one) for one, row in zip(slope, stiffness, strict=True)]
        return (sum(map(mul, rows, q), 0 * value) * 0.5).magnitude

    off = 0.5 * n * stiffness.width.max(axis=(0, 1))
    low, most = _stiffest(stiffness.middle, np.isfinite(off))
    convex = low - off > LEAST_CONVEXITY * (most + off)
    S = np.where(convex, stiffness.middle - off * np.eye(n)[:, :, None], np.eye(n)[:, :, None])
    along = np.sqrt(np.diagonal(np.linalg.inv(np.moveaxis(S, 2, 0)), axis1=1, axis2=2)).T
    # What counts as alike is a share of the largest energy of all states.
    largest = np.maximum(strain(Intervals(box)), value.magnitude)
    least = (slope.magnitude * along).sum(axis=0)
    t = least + np.sqrt(least**2 + 2 * (strain(Intervals(ends)) + 2 * SAME_ENERGY * largest))
    # S is no worse conditioned than 1/LEAST_CONVEXITY, so that a thousandth covers all roundings.
    return np.minimum(1.001 * t * along, balance.border[:, :, None]), convex


def _less_strained(
    balance: Balance, bounds: Intervals, ends: FloatArray, box: FloatArray, narrow: float
) -> FloatArray:
    """Hulls of boxes and of all stable states of no more strain energy, by a search that parts no
    ``narrow`` box: what it leaves has more energy, or is not stable, or near.
    """
    # Many more than a box takes that is told from all others at all.
    found = boxes.search(balance, box, bounds.low, bounds.high, budget=2000, narrow=narrow)
    row, part = found.points.below(found.every.nodes)
    every, parameters = found.every.ends.take(row, axis=2), balance.prepared(bounds)
    here = parameters[:, part]
    codes, proved = stability.types_over(balance, here, every)
    strain = _strain_energy(balance, here)(list(Intervals(every)))
    own = _strain_energy(balance, parameters)(list(Intervals(ends))).high
    largest = np.zeros(own.shape)
    np.maximum.at(largest, part, strain.magnitude)
    more = strain.low > (own + 2 * SAME_ENERGY * largest)[part]
    left = np.flatnonzero(~(more | (proved & (codes != EquilibriumType.STABLE))))
    return np.maximum(ends, hulls_of(every[:, :, left], part[left], ends.shape[2]))


def _pushing(model: Model, p: ParameterSet, q: Sequence[FloatArray]) -> list[Any]:
    """Of every contact whether it touches in states: the only one does in all of them."""
    if not model.has_regimes:
        return [1]
    statics = [value[..., None] for value in model.arguments(p)]
    return [
        np.less_equal(getattr(model.algebra, named("contact_gap", entry["name"]))(*q, *statics), 0)
        if entry["border"]
        else 1
        for entry in model.contacts
    ]


def least_slot(measure: FloatArray, states: FloatArray, error: FloatArray | float) -> IndexArray:
    """The slot of the least measure, and of those that are alike the one of larger coordinates, the
    first one first.

    ``measure`` and ``error``, bounds over max(1, |coordinate|), have the shape (..., slots), the
    coordinates ``states`` have (n, ..., slots); slots that are not asked for have an infinite
    measure.

    Examples
    --------
    >>> h = np.array([-0.2, 0.5, 0.2])
    >>> x = np.array([-6e-19, 0.0, 1e-17])
    >>> int(least_slot(np.abs(x), np.array([x, h]), np.full(3, 1e-16)))
    1
    """
    sizes = scale_of(states).max(axis=0)
    # Some bounds of their errors: sizes and distances are rounded, too.
    room = 8 * np.nan_to_num(error * sizes).max(axis=-1, keepdims=True, initial=0.0)
    left = np.isfinite(measure)
    for one in (measure, *-states):
        least = one.min(axis=-1, keepdims=True, initial=np.inf, where=left)
        left &= one <= least + room
    return left.argmax(axis=-1)
