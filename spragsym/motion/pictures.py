"""A motion over time, drawn."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .simulation import Trajectory

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


def axis_label(model: Any, name: str) -> str:
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


def course_over_time(
    motion: Trajectory, of: str, ax: Any, *, scale: tuple[float, float] = (1.0, 1.0), labels: tuple[str, str] | None = None,
    style: dict[str, Any] | None = None,
) -> Any:  # fmt: skip
    """A component over time, both times their scale, with labels on the axes; returns the line."""
    t = np.linspace(motion.t[0], motion.t[-1], 4000)
    (line,) = ax.plot(scale[0] * t, scale[1] * motion(t)[motion.components.index(of)], **(style or {}))
    across, up = labels or (axis_label(motion.model, "t"), axis_label(motion.model, of))
    ax.set(xlabel=across, ylabel=up)
    return line
