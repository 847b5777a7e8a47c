"""Reports on many brakes: each is that of its own data, by risk, and goes on where it stopped."""

import json
from pathlib import Path

import pytest

import spragsym as ss
from spragsym.cli import main
from spragsym.report.batch import BatchBrake, BatchReport, read_batch
from tests.support import ROOT

pytest.importorskip("matplotlib")
BASE = ROOT / "spragsym" / "report" / "brake.toml"
TABLE = """name;theta0;mu0
calm;30 deg;0.2
<b>at risk;52 deg;[0.3, 0.6]
impossible;200 deg;0.2
"""


def run(folder: Path, table: str, *options: str) -> int:
    """The exit code of the command for a table."""
    (folder / "brakes.csv").write_text(table, encoding="utf-8")
    words = ["report", str(BASE), "--batch", str(folder / "brakes.csv"), "--out"]
    words += [str(folder / "out"), "--no-oscillation", "--no-redesign", *options]
    with pytest.raises(SystemExit) as stop:
        main(words)
    return int(stop.value.code or 0)


def test_brakes_by_risk(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, TABLE) == 3
    told = capsys.readouterr()
    out = tmp_path / "out"
    assert "3 brakes, 1 at risk, 1 without a report" in told.out
    assert "line 4, column theta0: theta0 = '200 deg'" in told.err
    order = [told.out.index(name) for name in ("<b>at risk", "calm", "impossible")]
    assert order == sorted(order)
    page = (out / "index.html").read_text(encoding="utf-8")
    assert "<b>" not in page
    assert 'href="b_at_risk.html"' in page
    # The same as the report on a file with these data.
    text = BASE.read_text(encoding="utf-8").replace('"52 deg +- 1 deg"', '"30 deg"')
    (tmp_path / "calm.toml").write_text(text.replace('"[0.3, 0.6]"', '"0.2"'), encoding="utf-8")
    alone = ss.Study.from_file(tmp_path / "calm.toml").report(oscillation=False, redesign=False)
    held = json.loads((out / "calm.json").read_text(encoding="utf-8"))
    assert held["verdict"] == alone.verdict
    assert held["mu_jump"] == alone.to_dict()["mu_jump"]

    # It goes on where it stopped, and ends in the same bytes.
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    (out / "calm.json").unlink()
    kept = (out / "b_at_risk.json").stat().st_mtime_ns
    assert run(tmp_path, TABLE) == 3
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before
    assert (out / "b_at_risk.json").stat().st_mtime_ns == kept

    # A report on other data stays unless it may be replaced.
    capsys.readouterr()
    other = TABLE.replace("30 deg", "31 deg")
    assert run(tmp_path, other) == 2
    assert "calm.json is of other data" in capsys.readouterr().err
    assert run(tmp_path, other, "--force") == 3
    assert json.loads((out / "calm.json").read_text(encoding="utf-8"))["mu_jump"] != held["mu_jump"]


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("name,mu0\n", "has no row"),
        ("mu0,mu0\n0.1,0.2\n", "'mu0' twice"),
        ("mu0,\n0.1,0.2\n", "an empty cell"),
        ("name,mu0\na,0.1,0.2\n", "has 3 cells, and the head has 2"),
        ("name,mu0\na b,0.1\na/b,0.2\n", "two brakes would be written to a_b.json"),
    ],
)
def test_a_table_that_is_none_is_refused(table: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(table, encoding="utf-8")
    with pytest.raises(ss.errors.ParameterError, match=said):
        read_batch(tmp_path / "a.csv")


def test_files_stay_in_the_folder(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("name,mu0\n../../x,0.1\n,0.2\n..,0.3\n", encoding="utf-8")
    assert [one.stem for one in read_batch(tmp_path / "a.csv")] == ["x", "line_3", "line_4"]


def test_it_is_told_where_to_write(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words, said in (
        (["--batch", "brakes.csv"], "belong together"),
        (["--batch", "b.csv", "--out", "o", "--html", "a.html"], "leave out --html"),
    ):
        with pytest.raises(SystemExit, match="2"):
            main(["report", *words])
        assert said in capsys.readouterr().err


@pytest.mark.parametrize(
    ("reach", "at_risk"), [("within", True), ("faster", True), ("beyond", False), ("", False)]
)
def test_what_is_at_risk_does_not_hang_on_the_words(reach: str, at_risk: bool) -> None:
    told = {"reach": reach, "verdict": "It loses its contact: …"}
    brake = BatchBrake("brakes.csv", 2, "rear", "rear", {})
    assert BatchReport(brake, told).at_risk is at_risk
