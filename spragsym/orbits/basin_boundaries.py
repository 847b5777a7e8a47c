"""Basin boundaries: the intersection of the stable manifold of a saddle equilibrium with a plane of
initial states, and the parts of it that separate basins.

An initial state is on the stable manifold if its motion does not leave the saddle along the
unstable direction: the component of the final deviation along it, measured by the left eigenvector,
is 0. Newton's method solves this for longer and longer times (:meth:`_Walk.refined`). From a first
point, found by bisection, the curve is followed in both directions (:meth:`_Walk.follow`). Fates of
motions on both sides of each point show whether it separates basins (:meth:`_Walk.sides_verified`).
"""

from __future__ import annotations

import time
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
from ..motion.simulation import Start, Trajectory, state_of
from ..numerics.interval_arrays import BoolArray
from ..numerics.vectors import magnitude, norm
from ..results.result import Result
from ..statics.equilibria import equilibria
from .system import (
    FateVerdict,
    Saddle,
    System,
    TooUnstableError,
    judged,
    saddle_near,
    verified,
)

if TYPE_CHECKING:
    from .orbit import Cycle


@dataclass(frozen=True, eq=False)
class BasinBoundary(Result):
    """A curve of initial states in a plane whose motions tend to a saddle equilibrium: part of its
    stable manifold.

    Motions from both sides of the curve leave the saddle in opposite directions. They need not
    reach different attractors, since a motion may turn around later: ``boundary`` is True only
    where they do.

    Attributes
    ----------
    plane : tuple of str
        The two coordinates or rates.
    points : ndarray, shape (n, 2)
        Points in order along the curve.
    error : ndarray, shape (n,)
        Change of each point by the last refinement.
    boundary : ndarray of bool, shape (n,)
        True if initial states at a distance of 1e-6 on the two sides of the curve reach different
        attractors, and those at a quarter of this distance the same two. Elsewhere both sides
        belong to one basin, or are undecided, or were not followed in the time that ``seconds`` of
        :class:`spragsym.MotionOptions` allows.
    sides : ndarray of str, shape (n, 2)
        Fates of these states as text: on the side where the component along the unstable direction
        becomes negative, and on that where it becomes positive; with the fates of nearer states, if
        they differ.
    saddle : ndarray, shape (m,)
        The saddle.
    growth : float
        Its unstable eigenvalue, the only one that grows.
    how : tuple of str
        Reason for which the curve ends, at its first and at its last point; half of that time
        being over is one.
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
    start: Start | None = None,
    saddle: ArrayLike | Trajectory | Cycle | None = None,
    between: Ranges | None = None,
    step: float | None = None,
    points: int = 80,
    backend: str | None = None,
    options: MotionOptions | None = None,
    **values: float | None,
) -> BasinBoundary:
    """The stable manifold of a divergent equilibrium in a plane of initial states, and where it is
    the boundary of a basin.

    Parameters
    ----------
    p : Parameters of any model
        Scalars, for which there is a divergent equilibrium; in the article's model that is where
        there are three equilibria.
    plane : tuple of str, optional
        Two of the coordinates and rates, as x, y, vx, vy; by default the first coordinate and its
        rate. The others have the values in ``start``.
    start : array_like or mapping, optional
        A state in the plane, by default 0. The first point of the curve is searched for through it,
        along the first direction of the plane.
    saddle : array_like, optional
        Coordinates near the equilibrium; needed if there are several. The default is the only one
        in contact, or if there is none in contact, the only one without contact.
    between : mapping, optional
        Ranges of the two by name; by default 3 to either side of the equilibrium for coordinates, 1
        for rates, in units of the motion.
    step : float, optional
        Distance of neighbouring points, in the unit of the first direction of the plane; by default
        1/300 of its range.
    points : int
        Maximum number of points in each direction.
    options : MotionOptions, optional
        Tolerances by which fates are recognized.
    **values : float, optional
        Values of parameters that replace those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    BasinBoundary

    Raises
    ------
    ParameterError, ParameterTypeError
        For invalid arguments, and unless there is exactly one divergent equilibrium (near
        ``saddle``, if that is given) with one unstable direction: where three λ grow, its stable
        manifold bounds no basin.
    ConvergenceError
        If no first point is found on the line through ``start``, or not in ``seconds`` of the
        options.

    Notes
    -----
    An initial state is on the manifold if its motion never leaves the saddle along the unstable
    direction. The component along it, measured by the left eigenvector, is made zero at later and
    later times by Newton's method. Each point is on the manifold, and on the boundary of a basin
    where ``boundary`` is True. Other sheets of the manifold may be elsewhere in the plane; distant
    folds are not followed. If folds are closer than ``step``, the curve may pass from one to the
    next, which a smaller step shows.

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
    begun = time.thread_time()
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
    default_step = (high - low) * (1 / 300)
    step = default_step if step is None else as_number("step", step, POSITIVE) / float(units[0])
    points = as_count("points", points)
    until = begun + system.options.seconds
    walk = _Walk(
        system, scales, saddle_point, np.eye(len(names))[axes], ranges, step, points, until
    )
    first, error, span = walk.begun(state_of(model, start) / scales.states)
    # A quarter of the time for each direction, the rest for what is on both sides.
    now = time.thread_time()
    backward, why_backward = walk.follow(first, span, -1.0, now + (until - now) / 4)
    forward, why_forward = walk.follow(first, span, 1.0, now + (until - now) / 2)
    found = [*reversed(backward), (first, error), *forward]
    verdicts = walk.all_sides([state for state, _ in found], span)
    return BasinBoundary(
        plane,
        np.array([units * state[axes] for state, _ in found]),
        np.array([units.max() * error for _, error in found]),
        np.array([differ for differ, _ in verdicts]),
        np.array([sides for _, sides in verdicts]),
        saddle_point.state,
        saddle_point.growth,
        (why_backward, why_forward),
    )


def _verdict(system: System, start: FloatArray) -> FateVerdict:
    """Fate of a motion, undecided if rounding may change it."""
    found = judged(system, start)
    return verified(system, start, found, lambda neighbour: not _differ(system, found, neighbour))


def _differ(system: System, one: FateVerdict, other: FateVerdict) -> bool:
    """True if two motions reach different attractors, both decided."""
    decided = one.decided and other.decided
    return decided and system.same_limit(one.outcome, other.outcome) is False


def _saddle(system: System, p: ParameterSet, near: Any) -> Saddle:
    """The saddle whose manifold is computed: the one near given coordinates; or the only saddle
    among the equilibria of steady sliding, or if there is none, among those without contact.
    """
    n = len(p.model.coordinates)
    found, wider = list[Saddle](), False
    if near is not None:
        guess = as_numbers("saddle", near)
        if guess.shape not in ((n,), (2 * n,)):
            raise ParameterError(
                f"saddle has the shape {guess.shape}; give the {n} coordinates of a place near it"
            )
        found, wider = _saddles(system, [guess])
    for contact in (None, False) if near is None else ():
        if not (found or wider) and contact in (None, *p.model.regimes):
            rests = equilibria(p, contact)
            columns = [column[rests.states] for column in rests.coordinates.values()]
            found, wider = _saddles(system, np.transpose(columns))
    if len(found) != 1:
        listed = "; ".join(str(np.round(each.state, 6).tolist()) for each in found)
        none = (
            "none that grows in one direction only. Where a pair of eigenvalues grows as well, the "
            "stable manifold has too few dimensions to bound a basin; unstable_before and "
            "unstable_after of ss.flutter_onsets say from where on"
        )
        raise ParameterError(
            "one divergent equilibrium is needed to follow its stable manifold, there are: "
            + (f"{listed}; give saddle= near one" if found else none)
        )
    return found[0]


def _saddles(system: System, places: Iterable[FloatArray]) -> tuple[list[Saddle], bool]:
    """The different saddles that Newton's method finds from several guesses, and whether there is
    one beside them that bounds no basin.
    """
    found, wider = list[Saddle](), False
    for guess in places:
        try:
            saddle = saddle_near(system, guess)
        except ConvergenceError as error:
            wider |= isinstance(error, TooUnstableError)
            continue
        states = system.scales(saddle.state).states
        if not any(magnitude((saddle.state - one.state) / states) < 1e-9 for one in found):
            found.append(saddle)
    return found, wider


@dataclass(frozen=True)
class _Walk:
    """Computation of one curve of the manifold, in units of the motion about the saddle ``scales``;
    only ``system`` and the saddle ``natural`` are in the model's units.

    The rows of ``plane``, (2, m), are unit vectors along its two directions, ``to`` their ranges.
    ``until`` is the processor time of this thread at which no further motion is begun.
    """

    system: System
    scales: MotionScales
    natural: Saddle
    plane: FloatArray
    to: FloatArray
    step: float
    points: int
    until: float

    @cached_property
    def own(self) -> System:
        """The system in units of the motion."""
        return self.system.scaled(self.scales)

    @cached_property
    def saddle(self) -> Saddle:
        """The saddle in these units."""
        return saddle_near(self.own, self.natural.state / self.scales.states)

    def component(self, state: FloatArray, span: float) -> tuple[float, FloatArray]:
        """Component of the deviation from the saddle along the unstable direction, after a time
        ``span`` from an initial state; its derivatives in the plane, (2,).
        """
        flow_result = self.own.flow.flow_map(state, self.system.constants, span)
        left_eigenvector = self.saddle.left_eigenvector
        value = float(left_eigenvector @ (flow_result.state - self.saddle.state))
        return value, self.plane @ (left_eigenvector @ flow_result.by_state)

    def begun(self, state: FloatArray) -> tuple[FloatArray, float, float]:
        """A first point of the curve, as :meth:`refined` gives it, on the line through a state
        along the first direction of the plane.

        It is bracketed between initial states whose motions leave the saddle on different sides.
        """
        from scipy.optimize import bisect

        low, high = self.to[0]
        grid = np.linspace(low, high, 121)

        def at(x: float) -> FloatArray:
            return np.where(self.plane[0], x, state)

        def side(x: float) -> float:
            if time.thread_time() > self.until:
                raise ConvergenceError(
                    f"{self.late} before a first point was found; give a start near the boundary, "
                    "or more seconds of ss.MotionOptions"
                )
            return self.leaves(at(x))[0]

        sides = [side(x) for x in grid]
        changes = np.flatnonzero(np.abs(np.diff(sides)) > 1).tolist()
        if not changes:
            raise ConvergenceError(
                "no start in that line of the plane leaves the saddle to the other side; give "
                "another start"
            )
        for i in sorted(changes, key=lambda i: abs(grid[i] - self.plane[0] @ self.saddle.state)):
            guess = at(bisect(side, grid[i], grid[i + 1], xtol=5e-10 * (high - low)))
            for span in (0.75 * self.leaves(guess)[1], 3 / self.saddle.growth):
                # It fails where the side changes because a motion turns around late.
                with suppress(ConvergenceError):
                    return self.refined(guess, np.array([1.0, 0.0]), span)
        raise ConvergenceError(
            "no place in that line of the plane where the side changes is on the boundary; "
            "give another start"
        )

    @property
    def late(self) -> str:
        """Text that the time is over."""
        return f"{self.system.options.seconds:g} s of processor time were over"

    def leaves(self, state: FloatArray) -> tuple[float, float]:
        """Side on which a motion leaves the saddle, and when: the sign of its component along the
        unstable direction, once that is large; 20 / growth at most.
        """
        constants, large = self.system.constants, 0.1 * magnitude(self.saddle.left_eigenvector)
        component, clock = 0.0, 0.0
        for _ in range(20):
            state = self.own.flow.plain(state, constants, 1 / self.saddle.growth).state
            clock += 1 / self.saddle.growth
            component = float(self.saddle.left_eigenvector @ (state - self.saddle.state))
            if abs(component) > large:
                break
        return float(np.sign(component)), clock

    def refined(
        self, state: FloatArray, direction: FloatArray, span: float
    ) -> tuple[FloatArray, float, float]:
        """The initial state on the manifold near a guess, along a direction in the plane (2,); the
        last change; the time for which its motion was followed.

        Newton's method for :meth:`component` = 0, at longer and longer times: each 1 / growth
        reduces the error by a factor of e.
        """
        previous = np.inf
        for _ in range(40):
            first = np.inf
            for _ in range(10):
                value, slope = self.component(state, span)
                along = float(slope @ direction)
                if along == 0:
                    raise ConvergenceError("the boundary is not crossed along that direction")
                change = -value / along
                if abs(change) > min(0.2, max(10 * previous, 1e-4)):
                    raise ConvergenceError("the boundary is not near")
                state = state + change * direction @ self.plane
                if abs(change) < 1e-11:
                    return state, max(abs(change), 1e-15), span
                if abs(change) < 0.1 * first < np.inf:
                    break
                first = min(first, abs(change))
            previous, span = first, span + 2.5 / self.saddle.growth
        raise ConvergenceError("the boundary could not be refined")

    def follow(
        self, first: FloatArray, span: float, sign: float, until: float
    ) -> tuple[list[tuple[FloatArray, float]], str]:
        """Points of the curve with their errors in one direction, and the reason for which they
        end.
        """
        found: list[tuple[FloatArray, float]] = []
        state, previous, step = first, None, self.step
        while len(found) < self.points:
            if time.thread_time() > until:
                return found, f"half of the {self.late}"
            _, slope = self.component(state, span)
            normal = slope / norm(slope)
            tangent = np.array([-normal[1], normal[0]])
            tangent *= sign if previous is None else np.sign(tangent @ previous)
            guess = state + step * tangent @ self.plane
            try:
                # The guess is off the curve by the order of step²: its motion is followed for a
                # shorter time, after which it is still near the saddle.
                growth = norm(slope) * step**2 / (0.1 * magnitude(self.saddle.left_eigenvector))
                shorter = span - max(np.log(growth), 0.0) / self.saddle.growth
                with doing("point {} in one direction of the boundary", len(found) + 1):
                    ahead, error, later = self.refined(guess, normal, shorter)
                moved = self.plane @ (ahead - state)
                if moved @ tangent < 0.95 * norm(moved) or norm(moved) > 3 * step:
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
            state, previous, step, span = ahead, tangent, min(self.step, 1.5 * step), later
        return found, f"{self.points} points were followed"

    def all_sides(self, states: list[FloatArray], span: float) -> list[tuple[bool, list[str]]]:
        """The verdicts of :meth:`sides_verified` for all points, in an order that spreads over the
        curve; of those that are left when the time is over, that they were not asked.
        """
        late = f"not followed: {self.late}"
        verdicts = [(False, [late, late])] * len(states)
        # The first, then by the lowest bit that is set: every 64th, every 32nd, …
        for index in sorted(range(len(states)), key=lambda i: -(i & -i or len(states))):
            if time.thread_time() > self.until:
                break
            verdicts[index] = self.sides_verified(states[index], span)
        return verdicts

    def sides_verified(self, state: FloatArray, span: float) -> tuple[bool, list[str]]:
        """True if the two sides of a point are in different basins; and the fates as text.

        Basins may alternate beside the curve: so nearer states must have the same fates.
        """
        distance = 1e-6
        both = self.sides(state, span, distance)
        if not _differ(self.system, *both):
            return False, [str(each.described()) for each in both]
        is_boundary, texts = True, list[str]()
        for one, near in zip(both, self.sides(state, span, 0.25 * distance), strict=True):
            text = str(one.described())
            if not near.decided or _differ(self.system, one, near):
                is_boundary = False
                text += f", and nearer by {near.described()}"
            texts.append(text)
        return is_boundary, texts

    def sides(self, state: FloatArray, span: float, distance: float) -> list[FateVerdict]:
        """Fates of states at a distance on either side of a point: first where the component along
        the unstable direction is smaller, then where it is larger.
        """
        _, normal = self.component(state, span)
        across = distance * normal / norm(normal) @ self.plane
        starts = (self.scales.states * (state + sign * across) for sign in (-1, 1))
        return [_verdict(self.system, start) for start in starts]
