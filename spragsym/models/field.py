"""Vector field of a model for integrators and the search for cycles: of second order, smooth in each of its modes."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ..numerics.interval_arrays import BoolArray
from .parameters import FloatArray

#: What is said of an orbit on which the field jumps.
JUMPED = (
    "the orbit passes behind the end of a torsion spring, or through the anchor of a spring, where its force jumps: derivatives "
    "are not carried across a jump; simulate the motion, or look for another orbit"
)

#: Numbers that say which smooth piece of the field is meant, such as (contact, side, near).
Mode: TypeAlias = tuple[int, ...]

#: How far beyond its border a mode is left: it ends chatter by rounding, and costs an error of the order of its square.
GAP = 1e-12

#: How far apart an exponential of the friction law is left out and taken in again, in units of its exponent.
WIDTH = 5.0

#: Where a turn of a coordinate that comes around begins: no angle that models have, so that rounding decides no state's turn.
TURN, BEGIN = 2 * np.pi, -np.pi + 0.012345

#: A motion has settled when what is left to its limit is this share of its reach; for rest, of L_0.
SETTLED = 1e-4

#: Minus the exponent beyond which the search for cycles leaves an exponential of the friction law out: far below rounding.
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
        ``sign(mode)``: of the level inside a mode, a polynomial in the mode's numbers that is 1 or −1.
    beyond : callable
        ``beyond(mode)``: the mode on the other side.
    kink : bool
        Whether the field has a kink there; False where two modes differ by less than rounding.
    crossings : tuple of str
        What crossing it is called, to positive and to negative levels.
    scale : float
        What makes the level small beside the state: the error of a Taylor method is relative to the largest of all.
    jumps : callable or None
        ``jumps(state, constants)``: whether the field jumps where a motion leaves through the border; None where it never does.
    """

    name: str
    level: Callable[..., Any]
    rate: Callable[..., Any]
    sign: Callable[[Any], Any]
    beyond: Callable[[Mode], Mode]
    kink: bool = True
    crossings: tuple[str, str] = ("", "")
    scale: float = 1e-3
    jumps: Callable[..., bool] | None = None


def apart(one: Any, other: Any, around: Sequence[int]) -> FloatArray:
    """One state less another, numbers along the last axis; of coordinates that come ``around`` the shorter way."""
    off: FloatArray = np.subtract(one, other, dtype=float)
    for place in around:
        off[..., place] -= TURN * np.round(off[..., place] / TURN)
    return off


def in_one_turn(state: FloatArray, around: Sequence[int]) -> FloatArray:
    """The state with periodic coordinates in the turn from :data:`BEGIN` on."""
    found = np.array(state, dtype=float)
    for place in around:
        found[..., place] -= TURN * np.floor((found[..., place] - BEGIN) / TURN)
    return found


@dataclass(frozen=True)
class Field:
    """A model's motion: n coordinates q, q″ = acceleration(q, q′) in each mode, continuous across the borders between modes
    but where a border ``jumps``.

    Attributes
    ----------
    name : str
        Unique to the model: compiled integrators are kept by it.
    coordinates : tuple of str, length n
    parameters : tuple of str, length P
        Those that can be varied.
    constants : callable
        ``constants(values)``: what the functions below take, from the values of the parameters; of a fixed length. With
        ``xp`` as a second argument from other numbers than floats.
    acceleration, jacobian, by_parameters : callable
        ``f(state, constants, mode, xp)``: n accelerations; n rows of derivatives by the 2 n numbers of the state; n rows of
        derivatives by the P parameters.
    borders : tuple of Border
    initial_mode : callable
        ``initial_mode(state, constants)``; on a border either side is right; of columns for many states.
    modes : tuple of Mode
        All there are.
    parameter_set : callable
        ``parameter_set(**values)``: the model's parameters of these values, or an error where one may not have its value.
    exact : callable
        ``exact(mode)``: the mode without what is left out below rounding, for proofs.
    forces : tuple of (str, callable)
        Name and ``f(states, constants)``, arrays: forces whose range over an orbit is told.
    again : tuple of str
        Module, function and arguments that make the field once more in another process; empty where none do.
    ways : int
        How many numbers at the end of a mode go with the place alone.
    curved : bool
        Whether a level is no linear function of the state.
    around : tuple of int
        Places of coordinates that are angles after a turn of which all is as before.
    is_angle : callable
        ``is_angle(name)`` of a parameter or a coordinate.
    aloft : callable or None
        ``aloft(constants, state)``: whether a motion is above the belt for good; None where that is not known.
    """

    name: str
    coordinates: tuple[str, ...]
    parameters: tuple[str, ...]
    constants: Callable[..., tuple[float, ...]]
    acceleration: Callable[..., Any]
    jacobian: Callable[..., Any]
    by_parameters: Callable[..., Any]
    borders: tuple[Border, ...]
    initial_mode: Callable[..., Mode]
    modes: tuple[Mode, ...]
    parameter_set: Callable[..., Any]
    exact: Callable[[Mode], Mode] = tuple
    forces: tuple[tuple[str, Callable[..., Any]], ...] = ()
    again: tuple[str, ...] = ()
    ways: int = 0
    curved: bool = False
    around: tuple[int, ...] = ()
    is_angle: Callable[[str], bool] = "".__eq__
    aloft: Callable[[tuple[float, ...], FloatArray], bool] | None = None

    def mode_at_rest(self, state: Any, constants: Any) -> Mode:
        """The first mode, but for its last numbers, which are as at the state."""
        first = self.modes[0]
        return first[: -self.ways] + self.initial_mode(state, constants)[-self.ways :] if self.ways else first

    def check(self, name: str, value: float) -> None:
        """An error where a parameter may not have a value."""
        self.parameter_set(**{name: value})

    @property
    def components(self) -> tuple[str, ...]:
        """Names of the numbers in a state: the coordinates, then their rates as pages call them."""
        return (*self.coordinates, *(f"v{name}" for name in self.coordinates))

    @property
    def size(self) -> int:
        """Numbers in a state."""
        return 2 * len(self.coordinates)

    def matrix(self, state: Sequence[float], constants: Any, mode: Any, xp: Any = math) -> FloatArray:
        """The derivative of the rates of all numbers of a state by these: the linearized motion at an equilibrium."""
        n = len(self.coordinates)
        return np.vstack([np.eye(n, 2 * n, n), np.array(self.jacobian(state, constants, mode, xp), dtype=float)])

    def initial_modes(self, states: FloatArray, constants: FloatArray) -> list[Mode]:
        """Modes of many states, a row each."""
        columns: Any = self.initial_mode(states.T, constants.T)
        return list(zip(*(np.broadcast_to(numbers, len(states)).tolist() for numbers in columns), strict=True))

    def are_inside(self, states: Any, constants: Any, modes: Any) -> BoolArray:
        """Whether states, a column each, lie in their modes, or beyond the borders by no more than the gap."""
        within = np.ones(np.shape(states)[1:], dtype=bool)
        for border in self.borders:
            within &= border.sign(modes) * border.level(states, constants, modes) >= -2 * GAP
        return within
