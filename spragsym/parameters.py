"""Parameters of the model, dimensionless and in newtons, metres and seconds, validated once."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, ClassVar, Self, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import names
from .display import Shown
from .errors import NotDimensionlessError, ParameterError, ParameterTypeError
from .generated import scales as _scales
from .generated.quantities import BASE_VALUES, PARAMETERS, QUANTITIES

FloatArray: TypeAlias = NDArray[np.float64]

#: Names of the dimensionless parameters, in the order in which every function takes them.
NAMES = PARAMETERS

#: The article's base values (Section 3); its θ₀ is the control parameter.
ARTICLE = BASE_VALUES


@dataclass(frozen=True)
class Range:
    """Allowed values of an argument."""

    low: float
    high: float = math.inf
    open_low: bool = False
    remedy: str = ""
    closed_high: bool = False

    def contains(self, value: float) -> bool:
        """Whether a number is allowed."""
        return bool(self.inside(np.asarray(value)))

    def inside(self, values: FloatArray) -> NDArray[np.bool_]:
        """Where numbers are allowed."""
        above = values > self.low if self.open_low else values >= self.low
        below = values <= self.high if self.closed_high else values < self.high
        allowed: NDArray[np.bool_] = np.isfinite(values) & above & below
        return allowed

    def __str__(self) -> str:
        low = "(" if self.open_low or math.isinf(self.low) else "["
        return f"{low}{_bound(self.low)}, {_bound(self.high)}{']' if self.closed_high else ')'}"


def shown(value: float) -> str:
    """The shortest decimal that reads back as the same number, whole numbers without a point: ``-0.3``, ``200``."""
    return repr(float(value)).removesuffix(".0")


def _bound(value: float) -> str:
    named = {math.pi: "pi", math.pi / 2: "pi/2", -math.pi: "-pi", -math.pi / 2: "-pi/2"}
    return named.get(value) or shown(value)


POSITIVE = Range(0.0, open_low=True)
NOT_NEGATIVE = Range(0.0)
FINITE = Range(-math.inf)

#: Remedies for values out of range, where the range alone does not suggest one.
_REMEDIES = {
    "theta0": "angles are radians, strictly between 0 and pi; use numpy.radians for degrees",
    "mu0": "a belt that runs the other way is the mirror image: give the supplement of theta0",
    "kappa": "without preload nothing presses the mass on the belt",
    "sigma": "without the inclined spring there is no sprag",
}


def range_of(name: str, remedy: str = "") -> Range:
    """The allowed values of a quantity of the nomenclature."""
    quantity = QUANTITIES[name]
    return Range(quantity.low, quantity.high, quantity.low_open and not math.isinf(quantity.low), remedy)


RANGES = {name: range_of(name, _REMEDIES.get(name, "")) for name in NAMES}


def as_numbers(name: str, value: ArrayLike, allowed: Range = FINITE) -> FloatArray:
    """``value`` as a float64 array of any shape, or an error that names the argument.

    Parameters
    ----------
    name : str
        Name of the argument, for the error.
    value : array_like
        Real numbers: int, float32 and float64 are taken; a masked array only if nothing in it is masked.
    allowed : Range
        Where every number must lie.

    Raises
    ------
    ParameterTypeError
        For strings, booleans, complex numbers, objects, ragged lists and masked values.
    ParameterError
        For NaN, infinities and numbers out of range.
    """
    if isinstance(value, np.ma.MaskedArray):
        if np.ma.is_masked(value):
            raise ParameterTypeError(
                f"{name} has {int(np.ma.getmaskarray(value).sum())} masked values, and a masked value has no equilibria; "
                f"use {name}.compressed(), or {name}.filled(...) with a number"
            )
        value = value.data
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ParameterTypeError(f"{name} is not an array of numbers ({error}); give one number or a regular array") from error
    if array.dtype.kind not in "iuf":
        raise ParameterTypeError(
            f"{name} = {_short(value)} is of type {array.dtype}; it must be real numbers, not {_kind(array)}"
        )
    array = array.astype(np.float64)
    inside = allowed.inside(array)
    if not inside.all():
        index = tuple(int(i) for i in np.argwhere(~inside)[0]) if array.ndim else ()
        place = f"{name}[{', '.join(map(str, index))}]" if index else name
        more = int(np.count_nonzero(~inside)) - 1
        raise ParameterError(
            f"{place} = {shown(array[index].item())} is not in {allowed}"
            + (f", nor are {more} more of its values" if more else "")
            + (f": {allowed.remedy}" if allowed.remedy else "")
        )
    array.setflags(write=False)
    return array


def as_number(name: str, value: ArrayLike, allowed: Range = FINITE) -> float:
    """``value`` as one float; as :func:`as_numbers`, and an error for anything but a single number."""
    array = as_numbers(name, value, allowed)
    if array.ndim:
        raise ParameterTypeError(f"{name} has the shape {array.shape}; one number is needed here")
    return float(array)


def _short(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "..."


def _kind(array: NDArray[Any]) -> str:
    return {"U": "text", "S": "bytes", "b": "booleans", "c": "complex numbers", "O": "objects or ragged lists"}.get(
        array.dtype.kind, str(array.dtype)
    )


def degrees(angle: float) -> float:
    """An angle in degrees: the shortest number that is the same in radians, so that what was given in degrees comes back.

    Examples
    --------
    >>> math.degrees(math.radians(30.0)), degrees(math.radians(30.0))
    (29.999999999999996, 30.0)
    """
    value = math.degrees(angle)
    candidates = (float(f"{value:.{digits}g}") for digits in (14, 15, 16))
    return next((candidate for candidate in candidates if math.radians(candidate) == angle), value)


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
            elsewhere = "; it is an argument of the functions of motion, such as simulate" if name in ("V", "d") else ""
            remark = elsewhere or names.hint(name, known) or f"; the parameters are {', '.join(known)}"
            raise ParameterTypeError(f"{name} is not a parameter{remark}")


def common_shape(given: Mapping[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The shape that named shapes broadcast to, or an error that lists them."""
    try:
        return np.broadcast_shapes(*given.values())
    except ValueError as error:
        listed = ", ".join(f"{name} {shape}" for name, shape in given.items() if shape)
        raise ParameterError(f"the shapes do not broadcast together: {listed}; give equal shapes, or shapes with ones") from error


@dataclass(frozen=True, eq=False)
class ParameterSet(Shown):
    """Dimensionless parameters of a model, scalars or arrays that broadcast together; a subclass has a field for each."""

    #: Allowed values of each parameter, in the order in which functions take them.
    ranges: ClassVar[Mapping[str, Range]] = {}
    #: Parameters that may be left out, for functions that span them.
    spanned: ClassVar[frozenset[str]] = frozenset()
    #: Where a set with values for all of them comes from.
    origin: ClassVar[str] = ""

    def __post_init__(self) -> None:
        for name, allowed in self.ranges.items():
            value = getattr(self, name)
            if value is None:
                if name not in self.spanned:
                    raise ParameterError(f"{name} is missing; give it, or start from {self.origin}")
                continue
            object.__setattr__(self, name, as_numbers(name, value, allowed))
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    @property
    def shape(self) -> tuple[int, ...]:
        """Common shape of all parameters."""
        return common_shape({name: np.shape(getattr(self, name)) for name in self.ranges})

    def replace(self, **changes: ArrayLike | None) -> Self:
        """A copy with other values."""
        return replace(self, **changes)

    def require(self, *names: str) -> None:
        """Raise unless the named parameters are given."""
        for name in names:
            if getattr(self, name) is None:
                raise ParameterError(f"{name} is missing from the parameters, and is needed here; use p.replace({name}=...)")

    def scalars(self, *names: str) -> tuple[float, ...]:
        """The named parameters as floats; an error if one is missing or an array."""
        self.require(*names)
        return tuple(as_number(name, getattr(self, name)) for name in names)

    def broadcast(self, *names: str) -> tuple[FloatArray, ...]:
        """The named parameters, read-only, each of the common shape."""
        self.require(*names)
        return tuple(np.broadcast_to(getattr(self, name), self.shape) for name in names)

    def __repr__(self) -> str:
        given = ((name, getattr(self, name)) for name in self.ranges)
        return f"{type(self).__name__}({', '.join(f'{name}={_plain(value)}' for name, value in given if value is not None)})"

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(_equal(getattr(self, field.name), getattr(other, field.name)) for field in fields(self))

    __hash__ = None  # type: ignore[assignment]  # arrays do not hash


@named
@dataclass(frozen=True, eq=False, repr=False)
class Parameters(ParameterSet):
    """Dimensionless parameters, scalars or arrays that broadcast together.

    Parameters
    ----------
    theta0 : array_like, optional
        Inclination θ₀ of the undeformed spring, radians, in (0, π). May be left out for functions that span it.
    mu0 : array_like, optional
        Friction coefficient μ₀ ≥ 0. May be left out for functions that span it.
    kappa : array_like
        Preload κ = F_L / (k_c L_0) > 0.
    alpha, beta : array_like
        Stiffness ratios α = k_x / k_c ≥ 0 and β = k_y / k_c ≥ 0.
    sigma : array_like
        Stiffness ratio σ = k / k_c > 0.

    Raises
    ------
    ParameterError
        For a value out of range, or shapes that do not broadcast.
    ParameterTypeError
        For anything but real numbers.

    Notes
    -----
    Source: text after (9), with n = N / (k_c L_0) as derived.

    Examples
    --------
    >>> import numpy as np
    >>> p = Parameters.article(theta0=np.radians([30.0, 49.0]), mu0=0.7)
    >>> p.shape
    (2,)
    >>> float(p.kappa)
    0.007
    """

    ranges = RANGES
    spanned = frozenset(("theta0", "mu0"))
    origin = "Parameters.article(...)"

    theta0: Any = None
    mu0: Any = None
    kappa: Any = None
    alpha: Any = None
    sigma: Any = None
    beta: Any = None

    @classmethod
    def article(cls, **changes: ArrayLike | None) -> Parameters:
        """The article's base values, μ₀ = 0.5, κ = α = 0.007, σ = 0.1, β = 0, with changes."""
        check_names(changes, NAMES)
        return cls(**{**ARTICLE, **changes})


def _plain(value: FloatArray) -> str:
    return repr(value.item()) if value.ndim == 0 else f"array{value.shape}"


def _equal(one: FloatArray | None, other: FloatArray | None) -> bool:
    if one is None or other is None:
        return one is other
    return bool(np.array_equal(one, other))


@dataclass(frozen=True)
class Scales(Shown):
    """What one dimensionless unit is, in the units of the data."""

    length: Any
    time: Any
    force: Any


@named
@dataclass(frozen=True, eq=False)
class PhysicalParameters(Shown):
    """The model in newtons, metres, kilograms and seconds, or any consistent system of units; scalars or arrays that broadcast.

    Parameters
    ----------
    m : array_like
        Mass.
    k, k_x, k_y, k_c : array_like
        Stiffness of the inclined spring, along the belt, across it, and of the contact.
    F_L : array_like
        Preload.
    L_0 : array_like
        Length of the undeformed inclined spring.
    theta0 : array_like
        Its inclination, radians, in (0, π).
    mu0 : array_like
        Friction coefficient.
    V : array_like, optional
        Belt speed.
    d : array_like, optional
        Steepness of the friction law in creep, per unit of speed.

    Notes
    -----
    Source: text after (9). Lengths are measured in L_0, time in sqrt(m/k_c), forces in k_c L_0.

    Examples
    --------
    >>> from math import radians
    >>> brake = PhysicalParameters(m=0.4, k=1e5, k_x=7e3, k_y=0, k_c=1e6, F_L=350, L_0=0.05, theta0=radians(49), mu0=0.5, V=20)
    >>> brake.dimensionless()
    Parameters(theta0=0.8552113334772214, mu0=0.5, kappa=0.007, alpha=0.007, sigma=0.1, beta=0.0)
    >>> brake.scales.force
    50000.0
    """

    m: Any
    k: Any
    k_x: Any
    k_y: Any
    k_c: Any
    F_L: Any
    L_0: Any
    theta0: Any
    mu0: Any
    V: Any = None
    d: Any = None

    def __post_init__(self) -> None:
        for name, allowed in physical_ranges().items():
            given = getattr(self, name)
            if given is not None or name not in ("V", "d"):
                array = as_numbers(name, given, allowed)
                object.__setattr__(self, name, array if array.ndim else float(array))
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    @property
    def shape(self) -> tuple[int, ...]:
        """Common shape of all quantities."""
        return common_shape({field.name: np.shape(getattr(self, field.name)) for field in fields(self)})

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(_equal(getattr(self, field.name), getattr(other, field.name)) for field in fields(self))

    def __hash__(self) -> int:
        return hash(tuple(getattr(self, field.name) for field in fields(self)))  # arrays do not hash

    def __getattr__(self, name: str) -> Any:
        # Every function of the model first asks its parameters for one of these.
        if name in _DIMENSIONLESS_ONLY:
            raise NotDimensionlessError(
                "dimensionless Parameters are needed here, and these are PhysicalParameters; call .dimensionless() on them"
            )
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}{names.hint(name, dir(self))}")

    @property
    def scales(self) -> Scales:
        """Scales of length, time and force: multiply a dimensionless result by its scale."""
        return Scales(*(_as_given(value) for value in _scales.scales(self.m, self.k_c, self.L_0)))

    def dimensionless(self) -> Parameters:
        """The same system as :class:`Parameters`."""
        kappa, alpha, sigma, beta, *_ = self._groups()
        return Parameters(self.theta0, self.mu0, kappa, alpha, sigma, beta)

    def belt(self) -> dict[str, Any]:
        """Dimensionless ``V`` and ``d``, as :func:`spragsym.simulate` takes them; an error if one was not given."""
        for name in ("V", "d"):
            if getattr(self, name) is None:
                raise ParameterError(f"{name} is missing from the physical parameters, and the motion in time needs it")
        V, d = self._groups()[4:6]
        return {"V": _as_given(V), "d": _as_given(d)}

    def _groups(self) -> tuple[Any, ...]:
        absent = 0.0  # V and d enter their own groups only
        return _scales.dimensionless_groups(
            self.m, self.k_c, self.L_0, self.F_L, self.k_x, self.k, self.k_y,
            absent if self.V is None else self.V, absent if self.d is None else self.d,
        )  # fmt: skip


def physical_ranges() -> dict[str, Range]:
    """Allowed values of the quantities of :class:`PhysicalParameters`."""
    own = {name: range_of(name) for name in ("m", "k", "k_x", "k_y", "k_c", "F_L", "L_0")}
    return own | {name: RANGES[name] for name in ("theta0", "mu0")} | {name: range_of(f"{name}_dim") for name in ("V", "d")}


def _as_given(value: Any) -> Any:
    """A single number as a float."""
    return float(value) if np.ndim(value) == 0 else value


#: What :class:`Parameters` has and :class:`PhysicalParameters` has not.
_DIMENSIONLESS_ONLY = {name for name in (*NAMES, *vars(Parameters), *vars(ParameterSet)) if not name.startswith("_")} - {
    field.name for field in fields(PhysicalParameters)
}
