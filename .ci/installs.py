"""Whether every extra resolves from wheels alone on the machines that users have, as pip would install them there.

``python .ci/installs.py [MACHINE ...]``: all machines, or those whose names begin so. Prints a line for each; the number of those
that fail is the exit code. Where no registry can be reached it says that it is skipped.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from packaging.requirements import Requirement

PROJECT = tomllib.loads((Path(__file__).resolve().parent.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]
PYTHONS = ("3.11", "3.12", "3.13")
#: What pip calls each machine, newest first, and what markers call it.
_LINUX = (
    "manylinux_2_28",
    "manylinux_2_27",
    "manylinux_2_24",
    "manylinux_2_17",
    "manylinux2014",
    "manylinux_2_12",
    "manylinux_2_5",
)
MACHINES: dict[str, tuple[tuple[str, ...], dict[str, str]]] = {
    "Windows x64": (("win_amd64",), {"sys_platform": "win32", "platform_system": "Windows", "platform_machine": "AMD64"}),
    "macOS arm64": (("macosx_14_0_arm64",), {"sys_platform": "darwin", "platform_system": "Darwin", "platform_machine": "arm64"}),
    "macOS x64": (("macosx_14_0_x86_64",), {"sys_platform": "darwin", "platform_system": "Darwin", "platform_machine": "x86_64"}),
    **{
        f"Linux {machine}": (
            tuple(f"{tag}_{machine}" for tag in _LINUX),
            {"sys_platform": "linux", "platform_system": "Linux", "platform_machine": machine},
        )
        for machine in ("x86_64", "aarch64")
    },
}


def requirements(surroundings: dict[str, str]) -> list[str]:
    """All that the package and its extras ask for on a machine, without markers."""
    given = [*PROJECT["dependencies"], *(one for some in PROJECT["optional-dependencies"].values() for one in some)]
    wanted = []
    for text in given:
        requirement = Requirement(text)
        if requirement.name != PROJECT["name"] and (requirement.marker is None or requirement.marker.evaluate(surroundings)):
            requirement.marker = None
            wanted.append(str(requirement))
    return wanted


def resolve(machine: str, python: str) -> str:
    """What pip says against it; empty if it finds wheels of everything."""
    tags, surroundings = MACHINES[machine]
    wanted = requirements({**surroundings, "python_version": python, "python_full_version": f"{python}.0"})
    with tempfile.TemporaryDirectory() as folder:
        call = [sys.executable, "-m", "pip", "install", "--quiet", "--dry-run", "--ignore-installed", "--target", folder,
                "--only-binary=:all:", "--python-version", python, *(f"--platform={tag}" for tag in tags), *wanted]  # fmt: skip
        done = subprocess.run(call, capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else " ".join(line for line in done.stderr.splitlines() if line.startswith("ERROR"))


def reachable() -> bool:
    """Whether a registry answers."""
    with tempfile.TemporaryDirectory() as folder:
        call = [
            sys.executable,
            "-m",
            "pip",
            "download",
            "--quiet",
            "--retries=0",
            "--timeout=15",
            "--no-deps",
            "--dest",
            folder,
            "mpmath",
        ]
        return subprocess.run(call, capture_output=True, check=False).returncode == 0


def main(chosen: list[str]) -> int:
    """One line for each machine and Python."""
    if not reachable():
        print("no package registry can be reached: the check of installs is skipped")
        return 0
    cases = [(machine, python) for machine in MACHINES for python in PYTHONS]
    cases = [case for case in cases if not chosen or any(case[0].startswith(name) for name in chosen)]
    failed = 0
    with ThreadPoolExecutor(3) as pool:
        for (machine, python), said in zip(cases, pool.map(lambda case: resolve(*case), cases), strict=True):
            print(f"{machine}, Python {python}: {said or 'every extra resolves from wheels'}", flush=True)
            failed += bool(said)
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
