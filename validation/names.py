"""Pages whose quantities bear random names: words, functions and constants of every language, and
those of generated code.

Each page is derived and exported to C, JavaScript and MATLAB under a random name of its own; every
function gives the numbers of Python in each language, or the name is refused by its line. Last
found: a parameter called ``pi`` gave other numbers in MATLAB, ``sin``, ``EOF``, ``INLINE`` and
pages called ``main`` no code that compiles (19cc3e36).
"""

import builtins
import inspect
import keyword
import re
import subprocess
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.derive import folder as derivation
from spragsym.derive import model as vocabulary
from tests.oracles.exported_names import PAGE, compare
from tests.oracles.languages import NODE, octave

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


@cache
def pool() -> tuple[str, ...]:
    """Names as Python, the C compiler, node, Octave and the files of generated code tell them."""
    words = {*keyword.kwlist, *keyword.softkwlist, *dir(builtins)}
    includes = "".join(f"#include <{name}.h>\n" for name in HEADERS)
    for option in (["-E", "-P"], ["-E", "-dM"]):
        words |= set(
            re.findall(
                r"[A-Za-z]\w*",
                subprocess.run(
                    ["cc", *option, "-x", "c", "-"],
                    input=includes,
                    capture_output=True,
                    text=True,
                    check=True,
                ).stdout,
            )
        )
    asked = (
        "console.log([globalThis, Math, Number, Array].flatMap(it => "
        "Object.getOwnPropertyNames(it)).join(' '))"
    )
    words |= set(
        subprocess.run(
            [str(NODE), "-e", asked], capture_output=True, text=True, check=True
        ).stdout.split()
    )
    with tempfile.TemporaryDirectory() as name:
        words |= set(
            octave(
                Path(name), "printf('%s ', [iskeyword(); __list_functions__(); __builtins__()]{:});"
            ).split()
        )
    words |= {
        "await",
        "class",
        "function",
        "let",
        "yield",
        "template",
        "namespace",
        "operator",
        "virtual",
        "co_await",
        "concept",
    }
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
                at = next(
                    (
                        at
                        for at, name in enumerate(names)
                        if f"'{name}'" in str(error) or f"{name} is" in str(error)
                    ),
                    None,
                )
                if at is None or names[at] == safe[at]:
                    return {"kind": "wrong", "wrong": [f"{names}: {error}"]}
                names[at], refused = safe[at], refused + 1
        return {
            "kind": "page",
            "wrong": compare(ss.load(home / "model"), home, rng, names),
            "names": 8 - refused,
            "refused": refused,
        }
