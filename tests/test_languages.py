"""The house as CONTRIBUTING draws it, and a language added by its words alone."""

from __future__ import annotations

import ast
import ctypes
import json
import math
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.test_documents import ROOT, assert_shown, commands, run

PAGE = ROOT / "CONTRIBUTING.md"
#: Modules of spragsym that every room may use.
SERVANTS = {"assumed", "_version", "display", "door", "errors", "names", "progress"}


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


def test_the_general_floor_knows_no_model() -> None:
    derive = ROOT / "derive"
    general = [derive / "algebra.py", *sorted((derive / "emit").rglob("*.py"))]
    assert len(general) > 10
    for path in general:
        assert not any("kang_nam" in parts for parts in imported(path, derive)), path


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


@pytest.mark.thorough
def test_a_folder_is_all_that_a_new_language_needs(house: Path) -> None:
    """The steps as CONTRIBUTING shows them: the language is found, generated, offered, exported and packed."""
    pytest.importorskip("sympy")
    page = house / "page.md"
    page.write_text(steps(), encoding="utf-8")
    done = commands(page)
    assert len(done) == 2
    for command, shown in done:
        assert_shown(shown, run(command, house))
    text = (house / "plain/algebra.txt").read_text(encoding="utf-8")
    assert "f_slope(cos, sin, a_f, b_f, d_f, m_f) gives f′" in text
    build = "from setuptools import setup; setup()"
    packed = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", build, "-q", "build_py", "--build-lib", "lib"], cwd=house,
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert packed.returncode == 0, packed.stderr
    for name in ("generated/text/algebra.txt", "generated/text/target.json", "derive/emit/targets/text/__init__.py"):
        assert (house / "lib/spragsym" / name).is_file()
    assert not list((house / "lib").rglob("*.pyc"))


# --------------------------------------------------------------------------------- a model that is not the article's


@pytest.fixture(scope="module")
def pendulum() -> dict[str, str]:
    """What every target makes of a driven pendulum: algebra only, no kernel and no files of its own."""
    sp = pytest.importorskip("sympy")
    from spragsym.derive.emit import language, targets
    from spragsym.derive.emit.function import Function, Module
    from spragsym.derive.emit.quantities import Quantity

    sine, rate, damping, drive = sp.symbols("s rate damping drive", real=True)
    meanings = {sine: "sin φ", rate: "dφ/dτ", damping: "damping over critical", drive: "torque over weight and length"}
    acceleration = -sine - 2 * damping * rate - rate * sp.Abs(rate) ** 3 / 7 + drive * sp.exp(-sp.sqrt(1 + drive**2))
    arguments = (sine, rate, damping, drive)
    functions = (
        Function("acceleration", "Angular acceleration.", "Newton's law", arguments, acceleration, "φ″", transcendental=True),
        Function(
            "slopes", "Its derivatives.", "by hand", arguments, (sp.S(-1), -2 * damping - sp.Abs(rate) ** 3 * 4 / 7), "both"
        ),
    )
    return targets.render(
        targets.Material(
            modules=(Module("pendulum", "A driven pendulum.", functions),),
            kernel=language.NOTHING,
            counts={},
            quantities={str(it): Quantity(it, str(it), text) for it, text in meanings.items()},
            parameters=("damping", "drive"),
            base_values={},
            public=("acceleration", "slopes"),
            variant=False,
            digest="0123456789abcdef",
            header="Generated.",
            library="pendulum",
            summary="A driven pendulum.",
        )
    )


def test_a_model_without_a_kernel_is_printed(pendulum: dict[str, str]) -> None:
    assert {"pendulum.py", "quantities.py", "c/pendulum.c", "c/pendulum.h", "c/target.json"} <= pendulum.keys()
    assert not {"kernel.py", "c/main.c", "c/Makefile"} & pendulum.keys()
    assert json.loads(pendulum["c/target.json"])["files"] == ["pendulum.h", "pendulum.c"]
    for path in ("c/pendulum.h", "c/pendulum.c"):
        assert not re.search("spragsym|theta", pendulum[path], re.IGNORECASE), f"{path} knows the article's model"
        assert not re.search(r"@(?!file|param|return)", pendulum[path]), f"{path} has a place that nothing fills"


@pytest.mark.skipif(not shutil.which("cc"), reason="no C compiler on this machine")
def test_c_computes_a_model_without_a_kernel(pendulum: dict[str, str], tmp_path: Path) -> None:
    for path in ("pendulum.h", "pendulum.c"):
        (tmp_path / path).write_text(pendulum[f"c/{path}"], encoding="utf-8")
    built = tmp_path / "pendulum.so"
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-Wconversion", "-Wshadow", "-shared", "-fPIC"]
    done = subprocess.run(
        ["cc", *flags, "-o", built, tmp_path / "pendulum.c", "-lm"], capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
    library = ctypes.CDLL(str(built))
    sine, rate, damping, drive = 0.3, -1.7, 0.05, 0.8
    value = (ctypes.c_double * 2)()
    numbers = [ctypes.c_double(number) for number in (sine, rate, damping, drive)]
    assert library.pendulum_acceleration(*numbers, value) == 0
    expected = -sine - 2 * damping * rate - rate * abs(rate) ** 3 / 7 + drive * math.exp(-math.hypot(1.0, drive))
    assert value[0] == pytest.approx(expected, rel=1e-14)
    assert library.pendulum_slopes(*numbers, value) == 0
    h = 1e-5
    ahead, behind = (-2 * damping * (rate + s * h) - (rate + s * h) * abs(rate + s * h) ** 3 / 7 for s in (1, -1))
    assert list(value) == pytest.approx([-1.0, (ahead - behind) / (2 * h)], rel=1e-9)
    assert library.pendulum_slopes(ctypes.c_double(math.nan), *numbers[1:], value) == 2


@pytest.mark.thorough
def test_generated_c_comes_out_formatted(pendulum: dict[str, str], tmp_path: Path) -> None:
    """The printer lays C out by itself, as clang-format would, for any model."""
    formatter = shutil.which("clang-format", path=Path(sys.executable).parent)
    if formatter is None:
        pytest.skip("clang-format is not installed")
    published = ROOT / "generated" / "c"
    texts = {name: (published / name).read_text(encoding="utf-8") for name in ("spragsym.h", "spragsym.c", "main.c")}
    for name, text in {**texts, "pendulum.h": pendulum["c/pendulum.h"], "pendulum.c": pendulum["c/pendulum.c"]}.items():
        call = [formatter, f"--style=file:{ROOT / '.clang-format'}", f"--assume-filename={name}"]
        done = subprocess.run(call, input=text, capture_output=True, text=True, timeout=60, check=True)
        assert done.stdout == text, name


def test_the_same_file_from_two_targets_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("sympy")
    from spragsym.derive.emit import targets

    made = targets.Target("one", "One", "same", lambda material: {"a.txt": ""})
    monkeypatch.setattr(targets, "targets", lambda: (made, made))
    material = targets.Material((), None, {}, {}, (), {}, (), False, "", "")  # type: ignore[arg-type]  # no kernel is read
    with pytest.raises(ArithmeticError, match=r"One: another target writes same/a\.txt too"):
        targets.render(material)
