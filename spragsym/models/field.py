"""Vector field of a model for integrators and the search for cycles: of second order, smooth in
each of its modes.

Generated functions make it, over the modes (pushing…, side…, near…): ``pushing`` of every contact
is 1 in contact and 0 without, ``side`` of every friction the sign of the sliding speed, 0 where it
sticks, and ``near`` of every exponential of a friction law 1 where it is felt and 0 where it is
left out. What a model has not, as a contact that lifts, is no border.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, partial
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ..core.errors import ConvergenceError, ParameterError
from ..core.remarks import At, Remark
from ..display import Column
from ..numerics.arithmetic import Number
from ..numerics.vectors import WholeTurns, in_one_turn
from .forces import forces_of, of_statics, presses_either, undecorated
from .parameters import FloatArray

if TYPE_CHECKING:
    from ..motion.scales import MotionScales
    from .model import Model

#: What is said of an orbit on which the field jumps.
JUMPED = (
    "the orbit passes behind the end of a torsion spring, or through the anchor of a spring, "
    "where its force jumps: derivatives "
    "are not carried across a jump; simulate the motion, or look for another orbit"
)

#: Numbers that say which smooth piece of the field is meant, such as (contact, side, near).
Mode: TypeAlias = tuple[int, ...]

#: State, its derivative, or values of parameters: numbers of any type in order.
Vector: TypeAlias = Sequence[Any]

#: Values of a field's parameters in order, or of what its functions take for them.
Values: TypeAlias = tuple[float, ...]

#: ``xp`` of single floats: Python's functions, and the sign function, for derivatives of |p| by a
#: parameter p.
FLOATS = SimpleNamespace(**vars(math), sign=np.sign)

#: How far beyond its border a mode is left, in units of the border's level: it ends chatter by
#: rounding, and costs an error of the order of its square. Motions are carried in units of their
#: own (``spragsym.motion.scales``), and so are all tolerances that are numbers beside 1.
OVERSHOOT = 1e-12

#: How far apart an exponential of the friction law is left out and taken in again, in units of its
#: exponent.
HYSTERESIS = 5.0


#: A motion has settled when what is left to its limit is this share of its reach; for rest, of its
#: unit of length, which is 1 for motions of a common size.
SETTLED_SHARE = 1e-4

#: Minus the exponent beyond which the search for cycles leaves an exponential of the friction law
#: out: far below rounding.
FELT_EXPONENT = 42.0


@dataclass(frozen=True)
class Border:
    """Border at which a mode ends: at a zero of ``level``.

    Attributes
    ----------
    name : str
    level : callable
        ``level(state, constants, mode)``, algebra of any number type.
    rate : callable
        ``rate(state, accelerations, constants, mode)``: the derivative of the level in time.
    sign : callable
        ``sign(mode)``: of the level inside a mode, a polynomial in the mode's numbers: 1 or −1, or
        0 if it is no border of it.
    beyond : callable
        ``beyond(mode, state, constants)``: the mode on the other side.
    kink : bool
        Whether the field has a kink there; False where two modes differ by less than rounding.
    crossings : tuple of str
        What crossing it is called, to positive and to negative levels, and to a mode of which it is
        no border.
    scale : float
        What makes the level small beside the state: the error of a Taylor method is relative to the
        largest of all.
    jumps : callable or None
        ``jumps(state, constants)``: whether the field jumps where a motion leaves through the
        border; None where it never does.
    slopes : callable or None
        ``slopes(state, constants, mode)``: derivatives of the level by the 2 n numbers of the state
        and the P parameters, where derivatives of a motion are carried across a jump.
    stays : callable or None
        ``stays(state, constants, mode)``: not negative where a motion that comes to the border
        stays on it.
    place : int
        Which number of a mode it changes.
    contact : str
        The name of its contact, of several.
    """

    name: str
    level: Callable[..., Any]
    rate: Callable[..., Any]
    sign: Callable[[Any], Any]
    beyond: Callable[..., Mode]
    kink: bool = True
    crossings: tuple[str, ...] = ("", "")
    scale: float = 1e-3
    jumps: Callable[..., bool] | None = None
    slopes: Callable[..., Any] | None = None
    stays: Callable[..., float] | None = None
    place: int = 0
    contact: str = ""


@dataclass(frozen=True)
class Field:
    """A model's motion: n coordinates q, q″ = acceleration(q, q′) in each mode, continuous across
    the borders between modes but where a border ``jumps``.

    Attributes
    ----------
    name : str
        Unique to the model: compiled integrators are kept by it.
    coordinates : tuple of str, length n
    parameters : tuple of str, length P
        Those that can be varied.
    constants : callable
        ``constants(values)``: what the functions below take, from the values of the parameters; of
        a fixed length. With ``xp`` as a second argument from other numbers than floats.
    acceleration, jacobian, by_parameters : callable
        ``f(state, constants, mode, xp)``: n accelerations; n rows of derivatives by the 2 n numbers
        of the state; n rows of derivatives by the P parameters.
    borders : tuple of Border
    initial_mode : callable
        ``initial_mode(state, constants)``; on a border either side is right.
    modes : tuple of Mode
        All there are.
    parameter_set : callable
        ``parameter_set(**values)``: the model's parameters of these values, or an error where one
        may not have its value.
    exact : callable
        ``exact(mode)``: the mode without what is left out below rounding, for proofs.
    forces : tuple of (str, callable)
        Name and ``f(states, constants)``, arrays: forces whose range over an orbit is told.
    where : str
        What :func:`spragsym.load` takes for its model, by which it is made once more in another
        process; empty where none does.
    torsion_sides : int
        How many numbers at the end of a mode go with the place alone.
    faces : tuple of int
        Places in a mode that do too: of contacts that press on either of two faces, and of several
        contacts, any of which may be open at rest, of all.
    nonlinear_levels : bool
        Whether a level is no linear function of the state.
    periodic : mapping of int to mapping of int to int
        Turns after which all is as before: by the place of an angle that makes one, the turns of
        each that moves with it.
    model : Model or None
        Whose motion it is; None of one that is of no page.
    airborne : callable or None
        ``airborne(constants, state)``: whether a motion is above the belt for good; None where that
        is not known.
    units : tuple of str, length n
        Units of the coordinates: those of one unit have one scale, those in rad have the scale 1.
    lengths : callable
        ``lengths(state, constants)``: undeformed lengths of springs.
    sized : callable or None
        ``sized(levels)``: the field whose borders are resolved in units of their levels.
    natural, scales : Field and Scales, or None
        Of a field in units of a motion: the field in those of the model, and what they are.
    lead : int
        Place of the coordinate whose maxima mark the rounds of a motion.
    clock : callable or None
        ``clock(constants)``: the rate of the last coordinate, where that is the phase of a clock.
    """

    name: str
    coordinates: tuple[str, ...]
    parameters: tuple[str, ...]
    constants: Callable[..., Values]
    acceleration: Callable[..., Any]
    jacobian: Callable[..., Any]
    by_parameters: Callable[..., Any]
    borders: tuple[Border, ...]
    initial_mode: Callable[..., Mode]
    modes: tuple[Mode, ...]
    parameter_set: Callable[..., Any]
    exact: Callable[[Mode], Mode] = tuple
    forces: tuple[tuple[str, Callable[..., Any]], ...] = ()
    where: str = ""
    torsion_sides: int = 0
    faces: tuple[int, ...] = ()
    nonlinear_levels: bool = False
    periodic: WholeTurns = field(default_factory=dict, hash=False)
    model: Any = None
    airborne: Callable[[Values, FloatArray], bool] | None = None
    units: tuple[str, ...] = ()
    lengths: Callable[[Sequence[float], Values], Sequence[float]] = lambda *_: ()
    sized: Callable[[tuple[float, ...]], Field] | None = None
    natural: Field | None = None
    scales: MotionScales | None = None
    lead: int = 0
    clock: Callable[[Values], float] | None = None

    def with_lead(self, lead: int) -> Field:
        """The field with rounds marked by another coordinate."""
        if lead == self.lead:
            return self
        natural = self.natural.with_lead(lead) if self.natural else None
        return replace(self, lead=lead, natural=natural)

    def mode_at_rest(self, state: Vector, constants: Vector) -> Mode:
        """The first mode, but for the numbers that go with the place, which are as at the state."""
        first = self.modes[0]
        if not (self.torsion_sides or self.faces):
            return first
        here, last = self.initial_mode(state, constants), len(first) - self.torsion_sides
        with_place = {*self.faces, *range(last, len(first))}
        return tuple(here[k] if k in with_place else own for k, own in enumerate(first))

    def at_rest(self, position: Sequence[float], constants: Values) -> tuple[float, ...]:
        """The state without speeds at a place; that of a clock, which no place has, is at its
        phase 0 and has its rate.
        """
        still = (*position, *(0.0,) * (self.size - len(position)))
        return (*still[:-1], self.clock(constants)) if self.clock else still

    @cached_property
    def sticking_borders(self) -> tuple[Border, ...]:
        """The borders on which a motion may stay, as where friction holds."""
        return tuple(border for border in self.borders if border.stays)

    def stays(self, mode: Mode) -> tuple[Border, ...]:
        """Borders on which a state stays in a mode."""
        return tuple(border for border in self.sticking_borders if not border.sign(mode))

    def check(self, name: str, value: float) -> None:
        """An error where a parameter may not have a value."""
        self.parameter_set(**{name: value})

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the numbers in a state: the coordinates, then their rates as pages call them."""
        return (*self.coordinates, *(f"v{name}" for name in self.coordinates))

    @property
    def time(self) -> float:
        """The unit of its times, in that of the model."""
        return self.scales.time if self.scales else 1.0

    def column(self, name: str) -> Column:
        """The column of a parameter or a coordinate; without a model a plain number."""
        return Column(name) if self.model is None else self.model.column(name)

    def place(self, state: Sequence[float] | FloatArray, digits: str) -> Remark:
        """The coordinates of a state less whole turns, in words."""
        values = in_one_turn(state, self.periodic)
        parts = [
            At(name, (float(value),), digits, "rad" * self.column(name).is_angle)
            for name, value in zip(self.coordinates, values, strict=False)
        ]
        return Remark(", ".join(["{}"] * len(parts)), *parts)

    @property
    def size(self) -> int:
        """Numbers in a state."""
        return 2 * len(self.coordinates)

    @property
    def deviations(self) -> int:
        """Numbers of a state by which motions may differ, the first ones: the last is the rate of a
        clock, which is given.
        """
        return self.size - bool(self.clock)

    def rates(
        self, state: Vector, constants: Vector, mode: Mode, xp: object = FLOATS
    ) -> FloatArray:
        """The rates of all numbers of a state."""
        speeds = state[len(self.coordinates) :]
        return np.array([*speeds, *self.acceleration(state, constants, mode, xp)], dtype=float)

    def level_rate(self, border: Border, state: Vector, constants: Vector, mode: Mode) -> float:
        """The rate of a border's level in a mode."""
        pulls = self.acceleration(state, constants, mode, FLOATS)
        return float(border.rate(state, pulls, constants, mode))

    def matrix(
        self, state: Vector, constants: Vector, mode: Mode, xp: object = FLOATS
    ) -> FloatArray:
        """The derivative of the rates of all numbers of a state by these: the linearized motion at
        an equilibrium.
        """
        n = len(self.coordinates)
        return np.vstack(
            [np.eye(n, 2 * n, n), np.array(self.jacobian(state, constants, mode, xp), dtype=float)]
        )


@cache
def field_of(model: Model, reach: float, levels: tuple[float, ...] = ()) -> Field:
    """The field whose exponentials are left out where they are below exp(−reach), and whose borders
    are resolved in units of their ``levels``, by default 1.
    """
    motion = _Motion(model, reach, levels)
    return Field(
        f"{model.where}:{model.about['source']}:{reach!r}",
        model.coordinates,
        model.parameters,
        motion.constants,
        motion.in_mode("regime_rhs"),
        motion.in_mode("regime_jacobian"),
        motion.in_mode("regime_by_parameters"),
        tuple(motion.borders()),
        motion.initial_mode,
        tuple(
            itertools.product(
                *((1, 0),) * len(motion.contacts),
                *motion.sides,
                *((1, 0),) * motion.layers,
                *((1, -1),) * (len(motion.turns) + motion.torsions),
            )
        ),
        model.Parameters,
        lambda mode: (*mode[: motion.near], *(1,) * motion.layers, *mode[motion.turn :]),
        where=model.where,
        torsion_sides=motion.torsions,
        faces=motion.faces
        if len(motion.contacts) == 1
        else tuple(k for k, entry in enumerate(motion.contacts) if entry["border"]),
        forces=tuple(forces_of(model).items()),
        nonlinear_levels=model.about.get("curved", False),
        periodic=model.whole_turns,
        model=model,
        airborne=model.closed_form("airborne"),
        units=tuple(entry["unit"] for entry in model.about["coordinates"]),
        lengths=motion.lengths,
        sized=partial(field_of, model, reach),
        clock=motion.clock if model.clock else None,
    )


def exact_field(where: str) -> Field:
    """The field of a model by the name that loads it, for proofs: its contact laws have to be
    polynomials.
    """
    from .load import load

    model = load(where)
    for contact in model.contacts:
        if not contact["polynomial"]:
            raise ParameterError(
                f"the contact law{contact['name'] and ' of '}{contact['name']} is no polynomial: "
                "it has no continuation beyond its border, which proofs need"
            )
    if model.field.sticking_borders:
        raise ParameterError(
            "friction holds the mass where nothing slides, and proofs of cycles do not take "
            "in that it sticks"
        )
    if model.about.get("waves"):
        raise ParameterError(
            "cosines of coordinates stand in the equations of motion, which proofs of cycles "
            "do not take in"
        )
    if model.about["torsions"]:
        raise ParameterError(
            "the turning of a torsion spring is an arc tangent of the place, which proofs of "
            "cycles do not take in"
        )
    return model.field


class _Motion:
    """The functions of a field, from those that were generated for a model.

    Where the law of contact has a root, as Hertz's, and a coordinate is the gap, a motion is
    stopped at each turn of it. Where the mass only just touches, the depth goes with (t − t_0)² and
    its power 3/2 with |t − t_0|³. Before t_0 the series is that of −(t − t_0)³, which nothing shows
    to be wrong beyond: so a step ends at t_0.
    """

    def __init__(self, model: Model, reach: float, levels: tuple[float, ...] = ()) -> None:
        about = model.about
        self.model, self.reach, self.contacts = model, reach, model.contacts
        self.layers, self.torsions = about["layers"], len(about["torsions"])
        #: Of each friction whether it holds; of a model without any one number of the mode is left.
        self.holds = [entry["holds"] for entry in model.frictions] or [False]
        self.sides = [(1, -1, 0) if holds else (1, -1) for holds in self.holds]
        #: Frictions that hold, in the order of what is generated of them.
        self.holding = [index for index, holds in enumerate(self.holds) if holds]
        self.rooted = [not entry["polynomial"] for entry in self.contacts]
        #: Contacts whose gap is a coordinate, at each turn of which a motion is stopped.
        self.turns = [
            contact
            for contact, entry in enumerate(self.contacts)
            if self.rooted[contact] and entry["unilateral"] and entry["gap"] in model.coordinates
        ]
        #: Contacts that press on either of two faces: places of what goes with the place alone.
        self.faces = tuple(
            contact for contact, entry in enumerate(self.contacts) if presses_either(entry)
        )
        rows = itertools.chain(levels, itertools.repeat(1.0))
        sizes = [1.0 if entry["border"] is None else next(rows) for entry in self.contacts]
        #: How far before its border a law that is no polynomial is left, for it may have no
        #: continuation beyond; and up to which sliding speeds nothing slides.
        self.shifts = [
            2 * OVERSHOOT * size * rooted for size, rooted in zip(sizes, self.rooted, strict=True)
        ]
        self.still = list[float]()
        for holds in self.holds:
            size, *_ = itertools.islice(rows, 3 if holds else 1)
            # Sliding speeds up to this are 0 where friction holds.
            standstill = 2 * OVERSHOOT
            self.still.append(standstill * size)
        #: Places in a mode of the first side, the first exponential of a friction law, the first
        #: turn of a gap, and the first torsion spring.
        self.side = len(self.contacts)
        self.near = self.side + len(self.holds)
        self.turn = self.near + self.layers
        self.way = self.turn + len(self.turns)

    def constants(self, values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
        """Arguments of the functions, from values of the parameters."""
        # Of NumPy by one number at a time, so that no bit depends on where it stands in an array.
        cos, sin = (
            (xp.cos, xp.sin)
            if xp is not None
            else (lambda v: float(np.cos(v)), lambda v: float(np.sin(v)))
        )
        arguments = dict(zip(self.model.parameters, values, strict=True))
        for angle, names in self.model.about["angles"].items():
            arguments |= zip(names, (cos(arguments[angle]), sin(arguments[angle])), strict=True)
        return tuple(arguments[name] for name in self.model.about["arguments"]["motion"])

    def in_mode(self, name: str) -> Callable[..., Any]:
        """A generated function of the state, the constants and the numbers of the mode that it
        takes.
        """
        plain = undecorated(getattr(self.model.algebra, name))
        turn, way, rooted = self.turn, self.way, any(self.rooted)

        def call(state: Vector, constants: Vector, mode: Sequence[Any], xp: object) -> list[Any]:
            return plain(
                *state, *constants, *mode[:turn], *mode[way:], xp=_Rooted(xp) if rooted else xp
            )

        return call

    def initial_mode(self, state: Vector, constants: Vector) -> Mode:
        """The mode of a state."""
        algebra, n = self.model.algebra, len(self.model.coordinates)
        levels = undecorated(algebra.borders)(*state, *constants)
        gaps, slips = levels[: self.side], levels[self.side :]
        sides = [2 * (slip >= 0) - 1 for slip in slips]
        near = (
            1 * (depth <= self.reach)
            for depth in undecorated(algebra.layers)(*state, *constants, *sides)
        )
        turn = [2 * (state[n + self._gap(contact)] >= 0) - 1 for contact in self.turns]
        torsion_sides = (2 * (sine >= 0) - 1 for sine, _ in self._turning_waves(state, constants))
        # A law that is no polynomial begins without contact on the border itself.
        pushing = (
            1 * (gap <= -shift) if entry["border"] else 1
            for gap, shift, entry in zip(gaps, self.shifts, self.contacts, strict=True)
        )
        mode = *pushing, *sides, *near, *turn, *torsion_sides
        still = [index for index in self.holding if abs(slips[index]) <= self.still[index]]
        return self._settled(mode, state, constants, still) if still else mode

    def held(self, mode: Mode, state: Vector, constants: Vector, come: Sequence[int] = ()) -> Mode:
        """The mode in which a motion goes on where frictions have ``come`` to a border: what sticks
        and what hardly slides may begin and end to stick with them.
        """
        slips = undecorated(self.model.algebra.borders)(*state, *constants)[self.side :]
        chosen = [
            index
            for index in self.holding
            if index in come
            or not mode[self.side + index]
            or abs(slips[index]) <= self.still[index]
        ]
        return self._settled(mode, state, constants, chosen)

    def _settled(self, mode: Mode, state: Vector, constants: Vector, chosen: Sequence[int]) -> Mode:
        """The mode, over sides of the chosen frictions, that agrees with its own accelerations; of
        those that do the one in which most stick. An error where none does, or several that are no
        part of one.
        """
        found: list[tuple[set[int], Mode]] = []
        every = itertools.product((0, 1, -1), repeat=len(chosen))
        for sides in sorted(every, key=lambda sides: sum(map(abs, sides))):
            own = dict(zip(chosen, sides, strict=True))
            stuck = {index for index in chosen if not own[index]}
            after = tuple(
                own.get(index - self.side, number) if self.side <= index < self.near else number
                for index, number in enumerate(mode)
            )
            if any(stuck < others for others, _ in found):
                continue
            if self._agrees(after, state, constants, chosen):
                found.append((stuck, after))
        if len(found) == 1:
            return found[0][1]
        names = ", ".join(self.model.frictions[index]["name"] for index in chosen)
        several = f"{len(found)} ways to go on" if found else "no way to go on"
        raise ConvergenceError(
            f"where the frictions {names} stick or slip at one instant, dry friction leaves "
            f"{several} (Painlevé's paradox); change a parameter or the start by some thousandths"
        )

    def _agrees(self, mode: Mode, state: Vector, constants: Vector, chosen: Sequence[int]) -> bool:
        """Whether each chosen friction that sticks is within its limits, and each that slips can't
        stick, or is driven the way it slips.
        """
        margins = self.in_mode("grip")(state, constants, mode, FLOATS)
        for index in chosen:
            side, row = mode[self.side + index], 2 * self.holding.index(index)
            ahead, behind = margins[row : row + 2]
            sticks = min(ahead, behind) >= 0 < max(ahead, behind)  # in lift-off these are −F and F
            if side == (0 if sticks else 1 if ahead < behind else -1):
                continue
            if not (sticks and side * self._slip_rate(index, mode, state, constants) > 0):
                return False
        return True

    def _slip_rate(self, index: int, mode: Mode, state: Vector, constants: Vector) -> float:
        """Rate of change of a sliding speed in a mode."""
        pulls = self.in_mode("regime_rhs")(state, constants, mode, FLOATS)
        rates = undecorated(self.model.algebra.border_rates)(*state, *pulls, *constants)
        return float(rates[self.side + index])

    def _grips(self, index: int) -> Callable[..., float]:
        """Distance of the force of a friction that would hold the mass from its limits."""
        row, grip = 2 * self.holding.index(index), self.in_mode("grip")
        return lambda state, constants, mode: float(
            min(grip(state, constants, mode, FLOATS)[row : row + 2])
        )

    def _slips(self, row: int) -> Callable[..., Any]:
        """Derivatives of a sliding speed, or of how far its force is from a limit."""
        slopes = self.in_mode("grip_slopes")
        return lambda state, constants, mode: slopes(state, constants, mode, _namespace(state))[row]

    def clock(self, constants: Values) -> float:
        """The rate of the clock."""
        return float(undecorated(self.model.algebra.clock)(*constants))

    def lengths(self, state: Vector, constants: Values) -> list[float]:
        """Undeformed lengths of the springs along lines."""
        position = state[: len(self.model.coordinates)]
        geometry = undecorated(self.model.algebra.geometry)
        try:
            lines = geometry(*position, *of_statics(self.model, constants))
        except ArithmeticError:
            return []
        return [float(rest) for *_, rest in lines if rest]

    def _gap(self, contact: int) -> int:
        return self.model.coordinates.index(self.contacts[contact]["gap"])

    def _turning_waves(
        self, state: Vector, constants: Sequence[float]
    ) -> list[tuple[float, float]]:
        """Sine and cosine of every turning."""
        if not self.torsions:
            return []
        level = undecorated(self.model.algebra.turning_borders)
        forward, backward = (level(*state, *constants, *(way,) * self.torsions) for way in (1, -1))
        return [
            ((one - other) / 4, (one + other) / 2 - 1)
            for one, other in zip(forward, backward, strict=True)
        ]

    def borders(self) -> Iterator[Border]:
        """All borders between modes."""
        for contact, entry in enumerate(self.contacts):
            if entry["border"] is not None:
                yield self._lifting(contact, entry)
        for index, entry in enumerate(self.model.frictions):
            yield from self._sliding(index, entry)
        reach = self.reach
        for k in range(
            self.layers
        ):  # exponentials of the sliding speed, where they are about to be felt

            def shift(mode: Mode, index: int = self.near + k) -> Number:
                return -reach - HYSTERESIS * mode[index]

            sides = slice(self.side, self.near)
            levels = self._generated("layers", "layer_rates", k, sides, shift)
            yield Border(
                f"layer {k + 1}",
                *levels,
                *_side(self.near + k, 1),
                kink=False,
                scale=1e-3 / reach,
                place=self.near + k,
            )
        for k, contact in enumerate(self.turns):
            gap = self._gap(contact)
            rate = len(self.model.coordinates) + gap
            yield Border(
                f"{_said(self.contacts[contact])}gap' = 0",
                lambda state, *_, rate=rate: state[rate],
                lambda _, accelerations, *__, gap=gap: accelerations[gap],
                *_side(self.turn + k, 0),
                place=self.turn + k,
            )
        for k in range(self.torsions):
            # Where a turning comes to π times its way, or to −0.93 times it: from there the other
            # way counts it. Each way is smooth beyond its ends. At ±π the least turning jumps, and
            # so does the torque; a motion goes on the other way.
            levels = self._generated("turning_borders", "turning_rates", k, slice(self.way, None))
            _, beyond = _side(self.way + k, 0)

            def jumps(state: Vector, constants: Vector, k: int = k) -> bool:
                return bool(self._turning_waves(state, constants)[k][1] < 0)

            index = self.way + k
            yield Border(f"turning {k + 1}", *levels, lambda _: 1, beyond, jumps=jumps, place=index)

    def _lifting(self, contact: int, entry: Mapping[str, Any]) -> Border:
        """The border of a contact between its two regimes."""
        shift = self.shifts[contact]
        levels = self._generated("borders", "border_rates", contact, shift=lambda _: shift)
        sign, opened = _side(contact, 1)
        rubbing = [
            self.side + index
            for index in self.holding
            if self.model.frictions[index]["name"] == entry["name"]
        ]

        def lifted(mode: Mode, *at: Any) -> Mode:
            after = opened(mode)
            return after if all(mode[index] for index in rubbing) else self.held(after, *at)

        return Border(
            f"{_said(entry)}{entry['border']} = 0",
            *levels,
            sign,
            lifted,
            crossings=("face_left", "face_regained")
            if contact in self.faces
            else ("contact_lost", "contact_regained"),
            place=contact,
            contact=entry["name"],
        )

    def _sliding(self, friction: int, entry: Mapping[str, Any]) -> Iterator[Border]:
        """The border of a sliding speed; of friction that holds, the limits of its force too."""
        index, along, contact = self.side + friction, entry["along"], entry["name"]
        along = along if along.isidentifier() else f"({along})"
        slip = Border(
            f"{_said(entry)}{along}' = {entry['belt']}",
            *self._generated("borders", "border_rates", index),
            *_side(index, 0),
            crossings=("belt_overtakes", "mass_overtakes"),
            place=index,
            contact=contact,
        )
        if not entry["holds"]:
            yield slip
            return
        row = self.holding.index(friction)

        def held(mode: Mode, state: Vector, constants: Vector) -> Mode:
            return self.held(mode, state, constants, (friction,))

        yield replace(
            slip,
            beyond=held,
            crossings=(*slip.crossings, "stick"),
            jumps=always,
            slopes=self._slips(3 * row),
            stays=self._grips(friction),
        )
        for limit, way in enumerate(("with", "against")):
            slopes, margin = self._slips(3 * row + 1 + limit), 2 * row + limit

            def level(state: Vector, constants: Vector, mode: Mode, margin: int = margin) -> Number:
                return self.in_mode("grip")(state, constants, mode, _namespace(state))[margin]

            def rate(
                state: Vector,
                accelerations: Vector,
                constants: Vector,
                mode: Mode,
                slopes: Any = slopes,
            ) -> Number:
                changes = (*state[len(accelerations) :], *accelerations)
                return sum(
                    a * b for a, b in zip(slopes(state, constants, mode), changes, strict=False)
                )

            yield Border(
                f"{_said(entry)}friction at its limit {way} the belt",
                level,
                rate,
                lambda mode: 1 - mode[index] * mode[index],
                held,
                crossings=("", "", "slip"),
                jumps=always,
                slopes=slopes,
                place=index,
                contact=contact,
            )

    def _generated(
        self,
        level: str,
        rate: str,
        row: int,
        taken: slice = slice(0),
        shift: Callable[[Any], Any] | None = None,
    ) -> tuple[Callable[..., Any], Callable[..., Any]]:
        """Level and rate of a border: a row of two generated functions, which may take numbers of
        the mode too.
        """
        of_level, of_rate = (
            undecorated(getattr(self.model.algebra, name)) for name in (level, rate)
        )

        def level_of(state: Vector, constants: Vector, mode: Mode) -> Number:
            value = of_level(*state, *constants, *mode[taken], xp=_namespace(state))[row]
            return value + shift(mode) if shift else value

        def rate_of(state: Vector, accelerations: Vector, constants: Vector, mode: Mode) -> Number:
            return of_rate(*state, *accelerations, *constants, *mode[taken], xp=_namespace(state))[
                row
            ]

        return level_of, rate_of


def _said(entry: Mapping[str, Any]) -> str:
    """The contact before what is said of it, of several."""
    return f"{entry['name']}: " if entry["name"] else ""


def always(*_: Any) -> bool:
    """Of a border at which the field always jumps."""
    return True


def _side(index: int, both: int) -> tuple[Callable[[Any], Any], Callable[..., Mode]]:
    """Sign and other side of a border at which a number of the mode becomes the other one of two
    that add up to ``both``.
    """
    return (
        lambda mode: 1 - 2 * mode[index] if both else mode[index],
        lambda mode, *_: (*mode[:index], both - mode[index], *mode[index + 1 :]),
    )


class _Rooted:
    """A namespace whose root of a negative number is 0: trial steps leave the contact, and are
    rejected.
    """

    def __init__(self, xp: Any) -> None:
        self._xp = xp

    def __getattr__(self, name: str) -> Any:
        return getattr(self._xp, name)

    def log(self, value: Number) -> Number:
        """Logarithm, −∞ of 0, whose exponential is 0."""
        if isinstance(value, float):
            return math.log(value) if value > 0 else -math.inf
        if isinstance(value, np.ndarray):
            with np.errstate(divide="ignore"):
                return np.log(np.maximum(value, 0.0))
        return self._xp.log(value)

    def sqrt(self, value: Number) -> Number:
        """Square root of a float or an array; an expression of heyoka's is taken as it is."""
        if isinstance(value, float | np.ndarray | np.floating):
            return self._xp.sqrt(np.maximum(value, 0.0))
        return self._xp.sqrt(value)


def _namespace(state: Vector) -> Any:
    """Namespace of functions of a state's numbers: in NumPy, unless they say another namespace."""
    return getattr(state[0], "namespace", np)
