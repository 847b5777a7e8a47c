"""Printed equations held against a page: what is right is confirmed, what is wrong is repaired."""

from __future__ import annotations

import itertools
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

pytest.importorskip("sympy")

from spragsym.derive import pages, units
from spragsym.derive.statements import book, objects, papers, reading, samples, verdicts
from spragsym.derive.statements.tree import (
    FUNCTIONS,
    OF_SEVERAL,
    Unread,
    Vocabulary,
    printed,
    read_sympy,
    to_sympy,
)
from tests.oracles.printed import paper, rows

ARTICLE = pages.read(pages.SHIPPED / "kang_nam.py")
COUPLING = pages.read(pages.SHIPPED / "mode_coupling.py")


def _judged(
    about: str, text: str, form: str = "scaled", model: pages.PageModel = ARTICLE
) -> verdicts.Row:
    (row,) = rows(model, (about, text), form=form)
    return row


def _same(text: str, other: str) -> bool:
    """Equality by SymPy's own parser, which has no part in the check."""
    names = {name: sp.Symbol(name) for name in ("beta", "N", "S", "E", "Q", "I")}
    one, second = (
        sp.sympify("({}) - ({})".format(*it.split("=")), locals=names) for it in (text, other)
    )
    return sp.simplify(one - second) == 0


@pytest.mark.parametrize(
    ("about", "form", "wrong", "right"),
    [
        (
            "definition",
            "units",
            "L = sqrt((L_0*cos(theta) - x)**2 + (L_0*sin(theta) - y)**2)",
            "L = sqrt((L_0*cos(theta0) - x)**2 + (L_0*sin(theta0) - y)**2)",
        ),
        (
            "motion y",
            "scaled",
            "ay + sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N = 0",
            "ay + sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N + kappa = 0",
        ),
        (
            "equilibrium y",
            "scaled",
            "sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N = 0",
            "sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N + kappa = 0",
        ),
        ("scale N", "units", "n = N/k_c", "n = N/(k_c*L_0)"),
    ],
)
@pytest.mark.thorough
def test_misprints_of_the_article_are_found_without_a_hint(
    about: str, form: str, wrong: str, right: str
) -> None:
    """Four misprints of the article are found, each with one repair that is proved."""
    row = _judged(about, wrong, form)
    assert row.status == "misprint"
    assert len(row.edits) == 1
    assert row.alternatives == 1
    assert _same(row.repaired, right)
    assert _judged(about, right, form).status in ("confirmed", "definition")


@pytest.mark.parametrize(
    ("about", "text"),
    [
        ("motion x", "m*ax + k_x*x + k/2*(x - y) = mu*N"),
        ("motion x", "0 = 7*k*(m*ax + k_x*x + k/2*(x - y) - mu*N)"),
        ("energy V", "V = k_x*x**2/2 + k_y*y**2/2 + k*(x - y)**2/4 + F_L*y + F_L**2/k_c"),
        ("stiffness 1 2", "K_12 = mu0*k_c - k/2"),
        ("normal", "N = -k_c*y"),
    ],
)
def test_what_follows_from_the_page_is_confirmed(about: str, text: str) -> None:
    """Sides swapped, a factor of parameters, a constant of an energy are no misprints."""
    assert _judged(about, text, "units", COUPLING).status == "confirmed"


SPRINGS = "k_x*x**2/2 + k_y*y**2/2 + k*(x - y)**2/4"


@pytest.mark.parametrize(
    ("about", "before", "sign"),
    [("energy V", "V = ", "+"), ("energy V", "U = ", "+"), ("energy L", "L = m*vx**2/2 + ", "-")],
)
def test_an_applied_force_is_counted_in_the_potential_or_not(
    about: str, before: str, sign: str
) -> None:
    """Both prints of V and of L are right where a constant force acts, and the row says which."""
    energy = f"m*vy**2/2 - ({SPRINGS})" if sign == "-" else SPRINGS
    for text, said in ((energy, "left out"), (f"{energy} {sign} F_L*y", "counted")):
        row = _judged(about, before + text, "units", COUPLING)
        assert row.status == "confirmed", text
        assert f"{said}: F_L*y" in row.evidence
        assert ("F_L" in row.derived) == (said == "counted")


@pytest.mark.thorough
def test_an_energy_is_repaired_in_the_reading_that_it_is_nearest_to() -> None:
    """A sign is one edit, in V without the applied force; a force along another way is none."""
    row = _judged("energy V", f"V = {SPRINGS}".replace("x - y", "x + y"), "units", COUPLING)
    assert (row.status, [it["kind"] for it in row.edits]) == ("convention", ["sign"])
    assert "F_L" not in row.difference
    wrong = _judged("energy V", f"V = {SPRINGS} + F_L*x", "units", COUPLING)
    assert wrong.status == "misprint"


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("sign", "limit", "status"),
    [
        ("+", "linear in x, y", "approximation"),
        ("-", "linear in x, y", "failed"),
        ("+", "linear in x", "failed"),
        ("+", "", "approximation"),
        ("+", "linear in w", "w is no name"),
        ("+", "theta0, w, q -> 0", "w, q is no name"),
        ("+", "x, y -> w", "is no number of the page"),
        ("+", "x, y", "is none"),
    ],
)
def test_a_print_may_be_meant_to_first_order(sign: str, limit: str, status: str) -> None:
    """The force of an inclined spring is linear where all displacements are small together."""
    spring = f"sigma*cos(theta0)*(x*cos(theta0) {sign} y*sin(theta0))"
    text = f"ax + {spring} + alpha*x - mu*N = 0"
    meant = paper([("motion x", text)], form="scaled", limit=limit)
    (row,) = verdicts.check(meant, ARTICLE, repair=False).rows
    assert row.status == status or (row.status == "unread" and status in row.evidence)


@pytest.mark.parametrize(
    ("side", "push", "status"),
    [
        ("", "+ y", "confirmed"),
        (", both", "+ y", "misprint"),
        (", both", "+ pushing*y", "confirmed"),
        (", lift-off", "+ pushing*y", "confirmed"),
        (", lift-off", "+ y", "misprint"),
    ],
)
def test_a_motion_is_judged_on_the_side_that_is_named(side: str, push: str, status: str) -> None:
    """The contact law without n̄ is right where the mass touches, and on both sides it is not."""
    forces = f"sigma/L*(1 - L)*(sin(theta0) - y) + beta*y + kappa {push}"
    assert _judged(f"motion y{side}", f"ay + {forces} = 0").status == status
    assert _judged(f"acceleration y{side}", f"ay = -({forces})").status == status


def test_a_factor_of_the_state_is_told() -> None:
    """An equation times a coordinate says so, and an energy times 2 is another one."""
    text = "x*(m*ax + k_x*x + k/2*(x - y) - mu*N)"
    row = _judged("motion x", text, "units", COUPLING)
    assert (row.status, "times x" in row.evidence) == ("confirmed", True)
    assert _judged("energy T", "T = m*(vx**2 + vy**2)", "units", COUPLING).status == "misprint"


def test_a_value_with_a_factor_on_its_left_is_not_misread() -> None:
    """``2 T = m v²`` is no value of T, and is not judged as one."""
    row = _judged("energy T", "2*T = m*(vx**2 + vy**2)/2", "units", COUPLING)
    assert row.status == "unread"


REVERSED = [
    ("motion x", "m*ax + k_x*x + k/2*(x + y) + mu*N"),
    ("motion y", "m*ay + k_y*y + k_c*y + k/2*(y + x) + F_L"),
    ("equilibrium y", "k_y*y + k_c*y + k/2*(y + x) + F_L"),
]


@pytest.mark.thorough
def test_a_convention_is_stated_and_never_voted() -> None:
    """Rows with x reversed hold where the file says so; else they are told, and a row that is right
    without it makes them misprints.
    """
    stated = paper(REVERSED, conventions={"x": "reversed"}, form="units")
    found = verdicts.check(stated, COUPLING)
    assert [row.status for row in found.rows] == ["confirmed"] * 3
    assert found.conventions == ("x of the print is -x of the page",)
    silent = verdicts.check(paper(REVERSED, form="units"), COUPLING)
    assert {(row.status, row.is_expected) for row in silent.rows} == {("convention", False)}
    assert all("x of the print is -x" in row.evidence for row in silent.rows)
    assert silent.conventions == ()
    right = ("equilibrium x", "k_x*x + k/2*(x - y) - mu0*N")
    *wrong, kept = rows(COUPLING, *REVERSED, right, form="units")
    assert {row.status for row in wrong} == {"misprint"}
    assert kept.status == "confirmed"


def test_a_convention_is_an_expression_of_its_coordinate_and_none_of_a_clock() -> None:
    """An angle from the upright; what is none is refused with the remedy."""
    page = pages.read(Path(__file__).parents[2] / "validation/papers/cart_pole/page.py")
    texts = ("energy V", "V = m_p*g*l*cos(theta)"), ("energy V", "V = -m_p*g*l*sin(theta)")
    for (about, text), count in zip(texts, ("theta - pi", "theta + pi/2"), strict=True):
        (silent,) = rows(page, (about, text), form="units")
        assert silent.status == "convention"
        stated = paper([(about, text)], conventions={"theta": count}, form="units")
        assert verdicts.check(stated, page).rows[0].status == "confirmed"
    forced = pages.read(pages.SHIPPED / "forced_oscillator.py")
    clock = str(forced.mechanics.clock)
    for model, stated in ((forced, {clock: "reversed"}), (page, {"theta": "2*theta"})):
        with pytest.raises(papers.PaperError, match=f"{next(iter(stated))} ="):
            verdicts.check(paper([("other", "")], conventions=stated), model)


def test_units_point_at_the_term() -> None:
    """A statement whose units do not balance says where."""
    row = _judged("motion x", "m*ax + k_x*x**2 + k/2*(x - y) = mu*N", "units", COUPLING)
    assert row.status == "misprint"
    assert "k_x*x**2" in row.evidence


def test_a_print_is_read_as_it_stands() -> None:
    """Trees of random expressions have the value that SymPy's own parser reads."""
    names = frozenset({"x", "y", "z"})
    vocabulary = Vocabulary(names, ("x",), {})
    symbols = {name: sp.Symbol(name) for name in names}
    parts = ["x", "-y", "(x - 2*y)", "z**2", "x/y/z", "sin(x)*z", "-x**2", "2**-y"]
    for (one, other), sign in itertools.product(itertools.permutations(parts, 2), "+-*/"):
        text = f"{one} {sign} {other}" if sign in "+-" else f"({one}) {sign} ({other})"
        (equation,) = read_sympy(text, vocabulary)
        assert sp.expand(to_sympy(equation.left, symbols) - sp.sympify(text)) == 0, text
        (again,) = read_sympy(printed(equation.left), vocabulary)
        assert to_sympy(again.left, symbols) == to_sympy(equation.left, symbols), text


@pytest.mark.parametrize(
    "text", ["w + x", "x.y", "__import__('os')", "f(x)", "x +", "x if y else z"]
)
def test_what_is_no_expression_is_refused(text: str) -> None:
    """Nothing is evaluated, and unknown names are said with the place."""
    with pytest.raises(Unread):
        read_sympy(text, Vocabulary(frozenset({"x", "y", "z"}), (), {}))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("paper = 3", "line 1, key paper"),
        ("colour = 'red'", "line 1, key colour"),
        ("[[statement]]\nid = 'a'\nsympy = 'x'", "line 1, key about"),
        (
            "[[statement]]\nid = 'a'\nabout = 'motion x'\nform = 'si'\nsympy = 'x'",
            "line 4, key form",
        ),
        ("[[statement]]\nid = 'a'\nabout = 'motion x'", "line 2, key id"),
        ("[[statement]]\nid = 'a", "no TOML"),
    ],
)
def test_a_file_is_refused_by_line_and_key(tmp_path: Path, text: str, said: str) -> None:
    """An error names the line, the key and a remedy."""
    file = tmp_path / "paper.toml"
    file.write_text(text)
    with pytest.raises(papers.PaperError, match=said):
        papers.read(file)


def test_every_function_is_evaluated_in_numbers_and_exactly() -> None:
    """Numbers of every function of a print are those of SymPy."""
    import numpy as np

    from spragsym.derive.statements.repair import evaluated

    vocabulary = Vocabulary(frozenset({"x"}), (), {})
    for name, function in FUNCTIONS.items():
        count = 0 if name not in OF_SEVERAL else 1 if name == "atan2" else 2
        written = ", ".join(["x", "1/2", "2/5"][: count + 1])
        (equation,) = read_sympy(f"{name}({written})", vocabulary)
        inside = np.array([0.3, 0.7]) + (name == "acosh")
        value = evaluated(equation.left, {"x": inside})
        more = (sp.Rational(1, 2), sp.Rational(2, 5))[:count]
        assert np.allclose(value, [float(function(it, *more)) for it in inside]), name
    assert [FUNCTIONS[name](3, 1, 2) for name in ("max", "min")] == [3, 1]
    with pytest.raises(Unread):
        read_sympy("atan2(x, 1/2, 2/5)", vocabulary)
    assert [FUNCTIONS["Heaviside"](it) for it in (-2, 2)] == [0, 1]


def test_an_entry_that_is_not_judged_leaves_its_statement_unread() -> None:
    """An entry without a name on its left is not passed over."""
    text = "K_11 = k_x + k/2; 0 = mu0*k_c - k/2; K_21 = -k/2; K_22 = k_y + k_c + k/2"
    assert _judged("stiffness", text.replace("0 =", "K_12 ="), "units", COUPLING).status == (
        "confirmed"
    )
    assert _judged("stiffness", text, "units", COUPLING).status == "unread"


def test_a_name_whose_definition_has_no_meaning_in_a_form_is_unread() -> None:
    """A definition in quantities with units is none in the scaled form; one of it may be used."""
    found = rows(
        COUPLING,
        ("definition", "h = k_c*x"),
        ("motion x", "ax + h = 0", {"form": "scaled"}),
        ("equilibrium x", "h + mu0*N = 0"),
        form="units",
    )
    assert [row.status for row in found][:2] == ["definition", "unread"]
    assert "h is no name" in found[1].evidence
    assert found[2].status in ("failed", "misprint")


@pytest.mark.thorough
def test_names_of_values_stand_for_what_is_derived() -> None:
    """A mistake is found where it stands, and not where the name is used."""
    angles = r"\begin{bmatrix}\cos\theta\\ \sin\theta\end{bmatrix}"
    found = rows(
        ARTICLE,
        ("direction matrix", r"\mathbf{D} = \sigma \mathbf{I}"),
        ("equilibrium", rf"\mathbf{{D}}{angles} = \mathbf{{b}}"),
        ("direction side", r"\mathbf{b} = \begin{bmatrix} 0 \\ 0 \end{bmatrix}"),
        form="scaled",
    )
    assert [row.status == "confirmed" for row in found] == [False, True, False]


@pytest.mark.thorough
def test_a_matrix_is_read_with_its_inverse_and_its_determinant() -> None:
    """Random matrices, against SymPy's own algebra."""
    from spragsym.derive.statements.latex import read_latex

    names = frozenset({"a", "b", "c", "d"})
    vocabulary = Vocabulary(names | {"R"}, ("a", "b"), {}, {"R": (2, 2)})
    symbols = {name: sp.Symbol(name) for name in (*names, "R_11", "R_12", "R_21", "R_22")}
    R = sp.Matrix(2, 2, [symbols[f"R_{i}{j}"] for i in (1, 2) for j in (1, 2)])
    A = sp.Matrix(2, 2, [symbols[name] for name in ("a", "b", "c", "d")])
    matrix = r"\begin{bmatrix} a & b \\ c & d \end{bmatrix}"
    cases = {
        rf"\det(a \mathbf{{I}} + {matrix} R)": [(symbols["a"] * sp.eye(2) + A * R).det()],
        rf"R = ({matrix} R^T)^{{-1}}": [*(R - (A * R.T).inv())],
        rf"R {matrix} - {matrix} R = 0": [*(R * A - A * R)],
    }
    for text, expected in cases.items():
        found = read_latex(text, vocabulary)
        gaps = [to_sympy(it.left, symbols) - to_sympy(it.right, symbols) for it in found]
        pairs = zip(gaps, expected, strict=True)
        assert all(sp.simplify(gap - other) == 0 for gap, other in pairs), text


def test_formulas_are_shown_as_mathml() -> None:
    """What can be read is rendered, with dots on rates; what can't is left as text."""
    from spragsym.derive.statements.mathml import rendered

    shown = rendered("m_1*ax + sin(theta0)/L = 0", ["x"])
    assert shown is not None
    assert "<msub><mi>m</mi><mn>1</mn></msub>" in shown
    assert "<mover><mi>x</mi><mo>¨</mo></mover>" in shown
    assert "<mfrac>" in shown
    assert "θ" in shown
    assert rendered("besselj(1, x)", []) is None


@pytest.mark.thorough
def test_zero_is_decided_in_polynomials() -> None:
    """Random quotients on a circle, with roots and functions, equal and not."""
    import random

    from spragsym.derive import algebra

    c, s, x, y = sp.symbols("c s x y")
    generator = random.Random(78)
    parts = [c, s, x, y, sp.sqrt(x + 2), 1 / (x + y), sp.Abs(y), sp.exp(x), sp.Rational(2, 3)]

    def drawn() -> sp.Expr:
        one, other, third = generator.sample(parts, 3)
        return (one + generator.randint(1, 3) * other) / (third + c**2)

    for _ in range(6):
        left = drawn() * drawn() + drawn()
        same = sp.expand(left.subs(c**2, 1 - s**2), deep=False)
        assert algebra.equal(left, same, ((c, s),)), left
        assert not algebra.equal(left, same + x * s**3 / 7, ((c, s),)), left
    assert algebra.equal(sp.sign(x - y) * sp.Abs(y - x), -sp.sign(y - x) * sp.Abs(x - y), ())
    assert not algebra.equal(sp.sign(x - y), sp.sign(y - x), ())
    assert algebra.equal(sp.sqrt(c**2 + s**2) - x / x, 0, ((c, s),))
    assert algebra.equal((sp.sqrt(2) + sp.sqrt(x)) ** 2, 2 + x + 2 * sp.sqrt(2) * sp.sqrt(x), ())


def test_identities_of_functions_are_known() -> None:
    """Of angles that are multiples of each other, exponentials, sizes and signs; wrong ones are
    none.
    """
    from spragsym.derive.statements.identities import is_zero, normal_form

    a, p = sp.symbols("a p", nonnegative=True)
    x, y = sp.symbols("x y", real=True)
    right = {
        "sin((1 - a)*y)": "sin(y)*cos(a*y) - cos(y)*sin(a*y)",
        "1 - cos(x - y)": "2*sin((x - y)/2)**2",
        "tan(x/2)": "sin(x)/(1 + cos(x))",
        "cos(x)": "cos(x/3)*(4*cos(x/3)**2 - 3)",
        "tanh(x)": "(1 - exp(-2*x))/(1 + exp(-2*x))",
        "1 - tanh(x)**2": "1/cosh(x)**2",
        "exp(-(x + y)/p)": "exp(-x/p)*exp(-y/p)",
        "sign(x)*Abs(x)": "x",
        "Abs(p*x - p*y)": "p*Abs(y - x)",
        "Abs(x)**3": "sign(x)*x**3",
        "log(a*p)": "log(a) + log(p)",
        "log(1 + x/p)": "log(x + p) - log(p)",
        "log(x**2/p**2)/log(p)": "log(x**2)/log(p) - 2",
        "Abs(x)*y": "Piecewise((x*y, x > 0), (-x*y, x < 0))",
    }
    names = {str(it): it for it in (a, p, x, y)}
    for left, value in right.items():
        gap = sp.sympify(f"{left} - ({value})", locals=names)
        assert is_zero(gap), left
        assert not is_zero(gap + x * y / 7), left
        assert not is_zero(sp.sympify(f"{left} + ({value})", locals=names)), left
    assert normal_form(sp.cos(x / 2) ** 2 + sp.sin(x / 2) ** 2 - 1) == 0
    shown = normal_form(sp.cos(x / 2) - sp.cos(x))
    assert shown.free_symbols == {x}


@pytest.mark.parametrize(
    ("about", "text", "kinds"),
    [
        ("motion x", "m*ax - k_x*x + k/3*(x - y) = mu*N", ["sign", "number"]),
        ("energy V", f"V = {SPRINGS.replace('k_x', 'k_y', 1)} - F_L*y", ["sign", "index"]),
        ("energy V", "V = k_x*x**2/2 + k_y*y**2/2 + F_L*y", ["missing term"]),
    ],
)
@pytest.mark.thorough
def test_two_edits_and_a_lost_term_with_brackets_are_found(
    about: str, text: str, kinds: list[str]
) -> None:
    """Pairs of edits; and a lost term that is a product of brackets."""
    row = _judged(about, text, "units", COUPLING)
    assert row.status == "misprint"
    assert sorted(it["kind"] for it in row.edits) == sorted(kinds)
    assert row.marked.replace("«", "").replace("»", "") == text
    marked = [text[slice(*it["at"])] for it in row.edits]
    assert all(f"«{part}»" in row.marked for part in marked), row.marked
    assert _judged(about, row.repaired, "units", COUPLING).status == "confirmed"


def test_a_number_is_replaced_where_it_stands() -> None:
    """Another exponent, and another number, in its place and not beside it."""
    for about, text, old, new in (
        ("energy T", "T = m*(vx**2 + vy**3)/2", "3", "2"),
        ("energy V", f"V = {SPRINGS.replace('/4', '/3')}", "3", "4"),
        (
            "energy V",
            f"V = {SPRINGS.replace('(x - y)**2', '(x - y**2)')}",
            "x - y**2",
            "(x - y)**2",
        ),
    ):
        row = _judged(about, text, "units", COUPLING)
        assert [(it["old"], it["new"]) for it in row.edits] == [(old, new)], text


def test_an_energy_keeps_its_constant() -> None:
    """What a print adds that holds no state stays where something else is wrong."""
    text = "V = k_x*(x**2 - h**2)/2 + k_y*(y**2 - 4*h**2)/2 + k*(y + x)**2/4".replace(
        "h", "(F_L/k_c)"
    )
    row = _judged("energy V", text, "units", COUPLING)
    assert row.status == "convention"  # and what is right without one
    assert row.repaired in (text.replace("y + x", "y - x"), text.replace("y + x", "-y + x"))


def test_a_rate_has_the_letter_that_its_coordinate_is_listed_with() -> None:
    """Dots stand on the paper's letter in what is right."""
    text = r"T = \frac{m}{2} (\dot X^2 + \dot{X}^2)"
    (row,) = rows(COUPLING, ("energy T", text), renamed={"X": "x", "Y": "y"})
    assert r"\dot{Y}" in row.repaired_latex


def test_a_paper_is_repaired_and_held_against_another_page() -> None:
    """A repaired misprint is confirmed by its page, and fails without a repair by another one."""
    text = "m*ax - k_x*x + k/2*(x - y) = mu*N"
    wrong = paper([("motion x", text)], form="units", expect="misprint")
    right = verdicts.repaired(wrong, COUPLING)
    (row,) = verdicts.check(right, COUPLING, repair=False).rows
    assert row.status == "confirmed"
    (row,) = verdicts.check(wrong, COUPLING, repair=False).rows
    assert (row.status, row.repaired) == ("failed", "")
    assert row.difference


def test_a_reversed_equation_may_be_divided_by_a_parameter() -> None:
    """x is counted the other way in two rows, of which one is over the mass: none is a misprint."""
    texts = [
        ("motion x", "-ax - k_x/m*x - k/(2*m)*(x + y) - mu*N/m = 0"),
        ("motion y", "m*ay + k_y*y + k_c*y + k/2*(y + x) + F_L = 0"),
    ]
    stated = paper(texts, conventions={"x": "reversed"}, form="units")
    found = verdicts.check(stated, COUPLING)
    assert [row.status for row in found.rows] == ["confirmed", "confirmed"]


@pytest.mark.thorough
def test_equations_are_those_of_which_they_are_multiples() -> None:
    """In another order, and as a chain of two of which one is a sum."""
    across, along = "k_y*y + k_c*y + k/2*(y - x) + F_L", "k_x*x + k/2*(x - y) - mu0*N"
    for text in (f"2*({across}) = 0; {along} = 0", f"{across} = {along}; 3*({along}) = 0"):
        assert _judged("equilibrium", text, "units", COUPLING).status == "confirmed"
        row = _judged("equilibrium", text.replace("F_L", "x"), "units", COUPLING)
        assert row.status == "misprint"
    assert _judged("equilibrium", f"{along} = 0; 2*({along}) = 0", "units", COUPLING).status == (
        "failed"
    )


@pytest.mark.parametrize(("sign", "status"), [("-", "confirmed"), ("+", "misprint")])
def test_an_equilibrium_may_hold_the_other_one(sign: str, status: str) -> None:
    """N is written as the forces across that it balances: right where the other equation holds."""
    across = "F_L + k_y*y + k/2*(y - x)"
    text = f"(k_x + k/2)*x - k/2*y {sign} mu0*({across})"
    row = _judged("equilibrium x", text, "units", COUPLING)
    assert row.status == status
    assert status == "misprint" or "with a multiple of the equation of y" in row.evidence


SWAPPED = "K_21 = -k/2; K_11 = k_x + k/2; K_22 = k_y + k_c + k/2; K_12 = mu0*k_c - k/2"
SOLVED = "ay = -(k_y*y + k_c*y + k/2*(y - x) + F_L)/m; ax = (mu*N - k_x*x - k/2*(x - y))/m"


@pytest.mark.parametrize(
    ("about", "text", "status"),
    [
        ("stiffness", SWAPPED, "confirmed"),
        ("stiffness", SWAPPED.replace("K_21", "K_12", 1), "unread"),
        ("acceleration", SOLVED, "confirmed"),
        ("acceleration", SOLVED.replace("ay", "ax"), "unread"),
    ],
)
def test_entries_are_those_that_their_names_say(about: str, text: str, status: str) -> None:
    """In any order; a name that stands twice is no other entry."""
    row = _judged(about, text, "units", COUPLING)
    assert row.status == status
    assert status == "confirmed" or "each entry" in row.evidence


SUM = r"\begin{pmatrix} k_x & 0\\ 0 & k_y + k_c\end{pmatrix} + \frac k2\begin{pmatrix} 1 & -1\\ -1 & 1\end{pmatrix}"
WHOLE = r"\begin{pmatrix} k_x + k/2 & \mu_0k_c - k/2\\ -k/2 & k_y + k_c + k/2\end{pmatrix}"
RUBBED = SUM + r" + \begin{pmatrix} 0 & \mu_0 k_c\\ 0 & 0\end{pmatrix}"


@pytest.mark.parametrize("name", [r"\mathbf K", r"\mathbf K_s", "K"])
@pytest.mark.parametrize("sides", [(WHOLE, RUBBED), (RUBBED, WHOLE)])
def test_every_matrix_of_a_chain_is_judged(sides: tuple[str, str], name: str) -> None:
    """Also the first one, where the second is right."""
    one, other = sides
    for text, status in (
        (f"{name} = {one} = {other}", "confirmed"),
        (f"{name} = {one} = {other.replace('k_c', 'k_y')}", "misprint"),
        (f"{name} = {one.replace('k_y', 'k_x')} = {other}", "misprint"),
    ):
        assert _judged("stiffness", text, "units", COUPLING).status == status


@pytest.mark.thorough
def test_a_constant_of_an_energy_is_an_energy() -> None:
    """A force that lost its way is no constant, and no repair leaves one."""
    springs = "V = k_x*x**2/2 + k_y*y**2/2 + k*(x - y)**2/4"
    row = _judged("energy V", f"{springs} + F_L", "units", COUPLING)
    assert row.status == "misprint"
    assert _same(row.repaired, f"{springs} + F_L*y")
    row = _judged("energy V", f"{springs} + F_L*y".replace("y**2", "m**2"), "units", COUPLING)
    assert _same(row.repaired, f"{springs} + F_L*y")


def test_an_energy_without_a_value_is_judged_without_a_warning() -> None:
    """As of a misprinted gap, which is 0: what is infinite equals nothing."""
    text = "V = k_x*x**2/2 + k_y*y**2/2 + k*(x - y)**2/4 + F_L*y/(x - x)"
    row = _judged("energy V", text, "units", COUPLING)
    assert row.status in ("misprint", "failed")


@pytest.mark.parametrize("lost", ["Omega**2/2", "m*Omega/2"])
def test_a_term_of_one_reading_is_mended_and_not_taken_away(lost: str, tmp_path: Path) -> None:
    """As the centrifugal potential, which may be left out as a whole."""
    page = tmp_path / "page.py"
    page.write_text(
        '''"""A mass in a frame that turns."""
from spragsym.derive.model import Page
page = Page("A mass on a spring in a frame that turns.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "spring")
h = page.unit("h", "m", "length")
Omega = page.parameter("Omega", "1/s", "speed", "> 0", 0.4)
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * (page.rate(x) ** 2 + Omega**2 * x**2) / 2)
page.spring(k, along=x)
'''
    )
    right = "V = k*x**2/2 - m*Omega**2/2*x**2"
    fault = right.replace("m*Omega**2/2", lost)
    row = _judged("energy V", fault, "units", pages.read(page))
    assert row.status == "misprint"
    assert _same(row.repaired, right)


@pytest.mark.thorough
def test_a_name_beside_an_equation_stands_for_what_it_is_given() -> None:
    """In this print and in others; a name with a value that no other equation uses is none."""
    value = r"\quad\text{where}\quad \kappa = \frac{k}{2m}, \quad \omega^2 = k_x/m"
    print_ = rf"\ddot x + \omega^2 x + \kappa(x - y) = \frac{{\mu N}}{{m}}, {value}."
    other = r"\ddot y + \kappa(y - x) + \frac{k_y + k_c}{m}y = -F_L/m"
    found = rows(COUPLING, ("motion y", other), ("motion x", print_), form="units")
    assert [it.status for it in found] == ["confirmed"] * 2
    for fault in (print_.replace("+ \\kappa", "- \\kappa"), print_.replace("2m", "3m")):
        assert _judged("motion x", fault, "units", COUPLING).status == "misprint"
    text = r"k_e = \alpha_0 - k/2, \quad \alpha_0 = \mu_0 k_c"
    assert _judged("stiffness 1 2", text, "units", COUPLING).status == "confirmed"
    row = _judged("stiffness 1 2", text.replace("k_c", "k_y"), "units", COUPLING)
    assert row.status == "misprint"


def test_a_print_at_one_state_says_so() -> None:
    """The stiffness of a pendulum that hangs, that of the page at the angle 0, is no misprint."""
    page = pages.read(Path(__file__).parents[2] / "validation/papers/cart_pole/page.py")
    at_0, limit = "m_p*l*g", "limit = 'theta -> 0'"
    row = _judged("stiffness 2 2", f"K_22 = {at_0}", "units", page)
    assert (row.status, limit in row.evidence) == ("unread", True)
    (row,) = rows(page, ("stiffness 2 2", f"K_22 = {at_0}", {"limit": "theta -> 0"}), form="units")
    assert row.status == "approximation"
    assert _judged("stiffness 2 2", f"K_22 = 2*{at_0}", "units", page).status == "misprint"


@pytest.mark.thorough
def test_the_stiffness_of_one_coordinate_and_a_clock() -> None:
    """Of the coordinates that move, and so is the system."""
    forced = pages.read(pages.SHIPPED / "forced_oscillator.py")
    found = rows(forced, ("stiffness 1 1", "K_11 = k"), ("damping 1 1", "C_11 = 0"), form="units")
    system = r"\mathbf A = \begin{bmatrix} 0 & 1\\ -k/m & 0\end{bmatrix}"
    found += rows(forced, ("system", system), form="units")
    assert [it.status for it in found] == ["confirmed"] * 3


def test_a_meaning_in_one_form_does_not_hinder_statements_in_the_other() -> None:
    """A name that the scaled page has not is refused where it is used."""
    renamed = {"P": "2*k_x", "Q": "nowhere + k_x"}
    prints = (
        ("stiffness 1 1", r"\kappa_1 = P/2 + k/2", {"form": "units"}),
        ("stiffness 1 1", r"\kappa_2 = \alpha + \sigma/2", {"form": "scaled"}),
        ("stiffness 1 1", r"\kappa_3 = P/2 + k/2", {"form": "scaled"}),
        ("stiffness 1 1", r"\kappa_4 = Q", {"form": "units"}),
    )
    found = rows(COUPLING, *prints, renamed=renamed)
    assert [it.status for it in found] == ["confirmed"] * 2 + ["unread"] * 2
    assert "k_x is no name" in found[2].evidence
    assert "nowhere is no name" in found[3].evidence


@pytest.mark.thorough
def test_definitions_of_one_row_and_of_each_other() -> None:
    """Several names in a row, one value of two names, and a name before its own definition."""
    found = rows(
        COUPLING,
        ("definition", r"p_1 = k_x + k_y, \quad p_2 = p_3 = k/2"),
        ("definition", "p_4 = p_5"),
        ("definition", "2 p_5 = p_1 + 2k^* - p_1"),
        ("definition", "k^* = p_1 - k_y"),
        ("motion x", r"m\ddot x + p_4 x + p_2 (x - y) - (p_3 - k/2) y = \mu N"),
        ("motion x", r"m\ddot x + p_4 x + p_2 (x + y) - (p_3 - k/2) y = \mu N"),
        form="units",
    )
    assert [row.status for row in found] == [*["definition"] * 4, "confirmed", "misprint"]


def test_a_frequency_of_the_page_is_its_own() -> None:
    """Only where the page has no such name are powers of a frequency those of λ."""
    one = paper([("characteristic", "frequency**2 - 1 = 0")], form="scaled")
    (item,) = reading.read_paper(one, COUPLING)[1]
    assert isinstance(item, reading.Item)
    assert printed(item.equations[0].left) == "-lam**2 - 1"


def test_nothing_rests_on_a_page_with_a_clock() -> None:
    """There is no state of it either."""
    forced = pages.read(pages.SHIPPED / "forced_oscillator.py")
    (row,) = rows(forced, ("state x", "x = 0"))
    assert row.status == "unread"
    assert "nothing rests on a page with a clock" in row.evidence


def test_a_rate_is_0_of_constants_alone() -> None:
    """Of a length that moves, and of a name that the page has not, it is not read as 0."""
    texts = [
        ("definition", r"w_0 = \sigma/\alpha"),
        ("motion x", r"\frac{d}{dt}(w_0 x) = 0"),
        ("motion y", r"\dot{L} + y = 0"),
        ("energy V", r"V = \dot\phi"),
    ]
    read = paper(texts, {r"\phi": "phi"}, form="scaled")
    _, constant, length, unknown = reading.read_paper(read, ARTICLE)[1]
    assert isinstance(constant, reading.Item)
    assert printed(constant.equations[0].left) == "w_0*vx"
    assert isinstance(unknown, reading.Verdict)
    assert "phi" in unknown.evidence
    # A length, against its change in a short time.
    assert isinstance(length, reading.Item)
    at = length.values
    step = 1e-6

    def after(time: float) -> np.ndarray:
        across = np.cos(at["theta0"]) - at["x"] - time * at["vx"]
        along = np.sin(at["theta0"]) - at["y"] - time * at["vy"]
        return np.hypot(across, along)

    slope = (after(step) - after(-step)) / (2 * step)
    assert at["diff(L, t)"] == pytest.approx(slope, rel=1e-7)


@pytest.mark.parametrize(
    ("name", "number", "old", "new", "kind"),
    [
        ("shaken_block", "6", r"x < v_0", r"x > v_0", "function"),
        ("shaken_block", "6", r"& \dot x < v_0", r"& x < v_0", "symbol"),
        ("shaken_block", "6", r"+ \frac{F_N}", r"- \frac{F_N}", "sign"),
        ("two_inclined_springs", "5", "s^2", "s^3", "exponent"),
        ("two_inclined_springs", "1", "m & 0", "m & 1", "number"),
        ("two_inclined_springs", "6", "k_{22}-k_{11}", "k_{22}+k_{11}", "sign"),
        ("two_inclined_springs", "6", "}{2}", "}{3}", "number"),
        ("cubic_friction", "2", r"\frac32", r"\frac33", "number"),
        ("cubic_friction", "2", r"- \frac13", r"+ \frac13", "sign"),
        ("cubic_friction", "2", r"\right)^3", r"\right)", "exponent"),
        ("cubic_friction", "10", r"V_b\dot X^2", r"V_b\dot X^3", "exponent"),
        ("drill_string", "9", "+ W_{ob}R_b", "- W_{ob}R_b", "sign"),
    ],
)
@pytest.mark.thorough
def test_a_fault_is_one_edit_of_what_is_printed(
    name: str, number: str, old: str, new: str, kind: str
) -> None:
    """In a condition, in a determinant, in what is solved for a name or holds in a limit: the
    edit is the planted one, and what is right is the print.
    """
    path = Path(__file__).parents[2] / "validation/papers" / name
    whole = papers.read(path / "paper.toml")
    (right,) = (it for it in whole.statements if it.id == number)
    assert old in right.text
    book, _ = reading.read_paper(whole, pages.read(path / "page.py"))
    item = reading.read_statement(replace(right, text=right.text.replace(old, new, 1)), book)
    assert isinstance(item, reading.Item)
    row = verdicts.verdict_on(item)
    assert (row.status, [it["kind"] for it in row.edits]) == ("misprint", [kind])
    shown, meant = (re.sub("[{} ]", "", it) for it in (row.repaired_latex, right.text))
    assert shown == meant or kind == "exponent"  # in brackets of its own


@pytest.mark.parametrize(
    ("name", "about", "text", "defined"),
    [
        # 0 where the contact is open, of a power that has no value there.
        ("block_on_interface", "motion y, both", r"M\ddot y + C_y\dot y + W = c_n(-y)_+^{5/2}", ""),
        ("block_on_interface", "energy V", r"V = K_xx^2/2 + \frac{2c_n}{7}(-y)^{7/2}", ""),
        ("bead_on_hoop", "energy V", r"V = -mgr\cos\phi - \frac{m}{2}r^2\omega^2\sin^2\phi", ""),
        # On a page without friction μ is a parameter, and N a new name.
        (
            "pad_flutter",
            "motion theta",
            r"J\ddot\theta + c_t\dot\theta + a(F - N) = -\mu(F+N)h",
            r"N = k_2(y-a\theta), \quad F = k_1y + k_1a\theta",
        ),
        # What is numbered is no column a.
        (
            "pad_flutter",
            "motion y",
            r"m\ddot y + a_1\dot y + a_2y + aa_3\theta = 0",
            r"a_1 = c_y, \quad a_2 = k_1 + k_2, \quad a_3 = a_2 - 2k_2",
        ),
        (
            "shaken_block",
            "motion x",
            r"m\left(\ddot z + \ddot u\right) + kz = F_N\mu",
            r"u = u_0\cos\Omega t, \quad z = x - u",
        ),
    ],
)
@pytest.mark.thorough
def test_what_a_page_has_besides_its_equations_is_known(
    name: str, about: str, text: str, defined: str
) -> None:
    """Powers in lift-off, stored energies, letters of forces, numbered names, rates of a phase."""
    page = pages.read(Path(__file__).parents[2] / f"validation/papers/{name}/page.py")
    prints = [("definition", defined)] if defined else []
    *_, row = rows(page, *prints, (about, text), is_latex=True)
    assert row.status == "confirmed", row.evidence


@pytest.mark.parametrize("about", ["motion y", "scale N"])
def test_a_page_without_contact_has_no_normal_force(about: str) -> None:
    """Nor a scale of it."""
    page = pages.read(Path(__file__).parents[2] / "validation/papers/pad_flutter/page.py")
    (row,) = rows(page, (about, r"m\ddot y = N"))
    assert row.status == "unread"
    assert "N, which has no values" in row.evidence or "N is no name" in row.evidence


def test_a_power_that_is_a_fraction_has_a_unit() -> None:
    """Of a length, in a print that is no sum of different units."""
    x, k = sp.symbols("x k", real=True)
    known = {x: units.read("m"), k: units.read("N/m^(5/2)")}
    with sp.evaluate(False):
        power = k * x ** (sp.Integer(5) / 2)
    assert units.of(power, known) == units.read("N")
    with pytest.raises(units.UnitsError, match="is taken of x, which is in m, not a number"):
        units.of(2**x, known)


FOUR_BLOCKS = '''"""Four blocks, each held to each other one and to the ground."""

from spragsym.derive.model import Page

page = Page("Four blocks.")
m, L = page.unit("m", "kg", "mass"), page.unit("L", "m", "length")
k = page.unit("k", "N/m", "stiffness")
q = [page.coordinate(f"x_{i}", "m", "block") for i in range(4)]
for i, one in enumerate(q):
    held = page.parameter(f"g_{i}", "N/m", "to the ground", "> 0", 1.0, becomes=f"gamma_{i}")
    page.spring(held, along=one)
    page.force(page.parameter(f"F_{i}", "N", "load", "real", 1.0, becomes=f"phi_{i}"), along=one)
    for j, other in enumerate(q[:i]):
        between = page.parameter(f"c_{i}{j}", "N/m", "between", "> 0", 1.0, becomes=f"chi_{i}{j}")
        page.spring(between, along=one - other)
page.kinetic(m * sum(page.rate(it) ** 2 for it in q) / 2)
'''


@pytest.mark.thorough
def test_a_state_of_four_coordinates_is_found_in_seconds(tmp_path: Path) -> None:
    """Against NumPy; by eliminations without division it took minutes."""
    (tmp_path / "blocks.py").write_text(FOUR_BLOCKS)
    derivation = book.forms_of(pages.read(tmp_path / "blocks.py"))["units"]
    subject = objects.derived(derivation, "state")
    at = samples.drawn(derivation, subject)
    K = np.zeros((48, 4, 4))
    for i in range(4):
        K[:, i, i] += at[f"g_{i}"]
        for j in range(i):
            K[:, [i, j, i, j], [i, j, j, i]] += at[f"c_{i}{j}"][:, None] * [1, 1, -1, -1]
    loads = np.stack([at[f"F_{i}"] for i in range(4)], axis=1)
    found = [samples.numeric(entry, at) for entry in subject.entries]
    assert np.stack(found, axis=1) == pytest.approx(np.linalg.solve(K, loads[..., None])[..., 0])
