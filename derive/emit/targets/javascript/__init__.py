"""JavaScript: one ES module without dependencies, its declarations in TypeScript, and the model's
example if it has one.
"""

import json
import math
import textwrap

from .. import Material, ranges, runtime, spoken
from . import algebra, kernel


def render(material: Material) -> dict[str, str]:
    """The module, its declarations, and the model's example."""
    own = material.runtime.get("javascript", {})
    example = "example"
    parts = [
        text
        for name, text in sorted(own.items())
        if name.endswith(".mjs") and not name.startswith(example)
    ]
    solver = (
        [runtime(__file__, "kernel.mjs"), kernel.render(material)]
        if material.kernel.routines
        else []
    )
    module = [
        runtime(__file__, "library.mjs"),
        *solver,
        *([runtime(__file__, "input.mjs")] if parts else []),
        *parts,
    ]
    words = {**_words(material), "declarations": own.get("declarations.d.ts", "")}
    library = material.library
    texts = {
        f"{library}.mjs": "\n".join(module),
        f"{library}.d.ts": runtime(__file__, "library.d.ts"),
        f"{library}.d.mts": runtime(__file__, "library.d.mts"),
        **{name: text for name, text in own.items() if name.startswith(example)},
    }
    return {name: spoken(text, words) for name, text in texts.items()}


def _words(material: Material) -> dict[str, str]:
    """The texts that replace ``@name@``, or a comment with nothing else in it."""
    functions = material.algebra
    return {
        "library": material.library,
        "summary": textwrap.fill(
            material.summary.replace("*/", "* /"), 121, subsequent_indent=" * "
        ),
        "names_and_errors": textwrap.fill(
            (
                "Names are those of the page; as arguments of functions they end with an "
                "underscore. Functions compute with any numbers: whether parameters are in "
                "RANGES is for the caller to see to."
            )
            if material.of_a_page
            else (
                "Names are those of the Python package and of the C library. The solver throws "
                "at bad input: TypeError for what is no number or has an unknown name, "
                "RangeError for a number out of its range."
            ),
            127,
            subsequent_indent=" * ",
        ),
        "header": material.header.replace("``", "`"),
        "source": material.digest[:16],
        "names": json.dumps(list(material.parameters)),
        "typed_names": ", ".join(f'"{name}"' for name in material.parameters),
        "base": json.dumps(dict(material.base_values)),
        "typed_base": " ".join(f"{name}: number;" for name in material.base_values),
        "ranges": _ranges(material),
        "symbols": algebra.meanings(functions.values(), material.quantities),
        "algebra": "\n".join(map(algebra.definition, functions.values())),
        "members": "".join(algebra.declaration(it) for it in functions.values()),
    }


def _ranges(material: Material) -> str:
    """The ranges of the algebra's arguments as an object, one a line, without infinite ends and
    without arguments that may have any value.
    """
    lines = []
    for name, allowed in ranges(material).items():
        ends: dict[str, float | bool] = {}
        if math.isfinite(allowed.low):
            ends |= {"low": allowed.low, "low_open": allowed.low_open}
        if math.isfinite(allowed.high):
            ends |= {"high": allowed.high, "high_open": allowed.high_open}
        if ends:
            lines.append(f"  {name}: {json.dumps(ends)},\n")
    return "{\n" + "".join(lines) + "}" if lines else "{}"
