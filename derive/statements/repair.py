"""The smallest edits of a printed tree that give it the values it ought to have.

Every part of a tree has a value at each sample, and, by inverting the tree from its root, the value
that it would need for the whole to be right: an edit is right where it gives a part what it needs.
Numbers propose only; what is proposed is proved elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from .tree import FUNCTIONS, ONE, ZERO, Node, nodes, number_of, with_part

Values: TypeAlias = npt.NDArray[np.float64]
Path: TypeAlias = tuple[int, ...]
#: Relative gap of two values that count as the same at a sample.
CLOSE = 1e-8
#: What each kind of edit costs; two edits add up.
COST = {
    "sign": 1.0,
    "index": 1.0,
    "number": 1.05,
    "exponent": 1.1,
    "function": 1.1,
    "renaming": 1.1,
    "missing term": 1.2,
    "extra term": 1.2,
    "missing factor": 1.25,
    "extra factor": 1.25,
    "symbol": 1.5,
}
#: Added for every symbol beyond the first that an edit brings in, and for every level of brackets.
PER_SYMBOL, PER_LEVEL = {"missing term": 0.1, "missing factor": 0.3, "number": 0.0}, 0.001
#: Of pairs, so many first edits are followed.
MOST_FIRST = 400
_SWAPS = {"sin": ("cos",), "cos": ("sin",), "sinh": ("cosh",), "cosh": ("sinh",)}


@dataclass(frozen=True)
class Edit:
    """A part of the print, and what stands there instead."""

    kind: str
    at: tuple[int, int]
    old: Node
    new: Node
    cost: float
    also: tuple[tuple[int, int], ...] = ()  #: the same edit at further places


@dataclass(frozen=True)
class Repair:
    """A tree after edits."""

    tree: Node
    edits: tuple[Edit, ...]

    @property
    def cost(self) -> float:
        """The costs of its edits, added."""
        return sum(edit.cost for edit in self.edits)


@dataclass(frozen=True)
class Pool:
    """What an edit may bring in: values of names, and groups of names of one dimension."""

    values: Mapping[str, Values]
    kinds: Mapping[str, object]  #: equal where two names have the same dimension
    angles: Sequence[str] = ()

    @cached_property
    def alone(self) -> tuple[list[Node], Values]:
        """Every name, its opposite, and one over both, with their values."""
        ways: list[tuple[Node, Values]] = []
        with np.errstate(all="ignore"):
            for name, value in self.values.items():
                one = Node("symbol", value=name)
                ways += [(one, value), (Node("div", (ONE, one)), 1 / value)]
        ways += [(Node("neg", (part,)), -value) for part, value in ways]
        return [part for part, _ in ways], np.array([value for _, value in ways])

    @cached_property
    def logarithms(self) -> tuple[list[tuple[Node, Values]], Values]:
        """Names that are 0 nowhere, and the logarithms of their sizes."""
        parts = [(Node("symbol", value=name), value) for name, value in self.values.items()]
        for name in self.angles:
            angle = (Node("symbol", value=name),)
            for way, function in (("sin", np.sin), ("cos", np.cos)):
                parts.append((Node("call", angle, way), function(self.values[name])))
        parts = [(atom, it) for atom, it in parts if np.isfinite(it).all() and it.all()]
        return parts, np.array([np.log(np.abs(it)) for _, it in parts])

    def renaming(self, old: str, new: str) -> str:
        """The kind of edit that puts one name in the place of another."""
        if stem(old) == stem(new):
            return "index"
        return "renaming" if self.kinds.get(old) == self.kinds.get(new) else "symbol"


def stem(name: str) -> str:
    """A name without its index."""
    return name.rstrip("0123456789").split("_")[0]


def same(one: Values, other: Values) -> bool:
    """Whether values agree at every sample, to rounding, and are finite."""
    first, second = float(one[0]), float(other[0])
    if not abs(first - second) <= CLOSE * max(abs(first), abs(second)):
        return False
    size = np.maximum(np.abs(one), np.abs(other))
    return bool(np.isfinite(size).all() and (np.abs(one - other) <= CLOSE * size).all())


def evaluated(tree: Node, known: Mapping[str, Values]) -> Values:
    """The value of a tree at every sample."""
    return _values(tree, known, (), {})


def _values(
    tree: Node, known: Mapping[str, Values], path: Path, found: dict[Path, Values]
) -> Values:
    parts = [_values(part, known, (*path, place), found) for place, part in enumerate(tree.args)]
    with np.errstate(all="ignore"):
        match tree.kind:
            case "number":
                value = np.full_like(next(iter(known.values())), number_of(tree))
            case "symbol":
                value = known[tree.value]
            case "add":
                value = sum(parts[1:], parts[0])
            case "neg":
                value = -parts[0]
            case "mul":
                value = np.prod(parts, axis=0)
            case "div":
                value = parts[0] / parts[1]
            case "pow":
                value = parts[0] ** parts[1]
            case _ if tree.value == "Tuple":
                value = np.array(parts)
            case _ if tree.value == "Piecewise":
                held = [pair[1] != 0 for pair in parts]
                value = np.select(held, [pair[0] for pair in parts], np.nan)
            case _ if tree.value in _RELATIONS:
                value = 1.0 * _RELATIONS[tree.value](*parts)
            case _:
                value = _NUMERIC[tree.value](parts[0])
    found[path] = value
    return value


_RELATIONS = {
    "Lt": np.less,
    "Le": np.less_equal,
    "Gt": np.greater,
    "Ge": np.greater_equal,
    "Ne": np.not_equal,
    "Eq": np.equal,
    "And": np.multiply,
}
_NUMPY = {"Abs": "abs", "asin": "arcsin", "acos": "arccos", "atan": "arctan"}
_NUMERIC = {
    name: (lambda x: 1 / np.tan(x)) if name == "cot" else getattr(np, _NUMPY.get(name, name))
    for name in FUNCTIONS
}


def _needs(tree: Node, values: Mapping[Path, Values], target: Values) -> dict[Path, Values]:
    """What each part would have to be, where the tree can be inverted down to it."""
    found: dict[Path, Values] = {}

    def down(part: Node, path: Path, need: Values) -> None:
        found[path] = need
        own = [values[(*path, place)] for place in range(len(part.args))]
        with np.errstate(all="ignore"):
            match part.kind:
                case "neg":
                    needs: list[Values | None] = [-need]
                case "add":
                    whole = values[path]
                    needs = [need - (whole - value) for value in own]
                case "mul":
                    needs = [
                        need / np.prod(own[:place] + own[place + 1 :], axis=0)
                        for place in range(len(own))
                    ]
                case "div":
                    needs = [need * own[1], own[0] / need]
                case "pow":
                    root = np.abs(need) ** (1 / own[1])
                    needs = [np.copysign(root, own[0]), np.log(need) / np.log(own[0])]
                case "call" if part.value == "sqrt":
                    needs = [need**2]
                case "call" if part.value == "exp":
                    needs = [np.log(need)]
                case _:
                    needs = [None] * len(own)
        for place, below in enumerate(needs):
            if below is not None and np.isfinite(below).all():
                down(part.args[place], (*path, place), below)

    down(tree, (), target)
    return found


def repairs(tree: Node, target: Values, pool: Pool, pairs: bool = False) -> list[Repair]:
    """Repairs by one edit, or by ``pairs`` of them, the most likely first."""
    found = [] if pairs else _singles(tree, target, pool)
    for first in _firsts(tree, pool) if pairs else ():
        found += [
            Repair(second.tree, (*first.edits, *second.edits))
            for second in _singles(first.tree, target, pool, deep=False)
        ]
    trees: dict[Node, Repair] = {}
    for repair in sorted(found, key=lambda it: it.cost):
        trees.setdefault(_bare(repair.tree), repair)
    return list(trees.values())


def _bare(tree: Node) -> Node:
    """A tree without places, by which repairs are compared."""
    return Node(tree.kind, tuple(map(_bare, tree.args)), tree.value)


def _parts(tree: Node, path: Path = ()) -> Iterator[tuple[Path, Node, Node | None]]:
    yield path, tree, None
    for place, part in enumerate(tree.args):
        for below, inner, above in _parts(part, (*path, place)):
            yield below, inner, tree if above is None else above


def _firsts(tree: Node, pool: Pool) -> list[Repair]:
    """First ones of two edits: those whose new part is among few."""
    found = []
    for path, part, above in _parts(tree):
        found += [Repair(with_part(tree, path, it.new), (it,)) for it in _local(part, above, pool)]
        if above is not None and above.kind == "add" and len(above.args) > 1:
            gone = Edit("extra term", part.at, part, ZERO, COST["extra term"])
            found.append(Repair(with_part(tree, path, ZERO), (gone,)))
    return sorted(found, key=lambda it: it.cost)[:MOST_FIRST]


def _is_unsure(tree: Node, path: Path) -> bool:
    """Whether a part stands in a power, of which the inverse has two signs or none."""
    for place in path:
        if tree.kind == "pow":
            return True
        tree = tree.args[place]
    return False


def _local(part: Node, above: Node | None, pool: Pool, every: bool = False) -> list[Edit]:
    """Edits of one part whatever it would need; names of another dimension if ``every``."""

    def edit(kind: str, new: Node) -> Edit:
        return Edit(kind, part.at, part, new, COST[kind])

    found = []
    if above is None or above.kind in ("add", "call") or part.kind == "add":
        new = part.args[0] if part.kind == "neg" else Node("neg", (part,), at=part.at)
        found.append(edit("sign", new))
    if part.kind == "symbol":
        found += [
            edit(pool.renaming(part.value, name), Node("symbol", value=name, at=part.at))
            for name in pool.values
            if name != part.value and (every or pool.renaming(part.value, name) != "symbol")
        ]
    if part.kind == "number" and part.value != "pi" and above is not None:
        kind = "exponent" if above.kind == "pow" and above.args[1] is part else "number"
        found += [
            edit(kind, Node("number", value=value, at=part.at))
            for value in ("1", "2", "3", "4")
            if value != part.value
        ]
    if part.kind == "call":
        found += [
            edit("function", Node("call", part.args, name, part.at))
            for name in _SWAPS.get(part.value, ())
        ]
    return found


def _singles(tree: Node, target: Values, pool: Pool, deep: bool = True) -> list[Repair]:
    values: dict[Path, Values] = {}
    _values(tree, pool.values, (), values)
    needs = _needs(tree, values, target)
    found: list[Repair] = []
    table = np.array(list(pool.values.values()))
    names = list(pool.values)
    with np.errstate(all="ignore"):
        for path, part, above in _parts(tree):
            if path in needs:
                edits = _fitting(part, above, values[path], needs[path], pool, (names, table), deep)
                found += [Repair(with_part(tree, path, it.new), (it,)) for it in edits]
            if path not in needs or _is_unsure(tree, path):  # each edit is tried
                for it in _local(part, above, pool, every=True):
                    other = with_part(tree, path, it.new)
                    if same(evaluated(other, pool.values), target):
                        found.append(Repair(other, (it,)))
        if deep:
            found += _everywhere(tree, target, pool)
    return [
        Repair(it.tree, (_dearer(it.edits[0], tree),))
        for it in found
        if not same(evaluated(it.tree, pool.values), values[()])
    ]


def _dearer(edit: Edit, tree: Node) -> Edit:
    """The cost of an edit with the depth at which it stands."""
    depth = next((len(p) for p, part, _ in _parts(tree) if part is edit.old), 0)
    return replace(edit, cost=edit.cost + PER_LEVEL * depth)


def _everywhere(tree: Node, target: Values, pool: Pool) -> list[Repair]:
    """One name in the place of another wherever it stands."""
    counted: dict[str, int] = {}
    for part in nodes(tree):
        if part.kind == "symbol":
            counted[part.value] = counted.get(part.value, 0) + 1
    found = []
    for old, count in counted.items():
        for new in pool.values if count > 1 else ():
            kind = pool.renaming(old, new)
            if new != old and kind != "symbol":
                swapped = {**pool.values, old: pool.values[new]}
                if same(evaluated(tree, swapped), target):
                    one = Node("symbol", value=new)
                    first, *others = (part for part in nodes(tree) if part.value == old)
                    also = tuple(part.at for part in others)
                    edit = Edit("renaming", first.at, first, one, COST["renaming"], also)
                    found.append(Repair(_renamed(tree, old, new), (edit,)))
    return found


def _renamed(tree: Node, old: str, new: str) -> Node:
    if tree.kind == "symbol":
        return Node("symbol", value=new, at=tree.at) if tree.value == old else tree
    return Node(tree.kind, tuple(_renamed(it, old, new) for it in tree.args), tree.value, tree.at)


def _fitting(
    part: Node,
    above: Node | None,
    value: Values,
    need: Values,
    pool: Pool,
    known: tuple[list[str], Values],
    deep: bool,
) -> list[Edit]:
    """Edits that give a part what it needs."""
    found: list[Edit] = []

    def edit(kind: str, new: Node, further: float = 0.0) -> None:
        found.append(Edit(kind, part.at, part, new, COST[kind] + further))

    names, table = known
    if same(need, -value):
        edit("sign", part.args[0] if part.kind == "neg" else Node("neg", (part,), at=part.at))
    if part.kind == "symbol":
        for place in np.flatnonzero(np.abs(table[:, 0] - need[0]) <= CLOSE * abs(need[0])):
            if not same(table[place], need):
                continue
            kind = pool.renaming(part.value, names[place])
            edit(kind, Node("symbol", value=names[place], at=part.at))
    plain = part.kind == "number" and part.value != "pi"
    if plain and (number := _rational(need)) is not None:
        is_power = above is not None and above.kind == "pow" and above.args[1] is part
        edit("exponent" if is_power else "number", _number(number))
    if part.kind == "call":
        for name in _SWAPS.get(part.value, ()):
            swapped = Node("call", part.args, name, part.at)
            if same(evaluated(swapped, pool.values), need):
                edit("function", swapped)
    if part.kind in ("symbol", "call") and (value > 0).all() and (need > 0).all():
        power = _rational(np.log(need) / np.log(value))
        if power is not None and power not in (0, 1) and power.denominator <= 2:
            edit("exponent", Node("pow", (part, _number(power)), at=part.at))
    if part.kind == "pow" and same(need, evaluated(part.args[0], pool.values)):
        edit("exponent", part.args[0])
    if above is not None and above.kind == "add":
        scale = np.abs(value) + np.abs(need)
        if (np.abs(need) <= CLOSE * scale).all():
            edit("extra term", ZERO)
    if above is not None and above.kind in ("mul", "div") and same(need, np.ones_like(need)):
        edit("extra factor", ONE)
    if above is None or above.kind not in ("mul", "neg", "div"):
        ratio = need / value
        if not same(need, -value) and (fit := monomial(ratio, part, pool, deep)) is not None:
            size = len([it for it in nodes(fit) if it.kind == "symbol"])
            simple = fit.kind == "number"
            new = _times(part, fit)
            kind = "number" if simple else "missing factor"
            edit(kind, new, PER_SYMBOL[kind] * max(size - 1, 0))
    if part.kind == "add" or above is None or above.kind not in ("add", "neg"):
        lost = need - value
        if (fit := monomial(lost, part, pool, deep)) is not None:
            size = len([it for it in nodes(fit) if it.kind == "symbol"])
            args = part.args if part.kind == "add" else (part,)
            new = Node("add", (*args, fit), at=part.at)
            edit("missing term", new, PER_SYMBOL["missing term"] * max(size - 1, 0))
    return found


def _rational(values: Values) -> Fraction | None:
    """The small fraction that values are at every sample."""
    if not np.isfinite(values).all() or not same(values, np.full_like(values, values[0])):
        return None
    near = Fraction(float(values[0])).limit_denominator(48)
    return near if near and abs(near) <= 200 and same(values, np.full_like(values, near)) else None


def _number(value: Fraction) -> Node:
    size = Node("number", value=str(abs(value.numerator)))
    if value.denominator != 1:
        size = Node("div", (size, Node("number", value=str(value.denominator))))
    return Node("neg", (size,)) if value < 0 else size


def monomial(values: Values, near: Node, pool: Pool, deep: bool = True) -> Node | None:
    """The product of powers of names and functions that has these values, by logarithms."""
    if not np.isfinite(values).all() or not values.all():
        return None
    if (number := _rational(values)) is not None:
        return _number(number)
    parts, table = pool.alone
    near_first = np.abs(table[:, 0] - values[0]) <= CLOSE * abs(values[0])
    for place in np.flatnonzero(near_first):
        if same(values, table[place]):
            return parts[place]
    if not deep:
        return None
    calls = [it for it in dict.fromkeys(map(_bare, nodes(near))) if it.kind == "call"]
    known, logarithms = pool.logarithms
    calls = [it for it in calls if it.value != "Abs" and it not in [atom for atom, _ in known]]
    more = [(atom, evaluated(atom, pool.values)) for atom in calls]
    more = [(atom, it) for atom, it in more if np.isfinite(it).all() and it.all()]
    atoms = known + more
    if len(atoms) + 1 >= len(values):
        return None
    rows = np.array([*logarithms, *(np.log(np.abs(it)) for _, it in more), np.ones_like(values)]).T
    powers, *_ = np.linalg.lstsq(rows, np.log(np.abs(values)), rcond=None)
    halves = np.round(2 * powers[:-1]) / 2
    if np.abs(halves).max(initial=0) > 4 or np.count_nonzero(halves) > 7:
        return None
    product = np.ones_like(values)
    for (_, value), power in zip(atoms, halves, strict=True):
        if power:
            product = product * (value**power if power == int(power) else np.abs(value) ** power)
    factor = _rational(values / product)
    if factor is None:
        return None
    above = [_powered(atom, p) for (atom, _), p in zip(atoms, halves, strict=True) if p > 0]
    below = [_powered(atom, -p) for (atom, _), p in zip(atoms, halves, strict=True) if p < 0]
    if abs(factor) != 1 or not above:
        above = [_number(abs(factor)), *above]
    whole = above[0] if len(above) == 1 else Node("mul", tuple(above))
    if below:
        whole = Node("div", (whole, below[0] if len(below) == 1 else Node("mul", tuple(below))))
    return Node("neg", (whole,)) if factor < 0 else whole


def _times(part: Node, factor: Node) -> Node:
    """A part times a factor, which of a quotient joins the denominator if it is below 1."""
    if factor.kind != "div" or factor.args[0] != ONE:
        return Node("mul", (factor, part), at=part.at)
    above, below = part.args if part.kind == "div" else (part, None)
    below = factor.args[1] if below is None else Node("mul", (below, factor.args[1]))
    return Node("div", (above, below), at=part.at)


def _powered(atom: Node, power: float) -> Node:
    return atom if power == 1 else Node("pow", (atom, _number(Fraction(power))))
