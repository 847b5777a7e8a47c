"""Motions of two blocks on a belt by a driver of its own: forces written by hand, every event found
by SciPy, and what each block does next by the force that would hold it.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

#: Ranges of the parameters that are drawn.
RANGES = {
    "beta": (0.6, 1.6),
    "kappa": (0.2, 1.5),
    "mu_s": (0.4, 0.9),
    "mu_k": (0.1, 0.4),
    "N_1": (0.6, 1.4),
    "N_2": (0.6, 1.4),
    "V": (0.05, 0.4),
}


def drawn(seed: int) -> tuple[dict[str, float], list[float]]:
    """Parameters and a start, coordinates then rates."""
    rng = np.random.default_rng(seed)
    values = {name: float(rng.uniform(*ends)) for name, ends in RANGES.items()}
    return values, [*rng.uniform(-0.8, 0.8, 2).tolist(), *rng.uniform(-0.5, 0.5, 2).tolist()]


def alike(rng: np.random.Generator) -> tuple[dict[str, float], Any, Any]:
    """Two identical blocks that start at 0 with the belt, and the times at which both slip and both
    stick again: of μ_s N/V on they slip every 2 Δ/V + 2 π − 2 atan(Δ/V), Δ = (μ_s − μ_k) N.
    """
    mu_k, more, V, N, kappa = (
        float(rng.uniform(*ends))
        for ends in ((0.1, 0.5), (0.05, 0.5), (0.05, 0.5), (0.5, 2.0), (0.0, 2.0))
    )
    values = {"beta": 1.0, "kappa": kappa, "mu_s": mu_k + more, "mu_k": mu_k, "V": V}
    ratio = more * N / V
    slide = 2 * math.pi - 2 * math.atan(ratio)
    slips = values["mu_s"] * N / V + (2 * ratio + slide) * np.arange(4)
    return values | {"N_1": N, "N_2": N}, slips, slips[:-1] + slide


class Driver:
    """Two blocks with friction μ N, where ``falling`` μ_s/(1 + v/μ_k), else μ_k, on the belt."""

    def __init__(self, values: Mapping[str, float], falling: bool = False) -> None:
        beta, kappa = values["beta"], values["kappa"]
        self.stiffness = np.array([[1 + kappa, -kappa], [-kappa, beta + kappa]])
        self.normal = np.array([values["N_1"], values["N_2"]])
        self.mu_s, self.mu_k, self.V = (values[name] for name in ("mu_s", "mu_k", "V"))
        self.falling = falling
        #: Time, "STICK", "SLIP" or the side that it turns to, and the block.
        self.events: list[tuple[float, str, int]] = []

    def rub(self, speed: float) -> float:
        """The coefficient at a sliding speed, which is positive."""
        return self.mu_s / (1 + speed / self.mu_k) if self.falling else self.mu_k

    def rates(self, side: list[int]) -> Callable[[float, Any], Any]:
        """The equations of motion while each block slips on its side, or sticks (0)."""

        def rates(_: float, z: Any) -> Any:
            pull = self.stiffness @ z[:2]
            forces = [
                side[i] * self.rub(side[i] * (self.V - z[2 + i])) * self.normal[i]
                if side[i]
                else pull[i]
                for i in (0, 1)
            ]
            return [*z[2:], *(forces - pull)]

        return rates

    def next(self, i: int, z: Any) -> int:
        """What a block does that is as fast as the belt."""
        pull = float(self.stiffness[i] @ z[:2])
        return 0 if abs(pull) <= self.mu_s * self.normal[i] else int(math.copysign(1, pull))

    def run(self, start: list[float], t_end: float) -> Any:
        """The state at the end."""
        z, t = np.array(start, dtype=float), 0.0
        side = [int(math.copysign(1, self.V - z[2 + i])) for i in (0, 1)]
        while t < t_end:
            events = [self._leaves(i, side[i], t) for i in (0, 1)]
            part = solve_ivp(
                self.rates(side),
                (t, t_end),
                z,
                "DOP853",
                events=events,
                rtol=2.3e-14,
                atol=1e-15,
                max_step=0.02,
            )
            t, z = float(part.t[-1]), part.y[:, -1]
            for i in (0, 1):
                if not part.t_events[i].size:
                    continue
                z[2 + i] = self.V
                if side[i]:
                    turned = self.next(i, z)
                    word = ("BELT_OVERTAKES", "STICK", "MASS_OVERTAKES")[1 - turned]
                else:
                    word, turned = "SLIP", int(math.copysign(1, self.stiffness[i] @ z[:2]))
                side[i] = turned
                self.events.append((t, word, i))
        return z

    def _leaves(self, i: int, side: int, begin: float) -> Callable[[float, Any], float]:
        """What is 0 where block i leaves its mode, over the time since the motion entered it.

        A block that has just left the speed of the belt has it at ``begin``, and may have it again
        before the first step ends: of the two roots the quotient has the second only.
        """

        def slips(_: float, z: Any) -> float:
            return float(side * (self.V - z[2 + i]))

        def holds(_: float, z: Any) -> float:
            return float(self.mu_s * self.normal[i] - abs(self.stiffness[i] @ z[:2]))

        level = slips if side else holds

        def found(t: float, z: Any) -> float:
            return level(t, z) / (t - begin) if t > begin else level(t, z) or 1.0

        event: Any = found
        event.terminal, event.direction = True, -1
        return event
