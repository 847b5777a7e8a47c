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


def largest_push(w: float, mu_s: float, mu_k: float) -> float:
    """The P at which a mass on a belt at rest, pushed by P cos(w t), slips as P cos(w t) − x, which
    holds it, just touches its limit μ_s, from −x₀ to x₀, where it stops.

    x = A cos t + P cos(w t)/(1 − w²) − μ_k from x₀ = P − μ_s on, at rest.
    """

    def push(t: float) -> float:
        """At rest after the time t."""
        of_push = w * math.sin(w * t) - w**2 * math.sin(t)
        return (mu_s - mu_k) * math.sin(t) * (1 - w**2) / of_push

    def beyond(t: float) -> float:
        """How far from the other side of 0."""
        P = push(t)
        A = -P * w**2 / (1 - w**2) - (mu_s - mu_k)
        return A * math.cos(t) + P / (1 - w**2) * math.cos(w * t) - mu_k + P - mu_s

    # Friction that falls little makes the slip short: the root is below half a turn of the mass.
    return push(float(brentq(beyond, 1.2, math.pi - 1e-3, xtol=1e-15)))
