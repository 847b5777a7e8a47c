"""The code that decides the bits of a sweep's results: a store made by different code is not resumed."""

import hashlib
from collections.abc import Iterator
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable

#: What a motion's record is made by: rooms, and single modules. ``test_sweeps`` compares them with what is imported.
DECIDING = (
    "generated", "kang_nam", "models", "motion", "numerics", "results", "statics", "questions.py",
)  # fmt: skip


@cache
def digest(*further: str) -> str:
    """SHA-256 of the text of all modules that decide a record, whatever their line ends are; ``further`` places among them."""
    package = files(__package__.partition(".")[0])
    total = hashlib.sha256()
    for name, module in sorted(found for place in (*DECIDING, *further) for found in _modules(package, place)):
        total.update(f"{name}\n".encode() + module.read_bytes().replace(b"\r\n", b"\n"))
    return total.hexdigest()


def _modules(package: Traversable, place: str) -> Iterator[tuple[str, Traversable]]:
    """Name and text of a module, or of all modules of a room."""
    there = package.joinpath(place)
    if place.endswith(".py"):
        yield place, there
    elif there.is_dir():
        for inner in there.iterdir():
            yield from _modules(package, f"{place}/{inner.name}")
