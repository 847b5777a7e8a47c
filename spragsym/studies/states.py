"""The states of sliding in newtons, millimetres and hertz, and which of them the brake is in."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..catastrophe.paths import quasi_static_path
from ..cycles.sprag import SPRAG
from ..display import Result
from ..parameters import NAMES, FloatArray, Parameters
from ..statics.results import Stability
from ..statics.solver import equilibria
from .study import Study

#: What the eigenvalues of a matrix of four rows are off by, relative to the largest, generously.
ROUNDING = 1e-14
#: Damping ratio below which a state is neither damped nor driven to speak of.
NEUTRAL = 1e-3


@dataclass(frozen=True)
class State(Result):
    """A state of steady sliding in contact.

    ``frequencies_hz`` and ``damping_ratio`` belong to the roots of the motion linearized about it, slowest first, the friction
    law's own damping included where the belt speed is known; ``growth_per_s`` is their largest real part. ``stable`` says that it
    is negative, or zero without damping; ``statics`` is the word of (27) and (28), which leave the damping out. ``settles`` is
    None where that calls it stable, and so little damps or drives it that what the model leaves out decides.
    """

    direction_deg: float
    x_mm: float
    y_mm: float
    spring_length_mm: float
    spring_force_N: float
    contact_force_N: float
    statics: str
    stable: bool
    frequencies_hz: tuple[float, ...]
    damping_ratio: tuple[float, ...]
    growth_per_s: float
    current: bool

    @property
    def settles(self) -> bool | None:
        """Whether a small disturbance dies out."""
        least = min(self.damping_ratio, default=math.inf)
        return None if self.statics == "stable" and (self.growth_per_s == 0 or abs(least) < NEUTRAL) else self.stable


def states(study: Study, friction: float | None = None) -> tuple[State, ...]:
    """Every state in contact at the friction that works, by θ; the one that is reached as friction rises is ``current``."""
    working = study.friction[1] if friction is None else friction
    p = study.dimensionless.replace(mu0=working)
    eq = equilibria(p)
    here = current_theta(p)
    found = []
    for slot in range(int(eq.count)):
        theta, L, x, y = (float(getattr(eq, name)[slot]) for name in ("theta", "L", "x", "y"))
        roots = _roots(study, p, theta, L, x, y, eq.eigenvalues[slot])
        current = slot == int(np.nanargmin(np.abs(eq.theta - here)))
        found.append(_state(study, p, (theta, L, x, y), Stability(int(eq.stability[slot])), roots, current))
    return tuple(found)


def current_theta(p: Parameters) -> float:
    """θ of the state that is reached from small deformation as the friction rises from 0 to μ₀."""
    (mu0,) = p.scalars("mu0")
    values = [0.0, mu0] if mu0 > 0 else [0.0]
    return float(quasi_static_path(p, "mu0", values).theta[-1])


def _roots(study: Study, p: Parameters, theta: float, L: float, x: float, y: float, undamped: Any) -> Any:
    """λ over the unit of time: of (8)–(11) linearized, or of (27) where the belt speed is not known."""
    if not study.moves:
        return undamped
    belt = study.parameters.belt()
    (mu0,) = study.dimensionless.scalars("mu0")
    if study.friction[1] > 0:
        mu0 *= p.scalars("mu0")[0] / study.friction[1]
    values = (*p.replace(mu0=mu0).scalars(*NAMES), belt["V"], belt["d"])
    constants = SPRAG.constants(values)
    rows = np.array(SPRAG.jacobian((x, y, 0.0, 0.0), constants, (1, 1, 1), math), dtype=float)
    matrix = np.vstack([np.hstack([np.zeros((2, 2)), np.eye(2)]), rows])
    return np.linalg.eigvals(matrix)


def _state(
    study: Study, p: Parameters, place: tuple[float, float, float, float], kind: Stability, roots: FloatArray, current: bool
) -> State:
    theta, L, x, y = place
    scales = study.scales
    rate = np.asarray(roots, dtype=complex) / scales.time
    size = float(np.abs(rate).max())
    # Where nothing damps, as without friction, the sign of the real part is the rounding's.
    rate = np.where(np.abs(rate.real) <= ROUNDING * size, 1j * rate.imag, rate)
    upper = sorted((root for root in rate if root.imag > 1e-9 * size), key=lambda root: float(root.imag))
    growth = float(rate.real.max())
    stable = growth < 0 if study.moves and growth else kind == Stability.STABLE
    (sigma,) = p.scalars("sigma")
    millimetre = 1e3 * scales.length
    return State(
        math.degrees(theta), x * millimetre, y * millimetre, L * millimetre, sigma * (L - 1.0) * scales.force, -y * scales.force,
        kind.name.lower(), bool(stable), tuple(float(root.imag) / (2 * math.pi) for root in upper),
        tuple(float(-root.real / abs(root)) + 0.0 for root in upper), growth, current,
    )  # fmt: skip
