"""The layout of a print in LaTeX: equations side by side or below each other, with conditions."""

from __future__ import annotations

import re
from dataclasses import replace

from .lexer import Token, Tokens, split, texts
from .tree import Unread

#: Styles in which names and words stand.
ROMAN = (
    r"\mathrm",
    r"\text",
    r"\mathit",
    r"\mathsf",
    r"\operatorname",
    r"\textrm",
    r"\mathop",
    r"\mbox",
    r"\hbox",
    r"\rm",
)
BOLD = (r"\mathbf", r"\vec", r"\mathcal", r"\bar", r"\hat", r"\tilde")
ACCENTS = {r"\overline": r"\bar", r"\widehat": r"\hat", r"\widetilde": r"\tilde"}
ACCENTS |= {r"\mathscr": r"\mathcal"}
ACCENTS |= dict.fromkeys((r"\boldsymbol", r"\bm", r"\pmb", r"\mathbb", r"\underline"), r"\mathbf")
#: Words between equations.
WORDS = ("", "where", "with", "and", "for", "if", "when", "so", "or", "then", "thus", "hence")
BETWEEN = ("\\\\", r"\quad", r"\qquad", ",", ";", r"\Rightarrow", r"\Leftrightarrow", r"\eqno")
OVER = (r"\overset", r"\stackrel")
TIMES = (r"\cdot", r"\times", "*", r"\ast")
MATRICES = ("matrix", "pmatrix", "bmatrix", "Bmatrix", "smallmatrix", "array")
EQUAL = ("=", ":=", r"\equiv", r"\triangleq", r"\coloneqq")
#: Relations by their signs, as SymPy calls them.
RELATIONS = {
    sign: name
    for name, signs in {
        "Lt": r"< \lt",
        "Le": r"\le \leq \leqslant",
        "Gt": r"> \gt",
        "Ge": r"\ge \geq \geqslant",
        "Ne": r"\ne \neq",
        "Eq": "=",
    }.items()
    for sign in signs.split()
}


def equations_inside(item: Token) -> Tokens:
    """The items inside braces, or inside an environment that holds equations; else none."""
    inside = item.items or ()
    if item.text == r"\{" and texts(inside) == ["array"]:
        return equations_inside(inside[0])
    is_table = item.text in ("cases", "array") and {*EQUAL} & {*texts(inside)}
    return inside[item.text == "array" :] if item.text == "{" or is_table else ()


def is_number(items: Tokens) -> bool:
    """Whether the items are the number of an equation in brackets, as (3.1a)."""
    inside = len(items) == 1 and items[0].text == "(" and "".join(texts(items[0].items or ()))
    return bool(inside and re.fullmatch(r"\d+(\.\d+)*[a-z]?", inside))


def is_remark(items: Tokens) -> bool:
    """Whether the items are words in brackets, as (total energy)."""
    is_text = len(items) == 2 and items[0].text in ROMAN
    return is_text and label_of(items[1:]).startswith("(")


def is_condition(items: Tokens) -> bool:
    """Whether the items hold a relation other than equality."""
    return any(it.text in RELATIONS and it.text not in EQUAL for it in items)


def condition_of(items: Tokens) -> list[Token]:
    """The relation of what stands behind the last sign of equality before it, as in a = b > 0."""
    relation = next(it for it in items if it.text in RELATIONS and it.text not in EQUAL)
    before, *behind = split(items, relation.text)
    return [*split(before, *EQUAL)[-1], *items[len(before) :]]


def equation_of(items: Tokens) -> Tokens:
    """The items before a relation other than equality, if they are an equation; else none."""
    if not is_condition(items):
        return items
    count = len(items) - len(condition_of(items)) - 1
    return split(items, *(RELATIONS.keys() - EQUAL))[0] if count > 0 else []


def printed_apart(items: Tokens) -> list[list[Token]]:
    """Equations that are printed side by side or below each other.

    A line that begins with an operator continues the line above it.
    """
    separated: list[Token] = []
    for it in items:
        is_word = separated and separated[-1].text in ROMAN
        if is_word and label_of([it]).strip(".,;:") in WORDS:
            separated[-1] = replace(separated[-1], text=r"\quad")
        else:
            separated.append(it)
    items, pieces = separated, list[list[Token]]([[]])
    signs, is_new_line = ("+", "-", *TIMES, *EQUAL), False
    for number, it in enumerate(items):
        if it.text in BETWEEN:
            refuse_decimal_comma(items, number)
            is_new_line = is_new_line or it.text == "\\\\"
            pieces.append([])
        elif it.text != "&" and (it.text != "." or number < len(items) - 1):
            if is_new_line and not pieces[-1]:
                above = next((piece for piece in reversed(pieces) if piece), [])
                line = split(items[number:], "\\\\")[0]
                is_whole = all({*EQUAL} & {*texts(one)} for one in (above, line[1:]))
                goes_on = it.text in signs and (it.text in EQUAL or not is_whole)
                if goes_on or (above and above[-1].text in signs):
                    pieces = [piece for piece in pieces if piece] or [[]]
            pieces[-1].append(it)
            is_new_line = False
    pieces = [it for it in pieces if it and not is_number(it) and not is_remark(it)]
    for piece in pieces if len(pieces) > 1 else ():
        if all(it.text not in (*EQUAL, *RELATIONS) for it in piece):
            raise Unread("this part is no equation", piece[0].at[0])
    return pieces


def refuse_decimal_comma(items: Tokens, number: int) -> None:
    """Refuse a comma, the item of a number, between digits."""
    neighbours = texts((*items[number - 1 : number], *items[number + 1 : number + 2]))
    if items[number].text == "," and sum(text[0].isdigit() for text in neighbours) == 2:
        raise Unread("a comma between digits: a decimal comma, or two values", items[number].at[0])


def flattened(items: Tokens) -> list[Token]:
    """Tokens with braces opened and styles left out."""
    flat: list[Token] = []
    for it in items:
        if it.text == "{":
            flat += flattened(it.items or ())
        elif it.text not in ROMAN:
            flat.append(it)
    return flat


def label_of(items: Tokens) -> str:
    """The text of an index."""
    return "".join(text.removeprefix("\\") for text in texts(flattened(items)))
