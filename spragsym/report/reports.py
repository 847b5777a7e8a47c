"""The report of a study: what is said of its facts, as a sentence, a text, a page or JSON."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import nullcontext
from pathlib import Path
from typing import Any

from .._version import __version__
from ..display import Table
from ..errors import ParameterError
from ..files.writing import put
from ..progress import doing, show_progress
from ..results.result import Result
from . import report_json, texts
from .cautions import cautions
from .facts import Asked, Facts
from .next_steps import next_steps
from .study import Study


class Report(Facts, Result):
    """Report on a brake; what its model does not answer is None, with the reason among ``warnings``.

    What is computed is an attribute.
    """

    @property
    def vary(self) -> str | None:
        """The quantity that rises."""
        return None if self.study.rise is None else self.study.rise.quantity

    @property
    def mu_jump(self) -> float | None:
        """Where it jumps, of friction."""
        return self.jump_at if self.study.of_friction else None

    @property
    def mu0_jump(self) -> float | None:
        """The parameter mu0 there."""
        return self._jump if self.study.of_friction else None

    @property
    def mu_effective(self) -> float:
        """The friction that works."""
        return self.study.friction[1]

    @property
    def margin_percent(self) -> float | None:
        """By how much the jump lies beyond the largest value within the tolerances."""
        return None if self.jump_at is None else texts.percent_beyond(self.jump_at, self.study.working[2])

    @property
    def warnings(self) -> tuple[str, ...]:
        """Where an answer would mislead, or is not known."""
        return (*cautions(self), *self.remarks)

    @property
    def verdict(self) -> str:
        """Whether it sprags, at what friction, and how far that is; then what other states, motion and tolerances add."""
        return " ".join(texts.verdict(self))

    @property
    def about(self) -> dict[str, str]:
        """Title and date, as the file gives them, the file, its model, and the version of spragsym."""
        study = self.study
        model = f"model {study.kind.about['name']}"
        return {
            "title": study.title,
            "date": study.date,
            "file": study.source,
            "model": model,
            "version": f"spragsym {__version__}",
        }

    @property
    def next_steps(self) -> tuple[str, ...]:
        """What to do next, at most five steps."""
        return tuple(f"{verb} {what}" for verb, what in next_steps(self))

    def blocks(self) -> Iterator[str]:
        """The text of the report, piece by piece, each as soon as it is computed; the verdict first."""
        return texts.blocks(self)

    def to_dict(self) -> dict[str, Any]:
        """The report as JSON has it: numbers, texts, lists and dictionaries; quantities in the units of the file."""
        return report_json.as_json(self)

    def text(self) -> str:
        """The report as text: the verdict, then the numbers."""
        return "\n".join(self.blocks())

    def to_html(self, path: str | os.PathLike[str]) -> None:
        """Write the report as one page with its pictures (extra ``plot``)."""
        import spragsym  # a shorthand for what a user asks the package: no room imports one behind it

        put(Path(path), spragsym.figures.report_page(self))

    def as_table(self) -> Table:
        """The rows of its text."""
        return Table(self.verdict, ("", "value"), tuple(row for _, rows in texts.sections(self) for row in rows))

    def _for_file(self) -> Report:
        raise ParameterError("path: a report is computed anew from its study; write to_html(path), or json.dumps(to_dict())")

    def table_values(self) -> dict[str, Any]:
        """It has no columns."""
        return {}

    def __str__(self) -> str:
        return self.text()

    def __repr__(self) -> str:
        return f"Report({self.verdict!r}, {self.study!r})"


def report(study: Study, asked: Asked, progress: bool = False, *, now: bool = True) -> Report:
    """The report of a study; see :meth:`Study.report`. Unless ``now``, what it says is computed when it is asked for."""
    if study.friction[2] == 0 and study.kind.of_mu0 and study.quantities["mu0"].high > 0:
        law = " and ".join(study.kind.of_the_law)
        without = f", or leave {law} out for friction at full slip" if law else ""
        speed = study.shown_speed(study.values[study.belt or "V"])
        raise ParameterError(f"{speed}: nothing slides at that speed; give the speed of the belt{without}")
    found = Report(study, asked)
    if now:
        with show_progress() if progress else nullcontext(), doing(""):
            for _ in found.blocks():
                pass
    return found
