"""Drafts of files of statements: structure, lines, labels and guesses of sources in each format."""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

pytest.importorskip("pylatexenc")
pytest.importorskip("nbformat")
pytest.importorskip("mdit_py_plugins")

from spragsym.core.errors import MissingExtraError, ParameterError
from spragsym.drafts import draft

TEX = r"""\documentclass{article}
\title{A cart}
\newcommand{\be}{\begin{equation}}
\newcommand{\ee}{\end{equation}}
\newcommand{\pd}[2]{\frac{\partial #1}{\partial #2}}
\begin{document}
The mass $m_p$ of the pendulum; $\theta$ is the angle to the vertical, % $$a = b$$
and $g$ denotes gravity.
\be\label{eq:x}
  x_p = x + l \sin\theta ,
\ee
\[ T = \tfrac12 m \dot x^2 + \tfrac12 m_p (\dot x_p^2 + \dot y_p^2). \]
$$V = -m_p g l\cos\theta$$
\begin{align}
  \pd{L}{x} &= 0 \label{eq:dx}\\
  (m + m_p)\ddot x + m_p l\ddot\theta\cos\theta &- m_p l\dot\theta^2\sin\theta \nonumber\\
  &= 0, \tag{7}\\
  l\ddot\theta + \ddot x\cos\theta &= -g\sin\theta
\end{align}
\begin{equation*}
  \frac{d}{dt}\pd{L}{\dot q_i} - \pd{L}{q_i} = 0
\end{equation*}
\begin{equation} m \int a \end{equation}
\begin{verbatim} $$ c = d $$ \end{verbatim}
\end{document}
"""
#: id, line and about of each displayed equation, counted by hand.
ROWS = [
    ("eq:x", 10, "definition"),
    ("2", 12, "energy T"),
    ("3", 13, "energy V"),
    ("eq:dx", 15, "identity"),
    ("7", 16, "motion x"),
    ("6", 18, "motion theta"),
    ("7-2", 21, "notation"),
    ("8", 23, "other"),
]


def rows_of(source: Path) -> list[tuple[str, int, str]]:
    """id, line and about of every statement of a draft."""
    entries = tomllib.loads(draft(source).text)["statement"]
    return [(it["id"], int(it["where"].split()[-1]), it["about"]) for it in entries]


def test_a_source_in_tex(tmp_path: Path) -> None:
    (source := tmp_path / "a.tex").write_text(TEX, encoding="utf-8")
    assert rows_of(source) == ROWS
    found = draft(source)
    assert (found.equations, found.unread) == (8, 1)
    data = tomllib.loads(found.text)
    assert data["paper"] == "A cart"
    meanings = {name: data["meanings"][name] for name in ("m_p", "theta", "g", "l")}
    assert meanings == {"m_p": "mass", "theta": "angle to the vertical", "g": "gravity", "l": ""}
    assert data["statement"][3]["latex"] == r"\frac{\partial L}{\partial x} &= 0"
    assert "unread: " in data["statement"][-1]["note"]


MARKDOWN = r"""# A pendulum

$$ T = \frac12 m l^2\dot\theta^2 $$ (kinetic)

Text $$V = -m g l \cos\theta$$ goes on, where $l$ is the length.

\begin{align}
\ddot\theta &= -\frac gl\sin\theta \\
p &= m l^2\dot\theta
\end{align}

```math
\omega\_0 = \sqrt{g/l}
```

\[
E = T + V
\]

$$ \frac{d}{dt}\frac{\partial T}{\partial\dot\theta} = m l^2\ddot\theta $$

$$ \dot x_p = l\dot\theta\cos\theta $$

    $$ not = mathematics $$
"""
IN_MARKDOWN = [
    ("kinetic", 3, "energy T"),
    ("2", 5, "energy V"),
    ("3", 8, "acceleration theta"),
    ("4", 9, "definition"),
    ("5", 13, "definition"),
    ("6", 17, "definition"),
    ("7", 20, "identity"),
    ("8", 22, "definition"),
]


def test_a_source_in_markdown_and_the_same_in_a_notebook(tmp_path: Path) -> None:
    (source := tmp_path / "a.md").write_text(MARKDOWN, encoding="utf-8")
    assert rows_of(source) == IN_MARKDOWN
    cells = [
        {"cell_type": "code", "source": "$$a=b$$", "metadata": {}, "outputs": []},
        {"cell_type": "markdown", "source": MARKDOWN.splitlines(keepends=True), "metadata": {}},
    ]
    book = {"nbformat": 4, "nbformat_minor": 4, "metadata": {}, "cells": cells}
    (notebook := tmp_path / "a.ipynb").write_text(json.dumps(book), encoding="utf-8")
    assert rows_of(notebook) == IN_MARKDOWN
    assert 'where = "cell 2, line 3"' in draft(notebook).text


def test_mathematics_inside_of_a_paragraph_is_read_apart(tmp_path: Path) -> None:
    """Environments between dollars without empty lines, energies side by side, and remarks."""
    source = tmp_path / "a.md"
    lines = [
        *("# A box", "The energies are", "$$"),
        r"T = \frac12 m\dot x^2, \quad V = \frac12 k x^2",
        *("$$", "so that with $E$", "$$", r"\begin{align}", r"m\ddot x + k x = 0"),
        *(r"\quad \text{(the motion)}", r"\end{align}", "$$", "We take it.", "```", "$$", "```"),
    ]
    source.write_text("\n".join(lines), encoding="utf-8")
    found = rows_of(source)
    assert [(about, line) for _, line, about in found] == [
        ("energy T", 4),
        ("energy V", 4),
        ("motion x", 9),
    ]
    assert draft(source).unread == 0


def test_a_source_in_doconce(tmp_path: Path) -> None:
    text = (
        "TITLE: A spring\n\n!bt\n\\begin{equation}\nm\\ddot u + k u = 0\n\\end{equation}\n!et\n$$\n"
    )
    (source := tmp_path / "a.do.txt").write_text(text, encoding="utf-8")
    assert rows_of(source) == [("1", 5, "motion u")]
    assert tomllib.loads(draft(source).text)["paper"] == "A spring"


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.pdf", "", "none of .do.txt, .tex, .md, .markdown, .ipynb"),
        ("a.ipynb", '{"cells": 3}', "no notebook"),
        ("a.ipynb", "[" * 200 + "]" * 200, "levels"),
        ("a.tex", "{" * 200, "levels of groups"),
        ("a.md", "$$" + "{" * 200 + "$$", "levels of groups"),
    ],
)
def test_what_is_no_source_is_refused(tmp_path: Path, name: str, text: str, said: str) -> None:
    (source := tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(ParameterError, match=said):
        draft(source)


def test_controls_of_a_terminal_do_not_come_through(tmp_path: Path) -> None:
    (source := tmp_path / "a.tex").write_text("\\[ x = \x1b[31m 1 \u202e\\]", encoding="utf-8")
    text = draft(source).text
    assert "\x1b" not in text
    assert "\u202e" not in text
    assert len(tomllib.loads(text)["statement"]) == 1


def test_a_missing_library_names_its_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (source := tmp_path / "a.tex").write_text(r"\[ x = 1 \]", encoding="utf-8")
    real = __import__("importlib.util").util.find_spec
    monkeypatch.setattr(
        "importlib.util.find_spec", lambda name: None if name == "pylatexenc" else real(name)
    )
    with pytest.raises(MissingExtraError, match=r"pylatexenc.*'\.\[papers\]'"):
        draft(source)


@pytest.mark.thorough
def test_the_command_writes_a_file_that_check_reads(tmp_path: Path) -> None:
    (tmp_path / "a.tex").write_text(TEX, encoding="utf-8")
    command = [sys.executable, "-m", "spragsym", "check", "--draft", "a.tex", "--out", "a.toml"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "8 displayed equations: 1 unread, 6 with a guess" in done.stderr
    from spragsym.derive.statements.papers import read

    assert len(read(tmp_path / "a.toml").statements) == 8
