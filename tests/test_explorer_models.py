"""Pages of other models: states and motion against Python's, a state that jumps, links, keys, units, and no error."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli.explore import explore
from tests.explorer_pages import Explorer, chromium

pytest.importorskip("sympy", reason="SymPy is not installed: pages of models are derived")

#: Three coordinates, one coordinate; two springs, and a law of contact with a root.
MODELS = ("trolley", "stick_slip", "two_springs", "hertz_contact")


@pytest.fixture(scope="module")
def page_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], str]:
    """The address of a model's page, which is made when a test asks first."""
    folder = tmp_path_factory.mktemp("models")

    @cache
    def address(name: str) -> str:
        out = folder / f"{name}.html"
        done = CliRunner().invoke(explore, ["--model", name, "--out", str(out), "--no-open"])
        assert done.exit_code == 0, done.output
        return out.as_uri()

    return address


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as started:
        yield started.new_context(viewport={"width": 1300, "height": 1000}, reduced_motion="reduce")


@pytest.fixture
def opened(browser: Any, page_of: Callable[[str], str], request: pytest.FixtureRequest) -> Iterator[tuple[Explorer, Any]]:
    name = getattr(request, "param", "trolley")
    explorer = Explorer(browser.new_page(), page_of(name))
    explorer.open()
    yield explorer, ss.load(name)
    assert explorer.errors == []
    explorer.page.close()


def points(model: Any, n: int) -> list[dict[str, float]]:
    """Random points about the base values."""
    rng = np.random.default_rng(len(model.name))
    found = []
    for _ in range(n):
        values = {name: value * rng.uniform(0.7, 1.3) for name, value in model.base.items()}
        found.append(values | {name: rng.uniform(0.3, 2.8) for name in model.parameters if name not in values})
    return found


@pytest.mark.thorough
@pytest.mark.parametrize("opened", MODELS, indirect=True)
def test_states_are_those_that_python_proves(opened: tuple[Explorer, Any]) -> None:
    explorer, model = opened
    for point in points(model, 3):
        for contact in (True, False) if model.about["contact"]["unilateral"] else (True,):
            eq = model.equilibria(model.Parameters(**point), contact=contact)
            count = int(eq.count)
            found = explorer.page.evaluate("p => window.spragsym.equilibria(p)", {**point, "contact": contact})
            assert found["status"] == "searched"
            assert found["count"] == count
            proved = np.array([eq.coordinates[name][:count] for name in model.coordinates])
            for row, there in zip(np.argsort(proved[0]), found["states"], strict=True):
                assert [there[name] for name in model.coordinates] == pytest.approx(proved[:, row], abs=1e-9)
                assert there["stability"] == ss.Stability(int(eq.stability[row])).name.lower()


@pytest.mark.thorough
@pytest.mark.parametrize("opened", MODELS, indirect=True)
def test_the_motion_is_pythons(opened: tuple[Explorer, Any]) -> None:
    """From rest, over lift-offs and overtakings, by steps that are cut at kinks; errors of order h^4."""
    explorer, model = opened
    (point,) = points(model, 1)
    start = [0.05] + [0.0] * (2 * len(model.coordinates) - 1)
    tr = model.simulate(model.Parameters(**point), start=start, t_end=30.0)
    end = explorer.page.evaluate(
        "([p, s]) => { const m = window.spragsym.motion(p); for (let i = 0; i < 3000; i++) s = m.step(s, 0.01); return s; }",
        [point, start],
    )
    assert end == pytest.approx(tr.state[:, -1], abs=2e-6)


@pytest.mark.thorough
def test_a_state_is_carried_over_a_fold_and_back(opened: tuple[Explorer, Any]) -> None:
    """Up over the fold that Python proves, by slider and by key; back, and it has not returned."""
    explorer, model = opened
    folds = np.degrees(model.folds(model.Parameters(theta0=0.5), "theta0").theta0)
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


def test_a_brake_of_another_model_begins_at_its_data(tmp_path: Path) -> None:
    pytest.importorskip("pint", reason="pint is not installed")
    data, out = tmp_path / "brake.toml", tmp_path / "brake.html"
    example = Path(ss.__file__).parent / "studies" / "brake.toml"
    text = example.read_text(encoding="utf-8").replace('"kang_nam"', '"damped"')
    data.write_text(text.replace("[brake]", '[brake]\nc_x = "30 N s/m"\nc_y = "0 N s/m"\nc_s = "1 N s/m"'), encoding="utf-8")
    done = CliRunner().invoke(explore, ["--data", str(data), "--out", str(out), "--no-open"])
    assert done.exit_code == 0, done.exception
    (found,) = re.findall(r'id="data">(.*?)</script>', out.read_text(encoding="utf-8"))
    said = json.loads(found)
    point = said["presets"][0]["point"]
    assert point["zeta_x"] == pytest.approx(30 / math.sqrt(1500e3 * 0.35), rel=1e-12)
    assert point["kappa"] == pytest.approx(420 / (1500e3 * 0.038), rel=1e-12)
    assert said["units"]["length"] == [pytest.approx(38), "mm"]
