"""Onsets of undamped flutter held against a map of stability over the angle.

The states on a grid and their stability are those of :func:`spragsym.equilibria`, which knows
nothing of onsets. Between two neighbours a state that changes between flutter and no flutter must
have its onset listed, with the right side, and a state that does not must have none. The grid is
finer near 0, π/2 and π, about all that is listed, where a discriminant comes close to 0, and about
folds, where states change places and nothing can be said of a cell.
"""

from collections import Counter

import numpy as np

import spragsym as ss

Array = np.ndarray

#: Grid points in the middle, and towards each of 0, π/2 (from both sides) and π, down to
#: :data:`NEAREST`.
EVEN, TOWARDS, NEAREST = 160, 40, 1e-9
#: How often the grid is made finer where something comes close.
ZOOMS = 4


def grid() -> Array:
    """θ₀ in (0, π), ever closer to 0, π/2 and π."""
    near = np.geomspace(NEAREST, 0.3, TOWARDS)
    half = 0.5 * np.pi
    return np.unique(
        np.concatenate(
            [np.linspace(0, np.pi, EVEN + 2)[1:-1], near, half - near, half + near, np.pi - near]
        )
    )


def compare(p: ss.Parameters, onsets: ss.results.Onsets) -> tuple[int, int, int]:
    """Onsets that the map has and the list has not, the other way round, and those on the map."""
    theta0, eq = refined_map(p, onsets)
    flutter = np.where(
        np.arange(eq.undamped.shape[-1]) < eq.count[:, None],
        eq.undamped == ss.EquilibriumType.FLUTTER,
        False,
    )
    missed = extra = seen = 0
    for cell in np.flatnonzero(
        np.diff(eq.count) == 0
    ):  # otherwise a fold is in between, and the states changed places
        change = flutter[cell + 1].astype(int) - flutter[cell]
        expected = Counter((int(branch), int(change[branch])) for branch in np.flatnonzero(change))
        inside = (onsets.theta0 > theta0[cell]) & (onsets.theta0 < theta0[cell + 1])
        inside &= onsets.side != 0  # a touch, which changes nothing on either side
        listed = Counter(
            zip(onsets.branch[inside].tolist(), onsets.side[inside].tolist(), strict=True)
        )
        seen += expected.total()
        missed += (expected - listed).total()
        extra += (listed - expected).total()
    return missed, extra, seen


def refined_map(p: ss.Parameters, onsets: ss.results.Onsets) -> tuple[Array, ss.results.Equilibria]:
    """θ₀ and the states there: the grid, points about everything listed, and more where a
    discriminant comes near 0.
    """
    events = onsets.theta0
    bounds = np.unique(np.concatenate([[0.0, np.pi], events]))
    about = [events + distance for size in (1e-3, 1e-6, 1e-9) for distance in (-size, size)]
    theta0 = np.unique(np.concatenate([grid(), 0.5 * (bounds[1:] + bounds[:-1]), *about]))
    for zoom in range(ZOOMS + 1):
        far = np.abs(theta0[:, None] - events).min(axis=-1, initial=1.0)
        theta0 = theta0[(theta0 > 0) & (theta0 < np.pi) & (far > 1e-12)]
        eq = ss.equilibria(p.replace(theta0=theta0))
        near = dips(p, eq)
        folds = np.flatnonzero((np.diff(eq.count) != 0) & (np.diff(theta0) > 1e-6))
        if zoom == ZOOMS or not near.size + folds.size:
            break
        fine = (
            np.linspace(theta0[near - 1], theta0[near + 1], 13),
            np.linspace(theta0[folds], theta0[folds + 1], 13),
        )
        theta0 = np.union1d(theta0, np.concatenate(fine, axis=-1))
    return theta0, eq


def dips(p: ss.Parameters, eq: ss.results.Equilibria) -> Array:
    """Points at which the discriminant of a state comes closer to 0 than at the neighbours, without
    a change of its sign.
    """
    mu0, alpha, sigma, beta = p.scalars("mu0", "alpha", "sigma", "beta")
    s, c = np.sin(eq.theta), np.cos(eq.theta)
    K11, K22, K21 = (
        sigma * (1 - s * s / eq.L) + alpha,
        sigma * (1 - c * c / eq.L) + beta + 1,
        sigma / eq.L * s * c,
    )
    value = (K11 - K22) ** 2 + 4 * (K21 + mu0) * K21
    left, here, right = value[:-2], value[1:-1], value[2:]
    same = (np.sign(left) == np.sign(here)) & (np.sign(here) == np.sign(right))
    size = (K11 - K22) ** 2 + 4 * np.abs((K21 + mu0) * K21)
    close = np.abs(here) < 0.1 * size[1:-1]
    found = same & close & (np.abs(here) <= np.abs(left)) & (np.abs(here) <= np.abs(right))
    return np.unique(np.nonzero(found)[0]) + 1
