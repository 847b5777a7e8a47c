"""An exported page whose quantities bear names of languages: every function gives the numbers of Python in each of them."""

from __future__ import annotations

import inspect
import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np

from spragsym.derive import export, pages
from spragsym.models.load import page_of
from tests.oracles.emission import flat, functions, results_of_c, with_angles
from tests.oracles.languages import NODE, octave

#: Roles of names: a coordinate, an angle, and parameters in every function that pages have.
PAGE = '''r"""A block."""
from spragsym.derive.model import Abs, Page, atan, cos, cosh, exp, log, pi as PI, sin, sinh, sqrt, tanh
page = Page("A block on a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
L = page.unit("L", "m", "length")
q = page.coordinate({0!r}, "m", "displacement")
t = page.parameter({1!r}, "rad", "angle", "(0, pi/2)", 0.4)
a = page.parameter({2!r}, "1", "friction", "> 0", 0.3)
b = page.parameter({3!r}, "s/m", "steepness", "> 0", 0.3)
c = page.parameter({4!r}, "N s/m", "damping", "> 0", 0.3)
d = page.parameter({5!r}, "1", "share", "real", 0.3)
f = page.parameter("force", "N", "force", "> 0", 0.3, becomes={6!r})
V = page.parameter({7!r}, "m/s", "belt speed", "> 0", 0.3)
page.kinetic(m * page.rate(q)**2 / 2)
page.potential(k * q**2 / 2 * (1 + d**2 * sin(q / L)**2 + tanh(d) + log(2 + Abs(d)) + sqrt(1 + d**2)))
page.damper(c * (1 + q**2 / L**2), along=q)
page.force(f * cos(t) * (PI + atan(q / L)), along=q)
page.normal_force(k * L)
page.friction(q, V, lambda v: a * tanh(b * v) * (1 + exp(-b * Abs(v))))
'''


def compare(model: Any, home: Path, rng: np.random.Generator, names: list[str]) -> list[str]:
    """What is off in each language."""
    calls = []
    for name, function in functions(model):
        given = dict.fromkeys(inspect.unwrap(function).__code__.co_varnames[: inspect.unwrap(function).__code__.co_argcount], 0.0)
        given = {key: float(rng.uniform(0.2, 0.9)) for key in given}
        for angle, (cosine, sine) in model.about["angles"].items():
            turn = given.get(angle, 0.5)
            given |= {key: value for key, value in ((cosine, np.cos(turn)), (sine, np.sin(turn))) if key in given}
        if results := [float(leaf) for leaf in flat(function(**given))]:
            calls.append((name, function, [float(value) for value in given.values()], results))
    exact, wrong = np.concatenate([results for *_, results in calls]), []
    for language, run in (("c", in_c), ("javascript", in_node), ("matlab", in_octave)):
        out = home / language
        for name, text in export.export(page_of(model, pages.SHIPPED), model.name, language).items():
            (out / name).parent.mkdir(parents=True, exist_ok=True)
            (out / name).write_text(text, encoding="utf-8")
        try:
            off = np.abs(np.array(run(model, out, calls)) - exact).max()
        except (subprocess.SubprocessError, RuntimeError) as error:
            off = f"{error} {getattr(error, 'stderr', '')}"
        if isinstance(off, str) or not off <= 1e-13 * np.abs(exact).max():
            wrong.append(f"{language} of {model.name} with {names}: {off}")
    return wrong


def in_c(model: Any, out: Path, calls: list[Any]) -> list[float]:
    subprocess.run(["make", "-s"], cwd=out, check=True, capture_output=True, text=True, timeout=120)
    (header,) = out.glob("*.h")
    return results_of_c(
        out, header.stem, [(name, [*with_angles(model, it, given).values()], len(found)) for name, it, given, found in calls]
    )


def in_node(_: Any, out: Path, calls: list[Any]) -> list[float]:
    (module,) = out.glob("*.mjs")
    program = f'import {{ algebra }} from "./{module.name}";\nconst calls = {json.dumps([(name, given) for name, _, given, _ in calls])};\n'
    program += "console.log(JSON.stringify(calls.map(([called, given]) => algebra[called](...given)).flat(9)));\n"
    done = subprocess.run(
        [str(NODE), "--input-type=module", "-"], input=program, cwd=out, capture_output=True, text=True, timeout=60, check=True
    )
    return list(json.loads(done.stdout))


def in_octave(_: Any, out: Path, calls: list[Any]) -> list[float]:
    (package,) = out.glob("+*")
    program = "".join(
        f"r = cell(1, {len(found)}); [r{{:}}] = {package.name[1:]}.algebra.{name}({', '.join(map(repr, given))}); printf('%.17g\\n', r{{:}});\n"
        for name, _, given, found in calls
    )
    return [float(word) for word in octave(out, program).split()]
