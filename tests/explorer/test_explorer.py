"""The explorer: its bytes, and in a browser its numbers, jumps at folds and none around the cusp, keys, touch, words."""

from __future__ import annotations

import filecmp
import io
import json
import math
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from spragsym.cli.explore import explore
from spragsym.explorer import Preset, explorer_page
from spragsym.explorer.described import described
from spragsym.parameters import NAMES
from tests.explorer.pages import WITHOUT_WEBGL, Explorer, chromium
from tests.support import ROOT, derived

ASSETS = ROOT / "spragsym" / "explorer" / "assets"
SOURCES = ROOT / "explorer"
NODE = shutil.which("node")
BASE = ss.Parameters.article()
CASES = ss.load("kang_nam").cases()


# ------------------------------------------------------------------------------------------------------- bytes


@pytest.mark.thorough
def test_the_page_is_whole_and_the_same_every_time() -> None:
    page = explorer_page()
    assert page == explorer_page()
    assert len(page.encode()) < 2_000_000
    assert not re.search(r"""(src|href)\s*=\s*["']?\s*(https?:)?//""", page)
    places = re.findall(r"@([A-Z]+)@", (ASSETS / "page.html").read_text(encoding="utf-8"))
    assert len(places) > 15
    assert not re.search(rf"@({'|'.join(places)})@", page)
    bundled = json.loads((SOURCES / "package.json").read_text(encoding="utf-8"))["dependencies"]
    assert {"three", "uplot", "fft.js", "ml-matrix"} == set(bundled)
    for name, version in bundled.items():
        assert re.search(rf"^{re.escape(f'{name} {version}')}, MIT$", page, re.MULTILINE)
    assert page.count("Permission is hereby granted") == len(bundled)
    for module in ("spragsym.mjs", "kang_nam.mjs"):
        assert (ROOT / "generated/javascript" / module).read_text(encoding="utf-8").strip() in page


@pytest.mark.parametrize("name", ["kang_nam", "stribeck", "mode_coupling", "stick_slip"])
def test_every_page_with_two_parameters_begins_with_a_plane(name: str) -> None:
    """One with neither theta0 nor mu0, or with one of these, had none, and no reader could choose its axes."""
    model = ss.load(name)
    said = described(model, [Preset.of("Base", model.cases()[0][1])])
    first, second = said["axes"]
    balanced = [entry["name"] for entry in said["parameters"] if entry["role"] == "both"]
    assert first == model.axes[0]
    assert second in balanced
    assert second != first


def test_the_module_of_a_page_has_what_the_explorer_calls() -> None:
    export = pytest.importorskip("spragsym.derive.export", exc_type=ImportError)
    sources = "".join(path.read_text(encoding="utf-8") for path in (SOURCES / "src").glob("*.js"))
    called = re.findall(r'\balgebra(?:\?\.|\.)(\w+)|\bcall\("(\w+)"', sources)
    assert {one or other for one, other in called} == export.EXPLORED


def test_the_bundle_is_what_its_sources_give(tmp_path: Path) -> None:
    if NODE is None or not (SOURCES / "node_modules").is_dir():
        pytest.skip("needs node, and its packages in explorer/: make explorer")
    subprocess.run([NODE, "build.mjs", str(tmp_path)], cwd=SOURCES, check=True, timeout=60)
    made = sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*.*"))
    written = {"kang_nam/start.js"}
    kept = {str(path.relative_to(ASSETS)) for path in ASSETS.rglob("*.*") if path.suffix != ".html"}
    assert made == sorted(kept - written)
    assert filecmp.cmpfiles(tmp_path, ASSETS, made, shallow=False) == (made, [], [])


def test_a_name_can_not_end_the_script() -> None:
    page = explorer_page(presets=[Preset.of("</script><b>mine", BASE.replace(theta0=0.5))])
    assert "</script><b>" not in page
    assert page.count("</script>") == explorer_page().count("</script>")


def test_presets_are_single_points() -> None:
    names = list(BASE.model.parameters)
    assert [list(Preset.of(*case).point) for case in CASES] == [names] * len(CASES)
    for bad in (BASE, BASE.replace(theta0=np.array([0.5, 0.6]))):
        with pytest.raises(ss.ParameterError, match=r"theta0 = .* is not one number"):
            Preset.of("mine", bad)


@pytest.mark.thorough
def test_the_page_begins_at_data_of_ones_own(tmp_path: Path) -> None:
    """The dimensionless numbers by hand from those of the example file, and a model that the page can't compute refused."""
    pytest.importorskip("pint", reason="pint is not installed")
    data, out = ROOT / "spragsym" / "studies" / "brake.toml", tmp_path / "mine.html"
    assert CliRunner().invoke(explore, ["--data", str(data), "--out", str(out), "--no-open"]).exit_code == 0
    (text,) = re.findall(r'id="data">(.*?)</script>', out.read_text(encoding="utf-8"))
    said = json.loads(text)
    force, second = 1500e3 * 0.038, math.sqrt(0.35 / 1500e3)
    wanted = {"theta0": math.radians(52), "mu0": 0.45, "kappa": 420 / force, "alpha": 9 / 1500, "sigma": 180 / 1500, "beta": 0.0}
    wanted |= {"V": 1.2 * second / 0.038, "d": 10 * 0.038 / second}
    assert said["presets"][0]["point"] == pytest.approx(wanted, rel=1e-12)
    units = said["units"]
    assert [units["length"], units["time"], units["force"]] == [
        [pytest.approx(38), "mm"], [pytest.approx(second), "s"], [pytest.approx(force), "N"],
    ]  # fmt: skip
    given = {"kappa": ["F_L", 420, "N"], "alpha": ["k_x", 9, "N/mm"], "sigma": ["k", 180, "N/mm"], "V": ["V", 1.2, "m/s"]}
    for name, (quantity, value, unit) in given.items():
        assert units["parameters"][name] == [quantity, pytest.approx(value / wanted[name]), unit]
    named = CliRunner().invoke(explore, ["--data", str(data), "--model", "trolley", "--out", str(out), "--no-open"]).exception
    assert isinstance(named, ss.ParameterError)
    assert "holds data for the model kang_nam" in str(named)
    other = tmp_path / "other.toml"
    other.write_text(data.read_text(encoding="utf-8").replace('"kang_nam"', '"nobody"'), encoding="utf-8")
    problem = CliRunner().invoke(explore, ["--data", str(other), "--out", str(out), "--no-open", "--force"]).exception
    assert isinstance(problem, ss.SpragsymError)


#: Too few for a plane.
ONE_PARAMETER = '''r"""A mass in two wells."""
from spragsym.derive.model import Page
page = Page("A mass in two wells.")
m, k, l = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness"), page.unit("l", "m", "length")
b = page.parameter("b", "1", "hardening", "> 0", 1.0)
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.potential(k * (b * x**4 / (4 * l**2) - x**2 / 2))
'''


@pytest.mark.validate
def test_a_page_with_the_map_of_stability(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    for options in ([], ["--model", "stick_slip"]):
        texts = []
        for more in (["--onsets"], ["--onsets"], []):
            out = tmp_path / f"{len(texts)}{len(options)}.html"
            assert CliRunner().invoke(explore, ["--out", str(out), "--no-open", *options, *more]).exit_code == 0
            texts.append(out.read_text(encoding="utf-8"))
        assert texts[0] == texts[1]
        assert texts[0].count("<svg") == texts[2].count("<svg") + 1
        assert "Where oscillation sets in" not in texts[2]
        (command,) = re.findall(r"spragsym (onsets [^<]*)</pre>", texts[0])
        told = json.loads(CliRunner().invoke(cli, command.split()).stdout)
        assert told["curves"]
    where = derived(ONE_PARAMETER, "one_parameter")
    problem = CliRunner().invoke(explore, ["--model", str(where), "--onsets", "--out", str(out), "--force"]).exception
    assert "leave it out" in str(problem)


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    monkeypatch.setattr("spragsym.cli.explore.webbrowser.open", opened.append)
    out = tmp_path / "new" / "page.html"
    run = CliRunner().invoke(explore, ["--out", str(out), "--no-open"])
    assert (run.exit_code, run.stdout.strip(), opened) == (0, str(out), [])
    assert out.read_text(encoding="utf-8") == explorer_page()
    monkeypatch.setenv("DISPLAY", ":1")
    assert CliRunner().invoke(explore, ["--out", str(out)]).exit_code == 0  # the same bytes are not in the way
    assert opened == [out.resolve().as_uri()]
    for given, made in ((tmp_path / "new", "new/explorer.html"), (tmp_path / "bare", "bare.html")):
        assert CliRunner().invoke(explore, ["--out", str(given), "--no-open"]).stdout.strip() == str(tmp_path / made)
    out.write_text("mine", encoding="utf-8")
    assert isinstance(CliRunner().invoke(explore, ["--out", str(out)]).exception, ss.SpragsymError)
    assert out.read_text(encoding="utf-8") == "mine"
    problem = CliRunner().invoke(explore, ["--out", str(out), "--model", "nobody"]).exception
    assert isinstance(problem, ss.ParameterError)
    assert "no shipped model" in str(problem)
    assert "explore" in cli.list_commands(None)  # type: ignore[arg-type]  # the list does not depend on the context


# ------------------------------------------------------------------------------------------------- in a browser


@pytest.fixture(scope="module")
def url(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("explorer") / "explorer.html"
    path.write_text(explorer_page(), encoding="utf-8")
    return path.as_uri()


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as started:
        yield started


@pytest.fixture(scope="module")
def shared(browser: Any, url: str) -> Explorer:
    context = browser.new_context(viewport={"width": 1300, "height": 1000}, reduced_motion="reduce")
    context.add_init_script(WITHOUT_WEBGL)
    return Explorer(context.new_page(), url)


@pytest.fixture
def explorer(shared: Explorer) -> Iterator[Explorer]:
    shared.errors.clear()
    shared.open()
    yield shared
    assert shared.errors == []


def python_states(point: dict[str, float]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """θ of all states in contact, degrees."""
    values = {name: point[name] for name in NAMES[1:]}
    found = ss.equilibria(ss.Parameters(theta0=math.radians(point["theta0_deg"]), **values))
    return np.degrees(found.theta[: int(found.count)])


@pytest.mark.parametrize(
    "changes",
    [{}, {"kappa": 0.02, "alpha": 0.5, "sigma": 2.0}, {"kappa": 0.5499, "alpha": 0.8771, "sigma": 0.022509, "beta": 4.455}],
)
def test_the_lowest_fold_is_said(explorer: Explorer, changes: dict[str, float]) -> None:
    """A cusp, a point where the curve turns back, none; the marks are no more than a drawing of what is said."""
    explorer.open("".join(f"&{name}={value}" for name, value in changes.items())[1:])
    says = explorer.page.locator("#lowest")
    theirs = ss.critical_friction(BASE.replace(**changes))
    words = {"cusp": ", a cusp.", "turn": ", where the curve of folds turns back.", "": "No fold ends"}[theirs.kind]
    says.filter(has_text=words).wait_for()
    if theirs.kind:
        friction, angle = re.findall(r"= ([\d.]+)", says.inner_text())
        assert float(friction) == pytest.approx(float(theirs), rel=1e-5)
        assert float(angle) == pytest.approx(math.degrees(theirs.theta0), rel=1e-4)


@pytest.mark.thorough
def test_a_fold_crossed_by_mouse_in_both_directions(explorer: Explorer) -> None:
    """Low sheet → jump over the upper fold → back without a return → home over the other fold."""
    fold = math.degrees(float(ss.folds(BASE).theta0[0]))
    explorer.drag((30, 0.5), (fold - 1, 0.5))
    low = python_states(explorer.point())
    assert explorer.theta() == pytest.approx(low[0], abs=1e-5)
    assert "jump" not in explorer.says()
    explorer.drag((fold - 1, 0.5), (fold + 1, 0.5))
    (only,) = python_states(explorer.point())
    assert explorer.theta() == pytest.approx(only, abs=1e-5)
    assert only > low[0] + 60
    said = re.search(r"ended at θ₀ = ([\d.]+)°", explorer.says())
    assert said is not None
    assert float(said[1]) == pytest.approx(fold, abs=0.01)
    explorer.drag((fold + 1, 0.5), (30, 0.5))
    assert explorer.theta() == pytest.approx(python_states(explorer.point())[2], abs=1e-5)
    explorer.drag((30, 0.5), (30, 0.05), (60, 0.05))
    assert explorer.theta() < 90
    assert "2 jumps" in explorer.says()


@pytest.mark.thorough
def test_around_the_cusp_there_is_no_jump(explorer: Explorer) -> None:
    explorer.drag((30, 0.5), (30, 0.1), (90, 0.1), (90, 0.5), (60, 0.5))
    assert "jump" not in explorer.says()
    around = explorer.theta()
    explorer.open()
    explorer.drag((30, 0.5), (60, 0.5))
    assert "jump" in explorer.says()
    assert around == pytest.approx(explorer.theta(), abs=1.0)  # the same sheet; a pixel is half a degree


@pytest.mark.thorough
def test_the_walks_do_what_their_buttons_say(explorer: Explorer) -> None:
    """Across: a jump. Back: none. Home: the second one. Around, from the start again: none."""
    walks: dict[str, tuple[list[float], str]] = {
        "across": ([60, 0.5], "It jumped"), "back": ([30, 0.5], "It jumped"),
        "home": ([30, 0.5], "2 jumps"), "around": ([60, 0.5], ""),
    }  # fmt: skip
    sheets = []
    for way, (end, words) in walks.items():
        explorer.page.click(f"[data-walk={way}]")
        explorer.page.wait_for_function("([a, b]) => Math.abs(theta0_deg.value - a) + Math.abs(mu0.value - b) < 1e-6", arg=end)
        # Back ends where home ends: only the story tells that home has been walked.
        explorer.page.wait_for_function("words => story.innerText.includes(words)", arg=words)
        explorer.settle()
        assert words in explorer.says()
        assert "jump" in words or "jump" not in explorer.says()
        assert way == "home" or "2 jumps" not in explorer.says()
        sheets.append(explorer.theta() > 90)
    assert sheets == [True, True, False, True]


@pytest.mark.thorough
def test_the_page_follows_as_python_does(explorer: Explorer) -> None:
    """The rule of the page against the path that Python follows by folds, along random ways at several frictions."""
    for mu0 in (0.25, 0.5, 0.9):
        path = ss.quasi_static_path(BASE.replace(mu0=mu0), "theta0", np.radians([20.0, 100.0]))
        jumps = [math.degrees(float(jump.value)) for jump in path.jumps]
        explorer.open(f"theta0_deg=20&mu0={mu0}")
        explorer.page.fill("#theta0_deg", "100")
        said = re.search(r"ended at θ₀ = ([\d.]+)°", explorer.says())
        assert [float(said[1])] == pytest.approx(jumps, abs=0.01) if said else jumps == []


@pytest.mark.thorough
def test_at_a_pitchfork_nothing_jumps(explorer: Explorer) -> None:
    """Without friction and the spring along the belt: the state goes on as Python's path does."""
    p = BASE.replace(mu0=0.0, alpha=0.0)
    explorer.open("theta0_deg=20&mu0=0&alpha=0")
    explorer.page.fill("#theta0_deg", "170")
    path = ss.quasi_static_path(p, "theta0", np.radians([20.0, 170.0]))
    assert len(path.jumps) == 0
    assert "jumped" not in explorer.says()
    said = re.search(r"x = (\S+), stable", explorer.says())
    assert said is not None
    assert float(said[1].replace("−", "-")) == pytest.approx(float(path.x[-1]), rel=1e-3)


@pytest.mark.thorough
def test_curves_are_there_again_after_other_axes(explorer: Explorer) -> None:
    drawn = "document.querySelector('#plane canvas').toDataURL()"
    explorer.page.wait_for_timeout(800)
    before = explorer.page.evaluate(drawn)
    explorer.page.select_option("#across", "kappa")
    explorer.page.wait_for_timeout(300)
    assert explorer.page.evaluate(drawn) != before
    explorer.page.select_option("#across", "theta0")
    explorer.page.wait_for_function(f"before => {drawn} === before", arg=before)


@pytest.mark.thorough
def test_growth_is_pythons_at_huge_friction(explorer: Explorer) -> None:
    for mu0 in (1e8, 1e12):
        explorer.open(f"theta0_deg=30&mu0={mu0}")
        heads = explorer.page.evaluate("[...document.querySelectorAll('#states th')].map(c => c.textContent)")
        cells = explorer.page.locator("#states tbody tr").first.locator("td").all_inner_texts()
        eq = ss.equilibria(BASE.replace(theta0=math.radians(30.0), mu0=mu0))
        assert float(cells[heads.index("growth")]) == pytest.approx(float(eq.growth[0]), rel=0.01)


@pytest.mark.thorough
def test_presets(explorer: Explorer) -> None:
    for i, (_, p) in enumerate(CASES):
        explorer.page.select_option("#preset", str(i))
        point = explorer.point()
        assert math.radians(point.pop("theta0_deg")) == pytest.approx(p.theta0, rel=1e-9)
        assert point == {name: pytest.approx(getattr(p, name)) for name in NAMES[1:]}
        count = explorer.page.locator("#states tbody tr", has_text="contact").count()
        assert count == len(python_states(explorer.point()))


@pytest.mark.thorough
@pytest.mark.parametrize(("typed", "value"), [("0,3", 0.3), (" 0.25 ", 0.25), ("٫5", 0.5), ("3e-1", 0.3), ("0", 0.0)])
def test_numbers_as_people_type_them(explorer: Explorer, typed: str, value: float) -> None:
    explorer.page.fill("#mu0", typed)
    assert explorer.page.inner_text("#mu0_error") == ""
    assert f"mu0={value:g}&" in explorer.page.evaluate("new Promise(done => setTimeout(() => done(location.hash), 350))")


@pytest.mark.parametrize(("name", "typed", "words"), [
    ("mu0", "abc", "not a number"), ("mu0", "", "not a number"), ("mu0", "1.234,5", "not a number"),
    ("mu0", "-0,1", "at least 0"),
    ("theta0_deg", "180", "between 0 and 180"), ("theta0_deg", "0", "between 0 and 180"), ("kappa", "0", "greater than 0"),
    ("sigma", "1e999", "not a number"), ("beta", "−1", "at least 0"), ("alpha", "NaN", "not a number"),
])  # fmt: skip
@pytest.mark.thorough
def test_bad_numbers_change_nothing_and_are_explained(explorer: Explorer, name: str, typed: str, words: str) -> None:
    before = explorer.page.inner_text("#states")
    explorer.page.fill(f"#{name}", typed)
    assert words in explorer.page.inner_text(f"#{name}_error")
    assert explorer.page.get_attribute(f"#{name}", "aria-invalid") == "true"
    assert explorer.page.inner_text("#states") == before


@pytest.mark.thorough
def test_drawings_are_worked_out_beside_the_page(explorer: Explorer) -> None:
    """In a worker, also of a page from a file: curves that have no end cost their drawing, and the page goes on."""
    assert len(explorer.page.workers) == 1
    explorer.page.fill("#kappa", "1e-20")
    explorer.settle()
    assert "3 states" in explorer.says()
    explorer.page.fill("#kappa", "0.007")
    explorer.settle()
    assert explorer.theta() == pytest.approx(python_states(explorer.point())[0], abs=1e-5)


@pytest.mark.thorough
def test_a_fold_on_a_long_way_is_told_as_on_a_short_one(explorer: Explorer) -> None:
    (fold,) = ss.folds(BASE.replace(theta0=math.radians(30)), vary="mu0").mu0
    for far in ("3", "1e6"):
        explorer.open("theta0_deg=30&mu0=0.5")
        explorer.page.fill("#mu0", far)
        said = re.search(r"μ₀ = (\d\.\d+)", explorer.says())
        assert said is not None
        assert float(said[1]) == pytest.approx(float(fold), abs=1e-4)
    explorer.open("theta0_deg=30&mu0=0.5")
    explorer.page.fill("#kappa", "0.04")
    assert re.search(r"its state ended at κ = 0\.0\d+\.", explorer.says())


@pytest.mark.thorough
def test_huge_numbers_do_not_keep_the_page_waiting(explorer: Explorer) -> None:
    """A way of any length is followed in a bounded number of steps; 10 s is the limit of every action here."""
    for name, typed in (("mu0", "1e6"), ("alpha", "1e9"), ("sigma", "1e12"), ("theta0_deg", "1e-9"), ("kappa", "1e300")):
        explorer.page.fill(f"#{name}", typed)
        assert explorer.page.inner_text(f"#{name}_error") == ""


@pytest.mark.thorough
def test_half_a_number_leaves_no_trace(explorer: Explorer) -> None:
    """On the way from 30 to 45 stands 4, and 30 → 4 → 45 must not be a path; nor must 30 → 60 → 6."""
    explorer.page.fill("#theta0_deg", "60")
    assert "jumped" in explorer.says()
    explorer.page.fill("#theta0_deg", "40")
    assert "jumped" not in explorer.says()
    assert explorer.theta() < 60


@pytest.mark.thorough
def test_keyboard_only(explorer: Explorer) -> None:
    page = explorer.page
    page.goto("about:blank")  # the focus begins anew
    explorer.open()
    seen = []
    for _ in range(60):
        page.keyboard.press("Tab")
        seen.append(
            page.evaluate("document.activeElement.id || document.activeElement.dataset.walk || document.activeElement.tagName")
        )
    wanted = ["across", "mass", "anchor", "point", "preset", "theta0_deg", "theta0_deg_slider", "beta", "play", "x0", "pace"]
    order = [seen.index(name) for name in wanted]
    assert order == sorted(order)
    page.focus("#point")
    for _ in range(4):
        page.keyboard.press("Shift+ArrowRight")
    explorer.settle()
    assert explorer.point()["theta0_deg"] == pytest.approx(50)
    assert "jumped" in explorer.says()
    assert "50 degrees" in page.get_attribute("#point", "aria-valuetext")
    page.focus("#mu0")
    page.keyboard.press("ArrowUp")
    assert explorer.point()["mu0"] == pytest.approx(0.505)
    page.focus("#anchor")
    page.keyboard.press("ArrowLeft")
    assert explorer.point()["theta0_deg"] == pytest.approx(50.5)
    unnamed = page.evaluate(
        "[...document.querySelectorAll('input, select, button, [tabindex], [role=img]')].filter(e => !(e.labels?.length || "
        "e.getAttribute('aria-label') || e.textContent.trim())).map(e => e.outerHTML)"
    )
    assert unnamed == []


@pytest.mark.thorough
def test_a_link_carries_the_sheet(explorer: Explorer) -> None:
    explorer.drag((30, 0.5), (60, 0.5), (30, 0.5))
    explorer.page.click("#link")
    hash, theta = explorer.page.evaluate("location.hash"), explorer.theta()
    explorer.open(hash[1:])
    assert explorer.theta() == theta > 140
    explorer.open("theta0_deg=abc&mu0=-1&kappa=0,01&constructor=3")
    assert explorer.point()["kappa"] == 0.01
    assert explorer.point()["mu0"] == 0.5


@pytest.mark.thorough
def test_what_is_undecided_is_said(explorer: Explorer) -> None:
    explorer.open("kappa=1e-200")
    assert "Undecided" in explorer.page.inner_text("#status")
    assert "undecided" in explorer.page.inner_text("#count")
    assert "Undecided" in explorer.says()


@pytest.mark.thorough
def test_the_motion_runs_at_the_pace_of_the_screen(explorer: Explorer) -> None:
    page = explorer.page
    page.fill("#theta0_deg", "49")
    page.fill("#pace", "60")
    page.click("#restart")
    page.wait_for_function("document.querySelector('#motion_says').textContent.startsWith('off the belt')", timeout=10_000)
    before = page.get_attribute("#mass", "x")
    explorer.settle()
    assert page.get_attribute("#mass", "x") != before
    page.click("#play")
    assert page.inner_text("#play") == "Run"
    page.fill("#x0", "far")
    page.click("#restart")
    assert "not a number" in page.inner_text("#motion_says")
    page.click("#still")
    assert page.is_disabled("#still")


@pytest.mark.thorough
def test_anchor_and_mass_are_dragged(explorer: Explorer) -> None:
    """The anchor by 20° on its circle, taken beside its middle; the mass to a place, from which it moves on when let go."""
    page = explorer.page
    explorer.open("theta0_deg=30&mu0=0.3")

    def taken(name: str) -> tuple[float, float]:
        box = page.locator(name).bounding_box()
        return box["x"] + box["width"] / 2 + 3, box["y"] + box["height"] / 2 + 2

    page.locator("#mechanism").scroll_into_view_if_needed()
    scale = page.evaluate("document.querySelector('#mechanism svg').getScreenCTM().a") * 150
    turn = [scale * (f(math.radians(50)) - f(math.radians(30))) for f in (math.cos, math.sin)]
    for name, way in (("#anchor", turn), ("#mass", (0.4 * scale, 0.3 * scale))):
        x, y = taken(name)
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + way[0], y - way[1], steps=4)
        explorer.settle()
        if name == "#anchor":
            page.mouse.up()
            assert explorer.point()["theta0_deg"] == pytest.approx(50, abs=0.5)
            at = [float(page.locator("#states tr[aria-current] td").nth(k).inner_text().replace("−", "-")) for k in (4, 5)]
    assert float(page.input_value("#x0")) == pytest.approx(at[0] + 0.4, abs=0.02)
    assert float(page.input_value("#y0")) == pytest.approx(at[1] + 0.3, abs=0.02)
    page.mouse.up()
    assert page.inner_text("#play") == "Pause"
    page.wait_for_function("document.querySelector('#motion_says').textContent.startsWith('off the belt')")
    page.click("#still")


@pytest.mark.thorough
def test_the_surface_is_drawn(browser: Any, url: str) -> None:
    explorer = Explorer(browser.new_page(viewport={"width": 1000, "height": 800}), url)
    explorer.open()
    explorer.page.wait_for_timeout(1000)
    assert explorer.errors == []
    picture = explorer.page.locator("#space canvas[role=img]").screenshot()
    explorer.page.close()
    image = pytest.importorskip("PIL.Image", reason="Pillow is not installed")
    colours = image.open(io.BytesIO(picture)).convert("RGB").getcolors(1 << 24)
    blue = sum(count for count, (r, g, b) in colours if b > r + 60)
    amber = sum(count for count, (r, g, b) in colours if r > b + 60)
    assert blue > 5000
    assert amber > 500


@pytest.mark.thorough
def test_a_phone(browser: Any, url: str) -> None:
    """Narrow, dark, by touch, and without WebGL."""
    context = browser.new_context(
        viewport={"width": 360, "height": 740}, has_touch=True, color_scheme="dark", reduced_motion="reduce"
    )
    context.add_init_script(WITHOUT_WEBGL)
    phone = Explorer(context.new_page(), url)
    phone.open()
    assert phone.page.evaluate("document.documentElement.scrollWidth") <= 360
    assert phone.page.is_visible("#space .missing")
    phone.page.locator("#plane").scroll_into_view_if_needed()
    phone.page.touchscreen.tap(*phone.at(60, 0.5))
    phone.settle()
    assert phone.point()["theta0_deg"] == pytest.approx(60, abs=1)
    assert "jumped" in phone.says()
    ink = phone.page.evaluate("getComputedStyle(document.body).backgroundColor")
    assert max(int(part) for part in re.findall(r"\d+", ink)) < 60
    assert phone.errors == []
    context.close()


def test_a_state_is_called_stable_only_where_nothing_grows(explorer: Explorer) -> None:
    """The article's state after the jump grows by 4.9e-6: word and rate in the table are Python's, (27)'s word stands beside."""
    explorer.open("theta0_deg=30&mu0=0.5")
    said = explorer.page.evaluate(
        "[...document.querySelectorAll('#states tbody tr')].map(r => [...r.cells].map(c => c.textContent.trim()))"
    )
    heads = explorer.page.evaluate("[...document.querySelectorAll('#states th')].map(c => c.textContent)")
    column = {name: [row[place] for row in said] for place, name in enumerate(heads)}
    rows = 0
    for contact, name in ((True, "contact"), (False, "lift-off")):
        eq = ss.equilibria(ss.Parameters.article(theta0=math.radians(30.0)), contact=contact)
        for slot in range(int(eq.count)):
            word = column["stability"][rows].split()[-1]
            assert column["regime"][rows] == name
            assert word == eq.kind[slot]
            assert column["undamped"][rows] == ss.Stability(int(eq.stability[slot])).name.lower()
            written = column["growth"][rows].replace("\u2212", "-")
            assert float(written) == pytest.approx(float(eq.growth[slot]), rel=0.05)
            rows += 1
    assert rows == len(said) == 4
