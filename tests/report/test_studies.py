"""A brake in, a verdict out: units, files, and the report's numbers against direct calls."""

from __future__ import annotations

import dataclasses
import json
import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.design.design_space import PHYSICAL, dimensionless
from spragsym.kang_nam.design.events import have_jumped
from spragsym.models.mechanics.varying_units import BalanceInUnits
from spragsym.studies import brake_quantities, friction, jump_verdicts, measurements, pages, redesigns, texts, tolerances
from spragsym.studies.examples import example
from spragsym.studies.jump_verdicts import Chance, certificate
from tests.conftest import Run
from tests.oracles import article_motion
from tests.support import derived, few, model_of, shipped_page, written_brake

#: A brake's file: quantity and value.
BRAKE = {
    "m": "0.35 kg", "k": "180 N/mm ± 15 %", "L_0": "38 mm", "theta0": "52 deg ± 1 deg", "k_x": "9 N/mm ± 15 %", "k_y": "0 N/mm",
    "k_c": "1500 N/mm ± 15 %", "F_L": "420 N", "mu0": "[0.3, 0.6]", "V": "1.2 m/s", "d": "10 s/m", "model": "kang_nam",
}  # fmt: skip
#: Without tolerances, as :func:`brake` has it.
EXACT = {"k": "180 N/mm", "k_x": "9 N/mm", "k_c": "1500 N/mm", "theta0": "52 deg"}
#: The article's model by its page and the search.
CUBIC = {"model": "cubic_contact", "k_3": "0 N/mm^3"}
#: What takes longest of a report.
QUICKLY: dict[str, Any] = {"oscillation": False, "probability": False, "redesign": False}


def written(folder: Path, rows: Mapping[str, str | None] = {}, brake: Mapping[str, str] = BRAKE) -> Path:  # read only
    """The file of a brake with some quantities replaced, or left out."""
    return written_brake(folder, {name: value for name, value in {**brake, **rows}.items() if value is not None})


def studied(folder: Path, rows: Mapping[str, str | None], brake: Mapping[str, str] = BRAKE) -> ss.Study:
    return ss.Study.from_file(written(folder, rows, brake))


KEYS = [
    "mu_jump", "theta0_jump_deg", "mu0_jump", "mu_lowest", "theta0_lowest_deg", "kind_lowest", "mu_cusp", "mu_effective",
    "margin_percent", "states", "frequencies_hz", "spring_force_N", "contact_force_N", "displacement_mm", "oscillation",
    "certificate",
    "probability", "sobol", "redesign", "warnings", "reach", "speed_jump", "jump", "verdict", "folds",
    "vary", "jump_at",
]  # fmt: skip


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("studies"))


@pytest.fixture(scope="module")
def study(path: Path) -> ss.Study:
    return ss.Study.from_file(path)


@pytest.fixture(scope="module")
def report(study: ss.Study) -> ss.Report:
    return study.report(n=1024, oscillation=False, redesign=False)


@pytest.fixture(scope="module")
def redesigned(study: ss.Study) -> ss.Report:
    return study.report(oscillation=False, probability=False)


@pytest.mark.thorough
def test_the_numbers_are_those_of_direct_calls_without_units(report: ss.Report) -> None:
    # By hand: k_c L_0 = 57 000 N; κ = 420/57000, α = 9/1500, σ = 180/1500, β = 0; time sqrt(0.35/1.5e6) s.
    p = ss.Parameters(theta0=math.radians(52), mu0=0.45, kappa=420 / 57000, alpha=0.006, sigma=0.12, beta=0.0)
    assert report.mu_jump == pytest.approx(ss.jump_value(p), rel=1e-12)
    working = 0.45 * -math.expm1(-12.0)
    assert report.mu_effective == pytest.approx(working, rel=1e-12)
    at = p.replace(mu0=working)
    assert report.theta0_jump_deg == pytest.approx(math.degrees(ss.jump_value(at, "theta0")), rel=1e-12)
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
        hertz = np.sort(np.abs(eq.eigenvalues[i].imag))[::2] * math.sqrt(1.5e6 / 0.35) / (2 * math.pi)
        assert np.allclose(state.frequencies_hz, hertz[hertz > 0], rtol=1e-3)  # the law's damping is left out here


@pytest.mark.thorough
def test_the_text_has_the_forces_and_frequencies_of_the_state(report: ss.Report) -> None:
    here, said = report.current, " ".join(report.text().split())
    assert here is not None
    assert len(here.frequencies_hz) == 2
    told = [f"{f:.4g} Hz (damping ratio {ratio:.2g})" for f, ratio in zip(here.frequencies_hz, here.damping_ratio, strict=True)]
    assert f"frequencies {', '.join(told)}" in said
    assert f"force of the contact {here.contact_force_N:.5g} N" in said


@pytest.mark.by_hand("True")
@pytest.mark.parametrize("tolerances", few([True, False], False))
def test_json_has_the_keys_of_the_contract(tolerances: bool, tmp_path: Path, run: Run) -> None:
    found = json.loads(run("report", str(written(tmp_path, {} if tolerances else EXACT | {"mu0": "0.45"})), "--json"))
    assert list(found) == KEYS
    assert found["folds"][0]["friction"] == pytest.approx(found["mu_jump"], rel=1e-12)
    state = next(one for one in found["states"] if one["current"])
    way = found["folds"][0]
    assert way["before"]["x_mm"] < way["after"]["x_mm"] < state["x_mm"]  # it has jumped, and friction has grown since


def brake(**changes: float | None) -> ss.PhysicalParameters:
    values = dict(
        m=0.35, k=180e3, k_x=9e3, k_y=0.0, k_c=1.5e6, F_L=420.0, L_0=0.038, theta0=math.radians(52), mu0=0.3, V=1.2, d=10.0
    )
    return ss.PhysicalParameters(**(values | changes))  # type: ignore[arg-type]  # None for V and d only


@pytest.mark.thorough
def test_a_study_from_numbers_is_the_study_of_the_file(report: ss.Report) -> None:
    tolerance = {"k": "15 %", "k_x": 1350.0, "k_c": (1275e3, 1725e3), "theta0": "1 deg", "mu0": (0.3, 0.6)}
    found = ss.Study(brake(mu0=0.45), tolerance=tolerance).report(oscillation=False, redesign=False, n=1024)
    assert found.to_dict()["mu_jump"] == pytest.approx(report.mu_jump, rel=1e-12)
    assert found.probability is not None
    assert report.probability is not None
    assert found.probability.probability == pytest.approx(report.probability.probability, abs=0.01)
    assert found.verdict == report.verdict


@pytest.mark.validate
def test_changes_keep_the_target_as_they_are_printed(study: ss.Study, redesigned: ss.Report) -> None:
    assert redesigned.target == pytest.approx(1.2 * study.friction[2])
    assert len(redesigned.redesign) >= 5
    for change in redesigned.redesign:
        values = dict(study.values)
        for name, value in change.after.items():
            printed = float(study.shown(name, value, 12).split()[0])
            values[name] = math.radians(printed) if name == "theta0" else printed * (value / study.in_file(name, value))
        jump = ss.jump_value(ss.PhysicalParameters(**values).dimensionless())
        assert math.isnan(jump) or jump >= redesigned.target


@pytest.mark.thorough
def test_changes_hold_for_all_brakes_within_the_tolerances(study: ss.Study, redesigned: ss.Report) -> None:
    """Random brakes about each new design, every tolerance the same share of the new value: none jumps below 0.6."""
    rng = np.random.default_rng(11)
    off = {name: rng.uniform(-0.15, 0.15, 4000) for name in ("k", "k_x", "k_c")}
    for change in redesigned.redesign:
        values: dict[str, object] = {**study.values, **change.after}
        values |= {name: float(values[name]) * (1 + share) for name, share in off.items()}  # type: ignore[arg-type]  # numbers
        values["theta0"] = float(values["theta0"]) + rng.uniform(-1, 1, 4000) * math.pi / 180  # type: ignore[arg-type]  # a number
        jump = np.asarray(ss.jump_value(ss.PhysicalParameters(**values).dimensionless()))  # type: ignore[arg-type]  # arrays
        assert not (jump < 0.6).any()
        assert change.probability == 0
        assert change.outcome == "proved"


@pytest.mark.thorough
def test_a_change_that_a_brake_refutes_is_not_given() -> None:
    """Eight quantities with tolerances, of which corners used to be sampled: at every corner of every change nothing jumps."""
    off = dict.fromkeys(("k", "k_x", "k_c", "F_L", "L_0"), "8 %") | {"theta0": "1 deg", "mu0": (0.3, 0.36), "V": "10 %"}
    study = ss.Study(brake(mu0=0.33), tolerance=off)
    found = redesigns.changes(study, 0.4)
    assert found
    for change in found:
        new = study.changed(change.after)
        corners = tolerances.corners(new)
        assert len(corners) == 65  # the brake as drawn, at the largest friction, and all corners
        assert not jump_verdicts.jumping(new, corners).any()
        assert change.outcome in ("proved", "undecided")


def test_shares_that_the_samples_do_not_resolve_are_not_told(report: ss.Report) -> None:
    """Next to a certainty a handful of samples differ, and Sobol' indices of them are anything: −300 % was printed."""
    known = Chance(0.4, 0.39, 0.41, 0.95, 8192, {"mu0": (0.7, 0.8, 0.03), "k": (0.2, 0.3, 0.02)})
    noise = Chance(0.4, 0.39, 0.41, 0.95, 8192, {"k": (-0.012, 0.07, 0.02)})
    lost = Chance(0.9998, 0.999, 0.99997, 0.95, 8192, {"mu0": (-3.0, 2.5, 3.0), "k": (0.0, 0.0, 0.0)})
    told, untold = (dataclasses.replace(report, probability=one).text() for one in (known, lost))
    assert all(f"how much {name} decides" in told and f"how much {name} decides" not in untold for name in ("mu0", "k"))
    assert "not told by 8192 samples" in untold
    assert re.search(r"how much k decides +0 % by itself, 7 %", dataclasses.replace(report, probability=noise).text())


@pytest.mark.thorough
def test_three_standard_deviations_are_the_box_of_what_is_not_cut_off() -> None:
    study = ss.Study(brake(mu0=0.36), tolerance={"k": "sd 5 %", "k_x": "sd 5 %"}, correlation={("k", "k_x"): 1.0})
    found, proof = jump_verdicts.chance(study, 1 << 12), certificate(study)
    assert found is not None
    assert list(found.sobol) == ["k_x, k"]
    g = np.random.default_rng(5).normal(0, 0.05, 100_000)
    holds_the_share(found, study.values | {"k": 180e3 * (1 + g), "k_x": 9e3 * (1 + g)}, study.friction[1])
    # A brake with a soft strut and a stiff spring along the belt is no brake of one batch.
    assert proof.outcome == "refuted"
    assert proof.counterexample is not None
    assert proof.counterexample["k"] / 180e3 == pytest.approx(proof.counterexample["k_x"] / 9e3)


def holds_the_share(found: Any, values: Any, friction: Any) -> None:
    """That of 100 000 brakes whose jump comes at a friction or below it, within the bounds that are told."""
    share = float((np.asarray(ss.jump_value(ss.PhysicalParameters(**values).dimensionless())) <= friction).mean())
    error = 3 * math.sqrt(share * (1 - share) / 1e5)
    assert found.low - error < share < found.high + error


def with_friction(folder: Path, speed: Any, friction: Any, head: str = "v [m/s],mu") -> ss.Study:
    """The study of the brake with measured friction in a table."""
    rows = [f"{v},{mu}" for v, mu in zip(speed, friction, strict=True)]
    (folder / "measured.csv").write_text("\n".join([head, *rows]), encoding="utf-8")
    return studied(folder, {"mu0": None, "d": None, "friction": "measured.csv"})


@pytest.mark.thorough
def test_mu0_and_d_of_one_fit_are_correlated(tmp_path: Path) -> None:
    rng, speed = np.random.default_rng(3), np.linspace(0.005, 0.15, 20)

    def measured() -> Any:
        return 0.42 * (1 - np.exp(-8.0 * speed)) + rng.normal(0, 0.004, speed.size)

    study = with_friction(tmp_path, speed, measured())
    assert study.fit is not None
    # A steeper law with less friction fits nearly as well where the curve does not level off.
    assert study.correlation[("mu0", "d")] == study.fit.correlation < -0.9
    assert study.quantities["mu0"].sd == study.fit.mu0_error
    again = [measurements.fit_friction(speed, measured()) for _ in range(60)]
    together = np.corrcoef([one.mu0 for one in again], [one.d for one in again])[0, 1]
    assert together == pytest.approx(study.fit.correlation, abs=0.1)


@pytest.mark.validate
def test_a_design_that_sprags_within_its_tolerances_only_is_called_so_and_gets_changes() -> None:
    found = ss.Study(brake(mu0=0.34), tolerance={"k": "15 %", "k_c": "15 %", "theta0": "2 deg"}).report(n=1024, oscillation=False)
    assert found.mu_jump > 0.34
    assert found.verdict.startswith("As drawn it does not sprag")
    assert "but within the tolerances" in found.verdict
    assert found.redesign
    with pytest.raises(ss.ParameterError, match="nothing slides"):
        ss.Study(brake(V=0.0)).report(**QUICKLY)
    assert "inf" not in ss.Study(brake(mu0=0.0)).report(redesign=False, oscillation=False).verdict


def test_a_certificate_is_proved_where_the_jump_is_far_and_refuted_by_a_brake_that_jumps(report: ss.Report) -> None:
    far = ss.Study(brake(mu0=0.2), tolerance={"k": "5 %", "k_c": "5 %", "mu0": 0.02})
    assert certificate(far).outcome == "proved"
    found = report.certificate
    assert found is not None
    assert found.outcome == "refuted"
    assert found.counterexample is not None
    p = ss.PhysicalParameters(m=0.35, **found.counterexample).dimensionless()
    assert len(ss.quasi_static_path(p, "mu0", [0.0, found.counterexample["mu0"]]).jumps) == 1


CAUTIONS = {
    "a deep contact": ({"F_L": 42e3}, "linear contact means nothing"),
    "another state's contact": ({"theta0": math.radians(179.9)}, "in another state of sliding the contact is"),
    "no belt speed": ({"V": None, "d": None}, "V and d are not given"),
    "a stiff strut": ({"k": 1.8e6}, "should be the stiffest"),
    "a slow belt": ({"V": 0.05}, "friction works at 39.3 % of mu0: 0.118 in place of 0.3"),
    "mm/s for m/s": ({"V": 1200.0}, "looks like mm/s"),
    "radians for degrees": ({"theta0": math.radians(0.9)}, "looks like radians"),
    "percent for a number": ({"mu0": 45.0}, "more than any brake has"),
}


@pytest.mark.parametrize("name", CAUTIONS)
def test_answers_that_would_mislead_come_with_a_warning(name: str) -> None:
    changes, part = CAUTIONS[name]
    found = ss.Study(brake(**changes)).report(**QUICKLY)
    assert any(part in one for one in found.warnings), found.warnings
    plain = ss.Study(brake()).report(**QUICKLY)
    assert not any(part in one for one in plain.warnings)


@pytest.mark.thorough
def test_a_contact_that_holds_on_both_sides_may_be_as_soft_as_the_springs() -> None:
    found = ss.Study({"m": 1.0, "k_c": 100.0, "k": 90.0, "k_x": 80.0, "k_y": 0.0, "F_L": 1.0, "mu0": 0.2}, model="mode_coupling")
    told = found.report(**QUICKLY)
    assert not any("should be the stiffest" in one for one in told.warnings)


@pytest.mark.thorough
def test_a_belt_known_within_limits_makes_the_friction_less_sure(tmp_path: Path) -> None:
    study = studied(tmp_path, {"V": "[0, 0.3] m/s", "d": "[5, 10] s/m"})
    found = study.report(oscillation=False, redesign=False, n=1 << 12)
    rng = np.random.default_rng(8)
    given = {name: rng.uniform(one.low, one.high, 100_000) for name, one in study.quantities.items()}
    assert found.probability is not None
    holds_the_share(found.probability, given, given["mu0"] * -np.expm1(-given["d"] * given["V"]))
    assert max(found.probability.sobol, key=lambda name: found.probability.sobol[name][1]) == "V"
    # The counterexample is a brake of the file: mu0, V and d within their limits, and the friction that follows is enough.
    assert found.certificate is not None
    example = found.certificate.counterexample
    assert example is not None
    assert all(study.quantities[name].low <= value <= study.quantities[name].high for name, value in example.items())
    works = example["mu0"] * -math.expm1(-example["d"] * example["V"])
    assert ss.jump_value(ss.PhysicalParameters(**study.values | dict(example)).dimensionless()) <= works * (1 + 1e-12)


def test_without_friction_nothing_damps_and_the_state_is_stable() -> None:
    study = ss.Study(brake(mu0=0.0))
    found = study.report(**QUICKLY)
    assert found.current.stable
    assert found.current.growth_per_s == 0
    assert any("nothing damps" in one for one in found.warnings)
    assert not any("grows slowly" in one for one in found.warnings)


@pytest.mark.parametrize("angle", [70, 85])
def test_nothing_damps_a_contact_a_thousand_times_stiffer_either(angle: float) -> None:
    """Rounding is that of the fastest mode, and 1e-14 of it is more than 1e-14 of the slowest."""
    study = ss.Study(brake(mu0=0.0, k_c=1.5e9, k_x=90.0, theta0=math.radians(angle)))
    found = study.report(**QUICKLY)
    (current,) = (state for state in found.states if state.current)
    assert current.growth_per_s == 0
    assert set(current.damping_ratio) == {0.0}


def a_whole_page(study: ss.Study, report: ss.Report, file: Path, pictures: int) -> str:
    """The page of a report, which needs no other file."""
    study.to_html(file, report)
    text = file.read_text(encoding="utf-8")
    assert text.count("<svg") == pictures
    assert "with a knock where they are dashed" in text
    assert report.verdict in text
    assert "src=" not in text
    assert "http" not in text.replace("http://www.w3.org", "")
    return text


@pytest.mark.validate
def test_the_page_is_one_file_and_the_same_every_time(study: ss.Study, report: ss.Report, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    assert a_whole_page(study, report, tmp_path / "a.html", 4) == a_whole_page(study, report, tmp_path / "b.html", 4)


def test_no_text_of_a_page_is_taken_for_html(report: ss.Report) -> None:
    pytest.importorskip("jinja2")
    odd = "<b>&\"'"
    study = ss.Study(brake())
    study.source = odd
    report = dataclasses.replace(report, verdict=odd, warnings=(odd,))
    text = pages.document(study, report, [("<svg></svg>", odd)], [(odd, [(odd, odd)]), ("nothing", iter(()))])
    assert odd not in text
    assert text.count("&lt;b&gt;&amp;&#34;&#39;") == 8  # twice in the title
    assert text.count("<svg></svg>") == 1
    assert "nothing" not in text
    assert text.endswith("</html>\n")


@pytest.mark.thorough
def test_without_a_belt_no_map_says_where_oscillation_sets_in(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    study = studied(tmp_path, {"V": None, "d": None})
    study.to_html(tmp_path / "page.html", study.report(probability=False, redesign=False))
    assert "The map of stability" not in (tmp_path / "page.html").read_text(encoding="utf-8")


def test_friction_that_was_measured(tmp_path: Path) -> None:
    speed = np.linspace(0.02, 1.5, 30)
    noise = np.random.default_rng(3).normal(0, 0.004, speed.size)
    found = with_friction(tmp_path, speed, 0.42 * (1 - np.exp(-8.0 * speed)) + noise, "speed [m/s],friction")
    for name, truth in (("mu0", 0.42), ("d", 8.0)):
        one = found.quantities[name]
        assert one.low < truth < one.high
        assert one.value == pytest.approx(truth, rel=0.05)


def test_friction_that_falls_with_speed_is_called_another_law(tmp_path: Path) -> None:
    speed = np.linspace(0.05, 3.0, 20)
    found = with_friction(tmp_path, speed, 0.2 + 0.4 * np.exp(-speed)).report(**QUICKLY)
    assert any("off the measured friction" in one for one in found.warnings)


def test_the_oscillation_is_the_cycle_in_newtons_and_hertz() -> None:
    found = ss.Study(brake(mu0=0.45)).report(probability=False, redesign=False)
    lives = found.oscillation
    assert lives is not None
    assert lives.kind == "cycle"
    # Periods counted by hand: upward passages of the mean in a motion of the dimensionless model.
    p, belt = brake(mu0=0.45).dimensionless(), brake(mu0=0.45).belt()
    x, y, vx, vy = lives.motion.state
    tr = ss.simulate(p, **belt, x0=x, y0=y, vx0=vx, vy0=vy, t_end=3.5 * lives.motion.period)
    second = math.sqrt(0.35 / 1.5e6)
    assert 1 / (lives.frequency_hz * second) == pytest.approx(lives.motion.period, rel=1e-12)
    again = tr(lives.motion.period)
    assert np.abs(again - lives.motion.state).max() < 1e-6
    assert 57000 * tr.contact_force().max() == pytest.approx(lives.contact_force_N[1], rel=1e-3)
    assert 57000 * tr.spring_force().min() == pytest.approx(lives.spring_force_N[0], rel=1e-2)


def test_forces_and_spectra_of_a_motion() -> None:
    p = ss.Parameters.article(theta0=math.radians(30))
    eq = ss.equilibria(p.replace(mu0=ss.sliding_friction(0.5, 0.5, 10.0)))
    start = dict(x0=float(eq.x[0]) + 1e-3, y0=float(eq.y[0]))
    tr = ss.simulate(p, V=0.5, d=10.0, t_end=400.0, **start)
    L = np.hypot(math.cos(p.theta0) - tr.x, math.sin(p.theta0) - tr.y)
    assert np.allclose(tr.spring_force(), 0.1 * (L - 1), atol=1e-14)
    assert np.allclose(tr.contact_force(), np.where(tr.y < 0, -tr.y, 0.0), atol=0)
    slow = np.abs(eq.eigenvalues[0].imag).min() / (2 * math.pi)
    assert tr.spectrum(0.0).peak() == pytest.approx(slow, rel=0.01)
    # A motion so small is linear: the slow mode's rate is that of the linearization.
    constants = (math.cos(p.theta0), math.sin(p.theta0), 0.5, 0.007, 0.007, 0.1, 0.0, 0.5, 10.0)
    rows = np.array(article_motion.slopes((eq.x[0], eq.y[0], 0.0, 0.0), constants, True, 1))
    roots = np.linalg.eigvals(np.vstack([np.hstack([np.zeros((2, 2)), np.eye(2)]), rows]))
    rate = -roots[np.argmin(np.abs(roots.imag))].real
    assert tr.decay_rate() == pytest.approx(rate, rel=0.2)
    with pytest.raises(ss.ParameterError, match="points"):
        tr.spectrum(points=3)
    with pytest.raises(ss.ParameterError, match="of = 'vx'"):
        tr.decay_rate(of="vx")


def test_arrays_of_physical_parameters() -> None:
    many = brake(k=np.array([150e3, 180e3]), theta0=np.radians([[50.0], [52.0]]))  # type: ignore[arg-type]  # arrays, which brake() passes on
    assert many.shape == (2, 2)
    one = brake().dimensionless()
    assert ss.jump_value(many.dimensionless())[1, 1] == pytest.approx(ss.jump_value(one), rel=1e-12)
    with pytest.raises(ss.ParameterError, match="broadcast"):
        brake(k=np.ones(2), k_c=np.ones(3))  # type: ignore[arg-type]  # arrays


def test_commands_take_the_file(path: Path, tmp_path: Path, run: Run) -> None:
    def answer(command: str, *more: str) -> Any:
        return json.loads(run(command, *more, "--data", str(path), "--json"))

    p = brake(mu0=0.45 * -math.expm1(-12.0)).dimensionless()
    rows = answer("folds", "--vary", "k_x")["points"]
    assert [row["k_x_N/mm"] for row in rows] == pytest.approx((1500 * ss.folds(p, "alpha").alpha).tolist(), rel=1e-9)
    frictions, lowest = answer("critical"), ss.critical_friction(p)
    for name, value in (
        ("mu0_jump", ss.jump_value(p)), ("mu0_cusp", ss.cusp_friction(p)), ("mu0_lowest", lowest),
        ("theta0_lowest_deg", math.degrees(lowest.theta0)), ("mu_cr", ss.linear_critical_friction(p)),
    ):  # fmt: skip
        assert frictions[name] == pytest.approx(float(value), rel=1e-12)
    assert frictions["kind_lowest"] == lowest.kind
    assert frictions["jumps"][0]["mu0"] == frictions["mu0_jump"]
    jumps = answer("path", "--vary", "mu0=0:1:3")["jumps"]
    assert jumps[0]["mu0"] == pytest.approx(ss.jump_value(p), rel=1e-12)
    assert answer("equilibria")["equilibria"][0]["x_mm"] == pytest.approx(38 * ss.equilibria(p).x[0], rel=1e-9)
    points = answer("equilibria", "--mu0", "0.1:0.5:3")["points"]
    assert [len([row for row in one["equilibria"] if row["state"] == "contact"]) for one in points] == [3, 3, 1]
    set_ = answer("bifurcation")
    assert [row["x_mm"] for row in set_["folds"]["points"]] == pytest.approx((38 * ss.folds(p).x).tolist(), rel=1e-9)
    for point, k_x in zip(answer("equilibria", "--vary", "k_x=5:20:2")["points"], (5.0, 20.0), strict=True):
        assert point["parameters"]["k_x_N/mm"] == pytest.approx(k_x, rel=1e-12)
        eq = ss.equilibria(p.replace(alpha=k_x / 1500))
        there = [row["x_mm"] for row in point["equilibria"] if row["state"] == "contact"]
        assert there == pytest.approx((38 * eq.x[: eq.count]).tolist(), rel=1e-9)
    moving = ("--theta0", "45", "--t-end", "0.04", "-q", "-o", str(tmp_path / "rms.csv"))
    assert "lengths are in units of 38 mm, times in 0.000483046 s" in run("sweep", "--data", str(path), *moving)
    half = answer("simulate", "--t-end", "0.02", "--x0", "3.8")
    tr = ss.simulate(brake(mu0=0.45).dimensionless(), **brake().belt(), t_end=0.02 / 0.000483045891, x0=0.1)
    assert half["rms_mm"] == pytest.approx(38 * tr.rms(0.75 * tr.t[-1]), rel=1e-6)
    assert "add V" in run("simulate", "--data", str(written(tmp_path, {"V": None, "d": None})), code=2)


def test_a_cycle_in_seconds_millimetres_and_newtons(tmp_path: Path, run: Run) -> None:
    """The article's values with V = 0.5, d = 10, in scales of 0.5 s, 500 mm and 2 N."""
    rows = {
        "m": "1 kg", "k": "0.4 N/m", "L_0": "500 mm", "theta0": "42 deg", "k_x": "0.028 N/m", "k_y": "0 N/m", "k_c": "4 N/m",
        "F_L": "0.014 N", "mu0": "0.5", "V": "0.5 m/s", "d": "10 s/m",
    }  # fmt: skip
    asked = ("cycles", "--data", str(written(tmp_path, rows)), "--json")
    found = json.loads(run(*asked))
    cycle = ss.cycle(ss.Parameters.article(theta0=math.radians(42)), V=0.5, d=10.0)
    assert found["period_s"] == pytest.approx(0.5 * cycle.period, rel=1e-9)
    assert found["amplitude_mm"] == pytest.approx(500 * cycle.amplitude, rel=1e-9)
    assert found["contact_force_N"] == pytest.approx([2 * force for force in cycle.contact_force], rel=1e-9)
    # Where it is printed it is typed: lengths as the file has them, speeds in the unit of V.
    assert found["state"] == pytest.approx((cycle.state * [500, 500, 1, 1]).tolist(), rel=1e-9)
    again = json.loads(run(*asked, "--near", ",".join(map(str, found["state"]))))
    assert again["period_s"] == pytest.approx(found["period_s"], rel=1e-9)


@pytest.mark.validate
def test_another_model_answers_what_the_article_s_answers_where_it_is_the_same(tmp_path: Path, run: Run) -> None:
    """Paths and forces of the page against the closed forms."""
    file = written(tmp_path, EXACT | CUBIC | {"mu0": "0.3"})
    found = json.loads(run("report", str(file), "--json", "--no-oscillation"))
    assert list(found) == KEYS
    right = ss.Study(brake()).report(**QUICKLY)
    for key in ("mu_jump", "theta0_jump_deg", "mu_lowest", "theta0_lowest_deg", "mu_cusp", "mu_effective", "margin_percent"):
        assert found[key] == pytest.approx(getattr(right, key), rel=1e-9)
    assert found["kind_lowest"] == right.kind_lowest
    for state, one in zip(found["states"], right.states, strict=True):
        assert state["current"] == one.current
        for key in ("x_mm", "y_mm", "spring_force_N", "contact_force_N"):
            assert state[key] == pytest.approx(getattr(one, key), rel=1e-7)
        assert state["frequencies_hz"] == pytest.approx(one.frequencies_hz, rel=1e-6)
        assert state["growth_per_s"] == pytest.approx(one.growth_per_s, rel=1e-3, abs=1e-9)
    assert found["redesign"] == []  # it jumps at 0.366, beyond 1.2 times 0.3
    assert (found["certificate"]["outcome"], found["probability"]) == ("proved", None)


@pytest.mark.parametrize(
    ("friction", "outcome"), [(0.38, "refuted"), pytest.param(0.3, "proved", marks=pytest.mark.thorough), (0.0, "proved")]
)
def test_with_another_model_the_brake_as_drawn_is_looked_at_first(tmp_path: Path, friction: float, outcome: str) -> None:
    """Its jump is at 0.366."""
    found = certificate(studied(tmp_path, EXACT | CUBIC | {"mu0": f"[0, {friction}]" if friction else "0"}))
    assert found.outcome == outcome
    assert (found.counterexample or {}).get("mu0") == (friction if outcome == "refuted" else None)


def test_a_range_as_text_is_a_tolerance() -> None:
    """As messages advise, with the value where it holds it, else with its middle."""
    study = ss.Study(brake(), tolerance={"k_y": "[0, 1] N/mm", "k": "[200, 300] N/mm"})
    assert (study.quantities["k_y"].low, study.quantities["k_y"].high, study.quantities["k_y"].value) == (0.0, 1000.0, 0.0)
    assert study.quantities["k"].value == 250e3
    still = ss.Study(brake(V=0.0), tolerance={"V": (0.0, 0.1), "mu0": (0.0, 0.9)})
    assert still.friction[0] == 0.0


@pytest.mark.parametrize(
    "after", [{"F_L": 24.0}, {"k_x": 54.5e3}, {"theta0": math.radians(34.6)}, {"k": 24.7e3, "k_x": 10.4e3, "k_c": 1.47e6}]
)
def test_a_changed_brake_is_proved_in_few_boxes(after: dict[str, float], study: ss.Study) -> None:
    """Where cuts go along sides on which nothing rests, twenty thousand are not enough; at samples nothing jumps."""
    new = study.changed(after)
    found = certificate(new, hasty=True)
    assert found.outcome == "proved"
    assert found.boxes < 1000
    assert not jump_verdicts.jumping(new, tolerances.samples(new, 4096)).any()


@pytest.mark.thorough
def test_within_a_tolerance_as_narrow_as_rounding_is_the_probability_stays_open() -> None:
    """This brake jumps at each friction within it; where the ends of parts are rounded is as wide as the tolerance."""
    found = [jump_verdicts.bracket(ss.Study(brake(mu0=0.45), tolerance={"mu0": width})) for width in ("1 %", "1e-12 %")]
    assert found[0][0] > 0.999
    assert found[1] == (0.0, 1.0)


@pytest.mark.parametrize(
    ("model", "more", "rises"),
    [
        ("kang_nam", {"mu0": 0.45}, {"mu0", "V", "d"}),
        ("stribeck", {"mu_s": 0.5, "mu_k": 0.3, "v_s": 0.1}, {"mu_s", "mu_k", "v_s", "d"}),  # less friction at more speed
    ],
)
def test_quantities_with_which_friction_rises(model: str, more: dict[str, float], rises: set[str]) -> None:
    """Only of these the lower ends of tolerances are left out; at random brakes more of one is never less friction."""
    given = {"m": 0.35, "k": 180e3, "k_x": 9e3, "k_y": 0.0, "k_c": 1.5e6, "F_L": 420.0, "L_0": 0.038, "theta0": 0.9}
    given |= {"V": 1.2, "d": 10.0, **more}
    study = ss.Study(given, tolerance=dict.fromkeys(("k_c", "m", *rises, "V"), "10 %"), model=model)
    found = friction.rising(study)
    assert found == rises
    corners = tolerances.corners(study)[1:]
    assert {name for name, shares in zip(tolerances.varied(study), corners.T, strict=True) if (shares == 1).all()} == found
    rng = np.random.default_rng(8)
    values = tolerances.values_at(study, rng.uniform(size=(500, len(tolerances.varied(study)))))
    law = friction.law_of(study)
    for name in study.about["friction"]["quantities"]:
        most = {**values, name: np.full(500, study.quantities[name].high)}
        less, more_of_it = (ss.load(model).friction(brake_quantities.dimensionless(model, one)[0], law) for one in (values, most))
        assert (more_of_it >= less * (1 - 1e-14)).all() == (name in found)


@pytest.mark.validate
def test_with_another_model_the_same_brakes_jump(tmp_path: Path) -> None:
    """At the same corners and points of the tolerances as by closed forms, with the belt's speed among them."""
    other = studied(tmp_path, CUBIC | {"mu0": "[0.3, 0.4]", "V": "[0.1, 0.4] m/s"})
    shares = tolerances.samples(other, 4096)
    values = tolerances.values_at(other, shares)
    friction = ss.sliding_friction(values["mu0"], values["V"], values["d"])
    named = {name: values[name] for name in PHYSICAL if name != "mu0"}
    jumps = have_jumped(ss.Parameters(**dimensionless(named | {"mu0": friction}))) == 1
    assert np.array_equal(jump_verdicts.jumping(other, shares[:256]) == 1, jumps[:256])
    assert 0.05 < jumps.mean() < 0.95
    odds = jump_verdicts.chance(other, 512)
    assert odds is not None
    assert odds.low < jumps.mean() < odds.high


@pytest.mark.validate
def test_with_another_model_tolerances_are_proved(tmp_path: Path) -> None:
    """Also those of the contact's stiffness, on which all parameters depend."""
    study = studied(tmp_path, CUBIC | {"mu0": "[0.25, 0.28]", "k_c": "1.5 kN/mm ± 5 %"})
    found = study.report(oscillation=False, redesign=False)
    assert found.facts.within == "proved"
    odds = found.probability
    assert odds is not None
    assert (odds.low, odds.high, odds.confidence) == (0.0, 0.0, 1.0)
    low, high, units = jump_verdicts.box(study)
    for share in (0.0, 0.3, 1.0):
        at = {name: float(tolerances.quantile(one, share)) for name, one in study.quantities.items()}
        p = brake_quantities.groups("cubic_contact", at | {"k_c": study.values["k_c"]})
        works = -math.expm1(-at["V"] * at["d"])  # of mu0
        for name, value in p.items():
            assert float(getattr(low, name)) <= value * (works if name == "mu0" else 1.0) <= float(getattr(high, name))
        ((unit, one),) = units.items()
        assert one.low <= at["k_c"] / study.values["k_c"] <= one.high
        scaled = BalanceInUnits(low.model, True, units).scaled(p | {unit: at["k_c"] / study.values["k_c"]})
        for name, value in brake_quantities.groups("cubic_contact", at).items():
            assert scaled[name] == pytest.approx(value, rel=1e-14)


@pytest.mark.thorough
def test_with_another_model_a_brake_within_the_tolerances_that_jumps_is_found(tmp_path: Path) -> None:
    """Friction of 0.35 does not reach the jump at 0.366 as drawn; with other springs within the tolerances it does."""
    loose = {name: BRAKE[name] for name in ("k", "k_x")}
    found = certificate(studied(tmp_path, EXACT | CUBIC | loose | {"mu0": "[0.3, 0.35]"}))
    assert found.outcome == "refuted"
    example = found.counterexample
    assert example is not None
    assert example["mu0"] == 0.35
    assert {name: example[name] for name in ("k", "k_x")} != {"k": 180e3, "k_x": 9e3}
    corner = brake(k=example["k"], k_x=example["k_x"], mu0=0.35).dimensionless()
    assert ss.quasi_static_path(corner, "mu0", [0.0, 0.35]).jumps


@pytest.mark.validate
def test_another_model_has_a_page_and_forces_of_its_oscillation(tmp_path: Path) -> None:
    """The cycle's forces are those of the article's."""
    study = studied(tmp_path, CUBIC)
    found = study.report(probability=False, redesign=False)
    tolerance = {"k": "15 %", "k_x": "15 %", "k_c": "15 %", "theta0": "1 deg", "mu0": (0.3, 0.6)}
    right = ss.Study(brake(mu0=0.45), tolerance=tolerance).report(probability=False, redesign=False)
    assert found.oscillation is not None
    assert right.oscillation is not None
    for key in ("frequency_hz", "amplitude_mm", "spring_force_N", "contact_force_N"):
        assert getattr(found.oscillation, key) == pytest.approx(getattr(right.oscillation, key), rel=1e-6, abs=1e-9)
    assert (found.facts.reach, found.facts.hits) == (right.facts.reach, None)
    assert found.facts.speed == pytest.approx(right.facts.speed, rel=1e-9)
    assert found.peak is not None
    assert right.peak is not None
    for key in ("before", "after", "x_mm", "y_mm", "spring_force_N", "contact_force_N"):
        assert getattr(found.peak, key) == pytest.approx(getattr(right.peak, key), rel=1e-6)
    assert (found.peak.settles, found.peak.lifts_off) == (right.peak.settles, right.peak.lifts_off)
    a_whole_page(study, found, tmp_path / "page.html", 5)


@pytest.mark.thorough
@pytest.mark.parametrize(
    "rows",
    [
        pytest.param({}, id="at full slip, nearly"),
        pytest.param({"V": "0.2 m/s", "mu0": "[0.37, 0.47]"}, id="a slow belt"),
        pytest.param({"V": "[0.2, 0.3] m/s", "mu0": "[0.36, 0.46]"}, id="a belt whose speed varies"),
        pytest.param({"theta0": "52 deg sd 0.5 deg"}, id="a normal angle"),
    ],
)
def test_bounds_of_the_probability_hold_what_closed_forms_give(tmp_path: Path, rows: dict[str, str]) -> None:
    """The share of angles, speeds and frictions at which the article's brake jumps, each at the middles of many small steps."""
    study = studied(tmp_path, EXACT | {"theta0": BRAKE["theta0"], "mu0": "[0.34, 0.4]"} | rows)
    low, high = jump_verdicts.bracket(study)
    shares = (np.arange(400) + 0.5) / 400
    angles, speeds = (tolerances.quantile(study.quantities[name], shares) for name in ("theta0", "V"))
    jumps = ss.jump_value(study.dimensionless.replace(theta0=angles), "mu0")
    needed = np.asarray(jumps)[:, None] / (1 - np.exp(-10 * speeds))
    mu0 = study.quantities["mu0"]
    right = float(np.clip((mu0.high - needed) / (mu0.high - mu0.low), 0, 1).mean())
    assert 0.2 < right < 0.8
    assert low < right < high
    varies = study.quantities["V"].high > study.quantities["V"].low
    assert high - low < (0.5 if varies else 0.02)


@pytest.mark.validate
def test_another_model_is_told_what_to_change(tmp_path: Path) -> None:
    """Tubes and closed forms propose the same changes, nearly."""
    rows = {"k_c": "1500 N/mm", "k_x": "9 N/mm", "mu0": "[0.3, 0.35]"}
    right = studied(tmp_path, rows).report(probability=False, oscillation=False)
    other = studied(tmp_path, rows | CUBIC)
    found = other.report(oscillation=False, probability=False)
    assert found.redesign is not None
    assert [len(change.after) for change in found.redesign] == [1, 1, 1, 1, 2]
    for one, want in zip(found.redesign, [*right.redesign[:4], right.redesign[-1]], strict=True):
        assert one.after.keys() == want.after.keys()
        assert one.distance == pytest.approx(want.distance, rel=0.02)
        assert one.outcome == want.outcome == "proved"
        values = {name: quantity.value for name, quantity in other.changed(one.after).quantities.items() if name != "k_3"}
        closed = float(ss.jump_value(ss.PhysicalParameters(**values).dimensionless(), "mu0"))
        assert not closed < found.target
        assert one.jump_at == pytest.approx(closed, rel=1e-9, nan_ok=True)
    assert found.text().count("  then it") == len(found.redesign)
    told = found.to_dict()["redesign"][0]
    assert told["target"] == pytest.approx(1.2 * other.friction[2])
    assert f"to {other.shown('F_L', found.redesign[0].after['F_L'])}" in found.text()


@pytest.mark.thorough
def test_a_model_without_mu0_says_why_it_has_no_jump(tmp_path: Path) -> None:
    rows = {"mu0": None, "model": "stribeck", "mu_s": "0.45", "mu_k": "0.3", "v_s": "0.5 m/s"}
    found = studied(tmp_path, rows).report(**QUICKLY)
    assert found.mu_jump is None
    assert any("no mu0" in one and 'vary = "theta0"' in one for one in found.warnings)
    assert found.states
    assert found.current is None
    assert all(state.contact_force_N is not None and math.isfinite(state.contact_force_N) for state in found.states)


@pytest.mark.validate
def test_a_proof_covers_the_friction_that_works(tmp_path: Path) -> None:
    """A law may say more at the belt's speed than μ₀, up to which the state was followed."""
    law = "mu0 * (1 - exp(-d * Abs(v))) * (1 + 2 * exp(-d * Abs(v))) * sgn(v)"
    model = with_law(law, ", at_rest=mu0")
    study = studied(tmp_path, {"model": model, "mu0": "[0.2, 0.22]", "V": "[0.1, 0.2] m/s"})
    _, high, _ = jump_verdicts.box(study)
    # the law at its largest, 9/8, where exp(−d V) is 1/4: inside of the range of V
    values = {name: one.high for name, one in study.quantities.items()} | {"V": math.log(4) / 10}
    p, _ = brake_quantities.dimensionless(study.model, values)
    works = float(p.model.friction(p))
    assert works == pytest.approx(0.22 * 9 / 8)
    assert float(high.mu0) >= works
    # Most lies between the corners of the tolerances, and is bounded from above; least is at one, the slow end.
    slow = math.exp(-10 * 0.1)
    assert works <= study.friction[2] < works * (1 + 1e-5)
    assert study.friction[0] == pytest.approx(0.2 * (1 - slow) * (1 + 2 * slow), rel=1e-12)
    # By hand: with u = exp(-d V) the law is 1.05 at the roots of 2 u^2 - u + 0.05; the larger one is that of the lower speed.
    slow = -math.log((1 + math.sqrt(1 - 8 * 0.05)) / 4) / 10
    assert friction.speed_for(study, 1.05 * 0.22) == pytest.approx(slow, rel=1e-9)
    assert math.isnan(friction.speed_for(study, 1.126 * 0.22))


#: A brake by hand: it jumps where its friction is 0.59157, the closed form's.
SLOW = {
    "m": "0.4 kg", "k": "100 N/mm", "L_0": "40 mm", "theta0": "40 deg", "k_x": "7 N/mm", "k_y": "0 N/mm", "k_c": "1 kN/mm",
    "F_L": "280 N", "mu0": "0.5", "V": "3 m/s", "d": "1 s/m",
}  # fmt: skip
JUMPS = 0.591571854569


def with_law(law: str, at_rest: str, more: str = "") -> str:
    """The article's page with another friction law, in a folder."""
    pytest.importorskip("sympy")
    given = "page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)"
    return str(derived(shipped_page("kang_nam", (given, f"{more}page.friction(x, V, lambda v: {law}{at_rest})")), "other"))


def told(tmp_path: Path, model: str, rows: dict[str, str | None], **options: Any) -> ss.Report:
    """The report on the slow brake with some quantities replaced, or left out."""
    return studied(tmp_path, {"model": model} | rows, SLOW).report(**({"oscillation": False, "redesign": False} | options))


FALL = 'v_s = page.parameter("v_s", "m/s", "fall speed", "> 0", 0.5)\n'


@pytest.mark.validate
def test_on_a_slow_belt_another_model_is_proved_as_the_articles_is(tmp_path: Path) -> None:
    rows = {"V": "0.6 m/s", "mu0": "[0.65, 0.7]"}
    dampers = dict.fromkeys(("c_x", "c_y", "c_s"), "0 N*s/m")
    one, other = told(tmp_path, "kang_nam", rows), told(tmp_path, "damped", rows | dampers)
    assert one.facts.within == other.facts.within == "proved"
    assert other.verdict == one.verdict.replace("It sprags", "It sprags with the model damped")
    assert other.facts.working == pytest.approx((0.65 * -math.expm1(-0.6), 0.675 * -math.expm1(-0.6), 0.7 * -math.expm1(-0.6)))
    assert other.facts.speed == pytest.approx(-math.log1p(-JUMPS / 0.7), rel=1e-9)


def test_a_law_of_which_a_quantity_is_missing_says_nothing_of_a_speed(tmp_path: Path) -> None:
    found = told(tmp_path, "kang_nam", {"d": None, "mu0": "[0.55, 0.65]"}, probability=False)
    assert found.facts.working == (0.55, 0.6, 0.65)
    assert found.facts.reach == "jumped"
    assert any("d is not given: friction is taken at full slip" in one for one in found.warnings)
    assert not any("so slow" in one for one in found.warnings)


@pytest.mark.thorough
def test_a_motion_falls_only_where_steady_sliding_holds_it(tmp_path: Path) -> None:
    """By another integrator: after 9000 units of time it swings for ever, by 5.5 mm peak to peak, where sliding is unstable."""
    found = told(tmp_path, "kang_nam", {"theta0": "120 deg", "V": "1 m/s", "d": "3 s/m"}, oscillation=True, probability=False)
    assert found.current is not None
    assert not found.current.stable
    assert found.oscillation is not None
    assert found.oscillation.kind == "motion"
    assert "From rest it goes on swinging" in found.verdict
    rows = {"mu0": None, "mu_s": "0.6", "mu_k": "0.3", "v_s": "0.5 m/s", "V": "1 m/s", "d": "20 s/m"}
    found = told(tmp_path, "stribeck", rows, probability=False)  # the damping ratio of every state is negative
    assert found.verdict.endswith("Steady sliding is unstable: small disturbances grow.")


@pytest.mark.validate
def test_without_at_rest_the_friction_is_that_at_the_belts_speed(tmp_path: Path) -> None:
    model = with_law("mu0 * (1 - exp(-d * Abs(v))) * sgn(v)", "")
    works = -math.expm1(-0.7)
    found = told(tmp_path, model, {"V": "0.7 m/s", "mu0": "1.3"}, probability=False)
    assert found.facts.reach == "jumped"
    assert found.mu_jump == pytest.approx(JUMPS)
    assert found.mu_effective == pytest.approx(1.3 * works)
    found = told(tmp_path, model, {"V": "0.7 m/s", "mu0": "[1.0, 1.3]"}, n=256)
    assert found.probability is not None
    low, high = found.probability.proved
    assert low < (1.3 - JUMPS / works) / 0.3 < high < low + 0.01


@pytest.mark.validate
def test_a_key_of_critical_and_report_means_one_thing(tmp_path: Path, run: Run) -> None:
    """Where a part of mu0 works, mu0 at the jump and the friction there are two numbers."""
    model = with_law("mu0 * (1 - exp(-d * Abs(v))) * sgn(v)", "")
    file = written(tmp_path, {"model": model, "V": "0.7 m/s", "mu0": "1.3"}, SLOW)
    report = ss.Study.from_file(file).report(**QUICKLY).to_dict()
    critical = json.loads(run("critical", "--data", str(file), "--vary", "mu0=0:2", "--json"))
    assert report["mu0_jump"] == pytest.approx(JUMPS / -math.expm1(-0.7))
    both = {key for key in set(report) & set(critical) if isinstance(critical[key], float)}
    assert both >= {"mu0_jump", "theta0_lowest_deg"}
    for key in both:
        assert critical[key] == pytest.approx(report[key], rel=1e-9), key


@pytest.mark.validate
def test_a_law_may_say_more_than_at_full_slip(tmp_path: Path) -> None:
    law = "mu0 * (1 + exp(-Abs(v) / v_s)) * (1 - exp(-d * Abs(v))) * sgn(v)"
    model = with_law(law, ", at_rest=mu0", FALL)
    found = told(tmp_path, model, {"v_s": "2 m/s", "V": "2 m/s", "mu0": "0.55"}, oscillation=True, probability=False)
    assert found.facts.reach == "jumped"
    assert found.peak is not None
    rows = {"v_s": "[0.5, 6] m/s", "V": "8 m/s", "d": "3 s/m", "mu0": "0.45"}
    found = told(tmp_path, model, rows, probability=False)
    speeds, falls = np.linspace(0.3, 0.5, 2001)[:, None], np.linspace(0.5, 6, 500)
    most = (0.45 * (1 + np.exp(-speeds / falls)) * -np.expm1(-3 * speeds)).max(axis=1)
    assert found.facts.reach == "faster"
    assert found.facts.speed == pytest.approx(float(speeds[np.argmax(most >= JUMPS), 0]), abs=2e-4)
    assert "at lower speeds, from V = 0.378 m/s on" in found.verdict


@pytest.mark.validate
def test_the_worst_of_the_tolerances_may_change_with_the_speed(tmp_path: Path) -> None:
    law = "mu0 * (1 + 2 * Abs(v) / v_s * exp(-Abs(v) / v_s)) * (1 - exp(-d * Abs(v))) * sgn(v)"
    model = with_law(law, ", at_rest=mu0", FALL)
    found = told(tmp_path, model, {"v_s": "[0.5, 8] m/s", "V": "8 m/s", "mu0": "0.6"}, probability=False)
    speeds, falls = np.linspace(0.7, 1.0, 3001)[:, None], np.linspace(0.5, 8, 1000)
    most = (0.6 * (1 + 2 * speeds / falls * np.exp(-speeds / falls)) * -np.expm1(-speeds)).max(axis=1)
    right = float(speeds[np.argmax(most >= JUMPS), 0])
    assert 0.99 * right < found.facts.speed < right + 1e-4


@pytest.mark.validate
def test_a_law_that_mu0_does_not_scale_is_taken_at_full_slip(tmp_path: Path) -> None:
    more = 'mu_1 = page.parameter("mu_1", "1", "more friction", ">= 0", 0.1)\n'
    model = with_law("(mu_1 + mu0) * (1 - exp(-d * Abs(v))) * sgn(v)", ", at_rest=mu0 + mu_1", more)
    found = told(tmp_path, model, {"V": "0.7 m/s", "mu_1": "0.1"}, probability=False)
    assert found.facts.working == pytest.approx((0.6, 0.6, 0.6))
    assert found.mu_jump == pytest.approx(JUMPS)
    assert found.facts.reach == "jumped"
    assert any("not proportional to mu0" in one for one in found.warnings)


@pytest.mark.parametrize(
    ("given", "meant"), [("kx", "k_x"), ("kapa", "kappa"), ("thet0", "theta0"), ("K_Y", "k_y"), ("FL", "F_L")]
)
def test_a_misspelt_quantity_is_told_which_was_meant(given: str, meant: str, path: Path, run: Run) -> None:
    text = run("folds", "--data", str(path), "--vary", given, code=2)
    assert f"'{given}'" in text
    assert f"did you mean {meant}?" in text


@pytest.mark.thorough
def test_a_terminal_is_told_what_of_a_report_is_being_computed(
    study: ss.Study, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    told: list[str] = []
    with ss.show_progress(to=told.append):
        study.report(n=64, oscillation=False, redesign=False)
    assert "the proof for all within the tolerances" in told
    assert capsys.readouterr().err == ""
    study.report(n=64, oscillation=False, redesign=False, progress=True)
    assert capsys.readouterr().err != ""


@pytest.mark.thorough
def test_a_picture_of_a_motion_is_in_the_units_of_the_file(study: ss.Study) -> None:
    from spragsym.figures.motion_pictures import Units, motion_figure

    belt = {name: float(getattr(study.dimensionless, name)) for name in ("V", "d")}
    motion = ss.simulate(study.dimensionless, **belt, t_end=200.0)
    scales = study.scales
    figure = motion_figure(motion, 50.0, Units(1e3 * scales.length, scales.time, "mm"))
    over_time, phase, spectrum, *of_y = figure.axes
    line = over_time.lines[0]
    assert line.get_xdata()[-1] == pytest.approx(200.0 * math.sqrt(0.35 / 1.5e6))
    assert line.get_ydata()[-1] == pytest.approx(38.0 * motion.x[-1])
    # The belt is the dotted line, at 1.2 m/s.
    assert phase.lines[1].get_ydata()[0] == pytest.approx(1200.0)
    titles = [axes.get_xlabel() for axes in figure.axes]
    assert titles == ["$t$ (s)", "$x$ (mm)", "frequency (Hz)", "$t$ (s)", "$y$ (mm)", "frequency (Hz)"]
    assert of_y[0].lines[0].get_ydata()[-1] == pytest.approx(38.0 * motion.y[-1])
    assert len(of_y[1].lines) == 1  # the belt moves along x
    assert spectrum.lines[0].get_xdata()[1] == pytest.approx(1 / (150.0 * math.sqrt(0.35 / 1.5e6)), rel=1e-6)


@pytest.mark.validate
def test_a_slow_belt_is_judged_up_to_full_slip() -> None:
    """d V = 0.3: 26 % of the friction works. The speed by hand: mu0 (1 − exp(−d V)) = the friction of the jump."""
    found = ss.Study(brake(mu0=0.5, V=0.03)).report(redesign=False)
    speed = -math.log(1 - found.mu_jump / 0.5) / 10
    assert found.verdict.startswith(f"It sprags above V = {speed:.3g} m/s")
    assert f"at 0.03 m/s only {0.5 * (1 - math.exp(-0.3)):.4g} of your 0.5 works" in found.verdict
    assert found.to_dict()["reach"] == "faster"
    assert found.to_dict()["speed_jump"] == {"value": pytest.approx(speed), "unit": "m/s"}
    # Just above it the same brake has jumped, just below it has not.
    for share, jumped in ((1.001, True), (0.999, False)):
        fast = ss.Study(brake(mu0=0.5, V=share * speed)).report(**QUICKLY)
        assert fast.facts.jumped is jumped
    # The largest friction is that at full slip: 0.3663 is not 304 % above it, but 5 %.
    small = ss.Study(brake(mu0=0.35, V=0.03)).report(**QUICKLY)
    assert small.verdict.startswith("It does not sprag")
    assert "5 % above the largest that you have, 0.35" in small.verdict


@pytest.mark.thorough
def test_what_comes_to_rest_has_no_amplitude_and_no_forces() -> None:
    found = ss.Study(brake(mu0=0.5, V=0.03)).report(probability=False, redesign=False)
    lives = found.oscillation
    assert lives is not None
    assert lives.kind == "rest"
    assert "none: it decays to rest" in found.text()
    assert "amplitude" not in found.text()
    told = found.to_dict()
    assert told["spring_force_N"]["oscillation"] is None
    assert told["displacement_mm"]["oscillation_amplitude"] is None


def test_an_index_of_an_angle_is_no_angle(report: ss.Report) -> None:
    assert report.probability is not None
    shown = str(report.probability)
    first, total, error = report.probability.sobol["theta0"]
    assert f"{first:.4f}" in shown
    assert f"{total:.4f}" in shown
    assert "deg" not in shown


def test_a_corner_that_jumps_beside_a_sample_that_does_not() -> None:
    assert texts.share(Chance(0.0, 0.0, 4.5e-4, 0.95, 8192, {})) == "fewer than 0.045 %"
    assert texts.share(Chance(1.0, 0.9991, 1.0, 0.95, 8192, {})) == "more than 99.9 %"
    assert texts.share(Chance(0.99998, 0.9991, 1.0, 0.95, 8192, {})) != "100 %"


@pytest.mark.thorough
def test_the_jump_as_a_motion_has_its_peaks() -> None:
    """Another start and another friction, just above the fold, in plain simulation: the same peaks."""
    study = ss.Study(brake(mu0=0.45))
    jump = float(ss.jump_value(study.dimensionless))
    peak = study.report(probability=False, redesign=False).peak
    assert peak is not None
    path = ss.quasi_static_path(study.dimensionless, "mu0", [0.0, 0.45]).jumps[0]
    assert peak.before == pytest.approx({f"{name}_mm": 38 * path.before[name] for name in "xy"})
    assert peak.after == pytest.approx({f"{name}_mm": 38 * path.after[name] for name in "xy"})
    # It swings over the state that is left, and the contact is loaded more than in either state.
    assert peak.x_mm[1] > peak.after["x_mm"] > peak.before["x_mm"]
    assert peak.contact_force_N[1] > 57000 * max(-path.before["y"], -path.after["y"])
    p = study.dimensionless
    at = p.replace(mu0=1.0005 * jump / study.fraction)
    motion = ss.simulate(at, x0=path.before["x"], y0=path.before["y"], t_end=1500.0)
    assert peak.x_mm[1] == pytest.approx(38 * motion.x.max(), rel=5e-3)
    assert peak.contact_force_N[1] == pytest.approx(57000 * motion.contact_force().max(), rel=5e-3)
    assert peak.spring_force_N[0] == pytest.approx(57000 * motion.spring_force().min(), rel=5e-3)


def test_changes_may_be_left_out(path: Path, run: Run) -> None:
    found = json.loads(run("report", str(path), "--json", "--no-oscillation", "--no-redesign"))
    assert found["mu_jump"] < 1.2 * 0.6
    assert found["redesign"] == []


def test_remarks_of_a_command_speak_of_the_quantities_of_the_file(tmp_path: Path, run: Run) -> None:
    file = tmp_path / "brake.toml"
    file.write_text(run("report", "--example", "--model", "two_springs"), encoding="utf-8")
    (told,) = json.loads(run("folds", "--data", str(file), "--vary", "k_x", "--json"))["remarks"]
    study = ss.Study.from_file(file)
    (cut,) = ss.folds(study.dimensionless, "alpha").remarks
    assert (told.split(",")[0], cut.split(",")[0]) == ("searched k_x_N/m in [0", "searched alpha in [0")
    end = float(cut.split(", ")[1].split("]")[0]) * study.quantities["k_c"].value
    assert float(told.split(", ")[1].split("]")[0]) == pytest.approx(end, rel=1e-7)


def test_axes_of_a_figure_are_in_the_units_of_the_file(study: ss.Study) -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    from spragsym.cli.units import Units
    from spragsym.figures.labels import in_units

    units, values = Units(study.dimensionless.model, study), study.dimensionless
    assert (units.axis("theta0"), Units(values.model).axis("kappa")) == (None, None)
    assert units.axis("mu0") == ("$\\mu_0$", 1.0)
    for name, title, in_file in (("kappa", r"$F_{\rm L}$ (N)", 420.0), ("V", "$V$ (m/s)", 1.2), ("sigma", "$k$ (N/mm)", 180.0)):
        shown = units.axis(name)
        assert shown is not None
        assert shown[0] == title
        assert shown[1] * float(getattr(values, name)) == pytest.approx(in_file)
    assert units.of_time("period") == ("period (s)", study.scales.time)
    figure, ax = pyplot.subplots()
    ax.plot([0.0, 0.01], [0.0, 1.0])
    in_units(ax.xaxis, units.axis("kappa"))
    figure.canvas.draw()
    one = units.axis("kappa")[1]
    for tick, text in zip(ax.get_xticks(), ax.get_xticklabels(), strict=True):
        assert float(text.get_text().replace("−", "-")) == pytest.approx(one * tick)
        assert one * tick == pytest.approx(round(one * tick / 100) * 100, abs=1e-6)
    pyplot.close(figure)


def test_a_quantity_that_is_typed_is_in_the_unit_of_the_file(path: Path, run: Run) -> None:
    """V is 1.2 m/s in the file, and mu0 has no unit."""
    rms = [
        json.loads(run("simulate", "--data", str(path), "--t-end", "0.5", "--json", *more))["rms_mm"]
        for more in ([], ["-V", "1.2"], ["-V", "1.2", "--mu0", "0.45"], ["-V", "2.4"])
    ]
    assert rms[1:3] == pytest.approx([rms[0]] * 2, rel=1e-9)
    assert rms[3] != pytest.approx(rms[0], rel=1e-6)


def test_a_remark_names_places_in_the_units_of_the_file(study: ss.Study) -> None:
    from spragsym.cli.units import Units

    length, said = 1e3 * study.scales.length, Units(study.dimensionless.model, study).said
    assert said(["a box at theta0 = 0.5: x in [-0.5, 1e-3], there"]) == [
        f"a box at theta0_deg = {math.degrees(0.5):.8g}: x_mm in [{-0.5 * length:.8g}, {1e-3 * length:.8g}], there"
    ]
    for text in ("psi0 = 2, max = 4, and mu0 is 3", "theta_1 in [0, 1] rad"):
        assert said([text]) == [text]
    assert said(["it comes to rest near x = 0.5, y = -0.25"]) == [
        f"it comes to rest near x_mm = {0.5 * length:.8g}, y_mm = {-0.25 * length:.8g}"
    ]
    assert Units(study.dimensionless.model).said(["x in [0, 1]"]) == ["x in [0, 1]"]


@pytest.mark.validate
def test_a_report_is_the_same_whatever_the_page_calls_the_speed_of_its_belt(tmp_path: Path) -> None:
    """What is stable is so with the law's own damping, and an oscillation is looked for, by any name."""
    pytest.importorskip("sympy")
    told = {}
    for name in ("V", "U"):
        folder = tmp_path / name
        folder.mkdir()
        called = ('V = page.parameter("V"', f'{name} = page.parameter("{name}"'), ("(x, V,", f"(x, {name},")
        model = model_of(shipped_page("damped", *called), "own")
        (folder / "brake.toml").write_text(example(model), encoding="utf-8")
        found = ss.Study.from_file(folder / "brake.toml").report(n=64, redesign=False)
        assert found.study.moves
        assert model.where not in found.verdict
        told[name] = json.dumps(found.to_dict(), default=str).replace(model.where, "").replace(f'"{name}"', '"speed"')
        told[name] = told[name].replace(f"{name} = ", "speed = ")
    assert told["V"] == told["U"]
    assert '"oscillation": null' not in told["U"]


@pytest.mark.validate
def test_what_the_friction_law_alone_takes_may_be_left_out_whatever_it_is_called(tmp_path: Path) -> None:
    """Friction is μ₀ then, as for changes where a faster belt makes it jump; of another law nothing may be missing."""
    pytest.importorskip("sympy")
    called = ('V = page.parameter("V"', 'U = page.parameter("U"'), ("(x, V,", "(x, U,")
    model = model_of(shipped_page("damped", *called), "own")
    whole, less = tmp_path / "whole.toml", tmp_path / "less.toml"
    whole.write_text(example(model), encoding="utf-8")
    lines = example(model).splitlines(keepends=True)
    less.write_text("".join(line for line in lines if not line.startswith(("U ", "d "))), encoding="utf-8")
    study, slipping = ss.Study.from_file(whole), ss.Study.from_file(less)
    assert study.fraction < 1 == slipping.fraction
    assert study.at_full_slip().quantities == slipping.quantities
    found = slipping.report(n=64, redesign=False, oscillation=False)
    assert any(one.startswith("U and d are not given") and 'U = "1.2 m/s"' in one for one in found.warnings)
    less.write_text("".join(line for line in example(ss.load("stribeck")).splitlines(True) if line[:2] not in ("V ", "d ")))
    with pytest.raises(ss.ParameterError, match="V, d"):
        ss.Study.from_file(less)
