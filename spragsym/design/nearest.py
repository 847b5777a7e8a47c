"""The nearest point of a set, in units of tolerances, where only membership can be asked for, of many points at once.

A point of the set's border that is the nearest one of its neighbours comes first. Rays from the origin, evenly spread and the
same in every run, then ask for members that are nearer, and from these the next such point is sought, until no ray meets one.
Where there is no point to begin with, rays are walked outward to their first member; the best of them is turned and shortened.
That finds a set that a ray meets, and proves nothing about one that all rays miss.
"""

from collections.abc import Callable

import numpy as np

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import BoolArray
from ..progress import doing

Member = Callable[[FloatArray], BoolArray]
#: From a point near the border, or from 0, to the nearest point of the border about there, a member, if it is found.
Improved = Callable[[FloatArray], FloatArray | None]

#: Rays for each dimension squared, since a point may take milliseconds; radii at which each is asked, the last the farthest.
RAYS, _RADII = 8, np.concatenate([[1e-6], 2.0 ** np.arange(-8, 8.01, 0.25)])
#: Points to ask for at once, where there is a choice, outward and inward.
_OUTWARD, _INWARD = 512, 4096
#: Halvings of a radius while rays are compared, and at the end, to 1e-11 of it.
_COARSE, _FINE = 9, 36
#: Shares of the distance of a member at which rays ask for nearer ones, and how often the nearest of these is improved at most.
_SHARES, _ROUNDS = np.array([0.999, 0.7, 0.4]), 20


def nearest(
    member: Member, limits: tuple[FloatArray, FloatArray], improved: Improved
) -> FloatArray | None:  # fmt: skip
    """A member about as near to 0 as rays find it, of the shape (dimensions,), or none.

    ``member`` tells of points, of shape (n, dimensions), which are members; ``limits`` are the smallest and the largest value of
    each coordinate; ``improved`` gives the nearest member on the border about a point, if it finds one.
    """
    size = limits[0].size
    if member(np.zeros((1, size)))[0]:
        return np.zeros(size)
    rays = _rays(size)
    found = improved(np.zeros(size))
    if found is None:
        steps = np.array_split(_RADII, -(-_RADII.size // max(1, _OUTWARD // len(rays))))
        far = next((far for radii in steps if (far := _on_rays(member, rays, limits, radii)) is not None), None)
        if far is None:
            return None
        found = _better(member, _turned(member, far, limits), improved)
    for _ in range(_ROUNDS):
        nearer = _on_rays(member, rays, limits, float(np.linalg.norm(found)) * _SHARES)
        if nearer is None:
            break
        found = _better(member, nearer, improved)
    return found


def _better(member: Member, point: FloatArray, improved: Improved) -> FloatArray:
    """The border on the ray to a member, or the nearest member about there."""
    border = shortened(member, point)
    # Just inside of the border.
    found = improved(border * (1 - 1e-9))
    return border if found is None or np.linalg.norm(found) > np.linalg.norm(border) else found


def _on_rays(member: Member, rays: FloatArray, limits: tuple[FloatArray, FloatArray], radii: FloatArray) -> FloatArray | None:
    """The nearest of the members that rays meet at some radii, or where they end before, brought to the border, if any does."""
    lengths = np.minimum(radii[:, None], _reach(rays, limits))
    with doing("designs up to {:.4g} tolerances away", lengths.max()):
        inside = member((lengths[..., None] * rays).reshape(-1, rays.shape[1])).reshape(lengths.shape)
    radius = np.where(inside, lengths, np.inf).min(axis=0)
    met = np.flatnonzero(radius <= 1.5 * radius.min()) if inside.any() else np.empty(0, dtype=np.intp)
    if not met.size:
        return None
    found = _shortened(member, rays[met], radius[met], _COARSE)
    return rays[met[np.argmin(found)]] * found.min()


def _rays(size: int) -> FloatArray:
    """Unit vectors: both ways along every axis, and evenly in between."""
    from scipy.stats import norm, qmc

    axes = np.concatenate([np.eye(size), -np.eye(size)])
    if size == 1:
        return axes
    number = 1 << int(np.ceil(np.log2(RAYS * size * size)))
    points = qmc.Sobol(size, scramble=True, rng=np.random.default_rng(20)).random(number)
    normal = norm.ppf(np.clip(points, 1e-9, 1 - 1e-9))
    return np.concatenate([axes, normal / np.linalg.norm(normal, axis=-1, keepdims=True)])


def _reach(rays: FloatArray, limits: tuple[FloatArray, FloatArray]) -> FloatArray:
    """How far each ray goes within the limits."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = np.where(rays > 0, limits[1] / rays, np.where(rays < 0, limits[0] / rays, np.inf))
    return np.asarray(ends.min(axis=-1))


def shortened(member: Member, point: FloatArray) -> FloatArray:
    """A member brought nearer along its ray, to a border of the set, from inside."""
    radius = float(np.linalg.norm(point))
    if not radius:
        return point
    ray = point[None] / radius
    return np.asarray(ray[0] * _shortened(member, ray, np.array([radius]), _FINE)[0])


def _shortened(member: Member, rays: FloatArray, radius: FloatArray, halvings: int) -> FloatArray:
    """Radii of borders on the rays; several parts of each are asked for at once, where rays are few."""
    parts = min(16, max(2, _INWARD // len(rays)))
    low, high = np.zeros_like(radius), radius.copy()
    for _ in range(-(-halvings // int(np.log2(parts)))):
        marks = low + np.linspace(0.0, 1.0, parts + 1)[1:-1, None] * (high - low)
        with doing("designs {:.4g} tolerances away, and nearer ones", high.min()):
            inside = member((rays * marks[..., None]).reshape(-1, rays.shape[-1])).reshape(marks.shape)
        edges = np.concatenate([low[None], marks, high[None]])
        first = np.argmax(np.concatenate([inside, np.ones((1, radius.size), dtype=np.bool_)]), axis=0) + 1
        low, high = (np.take_along_axis(edges, (first - side)[None], axis=0)[0] for side in (1, 0))
    return high


def _turned(member: Member, point: FloatArray, limits: tuple[FloatArray, FloatArray]) -> FloatArray:
    """The ray to a member turned a little, and less and less, as long as that shortens it."""
    radius = float(np.linalg.norm(point))
    ray = point / radius
    if ray.size > 1:
        normal = np.random.default_rng(21).standard_normal((RAYS * ray.size, ray.size))
        for spread in (0.3, 0.1, 0.1, 0.03, 0.03, 0.01):
            rays = ray + spread * normal
            rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
            tried = radius * (1 - 1e-2 * spread)
            good = (_reach(rays, limits) >= tried) & member(rays * tried)
            if good.any():
                found = _shortened(member, rays[good], np.full(int(good.sum()), tried), _COARSE)
                ray, radius = rays[good][np.argmin(found)], float(found.min())
    return ray * radius
