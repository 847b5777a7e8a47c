"""Papers of few statements, made in tests."""

from collections.abc import Iterable, Mapping
from typing import Any

from spragsym.derive.pages import PageModel
from spragsym.derive.statements import verdicts
from spragsym.derive.statements.papers import Paper, Statement

#: What a statement is about, its text, and more of it by name.
Print = tuple[str, str] | tuple[str, str, Mapping[str, Any]]


def paper(
    prints: Iterable[Print],
    renamed: Mapping[str, str] | None = None,
    conventions: Mapping[str, str] | None = None,
    **each: Any,
) -> Paper:
    """A paper of these prints, in LaTeX where one of them has a backslash, with what is the same in
    ``each`` of its statements.
    """
    prints = [*prints]
    each = {"is_latex": any("\\" in text for _, text, *_ in prints), **each}
    found = []
    for number, (about, text, *more) in enumerate(prints):
        found.append(Statement(str(number), about, text, **each | dict(*more)))
    return Paper("", "", renamed or {}, tuple(found), conventions or {})


def rows(
    model: PageModel, *prints: Print, renamed: Mapping[str, str] | None = None, **each: Any
) -> tuple[verdicts.Row, ...]:
    """The verdicts on them."""
    return verdicts.check(paper(prints, renamed, **each), model).rows
