"""Julia: a module of plain functions of any number type, and for a page problems of
BifurcationKit and ModelingToolkit made of them.
"""

import re
import textwrap
from collections.abc import Iterable

from ...definitions import WIDTH, Definition, nested, ported
from .. import Angles, Material, MotionMaterial, Start, runtime, spoken, taken

#: Branches are continued from starts.
CONTINUES = True
#: Words of the language, and modules that the files use or that are always there.
RESERVED = frozenset(
    re.findall(
        r"\w+",
        "abstract baremodule base begin bifurcationkit break catch const continue core do else "
        "elseif end export false finally for function global if import let linearalgebra local "
        "macro main model modelingtoolkit module mutable primitive public quote return "
        "spragsym_problem struct true try type using where while",
    )
)
#: Borders of a regime: the margin of each kind, positive inside.
_MARGINS = {
    "gap": "(1 - 2 * {mode}) * border[{border}]",
    "face": "(1 - 2 * {mode}) * border[{border}]",
    "slip": "{mode} == 0 ? one({mode}) : {mode} * border[{border}]",
    "ahead": "{mode} == 0 ? grips[{grip}] : one({mode})",
    "behind": "{mode} == 0 ? grips[{grip}] : one({mode})",
}


def render(material: Material) -> dict[str, str]:
    """The module; of a page also the problems."""
    library, motion = material.library, material.motion
    functions = material.algebra
    names = dict.fromkeys(
        name for function in functions.values() for name in taken(function, material.angles)
    )
    words = {
        "library": library,
        "summary": _plain(material.summary),
        "header": _comment(material.header.replace("``", "`")),
        "meanings": "\n".join(
            _comment(f"{name}: {material.quantities[name].meaning}") for name in names
        ),
        "exported": _wrapped(f"export {', '.join(functions)}"),
        "algebra": "\n".join(_definition(one, material.angles) for one in functions.values()),
    }
    files = {f"{library}.jl": spoken(runtime(__file__, "module.jl"), words)}
    if motion is not None:
        words |= _problem(material, motion)
        for kind in ("bifurcationkit", "modelingtoolkit"):
            files[f"{library}_{kind}.jl"] = spoken(runtime(__file__, f"{kind}.jl"), words)
    return files


def _expression(text: str) -> str:
    """An expression in Julia; ratios of integers that fit are exact, for numbers of any type."""
    ratio = re.sub(r"\((-?\d{1,18})/(\d{1,18})\)", r"(\1//\2)", text)
    return ported(ratio, {"atan2": "atan"})


def _definition(function: Definition, angles: Angles) -> str:
    names = taken(function, angles)
    given = ", ".join([*names, *(f"{name}=0" for name in function.further)])
    turned = [
        f"    {part} = {turn}({angle})"
        for angle, parts in angles.items()
        if angle in names
        for turn, part in zip(("cos", "sin"), parts[-2:], strict=True)
        if part in function.read
    ]
    said = f"{function.summary} Returns {function.returns}. {function.origin}"
    lines = [
        _comment(said),
        _wrapped(f"function {function.name}({given})"),
        *turned,
        *(_wrapped(f"    {name} = {_expression(value)}") for name, value in function.statements),
        _wrapped(f"    return {nested(function.results, '()', _expression)}"),
        "end",
        "",
    ]
    return "\n".join(lines)


def _comment(text: str) -> str:
    return textwrap.fill(text, WIDTH, initial_indent="# ", subsequent_indent="# ")


def _plain(text: str) -> str:
    return " ".join(text.split())


def _wrapped(line: str) -> str:
    """A statement on as many lines as it needs: broken after a comma or an operator, by which Julia
    knows that it goes on.
    """
    lines, indent = [""], " " * (len(line) - len(line.lstrip()) + 4)
    for part in re.split(r"(?<=[-,+*/=]) ", line):
        joined = f"{lines[-1]} {part}" if lines[-1] else part
        if len(joined) > WIDTH and re.search(r"[-,+*/=]$", lines[-1]):
            lines.append(f"{indent}{part}")
        else:
            lines[-1] = joined
    return "\n".join(lines)


# ------------------------------------------------------------------------------------------------
# problems


def _problem(material: Material, motion: MotionMaterial) -> dict[str, str]:
    """Words of the files of problems."""
    n, names = len(motion.accelerations), taken(material.algebra["regime_rhs"], material.angles)
    states, numbers = names[: 2 * n], names[2 * n :]
    modes = numbers[len(motion.given) :]
    values = {name: f"u[{index}]" for index, name in enumerate(states, 1)}
    values |= {name: f"p.{name}" for name in numbers}

    def call(name: str, written: dict[str, str]) -> str:
        given = taken(material.algebra[name], material.angles)
        return f"model.{name}({', '.join(written[one] for one in given)})"

    margins = [
        _MARGINS[edge.kind].format(
            mode=f"p.{modes[edge.place]}",
            border=edge.place + 1,
            grip=2 * edge.row + 1 + (edge.kind == "behind"),
        )
        for edge in motion.borders
    ]
    holds = any(edge.row >= 0 for edge in motion.borders)
    labels = [f'"{edge.label(edge.kind)}"' for edge in motion.borders]
    along = motion.starts[0].along if motion.starts else material.parameters[0]
    followed = names[2 * n + material.parameters.index(along)]
    return {
        "count": str(n),
        "size": str(2 * n),
        "rhs": _wrapped(f"    {call('regime_rhs', values)}").strip(),
        "jacobian": _wrapped(f"    {call('regime_jacobian', values)}").strip(),
        "borders": _wrapped(f"    {call('borders', values)}").strip(),
        "grips": f"\n    grips = {call('grip', values)}" if holds else "",
        "margins": "".join(f"\n        {margin}," for margin in margins),
        "at_borders": f"ContinuousEvent({len(margins)}, at_borders, {_tuple(labels)}), "
        if margins
        else "",
        "record": _tuple(f"{name} = u[{index}]" for index, name in enumerate(states, 1)),
        "along": followed,
        "starts": "".join(
            _start(start, numbers, n, material.parameters) for start in motion.starts
        ),
        "states": _wrapped(f"@variables {' '.join(f'{name}(t)' for name in states)}"),
        "numbers": _wrapped(f"@parameters {' '.join(numbers)}"),
        "symbols": _wrapped(f"    {call('regime_rhs', {name: name for name in names})}").strip(),
        "places": ", ".join(states),
        "given": ", ".join(numbers),
        "equations": "".join(
            f"\n    D({place}) ~ {rate},\n    D({rate}) ~ accelerations[{i}],"
            for i, (place, rate) in enumerate(zip(states[:n], states[n:], strict=True), 1)
        ),
    }


def _tuple(items: Iterable[str]) -> str:
    listed = list(items)
    return f"({', '.join(listed)}{',' if len(listed) == 1 else ''})"


def _start(start: Start, numbers: list[str], n: int, parameters: tuple[str, ...]) -> str:
    """An entry of the table of starts."""
    values = [*(start.values[name] for name in parameters), *map(float, start.mode)]
    listed = _tuple(f"{name} = {value!r}" for name, value in zip(numbers, values, strict=True))
    place = ", ".join(map(repr, [*map(float, start.place), *[0.0] * n]))
    return f"\n    {start.name} = (state = [{place}], parameters = {listed}),"
