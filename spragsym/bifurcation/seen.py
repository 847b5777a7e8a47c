"""Numerically detected onsets where the search is undecided; verified one by one.

States are found at many values of the parameter, and from one value to the next each pair λ, λ̄ is followed on its own: others
may grow already, or never be damped. Where the growth of one changes its sign, bisection leads to the onset; where friction alone
damps, or nothing, it is the condition's own value that changes its sign. Krawczyk's operator proves the onset in a small box;
what it does not prove is listed as ``"detected"``.
"""

from dataclasses import replace
from functools import partial
from typing import TypeAlias

import numpy as np
from scipy.optimize import linear_sum_assignment

from ..numerics import certified_roots
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import ComplexArray, FloatArray, IntArray, Intervals
from ..numerics.precise_roots import as_intervals, narrowed
from ..statics import stability
from ..statics.mechanics.border import on_its_side
from ..statics.mechanics.precise_balance import ROOT_BITS
from ..statics.search import seen
from .bifurcation_conditions import HOPF
from .defining_systems import Augmented, PreciseAugmented
from .points import Found, matrices

#: Values of the parameter that are looked at.
VALUES = 61
#: Half-width of the box in which an onset is proved with many digits, over its size.
ROOM = 1e-6
#: Imaginary part of a λ that oscillates, over its size.
OSCILLATES = 1e-6
#: Real part of a λ that grows or decays, over the largest one: eigenvalues are known to less than that.
GROWS = 1e-11
#: Width of a box whose middle is as good as a root, and growth of a λ on the imaginary axis, over their sizes.
SMALL = 1e-6
#: Times that the range between two values is halved.
HALVINGS = 40
#: An onset that floats see: coordinates and parameter, shape (n + 1,), and the frequency, NaN where none was followed.
Sighting: TypeAlias = tuple[FloatArray, float]


def with_seen(system: Augmented, found: Found) -> tuple[Found, Roots, FloatArray]:
    """What a search has found, with the onsets that floats see and that are proved; those that are not; and their frequencies."""
    fixed, (low, high) = system.family.begin, system.family.spans[0]
    sightings = [(z, omega) for z, omega in _sightings(system) if low <= z[-1] <= high]
    candidates = np.array([z for z, _ in sightings]).reshape(-1, system.n).T
    room = ROOM * np.maximum(1.0, np.abs(candidates))
    wide = np.stack([room - candidates, room + candidates])
    precise = PreciseAugmented(system, fixed[:, 0], ROOT_BITS)
    known = [narrowed(precise, box, box) for box in np.moveaxis(wide, 2, 0)]
    sure = np.array([root is not None for root in known], dtype=np.bool_)
    ends = np.concatenate([wide[:, :, :0], *(as_intervals(root).ends for root in known if root is not None)], axis=2)
    omega = np.array([omega for _, omega in sightings])[~sure]
    proved, open_ = (
        on_its_side(system, fixed, Roots.at(part), partial(PreciseAugmented, system)) for part in (ends, wide[:, :, ~sure])
    )
    apart = np.abs(candidates[:, ~sure, None] - open_.middle[:, None]).max(axis=0)
    omega = omega[linear_sum_assignment(apart.T)[1]]  # of several pairs that cross at one place each has its own
    every = certified_roots.concatenated([found.roots, proved.kept(left=slice(0))], system.n)
    return replace(found, roots=certified_roots.distinct(every)), open_, omega


def _sightings(system: Augmented) -> list[Sighting]:
    """Onsets between values of the parameter."""
    low, high = system.family.spans[0]
    values = low + (high - low) * (np.arange(VALUES) + 0.5) / VALUES
    q, point = _states(seen(system.balance, system.family.at(values[None]), system.family.asked))
    neighbours = []
    for one in range(point.size):
        following = np.flatnonzero(point == point[one] + 1)
        if following.size:
            neighbours.append((one, int(following[np.abs(q[:, following] - q[:, [one]]).max(axis=0).argmin()])))
    z = np.concatenate([q, values[point][None]])
    every, out = _signals(system, z), list[Sighting]()
    for one, other in neighbours:
        if _crossing(every[one], every[other]).size:
            out += _bisected(system, (z[:, one], every[one]), (z[:, other], every[other]), HALVINGS)
    if system.condition is HOPF:
        return out
    # Not where the condition changes its sign at a pole.
    most = SMALL * max(np.abs(np.concatenate(every)), default=0.0)
    return [(state, omega) for state, omega in out if (np.abs(_signals(system, state[:, None])[0]) <= most).any()]


def _states(found: Roots) -> tuple[FloatArray, IntArray]:
    """Roots, and the middles of boxes so small that rounding alone leaves them open, each once; and their points."""
    boxes = Intervals(found.left)
    small = (boxes.width <= SMALL * np.maximum(1.0, np.abs(boxes.middle))).all(axis=0)
    q = np.concatenate([found.middle, boxes.middle[:, small]], axis=1)
    point = np.concatenate([found.point, found.left_point[small]])
    order = np.lexsort((q[0], point))
    q, point = q[:, order], point[order]
    again = (np.diff(point) == 0) & (np.abs(np.diff(q)) <= SMALL * np.maximum(1.0, np.abs(q[:, 1:]))).all(axis=0)
    first = np.concatenate([np.ones(min(1, point.size), dtype=np.bool_), ~again])
    return q[:, first], point[first]


def _crossing(a: ComplexArray, b: ComplexArray) -> ComplexArray:
    """Eigenvalues above the real axis whose real part changes sign to the next state; each is followed."""
    i, j = linear_sum_assignment(np.abs(a[:, None] - b[None]))
    size = max(np.abs([*a, *b]), default=0.0)
    before, after = a[i], b[j]
    passes = (before.real * after.real < 0) & (np.minimum(np.abs(before.real), np.abs(after.real)) > GROWS * size)
    return np.asarray(before[passes])


def _bisected(
    system: Augmented,
    low: tuple[FloatArray, ComplexArray],
    high: tuple[FloatArray, ComplexArray],
    halvings: int,
) -> list[Sighting]:
    """The onsets between two states with their λ, of which some cross: those are followed anew to the middle and from there."""
    state = _state(system, 0.5 * (low[0] + high[0]))
    (roots,) = _signals(system, state[:, None])
    middle = state, roots
    halves = [(one, other) for one, other in ((low, middle), (middle, high)) if _crossing(one[1], other[1]).size]
    if halvings and halves:
        # Where more than one onset lies between, the halvings are shared.
        share = (halvings - 1) // len(halves)
        return [sighting for one, other in halves for sighting in _bisected(system, one, other, share)]
    # Else the ends do not lie on one branch.
    crossing = _crossing(low[1], high[1])
    if system.condition is not HOPF:
        return [(state, np.nan) for _ in crossing]
    nearest = [roots[np.abs(roots - here).argmin()] for here in crossing if roots.size]
    return [(state, abs(here.imag)) for here in nearest if abs(here.real) <= SMALL * abs(here)]


def _state(system: Augmented, z: FloatArray) -> FloatArray:
    """The state of the value z[−1] that Newton's method finds near by."""
    parameters = Intervals.point(system.family.at(z[-1:, None]))
    with np.errstate(all="ignore"):
        q = system.balance.guessed(z[:-1, None], system.balance.prepared(parameters))
    return np.append(q[:, 0], z[-1])


def _signals(system: Augmented, z: FloatArray) -> list[ComplexArray]:
    """Numbers whose real part changes its sign at an onset, of each state z, shape (n + 1, N).

    The λ above the real axis; where friction alone damps, or nothing, the condition's own value.
    """
    if system.condition is HOPF:
        every = stability.roots(*matrices(system.family, z))
        return [row[np.isfinite(row) & (row.imag > OSCILLATES * np.abs(row))] for row in every]
    with np.errstate(all="ignore"):
        tested = system.residuals(Intervals.point(z), system.fixed(z.shape[1])).middle[-1:].T.astype(complex)
    return [row[np.isfinite(row)] for row in tested]
