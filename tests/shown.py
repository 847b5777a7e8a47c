"""What documents show: their blocks, their commands with the output below, and how it is compared
with what runs.
"""

import doctest
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support import ROOT

DOCS = ROOT / "docs"
README = ROOT / "README.md"
OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


def fenced(path: Path, language: str) -> list[str]:
    """Blocks of one language."""
    return re.findall(
        rf"^```{language}\n(.*?)^```$", path.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )


def commands(path: Path) -> list[tuple[str, str]]:
    """Commands of console blocks, each with the output that is shown below it."""
    found = []
    for block in fenced(path, "console"):
        for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            command, _, output = part.partition("\n")
            found.append((command, output))
    return found


def programs(path: Path, language: str) -> list[tuple[str, str]]:
    """Programs of one language, each with the output that is shown below it."""
    shown = rf"^```{language}\n((?:(?!```)[^\n]*\n)*)```\n+```text\n(.*?)^```$"
    return re.findall(shown, path.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def run(command: str, folder: Path, *, bare: bool = False) -> str:
    """stdout of a shell command that must succeed, with this interpreter's ``spragsym`` first on
    the path.

    A bare shell has nothing of this environment but that path, and the folder for its home.
    """
    if os.name != "posix" or not shutil.which("bash"):
        pytest.skip("needs bash")
    given = (
        {"PATH": os.defpath, "HOME": str(folder), "LANG": "C.UTF-8"} if bare else dict(os.environ)
    )
    environment = {
        **given,
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{given['PATH']}",
        "PYTHONIOENCODING": "utf-8",
    }
    environment.pop("FORCE_COLOR", None)
    done = subprocess.run(
        ["bash", "-o", "pipefail", "-c", command],
        cwd=folder,
        env=environment,
        capture_output=True,
        encoding="utf-8",
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def assert_shown(shown: str, given: str) -> None:
    """Output as shown, where ``...`` stands for anything."""
    assert doctest.OutputChecker().check_output(shown, given, OPTIONS), (
        f"shown:\n{shown}\ngiven:\n{given}"
    )


def captioned(path: Path) -> dict[str, str]:
    """Files that a page shows, by their names."""
    block = r"^```{code-block} (?:python|toml)\n:caption: (\S+)\n(.*?)^```$"
    return dict(re.findall(block, path.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL))


def assert_done(page: Path, folder: Path, files: list[str]) -> None:
    """Write the files of a page, run its commands, and compare what they print."""
    shown = captioned(page)
    assert [*shown] == files
    for name, content in shown.items():
        (folder / name).write_text(content, encoding="utf-8")
    done = commands(page)
    assert len(done) >= 5
    for command, output in done:
        assert_shown(output, run(command, folder))
