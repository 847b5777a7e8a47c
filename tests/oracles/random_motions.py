"""Random motions of the article's model by their numbers: cycles that branches begin with, fates
that change, and basins.
"""

from typing import Any

import numpy as np

import spragsym as ss

#: Parameters and the ranges that they are drawn from.
DRAWN = {
    "theta0": (0.35, 2.6),
    "mu0": (0.2, 1.0),
    "kappa": (0.002, 0.012),
    "alpha": (0.0, 0.012),
    "sigma": (0.05, 0.3),
    "V": (0.1, 0.6),
    "d": (4.0, 14.0),
}

#: What varies, and by how much at most to either side.
VARIED = {
    "theta0": 0.2,
    "mu0": 0.15,
    "kappa": 0.004,
    "alpha": 0.004,
    "sigma": 0.04,
    "V": 0.1,
    "d": 2.0,
}


def cycle_of(seed: int) -> tuple[ss.results.Cycle | None, np.random.Generator]:
    """The cycle of a seed; None where the motion comes to none."""
    rng = np.random.default_rng(seed)
    drawn = {name: float(rng.uniform(*between)) for name, between in DRAWN.items()}
    V, d = drawn.pop("V"), drawn.pop("d")
    start = rng.uniform([-1.0, -0.5, -0.5, -0.5], [3.0, 3.0, 0.5, 0.5])
    try:
        return ss.cycle(ss.Parameters(beta=0.0, **drawn), V=V, d=d, near=start, patient=False), rng
    except ss.errors.ConvergenceError:
        return None, rng


def fate_of(number: int) -> dict[str, Any]:
    """The arguments of a call."""
    rng = np.random.default_rng([28, number])
    values = {
        "theta0": rng.uniform(0.3, 1.2),
        "mu0": rng.uniform(0.3, 0.9),
        "kappa": 0.007 * 10 ** rng.uniform(-0.3, 0.3),
        "alpha": 0.007 * 10 ** rng.uniform(-0.3, 0.3),
        "sigma": 0.1 * 10 ** rng.uniform(-0.3, 0.3),
        "beta": 0.0,
        "V": rng.uniform(0.1, 0.6),
        "d": rng.uniform(3.0, 12.0),
    }
    vary = str(rng.choice(list(VARIED)))
    if number % 2:  # where rest is about to change its fate
        p = ss.Parameters(
            **{name: values[name] for name in values if name not in ("theta0", "V", "d")},
            theta0=1.0,
        )
        friction = ss.kang_nam.sliding_friction(values["mu0"], values["V"], values["d"])
        edges = ss.folds(p.replace(mu0=friction)).theta0
        if len(edges):
            values["theta0"] = max(float(edges.min()) - rng.uniform(0.0, 0.15), 0.05)
    wide = rng.uniform(0.1, 1.0) * VARIED[vary]
    bracket = (max(values[vary] - wide, 1e-3), values[vary] + wide)
    still = number % 2 or rng.random() < 0.3
    start = (
        [0.0] * 4 if still else rng.uniform([-0.5, -0.5, -0.3, -0.3], [3.0, 3.0, 0.3, 0.3]).tolist()
    )
    return {"values": values, "vary": vary, "bracket": bracket, "start": start}


def basin_of(number: int) -> ss.Parameters:
    """Parameters with three equilibria."""
    rng = np.random.default_rng([29, number])
    while True:
        mu0, V, d = rng.uniform(0.3, 0.9), rng.uniform(0.2, 0.6), rng.uniform(4.0, 12.0)
        p = ss.Parameters.article(mu0=mu0, V=V, d=d)
        edges = ss.folds(p.replace(mu0=ss.kang_nam.sliding_friction(mu0, V, d))).theta0
        if len(edges) == 2:  # there are three below the lower fold
            low = float(edges.min())
            return p.replace(theta0=rng.uniform(max(low - 0.3, 0.05), low))
