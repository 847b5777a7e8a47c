"""Periods of cycles that stick, three laws with d from 10 to 3,000, against maxima of SciPy's Radau
on the equation by hand.

Last found: under tanh(d v) a step passed the layer, and the period was wrong by 1e-4 with an error
of 1e-15 (issue 55).
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

import spragsym as ss
from tests.oracles import sticking

CASES = 200


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One cycle; that there is none, as a motion comes to rest, is no refusal."""
    law = list(sticking.LAWS)[number % len(sticking.LAWS)]
    model = sticking.model(law)
    values = {
        "mu_s": rng.uniform(0.6, 1.5),
        "delta": rng.uniform(0.3, 3.0),
        "zeta": rng.choice([0.0, 0.15]) * rng.uniform(),
    }
    p = model.Parameters(
        **values, V=rng.uniform(0.05, 0.6), d=10 ** rng.uniform(1.0, np.log10(3000.0))
    )
    outcome = ss.simulate(p, start=(2.0, 0.0)).outcome()
    try:
        cycle = ss.cycle(p, near=(2.0, 0.0))
    except ss.errors.ConvergenceError as error:
        return {
            "kind": f"refused, {outcome.regime.name}",
            "wrong": [],
            "refused": int("rest" not in str(error)),
        }
    rough, fine = (
        return_time(law, cycle.parameters, cycle.state, cycle.period, rtol)
        for rtol in (1e-9, 1e-11)
    )
    off, told = abs(cycle.period - fine), cycle.error + 3 * abs(rough - fine) + 1e-12
    wrong = [f"{law}, {p}: period {cycle.period!r} for {fine!r}"] * (not off <= told)
    if (
        cycle.stable
        and np.isfinite(outcome.period)
        and not abs(outcome.period - cycle.period) < 1e-8
    ):
        wrong.append(f"{law}, {p}: simulated {outcome.period!r}, cycle {cycle.period!r}")
    lost = abs(cycle.multipliers[0] - 1)
    wrong += [f"{law}, {p}: trivial multiplier {lost:.2g} off, error {cycle.error:.2g}"] * (
        not lost <= cycle.error
    )
    return {"kind": law, "wrong": wrong, "off": off, "error": cycle.error, "refused": 0}


def return_time(
    law: str, values: Mapping[str, float], state: Any, near: float, rtol: float
) -> float:
    """The time nearest to ``near`` between two maxima of x, over a little more than three such
    times.
    """
    mu_s, delta, zeta, V, d = (values[name] for name in ("mu_s", "delta", "zeta", "V", "d"))

    def friction(v: float) -> tuple[float, float]:
        fall = mu_s / (1 + delta * abs(v))
        value, slope = sticking.LAWS[law][1](d * v)
        return fall * value, fall * d * slope - fall**2 * delta / mu_s * math.copysign(
            value, v * value
        ) * math.copysign(1, v)

    found = solve_ivp(
        lambda _, y: (y[1], -y[0] - zeta * y[1] + friction(V - y[1])[0]),
        (0, 3.3 * near),
        state,
        method="Radau",
        jac=lambda _, y: ((0, 1), (-1, -zeta - friction(V - y[1])[1])),
        rtol=rtol,
        atol=1e-3 * rtol,
        events=_maximum,
    )
    times = found.t_events[0]
    gaps = np.subtract.outer(times, times)
    return float(gaps.ravel()[np.argmin(np.abs(gaps - near))])


def _maximum(_: float, y: Any) -> float:
    return float(y[1])


_maximum.direction = -1  # type: ignore[attr-defined]  # as SciPy wants it
