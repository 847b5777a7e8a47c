"""Long campaigns in parts: finished ones stand in a file, so that a campaign may be stopped, or bounded in time, and gone on with."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any


def finished(path: Path) -> dict[str, Any]:
    """What each finished part gave; a line that was cut off by a kill is left out."""
    found = {}
    if path.is_file():
        for line in path.read_text(encoding="utf-8").splitlines():
            try:
                name, result = json.loads(line)
            except ValueError:
                continue
            found[name] = result
    return found


def run(parts: Iterable[str], work: Callable[[str], Any], store: str = "", seconds: float = float("inf")) -> dict[str, Any]:
    """The results of all parts that are done, by name; those not in ``store`` are done until the time is over."""
    names, begin = list(parts), time.monotonic()
    path = Path(store) if store else None
    done = {} if path is None else {name: result for name, result in finished(path).items() if name in names}
    for name in names:
        if name in done:
            continue
        if time.monotonic() - begin > seconds:
            break
        done[name] = work(name)
        if path is not None:
            with path.open("a", encoding="utf-8") as file:
                file.write(json.dumps([name, done[name]]) + "\n")
        print(f"\r{len(done)} of {len(names)} parts, {time.monotonic() - begin:.0f} s", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return done


def journal(path: Path) -> list[dict[str, Any]]:
    """The finished lines of a file, one result each; a line that was cut short is dropped."""
    if not path.is_file():
        return []
    whole = [line for line in path.read_text(encoding="utf-8").splitlines(keepends=True) if line.endswith("\n")]
    path.write_text("".join(whole), encoding="utf-8")
    return [json.loads(line) for line in whole]


def numbered(
    path: Path, numbers: Iterable[int], work: Callable[[int], dict[str, Any]], enough: Callable[[Any], bool] = lambda lines: False
) -> list[dict[str, Any]]:
    """The results of all numbers, which say theirs as ``number``, until they are enough: those of the file, and further ones."""
    lines = journal(path)
    done = {line["number"] for line in lines}
    for number in numbers:
        if enough(lines):
            break
        if number not in done:
            lines.append(work(number))
            with path.open("a", encoding="utf-8") as file:
                file.write(json.dumps(lines[-1]) + "\n")
            print(lines[-1], file=sys.stderr, flush=True)
    return lines
