"""Points to begin at, of models that name none of their own."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..parameters import ParameterSet
    from .model import Model

#: What a parameter without a base value is: an inclination as in the article's cases, any other in the middle of its range.
_INCLINATION = math.radians(30.0)


def cases(model: Model) -> tuple[tuple[str, ParameterSet], ...]:
    """One point, the base values, of all parameters."""
    values = {}
    for entry in model.about["parameters"]:
        low, high = entry["low"], entry["high"]
        angle = entry["name"] in model.about["angles"]
        middle = _INCLINATION if angle else 0.5 * (low + high) if low is not None and high is not None else 1.0
        values[entry["name"]] = middle if entry["base"] is None else entry["base"]
    return (("Base values", model.Parameters(**values)),)
