"""The MATLAB package in Octave: the bits of C over all families, Python's folds and motion, errors that say what is wrong."""

from __future__ import annotations

import ctypes
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from spragsym.parameters import NAMES
from tests.oracles import article_motion, languages
from tests.oracles.languages import OCTAVE, octave
from tests.shown import fenced
from tests.support import ROOT, in_python, leaves

PAGE = ROOT / "docs" / "howto_matlab.md"

#: Name and arguments of a static method.
METHOD = r"^    function [^=]*?=[\s.]*(\w+)\(([^)]*)\)"

pytestmark = pytest.mark.skipif(OCTAVE is None, reason="Octave is not on this machine")


def numbers(text: str) -> list[list[float]]:
    """Lines of numbers."""
    return [[float(word) for word in line.split()] for line in text.splitlines()]


def literal(value: Any) -> str:
    """A number or a column as MATLAB reads it."""
    flat = np.ravel(value)
    return f"[{'; '.join(f'{float(entry):.17g}' for entry in flat)}]" if flat.size > 1 else f"{float(flat[0]):.17g}"


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


# ------------------------------------------------------------------------------------------------------ algebra


def test_algebra_is_that_of_python(package: Path) -> None:
    """Every generated function, for a column of points; matrices come row by row."""
    rng = np.random.default_rng(18)
    program, expected = "", []
    written = re.findall(METHOD, (package / "+spragsym/algebra.m").read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    assert len(written) > 60
    for name, taken in written:
        names = re.findall(r"\w+", taken)
        given = list(rng.uniform(0.2, 0.9, (len(names), 3)))
        results = leaves(in_python(name, names)(*given))
        places = [f"r{place}" for place in range(len(results))]
        program += f"[{', '.join(places)}] = spragsym.algebra.{name}({', '.join(map(literal, given))});\n"
        program += "".join(shown(f"{result} + zeros(3, 1)") for result in places)
        expected += [(name, np.broadcast_to(leaf, (3,))) for leaf in results]
    for (name, theirs), ours in zip(expected, numbers(octave(package, program)), strict=True):
        assert ours == pytest.approx(theirs, rel=1e-14, abs=1e-15), name


# --------------------------------------------------------------------------------------- surface, folds and cusps


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("alpha", "at"), [(0.0, (0.7, 0.5)), (0.007, (0.7, 0.5)), (0.7, (0.3, 15.0)), (1.0, (0.3, 20.0)), (1.001, (0.3, 20.0))]
)
def test_folds_and_cusps_are_those_that_python_proves(package: Path, alpha: float, at: tuple[float, float]) -> None:
    p = ss.Parameters.article(theta0=at[0], mu0=at[1], alpha=alpha)
    given = ", ".join(f"'{name}', {literal(getattr(p, name))}" for name in NAMES)
    program = f"p = struct({given});\nb = spragsym.bifurcation_set(p, 128);\n" + shown("numel(b.curves)")
    program += "".join(shown(f"b.cusps.{name}") for name in ("theta0", "mu0", "theta", "x", "y"))
    program += "f = spragsym.folds(p);\n" + "".join(shown(f"f.{name}") for name in ("theta0", "theta", "x", "y"))
    found = numbers(octave(package, program))
    theirs = ss.bifurcation_set(p)
    assert found[0] == [len(theirs.curves)]
    for ours, name in zip(found[1:6], ("theta0", "mu0", "theta", "x", "y"), strict=True):
        assert ours == pytest.approx(getattr(theirs.cusps, name), rel=1e-11, abs=1e-11), name
    folds = ss.folds(p)
    assert len(found[6]) > 0
    for ours, name in zip(found[6:], ("theta0", "theta", "x", "y"), strict=True):
        assert ours == pytest.approx(getattr(folds, name), rel=1e-9, abs=1e-9), name


# ------------------------------------------------------------------------------------------------------- motion


@pytest.mark.thorough
def test_right_hand_side_step_and_energy(package: Path) -> None:
    """The equations of motion by hand in three regimes; and steps across kinks of fourth order, by the other integrator."""
    p = ss.Parameters.article(theta0=math.radians(49.0))
    states = ([0.3, -0.02, 0.1, 0.2], [0.3, 0.05, 0.1, 0.2], [0.3, -0.02, 0.9, 0.2])
    program = "m = spragsym.prepare(spragsym.article('theta0', 49/180*pi), 0.5, 10);\n"
    for state in states:
        program += f"z = {literal(state)};\nr = spragsym.regime(m, z);\n"
        program += shown("[r.contact, r.side]") + shown("spragsym.rhs(m, z)") + shown("spragsym.energy(m, z)")
    for h, count in ((0.2, 200), (0.1, 400), (0.05, 800)):
        program += f"z = zeros(4, 1);\nfor k = 1:{count}, z = spragsym.step(m, {h}, z); end\n" + shown("z")
    found = numbers(octave(package, program))
    constants = (math.cos(p.theta0), math.sin(p.theta0), 0.5, 0.007, 0.007, 0.1, 0.0, 0.5, 10.0)
    for state, regime, rate, energy in zip(states, found[:9:3], found[1:9:3], found[2:9:3], strict=True):
        assert regime == [float(state[1] < 0), math.copysign(1.0, 0.5 - state[2])]
        assert rate == pytest.approx([*state[2:], *article_motion.everywhere(state, constants)], abs=1e-15)
        assert energy == pytest.approx([article_motion.stored(state, constants)], abs=1e-14)
    run = ss.simulate(p, V=0.5, d=10.0, t_end=40.0, rtol=1e-12)
    errors = [float(np.abs(np.array(state) - run.state[:, -1]).max()) for state in found[9:]]
    assert any(run.y > 0)
    assert errors[-1] < 1e-6
    assert math.log2(errors[0] / errors[-1]) / 2 > 3.6


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
