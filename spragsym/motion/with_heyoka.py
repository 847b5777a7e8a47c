"""heyoka's Taylor method, with the borders between the modes of the field as terminal events."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from ..errors import ConvergenceError
from ..models.field import GAP, Border, Field, Mode
from ..models.heyoka_library import Functions, library
from ..models.parameters import FloatArray
from .lobatto import unit_points
from .problem import Problem, check_stiffness, event_at, initial_mode, out_of_range, too_many_steps
from .solution import Crossing, Solution, assembled

#: Steps between two looks at signals: Python hears Ctrl-C only when compiled code returns. At most a second or so.
CHUNK = 20_000

#: A step ends where a spring passes its anchor within its speed over this. Closer than the root of the tolerance a Taylor series
#: does not see the least length, and goes on with negative ones.
CLOSE = 10.0

#: Minus the exponent from which on an exponential of the place is felt: there it is below rounding.
FELT = 37.0

#: Largest tolerance of fields with a border that is curved.
CURVED = 1e-3 * GAP

#: Times and states by steps, shapes (steps, DEGREE + 1) and (steps, 4, DEGREE + 1).
Samples: TypeAlias = tuple[FloatArray, FloatArray]


@dataclass(frozen=True)
class Approach:
    """Where a step ends because of what its Taylor series does not see.

    That is where the argument of a root is least and small, as the squared length of a spring that passes its anchor, and where
    an exponential or a hyperbolic tangent of the place is about to be felt; those of the sliding speed are borders of the field.

    Attributes
    ----------
    watched : expression
        Passes zero upward there.
    value : heyoka.cfunc or None
        The argument of a root.
    """

    watched: Any
    value: Any

    @classmethod
    def of(cls, called: list[tuple[str, Any]], system: list[Any]) -> list[Approach]:
        """Those of all functions that were ``called``."""
        import heyoka as hy

        names, found = [name for name, _ in system], list[Approach]()
        rates = {str(name) for name in names[len(names) // 2 :]}
        for name, z in called:
            seen = set(hy.get_variables(z))
            if name == "sqrt" and seen:
                rate = sum((hy.diff(z, name) * each for name, each in system), hy.expression(0.0))
                found.append(cls(1e-3 * (rate - CLOSE * z), hy.cfunc([z], names)))
            elif name in ("exp", "tanh") and seen and not seen & rates:
                outside = z + FELT if name == "exp" else (FELT**2 - 4.0 * z * z) / FELT
                found.append(cls(1e-3 * FELT * outside / (FELT**2 + z * z), None))
        return found

    def passed(self, state: Any, pars: Any) -> bool:
        """Whether the argument of a root is zero to GAP; the ``state`` is moved on by as much: there is no direction."""
        n = len(state) // 2
        if self.value is None or not abs(self.value(state, pars=pars[: self.value.nparams])[0]) < GAP**2:
            return False
        state[:n] += GAP / np.abs(state[n:]).max() * state[n:]
        return True


@dataclass(frozen=True)
class Equations:
    """A field for heyoka: constants and mode are its ``par[]``.

    Attributes
    ----------
    system : list
        Variables with their derivatives in time: the state, and with ``watch`` the integrals of a
        :class:`~spragsym.motion.measures.Course`, scaled by the last parameter so that they stay below the states: heyoka's
        error is relative to the largest of all. The parameter before is x(begin).
    seen : tuple
        State, constants and mode.
    approaches : list of Approach
        For each root in the field.
    """

    system: list[Any]
    seen: tuple[Any, Any, Any]
    approaches: list[Approach]

    @classmethod
    def of(cls, field: Field, constants: int, *, watch: bool) -> Equations:
        """Those of a field with this many constants."""
        hy = library()
        names, n = field.coordinates, len(field.coordinates)
        end = constants + len(field.modes[0])
        state = hy.make_vars(*names, *(f"v{name}" for name in names))
        known, mode = ([hy.par[i] for i in range(*ends)] for ends in ((constants,), (constants, end)))
        accelerations = field.acceleration(state, known, mode, xp := Functions())
        system = list(zip(state, [*state[n:], *accelerations], strict=True))
        if watch:
            shift, scale = state[0] - hy.par[end], hy.par[end + 1]
            # No coordinate has a dot in its name.
            sums = hy.make_vars("sum.shift", "sum.square", *(f"sum.{name}" for name in names[1:]))
            sums = sums if isinstance(sums, list | tuple) else [sums]
            system += zip(sums, (scale * shift, scale * shift * shift, *(scale * other for other in state[1:n])), strict=True)
        return cls(system, (state, known, mode), Approach.of(xp.called, system[: field.size]))


class Compiled:
    """A compiled Taylor integrator, used again and again."""

    def __init__(self, field: Field, constants: int, rtol: float) -> None:
        hy = library()

        equations = Equations.of(field, constants, watch=False)
        self.field, self.modes = field, constants
        self.log: list[Crossing] = []
        self.kinds = {(row, up): event_at(border, upward=up) for row, border in enumerate(field.borders) for up in (False, True)}
        self.mode: Mode = field.modes[0]
        self.stray: float | None = None
        # The gap keeps one crossing from being found twice, which is what a cooldown is for.
        self.solver = hy.taylor_adaptive(
            equations.system, [0.0] * field.size, tol=tolerance(field, rtol),
            t_events=[
                hy.t_event(
                    watched(border, *equations.seen), callback=partial(self._cross, row), cooldown=0.0, direction=ways_out(border)
                )
                for row, border in enumerate(field.borders)
            ] + [
                hy.t_event(each.watched, callback=partial(self._pass, each), direction=hy.event_direction.positive)
                for each in equations.approaches
            ],
        )  # fmt: skip
        # Views of what the integrator holds: each look at an attribute makes one anew.
        self.state, self.pars = self.solver.state, self.solver.pars
        # heyoka has no cooldowns where there are no events.
        self.reset = self.solver.reset_cooldowns if self.solver.with_events else lambda: None

    def __deepcopy__(self, _: object) -> Compiled:
        """heyoka deep-copies its callbacks; the copies must still write to this object."""
        return self

    def _cross(self, row: int, solver: Any, direction: int) -> bool:
        """Go over to the next mode; stop if it is not next, for then a crossing was missed."""
        border, mode = self.field.borders[row], self.mode
        if border.sign(mode) != -direction:
            self.stray = solver.time
            return False
        self.mode = border.beyond(mode)
        put(self.pars, self.modes, self.mode)
        kind = self.kinds[row, direction > 0]
        if kind is not None:
            self.log.append(Crossing(solver.time, tuple(self.state.tolist()), kind))
        return True

    def _pass(self, each: Approach, *_: Any) -> bool:
        each.passed(self.state, self.pars)
        return True

    def begin(self, problem: Problem) -> None:
        """Stand at the start of a motion, with no events recorded."""
        self.log, self.stray, self.mode = [], None, initial_mode(problem)
        self.solver.time = 0.0
        self.state[:] = problem.start
        put(self.pars, 0, (*problem.constants, *self.mode))
        self.reset()

    def go(self, problem: Problem, t: float, steps: int = 0, *, record: bool = False) -> tuple[int, list[Samples]]:
        """Go on to ``t`` from step number ``steps``; the number reached, and the samples of every chunk if asked for."""
        hy = library()
        solver = self.solver
        pieces: list[Samples] = []
        outcome = hy.taylor_outcome.step_limit
        while outcome == hy.taylor_outcome.step_limit:
            if steps >= problem.max_steps:
                raise too_many_steps(problem, solver.time)
            begun = solver.time
            result = solver.propagate_until(t, c_output=record, max_steps=min(CHUNK, problem.max_steps - steps))
            outcome, steps = result[0], steps + result[3]
            if outcome == hy.taylor_outcome.step_limit and result[3] == CHUNK:
                step = (solver.time - begun) / CHUNK
                check_stiffness(
                    problem.field, self.state[: problem.field.size], problem.constants, step, problem.t_end - solver.time
                )
            if result[4] is not None:
                pieces.append(_sampled(result[4]))
            if self.stray is not None:
                raise ConvergenceError(f"heyoka missed a kink before t = {solver.time:.6g}; use backend='scipy'")
        if outcome != hy.taylor_outcome.time_limit:
            if outcome == hy.taylor_outcome.err_nf_state:
                raise out_of_range()
            raise ConvergenceError(f"heyoka stopped at t = {solver.time:.6g} with {outcome}; use backend='scipy'")
        if not problem.field.is_inside(self.state.tolist(), problem.constants, self.mode):
            raise ConvergenceError(f"heyoka missed a kink before t = {solver.time:.6g}; use backend='scipy'")
        return steps, pieces


def ways_out(border: Border) -> Any:
    """In which directions an event of a border is looked for.

    Where the field jumps, the levels of both modes are 0, and are curved in the state: after a crossing the new one may be
    negative by the error of a step, and its way up is no event.
    """
    hy = library()
    return hy.event_direction.any if border.jumps is None else hy.event_direction.negative


def tolerance(field: Field, rtol: float) -> float:
    """What heyoka is given for its error.

    A level that is no linear function of the state has a Taylor series of its own, which agrees with that of the state to this
    tolerance only: where it is not far below the gap behind a border, the border just crossed would be met again.
    """
    return min(rtol, CURVED) if field.curved else rtol


def put(pars: Any, begin: int, values: Sequence[float]) -> None:
    """Write values into ``par[begin]`` and what follows; heyoka has none beyond the last that a field takes."""
    end = min(begin + len(values), len(pars))
    if end > begin:
        pars[begin:end] = values[: end - begin]


def watched(border: Border, state: Any, constants: Any, mode: Any) -> Any:
    """What is zero where a mode is left, small beside the state: heyoka's error is relative to the largest of all."""
    if border.watched is not None:
        return border.watched(state, constants, mode)
    return 1e-3 * (border.level(state, constants, mode) + (GAP * border.sign(mode) if border.kink else 0.0))


def _sampled(output: Any) -> Samples:
    """Times and values of a heyoka continuous output at the Lobatto points of its steps."""
    coefficients, begin, step = output.tcs, output.times[:-1, None], np.diff(output.times)[:, None]
    unit = unit_points()
    order = np.arange(coefficients.shape[2])
    states = (coefficients * step[:, :, None] ** order) @ unit ** order[:, None]
    t = begin + step * unit
    t[:, -1] = output.times[1:]
    return t, states


_CACHE = threading.local()


def compiled_for(problem: Problem) -> Compiled:
    """Compiled once per model, tolerance and thread."""
    known: dict[tuple[str, float], Compiled] = _CACHE.__dict__.setdefault("compiled", {})
    key = problem.field.name, problem.rtol
    if key not in known:
        known[key] = Compiled(problem.field, len(problem.constants), problem.rtol)
    return known[key]


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end`` and keep what follows ``t_record``."""
    compiled = compiled_for(problem)
    compiled.begin(problem)
    steps = compiled.go(problem, problem.t_record)[0] if problem.t_record > 0 else 0
    _, pieces = compiled.go(problem, problem.t_end, steps, record=True)
    times, states = (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    return assembled(times, states, compiled.log, problem.t_record)
