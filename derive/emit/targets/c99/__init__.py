"""C99: the algebra, the kernel for one point and for blocks of points, and the motion; no allocation, no global state."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping

from ...function import Function
from ...language import Kinds, Routine, Source
from .. import Material, Target, runtime
from . import algebra, cost, kernel, wide

#: Functions whose cost stands at the head of the source.
_TABLE = (
    "spragsym_prepare", "spragsym_equilibria", "spragsym_equilibria_batch", "spragsym_step",
    "balance", "guesses", "at_root", "runge_kutta",
)  # fmt: skip
_FILES = ("spragsym.h", "spragsym.c", "Makefile", "main.c")


def render(material: Material) -> dict[str, str]:
    """The header, the source, and an example with its makefile."""
    texts = {name: runtime(__file__, name) for name in _FILES}
    known = material.algebra
    used = _called(material, known)
    statics = [
        algebra.static(f"algebra_{name}", known[name]) for name in (*material.public, *sorted(used - set(material.public)))
    ]
    public = [known[name] for name in material.public]
    parts = {
        "algebra": "\n".join(item.text for item in statics),
        "arithmetic": _arithmetic(material),
        "kernel": _kernel(material, known),
        "wide": wide.render(material),
        "wrappers": "\n".join(algebra.wrapper(function) for function in public),
        "prototypes": "".join(algebra.prototype(function, material.quantities) for function in public),
    }
    source = _filled(texts["spragsym.c"], parts)
    counted = cost.costs(texts["spragsym.h"] + source, {item.name: item.operations for item in statics})
    words = {f"cost:{name}": cost.describe(value) for name, value in counted.items()}
    words["block"] = str(cost.constants(source)["BLOCK"])
    words["table"] = "\n".join(f" * - {name}: {words[f'cost:{name}']}" for name in _TABLE)
    words["source"] = material.digest[:16]
    words["header"] = textwrap.fill(material.header.replace("``", ""), 118, subsequent_indent=" * ")
    texts["spragsym.h"] = _filled(texts["spragsym.h"], parts)
    texts["spragsym.c"] = source
    return {name: _spoken(text, words) for name, text in texts.items()}


def _spoken(text: str, words: Mapping[str, str]) -> str:
    """Put the words in the places that ``@name@`` marks."""
    for name, word in words.items():
        text = text.replace(f"@{name}@", word)
    return text


def _filled(text: str, parts: Mapping[str, str]) -> str:
    """Put emitted text in the places that ``/* @name@ */`` marks."""
    for name, part in parts.items():
        text = text.replace(f"/* @{name}@ */", part)
    return text


def _called(material: Material, known: Mapping[str, Function]) -> set[str]:
    kinds = Kinds(material.kernel)
    return {name for it in material.kernel.routines.values() for name in kinds.calls(it) if name in known}


def _kernel(material: Material, known: Mapping[str, Function]) -> str:
    source = material.kernel
    kinds = Kinds(source)
    numbers = {item.name: (item.value, item.comment) for item in source.constants}
    numbers |= {name: (value, "") for name, value in material.counts.items()}
    return "\n".join([
        kernel.constants(numbers),
        *(kernel.structure(record) for record in source.records.values()),
        *(kernel.routine(it, kinds, "algebra_") for it in _in_order(source)),
    ])  # fmt: skip


def _arithmetic(material: Material) -> str:
    """Double-double numbers."""
    source = material.arithmetic
    if source is None:
        raise ArithmeticError("the C target needs double-double arithmetic")
    return "\n".join([
        kernel.constants({item.name: (item.value, item.comment) for item in source.constants}),
        *(kernel.structure(record) for record in source.records.values()),
        *(kernel.routine(it, Kinds(source), "") for it in _in_order(source)),
    ])  # fmt: skip


def _in_order(source: Source) -> list[Routine]:
    """Routines, each after those that it calls."""
    kinds = Kinds(source)
    ordered: dict[str, Routine] = {}

    def place(name: str) -> None:
        if name in ordered:
            return
        for called in kinds.calls(source.routines[name]):
            if called in source.routines:
                place(called)
        ordered[name] = source.routines[name]

    for name in source.routines:
        place(name)
    return list(ordered.values())


TARGET = Target("c", "C99", "c", render, exported=_FILES)
