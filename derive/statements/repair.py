"""The smallest edits of a printed tree that give it the values it ought to have.

An edit either takes one of a few parts in the place of another, and then the values of the whole
with each of them are found from the leaves up, all at once; or what it brings in is open, a number,
a factor, a term: then each part has the value that it would need for the whole to be right, by
inverting the tree from its root, and what is missing is a product of powers whose logarithms fit.
Values of equal parts of trees are found once. Numbers propose only; what is proposed is proved
elsewhere.
"""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp
from sympy.abc import x

from .tree import (
    FUNCTIONS,
    ONE,
    RELATIONS,
    ZERO,
    Node,
    joined,
    leaf,
    minus,
    nodes,
    number_of,
    renamed,
    symbols,
    with_part,
)

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
    "bracket": 1.1,
    "renaming": 1.1,
    "missing term": 1.2,
    "extra term": 1.2,
    "missing factor": 1.25,
    "extra factor": 1.25,
    "symbol": 1.5,
}
#: Samples at which edits are tried before all.
SCREEN = slice(0, 8, 2)


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
    further: float = 0.0  #: where it asks for more than its edits

    @property
    def cost(self) -> float:
        """The costs of its edits, added."""
        return sum(edit.cost for edit in self.edits) + self.further


@dataclass(frozen=True)
class Pool:
    """Expressions that an edit may bring in: values of names, and groups of names of one
    dimension.
    """

    values: Mapping[str, Values]
    kinds: Mapping[str, object]  #: equal where two names have the same dimension
    angles: Sequence[str] = ()

    def renaming(self, old: str, new: str) -> str:
        """The kind of edit that puts one name in the place of another."""
        if stem(old) == stem(new):
            return "index"
        return "renaming" if self.kinds.get(old) == self.kinds.get(new) else "symbol"


def stem(name: str) -> str:
    """A name without its index, or a derivative without what it is by."""
    if name.startswith("diff("):
        return name.rpartition(",")[0]
    return name.rstrip("0123456789").split("_")[0]


def same(one: Values, other: Values) -> bool:
    """Whether values agree at every sample, to rounding, and are finite."""
    first, second = float(one[0]), float(other[0])
    if not abs(first - second) <= CLOSE * max(abs(first), abs(second)):
        return False
    size = np.maximum(np.abs(one), np.abs(other))
    return bool(np.isfinite(size).all() and (np.abs(one - other) <= CLOSE * size).all())


def same_but_for_constant(one: Values, other: Values) -> bool:
    """Whether the difference is that in the other state of every pair with the same parameters."""
    gap, size = one - other, np.abs(one) + np.abs(other)
    return bool((np.abs(gap[::2] - gap[1::2]) <= CLOSE * size[::2]).all())


# ---------------------------------------------------------------------------------------- values


#: Operations on arrays by their names, functions and relations by those of SymPy's.
_NUMERIC = {
    **{name: sp.lambdify(x, of(x), "numpy") for name, of in FUNCTIONS.items()},
    **{name: getattr(operator, name.lower()) for name in RELATIONS},
    "add": lambda *parts: functools.reduce(operator.add, parts),
    "neg": operator.neg,
    "mul": lambda *parts: functools.reduce(operator.mul, parts),
    "div": operator.truediv,
    "pow": operator.pow,
    "max": lambda *parts: functools.reduce(np.maximum, parts),
    "min": lambda *parts: functools.reduce(np.minimum, parts),
    "And": lambda *parts: functools.reduce(np.logical_and, parts),
    "Tuple": lambda *parts: np.array(np.broadcast_arrays(*parts)),
    "Piecewise": lambda *pairs: np.select(
        [holds != 0 for _, holds in pairs], [value for value, _ in pairs], np.nan
    ),
}


def _applied(tree: Node, parts: Sequence[Values]) -> Values:
    """The values of a tree that is no leaf from those of its parts, any of which may be many."""
    return _NUMERIC[tree.operation](*parts)


class Numbers:
    """Values of trees at samples, those of a part that trees share once."""

    def __init__(self, known: Mapping[str, Values]) -> None:
        self.known = known
        self.size = len(next(iter(known.values())))
        self.found: dict[int, tuple[Node, Values]] = {}

    def of(self, tree: Node) -> Values:
        """The values of a tree."""
        if tree.kind == "symbol":
            return self.known[tree.value]
        kept = self.found.get(id(tree))
        if kept is None:
            if tree.kind == "number":
                value = np.full(self.size, number_of(tree))
            else:
                value = _applied(tree, [self.of(part) for part in tree.args])
            kept = self.found[id(tree)] = tree, value
        return kept[1]


def evaluated(tree: Node, known: Mapping[str, Values]) -> Values:
    """The value of a tree at every sample."""
    with np.errstate(all="ignore"):
        return Numbers(known).of(tree)


#: Number of a target, place of a part, and an edit of that part.
Proposal: TypeAlias = tuple[int, Path, Edit]
#: A part, where it stands, what is above it, its values and what it needs.
Place: TypeAlias = tuple[Path, Node, Node | None, Values, Values]


# ------------------------------------------------------------------------------ one part of a few


def _others(part: Node, above: Node | None, pool: Pool) -> list[Edit]:
    """Edits of a part that put one of a few others in its place."""
    found: list[Edit] = []

    def edit(kind: str, new: Node, further: float = 0.0) -> None:
        found.append(Edit(kind, part.at, part, new, COST[kind] + further))

    outer = "" if above is None else above.kind
    if outer in ("", "add", "call") or part.kind == "add":
        edit("sign", part.args[0] if part.kind == "neg" else minus(part))
    if part.kind == "symbol":
        for name in pool.values:
            if name != part.value:
                edit(pool.renaming(part.value, name), leaf(name, part.at))
    if part.kind == "number" and part.value != "pi" and above is not None:
        # Numbers and powers that an edit tries before what it brings in is open.
        for value in ("1", "2", "3", "4"):
            if value != part.value:
                edit(_number_kind(part, above), Node("number", value=value, at=part.at))
    swaps = {"sin": ("cos",), "cos": ("sin",), "sinh": ("cosh",), "cosh": ("sinh",)}
    for name in swaps.get(part.value, ()) if part.kind == "call" else ():
        edit("function", Node("call", part.args, name, part.at))
    if part.kind in ("symbol", "call", "add"):
        for power in (*map(Fraction, ("2", "3", "-1", "1/2")),):
            edit("exponent", Node("pow", (part, _number(power)), at=part.at))
    if part.kind == "pow":
        edit("exponent", part.args[0], 0.1)  # a power is seldom lost
    if other := _other_bracket(part):
        edit("bracket", other)
    if outer == "add":
        edit("extra term", ZERO)
    if outer in ("mul", "div"):
        edit("extra factor", ONE)
    return found


def _other_bracket(part: Node) -> Node | None:
    """(a + b)² for a + b², or the other way."""
    whole = part.args[0] if part.kind == "pow" else part
    if whole.kind != "add":
        return None
    *terms, last = whole.args
    inner = last.args[0] if last.kind == "neg" else last
    if part.kind == "pow":
        raised = replace(part, args=(inner, part.args[1]))
        return replace(whole, args=(*terms, minus(raised) if last.kind == "neg" else raised))
    if inner.kind != "pow":
        return None
    base, power = inner.args
    added = replace(whole, args=(*terms, minus(base) if last.kind == "neg" else base))
    return Node("pow", (added, power), at=part.at)


def _number_kind(part: Node, above: Node | None) -> str:
    is_power = above is not None and above.kind == "pow" and above.args[1] is part
    return "exponent" if is_power else "number"


class _Alternatives:
    """Values of a tree with each edit of one of its parts, at a few samples."""

    def __init__(self, pool: Pool) -> None:
        self.pool = pool
        self.numbers = Numbers({name: value[SCREEN] for name, value in pool.values.items()})
        self.kept: dict[tuple[int, str, str], tuple[Node, list[Edit], Values]] = {}
        self.lifted: dict[int, tuple[Node, Values]] = {}

    def own(self, part: Node, above: Node | None) -> tuple[list[Edit], Values]:
        """Edits of a part itself, and its values with each."""
        key = id(part), "" if above is None else above.kind, _number_kind(part, above)
        if key not in self.kept:
            edits = _others(part, above, self.pool)
            values = [self.numbers.of(it.new) for it in edits]
            whole = np.stack(values, axis=-2) if edits else self.numbers.of(part)[..., None, :][:0]
            self.kept[key] = part, edits, whole
        return self.kept[key][1:]

    def inside(self, tree: Node) -> Values:
        """Values with each edit of a part inside a tree, the parts in order, each with its own."""
        if id(tree) not in self.lifted:
            parts = [self.numbers.of(part) for part in tree.args]
            rows = [np.empty((0, self.numbers.size))] if not parts else []
            for index, part in enumerate(tree.args):
                below = np.concatenate([self.own(part, tree)[1], self.inside(part)], axis=-2)
                if tree.kind == "add":
                    rows.append(below + (self.numbers.of(tree) - parts[index]))
                else:
                    rows.append(_applied(tree, [*parts[:index], below, *parts[index + 1 :]]))
            self.lifted[id(tree)] = tree, np.concatenate(rows, axis=-2)
        return self.lifted[id(tree)][1]

    def edit(self, tree: Node, number: int) -> tuple[Path, Edit]:
        """An edit inside a tree by its number, and its place."""
        for index, part in enumerate(tree.args):
            edits, _ = self.own(part, tree)
            if number < len(edits):
                return (index,), edits[number]
            number -= len(edits)
            below = self.inside(part).shape[-2]
            if number < below:
                path, edit = self.edit(part, number)
                return (index, *path), edit
            number -= below
        raise IndexError(number)

    def right(self, tree: Node, targets: Values) -> Iterator[Proposal]:
        """Edits after which a tree has one of its targets, at the few samples."""
        edits, values = self.own(tree, None)
        rows = np.concatenate([values, self.inside(tree)], axis=-2)
        for way, target in enumerate(targets[:, SCREEN]):
            near = np.flatnonzero(np.abs(rows[:, 0] - target[0]) <= CLOSE * np.abs(target[0]))
            for number in near:
                if not same(rows[number], target):
                    continue
                if number < len(edits):
                    yield way, (), edits[number]
                else:
                    yield way, *self.edit(tree, int(number) - len(edits))


# ------------------------------------------------------------------------------- what is missing


def _inverted(tree: Node, parts: Sequence[Values], whole: Values, need: Values) -> Iterator[Values]:
    """Values that each part would have to have for the tree to be what it needs, where they are
    known.
    """
    match tree.kind:
        case "neg":
            yield -need
        case "add":
            rest = need - whole
            yield from (rest + value for value in parts)
        case "mul":
            for index in range(len(parts)):
                yield need / math.prod([*parts[:index], *parts[index + 1 :]])
        case "div":
            yield need * parts[1]
            yield parts[0] / need
        case "pow":
            yield np.copysign(np.abs(need) ** (1 / parts[1]), parts[0])
            yield np.log(need) / np.log(parts[0])
        case "call" if tree.value == "sqrt":
            yield need**2
        case "call" if tree.value == "exp":
            yield np.log(need)


def _places(
    tree: Node, need: Values, numbers: Numbers, path: Path = (), above: Node | None = None
) -> Iterator[Place]:
    """Parts with what they need, for each target of the whole."""
    value = numbers.of(tree)
    yield path, tree, above, value, need
    if (tree.args and tree.kind != "call") or tree.value in ("sqrt", "exp"):
        parts = [numbers.of(part) for part in tree.args]
        for index, below in enumerate(_inverted(tree, parts, value, need)):
            yield from _places(tree.args[index], below, numbers, (*path, index), tree)


class _Products:
    """Products of powers of names and functions, by their values."""

    def __init__(self, tree: Node, pool: Pool, numbers: Numbers) -> None:
        ways: list[tuple[Node, Values]] = []
        for name, value in pool.values.items():
            one = leaf(name)
            ways += [(one, value), (Node("div", (ONE, one)), 1 / value)]
        ways += [(minus(part), -value) for part, value in ways]
        ways.sort(key=lambda it: float(it[1][0]))
        self.alone = [part for part, _ in ways]
        self.table = np.array([value for _, value in ways])
        inside = dict.fromkeys(map(_bare, nodes(tree)))
        atoms = [it for it in inside if it.kind == "symbol" and it.value in pool.values]
        atoms += [leaf(name) for name in pool.values]
        angles = [(leaf(name),) for name in pool.angles if name in pool.values]
        atoms += [Node("call", angle, way) for angle in angles for way in ("cos", "sin")]
        # Functions that are no factors of a product.
        atoms += [
            it
            for it in inside
            if it.kind == "call"
            and it.value not in ("Abs", "Tuple", "Piecewise", "And", *RELATIONS)
        ]
        # Symbols in a bracket that may be a factor.
        atoms += [it for it in inside if it.kind == "add" and len(symbols(it)) <= 3]
        self.atoms: list[tuple[Node, Values]] = []
        rows = [np.ones(numbers.size)]
        for atom in dict.fromkeys(atoms):
            value = numbers.of(atom)
            row = np.log(np.abs(value))
            rest = row - sum((row @ it) / (it @ it) * it for it in rows)
            # A row of logarithms is new by a share of its squares, and some samples are spare.
            is_new = np.isfinite(row).all() and rest @ rest > 1e-12 * (row @ row)
            if is_new and len(rows) < numbers.size - 4:
                rows.append(rest)
                self.atoms.append((atom, value))
        plain = np.array([np.log(np.abs(it)) for _, it in self.atoms] + rows[:1])
        self.inverse = np.linalg.pinv(plain)

    def of(self, wanted: Values) -> dict[int, Node]:
        """Products that have the values of a row, by the row."""
        found: dict[int, Node] = {}
        usable = np.isfinite(wanted).all(axis=1) & (wanted != 0).all(axis=1)
        wanted = np.where(usable[:, None], wanted, np.nan)
        first = wanted[:, 0]
        near = CLOSE * np.abs(first)
        for row in np.flatnonzero(np.abs(wanted - first[:, None]).max(axis=1) <= near):
            if (number := _rational(wanted[row])) is not None:
                found[int(row)] = _number(number)
        low = np.searchsorted(self.table[:, 0], first - near)
        high = np.searchsorted(self.table[:, 0], first + near, "right")
        for row in np.flatnonzero((high > low) & usable):
            for index in range(low[row], high[row]):
                if same(wanted[row], self.table[index]):
                    found.setdefault(int(row), self.alone[index])
        powers = np.log(np.abs(wanted)) @ self.inverse
        halves = np.round(2 * powers[:, :-1]) / 2
        gap = np.abs(powers[:, :-1] - halves).max(axis=1, initial=0.0)
        # Powers of a product are near halves, and not large, and its factors are not many.
        few = np.count_nonzero(halves, axis=1) <= 7
        small = np.abs(halves).max(axis=1, initial=0.0) <= 4
        for row in np.flatnonzero((gap < 1e-6) & few & small):
            if int(row) not in found and (one := self._product(wanted[row], halves[row])):
                found[int(row)] = one
        return found

    def _product(self, wanted: Values, powers: Values) -> Node | None:
        product = np.ones_like(wanted)
        for (_, value), power in zip(self.atoms, powers, strict=True):
            if power:
                base = value if power == int(power) else np.abs(value)
                product = product * base**power
        factor = _rational(wanted / product)
        if factor is None:
            return None
        used = [(it[0], power) for it, power in zip(self.atoms, powers, strict=True) if power]
        above = [_powered(atom, power) for atom, power in used if power > 0]
        below = [_powered(atom, -power) for atom, power in used if power < 0]
        if abs(factor) != 1 or not above:
            above = [_number(abs(factor)), *above]
        whole = joined("mul", above)
        if below:
            whole = Node("div", (whole, joined("mul", below)))
        return minus(whole) if factor < 0 else whole


def _missing(places: Sequence[Place], products: _Products) -> Iterator[Proposal]:
    """Numbers, factors and terms that give a part what it needs."""
    factors, terms = [], []
    for place in places:
        path, part, above, _, needs = place
        outer = "" if above is None else above.kind
        if part.kind == "number" and part.value != "pi":
            kind = _number_kind(part, above)
            for way, need in enumerate(needs):
                if near := _rational(need):
                    yield way, path, Edit(kind, part.at, part, _number(near), COST[kind])
        elif outer not in ("mul", "neg", "div"):
            factors.append(place)
        if part.kind == "add" or outer not in ("add", "neg"):
            terms.append(place)
    wanted = [need / value for *_, value, need in factors]
    wanted += [need - value for *_, value, need in terms]
    ways = len(wanted[0])
    # Added for every symbol beyond the first that an edit brings in, and for every level of
    # brackets.
    per_symbol = {"missing term": 0.1, "missing factor": 0.3, "number": 0.0}
    for row, fit in products.of(np.concatenate(wanted)).items():
        number, way = divmod(row, ways)
        path, part, above, *_ = (*factors, *terms)[number]
        count = sum(it.kind in ("symbol", "div") for it in nodes(fit))
        further = 0.0
        if number < len(factors):
            kind, new = "missing factor" if symbols(fit) else "number", _times(part, fit)
            further = 0.02  # dearer than another number in the place of one that stands there
        else:
            kind = "missing term"
            args = part.args if part.kind == "add" else (part,)
            further = 0.0 if part.kind == "add" or above is None else 0.3  # a bracket
            new = Node("add", (*args, fit), at=part.at)
        cost = COST[kind] + per_symbol[kind] * max(count - 1, 0) + further
        yield way, path, Edit(kind, part.at, part, new, cost)


def _rational(values: Values) -> Fraction | None:
    """The small fraction that values are at every sample, and not 0."""
    first = float(values[0])
    if not np.isfinite(first) or not same(values, np.full_like(values, first)):
        return None
    near = Fraction(first).limit_denominator(48)
    return near if near and abs(near) <= 200 and same(values, np.full_like(values, near)) else None


def _number(value: Fraction) -> Node:
    size = Node("number", value=str(abs(value.numerator)))
    if value.denominator != 1:
        size = Node("div", (size, Node("number", value=str(value.denominator))))
    return minus(size) if value < 0 else size


def _times(part: Node, factor: Node) -> Node:
    """A part times a factor, which of a quotient joins the denominator if it is below 1."""
    if part.kind == "neg":
        return Node("neg", (_times(part.args[0], factor),), at=part.at)
    if factor.kind != "div" or factor.args[0] != ONE:
        return Node("mul", (factor, part), at=part.at)
    above, below = part.args if part.kind == "div" else (part, None)
    below = factor.args[1] if below is None else Node("mul", (below, factor.args[1]))
    return Node("div", (above, below), at=part.at)


def _powered(atom: Node, power: float) -> Node:
    return atom if power == 1 else Node("pow", (atom, _number(Fraction(power))))


# --------------------------------------------------------------------------------------- repairs


class Search:
    """Repairs of a tree with what a pool has."""

    def __init__(self, tree: Node, pool: Pool) -> None:
        self.tree, self.pool = tree, pool
        with np.errstate(all="ignore"):
            self.numbers = Numbers(pool.values)
            self.alternatives = _Alternatives(pool)
            self.products = _Products(tree, pool, self.numbers)

    def repairs(self, targets: Values, pairs: bool = False) -> list[tuple[Repair, int]]:
        """Repairs by one edit, or by ``pairs`` of them, the most likely first.

        Each with the number of its target.
        """
        found: list[tuple[Repair, int]] = []
        with np.errstate(all="ignore"):
            if pairs:
                for first in self.firsts:
                    for it, way in self._singles(first.tree, targets):
                        found.append((Repair(it.tree, (*first.edits, *it.edits)), way))
            else:
                found += [*self._singles(self.tree, targets), *self._everywhere(targets)]
        trees: dict[Node, tuple[Repair, int]] = {}
        for repair, way in sorted(found, key=lambda it: it[0].cost):
            trees.setdefault(_bare(repair.tree), (repair, way))
        return list(trees.values())

    @cached_property
    def firsts(self) -> list[Repair]:
        """First ones of two edits: those whose new part is among few."""
        found = []
        parts = [*_parts(self.tree)]
        for path, part, above in parts:
            for it in _others(part, above, self.pool):
                if it.new.kind != "pow":
                    found.append(_repair(self.tree, path, it))
        # Of pairs, so many first edits are followed, and so many parts of the trees
        # after them.
        most = min(600, 20_000 // len(parts))
        return sorted(found, key=lambda it: it.cost)[:most]

    def _singles(self, tree: Node, targets: Values) -> Iterator[tuple[Repair, int]]:
        places = [*_places(tree, targets, self.numbers)]
        open_ones = _missing(places, self.products)
        for way, path, edit in (*self.alternatives.right(tree, targets), *open_ones):
            repair = _repair(tree, path, edit)
            if same(self.numbers.of(repair.tree), targets[way]):
                yield repair, way

    def _everywhere(self, targets: Values) -> Iterator[tuple[Repair, int]]:
        """One name in the place of another wherever it stands."""
        named: dict[str, list[Node]] = {}
        for part in nodes(self.tree):
            if part.kind == "symbol":
                named.setdefault(part.value, []).append(part)
        for old, (first, *others) in named.items():
            for new in self.pool.values if others else ():
                if new == old or self.pool.renaming(old, new) == "symbol":
                    continue
                swapped = {name: it[SCREEN] for name, it in self.pool.values.items()}
                swapped[old] = swapped[new]
                few = evaluated(self.tree, swapped)
                one = leaf(new)
                also = tuple(part.at for part in others)
                edit = Edit("renaming", first.at, first, one, COST["renaming"], also)
                for way, target in enumerate(targets):
                    if same(few, target[SCREEN]):
                        tree = renamed(self.tree, {old: one})
                        if same(self.numbers.of(tree), target):
                            yield Repair(tree, (edit,)), way


def _repair(tree: Node, path: Path, edit: Edit) -> Repair:
    """A tree after one edit, which costs the more the deeper it stands."""
    dearer = replace(edit, cost=edit.cost + 0.001 * len(path))
    return Repair(with_part(tree, path, edit.new), (dearer,))


def _bare(tree: Node) -> Node:
    """A tree without places, by which repairs are compared."""
    return Node(tree.kind, tuple(map(_bare, tree.args)), tree.value)


def _parts(
    tree: Node, path: Path = (), above: Node | None = None
) -> Iterator[tuple[Path, Node, Node | None]]:
    yield path, tree, above
    for index, part in enumerate(tree.args):
        yield from _parts(part, (*path, index), tree)
