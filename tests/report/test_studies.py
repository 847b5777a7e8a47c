"""A brake in, a verdict out: units, files, and the report's numbers against direct calls."""

import itertools
import json
import math
import re
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym import figures
from spragsym.files.text import filled
from spragsym.report import advice, facts, redesigns, tolerances
from spragsym.report.tolerances import certificate
from tests.conftest import Run
from tests.oracles import user_pages
from tests.oracles.mistakes import BRAKE, TOLERANT
from tests.report.test_sentences import BRAKE as IN_SI
from tests.support import few, written_brake

#: Without tolerances, as :func:`brake` has it.
EXACT = {name: BRAKE[name] for name in ("k", "k_x", "k_c", "theta0")}
#: The article's model by its page and the search.
CUBIC = {"model": "cubic_contact", "k_3": "0 N/mm^3"}
#: A disc between two pads: friction tilts with it, and turns it where it is nearer to one of them.
BINARY = '''
"""Binary flutter after North."""
from spragsym.derive.model import Page, sin
page = Page("A disc between two pads.")
m, k, h = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness"), page.unit("h", "m", "half of its thickness")
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.3, role="friction")
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.05, becomes="zeta")
y, phi = page.coordinate("y", "m", "displacement"), page.coordinate("phi", "rad", "turning")
page.kinetic(m * (page.rate(y)**2 + 2 * h**2 * page.rate(phi)**2) / 2)
page.potential(k * (3 * y**2 + 5 * h**2 * phi**2) / 2)
page.damper(c, along=y)
page.force(mu0 * k * h * sin(phi), along=y)
page.force(-2 * mu0 * k * h * y, along=phi)
'''
#: What takes longest of a report.
QUICKLY: dict[str, Any] = {"oscillation": False, "probability": False, "redesign": False}


def written(
    folder: Path, rows: Mapping[str, str | None] = {}, brake: Mapping[str, str] = TOLERANT
) -> Path:  # read only
    """The file of a brake with some quantities replaced, or left out."""
    return written_brake(
        folder, {name: value for name, value in {**brake, **rows}.items() if value is not None}
    )


def studied(
    folder: Path, rows: Mapping[str, str | None], brake: Mapping[str, str] = TOLERANT
) -> ss.Study:
    return ss.Study.from_file(written(folder, rows, brake))


KEYS = [
    "mu_jump",
    "theta0_jump_deg",
    "mu0_jump",
    "mu_lowest",
    "theta0_lowest_deg",
    "kind_lowest",
    "mu_cusp",
    "mu_effective",
    "margin_percent",
    "states",
    "frequencies_hz",
    "spring_force_N",
    "contact_force_N",
    "displacement_mm",
    "oscillation",
    "certificate",
    "probability",
    "sobol",
    "redesign",
    "warnings",
    "reach",
    "speed_jump",
    "jump",
    "verdict",
    "folds",
    "vary",
    "jump_at",
    "other_states",
    "next_steps",
    "about",
]


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("studies"))


@pytest.fixture(scope="module")
def study(path: Path) -> ss.Study:
    return ss.Study.from_file(path)


@pytest.fixture(scope="module")
def report(study: ss.Study) -> ss.results.Report:
    return study.report(n=1024, oscillation=False, redesign=False)


@pytest.fixture(scope="module")
def redesigned(study: ss.Study) -> ss.results.Report:
    return study.report(oscillation=False, probability=False)


@pytest.mark.thorough
def test_the_numbers_are_those_of_direct_calls_without_units(report: ss.results.Report) -> None:
    # By hand: k_c L_0 = 57 000 N; κ = 420/57000, α = 9/1500, σ = 180/1500, β = 0; time
    # sqrt(0.35/1.5e6) s.
    p = ss.Parameters(
        theta0=math.radians(52), mu0=0.45, kappa=420 / 57000, alpha=0.006, sigma=0.12, beta=0.0
    )
    assert report.mu_jump == pytest.approx(ss.jump_value(p), rel=1e-12)
    working = 0.45 * -math.expm1(-12.0)
    assert report.mu_effective == pytest.approx(working, rel=1e-12)
    at = p.replace(mu0=working)
    assert report.theta0_jump_deg == pytest.approx(
        math.degrees(ss.jump_value(at, "theta0")), rel=1e-12
    )
    assert report.mu_cusp == pytest.approx(ss.cusp_friction(p), rel=1e-12)
    lowest = ss.critical_friction(p)
    assert report.mu_lowest == pytest.approx(float(lowest), rel=1e-12)
    assert report.theta0_lowest_deg == pytest.approx(math.degrees(lowest.theta0), rel=1e-12)
    assert report.kind_lowest == lowest.kind
    eq = ss.equilibria(at)
    assert len(report.states) == eq.count
    for i, state in enumerate(report.states):
        assert state.x_mm == pytest.approx(38 * eq.x[i], rel=1e-9)
        assert state.contact_force_N == pytest.approx(-57000 * eq.y[i], rel=1e-9)
        assert state.spring_force_N == pytest.approx(57000 * 0.12 * (eq.L[i] - 1), rel=1e-9)
        hertz = (
            np.sort(np.abs(eq.eigenvalues[i].imag))[::2] * math.sqrt(1.5e6 / 0.35) / (2 * math.pi)
        )
        assert np.allclose(
            state.frequencies_hz, hertz[hertz > 0], rtol=1e-3
        )  # the law's damping is left out here


@pytest.mark.by_hand("True")
@pytest.mark.parametrize("tolerances", few([True, False], False))
def test_json_has_the_keys_of_the_contract(
    tolerances: bool, tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And nothing else is written on stdout, be there a page too."""
    monkeypatch.setattr(ss.results.Report, "to_html", lambda *_: None)
    page = "--html", str(tmp_path / "a.html")
    found = json.loads(
        run(
            "report",
            str(written(tmp_path, {} if tolerances else EXACT | {"mu0": "0.45"})),
            "--json",
            *page,
        )
    )
    assert list(found) == KEYS
    assert found["folds"][0]["friction"] == pytest.approx(found["mu_jump"], rel=1e-12)
    state = next(one for one in found["states"] if one["current"])
    way = found["folds"][0]
    assert (
        way["before"]["x_mm"] < way["after"]["x_mm"] < state["x_mm"]
    )  # it has jumped, and friction has grown since


def brake(**changes: float | None) -> ss.PhysicalParameters:
    # None for V and d only
    return ss.PhysicalParameters(**{**IN_SI, **changes})  # type: ignore[arg-type]


@pytest.mark.thorough
def test_changes_hold_for_all_brakes_within_the_tolerances(
    study: ss.Study, redesigned: ss.results.Report
) -> None:
    """Random brakes about each new design, every tolerance the same share of the new value: none
    jumps below 0.6.
    """
    rng = np.random.default_rng(11)
    off = {name: rng.uniform(-0.15, 0.15, 4000) for name in ("k", "k_x", "k_c")}
    for change in redesigned.redesign:
        values: dict[str, object] = {**study.values, **change.after}
        # numbers
        values |= {name: float(values[name]) * (1 + share) for name, share in off.items()}  # type: ignore[arg-type]
        # a number
        values["theta0"] = float(values["theta0"]) + rng.uniform(-1, 1, 4000) * math.pi / 180  # type: ignore[arg-type]
        # arrays
        jump = np.asarray(ss.jump_value(ss.PhysicalParameters(**values).dimensionless()))  # type: ignore[arg-type]
        assert not (jump < 0.6).any()
        assert change.probability == 0
        assert change.outcome == "proved"


@pytest.mark.thorough
def test_how_far_a_change_is_is_told_in_tolerances(
    study: ss.Study, redesigned: ss.results.Report
) -> None:
    sizes = {name: 0.15 * study.values[name] for name in ("k", "k_x", "k_c")}
    sizes["theta0"] = math.radians(1.0)
    told = 0
    for change in redesigned.redesign:
        if change.after.keys() <= sizes.keys():
            steps = [(new - study.values[name]) / sizes[name] for name, new in change.after.items()]
            assert change.distance == pytest.approx(math.hypot(*steps), rel=1e-9)
            told += 1
    assert told


@pytest.mark.thorough
def test_a_change_that_is_small_in_si_goes_on_to_its_own_end() -> None:
    """A longer spring, by centimetres: at no corner of the tolerances it jumps in use."""
    used = 0.499
    study = ss.Study({**IN_SI, "mu0": used}, {"L_0": "2 %", "k": "10 %"})
    (longer,) = (one for one in redesigns.changes(study, 0.5) if [*one.after] == ["L_0"])
    assert longer.after["L_0"] > IN_SI["L_0"]
    for length, stiffness in itertools.product((0.98, 1.02), (0.9, 1.1)):
        corner = brake(L_0=length * longer.after["L_0"], k=stiffness * IN_SI["k"])
        assert not ss.jump_value(corner.dimensionless()) < used


@pytest.mark.thorough
def test_proposals_stay_within_what_may_change(tmp_path: Path) -> None:
    ends = {"k": (100e3, 250e3), "theta0": (math.radians(30.0), math.radians(60.0))}
    text = 'may_change = { k = "[100, 250] N/mm", theta0 = "[30, 60] deg" }'
    file = written(tmp_path, EXACT | {"mu0": "0.45"})
    file.write_text(file.read_text(encoding="utf-8") + text + "\n", encoding="utf-8")
    assert ss.Study.from_file(file).may_change == {
        name: pytest.approx(two) for name, two in ends.items()
    }
    free = ss.Study(brake(mu0=0.45))
    bounded = ss.Study(brake(mu0=0.45), may_change=ends)
    for study in (free, bounded):
        found = redesigns.changes(study, 0.5)
        assert found
        for change in found:
            for name, value in change.after.items():
                low, high = (
                    ends[name]
                    if study is bounded
                    else (study.values[name] / 3, study.values[name] * 3)
                )
                assert low * (1 - 1e-9) <= value <= high * (1 + 1e-9)
    low, high = (
        math.radians(20.0),
        math.radians(33.0),
    )  # in which the present inclination does not lie
    (change,) = redesigns.changes(
        ss.Study(brake(mu0=0.45), may_change={"theta0": (low, high)}), 0.5
    )
    assert low < change.after["theta0"] == pytest.approx(high)  # the nearest that it may be
    with pytest.raises(ss.errors.ParameterError, match="no state depends on m"):
        ss.Study(brake(), may_change={"m": (0.1, 0.2)})


@pytest.mark.validate
def test_a_change_that_a_brake_refutes_is_not_given() -> None:
    """Eight quantities with tolerances, of which corners used to be sampled: at every corner of
    every change nothing jumps.
    """
    off = dict.fromkeys(("k", "k_x", "k_c", "F_L", "L_0"), "8 %") | {
        "theta0": "1 deg",
        "mu0": (0.3, 0.36),
        "V": "10 %",
    }
    study = ss.Study(brake(mu0=0.33), tolerance=off)
    found = redesigns.changes(study, 0.4)
    assert found
    for change in found:
        new = study.changed(change.after)
        corners = tolerances.corners(new)
        assert (
            len(corners) == 129
        )  # the brake as drawn, at the largest friction, and all corners of seven others
        assert not tolerances.ending(new, tolerances.values_at(new, corners)).any()
        assert change.outcome in ("proved", "undecided")


def test_a_tolerance_without_a_unit_is_refused_where_the_data_have_units() -> None:
    """A number may be of N/mm as well as of N/m; a share, a ratio, 0 and a text tell."""
    made = pytest.importorskip("pint").UnitRegistry().Quantity
    data = {name: made(value, si) for name, value, si in _in_si()}
    for given in (data, ss.PhysicalParameters(**data)):
        for off in (15, (15.0, 20.0), np.float64(1e4)):
            with pytest.raises(ss.errors.ParameterTypeError, match=r"k = .* has no unit, and the"):
                ss.Study(given, tolerance={"k": off})
        for off in ("8 %", made(8.0, "N/mm"), "8 N/mm", (made(90, "N/mm"), made(110, "N/mm")), 0):
            assert ss.Study(given, tolerance={"k": off, "mu0": 0.1, "theta0": 0.01})
    bare = {name: value.magnitude for name, value in data.items()}
    assert ss.Study(bare, tolerance={"k": 15})
    with pytest.raises(ss.errors.ParameterTypeError, match="with units, and k without"):
        ss.Study(data | {"k": 1e5})


def _in_si() -> list[tuple[str, float, str]]:
    """A brake: names, values and units."""
    values = {"m": 0.4, "k": 1e5, "k_x": 7e3, "k_y": 0.0, "k_c": 1e6, "F_L": 350.0, "L_0": 0.05}
    units = ("kg", "N/m", "N/m", "N/m", "N/m", "N", "m")
    ratios = [("theta0", 0.8, "rad"), ("mu0", 0.5, "1")]
    return [*((*it, si) for it, si in zip(values.items(), units, strict=True)), *ratios]


@pytest.mark.thorough
def test_three_standard_deviations_are_the_box_of_what_is_not_cut_off() -> None:
    study = ss.Study(
        brake(mu0=0.36), tolerance={"k": "sd 5 %", "k_x": "sd 5 %"}, correlation={("k", "k_x"): 1.0}
    )
    found, proof = tolerances.chance(study, 1 << 12), certificate(study)
    assert found is not None
    assert list(found.sobol) == ["k_x, k"]
    g = np.random.default_rng(5).normal(0, 0.05, 100_000)
    values: Any = study.values | {"k": 180e3 * (1 + g), "k_x": 9e3 * (1 + g)}
    jump = np.asarray(ss.jump_value(ss.PhysicalParameters(**values).dimensionless()))
    share = float((jump <= study.friction[1]).mean())
    error = 3 * math.sqrt(share * (1 - share) / 1e5)
    assert found.low - error < share < found.high + error
    # A brake with a soft strut and a stiff spring along the belt is no brake of one batch.
    assert proof.outcome == "refuted"
    assert proof.counterexample is not None
    assert proof.counterexample["k"] / 180e3 == pytest.approx(proof.counterexample["k_x"] / 9e3)


def with_friction(folder: Path, speed: Any, friction: Any, head: str = "v [m/s],mu") -> ss.Study:
    """The study of the brake with measured friction in a table."""
    rows = [f"{v},{mu}" for v, mu in zip(speed, friction, strict=True)]
    (folder / "measured.csv").write_text("\n".join([head, *rows]), encoding="utf-8")
    return studied(folder, {"mu0": None, "d": None, "friction": "measured.csv"})


def test_a_certificate_is_proved_where_the_jump_is_far_and_refuted_by_a_brake_that_jumps(
    report: ss.results.Report,
) -> None:
    far = ss.Study(brake(mu0=0.2), tolerance={"k": "5 %", "k_c": "5 %", "mu0": 0.02})
    assert certificate(far).outcome == "proved"
    found = report.certificate
    assert found is not None
    assert found.outcome == "refuted"
    assert found.counterexample is not None
    p = ss.PhysicalParameters(m=0.35, **found.counterexample).dimensionless()
    assert len(ss.quasi_static_path(p, "mu0", [0.0, found.counterexample["mu0"]]).jumps) == 1


@pytest.mark.thorough
def test_a_contact_that_holds_on_both_sides_may_be_as_soft_as_the_springs() -> None:
    found = ss.Study(
        {"m": 1.0, "k_c": 100.0, "k": 90.0, "k_x": 80.0, "k_y": 0.0, "F_L": 1.0, "mu0": 0.2},
        model="mode_coupling",
    )
    told = found.report(**QUICKLY)
    assert not any("should be the stiffest" in one for one in told.warnings)


def test_without_friction_nothing_damps_and_the_state_is_neutral() -> None:
    study = ss.Study(brake(mu0=0.0))
    found = study.report(**QUICKLY)
    assert found.current.stability == "neutral"
    assert found.current.undamped == "stable"
    assert found.current.growth_per_s == 0
    assert any("nothing damps" in one for one in found.warnings)
    assert not any("grows slowly" in one for one in found.warnings)


@pytest.mark.thorough
def test_without_a_speed_a_state_that_diverges_is_unstable() -> None:
    """The angle at which three states are, of which the middle one diverges, by (27) alone."""
    found = ss.Study(brake(theta0=math.radians(30.0), V=None, d=None)).report(**QUICKLY)
    told = [(state.undamped, state.stability) for state in found.states]
    assert told == [("stable", "neutral"), ("divergent", "unstable"), ("stable", "neutral")]


def test_no_text_of_a_page_is_taken_for_html() -> None:
    pytest.importorskip("jinja2")
    odd = "<b>&\"'"
    words, rows = (
        dict.fromkeys(("title", "about", "verdict", "drawing"), odd),
        [(odd, [(odd, odd)]), ("nothing", iter(()))],
    )
    text = filled(
        "spragsym.figures",
        "report.html",
        odd,
        **words,
        at_risk=True,
        mechanism="",
        steps=[(odd, odd)],
        warnings=[odd],
        drawn=[("<svg></svg>", odd)],
        headed=rows,
    )
    assert odd not in text
    assert (text.count("&lt;b&gt;&amp;&#34;&#39;"), text.count("<svg></svg>")) == (
        12,
        1,
    )  # twelve, as the title stands twice
    assert "nothing" not in text
    assert text.endswith("</html>\n")


@pytest.mark.thorough
def test_a_state_that_no_rising_friction_reaches_is_not_offered(tmp_path: Path) -> None:
    """From near the other state of this brake the friction leads to the first one: at no friction
    it is alone, up to the fold from which on there are three.
    """
    rows = {"m": "0.42 kg", "k": "22 kN/mm", "L_0": "31 mm", "theta0": "58 deg", "mu0": "0.42"}
    rows |= {"k_x": "1.4 kN/mm", "k_y": "0.2 kN/mm", "k_c": "210 kN/mm", "F_L": "3.1 kN"}
    study = studied(tmp_path, rows)
    assert int(ss.equilibria(study.operating_point.replace(mu0=0.0)).count) == 1
    assert int(ss.equilibria(study.operating_point).count) == 3
    (said,) = [
        text for word, text in advice.next_steps(study.report(**QUICKLY)) if word == "decide"
    ]
    assert "the other one, x = 27.7 mm, comes by a jump or a push, not as friction rises" in said
    both = studied(tmp_path, EXACT | {"mu0": "0.3"})
    (offered,) = [
        text for word, text in advice.next_steps(both.report(**QUICKLY)) if word == "decide"
    ]
    assert offered.endswith('for the other one write state = { x = "43 mm" }')
    chosen = both.with_data(state={"x": 0.043}).report(**QUICKLY).current
    assert chosen is not None
    assert chosen.x_mm == pytest.approx(43, abs=0.05)


def test_friction_that_was_measured(tmp_path: Path) -> None:
    speed = np.linspace(0.02, 1.5, 30)
    noise = np.random.default_rng(3).normal(0, 0.004, speed.size)
    found = with_friction(
        tmp_path, speed, 0.42 * (1 - np.exp(-8.0 * speed)) + noise, "speed [m/s],friction"
    )
    for name, truth in (("mu0", 0.42), ("d", 8.0)):
        one = found.quantities[name]
        assert one.low < truth < one.high
        assert one.value == pytest.approx(truth, rel=0.05)
    falling = with_friction(tmp_path, speed, 0.4 / (1 + speed), "v [m/s],mu").report(**QUICKLY)
    assert any("choose a model with another law" in said for said in falling.warnings)


def test_the_oscillation_is_the_cycle_in_newtons_and_hertz() -> None:
    found = ss.Study(brake(mu0=0.45)).report(probability=False, redesign=False)
    lives = found.oscillation
    assert lives is not None
    assert lives.kind == "cycle"
    assert lives.lifts_off
    # Periods counted by hand: upward passages of the mean in a motion of the dimensionless model.
    x, y, vx, vy = lives.motion.state
    tr = ss.simulate(
        brake(mu0=0.45).dimensionless(), x0=x, y0=y, vx0=vx, vy0=vy, t_end=3.5 * lives.motion.period
    )
    second = math.sqrt(0.35 / 1.5e6)
    assert 1 / (lives.frequency_hz * second) == pytest.approx(lives.motion.period, rel=1e-12)
    again = tr(lives.motion.period)
    assert np.abs(again - lives.motion.state).max() < 1e-6
    assert 57000 * tr.contact_force().max() == pytest.approx(lives.contact_force_N[1], rel=1e-3)
    assert 57000 * tr.spring_force().min() == pytest.approx(lives.spring_force_N[0], rel=1e-2)


@pytest.mark.parametrize(
    ("friction", "outcome"),
    [(0.38, "refuted"), pytest.param(0.3, "proved", marks=pytest.mark.thorough), (0.0, "proved")],
)
def test_with_another_model_the_brake_as_drawn_is_looked_at_first(
    tmp_path: Path, friction: float, outcome: str
) -> None:
    """Its jump is at 0.366."""
    found = certificate(
        studied(tmp_path, EXACT | CUBIC | {"mu0": f"[0, {friction}]" if friction else "0"})
    )
    assert found.outcome == outcome
    assert (found.counterexample or {}).get("mu0") == (friction if outcome == "refuted" else None)


@pytest.mark.thorough
def test_with_another_model_a_brake_within_the_tolerances_that_jumps_is_found(
    tmp_path: Path,
) -> None:
    """Friction of 0.35 does not reach the jump at 0.366 as drawn; with other springs within the
    tolerances it does.
    """
    loose = {name: TOLERANT[name] for name in ("k", "k_x")}
    found = certificate(studied(tmp_path, EXACT | CUBIC | loose | {"mu0": "[0.3, 0.35]"}))
    assert found.outcome == "refuted"
    example = found.counterexample
    assert example is not None
    assert example["mu0"] == 0.35
    assert {name: example[name] for name in ("k", "k_x")} != {"k": 180e3, "k_x": 9e3}
    corner = brake(k=example["k"], k_x=example["k_x"], mu0=0.35).dimensionless()
    assert ss.quasi_static_path(corner, "mu0", [0.0, 0.35]).jumps


@pytest.mark.by_hand("a slow belt", "at full slip", "a normal angle")
@pytest.mark.thorough
@pytest.mark.parametrize(
    "rows",
    [
        pytest.param({}, id="at full slip, nearly"),
        pytest.param({"V": "0.2 m/s", "mu0": "[0.37, 0.47]"}, id="a slow belt"),
        pytest.param(
            {"V": "[0.2, 0.3] m/s", "mu0": "[0.36, 0.46]"}, id="a belt whose speed varies"
        ),
        pytest.param({"theta0": "52 deg sd 0.5 deg"}, id="a normal angle"),
        pytest.param({"V": None, "d": None}, id="friction that does not depend on speed"),
    ],
)
def test_bounds_of_the_probability_hold_what_closed_forms_give(
    tmp_path: Path, rows: dict[str, str | None]
) -> None:
    """The share of angles, speeds and frictions at which the article's brake jumps, each at the
    middles of many small steps.
    """
    study = studied(tmp_path, EXACT | {"theta0": TOLERANT["theta0"], "mu0": "[0.34, 0.4]"} | rows)
    low, high = tolerances.bracket(study)
    shares = (np.arange(400) + 0.5) / 400
    angles = study.quantities["theta0"].ppf(shares)
    belt = study.quantities.get("V")
    speeds = belt.ppf(shares) if belt else np.full(1, np.inf)
    jumps = ss.jump_value(study.dimensionless.replace(theta0=angles), "mu0")
    needed = np.asarray(jumps)[:, None] / (1 - np.exp(-10 * speeds))
    mu0 = study.quantities["mu0"]
    right = float(np.clip((mu0.high - needed) / (mu0.high - mu0.low), 0, 1).mean())
    assert 0.2 < right < 0.8
    assert low < right < high
    varies = belt is not None and belt.high > belt.low
    assert high - low < (0.5 if varies else 0.02)


@pytest.mark.thorough
def test_a_model_without_mu0_says_why_it_has_no_jump(tmp_path: Path) -> None:
    rows = {"mu0": None, "model": "stribeck", "mu_s": "0.45", "mu_k": "0.3", "v_s": "0.5 m/s"}
    found = studied(tmp_path, rows).report(**QUICKLY)
    assert found.mu_jump is None
    assert any(
        "no friction coefficient" in one and 'vary = "theta0"' in one for one in found.warnings
    )
    assert found.states
    assert found.current is None
    assert all(
        state.contact_force_N is not None and math.isfinite(state.contact_force_N)
        for state in found.states
    )


@pytest.mark.thorough
def test_a_mu0_in_forces_of_a_page_without_a_law_of_friction_is_a_load() -> None:
    """North's binary flutter rests where it begins, unstable; the picture of that motion is
    drawn.
    """
    linear = BINARY.replace("sin(phi)", "phi")
    for page, said in (
        (BINARY, "Small disturbances grow; from far out"),
        (linear, "Rest is unstable: small disturbances grow."),
    ):
        folder = user_pages.derived(page, "binary")
        found = ss.Study(
            {"m": 0.35, "k": 1e6, "h": 0.04, "mu0": 0.4, "c": 100.0}, model=str(folder)
        ).report()
        assert "no jump at any mu0" in found.verdict
        assert said in found.verdict
        assert all(row.friction is None for row in found.fold_rows)
        figures.motion_figure(ss.simulate(p := ss.load(folder).Parameters(), t_end=20.0))
        with pytest.raises(ss.errors.ConvergenceError, match="nothing moves from where it begins"):
            ss.cycle(p)


def test_where_statics_takes_the_law_at_the_speed_of_the_belt_it_is_given_all_of_mu0(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    study = ss.Study(brake(d=1.0))
    works = tolerances.box(study)[0].mu0
    monkeypatch.setattr(study.kind, "law", {**study.kind.law, "at_rest": "speed"})
    assert works < tolerances.box(ss.Study(brake(d=1.0)))[0].mu0 == 0.3


def test_a_belt_that_stands_still_is_refused_also_with_a_tolerance_of_the_friction() -> None:
    with pytest.raises(ss.errors.ParameterError, match="nothing slides at that speed"):
        ss.Study(brake(V=0.0), {"mu0": 0.1}).report(**QUICKLY)


@pytest.mark.thorough
def test_a_report_follows_the_state_that_was_chosen_and_names_the_other() -> None:
    small, far = (
        ss.Study(brake(V=None, d=None), state=state).report(**QUICKLY)
        for state in (None, {"x": 0.05})
    )
    assert math.isfinite(small.mu_jump)
    assert math.isnan(far.mu_jump)
    ((place, end),) = small.others
    assert place["x_mm"] == pytest.approx(far.current.places["x_mm"])
    assert math.isnan(end)
    ((place, end),) = far.others
    assert place["x_mm"] == pytest.approx(small.current.places["x_mm"])
    assert end == pytest.approx(small.mu_jump, rel=1e-9)
    assert "chosen near x = 50 mm" in far.verdict


def test_a_file_names_the_state(tmp_path: Path) -> None:
    file = written(tmp_path)
    text = file.read_text(encoding="utf-8")
    file.write_text(f'{text}state = {{ x = "50 mm" }}\n', encoding="utf-8")
    assert ss.Study.from_file(file).dimensionless.followed == pytest.approx({"x": 50 / 38})
    file.write_text(f'{text}state = {{ z = "50 mm" }}\n', encoding="utf-8")
    with pytest.raises(ss.errors.ParameterError, match=r"line 13: state = .*write state = \{ x = "):
        ss.Study.from_file(file)


@pytest.mark.parametrize("given", ["50 mm ± 2 %", "[48, 52] mm", "50 +- 1 mm", "50 mm sd 2 %"])
def test_a_place_and_a_beginning_take_no_tolerance(given: str, tmp_path: Path) -> None:
    file = written(tmp_path)
    text = file.read_text(encoding="utf-8")
    for line, name in (
        (f'state = {{ x = "{given}" }}\n', "x"),
        (f'vary = "F_L"\nbegin = "{given.replace("mm", "N")}"\n', "begin"),
    ):
        file.write_text(f"{text}{line}", encoding="utf-8")
        refused = f'{name} = .* takes no tolerance here; write "50 m?[mN]"'
        with pytest.raises(ss.errors.ParameterError, match=refused):
            ss.Study.from_file(file)


@pytest.mark.parametrize("given", ["60 s", "60", "nan mm", True, [1, 2]])
def test_what_is_offered_for_a_place_is_taken(given: object, tmp_path: Path) -> None:
    """Of a coordinate and of a beginning, which have no tolerance, each text after "write"."""
    file = written(tmp_path)
    text = file.read_text(encoding="utf-8")
    for before, behind in (("state = { x = ", " }"), ('vary = "F_L"\nbegin = ', "")):
        file.write_text(f"{text}{before}{json.dumps(given)}{behind}\n", encoding="utf-8")
        with pytest.raises(ss.errors.ParameterError) as refused:
            ss.Study.from_file(file)
        offered = re.findall('"[^"]*"', str(refused.value).rpartition("write ")[2])
        assert offered
        for one in offered:
            file.write_text(f"{text}{before}{one}{behind}\n", encoding="utf-8")
            ss.Study.from_file(file)


@pytest.mark.parametrize("name", ["tolerance", "correlation", "state", "may_change"])
@pytest.mark.parametrize("given", [5, "x", [1], {"x": "60 mm"}, {1: 2}, {"k": (1, 2, 3)}])
def test_a_mapping_of_another_kind_is_refused(name: str, given: object) -> None:
    with pytest.raises(ss.errors.SpragsymError, match=f"{name}|state"):
        ss.Study(IN_SI, **{name: given})


def test_a_load_that_rises_is_told_in_its_unit(tmp_path: Path) -> None:
    found = studied(tmp_path, EXACT | {"mu0": "0.4", "vary": "F_L", "begin": "50 N"}).report(
        **QUICKLY
    )
    (row,) = [row for row in found.fold_rows if row.value is not None]
    jump = ss.jump_value(found.study.operating_point, "kappa", begin=50 / 57000)
    assert found.jump_at == pytest.approx(57000 * jump, rel=1e-9)
    assert row.value == pytest.approx(found.jump_at, rel=1e-9)
    assert f"F_L {found.jump_at:.5g} N" in found.text()
    assert found.to_dict()["jump_at"] == {"value": pytest.approx(found.jump_at), "unit": "N"}
    assert found.mu_jump is None


@pytest.mark.thorough
def test_changes_hold_at_full_slip_where_faster_sliding_jumps() -> None:
    """What works at the belt's speed is less than μ₀, at which the brake jumps: changes keep the
    jump beyond μ₀ of every brake within the tolerances.
    """
    inclined = {"theta0": math.radians(30.0), "V": 1.0, "d": -math.log(0.1)}
    jump = float(np.asarray(ss.jump_value(brake(**inclined).dimensionless())))
    study = ss.Study(brake(**inclined, mu0=1.05 * jump), tolerance={"mu0": "5 %", "theta0": "1 %"})
    found = study.report(oscillation=False, probability=False, safety=1.0)
    assert found.reach == "faster"
    # The largest friction, μ₀ (1 − exp(−d v)) with both shares of 5 %, is that of the jump there.
    faster = math.log(1 - 1 / 1.05**2) / math.log(0.1)
    assert found.speed == pytest.approx(faster, rel=1e-9)
    assert len(found.redesign) > 2
    for change in found.redesign:
        assert change.outcome == "proved"
        angle = change.after.get("theta0", inclined["theta0"])
        for off in (0.99, 1.01):
            new = brake(**inclined | change.after | {"theta0": off * angle})
            assert np.asarray(ss.jump_value(new.dimensionless())) > 1.05 * 1.05 * jump


def test_a_jump_at_the_friction_itself_is_neither_below_nor_beyond() -> None:
    assert facts.percent_beyond(0.0, 0.0) == 0.0
    assert facts.percent_beyond(0.3, 0.0) == math.inf
    assert facts.percent_beyond(-0.3, 0.0) == -math.inf
    assert facts.percent_beyond(0.3, 0.2) == pytest.approx(50.0)


@pytest.mark.parametrize(
    ("jump", "speed", "reach"),
    [
        (None, math.nan, ""),
        (math.nan, math.nan, "never"),
        (0.25, 1.0, "jumped"),
        (0.32, 1.0, "within"),
        (0.38, math.nan, "faster"),  # up to μ₀, whatever the law of the speed says
        (0.45, 3.0, "faster"),  # of a law that is beyond its limit at some speed
        (0.45, math.nan, "beyond"),
    ],
)
def test_how_far_the_friction_reaches(jump: float | None, speed: float, reach: str) -> None:
    study: Any = SimpleNamespace(in_use=(0.25, 0.3, 0.35), full_slip=(0.35, 0.38, 0.4))
    assert facts.reach_of(study, jump, speed) == reach


@pytest.mark.thorough
def test_the_nearest_jump_is_told_in_tolerances(tmp_path: Path) -> None:
    """Of friction alone that is what is left to the jump, over its tolerance."""
    rows = BRAKE | {"mu0": "0.30 ± 0.02"}
    study = ss.Study.from_file(written_brake(tmp_path, rows))
    report = study.report(oscillation=False, redesign=False)
    at_speed = 0.3 * (1 - math.exp(-10 * 1.2))
    assert report.distance == pytest.approx((report.jump_at - at_speed) / 0.02, rel=1e-6)
    exact = ss.Study.from_file(written_brake(tmp_path, rows | {"mu0": "0.30"}))
    assert math.isnan(exact.report(oscillation=False, redesign=False).distance)
