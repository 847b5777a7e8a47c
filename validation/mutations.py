"""Single faults in the package, each against the tests of CI, or those that the variable TESTS
names; to see what no test notices.

Those of the fault's own room come first: they notice most. The faults of mutations.txt were drawn
from all rooms, others where a line was gone. A row has the file, line and column, what is replaced
by what, and the text of the line, by which it is found where code has moved; and, of a fault that
changes no answer, why.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
LIST = Path(__file__).with_suffix(".txt")
#: Seconds after which a fault counts as noticed: the tests take far less.
PATIENCE = 1800.0


class Fault(NamedTuple):
    """A line of a file, a column of its text, what stands there, what is put in its place, that
    text, and why nothing changes.
    """

    file: str
    line: int
    column: int
    old: str
    new: str
    text: str
    judged: str = ""


def faults() -> list[Fault]:
    """The faults of the list."""
    rows = [line.split("\t") for line in LIST.read_text(encoding="utf-8").splitlines()]
    return [Fault(file, int(line), int(column), *rest) for file, line, column, *rest in rows]


CASES = len(faults())


def place(tree: Path, fault: Fault) -> tuple[Path, int] | None:
    """The file and line of a fault: where it was, or the nearest line of the same text, or the only
    such line of the package.
    """
    every = [
        (path, number)
        for path in sorted((tree / "spragsym").rglob("*.py"))
        if not {"derive", "generated"} & set(path.parts)
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines())
        if line.strip() == fault.text
    ]
    here = [(path, number) for path, number in every if path == tree / fault.file]
    return (
        min(here, key=lambda one: abs(one[1] - fault.line + 1))
        if here
        else every[0]
        if len(every) == 1
        else None
    )


def noticed(tree: Path, path: Path, number: int, fault: Fault) -> bool:
    """Whether a test fails where the fault stands in a copy of the tree."""
    lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
    at = lines[number].index(fault.text) + fault.column
    lines[number] = lines[number][:at] + fault.new + lines[number][at + len(fault.old) :]
    path.write_text("".join(lines), encoding="utf-8")
    environment = os.environ | {"PYTHONPATH": str(tree), "HYPOTHESIS_PROFILE": "repeat"}
    own = f"tests/{Path(fault.file).parts[1]}"
    for tests in os.environ.get(
        "TESTS", f"{own} tests" if (tree / own).is_dir() else "tests"
    ).split():
        command = [sys.executable, "-m", "pytest", "-x", "-m", "not validate", tests]
        try:
            done = subprocess.run(
                command,
                cwd=tree,
                env=environment,
                capture_output=True,
                timeout=PATIENCE,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return True
        if done.returncode not in (0, 5):
            return True
    return False


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One fault of the list; it contradicts where no test notices it and no reason is given."""
    fault = faults()[number]
    with tempfile.TemporaryDirectory() as name:
        left_out = shutil.ignore_patterns(".git", ".venv", "build", "node_modules", "__pycache__")
        tree = Path(shutil.copytree(ROOT, Path(name) / "tree", symlinks=True, ignore=left_out))
        found = place(tree, fault)
        if found is None:
            return {"kind": "gone", "wrong": []}
        if fault.judged or noticed(tree, *found, fault):
            return {"kind": "judged" if fault.judged else "noticed", "wrong": []}
    return {
        "kind": "alive",
        "wrong": [f"{fault.file}:{fault.line}: {fault.old} -> {fault.new}: {fault.text}"],
    }
