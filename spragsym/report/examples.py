"""A file of data to begin with, for any model."""

from __future__ import annotations

import json
import math
from importlib import resources
from pathlib import Path

from ..models import Model
from ..models.load import USUAL
from .brake_quantities import scale_of

#: What one of a unit of measure is in the file, by its unit in SI.
_SIZES = {"kg": 0.35, "N/m": 1.5e6, "m": 0.038}


def example(model: Model) -> str:
    """The text of ``brake.toml``: the article's example, or the base values of a model with its units of measure as there.

    Examples
    --------
    >>> import spragsym as ss
    >>> example(ss.load("stick_slip")).splitlines()[1:3]
    ['[brake]', 'model = "stick_slip"']
    """
    if model.where == USUAL:
        return (resources.files("spragsym.report") / "brake.toml").read_text(encoding="utf-8")
    about, (_, p) = model.about, model.cases()[0]
    units = {entry["name"]: (_SIZES.get(entry["unit"], 1.0), entry["unit"]) for entry in about["units"]}
    rows = [
        (name, _written(size, unit), entry["meaning"])
        for entry, (name, (size, unit)) in zip(about["units"], units.items(), strict=True)
    ]
    for entry in about["parameters"]:
        value, unit = float(getattr(p, entry["name"])), entry["quantity_unit"]
        rows.append(
            (entry["quantity"], _written(value if unit == "rad" else value * scale_of(unit, units), unit), entry["meaning"])
        )
    lines = [f"{name} = {text}  # {meaning}" for name, text, meaning in rows]
    where = model.where if model.where == model.name else Path(model.where).as_posix()
    return "\n".join([f"# {about['summary']}", "[brake]", f"model = {json.dumps(where, ensure_ascii=False)}", *lines]) + "\n"


def _written(value: float, unit: str) -> str:
    """A quantity with its unit, an angle in degrees."""
    if unit == "rad":
        return f'"{math.degrees(value):.6g} deg"'
    return f"{value:.6g}" if unit == "1" else f'"{value:.6g} {unit}"'
