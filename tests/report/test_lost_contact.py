"""A state that leaves the contact has no jump there, and a report does not say so."""

import math
from pathlib import Path

import pytest

import spragsym as ss
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


@pytest.mark.parametrize(("tilt", "free"), [(35, False), (45, True)])
def test_a_state_that_leaves_the_contact_is_not_said_to_jump(
    tilt: int, free: bool, tmp_path: Path
) -> None:
    pytest.importorskip("sympy")
    page = Path(__file__).parents[1] / "oracles/pages/lifted_rod.py"
    file = tmp_path / "rod.toml"
    folder = derived(page.read_text(encoding="utf-8"), "lifted_rod")
    file.write_text(FILE.format(folder, tilt), encoding="utf-8")
    report = ss.Study.from_file(file, trust=True).report(oscillation=False, redesign=False)
    free_at = 30 + math.degrees(0.2 * math.cos(math.pi / 6))
    assert math.degrees(report.jump_at) == pytest.approx(free_at, abs=1e-9)
    verdict, *_ = report.text().splitlines()
    assert f"leaves the contact at tilt = {free_at:.4g} deg" in verdict
    assert verdict.startswith("It loses its contact" if free else "It does not sprag")
    assert "jump" not in verdict
