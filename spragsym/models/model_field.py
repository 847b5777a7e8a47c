"""The field of a model's motion, for integrators: its generated functions over the modes (pushing, side, near…).

``pushing`` is 1 in contact and 0 without, ``side`` the sign of the sliding speed, and ``near`` of every exponential of the
friction law 1 where it is felt and 0 where it is left out. What a model has not, as a contact that lifts, is no border.
"""

from __future__ import annotations

import inspect
import itertools
import math
from collections.abc import Callable, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ParameterError
from . import forces
from .field import GAP, WIDTH, Border, Field, Mode, never

if TYPE_CHECKING:
    from .model import Model


def undecorated(function: Callable[..., Any]) -> Callable[..., Any]:
    """The algebra of a generated function, without the common shape of results; it takes a namespace even where it needs none."""
    algebra: Callable[..., Any] = inspect.unwrap(function)
    return algebra if algebra.__kwdefaults__ else lambda *given, xp=None: algebra(*given)


@cache
def field_of(model: Model, reach: float) -> Field:
    """The field whose exponentials are left out where they are below exp(−reach)."""
    layers = model.about["layers"]
    contact, slip = model.about["contact"], model.about["friction"]
    borders: list[Border] = []
    if contact["gap"] is not None and contact["unilateral"]:
        borders.append(_contact(model))
    if slip is not None:
        borders.append(_slip(model))
    borders += [_layer(model, number, reach) for number in range(layers)]
    turns = _turns(model)
    borders += [_turn(model) for _ in range(turns)]
    torsions = len(model.about.get("torsions", ()))
    borders += [_way(model, number, torsions) for number in range(torsions)]
    return Field(
        f"{model.where}:{model.about['source']}:{reach!r}",
        model.coordinates,
        model.parameters,
        _constants(model),
        _in_mode(model, "regime_rhs"),
        _in_mode(model, "regime_jacobian"),
        _in_mode(model, "regime_by_parameters"),
        tuple(borders),
        _initial_mode(model, reach),
        tuple(itertools.product((1, 0), (1, -1), *((1, 0),) * layers, *((1, -1),) * (turns + torsions))),
        model.Parameters,
        lambda mode: (*mode[:2], *(1 for _ in range(layers)), *mode[2 + layers :]),
        again=(__name__, "exact_field", model.where),
        ways=torsions,
        forces=tuple(forces.told_of(model).items()),
        curved=model.about.get("curved", False),
        around=tuple(place for place, entry in enumerate(model.about["coordinates"]) if entry.get("comes_around")),
        is_angle=model.is_angle,
        aloft=model.closed_form("aloft") or never,
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


def _in_mode(model: Model, name: str) -> Callable[..., Any]:
    plain = undecorated(getattr(model.algebra, name))
    rooted = not model.about["contact"]["polynomial"]
    turn = 2 + model.about["layers"]
    after = turn + _turns(model)

    def call(state: Sequence[Any], constants: Sequence[Any], mode: Sequence[Any], xp: Any) -> Any:
        return plain(*state, *constants, *mode[:turn], *mode[after:], xp=_Rooted(xp) if rooted else xp)

    return call


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


def _generated(
    model: Model, names: tuple[str, str], row: int, taken: Callable[[Any], Sequence[Any]] = lambda mode: ()
) -> tuple[Callable[..., Any], Callable[..., Any]]:  # fmt: skip
    """Level and rate of a border: a row of two generated functions, which may take numbers of the mode too."""
    level, rate = (undecorated(getattr(model.algebra, name)) for name in names)

    def level_of(state: Any, constants: Any, mode: Any) -> Any:
        return level(*state, *constants, *taken(mode), xp=_namespace(state))[row]

    def rate_of(state: Any, accelerations: Any, constants: Any, mode: Any) -> Any:
        return rate(*state, *accelerations, *constants, *taken(mode), xp=_namespace(state))[row]

    return level_of, rate_of


def _other(place: int, both: int) -> Callable[[Mode], Mode]:
    """The mode whose number at a place is the other one of two that add up to ``both``."""
    return lambda mode: (*mode[:place], both - mode[place], *mode[place + 1 :])


def _contact(model: Model) -> Border:
    """Where the gap is zero. A law that is no polynomial may have no continuation beyond: it is left GAP before its border."""
    level, rate = _generated(model, ("borders", "border_rates"), 0)
    shift, name = 0.0 if model.about["contact"]["polynomial"] else 2 * GAP, f"{model.about['contact']['gap']} = 0"

    def shifted(state: Any, constants: Any, mode: Any) -> Any:
        return level(state, constants, mode) + shift

    return Border(
        name, shifted if shift else level, rate, lambda mode: 1 - 2 * mode[0], _other(0, 1),
        crossings=("contact_lost", "contact_regained"),
    )  # fmt: skip


def _slip(model: Model) -> Border:
    """Where the sliding speed is zero."""
    level, rate = _generated(model, ("borders", "border_rates"), 1)
    along, belt = (model.about["friction"][name] for name in ("along", "belt"))
    name = f"{along if along.isidentifier() else f'({along})'}' = {belt}"
    return Border(
        name, level, rate, lambda mode: mode[1], _other(1, 0),
        crossings=("belt_overtakes", "mass_overtakes"),
    )  # fmt: skip


def _layer(model: Model, number: int, reach: float) -> Border:
    """Where one of the exponentials of the sliding speed is about to be felt."""
    place = 2 + number
    depth, rate = _generated(model, ("layers", "layer_rates"), number, lambda mode: (mode[1],))

    def level(state: Any, constants: Any, mode: Any) -> Any:
        return depth(state, constants, mode) - reach - WIDTH * mode[place]

    def watched(state: Any, constants: Any, mode: Any) -> Any:
        return 1e-3 * level(state, constants, mode) / reach

    return Border(
        f"layer {number + 1}", level, rate, lambda mode: 1 - 2 * mode[place], _other(place, 1), kink=False, watched=watched,
    )  # fmt: skip


def _turns(model: Model) -> int:
    """1 where a motion is stopped at each turn of the gap: of a law with a root, as Hertz's, at a coordinate that is the gap.

    Where the mass only just touches, the depth goes with (t − t_0)² and its power 3/2 with |t − t_0|³. Before t_0 the series
    is that of −(t − t_0)³, which nothing shows to be wrong beyond: so a step ends at t_0.
    """
    contact = model.about["contact"]
    return int(not contact["polynomial"] and contact["unilateral"] and contact["gap"] in model.coordinates)


def _turn(model: Model) -> Border:
    """Where the gap is largest or smallest."""
    row, n, place = model.coordinates.index(model.about["contact"]["gap"]), len(model.coordinates), 2 + model.about["layers"]
    return Border(
        "gap' = 0", lambda state, *_: state[n + row], lambda _, accelerations, *__: accelerations[row], lambda mode: mode[place],
        _other(place, 0),
    )  # fmt: skip


def _way(model: Model, number: int, torsions: int) -> Border:
    """Where the turning of a torsion spring comes to π times its way, or to −0.93 times it: from there the other way counts it.

    Each way is smooth beyond its ends. At ±π the least turning jumps, and so does the torque; a motion goes on the other way.
    """
    first = 2 + model.about["layers"] + _turns(model)
    names, place = ("turning_borders", "turning_rates"), first + number
    level, rate = _generated(model, names, number, lambda mode: mode[first : first + torsions])

    def jumps(state: Any, constants: Any) -> bool:
        return bool(_turned(model, state, constants)[number][1] < 0)

    return Border(
        f"turning {number + 1}", level, rate, lambda mode: 1, _other(place, 0), jumps=jumps,
    )  # fmt: skip


def _turned(model: Model, state: Sequence[float], constants: Sequence[float]) -> list[tuple[float, float]]:
    """Sine and cosine of every turning."""
    count = len(model.about.get("torsions", ()))
    if not count:
        return []
    level = undecorated(model.algebra.turning_borders)
    forward, backward = (level(*state, *constants, *(way,) * count) for way in (1, -1))
    return [((one - other) / 4, (one + other) / 2 - 1) for one, other in zip(forward, backward, strict=True)]


def _namespace(state: Any) -> Any:
    """Where functions of a state's numbers are: in NumPy, or heyoka for its expressions."""
    if not type(state[0]).__module__.startswith("heyoka"):
        return np
    from .heyoka_library import library

    return library()


def _initial_mode(model: Model, reach: float) -> Callable[..., Mode]:
    borders, layers = map(undecorated, (model.algebra.borders, model.algebra.layers))
    lifts, turns = model.about["contact"]["unilateral"], _turns(model)
    fallen = len(model.coordinates) + model.coordinates.index(model.about["contact"]["gap"]) if turns else 0
    # A law that is no polynomial begins without contact on the border itself.
    highest = 0.0 if model.about["contact"]["polynomial"] else -2 * GAP

    def mode(state: Sequence[Any], constants: Sequence[Any]) -> Any:
        gap, slip = borders(*state, *constants)
        side = 2 * (slip >= 0) - 1
        near = (1 * (depth <= reach) for depth in layers(*state, *constants, side))
        turn = [2 * (state[fallen] >= 0) - 1] * turns
        ways = (2 * (sine >= 0) - 1 for sine, _ in _turned(model, state, constants))
        return 1 * (gap <= highest) if lifts else 1, side, *near, *turn, *ways

    return mode


def _constants(model: Model) -> Callable[..., tuple[Any, ...]]:
    angles = {name: (angle, part) for angle, pair in model.about["angles"].items() for part, name in enumerate(pair)}

    def constants(values: Sequence[Any], xp: Any = None) -> tuple[Any, ...]:
        # Of NumPy by one number at a time, so that no bit depends on where it stands in an array.
        cos, sin = (xp.cos, xp.sin) if xp is not None else (lambda v: float(np.cos(v)), lambda v: float(np.sin(v)))
        known = dict(zip(model.parameters, values, strict=True))
        known |= {name: (cos, sin)[part](known[angle]) for name, (angle, part) in angles.items()}
        return tuple(known[name] for name in model.about["arguments"]["motion"])

    return constants
