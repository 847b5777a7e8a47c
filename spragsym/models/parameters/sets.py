"""Base of parameter sets: one shape, equality, and errors that suggest the name that was meant."""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from typing import Any, ClassVar, Self, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from ... import names
from ...display import Shown
from ...errors import ParameterError, ParameterTypeError
from ...numerics.interval_arrays import FloatArray, Shape
from .ranges import Range, as_number, as_numbers

_C = TypeVar("_C")


def named(cls: type[_C]) -> type[_C]:
    """Make a dataclass suggest the name that was meant when it is given one that it does not have."""
    made: Callable[..., None] = cls.__init__
    known = [field.name for field in fields(cls)]  # type: ignore[arg-type]  # a dataclass, as said

    @functools.wraps(made)
    def __init__(self: Any, *args: Any, **values: Any) -> None:
        check_names(values, known)
        made(self, *args, **values)

    cls.__init__ = __init__  # type: ignore[method-assign]  # the same arguments
    return cls


def check_names(given: Iterable[str], known: Iterable[str]) -> None:
    """Raise for a name that is not known, with the one that was meant."""
    known = list(known)
    for name in given:
        if name not in known:
            remark = names.hint(name, known) or f"; the parameters are {', '.join(known)}"
            raise ParameterTypeError(f"{name} is not a parameter{remark}")


def common_shape(given: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The shape that named shapes broadcast to, or an error that lists them."""
    try:
        return np.broadcast_shapes(*given.values())
    except ValueError as error:
        listed = ", ".join(f"{name} {shape}" for name, shape in given.items() if shape)
        raise ParameterError(f"the shapes do not broadcast together: {listed}; give equal shapes, or shapes with ones") from error


@dataclass(frozen=True, eq=False)
class Values(Shown):
    """Fields that are numbers, arrays that broadcast together, or None."""

    @functools.cached_property
    def shape(self) -> Shape:
        """Common shape of all fields."""
        known = {field.name: np.shape(getattr(self, field.name)) for field in fields(self)}
        return common_shape(known) if any(known.values()) else ()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)) and not isinstance(self, type(other)):
            return NotImplemented
        return all(_equal(getattr(self, field.name), getattr(other, field.name)) for field in fields(self))

    def __hash__(self) -> int:
        return hash(tuple(getattr(self, field.name) for field in fields(self)))  # arrays do not hash


@dataclass(frozen=True, eq=False)
class ParameterSet(Values):
    """Dimensionless parameters of a model, scalars or arrays that broadcast together; a subclass has a field for each."""

    #: Allowed values of each parameter, in the order in which functions take them.
    ranges: ClassVar[Mapping[str, Range]] = {}
    #: Parameters that may be left out, for functions that span them.
    spanned: ClassVar[frozenset[str]] = frozenset()
    #: Where a set with values for all of them comes from.
    origin: ClassVar[str] = ""
    #: What :func:`spragsym.load` takes for the model.
    where: ClassVar[str] = ""
    #: Whether the model is the one without closed forms.
    searched: ClassVar[bool] = False
    _model: ClassVar[Any] = None

    def __post_init__(self) -> None:
        self._set({name: getattr(self, name) for name in self.ranges})

    def _set(self, values: Mapping[str, ArrayLike | None]) -> None:
        """Keep values once they are seen to be allowed."""
        for name, value in values.items():
            if value is None and name not in self.spanned:
                raise ParameterError(f"{name} is missing; give it, or start from {self.origin}")
            self.__dict__[name] = None if value is None else as_numbers(name, value, self.ranges[name])
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    @property
    def model(self) -> Any:
        """The :class:`spragsym.Model` that they are parameters of."""
        return type(self).model_of_class()

    @classmethod
    def model_of_class(cls) -> Any:
        """The model of all sets of a class."""
        if cls._model is None:  # a model is loaded when it is asked for, by a room that stands above this one
            cls._model = importlib.import_module("spragsym.models").load(cls.where)
        return cls._model

    def of(self, model: Any) -> Self:
        """The values as a set of ``model``: of the one without closed forms, ``model.search``, or of the one that has them."""
        return self if model.Parameters is type(self) else self._copied(model.Parameters)

    def _copied(self, kind: type[Self]) -> Self:
        other = object.__new__(kind)
        other.__dict__.update(
            {name: value for name, value in self.__dict__.items() if name in self.ranges or name == "_followed"}
        )
        return other

    @property
    def followed(self) -> Mapping[str, float] | None:
        """Coordinates near which the followed state begins; None for the reference state."""
        return self.__dict__.get("_followed")

    def following(self, **coordinates: float) -> Self:
        """A copy whose followed state is the stable equilibrium nearest to these coordinates, in place of the reference state.

        It holds for everything that follows a state: paths, jump values, margins, probabilities, certificates, redesigns.

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
        known = self.model.coordinates
        if not coordinates or not set(coordinates) <= set(known):
            raise ParameterError(f"coordinates = {', '.join(coordinates) or 'none'}; give some of {', '.join(known)}")
        other = self._copied(type(self))
        other.__dict__["_followed"] = {name: as_number(name, value) for name, value in coordinates.items()}
        return other

    def replace(self, **changes: ArrayLike | None) -> Self:
        """A copy with other values."""
        check_names(changes, self.ranges)
        other = self._copied(type(self))
        other._set(changes)  # what stays as it is need not be looked at again
        return other

    def given(self, **changes: ArrayLike | None) -> Self:
        """A copy with those values that are not None; itself if there are none."""
        known = {name: value for name, value in changes.items() if value is not None}
        return self.replace(**known) if known else self

    def __eq__(self, other: object) -> bool:
        same = super().__eq__(other)
        return same if same is NotImplemented else bool(same) and self.followed == getattr(other, "followed", None)

    __hash__ = Values.__hash__

    def require(self, *names: str) -> None:
        """Raise unless the named parameters are given."""
        for name in names:
            if getattr(self, name) is None:
                raise ParameterError(f"{name} is missing from the parameters, and is needed here; use p.replace({name}=...)")

    def scalars(self, *names: str) -> tuple[float, ...]:
        """The named parameters as floats; an error if one is missing or an array."""
        self.require(*names)
        kept = ((name, getattr(self, name)) for name in names)  # each was seen to be allowed when it was given
        return tuple(as_number(name, value) if value.ndim else value.item() for name, value in kept)

    def broadcast(self, *names: str) -> tuple[FloatArray, ...]:
        """The named parameters, read-only, each of the common shape."""
        self.require(*names)
        return tuple(np.broadcast_to(getattr(self, name), self.shape) for name in names)

    def __reduce__(self) -> tuple[Any, ...]:
        return _again, (self.where, self.searched, {name: getattr(self, name) for name in self.ranges}, self.followed)

    def __repr__(self) -> str:
        given = ((name, getattr(self, name)) for name in self.ranges)
        text = f"{type(self).__name__}({', '.join(f'{name}={_plain(value)}' for name, value in given if value is not None)})"
        chosen = ", ".join(f"{name}={value!r}" for name, value in (self.followed or {}).items())
        return f"{text}.following({chosen})" if chosen else text


def _again(where: str, searched: bool, values: dict[str, Any], followed: dict[str, float] | None) -> Any:
    model = importlib.import_module("spragsym.models").load(where)
    p = (model.search if searched else model).Parameters(**values)
    return p if followed is None else p.following(**followed)


def _plain(value: FloatArray) -> str:
    return repr(value.item()) if value.ndim == 0 else f"array{value.shape}"


def _equal(one: FloatArray | None, other: FloatArray | None) -> bool:
    if one is None or other is None:
        return one is other
    return bool(np.array_equal(one, other))
