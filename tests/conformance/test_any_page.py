"""A page of anybody's goes through the suite by one command."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.conformance.models import PAGES, TESTS


@pytest.mark.validate
def test_the_command_shows_its_table_and_runs_what_is_about_one_model(tmp_path: Path) -> None:
    pytest.importorskip("sympy")
    page = tmp_path / "mine.py"
    page.write_text(PAGES[1].read_text(encoding="utf-8"), encoding="utf-8")
    command = [sys.executable, "-m", "tests.conformance", str(page), "-rA", "-k", "states or exports"]
    done = subprocess.run(command, cwd=TESTS.parent, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stdout
    assert done.stdout.split()[0] == "mine"
    passed = [line for line in done.stdout.splitlines() if line.startswith("PASSED")]
    assert len(passed) > 3
    assert all(line.endswith("mine]") for line in passed)
