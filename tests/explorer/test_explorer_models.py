"""Pages of models that have no solver in JavaScript: a state that jumps, links, keys, units, and no error."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

pytest.importorskip("sympy", reason="SymPy is not installed: pages of models are derived")

import spragsym as ss
from spragsym.cli.explore import explore
from spragsym.derive.folder import write_page
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


@pytest.mark.thorough
def test_numbers_far_from_one_keep_the_page_going(opened: tuple[Explorer, Any]) -> None:
    """mu0 = alpha = 0 first, then numbers at which the search can't tell states apart, and says so; then back."""
    page = opened[0].page
    before = page.inner_text("#states tbody")
    for name, typed in (
        ("mu0", "0"),
        ("alpha", "0"),
        ("theta0_deg", "90"),
        ("mu0", "1e6"),
        ("kappa", "1e300"),
        ("kappa", "1e-20"),
    ):
        page.fill(f"#{name}", typed)
        assert page.inner_text(f"#{name}_error") == ""
    assert page.inner_text("#count") == "undecided"
    assert "Undecided here" in opened[0].says()
    page.evaluate("document.querySelector('#preset').dispatchEvent(new Event('change'))")
    opened[0].settle()
    assert page.inner_text("#states tbody") == before


@pytest.mark.thorough
def test_the_motion_is_drawn_and_stopped(opened: tuple[Explorer, Any]) -> None:
    page = opened[0].page
    page.click("#from_state")
    page.wait_for_function("document.querySelector('#motion_says').textContent.includes('belt')")
    before = page.get_attribute("#mass", "x")
    page.wait_for_function("x => document.querySelector('#mass').getAttribute('x') !== x", arg=before)
    page.click("#still")
    assert page.is_disabled("#still")


CLASH = '''"""A mass whose parameters are called as parts of the page are, and say what is no HTML."""
from spragsym.derive.model import Page, tanh
page = Page("A mass on a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
N_0 = page.unit("N_0", "N", "normal force")
link = page.parameter("link", "1", 'friction <img src=x onerror="window.harmed = 1"> of "it"', ">= 0", 0.5)
phase = page.parameter("phase", "m/s", "belt speed", ">= 0", 0.5)
pace = page.parameter("pace", "s/m", "steepness", "> 0", 10.0)
F = page.parameter("F", "N", "push", "real", 0.1, becomes="tilt_deg")
x = page.coordinate("x", "m", "along the belt")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.force(F, along=x)
page.normal_force(N_0)
page.friction(x, phase, lambda v: link * tanh(pace * v))
'''


@pytest.mark.thorough
def test_a_page_of_anybody_is_text_and_its_names_are_its_own(browser: Any, tmp_path: Path) -> None:
    """Meanings with markup and quotes, parameters called as elements and as an angle of a link; a folder with a space."""
    folder, out = tmp_path / "my pages", tmp_path / "clash.html"
    (tmp_path / "clash.py").write_text(CLASH, encoding="utf-8")
    write_page(tmp_path / "clash.py", folder)
    done = CliRunner().invoke(explore, ["--model", str(folder), "--out", str(out), "--no-open"])
    assert done.exit_code == 0, done.exception
    explorer = Explorer(browser.new_page(), out.as_uri())
    explorer.open()
    page = explorer.page
    assert page.evaluate("[window.harmed, document.querySelectorAll('#parameters img').length]") == [None, 0]
    assert page.locator("#parameters span").first.inner_text() == 'friction <img src=x onerror="window.harmed = 1"> of "it"'
    assert page.locator("#phase .u-over").count() == 1
    assert "units of" in page.inner_text("#pace_says")
    assert page.inner_text("#proof").startswith(f"spragsym equilibria --model '{folder}'")
    page.fill("#parameters #tilt_deg", "0.2")
    page.click("button:has-text('Copy a link')")
    before, hash = page.inner_text("#states"), page.evaluate("location.hash")
    explorer.open("tilt_deg=0.3")
    assert page.inner_text("#states") != before
    explorer.open(hash[1:])
    assert page.inner_text("#states") == before
    assert explorer.errors == []
    page.close()
