"""A release: its script, its workflows, its paper, and the pages that an index asks for."""

import importlib.util
import json
import re
import shutil
import subprocess
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import spragsym as ss
from spragsym.report.example import example
from tests.support import ROOT


def read(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def release() -> ModuleType:
    spec = importlib.util.spec_from_file_location("release", ROOT / ".ci/release.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A tree that is fit for a release."""
    if shutil.which("git") is None:
        pytest.skip("needs git")
    for name in ("spragsym/_version.py", "CHANGELOG.md", "CITATION.cff"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    git(tmp_path, "init", "-q")
    commit(tmp_path)
    return tmp_path


def git(folder: Path, *words: str) -> None:
    own = ("-c", "user.name=a", "-c", "user.email=a@localhost", "-c", "commit.gpgsign=false")
    subprocess.run(["git", *own, *words], cwd=folder, check=True, capture_output=True)


def commit(folder: Path) -> None:
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "--no-verify", "-m", "all")


def test_this_tree_says_its_version_and_date_everywhere(release: ModuleType, tree: Path) -> None:
    assert release.obstacles(tree) == []


@pytest.mark.parametrize(
    ("name", "old", "new", "said"),
    [
        ("CHANGELOG.md", r"## (\d\S+), \d{4}-\d\d-\d\d", r"## \1, not yet released", "date its"),
        ("CITATION.cff", r"\nversion: .*", "\nversion: 9.9.9", "another version"),
        ("CITATION.cff", r"\ndate-released: .*", "", "lacks 'date-released"),
        ("spragsym/_version.py", r'"(.*)"', '"next"', "has no version"),
    ],
)
def test_a_tree_that_does_not_agree_is_not_tagged(
    name: str, old: str, new: str, said: str, release: ModuleType, tree: Path
) -> None:
    text = (tree / name).read_text(encoding="utf-8")
    (tree / name).write_text(re.sub(old, new, text, count=1), encoding="utf-8")
    commit(tree)
    (one,) = release.obstacles(tree)
    assert said in one


def test_a_changed_tree_and_an_old_tag_are_refused(release: ModuleType, tree: Path) -> None:
    git(tree, "tag", f"v{ss.__version__}", "-m", "a")
    (tree / "new").write_text("", encoding="utf-8")
    assert [one.partition(";")[0] for one in release.obstacles(tree)] == [
        "the tree has changes that are not committed",
        f"the tag v{ss.__version__} is there",
    ]


def test_what_only_a_maintainer_can_write_is_named(release: ModuleType, tree: Path) -> None:
    shutil.copy(ROOT / "paper.md", tree)
    told = release.placeholders(tree)
    assert [one.partition(" has ")[0] for one in told] == ["paper.md", "paper.md", "CITATION.cff"]
    (tree / "paper.md").unlink()
    cited = (tree / "CITATION.cff").read_text(encoding="utf-8")
    own = cited.replace("name: The spragsym developers", "family-names: A")
    (tree / "CITATION.cff").write_text(own, encoding="utf-8")
    assert release.placeholders(tree) == []


def test_no_action_of_a_workflow_runs_on_a_node_that_is_retired() -> None:
    """The first versions on Node 24, as their action.yml says."""
    least = {"actions/checkout": 5, "actions/setup-python": 6, "actions/upload-artifact": 6}
    for name in ("check", "wheels"):
        used = re.findall(r"uses: (\S+)@v(\d+)", read(f".github/workflows/{name}.yml"))
        assert used
        assert all(int(version) >= least.get(action, 1) for action, version in used)


def test_workflows_are_those_that_the_contract_names() -> None:
    yaml = pytest.importorskip("yaml")
    check = yaml.safe_load(read(".github/workflows/check.yml"))
    assert set(check[True]) == {"push", "pull_request"}  # YAML reads "on" as true
    matrix = check["jobs"]["check"]["strategy"]["matrix"]
    assert [one.split("-")[0] for one in matrix["os"]] == ["ubuntu", "macos", "windows"]
    assert len(matrix["python"]) == 2
    assert ".ci/run" in [step.get("run") for step in check["jobs"]["check"]["steps"]]
    wheels = yaml.safe_load(read(".github/workflows/wheels.yml"))
    told = wheels["jobs"]["wheels"]["steps"][2]["env"]["CIBW_TEST_COMMAND"]
    (code,) = re.findall(r'python -c "(.*)"', told)
    try:
        exec(code, {})
    except ss.errors.SpragsymError as error:
        pytest.skip(str(error))
    finally:
        ss.kang_nam.set_backend("auto")


# ------------------------------------------------------------------------------------------------
# the paper


def numbers() -> dict[str, list[str]]:
    """What prints numbers of the paper → these numbers."""
    rows = re.findall(r"^\| ([\d., ]+) \| `(.*)` \|$", read("paper.md"), re.MULTILINE)
    return {source: told.split(", ") for told, source in rows}


def test_every_number_of_the_paper_is_printed_by_what_it_names() -> None:
    ledger = json.loads(read("generated/ledger.json"))["rows"]
    status = [row["status"] for row in ledger]
    rows = re.findall(r"^\| (.*?) \| (.*) \|$", performance(), re.MULTILINE)
    speed = {name: rest.split(" | ") for name, rest in reversed(rows)}  # the first of a name
    compiled = speed["ours, compiled, 1 thread: states, stability, error bounds"]
    eigvals = speed["batched numpy.linalg.eigvals, L-quartic"]
    points = re.findall(r"^(\d+) points of each family", performance(), re.MULTILINE)
    report = ss.Study.from_file(_written(example(ss.load("kang_nam"))))
    questions = re.findall(r"^### (\d+)\.", read("docs/cookbook.md"), re.MULTILINE)
    wanted = {
        "generated/LEDGER.md": [
            len(ledger),
            *(status.count(one) for one in ("confirmed", "approximation", "misprint")),
        ],
        "docs/performance.md": [
            compiled[0],
            eigvals[0],
            points[0],
            speed["near folds"][1].partition(",")[0],
        ],
        "spragsym report --example": [f"{report.displayed(report.jump()):.4g}"],
        "docs/cookbook.md": [questions[-1]],
    }
    for source, told in numbers().items():
        found = wanted.pop(source, None)
        if found is None:
            value = eval(source, {"ss": ss, "np": np})  # noqa: S307  # of our own page
            found = np.atleast_1d(value).tolist()
        assert told == [str(one) for one in found], source
    assert not wanted


def performance() -> str:
    return read("docs/performance.md")


def _written(text: str) -> Path:
    import tempfile

    path = Path(tempfile.mkdtemp()) / "brake.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_no_number_of_the_paper_is_without_a_source() -> None:
    """But for those in names, headings and the year of its date."""
    body = read("paper.md").split("---", 2)[2].partition("# Numbers of this paper")[0]
    plain = re.sub(r"\[@[\w; @]+\]|AUTO-07p|C99|μ₀ = 0\.5", "", body)
    said = set(re.findall(r"\d[\d.,]*\d|\d", plain))
    known = {number for told in numbers().values() for number in told}
    assert {number.rstrip(".,") for number in said} == known


def test_the_paper_has_the_parts_that_the_journal_asks_for() -> None:
    text = read("paper.md")
    words = text.split("---", 2)[2].partition("# Numbers of this paper")[0].split()
    assert 750 <= len(words) <= 1750
    heads = re.findall(r"^# (.*)$", text, re.MULTILINE)
    assert heads[:4] == ["Summary", "Statement of need", "State of the field", "Software design"]
    assert {"Research impact", "Disclosures", "Acknowledgements"} < {*heads}
    assert heads[-1] == "References"
    cited = set(re.findall(r"@(\w+)", text.split("---", 2)[2]))
    assert cited == set(re.findall(r"^@\w+\{(\w+),", read("paper.bib"), re.MULTILINE))


def test_pages_that_an_index_asks_for_hold_no_placeholder() -> None:
    for name in ("CODE_OF_CONDUCT.md", "SECURITY.md", "CONTRIBUTING.md", "CITATION.cff"):
        text = read(name)
        assert "example.com" not in text
        assert not re.search(r"TODO|FIXME|\[INSERT", text), name
