"""A model's functions in C, written on demand, against the Python ones at the same numbers."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import hypothesis
import numpy as np
import pytest
from hypothesis import given

pytest.importorskip("sympy")

import spragsym as ss
from spragsym.cli import main
from spragsym.derive.emit.targets.c99.layout import comment, plain
from spragsym.models.load import shipped
from tests.support import few, results_of_c, with_angles

COMPILER = shutil.which("cc")

#: Function of a model → which of its modules has it.
FUNCTIONS = {"rhs": "motion", "regime_jacobian": "motion", "regime_by_parameters": "motion", "forces_hessian": "statics"}


def exported(tmp_path: Path, name: str) -> Path:
    out = tmp_path / "c"
    with pytest.raises(SystemExit) as ended:
        main(["export", "--model", name, "--out", str(out)])
    assert ended.value.code == 0
    return out


def numbers(model: Any, function: str) -> list[float]:
    """Arguments for a function: a state in contact, base values, everything felt."""
    p = model.Parameters(**({"theta0": 0.8} if "theta0" in model.parameters else {}))
    n = len(model.coordinates)
    state = [0.1, -0.02, 0.05, 0.07][:n]
    rates = [0.03, -0.04, 0.02, -0.01][:n]
    felt = [1.0] * model.about["layers"]
    torsions = len(model.about["torsions"])
    taken = [float(value) for value in model.arguments(p, "motion")]
    if function == "rhs":
        return [*state, *rates, *taken]
    if function.startswith("regime"):
        return [*state, *rates, *taken, 1.0, 1.0, *felt, *[1.0] * torsions]
    directions = []
    of_statics = [float(value) for value in model.arguments(p)]
    for dx, dy, _ in model.statics.geometry(*state, *of_statics):
        length = float(np.hypot(dx, dy))
        directions += [float(dx) / length, float(dy) / length, length]
    return [*state, *directions, *[0.3] * torsions, *of_statics, 0.4, 1.0]


@pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
@pytest.mark.parametrize("name", few([*shipped()], "stribeck", "trolley"))
def test_c_gives_the_numbers_of_python(name: str, tmp_path: Path) -> None:
    """Compiled without a warning; the same to the last bits, since it is the same arithmetic but for root and exponential."""
    model = ss.load(name)
    out = exported(tmp_path, name)
    calls, want = [], []
    for function, module in FUNCTIONS.items():
        given = numbers(model, function)
        call = getattr(getattr(model, module), function)
        result = np.array(call(*given), dtype=float).ravel()
        want.append(result)
        calls.append((function, with_angles(model, call, given), result.size))
    got = results_of_c(out, name, calls, "-O1")
    np.testing.assert_allclose(got, np.concatenate(want), rtol=1e-13, atol=1e-15)


@pytest.mark.skipif(COMPILER is None or shutil.which("make") is None, reason="there is no C compiler, or no make")
@pytest.mark.parametrize("name", few([*shipped()], "sprag_rod", "stick_slip"))
def test_the_example_is_built_and_moves_as_python_does(name: str, tmp_path: Path) -> None:
    """Without a warning; steps of h = 0.005 across a kink are off by as much as h."""
    model = ss.load(name)
    out = exported(tmp_path, name)
    subprocess.run(["make", "-s"], cwd=out, check=True, timeout=120)
    lines = subprocess.run(["./example"], cwd=out, check=True, capture_output=True, text=True, timeout=60).stdout.splitlines()
    assert len(lines) == 6
    without = {key: np.pi / 4 for key in model.about["angles"] if key not in model.base}
    tr = model.simulate(model.Parameters(**without), t_end=20.0)
    said = lines[2].split()
    assert said[:2] == ["time", "8.0"]
    for component, value in zip(tr.components, tr(8.0), strict=True):
        assert float(said[said.index(component) + 1]) == pytest.approx(value, abs=2e-3)


def test_public_functions_take_the_names_of_the_page(tmp_path: Path) -> None:
    """An angle, and not its cosine and sine."""
    for name in ("two_springs", "sprag_rod"):
        out = exported(tmp_path / name, name)
        header = (out / f"{name}.h").read_text(encoding="utf-8")
        names = set(re.findall(r"double (\w+)", header))
        model = ss.load(name)
        assert set(model.parameters) <= names
        assert not names & {part for pair in model.about["angles"].values() for part in pair}


@given(hypothesis.strategies.text())
def test_a_comment_ends_where_it_ends(words: str) -> None:
    text = comment(words)
    assert text.isascii()
    assert text.count("*/") == text.count("/*") == 1


def test_signs_keep_their_meaning() -> None:
    assert plain("γ ≠ λ₂ Ω̃ ½ 45° Müller ά") == "gamma != lambda2 Omega~ [vulgar fraction one half] 45 degrees Muller alpha"


def test_a_folder_is_exported_from_the_page_in_it(tmp_path: Path) -> None:
    page = tmp_path / "mine.py"
    page.write_text((Path(__file__).parent.parent / "derive/models/stick_slip.py").read_text(encoding="utf-8"), encoding="utf-8")
    with pytest.raises(SystemExit) as ended:
        main(["derive", str(page), "--out", str(tmp_path / "folder")])
    assert ended.value.code == 0
    out = exported(tmp_path, str(tmp_path / "folder"))
    assert "mine_rhs" in (out / "mine.h").read_text(encoding="utf-8")
