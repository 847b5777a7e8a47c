"""Example data file for each model."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

from ..files.text import shipped_text
from ..models import Model
from ..models.load import USUAL
from ..models.quantities import factor, quantities
from .units import EXAMPLES, plain_unit

#: Examples for quantities whose size is not that of others with the same unit.
OWN_EXAMPLES: Mapping[str, str] = {"k_x": "9 N/mm", "k_y": "0 N/mm", "k_c": "1500 N/mm"}


def example_of(key: str, unit: str) -> str:
    """Example of a quantity as text, in an engineer's units."""
    return OWN_EXAMPLES.get(key) or EXAMPLES.get(unit, (f"1 {unit}",))[0]


def example(model: Model) -> str:
    """Text of ``brake.toml``: the article's example, or for another model its base values, scaled
    to the size of a brake.

    >>> import spragsym as ss
    >>> example(ss.load("stick_slip")).splitlines()[1:3]
    ['[brake]', 'model = "stick_slip"']
    """
    if model.where == USUAL:
        return shipped_text("spragsym.report", "brake.toml")
    kind, (_, p) = quantities(model.where), model.cases()[0]
    # Typical sizes of the units of measure, by SI unit.
    common = {"kg": 0.35, "N/m": 1.5e6, "m": 0.038, "N": 400.0, "N/m^(3/2)": 8e6}
    sizes = {name: common.get(unit, 1.0) for name, unit in kind.bases.items()}
    values = sizes | {
        quantity: float(p[name]) * kind.scale(kind.units[quantity], sizes)
        for quantity, name in kind.parameters.items()
    }
    # If the model's unit of speed is above 10 m/s, which is too fast for a belt, use example
    # speeds.
    given = ("m/s^2", "m/s", "s/m") if kind.scale("m/s", sizes) > 10.0 else ("m/s^2",)

    def written(name: str, value: float) -> str:
        si = kind.units[name]
        unit = plain_unit(si)
        if si in given:
            return example_of(name, si)
        return f"{float(f'{value / factor(unit, si):.3g}'):g} {unit}".strip()

    load, lines = kind.rises, list[str]()
    tolerances = {"k": " +- 10 %", "k_t": " +- 10 %", "theta0": " +- 1 deg", "mu0": " +- 10 %"}
    for name in kind.units:
        off = "" if name == load else tolerances.get(name, "")
        key = name if name.isascii() else json.dumps(name, ensure_ascii=False)
        entry = f'{key} = "{written(name, values[name])}{off}"'
        lines.append(f"{entry:<32}# {kind.meanings[name]}")
    if not kind.dampers:
        lines.append("# No damping but that of the friction law: the page has no dampers.")
    if load is not None:
        least = kind.ranges()[load]
        lines.append(f'vary = "{load}"')
        lines += (
            [] if least.contains(least.low) else [f'begin = "{written(load, 0.5 * values[load])}"']
        )
    where = Path(model.where).as_posix()
    return (
        "\n".join(
            [
                f"# {kind.about['summary']}",
                "[brake]",
                f"model = {json.dumps(where, ensure_ascii=False)}",
                *lines,
            ]
        )
        + "\n"
    )
