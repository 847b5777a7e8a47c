"""What ``spragsym check FILE --json`` prints: keys and types of each kind of row, read back."""

from __future__ import annotations

import io
import json
import math
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

pytest.importorskip("sympy")

PAPER = """
paper = "Contract"
[[statement]]
id = "right"
about = "motion y"
form = "scaled"
sympy = "ay + sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N + kappa = 0"
[[statement]]
id = "lost"
about = "motion y"
form = "scaled"
sympy = "ay + sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N = 0"
expect = "misprint"
[[statement]]
id = "lost too"
about = "equilibrium y"
form = "scaled"
latex = '''\\frac{\\sigma}{L}(1 - L)(\\sin\\theta_0 - y) + \\beta y - N = 0'''
expect = "misprint"
[[statement]]
id = "half"
about = "energy T"
form = "units"
latex = '''T = m (\\dot x^2 + \\dot y^2)'''
expect = "misprint"
[[statement]]
id = "two"
about = "energy T"
form = "units"
latex = '''T = \\frac13 m \\dot x^2 - \\frac12 m \\dot y^2'''
expect = "misprint"
[[statement]]
id = "limit"
about = "balance x"
form = "scaled"
limit = "d*V -> oo"
sympy = "sigma/L*(1 - L)*(cos(theta0) - x) + alpha*x - mu0*N = 0"
expect = "approximation"
[[statement]]
id = "new"
about = "definition"
sympy = "w = sqrt(k_c/m)"
[[statement]]
id = "unlike"
about = "motion x"
form = "scaled"
sympy = "ax**3 + exp(x*y) = 7*vy"
expect = "failed"
[[statement]]
id = "two ways"
about = "motion x"
latex = '''\\sin x y = 0'''
expect = "unread"
[[statement]]
id = "elsewhere"
about = "other"
sympy = "x"
"""
STATUS = {
    "right": "confirmed",
    "lost": "misprint",
    "lost too": "misprint",
    "half": "misprint",
    "two": "misprint",
    "limit": "approximation",
    "new": "definition",
    "unlike": "failed",
    "two ways": "unread",
    "elsewhere": "other",
}
#: Keys of every row, and their types.
KEYS: dict[str, type] = {
    **dict.fromkeys(
        ("id", "about", "status", "read", "derived", "repaired", "repaired_latex"), str
    ),
    **{"edits": list, "alternatives": int, "said_once_with": list, "evidence": str, "cost": str},
}


@pytest.fixture(scope="module")
def printing(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What the command prints, once for all tests."""
    from spragsym.cli import main

    path: Path = tmp_path_factory.mktemp("papers") / "paper.toml"
    path.write_text(PAPER, encoding="utf-8")
    told = io.StringIO()
    with redirect_stdout(told), pytest.raises(SystemExit) as stop:
        main(["check", str(path), "--model", "kang_nam", "--json"])
    assert stop.value.code == 0
    whole: dict[str, Any] = json.loads(told.getvalue())
    return whole


def _read(text: str) -> list[sp.Expr]:
    """Left less right of equations in SymPy's syntax, by SymPy's own parser."""
    names = {name: sp.Symbol(name) for name in ("N", "beta")}
    sides = [part.split("=") for part in text.split(";")]
    return [sp.Add(sp.sympify(left, names), -sp.sympify(right, names)) for left, right in sides]


@pytest.mark.thorough
def test_rows_have_the_keys_and_types_of_the_contract(printing: dict[str, Any]) -> None:
    """Each verdict, what a program reads of it, and that it is true."""
    head = {key: it for key, it in printing.items() if key != "rows"}
    assert head == {"paper": "Contract", "model": "kang_nam", "conventions": []}
    rows: dict[str, dict[str, Any]] = {row["id"]: row for row in printing["rows"]}
    assert {id: row["status"] for id, row in rows.items()} == STATUS
    for row in rows.values():
        assert {key: type(row[key]) for key in KEYS} == KEYS, row["id"]
        is_misprint = row["status"] == "misprint"
        assert is_misprint == bool(row["edits"]) == bool(row["repaired"]) == bool(row["cost"])
        assert bool(row["alternatives"]) == bool(row["repaired_latex"]) == is_misprint
    assert rows["lost"]["said_once_with"] == ["lost too"]
    assert rows["lost too"]["said_once_with"] == ["lost"]
    assert rows["half"]["said_once_with"] == rows["right"]["said_once_with"] == []
    assert "either" in rows["two ways"]["evidence"]
    assert rows["unlike"]["derived"]


@pytest.mark.thorough
def test_what_is_repaired_reads_back_as_what_is_derived(printing: dict[str, Any]) -> None:
    """By SymPy's parser, and the LaTeX by our reader; edits stand where they say."""
    from spragsym.derive.statements.latex import read_latex
    from spragsym.derive.statements.tree import Vocabulary, printed

    point = {"x": 0.2, "y": -0.4, "theta0": 0.9, "L_0": 1.0, "N": 0.4, "vx": 0.3, "vy": -0.7}
    point |= {"sigma": 1.3, "beta": 0.6, "kappa": 0.7, "m": 1.7, "ay": 0.1}
    dx, dy = math.cos(0.9) - point["x"], math.sin(0.9) - point["y"]
    at = {sp.Symbol(name): value for name, value in point.items()}
    at |= {sp.Symbol("L"): math.hypot(dx, dy), sp.Symbol("theta"): math.atan2(dy, dx)}
    vocabulary = Vocabulary(frozenset({*map(str, at), "T"}), ("x", "y"), {})
    counted = 0
    for row in (row for row in printing["rows"] if row["status"] == "misprint"):
        (right,), (derived,) = _read(row["repaired"]), _read(f"{row['derived']} = 0")
        left, _, value = row["repaired"].partition(" = ")
        tried = _read(f"{value} = 0")[0] if left == "T" else right
        assert float(tried.subs(at)) == pytest.approx(float(derived.subs(at))), row["id"]
        (equation,) = read_latex(row["repaired_latex"], vocabulary)
        (again,) = _read(f"{printed(equation.left)} = {printed(equation.right)}")
        assert sp.expand(again - right) == 0, row["repaired_latex"]
        for edit in row["edits"]:
            start, stop = edit["at"]
            assert {*edit} == {"kind", "at", "old", "new"}
            assert 0 <= start < stop <= len(row["print"])
            assert f"«{row['print'][start:stop]}»" in row["marked"]
            _ = _read(f"{edit['new']} = 0")
            counted += 1
    assert counted == 5
