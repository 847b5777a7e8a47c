"""C99: the algebra, the kernel if the model has one, and the model's own functions; without
allocation or global state.
"""

import re
import textwrap
from collections.abc import Iterable

from ...definitions import WIDTH
from ...expressions import printed
from ...language import ROUGH, Routine, Source
from .. import Material, beginnings, runtime, spoken, words
from . import algebra, cost, kernel, motion
from .layout import plain


#: Headers of C and of what these include, the example, and beginnings of constants in <unistd.h>.
RESERVED = frozenset(
    re.findall(
        r"\w+",
        "alloca assert complex ctype endian errno f features fenv float inttypes iso646 limits "
        "locale main math pthread r sched setjmp signal stdalign stdarg stdatomic stdbool stddef "
        "stdint stdio stdlib stdnoreturn string strings tgmath threads time uchar unistd w wchar "
        "wctype x",
    )
) | beginnings("\n".join(runtime(motion.__file__, name) for name in motion.PARTS))
#: The library of a page steps in time.
MOVES = True


def render(material: Material) -> dict[str, str]:
    """The header and the source; for a model with an example also that and its makefile."""
    library = material.library
    own = material.runtime.get("c", {})
    example = "main.c"
    definitions = "\n".join(
        text for name, text in sorted(own.items()) if name.endswith(".c") and name != example
    )
    functions = material.algebra
    called = material.kernel.called.union(re.findall(r"\balgebra_(\w+)\(", definitions))
    used = called & functions.keys()
    inside = {f"algebra_{name}": function for name, function in functions.items() if name in used}
    public = [functions[name] for name in material.public]
    declared, stepper = motion.stepper(material, material.motion) if material.motion else ("", "")
    parts = {
        "algebra": "\n".join(map(algebra.static, inside, inside.values())),
        "primitives": runtime(__file__, "kernel.c") if material.kernel.routines else "",
        "kernel": _kernel(material, definitions) if material.kernel.routines else "",
        "declarations": own.get("declarations.h", "") + declared,
        "definitions": definitions,
        "public": "\n".join(
            algebra.public(it, library, material.angles, inside=it.name in used) for it in public
        ),
        "prototypes": "".join(
            algebra.prototype(function, library, material.angles) for function in public
        ),
    }
    names = {"library": library, "LIBRARY": library.upper()}
    lines = {name: part and f"{part}\n" for name, part in parts.items()}
    header, source = (
        spoken(spoken(runtime(__file__, name), lines), names).rstrip() + "\n"
        for name in ("library.h", "library.c")
    )
    said = {
        **_words(material),
        **_costs(header + source, {name: it.operations for name, it in inside.items()}),
    }
    # The operations of a step are not counted: it may be halved any number of times.
    files = {f"{library}.h": header, f"{library}.c": source + stepper}
    if example in own:
        files |= {"Makefile": spoken(runtime(__file__, "Makefile"), names), example: own[example]}
    return {name: spoken(text, said) for name, text in files.items()}


def _words(material: Material) -> dict[str, str]:
    """Words for comments: source and summary of the library, meanings and ranges of quantities."""
    said = {
        "source": material.digest[:16],
        "header": textwrap.fill(material.header.replace("``", ""), WIDTH, subsequent_indent=" * "),
        "summary": textwrap.fill(plain(material.summary), WIDTH, subsequent_indent=" * "),
        "bad": "a null pointer, a NaN or an infinity"
        + ("; of the solver, a parameter out of its range too" if material.kernel.routines else ""),
        "symbols": algebra.symbols(
            (material.algebra[name] for name in material.public),
            material.quantities,
            material.angles,
        ),
    }
    for name, quantity in material.quantities.items():
        within = "in " if quantity.domain[0] in "([{" else ""
        said[f"meaning:{name}"] = plain(quantity.meaning)
        said[f"range:{name}"] = f"{within}{quantity.domain}"
    return said


def _costs(source: str, emitted: dict[str, int]) -> dict[str, str]:
    """Words for comments: the cost of every function, and the integers that the source defines."""
    costs, constants = cost.costs(source, emitted), cost.constants(source)
    said = {f"cost:{name}": cost.describe(value) for name, value in costs.items()}
    return said | {f"constant:{name}": str(value) for name, value in constants.items()}


def _kernel(material: Material, definitions: str) -> str:
    """The kernel's constants and records, and the functions that the definitions call."""
    source = material.both_kernels
    asked = source.routines.keys() & {*words(definitions, r"/\*.*?\*/"), *material.asked}
    numbers = {item.name: (item.value, item.comment) for item in source.constants}
    numbers |= {name: (value, "") for name, value in material.counts.items()}
    return "\n".join(
        [
            kernel.constants(numbers),
            *(kernel.structure(record) for record in source.records.values()),
            *(kernel.routine(it, source) for it in _in_order(source, printed(source, asked))),
        ]
    )


def _in_order(source: Source, routines: Iterable[Routine]) -> list[Routine]:
    """Routines, each after those that it calls."""
    ordered: dict[str, Routine] = {}

    def place(name: str) -> None:
        if name in ordered:
            return
        for called in source.routines[name].calls:
            if called in source.routines and called != ROUGH:
                place(called)
        ordered[name] = source.routines[name]

    for routine in routines:
        place(routine.name)
    return list(ordered.values())
