"""Parameters: what is wrong with them is said by name, in the words of who gave them."""

import importlib
import importlib.util
import inspect
from typing import Any

import pytest

import spragsym as ss

BRAKE = ss.PhysicalParameters(
    m=0.4, k=1e5, k_x=7e3, k_y=0, k_c=1e6, F_L=350, L_0=0.05, theta0=0.8, mu0=0.5, V=20
)

#: What functions need beside the parameters, so that nothing else is wrong with a call.
OTHERS: dict[str, Any] = {
    "vary": "kappa",
    "values": [0.1, 0.2],
    "between": {"kappa": (0.3, 0.6)},
    "theta": 1.0,
    "theta0": 1.0,
    "V": 0.5,
    "d": 10.0,
    "x": [0.0],
    "vx": [0.0],
    "claim": "no jump",
}


def test_physical_parameters_are_told_what_to_do() -> None:
    """By every public function with an argument of type Parameters, or of a set of any model."""
    modules = ["spragsym", "spragsym.kang_nam", "spragsym.precise", "spragsym.motion.sweeps"]
    modules += ["spragsym.figures"] * bool(importlib.util.find_spec("matplotlib"))
    asked = 0
    for module in map(importlib.import_module, modules):
        for public in getattr(module, "__all__", ()):
            try:
                function = getattr(module, public)
            except ImportError:  # of an extra that is not installed
                continue
            sets = ("Parameters", "ParameterSet")
            if not inspect.isfunction(function) or not set(sets) & {
                str(v) for v in inspect.get_annotations(function).values()
            }:
                continue
            taken = inspect.signature(function).parameters.values()
            needed = [
                one for one in taken if one.default is one.empty and one.kind != one.VAR_KEYWORD
            ]
            arguments = {
                one.name: BRAKE if one.annotation in sets else OTHERS[one.name] for one in needed
            }
            with pytest.raises(ss.errors.ParameterTypeError, match=r"\.dimensionless\(\)"):
                function(**arguments)
            asked += 1
    assert asked > 30


@pytest.mark.parametrize("name", ["trolley", "kang_nam"])
def test_a_set_of_parameters_does_not_change(name: str) -> None:
    """A value that is set would be one that no question sees."""
    p = ss.load(name).Parameters(theta0=0.8)
    for attribute in ("mu0", "nonsense"):
        with pytest.raises(AttributeError):
            setattr(p, attribute, 3.0)
    assert p.mu0 == p["mu0"] == 0.5
    with pytest.raises(AttributeError, match=r"use p\.replace\(mu0=\.\.\.\)"):
        ss.load("trolley").Parameters(theta0=0.8).mu0 = 3.0
