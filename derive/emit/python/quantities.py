"""The nomenclature as a plain table, for what the runtime says about names, units and ranges."""

import math
from collections.abc import Mapping

from ..quantities import Quantity

_HEAD = '''
from __future__ import annotations

from math import inf, pi
from typing import NamedTuple


class Quantity(NamedTuple):
    """Name in print (LaTeX), meaning, unit, ends of the interval of allowed values, and whether
    each end is left out.
    """

    article: str
    meaning: str
    unit: str
    low: float
    high: float
    low_open: bool
    high_open: bool


'''


def render(
    quantities: Mapping[str, Quantity],
    parameters: tuple[str, ...],
    base_values: Mapping[str, float],
    header: str,
) -> str:
    """``generated/quantities.py``."""
    entries = "".join(
        f"    {name!r}: {_entry(quantity)},\n" for name, quantity in quantities.items()
    )
    base = "".join(f"    {name!r}: {value!r},\n" for name, value in base_values.items())
    return (
        '"""What every name stands for, its unit, its allowed values and its value in the '
        f'article.\n\n{header}\n"""\n'
        f"{_HEAD}"
        f"QUANTITIES: dict[str, Quantity] = {{\n{entries}}}\n\n"
        "#: Dimensionless parameters, in the order in which every function takes "
        f"them.\nPARAMETERS = {parameters!r}\n\n"
        f"#: The article's base values.\nBASE_VALUES: dict[str, float] = {{\n{base}}}\n"
    )


def _entry(quantity: Quantity) -> str:
    allowed = quantity.interval
    ends = (
        f"{_number(allowed.low)}, {_number(allowed.high)}, {allowed.low_open}, {allowed.high_open}"
    )
    return (
        f"Quantity({quantity.article!r}, {quantity.meaning!r}, "
        f"{quantity.scale or quantity.unit!r}, {ends})"
    )


def _number(value: float) -> str:
    return "pi" if value == math.pi else repr(value)
