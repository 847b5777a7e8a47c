"""Search for the smallest edits that give a printed tree its target values at samples.

There are two kinds of edits. If the new part is one of a few (another name, sign, function), the
tree is evaluated with all of them at once, from the leaves up. If the new part is open (a number,
a factor, a term), the tree is inverted from its root: each node gets the value that it would need
for the whole to be right, and what is missing is sought as a product of powers of names, by linear
least squares of logarithms. Values only propose edits; :mod:`.verdicts` proves them.
"""

from __future__ import annotations

import functools
import itertools
import math
import operator
from collections.abc import Iterable, Iterator, Mapping, Sequence
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
#: Largest relative difference of two values that count as equal at a sample.
CLOSE = 1e-8
#: Costs of edits by their kind; those of two edits add up.
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
#: Samples at which edits are tried first.
SCREEN = slice(0, 8, 2)


@dataclass(frozen=True)
class Edit:
    """The replacement of one node of a printed tree."""

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
    further: float = 0.0  #: cost besides that of the edits

    @property
    def cost(self) -> float:
        """The total cost."""
        return sum(edit.cost for edit in self.edits) + self.further


@dataclass(frozen=True)
class Pool:
    """The names that an edit may bring in, with their values at the samples."""

    values: Mapping[str, Values]
    kinds: Mapping[str, object]  #: equal for names of the same dimension
    angles: Sequence[str] = ()  #: names of which sine and cosine may be brought in

    def renaming(self, old: str, new: str) -> str:
        """The kind of edit that replaces one name by another."""
        if stem(old) == stem(new):
            return "index"
        return "renaming" if self.kinds.get(old) == self.kinds.get(new) else "symbol"


def stem(name: str) -> str:
    """A name without its index, or a derivative without its variable."""
    if name.startswith("diff("):
        return name.rpartition(",")[0]
    return name.rstrip("0123456789").split("_")[0]


def same(one: Values, other: Values) -> bool:
    """Whether values are finite and agree at every sample to the relative tolerance ``CLOSE``."""
    first, second = float(one[0]), float(other[0])
    if not abs(first - second) <= CLOSE * max(abs(first), abs(second)):
        return False
    size = np.maximum(np.abs(one), np.abs(other))
    return bool(np.isfinite(size).all() and (np.abs(one - other) <= CLOSE * size).all())


def same_but_for_factor(one: Values, other: Values) -> bool:
    """Whether the ratio is that in the other state of every pair with the same parameters."""
    with np.errstate(all="ignore"):
        ratio = one / other
    return same(ratio[::2], ratio[1::2])


def same_but_for_constant(one: Values, other: Values) -> bool:
    """Whether the difference of values is equal in both states of every pair of samples."""
    with np.errstate(all="ignore"):
        gap, size = one - other, np.abs(one) + np.abs(other)
        return bool((np.abs(gap[::2] - gap[1::2]) <= CLOSE * size[::2]).all())


# ------------------------------------------------------------------------------------------------
# values


def multiplied(*factors: Values) -> Values:
    """A product that is 0 where a factor is, as a switch of a contact, and others have no value."""
    whole: Values = functools.reduce(operator.mul, factors)
    if not np.isnan(whole).any():
        return whole
    return np.where(functools.reduce(operator.or_, (it == 0 for it in factors)), 0.0, whole)


#: Operations on arrays, by ``Node.operation``.
_NUMERIC = {
    **{name: sp.lambdify(x, of(x), "numpy") for name, of in FUNCTIONS.items() if name != "atan2"},
    **{name: getattr(operator, name.lower()) for name in RELATIONS},
    "add": lambda *parts: functools.reduce(operator.add, parts),
    "neg": operator.neg,
    "mul": multiplied,
    "div": operator.truediv,
    "pow": operator.pow,
    "max": lambda *parts: functools.reduce(np.maximum, parts),
    "min": lambda *parts: functools.reduce(np.minimum, parts),
    "atan2": np.arctan2,
    "And": lambda *parts: functools.reduce(np.logical_and, parts),
    "Tuple": lambda *parts: np.array(np.broadcast_arrays(*parts)),
    "Piecewise": lambda *pairs: np.select(
        [holds != 0 for _, holds in pairs], [value for value, _ in pairs], np.nan
    ),
}


def _applied(tree: Node, parts: Sequence[Values]) -> Values:
    """The values of an inner node from those of its arguments, which broadcast."""
    return _NUMERIC[tree.operation](*parts)


class Numbers:
    """Evaluation of trees at samples; nodes that trees share are evaluated once."""

    def __init__(self, known: Mapping[str, Values]) -> None:
        self.known = known
        self.size = len(next(iter(known.values())))
        self.found: dict[int, tuple[Node, Values]] = {}

    def of(self, tree: Node) -> Values:
        """The values of a tree."""
        if tree.kind == "symbol":
            return self.known[tree.value]
        if id(tree) not in self.found:
            if tree.kind == "number":
                value = np.full(self.size, number_of(tree))
            else:
                value = _applied(tree, [self.of(part) for part in tree.args])
            self.found[id(tree)] = tree, value  # the tree is kept, so that its id stays its own
        return self.found[id(tree)][1]


def evaluated(tree: Node, known: Mapping[str, Values]) -> Values:
    """The values of a tree at the samples, from those of its names."""
    with np.errstate(all="ignore"):
        return Numbers(known).of(tree)


#: Index of a target, path to a node, and an edit of that node.
Proposal: TypeAlias = tuple[int, Path, Edit]
#: Path to a node, the node, its parent, its values and the values it needs, one row per target.
Place: TypeAlias = tuple[Path, Node, Node | None, Values, Values]


# ------------------------------------------------------------------------------------------------
# edits with few choices


def _choices(part: Node, above: Node | None, pool: Pool) -> list[Edit]:
    """Edits of a node whose new part is one of a few; ``above`` is its parent."""
    found: list[Edit] = []

    def edit(kind: str, new: Node, further: float = 0.0) -> None:
        found.append(Edit(kind, part.at, part, new, COST[kind] + further))

    swaps = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh"}
    swaps |= {"Lt": "Gt", "Gt": "Lt", "Le": "Ge", "Ge": "Le"}
    if part.kind == "call" and part.value in swaps:
        edit("function", replace(part, value=swaps[part.value]))
    if part.operation in ("Tuple", "And", *RELATIONS):  # conditions are no numbers
        return found
    outer = "" if above is None else above.kind
    if outer in ("", "add", "call") or part.kind == "add":
        edit("sign", part.args[0] if part.kind == "neg" else minus(part))
    if part.kind == "symbol":
        for name in pool.values:
            if name != part.value:
                edit(pool.renaming(part.value, name), leaf(name, part.at))
    if part.kind == "number" and part.value != "pi":
        for value in ("0", "1", "2", "3", "4"):
            if value != part.value:
                further = 0.1 if value == "0" and outer == "mul" else 0.0  # for the whole term
                edit(_number_kind(part, above), Node("number", value=value, at=part.at), further)
    if part.kind in ("symbol", "call", "add", "div"):
        for power in (Fraction(2), Fraction(3), Fraction(-1), Fraction(1, 2)):
            edit("exponent", Node("pow", (part, _number(power)), at=part.at))
    if part.kind == "pow":
        edit("exponent", part.args[0], 0.1)  # a power is seldom lost
    elif part.kind != "number" and outer in ("add", "neg", "call"):
        for factor in (Fraction(2), Fraction(1, 2)):  # as in a square or a cosine
            edit("number", _times(part, _number(factor)), 0.02)
    if other := _other_bracket(part):
        edit("bracket", other)
    if outer == "add":
        edit("extra term", ZERO)
    if outer in ("mul", "div"):
        edit("extra factor", ONE)
    return found


def _other_bracket(part: Node) -> Node | None:
    """The node with its bracket moved: (a + b)² for a + b², or the reverse; None for others."""
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
    """The kind of an edit of a number: in an exponent or elsewhere."""
    is_power = above is not None and above.kind == "pow" and above.args[1] is part
    return "exponent" if is_power else "number"


class _Alternatives:
    """Values, at the first samples, of a tree after each edit that has few choices."""

    def __init__(self, pool: Pool) -> None:
        self.pool = pool
        self.numbers = Numbers({name: value[SCREEN] for name, value in pool.values.items()})
        self.kept: dict[tuple[int, str, str], tuple[Node, list[Edit], Values]] = {}
        self.lifted: dict[int, tuple[Node, Values]] = {}

    def own(self, part: Node, above: Node | None) -> tuple[list[Edit], Values]:
        """Edits of a node itself, and its values after each: one row per edit."""
        key = id(part), "" if above is None else above.kind, _number_kind(part, above)
        if key not in self.kept:
            edits = _choices(part, above, self.pool)
            values = [self.numbers.of(it.new) for it in edits]
            none = self.numbers.of(part)[..., None, :][..., :0, :]
            whole = np.stack(values, axis=-2) if edits else none
            self.kept[key] = part, edits, whole
        return self.kept[key][1:]

    def inside(self, tree: Node) -> Values:
        """Values of a tree after each edit of a node below its root: one row per edit.

        The rows are ordered by argument; of each, edits of the argument itself come first.
        """
        if id(tree) not in self.lifted:
            parts = [self.numbers.of(part) for part in tree.args]
            rows = [np.empty((0, self.numbers.size))] if not parts else []
            for index, part in enumerate(tree.args):
                below = np.concatenate([self.own(part, tree)[1], self.inside(part)], axis=-2)
                before, after = parts[:index], parts[index + 1 :]
                if tree.kind == "add":  # of rows once, also where this part has no value
                    rows.append(below + _applied(tree, before + after))
                else:
                    rows.append(_applied(tree, [*before, below, *after]))
            self.lifted[id(tree)] = tree, np.concatenate(rows, axis=-2)
        return self.lifted[id(tree)][1]

    def edit(self, tree: Node, number: int) -> tuple[Path, Edit]:
        """Path and edit of a row of :meth:`inside`."""
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
        """Edits after which a tree has the values of a target at the first samples."""
        edits, values = self.own(tree, None)
        rows = np.concatenate([values, self.inside(tree)], axis=-2)
        for index, target in enumerate(targets[:, SCREEN]):
            near = np.flatnonzero(np.abs(rows[:, 0] - target[0]) <= CLOSE * np.abs(target[0]))
            for number in near:
                if not same(rows[number], target):
                    continue
                if number < len(edits):
                    yield index, (), edits[number]
                else:
                    yield index, *self.edit(tree, int(number) - len(edits))


# ------------------------------------------------------------------------------------------------
# missing numbers, factors and terms


def _inverted(tree: Node, parts: Sequence[Values], whole: Values, need: Values) -> Iterator[Values]:
    """For each argument of a node, the values that it needs for the node to have those in ``need``.

    ``parts`` are the arguments' present values and ``whole`` the node's. Nothing is given for an
    operation that is not inverted.
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
    """All nodes that inversion reaches, with the values they need.

    ``need`` and these have a row for each target.
    """
    value = numbers.of(tree)
    yield path, tree, above, value, need
    if (tree.args and tree.kind != "call") or tree.value in ("sqrt", "exp"):
        parts = [numbers.of(part) for part in tree.args]
        for index, below in enumerate(_inverted(tree, parts, value, need)):
            yield from _places(tree.args[index], below, numbers, (*path, index), tree)


class _Products:
    """Products of powers of names, functions and brackets, found from their values.

    A value v = f ∏ a_k^p_k has log |v| = log |f| + Σ p_k log |a_k|: the powers p_k follow by least
    squares over the samples.
    """

    def __init__(self, tree: Node, pool: Pool, numbers: Numbers) -> None:
        singles: list[tuple[Node, Values]] = []
        for name, value in pool.values.items():
            symbol = leaf(name)
            singles += [(symbol, value), (Node("div", (ONE, symbol)), 1 / value)]
        singles += [(minus(part), -value) for part, value in singles]
        singles.sort(key=lambda it: float(it[1][0]))
        self.singles = [part for part, _ in singles]
        self.single_values = np.array([value for _, value in singles])
        self.atoms: list[tuple[Node, Values]] = []
        # Atoms with linearly independent logarithms, by the Gram-Schmidt process; four samples
        # more than unknowns check a fit.
        rows = [np.ones(numbers.size)]
        for atom in self._candidates(tree, pool):
            value = numbers.of(atom)
            row = np.log(np.abs(value))
            rest = row - sum((row @ it) / (it @ it) * it for it in rows)
            is_new = np.isfinite(row).all() and rest @ rest > 1e-12 * (row @ row)
            if is_new and len(rows) < numbers.size - 4:
                rows.append(rest)
                self.atoms.append((atom, value))
        logarithms = np.array([np.log(np.abs(it)) for _, it in self.atoms] + rows[:1])
        self.inverse = np.linalg.pinv(logarithms)

    @staticmethod
    def _candidates(tree: Node, pool: Pool) -> Iterable[Node]:
        """Possible factors: names, sines and cosines, and functions and brackets of the tree."""
        inside = dict.fromkeys(map(_bare, nodes(tree)))
        atoms = [it for it in inside if it.kind == "symbol" and it.value in pool.values]
        atoms += [leaf(name) for name in pool.values]
        for name in pool.angles:
            if name in pool.values:
                atoms += [Node("call", (leaf(name),), function) for function in ("cos", "sin")]
        no_factors = ("Abs", "Tuple", "Piecewise", "And", *RELATIONS)
        atoms += [it for it in inside if it.kind == "call" and it.value not in no_factors]
        most_symbols = 3  # of a bracket that may be a factor
        atoms += [it for it in inside if it.kind == "add" and len(symbols(it)) <= most_symbols]
        return dict.fromkeys(atoms)

    def of(self, wanted: Values) -> dict[int, Node]:
        """The expressions found for rows of values, by the number of the row.

        A number is tried first, then a single name or its reciprocal, then a product of powers.
        """
        found: dict[int, Node] = {}
        usable = np.isfinite(wanted).all(axis=1) & (wanted != 0).all(axis=1)
        wanted = np.where(usable[:, None], wanted, np.nan)
        first = wanted[:, 0]
        near = CLOSE * np.abs(first)
        for row in np.flatnonzero(np.abs(wanted - first[:, None]).max(axis=1) <= near):
            if (number := _rational(wanted[row])) is not None:
                found[int(row)] = _number(number)
        low = np.searchsorted(self.single_values[:, 0], first - near)
        high = np.searchsorted(self.single_values[:, 0], first + near, "right")
        for row in np.flatnonzero((high > low) & usable):
            for index in range(low[row], high[row]):
                if same(wanted[row], self.single_values[index]):
                    found.setdefault(int(row), self.singles[index])
        powers = np.log(np.abs(wanted)) @ self.inverse
        halves = np.round(2 * powers[:, :-1]) / 2
        gap = np.abs(powers[:, :-1] - halves).max(axis=1, initial=0.0)
        # A product is accepted with at most 7 factors, in multiples of 1/2 as powers, up to 4.
        few = np.count_nonzero(halves, axis=1) <= 7
        small = np.abs(halves).max(axis=1, initial=0.0) <= 4
        for row in np.flatnonzero((gap < 1e-6) & few & small):
            if int(row) not in found:
                whole = self._product(wanted[row], halves[row])
                if whole is not None:
                    found[int(row)] = whole
        return found

    def _product(self, wanted: Values, powers: Values) -> Node | None:
        """The product of the atoms to given powers and a rational factor; None if the remaining
        factor is not rational.
        """
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
    """Edits by a number, a factor or a term with which a node has the values it needs."""
    factors: list[Place] = []
    terms: list[Place] = []
    for place in places:
        path, part, above, _, needs = place
        outer = "" if above is None else above.kind
        if part.kind == "number" and part.value != "pi":
            kind = _number_kind(part, above)
            for index, need in enumerate(needs):
                if near := _rational(need):
                    yield index, path, Edit(kind, part.at, part, _number(near), COST[kind])
        elif outer not in ("mul", "neg", "div"):
            factors.append(place)
        if part.kind == "add" or outer not in ("add", "neg"):
            terms.append(place)
    wanted = [need / value for *_, value, need in factors]
    wanted += [need - value for *_, value, need in terms]
    target_count = len(wanted[0])
    # The cost of every symbol beyond the first, and of every quotient.
    per_symbol = {"missing term": 0.1, "missing factor": 0.3, "number": 0.0}
    for row, fit in products.of(np.concatenate(wanted)).items():
        number, index = divmod(row, target_count)
        path, part, above, *_ = (*factors, *terms)[number]
        count = sum(it.kind in ("symbol", "div") for it in nodes(fit))
        if number < len(factors):
            kind = "missing factor" if symbols(fit) else "number"
            new = _times(part, fit)
            further = 0.02  # dearer than to replace a printed number
        else:
            kind = "missing term"
            args = part.args if part.kind == "add" else (part,)
            further = 0.0 if part.kind == "add" or above is None else 0.3  # for a new bracket
            new = Node("add", (*args, fit), at=part.at)
        cost = COST[kind] + per_symbol[kind] * max(count - 1, 0) + further
        yield index, path, Edit(kind, part.at, part, new, cost)


def _rational(values: Values) -> Fraction | None:
    """The nonzero fraction that the values are at every sample, if it is a small one."""
    first = float(values[0])
    if not np.isfinite(first) or not same(values, np.full_like(values, first)):
        return None
    near = Fraction(first).limit_denominator(48)
    return near if near and abs(near) <= 200 and same(values, np.full_like(values, near)) else None


def _number(value: Fraction) -> Node:
    """The tree of a fraction."""
    size = Node("number", value=str(abs(value.numerator)))
    if value.denominator != 1:
        size = Node("div", (size, Node("number", value=str(value.denominator))))
    return minus(size) if value < 0 else size


def _times(part: Node, factor: Node) -> Node:
    """A node times a factor; a factor 1/c extends the denominator."""
    if part.kind == "neg":
        return Node("neg", (_times(part.args[0], factor),), at=part.at)
    if factor.kind != "div" or factor.args[0] != ONE:
        return Node("mul", (factor, part), at=part.at)
    above, below = part.args if part.kind == "div" else (part, None)
    below = factor.args[1] if below is None else Node("mul", (below, factor.args[1]))
    return Node("div", (above, below), at=part.at)


def _powered(atom: Node, power: float) -> Node:
    return atom if power == 1 else Node("pow", (atom, _number(Fraction(power))))


# ------------------------------------------------------------------------------------------------
# repairs


class Search:
    """Repairs of a tree with the names of a pool."""

    def __init__(self, tree: Node, pool: Pool) -> None:
        self.tree, self.pool = tree, pool
        with np.errstate(all="ignore"):
            self.numbers = Numbers(pool.values)
            self.alternatives = _Alternatives(pool)
            self.products = _Products(tree, pool, self.numbers)

    def repairs(self, targets: Values, pairs: bool = False) -> list[tuple[Repair, int]]:
        """Repairs by one edit, or by two if ``pairs``, the cheapest first.

        ``targets`` has one row of values per target; each repair comes with the index of its row.
        """
        found: list[tuple[Repair, int]] = []
        with np.errstate(all="ignore"):
            if pairs:
                for first in self.firsts:
                    for second, index in self._singles(first.tree, targets):
                        edits = (*first.edits, *second.edits)
                        found.append((Repair(second.tree, edits), index))
            else:
                found += [*self._singles(self.tree, targets), *self._everywhere(targets)]
        cheapest: dict[Node, tuple[Repair, int]] = {}
        for repair, index in sorted(found, key=lambda it: it[0].cost):
            cheapest.setdefault(_bare(repair.tree), (repair, index))
        return list(cheapest.values())

    @cached_property
    def firsts(self) -> list[Repair]:
        """Trees after the first of two edits, which has few choices; at most 600, fewer of a large
        tree.
        """
        found = []
        parts = [*_parts(self.tree)]
        for path, part, above in parts:
            for it in _choices(part, above, self.pool):
                if it.new.kind != "pow":
                    found.append(_repair(self.tree, path, it))
        most = min(600, 20_000 // len(parts))
        return sorted(found, key=lambda it: it.cost)[:most]

    def _singles(self, tree: Node, targets: Values) -> Iterator[tuple[Repair, int]]:
        """Repairs of a tree by one edit of one node."""
        places = [*_places(tree, targets, self.numbers)]
        missing = _missing(places, self.products)
        for index, path, edit in (*self.alternatives.right(tree, targets), *missing):
            repair = _repair(tree, path, edit)
            if same(self.numbers.of(repair.tree), targets[index]):
                yield repair, index

    def _everywhere(self, targets: Values) -> Iterator[tuple[Repair, int]]:
        """One name in the place of another wherever it stands, and one edit of what is printed
        once and stands several times, as an entry in a determinant.
        """
        groups: dict[object, list[tuple[Path, Node, Node | None]]] = {}
        for place in _parts(self.tree):
            part = place[1]
            if part.kind == "symbol":
                groups.setdefault(part.value, []).append(place)
            if part.at != (0, 0):
                groups.setdefault((part.at, _bare(part)), []).append(place)
        few = self.alternatives.numbers
        for key, ((_, part, above), *others) in groups.items():
            edits = _choices(part, above, self.pool) if others else []
            if edits and edits[0].kind != "sign":
                edits.append(Edit("sign", part.at, part, minus(part), COST["sign"]))
            if isinstance(key, str):
                also, names = tuple(it[1].at for it in others), ("index", "renaming")
                edits = [replace(it, also=also) for it in edits if it.kind in names]
                edits = [replace(it, kind=names[1], cost=COST[names[1]]) for it in edits]
            if not edits:
                continue
            unknown, tree = leaf("?"), self.tree
            for path, *_ in groups[key]:
                tree = with_part(tree, path, unknown)
            values = np.stack([few.of(it.new) for it in edits], axis=-2)
            rows = evaluated(tree, {**few.known, unknown.value: values})
            for (row, edit), (index, target) in itertools.product(
                zip(rows, edits, strict=True), enumerate(targets)
            ):
                if same(row, target[SCREEN]):
                    repaired = renamed(tree, {unknown.value: edit.new})
                    if same(self.numbers.of(repaired), target):
                        yield Repair(repaired, (edit,)), index


def _repair(tree: Node, path: Path, edit: Edit) -> Repair:
    """A tree after one edit, which costs a little more the deeper its node lies."""
    dearer = replace(edit, cost=edit.cost + 0.001 * len(path))
    return Repair(with_part(tree, path, edit.new), (dearer,))


def _bare(tree: Node) -> Node:
    """A tree without places in the print, so that equal trees compare as equal."""
    return Node(tree.kind, tuple(map(_bare, tree.args)), tree.value)


def _parts(
    tree: Node, path: Path = (), above: Node | None = None
) -> Iterator[tuple[Path, Node, Node | None]]:
    """Every node of a tree, with its path and its parent."""
    yield path, tree, above
    for index, part in enumerate(tree.args):
        yield from _parts(part, (*path, index), tree)
