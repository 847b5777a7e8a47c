"""A user's error state of NumPy changes no answer: every public question, its result read to the
end.
"""

import inspect
import warnings
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.motion.sweeps import basin, rms_sweep, sensitivity

P = ss.Parameters.article(theta0=0.8, mu0=0.4)
BOX = (P.replace(mu0=0.1, theta0=0.5), P.replace(mu0=0.12, theta0=0.52))
SHORT = {"t_end": 20.0, "backend": "scipy"}
#: Each of a model with closed forms, and by the search where that is quick.
QUESTIONS: dict[str, Callable[[], Any]] = {
    "equilibria": lambda: ss.equilibria(P),
    "equilibria by the search": lambda: ss.equilibria(P, method="search"),
    "count": lambda: ss.count(P),
    "folds": lambda: ss.folds(P),
    "folds by the search": lambda: ss.folds(P, method="search"),
    "cusps": lambda: ss.cusps(P),
    "flutter_onsets": lambda: ss.flutter_onsets(P.replace(alpha=0.7), damping=False),
    "critical_friction": lambda: ss.critical_friction(P),
    "critical_value": lambda: ss.critical_value(P, "beta", between={"beta": (1.0, 2.0)}),
    "cusp_friction": lambda: ss.cusp_friction(P),
    "bifurcation_set": lambda: ss.bifurcation_set(P, n=20),
    "quasi_static_path": lambda: ss.quasi_static_path(P, "mu0", [0.1, 0.3, 0.6]),
    "jump_value": lambda: ss.jump_value(P),
    "jump_gradient": lambda: ss.jump_gradient(P),
    "jump_margin": lambda: ss.jump_margin(P, {"theta0": 0.02, "kappa": 0.001}),
    "redesign": lambda: ss.redesign(P, {"mu0": 0.5}, {"theta0": 0.02}),
    "certify": lambda: ss.certify(P, between={"mu0": (0.1, 0.12), "theta0": (0.5, 0.52)}),
    "jump_probability": lambda: ss.jump_probability(
        {**dict.fromkeys(("alpha", "beta"), 0.01), "kappa": 0.007, "sigma": 0.1}
        | {"theta0": 0.8, "mu0": (0.3, 0.6)},
        n=64,
        rng=1,
    ),
    "surface": lambda: ss.kang_nam.surface(P, 1.0, 0.8),
    "sliding_friction": lambda: ss.kang_nam.sliding_friction(0.5, 1e-300, 10.0),
    "linear_sprag": lambda: ss.kang_nam.linear_sprag(P),
    "linear_critical_friction": lambda: ss.kang_nam.linear_critical_friction(P),
    "sticking_states": lambda: ss.sticking_states(ss.load("coulomb_stick_slip").Parameters(V=0.0)),
    "simulate": lambda: ss.simulate(P, **SHORT),
    "rms_sweep": lambda: rms_sweep(P, **SHORT),
    "basin": lambda: basin(P, x=[0.0, 0.5], vx=[0.0, 0.1], **SHORT),
    "sensitivity": lambda: sensitivity(P.replace(theta0=[0.7, 0.8]), V=[0.5], d=[10.0], **SHORT),
    "fate": lambda: ss.fate(ss.load("stick_slip").Parameters(), backend="scipy"),
}


def held(thing: Any, deep: int = 0) -> Any:
    """A result as plain data, whatever it computes when it is looked at."""
    if isinstance(thing, np.ndarray) and thing.dtype != object:
        return thing.tolist()
    if isinstance(thing, dict):
        return {key: held(value, deep + 1) for key, value in thing.items()}
    if isinstance(thing, list | tuple):
        return [held(value, deep + 1) for value in thing]
    if is_dataclass(thing) and deep < 4:
        lazy = [
            name
            for name, one in inspect.getmembers(type(thing))
            if type(one).__name__ in ("property", "cached_property") and name[0] != "_"
        ]
        names = [*(one.name for one in fields(thing)), *lazy]
        return {name: held(getattr(thing, name, None), deep + 1) for name in names}
    return thing if isinstance(thing, int | float | str) or thing is None else str(type(thing))


@pytest.mark.thorough
@pytest.mark.by_hand("fate")
@pytest.mark.parametrize("name", QUESTIONS)
def test_an_error_state_changes_no_answer(name: str) -> None:
    ask = QUESTIONS[name]
    usual = repr(held(ask()))
    for state in ("raise", "warn"):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with np.errstate(all=state):
                assert repr(held(ask())) == usual, state
