"""The numbers of docs/oscillation.md, each by the command that stands beside it.

What a command prints, or gives in Python, is compared with the number to the last digit that the
page shows; the lines of its proofs must be printed as they stand.
"""

import functools
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from spragsym.results.result import Result

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "oscillation.md"

#: What finds one cycle, or less, and what takes minutes all the same.
QUICK, SLOW = ("spragsym cycles", "ss.", "[ss.", "abs("), ("--vary", "t_end=", "fate")

NUMBER = r"(?<![\w.₀-₉])\d+(?:\.\d+)?(?:e-?\d+)?(?![\d₀-₉])"


class Row(NamedTuple):
    """Numbers of the page, as they are written, and the command beside them."""

    what: str
    numbers: tuple[str, ...]
    command: str


def cells() -> Iterator[list[str]]:
    """The rows of all tables, their heads included."""
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        if line.startswith("|"):
            yield [cell.strip() for cell in line.strip("|").split("|")]


def rows() -> Iterator[Row]:
    """The rows of the table of commands; seconds are those of a machine, and bounds are for the
    command itself to keep.
    """
    before = ""
    for what, numbers, command in (
        row for row in cells() if len(row) == 3 and row[2].startswith(("`", "the same"))
    ):
        before = before if command == "the same" else command.strip("`")
        yield Row(
            what,
            ()
            if what.startswith("seconds")
            else tuple(re.findall(NUMBER, re.sub(r"below \S+", "", numbers))),
            before,
        )


def proofs() -> dict[str, list[str]]:
    """Each command with ``--prove`` of a console block, and the lines that it prints there."""
    found: dict[str, list[str]] = {}
    for block in re.findall(r"```console\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL):
        command, *lines = block.splitlines()
        if "--prove" in command:
            found[command.removeprefix("$ ").partition(" | ")[0]] = lines
    return found


def is_quick(row: Row) -> bool:
    """Whether a command takes no time."""
    return row.command.startswith(QUICK) and not any(word in row.command for word in SLOW)


@functools.cache
def printed(command: str, folder: Path = Path()) -> str:
    """What a command prints, and writes as tables below ``FOLDER``."""
    words = command.replace("FOLDER", str(folder)).split()
    if words[0] == "spragsym":
        text = CliRunner().invoke(cli, words[1:], catch_exceptions=False).stdout
    else:
        done = subprocess.run(
            [sys.executable, *words[1:]], capture_output=True, text=True, cwd=ROOT, check=False
        )
        text = done.stdout
        if done.returncode:
            raise RuntimeError(
                f"{command} ends with {done.returncode}: "
                f"{(done.stdout + done.stderr).strip()[-500:]}"
            )
    out = Path(words[words.index("--out") + 1]) if "--out" in words else None
    return text + "".join(
        file.read_text(encoding="utf-8") for file in (sorted(out.rglob("*.csv")) if out else ())
    )


def numbers_of(thing: Any) -> Iterator[float]:
    """All numbers of JSON, or of a result and what it holds."""
    if isinstance(thing, dict | list | tuple):
        for part in thing.values() if isinstance(thing, dict) else thing:
            yield from numbers_of(part)
    elif isinstance(thing, np.ndarray):
        yield from (float(number) for number in thing.real.ravel() if thing.dtype.kind in "iufc")
    elif isinstance(thing, int | float):
        yield float(thing)
    elif isinstance(thing, Result):
        yield from numbers_of(vars(thing))


def told(row: Row, folder: Path) -> list[float]:
    """The numbers that the command of a row gives, angles of Python in degrees as well."""
    if row.command.startswith("spragsym cycles"):
        return list(numbers_of(json.loads(printed(f"{row.command} --json"))))
    if not row.command.startswith(("ss.", "[ss.", "abs(")):
        return [
            float(number)
            for number in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", printed(row.command, folder))
        ]
    # the page is ours
    found = list(numbers_of(eval(row.command, {"ss": ss, "np": np})))  # noqa: S307
    return [*found, *np.degrees(found).tolist()]


def off(written: str, told: list[float]) -> float:
    """How far the nearest number that was printed is from one of the page in size, in units of its
    last digit.
    """
    mantissa, _, power = written.partition("e")
    unit = Decimal(1).scaleb(int(power or 0) - len(mantissa.partition(".")[2]))
    return min(
        float(abs(abs(Decimal(repr(float(number)))) - Decimal(written)) / unit)
        for number in told
        if np.isfinite(number)
    )


def differences(row: Row, folder: Path = Path()) -> list[str]:
    """Numbers of a row that its command does not print."""
    found = told(row, folder)
    return [
        f"{row.what}: {number}, {far:.3g} units off"
        for number in row.numbers
        if (far := off(number, found)) > 0.5
    ]


def unproved(command: str, lines: list[str]) -> list[str]:
    """Lines of a proof that its command does not print."""
    told = [" ".join(line.split()) for line in printed(command).splitlines()]
    return [f"{command}: {line}" for line in lines if " ".join(line.split()) not in told]
