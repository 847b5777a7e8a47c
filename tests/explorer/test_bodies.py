"""The moving drawing of several bodies and contacts: what is read off a page, and in a browser
where bodies are.
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("sympy", reason="SymPy is not installed: the scene is derived")

import spragsym as ss
from spragsym.cli.pages import page as page_of
from spragsym.derive import pages
from spragsym.derive.scene import Scene
from tests.explorer.pages import Explorer, chromium, window
from tests.oracles.contact_pages import FOUR, ROW, SHOES
from tests.oracles.user_pages import shipped_page

SceneOf = Callable[[str], Scene]
#: Pixels of a length 1.
SCALE = 150.0


@pytest.fixture
def scene_of(tmp_path: Path) -> Callable[[str], Scene]:
    def read(text: str) -> Scene:
        path = tmp_path / "a_page.py"
        path.write_text(text, encoding="utf-8")
        return Scene(pages.read(path).mechanics)

    return read


def arms(scene: Scene) -> list[tuple[str, ...]]:
    (function,) = scene.module().functions
    return [tuple(map(str, pair)) for pair in function.results]


def test_legs_and_a_stop_are_where_their_page_has_them(scene_of: SceneOf) -> None:
    """Legs a before and behind the centre and h below it, the stop to the right."""
    scene = scene_of(FOUR)
    said = scene.as_json()
    assert said["bodies"] == [{"sense": 1, "along": 0, "across": 1, "angle": 2}]
    assert arms(scene)[:3] == [("-1", "-h"), ("1", "-h"), ("0", "-h")]
    assert [one["outward"] for one in said["contacts"]] == [(0, -1)] * 3 + [(1, 0)]
    assert [tie["kind"] for tie in said["ties"]] == ["along", "angle"]


def test_blocks_in_a_row_are_bodies_that_springs_join(scene_of: SceneOf) -> None:
    said = scene_of(ROW).as_json()
    count = len(said["bodies"])
    assert count > 2
    assert said["bodies"] == [{"sense": 1, "along": index} for index in range(count)]
    assert [tie["bodies"] for tie in said["ties"] if len(tie["bodies"]) > 1]


def test_what_only_turns_lies_on_the_side_of_its_contact(scene_of: SceneOf) -> None:
    """Of shoes that turn alone, and of a disc whose angle runs clockwise."""
    shoes, disc = scene_of(SHOES), scene_of(shipped_page("disc_between_pads"))
    assert [body.keys() & {"along", "across"} for body in shoes.as_json()["bodies"]] == [
        set(),
        set(),
    ]
    assert [one["sense"] for one in disc.as_json()["bodies"]] == [-1]
    assert arms(disc) == [("0", "1"), ("0", "-1")]


# ------------------------------------------------------------------------------------------------
# in a browser


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as started:
        yield window(started, reduced_motion="reduce")


def opened(browser: Any, name: str, folder: Path) -> Explorer:
    out = folder / f"{name}.html"
    out.write_text(page_of(ss.load(name)), encoding="utf-8")
    explorer = Explorer(browser.new_page(), out.as_uri())
    explorer.open()
    return explorer


def edge(explorer: Explorer) -> np.ndarray[Any, Any]:
    """The bottom of the first body, as a vector."""
    one, other = corners(explorer, 1)[:2]
    return other - one


def corners(explorer: Explorer, body: int) -> np.ndarray[Any, Any]:
    """Corners of a body in lengths, y upwards."""
    text = explorer.page.get_attribute(f"#body_{body}", "d").strip("MZ")
    points = np.array([[float(part) for part in pair.split(",")] for pair in text.split(" L")])
    return points * [1, -1] / SCALE


@pytest.mark.thorough
def test_blocks_stand_and_move_where_their_states_are(browser: Any, tmp_path: Path) -> None:
    explorer = opened(browser, "two_blocks", tmp_path)
    page, model = explorer.page, ss.load("two_blocks")

    def centres() -> np.ndarray[Any, Any]:
        return np.array([corners(explorer, body).mean(axis=0)[0] for body in (1, 2)])

    found = []
    for mu_s in (1.0, 0.6):
        page.fill("#mu_s", repr(mu_s))
        explorer.settle()
        eq = ss.equilibria(model.Parameters(**{**model.base, "mu_s": mu_s}))
        found.append((centres(), np.array([eq["x_1"][0], eq["x_2"][0]])))
    (shown, there), (shown_too, there_too) = found
    assert shown_too - shown == pytest.approx(there_too - there, abs=1e-3)
    before = centres()
    page.focus("#body_2")
    for step in (1, 2, 3):
        page.keyboard.press("ArrowRight")
        assert centres() - before == pytest.approx([0.0, 0.02 * step], abs=2e-4)
    page.click("#restart")
    seen = []
    for _ in range(3):
        page.wait_for_timeout(200)
        seen.append(centres())
    assert len({tuple(one) for one in seen}) == 3
    assert explorer.errors == []
    page.close()


@pytest.mark.thorough
def test_a_pad_is_tilted_as_its_state_is_and_stays_rigid(browser: Any, tmp_path: Path) -> None:
    """By φ of Python, its corners at one distance in motion too."""
    explorer = opened(browser, "pad_on_legs", tmp_path)
    page, model = explorer.page, ss.load("pad_on_legs")
    page.fill("#mu0", "0.9")
    explorer.settle()
    eq = ss.equilibria(model.Parameters(**{**model.base, "mu0": 0.9}))
    assert np.arctan2(*edge(explorer)[::-1]) == pytest.approx(float(eq["phi"][0]), abs=1e-4)
    page.fill("#kappa", "0.4")
    page.click("#restart")
    seen = []
    for _ in range(3):
        page.wait_for_timeout(200)
        seen.append(edge(explorer))
    across, up = np.transpose(seen)
    sizes = np.hypot(across, up)
    assert sizes == pytest.approx(sizes[0], abs=1e-3)
    assert np.unique(np.arctan2(up, across)).size == 3
    assert explorer.errors == []
    page.close()
