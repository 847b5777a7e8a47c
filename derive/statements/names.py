"""Names in a print, and what they are on the page."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from ..model import acceleration_of
from .lexer import Tokens
from .tree import Node, Unread, Vocabulary, printed


#: Words for the columns of all coordinates, of their rates and of their accelerations.
COLUMNS = ("coordinates", "rates", "accelerations")
#: The word for the frequency ω of λ = iω.
FREQUENCY = "frequency"
#: Words for the objects that are matrices.
MATRICES = ("mass", "damping", "gyroscopic", "stiffness")


@dataclass(frozen=True)
class Name:
    """A printed name: letter or word with accents and indices, and its order of derivative."""

    base: str
    sub: str = ""
    sup: str = ""
    order: int = 0

    @property
    def spelled(self) -> str:
        """The name in letters, digits and underscores."""
        parts = [re.sub(r"\W+", "", part) for part in (self.base, self.sub, self.sup)]
        return "_".join(part for part in parts if part) + "'" * self.order

    def __str__(self) -> str:
        """The name as it is printed, and what a bold one may stand for."""
        style, _, letter = self.base.rpartition(" ")
        if not style:
            return self.spelled
        marks = "".join(f"{sign}{it}" for sign, it in (("_", self.sub), ("^", self.sup)) if it)
        return f"{style}{{{letter}}}{marks}"

    @property
    def remedy(self) -> str:
        """What may stand under [symbols], of a bold name too."""
        words = ", ".join((*COLUMNS, *MATRICES))
        return f" by a name of the page, or as {words}" if " " in self.base else ""


class Names:
    """Names of the page by their print."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.symbols, self.laws = vocabulary.symbols, vocabulary.laws
        self.fixed = vocabulary.fixed
        self.next: dict[str, str] = {}
        for coordinate in vocabulary.coordinates:
            self.next[coordinate] = f"v{coordinate}"
            self.next[f"v{coordinate}"] = acceleration_of(coordinate)
        #: names of several letters or digits that a print may spell without an index
        self.words = {
            it for it in self.symbols - {*self.next.values()} if len(it) > 1 and it.isalnum()
        }
        self.renamed: dict[tuple[Name, ...], Node] = {}
        #: functions by their printed names, as SymPy calls them
        self.functions: dict[Name, str] = {}
        #: columns of coordinates, rates and accelerations, by the words for them; none where the
        #: page has one of these words, of which the rates would be those of another quantity
        self.columns: dict[str, tuple[str, ...]] = {}
        if not {*COLUMNS} & self.symbols:
            row = vocabulary.coordinates
            for word in COLUMNS:
                self.columns[word] = row
                row = tuple(self.next.get(it, "") for it in row)
            self.next |= dict(itertools.pairwise(COLUMNS))

    def times(self) -> set[str]:
        """Names of time, which the page gives to nothing else."""
        return {*("t", "tau")} - self.symbols

    def of(self, name: Name, at: tuple[int, int]) -> Node:
        """Meaning of a name on the page."""
        found = self.known(name, at)
        if found is None:
            remedy = f"say what it is under [symbols]{name.remedy}"
            raise Unread(f"{name} is no name of the page; {remedy}", at[0])
        return found

    def known(self, name: Name, at: tuple[int, int]) -> Node | None:
        """Meaning of a name on the page, or nothing."""
        if (name,) in self.renamed:
            return moved(self.renamed[name,], at)
        if name.order:
            before = self.known(replace(name, order=name.order - 1), at)
            return before and self.rate(before)
        found = [it for it in _spellings(name) if it in self.symbols]
        if not found and "o" in (name.sub, name.sup):
            is_sub = name.sub == "o"
            zero = replace(name, sub="0") if is_sub else replace(name, sup="0")
            found = [it for it in _spellings(zero) if it in self.symbols]
        if len(found) > 1:
            raise Unread(f"{name.spelled} is two names of the page", at[0], (found[0], found[1]))
        if found:
            return Node("symbol", value=found[0], at=at)
        return Node("number", value="pi", at=at) if name == Name("pi") else None

    def rate(self, node: Node) -> Node:
        """The derivative by time of what is linear in coordinates or rates."""
        match node.kind:
            case "symbol" if node.value in self.next:
                return replace(node, value=self.next[node.value])
            case "number":
                return replace(node, value="0")
            case "add" | "neg":
                return replace(node, args=tuple(map(self.rate, node.args)))
            case "mul" if sum(map(self._moves, node.args)) == 1:
                parts = (self.rate(it) if self._moves(it) else it for it in node.args)
                return replace(node, args=tuple(parts))
            case "div" if not self._moves(node.args[1]):
                return replace(node, args=(self.rate(node.args[0]), node.args[1]))
        if not self._moves(node):
            return Node("number", value="0", at=node.at)
        raise Unread(f"the rate of {printed(node)} is not read; print it in rates", node.at[0])

    def _moves(self, node: Node) -> bool:
        if node.kind != "symbol":
            return any(map(self._moves, node.args))
        if self.fixed is not None:
            return node.value not in self.fixed
        return node.value in {*self.next, *self.next.values(), *self.laws}

    def word(self, items: Tokens, place: int) -> int:
        """Number of items that spell a name of the page that has several letters: a k c that
        is kc.
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


def moved(node: Node, at: tuple[int, int]) -> Node:
    """The same tree at another place of the print."""
    return replace(node, at=at, args=tuple(moved(it, at) for it in node.args))


def _spellings(name: Name) -> Sequence[str]:
    """Spellings that a printed name may have on a page."""
    labels = [re.sub(r"\W+", "", it) for it in (name.sub, name.sup) if it]
    bases = {"ell": ("ell", "l"), "lambda": ("lambda_", "lamda", "lam")}.get(
        name.base, (name.base,)
    )
    joined = (sep.join((base, *labels)) for base in bases for sep in ("_", ""))
    return [*dict.fromkeys((*joined, replace(name, order=0).spelled))]
