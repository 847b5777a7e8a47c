"""States and motions of a brake in newtons, millimetres and hertz: states of steady sliding
(:class:`State`), the jump as a motion (:class:`JumpPeak`), the oscillation (:class:`Oscillation`).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from ..bifurcation.paths import quasi_static_path
from ..core.errors import ConvergenceError, SpragsymError
from ..core.type_variables import T
from ..design.jumps import jump_value
from ..models import forces
from ..models.parameters import FloatArray, ParameterSet, Ranges
from ..models.quantities import factor
from ..motion import Outcome, Regime, Trajectory, simulate
from ..numerics.interval_arrays import ComplexArray
from ..orbits import Cycle, cycle
from ..orbits.finding import cycle_at
from ..orbits.system import System
from ..results import Equilibria, EquilibriumType, Named, Result
from ..statics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.search import balances_of, number_of
from ..statics.stability import NEUTRAL_GROWTH, linearization, roots, verdicts
from .study import Study
from .units import Numbers

#: The motion of a jump starts at this share of the distance from the fold to the remaining state.
SHARE_BEYOND_FOLD = 1e-2

#: A number for the only inclined spring or contact, a mapping by name for several, None for none.
OfSprings: TypeAlias = float | Numbers | None


@dataclass(frozen=True)
class State(Named):
    """A state of steady sliding in contact.

    Attributes
    ----------
    current : bool
        True for the state of the brake.
    stability : str
        ``"stable"``: small disturbances decay. ``"unstable"``: they grow. ``"neutral"``: their
        growth or decay is so slow that effects outside the model decide.
    undamped : str
        Stability by (27) and (28), without damping.
    places : dict
        Coordinates by name and unit, as ``x_mm`` or ``phi_deg``; each is an attribute, too.
    direction_deg, spring_length_mm, spring_force_N, contact_force_N
        A number for the only inclined spring or contact, a mapping by name for several, None for
        none.
    frequencies_hz, damping_ratio : tuple of float
        Those of the eigenvalues of the linearized motion, slowest first. The slope of the friction
        law is included if the belt speed is known.
    growth_per_s : float
        Largest real part of the eigenvalues.
    touching : str
        The contacts that touch, if there are several.
    """

    _held = "places"

    current: bool
    stability: str
    undamped: str
    direction_deg: OfSprings
    places: Numbers
    spring_length_mm: OfSprings
    spring_force_N: OfSprings
    contact_force_N: OfSprings
    frequencies_hz: tuple[float, ...]
    damping_ratio: tuple[float, ...]
    growth_per_s: float
    touching: str = ""


@dataclass(frozen=True)
class JumpPeak(Named):
    """The motion of a jump, from the fold on: ranges of coordinates and forces, and its limit.

    Attributes
    ----------
    at : float
        Value of the loading parameter at the jump, as reported.
    before, after : dict
        Coordinates at the fold, and of the state that remains, by name and unit.
    ranges : dict
        Smallest and largest value of each coordinate; each is an attribute, too.
    spring_force_N, contact_force_N
        Smallest and largest force of the only inclined spring or contact, or by name for several.
    lifts_off : bool
        True if a contact opens.
    settles : str
        Limit of the motion: ``"rest"``, ``"cycle"``, ``"lift-off"``, or ``"unsettled"``.
    followed_s : float
        Time over which the motion was followed.
    """

    _held = "ranges"

    at: float
    before: Numbers
    after: Numbers
    ranges: Ranges
    spring_force_N: Any
    contact_force_N: Any
    lifts_off: bool
    settles: str
    followed_s: float


@dataclass(frozen=True)
class Oscillation(Result):
    """The limit of a motion that starts at rest with all coordinates 0, or far out.

    Attributes
    ----------
    kind : str
        ``"cycle"``: an attracting cycle. ``"motion"``: it continues, without repeating itself in
        the time it was followed. ``"rest"``: it decays to rest. ``"lift-off"``: it lifts off for
        good. ``"falls"`` and ``"grows"``: it became smaller and smaller, or larger and larger, and
        was not followed to its end.
    frequency_hz : float
        Frequency of the cycle, else NaN.
    amplitude, unit
        Half the range of the first coordinate, in "mm" or "deg", for "cycle" and "motion".
    spring_force_N, contact_force_N
        Smallest and largest force for these, by name for several springs or contacts.
    coexists : bool or None
        True if it continues although steady sliding is stable; None if that is neutral, or the
        state of the brake is not known.
    start : str
        ``"rest"`` or ``"far out"``.
    motion
        The cycle or trajectory.
    """

    kind: str
    frequency_hz: float
    amplitude: float
    unit: str
    spring_force_N: Any
    contact_force_N: Any
    coexists: bool | None
    start: str
    motion: Any = field(repr=False)

    @property
    def amplitude_mm(self) -> float:
        """The amplitude, if it is a length; NaN if it is an angle."""
        return self.amplitude if self.unit == "mm" else math.nan

    @property
    def alive(self) -> bool:
        """True if the motion continues."""
        return self.kind in ("cycle", "motion")

    @property
    def lifts_off(self) -> bool:
        """True if a contact opens."""
        return self.kind == "lift-off" or _opens(self.contact_force_N)


def _opens(forces: Any) -> bool:
    """True if a contact opens: the smallest force of the only contact, or of one by name, is 0."""
    each = forces.values() if isinstance(forces, Mapping) else [forces]
    return any(ends is not None and ends[0] == 0 for ends in each)


def unit_of(study: Study, name: str = "") -> tuple[str, float]:
    """Unit of a coordinate, by default of the first, and the factor to it from the model's unit:
    millimetres for lengths, degrees for angles.
    """
    si = study.kind.coordinates[name or study.kind.model.coordinates[0]]
    return ("mm", 1e3 * study.scales.length) if si == "m" else ("deg", math.degrees(1.0))


def in_units(study: Study, position: Numbers) -> Numbers:
    """Coordinates in the model's units as numbers by name and unit."""
    shown = ((name, *unit_of(study, name)) for name in study.kind.coordinates if name in position)
    return {f"{name}_{unit}": size * float(position[name]) for name, unit, size in shown}


def _of_springs(study: Study, values: Sequence[Any]) -> OfSprings:
    """The values of all springs in order, as :data:`OfSprings`."""
    if len(values) < 2:
        return next(iter(values), None)
    return dict(zip((entry["name"] for entry in study.kind.about["springs"]), values, strict=True))


def _of_contacts(study: Study, in_newtons: Mapping[str, T]) -> T | dict[str, T] | None:
    """The force of the only contact, or the forces of several by name; None without contacts."""
    names = [one["name"] for one in study.kind.about["contacts"]]
    codes = {name: forces.named("contact_force", name) for name in names}
    found = {name: in_newtons[code] for name, code in codes.items() if code in in_newtons}
    return found.get("", found or None)


def _forces(study: Study, ends: Ranges, share: float = 1.0) -> tuple[Any, Any]:
    """Ranges of spring and of contact forces in newtons, from those in ``share`` of the model's
    unit.
    """
    size = share * study.scales.force
    in_newtons = {name: (low * size, high * size) for name, (low, high) in ends.items()}
    contacts = _of_contacts(study, in_newtons)
    springs = [force for name, force in in_newtons.items() if not name.startswith("contact_force")]
    return _of_springs(study, springs), contacts


def _extremes(p: ParameterSet, states: FloatArray) -> Ranges:
    """Smallest and largest value of each force over states (2 n, k)."""
    constants = [float(value) for value in p.model.arguments(p, "motion")]
    forces_over_time = (
        (name, force(states, constants)) for name, force in forces.forces_of(p.model).items()
    )
    return {name: (float(np.min(force)), float(np.max(force))) for name, force in forces_over_time}


def states(study: Study, eq: Equilibria, here: Numbers | None) -> tuple[State, ...]:
    """All states of ``eq``, which are in contact at the friction in use, in order; the one with the
    coordinates ``here`` is current.
    """
    positions = _places(eq)
    distances = [
        max(abs(value - here[name]) for name, value in position.items()) if here else math.inf
        for position in positions
    ]
    found = []
    for slot, position in enumerate(positions):
        nearest = slot == distances.index(min(distances))
        is_here = nearest and distances[slot] < 1e-6
        found.append(_state(study, eq, slot, position, is_here))
    return tuple(found)


def others(
    study: Study, eq: Equilibria, states: Sequence[State]
) -> tuple[tuple[Numbers, float | None], ...]:
    """Stable states of ``eq`` other than the current one: coordinates by name and unit, and the
    value of the loading parameter at which each ends; NaN if it does not, None if unknown.
    """
    at, load, found = study.operating_point, study.load, []
    for state, position in zip(states, _places(eq), strict=True):
        if state.undamped != "stable" or state.current:
            continue
        end = None
        if load is not None:
            with suppress(SpragsymError):
                jump = jump_value(
                    at.following(**position), load.name, begin=at.scalars(load.name)[0]
                )
                end = study.displayed(float(jump))
        found.append((state.places, end))
    return tuple(found)


def current(study: Study, eq: Equilibria) -> Numbers | None:
    """Coordinates of the state that is reached as the loading parameter rises; without a loading
    parameter those of the only state. None if there is none.
    """
    if study.load is None:
        return _places(eq)[0] if int(eq.count) == 1 else None
    (value,), begin = study.operating_point.scalars(study.load.name), study.start()
    path = quasi_static_path(
        study.operating_point, study.load.name, [begin, value] if value > begin else [begin]
    )
    if path.jumps and not path.jumps[-1].after:  # it has run to infinity on the way
        return None
    return {name: float(column[-1]) for name, column in path.coordinates.items()}


def comes_from_near(study: Study, position: Numbers) -> bool:
    """True if the state at a position (by name and unit) is reached from a state near it, where the
    loading parameter begins; otherwise only a jump or a push leads there.
    """
    if study.load is None:
        return True
    names = {name: name.rpartition("_")[::2] for name in position}
    si = {
        own: position[name] * factor(unit, study.kind.coordinates[own])
        for name, (own, unit) in names.items()
    }
    beside = study.with_data(state=si)
    reached, here = (current(one, equilibria(one.operating_point)) for one in (beside, study))
    if reached is None or here is None:
        return False
    off, apart = (
        sum(abs(reached[name] - other[name]) for name in beside.near)
        for other in (beside.near, here)
    )
    return off < apart


def _places(eq: Equilibria) -> list[Numbers]:
    """Coordinates of each state by name."""
    return [
        {name: float(column[slot]) for name, column in eq.coordinates.items()}
        for slot in range(int(eq.count))
    ]


def _state(study: Study, eq: Equilibria, slot: int, position: Numbers, is_here: bool) -> State:
    """The state in a slot of ``eq``, with these coordinates."""
    scales, model = study.scales, study.kind.model

    def of(names: Iterable[str], scale: float) -> OfSprings:
        return _of_springs(study, [scale * float(eq[name][slot]) for name in names])

    # Direction and length of each spring, alternating.
    where = [name for name in forces.columns_of(model) if name not in position]
    names = forces.forces_of(model)
    springs = [name for name in names if not name.startswith("contact_force")]
    contacts = {name: scales.force * float(eq[name][slot]) for name in names if name not in springs}
    touching = str(eq.touching[slot]) if model.has_regimes else ""
    rate = _roots(study, list(position.values()), touching) / scales.time
    size = np.abs(rate).max()
    # Without damping the real parts are rounding errors, relative to the largest eigenvalue.
    rate = np.where(np.abs(rate.real) <= 1e-14 * size, 1j * rate.imag, rate)
    upper = sorted((root for root in rate if root.imag > 1e-9 * size), key=lambda root: root.imag)
    ratios = tuple(float(-root.real / abs(root)) + 0.0 for root in upper)
    growth, kind = float(rate.real.max()), EquilibriumType(int(eq.undamped[slot]))
    stability = "neutral" if kind == EquilibriumType.STABLE else "unstable"
    if study.moves and growth:
        rate = rate[np.argsort(-rate.real, kind="stable")]
        stability = str(verdicts(np.array([growth]), rate[None])[0])
    return State(
        current=is_here,
        stability=stability,
        undamped=kind.name.lower(),
        direction_deg=of(where[::2], math.degrees(1.0)),
        places=in_units(study, position),
        spring_length_mm=of(where[1::2], 1e3 * scales.length),
        spring_force_N=of(springs, scales.force),
        contact_force_N=_of_contacts(study, contacts),
        frequencies_hz=tuple(float(root.imag) / (2 * math.pi) for root in upper),
        damping_ratio=ratios,
        growth_per_s=growth,
        touching=touching,
    )


def _roots(study: Study, q: list[float], touching: str) -> ComplexArray:
    """Eigenvalues of the linearized motion at the belt's speed, in the model's unit; without the
    slope of the friction law if the speed is not known.
    """
    p, belt = study.dimensionless, study.kind.law["belt"]
    if not study.moves and belt in p.model.parameters:
        # The friction in use is that at rest; at this speed no law has a slope.
        p = p.replace(**{belt: 1e9})
    given = np.array(p.scalars(*p.model.parameters))
    balances = balances_of(p.model, law=study.law)
    balance = balances[number_of(balances, touching)]
    return roots(*linearization(balance, np.array(q)[:, None], given[:, None]))[0]


def is_negligible(ratio: float) -> bool:
    """Whether a damping ratio decides nothing: the mode counts as neutral."""
    return abs(ratio) < NEUTRAL_GROWTH


def jump_peak(study: Study, value: float, speed: float) -> JumpPeak | None:
    """The jump as a motion; None if the friction of the belt does not reach the jump, the law is
    not known, or the motion creeps.

    ``value`` is that of the model's loading parameter at the jump, ``speed`` the smallest belt
    speed in m/s with this friction.

    Notes
    -----
    Source: (8)–(11), with the loading parameter at the jump; for friction by a larger μ₀, or a
    higher speed of the belt. The motion starts at rest. The coordinate that moves most is at a
    hundredth of the distance from the fold to the remaining state, and the others are in balance.
    """
    load, at = study.loading, _moving(study, value, speed)
    if at is None:
        return None
    p = study.operating_point
    path = quasi_static_path(p, load.name, [study.start(), value + 1e-6 * abs(value) + 1e-9])
    if not path.jumps or not path.jumps[0].after:
        return None
    turn = path.jumps[0]
    begin, end = (
        np.array([where[name] for name in p.model.coordinates])
        for where in (turn.before, turn.after)
    )
    held = int(np.abs(end - begin).argmax())
    balances = balances_of(p.model)
    balance = balances[number_of(balances, turn.touching)]
    on_fold = p.replace(**{load.name: value})
    start = _balanced(balance, on_fold, begin + SHARE_BEYOND_FOLD * (end - begin), held)
    at_rest = np.concatenate([start, np.zeros(start.size)])
    # A longer motion is needed if the mass has not yet covered half the distance.
    for times in (1500.0, 24_000.0):
        t_end = times * System.of(at, None).scales(at_rest).time
        try:
            motion = simulate(at, start=at_rest, t_end=t_end)
            comes_to = motion.outcome(0.5 * t_end).regime
        except ConvergenceError:
            return None
        if np.abs(motion.state[held] - begin[held]).max() > 0.5 * abs(end[held] - begin[held]):
            break
    else:
        return None
    course = motion(np.union1d(motion.t, np.linspace(0.0, motion.t[-1], 60_000)))
    springs, contact = _forces(study, _extremes(at, course))
    ranges = {}
    for name, row in zip(p.model.coordinates, course[: start.size], strict=True):
        unit, size = unit_of(study, name)
        ranges[f"{name}_{unit}"] = size * float(row.min()), size * float(row.max())
    return JumpPeak(
        at=study.displayed(value),
        before=in_units(study, turn.before),
        after=in_units(study, turn.after),
        ranges=ranges,
        spring_force_N=springs,
        contact_force_N=contact,
        lifts_off=_opens(contact),
        settles=comes_to.attractor or "unsettled",
        followed_s=float(motion.t[-1] * study.scales.time),
    )


def _moving(study: Study, value: float, speed: float) -> ParameterSet | None:
    """Parameters of the motion at the jump; None if the friction law is not known or does not reach
    the friction of the jump.
    """
    p, law = study.dimensionless, study.kind.law
    if not study.moves or (study.slides and study.law != "friction_at_speed"):
        return None
    if not study.of_friction:
        return p.replace(**{study.loading.name: value})
    name, jump = study.loading.name, study.displayed(value)
    at = p.replace(**{name: 1.0})
    if jump > study.friction[2]:
        if math.isnan(speed):
            return None
        at = at.replace(**{law["belt"]: speed * study.scales.time / study.scales.length})
    # The friction is proportional to this parameter.
    return at.replace(**{name: jump / float(p.model.friction(at, contact=law["name"]))})


def _balanced(balance: Balance, p: ParameterSet, position: FloatArray, held: int) -> FloatArray:
    """A position (n,) at which the forces on all coordinates except ``held`` are balanced, by
    Newton's method from ``position``.
    """
    values = balance.floats(np.array(p.scalars(*balance.parameters)))
    free, q = np.delete(np.arange(position.size), held), position.copy()
    for _ in range(20):
        at = balance.at(list(q), values, xp=np)
        stiffness = np.array(at.stiffness(), dtype=float)[np.ix_(free, free)]
        q[free] -= np.linalg.solve(stiffness, np.array(at.rows("forces"), dtype=float)[free])
    return q


def oscillation_of(study: Study, stability: str | None, holds: bool) -> Oscillation:
    """The stable cycle that the motion reaches from rest or from far out; else the other kind of
    motion from rest.

    ``stability`` is that of the brake's state, None if unknown; ``holds``: it is not unstable.
    """
    p, (unit, size) = study.dimensionless, unit_of(study)
    n = len(p.model.coordinates)
    beside = {"stable": True, "unstable": False}.get(stability or "")
    rest, far = np.zeros((2, 2 * n))
    # First two coordinates of a start far out, in units of the motion.
    far_out = (1.5, 0.5)[:n]
    far[: len(far_out)] = far_out * System.of(p, None).scales(rest).states[: len(far_out)]
    followed = {}
    for word, start in (("rest", rest), ("far out", far)):
        with suppress(ConvergenceError):
            followed[word] = motion, outcome = _followed(p, start)
            found = _cycle_of(p, start, outcome)
            if found is not None and found.stable:
                frequency = 1 / (found.period * study.scales.time)
                force_ranges = _forces(study, found.forces)
                return Oscillation(
                    "cycle",
                    frequency,
                    found.amplitude * size,
                    unit,
                    *force_ranges,
                    beside,
                    word,
                    found,
                )
    word = "rest"
    motion, outcome = followed.get(word) or _followed(p, rest)
    if stability == "unstable" and not motion.state.any():  # it started at an unstable state
        word = "far out"
        motion, outcome = followed.get(word) or _followed(p, far)
    t_end = float(motion.t[-1])
    late, regime = motion.after(0.75 * t_end), outcome.regime
    quarters = (
        (motion.t >= share * t_end) & (motion.t <= (share + 0.25) * t_end) for share in (0.5, 0.75)
    )
    before, now = (float(np.ptp(motion.state[0, quarter])) for quarter in quarters)
    trend = "motion" if now else "rest"
    if holds and now < 0.99 * before:
        trend = "falls"
    elif now > 2.0 * before:
        trend = "grows"
    kind = (regime.attractor or trend).replace("cycle", "motion")
    goes_on = 1.0 if kind == "motion" else math.nan
    force_ranges = _forces(study, _extremes(p, late.state), goes_on)
    lives = beside if kind == "motion" else None
    return Oscillation(
        kind, math.nan, goes_on * 0.5 * now * size, unit, *force_ranges, lives, word, late
    )


def _followed(p: ParameterSet, start: FloatArray) -> tuple[Trajectory, Outcome]:
    """The motion from a state, and its limit."""
    t_end = 3000.0 * System.of(p, None).scales(start).time  # some hundred periods
    motion, outcome = simulate(p, start=start, t_end=t_end), Outcome()
    with suppress(ConvergenceError):
        outcome = motion.outcome(0.75 * t_end)
    return motion, outcome


def _cycle_of(p: ParameterSet, start: FloatArray, outcome: Outcome) -> Cycle | None:
    """The cycle that a motion approaches, or near which it is; None if its limit is no cycle."""
    if outcome.limit == Regime.LIMIT_CYCLE:
        return cycle_at(System.of(p, None), np.array(outcome.cycle), outcome.period)
    return cycle(p, near=start, patient=False) if outcome.limit == Regime.UNSETTLED else None
