"""LaTeX of a repaired print: the printed text with its edits, everything else unchanged."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import replace

from .papers import Statement
from .repair import Edit
from .tree import ONE, ZERO, to_latex


def repaired_print(
    statement: Statement, edits: Sequence[Edit], letters: Mapping[str, str]
) -> str | None:
    """The printed LaTeX after edits; None if one of them can't be made in the text."""
    if not statement.is_latex or statement.transcribed:
        return None
    found = [replace(edit, at=at) for edit in edits for at in (edit.at, *edit.also)]
    found.sort(key=lambda it: it.at, reverse=True)
    overlap = any(one.at[0] < other.at[1] for one, other in itertools.pairwise(found))
    if overlap or any(edit.at == (0, 0) for edit in found):
        return None
    text = statement.text
    for edit in found:  # from the end, so that places before an edit stay
        edited = _edited(text, edit, letters)
        if edited is None:
            return None
        text = edited
    return text


def _edited(text: str, edit: Edit, letters: Mapping[str, str]) -> str | None:
    """The text after one edit; None if it can't be made there."""
    start, stop = edit.at
    before, old, after = text[:start], text[start:stop], text[stop:]
    new = edit.new
    if edit.kind == "sign" and edit.old.kind == "neg" and old.startswith("-"):
        is_first = not before.strip() or before.rstrip()[-1] in "=({[&"
        plus = "" if is_first else "+"
        return f"{before}{plus}{old[1:]}{after}"
    if edit.kind == "sign":
        if before.rstrip().endswith("+"):
            before = before.rstrip()[:-1]
        return f"{before}- {old}{after}"
    if new in (ZERO, ONE) or edit.kind in ("missing term", "missing factor"):
        return _joined(before, old, after, edit, letters)
    return f"{before}{to_latex(new, letters)}{after}"


def _joined(
    before: str, old: str, after: str, edit: Edit, letters: Mapping[str, str]
) -> str | None:
    """The text with a term or a factor added; None if it can't be added there."""
    new = edit.new
    terms = edit.old.args if edit.old.kind == new.kind else (edit.old,)
    if edit.kind == "missing term" and new.kind == "add" and new.args[:-1] == terms:
        added, sign = new.args[-1], "+"
        if added.kind == "neg":
            added, sign = added.args[0], "-"
        return f"{before}{old} {sign} {to_latex(added, letters)}{after}"
    if edit.kind == "missing factor" and new.kind == "mul" and not edit.old.args:
        factors = " ".join(old if it == edit.old else to_latex(it, letters) for it in new.args)
        if before.endswith("/"):
            factors = f"({factors})"
        return f"{before}{factors}{after}"
    above, slash, below = old.rpartition("/")
    if edit.kind == "missing factor" and edit.old.kind == "div" and slash:
        further = new.args[1].args[-1]
        return f"{before}{above}/({below} {to_latex(further, letters)}){after}"
    return None
