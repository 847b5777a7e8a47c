"""One mass on a belt under steep friction laws: its page, and the return time of its motion by SciPy's Radau on the equation by hand."""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from tests.oracles.user_pages import model_of, shipped_page

#: Steep factor of each law on the page, and its value and slope by hand.
LAWS = {
    "tanh": ("tanh(d * v)", lambda z: (math.tanh(z), 1 - math.tanh(z) ** 2)),
    "arctan": ("2 / pi * atan(d * v)", lambda z: (2 / math.pi * math.atan(z), 2 / math.pi / (1 + z * z))),
    "exponential": (
        "(1 - exp(-d * Abs(v))) * sgn(v)",
        lambda z: (math.copysign(-math.expm1(-abs(z)), z), math.exp(-abs(z))),
    ),
}  # fmt: skip


def model(law: str) -> Any:
    """The model of μ_s/(1 + δ|v|) times the steep factor."""
    text = f"mu_s / (1 + Abs(delta) * Abs(v)) * {LAWS[law][0]}"
    return model_of(
        shipped_page(
            "stick_slip", ("import Page", "import Abs, Page, atan, exp, pi, sgn, tanh"),
            ("2 * mu_s * v * v_s / (v**2 + v_s**2)", text),
            ('v_s = page.parameter("v_s", "m/s", "sliding speed at which friction is largest", "> 0", 0.1)\n',
             'delta = page.parameter("delta", "s/m", "fall", "real", 0.5)\nd = page.parameter("d", "s/m", "steepness", "> 0", 1e2)\n'),
        ),
        law,
    )  # fmt: skip


def return_time(law: str, values: Mapping[str, float], state: Any, near: float, rtol: float) -> float:
    """The time nearest to ``near`` between two maxima of x, over a little more than three such times."""
    mu_s, delta, zeta, V, d = (values[name] for name in ("mu_s", "delta", "zeta", "V", "d"))

    def friction(v: float) -> tuple[float, float]:
        fall = mu_s / (1 + delta * abs(v))
        value, slope = LAWS[law][1](d * v)
        return fall * value, fall * d * slope - fall**2 * delta / mu_s * math.copysign(value, v * value) * math.copysign(1, v)

    found = solve_ivp(
        lambda _, y: (y[1], -y[0] - zeta * y[1] + friction(V - y[1])[0]), (0, 3.3 * near), state, method="Radau",
        jac=lambda _, y: ((0, 1), (-1, -zeta - friction(V - y[1])[1])), rtol=rtol, atol=1e-3 * rtol, events=_maximum,
    )  # fmt: skip
    times = found.t_events[0]
    gaps = np.subtract.outer(times, times)
    return float(gaps.ravel()[np.argmin(np.abs(gaps - near))])


def _maximum(_: float, y: Any) -> float:
    return float(y[1])


_maximum.direction = -1  # type: ignore[attr-defined]  # as SciPy wants it
