"""The MATLAB package in Octave: the bits of C over all families, Python's motion, errors that say what is wrong."""

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
    p = languages.adversarial(120)
    return {contact: (p, languages.in_octave(p, contact)) for contact in (True, False)}


def test_every_bit_is_that_of_c(everything: Any, c_library: ctypes.CDLL) -> None:
    """Statuses, counts, states and bounds of all points, vouched for or not: one kernel, no operation of it different."""
    for contact, (p, found) in everything.items():
        assert not languages.unlike_c(found, c_library, p, contact).any()
        filled = np.arange(4) < found.count[:, None]
        assert all(np.array_equal(np.isfinite(found.columns[name]), filled) for name in ("theta", "L", "x", "y"))


# ------------------------------------------------------------------------------------------------ help and page


@pytest.mark.thorough
def test_examples_run_as_the_page_prints(package: Path) -> None:
    """Every program of the page with what it prints; the example is on it as exported."""
    programs, outputs = fenced(PAGE, "matlab"), fenced(PAGE, "text")
    assert len(programs) == len(outputs) > 2
    (example,) = package.glob("example_*.m")
    assert example.read_text(encoding="utf-8") in programs
    try:
        octave(package, "figure('visible', 'off'); plot(1, 1);")
    except RuntimeError as error:
        pytest.skip(f"Octave can't draw on this machine: {str(error).splitlines()[0]}")
    for program, output in zip(programs, outputs, strict=True):
        assert octave(package, f"set(0, 'defaultfigurevisible', 'off');\n{program}").startswith(output)
