r"""Lexer of LaTeX: tokens, nested where brackets or environments group them.

Source that prints nothing (spaces, sizes of brackets, labels, alignment environments) is removed,
and each bare ``|`` is classified as an opening or a closing bracket.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from .tree import Unread


@dataclass(frozen=True)
class Token:
    """A token, or a group with ``items``, whose ``text`` is the opening bracket or environment.

    ``at`` is its range of characters in the print.
    """

    text: str
    at: tuple[int, int]
    items: tuple[Token, ...] | None = None


Tokens = Sequence[Token]


def texts(items: Tokens) -> list[str]:
    """The texts of the items: tokens and opening brackets."""
    return [it.text for it in items]


def split(items: Tokens, *signs: str) -> list[list[Token]]:
    """The runs of items between the given signs."""
    parts: list[list[Token]] = [[]]
    for it in items:
        if it.text in signs:
            parts.append([])
        else:
            parts[-1].append(it)
    return parts


@dataclass
class Cursor:
    """A position in a sequence of items, for a recursive descent."""

    items: Tokens
    place: int = 0

    @property
    def item(self) -> Token | None:
        """The current item, None behind the last one."""
        return self.items[self.place] if self.place < len(self.items) else None

    @property
    def text(self) -> str:
        """The text of the current item, empty behind the last one."""
        return "" if self.item is None else self.item.text

    @property
    def at(self) -> int:
        """Offset of the current item in the print."""
        return self.end if self.item is None else self.item.at[0]

    @property
    def end(self) -> int:
        """Offset in the print at which the item before this one ends."""
        return self.items[self.place - 1].at[1]

    def take(self) -> Token:
        """Return the current item and advance.

        Raises
        ------
        Unread
            Behind the last item.
        """
        if self.item is None:
            raise Unread("an argument is missing", self.end)
        self.place += 1
        return self.items[self.place - 1]


FRACTIONS = (r"\frac", r"\dfrac", r"\tfrac", r"\cfrac", r"\nicefrac", r"\sfrac")
#: Operators that stand between two operands.
BINARY = ("+", "/", r"\cdot", r"\times", "*", "=", ":=", ",", ";", "<", ">", "^", "_")


def nested(text: str) -> tuple[Token, ...]:
    """Tokens of a print in LaTeX, grouped by brackets and environments.

    Raises
    ------
    Unread
        If brackets do not match, or bars can be paired in two ways.
    """
    stack: list[tuple[str, int, list[Token], bool]] = [("", 0, [], False)]
    closing = {"(": ")", "[": "]", r"\{": r"\}", "{": "}", "|": "|"}
    closing[r"\langle"] = r"\rangle"
    styles = {r"\rm": r"\mathrm", r"\bf": r"\mathbf", r"\cal": r"\mathcal"}
    tokens = _tokens(text)
    for (token, start, stop, side), following in itertools.zip_longest(tokens, tokens[1:]):
        opened, begin, inner, sized = stack[-1]
        bar = token == "|"
        closes = side == "right" if side else bool(inner) and not _awaits(inner)
        if bar and opened != "|" and following is not None and following[0] == "_":
            inner.append(Token("|at", (start, stop)))
        elif (token in closing and not bar) or (bar and not (opened == "|" and closes)):
            stack.append((token, start, [], bool(side)))
        elif token.startswith(r"\begin"):
            stack.append((token[7:-1].rstrip("*"), start, [], True))
        elif token in closing.values() or token.startswith(r"\end"):
            if not opened or token != closing.get(opened, rf"\end{{{opened}}}"):
                raise Unread(f"{token} closes nothing that is open", start)
            stack.pop()
            inner = _without_braces(inner)
            _refuse_ambiguous_bars(inner)
            # As in {\\bf K}, which is \\mathbf{K}.
            if inner and inner[0].text in styles:
                stack[-1][2].append(Token(styles[inner.pop(0).text], (begin, begin)))
            kind = "|bare" if bar and not sized else opened
            stack[-1][2].append(Token(kind, (begin, stop), tuple(inner)))
        else:
            inner.append(Token(token, (start, stop)))
    opened, begin, inner, _ = stack[-1]
    if opened:
        raise Unread(f"{opened} is not closed", begin)
    inner = _without_braces(inner)
    _refuse_ambiguous_bars(inner)
    return tuple(inner)


def _without_braces(inner: Tokens) -> list[Token]:
    """The items with those inside a box, or above or below a horizontal brace, in its place."""
    found, here = list[Token](), Cursor(inner)
    while here.item is not None:
        it = here.take()
        if it.text in (r"\underbrace", r"\overbrace", r"\boxed") and here.text == "{":
            found += here.take().items or ()
            if here.text == {r"\underbrace": "_", r"\overbrace": "^"}.get(it.text):
                here.place += 2  # what it is called
        else:
            found.append(it)
    return found


def _tokens(text: str) -> list[tuple[str, int, int, str]]:
    """Tokens as text, start, end, and for a bracket the side that the source gives it: "left",
    "right", or "" where it does not say.
    """
    aligned = r"(?:aligned|align|alignat|equation|gather|gathered|multline|split|eqnarray)\*?"
    # Parts of the source that print nothing, or only lay the equations out.
    unprinted = re.compile(
        rf"""%[^\n]* | ^\s*(?:\$\$?|\\\[|\\\() | (?:\$\$?|\\\]|\\\))\s*$
        | \\(?:label|tag|hspace|vspace|[hv]?phantom)\*?\s*\{{[^{{}}]*\}}
        | \\left\s*\\\{{(?=\s*\\begin\{{{aligned}\}}) | \\(?:begin|end)\{{{aligned}\}}
        (?:\s*\\right\s*\\\}})?
        | \\(?:left|right)\s*\. | (?<=\\\\)\s*(?:\[[^\]]*\]|\\hline)
        | (?<!\\)\\(?:displaystyle|textstyle|limits|nonumber|notag|,|;|:|!|>|\s) | ~""",
        re.VERBOSE,
    )
    shown = re.sub(r"(\\begin\{\w+\*?\})\[[tbc]\]", r"\1   ", text.replace("−", "-"))
    comma = r"(?<!_\{)(?<!\d)(\d+)\{,\}(\d+)"  # of a number, not between indices
    shown = re.sub(comma, r"\1.\2  ", shown)
    columns = r"\\begin\{array\}\s*\{[^{}]*\}"
    shown = re.sub(columns, lambda found: found[0].replace("|", " "), shown)
    for opening, closing, spelled in (
        # A choice or equations behind a brace, and what is taken at a point.
        (
            r"\begin{cases}",
            r"\end{cases}",
            r"\\left\s*(?:(?P<opens>\\\{)|\.)\s*\\begin\{array\}\s*\{(?:[^{}]|\{\})*\}"
            r"(?P<inside>(?:(?!\\begin\{array).)*?)"
            r"\\end\{array\}\s*\\right\s*(?(opens)\.|\\\})",
        ),
        (
            r"\left[",
            r"\right]",
            r"\\left\s*\.(?P<inside>(?:(?!\\left|\\right).|\\left(?:(?!\\left|\\right).)*\\right)*)"
            r"\\right\s*(?:\||\\r?vert)(?=\s*_)",
        ),
    ):
        instead = partial(_instead, opening, closing)
        shown = re.sub(spelled, instead, shown, flags=re.DOTALL)
    equal = r"\\(?:overset|stackrel)\s*\{(?:[^{}]|\{[^{}]*\})*\}\s*\{\s*=\s*\}"
    shown = re.sub(equal, lambda found: "=".center(len(found[0])), shown)
    shown = unprinted.sub(lambda found: " " * len(found[0]), shown)
    tokens: list[tuple[str, int, int, str]] = []
    place = 0
    single_digits = 0  # arguments that follow, each of one digit if it is a number without braces
    bars = dict.fromkeys((r"\vert", r"\mid", r"\lvert", r"\rvert"), "|")
    bars |= {rf"\{one}{{dcases}}": rf"\{one}{{cases}}" for one in ("begin", "end")}
    sides = dict.fromkeys((r"\left", r"\lvert", "l"), "left")
    sides |= dict.fromkeys((r"\right", r"\rvert", "r"), "right")
    a_token = re.compile(
        r"(?P<size>\\(?:left|right|middle|(?:big|Big|bigg|Bigg)[lrm]?)(?![A-Za-z])\s*)?"
        r"(?P<text>\\(?:begin|end)\{\w+\*?\}|\\[A-Za-z]+|\\.|:=|\d+(?:\.\d+)?|\.\d+|\S)"
    )
    while found := a_token.search(shown, place):
        token, (start, place) = found["text"], found.span()
        if single_digits and token[0].isdigit():
            token, place = token[0], found.start("text") + 1
            single_digits -= 1
        elif token in FRACTIONS:
            single_digits = 2
        else:
            single_digits = int(token in ("^", "_", r"\sqrt"))
        size = (found["size"] or "").strip()
        side = sides.get(token) or sides.get(size) or sides.get(size[-1:], "")  # \bigl ends in l
        tokens.append((bars.get(token, token), start, place, side))
    return tokens


def _instead(opening: str, closing: str, found: re.Match[str]) -> str:
    """The match with its outer brackets replaced; what is inside keeps its offset."""
    begin, end = (place - found.start() for place in found.span("inside"))
    return opening.ljust(begin) + found["inside"] + closing.ljust(len(found[0]) - end)


def _awaits(inner: Tokens) -> bool:
    """Whether the last item is an operator, so that an operand has to follow."""
    return inner[-1].items is None and inner[-1].text in (*BINARY, "-")


def _refuse_ambiguous_bars(inner: Tokens) -> None:
    """Refuse bars that can be paired in two ways: |a| b |c|."""
    bars = [number for number, it in enumerate(inner) if it.text == "|bare"]
    for one, other in itertools.pairwise(bars):
        between = inner[one + 1 : other]
        if between and between[0].text not in BINARY and not _awaits(between):
            raise Unread(
                r"the bars can be paired in two ways; write \left| and \right|",
                inner[one].at[0],
                ("Abs(a)*b*Abs(c)", "Abs(a*Abs(b)*c)"),
            )
