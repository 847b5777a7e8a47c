"""``python -m tests.mutants [SUBJECT ...]``: break each proving module in one place at a time, and see its tests notice.

Ends with 1 if a mutant survives that ``equivalent.toml`` does not list. Results are kept in ``build/mutants`` and taken up again
as long as neither module nor tests change.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
RESULTS = HERE.parent.parent / "build" / "mutants"
SUBJECTS = tomllib.loads((HERE / "subjects.toml").read_text(encoding="utf-8"))


def main() -> int:
    """All subjects, or those named, each in a process of its own."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutants", description="mutation tests of the modules that prove")
    parser.add_argument("subjects", nargs="*", metavar="SUBJECT", help=f"of {', '.join(SUBJECTS)}; all if none is named")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at a time")
    parser.add_argument("--only", action="append", default=[], help="the key of one mutant, run whatever is known of it")
    parser.add_argument("--again", action="store_true", help="only what survived, with the tests as they are now")
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    given = parser.parse_args()
    unknown = set(given.subjects) - set(SUBJECTS)
    if unknown:
        parser.error(f"no subject {', '.join(sorted(unknown))}; there are {', '.join(SUBJECTS)}")
    if given.inside:
        return _inside(given.subjects[0], given.jobs, given.only, given.again)
    RESULTS.mkdir(parents=True, exist_ok=True)
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "HYPOTHESIS_PROFILE": "repeat"}
    bad = 0
    for name in given.subjects or SUBJECTS:
        extra = [part for key in given.only for part in ("--only", key)]
        command = [sys.executable, "-m", "tests.mutants", name, "--inside", "--jobs", str(given.jobs), *extra]
        command += ["--again"] if given.again else []
        done = subprocess.run(command, env=environment, cwd=HERE.parent.parent, check=False)
        bad += 1 if done.returncode else _report(name, given.only)
    return 1 if bad else 0


def _inside(name: str, jobs: int, only: list[str], again: bool) -> int:
    subject = SUBJECTS[name]
    if "in_c" in subject:
        from . import c99

        return c99.run(subject, _results(name, only), only)
    import pytest

    from .runner import Runner

    runner = Runner(subject, _results(name, only), jobs, only, again, set(_listed(name)))
    options = ["-qq", "-s", "-p", "no:cacheprovider", "-p", "no:xdist"]
    return int(pytest.main([*options, *subject["tests"]], plugins=[runner]))


def _results(name: str, only: list[str]) -> Path:
    return RESULTS / (f"{name}.only.jsonl" if only else f"{name}.jsonl")


def _listed(name: str) -> dict[str, str]:
    """The mutants of a subject that change no answer, with the reason."""
    groups = tomllib.loads((HERE / "equivalent.toml").read_text(encoding="utf-8")).get(name, [])
    return {key: group["reason"] for group in groups for key in group["mutants"]}


def _report(name: str, only: list[str]) -> int:
    """Print the counts of one subject and its survivors, and return the number of those that nobody has explained."""
    listed = _listed(name)
    rows = [json.loads(line) for line in _results(name, only).read_text(encoding="utf-8").splitlines()]
    alive = [row for row in rows if not row["killed"]]
    unexplained = [row for row in alive if row["key"] not in listed]
    for row in unexplained:
        print(f"  survives, line {row['line']}: {row['key']}")
    for key in sorted(set(listed) - {row["key"] for row in alive}) if not only else ():
        print(f"  listed as equivalent, but killed or gone: {key}")
    counts = len(rows), len(rows) - len(alive), len(alive) - len(unexplained), len(unexplained)
    print(f"{name}: {counts[0]} mutants, {counts[1]} killed, {counts[2]} equivalent, {counts[3]} survive", flush=True)
    return len(unexplained)


if __name__ == "__main__":
    sys.exit(main())
