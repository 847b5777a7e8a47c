"""The check: its rows, and that it goes red for every small change in what is printed or said about
it.
"""

import dataclasses
import importlib
import random
import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from sympy.parsing.latex import parse_latex

from spragsym.derive import pages
from spragsym.derive.kang_nam import article, free_body, ledger
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.derive.kang_nam.ledger import LedgerRow
from spragsym.derive.kang_nam.mechanics import ACCELERATIONS
from spragsym.derive.statements.comparison import Comparison
from spragsym.derive.statements.papers import Paper, Statement
from spragsym.derive.statements.reading import Item, read_paper
from spragsym.derive.statements.tree import Equation, Node, nodes, printed, to_sympy, with_part

EQUATIONS = {f"eq-{number}" for number in range(1, 30)}
APPENDIX = {"A1-c0", "A1-d0", *(f"A{number}" for number in range(2, 14))}
SCALED = ("tau", "prime", "x", "y", "L", "sigma", "alpha", "beta", "kappa", "n")
DEFINITIONS = {f"def-{name}" for name in SCALED}
PRINTED = {entry.id: entry for entry in article.printed().statements}


@pytest.fixture(scope="module")
def rows(
    once: Callable[[str, Callable[[], list[LedgerRow]]], list[LedgerRow]],
) -> dict[str, LedgerRow]:
    return {row.id: row for row in once("check", ledger.run)}


@cache
def items() -> dict[str, Item]:
    """Statements that are compared, as they were read."""
    model = pages.read(pages.SHIPPED / "kang_nam.py")
    _, found = read_paper(article.printed(), model)
    return {item.statement.id: item for item in found if isinstance(item, Item)}


def check_with(id: str, text: str, *others: str) -> LedgerRow:
    """The row for a printed statement whose LaTeX was changed, with others that it needs."""
    kept = [it for it in article.printed().statements if it.id in (id, *others)]
    changed = [dataclasses.replace(it, text=text) if it.id == id else it for it in kept]
    paper: Paper = dataclasses.replace(article.printed(), statements=tuple(changed))
    (row,) = (row for row in ledger.run(paper) if row.id == id)
    return row


# ------------------------------------------------------------------------------------------------
# rows


def test_every_printed_statement_has_a_row(rows: dict[str, LedgerRow]) -> None:
    assert rows.keys() == EQUATIONS | APPENDIX | DEFINITIONS


def test_no_row_failed(rows: dict[str, LedgerRow]) -> None:
    assert not ledger.failures(list(rows.values()))


def test_statuses(rows: dict[str, LedgerRow]) -> None:
    by_status = {
        status: {id for id, row in rows.items() if row.status == status}
        for status in ("misprint", "approximation", "definition")
    }
    assert by_status["misprint"] == {"eq-6", "eq-9", "eq-13", "def-n", "A1-d0"}
    assert by_status["approximation"] == {"eq-12", "eq-27"}
    # What is assumed or named, as opposed to what follows from it.
    assert by_status["definition"] == {"eq-3", "eq-4", "eq-5", "eq-7", "eq-10", "def-prime"}


def test_rows_say_what_their_status_asks_for(rows: dict[str, LedgerRow]) -> None:
    for row in rows.values():
        assert row.printed
        assert row.derived
        is_zero = not re.sub(r"\\left\(|\\right\)|\\;|[ ,0]", "", row.difference)
        assert is_zero == (row.status in ("confirmed", "definition")), row.id
        told = (row.cause, row.evidence, row.consequence)
        assert all(told) if row.status == "misprint" else not any(told), row.id
        assert bool(row.limit) == (row.status == "approximation"), row.id
        assert row.note or row.status != "definition", row.id
    assert "κ" in rows["eq-9"].cause
    assert re.search(r"x = 1\.217\d+", rows["eq-9"].consequence), "a number at the base values"


# ------------------------------------------------------------------------------------------------
# typesetting against transcription

_SYMBOLS = (
    *(nm.mu0, nm.mu, nm.sigma, nm.alpha, nm.beta, nm.kappa),
    *(nm.F_L, nm.L_0, nm.k_c, nm.k_x, nm.k_y, nm.b1, nm.b2, nm.b3, nm.b4),
    *(nm.x, nm.y, nm.L, nm.n, nm.N, nm.k, nm.m_mass),
)
_ATOMS: dict[str, sp.Symbol] = {
    "x''": ACCELERATIONS[0],
    "y''": ACCELERATIONS[1],
    r"\ddot{x}": ACCELERATIONS[0],
    r"\ddot{y}": ACCELERATIONS[1],
    r"\Delta": sp.Symbol("Delta", real=True),
    r"\overline{n}": nm.nbar,
    r"\cos\theta_0": nm.c0,
    r"\sin\theta_0": nm.s0,
    r"\cos\theta": nm.c,
    r"\sin\theta": nm.s,
    **{re.sub(r"_\{(\w)\}", r"_\1", sp.latex(symbol)): symbol for symbol in _SYMBOLS},
}
#: One letter for each: the parser knows neither σ nor all products without a sign; e, i, d, S mean
#: something.
_LETTERS = dict(zip(_ATOMS, "ABCDFGHJKMOPQRTUVWXYZabcfghjkmpqrlvwz", strict=False))


def parse(latex: str) -> sp.Expr:
    """A piece of the article's typesetting as an expression in the nomenclature's symbols."""
    text = re.sub(r"\\left|\\right|\s|_\{eq\}", "", latex)
    text = re.sub(r"\\(cos|sin)\^2\\theta", r"\\\1\\theta^2", text)
    text = re.sub(r"([_^])\{(\w)\}", r"\1\2", text).replace("_o", "_0")
    atom = "|".join(map(re.escape, sorted(_ATOMS, key=len, reverse=True)))
    source, previous = "", ""
    for token in re.findall(rf"{atom}|\\[a-z]+|\S", text):
        ends = previous in _ATOMS or previous.isdigit() or previous in (")", "}")
        starts = token in _ATOMS or token.isdigit() or token in ("(", r"\sqrt", r"\frac")
        source += (r" \cdot " if ends and starts else " ") + _LETTERS.get(token, token)
        previous = token
    names = {sp.Symbol(letter): _ATOMS[atom] for atom, letter in _LETTERS.items()}
    return parse_latex(source, backend="lark").subs(names, simultaneous=True)


def typeset(entry: Statement) -> tuple[sp.Expr, ...]:
    """The components of a printed statement, read from its LaTeX."""
    last = entry.text[
        entry.text.rfind(r"\begin{") :
    ]  # (28) also names the derivatives that it evaluates
    matrix = re.search(
        r"\\begin\{(?:bmatrix|array)\}(?:\{c\})?(.*)\\end\{(?:bmatrix|array)\}", last
    )
    if matrix:
        return tuple(parse(part) for part in re.split(r"\\\\|&", matrix[1]))
    sides = entry.text.split("=")
    if re.fullmatch(r"F_[xy] ", sides[0]):  # (12) and (13) name their left side
        sides = sides[1:]
    is_definition = entry.id in ("eq-3", "eq-6", "eq-11") or not entry.id.startswith("eq-")
    return (parse(sides[1]),) if is_definition else (parse(sides[0]) - parse(sides[1]),)


def read(id: str) -> tuple[sp.Expr, ...]:
    """The components of a printed statement, as the check read it."""
    item = items()[id]
    names = {name: sp.Symbol(name) for name in ("theta", "theta0")}
    own = {"mu0": nm.mu0, "ax": ACCELERATIONS[0], "ay": ACCELERATIONS[1], "pushing": nm.nbar}
    known = {
        it.value for one in item.equations for side in (one.left, one.right) for it in nodes(side)
    }
    for name in known - names.keys() - own.keys():
        own[name] = nm.SYMBOLS.get(name, sp.Symbol(name))
    own |= {f"b_{place}": symbol for place, symbol in enumerate((nm.b1, nm.b2, nm.b3, nm.b4), 1)}
    own |= {"N": nm.n if item.derivation.scaled else nm.N, "Delta": _ATOMS[r"\Delta"]}
    circles = {sp.cos(names["theta"]): nm.c, sp.sin(names["theta"]): nm.s}
    circles |= {sp.cos(names["theta0"]): nm.c0, sp.sin(names["theta0"]): nm.s0}
    found = []
    for equation in item.equations:
        left, right = (
            to_sympy(side, own | names).xreplace(circles)
            for side in (equation.left, equation.right)
        )
        is_value = equation.left.kind == "symbol"
        found.append(right if is_value else left - right)
    return tuple(found)


# Cases, exp and sgn, the arrows of the scaling, names alone; relations between whole matrices.
NOT_ALGEBRA = {"eq-7", "eq-10", "eq-29", "def-tau", "def-prime", "def-x", "def-y", "def-L", "eq-3"}
NOT_ALGEBRA |= {f"eq-{number}" for number in (16, 17, 20, 21, 22, 23, 26, 27)}


ALGEBRA = [id for id in PRINTED if id not in NOT_ALGEBRA]


@pytest.mark.thorough
@pytest.mark.parametrize("id", ALGEBRA)
def test_the_print_is_read_as_another_reader_reads_it(id: str) -> None:
    for own, other in zip(read(id), typeset(PRINTED[id]), strict=True):
        assert sp.expand(own - other) == 0


# ------------------------------------------------------------------------------------------------
# mutations


def mutations(tree: Node, item: Item) -> Iterator[tuple[str, Node]]:
    """Each way to change one sign, one name, one exponent, one number or one function."""
    for path, part, above in _parts(tree):
        if part.kind == "symbol":
            alike = sorted(name for name in item.values if name[:1] == part.value[:1])
            others = [name for name in (*alike, "alpha", "beta", "L", "x") if name in item.values]
            for other in dict.fromkeys(others):
                if other != part.value:
                    yield f"{part.value} → {other}", with_part(tree, path, _symbol(other))
            yield f"{part.value} squared", with_part(tree, path, Node("pow", (part, _number("2"))))
        if part.kind == "number" and part.value not in ("0", "pi"):
            value = str(int(part.value) + 1)
            yield f"{part.value} → {value}", with_part(tree, path, _number(value))
        if part.kind == "call" and part.value in ("cos", "sin"):
            other = "sin" if part.value == "cos" else "cos"
            yield f"{part.value} → {other}", with_part(tree, path, Node("call", part.args, other))
        if above is not None and above.kind == "add":
            turned = part.args[0] if part.kind == "neg" else Node("neg", (part,))
            yield f"sign of {printed(part)}", with_part(tree, path, turned)


def _parts(
    tree: Node, path: tuple[int, ...] = (), above: Node | None = None
) -> Iterator[tuple[tuple[int, ...], Node, Node | None]]:
    yield path, tree, above
    for place, part in enumerate(tree.args):
        yield from _parts(part, (*path, place), tree)


def _symbol(name: str) -> Node:
    return Node("symbol", value=name)


def _number(value: str) -> Node:
    return Node("number", value=value)


def points(item: Item) -> Iterator[dict[str, sp.Expr]]:
    """Exact values of every name at random states, by the geometry, the laws, and what b and D are.

    Two and two have the same parameters.
    """
    generator = random.Random(20200416)

    def rational(low: int = 1) -> sp.Rational:
        return sp.Rational(generator.randint(low, 60), generator.randint(20, 60))

    for number in range(40):
        if number % 2 == 0:
            given = {str(it): rational() for it in item.derivation.parameters.values()}
            angle = sp.atan(rational())
        value: dict[str, sp.Expr] = given | {"theta0": angle}
        value |= {"x": rational(-60), "y": -rational(), "ax": rational(), "ay": rational()}
        value |= {"vx": rational(-60), "vy": rational(), "lam": rational(), "t": rational()}
        is_open = item.subject.side == "lift-off" or (
            item.subject.side == "both" and number % 4 > 1
        )
        if is_open:
            value["y"] = -value["y"]
        length = value.get("L_0", sp.S.One)
        across = length * sp.sin(angle) - value["y"]
        along = length * sp.cos(angle) - value["x"]
        value |= {"L": sp.sqrt(along**2 + across**2), "theta": sp.atan2(across, along)}
        value |= {"pushing": sp.Integer(not is_open), "Delta": length - value["L"]}
        value["N"] = -value["y"] * value.get("k_c", 1) * value["pushing"]
        slip = value["V"] - value["vx"]
        law = value["mu0"] * (1 - sp.exp(-value["d"] * abs(slip))) * sp.sign(slip)
        value["mu"] = value["mu0"] if item.subject.steady else law
        own = {name: _at(it, value) for name, it in item.bound.items()}
        yield value | own


def _at(expression: sp.Expr, value: dict[str, sp.Expr]) -> sp.Expr:
    return expression.xreplace({it: value[it.name] for it in expression.free_symbols})


def is_neutral(item: Item, tree: Node, changed: Node) -> bool:
    """Whether a change keeps the value, or of a residual times a factor of parameters, to 40 digits."""
    before, is_same = None, True
    for number, value in enumerate(points(item)):
        own = {name: it for name, it in item.defined.items() if name not in value}
        units = {
            name: to_sympy(it, value) for name, it in own.items() if not item.derivation.scaled
        }
        old, new = (sp.N(to_sympy(it, value | units), 50) for it in (tree, changed))
        if new is sp.nan or not new.is_finite:
            return False
        is_same = is_same and bool(abs(old - new) < 1e-40)
        if is_same:
            before = sp.S.One
            continue
        if item.subject.is_value or 0 in (old, new):
            return False
        ratio = new / old
        if item.subject.factor != "parameters" and abs(abs(ratio) - 1) > 1e-40:
            return False
        if number % 2 and abs(ratio - before) > 1e-40:
            return False
        before = ratio
    return True


#: Those that CI runs, one of each kind; the others take long, by the same code.
OF_EACH_KIND = ("A5", "A12", "A13", "def-sigma", "def-kappa", "def-n", "def-tau", "eq-25", "eq-4")
COMPARED = [id for id in PRINTED if id not in ("eq-3", "def-prime")]


@pytest.mark.parametrize(
    "id",
    [
        pytest.param(id, marks=pytest.mark.thorough if id in OF_EACH_KIND else pytest.mark.validate)
        for id in COMPARED
    ],
)
def test_every_mutation_is_caught_and_located(id: str) -> None:
    """A statement with any small change holds where the change is neutral, and nowhere else."""
    item, count = items()[id], 0
    for place, equation in enumerate(item.equations):
        side = equation.right if item.subject.is_value else equation.left
        for name, changed in mutations(side, item):
            left, right = equation.left, equation.right
            other = Equation(left, changed) if item.subject.is_value else Equation(changed, right)
            others = (*item.equations[:place], other, *item.equations[place + 1 :])
            whole = side if item.subject.is_value else Node("add", (side, Node("neg", (right,))))
            after = (
                changed if item.subject.is_value else Node("add", (changed, Node("neg", (right,))))
            )
            holds = Comparison(dataclasses.replace(item, equations=others)).agrees
            neutral = PRINTED[id].expect in ("confirmed", "definition") and is_neutral(
                item, whole, after
            )
            assert holds == neutral, f"{id}: {name}, neutral: {neutral}"
            count += 1
    assert count >= 2, f"{id}: hardly anything was changed"


# -----------------------------------------------------------------------------------------------
# explanations


@pytest.mark.thorough
def test_an_approximation_that_does_not_vanish_fails() -> None:
    row = check_with("eq-12", PRINTED["eq-12"].text.replace(r"\alpha x", r"2 \alpha x"))
    assert row.status == "failed"


@pytest.mark.thorough
def test_another_misprint_in_an_explained_row_fails() -> None:
    """Only the edits that are explained are."""
    row = check_with("eq-9", PRINTED["eq-9"].text.replace(r"+ \beta y", r"- \beta y"))
    assert row.status == "failed"
    assert "nothing explains" in row.note


@pytest.mark.thorough
def test_what_is_explained_and_right_fails() -> None:
    row = check_with("eq-9", PRINTED["eq-9"].text.replace("- n", r"- n + \kappa"))
    assert row.status == "failed"
    assert "the difference is zero" in row.note


def test_evidence_feels_the_physics(monkeypatch: pytest.MonkeyPatch) -> None:
    """The second route feels a change of physics: without the preload its forces do not fit its
    energy.
    """
    original = free_body.forces

    def without_preload(point: Any, *at: Any) -> Any:
        return original(dataclasses.replace(point, kappa=Fraction(0)), *at)

    monkeypatch.setattr(free_body, "forces", without_preload)
    row = check_with("eq-9", PRINTED["eq-9"].text)
    assert row.status == "failed"
    assert "virtual work" in row.note


def test_a_row_names_the_function_that_derives_it(rows: dict[str, LedgerRow]) -> None:
    """What stands under "derived by" is there, below ``derive`` or its ``statements``."""
    for row in rows.values():
        if row.id in ("eq-3", "def-prime"):  # names that are new to the page
            assert not row.derived_by
            continue
        for place in row.derived_by.split(", "):
            module, *names = place.split(".")
            below = "statements." if module == "objects" else ""
            found: Any = importlib.import_module(f"spragsym.derive.{below}{module}")
            for name in names:
                found = getattr(found, name)
            assert found.__doc__, row.derived_by


@pytest.mark.validate
@pytest.mark.parametrize("page", pages.shipped(), ids=lambda page: page.stem)
def test_every_page_is_judged(page: Path) -> None:
    """What holds of the article for each page that ships; of its own page all of it."""
    found = ledger.judge(pages.read(page))
    assert [it.id for it in found] == [*PRINTED]
    if page.stem == "kang_nam":
        assert {it.status for it in found} == {ledger.Transfer.HOLDS}
