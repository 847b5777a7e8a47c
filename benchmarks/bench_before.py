"""The solvers of this tree beside those of another commit, in one run: time a point, and whether the answers are the same.

``python -m benchmarks.bench_before REV [--points N] [--python INTERPRETER]``: REV is checked out into a temporary folder, its
compiled solver is built there if it has one, and a process for each tree solves the same random points in turn. A commit whose
compiled solver needs numba takes it from the interpreter, by default the one that runs this; without it that row is left out.
``--families`` takes N points of each family instead, cusp wedge and near folds among them, whose points leave float64.
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
from benchmarks.families import FAMILIES, random
from spragsym.parameters import NAMES

ROOT = Path(__file__).resolve().parent.parent
#: Slower by more than this share is marked.
ALLOWED = 0.05


class Worker:
    """A process that solves points with the package of one tree: :mod:`benchmarks.before_worker`."""

    def __init__(self, python: str, tree: Path, points: Path, *only: str) -> None:
        environment = os.environ | {"PYTHONPATH": str(tree), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        command = [python, str(Path(__file__).with_name("before_worker.py")), str(tree), str(points)]
        command += [",".join(only)] if only else []
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)
        self.ways = self._answer().split(",")

    def ask(self, *words: str) -> str:
        """What it answers to a line of words."""
        assert self.process.stdin is not None
        self.process.stdin.write(" ".join(words) + "\n")
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
    """A work tree of a commit in a temporary folder, with its extension module built."""
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
        workers = [Worker(options.python, tree, folder / "points.npy"), Worker(sys.executable, ROOT, folder / "points.npy")]
        for worker in workers:
            stack.callback(worker.stop)
        print(f"{options.points:,} random points in contact, {options.rev} and this tree in turn, best of {options.rounds}.\n")
        speed(*workers, options.points, options.rounds)
        print()
        answers(*workers, folder)


def speed(before: Worker, now: Worker, points: int, rounds: int) -> None:
    """Nanoseconds a point of each way that either tree has."""
    ways = [*now.ways, *(way for way in before.ways if way not in now.ways)]
    taken = {(worker, way): np.inf for worker in (before, now) for way in worker.ways}
    for turn in range(rounds):
        for way in ways:
            for worker in ((before, now), (now, before))[turn % 2]:
                if way in worker.ways:
                    taken[worker, way] = min(taken[worker, way], float(worker.ask("time", way)))
    print("| solver | before, ns a point | now | now / before |")
    print("|---|---|---|---|")
    for way in ways:
        cells = [f"{1e9 * taken[worker, way] / points:,.0f}" if way in worker.ways else "not there" for worker in (before, now)]
        ratio = "-"
        if way in before.ways and way in now.ways:
            share = taken[now, way] / taken[before, way]
            ratio = f"{share:.2f}" + (", slower" if share > 1 + ALLOWED else "")
        print(f"| {way.replace('_', ' ')} | {cells[0]} | {cells[1]} | {ratio} |")


def by_family(python: str, tree: Path, folder: Path, points: int, rounds: int) -> None:
    """What each rung settles of each family in contact, in percent, and microseconds a point by NumPy and by the compiled solver."""
    ways = ("numpy", "compiled")
    print(f"{points:,} points of each family in contact; best of {rounds}.\n")
    print(
        "| family | % by float64, wider, intervals: before | now | "
        + " | ".join(f"µs, {way}: before | now" for way in ways)
        + " |"
    )
    print("|---|---:|---:|" + "---:|" * 2 * len(ways))
    for number, (name, family) in enumerate(FAMILIES.items()):
        file = folder / f"{number}.npy"
        np.save(file, np.stack(family(np.random.default_rng([61, number]), points).broadcast(*NAMES)))
        workers = [Worker(python, tree, file, *ways), Worker(sys.executable, ROOT, file, *ways)]
        cells = [", ".join(worker.ask("rungs", "numpy").split()) for worker in workers]
        for way in ways:
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
    print("| solver | other counts | other kinds | largest difference |")
    print("|---|---|---|---|")
    for way in ("numpy", "compiled"):
        if way not in before.ways or way not in now.ways:
            continue
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
