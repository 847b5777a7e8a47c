"""MATLAB and Octave: a package folder with a file for each of the model's own functions and for
each namespace, and examples beside it.

A namespace is a class without objects, whose static methods are called
``library.algebra.name(...)``.
"""

import json
import math
import re
import textwrap
from collections.abc import Iterable
from dataclasses import replace

from ...definitions import WIDTH, symbols
from ...expressions import number
from ...quantities import Interval
from .. import Material, ranges, runtime, spoken
from . import algebra, kernel

#: The model's files whose names begin with this are written beside the package folder.
_EXAMPLE = "example_"


def render(material: Material) -> dict[str, str]:
    """The files of the package, and the examples."""
    if material.of_a_page:  # no function or constant of MATLAB ends with an underscore
        material = replace(material, library=f"{material.library}_")
    package = f"+{material.library}"
    own = {
        name: text
        for name, text in material.runtime.get("matlab", {}).items()
        if name.endswith(".m")
    }
    texts = {
        f"{package}/algebra.m": _namespace(
            "algebra",
            "Generated algebra, for arrays of any one size; nested results come one after the "
            "other.",
            map(algebra.definition, material.algebra.values()),
        )
    }
    if material.kernel.routines:
        routines = (
            *kernel.render(material),
            *(
                runtime(__file__, name)
                for name in ("where.m", "larger.m", "smaller.m", "cube_root.m")
            ),
        )
        texts[f"{package}/kernel.m"] = _namespace("kernel", material.kernel.summary, routines)
    if any(not name.startswith(_EXAMPLE) for name in own):
        checks = (
            *(runtime(__file__, name) for name in ("parameters.m", "numbers.m", "shown.m")),
            _ranges(material),
        )
        texts[f"{package}/checks.m"] = _namespace("checks", "Checks of what is given.", checks)
    texts |= {
        f"{package}/{name}": text for name, text in own.items() if not name.startswith(_EXAMPLE)
    }
    texts[f"{package}/Contents.m"] = _contents(material, own)
    texts |= {name: text for name, text in own.items() if name.startswith(_EXAMPLE)}
    return {name: spoken(text, _words(material)) for name, text in texts.items()}


def _namespace(name: str, summary: str, functions: Iterable[str]) -> str:
    """A class of static methods."""
    methods = "\n".join(textwrap.indent(text, "    ") for text in functions)
    head = "\n".join(algebra.comment(f"{name.upper()}  {summary}", ""))
    return f"classdef {name}\n{head}\n  methods (Static)\n{methods}  end\nend\n"


def _words(material: Material) -> dict[str, str]:
    """The texts that replace ``@name@``."""
    return {
        "library": material.library,
        "source": material.digest[:16],
        "names": ", ".join(f"'{name}'" for name in material.parameters),
        **{item.name: number(item.value) for item in material.kernel.constants},
        "base": ", ".join(
            f"'{name}', {json.dumps(value)}" for name, value in material.base_values.items()
        ),
    }


def _contents(material: Material, own: dict[str, str]) -> str:
    """Contents.m, which ``help`` shows on the package."""
    lines = textwrap.wrap(f"{material.summary} {material.header.replace('``', '')}", WIDTH)
    lines.append("")
    for name, text in own.items():
        if not name.startswith(_EXAMPLE):
            first = re.search(r"^%\w+\s+(.*)$", text, re.MULTILINE)
            lines += _listed(f"{name.removesuffix('.m'):18} - {first[1] if first else ''}", 2)
    lines += ["", f"  {material.library}.algebra holds the generated algebra:"]
    for module in material.modules:
        lines += _listed(", ".join(it.name for it in module), 4)
    lines += ["", "  Their arguments:"]
    for name in symbols(material.algebra.values()):
        lines += _listed(f"{name:10} - {material.quantities[name].meaning}", 4)
    if material.kernel.routines:
        lines += ["", *_listed(f"{material.library}.kernel: {material.kernel.summary}", 2)]
    return "".join(f"% {line}".rstrip() + "\n" for line in lines)


def _listed(text: str, indent: int) -> list[str]:
    return textwrap.wrap(
        text, WIDTH, initial_indent=" " * indent, subsequent_indent=" " * (indent + 2)
    )


def _ranges(material: Material) -> str:
    """The function ``range``, which gives the allowed values of each argument of the algebra."""
    alike: dict[str, list[str]] = {}
    for name, allowed in ranges(material).items():
        alike.setdefault(_ends(allowed, material.quantities[name].unit), []).append(f"'{name}'")
    cases = [
        line
        for ends, names in alike.items()
        for line in (*algebra.wrapped(f"    case {{{', '.join(names)}}}"), f"      {ends}")
    ]
    return spoken(runtime(__file__, "range.m"), {"cases": "\n".join(cases).strip()})


def _ends(allowed: Interval, unit: str) -> str:
    ends = [_number(allowed.low), _number(allowed.high)]
    text = f"{'(' if allowed.low_open else '['}{', '.join(ends)}{')' if allowed.high_open else ']'}"
    said = ": angles are radians" if unit == "rad" else ""
    return (
        f"ends = [{', '.join(ends)}, {allowed.low_open:d}, {allowed.high_open:d}]; text = "
        f"'{text}'; remedy = '{said}';"
    )


def _number(value: float) -> str:
    return "pi" if value == math.pi else f"{value:g}".replace("inf", "Inf")
