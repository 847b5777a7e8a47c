"""What axes call the parameters and coordinates of a model."""

from __future__ import annotations

from ..dynamics.pictures import symbol
from ..models import Model


def label(model: Model, name: str) -> str:
    """A parameter, a coordinate or its rate as an axis names it; the page's own symbol is that of a quantity with its unit."""
    if name in model.rates:
        return rf"$\dot{{{label(model, model.coordinates[model.rates.index(name)])[1:-1]}}}$"
    entries = {entry["name"]: entry for entry in model.about["parameters"]}
    own = name in entries and entries[name]["quantity"] == name
    written = entries[name]["symbol"] if own else symbol(name)
    return f"${written}$ (deg)" if name in model.about["angles"] else f"${written}$"
