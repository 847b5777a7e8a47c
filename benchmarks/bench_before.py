"""This tree beside another commit, in one run: how long each question takes, and whether the equilibria are the same.

``python -m benchmarks.bench_before REV [--points N] [--only NAMES] [--python INTERPRETER]``: REV is checked out into a temporary
folder, its compiled code is built there if it has any, and a process for each tree answers the same questions in turn: equilibria
of random points by each solver, and those of :mod:`benchmarks.before_questions`, all or those whose names begin with one of NAMES,
as in ``--only folds,cusps``. A commit whose compiled solver needs numba takes it from the interpreter, by default the one that runs
this; what a tree can't be asked is "not there". ``--families`` takes N points of each family instead, cusp wedge and near folds
among them, whose points leave float64.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import numpy as np

from benchmarks.before_worker import COLUMNS
from spragsym.parameters import NAMES
from tests.oracles.families import FAMILIES, random

ROOT = Path(__file__).resolve().parent.parent
#: Slower by more than this share is marked.
ALLOWED = 0.05
#: Ways to solve whose equilibria are compared.
COMPARED = ("equilibria, numpy", "equilibria, compiled")


class Worker:
    """A process that asks the package of one tree: :mod:`benchmarks.before_worker`."""

    def __init__(self, python: str, tree: Path, points: Path, *only: str) -> None:
        environment = os.environ | {"PYTHONPATH": str(tree), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)  # else a new process compiles the package, which has grown
        command = [python, str(Path(__file__).with_name("before_worker.py")), str(tree), str(points)]
        self.process = subprocess.Popen(
            [*command, *only], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment
        )
        self.ways = self._answer().split("\t")

    def ask(self, *words: str) -> str:
        """What it answers to a line of words."""
        assert self.process.stdin is not None
        self.process.stdin.write("\t".join(words) + "\n")
        self.process.stdin.flush()
        return self._answer()

    def _answer(self) -> str:
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            sys.exit(f"the process for {self.process.args!r} ended")
        return line.strip()

    def stop(self) -> None:
        """End it."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        self.process.wait()


@contextmanager
def checkout(rev: str) -> Iterator[Path]:
    """A work tree of a commit in a temporary folder, with its extension modules built."""
    with tempfile.TemporaryDirectory() as name:
        tree = Path(name) / "tree"
        git = ["git", "-C", str(ROOT), "worktree"]
        subprocess.run([*git, "add", "--quiet", "--detach", str(tree), rev], check=True)
        try:
            if "ext-modules" in (tree / "pyproject.toml").read_text(encoding="utf-8"):
                build = [sys.executable, "-c", "import setuptools; setuptools.setup()", "--quiet", "build_ext", "--inplace"]
                subprocess.run(build, cwd=tree, check=True, stdout=subprocess.DEVNULL)
            yield tree
        finally:
            subprocess.run([*git, "remove", "--force", str(tree)], check=True)


def main() -> None:
    """Print both tables."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.bench_before")
    parser.add_argument("rev", help="the commit to compare with")
    parser.add_argument("--points", type=int, default=1_000_000, help="1 000 000 by default")
    parser.add_argument("--families", action="store_true", help="N points of each family instead of random ones")
    parser.add_argument(
        "--only", type=lambda text: text.split(","), default=[], help="beginnings of names, with commas; all by default"
    )
    parser.add_argument("--rounds", type=int, default=7, help="turns of each, of which the best counts; 7 by default")
    parser.add_argument("--python", default=sys.executable, help="interpreter for the commit before, as one that has numba")
    options = parser.parse_args()
    with ExitStack() as stack:
        tree = stack.enter_context(checkout(options.rev))
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        if options.families:
            by_family(options.python, tree, folder, options.points, options.rounds)
            return
        columns = random(np.random.default_rng(1), options.points).broadcast(*NAMES)
        np.save(folder / "points.npy", np.stack(columns))
        trees = ((options.python, tree), (sys.executable, ROOT))
        workers = [Worker(python, where, folder / "points.npy", *options.only) for python, where in trees]
        for worker in workers:
            stack.callback(worker.stop)
        print(f"{options.points:,} random points in contact, {options.rev} and this tree in turn, best of {options.rounds}.\n")
        speed(*workers, options.rounds)
        answers(*workers, folder)


def speed(before: Worker, now: Worker, rounds: int) -> None:
    """How long either tree takes for each question that it has."""
    print("| question | before, µs | now | now / before |")
    print("|---|---:|---:|---|")
    for way in [*now.ways, *(way for way in before.ways if way not in now.ways)]:
        there = [worker for worker in (before, now) if way in worker.ways]
        taken = dict.fromkeys(there, np.inf)
        for turn in range(rounds):
            for worker in there[:: -1 if turn % 2 else 1]:
                taken[worker] = min(taken[worker], float(worker.ask("time", way)))
        cells = [f"{1e6 * taken[worker]:,.0f}" if worker in taken else "not there" for worker in (before, now)]
        share = taken[now] / taken[before] if len(there) == 2 else np.nan
        ratio = f"{share:.2f}" + (", slower" if share > 1 + ALLOWED else "") if np.isfinite(share) else "-"
        print(f"| {way} | {cells[0]} | {cells[1]} | {ratio} |", flush=True)


def by_family(python: str, tree: Path, folder: Path, points: int, rounds: int) -> None:
    """What each rung settles of each family in contact, in percent, and microseconds a point by NumPy and by the compiled solver."""
    print(f"{points:,} points of each family in contact; best of {rounds}.\n")
    print(
        "| family | % by float64, wider, intervals: before | now | "
        + " | ".join(f"µs of {way}: before | now" for way in COMPARED)
        + " |"
    )
    print("|---|---:|---:|" + "---:|" * 2 * len(COMPARED))
    for number, (name, family) in enumerate(FAMILIES.items()):
        file = folder / f"{number}.npy"
        np.save(file, np.stack(family(np.random.default_rng([61, number]), points).broadcast(*NAMES)))
        workers = [Worker(python, tree, file, *COMPARED), Worker(sys.executable, ROOT, file, *COMPARED)]
        cells = [", ".join(worker.ask("rungs", COMPARED[0]).split()) for worker in workers]
        for way in COMPARED:
            taken = [np.inf, np.inf]
            for turn in range(rounds):
                for which in ((0, 1), (1, 0))[turn % 2]:
                    if way in workers[which].ways:
                        taken[which] = min(taken[which], float(workers[which].ask("time", way)))
            cells += [f"{1e6 * spent / points:.3g}" if np.isfinite(spent) else "not there" for spent in taken]
        for worker in workers:
            worker.stop()
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


def answers(before: Worker, now: Worker, folder: Path) -> None:
    """Points whose count or kinds differ, and the largest difference over max(1, |value|)."""
    ways = [way for way in COMPARED if way in before.ways and way in now.ways]
    if not ways:
        return
    print("\n| question | other counts | other kinds | largest difference |")
    print("|---|---|---|---|")
    for way in ways:
        found = []
        for name, worker in (("before", before), ("now", now)):
            path = folder / f"{name}_{way}.npz"
            worker.ask("save", way, str(path))
            with np.load(path) as file:
                found.append({column: file[column] for column in ("count", "stability", *COLUMNS)})
        one, other = found
        counts = int((one["count"] != other["count"]).sum())
        kinds = int((one["stability"] != other["stability"]).any(axis=-1).sum())
        gaps = [np.abs(one[name] - other[name]) / np.maximum(1, np.abs(one[name])) for name in COLUMNS]
        worst = max(float(np.nanmax(gap, initial=0.0)) for gap in gaps)
        print(f"| {way} | {counts} | {kinds} | {worst:.1e} |")


if __name__ == "__main__":
    main()
