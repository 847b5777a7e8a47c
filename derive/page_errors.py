"""The error for a page that can't be derived, and the line of the page that it names."""

from __future__ import annotations

import inspect
import re
import traceback
from pathlib import Path


class PageError(ArithmeticError):
    """A page that can't be derived: its line, what was expected there, and what still works."""

    def __init__(self, line: int, message: str, page: str = "") -> None:
        # Internal symbols begin with an underscore that pages do not have.
        message = re.sub(r"(?<!['\w])_(?=[a-z])", "", message)
        where = ", ".join(filter(None, (page, f"line {line}" if line else "")))
        super().__init__(f"{where}: {message}" if where else message)
        self.line, self.message = line, message

    def of(self, page: str) -> PageError:
        """The same error, with the name of the page."""
        return PageError(self.line, self.message, page)


def line_of_page() -> int:
    """The line of the page that is being run, for errors.

    It is the line of the innermost frame of a page; frames of SymPy may lie above it. A page is
    run and not imported, so that its globals have no ``__spec__``. Without a page it is the line of
    the innermost frame outside this folder.
    """
    # Not inspect.stack, which looks for the module of each frame among all that are loaded: it is
    # asked for every name of a page.
    found = traceback.walk_stack(inspect.currentframe())
    ours = Path(__file__).parent
    outside = [it for it in found if Path(it[0].f_code.co_filename).parent != ours]
    of_page = [it for it in outside if "__spec__" not in it[0].f_globals]
    return next((line for _, line in (*of_page, *outside)), 0)


def refused(message: str) -> PageError:
    """The error for the line of the page that is being run."""
    return PageError(line_of_page(), message)
