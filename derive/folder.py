"""A model's folder: modules of plain algebra in Python and ``model.json``; functions that a model before it has are taken from there."""

from __future__ import annotations

import hashlib
import json
import textwrap
from collections.abc import Mapping
from typing import Any

import sympy as sp

from . import laws, linearization, statics
from .emit.function import Module
from .emit.targets.python import algebra
from .emit.targets import runtime
from .emit.targets import python as python_target
from .mechanics import MU, PUSHING, Line, Mechanics
from .pages import Model

#: Text of a function → the model and the module that have it first.
Shared = dict[str, tuple[str, str]]

_WIDTH = 112


def render(model: Model, header: str, shared: Shared | None = None) -> dict[str, str]:
    """The files of a model's folder, by their names.

    With ``shared``, functions that a model before it has are imported from its folder beside this one, and new ones are entered; the
    folder then stands in ``generated/models``. Without, the folder stands alone.
    """
    alone = shared is None
    files = {f"{module.name}.py": _module(model, module, header, shared) for module in modules(model.mechanics)}
    if alone:
        files["_broadcast.py"] = runtime(python_target.__file__, "_broadcast.py").replace("@header@", header)
    digests = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()}
    entries = {**description(model), "files": digests}
    return {**files, "model.json": json.dumps(entries, indent=1, ensure_ascii=False, sort_keys=True) + "\n"}


def modules(model: Mechanics) -> tuple[Module, ...]:
    """What is generated from a page."""
    return tuple(part.module(model) for part in (statics, linearization))


def _module(model: Model, module: Module, header: str, shared: Shared | None) -> str:
    own: list[str] = []
    borrowed: dict[tuple[str, str], list[str]] = {}
    for function in module.functions:
        text = algebra.definition(function, {})
        home = (model.name, module.name) if shared is None else shared.setdefault(text, (model.name, module.name))
        if home == (model.name, module.name):
            own.append(text)
        else:
            borrowed.setdefault(home, []).append(function.name)
    symbols = dict.fromkeys(str(symbol) for function in module.functions for symbol in function.accepted)
    meanings = _meanings(model.mechanics)
    table = "\n".join(textwrap.fill(f"{name} : {meanings[name]}", 110, subsequent_indent="    ") for name in symbols)
    imports = ["from types import ModuleType\n\nimport numpy\n"] if own else []
    local = [f"from {'._broadcast' if shared is None else '..._broadcast'} import Number, broadcasting"] if own else []
    local += [f"from ..{home}.{part} import {', '.join(sorted(names))}" for (home, part), names in sorted(borrowed.items())]
    names = ",\n".join(f'    "{function.name}"' for function in module.functions)
    head = "\n\n".join([
        f'"""{module.summary}\n\n{table}\n\n{textwrap.fill(header, 110)}\n"""',
        "from __future__ import annotations",
        "\n".join([*imports, *local]),
        f"__all__ = [\n{names},\n]",
    ])  # fmt: skip
    return "\n\n\n".join([head, *own]) + "\n"


def _meanings(model: Mechanics) -> Mapping[str, str]:
    """What every argument of the generated functions is."""
    entries: dict[str, str] = {}
    for coordinate in model.page.coordinates:
        entries[str(coordinate.symbol)] = coordinate.meaning
        entries[str(coordinate.rate)] = f"rate of {coordinate.symbol}"
    entries |= {datum.becomes: f"{datum.meaning}, dimensionless" for datum in model.parameters}
    for angle in model.angles:
        entries |= {str(angle.c): f"cosine of {angle.symbol}", str(angle.s): f"sine of {angle.symbol}"}
    for count, line in enumerate(model.lines, 1):
        entries |= {
            str(line.c): f"cosine of the direction of spring {count}, from the mass to its anchor",
            str(line.s): f"sine of the direction of spring {count}",
            str(line.l): f"length of spring {count}",
        }
    return entries | {
        str(MU): "friction coefficient",
        str(PUSHING): "1 in contact, 0 in lift-off",
        str(laws.SIDE): "1 where the belt is ahead, −1 where the mass is",
    }


def description(model: Model) -> dict[str, Any]:
    """``model.json`` without the digests of the files."""
    it = model.mechanics
    of_statics = {str(symbol) for symbol in (*statics.parameters(it), *laws.friction_at_rest(it).free_symbols)}
    return {
        "name": model.name,
        "summary": model.page.summary,
        "drawing": model.docstring,
        "source": hashlib.sha256(model.text.encode()).hexdigest(),
        "units": [{"name": str(unit.symbol), "unit": unit.unit, "meaning": unit.meaning} for unit in model.page.units],
        "coordinates": [
            {"name": str(entry.symbol), "rate": str(entry.rate), "meaning": entry.meaning, "unit": entry.unit}
            for entry in model.page.coordinates
        ],
        "parameters": [
            {
                "name": datum.becomes, "symbol": datum.latex, "meaning": datum.meaning, "unit": "rad" if datum.unit == "rad" else "1",
                "domain": datum.domain, "base": datum.base, "role": "both" if datum.becomes in of_statics else "motion",
                "quantity": str(datum.symbol), "quantity_unit": datum.unit,
            }
            for datum in it.parameters
        ],
        "angles": {str(angle.symbol): [str(angle.c), str(angle.s)] for angle in it.angles},
        "arguments": {
            "statics": [str(symbol) for symbol in statics.arguments(it)],
            "motion": [str(symbol) for symbol in it.arguments],
        },
        "by_parameters": [*(str(symbol) for symbol in statics.parameters(it)), str(MU)],
        "contact": {
            "gap": None if it.gap is None else str(it.gap), "unilateral": it.unilateral, "polynomial": it.polynomial,
        },
        "friction": None if it.slide is None else {"along": str(it.slide), "belt": str(it.belt)},
        "springs": [{"name": f"spring {count}", "chart": _chart(it, line)} for count, line in enumerate(it.lines, 1)],
    }  # fmt: skip


def _chart(model: Mechanics, line: Line) -> list[str] | None:
    """The two coordinates of the spring's first end, if it is at them: dx = a_x − x, dy = a_y − y."""
    for x in model.coordinates:
        for y in model.coordinates:
            steps = [sp.diff(part, symbol) for part in (line.dx, line.dy) for symbol in (x, y)]
            if x != y and steps == [-1, 0, 0, -1]:
                return [str(x), str(y)]
    return None
