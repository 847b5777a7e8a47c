"""The successor of a fold: the equilibrium that is left where two meet, to which the state jumps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..quartic import kernel


def landing(t: Any, trig: tuple[Any, ...], sqrt: Callable[[Any], Any]) -> Any:
    """tan(θ/2) of the third equilibrium where t = tan(θ/2) is a double root of the quartic in t, for any kind of numbers.

    The roots multiply to −1 and their sum stands in the quartic, so the two others solve τ² + g τ − 1/t² = 0, and one of them is
    positive. ``trig`` is a, b, d, m of f.
    """
    *_, e3, e4 = kernel.t_quartic(*trig)
    g = 2 * t + e3 / e4
    return (sqrt(g * g + 4 / (t * t)) - g) / 2
