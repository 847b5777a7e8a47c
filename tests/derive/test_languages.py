"""The house as CONTRIBUTING draws it, and a language added by its words alone."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support import ROOT

PAGE = ROOT / "CONTRIBUTING.md"
#: Modules of spragsym that every room may use.
SERVANTS = {"assumed", "_version", "display", "questions", "errors", "names", "progress"}


def section(title: str) -> str:
    """One section of CONTRIBUTING."""
    return PAGE.read_text(encoding="utf-8").split(f"\n## {title}\n")[1].split("\n## ")[0]


def imported(path: Path, root: Path) -> set[tuple[str, ...]]:
    """Modules below ``root`` that a file imports, by relative names or by ``import_module``, as parts of their paths."""
    package = path.relative_to(root).parts[:-1]
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.level:
            start = package[: len(package) - node.level + 1]
            module = (*start, *(node.module.split(".") if node.module else ()))
            found |= {(*module, alias.name) for alias in node.names}
        elif isinstance(node, ast.Call) and "import_module" in ast.unparse(node.func) and isinstance(node.args[0], ast.Constant):
            name = str(node.args[0].value)
            found |= {tuple(name.split(".")[1:])} if name.startswith(f"{root.name}.") else set()
    return found


# ------------------------------------------------------------------------------------------------------ the rooms


def arrows(indent: int = 4) -> dict[str, set[str]]:
    """Rooms of spragsym in the picture, or with a deeper indent those of its models, and the rooms that each may import from."""
    drawn = re.findall(rf"^ {{{indent}}}(\w+) .*<- (.*)$", section("The house"), re.MULTILINE)
    rooms: dict[str, set[str]] = {}
    for name, text in drawn:
        before = {*rooms, "generated"}
        if text.startswith("all above"):
            left_out = set(re.findall(r"\w+", text.partition(" but ")[2])) - {"and"}
            assert left_out <= before
            rooms[name] = before - left_out
        else:
            rooms[name] = set() if text == "nothing" else set(text.split(", "))
        assert rooms[name] <= before, f"{name} stands on what comes after it"
    return rooms


@pytest.mark.thorough
def test_the_picture_shows_every_room_and_every_import() -> None:
    spragsym, rooms = ROOT / "spragsym", arrows()
    folders = {path.parent.name for path in spragsym.glob("*/__init__.py") if not path.parent.is_symlink()}
    assert folders <= set(rooms)
    for name, below in rooms.items():
        files = sorted((spragsym / name).rglob("*.py")) or [spragsym / f"{name}.py"]
        for path in files:
            used = {parts[0] for parts in imported(path, spragsym)} - SERVANTS - {name}
            if name == "cli":
                used -= {"derive"}  # loaded when a command asks for it
            if name == "parameters":
                used -= {"models"}  # a set loads its model when it is asked for
            assert used <= below, f"{path.relative_to(ROOT)} imports from {sorted(used - below)}"
    inner = arrows(indent=6)
    assert {path.parent.name for path in spragsym.glob("models/*/__init__.py")} == set(inner)
    for name, below in inner.items():
        for path in sorted((spragsym / "models" / name).glob("*.py")):
            used = {parts[1] for parts in imported(path, spragsym) if parts[0] == "models"} - {name, "model"}
            assert used <= below, f"{path.relative_to(ROOT)} imports from {sorted(used - below)}"


# ------------------------------------------------------------------------------------------------- a new language


def steps() -> str:
    """The section on languages, without the indentation that the text of a numbered step has."""
    return re.sub(r"^   ", "", section("Add a language"), flags=re.MULTILINE)


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the tree with the folder that CONTRIBUTING shows, and nothing else changed."""
    copy = tmp_path_factory.mktemp("house")
    ignored = shutil.ignore_patterns("__pycache__", "*.so", "*.egg-info")
    for folder in ("derive", "generated", "spragsym"):
        shutil.copytree(ROOT / folder, copy / folder, symlinks=True, ignore=ignored)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, copy)
    shown = r"`(derive/emit/targets/\w+/__init__\.py)`:\n\n```python\n(.*?)\n```"
    ((path, program),) = re.findall(shown, steps(), re.DOTALL)
    (copy / path).parent.mkdir()
    (copy / path).write_text(program + "\n", encoding="utf-8")
    return copy


# ----------------------------------------------------------------------------------------- what is printed


@pytest.mark.thorough
def test_generated_c_comes_out_formatted() -> None:
    """The printer lays C out by itself, as clang-format would, for any model; of the article's another one knows nothing."""
    pytest.importorskip("sympy")
    from spragsym.derive import export

    formatter = shutil.which("clang-format", path=Path(sys.executable).parent)
    if formatter is None:
        pytest.skip("clang-format is not installed")
    published = ROOT / "generated" / "c"
    texts = {name: (published / name).read_text(encoding="utf-8") for name in ("spragsym.h", "spragsym.c", "main.c")}
    another = export.export(ROOT / "tests/oracles/pages/pressed.py", "pressed", "c")
    for path in ("pressed.h", "pressed.c"):
        assert not re.search(r"spragsym_|theta|@(?!file|param|return)", another[path], re.IGNORECASE), path
    for name, text in {**texts, **{name: text for name, text in another.items() if name != "Makefile"}}.items():
        call = [formatter, f"--style=file:{ROOT / '.clang-format'}", f"--assume-filename={name}"]
        done = subprocess.run(call, input=text, capture_output=True, text=True, timeout=60, check=True)
        assert done.stdout == text, name
