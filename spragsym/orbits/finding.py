"""Finding cycles: from a state near one, from a motion that approaches one, or from the Hopf point
at which one is born. All end in Newton's method for a closed orbit
(:mod:`spragsym.motion.shooting`).

Also attractors: the classifier (:mod:`spragsym.motion.classify`) detects the limit of a motion;
here Newton's method computes it as an equilibrium or closed orbit (:class:`Attractor`), which can
be continued in a parameter and compared with another.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from ..bifurcation.flutter import Onsets
from ..bifurcation.normal_forms import NormalForm, normal_form
from ..core.error_states import in_usual_state
from ..core.errors import ConvergenceError, ParameterError, ParameterTypeError, require_kind
from ..core.questions import require_answered
from ..core.remarks import Remark
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
    extent,
    in_scales,
    natural,
    rate,
    rests,
    subdivided,
)
from ..motion.simulation import Start, named_state
from ..motion.solution import Extremum
from ..numerics.balls import UndecidedSign
from ..numerics.vectors import TURN, WholeTurns, in_one_turn, magnitude, norm, state_difference
from .arclength import Setting, along, differences, started
from .orbit import Cycle, cycle_of, same_cycle
from .system import FateVerdict, FixedPoints, System, judged, rounding_of


@in_usual_state
def cycle(
    p: ParameterSet | None = None,
    near: Start | Trajectory | Cycle | None = None,
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

    Newton's method with the derivatives of the flow, by multiple shooting. The orbit may lose
    contact and overtake the belt any number of times, and may stick where friction holds it
    (``page.friction``).

    Parameters
    ----------
    p : Parameters of any model
        Scalars.
    near : array_like, mapping, Trajectory or Cycle, optional
        A state near the cycle, which may be unstable: coordinates, then rates, or some of them by
        name, by default 0. Or a
        motion whose end approaches the cycle; or a cycle at other values of the parameters.
    backend : {"heyoka", "scipy"}, optional
        As for :func:`~spragsym.simulate`.
    patient : bool
        From a state that is not near a cycle, follow the motion for up to 40 000 time units.
    onset : Onsets, optional
        Result of :func:`~spragsym.flutter_onsets`. It contains the model and its parameters, so
        ``p``, ``near`` and ``values`` are omitted.
    index : int
        Index of the onset.
    amplitude : float, optional
        Amplitude of the cycle born there, to a thousandth: half the range of the coordinate that
        moves most. The parameter along which the onsets were found takes the value at which the
        cycle has this amplitude; see :func:`spragsym.orbits.finding.born_at`.
    turns : int, optional
        For a page with a clock: the cycle that closes after this number of turns, stable or not, by
        Newton's method from ``near``, by default from the end of a motion of a hundred turns.
    options : ShootingOptions, optional
        Tolerances and limits of Newton's method, also for later continuation of the cycle.
    **values : float, optional
        Values of parameters that replace those of ``p``, as ``V=0.5, d=10.0``.

    Returns
    -------
    Cycle

    Raises
    ------
    ConvergenceError
        If there is no cycle near. The message says what the motion comes to instead.

    Notes
    -----
    Source: (8)–(11). The result is a cycle up to its stated error. Other cycles may exist.

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
    require_answered("cycle", p)
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


def _after_turns(system: System, near: Start | Trajectory | Cycle | None, turns: int) -> Cycle:
    """The cycle that closes after a number of turns of the clock."""
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
    system: System, near: Start | Trajectory | Cycle | None = None, *, patient: bool = True
) -> Cycle:
    """:func:`cycle` of a system.

    From a state, closed orbits are first computed from close returns of the motion. If there are
    none, or ``near`` is a motion, the limit of the motion is classified; under a clock, if it comes
    to none, Newton's method looks for a cycle of one turn from the start.
    """
    field, flow = system.field, system.flow
    if isinstance(near, Cycle):
        near.require(field, "near")
        return _checked(_towards(flow, near.orbit.guess, system.values))
    approached = near is None or isinstance(near, Trajectory)
    attempts = None if patient or approached else 1
    start = near.state[:, -1] if isinstance(near, Trajectory) else _state(system, near)
    if not np.isfinite(rate(field, start, system.constants)).all():
        raise ParameterError(
            f"near = {start.tolist()}: the motion is not defined there; give another state"
        )
    scales = system.scales(start)
    own = system.scaled(scales)
    try:
        # A longer motion is needed only if there are hardly any extrema.
        for time in () if approached else (400.0, 3000.0, 20000.0)[:attempts]:
            flow_result = own.flow.plain(start / scales.states, own.constants, time, loose=True)
            if (found := _by_returns(own, flow_result.extrema)) is not None:
                return _checked(found)
            if len(flow_result.extrema) > 2:
                break
        first = [t * scales.time for t in system.options.times[:attempts]]
        verdict = judged(system, start, times=first if attempts else None)
    except ConvergenceError as error:
        raise ConvergenceError(f"the motion can't be followed: {error}{_steep(system)}") from error
    if verdict.kind == Regime.LIMIT_CYCLE:
        with suppress(ConvergenceError):
            return cycle_at(system, np.array(verdict.outcome.cycle), verdict.outcome.period)
    if field.clock and not verdict.decided:  # without damping no motion comes to it
        with suppress(ConvergenceError):
            return cycle_at(system, start, TURN / field.clock(system.constants))
    why = stands_still(system, verdict.end) or Remark(
        "it comes to {}; give as near a state nearer to a cycle, or the end of a longer motion",
        verdict.described(),
    )
    raise ConvergenceError(Remark("no cycle was found near the motion: {}", why))


def cycle_at(system: System, state: FloatArray, period: float) -> Cycle:
    """The cycle near a state and a period, by Newton's method alone."""
    return _checked(_from_guess(system.flow, Iterate(state[None], period, system.values)))


def _steep(system: System) -> str:
    """Text that names the largest parameter if it exceeds 1e8, for a motion that cannot be
    integrated.
    """
    value, name = max(
        (abs(value), name)
        for name, value in zip(system.field.parameters, system.values, strict=True)
    )
    if value > 1e8:
        return f"; {name} = {value:g} is larger than it can carry: give a smaller one"
    return ""


def _towards(flow: Flow, earlier: Iterate, values: Values, halvings: int = 6) -> Orbit:
    """The closed orbit at other values of the parameters; if Newton's method fails, by way of the
    orbit halfway.
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
    """The cycle of an orbit; ConvergenceError if it is an equilibrium."""
    if rests(in_scales(orbit)):
        raise ConvergenceError(
            Remark(
                "there is no cycle near: what Newton's method finds is rest, at {}; start farther "
                "from it",
                orbit.field.place(natural(orbit).state, ".9g"),
            )
        )
    return cycle_of(orbit)


def _state(system: System, near: Start | None) -> FloatArray:
    """The state that a user gives, (m,), 0 for None; one without clock begins at its phase 0."""
    field = system.field
    n = len(field.coordinates) - bool(field.clock)
    if isinstance(near, Mapping):
        names = field.components
        named = named_state(near, names)
        still = np.zeros(len(names))
        still[-1] = field.clock(system.constants) if field.clock else 0.0
        pairs = zip(names, still, strict=True)
        return np.array([as_number(f"near[{it!r}]", named.get(it, value)) for it, value in pairs])
    state = np.zeros(2 * n) if near is None else as_numbers("near", near)
    if field.clock and state.shape == (2 * n,):
        state = np.concatenate([state[:n], [0.0], state[n:], [field.clock(system.constants)]])
    if state.shape != (field.size,):
        raise ParameterError(
            f"near has the shape {state.shape}; give a state of {field.size} numbers, a "
            "trajectory or a cycle"
        )
    return state


def _by_returns(system: System, extrema: Sequence[Extremum]) -> Orbit | None:
    """The first closed orbit, not at rest, that Newton's method finds from close returns: to the
    first maximum, to the last one, between any two; None if there is none.
    """
    periodic = system.field.periodic
    for begin, end in [pair for row in (0, -1, None) for pair in returns(extrema, periodic, row)]:
        with suppress(ConvergenceError):
            state = in_one_turn(begin.state, periodic)
            orbit = _from_guess(system.flow, Iterate(state[None], end.t - begin.t, system.values))
            if not rests(in_scales(orbit)):
                return orbit
    return None


def returns(
    extrema: Sequence[Extremum], periodic: WholeTurns, row: int | None = None
) -> list[tuple[Extremum, Extremum]]:
    """Close returns of a motion: pairs of maxima of the leading coordinate with similar states,
    eight at most.

    For each number of rounds up to 59 between the two, the closest pair is taken, or that of the
    first maximum (``row`` 0) or the last one (−1). A pair counts if its distance is below 0.3 of
    the motion's extent, and half that of every pair with fewer rounds that counts. Pairs are sorted
    by distance × rounds. States are in units of the motion.
    """
    extrema = [extremum for extremum in extrema if extremum.border == -1]
    largest_distance = 0.3
    maxima = [extremum for extremum in extrema if extremum.direction < 0]
    found, best = [], 2 * largest_distance
    states = np.array([extremum.state for extremum in maxima])
    scale = np.ptp([extremum.state for extremum in extrema] or np.zeros((1, 1)), axis=0)
    scale = np.maximum(scale, 1e-2 * scale.max() + 1e-300)
    for rounds in range(1, min(len(maxima), 60)):
        distances = np.abs(
            state_difference(states[rounds:], states[:-rounds], periodic) / scale
        ).max(axis=1)
        i = int(distances.argmin()) if row is None else row % len(distances)
        if distances[i] < best / 2:
            best = float(distances[i])
            found.append((rounds * best, i, i + rounds))
    return [(maxima[i], maxima[j]) for _, i, j in sorted(found)[:8]]


def _from_guess(flow: Flow, guess: Iterate) -> Orbit:
    """The closed orbit near a guess, on a refined mesh, no farther away than half its extent."""
    first = guess.states[0]
    aside = first - flow.field.periodic.unshifted(first)  # nearer to 0, what may be shifted
    orbit = in_scales(subdivided(flow, replace(guess, states=guess.states - aside)))
    reach = 0.5 * extent(orbit) if orbit.extrema() else np.inf
    return natural(closed_orbit(orbit.flow, orbit, across(orbit), reach=reach))


def repeats(system: System, state: FloatArray) -> str:
    """Text that a motion which nothing attracts is on a cycle nonetheless, as that of twins that
    start alike; empty if it does not come back to the state.
    """
    field = system.field
    periods = [2 * math.pi / field.clock(system.constants)] if field.clock else []
    with suppress(ConvergenceError):
        periods.append(cycle_near(system, state, patient=False).period)
    for period in periods:
        back = system.motion(state, period).state[:, -1]
        off = state_difference(back, state, field.periodic) / system.scales(state).states
        if magnitude(off) < SAME_STATE:
            return (
                f"it is on a cycle of period {period:.6g} that repels, and stays there by its "
                "start alone; begin beside it"
            )
    return ""


def stands_still(system: System, state: FloatArray) -> str:
    """Text that explains why a motion from a state does not move; empty if it moves, or cannot be
    integrated.
    """
    n = len(system.field.coordinates)
    try:
        scales = system.scales(state)
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
    """The cycle of a given amplitude in the family born at a Hopf point.

    The Hopf point is number ``index`` of the onsets; the parameter is the first one along which
    they were found. Statics may use the friction limit at fast sliding (``at_rest`` on the page),
    while the motion uses the friction at its sliding speed: so the Hopf point of the motion is
    computed first, by :func:`_of_the_motion`.

    The guess is the normal form u = u* + 2 Re(z q) + …, with |z|² = −(d Re λ/dp) (p − p*)/(ω l₁).
    Newton's method corrects it for the closed orbit, its period and the parameter. z is adjusted
    until the amplitude is met. The default amplitude is a tenth of that at which the motion first
    reaches a border of the field.
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
    leading = int(np.abs(form.q[: len(state)] / scales.places).argmax())
    size = float(np.abs(form.q[leading]))
    border, largest_z = _first_border(system, rest, form)
    if amplitude is None:
        unit = 1 / norm(form.q / scales.states)
        # Without a border, in units of the motion.
        free = 0.1 * largest_z if border else 0.01 * unit
        z = min(free, unit, _within(model, given, parameter, form))
        target = 2 * z * size
    else:
        z, target = amplitude / 2 / size, amplitude
    limit, remedy = 2 * largest_z * size, "give a smaller one, and go on from it with cycle_branch"
    if target > limit:
        remedy += f"; to first order only amplitudes below {limit:.3g} do not come to {border}"
    for _ in range(20):
        try:
            found = _along(system, rest, parameter, form, z)
        except ConvergenceError as error:
            raise ConvergenceError(
                f"no cycle of the amplitude {target:.3g} was found: {error}; {remedy}"
            ) from error
        reached = float(np.ptp(found.samples.states[leading])) / 2
        if amplitude is None or abs(reached / target - 1) < 1e-3:
            return found
        z *= min(max(target / reached, 0.5), 2.0)
    raise ConvergenceError(
        f"no cycle of the amplitude {target:g} was found: the last one has {reached:.6g}; {remedy}"
    )


def still(position: FloatArray) -> FloatArray:
    """The state at rest at a position: rates 0 appended."""
    return np.append(position, np.zeros(len(position)))


def _along(system: System, rest: FloatArray, parameter: int, form: NormalForm, z: float) -> Cycle:
    """The cycle of the family born at a Hopf point whose first state has the component 2 z along q,
    to first order of the normal form.

    Newton's method for the closed orbit and the parameter. The two conditions fix the complex
    component of the first state along q: modulus and phase.
    """
    scales = system.scales(rest)
    own, unit = system.scaled(scales), 1 / norm(form.q / scales.states)
    criticality_known = abs(form.lyapunov) > form.lyapunov_error
    change = -form.omega * form.lyapunov * z**2 / form.crossing if criticality_known else 0.0
    ahead = form.along * change + 2 * z * form.q.real + z**2 * (form.square.real + form.mean)
    first, middle = (rest + ahead) / scales.states, rest / scales.states
    start = list(system.values)
    start[parameter] += change

    left_eigenvector = form.p.conjugate() * scales.states / unit
    target = float((left_eigenvector @ (first - middle)).real)

    def conditions(orbit: Orbit) -> tuple[FloatArray, FloatArray]:
        component = left_eigenvector @ (orbit.state - middle)
        rows = np.zeros((2, orbit.states.size + 2))
        rows[:, : len(rest)] = left_eigenvector.real, left_eigenvector.imag
        return np.array([component.real - target, component.imag]), rows

    period = 2 * math.pi / form.omega / scales.time
    guess = subdivided(own.flow, Iterate(first[None], period, tuple(start), (parameter,))).guess
    return cycle_of(natural(closed_orbit(own.flow, guess, conditions, reach=4 * z / unit)))


def _of_the_motion(
    model: Model, given: FloatArray, state: FloatArray, parameter: int, form: NormalForm
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Parameters and coordinates at the Hopf point of the motion near that of statics, and radii of
    their errors, (n + 1,).

    Newton's method for n accelerations = 0 and Re λ = 0, with differences as Jacobian. Coordinates
    are in units of the motion. The unit of the parameter is its value, or if that is 0 the change
    that changes Re λ by ω.
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
        eigenvalues = np.linalg.eigvals(field.matrix(u, constants, mode))
        nearest = eigenvalues[np.abs(eigenvalues - 1j * form.omega).argmin()]
        growth = nearest.real / form.crossing / units[n]
        return np.append(accelerations * scales.time**2 / scales.places, growth)

    found = np.append(state, given[parameter]) / units
    scale = 1 + magnitude(found)
    rounding = 1e-13
    for _ in range(20):
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
    values = given.copy()
    *q, values[parameter] = units * found
    return values, np.array(q), 4 * max(width, rounding * scale) * units


def _first_border(system: System, rest: FloatArray, form: NormalForm) -> tuple[str, float]:
    """Name of the border that a growing cycle reaches first, and the |z| at which it does, to first
    order: at a distance h it is |h| / (2 |∇h q|). An empty name and infinity without borders.
    """
    field, constants = system.field, system.constants
    mode = field.mode_at_rest(rest.tolist(), constants)
    borders = [border for border in field.borders if any(border.crossings) and border.sign(mode)]
    if not borders:
        return "", math.inf

    def levels(u: FloatArray) -> FloatArray:
        return np.array([border.level(u.tolist(), constants, mode) for border in borders])

    with np.errstate(divide="ignore"):
        steps = 1e-6 * system.scales(rest).states
        at_z = np.abs(levels(rest)) / (2 * np.abs(differences(levels, rest, steps) @ form.q))
    return borders[int(at_z.argmin())].name, float(at_z.min())


def _within(model: Model, given: FloatArray, parameter: int, form: NormalForm) -> float:
    """|z| up to which the parameter changes by at most a tenth of the distance to the end of its
    range, to first order.
    """
    entry, value = model.about["parameters"][parameter], given[parameter]
    per_square = -form.omega * form.lyapunov / form.crossing
    end = entry["high"] if per_square > 0 else entry["low"]
    if end is None or not per_square:
        return np.inf
    return math.sqrt(0.1 * abs(end - value) / abs(per_square))


@dataclass(frozen=True)
class Attractor:
    """A stable equilibrium or cycle, or lift-off, for which only the kind matters."""

    kind: Regime
    system: System
    state: FloatArray
    orbit: Cycle | None = None


def attractor(system: System, verdict: FateVerdict) -> Attractor:
    """The attractor that a motion was seen to approach, by Newton's method; ConvergenceError if it
    converges to another one.
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
    """The attractor continued to a system with another value of one parameter; ConvergenceError if
    it ends or loses its stability before.
    """
    if earlier.kind == Regime.LIFT_OFF or earlier.system == system:
        return replace(earlier, system=system)
    if earlier.orbit is not None:
        return _of_cycle(system, followed_cycle(earlier.orbit, system.values))
    index, span = _varied(earlier.system.values, system.values)
    scales = earlier.system.scales(earlier.state)
    own = earlier.system.scaled(scales)
    rest = FixedPoints(own.field).started(own, earlier.state / scales.states, index, span)
    return _at_rest(system, natural(along(rest, system.values[index]).orbit).state)


def followed_cycle(earlier: Cycle, values: Values) -> Cycle:
    """The cycle continued to another value of one parameter; ConvergenceError if the branch has a
    fold or ends before.
    """
    index, span = _varied(earlier.values, values)
    own = in_scales(earlier.orbit)
    setting = Setting(own.flow, (index,), own.period, (span,))
    return cycle_of(along(started(setting, own.guess), values[index]).orbit)


def _varied(now: Values, then: Values) -> tuple[int, float]:
    """Index of the only parameter that differs, and the absolute difference."""
    ((index, span),) = (
        (i, abs(b - a)) for i, (a, b) in enumerate(zip(now, then, strict=True)) if a != b
    )
    return index, span


def attractor_exponents(
    system: System, verdict: FateVerdict
) -> tuple[str, FloatArray, FloatArray, Remark | str]:
    """Kind of the attractor of a motion, its Lyapunov exponents, largest first, their errors, and
    what is to be said of a cycle that closes up to a shift.

    They are real parts of eigenvalues, or ln |μ| / T of multipliers μ; −∞ for deviations that
    sticking ends, NaN for lift-off. The error is infinite for a multiplier below its own error.
    """
    kind, size = verdict.kind.attractor, system.field.deviations
    if verdict.kind == Regime.EQUILIBRIUM and system.field.clock:
        # Held in every phase: deviations of the coordinates persist, sticking ends those of rates.
        held = np.where(np.arange(size) < len(system.field.coordinates), 0.0, -np.inf)
        return kind, held, np.zeros(size), ""
    limit = attractor(system, verdict)
    if limit.kind == Regime.LIFT_OFF:
        unknown = np.full(size, np.nan)
        return kind, unknown, unknown, ""
    if limit.orbit is None:
        values, _ = spectrum_at_rest(
            system.field, system.constants, limit.state, system.resting_mode(limit.state)
        )
        rates = np.full(size, -np.inf)
        rates[: len(values)] = values.real
        errors = np.zeros(len(rates))
    else:
        moduli = np.abs(limit.orbit.multipliers)
        off = np.array([0.0, *limit.orbit.multiplier_errors])
        with np.errstate(divide="ignore", invalid="ignore"):
            rates = np.log(moduli) / limit.orbit.period
            known = np.where(moduli > 0, off < moduli, off == 0)
            relative = np.divide(off, moduli, out=np.zeros_like(off), where=moduli > 0)
            errors = np.where(known, -np.log1p(-relative) / limit.orbit.period, np.inf)
        rates[0] = 0.0
    order = np.argsort(-rates, kind="stable")
    return kind, rates[order], errors[order], "" if limit.orbit is None else limit.orbit.moves_on


def same(one: Attractor, other: Attractor) -> bool:
    """True if two attractors at the same values of the parameters are the same."""
    if one.kind != other.kind or one.kind == Regime.LIFT_OFF:
        return one.kind == other.kind
    if one.orbit is None or other.orbit is None:
        states = one.system.scales(one.state).states
        off = state_difference(one.state, other.state, one.system.field.periodic) / states
        return magnitude(off) < SAME_STATE * (1 + magnitude(one.state / states))
    return same_cycle(one.orbit, other.orbit)


def _at_rest(system: System, state: FloatArray) -> Attractor:
    """The attractor of an equilibrium; ConvergenceError if it is unstable."""
    matrix = system.linearization(state)
    if np.linalg.eigvals(matrix).real.max() > rounding_of(matrix):
        raise ConvergenceError("the equilibrium loses its stability on the way")
    return Attractor(Regime.EQUILIBRIUM, system, state)


def _of_cycle(system: System, orbit: Cycle) -> Attractor:
    """The attractor of a cycle; ConvergenceError if it is not stable."""
    if not orbit.stable:
        raise ConvergenceError("the cycle loses its stability on the way")
    return Attractor(Regime.LIMIT_CYCLE, system, orbit.state, orbit)
