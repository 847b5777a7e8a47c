"""The article's cases: its base values first, then those of its Figures 8 to 10."""

import math

from ..models.parameters import Parameters

#: Name, θ₀ in degrees, and what differs from the base values.
_CASES: tuple[tuple[str, float, dict[str, float]], ...] = (
    ("Article, base values, before the fold: θ₀ = 30°", 30.0, {}),
    ("Article, past the fold: θ₀ = 49°", 49.0, {}),
    ("Article, friction below the cusp: μ₀ = 0.15", 49.0, {"mu0": 0.15}),
    ("Article, Figure 8: β = 1", 30.0, {"beta": 1.0}),
    ("Article, Figure 8: β = 2, no jump", 30.0, {"beta": 2.0}),
    ("Article, Figure 9: α = 0.07", 30.0, {"alpha": 0.07}),
    ("Article, Figure 9: α = 0.7, flutter at θ₀ = 150°", 150.0, {"alpha": 0.7}),
    ("Article, Figure 10: σ = 0.01", 30.0, {"sigma": 0.01}),
    ("Article, Figure 10: σ = 1", 30.0, {"sigma": 1.0}),
)


def cases() -> tuple[tuple[str, Parameters], ...]:
    """Named points of all parameters."""
    return tuple((name, Parameters.article(theta0=math.radians(angle), **changed)) for name, angle, changed in _CASES)
