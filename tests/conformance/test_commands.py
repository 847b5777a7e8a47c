"""Every command about a model: the same keys for all of them, and what Python says."""

import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.command_line import options_of
from spragsym.display import own_name
from spragsym.files import storage
from spragsym.results.points import UNSTABLE
from tests.conformance import models
from tests.conformance.models import ALIKE, MODELS, MOVING, load, moved
from tests.conftest import Run
from tests.oracles.user_pages import derived, shipped_page
from tests.support import few


def of(name: str, *more: str) -> list[str]:
    """The options for a model at its base values, 20 degrees where there is none."""
    return [*models.words(name, 20.0), *more]


def a_set(name: str) -> Any:
    """The same in Python."""
    return models.a_set(name, 20.0)


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "kang_nam", "stick_slip", "pressed"))
def test_equilibria_have_the_same_keys_and_are_those_of_python(name: str, run: Run) -> None:
    told = json.loads(run("equilibria", *of(name), "--json"))
    assert list(told) == ["model", "parameters", "equilibria", "complete", "undecided", "remarks"]
    p, model = a_set(name), load(name)
    assert [key.removesuffix("_deg") for key in told["parameters"]] == list(model.parameters)
    for one, shown in zip(model.parameters, told["parameters"].values(), strict=True):
        assert shown == pytest.approx(_degrees(model, one, np.atleast_1d(p[one]))[0], rel=1e-15)
    rows = [(state, eq, slot) for state, eq in _states(p) for slot in range(int(eq.count))]
    assert len(told["equilibria"]) == len(rows) > 0
    for row, (state, eq, slot) in zip(told["equilibria"], rows, strict=True):
        touching = ["touching"] * model.has_regimes
        assert list(row)[: 2 + len(touching)] == ["state", *touching, "stability"]
        last = ("growth", "error", "undamped", "marginal")
        assert list(row)[-4:] == [own_name(model, one) for one in last]
        assert row["state"] == state
        for entry in model.about["coordinates"]:
            value = float(eq[entry["name"]][slot])
            angle = entry["unit"] == "rad"
            # An inclination that was typed in degrees may be off by its last place.
            exact = pytest.approx(math.degrees(value) if angle else value, rel=1e-15, abs=0.0)
            assert row[entry["name"] + "_deg" * angle] == exact
    assert told["complete"] == all(eq.complete for _, eq in _states(p))


def _states(p: Any) -> list[tuple[str, Any]]:
    return [
        (state, ss.equilibria(p, contact=contact)) for contact, state in p.model.regimes.items()
    ]


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "mode_coupling", "kang_nam"))
def test_equilibria_of_every_model_along_a_range(name: str, run: Run) -> None:
    """By --vary, and by a list in the option itself: the same table."""
    vary, base = moved(name, "mu0")
    span = f"{base!r}:{1.25 * base!r}:2"
    ranged = run("equilibria", *of(name), "--vary", f"{vary}={span}")
    assert ranged == run("equilibria", *of(name, options_of(load(name).about, vary)[0], span))
    assert ranged.split()[0] == vary
    points = json.loads(run("equilibria", *of(name), "--vary", f"{vary}={span}", "--json"))[
        "points"
    ]
    assert [point["parameters"][vary] for point in points] == [base, 1.25 * base]


def test_a_file_of_a_brake_brings_its_model(tmp_path: Path, run: Run) -> None:
    """With k_3 = 0 cubic_contact is the article's model: the same answers in the file's units, by
    the model's own law.
    """
    lines = run("report", "--example").splitlines(keepends=True)
    text = "".join(line for line in lines if not line.startswith("damping_ratio"))
    one, two = tmp_path / "one.toml", tmp_path / "two.toml"
    one.write_text(text, encoding="utf-8")
    two.write_text(
        text.replace('"kang_nam"', '"cubic_contact"') + 'k_3 = "0 N/mm^3"\n', encoding="utf-8"
    )
    told = [json.loads(run("equilibria", "--data", str(file), "--json")) for file in (one, two)]
    assert [each["model"] for each in told] == ["kang_nam", "cubic_contact"]
    for row, other in zip(*(each["equilibria"] for each in told), strict=True):
        assert list(row) == list(other)
        for key in ("x_mm", "y_mm", "growth_per_s"):
            assert other[key] == pytest.approx(row[key], rel=1e-6)
    study = ss.Study.from_file(one)
    p = study.dimensionless
    at_work = p.replace(mu0=study.friction[1])
    growth = ss.equilibria(at_work).growth
    assert told[0]["equilibria"][0]["growth_per_s"] == pytest.approx(
        float(growth[0]) / study.scales.time, rel=1e-9
    )
    assert growth[0] != ss.equilibria(at_work.replace(V=0.5, d=10.0)).growth[0]
    said = run("equilibria", "--data", str(two), "--model", "damped", code=2)
    assert "is about cubic_contact" in said


# -----------------------------------------------------------------------------------------------
# points and paths


@pytest.mark.by_hand("soft_brake", *ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "kang_nam"))
def test_folds_have_the_same_keys_and_are_those_of_python(name: str, run: Run) -> None:
    told = json.loads(run("folds", *of(name), "--json"))
    assert list(told) == ["model", "vary", "points", "complete", "searched", "undecided", "remarks"]
    model, p = load(name), a_set(name)
    found = ss.folds(p, model.axes[-1])
    known = _degrees(model, model.axes[-1], found[model.axes[-1]])
    assert [row[told["vary"]] for row in told["points"]] == pytest.approx(known, rel=1e-12)
    assert (told["complete"], told["remarks"]) == (found.complete, list(found.remarks))
    places = [_title(model, column) for column in found.state_columns]
    after = [_title(model, column, "_after") for column in found.state_columns]
    for row in told["points"]:
        assert list(row) == [
            told["vary"],
            "kind",
            *places,
            "ends",
            "when",
            *UNSTABLE,
            *after,
            "error",
        ]
    assert run("folds", *of(name))


def _title(model: ss.Model, column: str, end: str = "") -> str:
    angles = {entry["name"] for entry in model.about["coordinates"] if entry["unit"] == "rad"}
    return column + end + "_deg" * (column in angles or column.startswith("theta"))


def _degrees(model: ss.Model, name: str, values: Any) -> list[float]:
    return [
        math.degrees(value) if name in model.about["angles"] else value for value in values.tolist()
    ]


@pytest.mark.by_hand("soft_brake", "two_springs", *ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "mode_coupling", "kang_nam"))
def test_onsets_have_the_same_keys(name: str, run: Run) -> None:
    told = json.loads(run("bifurcation", *of(name), "--vary", load(name).axes[0], "--json"))
    assert list(told) == ["model", "parameters", "folds", "onsets"]
    names = [
        "omega",
        "criticality",
        "when",
        "onset",
        *UNSTABLE,
        "lyapunov",
        "lyapunov_error",
        "crossing",
        "why",
        "error",
    ]
    keys = [own_name(load(name), key) for key in names]
    for row in told["onsets"]["points"]:
        assert list(row)[-len(keys) :] == keys
    shown = run("bifurcation", *of(name), "--vary", load(name).axes[0], "--undamped")
    assert "Onsets" in shown


def test_columns_of_a_page_stand_in_tables_as_its_own(run: Run) -> None:
    """A parameter called as a column of ours that stands in no table is shown, ours is not; and
    one whose name begins as that of our growth rates has its digits.
    """
    text = shipped_page(
        "stick_slip",
        ('becomes="zeta"', 'becomes="lyapunov"'),
        ('"> 0", 0.1)', '"> 0", 0.1, becomes="growth_v")'),
    )
    named = ["--model", str(derived(text, "named_as_columns"))]
    *_, head, row = run("bifurcation", *named, "--vary", "lyapunov=0:1").splitlines()
    assert head.split()[:2] == ["lyapunov", "kind"]
    assert "lyapunov_" not in head.split()
    # The onset is where damper and slope of the law cancel, as the page of stick_slip says.
    value = 2 * 0.5 * 0.1 * (0.5**2 - 0.1**2) / (0.5**2 + 0.1**2) ** 2
    assert float(row.split()[0]) == pytest.approx(value, rel=1e-7)
    rows = run("equilibria", *named, "--vary", "growth_v=0.1234:0.5678:2").splitlines()
    assert [line.split()[0] for line in rows] == ["growth_v", "0.1234", "0.5678"]
    column = rows[0].split().index("growth")
    assert all(re.fullmatch(r"-?\d\.\de[+-]\d\d", line.split()[column]) for line in rows[1:])


PLANES = [name for name in MODELS if len(load(name).axes) == 2]


@pytest.mark.by_hand("soft_brake", "two_springs", *ALIKE)
@pytest.mark.thorough
@pytest.mark.parametrize("name", few(PLANES, "kang_nam"))
def test_cusps_have_the_same_keys(name: str, run: Run) -> None:
    model = load(name)
    inclination, coefficient = model.axes
    most = min(85.0, math.degrees(0.9 * model.Parameters.ranges[inclination].high))
    ranges = f"{inclination}=5:{most}", f"{coefficient}=0:1"
    told = json.loads(
        run("bifurcation", *of(name)[:2], "--vary", ranges[0], "--vary", ranges[1], "--json")
    )
    assert list(told) == ["model", "parameters", "folds", "onsets", "cusps"]
    for row in told["cusps"]["points"]:
        places = [_title(model, column) for column in ss.equilibria(a_set(name)).state_columns]
        assert list(row) == [f"{inclination}_deg", coefficient, "kind", *places, "error"]
    assert told["cusps"]["searched"][coefficient] == [0.0, 1.0]
    assert told["folds"]["searched"][f"{inclination}_deg"] == pytest.approx([5.0, most])


#: Beside the anchor of its torsion spring a search over all θ₀ takes minutes; its report does that
#: once.
CRITICAL = [name for name in MODELS if name != "soft_brake"]


@pytest.mark.by_hand("two_springs", "sprag_rod", *ALIKE)
@pytest.mark.parametrize("name", few(CRITICAL, "kang_nam", "stick_slip"))
def test_critical_values_have_the_same_keys(name: str, run: Run) -> None:
    model = load(name)
    vary = model.axes[-1]
    ends = "=20:60" if vary in model.about["angles"] else "=0.05:0.9"
    others = [word for word in of(name) if not word.startswith(f"--{vary}=")]
    told = json.loads(run("critical", *others, "--vary", f"{vary}{ends}", "--json"))
    frictions = ["mu0_jump", "mu0_lowest", "theta0_lowest_deg", "kind_lowest", "mu0_cusp", "mu_cr"]
    assert list(told) == ["model", "vary", "jumps", "jumped", *frictions, "remarks"]
    (jump,) = told["jumps"]
    places = [_title(model, name) for name in model.coordinates]
    assert list(jump) == ["way", "searched", told["vary"], "kind", *places, "error"]
    assert told["mu_cr"] is not None or any(
        text.startswith("mu_cr: linear_critical_friction is not there") for text in told["remarks"]
    )


#: Its tip is pressed on the belt on either side of the pivot; which side is less strained depends on
#: the direction of the pull.
TWO_SIDES = '''"""An arm that turns, its tip on a belt."""
from spragsym.derive.model import Page, cos, sin, tanh
page = Page("An arm whose tip rubs on a belt.")
m = page.unit("m", "kg", "mass of the tip")
W = page.unit("W", "N", "weight of the tip")
R = page.unit("R", "m", "length of the arm")
theta0 = page.parameter("theta0", "rad", "angle of the pull", "(0, pi)", 0.9)
mu0 = page.parameter("mu0", "1", "friction coefficient", "[0, 1]", 0.1)
k_c = page.parameter("k_c", "N/m", "stiffness of the belt", "> 0", 100.0, becomes="stiff")
h = page.parameter("h", "m", "height of the pivot", "> 0", 0.8)
F = page.parameter("F", "N", "pull", ">= 0", 0.5)
V = page.parameter("V", "m/s", "belt speed", "> 0", 0.5)
phi = page.coordinate("phi", "rad", "angle of the arm")
X, Y = R * sin(phi), h - R * cos(phi)
page.kinetic(m * (R * page.rate(phi)) ** 2 / 2)
page.potential(W * Y)
page.force(F * cos(theta0), F * sin(theta0), at=(X, Y))
page.contact(Y, lambda depth: k_c * depth)
page.friction(X, V, lambda v: mu0 * tanh(v / V), at_rest=mu0)
'''


@pytest.mark.thorough
def test_a_lowest_friction_of_another_state_is_not_told(run: Run) -> None:
    """What is followed from the least inclination on never jumps; the state at 30 degrees does."""
    folder = derived(TWO_SIDES, "two_sides")
    p = ss.load(folder).Parameters(theta0=math.radians(30.0))
    assert ss.critical_friction(p).value == math.inf
    words = ["critical", "--model", str(folder), "--theta0", "30"]
    told = json.loads(run(*words, "--json"))
    assert told["mu0_jump"] == pytest.approx(ss.jump_value(p), rel=1e-9)
    assert told["mu0_lowest"] is None
    (why,) = [text for text in told["remarks"] if text.startswith("mu0_lowest: ")]
    assert why.endswith(f" another state is followed than at theta0 = {p.theta0:.6g} rad")


@pytest.mark.by_hand("soft_brake", "sprag_rod", *ALIKE)
@pytest.mark.parametrize("name", few(MODELS, "stick_slip", "kang_nam"))
def test_paths_have_the_same_keys_and_are_those_of_python(name: str, run: Run) -> None:
    model = load(name)
    vary, base = moved(name, "mu0", "V")
    span = f"{vary}={0.2 * base!r}:{1.2 * base!r}:3"
    told = json.loads(run("path", *of(name), "--vary", span, "--json"))
    found = ss.quasi_static_path(a_set(name), vary, np.linspace(0.2 * base, 1.2 * base, 3))
    assert list(told) == ["model", "vary", "states", "jumps"]
    places = [_title(model, column) for column in found.state_columns]
    assert [row[vary] for row in told["states"]] == pytest.approx(found.values, rel=1e-15)
    for row in told["states"]:
        more = ["touching"] * model.has_regimes
        assert list(row) == [vary, "stability", "undamped", "growth", *places, *more]
    for column, place in zip(found.state_columns, places, strict=True):
        unit = math.degrees(1.0) if place.endswith("_deg") else 1.0
        assert [row[place] for row in told["states"]] == pytest.approx(
            unit * found.places[column], rel=1e-12
        )
    assert len(told["jumps"]) == len(found.jumps)
    assert "States" in run("path", *of(name), "--vary", span)


# ------------------------------------------------------------------------------------------------
# motions


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(MOVING, "kang_nam", "stick_slip", "sprag_rod"))
def test_motions_have_the_same_keys_and_are_those_of_python(name: str, run: Run) -> None:
    model = load(name)
    first, *_ = model.coordinates
    angle = {entry["name"]: entry["unit"] for entry in model.about["coordinates"]}[first] == "rad"
    words = [
        "--t-end",
        "30",
        "--backend",
        "scipy",
        "--rtol",
        "1e-8",
        f"--{first}0",
        "2" if angle else "0.05",
    ]
    told = json.loads(run("simulate", *of(name), *words, "--json"))
    size = ["rms", "rms_about_mean", "mean", "largest"]
    events = [kind.name.lower() for kind in ss.Event]
    assert list(told) == [
        "model",
        *(key + "_deg" * angle for key in size),
        "period",
        "converged",
        *events,
        "backend",
    ]
    unit = math.degrees(1.0) if angle else 1.0
    start = {f"{first}0": math.radians(2.0) if angle else 0.05}
    tr = ss.simulate(a_set(name), t_end=30.0, rtol=1e-8, backend="scipy", **start)
    assert told["rms" + "_deg" * angle] == pytest.approx(unit * tr.rms(22.5), rel=1e-9)


@pytest.mark.by_hand("sprag_rod", "mode_coupling", "two_springs", "two_blocks", *ALIKE)
@pytest.mark.thorough
@pytest.mark.parametrize("name", few(MOVING, "stick_slip"))
def test_maps_of_fates_of_every_model_are_those_of_python(
    name: str, tmp_path: Path, run: Run
) -> None:
    out, picture = tmp_path / "map.csv", tmp_path / "map.svg"
    spans = {}
    for axis in (moved(name, "V"), moved(name, *(one for one in load(name).base if one != "V"))):
        spans |= {axis[0]: f"{axis[1]!r},{1.1 * axis[1]!r}"}
    axes = [f"{options_of(load(name).about, axis)[0]}={span}" for axis, span in spans.items()]
    run("fates", *of(name), *axes, "--t-end", "300", "-q", "-o", str(out), "--plot", str(picture))
    columns, _ = storage.read(out)
    known = ss.fate_map(
        a_set(name).replace(**{axis: columns[axis].astype(float) for axis in spans}), t_end=300.0
    )
    assert columns["kind"].astype(int).tolist() == known.kind.tolist()
    assert columns["period"].astype(float) == pytest.approx(known.period, nan_ok=True)
    assert "<svg" in picture.read_text(encoding="utf-8")
