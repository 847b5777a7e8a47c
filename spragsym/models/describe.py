"""A model in words: its drawing, coordinates and parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any


def described(about: Mapping[str, Any]) -> str:
    """Summary, drawing and tables of a ``model.json``."""
    parts = [f"{about['name']}: {about['summary']}", about["drawing"].strip()]
    coordinates = [("coordinate", "meaning")]
    coordinates += [
        (entry["name"], entry["meaning"] + (", radians" if entry["unit"] == "rad" else "")) for entry in about["coordinates"]
    ]
    parameters = [("parameter", "base", "allowed", "of", "meaning")]
    parameters += [
        (
            entry["name"],
            "" if entry["base"] is None else f"{entry['base']:g}",
            entry["domain"],
            {"both": "statics and motion", "motion": "motion"}[entry["role"]],
            entry["meaning"] + (", radians" if entry["unit"] == "rad" else _behind(entry)),
        )
        for entry in about["parameters"]
    ]
    return "\n\n".join([*parts, _table(coordinates), _table(parameters), f"measured in: {units_of(about)}"])


def units_of(about: Mapping[str, Any]) -> str:
    """What lengths, times and forces are measured in, in the quantities of the page."""
    return ", ".join(f"{name} {about['scales'][name].replace('**', '^')}" for name in ("length", "time", "force"))


def explained(about: Mapping[str, Any]) -> dict[str, tuple[str, str]]:
    """Unit and meaning of everything that files of motions hold, by its name."""
    found = {"t": (about["scales"]["time"], "time"), "error": ("1", "largest difference to a run at a tighter tolerance")}
    for entry in about["coordinates"]:
        name, rate = entry["name"], entry["rate"]
        found |= {name: (entry["scale"], entry["meaning"]), rate: (entry["rate_scale"], f"rate of {name}")}
        found |= {f"{name}0": (entry["scale"], f"initial {name}"), f"{rate}0": (entry["rate_scale"], f"initial {rate}")}
    for entry in about["parameters"]:
        found[entry["name"]] = (entry["unit"], entry["meaning"])
    for name in about["angles"]:
        found[f"{name}_deg"] = ("degree", found[name][1])
    return found


def _behind(entry: Mapping[str, Any]) -> str:
    """The quantity with a unit behind a dimensionless one."""
    return "" if entry["quantity"] == entry["name"] else f" ({entry['quantity']}, dimensionless)"


def _table(rows: Sequence[Sequence[str]]) -> str:
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows)
