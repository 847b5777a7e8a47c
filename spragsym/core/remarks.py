"""Remarks of results: sentences whose numbers can be converted to other units afterwards."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

#: For a parameter or coordinate, or for no name and an SI unit, its title, its unit, and the factor
#: to that unit.
Units: TypeAlias = Callable[[str, str], tuple[str, str, float]]


@dataclass(frozen=True)
class At:
    """A value or a range (two ends) of a parameter or a coordinate, in units of the model."""

    name: str
    ends: tuple[float, ...]
    digits: str = ".8g"
    unit: str = ""

    def in_units(self, units: Units) -> str:
        """The text, "title = value unit" or "title in [low, high] unit", in other units."""
        title, unit, factor = units(self.name, "")
        low, *high = (f"{factor * (end + 0.0):{self.digits}}" for end in self.ends)
        where = f"in [{low}, {high[0]}]" if high else f"= {low}"
        return f"{title} {where} {unit}".rstrip()

    def __str__(self) -> str:
        return self.in_units(lambda name, _: (name, self.unit, 1.0))


@dataclass(frozen=True)
class Amount:
    """A number of a dimension, which is an SI unit, in units of the model."""

    value: float
    dimension: str
    digits: str = ".6g"

    def in_units(self, units: Units) -> str:
        """The text, "value unit", in other units."""
        _, unit, factor = units("", self.dimension)
        return f"{factor * self.value:{self.digits}} {unit}".rstrip()

    def __str__(self) -> str:
        return f"{self.value:{self.digits}}"


class Remark(str):
    """A sentence, made of a format template and its parts, which may be :class:`At`,
    :class:`Amount` or remarks.
    """

    template: str
    parts: tuple[Any, ...]

    def __new__(cls, template: str, *parts: Any) -> Remark:
        made = super().__new__(cls, template.format(*parts) if parts else template)
        made.template, made.parts = template, parts
        return made

    def __getnewargs__(self) -> tuple[Any, ...]:
        return (self.template, *self.parts)

    def in_units(self, units: Units) -> str:
        """The sentence in other units."""
        parts = (
            part.in_units(units) if isinstance(part, At | Amount | Remark) else part
            for part in self.parts
        )
        return self.template.format(*parts) if self.parts else self.template
