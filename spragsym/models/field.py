"""Vector field of a model: second order in time, smooth in each mode, for integrators and periodic
orbits.

A mode is a tuple of numbers (pushing…, side…, near…). ``pushing`` is the contact indicator of every
contact, 1 in contact and 0 without. ``side`` is the sign of every friction's sliding speed, 0 while
it sticks. ``near`` is, for every exponential of a friction law, 1 where it is evaluated and 0 where
it is neglected. Generated functions take the numbers of the mode, and :class:`Border` objects say
where it changes.
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

from ..core.errors import ParameterError
from ..core.remarks import At, Remark
from ..display import Column
from ..generated.transition import displaces, lacks
from ..numerics.arithmetic import Number
from ..numerics.vectors import WholeTurns, in_one_turn, magnitude, makes_turns
from .forces import forces_of, of_statics, presses_either, undecorated
from .parameters import FloatArray

if TYPE_CHECKING:
    from ..motion.scales import MotionScales
    from .model import Model

#: Message for an orbit on which the field jumps.
JUMPED = (
    "the orbit passes behind the end of a torsion spring, or through the anchor of a spring, "
    "where its force jumps: derivatives "
    "are not carried across a jump; simulate the motion, or look for another orbit"
)

#: Numbers that select a smooth piece of the field, such as (contact, side, near).
Mode: TypeAlias = tuple[int, ...]

#: State, its derivative, or values of parameters: numbers of any type in order.
Vector: TypeAlias = Sequence[Any]

#: Values of a field's parameters in order, or the arguments that follow from them.
Values: TypeAlias = tuple[float, ...]

#: ``xp`` of single floats: Python's functions, and the sign function, for derivatives of |p| by a
#: parameter p.
FLOATS = SimpleNamespace(**vars(math), sign=np.sign)

#: A mode is left this far beyond its border, in units of the border's level. It prevents chatter
#: from rounding, at an error of the order of its square. Motions are integrated in their own units
#: (``spragsym.motion.scales``), so that tolerances are relative to 1.
OVERSHOOT = 1e-12

#: Hysteresis, in the exponent, between neglecting an exponential of the friction law and evaluating
#: it again.
HYSTERESIS = 5.0


#: A motion has settled at a distance from its limit of this share of its range; at rest, of its
#: unit of length.
SETTLED_SHARE = 1e-4

#: Periodic orbits neglect exponentials of the friction law below exp(−this), far below rounding.
FELT_EXPONENT = 42.0


@dataclass(frozen=True)
class Border:
    """Border of modes: a mode ends at a zero of ``level``.

    Attributes
    ----------
    name : str
    level : callable
        ``level(state, constants, mode)``, algebra of any number type.
    rate : callable
        ``rate(state, accelerations, constants, mode)``: the time derivative of the level.
    sign : callable
        ``sign(mode)``: sign of the level inside a mode, 1 or −1; 0 if the border is none of this
        mode. It is a polynomial in the mode's numbers.
    beyond : callable
        ``beyond(mode, state, constants)``: the mode on the other side.
    kink : bool
        Whether the field has a kink there; False where two modes differ by less than rounding.
    crossings : tuple of str
        Names of crossings: to positive levels, to negative levels, and to a mode without this
        border.
    scale : float
        Factor that makes the level small beside the state, since the error of a Taylor method is
        relative to the largest component.
    jumps : callable or None
        ``jumps(state, constants)``: whether the field jumps where a motion crosses; None if never.
    slopes : callable or None
        ``slopes(state, constants, mode)``: derivatives of the level by the 2 n numbers of the state
        and the P parameters, for saltation matrices.
    stays : callable or None
        ``stays(state, constants, mode)``: not negative where a motion that reaches the border stays
        on it.
    place : int
        Index of the number of the mode that changes.
    contact : str
        The name of its contact, if there are several.
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
    """The motion of a model: q″ = acceleration(q, q′) for n coordinates, in each mode.

    The field is continuous across borders, except where a border ``jumps``.

    Attributes
    ----------
    name : str
        Unique to the model: the key of compiled integrators.
    coordinates : tuple of str, length n
    parameters : tuple of str, length P
        Parameters that can be varied.
    constants : callable
        ``constants(values)``: arguments of the functions below, from values of the parameters; of
        fixed length. With ``xp`` as a second argument, from numbers other than floats.
    acceleration, jacobian, by_parameters : callable
        ``f(state, constants, mode, xp)``: n accelerations; n rows of derivatives by the 2 n numbers
        of the state; n rows of derivatives by the P parameters.
    borders : tuple of Border
    initial_mode : callable
        ``initial_mode(state, constants)``: the mode of a state; on a border either side.
    modes : tuple of Mode
        All modes.
    parameter_set : callable
        ``parameter_set(**values)``: the model's parameters, or an error for a value out of range.
    exact : callable
        ``exact(mode)``: the mode in which nothing is neglected, for proofs.
    regime : callable
        ``regime(mode)``: the numbers of a mode that the generated functions take, which select a
        smooth regime.
    forces : tuple of (str, callable)
        Name and ``f(states, constants)``, arrays: forces whose range over an orbit is reported.
    where : str
        The argument of :func:`spragsym.load` for the model, by which another process makes the
        field again; empty if there is none.
    torsion_sides : int
        Count of numbers at the end of a mode that depend on the position alone.
    faces : tuple of int
        Other indices in a mode that depend on the position alone: of contacts that press on either
        of two faces, and of all contacts if there are several, any of which may be open at rest.
    nonlinear_levels : bool
        Whether some level is no linear function of the state.
    periodic : WholeTurns
        Whole turns under which the field is invariant: by the index of an angle, the turns of each
        coordinate that go with one turn of it; and shifts, as of all that nothing ties to a place.
    model : Model or None
        The model, or None for a field without a page.
    airborne : callable or None
        ``airborne(constants, state)``: whether a motion stays above the belt forever; None if that
        is not known.
    units : tuple of str, length n
        Units of the coordinates. Coordinates of one unit share a scale; the scale of rad is 1.
    lengths : callable
        ``lengths(state, constants)``: undeformed lengths of springs.
    sized : callable or None
        ``sized(levels)``: the field whose borders are resolved in units of these levels.
    natural, scales : Field and Scales, or None
        For a field in units of a motion: the field in the model's units, and the scales.
    lead : int
        Index of the coordinate whose maxima separate the rounds of a motion.
    clock : callable or None
        ``clock(constants)``: the rate of the last coordinate, if that is the phase of a clock.
    friction_holds : callable
        ``friction_holds(state, constants)``: True if a friction that does not slide holds the
        state, or is at its limit, to which steady sliding comes as its belt stops.
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
    regime: Callable[[Mode], Mode] = tuple
    forces: tuple[tuple[str, Callable[..., Any]], ...] = ()
    where: str = ""
    torsion_sides: int = 0
    faces: tuple[int, ...] = ()
    nonlinear_levels: bool = False
    periodic: WholeTurns = field(default_factory=WholeTurns, hash=False)
    model: Any = None
    airborne: Callable[[Values, FloatArray], bool] | None = None
    units: tuple[str, ...] = ()
    lengths: Callable[[Sequence[float], Values], Sequence[float]] = lambda *_: ()
    sized: Callable[[tuple[float, ...]], Field] | None = None
    natural: Field | None = None
    scales: MotionScales | None = None
    lead: int = 0
    clock: Callable[[Values], float] | None = None
    friction_holds: Callable[..., bool] = lambda *_: False

    def with_lead(self, lead: int) -> Field:
        """The field whose rounds are separated by another coordinate."""
        if lead == self.lead:
            return self
        natural = self.natural.with_lead(lead) if self.natural else None
        return replace(self, lead=lead, natural=natural)

    def mode_at_rest(self, state: Vector, constants: Vector) -> Mode:
        """The first mode, with the numbers that depend on the position alone taken from the
        state.
        """
        first = self.modes[0]
        if not (self.torsion_sides or self.faces):
            return first
        own, last = self.initial_mode(state, constants), len(first) - self.torsion_sides
        by_position = {*self.faces, *range(last, len(first))}
        return tuple(own[k] if k in by_position else number for k, number in enumerate(first))

    def at_rest(self, position: Sequence[float], constants: Values) -> tuple[float, ...]:
        """The state at a position without speeds; a clock has the phase 0 and its own rate."""
        still = (*position, *(0.0,) * (self.size - len(position)))
        return (*still[:-1], self.clock(constants)) if self.clock else still

    def resting_mode(self, position: Sequence[float], constants: Values) -> Mode:
        """The mode of a state without speeds. Friction holds there what does not slide at all: what
        a belt carries along moves, however slowly.
        """
        state = (*position, *(0.0,) * (self.size - len(position)))
        mode = self.initial_mode(state, constants)
        for border in self.stays(mode):
            if slides := border.level(state, constants, mode):
                mode = (*mode[: border.place], 2 * (slides > 0) - 1, *mode[border.place + 1 :])
        return mode

    @property
    def marker(self) -> int | None:
        """Index of the coordinate whose whole turns mark the rounds of a motion: the phase of a
        clock, or a leading angle; None if neither makes turns.
        """
        index = len(self.coordinates) - 1 if self.clock else self.lead
        return index if makes_turns(index, self.periodic) else None

    @cached_property
    def sticking_borders(self) -> tuple[Border, ...]:
        """Borders on which a motion may stay, as where friction sticks."""
        return tuple(border for border in self.borders if border.stays)

    def stays(self, mode: Mode) -> tuple[Border, ...]:
        """Borders on which a state stays in this mode."""
        return tuple(border for border in self.sticking_borders if not border.sign(mode))

    def entered(self, slot: int, mode: Mode, after: Mode) -> int:
        """Index of the border at which a friction, number ``slot`` of a mode, comes to another:
        its sliding speed, or the limit of its force in the direction of its slip.
        """
        rows = [row for row, border in enumerate(self.borders) if border.place == slot]
        slip, *limits = rows
        return slip if mode[slot] else limits[after[slot] < 0]

    def check(self, name: str, value: float) -> None:
        """Raise ParameterError if a parameter may not have this value."""
        self.parameter_set(**{name: value})

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the numbers in a state: the coordinates, then their rates as pages call them."""
        return (*self.coordinates, *(f"v{name}" for name in self.coordinates))

    @property
    def time(self) -> float:
        """The unit of time, in that of the model."""
        return self.scales.time if self.scales else 1.0

    def column(self, name: str) -> Column:
        """The column of a parameter or coordinate; a plain number without a model."""
        return Column(name) if self.model is None else self.model.column(name)

    def place(self, state: Sequence[float] | FloatArray, digits: str) -> Remark:
        """The coordinates of a state, without whole turns, as text."""
        values = in_one_turn(state, self.periodic)
        parts = [
            At(name, (float(value),), digits, "rad" * self.column(name).is_angle)
            for name, value in zip(self.coordinates, values, strict=False)
        ]
        return Remark(", ".join(["{}"] * len(parts)), *parts)

    @property
    def size(self) -> int:
        """Count of numbers in a state, 2 n."""
        return 2 * len(self.coordinates)

    @property
    def deviations(self) -> int:
        """Count of numbers, the first ones of a state, in which motions may differ; the rate of a
        clock is given.
        """
        return self.size - bool(self.clock)

    def rates(
        self, state: Vector, constants: Vector, mode: Mode, xp: object = FLOATS
    ) -> FloatArray:
        """The time derivative of a state."""
        speeds = state[len(self.coordinates) :]
        return np.array([*speeds, *self.acceleration(state, constants, mode, xp)], dtype=float)

    def level_rate(self, border: Border, state: Vector, constants: Vector, mode: Mode) -> float:
        """The time derivative of a border's level in a mode."""
        pulls = self.acceleration(state, constants, mode, FLOATS)
        return float(border.rate(state, pulls, constants, mode))

    def matrix(
        self, state: Vector, constants: Vector, mode: Mode, xp: object = FLOATS
    ) -> FloatArray:
        """The Jacobian of the rates by the state, shape (2 n, 2 n)."""
        n = len(self.coordinates)
        by_state = np.array(self.jacobian(state, constants, mode, xp), dtype=float)
        return np.vstack([np.eye(n, 2 * n, n), by_state])


@cache
def field_of(model: Model, reach: float, levels: tuple[float, ...] = ()) -> Field:
    """The field of a model that neglects exponentials below exp(−reach).

    Its borders are resolved in units of their ``levels``, by default 1.
    """
    motion = _Motion(model, reach, levels)
    field = Field(
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
        regime=motion.regime,
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
        friction_holds=motion.friction_holds,
    )
    return replace(
        field, periodic=WholeTurns(model.whole_turns, shifts_of(field, model.whole_turns))
    )


def shifts_of(field: Field, turns: WholeTurns) -> FloatArray:
    """Directions along which every state of a field may be shifted, orthonormal rows, (r, 2 n); not
    along angles that make whole ``turns``, after each of which a motion closes as it is.

    They are seen at two states with parameters drawn at random: neither accelerations nor levels of
    borders change along them, in any mode. A page that excludes all of these has none.
    """
    n, rng = len(field.coordinates), np.random.default_rng(0)
    none = np.zeros((0, field.size))
    found = np.eye(n)[[index for index in range(n) if not makes_turns(index, turns)]]
    try:
        constants = field.constants(tuple(rng.uniform(0.4, 1.6, len(field.parameters)).tolist()))
        states = rng.uniform(-1.0, 1.0, (2, field.size))
        for mode, state in itertools.product(field.modes, states.tolist()):
            slopes = np.array(field.jacobian(state, constants, mode, FLOATS), dtype=float)[:, :n]
            _, sizes, rows = np.linalg.svd(slopes @ found.T)
            rank = int((sizes > 1e-12 * max(1.0, magnitude(slopes))).sum())
            found = rows[rank:] @ found
            if not len(found):
                return none
        shifts = np.hstack([found, np.zeros((len(found), n))])
        for mode, border, shift in itertools.product(field.modes, field.borders, shifts):
            before, after = (
                border.level(state.tolist(), constants, mode)
                for state in (states[0], states[0] + shift)
            )
            if abs(after - before) > 1e-12 * (1 + abs(before)):
                return none
    except (ArithmeticError, ValueError, np.linalg.LinAlgError):
        return none
    return shifts


def exact_field(where: str) -> Field:
    """The field of a model by its name, for proofs; ParameterError if proofs do not cover the
    model.
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
    """The functions of a field, from the generated functions of a model.

    If a contact law has a root, as Hertz's, and a coordinate is the gap, a motion is stopped at
    each extremum of it. Where the mass just touches, the depth is like (t − t_0)² and its power 3/2
    like |t − t_0|³. The Taylor series from t < t_0 is that of −(t − t_0)³, and beyond t_0 nothing
    shows that it is wrong. So a step ends at t_0.
    """

    def __init__(self, model: Model, reach: float, levels: tuple[float, ...] = ()) -> None:
        about = model.about
        self.model, self.reach, self.contacts = model, reach, model.contacts
        self.layers, self.torsions = about["layers"], len(about["torsions"])
        #: For each friction, whether it can stick; a model without friction has one entry.
        self.holds = [entry["holds"] for entry in model.frictions] or [False]
        self.sides = [(1, -1, 0) if holds else (1, -1) for holds in self.holds]
        #: Frictions that can stick, in the order of the rows of generated functions.
        self.holding = [index for index, holds in enumerate(self.holds) if holds]
        self.rooted = [not entry["polynomial"] for entry in self.contacts]
        #: Contacts whose gap is a coordinate, at each extremum of which a motion is stopped.
        self.turns = [
            contact
            for contact, entry in enumerate(self.contacts)
            if self.rooted[contact] and entry["unilateral"] and entry["gap"] in model.coordinates
        ]
        #: Contacts that press on either of two faces: indices of numbers of the mode that depend on
        #: the position alone.
        self.faces = tuple(
            contact for contact, entry in enumerate(self.contacts) if presses_either(entry)
        )
        rows = itertools.chain(levels, itertools.repeat(1.0))
        sizes = [1.0 if entry["border"] is None else next(rows) for entry in self.contacts]
        #: A law that is no polynomial is left this far before its border, beyond which it may have
        #: no value.
        self.shifts = [
            2 * OVERSHOOT * size * rooted for size, rooted in zip(sizes, self.rooted, strict=True)
        ]
        #: Sliding speeds up to this count as 0 where friction sticks.
        self.still = list[float]()
        for holds in self.holds:
            size, *_ = itertools.islice(rows, 3 if holds else 1)
            self.still.append(2 * OVERSHOOT * size)
        #: Indices in a mode of the first side, the first exponential of a friction law, the first
        #: extremum of a gap, and the first torsion spring.
        self.side = len(self.contacts)
        self.near = self.side + len(self.holds)
        self.turn = self.near + self.layers
        self.way = self.turn + len(self.turns)

    def constants(self, values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
        """Arguments of the functions, from values of the parameters."""
        # NumPy on single numbers: in arrays the last bit depends on the position.
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
        """A generated function as ``f(state, constants, mode, xp)``; it gets the numbers of the
        mode that it takes.
        """
        plain = undecorated(getattr(self.model.algebra, name))
        rooted = any(self.rooted)

        def call(state: Vector, constants: Vector, mode: Sequence[Any], xp: object) -> list[Any]:
            return plain(*state, *constants, *self.regime(mode), xp=_Rooted(xp) if rooted else xp)

        return call

    def regime(self, mode: Sequence[Any]) -> tuple[Any, ...]:
        """The numbers of a mode that generated functions take: all but those of extrema."""
        return *mode[: self.turn], *mode[self.way :]

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
        # With a law that is no polynomial, the border itself is without contact.
        pushing = (
            1 * (gap <= -shift) if entry["border"] else 1
            for gap, shift, entry in zip(gaps, self.shifts, self.contacts, strict=True)
        )
        mode = *pushing, *sides, *near, *turn, *torsion_sides
        still = self._still(levels)
        return self._settled(mode, state, constants, still) if still else mode

    def friction_holds(self, state: Vector, constants: Vector) -> bool:
        """Whether friction holds a state, see :class:`Field`, up to rounding."""
        still = self._still(undecorated(self.model.algebra.borders)(*state, *constants))
        if not still:
            return False
        mode, rounding = self.initial_mode(state, constants), 1e-9
        margins = self.in_mode("grip")(state, constants, mode, FLOATS)
        rows = (2 * self.holding.index(index) for index in still)
        pairs = ((min(margins[row : row + 2]), sum(margins[row : row + 2])) for row in rows)
        return any(least >= -rounding * width and width > 0 for least, width in pairs)

    def _still(self, levels: Vector) -> list[int]:
        """Indices of the frictions that hold and do not slide, by the levels of all borders."""
        slips = levels[self.side :]
        return [index for index in self.holding if abs(slips[index]) <= self.still[index]]

    def held(
        self,
        mode: Mode,
        state: Vector,
        constants: Vector,
        come: Sequence[int] = (),
        before: Mode | None = None,
    ) -> Mode:
        """The mode after frictions have ``come`` to a border, or after forces have jumped.

        ``mode`` has the new numbers of all else; ``before`` is the mode until then, by default
        this one. Frictions that stick or hardly slide may start or stop sticking together with
        those that came.
        """
        slips = undecorated(self.model.algebra.borders)(*state, *constants)[self.side :]
        chosen = [
            index
            for index in self.holding
            if index in come
            or not mode[self.side + index]
            or abs(slips[index]) <= self.still[index]
        ]
        return self._settled(mode, state, constants, chosen, before or mode)

    def _settled(
        self,
        mode: Mode,
        state: Vector,
        constants: Vector,
        chosen: Sequence[int],
        before: Mode | None = None,
    ) -> Mode:
        """The mode consistent with its own accelerations, among all sides of the chosen frictions.

        Where a static coefficient is above the kinetic one, several may be; the rule is
        :func:`~spragsym.generated.transition.displaces`. The mobility of frictions along
        independent displacements is positive definite, so that some mode is consistent, but for
        rounding.
        """
        if not chosen:
            return mode
        found: tuple[Mode, int, float] | None = None
        nearest: float | None = None
        every = itertools.product((0, 1, -1), repeat=len(chosen))
        for sides in sorted(every, key=lambda sides: sum(map(abs, sides))):
            slips = sum(map(abs, sides))
            if found and not found[2] and slips > found[1]:
                break
            own = list(mode)
            for index, side in zip(chosen, sides, strict=True):
                own[self.side + index] = side
            after = tuple(own)
            lack, change = self._lacking(after, state, constants, chosen), 0.0
            if found and not (lack or found[2]):  # only then are changes compared
                if nearest is None:
                    nearest = self._change(found[0], before, state, constants)
                change = self._change(after, before, state, constants)
            if found is None or displaces(slips, lack, change, found[1], found[2], nearest or 0.0):
                nearest = change if found and not found[2] else None
                found = after, slips, lack
        assert found
        return found[0]

    def _change(self, mode: Mode, before: Mode | None, state: Vector, constants: Vector) -> float:
        """ΔᵀM Δ of the change Δ of the accelerations from one mode to another."""
        rates = self.in_mode("regime_rhs")
        change = np.array(rates(state, constants, mode, FLOATS), dtype=float)
        if before is not None:
            change -= rates(state, constants, before, FLOATS)
        position = state[: len(self.model.coordinates)]
        mass = undecorated(self.model.algebra.mass_matrix)(*position, *constants)
        return float(change @ np.array(mass, dtype=float) @ change)

    def _lacking(
        self, mode: Mode, state: Vector, constants: Vector, chosen: Sequence[int]
    ) -> float:
        """The largest share of its limit that a chosen friction lacks for the mode to be
        consistent; 0 where it is.
        """
        margins = self.in_mode("grip")(state, constants, mode, FLOATS)
        rates = [0.0] * (self.side + len(self.holds))
        if any(mode[self.side + index] for index in chosen):
            pulls = self.in_mode("regime_rhs")(state, constants, mode, FLOATS)
            rates = undecorated(self.model.algebra.border_rates)(*state, *pulls, *constants)
        largest = 0.0
        for index in chosen:
            ahead, behind = margins[2 * self.holding.index(index) :][:2]
            place = self.side + index
            largest = max(largest, lacks(mode[place], ahead, behind, rates[place]))
        return largest

    def _grips(self, index: int) -> Callable[..., float]:
        """The function that gives the distance of a sticking friction's force from its nearer
        limit.
        """
        row, grip = 2 * self.holding.index(index), self.in_mode("grip")
        return lambda state, constants, mode: float(
            min(grip(state, constants, mode, FLOATS)[row : row + 2])
        )

    def _slips(self, row: int) -> Callable[..., Any]:
        """The function that gives derivatives of a sliding speed, or of the distance to a limit."""
        slopes = self.in_mode("grip_slopes")
        return lambda state, constants, mode: slopes(state, constants, mode, _namespace(state))[row]

    def clock(self, constants: Values) -> float:
        """The rate of the clock."""
        return float(undecorated(self.model.algebra.clock)(*constants))

    def lengths(self, state: Vector, constants: Values) -> list[float]:
        """Undeformed lengths of the springs; empty where the geometry has no value."""
        position = state[: len(self.model.coordinates)]
        geometry = undecorated(self.model.algebra.geometry)
        try:
            lines = geometry(*position, *of_statics(self.model, constants))
        except ArithmeticError:
            return []
        return [float(rest) for *_, rest in lines if rest]

    def _gap(self, contact: int) -> int:
        """Index of the coordinate that is the gap of a contact."""
        return self.model.coordinates.index(self.contacts[contact]["gap"])

    def _turning_waves(
        self, state: Vector, constants: Sequence[float]
    ) -> list[tuple[float, float]]:
        """Sine and cosine of the angle of every torsion spring."""
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
        for k in range(self.layers):  # an exponential of the friction law becomes negligible

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
            # The angle leaves its branch at π times the branch's sign, or at −0.93 times it, for
            # the other branch. Each branch is smooth beyond its ends. At ±π the least angle jumps,
            # and so does the torque.
            levels = self._generated("turning_borders", "turning_rates", k, slice(self.way, None))
            _, turned = _side(self.way + k, 0)

            def beyond(mode: Mode, *at: Any, turned: Callable[..., Mode] = turned) -> Mode:
                # The torque jumps, and with it the force that frictions have to hold.
                state, constants = at
                return self.held(turned(mode), state, constants, (), mode)

            def jumps(state: Vector, constants: Vector, k: int = k) -> bool:
                return bool(self._turning_waves(state, constants)[k][1] < 0)

            index = self.way + k
            yield Border(f"turning {k + 1}", *levels, lambda _: 1, beyond, jumps=jumps, place=index)

    def _lifting(self, contact: int, entry: Mapping[str, Any]) -> Border:
        """The border at which a contact opens and closes."""
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
            if all(mode[index] for index in rubbing):
                return after
            state, constants = at
            return self.held(after, state, constants, (), mode)

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
                slopes: Callable[..., Sequence[Any]] = slopes,
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
        """Level and rate of a border, as one row of two generated functions.

        ``taken`` are the numbers of the mode that these take, and ``shift`` is added to the level.
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
    """The name of a contact as a prefix, if it has one."""
    return f"{entry['name']}: " if entry["name"] else ""


def always(*_: Any) -> bool:
    """True: at some borders the field always jumps."""
    return True


def _side(index: int, both: int) -> tuple[Callable[[Any], Any], Callable[..., Mode]]:
    """``sign`` and ``beyond`` of a border at which number ``index`` of the mode changes to ``both``
    minus itself.
    """
    return (
        lambda mode: 1 - 2 * mode[index] if both else mode[index],
        lambda mode, *_: (*mode[:index], both - mode[index], *mode[index + 1 :]),
    )


class _Rooted:
    """A namespace whose root of a negative number is 0.

    Trial steps of integrators leave the contact and are rejected later.
    """

    def __init__(self, xp: Any) -> None:
        self._xp = xp

    def __getattr__(self, name: str) -> Any:
        return getattr(self._xp, name)

    def log(self, value: Number) -> Number:
        """Logarithm; −∞ of 0 and negative numbers, whose exponential is 0."""
        if isinstance(value, float):
            return math.log(value) if value > 0 else -math.inf
        if isinstance(value, np.ndarray):
            with np.errstate(divide="ignore"):
                return np.log(np.maximum(value, 0.0))
        return self._xp.log(value)

    def sqrt(self, value: Number) -> Number:
        """Square root of a float or an array, clipped at 0; expressions of heyoka are not
        clipped.
        """
        if isinstance(value, float | np.ndarray | np.floating):
            return self._xp.sqrt(np.maximum(value, 0.0))
        return self._xp.sqrt(value)


def _namespace(state: Vector) -> Any:
    """The namespace of functions for a state's numbers: that of the numbers themselves, or
    NumPy.
    """
    return getattr(state[0], "namespace", np)
