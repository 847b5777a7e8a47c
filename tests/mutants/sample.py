"""``python -m tests.mutants.sample N``: faults drawn at random from all rooms of ``spragsym/``, and which tests notice them.

Each fault is written into a copy of the tree, in which the tests run that reach its line, the quickest first, up to the first
failure. Which tests reach a line, and how long they take, comes from one run of all tests, ``--reach``, which is made once.
A fault that the tests of ``make check`` do not notice survives, and is printed. Verdicts are kept in ``build/mutants``: a run
that was ended is taken up where it was.
"""

from __future__ import annotations

import argparse
import ast
import json
import math
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml
from collections import defaultdict
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from queue import SimpleQueue
from typing import TypeAlias

from .operators import Mutant, mutants

#: Tests by file and line.
Reached: TypeAlias = dict[str, dict[int, set[str]]]
ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = ROOT / "build" / "mutants"
#: Seconds of tests in the first process of a mutant; each further one takes that many times as much.
FIRST, GROWTH = 5.0, 4.0
#: Seconds, and multiples of what its tests take, after which a process counts as killed; the memory of one.
SECONDS, TIMES, MEMORY = 60.0, 8.0, 8 << 30
#: What a copy of the tree does without.
LEFT_OUT = (".git", ".venv", "build", ".mypy_cache", ".ruff_cache", ".pytest_cache", ".hypothesis", "__pycache__")


def main() -> int:
    """Draw, run, print; 1 if a fault survives."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutants.sample", description="random faults in all rooms")
    parser.add_argument("count", type=int, nargs="?", default=200, help="how many (200)")
    parser.add_argument("--seed", type=int, default=1, help="of the draw (1)")
    parser.add_argument("--jobs", type=int, default=1, help="faults at a time")
    parser.add_argument("--only", default="", help="those whose key contains this, run whatever is known of them")
    parser.add_argument("--limit", type=float, default=math.inf, help="most seconds of tests that one meets (all)")
    parser.add_argument("--reach", action="store_true", help="run all tests first, to see which of them reach what")
    parser.add_argument("--data", type=Path, default=BUILD, help="folder of reach.coverage and reach.xml")
    given = parser.parse_args()
    if given.reach:
        reach(given.jobs)
    tests, took = reached(given.data)
    journal = BUILD / f"sample-{given.seed}.jsonl"
    journal.parent.mkdir(parents=True, exist_ok=True)
    known = {row["key"]: row for row in map(json.loads, journal.read_text().splitlines())} if journal.exists() else {}
    drawn = draw(given.count, given.seed)
    waiting = [
        one
        for one in drawn
        if given.only in one[0] and (given.only or not known.get(one[0], {}).get("limit", -1.0) >= given.limit)
    ]
    folders: SimpleQueue[Path] = SimpleQueue()
    with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor(given.jobs) as pool:
        for number in range(given.jobs):
            folders.put(_copied(Path(place) / str(number)))

        def run(one: tuple[str, str, Mutant]) -> tuple[str, str, int, float]:
            key, file, mutant = one
            folder, begun, spent = folders.get(), time.monotonic(), 0.0
            some = [
                test
                for test in sorted(meeting(tests, file, mutant.line), key=took.__getitem__)
                if (spent := spent + took[test]) < given.limit
            ]
            try:
                return key, noticed(folder, file, mutant, some, took), len(some), time.monotonic() - begun
            finally:
                folders.put(folder)

        for done in as_completed([pool.submit(run, one) for one in waiting]):
            key, by, count, seconds = done.result()
            known[key] = {"key": key, "by": by, "tests": count, "limit": math.inf if by else given.limit}
            with journal.open("a", encoding="utf-8") as out:
                out.write(json.dumps(known[key], ensure_ascii=False) + "\n")
            print(f"{'killed' if by else 'SURVIVES':8} {seconds:6.1f} s  {key}  [{by or f'{count} tests'}]", flush=True)
    alive = [f"line {mutant.line} of {key}" for key, _, mutant in drawn if key in known and not known[key]["by"]]
    met = sum(key in known for key, _, _ in drawn)
    print(f"\n{met} faults, {met - len(alive)} killed, {len(alive)} survive", *alive, sep="\n  ")
    return 1 if alive else 0


def draw(count: int, seed: int) -> list[tuple[str, str, Mutant]]:
    """Faults with their keys and files, drawn without preference from all there are."""
    every = [
        (f"{file} {mutant.key}", file, mutant)
        for path in sorted((ROOT / "spragsym").rglob("*.py"))
        if not (file := str(path.relative_to(ROOT))).startswith(("spragsym/derive", "spragsym/generated"))
        for mutant in mutants(ast.parse(path.read_text(encoding="utf-8")))
    ]
    print(f"{len(every)} faults in all", flush=True)
    return random.Random(seed).sample(every, count)


def reach(jobs: int) -> None:
    """Run all tests, and keep which of them reach which line."""
    BUILD.mkdir(parents=True, exist_ok=True)
    environment = _environment(ROOT) | {"COVERAGE_FILE": str(BUILD / "reach.coverage")}
    options = ["--dist", "loadfile", "--no-loadscope-reorder", "--cov", "--cov-context=test", "--cov-report="]
    command = [sys.executable, "-m", "pytest", "-n", str(jobs), *options, f"--junitxml={BUILD / 'reach.xml'}"]
    subprocess.run(command, cwd=ROOT, env=environment, check=True)


def reached(folder: Path) -> tuple[Reached, dict[str, float]]:
    """The tests that reach each line of each file, and the seconds of each test."""
    from coverage import CoverageData

    data, took = CoverageData(str(folder / "reach.coverage")), dict[str, float]()
    data.read()
    for case in xml.parse(folder / "reach.xml").iter("testcase"):
        parts = case.attrib["classname"].split(".")
        deep = next(k for k in range(len(parts), 0, -1) if ROOT.joinpath(*parts[:k]).with_suffix(".py").is_file())
        took["::".join(["/".join(parts[:deep]) + ".py", *parts[deep:], case.attrib["name"]])] = float(case.attrib["time"])
    tests: Reached = defaultdict(dict)
    for file in data.measured_files():
        name = "spragsym/" + file.rpartition("/spragsym/")[2]
        for line, contexts in data.contexts_by_lineno(file).items():
            tests[name][line] = {context.partition("|")[0] for context in contexts} & took.keys()
    return tests, took


def meeting(tests: Reached, file: str, line: int) -> set[str]:
    """The tests that run the statement on a line; of one that is run by the import of its module, those that run any of it."""
    parts = [node for node in ast.walk(ast.parse((ROOT / file).read_bytes())) if isinstance(node, ast.stmt)]
    begin = max(node.lineno for node in parts if node.lineno <= line <= (node.end_lineno or node.lineno))
    return set(tests[file].get(begin, ())) or {test for each in tests[file].values() for test in each}


def noticed(folder: Path, file: str, mutant: Mutant, tests: list[str], took: dict[str, float]) -> str:
    """The processes' first failure: its test, or what ended it; empty where all pass."""
    path = folder / file
    sound = path.read_bytes()
    path.write_bytes(broken(sound, mutant.key))
    try:
        for part, seconds in _parts(tests, took):
            failed = _failed(folder, part, SECONDS + TIMES * seconds)
            if failed:
                return failed
    finally:
        path.write_bytes(sound)
    return ""


def broken(sound: bytes, key: str) -> bytes:
    """The text of a module with a fault, all else as it stands."""
    tree = ast.parse(sound)
    mutant = next(one for one in mutants(tree) if one.key == key)
    held = getattr(mutant.parent, mutant.field)
    node, lines = held if mutant.index is None else held[mutant.index], sound.splitlines(keepends=True)
    begin, end = (
        sum(map(len, lines[: line - 1])) + column
        for line, column in ((node.lineno, node.col_offset), (node.end_lineno, node.end_col_offset))
    )
    other = ast.unparse(ast.fix_missing_locations(mutant.other))
    text = f"({other})" if isinstance(mutant.other, ast.expr) else other
    return sound[:begin] + text.encode() + sound[end:]


def _parts(tests: list[str], took: dict[str, float]) -> Iterator[tuple[list[str], float]]:
    part, total, limit = [], 0.0, FIRST
    for test in tests:
        part.append(test)
        total += took.get(test, 0.0)
        if total > limit:
            yield sorted(part), total
            part, total, limit = [], 0.0, limit * GROWTH
    if part:
        yield sorted(part), total


def _failed(folder: Path, tests: list[str], seconds: float) -> str:
    names = folder / "build" / "tests.txt"
    names.parent.mkdir(exist_ok=True)
    names.write_text("\n".join(tests), encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-rfE", "--tb=no", "-p", "no:cacheprovider", f"@{names}"]
    try:
        done = subprocess.run(
            command, cwd=folder, env=_environment(folder), capture_output=True, text=True, timeout=seconds,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY)),
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return "time"
    if done.returncode in (0, 5):
        return ""
    if "not found: " in done.stderr:
        raise RuntimeError(f"tests have other names than those of the run that told what they reach:\n{done.stderr}")
    said = [line.split(" - ")[0] for line in done.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    return said[0] if said else f"exit {done.returncode}"


def _environment(folder: Path) -> dict[str, str]:
    kept = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "HYPOTHESIS_PROFILE": "all", "PYTHONDONTWRITEBYTECODE": "1"}
    return os.environ | kept | {"PYTHONPATH": str(folder)}


def _copied(folder: Path) -> Path:
    shutil.copytree(ROOT, folder, symlinks=True, ignore=shutil.ignore_patterns(*LEFT_OUT, "*.pyc"))
    return folder


if __name__ == "__main__":
    sys.exit(main())
