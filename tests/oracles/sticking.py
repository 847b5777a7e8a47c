"""One mass on a belt under steep friction laws."""

import math
from typing import Any

from tests.oracles.user_pages import model_of, shipped_page

#: Steep factor of each law on the page, and its value and slope by hand.
LAWS = {
    "tanh": ("tanh(d * v)", lambda z: (math.tanh(z), 1 - math.tanh(z) ** 2)),
    "arctan": (
        "2 / pi * atan(d * v)",
        lambda z: (2 / math.pi * math.atan(z), 2 / math.pi / (1 + z * z)),
    ),
    "exponential": (
        "(1 - exp(-d * Abs(v))) * sgn(v)",
        lambda z: (math.copysign(-math.expm1(-abs(z)), z), math.exp(-abs(z))),
    ),
}


def model(law: str) -> Any:
    """The model of μ_s/(1 + δ|v|) times the steep factor."""
    text = f"mu_s / (1 + Abs(delta) * Abs(v)) * {LAWS[law][0]}"
    return model_of(
        shipped_page(
            "stick_slip",
            ("import Page", "import Abs, Page, atan, exp, pi, sgn, tanh"),
            ("2 * mu_s * v * v_s / (v**2 + v_s**2)", text),
            (
                'v_s = page.parameter("v_s", "m/s", "sliding speed at which friction is '
                'largest", "> 0", 0.1)\n',
                'delta = page.parameter("delta", "s/m", "fall", "real", 0.5)\nd = '
                'page.parameter("d", "s/m", "steepness", "> 0", 1e2)\n',
            ),
        ),
        law,
    )


def dry() -> Any:
    """The model of dry friction μ_s exp(−v/v_s), which holds by μ_s: x = μ_s exp(−V/v_s) loses its
    stability where μ_s exp(−V/v_s) = ζ v_s.
    """
    law = "slip=lambda v: mu_s * exp(-Abs(v) / v_s) * sgn(v), holds=mu_s"
    return model_of(
        shipped_page(
            "stick_slip",
            ("import Page", "import Abs, Page, exp, sgn"),
            ("lambda v: 2 * mu_s * v * v_s / (v**2 + v_s**2)", law),
        ),
        "dry",
    )
