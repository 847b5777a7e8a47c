"""Pages of models that have no solver in JavaScript: a state that jumps, links, keys, units, and no error."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

pytest.importorskip("sympy", reason="SymPy is not installed: pages of models are derived")

import spragsym as ss
from spragsym.cli.explore import explore
from tests.explorer.pages import Explorer, chromium


@pytest.fixture(scope="module")
def url(tmp_path_factory: pytest.TempPathFactory) -> str:
    out = tmp_path_factory.mktemp("models") / "trolley.html"
    done = CliRunner().invoke(explore, ["--model", "trolley", "--out", str(out), "--no-open"])
    assert done.exit_code == 0, done.output
    return out.as_uri()


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as started:
        yield started.new_context(viewport={"width": 1300, "height": 1000}, reduced_motion="reduce")


@pytest.fixture
def opened(browser: Any, url: str) -> Iterator[tuple[Explorer, Any]]:
    explorer = Explorer(browser.new_page(), url)
    explorer.open()
    yield explorer, ss.load("trolley")
    assert explorer.errors == []
    explorer.page.close()


@pytest.mark.thorough
def test_a_state_is_carried_over_a_fold_and_back(opened: tuple[Explorer, Any]) -> None:
    """Up over the fold that Python proves, by slider and by key; back, and it has not returned."""
    explorer, model = opened
    folds = np.degrees(ss.folds(model.Parameters(theta0=0.5), "theta0").theta0)
    fold = float(min(folds[folds > 30]))
    explorer.page.fill("#theta0_deg", f"{fold - 0.2:.6f}".replace(".", ","))
    assert "jumped" not in explorer.says()
    low = float(re.findall(r"x = ([\d.]+)", explorer.says())[0])
    explorer.page.fill("#theta0_deg", f"{fold + 0.2:.6f}")
    assert "jumped" in explorer.says()
    explorer.page.keyboard.press("Enter")
    explorer.page.fill("#theta0_deg", "30")
    assert float(re.findall(r"x = ([\d.]+)", explorer.says())[0]) > low + 0.5
    hash = explorer.page.evaluate("new Promise(done => setTimeout(() => done(location.hash), 400))")
    before = explorer.page.inner_text("#states")
    explorer.open(hash[1:])
    assert explorer.page.inner_text("#states") == before
    explorer.page.fill("#mu0", "-1")
    assert "at least 0" in explorer.page.inner_text("#mu0_error")
    assert "searched" in explorer.page.inner_text("header").lower()
    assert explorer.page.inner_text("#proof").startswith("spragsym equilibria --model trolley --theta0 30 ")
