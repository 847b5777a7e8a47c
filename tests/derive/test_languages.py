"""Languages: the bits of C, what their page shows, and one added by the words of CONTRIBUTING
alone.
"""

import ctypes
import inspect
import itertools
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.derive import export
from spragsym.derive.emit import targets
from spragsym.derive.kang_nam import library
from tests.oracles import languages
from tests.oracles.languages import NODE, OCTAVE
from tests.shown import DOCS, commands, programs, run
from tests.support import ROOT

PAGE = ROOT / "CONTRIBUTING.md"


def section(title: str) -> str:
    """One section of CONTRIBUTING."""
    return PAGE.read_text(encoding="utf-8").split(f"\n## {title}\n")[1].split("\n## ")[0]


# ------------------------------------------------------------------------------------------------
# languages that are there


@pytest.mark.thorough
@pytest.mark.parametrize("contact", [True, False])
@pytest.mark.parametrize(
    ("there", "solved"),
    [(NODE, languages.in_node), (OCTAVE, languages.in_octave)],
    ids=["node", "Octave"],
)
def test_every_bit_is_that_of_c(
    there: str | None, solved: Callable[..., Any], contact: bool, c_library: ctypes.CDLL
) -> None:
    """Statuses, counts, states and bounds of all points, vouched for or not: one kernel, no
    operation of it different.
    """
    if there is None:
        pytest.skip("it is not on this machine")
    p = languages.adversarial(120)
    found = solved(p, contact)
    assert not languages.unlike_c(found, c_library, p, contact).any()
    filled = np.arange(4) < found.count[:, None]
    assert all(
        np.array_equal(np.isfinite(found.columns[name]), filled)
        for name in ("theta", "L", "x", "y")
    )


def in_node(program: str) -> str:
    command, folder = [str(NODE), "--input-type=module"], languages.library("javascript")
    return subprocess.run(
        command, cwd=folder, input=program, capture_output=True, text=True, timeout=60, check=True
    ).stdout


def in_octave(program: str) -> str:
    return languages.octave(
        languages.library("matlab"), f"set(0, 'defaultfigurevisible', 'off');\n{program}"
    )


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("language", "there", "ran"), [("javascript", NODE, in_node), ("matlab", OCTAVE, in_octave)]
)
def test_programs_of_the_page_print_what_it_shows(
    language: str, there: str | None, ran: Callable[[str], str]
) -> None:
    if there is None:
        pytest.skip("it is not on this machine")
    shown = programs(DOCS / "howto_languages.md", language)
    assert len(shown) > 2
    for example in languages.library(language).glob("example_*.m"):
        text = example.read_text(encoding="utf-8")
        assert text.removesuffix("% SPDX-License-Identifier: MIT\n") in dict(shown)
    for program, output in shown:
        assert ran(program).startswith(output)


def test_the_program_of_the_page_in_python_prints_what_it_shows(
    capsys: pytest.CaptureFixture[str],
) -> None:
    shown = programs(DOCS / "howto_languages.md", "python")
    ((program, output),) = (one for one in shown if "mpmath" in one[0])
    with mpmath.workdps(15):
        exec(program, {})
    assert capsys.readouterr().out == output


@pytest.mark.thorough
@pytest.mark.parametrize("language", ["casadi", "jax"])
def test_a_library_that_differentiates_has_our_jacobians_and_finds_the_design(
    language: str, tmp_path: Path
) -> None:
    """Its own of forces and accelerations, at a thousand sets at once; and what the page asks of
    its optimizer.
    """
    pytest.importorskip(language)
    model = {"jax": _with_jax, "casadi": _with_casadi}[language]
    pairs = (("forces", "forces_jacobian"), ("regime_rhs", "regime_jacobian"))
    for name, (function, jacobian) in itertools.product(("two_springs", "hertz_contact"), pairs):
        run(f"spragsym export --language {language} --model {name} --out .", tmp_path)
        exec((tmp_path / f"{name}.py").read_text(encoding="utf-8"), space := {})
        names = list(inspect.signature(space[function]).parameters)
        switches = [name in ("pushing", "side", "near1") for name in names]
        table = np.where(
            switches, 1.0, np.random.default_rng(59).uniform(0.2, 0.9, (1000, len(names)))
        )
        table[:, names.index("y")] *= -1.0  # the contact's side, where a root is real
        ours, theirs = model(space[function], space[jacobian], table)
        np.testing.assert_allclose(ours[..., : theirs.shape[-1]], theirs, rtol=1e-11, atol=1e-11)
        row = dict(zip(names, table[0], strict=True)) | {"y": -0.5, "vx": 0.1}
    sliding = [row[name] for name in inspect.signature(space["rhs"]).parameters]
    kinked, smooth = (
        np.array(it, dtype=float).ravel()
        for it in (space["rhs"](*sliding), space["regime_rhs"](*row.values()))
    )
    np.testing.assert_allclose(kinked, smooth)
    for command, output in commands(DOCS / "howto_languages.md"):
        if f"--language {language} --model" in command:
            assert run(command, tmp_path) == output
    ((program, shown),) = (
        one
        for one in programs(DOCS / "howto_languages.md", "python")
        if f"import {language}" in one[0]
    )
    (tmp_path / "design.py").write_text(program, encoding="utf-8")
    assert run("python design.py", tmp_path) == shown
    sigma, mu0 = map(float, re.findall(r"0\.\d+", shown))
    p = ss.load("kang_nam").Parameters(theta0=np.radians(50.0), sigma=sigma)
    assert ss.jump_value(p) == pytest.approx(mu0, abs=1e-6)


def _with_jax(function: Any, jacobian: Any, table: Any) -> tuple[Any, Any]:
    import jax

    with jax.enable_x64(True):
        whole = jax.vmap(jax.jacfwd(lambda row: jax.numpy.array(function(*row))))(table)
        return whole, np.moveaxis(jax.vmap(lambda row: jacobian(*row))(table), -1, 0)


def _with_casadi(function: Any, jacobian: Any, table: Any) -> tuple[Any, Any]:
    import casadi as ca

    row = ca.SX.sym("row", table.shape[1])
    parts = ca.vertsplit(row)
    derived = (
        ca.jacobian(ca.vertcat(*function(*parts)), row),
        ca.vertcat(*(ca.horzcat(*line) for line in jacobian(*parts))),
    )
    ours, theirs = ca.Function("derived", [row], list(derived)).map(len(table))(table.T)
    return np.array(ours).reshape(2, len(table), -1), np.array(theirs).reshape(2, len(table), -1)


@pytest.mark.thorough
@pytest.mark.parametrize("language", targets.languages())
def test_every_file_says_its_terms(language: str) -> None:
    """Of a page's library and of the article's."""
    files = export.export(ROOT / "derive/models/stick_slip.py", "stick_slip", language)
    if targets.packer(language) is None:
        files |= library.exported(language)
    for name, text in files.items():
        assert "SPDX-License-Identifier: MIT" in " ".join(text.split()), name


# ------------------------------------------------------------------------------------------------
# a new language


def test_the_language_that_contributing_adds_is_printed() -> None:
    """Its one file, as it stands there, gives every function of the library with the statements of
    Python.
    """
    steps = re.sub(r"^   ", "", section("Add a language"), flags=re.MULTILINE)
    ((name, program),) = re.findall(
        r"`derive/emit/targets/(\w+)/__init__\.py`:\n\n```python\n(.*?)\n```", steps, re.DOTALL
    )
    space: dict[str, Any] = {"__package__": f"{targets.__name__}.{name}"}
    exec(program, space)
    ((_, text),) = space["render"](
        library.material(lambda name: (ROOT / "generated" / name).read_text(encoding="utf-8"))
    ).items()
    assert "f_third(cos, sin, a_f, b_f, d_f, m_f) gives f‴\n  w0 = 4*a_f\n" in text


# ------------------------------------------------------------------------------------------------
# what is printed


@pytest.mark.thorough
def test_generated_c_comes_out_formatted() -> None:
    """The printer lays C out by itself, as clang-format would, for any model; of the article's
    another one knows nothing.
    """
    pytest.importorskip("sympy")
    from spragsym.derive import export

    formatter = shutil.which("clang-format", path=Path(sys.executable).parent)
    if formatter is None:
        pytest.skip("clang-format is not installed")
    published = ROOT / "generated" / "c"
    texts = {
        name: (published / name).read_text(encoding="utf-8")
        for name in ("spragsym.h", "spragsym.c", "main.c")
    }
    another = export.export(ROOT / "tests/oracles/pages/pressed.py", "pressed", "c")
    for path in ("pressed.h", "pressed.c"):
        assert not re.search(
            r"spragsym_|theta|@(?!file|param|return)", another[path], re.IGNORECASE
        ), path
    for name, text in {
        **texts,
        **{name: text for name, text in another.items() if name != "Makefile"},
    }.items():
        call = [formatter, f"--style=file:{ROOT / '.clang-format'}", f"--assume-filename={name}"]
        done = subprocess.run(
            call, input=text, capture_output=True, text=True, timeout=60, check=True
        )
        assert done.stdout == text, name
