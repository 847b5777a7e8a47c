"""Remarks on what is not known: sentences whose numbers know what they are of, so that they can be
told in other units.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

#: What a parameter or a coordinate is called, its unit, and what one of it is there.
Units: TypeAlias = Callable[[str], tuple[str, str, float]]


@dataclass(frozen=True)
class At:
    """The value of a parameter or a coordinate, or both ends of a range of it, and its unit where
    the model measures it.
    """

    name: str
    ends: tuple[float, ...]
    digits: str = ".8g"
    unit: str = ""

    def in_units(self, units: Units) -> str:
        """Text of the quantity in other units."""
        title, unit, one = units(self.name)
        low, *high = (f"{one * (end + 0.0):{self.digits}}" for end in self.ends)
        where = f"in [{low}, {high[0]}]" if high else f"= {low}"
        return f"{title} {where} {unit}".rstrip()

    def __str__(self) -> str:
        return self.in_units(lambda name: (name, self.unit, 1.0))


class Remark(str):
    """A sentence from a template and its parts, among them places and other remarks."""

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
            part.in_units(units) if isinstance(part, At | Remark) else part for part in self.parts
        )
        return self.template.format(*parts) if self.parts else self.template
