"""A cycle from a state near it, from a motion that approaches it, or from the Hopf point at which
it is born; and attractors, the limit of a motion as a solution of an equation.

What a motion comes to is told by the classifier (:mod:`spragsym.motion.classify`). Here it becomes
an equilibrium or a closed orbit by Newton's method, which can be followed to other values of the
parameters and compared with another.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from ..bifurcation.flutter import Onsets
from ..bifurcation.normal_forms import NormalForm, normal_form
from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, ParameterTypeError, require_kind
from ..models.field import Values
from ..models.model import Model
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, as_count, as_number, as_numbers
from ..motion import Trajectory
from ..motion.classify import spectrum_at_rest
from ..motion.integrators import Flow
from ..motion.options import MotionOptions, ShootingOptions
from ..motion.regimes import SAME_STATE, Regime
from ..motion.scales import scales_of
from ..motion.shooting import (
    Iterate,
    Orbit,
    across,
    closed_orbit,
    error_of,
    extent,
    in_scales,
    natural,
    rate,
    subdivided,
)
from ..motion.solution import Extremum
from ..numerics.balls import UndecidedSign
from ..numerics.vectors import WholeTurns, apart, in_one_turn, magnitude, norm
from .arclength import Setting, along, differences, started
from .orbit import Cycle, cycle_of, same_cycle
from .system import FateVerdict, FixedPoints, System, judged, rounding_of


@in_usual_state
def cycle(
    p: ParameterSet | None = None,
    near: ArrayLike | Trajectory | Cycle | None = None,
    *,
    backend: str | None = None,
    patient: bool = True,
    onset: Onsets | None = None,
    index: int = 0,
    amplitude: float | None = None,
    turns: int | None = None,
    options: ShootingOptions | None = None,
    **values: float | None,
) -> Cycle:
    """The cycle near a state, or the one that a motion approaches, or the one that is born at an
    onset of flutter.

    Newton's method on the flow and its derivatives, by multiple shooting; the orbit may lose
    contact and overtake the belt as often as it likes, and stick where friction holds it
    (``page.friction``): there the derivatives go on from border to border.

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    near : array_like, Trajectory or Cycle, optional
        A state near the cycle, stable or not, coordinates, then rates, of the article's model x, y,
        x', y'; or a motion whose end approaches it; or a cycle for other values of the parameters.
        0 where left out.
    backend : {"heyoka", "scipy"}, optional
        As for :func:`~spragsym.simulate`.
    patient : bool
        Whether to follow the motion from a state that is not near a cycle, for up to 40 000 time
        units.
    onset : Onsets, optional
        Of :func:`~spragsym.flutter_onsets`. They know their model and its parameters: ``p``,
        ``near`` and ``values`` are left out.
    index : int
        The number of the onset among them.
    amplitude : float, optional
        Of the cycle that is born there: half of the range of the coordinate that moves most, to a
        thousandth; see :func:`spragsym.orbits.finding.born_at`. The parameter along which the
        onsets were found takes the value that belongs to it.
    turns : int, optional
        Of a page with a clock: the cycle that closes after so many turns of it, stable or not, by
        Newton's method from ``near``; without that from the end of a motion of a hundred turns.
    options : ShootingOptions, optional
        Tolerances and limits of Newton's method, and of what is followed from the cycle.
    **values : float, optional
        Parameters in place of those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    Cycle

    Raises
    ------
    ConvergenceError
        Where there is no cycle near: it says what the motion comes to instead.

    Notes
    -----
    Source: (8)–(11). What is found is a cycle to the error that is told; that there are no others
    is not.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.cycle(ss.Parameters.article(theta0=np.radians(42)), V=0.5, d=10.0)
    >>> round(found.period, 6), found.stable
    (34.26737, True)
    >>> model = ss.load("stick_slip")
    >>> onsets = ss.flutter_onsets(model.Parameters(), vary="V")
    >>> born = ss.cycle(onset=onsets, index=1, amplitude=0.05)
    >>> str(onsets.criticality[1]), born.stable, bool(born.parameters["V"] > onsets.V[1])
    ('subcritical', False, True)
    """
    if onset is not None:
        if p is not None or near is not None:
            raise ParameterTypeError(
                "an onset knows its parameters and its state; leave out p and near, or the onset"
            )
        require_kind("onset", onset, Onsets, "a result of ss.flutter_onsets(...)")
        return born_at(onset, index, amplitude, backend, options)
    if p is None:
        raise ParameterTypeError("p is missing; give parameters, or the onset of a model")
    motions = None if options is None else MotionOptions(shooting=options)
    system = System.of(p, backend, motions, **values)
    if turns is not None:
        return _after_turns(system, near, as_count("turns", turns))
    return cycle_near(system, near, patient=patient)


def _after_turns(system: System, near: ArrayLike | Trajectory | Cycle | None, turns: int) -> Cycle:
    """The cycle of so many turns of the clock."""
    field = system.field
    if field.clock is None:
        raise ParameterError(
            f"turns = {turns}: the page has no clock to turn; leave it out, or say "
            "page.clock(omega)"
        )
    turn = 2 * math.pi / field.clock(system.constants)
    if isinstance(near, Cycle | Trajectory):
        start = near.state if isinstance(near, Cycle) else near.state[:, -1]
    else:
        start = _state(system, near)
    if near is None:
        # Turns of a clock after which a motion is near a cycle.
        start = system.motion(start, 100 * turn).state[:, -1]
    try:
        found = cycle_at(system, start, turns * turn)
    except ConvergenceError as error:
        raise ConvergenceError(
            f"no cycle that closes after turns = {turns} of the clock: {error}, or give other "
            f"turns: after a doubling the motion repeats after {2 * turns}"
        ) from error
    own = round(found.period / turn)
    if own != turns:
        raise ConvergenceError(
            f"the cycle near the state closes after {own} turns of the clock, and not {turns}; "
            f"give another state, or turns={own}"
        )
    return found


def cycle_near(
    system: System, near: ArrayLike | Trajectory | Cycle | None = None, *, patient: bool = True
) -> Cycle:
    """:func:`cycle` of any system."""
    field, flow = system.field, system.flow
    if isinstance(near, Cycle):
        near.require(field, "near")
        return _checked(_towards(flow, near.orbit.guess, system.values))
    approached = near is None or isinstance(near, Trajectory)
    looks = None if patient or approached else 1
    start = near.state[:, -1] if isinstance(near, Trajectory) else _state(system, near)
    if not np.isfinite(rate(field, start, system.constants)).all():
        raise ParameterError(
            f"near = {start.tolist()}: the motion is not defined there; give another state"
        )
    scales = system.scales(start)
    own = system.scaled(scales)
    try:
        # Returns of a motion are looked at over this time, and over a longer one where
        # it hardly has turned by then.
        for time in () if approached else (400.0, 3000.0, 20000.0)[:looks]:
            flow_result = own.flow.plain(start / scales.states, own.constants, time, loose=True)
            if (found := _by_returns(own, flow_result.extrema)) is not None:
                return _checked(found)
            if len(flow_result.extrema) > 2:
                break
        times = [t * scales.time for t in system.options.times[:looks]]
        verdict = judged(system, start, times=times)
    except ConvergenceError as error:
        raise ConvergenceError(f"the motion can't be followed: {error}{_steep(system)}") from error
    if verdict.kind == Regime.LIMIT_CYCLE:
        with suppress(ConvergenceError):
            return cycle_at(system, np.array(verdict.outcome.cycle), verdict.outcome.period)
    why = stands_still(system, verdict.end) or (
        f"it comes to {verdict.described()}; give as near a state nearer to a cycle, or the end of "
        "a longer motion"
    )
    raise ConvergenceError(f"no cycle was found near the motion: {why}")


def cycle_at(system: System, state: FloatArray, period: float) -> Cycle:
    """The cycle of about a period near a state: Newton's method and nothing else."""
    return _checked(_from_guess(system.flow, Iterate(state[None], period, system.values)))


def _steep(system: System) -> str:
    """Feature that may be too much for an integrator."""
    value, name = max(
        (abs(value), name)
        for name, value in zip(system.field.parameters, system.values, strict=True)
    )
    # Parameters beyond this are named where a motion can't be followed.
    if value > 1e8:
        return f"; {name} = {value:g} is larger than it can carry: give a smaller one"
    return ""


def _towards(flow: Flow, earlier: Iterate, values: Values, halvings: int = 6) -> Orbit:
    """The closed orbit at other values of the parameters, by steps half as wide where Newton's
    method fails.
    """
    try:
        return _from_guess(flow, Iterate(earlier.states, earlier.period, values))
    except ConvergenceError:
        if halvings == 0 or values == earlier.values:
            raise
    middle = tuple((a + b) / 2 for a, b in zip(earlier.values, values, strict=True))
    between = _towards(flow, earlier, middle, halvings - 1)
    return _towards(flow, between.guess, values, halvings - 1)


def _checked(orbit: Orbit) -> Cycle:
    if _rests(orbit):
        raise ConvergenceError(
            "there is no cycle near: what Newton's method finds is rest, at "
            f"{np.round(orbit.state, 9).tolist()}; start farther from it"
        )
    return cycle_of(orbit)


def _rests(orbit: Orbit) -> bool:
    """Whether a closed orbit is an equilibrium, which closes after any period, as an orbit beside
    it nearly does.
    """
    orbit = in_scales(orbit)
    # A closed orbit of a smaller extent is rest.
    least_extent = 1e-9
    # So is one whose extent is less than so many of its errors.
    return extent(orbit) <= max(least_extent, 100.0 * error_of(orbit))


def _state(system: System, near: ArrayLike | None) -> FloatArray:
    field = system.field
    n = len(field.coordinates) - bool(field.clock)
    state = np.zeros(2 * n) if near is None else as_numbers("near", near)
    if field.clock and state.shape == (2 * n,):
        # Without the clock, which begins at 0 and keeps its rate.
        state = np.concatenate([state[:n], [0.0], state[n:], [field.clock(system.constants)]])
    if state.shape != (field.size,):
        raise ParameterError(
            f"near has the shape {state.shape}; give a state of {field.size} numbers, a "
            "trajectory or a cycle"
        )
    return state


def _by_returns(system: System, extrema: Sequence[Extremum]) -> Orbit | None:
    """The first closed orbit that Newton's method finds from two states that are alike: with the
    first one, the last one, any.
    """
    periodic = system.field.periodic
    for begin, end in [pair for row in (0, -1, None) for pair in returns(extrema, periodic, row)]:
        with suppress(ConvergenceError):
            state = in_one_turn(begin.state, periodic)
            orbit = _from_guess(system.flow, Iterate(state[None], end.t - begin.t, system.values))
            if not _rests(orbit):
                return orbit
    return None


def returns(
    extrema: Sequence[Extremum], periodic: WholeTurns, row: int | None = None
) -> list[tuple[Extremum, Extremum]]:
    """Pairs of alike states, largest in the leading coordinate: of each number of rounds the
    nearest, or the first one (0), or the last one (−1).

    One counts only if it is twice as near as those of fewer rounds that count. Those come first
    that are the nearest, times their rounds. States are in units of the motion.
    """
    extrema = [extremum for extremum in extrema if extremum.border == -1]
    # A return that misses by more than this share of the motion's extent is not tried.
    largest_miss = 0.3
    highest = [extremum for extremum in extrema if extremum.direction < 0]
    found, best = [], 2 * largest_miss
    states = np.array([extremum.state for extremum in highest])
    scale = np.ptp([extremum.state for extremum in extrema] or np.zeros((1, 1)), axis=0)
    scale = np.maximum(scale, 1e-2 * scale.max() + 1e-300)
    # Rounds after which a state may return, at most.
    for rounds in range(1, min(len(highest), 60)):
        off = np.abs(apart(states[rounds:], states[:-rounds], periodic) / scale).max(axis=1)
        i = int(off.argmin()) if row is None else row % len(off)
        if off[i] < best / 2:
            best = float(off[i])
            found.append((rounds * best, i, i + rounds))
    # Most pairs that are tried.
    return [(highest[i], highest[j]) for _, i, j in sorted(found)[:8]]


def _from_guess(flow: Flow, guess: Iterate) -> Orbit:
    """Newton's method from a guess, in as many mesh intervals as its growth asks for; it may not go
    far.
    """
    orbit = in_scales(subdivided(flow, guess))
    reach = 0.5 * extent(orbit) if orbit.extrema() else np.inf
    return natural(closed_orbit(orbit.flow, orbit, across(orbit), reach=reach))


def stands_still(system: System, state: FloatArray) -> str:
    """Reason: nothing moves; empty where it moves."""
    n = len(system.field.coordinates)
    try:
        scales = system.scales(state)
        # So long a motion tells whether anything moves.
        states = system.motion(state, 200.0 * scales.time).state[:n]
        moved = np.ptp(states, axis=1) / scales.places
    except ConvergenceError:
        return ""
    if moved.any():
        return ""
    if system.field.stays(system.mode(state)):
        return (
            "it comes to rest, and friction holds it there, as on any belt that stands still; "
            "give a belt speed above 0"
        )
    return "nothing moves from where it begins, a state of equilibrium; begin beside it"


def born_at(
    onsets: Onsets,
    index: int,
    amplitude: float | None,
    backend: str | None,
    options: ShootingOptions | None = None,
) -> Cycle:
    """The cycle of an amplitude in the family that is born at one of the onsets, along their first
    parameter.

    The motion takes friction at its sliding speed. Where statics takes its limit at fast sliding
    (``at_rest`` on the page), the Hopf point of the motion is sought beside the one that is proved.
    From there the normal form u = u* + 2 Re(z q) + …, with |z|² = −(d Re λ/dp) (p − p*)/(ω l₁), is
    corrected by Newton's method on the closed orbit, its period and the parameter. Without an
    amplitude it is a tenth of that at which the motion would come to a border of the field.
    """
    if not len(onsets):
        raise ParameterError("there are no onsets; search where there is one to begin from")
    row = as_count("index", index, 0, len(onsets) - 1)
    model = onsets.parameters.model
    vary = onsets.vary[0]
    form = onsets.normal_forms[row]
    if isinstance(form, str):
        raise ParameterError(f"index = {index}: no cycle is known to be born there, for {form}")
    parameter = model.parameters.index(vary)
    if amplitude is not None:
        amplitude = as_number("amplitude", amplitude, POSITIVE)
    given, state, radii = _of_the_motion(
        model, onsets.given(row), onsets.state(row), parameter, form
    )
    balance = onsets.balance(row, "friction_at_speed")
    try:
        form = normal_form(balance, given, state, (vary,), radii)
    except UndecidedSign as reason:
        raise ConvergenceError(
            f"the motion has no generic Hopf point beside the onset: {reason}"
        ) from reason
    system = System(Flow.of(model.field, backend, options), tuple(given.tolist()))
    rest = still(state)
    scales = system.scales(rest)
    most = int(np.abs(form.q[: len(state)] / scales.places).argmax())
    size = float(np.abs(form.q[most]))
    border, reach = _first_border(system, rest, form)
    if amplitude is None:
        unit = 1 / norm(form.q / scales.states)
        # A tenth of that at which it first comes to a border; where it comes to none, in units of
        # the motion.
        free = 0.1 * reach if border else 0.01 * unit
        z = min(free, unit, _within(model, given, parameter, form))
        asked = 2 * z * size
    else:
        z, asked = amplitude / 2 / size, amplitude
    least, remedy = 2 * reach * size, "give a smaller one, and go on from it with cycle_branch"
    if asked > least:
        remedy += f"; to first order only amplitudes below {least:.3g} do not come to {border}"
    # The longest of these steps, as a factor, and how many there are at most.
    farthest, steps = 2.0, 20
    for _ in range(steps):
        try:
            found = _along(system, rest, parameter, form, z)
        except ConvergenceError as error:
            raise ConvergenceError(
                f"no cycle of the amplitude {asked:.3g} was found: {error}; {remedy}"
            ) from error
        reached = float(np.ptp(found.samples.states[most])) / 2
        # How closely an amplitude is met, relatively.
        if amplitude is None or abs(reached / asked - 1) < 1e-3:
            return found
        z *= min(max(asked / reached, 1 / farthest), farthest)
    raise ConvergenceError(
        f"no cycle of the amplitude {asked:g} was found: the last one has {reached:.6g}; {remedy}"
    )


def still(position: FloatArray) -> FloatArray:
    """The state at rest in a place."""
    return np.append(position, np.zeros(len(position)))


def _along(system: System, rest: FloatArray, parameter: int, form: NormalForm, z: float) -> Cycle:
    """The cycle whose largest state has the part 2 |z| along q, as the normal form has it to first
    order.
    """
    scales = system.scales(rest)
    own, unit = system.scaled(scales), 1 / norm(form.q / scales.states)
    decided = abs(form.lyapunov) > form.lyapunov_error
    aside = -form.omega * form.lyapunov * z**2 / form.crossing if decided else 0.0
    ahead = form.along * aside + 2 * z * form.q.real + z**2 * (form.square.real + form.mean)
    first, middle = (rest + ahead) / scales.states, rest / scales.states
    start = list(system.values)
    start[parameter] += aside

    # What is asked of the first state: its part along q, as the normal form has it.
    left_eigenvector = form.p.conjugate() * scales.states / unit
    wanted = float((left_eigenvector @ (first - middle)).real)

    def conditions(orbit: Orbit) -> tuple[FloatArray, FloatArray]:
        seen = left_eigenvector @ (orbit.state - middle)
        wide = np.zeros((2, orbit.states.size + 2))
        wide[:, : len(rest)] = left_eigenvector.real, left_eigenvector.imag
        return np.array([seen.real - wanted, seen.imag]), wide

    period = 2 * math.pi / form.omega / scales.time
    guess = subdivided(own.flow, Iterate(first[None], period, tuple(start), (parameter,))).guess
    return cycle_of(natural(closed_orbit(own.flow, guess, conditions, reach=4 * z / unit)))


def _of_the_motion(
    model: Model, given: FloatArray, state: FloatArray, parameter: int, form: NormalForm
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Parameters and coordinates at the Hopf point of the motion itself, and how well each is
    known, by Newton's method in units of the motion and of the parameter: its value, or what makes
    of the pair's real part its frequency.
    """
    field, n = model.field, len(state)
    scales = scales_of(field, field.constants(given.tolist()), still(state).tolist())
    units = np.array([*scales.places, abs(given[parameter]) or form.omega / abs(form.crossing)])

    def residual(unknowns: FloatArray) -> FloatArray:
        values = given.copy()
        *q, values[parameter] = units * unknowns
        constants = field.constants(values.tolist())
        u = still(np.array(q)).tolist()
        mode = field.exact(field.mode_at_rest(u, constants))
        accelerations = field.rates(u, constants, mode)[n:]
        roots = np.linalg.eigvals(field.matrix(u, constants, mode))
        near = roots[np.abs(roots - 1j * form.omega).argmin()]
        off = near.real / form.crossing / units[n]
        return np.append(accelerations * scales.time**2 / scales.places, off)

    found = np.append(state, given[parameter]) / units
    scale = 1 + magnitude(found)
    # Least half-width of the box that is taken around the Hopf point of the motion, over its
    # numbers, which are no less than 1 in units of the motion and of the parameter.
    rounding = 1e-13
    # Most steps of Newton's method.
    steps = 20
    for _ in range(steps):
        step = np.linalg.lstsq(differences(residual, found, 1e-6 * scale), residual(found))[0]
        found, width = found - step, magnitude(step)
        if not rounding * scale < width < scale:
            break
    if not width <= 1e-7 * scale:
        vary = model.parameters[parameter]
        raise ConvergenceError(
            "no Hopf point of the motion, which takes friction at its own speed, was found beside "
            f"the onset at {vary} = {given[parameter]:.6g}: see the labels H of "
            f"ss.diagram(p, {vary!r}, between=...)"
        )
    there = given.copy()
    *q, there[parameter] = units * found
    return there, np.array(q), 4 * max(width, rounding * scale) * units


def _first_border(system: System, rest: FloatArray, form: NormalForm) -> tuple[str, float]:
    """The border that gap or sliding speed would come to first, and the |z| at which they do, to
    first order; none, infinity.
    """
    field, constants = system.field, system.constants
    borders = [border for border in field.borders if any(border.crossings)]
    if not borders:
        return "", math.inf

    mode = field.mode_at_rest(rest.tolist(), constants)

    def levels(u: FloatArray) -> FloatArray:
        return np.array([border.level(u.tolist(), constants, mode) for border in borders])

    with np.errstate(divide="ignore"):
        steps = 1e-6 * system.scales(rest).states
        reach = np.abs(levels(rest)) / (2 * np.abs(differences(levels, rest, steps) @ form.q))
    return borders[int(reach.argmin())].name, float(reach.min())


def _within(model: Model, given: FloatArray, parameter: int, form: NormalForm) -> float:
    """|z| up to which the parameter stays within a tenth of its range, to first order."""
    entry, value = model.about["parameters"][parameter], given[parameter]
    ahead = -form.omega * form.lyapunov / form.crossing
    end = entry["high"] if ahead > 0 else entry["low"]
    return np.inf if end is None or not ahead else math.sqrt(0.1 * abs(end - value) / abs(ahead))


# ------------------------------------------------------------------------------------------------
# attractors


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
    kind, size = verdict.kind.attractor, system.field.deviations
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
