"""``python -m tests.mutations [--jobs N] [--only K,K] PYTEST ARGUMENTS``: single faults, each against the tests that are named.

The 150 faults of tests/mutations.txt are drawn from all rooms of ``spragsym``; ``--draw SEED`` draws them anew. Each stands
there by its file, line and column, what is replaced by what, and the text of its line, by which it is found where code has
moved, and of some by why no test can notice them. It prints which are noticed and by what, and ends with 1 if any other is not.
Each job works in a copy of the tree.
"""

from __future__ import annotations

import argparse
import ast
import itertools
import os
import queue
import random
import shutil
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
LIST = Path(__file__).with_suffix(".txt")
COUNT = 150
#: Seconds after which a fault counts as noticed: the tests that are named have to take far less.
PATIENCE = 1800.0
_PAIRS = "+ -, * /, < <=, > >=, == !=, is is_not, in not_in, and or, min max, any all, True False, & |"
OTHER = {
    one.replace("_", " "): other.replace("_", " ")
    for pair in _PAIRS.split(", ")
    for one, other in itertools.permutations(pair.split())
}
OTHER |= {"//": "*", "%": "*", "**": "*", "@": "-"}


class Fault(NamedTuple):
    """A line of a file, a column of its text, what stands there, what is put in its place, that text, and why none can see it."""

    file: str
    line: int
    column: int
    old: str
    new: str
    text: str
    why: str = ""


def faults(file: str, source: str) -> Iterator[Fault]:
    """All single faults of a module: an operator, a number, a truth value, a negation, or min for max."""
    lines, tree = source.splitlines(), ast.parse(source)
    left_out = {id(part) for node in ast.walk(tree) for part in _left_out(node)}

    def fault(number: int, at: int, old: str, new: str) -> Fault:
        text = lines[number - 1].strip()
        return Fault(file, number, at - lines[number - 1].index(text), old, new, text)

    def column(number: int, offset: int) -> int:
        return len(lines[number - 1].encode()[:offset].decode())

    for node in ast.walk(tree):
        if id(node) in left_out:
            continue
        for one, other in itertools.pairwise(_operands(node)):
            if one.end_lineno == other.lineno:
                end = column(other.lineno, one.end_col_offset or 0)
                between = lines[other.lineno - 1][end : column(other.lineno, other.col_offset)]
                old = between.strip("() ")
                if old in OTHER:
                    yield fault(other.lineno, end + between.index(old), old, OTHER[old])
        old, new = _word(node)
        if old and isinstance(node, ast.expr):
            at = column(node.lineno, node.col_offset)
            if lines[node.lineno - 1][at:].startswith(old):
                yield fault(node.lineno, at, old, new)


def _operands(node: ast.AST) -> list[ast.expr]:
    """Operands in a row, with an operator between each two."""
    if isinstance(node, ast.BinOp):
        return [node.left, node.right]
    return (
        [node.left, *node.comparators] if isinstance(node, ast.Compare) else node.values if isinstance(node, ast.BoolOp) else []
    )


def _word(node: ast.AST) -> tuple[str, str]:
    """What of a node may be replaced at its beginning, and by what."""
    match node:
        case ast.Constant(value=bool(value)):
            return str(value), OTHER[str(value)]
        case ast.Constant(value=int(value)):
            return repr(value), str(value + 1)
        case ast.Constant(value=float(value)):
            return repr(value), repr(1.5 * value if value else 1.0)
        case ast.UnaryOp(op=ast.Not()):
            return "not ", ""
        case ast.Name(id=name) if name in OTHER:
            return name, OTHER[name]
    return "", ""


def _left_out(node: ast.AST) -> Iterator[ast.AST]:
    """Annotations, what an error says, and parts of texts, in which nothing is computed."""
    names = () if isinstance(node, ast.JoinedStr) else ("annotation", "returns", "exc")
    parts = [getattr(node, name, None) for name in names] or [node]
    for part in [*parts, *getattr(node, "decorator_list", ())]:
        yield from ast.walk(part) if isinstance(part, ast.AST) else ()


def sources(tree: Path) -> list[Path]:
    """The modules of the package, but for the derivation and what it wrote."""
    return sorted(path for path in (tree / "spragsym").rglob("*.py") if not {"derive", "generated"} & set(path.parts))


def draw(seed: int) -> list[Fault]:
    """As many of each room as of another, as far as there are."""
    rooms: dict[str, list[Fault]] = defaultdict(list)
    for path in sources(ROOT):
        file, parts = path.relative_to(ROOT).as_posix(), path.relative_to(ROOT).parts
        rooms[parts[1] if len(parts) > 2 else "modules"] += faults(file, path.read_text(encoding="utf-8"))
    rng, chosen = random.Random(seed), list[Fault]()
    for number, name in enumerate(sorted(rooms, key=lambda name: len(rooms[name]))):
        share = -(-(COUNT - len(chosen)) // (len(rooms) - number))
        chosen += rng.sample(rooms[name], min(share, len(rooms[name])))
    return sorted(chosen[:COUNT])


def listed() -> list[Fault]:
    """The faults of the list."""
    rows = [line.split("\t") for line in LIST.read_text(encoding="utf-8").splitlines()]
    return [Fault(file, int(line), int(column), *rest) for file, line, column, *rest in rows]


def place(tree: Path, fault: Fault) -> tuple[Path, int] | None:
    """The file and line of a fault: where it was, or the nearest line of the same text, or the only such line of the package."""
    every = [
        (path, number)
        for path in sources(tree)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines())
        if line.strip() == fault.text
    ]
    here = [(path, number) for path, number in every if path == tree / fault.file]
    return min(here, key=lambda one: abs(one[1] - fault.line + 1)) if here else every[0] if len(every) == 1 else None


def noticed(tree: Path, fault: Fault, arguments: list[str]) -> str:
    """The first test that fails, or what ended the tests; "gone" where the line is no more, empty where nothing is noticed."""
    found = place(tree, fault)
    if found is None:
        return "gone"
    path, number = found
    sound = path.read_text(encoding="utf-8")
    lines = sound.splitlines(keepends=True)
    at = lines[number].index(fault.text) + fault.column
    lines[number] = lines[number][:at] + fault.new + lines[number][at + len(fault.old) :]
    path.write_text("".join(lines), encoding="utf-8")
    environment = os.environ | {"PYTHONPATH": str(tree), "PYTHONDONTWRITEBYTECODE": "1", "HYPOTHESIS_PROFILE": "repeat"}
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-n0", "-rfE", "--tb=no", "-p", "no:cacheprovider", *arguments]
    try:
        done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        return "time"
    finally:
        path.write_text(sound, encoding="utf-8")
    said = [line.split(" - ")[0] for line in done.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    return "" if done.returncode in (0, 5) else said[0] if said else f"exit {done.returncode}"


def main() -> int:
    """Exit code 1 if a fault is not noticed."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutations")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--draw", type=int, metavar="SEED", help="write the list anew")
    parser.add_argument("--only", default="", help="numbers of faults, from 1, with commas")
    given, arguments = parser.parse_known_args()
    if given.draw is not None:
        rows = ["\t".join(map(str, fault)) for fault in draw(given.draw)]
        LIST.write_text("\n".join(rows) + "\n", encoding="utf-8")
        return 0
    chosen = dict(enumerate(listed(), 1))
    numbers = [int(part) for part in given.only.split(",") if part] or list(chosen)
    alive, gone = list[int](), 0
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(given.jobs) as pool:
        trees: queue.SimpleQueue[Path] = queue.SimpleQueue()
        for job in range(given.jobs):
            left_out = shutil.ignore_patterns(".git", ".venv", "build", "node_modules", "__pycache__")
            trees.put(Path(shutil.copytree(ROOT, Path(name) / str(job), symlinks=True, ignore=left_out)))

        def run(number: int) -> tuple[int, str]:
            tree = trees.get()
            try:
                return number, noticed(tree, chosen[number], arguments)
            finally:
                trees.put(tree)

        for done in as_completed([pool.submit(run, number) for number in numbers]):
            number, by = done.result()
            fault = chosen[number]
            alive += [number] * (not by and not fault.why)
            gone += by == "gone"
            told = by or (f"SURVIVES, as it may ({fault.why})" if fault.why else "SURVIVES")
            print(f"{number:3} {told}: {fault.file}:{fault.line}: {fault.old} -> {fault.new}: {fault.text}", flush=True)
    print(f"{len(numbers)} faults, {gone} gone, {len(alive)} survive: {', '.join(map(str, sorted(alive)))}")
    return 1 if alive else 0


if __name__ == "__main__":
    sys.exit(main())
