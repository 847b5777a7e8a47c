"""Attractors: the limit of a motion as a solution of an equation, and the same limit followed as a
parameter varies.

What a motion comes to is told by the classifier (:mod:`spragsym.motion.classify`). Here it becomes
an equilibrium or a closed orbit by Newton's method, which can be followed to other values of the
parameters and compared with another.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..core.errors import ConvergenceError
from ..models.field import Values
from ..models.parameters import FloatArray
from ..motion.classify import spectrum_at_rest
from ..motion.regimes import SAME_STATE, Regime
from ..motion.shooting import in_scales, natural
from ..numerics.vectors import apart, magnitude
from .arclength import Setting, along, started
from .finding import cycle_at
from .orbit import Cycle, cycle_of, same_cycle
from .system import KINDS, FateVerdict, FixedPoints, System, rounding_of


@dataclass(frozen=True)
class Attractor:
    """A stable equilibrium or cycle; of lift-off the kind alone, which all of it shares."""

    kind: Regime
    system: System
    state: FloatArray
    orbit: Cycle | None = None


def attractor(system: System, verdict: FateVerdict) -> Attractor:
    """The attractor of a verdict, by Newton's method; ConvergenceError where that does not find the
    one that was told.
    """
    found = verdict.outcome
    if verdict.kind == Regime.LIFT_OFF:
        return Attractor(verdict.kind, system, verdict.end)
    if verdict.kind == Regime.EQUILIBRIUM:
        return _at_rest(system, system.equilibrium(np.array(found.rest)))
    if verdict.kind != Regime.LIMIT_CYCLE:
        raise ConvergenceError(f"the motion comes to {verdict.described()}")
    orbit = cycle_at(system, np.array(found.cycle), found.period)
    if abs(orbit.period / found.period - 1) > 1e-3:
        raise ConvergenceError(
            f"Newton's method finds a cycle of period {orbit.period:.6g} beside that of "
            f"{found.period:.6g}"
        )
    return _of_cycle(system, orbit)


def followed(earlier: Attractor, system: System) -> Attractor:
    """The attractor continued to another value of one parameter; ConvergenceError where it ends or
    is lost on the way.
    """
    if earlier.kind == Regime.LIFT_OFF or earlier.system == system:
        return replace(earlier, system=system)
    if earlier.orbit is not None:
        return _of_cycle(system, followed_cycle(earlier.orbit, system.values))
    index, span = _varied(earlier.system.values, system.values)
    scales = earlier.system.scales(earlier.state)
    there = earlier.system.scaled(scales)
    rest = FixedPoints(there.field).started(there, earlier.state / scales.states, index, span)
    return _at_rest(system, natural(along(rest, system.values[index]).orbit).state)


def followed_cycle(earlier: Cycle, values: Values) -> Cycle:
    """The cycle continued to another value of one parameter; ConvergenceError where it turns back,
    or is lost, on the way.
    """
    index, span = _varied(earlier.values, values)
    own = in_scales(earlier.orbit)
    setting = Setting(own.flow, (index,), own.period, (span,))
    return cycle_of(along(started(setting, own.guess), values[index]).orbit)


def _varied(now: Values, then: Values) -> tuple[int, float]:
    """Parameter in which two sets differ alone, and by how much."""
    ((index, span),) = (
        (i, abs(b - a)) for i, (a, b) in enumerate(zip(now, then, strict=True)) if a != b
    )
    return index, span


def attractor_exponents(system: System, verdict: FateVerdict) -> tuple[str, FloatArray, FloatArray]:
    """The kind of attractor that a decided motion comes to, its Lyapunov exponents, largest first,
    and their errors.

    Real parts of eigenvalues, or ln |μ| / T: of a multiplier that is lost in its error nothing is
    known; −∞ of deviations that sticking ends. NaN for lift-off.
    """
    kind, size = KINDS[verdict.kind], system.field.deviations
    if verdict.kind == Regime.EQUILIBRIUM and system.field.clock:
        # Held in every phase: nothing decays along coordinates and phase, sticking ends the rest.
        held = np.where(np.arange(size) < len(system.field.coordinates), 0.0, -np.inf)
        return kind, held, np.zeros(size)
    limit = attractor(system, verdict)
    if limit.kind == Regime.LIFT_OFF:
        nothing = np.full(size, np.nan)
        return kind, nothing, nothing
    if limit.orbit is None:
        values, _ = spectrum_at_rest(
            system.field, system.constants, limit.state, system.mode(limit.state)
        )
        rates = np.full(size, -np.inf)
        rates[: len(values)] = values.real
        errors = np.zeros(len(rates))
    else:
        sizes = np.abs(limit.orbit.multipliers)
        off = np.array([0.0, *limit.orbit.multiplier_errors])
        with np.errstate(divide="ignore", invalid="ignore"):
            rates = np.log(sizes) / limit.orbit.period
            known_from = np.where(sizes > 0, off < sizes, off == 0)
            relative = np.divide(off, sizes, out=np.zeros_like(off), where=sizes > 0)
            errors = np.where(known_from, -np.log1p(-relative) / limit.orbit.period, np.inf)
        rates[0] = 0.0
    order = np.argsort(-rates, kind="stable")
    return kind, rates[order], errors[order]


def same(one: Attractor, other: Attractor) -> bool:
    """Whether two attractors at the same values of the parameters are one."""
    if one.kind != other.kind or one.kind == Regime.LIFT_OFF:
        return one.kind == other.kind
    if one.orbit is None or other.orbit is None:
        states = one.system.scales(one.state).states
        off = apart(one.state, other.state, one.system.field.periodic) / states
        return magnitude(off) < SAME_STATE * (1 + magnitude(one.state / states))
    return same_cycle(one.orbit, other.orbit)


def _at_rest(system: System, state: FloatArray) -> Attractor:
    matrix = system.linearization(state)
    if np.linalg.eigvals(matrix).real.max() > rounding_of(matrix):
        raise ConvergenceError("the equilibrium loses its stability on the way")
    return Attractor(Regime.EQUILIBRIUM, system, state)


def _of_cycle(system: System, orbit: Cycle) -> Attractor:
    if not orbit.stable:
        raise ConvergenceError("the cycle loses its stability on the way")
    return Attractor(Regime.LIMIT_CYCLE, system, orbit.state, orbit)
