"""Exports of pages with a clock: its phase is an argument, and the example lets it run."""

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

from scipy.integrate import solve_ivp

import spragsym as ss
from tests.derive.test_exports_of_several_contacts import exported
from tests.oracles import clocks, exports
from tests.oracles.emission import arguments
from tests.oracles.exports import CC, RUN
from tests.oracles.user_pages import derived


@pytest.mark.thorough
@pytest.mark.by_hand(*(f"{language}-forced" for language in RUN))
@pytest.mark.parametrize(
    ("name", "text"),
    [("moved", clocks.MOVED), ("forced", clocks.FRICTION)],
    ids=["moved", "forced"],
)
@pytest.mark.parametrize("language", RUN)
def test_functions_of_a_clock_are_those_of_python_and_its_field_that_by_hand(
    language: str, name: str, text: str, tmp_path: Path
) -> None:
    needed, there, run = RUN[language]
    if there is None:
        pytest.skip(f"there is no {needed} on this machine")
    model, rng = ss.load(derived(text, name)), np.random.default_rng(79)

    def at_random(names: tuple[str, ...]) -> dict[str, float]:
        known = dict(zip(names, arguments(names, rng), strict=True))
        base = {one: value for one, value in model.base.items() if one in known}
        return known | base | ({"vphase": base["omega"]} if "vphase" in known else {})

    calls = [call for _ in range(3) for call in exports.calls(model, at_random)]
    fields = [call for call in calls if call.function == "rhs"]
    assert len(fields) == 3
    found = run(exported(text, name, language, tmp_path), calls)
    known = np.concatenate([call.results for call in calls])
    np.testing.assert_allclose(found, known, rtol=1e-13, atol=1e-13 * max(1.0, abs(known).max()))
    ends = np.cumsum([len(call.results) for call in calls])
    for call, end in zip(calls, ends, strict=True):
        if call.function == "rhs" and name == "moved":
            x, phase, v, rate = call.given[:4]
            assert (rate, found[end - 1]) == (model.base["omega"], 0.0)
            by_hand = clocks.moved(phase / rate, np.array([x, v]))[1]
            assert found[end - 2] == pytest.approx(by_hand, rel=1e-12)


@pytest.mark.thorough
@pytest.mark.parametrize("language", RUN)
def test_the_example_is_driven_as_by_hand(language: str, tmp_path: Path) -> None:
    """From rest at the phase 0, by steps that are not cut at kinks."""
    needed, there, _ = RUN[language]
    if there is None or (language == "c" and (CC is None or shutil.which("make") is None)):
        pytest.skip(f"there is no {needed} on this machine")
    out = exported(clocks.MOVED, "moved", language, tmp_path)
    if language == "c":
        subprocess.run(["make", "-s"], cwd=out, check=True, timeout=120)
    (example,) = out.glob("example" if language == "c" else "example*")
    program = {"c": [], "javascript": [there], "matlab": [there, "--norc", "-q"]}
    command = [*program.get(language, [sys.executable]), f"./{example.name}"]
    done = subprocess.run(command, cwd=out, capture_output=True, text=True, timeout=120)
    said = next(line for line in done.stdout.splitlines() if line.split()[:2] == ["time", "8.0"])
    told = dict(zip(said.split()[2:-1:2], said.split()[3::2], strict=False))
    run = solve_ivp(clocks.moved, (0.0, 8.0), [0.0, 0.0], "DOP853", rtol=1e-10, atol=1e-12)
    for component, value in zip(("x", "vx"), run.y[:, -1], strict=True):
        assert float(told[component]) == pytest.approx(value, abs=4e-3)
    assert float(told["phase"]) == pytest.approx(0.6 * 8.0, abs=1e-8)
