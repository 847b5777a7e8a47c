"""What a command prints, in degrees; with ``--data`` in the units of that file."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import click

from ..errors import ParameterError
from ..names import hint

if TYPE_CHECKING:
    from ..models import Model
    from ..report import Study

#: Of a motion what is measured in the unit of its first component, and what is a force.
MEASURED, FORCES = ("rms", "rms_about_mean", "mean", "amplitude", "largest", "error"), ("spring_force", "contact_force")


#: A number in a remark.
NUMBER = re.compile(r"-?(?:\d+\.?\d*(?:e[-+]?\d+)?|inf)")


@dataclass(frozen=True)
class Units:
    """Units of the answers about a model: without dimension and angles in degrees, or those of a file of a brake."""

    model: Model
    study: Study | None = None

    def place(self, name: str, end: str = "") -> tuple[str, float]:
        """What a coordinate, a direction or a length of a spring is called, and what one of it is there."""
        known = {entry["name"]: entry["unit"] for entry in self.model.about["coordinates"]}
        return self._of(name + end, known.get(name, "rad" if name.partition("_")[0] == "theta" else "m"))

    def rate(self, name: str) -> tuple[str, float]:
        """The same of a rate of growth, and of a frequency."""
        return (name, 1.0) if self.study is None else (f"{name}_per_s", 1.0 / self.study.scales.time)

    def varied(self, name: str) -> tuple[str, float, str]:
        """Of a parameter, or with a file of a quantity: the parameter, what one of it is there, and what it is called."""
        entries = self.model.about["parameters"]
        for entry in entries:
            if name == entry["name"] and (self.study is None or name != entry["quantity"] or entry["quantity_unit"] == "1"):
                title, unit = self._of(name, entry["unit"])
                return name, unit, title
        for entry in entries:
            if name == entry["quantity"]:
                if self.study is None:
                    raise ParameterError(
                        f"--vary {name}: without --data the parameters have no units; give --vary {entry['name']}"
                    )
                title, unit = self._of(name, entry["quantity_unit"], name)
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
        from ..motion.pictures import symbol

        entries = {entry["name"]: (entry["quantity"], entry["quantity_unit"]) for entry in self.model.about["parameters"]}
        quantity, si = entries.get(name, (name, "m"))
        unit, size = ("", 1.0) if si == "1" else self.study.unit_of(si, quantity if name in entries else "")
        return f"{before}${symbol(quantity)}${f' ({unit})' if unit else ''}{after}", size

    def of_time(self, title: str) -> tuple[str, float] | None:
        """The same of a time."""
        return None if self.study is None else (f"{title} (s)", self.time)

    def state(self, name: str) -> float:
        """What one of a coordinate or of its rate is where a state is typed: angles are degrees, their rates are not."""
        rates = {entry["rate"]: entry["unit"] for entry in self.model.about["coordinates"]}
        if name not in rates:
            return self.place(name)[1]
        return 1.0 if self.study is None else self.study.unit_of("1/s" if rates[name] == "rad" else "m/s")[1]

    @property
    def time(self) -> float:
        """What one of a time is in the answer: seconds, with a file."""
        return 1.0 if self.study is None else self.study.scales.time

    def parameter(self, name: str) -> tuple[str, float]:
        """What a parameter is called, and what one of it is there."""
        return (f"{name}_deg", math.degrees(1.0)) if name in self.model.about["angles"] else (name, 1.0)

    def said(self, remarks: Iterable[str]) -> list[str]:
        """Remarks with what they say of parameters and coordinates, ``x = 1`` or ``x in [0, 1]``, in the units of the file."""
        if self.study is None:
            return list(remarks)
        told = {entry["name"]: self.place(entry["name"]) for entry in self.model.about["coordinates"]}
        for entry in self.model.about["parameters"]:
            _, unit, title = self.varied(entry["quantity"])
            told[entry["name"]] = title, unit

        def in_units(found: re.Match[str]) -> str:
            title, unit = told[found[1]]
            numbers = NUMBER.sub(lambda number: f"{unit * float(number[0]):.8g}", found[2])
            return title + numbers

        names = "|".join(map(re.escape, sorted(told, key=len, reverse=True)))
        place = re.compile(rf"(?<![\w.])({names})(?:( = {NUMBER.pattern}| in \[{NUMBER.pattern}, {NUMBER.pattern}\])(?: rad)?)")
        return [place.sub(in_units, text) for text in remarks]

    def measured(self, summary: dict[str, Any]) -> dict[str, Any]:
        """What is measured of a motion, each under a name that says its unit."""
        found = {}
        for name, value in summary.items():
            key, unit = self._measure(name)
            scaled = [unit * one for one in value] if isinstance(value, list) and key != name else value
            found[key] = value * unit if key != name and isinstance(value, float) else scaled
        return found

    def _measure(self, name: str) -> tuple[str, float]:
        if name in MEASURED:
            return self._of(name, self.model.about["coordinates"][0]["unit"])
        if name in FORCES and self.study is not None:
            return self._of(name, "N")
        if name == "period" and self.study is not None:
            return "period_s", self.study.scales.time
        return name, 1.0

    def _of(self, title: str, si: str, quantity: str = "") -> tuple[str, float]:
        """A title with its unit, and what one of the model's own units is there."""
        if si == "rad":
            return f"{title}_deg", math.degrees(1.0)
        if self.study is None or si == "1":
            return title, 1.0
        unit, size = self.study.unit_of(si, quantity)
        return f"{title}_{unit}", size
