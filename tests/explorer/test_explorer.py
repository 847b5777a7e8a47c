"""The explorer: its bytes, and in a browser its numbers, jumps at folds and none around the cusp,
keys, touch, words.
"""

import html
import json
import math
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli.pages import explore
from spragsym.derive.kang_nam.library import exported
from spragsym.explorer import explorer_page
from spragsym.explorer.page import described
from spragsym.generated.quantities import PARAMETERS
from spragsym.models.load import shipped
from tests.explorer.pages import Explorer, chromium, window
from tests.support import ROOT

ASSETS = ROOT / "spragsym" / "explorer" / "assets"
SOURCES = ROOT / "explorer"
NODE = shutil.which("node")
BRAKE = ROOT / "spragsym" / "report" / "brake.toml"
BASE = ss.Parameters.article()


# ------------------------------------------------------------------------------------------------
# bytes


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
    module = (ROOT / "generated/models/kang_nam/kang_nam.mjs").read_text(encoding="utf-8")
    for text in (module, exported("javascript")["spragsym.mjs"]):
        assert text.strip() in page


def test_every_name_that_a_module_imports_is_exported_by_the_other() -> None:
    """A page whose code imports a name that is gone stops at its first call."""
    modules = {
        path.resolve(): path.read_text(encoding="utf-8") for path in SOURCES.rglob("src/**/*.js")
    }
    exported_names = {
        path: set(re.findall(r"^export (?:async )?(?:function|const) (\w+)", text, re.MULTILINE))
        for path, text in modules.items()
    }
    seen = 0
    for path, text in modules.items():
        for names, other in re.findall(r"import \{([^}]*)\} from \"(\.[^\"]*)\"", text):
            wanted = {name.split(" as ")[0].strip() for name in names.split(",") if name.strip()}
            assert wanted <= exported_names[(path.parent / other).resolve()], (
                f"{path.name}: {other}"
            )
            seen += len(wanted)
    assert seen > 50


def test_a_cell_of_a_notebook_shows_it_at_the_point() -> None:
    shown = ss.explore(ss.Parameters.article(theta0=0.8125, V=0.5, d=10.0))._repr_html_()
    assert shown.startswith("<iframe srcdoc=")
    assert "0.8125" in html.unescape(shown)


def test_sliders_hold_allowed_values_on_both_sides_of_the_base() -> None:
    for model in map(ss.load, shipped()):
        if model.refusal("explore"):
            continue
        for entry in described(model, [])["parameters"]:
            size = math.radians(1.0) if entry["angle"] else 1.0
            low, high = size * entry["low"], size * entry["high"]
            allowed = model.Parameters.ranges[entry["name"]]
            assert allowed.contains(low)
            assert allowed.contains(high)
            assert low <= model.base.get(entry["name"], high) <= high


def written(data: Path, out: Path, *words: str) -> str:
    """The page that the command writes for the data of a file; its errors are raised."""
    asked = ["--data", str(data), "--out", str(out), "--no-open", "--force", *words]
    CliRunner().invoke(explore, asked, catch_exceptions=False)
    return out.read_text(encoding="utf-8")


@pytest.mark.thorough
def test_the_page_begins_at_data_of_ones_own(tmp_path: Path) -> None:
    """The dimensionless numbers by hand from those of the example file, and a model that the page
    can't compute refused.
    """
    out, other = tmp_path / "mine.html", tmp_path / "other.toml"
    page = written(BRAKE, out)
    (text,) = re.findall(r'id="data">(.*?)</script>', page)
    said = json.loads(text)
    force, second = 1500e3 * 0.038, math.sqrt(0.35 / 1500e3)
    wanted = {
        "theta0": math.radians(52),
        "mu0": 0.45,
        "kappa": 420 / force,
        "alpha": 9 / 1500,
        "sigma": 180 / 1500,
        "beta": 0.0,
    }
    wanted |= {"V": 1.2 * second / 0.038, "d": 10 * 0.038 / second}
    point = said["presets"][0]["point"]
    assert {name: point[name] for name in wanted} == pytest.approx(wanted, rel=1e-12)
    units = said["units"]
    assert [units["length"], units["time"], units["force"]] == [
        [pytest.approx(38), "mm"],
        [pytest.approx(second), "s"],
        [pytest.approx(force), "N"],
    ]
    given = {
        "kappa": ["F_L", 420, "N"],
        "alpha": ["k_x", 9, "N/mm"],
        "sigma": ["k", 180, "N/mm"],
        "V": ["V", 1.2, "m/s"],
    }
    for name, (quantity, value, unit) in given.items():
        assert units["parameters"][name] == [quantity, pytest.approx(value / wanted[name]), unit]
    rows = BRAKE.read_text(encoding="utf-8")
    dampers = {"c_x": 1.0, "c_y": 7.0, "c_s": 0.7}
    for given in (dampers, {}):
        instead = "\n".join(f'{name} = "{value} N s/m"' for name, value in given.items())
        changed = re.sub(r"^damping_ratio.*$", instead, rows, flags=re.MULTILINE)
        other.write_text(changed, encoding="utf-8")
        (text,) = re.findall(r'id="data">(.*?)</script>', written(other, out))
        point = json.loads(text)["presets"][0]["point"]
        zeta = [point[name] for name in sorted(point) if name.startswith("zeta")]
        assert zeta == pytest.approx([given[n] / math.sqrt(0.35 * 1500e3) for n in sorted(given)])
    with pytest.raises(ss.errors.ParameterError, match="is about kang_nam"):
        written(BRAKE, out, "--model", "trolley")
    other.write_text(rows.replace('"kang_nam"', '"nobody"'), encoding="utf-8")
    with pytest.raises(ss.errors.SpragsymError):
        written(other, out)


# ------------------------------------------------------------------------------------------------
# in a browser


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
    return Explorer(window(browser, reduced_motion="reduce").new_page(), url)


@pytest.fixture
def explorer(shared: Explorer) -> Iterator[Explorer]:
    shared.errors.clear()
    shared.open()
    yield shared
    assert shared.errors == []


def python_states(point: dict[str, float]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """θ of all states in contact, degrees."""
    values = {name: point[name] for name in PARAMETERS[1:]}
    found = ss.equilibria(ss.Parameters(theta0=math.radians(point["theta0_deg"]), **values))
    return np.degrees(found.theta[: int(found.count)])


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"kappa": 0.02, "alpha": 0.5, "sigma": 2.0},
        {"kappa": 0.5499, "alpha": 0.8771, "sigma": 0.022509, "beta": 4.455},
    ],
)
def test_the_lowest_fold_is_said(explorer: Explorer, changes: dict[str, float]) -> None:
    """A cusp, a point where the curve turns back, none; the marks are no more than a drawing of
    what is said.
    """
    explorer.open("".join(f"&{name}={value}" for name, value in changes.items())[1:])
    says = explorer.page.locator("#lowest")
    theirs = ss.critical_friction(BASE.replace(**changes))
    words = {
        "cusp": ", a cusp.",
        "turn": ", where the curve of folds turns back.",
        "": "No fold ends",
    }[theirs.kind]
    says.filter(has_text=words).wait_for()
    if theirs.kind:
        friction, angle = re.findall(r"= ([\d.]+)", says.inner_text())
        assert float(friction) == pytest.approx(float(theirs), rel=1e-5)
        assert float(angle) == pytest.approx(math.degrees(theirs.theta0), rel=1e-4)


@pytest.mark.thorough
def test_data_of_ones_own_is_typed_and_shown_in_its_units(browser: Any, tmp_path: Path) -> None:
    """Boxes, axes, states, starts and pace in newtons, millimetres and seconds, by hand."""
    out = tmp_path / "mine.html"
    (text,) = re.findall(r'id="data">(.*?)</script>', written(BRAKE, out))
    given = json.loads(text)["presets"][0]["point"]
    context = window(browser)
    mine = Explorer(context.new_page(), out.as_uri())
    mine.open()
    page, force = mine.page, 1500e3 * 0.038
    assert [page.input_value(f"#{name}") for name in ("theta0_deg", "kappa", "sigma", "V")] == [
        "52",
        "420",
        "180",
        "1.2",
    ]
    page.fill("#kappa", "210")
    row = page.inner_text("label[for=kappa]")
    assert "F_L" in row
    assert float(re.findall(r"κ = (\S+)", row)[0]) == pytest.approx(210 / force, rel=1e-4)
    p = ss.Parameters(theta0=math.radians(52), mu0=0.45, kappa=210 / force, alpha=0.006, sigma=0.12)
    eq = ss.equilibria(p)
    place = page.locator("#states th").all_inner_texts().index("x in mm")
    cells = page.locator(f"#states tr td:nth-child({place + 1})").all_inner_texts()
    count = int(eq.count)
    assert count == 3
    assert [float(cell.replace("−", "-")) for cell in cells[:count]] == pytest.approx(
        38 * eq["x"][:count], rel=1e-6
    )
    growth = page.locator("#states th").all_inner_texts().index("growth in 1/s")
    rates = page.locator(f"#states tr td:nth-child({growth + 1})").all_inner_texts()
    second = math.sqrt(0.35 / 1500e3)
    slides = ss.load("damped").Parameters(**given | {"kappa": 210 / force})
    assert [float(rate.replace("−", "-")) for rate in rates[:count]] == pytest.approx(
        ss.equilibria(slides)["growth"][:count] / second, rel=0.01
    )
    page.set_viewport_size({"width": 1280, "height": 900})
    sizes = "table => [table.parentElement.scrollWidth, table.parentElement.clientWidth]"
    whole, shown = page.locator("#states").evaluate(sizes)
    assert whole <= shown, "the last columns are cut off"
    page.fill("#kappa", "-1")
    assert "F_L must be greater than 0 N" in page.inner_text("#kappa_error")
    page.fill("#kappa", "420")
    assert page.inner_text("#starts label").split() == ["x", "mm"]
    page.fill("#pace", "10")
    second = math.sqrt(0.35 / 1500e3)
    pace = page.inner_text("#pace_says")
    assert float(pace.split()[0]) == pytest.approx(10 * second, rel=1e-2)
    assert pace.split()[1] == "s"
    page.click("#from_state")
    state = 38 * float(ss.equilibria(p.replace(kappa=420 / force))["x"][0])
    assert float(page.input_value("#x0")) == pytest.approx(state + 0.38, rel=1e-6)
    assert mine.errors == []
    context.close()


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
    assert around == pytest.approx(
        explorer.theta(), abs=1.0
    )  # the same sheet; a pixel is half a degree


@pytest.mark.thorough
def test_the_page_follows_as_python_does(explorer: Explorer) -> None:
    """The rule of the page against the path that Python follows by folds, along random ways at
    several frictions.
    """
    for mu0 in (0.25, 0.5, 0.9):
        path = ss.quasi_static_path(BASE.replace(mu0=mu0), "theta0", np.radians([20.0, 100.0]))
        jumps = [math.degrees(float(jump.value)) for jump in path.jumps]
        explorer.open(f"theta0_deg=20&mu0={mu0}")
        explorer.page.fill("#theta0_deg", "100")
        said = re.search(r"ended at θ₀ = ([\d.]+)°", explorer.says())
        assert [float(said[1])] == pytest.approx(jumps, abs=0.01) if said else jumps == []


@pytest.mark.thorough
def test_the_motion_runs_at_the_pace_of_the_screen(explorer: Explorer) -> None:
    page = explorer.page
    page.fill("#theta0_deg", "49")
    page.fill("#pace", "60")
    page.click("#restart")
    page.wait_for_function(
        "document.querySelector('#motion_says').textContent.startsWith('off the belt')",
        timeout=10_000,
    )
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
def test_words_and_rates_are_those_of_python(explorer: Explorer) -> None:
    """The article's state after the jump grows by 4.9e-6: words and rate in the table are
    Python's.
    """
    explorer.open("theta0_deg=30&mu0=0.5")
    heads, *said = explorer.page.evaluate(
        "[...document.querySelectorAll('#states tr')].map(r => [...r.cells].map(c => "
        "c.textContent.trim()))"
    )
    column = dict(zip(heads, zip(*said, strict=True), strict=True))
    rows = 0
    for contact, name in ((True, "contact"), (False, "lift-off")):
        eq = ss.equilibria(ss.Parameters.article(theta0=math.radians(30.0)), contact=contact)
        for slot in range(int(eq.count)):
            word = column["without damping"][rows].split()[-1]
            assert column["regime"][rows] == name
            assert word == ss.EquilibriumType(int(eq.undamped[slot])).name.lower()
            assert column["stability"][rows] == eq.stability[slot]
            written = column["growth"][rows].replace("\u2212", "-")
            assert float(written) == pytest.approx(float(eq.growth[slot]), rel=0.05)
            rows += 1
    assert rows == len(said) == 4


@pytest.mark.thorough
@pytest.mark.parametrize("width", [390, 1300])
def test_what_is_printed_stands_in_its_box(explorer: Explorer, width: int) -> None:
    """Drawings, their glass and the table within the paper's width, before it is taken."""
    page = explorer.page
    page.set_viewport_size({"width": width, "height": 1000})
    explorer.settle()
    size = "[document.querySelector('#plane .uplot')].map(o => [o.clientWidth, o.clientHeight])"
    on_screen = page.evaluate(size)
    outside = page.evaluate("""async () => {
        dispatchEvent(new Event("beforeprint"));
        await null;
        const box = (element) => element.getBoundingClientRect();
        const within = (inner, outer) => inner.left >= outer.left - 1 && inner.right <= outer.right + 1
            && inner.top >= outer.top - 1 && inner.bottom <= outer.bottom + 1;
        const drawn = [...document.querySelectorAll(".uplot, #states")];
        const glass = [...document.querySelectorAll(".u-over > .overlay")];
        return [drawn.length, glass.length,
            ...drawn.filter((one) => !within(box(one), box(one.parentNode))).map((one) => one.parentNode.id),
            ...glass.filter((one) => Math.abs(one.width - box(one).width) > 1).map(() => "glass")];
    }""")
    columns = page.evaluate(
        "new Set([...document.querySelectorAll('section')].map(s => s.getBoundingClientRect().left)).size"
    )
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    explorer.settle()
    assert outside == [6, 2]
    assert columns == 1
    assert page.evaluate(size) == on_screen
