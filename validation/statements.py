"""The register of absolute sentences: for each row of docs/statements.toml a falsehood, the negation
of the statement or one about too large a domain, is planted into a copy of the test that is to
see it, which then has to fail, by an assertion.
"""

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
ROWS = tomllib.loads((ROOT / "docs/statements.toml").read_text(encoding="utf-8"))["rows"]
CASES = len(ROWS)
#: What pytest prints where a statement is seen to be false, not where code breaks.
SEEN = re.compile(r"^E +(assert\b|AssertionError|Failed: DID NOT RAISE)", re.MULTILINE)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One row; it contradicts where its test passes, or fails for another reason."""
    name, row = list(ROWS.items())[number]
    file, test = row["test"].split("::")
    path = ROOT / file
    planted = path.with_name(f"{path.stem}_planted_{os.getpid()}.py")
    planted.write_text(path.read_text(encoding="utf-8").replace(*row["plant"]), encoding="utf-8")
    try:
        done = subprocess.run(
            [
                sys.executable,
                "-m",
                "pytest",
                "-x",
                "-q",
                "-p",
                "no:cacheprovider",
                f"{planted}::{test}",
            ],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
        )
    finally:
        planted.unlink()
    if done.returncode == 1 and SEEN.search(done.stdout):
        return {"kind": "seen", "wrong": []}
    (said,) = done.stdout.splitlines()[-1:] or ("nothing",)
    if done.returncode == 0 and re.match(r"\d+ skipped", said):  # what it needs is not here
        return {"kind": "skipped", "wrong": []}
    return {"kind": "unseen", "wrong": [f"{name}: {said}"]}
