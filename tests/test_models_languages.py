"""Every shipped model's algebra and motion in JavaScript and MATLAB, against the Python functions at the same numbers."""

from __future__ import annotations

import json
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("sympy")

import spragsym as ss
from benchmarks.languages import NODE, OCTAVE, octave
from spragsym.derive import export, pages
from spragsym.derive.emit import targets
from spragsym.models.load import shipped

MODELS = sorted(shipped())


@cache
def written(language: str) -> dict[str, str]:
    """The files of all models in a language."""
    (target,) = (one for one in targets.targets() if one.language == language)
    files: dict[str, str] = {}
    for material in materials():
        files |= target.render(material)
    return files


@cache
def materials() -> tuple[targets.Material, ...]:
    """All that is derived from the shipped pages."""
    return tuple(export.material(pages.read(path, path.stem)) for path in pages.shipped())


def exported(language: str, folder: Path) -> Path:
    for name, text in written(language).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


@cache
def calls() -> list[tuple[str, str, list[float], list[float]]]:
    """Model, function, arguments and what Python makes of them, flat."""
    rng = np.random.default_rng(182)
    found = []
    for name in MODELS:
        model = ss.load(name)
        for module in (model.statics, model.motion, model.linearization):
            for function in module.__all__:
                call = getattr(module, function)
                code = call.__wrapped__.__code__
                # y < 0: the belt is touched, and roots of the depth are real.
                signs = [-1.0 if taken == "y" else 1.0 for taken in code.co_varnames[: code.co_argcount]]
                given = [float(value) for value in signs * rng.uniform(0.2, 0.9, code.co_argcount)]
                results = list(leaves(call(*given)))
                if results:
                    found.append((name, function, given, results))
    assert len(found) > 20 * len(MODELS)
    assert {name for name, *_ in found} == set(MODELS)
    return found


def leaves(result: Any) -> list[float]:
    return [leaf for part in result for leaf in leaves(part)] if isinstance(result, tuple | list) else [float(result)]


@pytest.mark.thorough
@pytest.mark.skipif(NODE is None, reason="node is not on this machine")
def test_javascript_gives_the_numbers_of_python(tmp_path: Path) -> None:
    folder = exported("javascript", tmp_path)
    program = "".join(f'import * as {name} from "./{name}.mjs";\n' for name in MODELS)
    program += f"const models = {{ {', '.join(MODELS)} }};\n"
    program += f"const calls = {json.dumps([call[:3] for call in calls()])};\n"
    program += "console.log(JSON.stringify(calls.map(([model, name, given]) => models[model].algebra[name](...given))));\n"
    (folder / "all.mjs").write_text(program, encoding="utf-8")
    done = subprocess.run([str(NODE), "all.mjs"], cwd=folder, capture_output=True, text=True, timeout=120, check=True)
    for found, (model, function, _, results) in zip(json.loads(done.stdout), calls(), strict=True):
        assert leaves(found) == pytest.approx(results, rel=1e-13, abs=1e-14), (model, function)


@pytest.mark.thorough
@pytest.mark.skipif(OCTAVE is None, reason="Octave is not on this machine")
def test_matlab_gives_the_numbers_of_python(tmp_path: Path) -> None:
    """For a column of two points, of which one is the other again."""
    folder, program = exported("matlab", tmp_path), ""
    for model, function, given, results in calls():
        names = ", ".join(f"r{place}" for place in range(len(results)))
        columns = ", ".join(f"[{value!r}; {value!r}]" for value in given)
        program += f"[{names}] = {model}.algebra.{function}({columns});\n"
        program += "".join(f"printf('%.17g ', r{place}(end));" for place in range(len(results))) + "printf('\\n');\n"
    lines = octave(folder, program).splitlines()
    for line, (model, function, _, results) in zip(lines, calls(), strict=True):
        assert [float(word) for word in line.split()] == pytest.approx(results, rel=1e-13, abs=1e-14), (model, function)
