"""The MATLAB package in Octave: the bits of C over all families, Python's folds and motion, errors that say what is wrong."""

from __future__ import annotations

import ctypes
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from tests.oracles import languages
from tests.oracles.languages import OCTAVE, octave
from tests.shown import fenced
from tests.support import ROOT

PAGE = ROOT / "docs" / "howto_matlab.md"


pytestmark = pytest.mark.skipif(OCTAVE is None, reason="Octave is not on this machine")


def numbers(text: str) -> list[list[float]]:
    """Lines of numbers."""
    return [[float(word) for word in line.split()] for line in text.splitlines()]


def shown(expression: str) -> str:
    """A statement that prints an array on one line, digit for digit."""
    return f"printf('%.17g ', {expression}); printf('\\n');\n"


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the export in it."""
    folder = tmp_path_factory.mktemp("matlab")
    assert CliRunner().invoke(cli, ["export", "--language", "matlab", "--out", str(folder)]).exit_code == 0
    return folder


# -------------------------------------------------------------------------------------------------- equilibria


@pytest.fixture(scope="module")
def everything() -> dict[bool, tuple[ss.Parameters, languages.Found]]:
    """Points of all families and what Octave says about them, in contact and in lift-off."""
    p = languages.adversarial(400)
    return {contact: (p, languages.in_octave(p, contact)) for contact in (True, False)}


@pytest.mark.parametrize("contact", [True, False])
def test_what_is_vouched_for_is_what_python_proves(everything: Any, contact: bool) -> None:
    """Counts, kinds and errors within the bounds of both, against the ladder's digits; NaN beyond the count."""
    p, found = everything[contact]
    assert np.mean(found.status == 0) > 0.999
    assert languages.against_python(found, p, contact).wrong == 0
    assert 0 < languages.against_python(found, p, contact).largest <= 1
    filled = np.arange(4) < found.count[:, None]
    for name in ("theta", "L", "x", "y"):
        assert np.array_equal(np.isfinite(found.columns[name]), filled)


def test_every_bit_is_that_of_c(everything: Any, c_library: ctypes.CDLL) -> None:
    """Statuses, counts, states and bounds of all points, vouched for or not: one kernel, no operation of it different."""
    for contact, (p, found) in everything.items():
        assert not languages.unlike_c(found, c_library, p, contact).any()


# ------------------------------------------------------------------------------------------------ help and page


@pytest.mark.thorough
def test_examples_run_as_the_page_prints(package: Path) -> None:
    """Every program of the page with what it prints; the two examples are on it as exported. What is drawn are folds."""
    programs, outputs = fenced(PAGE, "matlab"), fenced(PAGE, "text")
    assert len(programs) == len(outputs) > 3
    examples = [path.read_text(encoding="utf-8") for path in sorted(package.glob("example_*.m"))]
    assert len(examples) == 2
    assert set(examples) <= set(programs)
    try:
        octave(package, "figure('visible', 'off'); plot(1, 1);")
    except RuntimeError as error:
        pytest.skip(f"Octave can't draw on this machine: {str(error).splitlines()[0]}")
    hidden = "set(0, 'defaultfigurevisible', 'off');\n"
    drawn = (
        "for line = findobj(gca, 'type', 'line')', printf('%.17g ', get(line, 'xdata'), get(line, 'ydata')); printf('\\n'); end"
    )
    for program, output in zip(programs, outputs, strict=True):
        draws = "bifurcation_set" in program
        printed = octave(package, hidden + program + (drawn if draws else ""))
        assert printed.startswith(output)
        if draws:
            _are_folds(numbers(printed.removeprefix(output)))


def _are_folds(lines: list[list[float]]) -> None:
    """Points of a drawing, each line its abscissae in degrees and then its ordinates, against the folds that Python finds."""
    theirs = ss.bifurcation_set(ss.Parameters.article())
    curves = np.concatenate([np.stack([np.degrees(curve.theta0), curve.mu0]) for curve in theirs.curves], axis=1)
    assert len(lines) == 1 + len(theirs.curves)
    for line in lines:
        points = np.array(line).reshape(2, -1)
        far = np.abs(points[:, :, None] - curves[:, None, :]) / (np.array([180.0, 1.0])[:, None, None] + points[:, :, None])
        assert far.max(axis=0).min(axis=-1).max() < 5e-3
