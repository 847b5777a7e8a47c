"""Shipped pages with the kilogram, the metre and the second as units of measure: what they measure
in themselves are parameters, so that all lengths, times and masses can be scaled.
"""

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy as sp

from tests.oracles.user_pages import model_of, shipped_page

UNITS = """page.unit("kg_", "kg", "kilogram")
page.unit("m_", "m", "metre")
page.unit("s_", "s", "second")
"""

#: A call that makes a quantity a unit of measure.
UNIT = re.compile(r'page\.unit\(("[^"]*", "[^"]*", "[^"]*")(?:, latex="[^"]*")?\)')


def dimensional(name: str) -> Any:
    """The model of a shipped page, measured in kilograms, metres and seconds."""
    text = UNIT.sub(r'page.parameter(\1, "> 0", 1.0)', shipped_page(name))
    first = re.search(r"^\w+ = page\.parameter", text, re.MULTILINE)
    assert first
    return model_of(text[: first.start()] + UNITS + text[first.start() :], f"{name}_in_si")


def unit(scale: str, sizes: Sequence[float]) -> float:
    """The unit of a quantity whose ``scale`` stands in model.json, with the sizes of kilogram,
    metre and second.
    """
    return float(sp.sympify(scale).subs(dict(zip(("kg_", "m_", "s_"), sizes, strict=True))))


def units(model: Any, sizes: Sequence[float]) -> tuple[dict[str, float], Any]:
    """Units of all parameters, and of a state."""
    about = model.about
    rates = [entry["rate_scale"] for entry in about["coordinates"]]
    places = [entry["scale"] for entry in about["coordinates"]]
    of_parameters = {entry["name"]: unit(entry["scale"], sizes) for entry in about["parameters"]}
    return of_parameters, np.array([unit(scale, sizes) for scale in (*places, *rates)])
