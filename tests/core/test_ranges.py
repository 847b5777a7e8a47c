"""Ranges of what varies that are none, or of another parameter: errors that say what to write."""

from collections.abc import Callable
from typing import Any

import pytest

import spragsym as ss

P = ss.Parameters.article()
WRONG: dict[str, tuple[Callable[[], Any], str]] = {
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


@pytest.mark.parametrize(("call", "said"), WRONG.values(), ids=WRONG)
def test_a_range_that_is_none_is_refused_with_the_remedy(
    call: Callable[[], Any], said: str
) -> None:
    with pytest.raises((ss.errors.ParameterTypeError, ss.errors.ParameterError), match=said):
        call()
