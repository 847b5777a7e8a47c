"""``python -m tests.mutants [SUBJECT ...]``: break each proving module in one place at a time, and see its tests notice.

Ends with 1 if a mutant survives that ``equivalent.toml`` does not list. Verdicts are kept in ``build/mutants``: a run that was
ended, with Ctrl-C or otherwise, is taken up where it was, and only what changed since is run again.
"""

from __future__ import annotations

import argparse
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
    parser.add_argument("--quick", action="store_true", help="leave out what is listed as equivalent: it takes longest")
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    given = parser.parse_args()
    unknown = set(given.subjects) - set(SUBJECTS)
    if unknown:
        parser.error(f"no subject {', '.join(sorted(unknown))}; there are {', '.join(SUBJECTS)}")
    if given.inside:
        return _inside(given.subjects[0], given.jobs, set(given.only), given.quick)
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "HYPOTHESIS_PROFILE": "repeat"}
    bad = 0
    for name in given.subjects or SUBJECTS:
        extra = [part for key in given.only for part in ("--only", key)]
        command = [sys.executable, "-m", "tests.mutants", name, "--inside", "--jobs", str(given.jobs), *extra]
        command += ["--quick"] if given.quick else []
        with subprocess.Popen(command, env=environment, cwd=HERE.parent.parent) as process:
            try:
                bad += process.wait() != 0
            except KeyboardInterrupt:  # which it has got as well
                process.wait()
                return 130
    return 1 if bad else 0


def _inside(name: str, jobs: int, only: set[str], quick: bool) -> int:
    subject = SUBJECTS[name]
    reasons = tomllib.loads((HERE / "equivalent.toml").read_text(encoding="utf-8")).get(name, {})
    listed = {key for keys in reasons.values() for key in keys}
    if "in_c" in subject:
        from . import c99

        return c99.run(name, subject, RESULTS, only, listed, quick)
    import pytest

    from .runner import Runner

    runner = Runner(name, subject, RESULTS, jobs, only, listed, quick)
    options = ["-qq", "-s", "-p", "no:cacheprovider", "-p", "no:xdist"]
    code = int(pytest.main([*options, *subject["tests"]], plugins=[runner]))
    return code or min(runner.unexplained, 1)


if __name__ == "__main__":
    sys.exit(main())
