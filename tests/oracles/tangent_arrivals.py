"""Damped stick-slip with a static and a kinetic coefficient, and where its arrival at x′ = V becomes
tangent, in closed form.

It slips from x = μ_s − ζ V at the speed V, on x″ + ζ x′ + x = μ_k. All is linear in Δ = μ_s − μ_k and
V: the largest speed that it comes to after a turn is V where V/Δ has one value, which depends on ζ
alone. Beyond, the block slides on, and winds onto steady sliding.
"""

import math
from typing import Any

from scipy.optimize import brentq

from tests.oracles.user_pages import model_of, shipped_page


def model() -> Any:
    """The shipped page with a damper beside its spring."""
    damper = '"c", "N s/m", "damper", ">= 0", 0.05, becomes="zeta"'
    page = shipped_page(
        "coulomb_stick_slip",
        ("V = page.parameter(", f"c = page.parameter({damper})\nV = page.parameter("),
        ("page.spring(k, along=x)", "page.spring(k, along=x)\npage.damper(c, along=x)"),
    )
    return model_of(page, "damped_stick_slip")


def ratio(zeta: float) -> float:
    """V/Δ at which the arrival is tangent."""

    def beyond(ratio: float) -> float:
        """How much the largest speed after a turn is above that of the belt, for Δ = 1."""
        # u = x − μ_k = A e^(λ t) + its conjugate; u′ is largest where u″ = 0
        root = complex(-zeta / 2, math.sqrt(1 - zeta**2 / 4))
        u, speed = 1 - zeta * ratio, ratio
        part = (speed - root.conjugate() * u) / (root - root.conjugate())
        turned = part * root**2
        begin = math.atan2(turned.imag, turned.real)
        # Re(A λ² e^(λ t)) = 0: the second zero after the start at which u″ comes from above
        t = next(
            t
            for k in range(9)
            if (t := (math.pi / 2 + 2 * math.pi * k - begin) / root.imag) > math.pi / 2
        )
        grown = part * root * complex(math.cos(root.imag * t), math.sin(root.imag * t))
        return 2 * math.exp(root.real * t) * grown.real - ratio

    return float(brentq(beyond, 1e-3, 1e3, xtol=1e-15, rtol=1e-15))
