"""The article's equations of motion (8)–(11) in plain numbers, written by hand: what other
integrators are handed.
"""

import math
from collections.abc import Sequence
from typing import Any

from scipy.integrate import solve_ivp

from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam.parameters import Parameters

#: cos θ₀, sin θ₀, μ₀, κ, α, σ, β, V, d.
Constants = Sequence[float]


def accelerations(
    state: Sequence[float], constants: Constants, contact: bool, side: float
) -> tuple[float, float]:
    """x″ and y″ in contact or in lift-off, for the belt ahead (1) or the mass (−1), continued
    beyond the regime.
    """
    x, y, vx, _ = state
    cos0, sin0, mu0, kappa, alpha, sigma, beta, V, d = constants
    along, across = cos0 - x, sin0 - y
    length = math.hypot(along, across)
    pull = sigma * (length - 1) / length
    n = -y if contact else 0.0
    mu = mu0 * side * -math.expm1(-d * side * (V - vx))
    return pull * along - alpha * x + mu * n, pull * across - beta * y + n - kappa


def slopes(
    state: Sequence[float], constants: Constants, contact: bool, side: float
) -> tuple[tuple[float, ...], ...]:
    """Their derivatives by x, y, x', y'."""
    x, y, vx, _ = state
    cos0, sin0, mu0, _, alpha, sigma, beta, V, d = constants
    along, across = cos0 - x, sin0 - y
    length = math.hypot(along, across)
    turn = sigma / length**3  # σ (1 − 1/L), derived
    firm = sigma * (1 - 1 / length)
    on = 1.0 if contact else 0.0
    decay = math.exp(-d * side * (V - vx))
    mu, slope = mu0 * side * (1 - decay), -mu0 * d * decay
    return (
        (-firm - turn * along**2 - alpha, -turn * along * across - mu * on, -slope * y * on, 0.0),
        (-turn * along * across, -firm - turn * across**2 - beta - on, 0.0, 0.0),
    )


def everywhere(state: Sequence[float], constants: Constants) -> tuple[float, float]:
    """x″ and y″, kinked where y = 0 and where x' = V."""
    slip = constants[7] - state[2]
    return accelerations(state, constants, state[1] < 0, math.copysign(1.0, slip) if slip else 0.0)


def integrated(
    p: Parameters, V: float, d: float, start: Sequence[float], t_end: float, **options: Any
) -> Any:
    """The motion by ``solve_ivp``, which knows nothing of kinks."""
    theta0, *others = p.scalars(*PARAMETERS)
    constants = (math.cos(theta0), math.sin(theta0), *others, V, d)
    return solve_ivp(
        lambda _, state: [*state[2:], *everywhere(state, constants)], (0.0, t_end), start, **options
    )


def stored(state: Sequence[float], constants: Constants) -> float:
    """Kinetic energy, and the energy of the springs, of the contact and of the preload, which pulls
    towards the belt.
    """
    x, y, vx, vy = state
    cos0, sin0, _, kappa, alpha, sigma, beta, _, _ = constants
    stretch = math.hypot(cos0 - x, sin0 - y) - 1
    springs = sigma * stretch**2 + alpha * x**2 + beta * y**2 + min(y, 0.0) ** 2
    return 0.5 * (vx**2 + vy**2 + springs) + kappa * y
