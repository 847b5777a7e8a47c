"""First Lyapunov coefficients against 50 digits from equations written by hand, and their signs
against motions.

A case is one search: those of the list on shipped pages, then random damped sets. Every fifth has
its signs held against motions from inside and outside of the cycle that is born. It guards the
claim that every proved bound of a coefficient holds (2d3fc3b3).
"""

from typing import Any

import mpmath
import numpy as np

import spragsym as ss
from tests.oracles.hopf_points import against_motions, reference_of

CASES = 60
SHIPPED: tuple[tuple[str, str, dict[str, float], dict[str, tuple[float, float]]], ...] = (
    ("stick_slip", "V", {}, {}),
    ("stick_slip", "zeta", {}, {}),
    ("stick_slip", "mu_s", {"V": 0.3}, {}),
    ("damped", "mu0", {"theta0": 0.7}, {}),
    ("damped", "mu0", {"theta0": 2.2}, {}),
    ("damped", "zeta_x", {"theta0": 0.7, "mu0": 2.5}, {}),
    ("kang_nam", "mu0", {"theta0": 0.7}, {}),
    ("kang_nam", "sigma", {"theta0": 0.7}, {"sigma": (0.01, 2.0)}),
    ("cubic_contact", "mu0", {"theta0": 0.7}, {}),
    ("hertz_contact", "mu0", {"theta0": 0.7}, {}),
    ("inclined_belt", "mu0", {"theta0": 0.7}, {}),
    ("mode_coupling", "mu0", {}, {}),
    ("two_springs", "theta0", {}, {}),
    ("two_springs", "mu0", {"theta0": 1.0}, {}),
)
SPANS = {"mu0": (0.0, 8.0), "theta0": (0.1, 3.04), "sigma": (0.02, 6.0), "alpha": (0.0, 3.0)}


def asked(number: int, rng: np.random.Generator) -> Any:
    """The onsets of a search."""
    if number < len(SHIPPED):
        name, vary, others, between = SHIPPED[number]
        return ss.flutter_onsets(
            ss.load(name).Parameters(**others), vary=vary, between=between or None
        )
    values = {
        "theta0": rng.uniform(0.15, 3.0),
        "kappa": 10 ** rng.uniform(-3, 0),
        "alpha": 10 ** rng.uniform(-3, 0.2),
        "sigma": 10 ** rng.uniform(-1.5, 0.7),
        "beta": rng.choice([0.0, 10 ** rng.uniform(-2, 0.5)]),
        "V": rng.uniform(0.05, 1.0),
        "d": 10 ** rng.uniform(0.3, 1.5),
        "mu0": 10 ** rng.uniform(-1, 0.7),
        **{name: 10 ** rng.uniform(-3, -0.5) for name in ("zeta_x", "zeta_y", "zeta_s")},
    }
    vary = str(rng.choice(list(SPANS)))
    return ss.flutter_onsets(
        ss.load("damped").Parameters(**values), vary=vary, between={vary: SPANS[vary]}
    )


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """The coefficients of one search."""
    onsets = asked(number, rng)
    wrong, decided, moved = [], 0, 0
    for row in np.flatnonzero(np.isfinite(onsets.lyapunov)).tolist():
        exact = reference_of(onsets, row)
        for name in ("lyapunov", "crossing"):
            off = abs(float(getattr(exact, name) - mpmath.mpf(float(getattr(onsets, name)[row]))))
            bound = float(getattr(onsets, f"{name}_error")[row])
            wrong += [
                f"{onsets.parameters!r} along {onsets.vary}: {name} {off:.2e} off, bound "
                f"{bound:.2e}"
            ] * (off > bound)
        if onsets.criticality[row] != "undecided":
            decided += 1
            told = against_motions(onsets, row) if number % 5 == 0 else None
            moved += told is not None
            wrong += [f"{onsets.parameters!r}: {onsets.criticality[row]}, motions say {told}"] * (
                told not in (None, onsets.criticality[row])
            )
    name = onsets.parameters.model.name
    return {
        "kind": name,
        "wrong": wrong,
        "onsets": len(onsets),
        "decided": decided,
        "by motions": moved,
    }
