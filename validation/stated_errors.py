"""Errors that motions of `sprag_rod`, whose borders are curved, state, against Taylor series of
tighter steps.

A motion that differs from its reference by more than is stated, and rounding, contradicts it.
"""

from dataclasses import replace
from typing import Any
from unittest.mock import patch

import numpy as np

import spragsym as ss
from spragsym.motion import integrators, with_heyoka
from spragsym.motion.problem import prepare

CASES = 200

#: Tolerance of the reference, below all that a motion may ask for.
TIGHTEST = 1e-17

#: Share of a state's size that rounding takes.
UNRESOLVED = 1e-14


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One motion of a model whose gap or direction of friction turns with the place."""
    model = ss.load("sprag_rod")
    p = model.Parameters(theta0=rng.uniform(0.5, 1.2), V=rng.uniform(0.1, 1.0))
    start = 0.02 * rng.standard_normal(len(model.components))
    backend = "heyoka" if number % 2 else "scipy"
    rtol = float(10 ** rng.uniform(-12.0, -4.0))
    t_end = float(rng.uniform(5.0, 40.0))
    hidden = "heyoka" if number % 4 == 2 else ""  # SciPy's error is told by SciPy too
    with patch.object(integrators, "is_there", lambda name: name != hidden):
        run = ss.simulate(
            p, start=start, t_end=t_end, rtol=rtol, backend=backend, estimate_error=True
        )
    assert run.error is not None
    if np.isnan(run.error).all():
        return {"kind": f"{backend}, not known", "wrong": []}
    problem = prepare(model, p, start=tuple(start.tolist()), t_end=t_end, rtol=1e-13)
    reference = with_heyoka.integrate(replace(problem, rtol=TIGHTEST)).samples
    at = reference(np.minimum(run.t, reference.t[-1]))
    true = np.abs(run.state - at).max(axis=0)
    allowed = run.error + UNRESOLVED * np.abs(run.state).max()
    wrong = (
        []
        if (true <= allowed).all()
        else [
            f"rtol {rtol:.2g}: {true.max():.2g}, {np.max(true / (allowed + 1e-300)):.3g} "
            "times as stated"
        ]
    )
    return {
        "kind": f"{backend}{' alone' * bool(hidden)}",
        "wrong": wrong,
        "true": float(true.max()),
    }
