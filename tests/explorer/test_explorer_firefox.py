"""The explorer in Firefox: folds crossed by mouse, around the cusp, keys, bad numbers, numbers as in Python, no error."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator

import numpy as np
import pytest

import spragsym as ss
from spragsym.explorer import explorer_page
from spragsym.parameters import NAMES
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


def test_keys_and_bad_numbers(explorer: Explorer) -> None:
    explorer.page.focus("#point")
    for _ in range(4):
        explorer.page.keyboard.press("Shift+ArrowRight")
    explorer.settle()
    assert explorer.point()["theta0_deg"] == pytest.approx(50)
    assert "jumped" in explorer.says()
    explorer.page.fill("#mu0", "abc")
    assert "not a number" in explorer.page.inner_text("#mu0_error")
    explorer.page.fill("#mu0", "0,3")
    assert explorer.page.inner_text("#mu0_error") == ""
    assert explorer.page.input_value("#mu0_slider") == "0.3"


def test_numbers_are_pythons(explorer: Explorer) -> None:
    rng = np.random.default_rng(181)
    n = 500
    p = ss.Parameters(
        theta0=rng.uniform(0.01, 3.13, n), mu0=rng.uniform(0, 2, n), kappa=10 ** rng.uniform(-4, 0, n),
        alpha=rng.uniform(0, 1, n), sigma=10 ** rng.uniform(-2, 1, n), beta=rng.uniform(0, 3, n),
    )  # fmt: skip
    points = [{name: float(getattr(p, name)[i]) for name in NAMES} for i in range(n)]
    solved = "points => JSON.stringify(JSON.parse(points).map(p => window.spragsym.equilibria(p)))"
    found = json.loads(explorer.page.evaluate(solved, json.dumps(points)))
    here = ss.equilibria(p)
    for i, there in enumerate(found):
        if there["status"] == "ok":
            assert there["count"] == int(here.count[i])
            assert [state["theta"] for state in there["states"]] == pytest.approx(here.theta[i, : there["count"]], abs=1e-9)


def test_the_motion_runs(explorer: Explorer) -> None:
    explorer.page.fill("#theta0_deg", "49")
    explorer.page.fill("#pace", "60")
    explorer.page.click("#restart")
    explorer.page.wait_for_function("document.querySelector('#motion_says').textContent.startsWith('off the belt')")
    explorer.page.click("#still")
