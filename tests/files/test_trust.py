"""Code that a file names as its model does not run unasked."""

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

import spragsym as ss
from tests.support import ROOT

pytest.importorskip("sympy")

Run = Callable[..., str]
PAGE = (ROOT / "derive/models/stick_slip.py").read_text(encoding="utf-8")
STATEMENT = '[[statement]]\nid = "1"\nabout = "energy T"\nsympy = "m*vx**2/2"\n'


@pytest.fixture
def page(tmp_path: Path) -> Path:
    """A page that leaves a mark when it is run."""
    path = tmp_path / "a page.py"
    path.write_text(
        f"{PAGE}\nimport pathlib\npathlib.Path({str(tmp_path / 'ran')!r}).touch()\n",
        encoding="utf-8",
    )
    return path


def paper(folder: Path, model: object) -> Path:
    folder.mkdir(exist_ok=True)
    (folder / "paper.toml").write_text(f"model = {str(model)!r}\n{STATEMENT}", encoding="utf-8")
    return folder / "paper.toml"


def test_no_page_that_a_paper_names_runs_unasked(page: Path, run: Run) -> None:
    folder = page.parent / "paper"
    folder.mkdir()
    shutil.copy(page, folder / "beside.py")
    shutil.copytree(ROOT / "generated/models/stick_slip", folder / "derived")
    own = ROOT / "validation" / "papers" / "cart_pole"
    (folder / "linked.py").symlink_to(page)
    around = os.path.relpath(own, folder) + "/" + os.path.relpath(page, own)
    for model in ("beside.py", "../a page.py", page, "derived", "linked.py", around):
        file = paper(folder, model)
        with pytest.raises(ss.errors.ParameterError, match=r"whose code runs; .* trust=True"):
            ss.check(file)
        said = run("check", str(file), code=2)
        assert "--trust or --model" in said
        assert not (page.parent / "ran").exists(), model


@pytest.mark.thorough
def test_what_is_trusted_runs(page: Path, run: Run) -> None:
    file = paper(page.parent / "paper", "../a page.py")
    for asked in (["--trust"], ["--model", str(page)]):
        assert "confirmed" in run("check", str(file), *asked)
        (page.parent / "ran").unlink()
        page.write_text(page.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    assert ss.check(file, trust=True).status == ("confirmed",)


@pytest.mark.thorough
def test_what_ships_needs_no_trust(tmp_path: Path) -> None:
    (tmp_path / "stick_slip").mkdir()  # of that name, and not what is meant
    assert ss.check(paper(tmp_path, "stick_slip")).status == ("confirmed",)
    assert ss.check(ROOT / "validation/papers/cart_pole/paper.toml").is_expected
