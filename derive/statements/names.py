"""Names in a print, and what they are on the page."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from ..model import acceleration_of
from .lexer import Tokens
from .tree import Node, Unread, Vocabulary, printed


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


class Names:
    """Names of the page by their print."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.symbols, self.laws = vocabulary.symbols, vocabulary.laws
        self.next: dict[str, str] = {}
        for coordinate in vocabulary.coordinates:
            self.next[coordinate] = f"v{coordinate}"
            self.next[f"v{coordinate}"] = acceleration_of(coordinate)
        #: names of several letters or digits that a print may spell without an index
        self.words = {
            it for it in self.symbols - {*self.next.values()} if len(it) > 1 and it.isalnum()
        }
        self.renamed: dict[tuple[Name, ...], Node] = {}

    def times(self) -> set[str]:
        """Names of time, which the page gives to nothing else."""
        return {*("t", "tau")} - self.symbols

    def of(self, name: Name, at: tuple[int, int]) -> Node:
        """Meaning of a name on the page."""
        found = self.known(name, at)
        if found is None:
            raise Unread(
                f"{name.spelled} is no name of the page; say what it is under [symbols]", at[0]
            )
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
        moving = {*self.next, *self.next.values(), *self.laws}
        return node.value in moving if node.kind == "symbol" else any(map(self._moves, node.args))

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
