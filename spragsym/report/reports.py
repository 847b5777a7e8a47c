"""The report of a study: its facts, stated as text, page and JSON."""

from __future__ import annotations

import os

from ..core.errors import ParameterError
from ..display import Table
from ..files.storage import put
from ..results import Result
from . import texts
from .advice import next_steps, warnings
from .facts import Facts


class Report(Facts, Result):
    """Report on a brake: its facts are attributes; text, page and JSON state them."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences on where an answer would mislead, or is not known."""
        return warnings(self)

    @property
    def verdict(self) -> str:
        """Sentences on the jump, on other states, on the motion and on the tolerances."""
        return " ".join(texts.verdict(self))

    @property
    def about(self) -> dict[str, str]:
        """Title, date and file, as they were given, the model, and the version of spragsym."""
        return texts.about(self)

    @property
    def next_steps(self) -> tuple[str, ...]:
        """What to do next, at most five steps."""
        return tuple(f"{verb} {what}" for verb, what in next_steps(self))

    def to_dict(self) -> texts.Json:
        """The report as JSON has it; quantities in the units of the file."""
        return texts.as_json(self)

    def text(self) -> str:
        """The report as text: the verdict, then the numbers."""
        return "\n".join(texts.blocks(self))

    def to_html(self, path: str | os.PathLike[str]) -> None:
        """Write the report as one page with its pictures (extra ``plot``)."""
        import spragsym  # a shorthand: no room imports one behind it

        put(path, spragsym.figures.report_page(self))

    def as_table(self) -> Table:
        """The rows of its text."""
        return Table(
            self.verdict,
            ("", "value"),
            tuple(row for _, rows in texts.sections(self) for row in rows),
        )

    def _for_file(self) -> Report:
        raise ParameterError(
            "path: a report is computed anew from its study; "
            "write to_html(path), or json.dumps(to_dict())"
        )

    def _shown(self) -> texts.Json:
        """It has no columns."""
        return {}

    __str__ = text

    def __repr__(self) -> str:
        return f"Report({self.verdict!r}, {self.study!r})"
