"""Typical mistakes in files, calls and commands, each in a process of its own: exit code, seconds of
processor time, and the first line of what it is answered.

It guards the claims that tests ask within a process: one line that names what is wrong and what to
do, in no more time than a reader notices, loading included.
"""

import resource
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from tests.oracles.mistakes import BEFORE, BRAKE, CALLS, COMMANDS, FILES

#: Of a file, a call and a command: what is typed, and words of the answer.
MISTAKES = [*FILES, *CALLS, *COMMANDS]
CASES = len(MISTAKES)
#: Seconds of processor time that a refusal may take.
LIMIT = 0.3
#: The least of so many runs counts, as other processes slow some down.
RUNS = 3


def judge(number: int, _: np.random.Generator) -> dict[str, Any]:
    """One of the mistakes."""
    *typed, words = MISTAKES[number]
    with tempfile.TemporaryDirectory() as folder:
        if len(typed) == 2:
            kind, given, code, options = _of_file(Path(folder), *typed)
        elif number < len(FILES) + len(CALLS):
            kind, given, code = "call", typed[0], 1
            options = ["-c", f"{BEFORE}\n{given}"]
        else:
            kind, given, code = "command", typed[0], 2
            options = ["-m", "spragsym", *shlex.split(given)]
        seconds, done = min(
            (_run(options, folder) for _ in range(RUNS)), key=lambda found: found[0]
        )
    lines = done.stderr.splitlines() or [""]
    said = lines[-1] if kind == "call" else lines[0]  # a call's message follows the traceback
    print(f"{kind:8}{done.returncode:3}{seconds:6.2f}  {given}\n{'':19}{said}", flush=True)
    wrong = [f"{given}: {word!r} is not said" for word in words if word not in said]
    if done.returncode != code or (kind != "call" and len(lines) > 1) or done.stdout:
        wrong.append(f"{given}: code {done.returncode}, {len(lines)} lines, {done.stdout!r}")
    if seconds > LIMIT:
        wrong.append(f"{given}: {seconds:.2f} s of processor time")
    return {"kind": kind, "wrong": wrong, "processor": seconds}


def _of_file(folder: Path, key: str, value: str) -> tuple[str, str, int, list[str]]:
    rows = "".join(f'{name} = "{text}"\n' for name, text in {**BRAKE, key: value}.items())
    (folder / "brake.toml").write_text(f"[brake]\n{rows}", encoding="utf-8")
    return "file", f"{key} = {value!r}", 2, ["-m", "spragsym", "report", "brake.toml"]


def _run(options: list[str], folder: str) -> tuple[float, subprocess.CompletedProcess[str]]:
    """Seconds of processor time of a run of Python, and what came of it."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [sys.executable, *options], cwd=folder, capture_output=True, encoding="utf-8"
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done
