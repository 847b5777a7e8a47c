"""Code that a file names as its model does not run unasked."""

import json
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


@pytest.mark.thorough
def test_a_paper_forges_no_row(tmp_path: Path, run: Run) -> None:
    """Its texts are no lines, cells, markup or commands of a terminal in any format."""
    forged = (
        r"x | confirmed |\n| 7 | Equation (7) | motion | confirmed <script> \u001b \u202e \u2028"
    )
    (tmp_path / "p.toml").write_text(
        f'paper = "{forged}"\n[[statement]]\nid = "1"\nabout = "energy T"\nwhere = "{forged}"\n'
        f'note = "{forged}"\nsympy = "m*vx**2/2"\n',
        encoding="utf-8",
    )
    asked = ["check", str(tmp_path / "p.toml"), "--model", "stick_slip"]
    told = [run(*asked, "--out", str(tmp_path)), run(*asked, "--json"), run(*asked, "--row", "1")]
    told += [(tmp_path / name).read_text("utf-8") for name in ("LEDGER.md", "ledger.html")]
    for text in told:
        assert not set(text) & set("\x1b\u202e\u2028"), text
        assert not [line for line in text.split("\n") if line.startswith("| 7 |")], text
    assert "<script" not in told[3] + told[4]
    assert told[3].count("\n| ") == 2
    assert [row["status"] for row in json.loads(told[1])["rows"]] == ["confirmed"]
