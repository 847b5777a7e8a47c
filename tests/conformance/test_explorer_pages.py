"""The explorer's page of every model: the same parts and columns, the states that Python proves,
and its motion.
"""

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.cli.pages import page as page_of
from spragsym.display import own_name
from spragsym.models.forces import named
from tests.conformance.models import ALIKE, MODELS, answers, load, place, starts
from tests.explorer.pages import WITHOUT_WEBGL, Explorer, chromium
from tests.oracles.contact_pages import PAD
from tests.oracles.user_pages import model_of
from tests.support import few

pytest.importorskip("sympy", reason="SymPy is not installed: pages of models are derived")

#: Parts of each page, in their order; of closed forms there may be more.
PARTS = ["mechanism_part", "plane_part", "along_part", "parameter_part", "built_part"]


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as started:
        context = started.new_context(
            viewport={"width": 1300, "height": 1000}, reduced_motion="reduce"
        )
        context.add_init_script(WITHOUT_WEBGL)
        yield context


def opened(browser: Any, model: ss.Model, folder: Path) -> Explorer:
    out = folder / f"{model.name}.html"
    out.write_text(page_of(model), encoding="utf-8")
    explorer = Explorer(browser.new_page(), out.as_uri())
    explorer.open()
    return explorer


def points(model: ss.Model, n: int) -> list[dict[str, float]]:
    """Random points about the base values, within the domains."""
    rng = np.random.default_rng(len(model.name))
    found = []
    most = {
        one["name"]: math.inf if one["high"] is None else one["high"]
        for one in model.about["parameters"]
    }
    for _ in range(n):
        values = {
            name: min(value * rng.uniform(0.7, 1.3), most[name])
            for name, value in model.base.items()
        }
        found.append(
            values
            | {name: rng.uniform(0.3, 1.5) for name in model.parameters if name not in values}
        )
    return found


def compare_states(
    explorer: Explorer, model: ss.Model, point: dict[str, float], status: str
) -> int:
    """Hold the page's states against those that Python proves, by coordinate and by word; how many
    there are.
    """
    total = 0
    for contact in model.regimes:
        eq = ss.equilibria(model.Parameters(**point), contact=contact)
        count = int(eq.count)
        found = explorer.page.evaluate(
            "p => window.spragsym.equilibria(p)", {**point, "contact": contact}
        )
        assert (found["status"], found["count"]) == (status, count)
        where = np.array([eq[name][:count] for name in model.coordinates])
        there = sorted(found["states"], key=lambda state: state[model.coordinates[0]])
        for slot, state in zip(np.argsort(where[0]), there, strict=True):
            assert [state[name] for name in model.coordinates] == pytest.approx(
                where[:, slot], abs=1e-9
            )
            assert state["undamped"] == ss.EquilibriumType(int(eq.undamped[slot])).name.lower()
        total += count
    return total


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "kang_nam"))
def test_every_page_has_the_same_parts_and_the_states_of_python(
    name: str, browser: Any, tmp_path: Path
) -> None:
    model = load(name)
    if not answers(model, "explore", lambda: page_of(model)):
        return
    explorer = opened(browser, model, tmp_path)
    page = explorer.page
    parts = page.evaluate(
        "[...document.querySelectorAll('main > section[id]')].map(part => part.id)"
    )
    assert [part for part in parts if part in PARTS] == PARTS
    assert page.is_visible("#plane_part") == (len(model.plane) == 2)
    heads = page.evaluate(
        "[...document.querySelectorAll('#states th')].map(cell => cell.textContent)"
    )
    springs = len(model.about["springs"])
    assert heads[:3] == ["", "regime", "stability"]
    for head, spelled in ((r"θ.*", "theta"), (r"L\S*", "L")):
        own = sum(one.startswith(spelled) for one in model.coordinates)
        assert sum(bool(re.fullmatch(head, one)) for one in heads) == springs + own
    rubbing = [one["name"] for one in model.frictions] or [""]
    told = [f"normal n {one['name']}".strip() for one in model.contacts]
    told += [f"friction μn {one}".strip() for one in rubbing]
    assert heads[-len(told) :] == told
    ids = page.evaluate(
        "[...document.querySelectorAll('#parameters input[type=text]')].map(box => box.id)"
    )
    assert [one.removesuffix("_deg") for one in ids] == list(model.parameters)
    rows = page.evaluate(
        "[...document.querySelectorAll('#states tbody tr')].map(r => [...r.cells].map(c => "
        "c.textContent))"
    )
    eq, p = ss.equilibria(model.cases()[0][1]), model.cases()[0][1]
    read = [
        [float(row[k].replace("\u2212", "-")) for row in rows if row[1] != "lift-off"]
        for k in range(-len(told), 0)
    ]
    normals = dict(zip((one["name"] for one in model.contacts), read, strict=False))
    for one in (entry["name"] for entry in model.contacts if entry["gap"] is not None):
        by_python = eq[own_name(model, named("contact_force", one))][: int(eq.count)]
        assert sorted(normals[one]) == pytest.approx(sorted(map(float, by_python)), rel=1e-4)
    for one, forces in zip(rubbing, read[len(normals) :], strict=True):
        mu = float(model.friction(p, "friction_at_rest", one or None)) if model.frictions else 0.0
        assert forces == pytest.approx([mu * value for value in normals[one]], rel=1e-4)
    command = page.inner_text("#proof").split()
    assert command[:4] == ["spragsym", "equilibria", "--model", place(name)]
    status = "ok" if name == "kang_nam" else "searched"
    assert sum(compare_states(explorer, model, point, status) for point in points(model, 3)) >= 3
    assert explorer.errors == []
    page.close()


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "kang_nam"))
def test_every_motion_is_pythons(name: str, browser: Any, tmp_path: Path) -> None:
    """From rest, over lift-offs and overtakings, by steps that are cut at kinks, and sticking;
    errors of order h^4.
    """
    model = load(name)
    if not model.frictions:
        pytest.skip(f"{name} has no belt")
    if not answers(model, "explore", lambda: page_of(model)):
        return
    explorer = opened(browser, model, tmp_path)
    (point,) = points(model, 1)
    run = (
        "([p, s]) => { const m = window.spragsym.motion(p); for (let i = 0; i < 3000; i++) s = "
        "m.step(s, 0.01); return s; }"
    )
    p = model.Parameters(**point)
    for start in starts(p, [0.05] + [0.0] * (2 * len(model.coordinates) - 1)):
        tr = ss.simulate(p, start=start, t_end=30.0)
        assert explorer.page.evaluate(run, [point, start]) == pytest.approx(
            tr.state[:, -1], abs=2e-6
        )
    assert explorer.errors == []
    explorer.page.close()


@pytest.mark.thorough
def test_a_state_passes_where_a_leg_lifts_or_ends_there(browser: Any, tmp_path: Path) -> None:
    """The rear of two legs lifts at μ = (2 k_c a² + k_t)/(2 k_c a h), without k_t at a/h, where the
    state ends.
    """
    explorer = opened(browser, model_of(PAD, "pad_explored"), tmp_path)
    page = explorer.page
    for k_t, lifts in ((0.3, 2.3 / 1.6), (0.0, 1.0 / 0.8)):
        for name, value in (("k_t", k_t), ("mu0", lifts - 0.01), ("mu0", lifts + 0.01)):
            page.fill(f"#{name}", repr(value))
            explorer.settle()
        said = explorer.says()
        assert ("in contact of front alone" in said and "jumped" not in said) == bool(k_t)
        assert k_t or "No state was found" in said
    assert explorer.errors == []
    page.close()


@pytest.mark.validate
def test_search_finds_what_the_solver_of_closed_forms_proves(browser: Any, tmp_path: Path) -> None:
    """The article's page without its closed forms is that of any model, and follows over the same
    fold.
    """
    model = ss.load("kang_nam").search
    explorer = opened(browser, model, tmp_path)
    for point in points(model, 20):
        compare_states(explorer, model, point, "searched")
    fold = math.degrees(float(ss.folds(ss.Parameters.article(), "theta0").theta0[0]))
    explorer.page.fill("#theta0_deg", f"{fold + 1:.6f}")
    said = re.search(r"state ended at θ₀ = ([\d.]+)°", explorer.says())
    assert said is not None
    assert float(said[1]) == pytest.approx(fold, abs=0.05)
    assert explorer.errors == []
    explorer.page.close()


#: A door whose closer lets it turn beyond one turn: states at 48°, 175° and 318°.
DOOR = '''r"""A door on an inclined hinge."""
from spragsym.derive.model import Page, cos, tanh
page = Page("A door on an inclined hinge with a closer.")
I = page.unit("I", "kg m^2", "inertia of the door")
rho = page.unit("rho", "m", "radius of the pin")
W = page.unit("W", "N", "load of the pin")
mu = page.parameter("mu", "1", "friction of the pin", ">= 0", 0.5)
g = page.parameter("g", "N m", "moment of the weight", ">= 0", 0.5)
k = page.parameter("k", "N m", "closer", ">= 0", 0.15)
V = page.parameter("V", "rad/s", "speed of the wall", "> 0", 0.4)
phi = page.coordinate("phi", "rad", "opening")
page.kinetic(I * page.rate(phi) ** 2 / 2)
page.potential(-g * cos(phi) + k * phi**2 / 2)
page.normal_force(W)
page.friction(rho * phi, rho * V, lambda v: mu * tanh(20 * v / (rho * V)), at_rest=mu)
'''


@pytest.mark.thorough
def test_states_of_an_angle_beyond_one_turn_are_found(browser: Any, tmp_path: Path) -> None:
    explorer = opened(browser, model_of(DOOR, "door"), tmp_path)
    point = {"mu": 0.5, "g": 0.5, "k": 0.15, "V": 0.4}
    found = explorer.page.evaluate("p => window.spragsym.equilibria(p)", {**point, "contact": True})
    angles = np.linspace(-10, 10, 100_001)
    force = 0.5 * np.sin(angles) + 0.15 * angles - 0.5
    assert found["count"] == np.count_nonzero(force[1:] * force[:-1] < 0) == 3
    assert explorer.errors == []
