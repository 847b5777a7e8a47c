"""Whether every extra resolves from wheels alone on the machines that users have, as pip would
install them there.

``python .ci/installs.py [MACHINE ...]``: all machines, or those whose names begin so. Prints a line
for each, once with the newest versions, once with those of ``constraints.txt`` and once with the
lowest that pyproject.toml allows; the number of those that fail is the exit code.

``python .ci/installs.py lowest [option of pytest ...]``: installs the lowest versions into an
environment of its own, ``.lowest``, and runs the quick tests there.

Where no registry can be reached it says that it is skipped. What a registry says is kept by uv, so
that a second call is quick.
"""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PYTHONS = ("3.11", "3.12", "3.13")
#: What uv calls each machine.
MACHINES = {
    "Windows x64": "x86_64-pc-windows-msvc",
    "macOS arm64": "aarch64-apple-darwin",
    "macOS x64": "x86_64-apple-darwin",
    "Linux x86_64": "x86_64-manylinux_2_28",
    "Linux aarch64": "aarch64-manylinux_2_28",
}
#: How versions are chosen, by what is printed.
VERSIONS: dict[str, tuple[str, ...]] = {
    "newest": (),
    "constraints.txt": ("--constraint", "constraints.txt"),
    "lowest": ("--resolution", "lowest-direct"),
}


def resolve(machine: str, python: str, versions: str) -> str:
    """What uv says against it; empty if it finds wheels of everything."""
    call = [
        sys.executable,
        "-m",
        "uv",
        "pip",
        "compile",
        "pyproject.toml",
        "--all-extras",
        "--only-binary=:all:",
        "--quiet",
        "--python-version",
        python,
        "--python-platform",
        MACHINES[machine],
        *VERSIONS[versions],
    ]
    try:
        done = subprocess.run(
            call,
            cwd=ROOT,
            capture_output=True,
            text=True,
            encoding="utf-8",
            check=False,
            timeout=600,
        )
    except subprocess.TimeoutExpired:
        return "no answer within ten minutes"
    return "" if done.returncode == 0 else " ".join(done.stderr.split())


def reachable() -> bool:
    """Whether a registry answers."""
    call = [sys.executable, "-m", "uv", "pip", "compile", "-", "--no-deps", "--quiet", "--refresh"]
    return (
        subprocess.run(
            call, cwd=ROOT, input="mpmath", text=True, capture_output=True, check=False
        ).returncode
        == 0
    )


def lowest(options: list[str]) -> int:
    """The quick tests with the lowest versions; the exit code of pytest."""
    home = ROOT / ".lowest"
    python = home / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    uv = [sys.executable, "-m", "uv"]
    install = [*uv, "pip", "install", "--quiet", "--python", python, *VERSIONS["lowest"]]
    quick = "not thorough and not validate"
    # What an old library calls of a new one is no fault of ours.
    others = ("-W", "default::DeprecationWarning")
    for call in (
        [*uv, "venv", "--quiet", "--clear", "--python", sys.executable, home],
        [*install, "--config-settings", "editable_mode=compat", "-e", ".[all,test]"],
        [python, "-m", "pytest", "-m", quick, *others, *options],
    ):
        if code := subprocess.run(call, cwd=ROOT, check=False).returncode:
            return code
    return 0


def main(chosen: list[str]) -> int:
    """One line for each machine, Python and choice of versions."""
    if not reachable():
        print("no package registry can be reached: the check of installs is skipped")
        return 0
    if chosen[:1] == ["lowest"]:
        return lowest(chosen[1:])
    cases = [
        case
        for case in product(MACHINES, PYTHONS, VERSIONS)
        if not chosen or any(case[0].startswith(it) for it in chosen)
    ]
    failed = 0
    with ThreadPoolExecutor(2) as pool:
        for (machine, python, versions), said in zip(
            cases, pool.map(lambda case: resolve(*case), cases), strict=True
        ):
            print(
                f"{machine}, Python {python}, {versions}: "
                f"{said or 'every extra resolves from wheels'}",
                flush=True,
            )
            failed += bool(said)
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
