"""Calls as a user writes them, for type checkers: ``make lint`` checks that right ones pass, and
that wrong ones are seen.
"""

# pyright: reportUnnecessaryTypeIgnoreComment=true

import numpy as np

import spragsym as ss

p = ss.Parameters.article(theta0=1.0)
model = ss.load("two_springs")
eq: ss.results.Equilibria = ss.equilibria(
    model.Parameters(theta0=1.0), within={"x": (-1.0, 1.0)}, method="search"
)
found: ss.results.Points = ss.folds(p, "mu0", between={"mu0": (0.0, 1.0)}, method="closed")
value = ss.jump_value(p, "sigma", until=1.0)
path: ss.results.Path = ss.quasi_static_path(p, "mu0", np.linspace(0.0, 1.0, 3), method="search")
proved: ss.results.Certificate = ss.certify(p, "no jump", vary="mu0", begin=0.0, max_boxes=10)
odds: ss.results.JumpProbability = ss.jump_probability({"mu0": (0.2, 0.4)}, model=model, n=64)
lowest: ss.results.CriticalLoad = ss.critical_friction(p, between={"mu0": (0.0, 1.0)})
sweep: ss.results.Sweep = ss.rms_sweep(p, t_end=1.0)

ss.folds(p, method="guess")  # type: ignore[arg-type]
ss.equilibria(p, contacts=True)  # type: ignore[call-arg]
model.folds(p)  # type: ignore[attr-defined]
