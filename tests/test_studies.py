"""A brake in, a verdict out: units, files, and the report's numbers against direct calls."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

import spragsym as ss
from spragsym.cli import main

BRAKE = """[brake]
m = "0.35 kg"
k = "180 N/mm ± 15 %"
L_0 = "38 mm"
theta0 = "52 deg ± 1 deg"
k_x = "9 N/mm ± 15 %"
k_y = "0 N/mm"
k_c = "1500 N/mm ± 15 %"
F_L = "420 N"
mu0 = "[0.3, 0.6]"
V = "1.2 m/s"
d = "10 s/m"
model = "kang_nam"
"""
KEYS = [
    "mu_jump",
    "theta0_jump_deg",
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
]


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("studies") / "brake.toml"
    file.write_text(BRAKE, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def study(path: Path) -> ss.Study:
    return ss.Study.from_file(path)


@pytest.fixture(scope="module")
def report(study: ss.Study) -> ss.Report:
    return study.report(n=1024)


def test_the_numbers_are_those_of_direct_calls_without_units(report: ss.Report) -> None:
    # By hand: k_c L_0 = 57 000 N; κ = 420/57000, α = 9/1500, σ = 180/1500, β = 0; time sqrt(0.35/1.5e6) s.
    p = ss.Parameters(theta0=math.radians(52), mu0=0.45, kappa=420 / 57000, alpha=0.006, sigma=0.12, beta=0.0)
    assert report.mu_jump == pytest.approx(ss.jump_value(p), rel=1e-12)
    working = 0.45 * -math.expm1(-12.0)
    assert report.mu_effective == pytest.approx(working, rel=1e-12)
    at = p.replace(mu0=working)
    assert report.theta0_jump_deg == pytest.approx(math.degrees(ss.jump_value(at, "theta0")), rel=1e-12)
    assert report.mu_cusp == pytest.approx(ss.critical_friction(p), rel=1e-12)
    eq = ss.equilibria(at)
    assert len(report.states) == eq.count
    for i, state in enumerate(report.states):
        assert state.x_mm == pytest.approx(38 * eq.x[i], rel=1e-9)
        assert state.contact_force_N == pytest.approx(-57000 * eq.y[i], rel=1e-9)
        assert state.spring_force_N == pytest.approx(57000 * 0.12 * (eq.L[i] - 1), rel=1e-9)
        hertz = np.sort(np.abs(eq.eigenvalues[i].imag))[::2] * math.sqrt(1.5e6 / 0.35) / (2 * math.pi)
        assert np.allclose(state.frequencies_hz, hertz[hertz > 0], rtol=1e-3)  # the law's damping is left out here


def test_json_has_the_keys_of_the_contract(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        main(["report", str(path), "--json"])
    assert stop.value.code == 0
    found = json.loads(capsys.readouterr().out)
    assert list(found) == KEYS
