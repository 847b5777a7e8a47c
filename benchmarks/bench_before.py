"""This tree beside another commit, in one run: how long each question takes, and whether the
equilibria are the same.

``python -m benchmarks.bench_before REV [--points N] [--rounds N] [--only PARAMETERS]``: REV is checked
out into a temporary folder, its compiled code is built there, and a process for each tree is asked
the questions in turn, all or those whose names begin with one of PARAMETERS, as in
``--only folds,cusps``. A question that raises is "not there". asv builds an environment for each
commit, times the commits one after the other, and compares no answers.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import numpy as np

from spragsym.generated.quantities import PARAMETERS
from tests.oracles.families import random

ROOT = Path(__file__).resolve().parent.parent
#: Slower by more than this share is marked.
ALLOWED = 0.05
#: What both trees are asked; ``many`` are all points, ``some`` 300 of them, ``few`` 30 sets of one
#: point each.
QUESTIONS = {
    "equilibria, numpy": "ss.kang_nam.set_backend('numpy', 1), ss.equilibria(many)",
    "equilibria, compiled": "ss.kang_nam.set_backend('compiled', 1), ss.equilibria(many)",
    "equilibria, compiled, 2 threads": "ss.kang_nam.set_backend('compiled', 2), ss.equilibria(many)",
    "equilibria of one point, numpy": "ss.kang_nam.set_backend('numpy', 1), ss.equilibria(one)",
    "equilibria of one point, compiled": "ss.kang_nam.set_backend('compiled', 1), ss.equilibria(one)",
    "count, numpy": "ss.kang_nam.set_backend('numpy', 1), ss.count(many)",
    "count, compiled": "ss.kang_nam.set_backend('compiled', 1), ss.count(many)",
    "folds along theta0": "ss.folds(one, 'theta0')",
    "folds along mu0": "ss.folds(one, 'mu0')",
    "folds along theta0, 30 points": "[ss.folds(p, 'theta0') for p in few]",
    "folds of cubic_contact": "ss.folds(cubic, 'theta0')",
    "cusps": "ss.cusps(one)",
    "cusps, 30 points": "[ss.cusps(p) for p in few]",
    "cusps of cubic_contact": "ss.cusps(cubic)",
    "flutter_onsets": "ss.flutter_onsets(flutters, damping=False)",
    "flutter_onsets, 30 points": "[ss.flutter_onsets(p, damping=False) for p in few]",
    "bifurcation_set": "ss.bifurcation_set(one)",
    "quasi_static_path along theta0": "ss.quasi_static_path(one, 'theta0', np.linspace(0.01, 3.0, 500))",
    "quasi_static_path along mu0": "ss.quasi_static_path(one, 'mu0', np.linspace(0.0, 1.0, 500))",
    "quasi_static_path of cubic_contact": "ss.quasi_static_path(cubic, 'mu0', np.linspace(0.0, 1.0, 100))",
    "jump_value along mu0": "ss.jump_value(one, 'mu0')",
    "jump_value along theta0": "ss.jump_value(one, 'theta0')",
    "jump_value along mu0, 300 points": "ss.jump_value(some, 'mu0')",
    "jump_value along theta0, 300 points": "ss.jump_value(some, 'theta0')",
    "critical_friction": "ss.critical_friction(one)",
    "critical_friction, 300 points": "ss.critical_friction(some)",
    "jump_margin": "ss.jump_margin(design, scale)",
    "jump_margin of cubic_contact": "ss.jump_margin(cubic, scale)",
    "redesign": "ss.redesign(design, ('theta0', 'sigma'), {'mu0': 0.7})",
    "redesign of cubic_contact": "ss.redesign(cubic, ('theta0', 'sigma'), {'mu0': 0.7})",
    "simulate": "ss.simulate(one, **law)",
    "simulate, compiled": "ss.simulate(one, **law, backend='compiled')",
    "simulate, scipy": "ss.simulate(one, **law, t_end=100.0, backend='scipy')",
    "rms_sweep": "ss.rms_sweep(angles, **law, t_end=500.0)",
    "rms_sweep, compiled": "ss.rms_sweep(angles, **law, t_end=500.0, backend='compiled')",
    "rms_sweep, 2 workers": "ss.rms_sweep(angles, **law, t_end=500.0, workers=2)",
    "import spragsym": "fresh('import spragsym')",
    "import and first equilibria": "fresh('import spragsym as ss; ss.equilibria(ss.Parameters.article(theta0=1.0))')",
    "command --help": "fresh(\"from spragsym.cli import main; main(['--help'])\")",
    "command equilibria": "fresh(\"from spragsym.cli import main; main(['equilibria', '--theta0', '49'])\")",
}
#: The process of one tree: a line holds an expression, and a file if its equilibria are to be
#: saved; the answer is seconds, or nothing.
WORKER = """
import subprocess, sys, time
import numpy as np, spragsym as ss
points = np.load(sys.argv[1])
one, many, some = ss.Parameters.article(theta0=np.radians(49.0)), ss.Parameters(*points), ss.Parameters(*points[:, :300])
few = [ss.Parameters(*map(float, point)) for point in points[:, :30].T]
flutters, design = ss.Parameters.article(sigma=1.0, mu0=1.5), one.replace(theta0=0.7, mu0=0.5)
cubic = ss.load("cubic_contact").Parameters(theta0=0.7, mu0=0.5)
angles = ss.Parameters.article(theta0=np.radians(np.linspace(5.0, 175.0, 35)))
scale, law = {"theta0": 0.02, "mu0": 0.05, "sigma": 0.01, "kappa": 0.001}, {"V": 0.5, "d": 10.0}
known = {}
def fresh(code):
    subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
for line in sys.stdin:
    question, _, file = line.rstrip("\\n").partition("\\t")
    best, end = float("inf"), time.perf_counter() + 0.2
    try:
        if question not in known:
            known[question] = compile(question, "question", "eval")
            eval(known[question])
        while time.perf_counter() < end or best == float("inf"):
            begin = time.perf_counter()
            answer = eval(known[question])
            best = min(best, time.perf_counter() - begin)
        if file:
            kind = getattr(answer[1], "undamped", None)  # former states call it stability
            np.savez(file, kind=answer[1].stability if kind is None else kind, **{key: getattr(answer[1], key) for key in ("count", "theta", "L", "x", "y")})
    except Exception:
        best = float("nan")
    print(best, flush=True)
"""


@contextmanager
def checkout(rev: str) -> Iterator[Path]:
    """A work tree of a commit in a temporary folder, with its extension modules built."""
    with tempfile.TemporaryDirectory() as name:
        tree, git = Path(name) / "tree", ["git", "-C", str(ROOT), "worktree"]
        subprocess.run([*git, "add", "--quiet", "--detach", str(tree), rev], check=True)
        try:
            build = "from setuptools import setup; setup()"
            subprocess.run(
                [sys.executable, "-c", build, "-q", "build_ext", "--inplace"],
                cwd=tree,
                check=False,
                capture_output=True,
            )
            yield tree
        finally:
            subprocess.run([*git, "remove", "--force", str(tree)], check=True)


@contextmanager
def worker(tree: Path, points: Path) -> Iterator[subprocess.Popen[str]]:
    """A process that asks the package of one tree."""
    environment = os.environ | {
        "PYTHONPATH": str(tree),
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
    }
    command = [sys.executable, "-c", WORKER, str(points)]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment, cwd=tree
    ) as process:
        yield process


def asked(process: subprocess.Popen[str], *words: str) -> float:
    """Seconds of a question, NaN where the tree doesn't know it."""
    assert process.stdin is not None
    assert process.stdout is not None
    process.stdin.write("\t".join(words) + "\n")
    process.stdin.flush()
    line = process.stdout.readline()
    if not line:
        sys.exit("the process of a tree ended")
    return float(line)


def differences(workers: list[subprocess.Popen[str]], question: str, folder: Path) -> str:
    """Points whose count or kinds differ, and the largest difference over max(1, |value|)."""
    found = []
    for number, process in enumerate(workers):
        if np.isnan(asked(process, question, str(folder / f"{number}.npz"))):
            return "- | - | -"
        with np.load(folder / f"{number}.npz") as file:
            found.append(dict(file))
    one, other = found
    counts = int((one["count"] != other["count"]).sum())
    kinds = int((one["kind"] != other["kind"]).any(axis=-1).sum())
    gaps = [
        np.abs(one[key] - other[key]) / np.maximum(1, np.abs(one[key]))
        for key in ("theta", "L", "x", "y")
    ]
    return f"{counts} | {kinds} | {max(float(np.nanmax(gap, initial=0.0)) for gap in gaps):.1e}"


def main() -> None:
    """Print both tables."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.bench_before")
    parser.add_argument("rev")
    parser.add_argument("--points", type=int, default=100_000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument(
        "--only",
        type=lambda text: tuple(text.split(",")),
        default=("",),
        help="beginnings of names",
    )
    given = parser.parse_args()
    chosen = {name: question for name, question in QUESTIONS.items() if name.startswith(given.only)}
    with ExitStack() as stack:
        tree, folder = (
            stack.enter_context(checkout(given.rev)),
            Path(stack.enter_context(tempfile.TemporaryDirectory())),
        )
        np.save(
            folder / "points.npy",
            np.stack(random(np.random.default_rng(1), given.points).broadcast(*PARAMETERS)),
        )
        workers = [
            stack.enter_context(worker(where, folder / "points.npy")) for where in (tree, ROOT)
        ]
        print(
            f"{given.points:,} random points in contact, {given.rev} and this tree in turn, "
            f"best of {given.rounds}.\n"
        )
        print("| question | before, µs | now | now / before |\n|---|---:|---:|---|")
        for name, question in chosen.items():
            taken = [np.inf, np.inf]
            for turn in range(given.rounds):
                for which in ((0, 1), (1, 0))[turn % 2]:
                    taken[which] = min(taken[which], asked(workers[which], question))
            cells = [
                f"{1e6 * spent:,.0f}" if np.isfinite(spent) else "not there" for spent in taken
            ]
            share = taken[1] / taken[0] if np.isfinite(taken).all() else np.nan
            ratio = (
                f"{share:.2f}" + (", slower" if share > 1 + ALLOWED else "")
                if np.isfinite(share)
                else "-"
            )
            print(f"| {name} | {cells[0]} | {cells[1]} | {ratio} |", flush=True)
        print("\n| question | other counts | other kinds | largest difference |\n|---|---|---|---|")
        for name in ("equilibria, numpy", "equilibria, compiled"):
            if name in chosen:
                print(f"| {name} | {differences(workers, chosen[name], folder)} |")


if __name__ == "__main__":
    main()
