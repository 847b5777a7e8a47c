"""Where the stable manifold of a divergent equilibrium meets a plane of starts: the boundary of a basin."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..display import Result
from ..dynamics.field import Field
from ..dynamics.problem import BELT_SPEED, CREEP
from ..errors import ConvergenceError, ParameterError
from ..parameters import FINITE, NAMES, FloatArray, Parameters, as_number
from .flows import carrier
from .passage import Fly
from .saddles import Saddle, saddle_near, side
from .sprag import SPRAG

#: Components of a state, by name.
COMPONENTS = ("x", "y", "vx", "vy")

#: Longer times in one refinement, in units of the saddle's time.
MORE = 3.0

#: A refinement that moves the start by less than this is the last.
SETTLED = 1e-11


@dataclass(frozen=True, eq=False)
class BasinBoundary(Result):
    """A curve of starts in a plane from which a motion goes to the divergent equilibrium.

    Attributes
    ----------
    plane : tuple of str
    points : ndarray, shape (n, 2)
        In order along the curve.
    error : ndarray, shape (n,)
        How much the last refinement moved them.
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
    saddle: FloatArray
    growth: float
    how: tuple[str, str]


def basin_boundary(
    p: Parameters, *, V: float, d: float, plane: tuple[str, str] = ("x", "vx"), start: Any = (0.0, 0.0, 0.0, 0.0),
    to: tuple[tuple[float, float], tuple[float, float]] | None = None, step: float = 0.02, points: int = 80,
    backend: str | None = None,
) -> BasinBoundary:  # fmt: skip
    """The stable manifold of the divergent equilibrium in a plane of starts.

    Parameters
    ----------
    p : Parameters
        Scalars, where there are three equilibria.
    V, d : float
        As for :func:`~spragsym.simulate`.
    plane : tuple of str
        Two of x, y, vx, vy; the other two are those of ``start``.
    start : array_like of 4 numbers
        A state in the plane; the curve is looked for along the first direction of the plane, from the equilibrium on.
    to : pair of ranges, optional
        Of the two; by default 3 to either side of the equilibrium, and 1 for speeds.
    step : float
        Between neighbours on the curve.
    points : int
        Most points either way.

    Returns
    -------
    BasinBoundary

    Notes
    -----
    A start is on the manifold if its motion never leaves along the saddle's direction of growth: the part along it, which the
    left eigenvector measures, is made zero at later and later times by Newton's method. The curve found is one piece of
    the boundary; others may be elsewhere in the plane, and far folds of the manifold are not followed.
    """
    values = (*p.scalars(*NAMES), as_number("V", V, BELT_SPEED), as_number("d", d, CREEP))
    if len(plane) != 2 or plane[0] == plane[1] or any(name not in COMPONENTS for name in plane):
        raise ParameterError(f"plane = {plane!r} is not two of {', '.join(COMPONENTS)}")
    axes = (COMPONENTS.index(plane[0]), COMPONENTS.index(plane[1]))
    state = np.array([as_number("start", value, FINITE) for value in start])
    saddle = _divergent(p, values)
    fly, _ = carrier(SPRAG, backend)
    widths = [3.0 if axis < 2 else 1.0 for axis in axes]
    ranges = to or tuple((saddle.state[a] - w, saddle.state[a] + w) for a, w in zip(axes, widths, strict=True))
    walk = _Walk(SPRAG, fly, values, saddle, axes, ranges, step, points)
    first, error = walk.begun(state)
    ways = [walk.follow(first, error, sign) for sign in (-1.0, 1.0)]
    found = [*reversed(ways[0][0]), (first, error), *ways[1][0]]
    return BasinBoundary(
        plane, np.array([each[list(axes)] for each, _ in found]), np.array([error for _, error in found]), saddle.state,
        saddle.growth, (ways[0][1], ways[1][1]),
    )  # fmt: skip


def _divergent(p: Parameters, values: tuple[float, ...]) -> Saddle:
    """The divergent equilibrium at the friction of steady sliding, as the motion has it."""
    from ..catastrophe import sliding_friction
    from ..statics.solver import Stability, equilibria

    found = equilibria(p.replace(mu0=sliding_friction(values[1], values[-2], values[-1])))
    rows = np.flatnonzero(found.stability == Stability.DIVERGENT)
    if not len(rows):
        raise ParameterError("there is no divergent equilibrium, and so no such boundary; three equilibria are needed")
    place = np.array([found.x[rows[0]], found.y[rows[0]], 0.0, 0.0])
    saddle = saddle_near(SPRAG, values, place)
    if saddle is None:
        raise ConvergenceError("the divergent equilibrium repels in more than one direction")
    return saddle


@dataclass(frozen=True)
class _Walk:
    """One curve on the manifold."""

    field: Field
    fly: Fly
    values: tuple[float, ...]
    saddle: Saddle
    axes: tuple[int, int]
    to: Any
    step: float
    points: int

    def off(self, state: FloatArray, span: float) -> tuple[float, FloatArray]:
        """How far a motion has come along the direction of growth, and the derivative of that in the plane."""
        value, slope = side(self.field, self.fly, self.values, state, span, self.saddle)
        return value, slope[list(self.axes)]

    def begun(self, state: FloatArray) -> tuple[FloatArray, float]:
        """A first point, along the first direction of the plane: between starts that leave to different sides."""
        low, high = self.to[0]
        ways = np.linspace(low, high, 121)
        span = 6 / self.saddle.growth
        sides = []
        for way in ways:
            there = state.copy()
            there[self.axes[0]] = way
            sides.append(self._side(there, span))
        changes = [i for i in range(len(ways) - 1) if sides[i] * sides[i + 1] < 0]
        if not changes:
            raise ConvergenceError("no start in that line of the plane leaves the saddle to the other side; give another start")
        near = min(changes, key=lambda i: abs(ways[i] - self.saddle.state[self.axes[0]]))
        low, high = float(ways[near]), float(ways[near + 1])
        for _ in range(30):
            middle = (low + high) / 2
            there = state.copy()
            there[self.axes[0]] = middle
            low, high = (middle, high) if self._side(there, span) == sides[near] else (low, middle)
        there = state.copy()
        there[self.axes[0]] = (low + high) / 2
        direction = np.zeros(2)
        direction[0] = 1.0
        return self.refined(there, direction)

    def _side(self, state: FloatArray, span: float) -> float:
        """To which side a motion leaves first: the sign of its part along the direction of growth, once that is large."""
        none = np.zeros((2, len(self.field.parameters)))
        constants = self.field.constants(self.values)
        for _ in range(20):
            state = self.fly(state, constants, span / 6, none).state
            part = float(self.saddle.measure @ (state - self.saddle.state))
            if abs(part) > 0.5 * float(np.abs(self.saddle.measure).max()) * 0.2:
                break
        return float(np.sign(part))

    def refined(self, state: FloatArray, direction: FloatArray) -> tuple[FloatArray, float]:
        """The start on the manifold near another, along a direction in the plane, and what the last refinement changed."""
        span, before, moved = 3 / self.saddle.growth, np.inf, np.inf
        for _ in range(40):
            begun = state.copy()
            for _ in range(12):
                value, slope = self.off(state, span)
                along = float(slope @ direction)
                if along == 0:
                    raise ConvergenceError("the boundary is not crossed along that direction")
                change = -value / along
                if abs(change) > 0.2:
                    raise ConvergenceError("the boundary is not near")
                state = state.copy()
                state[list(self.axes)] += change * direction
                if abs(change) < 1e-13:
                    break
            moved = float(np.abs(state - begun).max())
            if moved < SETTLED:
                return state, max(moved, 1e-15)
            if moved > 10 * before:
                break
            before, span = moved, span + MORE / self.saddle.growth
        raise ConvergenceError("the boundary could not be refined")

    def follow(self, first: FloatArray, error: float, sign: float) -> tuple[list[tuple[FloatArray, float]], str]:
        """Points in one direction, and why they end."""
        found: list[tuple[FloatArray, float]] = []
        state, way, step = first, None, self.step
        span = 12 / self.saddle.growth
        while len(found) < self.points:
            _, slope = self.off(state, span)
            normal = slope / np.linalg.norm(slope)
            along = np.array([-normal[1], normal[0]])
            along = along * sign if way is None else along * np.sign(along @ way)
            guess = state.copy()
            guess[list(self.axes)] += step * along
            try:
                ahead, error = self.refined(guess, normal)
            except ConvergenceError:
                step /= 2
                if step < 1e-4:
                    return found, "it could not be followed farther"
                continue
            moved = (ahead - state)[list(self.axes)]
            if moved @ along < 0.3 * float(np.linalg.norm(moved)) or np.linalg.norm(moved) > 3 * step:
                step /= 2
                if step < 1e-4:
                    return found, "it could not be followed farther"
                continue
            inside = [low <= ahead[axis] <= high for axis, (low, high) in zip(self.axes, self.to, strict=True)]
            if not all(inside):
                return found, "the range ends"
            found.append((ahead, error))
            state, way, step = ahead, along, min(self.step, 1.5 * step)
        return found, f"{self.points} points were followed"
