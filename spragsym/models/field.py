"""Vector field of a model for integrators and the search for cycles: of second order, smooth in
each of its modes.

Generated functions make it, over the modes (pushing, side, near…): ``pushing`` is 1 in contact and
0 without, ``side`` the sign of the sliding speed, and ``near`` of every exponential of the friction
law 1 where it is felt and 0 where it is left out. What a model has not, as a contact that lifts, is
no border.
"""

from __future__ import annotations

import inspect
import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ..core.errors import ParameterError
from ..display import Column
from . import forces
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

#: Values of a field's parameters in order, or of what its functions take for them.
Values: TypeAlias = tuple[float, ...]

#: ``xp`` of single floats: Python's functions, and the sign function, for derivatives of |p| by a
#: parameter p.
FLOATS = SimpleNamespace(**vars(math), sign=np.sign)

#: How far beyond its border a mode is left, in units of the border's level: it ends chatter by
#: rounding, and costs an error of the order of its square. Motions are carried in units of their
#: own (``spragsym.motion.scales``), and so are all tolerances that are numbers beside 1.
GAP = 1e-12

#: How far apart an exponential of the friction law is left out and taken in again, in units of its
#: exponent.
WIDTH = 5.0

#: Sliding speeds up to this are 0 where friction holds.
STILL = 2 * GAP

#: A motion has settled when what is left to its limit is this share of its reach; for rest, of its
#: unit of length, which is 1 for motions of a common size.
SETTLED = 1e-4

#: Minus the exponent beyond which the search for cycles leaves an exponential of the friction law
#: out: far below rounding.
REACH = 42.0


@dataclass(frozen=True)
class Border:
    """Where a mode ends: at a zero of ``level``.

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
    ways : int
        How many numbers at the end of a mode go with the place alone.
    faces : int
        How many at its beginning do: 1 of a contact that presses on either of two faces.
    curved : bool
        Whether a level is no linear function of the state.
    around : tuple of int
        Places of coordinates that are angles after a turn of which all is as before.
    model : Model or None
        Whose motion it is; None of one that is of no page.
    aloft : callable or None
        ``aloft(constants, state)``: whether a motion is above the belt for good; None where that is
        not known.
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
    ways: int = 0
    faces: int = 0
    curved: bool = False
    around: tuple[int, ...] = ()
    model: Any = None
    aloft: Callable[[Values, FloatArray], bool] | None = None
    units: tuple[str, ...] = ()
    lengths: Callable[[Sequence[float], Values], Sequence[float]] = lambda *_: ()
    sized: Callable[[tuple[float, ...]], Field] | None = None
    natural: Field | None = None
    scales: MotionScales | None = None
    lead: int = 0

    def led(self, lead: int) -> Field:
        """The field with rounds marked by another coordinate."""
        if lead == self.lead:
            return self
        natural = self.natural.led(lead) if self.natural else None
        return replace(self, lead=lead, natural=natural)

    def mode_at_rest(self, state: Any, constants: Any) -> Mode:
        """The first mode, but for the numbers that go with the place, which are as at the state."""
        first, last = self.modes[0], len(self.modes[0]) - self.ways
        if not (self.ways or self.faces):
            return first
        here = self.initial_mode(state, constants)
        return here[: self.faces] + first[self.faces : last] + here[last:]

    @cached_property
    def holding(self) -> tuple[Border, ...]:
        """The borders on which a motion may stay, as where friction holds."""
        return tuple(border for border in self.borders if border.stays)

    def stays(self, mode: Mode) -> tuple[Border, ...]:
        """Those on which it stays in a mode."""
        return tuple(border for border in self.holding if not border.sign(mode))

    def check(self, name: str, value: float) -> None:
        """An error where a parameter may not have a value."""
        self.parameter_set(**{name: value})

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the numbers in a state: the coordinates, then their rates as pages call them."""
        return (*self.coordinates, *(f"v{name}" for name in self.coordinates))

    def column(self, name: str) -> Column:
        """The column of a parameter or a coordinate; without a model a plain number."""
        return Column(name) if self.model is None else self.model.column(name)

    @property
    def size(self) -> int:
        """Numbers in a state."""
        return 2 * len(self.coordinates)

    def matrix(
        self, state: Sequence[float], constants: Any, mode: Mode, xp: Any = FLOATS
    ) -> FloatArray:
        """The derivative of the rates of all numbers of a state by these: the linearized motion at
        an equilibrium.
        """
        n = len(self.coordinates)
        return np.vstack(
            [np.eye(n, 2 * n, n), np.array(self.jacobian(state, constants, mode, xp), dtype=float)]
        )


@cache
def undecorated(function: Callable[..., Any]) -> Callable[..., Any]:
    """The algebra of a generated function, without the common shape of results; it takes a
    namespace even where it needs none.
    """
    algebra: Callable[..., Any] = inspect.unwrap(function)
    return algebra if algebra.__kwdefaults__ else lambda *given, xp=None: algebra(*given)


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
                (1, 0),
                motion.sides,
                *((1, 0),) * motion.layers,
                *((1, -1),) * (motion.turns + motion.torsions),
            )
        ),
        model.Parameters,
        lambda mode: (*mode[:2], *(1,) * motion.layers, *mode[motion.turn :]),
        where=model.where,
        ways=motion.torsions,
        faces=motion.faces,
        forces=tuple(forces.told_of(model).items()),
        curved=model.about.get("curved", False),
        around=tuple(
            place
            for place, entry in enumerate(model.about["coordinates"])
            if entry.get("comes_around")
        ),
        model=model,
        aloft=model.closed_form("aloft"),
        units=tuple(entry["unit"] for entry in model.about["coordinates"]),
        lengths=motion.lengths,
        sized=partial(field_of, model, reach),
    )


def exact_field(where: str) -> Field:
    """The field of a model by the name that loads it, for proofs: its contact law has to be a
    polynomial.
    """
    from .load import load

    model = load(where)
    if not model.contact["polynomial"]:
        raise ParameterError(
            "the contact law is no polynomial: it has no continuation beyond its border, "
            "which proofs need"
        )
    if model.field.holding:
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
        model.require_one_contact("motion")
        about = model.about
        self.model, self.reach, self.contact = model, reach, model.contact
        self.layers, self.torsions = about["layers"], len(about["torsions"])
        self.holds = hasattr(model.algebra, "grip")
        self.sides = (1, -1, 0) if self.holds else (1, -1)
        self.rooted = not self.contact["polynomial"]
        self.turns = int(
            self.rooted and self.contact["unilateral"] and self.contact["gap"] in model.coordinates
        )
        lifts = self.contact["border"] is not None
        #: How many numbers at the beginning of a mode go with the place alone.
        self.faces = int(lifts and not self.contact["unilateral"])
        sizes = levels or (1.0, 1.0)
        #: How far before its border a law that is no polynomial is left, for it may have no
        #: continuation beyond; and up to which sliding speed nothing slides.
        self.shift = 2 * GAP * sizes[0] * self.rooted
        self.still = STILL * sizes[-1 if len(sizes) <= lifts else lifts]
        #: Places in a mode of the turn of the gap, and of the first torsion spring.
        self.turn = 2 + self.layers
        self.way = self.turn + self.turns

    def constants(self, values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
        """What the functions take, from values of the parameters."""
        # Of NumPy by one number at a time, so that no bit depends on where it stands in an array.
        cos, sin = (
            (xp.cos, xp.sin)
            if xp is not None
            else (lambda v: float(np.cos(v)), lambda v: float(np.sin(v)))
        )
        known = dict(zip(self.model.parameters, values, strict=True))
        for angle, names in self.model.about["angles"].items():
            known |= zip(names, (cos(known[angle]), sin(known[angle])), strict=True)
        return tuple(known[name] for name in self.model.about["arguments"]["motion"])

    def in_mode(self, name: str) -> Callable[..., Any]:
        """A generated function of the state, the constants and the numbers of the mode that it
        takes.
        """
        plain = undecorated(getattr(self.model.algebra, name))
        turn, way, rooted = self.turn, self.way, self.rooted

        def call(
            state: Sequence[Any], constants: Sequence[Any], mode: Sequence[Any], xp: Any
        ) -> Any:
            return plain(
                *state, *constants, *mode[:turn], *mode[way:], xp=_Rooted(xp) if rooted else xp
            )

        return call

    def initial_mode(self, state: Sequence[Any], constants: Sequence[Any]) -> Mode:
        """The mode of a state."""
        algebra, n = self.model.algebra, len(self.model.coordinates)
        gap, slip = undecorated(algebra.borders)(*state, *constants)
        side = 2 * (slip >= 0) - 1
        near = (
            1 * (depth <= self.reach)
            for depth in undecorated(algebra.layers)(*state, *constants, side)
        )
        turn = [2 * (state[n + self._gap] >= 0) - 1] if self.turns else []
        ways = (2 * (sine >= 0) - 1 for sine, _ in self._turned(state, constants))
        # A law that is no polynomial begins without contact on the border itself.
        pushing = 1 * (gap <= -self.shift) if self.contact["border"] else 1
        mode = pushing, side, *near, *turn, *ways
        return self.held(mode, state, constants) if self.holds and abs(slip) <= self.still else mode

    def held(self, mode: Mode, state: Any, constants: Any) -> Mode:
        """The mode where nothing slides: sticking, if there is contact and the force of friction is
        within its limits.
        """
        ahead, behind = self.in_mode("grip")(state, constants, mode, FLOATS)
        sticks = min(ahead, behind) >= 0 < max(ahead, behind)  # in lift-off these are −F and F
        return mode[0], 0 if sticks else 1 if ahead < behind else -1, *mode[2:]

    def grips(self, state: Any, constants: Any, mode: Mode) -> float:
        """How far the force of friction that would hold the mass is from its limits."""
        return float(min(self.in_mode("grip")(state, constants, mode, FLOATS)))

    def slips(self, row: int) -> Callable[..., Any]:
        """Derivatives of the sliding speed, or of how far its force is from a limit."""
        slopes = self.in_mode("grip_slopes")
        return lambda state, constants, mode: slopes(state, constants, mode, _namespace(state))[row]

    def lengths(self, state: Sequence[float], constants: Values) -> list[float]:
        """Undeformed lengths of the springs along lines."""
        place = state[: len(self.model.coordinates)]
        geometry = undecorated(self.model.algebra.geometry)
        try:
            lines = geometry(*place, *forces.of_statics(self.model, constants))
        except ArithmeticError:
            return []
        return [float(rest) for *_, rest in lines if rest]

    @property
    def _gap(self) -> int:
        return self.model.coordinates.index(self.contact["gap"])

    def _turned(
        self, state: Sequence[float], constants: Sequence[float]
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
        of_gap, of_slip, reach = self.contact["border"], self.model.friction_law, self.reach
        if of_gap is not None:
            levels = self._generated("borders", "border_rates", 0, shift=lambda _: self.shift)
            sign, opened = _side(0, 1)

            def lifted(mode: Mode, *at: Any) -> Mode:
                after = opened(mode)
                return after if mode[1] else self.held(after, *at)

            yield Border(
                f"{of_gap} = 0",
                *levels,
                sign,
                lifted,
                crossings=("face_left", "face_regained")
                if self.faces
                else ("contact_lost", "contact_regained"),
            )
        if of_slip is not None:
            along = of_slip["along"]
            name = f"{along if along.isidentifier() else f'({along})'}' = {of_slip['belt']}"
            levels, crossings = (
                self._generated("borders", "border_rates", 1),
                ("belt_overtakes", "mass_overtakes"),
            )
            if self.holds:
                yield from self._held(name, levels, crossings)
            else:
                yield Border(name, *levels, *_side(1, 0), crossings=crossings)
        for k in range(
            self.layers
        ):  # exponentials of the sliding speed, where they are about to be felt

            def shift(mode: Mode, place: int = 2 + k) -> Any:
                return -reach - WIDTH * mode[place]

            levels = self._generated("layers", "layer_rates", k, slice(1, 2), shift)
            yield Border(
                f"layer {k + 1}", *levels, *_side(2 + k, 1), kink=False, scale=1e-3 / reach
            )
        if self.turns:
            rate = len(self.model.coordinates) + self._gap
            yield Border(
                "gap' = 0",
                lambda state, *_: state[rate],
                lambda _, accelerations, *__: accelerations[self._gap],
                *_side(self.turn, 0),
            )
        for k in range(self.torsions):
            # Where a turning comes to π times its way, or to −0.93 times it: from there the other
            # way counts it. Each way is smooth beyond its ends. At ±π the least turning jumps, and
            # so does the torque; a motion goes on the other way.
            levels = self._generated("turning_borders", "turning_rates", k, slice(self.way, None))
            _, beyond = _side(self.way + k, 0)

            def jumps(state: Any, constants: Any, k: int = k) -> bool:
                return bool(self._turned(state, constants)[k][1] < 0)

            yield Border(f"turning {k + 1}", *levels, lambda _: 1, beyond, jumps=jumps)

    def _held(
        self, name: str, levels: tuple[Any, Any], crossings: tuple[str, str]
    ) -> Iterator[Border]:
        """Borders of dry friction: the sliding speed comes to 0, or the force that holds it there
        comes to a limit.
        """
        begins = (*crossings, "stick")
        yield Border(
            name,
            *levels,
            lambda mode: mode[1],
            self.held,
            True,
            begins,
            1e-3,
            always,
            self.slips(0),
            self.grips,
        )
        for row, way in enumerate(("with", "against")):
            slopes = self.slips(1 + row)

            def level(state: Any, constants: Any, mode: Mode, row: int = row) -> Any:
                return self.in_mode("grip")(state, constants, mode, _namespace(state))[row]

            def rate(
                state: Any, accelerations: Any, constants: Any, mode: Mode, slopes: Any = slopes
            ) -> Any:
                changes = (*state[len(accelerations) :], *accelerations)
                return sum(
                    a * b for a, b in zip(slopes(state, constants, mode), changes, strict=False)
                )

            yield Border(
                f"friction at its limit {way} the belt",
                level,
                rate,
                lambda mode: 1 - mode[1] * mode[1],
                self.held,
                crossings=("", "", "slip"),
                jumps=always,
                slopes=slopes,
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

        def level_of(state: Any, constants: Any, mode: Mode) -> Any:
            value = of_level(*state, *constants, *mode[taken], xp=_namespace(state))[row]
            return value + shift(mode) if shift else value

        def rate_of(state: Any, accelerations: Any, constants: Any, mode: Mode) -> Any:
            return of_rate(*state, *accelerations, *constants, *mode[taken], xp=_namespace(state))[
                row
            ]

        return level_of, rate_of


def always(*_: Any) -> bool:
    """Of a border at which the field always jumps."""
    return True


def _side(place: int, both: int) -> tuple[Callable[[Any], Any], Callable[..., Mode]]:
    """Sign and other side of a border at which a number of the mode becomes the other one of two
    that add up to ``both``.
    """
    return (
        lambda mode: 1 - 2 * mode[place] if both else mode[place],
        lambda mode, *_: (*mode[:place], both - mode[place], *mode[place + 1 :]),
    )


class _Rooted:
    """A namespace whose root of a negative number is 0: trial steps leave the contact, and are
    rejected.
    """

    def __init__(self, xp: Any) -> None:
        self._xp = xp

    def __getattr__(self, name: str) -> Any:
        return getattr(self._xp, name)

    def log(self, value: Any) -> Any:
        """Logarithm, −∞ of 0, whose exponential is 0."""
        if isinstance(value, float):
            return math.log(value) if value > 0 else -math.inf
        if isinstance(value, np.ndarray):
            with np.errstate(divide="ignore"):
                return np.log(np.maximum(value, 0.0))
        return self._xp.log(value)

    def sqrt(self, value: Any) -> Any:
        """Square root of a float or an array; an expression of heyoka's is taken as it is."""
        if isinstance(value, float | np.ndarray | np.floating):
            return self._xp.sqrt(np.maximum(value, 0.0))
        return self._xp.sqrt(value)


def _namespace(state: Any) -> Any:
    """Where functions of a state's numbers are: in NumPy, unless they say another namespace."""
    return getattr(state[0], "namespace", np)
