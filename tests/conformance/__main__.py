"""The table of all public questions and all models, shipped or named by folders: ``python -m tests.conformance [DIR ...]``.

``closed`` and ``search`` are ways to an answer, the one that is taken first stands first; ``-`` is ``ModelError``.
"""

from __future__ import annotations

import sys

import spragsym as ss
from spragsym import door
from spragsym.models.load import shipped


def ways(model: ss.Model, name: str) -> tuple[str, ...]:
    """How a model answers a question."""
    general = getattr(getattr(ss.Model, name), "__wrapped__", None)
    found = ["closed"] * (name in model.closed) + ["search"] * getattr(general, "answered", True)
    return tuple(found)


def table(models: list[ss.Model]) -> list[list[str]]:
    """A row for each question."""
    head = ["", *(model.name for model in models)]
    return [head, *([name, *("+".join(ways(model, name)) or "-" for model in models)] for name in sorted(door.INTERFACE))]


def main() -> None:
    """Print it."""
    rows = table([ss.load(name) for name in (*shipped(), *sys.argv[1:])])
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip())


if __name__ == "__main__":
    main()
