"""Parameters: what is wrong with them is said by name, in the words of who gave them."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import math
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import spragsym as ss
from spragsym.parameters import degrees

BRAKE = ss.PhysicalParameters(m=0.4, k=1e5, k_x=7e3, k_y=0, k_c=1e6, F_L=350, L_0=0.05, theta0=0.8, mu0=0.5, V=20)

#: What functions need beside the parameters, so that nothing else is wrong with a call.
OTHERS: dict[str, Any] = {
    "vary": "kappa", "values": [0.1, 0.2], "bracket": (0.1, 1.0), "theta": 1.0, "theta0": 1.0, "V": 0.5, "d": 10.0,
    "x": [0.0], "vx": [0.0], "to": (0.3, 0.6), "mu0": (0.3, 0.6), "ends": (0.3, 0.6), "claim": "no jump",
}  # fmt: skip


def functions_of_parameters() -> dict[str, Callable[..., Any]]:
    """Every public function with an argument of type Parameters, or of a set of any model."""
    modules = ["spragsym", "spragsym.precise", "spragsym.sweeps"]
    if importlib.util.find_spec("matplotlib"):
        modules.append("spragsym.figures")
    found = {}
    for name in modules:
        module = importlib.import_module(name)
        for public in getattr(module, "__all__", ()):
            try:
                function = getattr(module, public)
            except ImportError:  # of an extra that is not installed
                continue
            if inspect.isfunction(function) and {"Parameters", "ParameterSet"} & {
                str(v) for v in inspect.get_annotations(function).values()
            }:
                found[f"{name}.{public}"] = function
    return found


FUNCTIONS = functions_of_parameters()


@pytest.mark.parametrize("name", FUNCTIONS)
def test_physical_parameters_are_told_what_to_do(name: str) -> None:
    function = FUNCTIONS[name]
    needed = [p for p in inspect.signature(function).parameters.values() if p.default is p.empty and p.kind != p.VAR_KEYWORD]
    arguments = {p.name: BRAKE if p.annotation in ("Parameters", "ParameterSet") else OTHERS[p.name] for p in needed}
    with pytest.raises(ss.ParameterTypeError, match=r"\.dimensionless\(\)"):
        function(**arguments)


# ---------------------------------------------------------------------------------------------------------- names

TYPOS = {
    "teta0": "theta0", "theta": "theta0", "theta_0": "theta0", "θ0": "theta0", "θ₀": "theta0", "Theta0": "theta0",
    "theta0_deg": "theta0", "mu": "mu0", "mu_0": "mu0", "μ0": "mu0", "µ_0": "mu0", "kapa": "kappa", "κ": "kappa",
    "Alpha": "alpha", "aplha": "alpha", "sgima": "sigma", "σ": "sigma", "bet": "beta",
}  # fmt: skip


@pytest.mark.parametrize("typo", TYPOS)
def test_a_name_that_was_meant_is_named(typo: str) -> None:
    article = ss.Parameters.article
    calls: list[Callable[[], Any]] = [
        lambda: ss.Parameters(kappa=1, alpha=1, sigma=1, beta=1, **{typo: 1}), lambda: article(**{typo: 1}),
        lambda: article().replace(**{typo: 1}),
    ]  # fmt: skip
    for call in calls:
        with pytest.raises(ss.ParameterTypeError, match=rf"^{typo} is not a parameter; did you mean {TYPOS[typo]}\?$"):
            call()


# --------------------------------------------------------------------------------------------------------- numbers


@given(st.floats(1e-9, 180.0, exclude_max=True) | st.integers(1, 17999).map(lambda n: n / 100))
def test_degrees_come_back(typed: float) -> None:
    """What was typed, or where several numbers have the same radians the shortest of them."""
    back = degrees(math.radians(typed))
    assert math.radians(back) == math.radians(typed) or back == pytest.approx(typed, rel=1e-15)
    if len(repr(typed)) <= 14:
        assert back == typed
