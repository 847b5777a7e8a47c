"""Searches of pages with angles that may turn and with hardening springs: all states against those that
SciPy finds from 200 starts, of forces written by hand.
"""

from typing import Any

import numpy as np
from scipy.optimize import root

import spragsym as ss
from tests.oracles.stubborn_pages import hardening, pendulum

CASES = 60


def of_pendulum(rng: np.random.Generator) -> tuple[Any, Any, Any, float]:
    """A set of the two rods; its forces and its gap; and how far states are looked for."""
    v = {"mu0": rng.uniform(0, 0.8), "G": rng.uniform(0.1, 2), "H": rng.uniform(0.8, 1.95)}
    v |= {"K": rng.uniform(5, 50), "k_t": 10 ** rng.uniform(-0.5, 0.5)}
    mu0, G, H, K, k_t = v.values()
    mu0 *= np.tanh(8.0)  # d V

    def gap(q: Any) -> Any:
        return H - np.cos(q[0]) - np.cos(q[1])

    def forces(q: Any) -> Any:
        (a, b), N = q, -K * gap(q)
        return np.array(
            [
                k_t * (2 * a - b) + 2 * G * np.sin(a) - N * (np.sin(a) + mu0 * np.cos(a)),
                k_t * (b - a) + G * np.sin(b) - N * (np.sin(b) + mu0 * np.cos(b)),
            ]
        )

    return pendulum().Parameters(**v), forces, gap, 15.0


def of_hardening(rng: np.random.Generator) -> tuple[Any, Any, Any, float]:
    """The same of the mass on two springs."""
    v = {"theta0": rng.uniform(0.3, 2.8), "mu0": rng.uniform(0, 0.8), "kappa": 0.007}
    v |= {"alpha": rng.uniform(0.003, 0.1), "sigma": rng.uniform(0.02, 0.3)}
    v |= {"theta0_2": rng.uniform(0.3, 2.8), "sigma_2": rng.uniform(0.01, 0.2)}
    v |= {"lambda_2": rng.uniform(0.5, 2), "k_3": 10 ** rng.uniform(-3, 0.7)}
    theta0, mu0, kappa, alpha, sigma, theta0_2, sigma_2, size, hard = v.values()

    def pull(q: Any, angle: float, length: float, linear: float, cubic: float) -> Any:
        to = length * np.array([np.cos(angle), np.sin(angle)]) - q
        far = np.hypot(*to)
        return -(linear * (far - length) + cubic * (far - length) ** 3) * to / far

    def forces(q: Any) -> Any:
        springs = pull(q, theta0, 1, sigma, 0) + pull(q, theta0_2, size, sigma_2, hard)
        N = -q[1]
        return springs + np.array([alpha * q[0] - mu0 * N, kappa - N])

    p = hardening().Parameters(**v)
    return p, forces, lambda q: q[1], 3.0


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One random set of one of the pages."""
    which = (of_pendulum, of_hardening)[number % 2]
    p, forces, gap, reach = which(rng)
    eq = ss.equilibria(p)
    states = np.array([eq[name] for name in p.model.coordinates]).T
    off = max((float(np.abs(forces(q)).max()) for q in states[: int(eq.count)]), default=0.0)
    wrong, seen = [f"forces of {off} at a state"] * (off > 1e-9), 0
    for _ in range(200):
        tried = root(forces, rng.uniform(-reach, reach, 2), tol=1e-13)
        # Not those that only nearly touch.
        if not tried.success or np.abs(forces(tried.x)).max() > 1e-11 or gap(tried.x) > -1e-9:
            continue
        seen += 1
        if not eq.count or np.abs(states - tried.x).max(axis=1).min() > 1e-6:
            wrong.append(f"lost {tried.x}")
    told = {"kind": which.__name__, "states": int(eq.count), "seen": seen}
    return told | {"wrong": sorted(set(wrong))[:3], "undecided": int(bool(eq.undecided))}
