"""The field of a model's motion, for integrators: its generated functions over the modes (pushing, side, near…).

``pushing`` is 1 in contact and 0 without, ``side`` the sign of the sliding speed, and ``near`` of every exponential of the
friction law 1 where it is felt and 0 where it is left out. What a model has not, as a contact that lifts, is no border.
"""

from __future__ import annotations

import inspect
import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ParameterError
from . import forces
from .field import GAP, WIDTH, Border, Field, Mode

if TYPE_CHECKING:
    from .model import Model


def undecorated(function: Callable[..., Any]) -> Callable[..., Any]:
    """The algebra of a generated function, without the common shape of results; it takes a namespace even where it needs none."""
    algebra: Callable[..., Any] = inspect.unwrap(function)
    return algebra if algebra.__kwdefaults__ else lambda *given, xp=None: algebra(*given)


@cache
def field_of(model: Model, reach: float) -> Field:
    """The field whose exponentials are left out where they are below exp(−reach)."""
    motion = _Motion(model, reach)
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
        tuple(itertools.product((1, 0), (1, -1), *((1, 0),) * motion.layers, *((1, -1),) * (motion.turns + motion.torsions))),
        model.Parameters,
        lambda mode: (*mode[:2], *(1,) * motion.layers, *mode[motion.turn :]),
        again=(__name__, "exact_field", model.where),
        ways=motion.torsions,
        forces=tuple(forces.told_of(model).items()),
        curved=model.about.get("curved", False),
        around=tuple(place for place, entry in enumerate(model.about["coordinates"]) if entry.get("comes_around")),
        is_angle=model.is_angle,
        aloft=model.closed_form("aloft"),
    )


def exact_field(where: str) -> Field:
    """The field of a model by the name that loads it, for proofs: its contact law has to be a polynomial."""
    from .load import load

    model = load(where)
    if not model.about["contact"]["polynomial"]:
        raise ParameterError("the contact law is no polynomial: it has no continuation beyond its border, which proofs need")
    if model.about.get("waves"):
        raise ParameterError("cosines of coordinates stand in the equations of motion, which proofs of cycles do not take in")
    if model.about.get("torsions"):
        raise ParameterError(
            "the turning of a torsion spring is an arc tangent of the place, which proofs of cycles do not take in"
        )
    return model.field


class _Motion:
    """The functions of a field, from those that were generated for a model.

    Where the law of contact has a root, as Hertz's, and a coordinate is the gap, a motion is stopped at each turn of it. Where
    the mass only just touches, the depth goes with (t − t_0)² and its power 3/2 with |t − t_0|³. Before t_0 the series is that
    of −(t − t_0)³, which nothing shows to be wrong beyond: so a step ends at t_0.
    """

    def __init__(self, model: Model, reach: float) -> None:
        about = model.about
        self.model, self.reach, self.contact = model, reach, about["contact"]
        self.layers, self.torsions = about["layers"], len(about.get("torsions", ()))
        self.rooted = not self.contact["polynomial"]
        self.turns = int(self.rooted and self.contact["unilateral"] and self.contact["gap"] in model.coordinates)
        #: Places in a mode of the turn of the gap, and of the first torsion spring.
        self.turn = 2 + self.layers
        self.way = self.turn + self.turns

    def constants(self, values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
        """What the functions take, from values of the parameters."""
        # Of NumPy by one number at a time, so that no bit depends on where it stands in an array.
        cos, sin = (xp.cos, xp.sin) if xp is not None else (lambda v: float(np.cos(v)), lambda v: float(np.sin(v)))
        known = dict(zip(self.model.parameters, values, strict=True))
        for angle, names in self.model.about["angles"].items():
            known |= zip(names, (cos(known[angle]), sin(known[angle])), strict=True)
        return tuple(known[name] for name in self.model.about["arguments"]["motion"])

    def in_mode(self, name: str) -> Callable[..., Any]:
        """A generated function of the state, the constants and the numbers of the mode that it takes."""
        plain = undecorated(getattr(self.model.algebra, name))
        turn, way, rooted = self.turn, self.way, self.rooted

        def call(state: Sequence[Any], constants: Sequence[Any], mode: Sequence[Any], xp: Any) -> Any:
            return plain(*state, *constants, *mode[:turn], *mode[way:], xp=_Rooted(xp) if rooted else xp)

        return call

    def initial_mode(self, state: Sequence[Any], constants: Sequence[Any]) -> Any:
        """The mode of a state, or of columns of many."""
        algebra, n = self.model.algebra, len(self.model.coordinates)
        gap, slip = undecorated(algebra.borders)(*state, *constants)
        side = 2 * (slip >= 0) - 1
        near = (1 * (depth <= self.reach) for depth in undecorated(algebra.layers)(*state, *constants, side))
        turn = [2 * (state[n + self._gap] >= 0) - 1] if self.turns else []
        ways = (2 * (sine >= 0) - 1 for sine, _ in self._turned(state, constants))
        # A law that is no polynomial begins without contact on the border itself.
        return 1 * (gap <= -2 * GAP * self.rooted) if self.contact["unilateral"] else 1, side, *near, *turn, *ways

    @property
    def _gap(self) -> int:
        return self.model.coordinates.index(self.contact["gap"])

    def _turned(self, state: Sequence[float], constants: Sequence[float]) -> list[tuple[float, float]]:
        """Sine and cosine of every turning."""
        if not self.torsions:
            return []
        level = undecorated(self.model.algebra.turning_borders)
        forward, backward = (level(*state, *constants, *(way,) * self.torsions) for way in (1, -1))
        return [((one - other) / 4, (one + other) / 2 - 1) for one, other in zip(forward, backward, strict=True)]

    def borders(self) -> Iterator[Border]:
        """All borders between modes."""
        of_gap, of_slip, reach = self.contact["gap"], self.model.about["friction"], self.reach
        if of_gap is not None and self.contact["unilateral"]:
            # A law that is no polynomial may have no continuation beyond its border: it is left GAP before.
            levels = self._generated("borders", "border_rates", 0, shift=lambda _: 2 * GAP * self.rooted)
            yield Border(f"{of_gap} = 0", *levels, *_side(0, 1), crossings=("contact_lost", "contact_regained"))
        if of_slip is not None:
            along = of_slip["along"]
            name = f"{along if along.isidentifier() else f'({along})'}' = {of_slip['belt']}"
            levels = self._generated("borders", "border_rates", 1)
            yield Border(name, *levels, *_side(1, 0), crossings=("belt_overtakes", "mass_overtakes"))
        for k in range(self.layers):  # exponentials of the sliding speed, where they are about to be felt

            def shift(mode: Any, place: int = 2 + k) -> Any:
                return -reach - WIDTH * mode[place]

            levels = self._generated("layers", "layer_rates", k, lambda mode: mode[1:2], shift)
            yield Border(f"layer {k + 1}", *levels, *_side(2 + k, 1), kink=False, scale=1e-3 / reach)
        if self.turns:
            rate = len(self.model.coordinates) + self._gap
            yield Border(
                "gap' = 0", lambda state, *_: state[rate], lambda _, accelerations, *__: accelerations[self._gap],
                *_side(self.turn, 0),
            )  # fmt: skip
        for k in range(self.torsions):
            # Where a turning comes to π times its way, or to −0.93 times it: from there the other way counts it. Each way is
            # smooth beyond its ends. At ±π the least turning jumps, and so does the torque; a motion goes on the other way.
            levels = self._generated("turning_borders", "turning_rates", k, lambda mode: mode[self.way :])
            _, beyond = _side(self.way + k, 0)

            def jumps(state: Any, constants: Any, k: int = k) -> bool:
                return bool(self._turned(state, constants)[k][1] < 0)

            yield Border(f"turning {k + 1}", *levels, lambda _: 1, beyond, jumps=jumps)

    def _generated(
        self, level: str, rate: str, row: int, taken: Callable[[Any], Any] = lambda _: (),
        shift: Callable[[Any], Any] | None = None,
    ) -> tuple[Callable[..., Any], Callable[..., Any]]:  # fmt: skip
        """Level and rate of a border: a row of two generated functions, which may take numbers of the mode too."""
        of_level, of_rate = (undecorated(getattr(self.model.algebra, name)) for name in (level, rate))

        def level_of(state: Any, constants: Any, mode: Any) -> Any:
            value = of_level(*state, *constants, *taken(mode), xp=_namespace(state))[row]
            return value + shift(mode) if shift else value

        def rate_of(state: Any, accelerations: Any, constants: Any, mode: Any) -> Any:
            return of_rate(*state, *accelerations, *constants, *taken(mode), xp=_namespace(state))[row]

        return level_of, rate_of


def _side(place: int, both: int) -> tuple[Callable[[Any], Any], Callable[[Mode], Mode]]:
    """Sign and other side of a border at which a number of the mode becomes the other one of two that add up to ``both``."""
    return (
        lambda mode: 1 - 2 * mode[place] if both else mode[place],
        lambda mode: (*mode[:place], both - mode[place], *mode[place + 1 :]),
    )


class _Rooted:
    """A namespace whose root of a negative number is 0: trial steps leave the contact, and are rejected."""

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
    """Where functions of a state's numbers are: in NumPy, or heyoka for its expressions."""
    if not type(state[0]).__module__.startswith("heyoka"):
        return np
    from .heyoka_library import library

    return library()
