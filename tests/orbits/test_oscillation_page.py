"""Numbers of docs/oscillation.md are those that the commands beside them print."""

import importlib.util

import pytest

from tests.oracles import oscillation_page as page

pytestmark = pytest.mark.skipif(
    not importlib.util.find_spec("heyoka"), reason="branches take SciPy minutes"
)

#: The campaigns among the commands are run by the campaign.
ROWS = [row for row in page.rows() if row.command.startswith(page.QUICK)]


MARKED = [
    pytest.param(row, marks=() if page.is_quick(row) else pytest.mark.thorough) for row in ROWS
]


@pytest.mark.by_hand(
    "exponents of an irregular motion",
    "fate of rest, and x of the saddle",
    "those of its multipliers",
    "its Lyapunov",
    "fold of the branch",
    "over friction",
)
@pytest.mark.parametrize("row", MARKED, ids=[row.what for row in ROWS])
def test_numbers_are_those_of_the_command(row: page.Row) -> None:
    assert page.differences(row) == []


def test_a_wrong_digit_is_noticed() -> None:
    assert page.off("34.2673700110", [1.0, 34.26737001097547]) < 0.5
    assert page.off("34.2673700111", [1.0, 34.26737001097547]) > 0.5
    assert len(ROWS) > 8
