"""The reference state, that of small deformation, from which a state is followed unless another one is chosen."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..models.model_field import undecorated
from ..numerics.interval_arrays import BoolArray, FloatArray, IndexArray, Intervals
from ..numerics.jets import variables
from ..results.equilibria import Equilibria, Stability
from .mechanics.laws import XP
from .tie_breaking import least_slot

#: Strain energies that differ by less than this, relative to the largest, are equal: those of mirror images differ by rounding.
EQUAL = 1e-9
#: Least eigenvalue of a stiffness, over the largest, that counts as positive.
POSITIVE = 1e-6


def reference_state(model: Any, eq: Equilibria, near: Mapping[str, float] | None = None) -> IndexArray:
    """The slot of the stable equilibrium of least strain energy, for each point; where none is stable, of any of least strain.

    ``eq`` is in contact, of any shape, slots are the last axis; ``near`` are coordinates to which it is the nearest, instead.
    Strain energy is that of springs, torsion springs, contact and the page's potentials, without applied forces. Where it is
    convex at the origin of the coordinates, it is taken to second order there, so that a spring that flipped over, as that of a
    truss which snapped, counts as deformed though it may be relaxed again. Of equal energies, as those of mirror images, the
    state of smaller first coordinate is taken, by size, then the one of larger coordinates.
    """
    q = [getattr(eq, name) for name in model.coordinates]
    stable = eq.stability == Stability.STABLE
    among = np.where(stable.any(axis=-1, keepdims=True), stable, ~np.isnan(q[0]))
    return chosen_state(model, eq.parameters, q, eq.error, among, near)


def nearest_state(
    eq: Equilibria, near: Mapping[str, float], among: BoolArray | bool = True, error: float | FloatArray = 0.0
) -> IndexArray:
    """The slot of the equilibrium that is nearest to a state, for each point, among all or some; distances have these errors."""
    q = [eq.coordinates[name] for name in near]
    return _nearest(q, [row - value for row, value in zip(q, near.values(), strict=True)], error, ~np.isnan(q[0]) & among)


def _nearest(q: Sequence[FloatArray], off: Sequence[FloatArray], error: Any, among: BoolArray) -> IndexArray:
    return least_slot(np.where(among, np.linalg.norm(off, axis=0), np.inf), np.array(q), error)


def chosen_state(
    model: Any, p: Any, q: Sequence[FloatArray], error: FloatArray, among: BoolArray, near: Mapping[str, float] | None
) -> IndexArray:
    """The chosen state from coordinates, slots last, bounds on their errors, and the slots to choose from."""
    if near is not None:
        return _nearest(q, [q[model.coordinates.index(name)] - value for name, value in near.items()], error, among)
    (_, point), *_ = model.cases()
    missing = {
        name: getattr(point, name) for name in model.parameters if getattr(p, name) is None
    }  # of the motion: not felt here
    given = [value[..., None] for value in model.arguments(p.replace(**missing), "motion")]
    energy, origin = undecorated(model.algebra.strain_energy), Intervals.point(np.zeros((*p.shape, 1)))
    every = range(len(q))

    def derivative(*numbers: int) -> FloatArray:
        found = series.derivative(*numbers)
        return np.broadcast_to(found.middle if isinstance(found, Intervals) else found, (*p.shape, 1))[..., 0]

    with np.errstate(all="ignore"):  # beyond ``count`` there are no numbers
        strain = energy(*q, *given, 1, xp=np)
        series = energy(*variables([origin] * len(q), 2), *map(Intervals.point, given), 1, xp=XP)
        at_origin = np.nan_to_num(np.abs(derivative()))[..., None]
        slope = np.stack([derivative(i) for i in every], axis=-1)
        stiffness = np.stack([np.stack([derivative(i, j) for j in every], axis=-1) for i in every], axis=-2)
    place = np.stack(q, axis=-1)
    second = np.einsum("...i,...si->...s", slope, place) + 0.5 * np.einsum("...si,...ij,...sj->...s", place, stiffness, place)
    convex = np.isfinite(stiffness).all(axis=(-2, -1))
    roots = np.linalg.eigvalsh(np.where(np.expand_dims(convex, (-2, -1)), stiffness, 0.0))
    convex &= roots[..., 0] > POSITIVE * np.abs(roots).max(axis=-1)
    strain = np.where(np.expand_dims(convex, -1), second, strain)
    strain = np.where(among & np.isfinite(strain), strain, np.inf)
    sizes = np.where(np.isfinite(strain), np.abs(strain), 0.0).max(axis=-1, keepdims=True, initial=0.0)
    largest = np.maximum(sizes, at_origin)  # two states may both be relaxed, but for rounding
    least = strain <= strain.min(axis=-1, keepdims=True, initial=np.inf) + EQUAL * largest
    return least_slot(np.where(least & among, np.abs(q[0]), np.inf), np.array(q), error)
