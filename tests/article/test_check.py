"""The check: its rows, and that it goes red for every small change in what is printed or said about
it.
"""

import dataclasses
import importlib
import random
import re
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
import sympy as sp
from sympy.parsing.latex import parse_latex

from spragsym.derive.kang_nam import article, check, explanations, free_body
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.derive.kang_nam.article import Printed
from spragsym.derive.kang_nam.check import Derived, Row
from spragsym.derive.kang_nam.mechanics import AX, AY

EQUATIONS = {f"eq-{number}" for number in range(1, 30)}
APPENDIX = {"A1-c0", "A1-d0", *(f"A{number}" for number in range(2, 14))}
SCALED = ("tau", "prime", "x", "y", "L", "sigma", "alpha", "beta", "kappa", "n")
DEFINITIONS = {f"def-{name}" for name in SCALED}
PRINTED = {entry.id: entry for entry in article.PRINTED}


@pytest.fixture(scope="module")
def rows(once: Callable[[str, Callable[[], list[Row]]], list[Row]]) -> dict[str, Row]:
    return {row.id: row for row in once("check", check.run)}


@cache
def derived_forms() -> dict[str, Derived]:
    return check.derived_forms()


def check_with(id: str, expression: article.Expression) -> Row:
    """The row for a printed statement whose expression was changed."""
    return check.check(dataclasses.replace(PRINTED[id], expression=expression), derived_forms()[id])


# ------------------------------------------------------------------------------------------------
# rows


def test_every_printed_statement_has_a_row(rows: dict[str, Row]) -> None:
    assert len(article.PRINTED) == len(PRINTED), "two statements share an id"
    assert rows.keys() == EQUATIONS | APPENDIX | DEFINITIONS


def test_no_row_failed(rows: dict[str, Row]) -> None:
    assert not check.failures(list(rows.values()))


def test_statuses(rows: dict[str, Row]) -> None:
    by_status = {
        status: {id for id, row in rows.items() if row.status == status} for status in check.SOUND
    }
    assert by_status["misprint"] == {"eq-6", "eq-9", "eq-13", "def-n", "A1-d0"}
    assert by_status["approximation"] == {"eq-12", "eq-27"}
    # What is assumed or named, as opposed to what follows from it.
    assert by_status["definition"] == {"eq-3", "eq-4", "eq-5", "eq-7", "eq-10", "def-prime"}


def test_rows_say_what_their_status_asks_for(rows: dict[str, Row]) -> None:
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


# -------------------------------------------------------------------------- typesetting against
# transcription

_ATOMS: dict[str, sp.Symbol] = {
    "x''": AX,
    "y''": AY,
    r"\ddot{x}": AX,
    r"\ddot{y}": AY,
    r"\Delta": article.Delta,
    r"\overline{n}": nm.nbar,
    r"\cos\theta_0": nm.c0,
    r"\sin\theta_0": nm.s0,
    r"\cos\theta": nm.c,
    r"\sin\theta": nm.s,
    r"\mu_0": nm.mu0,
    r"\mu": nm.mu,
    r"\sigma": nm.sigma,
    r"\alpha": nm.alpha,
    r"\beta": nm.beta,
    r"\kappa": nm.kappa,
    "F_L": nm.F_L,
    "L_0": nm.L_0,
    "k_c": nm.k_c,
    "k_x": nm.k_x,
    "k_y": nm.k_y,
    "b_1": nm.b1,
    "b_2": nm.b2,
    "b_3": nm.b3,
    "b_4": nm.b4,
    "x": nm.x,
    "y": nm.y,
    "L": nm.L,
    "n": nm.n,
    "N": nm.N,
    "k": nm.k,
    "m": nm.m_mass,
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


def typeset(entry: Printed) -> tuple[sp.Expr, ...]:
    """The components of a printed statement, read from its LaTeX."""
    last = entry.latex[
        entry.latex.rfind(r"\begin{") :
    ]  # (28) also names the derivatives that it evaluates
    matrix = re.search(
        r"\\begin\{(?:bmatrix|array)\}(?:\{c\})?(.*)\\end\{(?:bmatrix|array)\}", last
    )
    if matrix:
        return tuple(parse(part) for part in re.split(r"\\\\|&", matrix[1]))
    sides = entry.latex.split("=")
    if re.fullmatch(r"F_[xy] ", sides[0]):  # (12) and (13) name their left side
        sides = sides[1:]
    is_definition = entry.id in ("eq-3", "eq-6", "eq-11") or not entry.id.startswith("eq-")
    return (parse(sides[1]),) if is_definition else (parse(sides[0]) - parse(sides[1]),)


# Cases, exp and sgn, the arrows of the scaling. Relations between whole matrices are printed as
# functions.
NOT_ALGEBRA = {"eq-7", "eq-10", "eq-29", "def-tau", "def-prime", "def-x", "def-y", "def-L"}


ALGEBRA = [
    id for id, entry in PRINTED.items() if not callable(entry.expression) and id not in NOT_ALGEBRA
]


#: Those whose LaTeX takes longest to be parsed.
LONG = (
    "A2",
    "A3",
    "A4",
    "A6",
    "A7",
    "A8",
    "A9",
    "def-n",
    "eq-6",
    "eq-8",
    "eq-9",
    "eq-12",
    "eq-13",
    "eq-14",
    "eq-15",
    "eq-18",
    "eq-19",
    "eq-24",
    "eq-28",
)


@pytest.mark.parametrize(
    "id", [pytest.param(id, marks=pytest.mark.thorough) if id in LONG else id for id in ALGEBRA]
)
def test_typesetting_agrees_with_transcription(id: str) -> None:
    entry = PRINTED[id]
    expected = entry.expression if isinstance(entry.expression, tuple) else (entry.expression,)
    for read, transcribed in zip(typeset(entry), expected, strict=True):
        assert sp.expand(read - transcribed) == 0


@pytest.mark.thorough
@pytest.mark.parametrize("id", sorted(explanations.CORRECTIONS))
def test_the_right_form_is_typeset_as_it_is_transcribed(id: str) -> None:
    correction = explanations.CORRECTIONS[id]
    assert isinstance(correction.expression, sp.Expr)
    (read,) = typeset(dataclasses.replace(PRINTED[id], latex=correction.latex))
    assert sp.expand(read - correction.expression) == 0


# ------------------------------------------------------------------------------------------------
# mutations

#: What a compositor might set instead of each symbol.
_SWAPS: dict[sp.Symbol, tuple[sp.Symbol, ...]] = {
    nm.b1: (nm.b2, nm.b3),
    nm.b2: (nm.b1, nm.b4),
    nm.b3: (nm.b4, nm.b1),
    nm.b4: (nm.b3, nm.b2),
    nm.alpha: (nm.beta,),
    nm.beta: (nm.alpha,),
    nm.sigma: (nm.alpha,),
    nm.kappa: (nm.sigma,),
    nm.mu0: (nm.kappa,),
    nm.mu: (nm.kappa,),
    nm.c0: (nm.c, nm.s0),
    nm.s0: (nm.s, nm.c0),
    nm.c: (nm.c0, nm.s),
    nm.s: (nm.s0, nm.c),
    nm.x: (nm.y,),
    nm.y: (nm.x,),
    nm.k_x: (nm.k_y,),
    nm.k_y: (nm.k_x,),
    nm.k: (nm.k_c,),
    nm.n: (nm.y,),
    nm.N: (nm.F_L,),
    nm.F_L: (nm.N,),
    nm.L: (nm.L_0,),
    nm.nbar: (nm.n,),
    nm.k_c: (nm.k,),
    nm.m_mass: (nm.k,),
    nm.L_0: (nm.L,),
    nm.creep: (nm.V,),
    nm.V: (nm.vx,),
    nm.vx: (nm.vy,),
    AX: (AY,),
    AY: (AX,),
    article.Delta: (nm.L,),
}


def mutations(node: sp.Expr, in_exponent: bool = False) -> Iterator[tuple[str, sp.Expr]]:
    """Each way to change one sign, one index, one exponent or one number of an expression, with a
    name.
    """
    if node.is_Symbol:
        for other in _SWAPS[node]:
            yield f"{node} → {other}", other
        yield f"{node} squared", node**2
    elif node.is_Integer:
        if node not in (0, -1):  # −1 is a sign, and turned where the product stands
            yield f"{node} → {node + 1}", node + 1
        if abs(node) > 1:
            yield f"{node} → {node - 1}", node - 1
    if not in_exponent and node != 0:
        yield f"sign of {node}", -node
    for place, argument in enumerate(node.args):
        before, after = node.args[:place], node.args[place + 1 :]
        exponent = isinstance(node, sp.Pow) and place == 1
        # A sign turned in a factor is the sign of the product; in a square it changes nothing.
        for name, changed in mutations(argument, in_exponent=exponent):
            if isinstance(node, sp.Mul | sp.Pow) and name == f"sign of {argument}":
                continue
            yield name, node.func(*before, changed, *after)


def rational_points(count: int = 4) -> Iterator[dict[sp.Symbol, sp.Rational]]:
    """Random rationals for every symbol, on the unit circles, with b₁ … b₄ and Δ as they are
    defined.
    """
    generator = random.Random(20200416)

    def rational() -> sp.Rational:
        return sp.Rational(generator.randint(1, 60), generator.randint(1, 60))

    symbols = sorted(_SWAPS.keys() | {nm.vy}, key=str)
    for _ in range(count):
        point = {symbol: rational() for symbol in symbols}
        for cosine, sine in ((nm.c, nm.s), (nm.c0, nm.s0)):
            half = rational()
            point[cosine], point[sine] = (1 - half**2) / (1 + half**2), 2 * half / (1 + half**2)
        names = (nm.c0, nm.s0, nm.mu0, nm.kappa, nm.alpha, nm.beta)
        cos0, sin0, mu, kappa, alpha, beta = (point[name] for name in names)
        point |= {nm.b1: -alpha * cos0 - mu * sin0, nm.b2: -(beta + 1) * sin0 - kappa}
        point |= {nm.b3: -alpha * cos0, nm.b4: -beta * sin0 - kappa, nm.mu: mu}
        point[article.Delta] = point[nm.L_0] - point[nm.L]
        yield point


POINTS = tuple(rational_points())


def same_numbers(left: sp.Expr, right: sp.Expr) -> bool:
    """Whether two expressions agree at all random points, exactly or, with an exponential, to 40
    digits.
    """
    for point in POINTS:
        gap = (left - right).xreplace(point)
        if gap != 0 if gap.is_Rational else abs(sp.N(gap, 50)) > sp.Float("1e-40"):
            return False
    return True


EQUATIONS_MUTATED = (f"eq-{number}" for number in (1, 2, 8, 10, 12, 14, 15, 18, 19, 24, 25, 28))
MUTATED = sorted(
    {*APPENDIX, *explanations.CORRECTIONS, *EQUATIONS_MUTATED, "def-sigma", "def-kappa"}
)


def mutated(
    id: str, components: tuple[sp.Expr, ...]
) -> Iterator[tuple[str, tuple[sp.Expr, ...], bool]]:
    """Every mutation of a statement: name, changed components, and whether numbers say that it is
    neutral.
    """
    for place, component in enumerate(components):
        for name, changed in mutations(component):
            neutral = same_numbers(component, changed)
            yield name, (*components[:place], changed, *components[place + 1 :]), neutral


def components_of(id: str) -> tuple[sp.Expr, ...]:
    expression = PRINTED[id].expression
    return expression if isinstance(expression, tuple) else (expression,)


@pytest.fixture
def plain_differences(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave a difference that is not zero as it is: arranging it for the ledger takes most of the
    time.
    """
    derived_forms()
    monkeypatch.setattr(sp, "simplify", lambda expression: expression)


#: Those that take long, by the same code as one of each kind, which CI runs: scalar, matrix,
#: approximation, law, misprint.
LONG_ONES = (
    "def-n",
    "A11",
    "A1-c0",
    "A1-d0",
    "A2",
    "A3",
    "A4",
    "A6",
    "A7",
    "A8",
    "A9",
    "A10",
    "eq-1",
    "eq-2",
    "eq-6",
    "eq-8",
    "eq-13",
    "eq-14",
    "eq-15",
    "eq-18",
    "eq-19",
    "eq-28",
    "A12",
)
OF_EACH_KIND = ("A5", "eq-24", "eq-12", "eq-10", "eq-9")


def by_length(ids: Iterable[str]) -> list[Any]:
    """Parameters of a test."""
    marks = dict.fromkeys(LONG_ONES, pytest.mark.validate) | dict.fromkeys(
        OF_EACH_KIND, pytest.mark.thorough
    )
    return [pytest.param(id, marks=marks.get(id, ())) for id in ids]


@pytest.mark.parametrize("id", by_length(MUTATED))
@pytest.mark.usefixtures("plain_differences")
def test_every_mutation_is_caught_and_located(id: str) -> None:
    sound = check_with(id, PRINTED[id].expression).status
    count = 0
    for name, changed, neutral in mutated(id, components_of(id)):
        row = check_with(id, changed)
        assert row.id == id
        assert row.status == (sound if neutral else check.FAILED), (
            f"{id}: {name}, neutral: {neutral}"
        )
        count += 1
    assert count >= 4, f"{id}: hardly anything was changed"


@pytest.mark.parametrize("id", by_length(sorted(explanations.CORRECTIONS)))
@pytest.mark.usefixtures("plain_differences")
def test_every_mutation_of_a_right_form_is_caught(id: str, monkeypatch: pytest.MonkeyPatch) -> None:
    correction = explanations.CORRECTIONS[id]
    right = correction.expression
    assert isinstance(right, sp.Expr)
    for name, changed in mutations(right):
        monkeypatch.setitem(
            explanations.CORRECTIONS, id, dataclasses.replace(correction, expression=changed)
        )
        row = check_with(id, PRINTED[id].expression)
        assert (row.status == check.FAILED) != same_numbers(right, changed), f"{id}: {name}"


# -----------------------------------------------------------------------------------------------
# explanations


def test_an_approximation_that_does_not_vanish_fails() -> None:
    printed = PRINTED["eq-12"].expression
    assert isinstance(printed, sp.Expr)
    row = check_with("eq-12", printed + nm.alpha * nm.x)
    assert row.status == check.FAILED
    assert "does not vanish" in row.note


C, A = explanations.CORRECTIONS, explanations.APPROXIMATIONS


def test_evidence_feels_the_physics(monkeypatch: pytest.MonkeyPatch) -> None:
    """The second route feels a change of physics: without the preload its forces do not fit its
    energy.
    """
    original = free_body.forces

    def without_preload(point: Any, *at: Any) -> Any:
        return original(dataclasses.replace(point, kappa=Fraction(0)), *at)

    monkeypatch.setattr(free_body, "forces", without_preload)
    row = check_with("eq-9", PRINTED["eq-9"].expression)
    assert row.status == check.FAILED
    assert "virtual work" in row.note


def test_a_row_names_the_function_that_derives_it_and_that_function_names_the_row(
    rows: dict[str, Row],
) -> None:
    """Equation (26), say, is found by its number from either side."""
    for row in rows.values():
        module, _, name = row.derived_by.partition(".")
        function = getattr(importlib.import_module(f"spragsym.derive.kang_nam.{module}"), name)
        number = {"eq": "({})", "def": "after (9)"}.get(row.id.partition("-")[0], "(A{})")
        asked = number.format(
            row.id.partition("-")[2]
            if row.id.startswith("eq")
            else row.id.removeprefix("A").partition("-")[0]
        )
        assert _names(function.__doc__, asked), (row.id, row.derived_by, function.__doc__)


def _names(text: str, asked: str) -> bool:
    """Whether a number, ``(26)`` or ``(A3)`` or ``after (9)``, stands in a text, by itself or
    inside a range such as (1)–(11).
    """
    if asked in text:
        return True
    letter, number = re.fullmatch(r"(?:after )?\((A?)(\d+)\)", asked).groups()  # type: ignore[union-attr]
    ranges = re.findall(rf"\({letter}(\d+)\)–\({letter}(\d+)\)", text)
    return not asked.startswith("after") and any(
        int(low) <= int(number) <= int(high) for low, high in ranges
    )
