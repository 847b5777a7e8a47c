"""Pages at random, from all of the vocabulary, against mechanics assembled from their energies in numbers."""

from __future__ import annotations

import ast

import pytest

pytest.importorskip("sympy")

from tests.oracles.page_mechanics import judge
from tests.oracles.random_pages import draw
from tests.support import few

#: Of the seed 2: one coordinate or more, gaps and slides that are expressions, angles, dampers.
SEED, NUMBERS = 2, (0, 1, 2, 5, 6, 7, 8, 9)


@pytest.mark.by_hand("1", "9", "0")
@pytest.mark.thorough
@pytest.mark.parametrize("number", few(NUMBERS, 2))
def test_a_page_at_random_is_as_it_is_written(number: int) -> None:
    """Accelerations, states with their gaps, growth; by Newton's method from many starts no state is missed."""
    outcome = judge(SEED, number)
    assert outcome["kind"] == "right", outcome


@pytest.mark.thorough
def test_pages_are_the_same_wherever_they_are_drawn() -> None:
    texts = [draw(SEED, number).text() for number in range(40)]
    assert texts == [draw(SEED, number).text() for number in range(40)]
    assert len(set(texts)) == 40
    for text in texts:
        ast.parse(text)
    drawn = [draw(SEED, number) for number in range(300)]
    assert {len(page.coordinates) for page in drawn} == {1, 2, 3, 4}
    for part in (
        "springs",
        "lines",
        "torsions",
        "dampers",
        "line_dampers",
        "potentials",
        "forces",
        "contact",
        "normal",
        "friction",
    ):
        assert sum(bool(getattr(page, part)) for page in drawn) > 10, part
