"""Exports of pages with several contacts: the functions and the example of each language against
Python, and what is refused.
"""

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

import spragsym as ss
from spragsym.cli import main
from spragsym.derive import export
from spragsym.derive.model import PageError
from tests.oracles import exports
from tests.oracles.contact_pages import BLOCKS, PAD, PADS
from tests.oracles.emission import arguments
from tests.oracles.exports import CC, RUN
from tests.oracles.user_pages import derived


def exported(text: str, name: str, language: str, out: Path) -> Path:
    command = ["export", "--model", str(derived(text, name)), "--language", language]
    with pytest.raises(SystemExit, match="0"):
        main([*command, "--out", str(out)])
    return out


@pytest.mark.thorough
@pytest.mark.parametrize("language", RUN)
def test_functions_of_several_contacts_are_those_of_python(language: str, tmp_path: Path) -> None:
    needed, there, run = RUN[language]
    if there is None:
        pytest.skip(f"there is no {needed} on this machine")
    model, rng = ss.load(derived(PAD, "pad_on_2")), np.random.default_rng(79)
    calls = [
        call
        for _ in range(3)
        for call in exports.calls(
            model, lambda names: dict(zip(names, arguments(names, rng), strict=True))
        )
    ]
    assert {"contact_force_front", "friction_at_rest_rear", "rhs"} <= {c.function for c in calls}
    found = run(exported(PAD, "pad_on_2", language, tmp_path), calls)
    known = np.concatenate([call.results for call in calls])
    np.testing.assert_allclose(found, known, rtol=1e-13, atol=1e-13 * max(1.0, abs(known).max()))


@pytest.mark.thorough
@pytest.mark.skipif(
    CC is None or shutil.which("make") is None, reason="there is no C compiler, or no make"
)
@pytest.mark.parametrize(("text", "name"), [(PAD, "pad_on_2"), (PADS, "pads")])
def test_the_example_in_c_is_built_and_moves_as_python_does(
    text: str, name: str, tmp_path: Path
) -> None:
    out = exported(text, name, "c", tmp_path)
    subprocess.run(["make", "-s"], cwd=out, check=True, timeout=120)
    done = subprocess.run(
        ["./example"], cwd=out, check=True, capture_output=True, text=True, timeout=60
    )
    tr = ss.simulate(ss.load(derived(text, name)).Parameters(), t_end=8.0)
    said = done.stdout.splitlines()[2].split()
    assert said[:2] == ["time", "8.0"]
    for component, value in zip(tr.components, tr(8.0), strict=True):
        assert float(said[said.index(component) + 1]) == pytest.approx(value, abs=2e-3)
    assert len(said[said.index("energy") + 2 :]) == 2  # which of both touch


@pytest.mark.thorough
def test_frictions_that_hold_together_are_not_exported() -> None:
    page = derived(BLOCKS, "blocks") / "page.py"
    line = BLOCKS[: BLOCKS.rindex("page.friction(x_2")].count("\n") + 1
    with pytest.raises(PageError, match=rf"line {line}: of several frictions some hold.*tanh"):
        export.export(page, "blocks", "c")
