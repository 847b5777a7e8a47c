"""Units of printed results: degrees, or with ``--data`` the units of that file."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from ..errors import ParameterError, hint
from ..remarks import Remark

if TYPE_CHECKING:
    from ..models import Model
    from ..report import Study

#: What is measured of a motion in the unit of its first component; forces; and rates.
MEASURED = ("rms", "rms_about_mean", "mean", "amplitude", "largest", "error")
FORCES, RATES = ("spring_force", "contact_force"), ("growth", "omega", "eigenvalues", "damped_eigenvalues")


@dataclass(frozen=True)
class Units:
    """Units of the answers about a model: without dimension and angles in degrees, or those of a file of a brake."""

    model: Model
    study: Study | None = None

    @property
    def si(self) -> dict[str, str]:
        """SI units of coordinates and their rates."""
        entries = self.model.about["coordinates"]
        rates = {entry["rate"]: "1/s" if entry["unit"] == "rad" else "m/s" for entry in entries}
        return {entry["name"]: entry["unit"] for entry in entries} | rates

    @property
    def time(self) -> float:
        """What one of a time is in the answer: seconds, with a file."""
        return 1.0 if self.study is None else self.study.scales.time

    def of(self, name: str, end: str = "") -> tuple[str, float]:
        """What a column of states or a measure of motions is called, and what one of it is in the answer."""
        coordinate = self.si.get(name)
        if coordinate is None and self.study is not None and name in (*RATES, "period"):
            return (f"{name}_s", self.time) if name == "period" else (f"{name}_per_s", 1.0 / self.time)
        si = "N" if name in FORCES else self.si[self.model.coordinates[0]] if name in MEASURED else coordinate or "1"
        if coordinate is None and re.fullmatch(r"(theta|L)(_.*)?", name):  # of a spring
            si = "rad" if name.startswith("theta") else "m"
        return self._titled(name + end, si)

    def row(self, values: Mapping[str, Any], end: str = "") -> dict[str, Any]:
        """Columns of a state, or what is measured of a motion, each under the name that says its unit."""
        titles = ((self.of(name, end), value) for name, value in values.items())
        return {title: _scaled(value, size) for (title, size), value in titles}

    def rows(self, columns: Mapping[str, Any], end: str = "", **more: Sequence[Any]) -> list[dict[str, Any]]:
        """Rows of columns of one length, and of those that have no unit."""
        told = {**self.row(columns, end), **more}
        return [dict(zip(told, row, strict=True)) for row in zip(*told.values(), strict=True)]

    def varied(self, name: str) -> tuple[str, float, str]:
        """A parameter, or with a file its quantity: the parameter, its unit in SI, and its title."""
        entries = self.model.about["parameters"]
        for entry in entries:
            if name == entry["name"] and (self.study is None or name != entry["quantity"] or entry["quantity_unit"] == "1"):
                title, unit = self._titled(name, entry["unit"])
                return name, unit, title
        for entry in entries:
            if name == entry["quantity"]:
                if self.study is None:
                    cure = f"without --data the parameters have no units; give --vary {entry['name']}"
                    raise ParameterError(f"--vary {name}: {cure}")
                title, unit = self._titled(name, entry["quantity_unit"], name)
                return entry["name"], unit, title
        if any(name == entry["name"] for entry in self.model.about["units"]):
            raise ParameterError(
                f"--vary {name}: it is a unit of the model, and several parameters change with it; write a file for each value"
            )
        known = [entry[key] for key in ("name", "quantity") for entry in entries]
        known = list(dict.fromkeys(known if self.study else self.model.parameters))
        raise click.UsageError(f"--vary: {name!r} is not one of {', '.join(known)}{hint(name, known)}")

    def axis(self, name: str, before: str = "", after: str = "") -> tuple[str, float] | None:
        """What an axis of a figure says of a parameter or a coordinate, and what one of the model's own is there.

        None without a file, and of angles, which figures show in degrees.
        """
        if self.study is None or self.model.is_angle(name):
            return None
        from ..figures.labels import symbol

        entries = {entry["name"]: (entry["quantity"], entry["quantity_unit"]) for entry in self.model.about["parameters"]}
        quantity, si = entries.get(name, (name, "m"))
        unit, size = ("", 1.0) if si == "1" else self.study.unit_of(si, quantity if name in entries else "")
        return f"{before}${symbol(quantity)}${f' ({unit})' if unit else ''}{after}", size

    def state(self, name: str) -> float:
        """What one of a coordinate or of its rate is where a state is typed: angles are degrees, their rates are not."""
        if name in self.model.rates:
            return 1.0 if self.study is None else self.study.unit_of(self.si[name])[1]
        return self.of(name)[1]

    def said(self, remarks: Iterable[str]) -> list[str]:
        """Remarks with what they say of parameters and coordinates in the units of the file."""
        return [text.told(self._named) if self.study is not None and isinstance(text, Remark) else str(text) for text in remarks]

    def _named(self, name: str) -> tuple[str, float]:
        """A parameter, by its quantity, or a coordinate."""
        quantities = {entry["name"]: entry["quantity"] for entry in self.model.about["parameters"]}
        return self.varied(quantities[name])[:0:-1] if name in quantities else self.of(name)

    def _titled(self, title: str, si: str, quantity: str = "") -> tuple[str, float]:
        """A title with its unit, and what one of the model's own units is there."""
        if si == "rad":
            return f"{title}_deg", math.degrees(1.0)
        if self.study is None or si == "1":
            return title, 1.0
        unit, size = self.study.unit_of(si, quantity)
        return f"{title}_{unit}", size


def _scaled(value: Any, size: float) -> Any:
    """A value, or all of several, in a unit; a complex number as its two parts."""
    if isinstance(value, np.ndarray | list | tuple):
        return [_scaled(one, size) for one in value]
    if isinstance(value, complex):
        return [size * float(value.real), size * float(value.imag)]
    value = value.item() if isinstance(value, np.generic) else value
    return size * value if isinstance(value, float) else value
