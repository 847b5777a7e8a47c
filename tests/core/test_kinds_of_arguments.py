"""An argument of a wrong kind is refused by every public function."""

import inspect
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import spragsym as ss

pytestmark = pytest.mark.thorough

P = ss.load("inclined_belt").Parameters(theta0=1.0)
#: What makes a call of any public function, by the names of arguments.
USUAL: dict[str, Any] = {
    "p": P,
    "vary": "beta",
    "between": {"beta": (0.1, 0.3)},
    "values": [0.1, 0.2],
    "change": ["sigma"],
    "scale": ["sigma"],
    "target": {"mu0": 3.0},
    "distribution": {"theta0": 1.0, "sigma": (0.1, 0.2)},
    "paper": "none.toml",
    **dict.fromkeys(("M", "K", "friction"), np.eye(2)),
}
#: Kinds of arguments that are none of numbers.
KINDS = ("str", "Mapping", "Cycle", "Ranges")


def _calls() -> Iterator[tuple[str, str]]:
    for name in ss.__all__:
        function = getattr(ss, name)
        others = ("load", "explore", "show_progress", "cycle_branch", "cycle_events")
        if not inspect.isfunction(function) or name in others:
            continue
        for argument in inspect.signature(function).parameters.values():
            words = str(argument.annotation).split(" | ")
            kinds = [it for it in words if it.endswith("Options") or it.partition("[")[0] in KINDS]
            if kinds and len(kinds) == len(words) - ("None" in words):
                yield name, argument.name


@pytest.mark.parametrize(("name", "argument"), [*_calls()])
def test_an_argument_of_a_wrong_kind_is_refused(name: str, argument: str) -> None:
    """By an error of this library, never by one of what it was given to."""
    function: Callable[..., Any] = getattr(ss, name)
    needed = {
        it.name: USUAL[it.name]
        for it in inspect.signature(function).parameters.values()
        if it.default is it.empty and it.kind is not it.VAR_KEYWORD
    }
    with pytest.raises(ss.errors.SpragsymError):
        function(**{**needed, argument: object()})
