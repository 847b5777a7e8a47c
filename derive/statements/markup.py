"""A print with its edits, in LaTeX: what is not edited stands as it was printed."""

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
    """The print after edits, where each has its place in it."""
    found = [replace(edit, at=at) for edit in edits for at in (edit.at, *edit.also)]
    found.sort(key=lambda it: it.at, reverse=True)
    apart = all(one.at[0] >= other.at[1] for one, other in itertools.pairwise(found))
    is_placed = apart and all(edit.at != (0, 0) for edit in found)
    marked = statement.text if statement.is_latex and not statement.transcribed else None
    for edit in found:
        marked = _edited(marked, edit, letters) if marked and is_placed else None
    return marked


def _edited(text: str, edit: Edit, letters: Mapping[str, str]) -> str | None:
    """The print after an edit, if it can be made in its characters."""
    start, stop = edit.at
    before, old, after = text[:start], text[start:stop], text[stop:]
    new = edit.new
    if edit.kind == "sign" and edit.old.kind == "neg" and old.startswith("-"):
        opened = not before.strip() or before.rstrip()[-1] in "=({[&"
        return f"{before}{'' if opened else '+'}{old[1:]}{after}"
    if edit.kind == "sign":
        signed = before.rstrip()
        return f"{signed[:-1] if signed.endswith('+') else before}- {old}{after}"
    if new in (ZERO, ONE) or edit.kind in ("missing term", "missing factor"):
        return _joined(before, old, after, edit, letters)
    return f"{before}{to_latex(new, letters)}{after}"


def _joined(
    before: str, old: str, after: str, edit: Edit, letters: Mapping[str, str]
) -> str | None:
    """A print with a term or a factor more."""
    new, count = edit.new, len(edit.old.args)
    terms = edit.old.args if edit.old.kind == new.kind else (edit.old,)
    if edit.kind == "missing term" and new.kind == "add" and new.args[:-1] == terms:
        added = new.args[-1]
        minus = added.kind == "neg"
        shown = to_latex(added.args[0] if minus else added, letters)
        return f"{before}{old} {'-' if minus else '+'} {shown}{after}"
    if edit.kind == "missing factor" and new.kind == "mul" and not count:
        factors = " ".join(old if it == edit.old else to_latex(it, letters) for it in new.args)
        return (
            f"{before}({factors}){after}" if before.endswith("/") else f"{before}{factors}{after}"
        )
    above, slash, below = old.rpartition("/")
    if edit.kind == "missing factor" and edit.old.kind == "div" and slash:
        further = new.args[1].args[-1]
        return f"{before}{above}/({below} {to_latex(further, letters)}){after}"
    return None
