"""What the documents show is what runs: README, CONTRIBUTING, the pages under docs/ and every
docstring's examples.
"""

import ast
import contextlib
import doctest
import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import spragsym
from tests.shown import DOCS, OPTIONS, README, assert_shown, commands, fenced, run
from tests.support import LONG_MOTIONS_TAKE_MINUTES, ROOT, few, needs_a_quick_integrator

# -------------------------------------------------------------------------------------------------
# docstrings

MODULES = sorted(
    name
    for _, name, package in pkgutil.walk_packages(spragsym.__path__, "spragsym.")
    if not name.endswith("__main__") and ".cli" not in name and ".derive" not in name
    for path in [
        ROOT / name.replace(".", "/") / "__init__.py"
        if package
        else ROOT / f"{name.replace('.', '/')}.py"
    ]
    if path.is_file() and ">>> " in path.read_text(encoding="utf-8")
)

#: Modules whose examples take long, or seconds: tests have the same calls.
LONG = (
    "spragsym.orbits.branch",
    "spragsym.orbits.diagram",
    "spragsym.bifurcation.hopf_curves",
    "spragsym.figures.curves",
    "spragsym.design.probability",
    "spragsym.design.jumps",
    "spragsym.design.margins",
    "spragsym.design.tube_certificates",
)
SECONDS = (
    "spragsym.orbits.fate_boundaries",
    "spragsym.orbits.basin_boundaries",
    "spragsym.bifurcation.critical",
)
#: The others by their room.
ROOMS = sorted({name.split(".")[1] for name in MODULES if name not in (*LONG, *SECONDS)})


@pytest.mark.by_hand(*SECONDS)
@pytest.mark.parametrize("name", few(["spragsym", *ROOMS, *LONG, *SECONDS], "spragsym", *ROOMS))
def test_docstring_examples(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each example of a room, or of a module of which they take long, runs as it stands."""
    if name.startswith(("orbits", "spragsym.orbits")) and LONG_MOTIONS_TAKE_MINUTES:
        pytest.skip(LONG_MOTIONS_TAKE_MINUTES)
    monkeypatch.chdir(ROOT)
    of_room = [one for one in MODULES if one.split(".")[1] == name and one not in (*LONG, *SECONDS)]
    for one in of_room or [name]:
        with contextlib.suppress(spragsym.core.errors.MissingExtraError):
            failed, _ = doctest.testmod(importlib.import_module(one), optionflags=OPTIONS)
            assert failed == 0, one


@pytest.mark.parametrize("name", [*LONG, *SECONDS])
def test_docstring_examples_that_take_long_can_be_read(name: str) -> None:
    for test in doctest.DocTestFinder().find(importlib.import_module(name)):
        for example in test.examples:
            compile(example.source, test.name, "single")


@pytest.mark.parametrize(
    "room", ["numerics", "files", "results", "statics", "bifurcation", "design", "cli"]
)
def test_a_room_has_what_it_offers(room: str) -> None:
    exec(f"from spragsym.{room} import *", {})


def lacking(found: object, *sections: str) -> list[str]:
    """Sections that a docstring lacks; an example with its output is one."""
    text = inspect.getdoc(found) or ""
    examples = doctest.DocTestParser().get_examples(text)
    lacks = [one for one in sections if f"\n{one}\n{'-' * len(one)}\n" not in text]
    return lacks + ["Examples"] * (not any(example.want for example in examples))


def test_what_is_public_says_what_it_takes_gives_and_refuses() -> None:
    """Functions and classes, and methods of results where they are written."""
    for room in (spragsym, spragsym.kang_nam):
        for name in room.__all__:
            found = getattr(room, name)
            if inspect.isfunction(found):
                signature = inspect.signature(found)
                gives = signature.return_annotation not in (None, "None")
                wanted = ["Parameters", "Raises"] * bool(signature.parameters) + ["Returns"] * gives
                assert lacking(found, *wanted) == [], name
            elif inspect.isclass(found) and not issubclass(found, spragsym.results.Result):
                assert lacking(found) == [], name
    for kind in {getattr(spragsym.results, name) for name in dir(spragsym.results)}:
        for name, method in vars(kind).items():
            if inspect.isfunction(method) and not name.startswith("_"):
                signature = inspect.signature(method)
                gives = signature.return_annotation not in (None, "None")
                wanted = ["Parameters"] * (len(signature.parameters) > 1) + ["Returns"] * gives
                assert lacking(method, *wanted) == [], method.__qualname__


# ------------------------------------------------------------------------------------------------
# README


@pytest.mark.thorough
def test_the_readme_in_the_shell_of_a_newcomer(tmp_path: Path) -> None:
    """Its commands and its Python, one after another in a folder that was empty, with nothing of
    this environment.
    """
    for block in fenced(README, "text"):
        for line in re.findall(r"^spragsym .*", block, re.MULTILINE):
            run(line, tmp_path, bare=True)
    for command, output in commands(README):
        if not command.startswith("make "):
            assert_shown(output, run(command, tmp_path, bare=True))
    text = "".join(fenced(README, "python"))
    assert text.count(">>> ") > 8
    (tmp_path / "readme.txt").write_text(text, encoding="utf-8")
    run("python -m doctest -o ELLIPSIS -o NORMALIZE_WHITESPACE readme.txt", tmp_path, bare=True)


def test_readme_links_and_numbers() -> None:
    text = README.read_text(encoding="utf-8")
    for link in re.findall(r"\]\(([^)#]+)\)", text):
        assert (ROOT / link).is_file(), link
    assert set(re.findall(r"`(make [a-z-]+)`", text)) <= {f"make {name}" for name in make_targets()}


def make_targets() -> set[str]:
    return set(
        re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    )


def test_table_of_corrections_is_the_ledgers() -> None:
    """Every misprint stands in the README, and the numbers that it quotes are the ledger's."""
    import json

    rows = json.loads((ROOT / "generated/ledger.json").read_text(encoding="utf-8"))["rows"]
    misprints = [row["id"] for row in rows if row["status"] == "misprint"]
    text = README.read_text(encoding="utf-8")
    assert re.findall(r"^\| ([\w-]+) \| .* \| .* \| .* \|$", text, re.MULTILINE)[1:] == misprints
    (eq6,) = [row["consequence"] for row in rows if row["id"] == "eq-6"]
    printed, right = (float(number) for number in re.findall(r"L = ([\d.]+\d)", eq6))
    assert f"L = {printed:.3f} where it is {right:.3f}" in text


def test_citation() -> None:
    import yaml

    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert cited["version"] == spragsym.__version__
    assert f"## {spragsym.__version__}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    article = cited["references"][0]
    assert (article["journal"], article["year"], article["volume"]) == (
        "Applied Sciences",
        2020,
        10,
    )
    assert f"10 ({article['year']}) {article['start']}" in README.read_text(encoding="utf-8")
    assert np.all([person["family-names"] for person in article["authors"]])


# ------------------------------------------------------------------------------------------------
# pages


def test_the_theory_names_what_exists() -> None:
    """Each function of derive/ and each test that the pages of the theory and of its statements
    name.
    """
    assert min(_named_in("theory"), _named_in("statements")) > 30


def _named_in(page: str) -> int:
    """How many functions of derive/ and tests a page names, all of which exist."""
    pytest.importorskip("sympy")
    named = re.findall(
        r"`(?!ss\.)(test_)?(\w+)\.(\w+)`", (DOCS / f"{page}.md").read_text(encoding="utf-8")
    )
    for test, module, name in named:
        if test:
            assert f"def {name}(" in next((ROOT / "tests").rglob(f"test_{module}.py")).read_text(
                encoding="utf-8"
            ), name
        else:
            own = (ROOT / "derive/kang_nam" / f"{module}.py").is_file()
            home = f"spragsym.derive.{'kang_nam.' if own else ''}{module}"
            assert callable(getattr(importlib.import_module(home), name)), name
    return len(named)


@pytest.mark.parametrize(
    "command",
    [
        pytest.param(command, marks=pytest.mark.thorough)
        if command.startswith("spragsym sweep")
        else command
        for command, _ in commands(DOCS / "command_line.md")
    ],
)
def test_command_line_page(command: str, tmp_path: Path) -> None:
    assert_shown(dict(commands(DOCS / "command_line.md"))[command], run(command, tmp_path))


def test_the_page_on_the_command_line_lists_every_command() -> None:
    from spragsym.cli import COMMANDS

    listed = re.findall(
        r"^\| `(\w+)` \|", (DOCS / "command_line.md").read_text(encoding="utf-8"), re.MULTILINE
    )
    assert sorted(listed) == sorted(COMMANDS)


def test_the_table_of_questions_names_every_public_name_once_and_its_page() -> None:
    rows = re.findall(
        r"^\| .*\? \| (`.*`) \| \[\]\((api_\w+\.md)\) \|$",
        (DOCS / "api.md").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    named = [name for names, _ in rows for name in re.findall(r"`(\w+)`", names)]
    assert len(named) == len(set(named))
    assert set(spragsym.__all__) - {"results", "__version__"} == set(named) - {"open"}
    for names, page in rows:
        text = (DOCS / page).read_text(encoding="utf-8")
        for name in re.findall(r"`(\w+)`", names):
            assert re.search(rf"spragsym\.(core\.)?{name}\b", text), (name, page)


#: The parts of the cookbook, each the steps of one user.
USERS = ("Engineer", "Student", "Referee")


@pytest.mark.thorough
@needs_a_quick_integrator
@pytest.mark.parametrize("user", USERS)
def test_steps_of_a_user_are_those_of_the_cookbook(
    user: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every recipe of the part, one after another in one folder."""
    for module in ("matplotlib", "xarray", "pandas"):
        pytest.importorskip(module)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for question, code in recipes(user):
        file = tmp_path / "recipe.md"
        file.write_text(code, encoding="utf-8")
        for command, output in commands(file):
            assert_shown(output, run(command, tmp_path))
        for block in fenced(file, "python"):
            test = doctest.DocTestParser().get_doctest(block, names, question, None, 0)
            runner = doctest.DocTestRunner(optionflags=OPTIONS)
            assert runner.run(test, clear_globs=False).failed == 0, question
            names = test.globs


def recipes(user: str) -> list[tuple[str, str]]:
    """Questions of a part of the cookbook, each with its recipe."""
    text = (DOCS / "cookbook.md").read_text(encoding="utf-8")
    part = text.partition(f"\n## {user}\n")[2].partition("\n## ")[0]
    found = re.split(r"^### \d+\. (.*)$", part, flags=re.MULTILINE)[1:]
    return list(zip(found[::2], found[1::2], strict=True))


def test_every_question_of_the_cookbook_has_a_recipe() -> None:
    text = (DOCS / "cookbook.md").read_text(encoding="utf-8")
    numbers = [int(number) for number in re.findall(r"^### (\d+)\. .*\?$", text, re.MULTILINE)]
    every = [code for user in USERS for _, code in recipes(user)]
    assert numbers == list(range(1, len(every) + 1))
    assert len(every) >= 30
    assert all("\n>>> " in code or "\n$ " in code for code in every)


def test_files_that_contributing_names_exist() -> None:
    """By their whole path, or its end where the sentence has said the room; but for those that a
    reader is to write.
    """
    tracked = [
        str(path.relative_to(ROOT))
        for room in ("derive", "spragsym", "tests", "explorer/src")
        for path in (ROOT / room).rglob("*.*")
    ]
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    to_write = (
        "spragsym/design/snap_energy.py",
        "derive/emit/targets/text/__init__.py",
        "derive/models/NAME.py",
    )
    for name in set(re.findall(r"`([\w/.]+\.(?:py|js|c|toml|html))`", text)) - {*to_write}:
        assert (ROOT / name).is_file() or any(path.endswith(f"/{name}") for path in tracked), name


def test_the_question_of_contributing_is_answered() -> None:
    """By the strain energy of the article's model, written by hand."""
    room = ModuleType("spragsym.design.snap_energy")
    room.__package__ = "spragsym.design"
    exec(fenced(ROOT / "CONTRIBUTING.md", "python")[0], vars(room))
    p, values = spragsym.Parameters.article(mu0=0.5), np.radians([40.0, 50.0])
    (jump,) = spragsym.quasi_static_path(p, "theta0", values).jumps
    one, other = (
        (0.007 * at["x"] ** 2 + 0.1 * (at["L"] - 1) ** 2 + at["y"] ** 2) / 2
        for at in (jump.before, jump.after)
    )
    assert room.snap_energy(p, "theta0", values) == pytest.approx([other - one], rel=1e-12)


#: Pages whose cells run here, and the one on clusters, which test_sweeps runs.
PAGES = ("tutorial", "howto_units", "howto_many", "howto_brake")
CELL = r"\{code-cell\} python"


@needs_a_quick_integrator
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.thorough if name == "howto_brake" else ())
        for name in PAGES
    ],
)
def test_code_cells_of_the_pages_run(name: str) -> None:
    """What ``make docs`` executes."""
    pytest.importorskip("matplotlib")
    code = "\n".join(fenced(DOCS / f"{name}.md", CELL))
    code = re.sub(r"^[:%].*", "", code, flags=re.MULTILINE)  # tags and magics
    exec(compile(code, f"docs/{name}.md", "exec"), {})


def test_every_page_with_cells_is_run() -> None:
    held = {page.stem for page in DOCS.glob("*.md") if fenced(page, CELL)}
    assert held == {*PAGES, "howto_cluster"}


@pytest.mark.thorough
def test_commands_of_the_pages_on_brakes_and_clusters_run(tmp_path: Path) -> None:
    for command, output in commands(DOCS / "howto_brake.md"):
        assert_shown(output, run(command, tmp_path))
    for line in "".join(fenced(DOCS / "howto_cluster.md", "sh")).splitlines():
        run(line, tmp_path)
    written = sorted(path.name for path in tmp_path.iterdir())
    assert written == ["brake.toml", "over.csv", "over.svg", "rms.nc"]


@pytest.mark.thorough
@needs_a_quick_integrator
@pytest.mark.parametrize("name", ["howto_squeal", "howto_finite_elements"])
def test_the_pages_on_squeal_run(name: str, tmp_path: Path) -> None:
    """The file that one shows, its commands one after another, and its Python."""
    page = DOCS / f"{name}.md"
    for text in fenced(page, "toml"):
        (tmp_path / "squeal.toml").write_text(text, encoding="utf-8")
    for command, output in commands(page):
        assert_shown(output, run(command, tmp_path))
    test = doctest.DocTestParser().get_doctest(fenced(page, "python")[0], {}, page.name, None, 0)
    assert doctest.DocTestRunner(optionflags=OPTIONS).run(test).failed == 0


@pytest.mark.thorough
def test_the_pages_build_without_warnings(tmp_path: Path) -> None:
    """As ``make docs`` does, but for their cells, which run above."""
    for module in ("sphinx", "myst_nb", "numpydoc", "furo"):
        pytest.importorskip(module, exc_type=ImportError)
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "sphinx",
            "-W",
            "-q",
            "-D",
            "nb_execution_mode=off",
            str(DOCS),
            str(tmp_path / "html"),
        ],
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr


def test_what_the_glossary_names_is_there() -> None:
    """Each term leads to a function or class of the package."""
    named = re.findall(
        r"`([a-z_]+(?:\.[a-z_]+)*\.\w+)`", (DOCS / "glossary.md").read_text(encoding="utf-8")
    )
    assert len(named) > 40
    for path in named:
        module, _, name = path.rpartition(".")
        assert hasattr(importlib.import_module(f"spragsym.{module}"), name), path


# ------------------------------------------------------------------------------------------------
# names in texts

#: What a name in a text begins with → what it then is a name of.
ROOTS: dict[str, Callable[[], object]] = {
    "ss": lambda: spragsym,
    "spragsym": lambda: spragsym,
    "model": lambda: spragsym.load("kang_nam"),
    "page": lambda: pytest.importorskip("spragsym.derive.model").Page("A page."),
    "p": lambda: spragsym.load("kang_nam").Parameters(theta0=0.8),
}
NAME = re.compile(rf"(?<![\w./\"'-])({'|'.join(ROOTS)})((?:\.[a-zA-Z_]\w*)+)(?![\w/]|-\w)")
#: Endings of files, which may begin as names do.
FILES = (
    "py",
    "toml",
    "json",
    "csv",
    "md",
    "html",
    "fmu",
    "svg",
    "pdf",
    "png",
    "npz",
    "h5",
    "h",
    "c",
    "mjs",
    "ts",
)


def names_in(code: str) -> set[tuple[str, str]]:
    """Names of the package, models, pages and parameters in code, each with its beginning."""
    found = {(match[1], match[2][1:]) for match in NAME.finditer(code)}
    return {(root, path) for root, path in found if path.rpartition(".")[2] not in FILES}


def is_there(root: object, path: str) -> bool:
    """Whether the first names of a path are there, as far as values are known without a call."""
    for name in path.split("."):
        if name in getattr(root, "__annotations__", {}):  # a field of a record
            return True
        if not hasattr(root, name):
            if not inspect.ismodule(root):
                return False
            try:
                importlib.import_module(f"{root.__name__}.{name}")
            except ImportError:
                return False
        root = getattr(root, name)
    return True


def texts() -> Iterator[tuple[str, str]]:
    """Pieces of code in pages and docstrings, each with where it stands."""
    for page in (
        README,
        ROOT / "CONTRIBUTING.md",
        ROOT / "CHANGELOG.md",
        *sorted(DOCS.glob("*.md")),
    ):
        whole = page.read_text(encoding="utf-8")
        blocks = re.findall(r"^```(?:python|\{code-cell\} python)\n(.*?)^```$", whole, re.M | re.S)
        spans = re.findall(r"`([^`\n]+)`", re.sub(r"^```.*?^```$", "", whole, flags=re.M | re.S))
        yield from ((page.name, code) for code in (*blocks, *spans))
    for folder in ("spragsym", "derive"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                kinds = (ast.Module, ast.ClassDef, ast.FunctionDef)
                if isinstance(node, kinds) and (said := ast.get_docstring(node)):
                    of = f"{path.relative_to(ROOT)}, {getattr(node, 'name', 'its head')}"
                    yield from ((of, code) for code in re.findall(r"`~?([^`\n]+)`", said))


@pytest.mark.thorough
def test_names_in_texts_are_there() -> None:
    """Of the package, models, pages and parameters; not `model.equilibria`, which none has."""
    library = pytest.importorskip("spragsym.derive.kang_nam.library")
    known = {root: make() for root, make in ROOTS.items()}
    of_octave = {Path(name).stem for name in library.exported("matlab")}
    missing = {
        (where, f"{root}.{path}")
        for where, code in texts()
        for root, path in names_in(code)
        if not is_there(known[root], path)
        and not (where == "howto_languages.md" and path.partition(".")[0] in of_octave)
    }
    assert missing == set()
