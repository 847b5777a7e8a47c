"""``python -m tests.conformance``: the table of all public questions and all models.

``closed`` and ``search`` are ways to an answer, the one that is taken first stands first; ``-`` is
``ModelError``.

``python -m tests.conformance PAGE.py|DIR ... [OPTIONS OF PYTEST]``: the table of these models, and
the whole suite for each of them; the exit code is that of the tests.
"""

import os
import subprocess
import sys
from itertools import takewhile
from pathlib import Path

import spragsym as ss
from tests.conformance import models
from tests.conformance.test_questions import TABLE, Asked, questions


def ways(model: ss.Model, name: str, general: bool) -> tuple[str, ...]:
    """How a model answers a question."""
    own = name in model.closed or (not general and bool(model.closed))
    return (*["closed"] * own, *["search"] * general)


def table(asked: list[ss.Model]) -> list[list[str]]:
    """A row for each question."""
    of_article = TABLE[Asked.article].split()
    rows = (
        [name, *("+".join(ways(model, name, name not in of_article)) or "-" for model in asked)]
        for name in questions()
    )
    return [["", *(model.name for model in asked)], *rows]


def main() -> int:
    """Print it; then run the tests for what is named."""
    if {"-h", "--help"} & set(sys.argv):
        print(__doc__)
        return 0
    named = list(takewhile(lambda word: not word.startswith("-"), sys.argv[1:]))
    asked = [ss.load(models.folder_of(page)) for page in named]
    rows = table(asked or [models.load(name) for name in models.MODELS])
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        print(
            "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip(),
            flush=True,
        )
    if not asked:
        return 0
    # In a process of its own, in which the models are those asked for, without workers too.
    os.environ[models.ASKED] = os.pathsep.join(model.where for model in asked)
    tests = [sys.executable, "-m", "pytest", str(Path(__file__).parent)]
    workers = str(min(4, os.cpu_count() or 1))
    return subprocess.call([*tests, "-n", workers, *sys.argv[1 + len(named) :]])


if __name__ == "__main__":
    sys.exit(main())
