"""The reference state, that of small deformation, from which a state is followed unless another one is chosen."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..numerics.interval_arrays import FloatArray
from ..results.equilibria import Equilibria, Stability
from .tie_breaking import least_slot

#: Strain energies that differ by less than this, relative to the largest, are equal: those of mirror images differ by rounding.
EQUAL = 1e-9
#: Step of differences of the strain energy, which is of fourth degree or so in lengths of order 1.
STEP = 1e-3
#: Least eigenvalue of a stiffness, over the largest, that counts as positive.
POSITIVE = 1e-6


def reference_state(model: Any, eq: Equilibria, near: Mapping[str, float] | None = None) -> NDArray[np.intp]:
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


def chosen_state(
    model: Any, p: Any, q: Sequence[FloatArray], error: FloatArray, among: NDArray[np.bool_], near: Mapping[str, float] | None
) -> NDArray[np.intp]:
    """The chosen state from coordinates, slots last, bounds on their errors, and the slots to choose from."""
    if near is not None:
        off = np.linalg.norm([q[model.coordinates.index(name)] - value for name, value in near.items()], axis=0)
        return least_slot(np.where(among, off, np.inf), np.array(q), error)
    (_, point), *_ = model.cases()
    missing = {
        name: getattr(point, name) for name in model.parameters if getattr(p, name) is None
    }  # of the motion: not felt here
    given = [value[..., None] for value in model.arguments(p.replace(**missing), "motion")]

    def energy(*place: FloatArray) -> FloatArray:
        with np.errstate(all="ignore"):  # beyond ``count`` there are no numbers
            return np.asarray(model.algebra.strain_energy(*place, *given, 1), dtype=float)

    at_origin = np.nan_to_num(np.abs(energy(*np.zeros((len(q), 1)))))
    slope, stiffness = _expanded(energy, len(q))
    place = np.stack(q, axis=-1)
    second = np.einsum("...i,...si->...s", slope, place) + 0.5 * np.einsum("...si,...ij,...sj->...s", place, stiffness, place)
    convex = np.isfinite(stiffness).all(axis=(-2, -1))
    roots = np.linalg.eigvalsh(np.where(np.expand_dims(convex, (-2, -1)), stiffness, 0.0))
    convex &= roots[..., 0] > POSITIVE * np.abs(roots).max(axis=-1)
    strain = np.where(np.expand_dims(convex, -1), second, energy(*q))
    strain = np.where(among & np.isfinite(strain), strain, np.inf)
    sizes = np.where(np.isfinite(strain), np.abs(strain), 0.0).max(axis=-1, keepdims=True, initial=0.0)
    largest = np.maximum(sizes, at_origin)  # two states may both be relaxed, but for rounding
    least = strain <= strain.min(axis=-1, keepdims=True, initial=np.inf) + EQUAL * largest
    return least_slot(np.where(least & among, np.abs(q[0]), np.inf), np.array(q), error)


def _expanded(energy: Callable[..., FloatArray], n: int) -> tuple[FloatArray, FloatArray]:
    """First and second derivatives at the origin, shapes (…, n) and (…, n, n), by differences."""
    axes = STEP * np.eye(n)
    pairs = [(i, j) for i in range(n) for j in range(i)]
    here, ahead, back = energy(*np.zeros((n, 1))), energy(*axes), energy(*-axes)
    slope = (ahead - back) / (2 * STEP)
    both = energy(*np.array([axes[i] + axes[j] for i, j in pairs]).reshape(-1, n).T)
    stiffness = np.zeros((*slope.shape, n))
    stiffness[..., range(n), range(n)] = (ahead + back - 2 * here) / STEP**2
    for place, (i, j) in enumerate(pairs):
        mixed = both[..., place] - ahead[..., i] - ahead[..., j] + here[..., 0]
        stiffness[..., i, j] = stiffness[..., j, i] = mixed / STEP**2
    return slope, stiffness
