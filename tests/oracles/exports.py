"""Exports of a model, run in each language on calls of its functions."""

import importlib.util
import inspect
import json
import shutil
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tests.oracles.emission import flat, functions, results_of_c, with_angles
from tests.oracles.languages import NODE, OCTAVE, octave

CC = shutil.which("cc")


@dataclass(frozen=True)
class Call:
    """A generated function, what it was given, also by names with angles for their cosines and
    sines, and what Python makes of it.
    """

    function: str
    given: list[float]
    by_angles: dict[str, float]
    results: list[float]


def calls(model: Any, values: Callable[[tuple[str, ...]], Mapping[str, float]]) -> list[Call]:
    """All functions of a model that have a result, of values for the names of their arguments; but
    for those whose law overflows, far beyond the border of a regime.
    """
    found = []
    for function, python in functions(model):
        given = list(map(float, values(names_of(python)).values()))
        with np.errstate(over="ignore", invalid="ignore"):
            results = [float(leaf) for leaf in flat(python(*given))]
        if results and np.isfinite(results).all():
            found.append(Call(function, given, with_angles(model, python, given), results))
    return found


def names_of(function: Any) -> tuple[str, ...]:
    code = inspect.unwrap(function).__code__
    return code.co_varnames[: code.co_argcount]


def in_c(folder: Path, asked: Sequence[Call]) -> list[float]:
    """Compiled without a warning."""
    (header,) = folder.glob("*.h")
    return results_of_c(
        folder,
        header.stem,
        [(one.function, [*one.by_angles.values()], len(one.results)) for one in asked],
    )


def in_node(folder: Path, asked: Sequence[Call]) -> list[float]:
    (module,) = (path for path in folder.glob("*.mjs") if not path.name.startswith("example_"))
    program = f'import {{ algebra }} from "./{module.name}";\n'
    program += f"const calls = {json.dumps([(one.function, one.given) for one in asked])};\n"
    program += (
        "console.log(JSON.stringify(calls.map(([called, given]) => "
        "algebra[called](...given)).flat(9)));\n"
    )
    command = [str(NODE), "--input-type=module", "-"]
    done = subprocess.run(
        command, input=program, cwd=folder, capture_output=True, text=True, timeout=120, check=True
    )
    return [
        float(number) for number in json.loads(done.stdout)
    ]  # JSON writes a large float as an integer


def in_octave(folder: Path, asked: Sequence[Call]) -> list[float]:
    """For a column of two points, of which one is the other again."""
    (package,), program = folder.glob("+*"), ""
    for call in asked:
        names = [f"r{place}" for place in range(len(call.results))]
        columns = ", ".join(f"[{value!r}; {value!r}]" for value in call.given)
        program += (
            f"[{', '.join(names)}] = {package.name[1:]}.algebra.{call.function}({columns});\n"
        )
        program += "".join(f"printf('%.17g\\n', {one}(end));\n" for one in names)
    return [float(word) for word in octave(folder, program).split()]


def in_this_process(folder: Path, asked: Sequence[Call]) -> list[float]:
    """Of a module of Python, to which an angle is given as itself, and no direction of a spring."""
    (module,) = (path for path in folder.glob("*.py") if not path.name.startswith("example_"))
    exported, found = dict[str, Any](), list[float]()
    exec(module.read_text(encoding="utf-8"), exported)
    for call in asked:
        function = exported[call.function]
        found += map(
            float, flat(function(*map(call.by_angles.get, inspect.signature(function).parameters)))
        )
    return found


def in_jax(folder: Path, asked: Sequence[Call]) -> list[float]:
    import jax

    with jax.enable_x64(True):
        return in_this_process(folder, asked)


#: Language of an export → what runs it, where that is, and how.
RUN: dict[str, tuple[str, str | None, Callable[[Path, Sequence[Call]], list[float]]]] = {
    "c": ("C compiler", CC, in_c),
    "javascript": ("node", NODE, in_node),
    "matlab": ("Octave", OCTAVE, in_octave),
    "casadi": ("CasADi", str(importlib.util.find_spec("casadi") or "") or None, in_this_process),
    "jax": ("JAX", str(importlib.util.find_spec("jax") or "") or None, in_jax),
}
