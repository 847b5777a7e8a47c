"""Onsets that floats see where a search over boxes ends before all is decided: each proved on its own if that succeeds.

States are found at many values of the parameter, and where the growth of an oscillation changes its sign from one value to the
next, Newton's method leads to the onset between them; where friction alone damps, or nothing, it is the condition's own value
that changes its sign. Krawczyk's operator proves the onset in a small box; what it does not prove is listed as seen.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from ..exact import certified_roots
from ..exact.certified_roots import Roots
from ..exact.interval_arrays import FloatArray, Intervals
from ..exact.krawczyk import as_intervals, narrowed
from ..exact.polynomials import Undecided
from . import stability
from .bifurcation_conditions import Hopf
from .border import BITS, on_its_side
from .defining_systems import Augmented
from .equilibria import seen
from .points import Found
from .precise_points import PreciseAugmented

#: Values of the parameter that are looked at.
VALUES = 61
#: Steps of Newton's method, the last of which has to be as small as this.
STEPS, CONVERGED = 12, 1e-9
#: Half-width of the box in which an onset is proved with many digits, over its size.
ROOM = 1e-6
#: Imaginary part of a λ that oscillates, over its size.
OSCILLATES = 1e-6


def with_seen(
    system: Augmented, given: FloatArray, span: FloatArray, found: Found, asked: FloatArray | None
) -> tuple[Found, Roots]:
    """What a search has found, with the onsets that floats see and that are proved; and those that are not."""
    fixed = np.where(np.isnan(given), span[0], given)
    candidates = _converged(system, fixed, _crossings(system, given, span, asked))
    inside = (span[0] <= candidates[-1]) & (candidates[-1] <= span[1])
    candidates = candidates[:, inside]
    room = ROOM * np.maximum(1.0, np.abs(candidates))
    wide = np.stack([room - candidates, room + candidates])
    proved_ends = [_proved(system, fixed[:, 0], box) for box in np.moveaxis(wide, 2, 0)]
    sure = np.array([ends is not None for ends in proved_ends], dtype=np.bool_)
    ends = np.concatenate([wide[:, :, :0], *(part for part in proved_ends if part is not None)], axis=2)
    nothing = found.roots.left[:, :, :0], found.roots.left_point[:0]
    proved, open_ = (
        on_its_side(
            system,
            fixed,
            Roots(part, part, np.zeros(part.shape[2], dtype=np.int64), *nothing),
            partial(PreciseAugmented, system, bits=BITS),
        )
        for part in (ends, wide[:, :, ~sure])
    )
    every = certified_roots.concatenated([found.roots, replace(proved, left=nothing[0], left_point=nothing[1])], system.n)
    order = np.argsort(-every.alone[0, 0])
    ends, alone = every.ends[:, :, order], every.alone[:, :, order]
    keep, _ = certified_roots.once(ends, alone, np.zeros(order.size, dtype=np.int64))
    roots = replace(found.roots, ends=ends[:, :, keep], alone=alone[:, :, keep], point=np.zeros(keep.size, dtype=np.int64))
    return replace(found, roots=roots), open_


def _proved(system: Augmented, given: FloatArray, box: FloatArray) -> FloatArray | None:
    """Floats around the onset in a box of shape (2, n + 1), None where it is not proved."""
    try:
        root = narrowed(PreciseAugmented(system, given, BITS), box, box)
    except (Undecided, ZeroDivisionError):
        return None
    return None if root is None else as_intervals(root).ends


def _crossings(system: Augmented, given: FloatArray, span: FloatArray, asked: FloatArray | None) -> FloatArray:
    """Coordinates and parameter between values at which the growth of an oscillation changes its sign, shape (n + 1, number)."""
    balance = system.balance
    values = span[0] + (span[1] - span[0]) * (np.arange(VALUES) + 0.5) / VALUES
    columns = np.repeat(given, VALUES, axis=1)
    columns[balance.parameters.index(system.vary[0])] = values
    found = seen(balance, columns, asked)
    q, point = found.middle, found.point
    out = []
    if point.size:
        with np.errstate(all="ignore"):  # beyond the touch a law like Hertz's has no value
            tested = _tested(system, q, columns[:, point])
        for one in range(point.size):
            following = np.flatnonzero(point == point[one] + 1)
            if not following.size:
                continue
            other = following[np.abs(q[:, following] - q[:, [one]]).max(axis=0).argmin()]
            a, b = tested[one], tested[other]
            if np.isfinite([a, b]).all() and a * b < 0:
                ends = [np.append(q[:, k], values[point[k]]) for k in (one, other)]
                out.append(ends[0] + (ends[1] - ends[0]) * a / (a - b))
    return np.array(out).reshape(-1, system.n).T


def _tested(system: Augmented, q: FloatArray, given: FloatArray) -> FloatArray:
    """What changes its sign at an onset, at states of shape (n, N)."""
    if isinstance(system.condition, Hopf):
        every = stability.roots(*(np.moveaxis(part, -1, 0) for part in stability.linearization(system.balance, q, given)))
        growth: FloatArray = np.where(np.abs(every.imag) > OSCILLATES * np.abs(every), every.real, -np.inf).max(axis=1)
        return growth
    z = np.concatenate([q, given[[system.balance.parameters.index(system.vary[0])]]])
    value: FloatArray = system.residuals(Intervals.point(z), system.prepared(Intervals.point(given))).middle[-1]
    return value


def _converged(system: Augmented, fixed: FloatArray, start: FloatArray) -> FloatArray:
    """Where Newton's method leads from the given ones, of those from which it converges."""
    z, change = start, np.full(start.shape[1], np.inf)
    with np.errstate(all="ignore"):
        parameters = system.prepared(Intervals.point(np.repeat(fixed, start.shape[1], axis=1)))
        for _ in range(STEPS if start.size else 0):
            after = Intervals(certified_roots.stepped(system, np.stack([-z, z]), parameters).ends).middle
            change, z = np.abs(after - z).max(axis=0), after
    return z[:, change <= CONVERGED * np.maximum(1.0, np.abs(z).max(axis=0, initial=0.0))]
