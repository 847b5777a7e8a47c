"""Exports of a model, run in each language on calls of its functions."""

import importlib.util
import inspect
import json
import math
import re
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
GFORTRAN = shutil.which("gfortran")
JULIA = shutil.which("julia")


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


def in_fortran(folder: Path, asked: Sequence[Call]) -> list[float]:
    """Compiled without a warning, and with nothing that the standard does not have."""
    (source,) = folder.glob("*.f90")
    most = max(len(one.results) for one in asked)
    lines = ["program asked", f"use {source.stem}", "implicit none"]
    lines += [f"double precision :: found({most})"]
    for call in asked:
        numbers = [f"{value!r}_8" for value in call.by_angles.values()]
        lines += [f"call {call.function}(&", *(f"{one}, &" for one in numbers), "found)"]
        lines += [f"print '(es25.17e3)', found({k})" for k in range(1, len(call.results) + 1)]
    program = folder / "asked.f95"
    of_auto = ["double precision function getp()", "getp = 0", "end function", ""]
    program.write_text("\n".join([*lines, "end program", *of_auto]), encoding="utf-8")
    strict = ["-std=f2018", "-pedantic", "-Wall", "-Wno-unused-dummy-argument", "-Werror"]
    command = [str(GFORTRAN), *strict, "-ffp-contract=off", source.name, program.name]
    subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True, timeout=120)
    done = subprocess.run([folder / "a.out"], capture_output=True, text=True, check=True)
    return [float(word) for word in done.stdout.split()]


def in_julia(folder: Path, asked: Sequence[Call]) -> list[float]:
    """By Julia; where there is none its functions are read as Python's, whose statements they
    have.
    """
    module = min(folder.glob("*.jl"), key=lambda path: len(path.stem))
    if JULIA is None:
        return _as_python(module.read_text(encoding="utf-8"), asked)
    lines = [f'include("{module.name}")', f"import .{module.stem}"]
    lines.append("flat(a) = a isa Tuple ? reduce(vcat, map(flat, a)) : [float(a)]")
    for call in asked:
        given = ", ".join(map(repr, call.by_angles.values()))
        lines.append(f"foreach(println, flat({module.stem}.{call.function}({given})))")
    (folder / "asked.jl").write_text("\n".join(lines), encoding="utf-8")
    command = [JULIA, "--startup-file=no", "asked.jl"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    return [float(word) for word in done.stdout.split()]


def _as_python(text: str, asked: Sequence[Call]) -> list[float]:
    """Results of Julia's functions, each of one statement a line but for lines that go on."""
    functions = text[text.index("\nfunction ") :].removesuffix("end\n")
    joined = re.sub(r"(?<=[-,+*/=(])\n +", " ", functions).replace("//", "/")
    program = re.sub(r"(?m)^end$", "", re.sub(r"(?m)^function (.*)$", r"def \1:", joined))
    space = {**vars(math), "sign": lambda u: (u > 0) - (u < 0)}
    space["atan"] = lambda *given: (math.atan2 if len(given) > 1 else math.atan)(*given)
    exec(program, space)
    return [float(v) for one in asked for v in flat(space[one.function](*one.by_angles.values()))]


#: Language of an export → what runs it, where that is, and how.
RUN: dict[str, tuple[str, str | None, Callable[[Path, Sequence[Call]], list[float]]]] = {
    "c": ("C compiler", CC, in_c),
    "javascript": ("node", NODE, in_node),
    "matlab": ("Octave", OCTAVE, in_octave),
    "casadi": ("CasADi", str(importlib.util.find_spec("casadi") or "") or None, in_this_process),
    "auto": ("gfortran", GFORTRAN, in_fortran),
    "julia": ("Julia", "read as Python", in_julia),
    "jax": ("JAX", str(importlib.util.find_spec("jax") or "") or None, in_jax),
}
