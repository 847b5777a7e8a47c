"""``python -m validation`` lists the campaigns, and what each holds against what; ``python -m validation NAME ...`` runs one.

``python -m validation.NAME ...`` is the same; what follows the name are its arguments. ``python -m validation all FOLDER
[SECONDS]`` runs every one after another, each with arguments for some minutes and cut after SECONDS (900); what it prints goes to
a file of the folder. Interrupted, it goes on where it was.
"""

from __future__ import annotations

import ast
import runpy
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from . import parts

HERE = Path(__file__).parent

#: Exit code of a campaign that needs what this machine does not have.
SKIPPED = 77

#: Every campaign with arguments for some minutes; {folder} is where what it finds is kept.
ALL = (
    "basins {folder}/basins.jsonl 25", "branches {folder}/branches 6", "by_hand 10", "certificates 60", "certificates brackets",
    "criticality 20", "cycle_search {folder}/search 4 20", "cycles", "digits 20", "emission", "equilibria 200000", "events",
    "explorer 20", "extremes 20", "fates {folder}/fates.jsonl 10", "flutter 40 1 300", "folds 20 100", "gaps 2",
    "jumps values 60", "jumps boxes 60", "lowest scan 4", "lowest digits", "measurements", "models 5000",
    "oscillation {folder}/page --quick", "paths 100", "precise 200", "proofs {folder}/proofs.jsonl 60", "random_pages 10",
    "regimes 100", "reports statements 20", "reports changes 20", "shapes 60", "sweeps 10 10 3000",
    "verdicts {folder}/verdicts.jsonl 40",
)  # fmt: skip


def main() -> int:
    """Run what is named, with the other words as its arguments."""
    if len(sys.argv) == 1 or sys.argv[1] in ("-h", "--help"):
        for name in sorted(names()):
            text = ast.get_docstring(ast.parse((HERE / f"{name}.py").read_text(encoding="utf-8"))) or ""
            print(f"{name:14} {text.splitlines()[0]}")
        return 0
    if sys.argv[1] == "all" and len(sys.argv) in (3, 4):
        return every(Path(sys.argv[2]), float((sys.argv[3:] or ["900"])[0]))
    if sys.argv[1] not in names():
        print(f"{sys.argv[1]} is no campaign; they are {', '.join(sorted(names()))}, and all FOLDER [SECONDS]", file=sys.stderr)
        return 2
    name = sys.argv.pop(1)
    sys.argv[0] = f"python -m validation.{name}"
    try:
        runpy.run_module(f"validation.{name}", run_name="__main__")
    except pytest.skip.Exception as missing:  # what tests skip without, a campaign that shares their helpers can't run without
        print(f"skipped: {missing}")
        return SKIPPED
    return 0


def names() -> set[str]:
    """The modules that are campaigns."""
    return {path.stem for path in HERE.glob("[a-z]*.py")} - {"parts", "motions_by_hand"}


def every(folder: Path, limit: float) -> int:
    """Run all campaigns, each in a process of its own, and print how each ended; 1 if one ended with an error, else 0."""
    folder.mkdir(parents=True, exist_ok=True)

    def ended(campaign: str) -> dict[str, Any]:
        begin, words = time.monotonic(), campaign.format(folder=folder.resolve()).split()
        with (folder / f"{'_'.join(campaign.split()[:2]).partition('_{')[0]}.txt").open("w", encoding="utf-8") as printed:
            try:
                command = [sys.executable, "-m", "validation", *words]
                code = subprocess.run(command, stdout=printed, stderr=subprocess.STDOUT, timeout=limit).returncode
                how = "skipped" if code == SKIPPED else f"exit {code}"
            except subprocess.TimeoutExpired:
                how = "cut"
        return {"how": how, "seconds": round(time.monotonic() - begin)}

    done = parts.run(ALL, ended, str(folder / "all.jsonl"))
    for campaign, result in done.items():
        print(f"{result['how']:8} {result['seconds']:5} s  {campaign}")
    return int(any(result["how"] not in ("exit 0", "cut", "skipped") for result in done.values()))


if __name__ == "__main__":
    sys.exit(main())
