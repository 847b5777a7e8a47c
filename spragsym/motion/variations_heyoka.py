"""Motion with its variational equations by heyoka's Taylor method, borders as terminal events."""

from __future__ import annotations

import threading
from functools import partial
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.field import JUMPED, Field, Mode
from ..models.heyoka_library import XP, Functions, library
from ..models.parameters import FloatArray
from .lobatto import unit_points
from .problem import StiffError, check_stiffness, out_of_range
from .segment import Crossing, Passage, Turn
from .variations_scipy import IMPLICIT, Flight
from .with_heyoka import Approach, put, watched

#: Tolerances with derivatives and of the plain flow, whose other steps make it a witness of the first; heyoka's error is
#: relative to the largest of all that it carries.
TOLERANCE, PLAIN = 1e-17, 1e-16

#: Derivatives are carried in this unit, so that they stay below the state.
UNIT = 1e-4

#: Steps after which a stretch is given up, and between two looks at signals.
MAX_STEPS, CHUNK = 2_000_000, 20_000


class Compiled:
    """One compiled integrator of a field, used again and again: constants, mode and directions are its ``par[]``."""

    def __init__(self, field: Field, derivatives: bool, directions: int) -> None:
        hy = library()

        self.field, self.m, self.derivatives, self.directions = field, field.size, derivatives, directions
        n, m = len(field.coordinates), field.size
        state = hy.make_vars(*(f"q{i}" for i in range(m)))
        self.constants = len(field.constants([1.0] * len(field.parameters)))
        width, parameters = len(field.modes[0]), len(field.parameters)
        constants = [hy.par[i] for i in range(self.constants)]
        mode = [hy.par[self.constants + i] for i in range(width)]
        accelerations = list(field.acceleration(state, constants, mode, xp := Functions()))
        system = list(zip(state, [*state[n:], *accelerations], strict=True))
        approaches = Approach.of(xp.called, system)
        if derivatives:
            jacobian = field.jacobian(state, constants, mode, XP)
            slopes = field.by_parameters(state, constants, mode, XP)
            for column in range(m + directions):
                part = hy.make_vars(*(f"d{i}_{column}" for i in range(m)))
                rates = [_dot(row, part) for row in jacobian]
                if column >= m:
                    begin = self.constants + width + (column - m) * parameters
                    weights = [hy.par[begin + i] for i in range(parameters)]
                    rates = [rate + UNIT * _dot(row, weights) for rate, row in zip(rates, slopes, strict=True)]
                system += zip(part, [*part[n:], *rates], strict=True)
            sums = hy.make_vars("sum", "squares")
            system += zip(sums, [UNIT * state[0], UNIT * state[0] * state[0]], strict=True)
        borders = [b.sign(mode) * watched(b, state, constants, mode) for b in field.borders]
        rates = [(-1, state[n])] + [
            (i, b.rate(state, accelerations, constants, mode)) for i, b in enumerate(field.borders) if b.kink
        ]
        self.crossings: list[Crossing] = []
        self.turns: list[Turn] = []
        self.mode: Mode = field.modes[0]
        self.known: tuple[float, ...] = ()
        self.jumped = False
        self.solver = hy.taylor_adaptive(
            system, [0.0] * len(system),
            tol=TOLERANCE if derivatives else PLAIN, compact_mode=True,
            t_events=[
                hy.t_event(value, callback=partial(self._cross, i), cooldown=0.0, direction=hy.event_direction.negative)
                for i, value in enumerate(borders)
            ] + [
                hy.t_event(each.watched, callback=partial(self._pass, each), direction=hy.event_direction.positive)
                for each in approaches
            ],
            nt_events=[hy.nt_event(1e-3 * value, partial(self._turn, i)) for i, value in rates],
        )  # fmt: skip

    def __deepcopy__(self, _: object) -> Compiled:
        """heyoka copies its callbacks; they must go on to write here."""
        return self

    def _cross(self, index: int, solver: Any, _: int) -> bool:
        border = self.field.borders[index]
        if self.derivatives and border.jumps is not None and border.jumps(solver.state[: self.m].tolist(), self.known):
            self.jumped = True
            return False
        self.mode = after = border.beyond(self.mode)
        put(self.solver.pars, self.constants, after)
        if border.kink:
            self.crossings.append(Crossing(solver.time, index, int(border.sign(after)), solver.state[: self.m].copy()))
        return True

    def _pass(self, each: Approach, solver: Any, _: int) -> bool:
        self.jumped = each.passed(solver.state[: self.m], solver.pars) and self.derivatives
        return not self.jumped

    def _turn(self, border: int, solver: Any, t: float, direction: int) -> None:
        solver.update_d_output(t)
        self.turns.append(Turn(t, border, direction, *self._split(solver.d_output)))

    def _split(self, values: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        m = self.m
        if not self.derivatives:
            return values[:m].copy(), np.empty((0, 0)), np.empty((0, 0))
        columns = np.zeros((m, m + 2))
        columns[:, : m + self.directions] = values[m : m * (1 + m + self.directions)].reshape(m + self.directions, m).T / UNIT
        return values[:m].copy(), columns[:, :m], columns[:, m:]

    def _begin(self, state: FloatArray, constants: tuple[float, ...], directions: FloatArray) -> None:
        solver, m = self.solver, self.m
        self.crossings, self.turns = [], []
        self.known, self.jumped = constants, False
        solver.time = 0.0
        solver.state[:] = 0.0
        solver.state[:m] = state
        if self.derivatives:
            solver.state[m : m + m * m : m + 1] = UNIT
        self.mode = self.field.initial_mode(state, constants)
        put(self.solver.pars, 0, (*constants, *self.mode, *np.ravel(directions)))
        solver.reset_cooldowns()

    def fly(self, state: FloatArray, constants: tuple[float, ...], duration: float, directions: FloatArray) -> Passage:
        """Carry a state on for a while; by an implicit method where steps collapse."""
        try:
            return self._fly(state, constants, duration, directions)
        except StiffError:
            implicit = Flight(self.field, self.derivatives, self.directions, IMPLICIT, stiff=True)
            return implicit.fly(state, constants, duration, directions)

    def _fly(self, state: FloatArray, constants: tuple[float, ...], duration: float, directions: FloatArray) -> Passage:
        hy = library()
        self._begin(state, constants, directions)
        solver = self.solver
        steps, outcome = 0, hy.taylor_outcome.step_limit
        while outcome == hy.taylor_outcome.step_limit:
            if steps >= MAX_STEPS:
                raise ConvergenceError(f"{MAX_STEPS} steps were made by t = {solver.time:.6g} of {duration:.6g}: too stiff")
            begun = solver.time
            outcome, _, _, made, *_ = solver.propagate_until(duration, max_steps=CHUNK)
            steps += made
            if outcome == hy.taylor_outcome.step_limit:
                step, left = (solver.time - begun) / CHUNK, duration - solver.time
                check_stiffness(self.field, solver.state[: self.m], constants, step, left)
        if self.jumped:
            raise ConvergenceError(JUMPED)
        end, by_state, by_parameters = self._split(solver.state)
        if outcome == hy.taylor_outcome.err_nf_state or not np.isfinite(end).all():
            raise out_of_range()
        if outcome != hy.taylor_outcome.time_limit:
            raise ConvergenceError(f"heyoka stopped at t = {solver.time:.6g} with {outcome}")
        if not self.field.is_inside(end, constants, self.mode):
            raise ConvergenceError(f"heyoka missed a kink before t = {duration:.6g}; use backend='scipy'")
        integrals = (float(solver.state[-2]) / UNIT, float(solver.state[-1]) / UNIT) if self.derivatives else None
        return Passage(end, by_state, by_parameters, tuple(self.crossings), tuple(self.turns), integrals)

    def sample(self, state: FloatArray, constants: tuple[float, ...], duration: float) -> tuple[FloatArray, FloatArray]:
        """Times (n,) and states (m, n) at the Lobatto points of the steps of a stretch, ends shared."""
        self._begin(state, constants, np.zeros((2, len(self.field.parameters))))
        solver, unit = self.solver, unit_points()
        powers = unit ** np.arange(solver.order + 1)[:, None]
        times, states = [np.zeros(1)], [np.asarray(state, dtype=float)[:, None]]
        for _ in range(MAX_STEPS):
            begin = solver.time
            if begin >= duration:
                return np.concatenate(times), np.concatenate(states, axis=1)
            _, made = solver.step(duration - begin, write_tc=True)
            if not made > 0 or not np.isfinite(solver.state[: self.m]).all():
                break
            if self.jumped:
                raise ConvergenceError(JUMPED)
            scaled = solver.tc[: self.m] * made ** np.arange(solver.order + 1)
            times.append(begin + made * unit[1:])
            states.append((scaled @ powers)[:, 1:])
        raise ConvergenceError(f"heyoka stopped at t = {solver.time:.6g}")


def _dot(one: Any, other: Any) -> Any:
    products = [a * b for a, b in zip(one, other, strict=True) if not (isinstance(a, int) and a == 0)]
    return sum(products[1:], products[0]) if products else 0.0 * other[0]


_CACHE = threading.local()


def compiled(field: Field, derivatives: bool = True, directions: int = 2) -> Compiled:
    """Compiled once per field and thread; without ``directions``, derivatives by parameters are 0."""
    known: dict[tuple[str, bool, int], Compiled] = _CACHE.__dict__.setdefault("compiled", {})
    key = field.name, derivatives, directions
    if key not in known:
        known[key] = Compiled(field, derivatives, directions)
    return known[key]
