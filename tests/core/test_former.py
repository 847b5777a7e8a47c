"""Former spellings of a range that varies: errors that say the present one."""

from collections.abc import Callable
from typing import Any

import pytest

import spragsym as ss

P = ss.Parameters.article()
FORMER: dict[str, tuple[Callable[[], Any], str]] = {
    "a bracket": (
        lambda: ss.critical_value(P, "beta", bracket=(1, 2)),
        "critical_value has no argument bracket; write between=",
    ),
    "by position": (
        lambda: ss.diagram(P, "theta0", (0.1, 0.3)),
        "diagram takes 2 arguments by position, not 3; write between=",
    ),
    "to": (
        lambda: ss.basin_boundary(P, to=((-1, 1), (-1, 1))),
        "basin_boundary has no argument to; write between=",
    ),
    "a pair": (
        lambda: ss.fate_boundary(P, "V", between=(0.1, 0.3)),
        r"between = \(0.1, 0.3\) is no mapping; give the ends by name, as \{\"V\": \(0, 1\)\}",
    ),
    "no range": (
        lambda: ss.critical_value(P, "beta", between={}),
        r"between = \{\} has no range of beta; give its ends, as between=\{\"beta\": \(0, 1\)\}",
    ),
    "of another": (
        lambda: ss.critical_value(P, "beta", between={"sigma": (1, 2)}),
        "between has a range for 'sigma'; beta, mu0, theta0 may have one",
    ),
}


@pytest.mark.parametrize(("call", "said"), FORMER.values(), ids=FORMER)
def test_a_former_spelling_is_refused_with_the_present_one(
    call: Callable[[], Any], said: str
) -> None:
    with pytest.raises((ss.errors.ParameterTypeError, ss.errors.ParameterError), match=said):
        call()
