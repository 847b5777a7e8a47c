"""Axis labels of a model's parameters and coordinates, and the ranges that axes show."""

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axis import Axis
from matplotlib.ticker import FuncFormatter, MaxNLocator

from ..models import Model
from ..models.field import Field
from ..results import Points

#: Range of a parameter, by its name.
Between = Mapping[str, tuple[float, float]]
#: What is shown beyond the farthest cusp.
ROOM = 1.25
#: Names that are letters.
GREEK = {
    "alpha", "beta", "gamma", "delta", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "rho", "sigma", "tau", "phi", "psi",
}  # fmt: skip


def symbol(name: str) -> str:
    """A name as mathematics writes it, without the dollars: ``\\kappa``, ``k_{\\rm c}``, ``\\theta_0``."""
    base, _, index = name.partition("_")
    if numbered := re.fullmatch(r"([^\W\d]+)(\d)", base):
        return f"{symbol(numbered[1])}_{numbered[2]}" if not index else f"{symbol(numbered[1])}_{{{numbered[2]}, {index}}}"
    return (rf"\{base}" if base in GREEK else base) + (rf"_{{\rm {index}}}" if index else "")


def axis_label(model: Model, name: str) -> str:
    """What an axis says of a coordinate, of its rate, or of the time ``t``: the symbol over its unit."""
    unit = model.quantities[name][0]
    written = rf"{symbol(model.coordinates[model.rates.index(name)])}'" if name in model.rates else symbol(name)
    if unit in ("1", "rad"):
        return f"${written}$" if unit == "1" else f"${written}$ (rad)"
    letters = in_letters(unit)
    return f"${written}$ / $({letters})$" if r"\," in letters else f"${written}$ / ${letters}$"


def in_letters(scale: str) -> str:
    """The scale of a quantity, as ``L_0*sqrt(k_c)/sqrt(m)``, as mathematics writes it."""
    merged = re.sub(r"sqrt\((\w+)\)/sqrt\((\w+)\)", r"\\sqrt{\1/\2}", scale)
    return re.sub(r"(?<!\\)sqrt\((.+?)\)", r"\\sqrt{\1}", merged).replace("**", "^").replace("*", r"\,")


def label(model: Model, name: str) -> str:
    """A parameter, a coordinate or its rate as an axis names it."""
    if name in model.rates:
        return rf"$\dot{{{label(model, model.coordinates[model.rates.index(name)])[1:-1]}}}$"
    return shown(model, name)[0]


def shown(known: Model | Field, name: str) -> tuple[str, float]:
    """What an axis calls a parameter or a coordinate of a motion, and what one of it is there: angles are degrees."""
    angle = known.is_angle(name)
    return f"${symbol(name)}$ (deg)" if angle else f"${symbol(name)}$", math.degrees(1.0) if angle else 1.0


def as_drawn(model: Model, name: str, values: Any) -> Any:
    """Values of a parameter or a column in the unit of its axis: angles in degrees, all else as it is."""
    return np.degrees(values) if model.is_angle(name) else values


def with_unit(model: Model, name: str) -> str:
    """Axis label with the unit of the model."""
    if model.is_angle(name):
        return label(model, name)
    scales = {entry["name"]: entry["scale"] for entry in model.about["coordinates"]}
    scale = scales.get(name, "1" if name in model.parameters else model.about["scales"]["length"])
    return f"{label(model, name)} ({'dimensionless' if scale == '1' else f'units of ${in_letters(scale)}$'})"


#: What an axis says, and what one of what is drawn is there.
Shown = tuple[str, float]


class _Round(MaxNLocator):
    """Ticks at round numbers in the unit of an axis."""

    def __init__(self, one: float) -> None:
        super().__init__("auto", steps=[1, 2, 2.5, 5, 10])
        self.one = one

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        return [tick / self.one for tick in super().tick_values(self.one * vmin, self.one * vmax)]


def in_units(axis: Axis, shown: Shown | None) -> None:
    """Have an axis show other units than what is drawn is in; None leaves it as it is."""
    if shown is not None:
        title, one = shown
        axis.set_label_text(title)
        if one != 1.0:
            axis.set_major_locator(_Round(one))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{one * value:.6g}"))


def window(model: Model, vary: Sequence[str], between: Between, cusps: Points | None = None) -> Between:
    """Ranges to show: those given, the parameter's own, or one that has room for its base value, for 1 and for all cusps."""
    entries = {entry["name"]: entry for entry in model.about["parameters"]}
    out = dict(between)
    for name in (name for name in vary if name in entries and name not in between):
        entry = entries[name]
        farthest = 0.0 if cusps is None else float(np.abs(getattr(cusps, name)).max(initial=0.0))
        far = max(1.0, 2.0 * abs(entry["base"] or 0.0), ROOM * farthest)
        out[name] = (-far if entry["low"] is None else entry["low"], far if entry["high"] is None else entry["high"])
    return out
