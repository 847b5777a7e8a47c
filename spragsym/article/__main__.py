"""``python -m spragsym.article`` writes the record of the claims anew; with ``measure``, that of
time and memory of commands.
"""

import json
import os
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from . import STATEMENTS, record_text, run


def _measurements() -> str:
    """The content of measured.json: of the machine where this runs."""
    # Commands that the report names.
    commands = (
        ("check", "--again"),
        ("check", "--claims", "--again"),
        ("figures", "--out", "figures"),
    )
    rows = [_measured(arguments) for arguments in commands]
    machine = f"{os.cpu_count()} cores, {platform.machine()}, Python {platform.python_version()}"
    return json.dumps({"machine": machine, "rows": rows}, indent=1) + "\n"


def _measured(arguments: tuple[str, ...]) -> dict[str, Any]:
    with tempfile.TemporaryDirectory() as folder:
        begun = time.perf_counter()
        process = subprocess.Popen(
            [sys.executable, "-m", "spragsym", *arguments],
            cwd=folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        _, status, used = os.wait4(process.pid, 0)
        wall = time.perf_counter() - begun
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise RuntimeError(f"spragsym {' '.join(arguments)} ended with {process.returncode}")
    return {
        "command": f"spragsym {' '.join(arguments)}",
        "wall": round(wall, 1),
        "cpu": round(used.ru_utime + used.ru_stime, 1),
        "megabytes": round(used.ru_maxrss / 1024),
    }


if sys.argv[1:] not in ([], ["measure"]):
    sys.exit("usage: python -m spragsym.article [measure]")
name, text = (
    ("measured.json", _measurements())
    if sys.argv[1:]
    else ("record.json", record_text(run(STATEMENTS)))
)
Path(__file__).with_name(name).write_text(text, encoding="utf-8", newline="\n")
