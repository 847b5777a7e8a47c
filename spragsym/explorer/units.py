"""Units of the user in the explorer: what one of the model's dimensionless numbers is, and the name of its unit."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Units:
    """Units of the data that a page begins at.

    Attributes
    ----------
    source : str
        Where they are from, in words that the page shows.
    length, time, force : tuple of (float, str)
        What 1 is in the unit that is named.
    parameters : dict of str to tuple of (str, float, str)
        For dimensionless parameters that have a quantity with a unit: its name, what 1 is, and the unit.
    """

    source: str
    length: tuple[float, str]
    time: tuple[float, str]
    force: tuple[float, str]
    parameters: dict[str, tuple[str, float, str]] = field(default_factory=dict)

    def data(self) -> dict[str, Any]:
        """The units in the form that the page reads."""
        return {"length": self.length, "time": self.time, "force": self.force, "parameters": self.parameters}
