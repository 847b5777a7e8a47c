"""The explorer in Firefox: folds crossed by mouse, around the cusp, keys, bad numbers, numbers as in Python, no error."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import pytest

import spragsym as ss
from spragsym.explorer import explorer_page
from tests.explorer.pages import Explorer, firefox

pytestmark = pytest.mark.thorough  # a second browser; tests/explorer/test_explorer.py has all questions in the first

BASE = ss.Parameters.article()


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Explorer]:
    folder = tmp_path_factory.mktemp("firefox")
    path = folder / "explorer.html"
    path.write_text(explorer_page(), encoding="utf-8")
    with firefox(folder) as browser:
        yield Explorer(browser.new_page(viewport={"width": 1300, "height": 1000}), path.as_uri())


@pytest.fixture
def explorer(opened: Explorer) -> Iterator[Explorer]:
    opened.errors.clear()
    opened.open()
    yield opened
    assert opened.errors == []


def test_a_fold_crossed_in_both_directions_and_none_around_the_cusp(explorer: Explorer) -> None:
    fold = math.degrees(float(ss.folds(BASE).theta0[0]))
    explorer.drag((30, 0.5), (fold - 2, 0.5))
    assert "jump" not in explorer.says()
    explorer.drag((fold - 2, 0.5), (fold + 2, 0.5))
    said = re.search(r"state ended at θ₀ = ([\d.]+)°", explorer.says())
    assert said is not None
    assert float(said[1]) == pytest.approx(fold, abs=0.3)  # a pixel of friction moves it
    explorer.drag((fold + 2, 0.5), (30, 0.5))
    assert explorer.theta() > 140
    explorer.drag((30, 0.5), (30, 0.05), (60, 0.05))
    assert "2 jumps" in explorer.says()
    explorer.open()
    explorer.drag((30, 0.5), (30, 0.1), (90, 0.1), (90, 0.5), (60, 0.5))
    assert "jump" not in explorer.says()
    assert explorer.theta() > 90
