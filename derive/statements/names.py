"""Printed names, with accents, indices and dots, and the quantities of the page they stand for."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp

from ..model import acceleration_of
from .lexer import Tokens
from .tree import FUNCTIONS, ONE, ZERO, Node, Unread, Vocabulary, joined, leaf, printed
from .tree import read_sympy, renamed, to_sympy


#: Words for the columns of all coordinates, of their rates and of their accelerations, and for that
#: of the coordinates and below them their rates.
COLUMNS = ("coordinates", "rates", "accelerations", "states")
#: Words for the objects that are matrices.
MATRICES = ("mass", "damping", "gyroscopic", "stiffness")


@dataclass(frozen=True)
class Name:
    """A printed name: letter or word with accents and indices.

    ``order`` is the number of dots or primes on it.
    """

    base: str
    sub: str = ""
    sup: str = ""
    order: int = 0
    has_dots: bool = field(default=False, compare=False)  #: dots are by time, primes may not be

    @property
    def spelled(self) -> str:
        """The name in letters, digits and underscores, with a prime for each order."""
        return "_".join(self.parts) + "'" * self.order

    @property
    def parts(self) -> list[str]:
        """Base and indices in letters and digits; marks in an index as words, k^* as k_star."""
        marks = str.maketrans({"*": "star", "+": "plus", "-": "minus"})
        found = (self.base, self.sub.translate(marks), self.sup.translate(marks))
        return [word for part in found if (word := re.sub(r"\W+", "", part))]

    def __str__(self) -> str:
        """The name in messages, in LaTeX if it has an accent or a style."""
        style, _, letter = self.base.rpartition(" ")
        if not style:
            return self.spelled
        marks = "".join(f"{sign}{it}" for sign, it in (("_", self.sub), ("^", self.sup)) if it)
        return f"{style}{{{letter}}}{marks}"

    @property
    def remedy(self) -> str:
        """The end of a message: what may be written for this name under [symbols]."""
        if " " in self.base:
            return f" by a name of the page, or as {', '.join((*COLUMNS, *MATRICES))}"
        return f", or as energy {self.base}" if self.spelled in ("T", "V", "L") else ""


class Names:
    """Lookup of printed names among those of the page, and their derivatives."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.symbols, self.laws = vocabulary.symbols, vocabulary.laws
        self.fixed, self.derivative = vocabulary.fixed, vocabulary.derivative
        self.functions_of_one, self.has_roots = vocabulary.arguments.keys(), vocabulary.has_roots
        self.dotted = vocabulary.dotted
        #: whether a name that is not known is a new one, to which a value is given
        self.is_open, self.is_definition = False, vocabulary.is_definition
        self.next: dict[str, str] = {}
        for coordinate in vocabulary.coordinates:
            self.next[coordinate] = f"v{coordinate}"
            self.next[f"v{coordinate}"] = acceleration_of(coordinate)
        #: names of several letters or digits that a print may spell without an index
        self.words = {
            it for it in self.symbols - {*self.next.values()} if len(it) > 1 and it.isalnum()
        }
        self.renamed: dict[Name, Node] = {}
        #: why a meaning can't be read, as of names that only the other form of the page has
        self.refused: dict[Name, str] = {}
        #: what is wrong with a name under [symbols] that can't be read
        self.unread = ""
        #: functions by their printed names, as SymPy calls them
        self.functions: dict[Name, str] = {}
        #: names in the columns of coordinates, rates and accelerations, by the words for these;
        #: empty if the page itself has a quantity with one of these words as its name
        self.columns: dict[str, tuple[str, ...]] = {}
        if not {*COLUMNS} & self.symbols:
            row, words = vocabulary.coordinates, COLUMNS[:3]
            for word in words:
                self.columns[word] = row
                row = tuple(self.next.get(it, "") for it in row)
            self.next |= dict(itertools.pairwise(words))
            for word, above in (("states", words[0]), ("rates of states", words[1])):
                self.columns[word] = self.columns[above] + self.columns[self.next[above]]
            self.next["states"] = "rates of states"
        self.aliases: dict[str, str] = {}
        for name, (state, *more) in vocabulary.states.items():
            if not more:
                self.aliases[name] = state
                continue
            self.columns[name] = (state, *more)
            self.next[name] = f"rates of {name}"
            self.columns[self.next[name]] = tuple(self.next.get(it, "") for it in (state, *more))

    def times(self) -> set[str]:
        """Letters that stand for time: t and tau, unless the page has such a quantity."""
        return {*("t", "tau")} - self.symbols

    def of(self, name: Name, at: tuple[int, int]) -> Node:
        """The tree that a printed name stands for.

        Raises
        ------
        Unread
            If the page has no such name, or two.
        """
        found = self.known(name, at)
        if found is None and (self.is_open or self.dotted is not None):
            return leaf(name.spelled, at)
        if found is None:
            remedy = f"say what it is under [symbols]{name.remedy}"
            if self.has_roots:
                remedy += ", an eigenvalue as lam or frequency"
            said = f"{name} is no name of the page; {remedy}"
            raise Unread("; ".join(filter(None, (said, self.unread))), at[0])
        return found

    def known(self, name: Name, at: tuple[int, int]) -> Node | None:
        """The tree that a printed name stands for, or None."""
        if name in self.refused:
            raise Unread(self.refused[name], at[0])
        if name in self.renamed:
            return moved(self.renamed[name], at)
        if name.order:
            before = self.known(replace(name, order=name.order - 1), at)
            if before is None and self.dotted is not None and (name.has_dots or name.order == 2):
                base = replace(name, order=0).spelled
                self.dotted.add(base)
                self.symbols |= {base}
                self.next |= {base: f"v{base}", f"v{base}": acceleration_of(base)}
                return self.known(name, at)
            if before is not None and not (name.has_dots or self.moves(before)):
                before = before if self.function_of(before) else None  # k' is no rate of k
            if before is None and name.spelled in self.symbols:  # a speed of no place
                return leaf(name.spelled, at)
            if before is None or name.has_dots or self.function_of(before) is None:
                return before and self.rate(before)
            return self.derived(before, "")
        found = [it for it in _spellings(name) if it in self.symbols]
        if not found and "o" in (name.sub, name.sup):
            is_sub = name.sub == "o"
            zero = replace(name, sub="0") if is_sub else replace(name, sup="0")
            found = [it for it in _spellings(zero) if it in self.symbols]
        if not found and self.has_roots and re.fullmatch(r"\d([,/]\d)+|pm", name.sub):
            root = self.known(replace(name, sub=""), at)  # as λ_{1,2} and λ_±
            return root if root is not None and root.value in ("lam", "frequency") else None
        if not found and name.sup == "*" and not (self.is_open and self.is_definition):
            place = self.known(replace(name, sup=""), at)  # of an equilibrium
            return place if place is not None and place.value in self.next else None
        if len(found) > 1:
            raise Unread(f"{name.spelled} is two names of the page", at[0], (found[0], found[1]))
        if found:
            return leaf(found[0], at)
        return Node("number", value="pi", at=at) if name == Name("pi") else None

    def function_of(self, node: Node) -> str | None:
        """The function of one argument that a symbol is, or is a derivative of; else None."""
        return function_behind(node.value, self.functions_of_one)

    def derived(self, node: Node, by: str) -> Node:
        """The derivative of a symbol by another name; by its argument if ``by`` is empty."""
        if self.derivative is None:
            raise Unread("a derivative is not read here", node.at[0])
        try:
            return replace(node, value=self.derivative(node.value, by))
        except Unread as error:
            raise Unread(error.reason, node.at[0]) from error

    def rate(self, node: Node) -> Node:
        """The derivative of a tree by time."""
        if not self.moves(node):
            return Node("number", value="0", at=node.at)
        match node.kind:
            case "symbol" if (state := self.aliases.get(node.value, node.value)) in self.next:
                return replace(node, value=self.next[state])
            case "symbol" if self.derivative is not None and node.value not in self.columns:
                return self.derived(node, "t")
            case "symbol":
                pass
            case _ if node.value in ("", *FUNCTIONS):
                return moved(self._by_chain(node, self.rate), node.at)
        raise Unread(f"the rate of {printed(node)} is not read; print it in rates", node.at[0])

    def partial(self, node: Node, by: str) -> Node:
        """The derivative of a tree by a coordinate or rate."""
        by = self.aliases.get(by, by)
        node = replace(node, value=self.aliases.get(node.value, node.value))
        is_other = node.kind == "number" or node.value in {*self.next, *self.next.values()}
        if node.value == by:
            return replace(ONE, at=node.at)
        if is_other or not self.moves(node):
            return Node("number", value="0", at=node.at)
        if node.kind == "symbol":
            return self.derived(node, by)
        if node.value not in ("", *FUNCTIONS):
            raise Unread(f"the derivative of {printed(node)} is not read", node.at[0])
        return moved(self._by_chain(node, lambda it: self.partial(it, by)), node.at)

    def _by_chain(self, node: Node, slope: Callable[[Node], Node]) -> Node:
        """The derivative of an operation by the chain rule: the sum of ∂f/∂u_k times the slope of
        u_k.
        """
        operands = {f"u{number}": operand for number, operand in enumerate(node.args)}
        names = {name: sp.Symbol(name, real=True) for name in operands}
        plain = (it if it.kind == "number" else leaf(name) for name, it in operands.items())
        value = to_sympy(replace(node, args=tuple(plain)), names)
        terms = []
        for name, operand in operands.items():
            if (inner := slope(operand)).value != "0":
                text = str(sp.diff(value, names[name]))
                outer = read_sympy(text, Vocabulary(frozenset(names), (), {}))[0].left
                factors = [it for it in (renamed(outer, operands), inner) if printed(it) != "1"]
                terms.append(joined("mul", factors or [replace(ONE, at=node.at)]))
        return joined("add", terms or [replace(ZERO, at=node.at)])

    def moves(self, node: Node) -> bool:
        """Whether a tree changes in time."""
        if node.kind != "symbol":
            return any(map(self.moves, node.args))
        if self.fixed is not None:
            return node.value not in self.fixed
        if self.dotted is not None and node.value.startswith("diff("):
            return True
        return node.value in {*self.next, *self.next.values(), *self.laws}

    def word(self, items: Tokens, place: int) -> int:
        """Number of items, from a place on, that spell a name of several letters: 2 for ``k c``
        on a page with kc; 0 if none does.

        Raises
        ------
        Unread
            If each letter is a name of the page as well.
        """
        letters = ""
        for it in items[place:]:
            if it.items is not None or not (it.text.isalnum() and it.text.isascii()):
                break
            letters += it.text
        word = max((it for it in self.words if letters.startswith(it)), key=len, default="")
        if word and all(it in self.symbols for it in word):
            product = "*".join(word)
            raise Unread(f"{word} is a name and a product", items[place].at[0], (word, product))
        count, length = 0, 0
        while length < len(word):
            length += len(items[place + count].text)
            count += 1
        return count


def function_behind(value: str, functions: Collection[str]) -> str | None:
    """The function that a name is or is a derivative of: f for diff(diff(f, x), x); else None."""
    while value not in functions and value.startswith("diff("):
        inner, comma, by = value.removeprefix("diff(").removesuffix(")").rpartition(", ")
        value = inner if comma else by
    return value if value in functions else None


def moved(node: Node, at: tuple[int, int]) -> Node:
    """The same tree, every node of it at another place in the print."""
    return replace(node, at=at, args=tuple(moved(it, at) for it in node.args))


def _spellings(name: Name) -> Sequence[str]:
    """Spellings that a printed name may have on a page, k_c or kc."""
    labels = name.parts[1:]
    bases = {"ell": ("ell", "l"), "lambda": ("lambda_", "lamda", "lam")}.get(
        name.base, (name.base,)
    )
    joined = (sep.join((base, *labels)) for base in bases for sep in ("_", ""))
    return [*dict.fromkeys((*joined, replace(name, order=0).spelled))]
