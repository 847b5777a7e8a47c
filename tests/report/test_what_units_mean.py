"""Units that may mean two things, and quantities that carry units or dimensions of their own, are
refused and not guessed.
"""

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import spragsym as ss
from spragsym.cli import main
from spragsym.report.units import read
from tests.oracles.mistakes import BRAKE
from tests.support import written_brake


@pytest.mark.parametrize(
    ("text", "si", "words"),
    [
        ("350 gr", "kg", "two meanings, g and grain"),
        ("0.35 ton", "kg", "two meanings"),
        ("180 B N/mm", "N/m", "'B N/mm' is not known; write m, g"),
        ("180 % N/mm", "N/m", "percent .* no unit"),
        ("180 ppm N/mm", "N/m", "ppm .* no unit"),
        ("9 N rad", "N", "does not measure"),
    ],
)
def test_a_unit_that_may_be_another_is_refused(text: str, si: str, words: str) -> None:
    with pytest.raises(ss.errors.ParameterError, match=words):
        read(text, si)


@pytest.mark.parametrize(
    ("text", "si", "value"),
    [
        ("3 N m/rad", "N m", 3.0),
        ("3 N m", "N m/rad", 3.0),
        ("3 N m/deg", "N m", 540 / np.pi),
        ("2 short_ton", "kg", 2 * 907.18474),
    ],
)
def test_a_torsional_stiffness_may_be_a_torque_a_radian(text: str, si: str, value: float) -> None:
    assert read(text, si).value == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (SimpleNamespace(units="millimeter", magnitude=50.0, __array__=None), "in millimeter"),
        (SimpleNamespace(unit="deg", value=0.5), "in deg"),
        (SimpleNamespace(dims=("a",), values=np.ones(2)), "dimensions a"),
    ],
)
def test_units_and_dimensions_of_a_value_are_not_dropped(given: object, words: str) -> None:
    with pytest.raises(ss.errors.ParameterTypeError, match=words):
        ss.Parameters.article(theta0=given)
    with pytest.raises(ss.errors.ParameterTypeError, match=words):
        ss.PhysicalParameters(
            m=1, k=1, k_x=1, k_y=0, k_c=9, F_L=3, L_0=1, theta0=0.5, mu0=0.5, V=given
        )


@pytest.mark.filterwarnings("always")
def test_an_odd_number_is_told_of_wherever_data_are_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    brake = written_brake(tmp_path, {**BRAKE, "mu0": "45"})
    with pytest.raises(SystemExit, match="0"):
        main(["equilibria", "--data", str(brake)])
    assert re.fullmatch("spragsym: warning: .*write 45 % or 0.45.*\n", capsys.readouterr().err)
    with pytest.warns(UserWarning, match="write 45 % or 0.45"):
        ss.Study.from_file(brake)
