"""Pages whose quantities bear random names: words, functions and constants of every language, and those of generated code.

Each page is derived and exported to C, JavaScript and MATLAB under a random name of its own; every function gives the numbers of
Python in each language, or the name is refused by its line.
Last found: a parameter called ``pi`` gave other numbers in MATLAB, ``sin``, ``EOF``, ``INLINE`` and pages called ``main`` no code that
compiles (19cc3e36).
"""

from __future__ import annotations

import builtins
import inspect
import json
import keyword
import re
import subprocess
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.cli.export import of_model
from spragsym.derive import folder as derivation
from spragsym.derive import model as vocabulary
from tests.oracles.emission import flat, functions
from tests.oracles.languages import NODE, octave
from tests.support import results_of_c, with_angles

CASES = 50
HOME = Path(inspect.getfile(derivation)).parent
HEADERS = (
    "complex",
    "ctype",
    "errno",
    "fenv",
    "float",
    "limits",
    "math",
    "signal",
    "stdint",
    "stdio",
    "stdlib",
    "string",
    "time",
    "unistd",
)
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


@cache
def pool() -> tuple[str, ...]:
    """Names as Python, the C compiler, node, Octave and the files of generated code tell them."""
    words = {*keyword.kwlist, *keyword.softkwlist, *dir(builtins)}
    includes = "".join(f"#include <{name}.h>\n" for name in HEADERS)
    for option in (["-E", "-P"], ["-E", "-dM"]):
        words |= set(re.findall(r"[A-Za-z]\w*", subprocess.run(
            ["cc", *option, "-x", "c", "-"], input=includes, capture_output=True, text=True, check=True).stdout))  # fmt: skip
    asked = "console.log([globalThis, Math, Number, Array].flatMap(it => Object.getOwnPropertyNames(it)).join(' '))"
    words |= set(subprocess.run([str(NODE), "-e", asked], capture_output=True, text=True, check=True).stdout.split())
    with tempfile.TemporaryDirectory() as name:
        words |= set(octave(Path(name), "printf('%s ', [iskeyword(); __list_functions__(); __builtins__()]{:});").split())
    words |= {"await", "class", "function", "let", "yield", "template", "namespace", "operator", "virtual", "co_await", "concept"}
    for path in (
        *HOME.rglob("runtime/**/*"),
        *HOME.glob("emit/*.py"),
        *(HOME.parent / "generated" / "models").glob("*/algebra.py"),
    ):
        if path.is_file() and "__pycache__" not in path.parts:
            words |= set(re.findall(r"[A-Za-z_]\w*", path.read_text(encoding="utf-8")))
    return tuple(sorted(words))


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One page with eight names, of which those that are refused are given others."""
    names, refused = [str(name) for name in rng.choice(pool(), 9, replace=False)], 0
    safe = [f"plain_{place}" for place in range(len(names))]
    with tempfile.TemporaryDirectory() as place:
        home = Path(place)
        page = home / f"{names.pop()}{rng.choice(['', '-2', ' b', '.v2'])}.py"
        while True:
            page.write_text(PAGE.format(*names), encoding="utf-8")
            try:
                derivation.write_page(page, home / "model")
                break
            except vocabulary.PageError as error:
                at = next((at for at, name in enumerate(names) if f"'{name}'" in str(error) or f"{name} is" in str(error)), None)
                if at is None or names[at] == safe[at]:
                    return {"kind": "wrong", "wrong": [f"{names}: {error}"]}
                names[at], refused = safe[at], refused + 1
        return {
            "kind": "page",
            "wrong": compare(ss.load(home / "model"), home, rng, names),
            "names": 8 - refused,
            "refused": refused,
        }


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
        for name, text in of_model(model, language).items():
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
    return results_of_c(out, header.stem, [(name, with_angles(model, it, given), len(found)) for name, it, given, found in calls])


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
