"""Exports of every model: its functions in each language, compiled or run, against the Python ones
at the same numbers.
"""

import math
import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spragsym as ss

pytest.importorskip("sympy")

from spragsym.cli import main
from spragsym.cli.export import languages
from tests.conformance.models import ALIKE, MODELS, MOVING, a_set, load, place
from tests.oracles import exports
from tests.oracles.emission import arguments
from tests.oracles.exports import CC, RUN, Call, names_of
from tests.oracles.user_pages import alone
from tests.support import few


@cache
def calls(name: str) -> list[Call]:
    """Each function at two places, in contact where that matters."""
    rng = np.random.default_rng([182, *name.encode()])
    model = alone(name) if place(name) == name else load(name)
    found = [
        call
        for _ in range(2)
        for call in exports.calls(model, lambda names: at_a_place(model, names, rng))
    ]
    assert len({call.function for call in found}) > 15
    return found


def at_a_place(model: Any, names: tuple[str, ...], rng: np.random.Generator) -> dict[str, float]:
    """Arguments of which directions, lengths and turnings of springs follow from the others."""
    values, algebra = dict(zip(names, arguments(names, rng), strict=True)), model.algebra
    for angle, (cosine, sine) in model.about["angles"].items():
        if angle in values and cosine in values:
            values |= {cosine: math.cos(values[angle]), sine: math.sin(values[angle])}
    if "l1" in values:
        for count, (dx, dy, _) in enumerate(
            algebra.geometry(*map(values.get, names_of(algebra.geometry))), 1
        ):
            length = math.hypot(dx, dy)
            values |= {f"c{count}": dx / length, f"s{count}": dy / length, f"l{count}": length}
    if "phi1" in values:
        for count, turn in enumerate(
            algebra.turnings(*map(values.get, names_of(algebra.turnings))), 1
        ):
            values[f"phi{count}"] = math.atan2(*turn[::-1])
    return values


def export(name: str, language: str, folder: Path) -> Path:
    """What the command writes."""
    with pytest.raises(SystemExit, match="0"):
        main(["export", "--model", place(name), "--language", language, "--out", str(folder)])
    return folder


def test_every_language_is_run() -> None:
    """An FMU by ``test_fmu``: it has the motion only."""
    assert {*RUN, "fmu"} == set(languages())


@pytest.mark.by_hand(
    "c-sprag_rod", "c-two_blocks", *(f"{language}-{name}" for language in RUN for name in ALIKE)
)
@pytest.mark.parametrize("name", few(MODELS, "pressed"))
@pytest.mark.parametrize("language", RUN)
def test_an_export_gives_the_numbers_of_python(language: str, name: str, tmp_path: Path) -> None:
    """To the last bits: it is the same arithmetic, but for roots, exponentials and angles."""
    needed, there, run = RUN[language]
    if there is None:
        pytest.skip(f"there is no {needed} on this machine")
    found = run(export(name, language, tmp_path), calls(name))
    assert len(found) == sum(len(call.results) for call in calls(name))
    for call in calls(name):
        ours, found = found[: len(call.results)], found[len(call.results) :]
        close = 1e-13 * max(1.0, *map(abs, call.results))
        np.testing.assert_allclose(
            ours, call.results, rtol=1e-13, atol=close, err_msg=call.function
        )


@pytest.mark.thorough
@pytest.mark.parametrize("language", sorted(RUN.keys() - {"auto", "c", "julia"}))
def test_an_example_moves_as_python_does(language: str, tmp_path: Path) -> None:
    """With steps that are not cut at kinks, and nothing said besides."""
    needed, there, _ = RUN[language]
    if there is None:
        pytest.skip(f"there is no {needed} on this machine")
    out = export("pressed", language, tmp_path / "out")
    (example,) = out.glob("example*")
    program = {"javascript": [there], "matlab": [there, "--norc", "-q"]}.get(language)
    command = [*(program or [sys.executable]), example.name]
    done = subprocess.run(command, cwd=out, capture_output=True, text=True, timeout=120)
    assert "shadows" not in done.stderr
    said = next(line for line in done.stdout.splitlines() if line.split()[:2] == ["time", "8.0"])
    tr = ss.simulate(a_set("pressed", 45.0), t_end=8.0)
    for component, value in zip(tr.components, tr(8.0), strict=True):
        told = said.split()[said.split().index(component) + 1]
        assert float(told) == pytest.approx(value, abs=4e-3)


# ------------------------------------------------------------------------------------------------
# what C has more


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.thorough
@pytest.mark.skipif(
    CC is None or shutil.which("make") is None, reason="there is no C compiler, or no make"
)
@pytest.mark.parametrize("name", few(MOVING, "pressed"))
def test_the_example_is_built_and_moves_as_python_does(name: str, tmp_path: Path) -> None:
    """Without a warning, from functions that take the page's names; steps of h = 0.005 across a
    kink are off by as much as h. While the mass sticks each step crosses the kink, and the speed is
    off by as much as h.
    """
    model = load(name)
    out = export(name, "c", tmp_path)
    taken = set(re.findall(r"double (\w+)", (out / f"{name}.h").read_text(encoding="utf-8")))
    assert {f"{name}_" for name in model.parameters} <= taken
    assert not taken & {
        f"{part}_" for pair in model.about["angles"].values() for part in pair
    }  # but an angle
    subprocess.run(["make", "-s"], cwd=out, check=True, timeout=120)
    lines = subprocess.run(
        ["./example"], cwd=out, check=True, capture_output=True, text=True, timeout=60
    ).stdout.splitlines()
    assert len(lines) == 6
    tr = ss.simulate(a_set(name, 45.0), t_end=8.0)
    said = lines[2].split()
    assert said[:2] == ["time", "8.0"]
    sticks = 8.0 * max(map(tr.sticking_share, model.rubbing))
    close = 2e-3 + 0.005 * sticks
    for component, value in zip(tr.components, tr(8.0), strict=True):
        assert float(said[said.index(component) + 1]) == pytest.approx(value, abs=close)
