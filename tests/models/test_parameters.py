"""Parameters: what is wrong with them is said by name, in the words of who gave them."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
from collections.abc import Callable
from typing import Any

import pytest

import spragsym as ss

BRAKE = ss.PhysicalParameters(m=0.4, k=1e5, k_x=7e3, k_y=0, k_c=1e6, F_L=350, L_0=0.05, theta0=0.8, mu0=0.5, V=20)

#: What functions need beside the parameters, so that nothing else is wrong with a call.
OTHERS: dict[str, Any] = {
    "vary": "kappa", "values": [0.1, 0.2], "bracket": (0.1, 1.0), "theta": 1.0, "theta0": 1.0, "V": 0.5, "d": 10.0,
    "x": [0.0], "vx": [0.0], "to": (0.3, 0.6), "mu0": (0.3, 0.6), "ends": (0.3, 0.6), "claim": "no jump",
}  # fmt: skip


def functions_of_parameters() -> dict[str, Callable[..., Any]]:
    """Every public function with an argument of type Parameters, or of a set of any model."""
    modules = ["spragsym", "spragsym.precise", "spragsym.motion.sweeps"]
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
