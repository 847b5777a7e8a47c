"""The worst-case number of operations of C functions, counted in their text: in every branch, and
in every pass of a loop.
"""

import re
from collections import Counter

#: Calls that are listed by name; ``fabs`` and ``isfinite`` count as one operation each.
LIBM = ("sqrt", "exp", "sin", "cos", "atan")


def costs(source: str, emitted: dict[str, int]) -> dict[str, Counter[str]]:
    """The cost of each function of ``source``; ``emitted`` are the operations of the functions that
    are counted already.
    """
    # A loop over an array counts as many passes as the longest array has that is passed to it.
    named = constants(source) | {"length": 4}
    # The loop over blocks of points is left out: costs are those of one block.
    blocks = re.compile(r"for \(size_t \w+ = 0; \w+ < points; \w+ \+= BLOCK\)")
    source = blocks.sub("", re.sub(r"/\*.*?\*/", "", source, flags=re.DOTALL))
    cost_of: dict[str, Counter[str]] = {name: Counter({name: 1}) for name in LIBM}
    cost_of |= {name: Counter({"operations": 1}) for name in ("fabs", "isfinite")}
    function = re.compile(r"^(?!typedef)[\w *]*?\b(\w+)\([^;{]*\) \{", re.MULTILINE)
    for match in function.finditer(source):
        name, body = match[1], source[match.end() : _closing(source, match.end())]
        if name in emitted:
            cost_of[name] = Counter({"operations": emitted[name]}) + _calls(
                body, {key: cost_of[key] for key in LIBM}
            )
        else:
            cost_of[name] = _block(body, cost_of, named)
    return cost_of


def constants(source: str) -> dict[str, int]:
    """The integers that ``source`` defines, by their names."""
    return {
        name: int(value)
        for name, value in re.findall(r"#define (\w+) (\d+)$", source, re.MULTILINE)
    }


def describe(cost: Counter[str]) -> str:
    """``123 operations, 4 sqrt, 1 cos``."""
    return ", ".join(f"{cost[name]} {name}" for name in ("operations", *LIBM) if cost[name])


def _closing(text: str, start: int) -> int:
    depth = 1
    for position in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[position], 0)
        if not depth:
            return position
    raise ArithmeticError("the C template has a block that does not end")


def _block(text: str, cost_of: dict[str, Counter[str]], constants: dict[str, int]) -> Counter[str]:
    total: Counter[str] = Counter()
    counted = re.compile(r"for \(int \w+ = \w+; \w+ < (\w+); \w+\+\+\) \{")
    while loop := counted.search(text):
        end = _closing(text, loop.end())
        once = _block(text[loop.end() : end], cost_of, constants)
        passes = int(loop[1]) if loop[1].isdigit() else constants[loop[1]]
        total += Counter({name: passes * count for name, count in once.items()})
        text = text[: loop.start()] + text[end + 1 :]
    if re.search(r"\b(for|while|do|goto)\b", text):
        raise ArithmeticError("the C template has a loop whose passes can't be counted")
    operator = re.compile(r"(?<=\s)(?:[-+*/<>]|[<>]=|[-+*/]=)(?=\s)")
    return total + Counter({"operations": len(operator.findall(text))}) + _calls(text, cost_of)


def _calls(text: str, cost_of: dict[str, Counter[str]]) -> Counter[str]:
    call = re.compile(r"\b([a-z]\w*)\(")
    return sum((cost_of.get(name, Counter()) for name in call.findall(text)), Counter())
