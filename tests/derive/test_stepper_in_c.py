"""The stepper of exported C, on a mass that a belt carries until its spring is too strong."""

import ctypes
import math
import subprocess
from pathlib import Path
from typing import Any

import pytest

from spragsym.derive.export import export
from tests.oracles.c_target import compiler

pytest.importorskip("sympy")
pytestmark = pytest.mark.thorough
PAGE = Path(__file__).resolve().parents[2] / "derive/models/coulomb_stick_slip.py"
#: Static and kinetic friction, and belt speed; the normal force is 1.
GIVEN = {"mu_s": 0.6, "mu_k": 0.4, "V": 0.3}
Numbers = ctypes.c_double * 100


@pytest.fixture(scope="module")
def stepper(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """The compiled library, and its parameters."""
    found, folder = compiler(), tmp_path_factory.mktemp("c")
    if found is None:
        pytest.skip("no C compiler")
    for name, text in export(PAGE, "coulomb_stick_slip", "c").items():
        (folder / name).write_text(text, encoding="utf-8")
    strict = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")
    built = folder / "built.so"
    command = [found, *strict, "-O1", "-ffp-contract=off", "-shared", "-fPIC"]
    source = folder / "coulomb_stick_slip.c"
    subprocess.run([*command, "-o", built, source, "-lm"], check=True, timeout=120)
    lines = (folder / "coulomb_stick_slip.h").read_text(encoding="utf-8").splitlines()
    (names,) = [line.strip(" *.").split(", ") for line in lines if line.startswith(" * mu_s, ")]
    return ctypes.CDLL(str(built)), [GIVEN[name] for name in names]


def begun(stepper: Any, state: tuple[float, float], tolerance: float = 1e-12) -> tuple[int, Any]:
    library, given = stepper
    motion = Numbers()
    begin = library.coulomb_stick_slip_begin
    status = begin(motion, Numbers(*given), Numbers(*state), ctypes.c_double(tolerance))
    return status, motion


def test_what_sticks_is_carried_and_then_slips(stepper: Any) -> None:
    """It slips at x = μ_s N, then x = μ_k N + (μ_s − μ_k) N cos τ + V sin τ."""
    status, motion = begun(stepper, (0.0, 0.3))
    assert status == 0
    advance = stepper[0].coulomb_stick_slip_advance
    for time in (0.7, 1.9):
        assert advance(motion, ctypes.c_double(time - motion[0])) == 0
        assert motion[1:3] == pytest.approx([0.3 * time, 0.3], abs=1e-15)
    assert advance(motion, ctypes.c_double(1.4)) == 0
    after = motion[0] - 2.0
    x = 0.4 + 0.2 * math.cos(after) + 0.3 * math.sin(after)
    assert motion[1:3] == pytest.approx(
        [x, -0.2 * math.sin(after) + 0.3 * math.cos(after)], abs=1e-10
    )


def test_bad_input_is_refused_and_leaves_the_motion(stepper: Any) -> None:
    for state, tolerance in (((math.nan, 0.0), 1e-9), ((0.0, math.inf), 1e-9), ((0.0, 0.0), 0.0)):
        assert begun(stepper, state, tolerance)[0] == 2
    _, motion = begun(stepper, (0.0, 0.3))
    before = bytes(motion)
    for duration in (-1.0, math.nan, math.inf):
        assert stepper[0].coulomb_stick_slip_advance(motion, ctypes.c_double(duration)) == 2
        assert bytes(motion) == before
