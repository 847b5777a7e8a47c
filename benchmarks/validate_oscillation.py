"""The numbers of docs/oscillation.md, each by the command that stands beside it.

``python -m benchmarks.validate_oscillation [--quick]`` runs the commands of the page's table and compares what they print with the
number to the last digit that the page shows; the lines of its proofs must be printed as they stand. ``--quick`` leaves out branches
and proofs. Exit code 1 if a number is not the command's.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path
from typing import Any, NamedTuple

from click.testing import CliRunner

from spragsym.cli import cli

PAGE = Path(__file__).parents[1] / "docs" / "oscillation.md"


class Row(NamedTuple):
    """Numbers of the page, as they are written, and the command beside them."""

    what: str
    numbers: tuple[str, ...]
    command: str


def rows() -> Iterator[Row]:
    """The rows of the table whose command is one of ``spragsym cycles``."""
    before = ""
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else []
        if len(cells) != 3:
            continue
        found = re.fullmatch(r"`(spragsym cycles [^`]*)`", cells[2])
        command = before if cells[2] == "the same" else found.group(1) if found else ""
        before = command
        if command:
            yield Row(cells[0], tuple(re.findall(r"\d+\.\d+", cells[1])), command)


def proofs() -> dict[str, list[str]]:
    """Each command with ``--prove`` of a console block, and the lines that it prints there."""
    found: dict[str, list[str]] = {}
    for block in re.findall(r"```console\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL):
        command, *lines = block.splitlines()
        if "--prove" in command:
            found[command.removeprefix("$ ").partition(" | ")[0]] = lines
    return found


def is_quick(row: Row) -> bool:
    """Whether a command finds one cycle only."""
    return "--vary" not in row.command


def printed(command: str) -> str:
    """What a command prints."""
    result = CliRunner().invoke(cli, command.split()[1:], catch_exceptions=False)
    return result.stdout


def numbers_of(thing: Any) -> Iterator[float]:
    """All numbers of JSON."""
    if isinstance(thing, dict | list):
        for part in thing.values() if isinstance(thing, dict) else thing:
            yield from numbers_of(part)
    elif isinstance(thing, float):
        yield thing


def off(written: str, told: list[float]) -> float:
    """How far the nearest number that was printed is from one of the page, in units of its last digit."""
    unit = Decimal(1).scaleb(-len(written.partition(".")[2]))
    return min(float(abs(Decimal(repr(number)) - Decimal(written)) / unit) for number in told)


def differences(row: Row) -> list[str]:
    """Numbers of a row that its command does not print."""
    told = list(numbers_of(json.loads(printed(f"{row.command} --json"))))
    return [f"{row.what}: {number}, {far:.3g} units off" for number in row.numbers if (far := off(number, told)) > 0.5]


def unproved(command: str, lines: list[str]) -> list[str]:
    """Lines of a proof that its command does not print."""
    told = [" ".join(line.split()) for line in printed(command).splitlines()]
    return [f"{command}: {line}" for line in lines if " ".join(line.split()) not in told]


def main() -> None:
    """Run the commands, and print what differs."""
    quick, bad = "--quick" in sys.argv[1:], 0
    for row in rows():
        if is_quick(row) or not quick:
            wrong = differences(row)
            bad += len(wrong)
            print(f"{'; '.join(wrong) or 'as printed'}: {row.what}, {row.command}", flush=True)
    for command, lines in {} if quick else proofs().items():
        wrong = unproved(command, lines)
        bad += len(wrong)
        print(f"{'; '.join(wrong) or 'as printed'}: {command}", flush=True)
    sys.exit(bool(bad))


if __name__ == "__main__":
    main()
