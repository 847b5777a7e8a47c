"""Parameters of models: which values an argument may have, and sets of parameter values."""

from __future__ import annotations

import functools
import importlib
import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from ..core.errors import ParameterError, ParameterTypeError, hint
from ..core.type_variables import K, T
from ..display import Tabular
from ..numerics.interval_arrays import BoolArray, Shape
from ..numerics.interval_arrays import FloatArray as FloatArray
from .units import Carried as Carried

if TYPE_CHECKING:
    from ..models.model import Model

#: Lower and upper end of a range.
Span: TypeAlias = tuple[float, float]
#: Ranges of parameters or coordinates by name.
Ranges: TypeAlias = Mapping[str, Span]

#: Distance from an open end at which a value inside of the range is taken, over the length of it.
INSIDE = 2.0**-40


@dataclass(frozen=True)
class Range:
    """Allowed values of an argument, in its SI unit; the ends belong to it as the flags say.

    ``remedy`` is advice for a value outside.
    """

    low: float
    high: float = math.inf
    open_low: bool = False
    remedy: str = ""
    closed_high: bool = False
    unit: str = "1"

    def spans(self, value: Any) -> BoolArray:
        """Whether a number of any type lies in the range, or the mask of an array's numbers that
        do.
        """
        above = value > self.low if self.open_low else value >= self.low
        return above & (value <= self.high if self.closed_high else value < self.high)

    def contains(self, value: float) -> bool:
        """Whether a number is finite and in the range."""
        return math.isfinite(value) and bool(self.spans(value))

    def reached(self, end: float, length: float = 1.0) -> float:
        """An end of the range or, if it is open, a value next to it inside; ``length`` is that of
        the searched range.
        """
        if self.contains(end):
            return end
        return end + INSIDE * length * (1 if end <= self.low else -1)

    def inside(self, values: FloatArray) -> BoolArray:
        """Mask of the numbers that are finite and in the range."""
        return np.isfinite(values) & self.spans(values)

    def __str__(self) -> str:
        low = "(" if self.open_low or math.isinf(self.low) else "["
        return f"{low}{_bound(self.low)}, {_bound(self.high)}{']' if self.closed_high else ')'}"


def shown(value: float) -> str:
    """The shortest decimal that reads back as the same number, as ``-0.3`` and ``200``."""
    return repr(float(value)).removesuffix(".0")


def _bound(value: float) -> str:
    """An end of a range as text, with multiples of pi by name."""
    named = {math.pi: "pi", math.pi / 2: "pi/2", -math.pi: "-pi", -math.pi / 2: "-pi/2"}
    return named.get(value) or shown(value)


POSITIVE = Range(0.0, open_low=True)
NOT_NEGATIVE = Range(0.0)
FINITE = Range(-math.inf)
ANGLE = Range(-math.inf, unit="rad")


def as_numbers(
    name: str, value: ArrayLike, allowed: Range = FINITE, carried: Carried | None = None
) -> FloatArray:
    """``value`` as a read-only float64 array of any shape.

    Elements with units are converted if the units are understood; ``carried`` keeps the units.
    Raises ParameterTypeError for texts, booleans, complex numbers, objects, ragged lists, masked
    values, other units, units mixed with bare numbers, and named dimensions. Raises ParameterError
    for NaN, infinities and numbers outside of ``allowed``. Errors name the argument.
    """
    if type(value) is float and allowed.contains(value):  # the most frequent case, made fast
        single: FloatArray = np.array(value)
        single.setflags(write=False)
        return single
    carried = carried or Carried(name, allowed.unit)
    value = carried.numbers(value)
    if "" in carried.units and len(carried.units) > 1:
        raise ParameterTypeError(
            f"{name} has values in {', '.join(sorted(carried.units - {''}))} beside values without "
            "a unit; give all of them a unit, or none"
        )
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ParameterTypeError(
            f"{name} is not an array of numbers ({error}); give one number or a regular array"
        ) from error
    if array.dtype.kind not in "iuf":
        kinds = {
            "U": "text",
            "S": "bytes",
            "b": "booleans",
            "c": "complex numbers",
            "O": "objects or ragged lists",
        }
        raise ParameterTypeError(
            f"{name} = {_short(value)} is {kinds.get(array.dtype.kind, array.dtype)}; it must be "
            "real numbers"
        )
    array = array.astype(float)
    inside = allowed.inside(array)
    if not inside.all():
        index = tuple(int(i) for i in np.argwhere(~inside)[0]) if array.ndim else ()
        element = f"{name}[{', '.join(map(str, index))}]" if index else name
        more = int(np.count_nonzero(~inside)) - 1
        raise ParameterError(
            f"{element} = {shown(array[index].item())} is not in {allowed}"
            + (f", nor are {more} more of its values" if more else "")
            + (f": {allowed.remedy}" if allowed.remedy else "")
        )
    array.setflags(write=False)
    return array


def as_number(name: str, value: ArrayLike, allowed: Range = FINITE) -> float:
    """``value`` as one float, with the errors of :func:`as_numbers`; an array is an error too."""
    array = as_numbers(name, value, allowed)
    if array.ndim:
        raise ParameterTypeError(f"{name} has the shape {array.shape}; one number is needed here")
    return float(array)


def as_range(name: str, value: ArrayLike, allowed: Range = FINITE) -> tuple[float, float]:
    """``value`` as lower and upper end of a range, with the errors of :func:`as_numbers`; anything
    else is a ParameterError.
    """
    ends = as_numbers(name, value, allowed)
    if ends.shape != (2,) or not ends[0] < ends[1]:
        raise ParameterError(f"{name} = {value!r:.60} is no range; give its lower and upper end")
    return float(ends[0]), float(ends[1])


def as_mapping(name: str, given: Mapping[K, T] | None, example: str) -> dict[K, T]:
    """A mapping, empty for None; ParameterTypeError with an example for anything else."""
    if not isinstance(given, Mapping | None):
        raise ParameterTypeError(f"{name} = {given!r:.60} is no mapping; give {example}")
    return dict(given or {})


def as_ranges(
    name: str, given: Ranges | None, allowed: Mapping[str, Range]
) -> dict[str, tuple[float, float]]:
    """Ranges by name, each within the ``allowed`` one; names without one are an error."""
    ranges = as_mapping(name, given, f'the ends by name, as {{"{next(iter(allowed))}": (0, 1)}}')
    for one in ranges:
        if one not in allowed:
            raise ParameterError(
                f"{name} has a range for {one!r}; {', '.join(allowed)} may have one"
            )
    return {one: as_range(f"{name}[{one!r}]", ends, allowed[one]) for one, ends in ranges.items()}


def largest(p: ParameterSet, name: str) -> float:
    """The largest absolute value of a parameter over all points; 0 if it has no value."""
    value = p[name]
    return 0.0 if value is None else float(np.abs(value).max(initial=0.0))


def varied_range(vary: str, between: Ranges | None, allowed: Range) -> Span:
    """The range of the parameter that varies, the only one that ``between`` may hold."""
    given = as_ranges("between", between, {vary: allowed})
    if not given:
        raise ParameterError(
            f'between = {between!r} has no range of {vary}; give its ends, as between={{"{vary}": '
            "(0, 1)}"
        )
    return given[vary]


def as_count(name: str, value: object, least: int = 1, most: float = math.inf) -> int:
    """``value`` as an integer between ``least`` and ``most``."""
    if (
        isinstance(value, bool)
        or not isinstance(value, int | np.integer)
        or not least <= value <= most
    ):
        allowed = f"of {least} or more" if most == math.inf else f"in [{least}, {most}]"
        raise ParameterError(f"{name} = {value!r} is not an integer {allowed}")
    return int(value)


def _short(value: object) -> str:
    """The representation of a value, cut to 40 characters."""
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "..."


def degrees(angle: float) -> float:
    """An angle in degrees: the shortest number with the same value in radians.

    So an angle that was given in degrees reads back as it was given.

    Examples
    --------
    >>> math.degrees(math.radians(30.0)), degrees(math.radians(30.0))
    (29.999999999999996, 30.0)
    """
    value = math.degrees(angle)
    candidates = (float(f"{value:.{digits}g}") for digits in (14, 15, 16))
    return next((candidate for candidate in candidates if math.radians(candidate) == angle), value)


def named(cls: type[T]) -> type[T]:
    """Class decorator: a dataclass whose error for an unknown field suggests the one that was
    meant.
    """
    made: Callable[..., None] = cls.__init__
    names = [field.name for field in fields(cls)]  # type: ignore[arg-type]  # a dataclass, as said

    @functools.wraps(made)
    def __init__(self: object, *args: Any, **values: Any) -> None:
        check_names(values, names)
        made(self, *args, **values)

    cls.__init__ = __init__  # type: ignore[method-assign]  # the same arguments
    return cls


def check_names(given: Iterable[str], allowed: Iterable[str]) -> None:
    """Raise ParameterTypeError for an unknown name, with a suggestion."""
    allowed = list(allowed)
    for name in given:
        if name not in allowed:
            remark = hint(name, allowed) or f"; the parameters are {', '.join(allowed)}"
            raise ParameterTypeError(f"{name} is not a parameter{remark}")


def common_shape(given: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The shape to which named shapes broadcast; ParameterError lists them if there is none."""
    try:
        return np.broadcast_shapes(*given.values())
    except ValueError as error:
        listed = ", ".join(f"{name} {shape}" for name, shape in given.items() if shape)
        raise ParameterError(
            f"the shapes do not broadcast together: {listed}; give equal shapes, or shapes "
            "with ones"
        ) from error


@dataclass(frozen=True, eq=False)
class Values(Tabular):
    """Fields that are numbers, arrays that broadcast together, or None."""

    in_a_line = True

    @property
    def _values(self) -> Mapping[str, Any]:
        """The fields by name."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    @functools.cached_property
    def shape(self) -> Shape:
        """Common shape of all fields."""
        shapes = {name: np.shape(value) for name, value in self._values.items()}
        return common_shape(shapes) if any(shapes.values()) else ()

    def __getitem__(self, name: str) -> Any:
        """A field by its name."""
        return getattr(self, name)

    def __eq__(self, other: object) -> bool:
        related = isinstance(other, type(self)) or isinstance(self, type(other))
        if not related or not isinstance(other, Values):
            return NotImplemented
        same = all(np.array_equal(value, other[name]) for name, value in self._values.items())
        return same and getattr(self, "followed", None) == getattr(other, "followed", None)

    def __hash__(self) -> int:
        return hash(tuple(self._values.values()))  # arrays do not hash


class ParameterSet(Values):
    """Dimensionless parameters of a model, scalars or arrays that broadcast together.

    A parameter is an item by its name, and also an attribute unless a set has another attribute of
    that name.
    """

    #: Allowed values of each parameter, in the order in which functions take them.
    ranges: ClassVar[Mapping[str, Range]] = {}
    #: Parameters that may be missing, for functions that vary them.
    spanned: ClassVar[frozenset[str]] = frozenset()
    #: How to make a set with values for all parameters, for messages.
    origin: ClassVar[str] = ""
    #: The argument of :func:`spragsym.load` for the model.
    where: ClassVar[str] = ""
    #: Coordinates; the followed state is the one nearest to them. None for the reference state.
    followed: ClassVar[Mapping[str, float] | None] = None
    _model: ClassVar[Model | None] = None

    #: Default values.
    base: ClassVar[Mapping[str, float | None]] = {}

    def __init__(self, /, *given: ArrayLike | None, **values: ArrayLike | None) -> None:
        check_names(values, self.ranges)
        named = dict(zip(self.ranges, given, strict=False))
        if len(given) > len(named) or set(named) & set(values):
            raise ParameterTypeError(
                f"{len(given)} values without and {len(values)} with names; give each of "
                f"{', '.join(self.ranges)} once at most"
            )
        self._set({**self.base, **named, **values})

    def __post_init__(self) -> None:
        self._set({name: getattr(self, name) for name in self.ranges})

    def _set(self, values: Mapping[str, ArrayLike | None]) -> None:
        """Set values in place, after they have been checked."""
        held = self.__dict__["_held"] = dict(self.__dict__.get("_held", {}))
        for name, value in values.items():
            if value is None and name not in self.spanned:
                raise ParameterError(f"{name} is missing; give it, or start from {self.origin}")
            held[name] = None if value is None else as_numbers(name, value, self.ranges[name])
        self.__dict__.update(self._attributes(held))
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    def __setattr__(self, name: str, value: object) -> NoReturn:
        """Raise AttributeError: a set is immutable."""
        raise AttributeError(
            f"{name} can't be set: a set of parameters stays as it is; use p.replace({name}=...)"
        )

    def __getitem__(self, name: str) -> Any:
        """A parameter by its name."""
        if name not in self.ranges:
            raise KeyError(f"{name!r} is none of the parameters {', '.join(self.ranges)}")
        return self.__dict__["_held"][name]

    @property
    def _values(self) -> Mapping[str, Any]:
        return {name: self[name] for name in self.ranges}

    def _shown(self) -> dict[str, Any]:
        return {name: value for name, value in self._values.items() if value is not None}

    @property
    def _of_model(self) -> Model:
        return self.model

    @property
    def model(self) -> Model:
        """The :class:`spragsym.Model` to which the parameters belong."""
        return type(self).model_of_class()

    @classmethod
    def model_of_class(cls) -> Model:
        """The model of all sets of this class."""
        if cls._model is None:  # models are loaded on first use; their module imports this one
            cls._model = importlib.import_module("spragsym.models").load(cls.where)
        return cls._model

    def of(self, model: Model) -> Self:
        """The same values as a set of ``model``, the model with or without closed forms."""
        return self if model.Parameters is type(self) else self._copied(model.Parameters)

    def _copied(self, kind: type[ParameterSet]) -> Any:
        """A copy of the values and of the followed state, as a set of class ``kind``."""
        other = object.__new__(kind)
        kept = {
            name: self.__dict__[name] for name in ("followed", "_held") if name in self.__dict__
        }
        other.__dict__.update(kept | kind._attributes(self.__dict__["_held"]))
        return other

    @staticmethod
    def _attributes(values: Mapping[str, Any]) -> dict[str, Any]:
        """Values whose names are no attributes of sets."""
        return {name: one for name, one in values.items() if not hasattr(ParameterSet, name)}

    def following(self, /, **coordinates: float) -> Self:
        """A copy whose followed state is the stable equilibrium nearest to these coordinates, in
        place of the reference state.

        It holds for everything that follows a state: paths, jump values, margins, probabilities,
        certificates, redesigns.

        Parameters
        ----------
        **coordinates : float
            Some of the model's coordinates, angles in radians; the distance is taken in these.

        Raises
        ------
        ParameterError
            For a name that is no coordinate, or none at all.

        Examples
        --------
        >>> import spragsym as ss
        >>> rod = ss.load("sprag_rod")
        >>> p = rod.Parameters(theta0=0.6).following(phi=-0.5)
        >>> ss.quasi_static_path(p, "mu0", [0.0, 0.2]).phi.round(4).tolist()
        [-0.5638, -0.5727]
        """
        every = self.model.coordinates
        if not coordinates or not set(coordinates) <= set(every):
            raise ParameterError(
                f"coordinates = {', '.join(coordinates) or 'none'}; give some of {', '.join(every)}"
            )
        other = self._copied(type(self))
        other.__dict__["followed"] = {
            name: as_number(name, value, self.model.any_of(name))
            for name, value in coordinates.items()
        }
        return other

    def replace(self, /, **changes: ArrayLike | None) -> Self:
        """A copy with other values."""
        check_names(changes, self.ranges)
        other = self._copied(type(self))
        other._set(changes)  # the others have been checked already
        return other

    def given(self, /, **changes: ArrayLike | None) -> Self:
        """A copy with those values that are not None; the set itself if all are None."""
        changed = {name: value for name, value in changes.items() if value is not None}
        return self.replace(**changed) if changed else self

    def require(self, *names: str) -> None:
        """Raise ParameterError unless the named parameters have values."""
        for name in names:
            if self[name] is None:
                raise ParameterError(
                    f"{name} is missing from the parameters, and is needed here; use "
                    f"p.replace({name}=...)"
                )

    def scalars(self, *names: str) -> tuple[float, ...]:
        """The named parameters as floats; an error if one is missing or an array."""
        self.require(*names)
        values = ((name, self[name]) for name in names)
        return tuple(
            as_number(name, value) if value.ndim else value.item() for name, value in values
        )

    def broadcast(self, *names: str) -> tuple[FloatArray, ...]:
        """The named parameters as read-only arrays of the common shape."""
        self.require(*names)
        return tuple(np.broadcast_to(self[name], self.shape) for name in names)

    def __reduce__(self) -> tuple[Any, ...]:
        return set_of, (self.model, dict(self._values), self.followed)

    def __repr__(self) -> str:
        given = self._values
        words = ", ".join(
            f"{name}={repr(value.item()) if value.ndim == 0 else f'array{value.shape}'}"
            for name, value in given.items()
            if value is not None
        )
        text = f"{type(self).__name__}({words})"
        chosen = ", ".join(f"{name}={value!r}" for name, value in (self.followed or {}).items())
        return f"{text}.following({chosen})" if chosen else text


def set_of(
    model: Model, values: Mapping[str, Any], followed: Mapping[str, float] | None
) -> ParameterSet:
    """A set of parameters of a model, with the coordinates of the followed state, or None."""
    p = model.Parameters(**values)
    return p if followed is None else p.following(**followed)
