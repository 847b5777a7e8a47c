"""A state that leaves the contact has no jump there, and a report does not say so."""

import math
from pathlib import Path

import numpy as np
import pytest

import spragsym as ss
from spragsym.report.over import verdicts_over
from tests.conftest import Run
from tests.oracles.user_pages import derived

#: A load of P L/c = 0.2, with which the rod comes free at 30°: the tilt is then 30° + 0.2 cos 30°.
FILE = """
[brake]
model = "{}"
m = "1 kg"
k = "1000 N/m"
L = "1 m"
tilt = "{} deg"
mu = "0.3"
c = "50 N m/rad"
P = "10 N"
V = "9 m/s"
d = "0.3 s/m"
vary = "tilt"
begin = "10 deg"
"""


FREE_AT = 30 + math.degrees(0.2 * math.cos(math.pi / 6))


def written(folder: Path, tilt: int) -> Path:
    """A file of the rod at a tilt in degrees."""
    pytest.importorskip("sympy")
    page = Path(__file__).parents[1] / "oracles/pages/lifted_rod.py"
    model, file = derived(page.read_text(encoding="utf-8"), "lifted_rod"), folder / "rod.toml"
    file.write_text(FILE.format(model, tilt), encoding="utf-8")
    return file


@pytest.mark.parametrize(("tilt", "free"), [(35, False), (45, True)])
def test_a_state_that_leaves_the_contact_is_not_said_to_jump(
    tilt: int, free: bool, tmp_path: Path
) -> None:
    study = ss.Study.from_file(written(tmp_path, tilt), trust=True)
    report, free_at = study.report(oscillation=False, redesign=False), FREE_AT
    assert math.degrees(report.jump_at) == pytest.approx(free_at, abs=1e-9)
    verdict, *_ = report.text().splitlines()
    assert f"leaves the contact at tilt = {free_at:.4g} deg" in verdict
    assert verdict.startswith("It loses its contact" if free else "It does not sprag")
    assert "jump" not in verdict


def test_nor_over_a_quantity(tmp_path: Path) -> None:
    study = ss.Study.from_file(written(tmp_path, 35), trust=True)
    found = verdicts_over(study, {"tilt": np.array([35.0, 45.0])})
    assert [row[3] for row in found.rows] == ["does not leave the contact", "has left the contact"]


def test_nor_by_the_command_for_critical_values(tmp_path: Path, run: Run) -> None:
    file = written(tmp_path, 35)
    out = run("critical", "--data", str(file), "--trust", "--vary", "tilt")
    row = next(line for line in out.splitlines() if line.startswith("tilt_deg"))
    assert "where it leaves the contact" in row
    assert "jump" not in row
    assert float(row.split()[-1]) == pytest.approx(FREE_AT, abs=1e-6)
