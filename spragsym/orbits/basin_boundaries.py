"""Basin boundaries: the stable manifold of a divergent equilibrium in a plane of starts, and where
it bounds a basin.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError
from ..core.progress import doing
from ..core.questions import model_of
from ..models.parameters import (
    POSITIVE,
    FloatArray,
    ParameterSet,
    Ranges,
    as_count,
    as_number,
    as_numbers,
    as_ranges,
)
from ..motion.options import MotionOptions
from ..motion.scales import MotionScales
from ..motion.simulation import Trajectory, state_of
from ..numerics.interval_arrays import BoolArray
from ..numerics.vectors import magnitude, norm
from ..results.result import Result
from ..statics.equilibria import equilibria
from .system import FateVerdict, Saddle, System, judged, saddle_near, verified

if TYPE_CHECKING:
    from .orbit import Cycle


@dataclass(frozen=True, eq=False)
class BasinBoundary(Result):
    """A curve of starts in a plane from which a motion goes to the divergent equilibrium: its
    stable manifold.

    Motions from both sides of the curve leave the equilibrium to different sides. Whether they come
    to different attractors is another question, since a motion that is turned back at first may go
    over later: ``boundary`` is true only where they do.

    Attributes
    ----------
    plane : tuple of str
    points : ndarray, shape (n, 2)
        In order along the curve.
    error : ndarray, shape (n,)
        How much the last refinement moved them.
    boundary : ndarray of bool, shape (n,)
        Whether starts 1e-6 to either side of a point, across the curve, come to different
        attractors, and to the same two at a quarter of that. What is not is manifold, with one
        basin on both sides, or undecided.
    sides : ndarray of str, shape (n, 2)
        What they come to, in words: where the part along the saddle's direction of growth becomes
        negative, and where positive; and what nearer starts come to, where that is something else.
    saddle : ndarray, shape (m,)
        The equilibrium.
    growth : float
        Its eigenvalue.
    how : tuple of str
        Why the curve ends, at its first and at its last point.
    """

    plane: tuple[str, str]
    points: FloatArray
    error: FloatArray
    boundary: BoolArray
    sides: NDArray[np.str_]
    saddle: FloatArray
    growth: float
    how: tuple[str, str]


@in_usual_state
def basin_boundary(
    p: ParameterSet,
    *,
    plane: tuple[str, str] | None = None,
    start: ArrayLike | None = None,
    saddle: ArrayLike | Trajectory | Cycle | None = None,
    between: Ranges | None = None,
    step: float | None = None,
    points: int = 80,
    backend: str | None = None,
    options: MotionOptions | None = None,
    **values: float | None,
) -> BasinBoundary:
    """The stable manifold of a divergent equilibrium in a plane of starts, and where it is the
    boundary of a basin.

    Parameters
    ----------
    p : Parameters of any model
        Scalars, where there is a divergent equilibrium; in the article's model that is where there
        are three.
    plane : tuple of str, optional
        Two of the coordinates and rates, as x, y, vx, vy; the others are those of ``start``. The
        first coordinate and its rate unless told otherwise.
    start : array_like, optional
        A state in the plane, 0 where it is left out; the curve is looked for along the first
        direction of the plane, from the equilibrium on.
    saddle : array_like, optional
        Coordinates near the equilibrium; needed where there are several. Without them it is the
        one in contact, or where there is none in contact, the one where nothing touches.
    between : mapping, optional
        Ranges of the two by name; by default 3 to either side of the equilibrium, and 1 for speeds,
        in units of the motion, which are 1 for numbers of a common size.
    step : float, optional
        Between neighbours on the curve, along the first direction of the plane; a 300th of that
        range where it is left out.
    points : int
        Most points either way.
    options : MotionOptions, optional
        Numbers by which fates are told.
    **values : float, optional
        Parameters in place of those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    BasinBoundary

    Raises
    ------
    ParameterError, ParameterTypeError
        For arguments that make no sense, and unless there is one divergent equilibrium, near
        ``saddle`` if that is given.

    Notes
    -----
    A start is on the manifold if its motion never leaves along the saddle's direction of growth:
    the part along it, which the left eigenvector measures, is made zero at later and later times by
    Newton's method. Each point found is on the manifold, and on the boundary of a basin where
    ``boundary`` says so; other sheets of the manifold may be elsewhere in the plane, and far folds
    of it are not followed. Where folds lie closer than ``step``, the walk may pass from one to the
    next: a smaller step tells.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(40))
    >>> found = ss.basin_boundary(p, V=0.5, d=10.0, step=0.1, points=1)
    >>> found.points.round(3).tolist()
    [[0.528, -0.017], [0.429, 0.0], [0.33, 0.014]]
    >>> found.boundary.tolist(), found.sides[0].tolist()
    ([False, False, False], ['a cycle of period 34.0235', 'a cycle of period 34.0235'])
    """
    model = model_of(p)
    model.require_answered("basin_boundary")
    system = System.of(p := p.given(**values), backend, options)
    names = model.components
    plane = (model.coordinates[0], model.rates[0]) if plane is None else plane
    if not len(plane) == len({*plane} & {*names}) == 2:
        raise ParameterError(f"plane = {plane!r} is not two of {', '.join(names)}")
    axes = [names.index(name) for name in plane]
    saddle_point = _saddle(system, p, saddle)
    scales = system.scales(saddle_point.state)
    units = scales.states[axes]
    widths = units * [3.0 if name in model.coordinates else 1.0 for name in plane]
    given = as_ranges("between", between, {name: model.any_of(name) for name in plane})
    about = zip(plane, saddle_point.state[axes], widths, strict=True)
    ranges = np.array([given.get(name, (at - width, at + width)) for name, at, width in about])
    ranges /= units[:, None]
    low, high = ranges[0]
    # Distance of neighbours on the curve by default, as a share of the range.
    whole = (high - low) * (1 / 300)
    step = whole if step is None else as_number("step", step, POSITIVE) / float(units[0])
    points = as_count("points", points)
    walk = _Walk(system, scales, saddle_point, np.eye(len(names))[axes], ranges, step, points)
    first, error, span = walk.begun(state_of(model, start) / scales.states)
    (back, why_back), (forth, why_forth) = (walk.follow(first, span, sign) for sign in (-1.0, 1.0))
    found = [*reversed(back), (first, error), *forth]
    differ, sides = map(
        np.array, zip(*(walk.sides_verified(each, span) for each, _ in found), strict=True)
    )
    return BasinBoundary(
        plane,
        np.array([units * each[axes] for each, _ in found]),
        np.array([units.max() * error for _, error in found]),
        differ,
        sides,
        saddle_point.state,
        saddle_point.growth,
        (why_back, why_forth),
    )


def _surely(system: System, start: FloatArray) -> FateVerdict:
    """Fate of a motion, unless rounding decides that."""
    found = judged(system, start)
    return verified(system, start, found, lambda beside: not _differ(system, found, beside))


def _differ(system: System, one: FateVerdict, other: FateVerdict) -> bool:
    """Whether two motions are seen to come to different attractors."""
    decided = one.decided and other.decided
    return decided and system.same_limit(one.outcome, other.outcome) is False


def _saddle(system: System, p: ParameterSet, near: Any) -> Saddle:
    """The saddle from which to look: near a place that is given, or the one among the equilibria of
    steady sliding, and where none of these is one, among those where nothing touches.
    """
    n = len(p.model.coordinates)
    found: list[Saddle] = []
    if near is not None:
        guess = as_numbers("saddle", near)
        if guess.shape not in ((n,), (2 * n,)):
            raise ParameterError(
                f"saddle has the shape {guess.shape}; give the {n} coordinates of a place near it"
            )
        found = _saddles(system, [guess])
    for contact in (None, False) if near is None else ():
        if not found and contact in (None, *p.model.regimes):
            rests = equilibria(p, contact)
            columns = [column[rests.states] for column in rests.coordinates.values()]
            found = _saddles(system, np.transpose(columns))
    if len(found) != 1:
        listed = "; ".join(str(np.round(each.state, 6).tolist()) for each in found)
        none = (
            "none that grows in one direction only: where friction falls with speed, the mass may "
            "swing there as well"
        )
        raise ParameterError(
            "one divergent equilibrium is needed to follow its stable manifold, there are: "
            + (f"{listed}; give saddle= near one" if found else none)
        )
    return found[0]


def _saddles(system: System, places: Iterable[FloatArray]) -> list[Saddle]:
    """Those near places, each once."""
    found: list[Saddle] = []
    for guess in places:
        with suppress(ConvergenceError):
            saddle = saddle_near(system, guess)
            states = system.scales(saddle.state).states
            # Equilibria that differ by less than this are one. Lengths are in units
            # of the motion about the saddle.
            if not any(magnitude((saddle.state - one.state) / states) < 1e-9 for one in found):
                found.append(saddle)
    return found


@dataclass(frozen=True)
class _Walk:
    """One curve on the manifold, in a plane of which the rows of ``plane`` are the directions, all
    but ``system`` and ``natural`` in units of the motion about the saddle.
    """

    system: System
    scales: MotionScales
    natural: Saddle
    plane: FloatArray
    to: FloatArray
    step: float
    points: int

    @cached_property
    def own(self) -> System:
        """The system in units of the motion."""
        return self.system.scaled(self.scales)

    @cached_property
    def saddle(self) -> Saddle:
        """The saddle in these units."""
        return saddle_near(self.own, self.natural.state / self.scales.states)

    def off(self, state: FloatArray, span: float) -> tuple[float, FloatArray]:
        """Distance of a motion along the direction of growth, and the derivative of that in the
        plane.
        """
        flow_result = self.own.flow.flow_map(state, self.system.constants, span)
        left_eigenvector = self.saddle.left_eigenvector
        return float(left_eigenvector @ (flow_result.state - self.saddle.state)), self.plane @ (
            left_eigenvector @ flow_result.by_state
        )

    def begun(self, state: FloatArray) -> tuple[FloatArray, float, float]:
        """A first point, along the first direction of the plane, between starts that leave to
        different sides.
        """
        from scipy.optimize import bisect

        low, high = self.to[0]
        ways = np.linspace(low, high, 121)

        def at(way: float) -> FloatArray:
            return np.where(self.plane[0], way, state)

        sides = [self.leaves(at(way))[0] for way in ways]
        changes = np.flatnonzero(np.abs(np.diff(sides)) > 1).tolist()
        if not changes:
            raise ConvergenceError(
                "no start in that line of the plane leaves the saddle to the other side; give "
                "another start"
            )
        for near in sorted(changes, key=lambda i: abs(ways[i] - self.plane[0] @ self.saddle.state)):
            # Between starts so close that leave to different sides, as a share of
            # the range, Newton's method begins.
            begun = at(
                bisect(
                    lambda way: self.leaves(at(way))[0],
                    ways[near],
                    ways[near + 1],
                    xtol=5e-10 * (high - low),
                )
            )
            for span in (0.75 * self.leaves(begun)[1], 3 / self.saddle.growth):
                with suppress(
                    ConvergenceError
                ):  # a side that changes because a motion turns late is no boundary
                    return self.refined(begun, np.array([1.0, 0.0]), span)
        raise ConvergenceError(
            "no place in that line of the plane where the side changes is on the boundary; "
            "give another start"
        )

    def leaves(self, state: FloatArray) -> tuple[float, float]:
        """To which side a motion leaves, and when: the sign of its part along the direction of
        growth, once that is large.
        """
        constants, reach = self.system.constants, 0.1 * magnitude(self.saddle.left_eigenvector)
        part, clock = 0.0, 0.0
        for _ in range(20):
            state = self.own.flow.plain(state, constants, 1 / self.saddle.growth).state
            clock += 1 / self.saddle.growth
            part = float(self.saddle.left_eigenvector @ (state - self.saddle.state))
            if abs(part) > reach:
                break
        return float(np.sign(part)), clock

    def refined(
        self, state: FloatArray, direction: FloatArray, span: float
    ) -> tuple[FloatArray, float, float]:
        """The start on the manifold near another, along a direction in the plane; what the last
        refinement changed; the time.

        The longer the motion is followed, the more is known of the start, by a factor of e every 1
        / growth, each by a few steps of Newton's method.
        """
        before = np.inf
        for _ in range(40):
            first = np.inf
            for _ in range(10):
                value, slope = self.off(state, span)
                along = float(slope @ direction)
                if along == 0:
                    raise ConvergenceError("the boundary is not crossed along that direction")
                change = -value / along
                # A step of Newton's method longer than this leads astray.
                if abs(change) > min(0.2, max(10 * before, 1e-4)):
                    raise ConvergenceError("the boundary is not near")
                state = state + change * direction @ self.plane
                # A refinement that moves the start by less than this is the
                # last.
                if abs(change) < 1e-11:
                    return state, max(abs(change), 1e-15), span
                if abs(change) < 0.1 * first < np.inf:
                    break
                first = min(first, abs(change))
            # How much longer the motion is followed in each refinement, in units of
            # the saddle's time.
            before, span = first, span + 2.5 / self.saddle.growth
        raise ConvergenceError("the boundary could not be refined")

    def follow(
        self, first: FloatArray, span: float, sign: float
    ) -> tuple[list[tuple[FloatArray, float]], str]:
        """Points in one direction, and why they end."""
        found: list[tuple[FloatArray, float]] = []
        state, way, step = first, None, self.step
        while len(found) < self.points:
            _, slope = self.off(state, span)
            normal = slope / norm(slope)
            along = np.array([-normal[1], normal[0]])
            along = along * sign if way is None else along * np.sign(along @ way)
            guess = state + step * along @ self.plane
            try:
                # A start as far off the curve as the square of a step is
                # followed until it is off the saddle by no more than this.
                seen = norm(slope) * step**2 / (0.1 * magnitude(self.saddle.left_eigenvector))
                with doing("point {} in one direction of the boundary", len(found) + 1):
                    ahead, error, later = self.refined(
                        guess, normal, span - max(np.log(seen), 0.0) / self.saddle.growth
                    )
                moved = self.plane @ (ahead - state)
                # Cosine of the largest angle between a step and the curve's
                # tangent.
                if moved @ along < 0.95 * norm(moved) or norm(moved) > 3 * step:
                    raise ConvergenceError(
                        "farther off the tangent it is another fold of the manifold"
                    )
            except ConvergenceError:
                step /= 2
                if step < 1e-4:
                    return found, "it could not be followed farther"
                continue
            low, high = np.transpose(self.to)
            if not ((low <= self.plane @ ahead) & (self.plane @ ahead <= high)).all():
                return found, "the range ends"
            found.append((ahead, error))
            state, way, step, span = ahead, along, min(self.step, 1.5 * step), later
        return found, f"{self.points} points were followed"

    def sides_verified(self, state: FloatArray, span: float) -> tuple[bool, list[str]]:
        """Whether the sides of a point lie in different basins, also nearer by, and what starts
        there come to, in words.
        """
        aside = 1e-6
        both = self.sides(state, span, aside)
        if not _differ(self.system, *both):
            return False, [each.described() for each in both]
        # Where they differ it is looked at this share of the distance too: basins may
        # alternate beside the curve.
        nearer = self.sides(state, span, 0.25 * aside)
        other = [
            not near.decided or _differ(self.system, one, near)
            for one, near in zip(both, nearer, strict=True)
        ]
        sides = [
            one.described() + (f", and nearer by {near.described()}" if differs else "")
            for one, near, differs in zip(both, nearer, other, strict=True)
        ]
        return not any(other), sides

    def sides(self, state: FloatArray, span: float, aside: float) -> list[FateVerdict]:
        """Fates of starts to either side of a point: where the part along the direction of growth
        is less, and more.
        """
        _, normal = self.off(state, span)
        across = aside * normal / norm(normal) @ self.plane
        starts = (self.scales.states * (state + way * across) for way in (-1, 1))
        return [_surely(self.system, start) for start in starts]
