"""JavaScript: one ES module without dependencies, its types and an example."""

from __future__ import annotations

import json
import math

from .. import Material, Target, runtime
from . import algebra, kernel

#: Parts of the module in order, between which the generated text stands.
_PARTS = ("numbers", "equilibria", "motion", "polynomials", "folds")
_FILES = ("spragsym.mjs", "spragsym.d.ts", "spragsym.d.mts", "example.mjs")


def render(material: Material) -> dict[str, str]:
    """The module, its declarations, and an example."""
    words = {
        "header": material.header.replace("``", "`"),
        "source": material.digest[:16],
        "base": json.dumps(dict(material.base_values)),
        "names": json.dumps(list(material.parameters)),
        "ranges": _ranges(material),
        "algebra": _algebra(material),
        "kernel": kernel.render(material),
        "declarations": "".join(algebra.declaration(it) for it in material.algebra.values()),
    }
    texts = {name: runtime(__file__, name) for name in _FILES}
    texts["spragsym.mjs"] += "\n" + "\n".join(runtime(__file__, f"{part}.mjs") for part in _PARTS)
    return {name: _spoken(text, words) for name, text in texts.items()}


def _spoken(text: str, words: dict[str, str]) -> str:
    """Put the words in the places that ``@name@`` marks, alone in a comment or not."""
    for name, word in words.items():
        text = text.replace(f"// @{name}@\n", word).replace(f"@{name}@", word)
    return text


def _algebra(material: Material) -> str:
    functions = material.algebra
    defined = "\n".join(algebra.definition(it, material.quantities, f"algebra_{name}") for name, it in functions.items())
    listed = "".join(f"  {name}: algebra_{name},\n" for name in functions)
    return f"{defined}\n/** The generated algebra, by the names that it has in Python. */\nexport const algebra = Object.freeze({{\n{listed}}});\n"


def _ranges(material: Material) -> str:
    """The allowed values of every parameter and of V and d, as JSON; infinite ends are left out."""
    entries = {}
    for name in (*material.parameters, "V", "d"):
        allowed = material.quantities[name].interval
        ends = {"low": allowed.low, "high": allowed.high}
        entries[name] = {key: value for key, value in ends.items() if math.isfinite(value)}
        if math.isfinite(allowed.low):
            entries[name]["open"] = allowed.low_open
    return json.dumps(entries)


TARGET = Target("javascript", "JavaScript", "javascript", render, exported=_FILES)
