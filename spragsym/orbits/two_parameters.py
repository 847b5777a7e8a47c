"""Events of cycles followed in two parameters: curves of folds, doublings, tori and grazings in a plane."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from itertools import islice

import numpy as np

from ..errors import ConvergenceError, ParameterError
from ..models.field import Field
from ..models.parameters import FloatArray
from ..motion.multipliers import CRITERIA, is_complex_pair
from ..motion.shooting import Loop
from ..progress import doing
from ..results.result import Result
from .arclength import Point, Setting, at_zero, corrected, point_of, steps
from .branch import CycleEvent
from .events import touching
from .orbit import Cycle, cycle_of

#: Lengths of a step, in states, shares of the period and spans of the parameters.
FIRST, LONGEST, SHORTEST, KINK = 0.01, 0.1, 1e-6, 1e-4

#: Spans of a parameter whose range is not given: of its value, and at least.
SPAN, LEAST = 0.25, 0.02


@dataclass(frozen=True, eq=False)
class EventCurve(Result):
    """A curve of events in the plane of two parameters.

    Attributes
    ----------
    kind : str
    vary : tuple of str
    values : ndarray, shape (n, 2)
    periods : ndarray, shape (n,)
    how : tuple of str
        Why the curve ends, at its first and at its last point.
    cycles : tuple of Cycle
    """

    kind: str
    vary: tuple[str, str]
    values: FloatArray
    periods: FloatArray
    how: tuple[str, str]
    cycles: tuple[Cycle, ...] = field(repr=False)

    @property
    def table_model(self) -> Field | None:
        """It knows which parameters are angles."""
        return self.cycles[0].field if self.cycles else None


def cycle_events(
    event: CycleEvent, vary: tuple[str, str], *, to: dict[str, tuple[float, float]] | None = None, points: int = 60
) -> EventCurve:  # fmt: skip
    """Follow a fold, doubling, torus or grazing of cycles in two parameters.

    Parameters
    ----------
    event : CycleEvent
        Of a branch.
    vary : tuple of str
        Two parameters.
    to : dict, optional
        Parameter → range; the curve ends where it leaves it.
    points : int
        Most points each way.

    Returns
    -------
    EventCurve

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and events of another kind.

    Notes
    -----
    Newton's method on the closed orbit, with the event's test function as one more equation: for a fold det(1 − R) = 0 and for
    a doubling det(1 + R) = 0, R the monodromy matrix across the flow; for a grazing level and rate of the border at the start.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.cycle(ss.Parameters.article(theta0=np.radians(43.1)), V=0.5, d=10.0, near=(2.54, 3.36, 0, 0.36))
    >>> (doubling,) = ss.cycle_branch(found, "theta0", np.radians([43.09, 43.13])).of("period_doubling")
    >>> curve = ss.cycle_events(doubling, ("theta0", "mu0"), points=1)
    >>> np.degrees(curve.values[:, 0]).round(2).tolist(), curve.values[1, 1].item()
    ([43.03, 43.12, 43.21], 0.5)
    """
    if event.loop is None or event.kind not in (*CRITERIA, "grazing"):
        raise ParameterError(f"a {event.kind} is not followed in two parameters; give a fold, doubling, torus or grazing")
    model = event.cycle.field
    for name in vary:
        if name not in model.parameters:
            raise ParameterError(f"vary = {vary!r}: {name!r} is not one of {', '.join(model.parameters)}")
    if len(vary) != 2 or vary[0] == vary[1]:
        raise ParameterError(f"vary = {vary!r} is not two parameters")
    free = (model.parameters.index(vary[0]), model.parameters.index(vary[1]))
    ranges = to or {}
    spans = []
    for name, index in zip(vary, free, strict=True):
        low, high = ranges.get(name, (0.0, 0.0))
        spans.append((high - low) / 2 if high > low else max(SPAN * abs(event.loop.values[index]), LEAST))
    holds = partial(touching, event.border) if event.border >= 0 else partial(at_zero, event.kind)
    setting = Setting(event.loop.flow, free, event.cycle.period, tuple(spans), event=holds)
    bounds = [ranges.get(name, (-np.inf, np.inf)) for name in vary]
    first = point_of(setting, setting.looped(event.loop.guess))
    (back, why_back), (forth, why_forth) = (_followed(event.kind, bounds, points, first, sign) for sign in (-1.0, 1.0))
    loops = [*reversed(back), first.loop, *forth]
    cycles = tuple(cycle_of(each) for each in loops)
    return EventCurve(
        event.kind, vary, np.array([[each.values[i] for i in free] for each in loops]),
        np.array([each.period for each in loops]), (why_back, why_forth), cycles,
    )  # fmt: skip


def _followed(
    kind: str, bounds: list[tuple[float, float]], points: int, first: Point, direction: float
) -> tuple[list[Loop], str]:  # fmt: skip
    """Loops in one direction, and why they end."""
    found: list[Loop] = []

    def ahead(point: Point, length: float) -> Point:
        with doing("point {} in one direction of the curve", len(found) + 1):
            return corrected(point, length, reach=0.5, iterations=9)

    try:
        for point in islice(steps(first.turned(direction), ahead, FIRST, LONGEST, SHORTEST, KINK), points):
            if not all(low <= point.loop.values[i] <= high for i, (low, high) in zip(first.setting.free, bounds, strict=True)):
                return found, "the range ends"
            if kind == "torus" and not is_complex_pair(point.loop):
                return found, "its multipliers become real"
            found.append(point.loop)
    except (ConvergenceError, np.linalg.LinAlgError) as error:
        return found, f"it could not be followed farther: {error}"
    return found, f"{points} points were followed"
