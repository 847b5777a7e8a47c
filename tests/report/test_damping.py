"""A damping ratio, and the dampers that follow from it."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import ConvergenceError, ParameterError
from spragsym.motion import integrators
from spragsym.report import states
from spragsym.report.example import example
from tests.oracles.mistakes import BRAKE
from tests.support import written_brake

ROWS = {**BRAKE, "k_y": "20 N/mm", "mu0": "0.3"}


@pytest.mark.parametrize("seed", range(5))
def test_every_mode_has_the_ratio(seed: int) -> None:
    """The roots of the mass on its springs and dampers, whose matrices are written by hand."""
    rng = np.random.default_rng(seed)
    m, L_0, F_L, theta0, ratio = 10 ** rng.uniform(-3, 3), 0.1, 5.0, rng.uniform(0.1, 3.0), 0.02
    k, k_x, k_y, k_c = 10 ** rng.uniform(2, 7, 4)
    si = {"m": m, "L_0": L_0, "F_L": F_L, "theta0": theta0, "mu0": 0.4, "V": 1.0, "d": 10.0}
    si |= {"k": k, "k_x": k_x, "k_y": k_y, "k_c": k_c}
    found = ss.Study(ss.PhysicalParameters(**si), damping_ratio=ratio)
    c_x, c_y, c_s = (found.values[name] for name in ("c_x", "c_y", "c_s"))
    along = np.array([math.cos(theta0), math.sin(theta0)])
    C = np.diag([c_x, c_y]) + c_s * np.outer(along, along)
    K = np.diag([k_x, k_y + k_c]) + k * np.outer(along, along)
    roots = np.linalg.eigvals(np.block([[np.zeros((2, 2)), np.eye(2)], [-K / m, -C / m]]))
    np.testing.assert_allclose(-roots.real / np.abs(roots), ratio, rtol=1e-7)


def test_a_ratio_in_a_file_brings_dampers_and_leaves_the_jump(tmp_path: Path) -> None:
    plain = ss.Study.from_file(written_brake(tmp_path, ROWS))
    study = ss.Study.from_file(written_brake(tmp_path, {**ROWS, "damping_ratio": "0.5 %"}))
    assert (plain.model, study.model, study.damping_ratio) == ("kang_nam", "damped", 0.005)
    assert study.jump() == plain.jump()
    quick = {"probability": False, "redesign": False, "oscillation": False}
    before, after = (one.report(**quick) for one in (plain, study))
    assert before.current.stability == "neutral"
    assert after.current.stability == "stable"
    assert after.current.damping_ratio == pytest.approx((0.008, 0.005), rel=0.05)
    given = {name: study.shown(name, digits=17) for name in ("c_x", "c_y", "c_s")}
    other = ss.Study.from_file(written_brake(tmp_path, {**ROWS, **given}))
    assert other.values == pytest.approx(study.values, rel=1e-14)


REFUSED = {
    "both": ({"damping_ratio": "1 %", "c_x": "1 N s/m"}, "c_x is given too; leave one"),
    "a tolerance": ({"damping_ratio": "[0.9, 1.1] %"}, "takes no tolerance here; write"),
    "too much": ({"damping_ratio": "120 %"}, "it must be at least 0 % and below 100 %"),
    "no dampers": ({"damping_ratio": "1 %", "model": "cubic_contact", "k_3": "1 N/mm^3"}, "no dam"),
    "one of three": ({"c_x": "1 N s/m"}, 'is without c_y, c_s; add lines such as c_y = "7 N s/m"'),
}


def test_motions_of_a_report_that_decay_are_followed_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What SciPy follows takes seconds, and no cycle is sought near what settles at rest."""
    begun, sought = list[tuple[float, ...]](), list[float]()
    integrate, asked = integrators.integrate, integrators.Flow._asked

    def counted(problem: integrators.Problem, backend: str) -> integrators.Solution:
        begun.append(problem.start)
        return integrate(problem, backend)

    def looked(flow: integrators.Flow, *given: Any, **options: Any) -> Any:
        sought.append(flow.field.size)
        return asked(flow, *given, **options)

    monkeypatch.setattr(integrators, "integrate", counted)
    monkeypatch.setattr(integrators.Flow, "_asked", looked)
    study = ss.Study.from_file(written_brake(tmp_path, {**ROWS, "damping_ratio": "0.5 %"}))
    lives = study.report(probability=False, redesign=False).oscillation
    assert lives is not None
    assert (lives.kind, lives.start) == ("rest", "rest")
    assert begun == [(0.0, 0.0, 0.0, 0.0), (1.5, 0.5, 0.0, 0.0)]
    assert not sought


@pytest.mark.parametrize("stiffer", [1.0, 1e4, 1e11])
def test_a_report_follows_as_many_oscillations_of_any_stiffness(
    stiffer: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """3000 units of time are minutes where one of them is 10⁵ oscillations."""
    followed = list[float]()

    def begun(p: ss.Parameters, *, start: Any, t_end: float) -> None:
        followed.append(t_end * brake.scales.time)
        raise ConvergenceError("far enough")

    monkeypatch.setattr(states, "simulate", begun)
    k_x = stiffer * 1.95e6
    si = {"m": 0.35, "k_c": 1.5e6, "F_L": 400.0, "k": 7.5e5, "k_y": 0.0, "k_x": k_x}
    brake = ss.Study(si | {"mu0": 0.3, "V": 0.3, "d": 18.0}, model="mode_coupling")
    with pytest.raises(ConvergenceError, match="far enough"):
        states.oscillation_of(brake, "stable", True)
    turns = np.array(followed) * math.sqrt(k_x / 0.35) / (2 * math.pi)
    assert ((turns > 300) & (turns < 3000)).all()


@pytest.mark.parametrize("name", REFUSED)
def test_a_ratio_that_means_nothing_is_refused(name: str, tmp_path: Path) -> None:
    rows, part = REFUSED[name]
    with pytest.raises(ParameterError, match="line") as refused:
        ss.Study.from_file(written_brake(tmp_path, ROWS | rows))
    assert part in str(refused.value)


def test_one_damper_gives_one_mode_its_ratio_and_not_four(tmp_path: Path) -> None:
    file = tmp_path / "brake.toml"
    for model, known in (("stick_slip", True), ("pad_on_disc", False)):
        lines = example(ss.load(model)).splitlines()
        kept = [line for line in lines if not line.startswith(("c =", "c_w ="))]
        file.write_text("\n".join([*kept, "damping_ratio = 0.01"]), encoding="utf-8")
        if known:
            m, k, c = (ss.Study.from_file(file).values[name] for name in ("m", "k", "c"))
            assert c == pytest.approx(2 * 0.01 * math.sqrt(k * m), rel=1e-12)
            continue
        with pytest.raises(ParameterError, match=r'cannot give all 4 modes .* write c_w = "7 N'):
            ss.Study.from_file(file)
