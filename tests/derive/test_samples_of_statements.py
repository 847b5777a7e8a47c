"""Statements are judged at states on their own side of the contacts, however far that is."""

from pathlib import Path

import pytest

pytest.importorskip("sympy")

from spragsym.derive import pages
from tests.oracles.printed import rows

#: A block on a spring before a stop, far from where the spring is at rest.
STOP = '''"""A page of the tests."""
from spragsym.derive.model import Page
page = Page("A block on a spring before a stop.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "spring")
l = page.unit("l", "m", "a length")
g = page.parameter("g", "m", "play", "> 0", 5.0)
k_s = page.parameter("k_s", "N/m", "stop", "> 0", 2.0)
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.contact(g - x, lambda depth: k_s * depth)
'''


def test_the_size_of_a_mistake_is_that_of_states_in_contact(tmp_path: Path) -> None:
    """Without the play N is too large by k_s g: of both sides by g/(2 x - g), 1 where they touch."""
    path = tmp_path / "stop.py"
    path.write_text(STOP, encoding="utf-8")
    # A row that is right forbids the origin by which this one would be.
    row, _ = rows(pages.read(path), ("normal", "N = k_s*x"), ("normal", "N = k_s*(x - g)"))
    assert row.status == "misprint"
    assert 0.1 < float(row.cost.split()[0]) < 0.9
