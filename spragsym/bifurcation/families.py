"""Families of equilibria in contact: one parameter of a model varies over its range, or two do, and the others are fixed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from ..errors import ParameterError, ParameterTypeError
from ..models.parameters import as_numbers
from ..numerics.interval_arrays import FloatArray, Intervals
from ..statics.mechanics.balance import Balance
from ..statics.mechanics.forces import Model
from ..statics.regions import by_hand

#: End of the range of a parameter that has none, over its base value if that is larger than 1.
FAR = 10.0


@dataclass(frozen=True)
class Family:
    """What is searched: parameters that vary over ranges, at one point of the others or at many.

    ``given`` are all parameters, shape (parameters, points), NaN for those that vary; ``spans`` the ranges of these, shape
    (number, 2), and ``endless`` those of them whose range was cut; ``asked`` is a region of the coordinates by hand.
    """

    p: Any
    balance: Balance
    vary: tuple[str, ...]
    given: FloatArray
    spans: FloatArray
    asked: FloatArray | None = None
    endless: tuple[str, ...] = ()

    @classmethod
    def of(
        cls, p: Any, vary: Sequence[str], between: Mapping[str, tuple[float, float]] | None = None,
        within: Mapping[str, tuple[float, float]] | None = None, *, room: float = 0.0,
    ) -> Self:  # fmt: skip
        """Of a set of parameters; ``room`` is how far beyond the border of the contact states count, too."""
        balance, between = Balance(p.model, contact=True, room=room), between or {}
        spans, asked = ranges(p.model, vary, between), by_hand(balance.coordinates, within)
        given = given_column(p, balance.parameters, vary)
        return cls(p, balance, tuple(vary), given, spans, asked, endless(p.model, vary, between))

    def at(self, values: FloatArray) -> FloatArray:
        """All parameters where those that vary have these values, shape (number, points)."""
        points = np.broadcast_shapes(self.given.shape[1:], values.shape[1:])
        out = np.array(np.broadcast_to(self.given, (len(self.given), *points)))
        out[[self.balance.parameters.index(name) for name in self.vary]] = values
        return out

    @property
    def begin(self) -> FloatArray:
        """All parameters at the lower ends of the ranges."""
        return self.at(self.spans[:, :1])

    @property
    def over(self) -> Intervals:
        """All parameters over the ranges."""
        return Intervals.between(self.begin, self.at(self.spans[:, 1:]))


def ranges(model: Model, vary: Sequence[str], between: Mapping[str, tuple[float, float]]) -> FloatArray:
    """Lower and upper ends of the parameters that vary, shape (number, 2)."""
    if not isinstance(between, Mapping):
        raise ParameterTypeError(f'between = {between!r:.60} is no mapping; give the ends by name, as {{"mu0": (0, 1)}}')
    entries = {entry["name"]: entry for entry in model.about["parameters"]}
    rows = []
    for name in vary:
        if not isinstance(name, str) or name not in entries:
            raise ParameterError(f"vary = {name!r} is not a parameter of this model; choose one of {', '.join(entries)}")
        entry = entries[name]
        low, high = (entry[end] for end in ("low", "high"))
        far = FAR * max(1.0, abs(entry["base"] or 0.0))
        default = (-far if low is None else low, far if high is None else high)
        ends = as_numbers(f"between[{name!r}]", between[name]) if name in between else np.array(default)
        if ends.shape != (2,) or not ends[0] < ends[1]:
            raise ParameterError(f"between[{name!r}] = {between[name]} is no range; give its lower and upper end")
        if (ends[0] < default[0] and low is not None) or (ends[1] > default[1] and high is not None):
            raise ParameterError(
                f"between[{name!r}] = {between[name]} leaves the range of {name}, {entry['domain']}; stay within it"
            )
        rows.append(ends)
    for name in between:
        if name not in vary:
            raise ParameterError(f"between has a range for {name!r}, which does not vary; {', '.join(vary)} does")
    return np.array(rows, dtype=float).reshape(-1, 2)


def endless(model: Model, vary: Sequence[str], between: Mapping[str, tuple[float, float]]) -> tuple[str, ...]:
    """Parameters without an end, of which nobody has said how far they are searched."""
    entries = {entry["name"]: entry for entry in model.about["parameters"]}
    return tuple(name for name in vary if name not in between and None in (entries[name]["low"], entries[name]["high"]))


def given_column(p: Any, names: Sequence[str], vary: Sequence[str]) -> FloatArray:
    """Scalar parameters as one column, NaN for those that vary."""
    fixed = [name for name in names if name not in vary]
    for name in fixed:
        if getattr(p, name) is None:
            raise ParameterError(f"{name} has no value while {' and '.join(vary)} varies; use p.replace({name}=...), or vary it")
    values = dict(zip(fixed, p.scalars(*fixed), strict=True))
    return np.array([[values.get(name, np.nan)] for name in names])
