"""Periods of cycles that stick, three laws with d from 10 to 3,000, against maxima of SciPy's Radau on the equation by hand.

Last found: under tanh(d v) a step passed the layer, and the period was wrong by 1e-4 with an error of 1e-15 (issue 55).
"""

from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles import sticking

CASES = 200


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One cycle; that there is none, as a motion comes to rest, is no refusal."""
    law = list(sticking.LAWS)[number % len(sticking.LAWS)]
    model = sticking.model(law)
    values = {"mu_s": rng.uniform(0.6, 1.5), "delta": rng.uniform(0.3, 3.0), "zeta": rng.choice([0.0, 0.15]) * rng.uniform()}
    p = model.Parameters(**values, V=rng.uniform(0.05, 0.6), d=10 ** rng.uniform(1.0, np.log10(3000.0)))
    outcome = ss.simulate(p, start=(2.0, 0.0)).outcome()
    try:
        cycle = ss.cycle(p, near=(2.0, 0.0))
    except ss.ConvergenceError as error:
        return {"kind": f"refused, {outcome.regime.name}", "wrong": [], "refused": int("rest" not in str(error))}
    rough, fine = (sticking.return_time(law, cycle.parameters, cycle.state, cycle.period, rtol) for rtol in (1e-9, 1e-11))
    off, told = abs(cycle.period - fine), cycle.error + 3 * abs(rough - fine) + 1e-12
    wrong = [f"{law}, {p}: period {cycle.period!r} for {fine!r}"] * (not off <= told)
    if cycle.stable and np.isfinite(outcome.period) and not abs(outcome.period - cycle.period) < 1e-8:
        wrong.append(f"{law}, {p}: simulated {outcome.period!r}, cycle {cycle.period!r}")
    lost = abs(cycle.multipliers[0] - 1)
    wrong += [f"{law}, {p}: trivial multiplier {lost:.2g} off, error {cycle.error:.2g}"] * (not lost <= cycle.error)
    return {"kind": law, "wrong": wrong, "off": off, "error": cycle.error, "refused": 0}
