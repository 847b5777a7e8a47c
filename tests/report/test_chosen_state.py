"""The state that a report follows can be chosen; others that are stable are named."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

import spragsym as ss

BRAKE = {
    "m": 0.35, "k": 1.8e5, "L_0": 0.038, "theta0": math.radians(52.0), "k_x": 9e3, "k_y": 0.0, "k_c": 1.5e6, "F_L": 420.0,
    "mu0": 0.3,
}  # fmt: skip
QUICK = {"probability": False, "redesign": False, "oscillation": False}


def study(**options: Any) -> ss.Study:
    return ss.Study(BRAKE, model="kang_nam", **options)


@pytest.mark.thorough
def test_a_report_follows_the_state_that_was_chosen_and_names_the_other() -> None:
    small, far = study().report(**QUICK), study(state={"x": 0.05}).report(**QUICK)
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
    file = tmp_path / "brake.toml"
    rows = "\n".join(f"{name} = {json.dumps(value if name in ('theta0', 'mu0') else str(value))}" for name, value in {
        "m": "0.35 kg", "k": "180 N/mm", "L_0": "38 mm", "theta0": "52 deg", "k_x": "9 N/mm", "k_y": "0 N/mm", "k_c": "1500 N/mm",
        "F_L": "420 N", "mu0": 0.3,
    }.items())  # fmt: skip
    file.write_text(f'[brake]\n{rows}\nstate = {{ x = "50 mm" }}\n')
    assert ss.Study.from_file(file).dimensionless.followed == pytest.approx({"x": 50 / 38})
    file.write_text(f'[brake]\n{rows}\nstate = {{ z = "50 mm" }}\n')
    with pytest.raises(ss.ParameterError, match=r"line 11: state = .*write state = \{ x = "):
        ss.Study.from_file(file)
