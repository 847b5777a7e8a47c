"""The solver for one point, and the generated algebra without the wrapper that restores shapes."""

from __future__ import annotations

import inspect

from ...generated import equilibrium as _equilibrium
from ...generated import stability as _stability
from ...generated.kernel import (
    Balance,
    Direction,
    Point,
    Root,
    apart,
    arctangent,
    at_root,
    balance,
    cosine_and_sine,
    cubic,
    depressed,
    discriminant,
    factors,
    guesses,
    one_positive,
    polish,
    quartic,
    root_pair,
    stability,
)

__all__ = [
    "Balance",
    "Direction",
    "Point",
    "Root",
    "apart",
    "arctangent",
    "at_root",
    "balance",
    "cosine_and_sine",
    "cubic",
    "depressed",
    "discriminant",
    "f",
    "f_coefficients",
    "f_curvature",
    "f_slope",
    "f_third",
    "factors",
    "guesses",
    "invariants",
    "one_positive",
    "polish",
    "quartic",
    "resolvent",
    "root_pair",
    "stability",
    "state",
    "stiffness",
    "t_quartic",
]

f_coefficients = inspect.unwrap(_equilibrium.f_coefficients)
resolvent = inspect.unwrap(_equilibrium.resolvent)
t_quartic = inspect.unwrap(_equilibrium.t_quartic)
f = inspect.unwrap(_equilibrium.f)
f_slope = inspect.unwrap(_equilibrium.f_slope)
f_curvature = inspect.unwrap(_equilibrium.f_curvature)
f_third = inspect.unwrap(_equilibrium.f_third)
state = inspect.unwrap(_equilibrium.state)
stiffness = inspect.unwrap(_stability.stiffness)
invariants = inspect.unwrap(_stability.invariants)
