"""Exports of every model: its functions in each language, compiled or run, against the Python ones at the same numbers."""

from __future__ import annotations

import importlib.util
import inspect
import json
import math
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
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
from tests.oracles.emission import arguments, flat, functions, results_of_c, with_angles
from tests.oracles.languages import NODE, OCTAVE, octave
from tests.support import few

CC = shutil.which("cc")


@dataclass(frozen=True)
class Call:
    """A generated function, what it was given, and what Python makes of it."""

    function: str
    given: list[float]
    results: list[float]


@cache
def calls(name: str) -> list[Call]:
    """All functions of a model that have a result, each at two places, in contact where that matters."""
    rng, found = np.random.default_rng([182, *name.encode()]), []
    for function, python in functions(load(name)):
        for _ in range(2):
            given = list(map(float, at_a_place(load(name), names_of(python), rng).values()))
            results = [float(leaf) for leaf in flat(python(*given))]
            found += [Call(function, given, results)] * bool(results)
    assert len({call.function for call in found}) > 15
    return found


def names_of(function: Any) -> tuple[str, ...]:
    code = inspect.unwrap(function).__code__
    return code.co_varnames[: code.co_argcount]


def at_a_place(model: Any, names: tuple[str, ...], rng: np.random.Generator) -> dict[str, float]:
    """Arguments of which directions, lengths and turnings of springs follow from the others."""
    values, algebra = dict(zip(names, arguments(names, rng), strict=True)), model.algebra
    for angle, (cosine, sine) in model.about["angles"].items():
        if angle in values and cosine in values:
            values |= {cosine: math.cos(values[angle]), sine: math.sin(values[angle])}
    if "l1" in values:
        for count, (dx, dy, _) in enumerate(algebra.geometry(*map(values.get, names_of(algebra.geometry))), 1):
            length = math.hypot(dx, dy)
            values |= {f"c{count}": dx / length, f"s{count}": dy / length, f"l{count}": length}
    if "phi1" in values:
        for count, turn in enumerate(algebra.turnings(*map(values.get, names_of(algebra.turnings))), 1):
            values[f"phi{count}"] = math.atan2(*turn[::-1])
    return values


def export(name: str, language: str, folder: Path) -> Path:
    """What the command writes."""
    with pytest.raises(SystemExit, match="0"):
        main(["export", "--model", place(name), "--language", language, "--out", str(folder)])
    return folder


# ------------------------------------------------------------------------------------- how each language is run


def in_c(name: str, folder: Path) -> list[float]:
    """Compiled without a warning."""
    model, python = load(name), dict(functions(load(name)))
    given = [list(with_angles(model, python[one.function], one.given).values()) for one in calls(name)]
    asked = [(one.function, taken, len(one.results)) for one, taken in zip(calls(name), given, strict=True)]
    return results_of_c(folder, name, asked)


def in_node(name: str, folder: Path) -> list[float]:
    asked = json.dumps([(one.function, one.given) for one in calls(name)])
    program = f'import {{ algebra }} from "./{name}.mjs";\nconst calls = {asked};\n'
    program += "console.log(JSON.stringify(calls.map(([called, given]) => algebra[called](...given)).flat(9)));\n"
    (folder / "calls.mjs").write_text(program, encoding="utf-8")
    done = subprocess.run([str(NODE), "calls.mjs"], cwd=folder, capture_output=True, text=True, timeout=120, check=True)
    return [float(number) for number in json.loads(done.stdout)]  # JSON writes a large float as an integer


def in_octave(name: str, folder: Path) -> list[float]:
    """For a column of two points, of which one is the other again."""
    program = ""
    for call in calls(name):
        names = [f"r{place}" for place in range(len(call.results))]
        columns = ", ".join(f"[{value!r}; {value!r}]" for value in call.given)
        program += f"[{', '.join(names)}] = {name}_.algebra.{call.function}({columns});\n"
        program += "".join(f"printf('%.17g\\n', {one}(end));\n" for one in names)
    return [float(word) for word in octave(folder, program).split()]


def in_this_process(name: str, folder: Path) -> list[float]:
    """Of a module of Python, to which an angle is given as itself, and no direction of a spring."""
    model, python, found = load(name), dict(functions(load(name))), []
    exported: dict[str, Any] = {}
    exec((folder / f"{name}.py").read_text(encoding="utf-8"), exported)
    for call in calls(name):
        values, function = with_angles(model, python[call.function], call.given), exported[call.function]
        found += map(float, flat(function(*map(values.get, inspect.signature(function).parameters))))
    return found


def in_jax(name: str, folder: Path) -> list[float]:
    import jax

    with jax.enable_x64(True):
        return in_this_process(name, folder)


#: Language of an export → what runs it, where that is, and how.
RUN: dict[str, tuple[str, str | None, Callable[[str, Path], list[float]]]] = {
    "c": ("C compiler", CC, in_c),
    "javascript": ("node", NODE, in_node),
    "matlab": ("Octave", OCTAVE, in_octave),
    "casadi": ("CasADi", str(importlib.util.find_spec("casadi") or "") or None, in_this_process),
    "jax": ("JAX", str(importlib.util.find_spec("jax") or "") or None, in_jax),
}


def test_every_language_is_run() -> None:
    """An FMU by ``test_fmu``: it has the motion only."""
    assert {*RUN, "fmu"} == set(languages())


@pytest.mark.by_hand("c-sprag_rod", *(f"{language}-{name}" for language in RUN for name in ALIKE))
@pytest.mark.parametrize("name", few(MODELS, "pressed"))
@pytest.mark.parametrize("language", RUN)
def test_an_export_gives_the_numbers_of_python(language: str, name: str, tmp_path: Path) -> None:
    """To the last bits: it is the same arithmetic, but for roots, exponentials and angles."""
    needed, there, run = RUN[language]
    if there is None:
        pytest.skip(f"there is no {needed} on this machine")
    found = run(name, export(name, language, tmp_path))
    assert len(found) == sum(len(call.results) for call in calls(name))
    for call in calls(name):
        ours, found = found[: len(call.results)], found[len(call.results) :]
        close = 1e-13 * max(1.0, *map(abs, call.results))
        np.testing.assert_allclose(ours, call.results, rtol=1e-13, atol=close, err_msg=call.function)


# ------------------------------------------------------------------------------------------------ what C has more


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.thorough
@pytest.mark.skipif(CC is None or shutil.which("make") is None, reason="there is no C compiler, or no make")
@pytest.mark.parametrize("name", few(MOVING, "pressed"))
def test_the_example_is_built_and_moves_as_python_does(name: str, tmp_path: Path) -> None:
    """Without a warning, from functions that take the page's names; steps of h = 0.005 across a kink are off by as much as h."""
    model = load(name)
    out = export(name, "c", tmp_path)
    taken = set(re.findall(r"double (\w+)", (out / f"{name}.h").read_text(encoding="utf-8")))
    assert {f"{name}_" for name in model.parameters} <= taken
    assert not taken & {f"{part}_" for pair in model.about["angles"].values() for part in pair}  # but an angle
    subprocess.run(["make", "-s"], cwd=out, check=True, timeout=120)
    lines = subprocess.run(["./example"], cwd=out, check=True, capture_output=True, text=True, timeout=60).stdout.splitlines()
    assert len(lines) == 6
    tr = ss.simulate(a_set(name, 45.0), t_end=20.0)
    said = lines[2].split()
    assert said[:2] == ["time", "8.0"]
    for component, value in zip(tr.components, tr(8.0), strict=True):
        assert float(said[said.index(component) + 1]) == pytest.approx(value, abs=2e-3)
