"""Motion with its variational equations by SciPy's DOP853, restarted at every border."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.field import GAP, JUMPED, Field, Mode
from ..models.parameters import FloatArray
from .lobatto import unit_points
from .problem import Problem, event_at
from .segment import Crossing, Passage, Turn
from .solution import Crossing as Reached
from .solution import Solution, assembled
from .with_scipy import ARRAYS, FLOATS, clearances, first_crossing

#: As tight as DOP853 goes.
RTOL, ATOL = 2.3e-14, 1e-15

#: Tolerance of Radau, whose order is five.
IMPLICIT = 1e-12

MAX_STEPS = 200_000

#: Each step is searched for zeros on this many intervals.
_SEARCH = np.linspace(0.0, 1.0, 13)


@dataclass(frozen=True)
class Flight:
    """A field, carried on with or without derivatives; those by parameters are 0 where there are no directions.

    By DOP853, or where it is ``stiff`` by Radau.
    """

    field: Field
    derivatives: bool = True
    directions: int = 2
    rtol: float = RTOL
    stiff: bool = False

    def fly(self, state: FloatArray, constants: tuple[float, ...], duration: float, directions: FloatArray) -> Passage:
        """Carry a state on for a while."""
        if self.directions and not directions.any():
            return replace(self, directions=0).fly(state, constants, duration, directions)
        m = self.field.size
        crossings: list[Crossing] = []
        turns: list[Turn] = []
        whole = np.asarray(state, dtype=float)
        if self.derivatives:
            whole = np.concatenate([whole, np.eye(m, m + self.directions).ravel()])
        for piece in self._pieces(whole, constants, duration, directions):
            turns += self._turns(piece, constants)
            if piece.border is not None and self.field.borders[piece.border].kink:
                sign = int(self.field.borders[piece.border].sign(piece.after))
                crossings.append(Crossing(piece.end, piece.border, sign, piece.state[:m].copy()))
            whole = piece.state
        return Passage(*self._split(whole), tuple(crossings), tuple(turns))

    def sample(self, state: FloatArray, constants: tuple[float, ...], duration: float) -> tuple[FloatArray, FloatArray]:
        """Times (n,) and states (m, n) at the Lobatto points of the steps of a stretch, ends shared."""
        unit, none = unit_points(), np.zeros((2, len(self.field.parameters)))
        times, states = [np.zeros(1)], [np.asarray(state, dtype=float)[:, None]]
        flight = Flight(self.field, derivatives=False)
        for piece in flight._pieces(np.asarray(state, dtype=float), constants, duration, none):
            local = piece.begin + unit[1:] * (piece.end - piece.begin)
            values = piece.dense(local)
            values[:, -1] = piece.state
            times.append(local)
            states.append(values)
        return np.concatenate(times), np.concatenate(states, axis=1)

    def _split(self, values: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        m = self.field.size
        if not self.derivatives:
            return values[:m].copy(), np.empty((0, 0)), np.empty((0, 0))
        columns = np.zeros((m, m + 2))
        columns[:, : m + self.directions] = values[m:].reshape(m, m + self.directions)
        return values[:m].copy(), columns[:, :m], columns[:, m:]

    def _pieces(self, whole: FloatArray, constants: tuple[float, ...], duration: float, directions: FloatArray) -> Any:
        """Steps, none of which leaves its mode; a step that would is cut at the border."""
        m, clock, first = self.field.size, 0.0, None
        mode = self.field.initial_mode(whole[:m], constants)
        options: dict[str, Any] = {"rtol": self.rtol, "atol": ATOL * (self.rtol / RTOL)}
        steps = 0
        while clock < duration:
            rates = self._rates(constants, mode, directions)
            bound = duration - clock
            if self.stiff:
                options["jac"] = self._matrix(constants, mode)
            method = _method(self.stiff)
            solver = method(rates, 0.0, whole, bound, first_step=None if first is None else min(first, bound), **options)
            found = None
            while solver.status == "running" and found is None:
                before = solver.y.copy()
                message = solver.step()
                steps += 1
                if solver.status == "failed" or steps > MAX_STEPS:
                    raise ConvergenceError(
                        f"SciPy's {method.__name__} stopped at t = {clock + solver.t:.6g}: {message or 'too many steps'}"
                    )
                dense, begin, end = solver.dense_output(), solver.t_old, solver.t
                found = first_crossing(self.field, constants, mode, partial(_part, dense, m), begin, end)
                if found is None:
                    yield _Piece(clock + begin, clock + end, solver.y.copy(), _shifted(dense, clock), mode, None, mode)
            whole = solver.y.copy()
            if found is None:
                clock += solver.t
                continue
            # The state at the border by a step of its own: the interpolant is of lower order than the method.
            at, border = found
            jumps = self.field.borders[border].jumps
            first, whole = solver.step_size, _stepped(method, rates, begin, before, at, options)
            for _ in range(4 * self.stiff):  # Radau's interpolant is of low order: Newton's method on steps of its own
                clear, rate = clearances(self.field, constants, mode, whole[:m])[border].tolist()
                if abs(clear) > GAP / 10 and rate:
                    at = max(at - clear / rate, begin)
                    whole = _stepped(method, rates, begin, before, at, options)
            if self.derivatives and jumps is not None and jumps(whole[:m].tolist(), constants):
                raise ConvergenceError(JUMPED)
            after = self.field.borders[border].beyond(mode)
            yield _Piece(clock + begin, clock + at, whole, _shifted(dense, clock), mode, border, after)
            clock, mode = clock + at, after

    def _rates(
        self, constants: tuple[float, ...], mode: Mode, directions: FloatArray
    ) -> Callable[[float, FloatArray], FloatArray]:
        field, m, n = self.field, self.field.size, len(self.field.coordinates)

        def rates(_: float, whole: FloatArray) -> FloatArray:
            state = whole[:m].tolist()
            own = np.array([*state[n:], *field.acceleration(state, constants, mode, FLOATS)])
            if not self.derivatives:
                return own
            columns = whole[m:].reshape(m, m + self.directions)
            lower = np.array(field.jacobian(state, constants, mode, FLOATS), dtype=float) @ columns
            if self.directions:
                lower[:, m:] += np.array(field.by_parameters(state, constants, mode, FLOATS), dtype=float) @ directions.T
            return np.concatenate([own, columns[n:].ravel(), lower.ravel()])

        return rates

    def _matrix(self, constants: tuple[float, ...], mode: Mode) -> Callable[[float, FloatArray], FloatArray]:
        """The Jacobian of the field; of all columns that are carried in blocks, without its own derivatives."""
        field, m, n = self.field, self.field.size, len(self.field.coordinates)
        columns = m + self.directions

        def matrix(_: float, whole: FloatArray) -> FloatArray:
            lower = np.array(field.jacobian(whole[:m].tolist(), constants, mode, FLOATS), dtype=float)
            own = np.vstack([np.eye(n, m, n), lower])
            if not self.derivatives:
                return own
            full = np.zeros((len(whole), len(whole)))
            full[:m, :m], full[m:, m:] = own, np.kron(own, np.eye(columns))
            return full

        return matrix

    def _turns(self, piece: _Piece, constants: tuple[float, ...]) -> list[Turn]:
        """Zeros of the rates within a step."""
        grid = piece.begin + _SEARCH * (piece.end - piece.begin)
        borders, values = self._watched(piece.dense(grid), constants, piece.mode)
        found = []

        def at(row: int, t: float) -> float:
            return float(self._watched(piece.dense(t), constants, piece.mode)[1][row])

        changes = (values[:, :-1] < 0) != (values[:, 1:] < 0)
        for row, i in np.argwhere(changes).tolist():
            t = _zero(partial(at, row), float(grid[i]), float(grid[i + 1]))
            found.append(Turn(t, borders[row], 1 if values[row, i] < 0 else -1, *self._split(piece.dense(t))))
        return sorted(found, key=lambda turn: turn.t)

    def _watched(self, whole: FloatArray, constants: tuple[float, ...], mode: Mode) -> tuple[list[int], FloatArray]:
        """Numbers of borders, −1 for the first coordinate, and the rates whose zeros are turns: shape (rows, …)."""
        states, n = whole[: self.field.size], len(self.field.coordinates)
        kinks = [i for i, border in enumerate(self.field.borders) if border.kink]
        values = np.empty((1 + len(kinks), *states.shape[1:]))
        values[0] = states[n]
        if kinks:
            numbers, xp = (states, ARRAYS) if states.ndim > 1 else (states.tolist(), FLOATS)
            accelerations = self.field.acceleration(numbers, constants, mode, xp)
            for row, i in enumerate(kinks, 1):
                values[row] = self.field.borders[i].rate(numbers, accelerations, constants, mode)
        return [-1, *kinks], values


@dataclass(frozen=True)
class _Piece:
    """One step within a mode."""

    begin: float
    end: float
    state: FloatArray
    dense: Callable[[Any], FloatArray]
    mode: Mode
    border: int | None
    after: Mode


def _part(dense: Callable[[Any], FloatArray], size: int, t: Any) -> FloatArray:
    return dense(t)[:size]


def _shifted(dense: Callable[[Any], FloatArray], clock: float) -> Callable[[Any], FloatArray]:
    return lambda t: dense(t - clock)


def _zero(function: Callable[[float], float], begin: float, end: float) -> float:
    from scipy.optimize import brentq

    if function(begin) * function(end) > 0:
        return begin  # beyond the border by rounding: it is left at once
    return float(brentq(function, begin, end, xtol=1e-15, rtol=8.9e-16))


def _method(stiff: bool) -> Any:
    from scipy.integrate import DOP853, Radau

    return Radau if stiff else DOP853


def _stepped(method: Any, rates: Any, begin: float, state: FloatArray, end: float, options: dict[str, Any]) -> FloatArray:
    """A state carried on to the end of a part of a step."""
    if end <= begin:
        return state
    solver = method(rates, begin, state, end, first_step=end - begin, **options)
    while solver.status == "running":
        solver.step()
    reached: FloatArray = solver.y
    return reached


def implicit_motion(problem: Problem) -> Solution:
    """The motion by Radau, from 0 to ``t_end``; kept is what follows ``t_record``."""
    field, unit, none = problem.field, unit_points(), np.zeros((2, len(problem.field.parameters)))
    flight = Flight(field, derivatives=False, rtol=max(problem.rtol / 100, IMPLICIT), stiff=True)
    times, states, crossings = [], [], []
    for piece in flight._pieces(np.array(problem.start), problem.constants, problem.t_end, none):
        begin = max(piece.begin, problem.t_record)
        if piece.end <= begin:
            continue
        times.append(begin + unit * (piece.end - begin))
        times[-1][-1] = piece.end
        states.append(piece.dense(times[-1]))
        states[-1][:, -1] = piece.state
        if piece.border is not None:
            border = field.borders[piece.border]
            kind = event_at(border, upward=border.sign(piece.mode) < 0)
            if kind is not None:
                crossings.append(Reached(piece.end, tuple(piece.state.tolist()), kind))
    return replace(assembled(np.array(times), np.array(states), crossings, problem.t_record), implicit=True)


@cache
def flight(field: Field, derivatives: bool = True) -> Flight:
    """For symmetry with heyoka's, which are compiled."""
    return Flight(field, derivatives)
