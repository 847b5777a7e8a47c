"""Wheel and source distribution: complete, and the runtime without SymPy in an otherwise empty
environment.
"""

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tomllib
import venv
import zipfile
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

import spragsym
from tests.support import NO_ENVIRONMENT, ROOT, few, needs_posix

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))

#: What ``pip install spragsym`` brings, by the names of its folders in site-packages.
RUNTIME = (
    "numpy",
    "numpy.libs",
    "scipy",
    "scipy.libs",
    "mpmath",
    "click",
    "rich",
    "pygments",
    "markdown_it*",
    "mdurl",
    "filelock",
    "lazy_loader",
)


def sources(folder: Path) -> dict[str, Path]:
    """Packages below a folder by dotted name; links are not followed."""
    found = {}
    for init in sorted(folder.rglob("__init__.py")):
        if "__pycache__" not in init.parts:
            found[".".join(init.parent.relative_to(folder.parent).parts)] = init.parent
    return found


def test_packages_are_those_of_the_tree() -> None:
    listed = PROJECT["tool"]["setuptools"]["packages"]
    tree = {
        name: path
        for name, path in sources(ROOT / "spragsym").items()
        if not (ROOT / "spragsym" / path.name).is_symlink()
    }
    for folder in ("derive", "generated"):
        tree |= {f"spragsym.{name}": path for name, path in sources(ROOT / folder).items()}
    # A target language is found by its folder, by setuptools too: as data of the registry's
    # package.
    tree = {
        name: path
        for name, path in tree.items()
        if not name.startswith("spragsym.derive.emit.targets.")
    }
    assert sorted(listed) == sorted(tree)
    assert len(listed) == len(set(listed))


def test_parts_are_found_beside_the_package_where_there_are_no_links(tmp_path: Path) -> None:
    for name in ("spragsym", "derive", "generated"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text(f"name = {name!r}", encoding="utf-8")
    for name in ("__init__.py", "__init__.pyi"):
        shutil.copy(ROOT / "spragsym" / name, tmp_path / "spragsym")
    program = "import spragsym.derive; print(spragsym.derive.name, spragsym.generated.name)"
    assert (
        subprocess.check_output([sys.executable, "-c", program], cwd=tmp_path, text=True)
        == "derive generated\n"
    )


# ------------------------------------------------------------------------------------------------
# archives


def clone(folder: Path) -> Path:
    """A copy of the tree as Git would give it, named spragsym."""
    copy = folder / "spragsym"
    ignored = shutil.ignore_patterns(
        ".git", ".venv", "__pycache__", "*.egg-info", ".*_cache", "*.so", "node_modules"
    )
    shutil.copytree(ROOT, copy, symlinks=True, ignore=ignored)
    return copy


@pytest.fixture(scope="module")
def archives(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A wheel, built from the source distribution, and that, built from a copy of the tree without
    a network.

    Nothing is compiled for it, which takes most of the time: what needs the compiled solver builds
    :func:`wheel_by` a compiler.
    """
    if importlib.util.find_spec("build") is None:
        pytest.skip("build is not installed: pip install 'spragsym[test]'")
    out = tmp_path_factory.mktemp("dist")
    copy = clone(tmp_path_factory.mktemp("tree"))
    done = subprocess.run(
        [sys.executable, "-m", "build", "--no-isolation", "--outdir", str(out), str(copy)],
        env=os.environ | {"CC": "/bin/false"},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    (wheel,), (sdist,) = out.glob("*.whl"), out.glob("*.tar.gz")
    return wheel, sdist


def committed(*folders: str) -> set[str]:
    """Files of the tree below some folders, without what tools leave there."""
    skipped = {"__pycache__", "_build", "jupyter_execute"}
    links = [
        ROOT / "spragsym" / name for name in ("derive", "generated")
    ]  # without symbolic links, files
    paths = (path for folder in folders for path in (ROOT / folder).rglob("*") if path not in links)
    return {
        path.relative_to(ROOT).as_posix()
        for path in paths
        if path.is_file()
        and not skipped & set(path.parts)
        and path.suffix not in (".pyc", ".so", ".pyd")
    }


@pytest.mark.thorough
def test_the_wheel_holds_all_of_the_package(archives: tuple[Path, Path]) -> None:
    with zipfile.ZipFile(archives[0]) as wheel:
        names = set(wheel.namelist())
    for path in committed("derive", "generated"):
        assert f"spragsym/{path}" in names
    for path in committed("spragsym"):
        assert path in names
    assert {name.split("/")[0] for name in names} == {
        "spragsym",
        f"spragsym-{spragsym.__version__}.dist-info",
    }
    for name in (
        "generated/c/spragsym.h",
        "generated/c/spragsym.c",
        "generated/ledger.json",
        "generated/LEDGER.md",
        "py.typed",
    ):
        assert f"spragsym/{name}" in names
    assert any(name.endswith("licenses/LICENSE") for name in names)


@pytest.mark.thorough
def test_the_source_distribution_holds_all_of_the_tree(archives: tuple[Path, Path]) -> None:
    with tarfile.open(archives[1]) as sdist:
        names = {name.partition("/")[2] for name in sdist.getnames()}
    wanted = committed("derive", "generated", "spragsym", "tests", "benchmarks", "docs")
    wanted |= {
        "Makefile",
        "README.md",
        "LICENSE",
        "CITATION.cff",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "constraints.txt",
    }
    wanted |= {"pyproject.toml", ".ci/run", ".ci/compiled.py", ".pre-commit-config.yaml"}
    assert wanted - names == set()
    assert not any("__pycache__" in name for name in names)


# ------------------------------------------------------------------------------------------------
# with a compiler

COMPILER = next(filter(shutil.which, ("cc", "gcc", "clang")), None)
needs_compiler = pytest.mark.skipif(COMPILER is None, reason="no C compiler")


def extensions(wheel: Path) -> list[str]:
    """Extension modules in a wheel, with their folders."""
    with zipfile.ZipFile(wheel) as archive:
        return [name for name in archive.namelist() if name.endswith(tuple(EXTENSION_SUFFIXES))]


def wheel_by(compiler: str, sdist: Path, out: Path) -> Path:
    """What pip makes of the source distribution where ``CC`` is that compiler."""
    done = subprocess.run(
        [
            sys.executable,
            "-m",
            "pip",
            "wheel",
            "--quiet",
            "--no-deps",
            "--no-build-isolation",
            "--no-index",
            "-w",
            out,
            sdist,
        ],
        env=os.environ | {"CC": compiler},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    (wheel,) = out.glob("*.whl")
    return wheel


@pytest.mark.thorough
@needs_posix
@needs_compiler
def test_the_wheel_holds_the_compiled_solver(archives: tuple[Path, Path], tmp_path: Path) -> None:
    hasty = tmp_path / "hasty"  # the last -O counts
    hasty.write_text(f'#!/bin/sh\nexec {COMPILER} "$@" -O0\n', encoding="utf-8")
    hasty.chmod(0o755)
    wheel = wheel_by(str(hasty), archives[1], tmp_path)
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    assert sorted(extensions(wheel)) == [
        f"spragsym/{name}{suffix}"
        for name in (
            "kang_nam/quartic/_compiled",
            "motion/_carried",
            "numerics/_contractors",
            "numerics/_search",
            "numerics/_tape",
        )
    ]
    assert not wheel.name.endswith("-none-any.whl")


# ------------------------------------------------------------------------------------------------
# an empty environment


def environment(home: Path, wheel: Path | None) -> Path:
    """An environment with a wheel, or this tree, and what it requires, and nothing else; its
    interpreter.
    """
    if os.name != "posix":
        pytest.skip("needs links to what is installed")
    venv.create(home, with_pip=False, symlinks=True)
    interpreter = home / "bin/python"
    here, there = (
        Path(sysconfig.get_paths()["purelib"]),
        home / "lib" / f"python{sys.version_info[0]}.{sys.version_info[1]}",
    )
    for name in RUNTIME:
        for path in (*here.glob(name), *here.glob(f"{name.partition('.')[0]}-*.dist-info")):
            link = there / "site-packages" / path.name
            if not link.exists():
                link.symlink_to(path)
    if wheel is None:
        (there / "site-packages/spragsym").symlink_to(ROOT / "spragsym")
        return interpreter
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(there / "site-packages")
    return interpreter


@pytest.fixture(scope="module", params=few(["tree", "wheel"], "tree"))
def python(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An environment without the extras."""
    wheel = request.getfixturevalue("archives")[0] if request.param == "wheel" else None
    return environment(tmp_path_factory.mktemp("empty"), wheel)


def call(python: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run it away from the tree, without a word of this environment."""
    command = [python, "-I", "-W", "error", *arguments]
    return subprocess.run(
        command, cwd=python.parent, env=NO_ENVIRONMENT, capture_output=True, text=True, timeout=120
    )


@pytest.mark.thorough
def test_runtime_without_extras(python: Path) -> None:
    program = (
        "import sys, numpy as np, spragsym as ss\n"
        "assert not {'sympy', 'matplotlib', 'flint', 'heyoka'} & set(sys.modules)\n"
        "turn = ss.folds(ss.Parameters.article()).theta0[0]\n"
        "p = ss.Parameters.article(theta0=[*np.radians([30.0, 49.0]), turn])\n"
        "eq = ss.equilibria(p)\n"
        "assert eq.count[:2].tolist() == [3, 1] and eq.escalated[2], (eq.count, eq.escalated)\n"
        "assert 'sympy' not in sys.modules\n"
        "assert ss.simulate(p.replace(theta0=0.9), V=0.5, d=10.0, t_end=20.0).backend in "
        "('compiled', 'scipy')\n"
        "print(ss.__file__)\n"
    )
    done = call(python, "-c", program)
    assert done.returncode == 0, done.stderr
    assert str(python.parent.parent) in done.stdout


@pytest.mark.thorough
def test_commands_without_extras(python: Path) -> None:
    assert (
        call(python, "-m", "spragsym", "--version").stdout
        == f"spragsym, version {spragsym.__version__}\n"
    )
    done = call(python, "-m", "spragsym", "equilibria", "--theta0", "30", "--json")
    assert len(json.loads(done.stdout)["equilibria"]) == 4, done.stderr
    for language in (
        "c",
        "javascript",
        "matlab",
    ):  # put together from what was generated, without SymPy
        done = call(
            python,
            "-m",
            "spragsym",
            "export",
            "--language",
            language,
            "--out",
            str(python.parent / language),
        )
        assert done.returncode == 0, done.stderr
    for name in ("c/spragsym.c", "javascript/spragsym.mjs", "matlab/+spragsym/kernel.m"):
        assert (python.parent / name).is_file()


@pytest.mark.parametrize(
    ("arguments", "extra"),
    [
        (["check", "--again"], "derive"),
        pytest.param(["bifurcation", "--plot", "a.pdf"], "plot", marks=pytest.mark.thorough),
        pytest.param(["figures", "--out", "figures"], "plot", marks=pytest.mark.thorough),
        (["simulate", "--theta0", "49", "--backend", "heyoka"], "fast"),
        pytest.param(
            ["simulate", "--theta0", "49", "--t-end", "1600", "--output", "a.nc"],
            "sweep",
            marks=pytest.mark.thorough,
        ),
        pytest.param(
            ["sweep", "--theta0", "49", "--output", "a.nc"], "sweep", marks=pytest.mark.thorough
        ),
    ],
)
def test_a_missing_extra_is_named(python: Path, arguments: list[str], extra: str) -> None:
    done = call(python, "-m", "spragsym", *arguments)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("spragsym: ")
    assert done.stderr.count("\n") == 1
    assert f"pip install '.[{extra}]'" in done.stderr
