"""The nomenclature as a plain table, for what the runtime says about names, units and ranges."""

from __future__ import annotations

import math

from ...quantities import Quantity
from .. import Material

_HEAD = '''
from __future__ import annotations

from math import inf, pi
from typing import NamedTuple


class Quantity(NamedTuple):
    """Name in print (LaTeX), meaning, unit, ends of the interval of allowed values, and whether each end is left out."""

    article: str
    meaning: str
    unit: str
    low: float
    high: float
    low_open: bool
    high_open: bool


'''


def render(material: Material, header: str) -> str:
    """``generated/quantities.py``."""
    entries = "".join(f"    {name!r}: {_entry(quantity)},\n" for name, quantity in material.quantities.items())
    base = "".join(f"    {name!r}: {value!r},\n" for name, value in material.base_values.items())
    return (
        f'"""What every name stands for, its unit, its allowed values and its value in the article.\n\n{header}\n"""\n'
        f"{_HEAD}"
        f"QUANTITIES: dict[str, Quantity] = {{\n{entries}}}\n\n"
        f"#: Dimensionless parameters, in the order in which every function takes them.\nPARAMETERS = {material.parameters!r}\n\n"
        f"#: The article's base values.\nBASE_VALUES: dict[str, float] = {{\n{base}}}\n"
    )


def _entry(quantity: Quantity) -> str:
    allowed = quantity.interval
    meaning, unit = (quantity.measured, quantity.scale) if quantity.scale else (quantity.meaning, quantity.unit)
    ends = f"{_number(allowed.low)}, {_number(allowed.high)}, {allowed.low_open}, {allowed.high_open}"
    return f"Quantity({quantity.article!r}, {meaning!r}, {unit!r}, {ends})"


def _number(value: float) -> str:
    return "pi" if value == math.pi else repr(value)
