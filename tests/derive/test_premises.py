"""Papers without a page: what they print of energies and forces is a premise, and what follows is
judged.
"""

from __future__ import annotations

import json
import tomllib
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser

import pytest

pytest.importorskip("sympy")

from spragsym.derive.statements.dimensions import problems
from spragsym.derive.statements.papers import Paper, PaperError, Statement, paper_of
from spragsym.derive.statements.premises import check_premises
from spragsym.paper_ledgers import as_latex
from spragsym.papers import PaperCheck
from tests.shown import DOCS

#: Of a pendulum on a cart with damping and a force: id, about, print. Equations are the textbook's.
CART = [
    ("x_p", "definition", r"x_p = x + l\sin\theta"),
    ("y_p", "definition", r"y_p = l\cos\theta"),
    ("T", "energy T", r"T = \frac12 M\dot x^2 + \frac12 m(\dot x_p^2 + \dot y_p^2)"),
    ("V", "energy V", r"V = m g y_p"),
    ("Q", "force x", r"Q = F - c\dot x"),
    (
        "T again",
        "energy T",
        r"T = \frac12(M+m)\dot x^2 + m l\dot x\dot\theta\cos\theta + \frac12 m l^2\dot\theta^2",
    ),
    ("L", "energy L", r"\mathcal L = T - V"),
    (
        "p",
        "identity",
        r"\frac{\partial\mathcal L}{\partial\dot\theta} = m l\dot x\cos\theta + m l^2\dot\theta",
    ),
    (
        "m x",
        "motion x",
        r"(M+m)\ddot x + m l\ddot\theta\cos\theta - m l\dot\theta^2\sin\theta + c\dot x = F",
    ),
    ("m theta", "motion theta", r"l\ddot\theta + \ddot x\cos\theta - g\sin\theta = 0"),
    ("C", "damping 1 1", "C_{11} = c"),
]


def checked(rows: list[tuple[str, str, str]], head: str = "") -> PaperCheck:
    """Verdicts on statements without a page."""
    body = "".join(
        f"[[statement]]\nid = {json.dumps(id)}\nabout = '{about}'\nlatex = '''{latex}'''\n"
        for id, about, latex in rows
    )
    found = check_premises(paper_of("a.toml", f"paper = 'A cart'\n{head}{body}", tomllib.loads))
    return PaperCheck(**vars(found))


def test_premises_are_not_confirmed_and_what_follows_is() -> None:
    found = checked(CART)
    assert dict(zip([row.id for row in found.rows], found.status, strict=True)) == {
        "x_p": "definition",
        "y_p": "definition",
        **dict.fromkeys(("T", "V", "Q"), "premise"),
        **dict.fromkeys(("T again", "L", "p", "m x", "m theta", "C"), "confirmed"),
    }
    assert found.is_expected
    first = found.to_markdown().split("\n\n")[1]
    assert first.startswith(
        "Without a page. Premises, taken as printed and not confirmed: T, V, Q."
    )
    assert found.judged.startswith("6 of 11 judged; 3 premises")


#: Faults after the premises, with a part of what is right.
FAULTS = {
    "m x": ("+ c", "- c", "c*vx"),
    "T again": (r"\frac12 m l^2", r"m l^2", "m*l**2*vtheta**2/2"),
}


@cache
def wrong() -> PaperCheck:
    """Verdicts with all faults, and with prints that are commands elsewhere."""
    rows = [
        (id, about, it.replace(*FAULTS[id][:2]) if id in FAULTS else it) for id, about, it in CART
    ]
    hostile = r"\text{<script>alert(1)</script>} = \href{javascript:alert(1)}{x}"
    return checked(
        [*rows, ("50%", "other", hostile), ("in", "motion x", r"\input{/etc/passwd} = 0")]
    )


@pytest.mark.thorough
def test_faults_after_the_premises_are_found() -> None:
    found = {row.id: row for row in wrong().rows}
    for id, (_, _, right) in FAULTS.items():
        assert found[id].status == "misprint"
        assert right in found[id].repaired
    assert {found[it].status for it in ("T", "V", "Q")} == {"premise"}
    assert {found[it].status for it in ("L", "p", "C")} == {"confirmed"}


def test_a_lagrangian_alone_is_a_premise() -> None:
    rows = [
        ("L", "energy L", r"L = \frac12 m\dot x^2 - \frac12 k x^2"),
        ("right", "motion x", r"m\ddot x + k x = 0"),
        ("wrong", "motion x", r"m\ddot x - k x = 0"),
    ]
    assert checked(rows).status == ("premise", "confirmed", "misprint")


def test_what_stands_beside_a_premise_is_none_of_it() -> None:
    rows = [
        ("T", "energy T", r"T = \frac12 m\dot x^2, \quad V = \frac12 k x^2"),
        ("V", "energy V", r"V = \frac12 k x^2 \quad \text{(of the spring)}"),
        ("m", "motion x", r"m\ddot x + k x = 0"),
    ]
    assert checked(rows).status == ("premise", "premise", "confirmed")


def test_a_factor_before_a_bracket_is_no_function() -> None:
    """Without a page, where no name is known."""
    rows = [
        ("T", "energy T", r"T(\dot x) = \frac12 M\dot x^2"),
        ("V", "energy V", r"V = k(x - x_0)^2"),
        ("Q", "force x", r"Q_x = a(u_1 - u_2)"),
        ("M", "definition", "M = m_1(l_1 + l_2)"),
        ("m", "motion x", r"m_1(l_1 + l_2)\ddot x + 2k(x - x_0) = a(u_1 - u_2)"),
    ]
    assert checked(rows).status == (*("premise",) * 3, "definition", "confirmed")


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([("m", "motion x", r"m\ddot x = 0")], "names no model"),
        ([("T", "energy T", "T = k x^2"), ("m", "motion x", r"m\ddot x = 0")], "holds no rates"),
        (
            [("T", "energy T", r"T = m\dot x^2"), ("Q", "force y", "Q = F")],
            "no coordinate; these are x",
        ),
        (
            [("T", "energy T", r"T = m\dot x^2"), ("Q", "force x", r"Q = -c\dot x^2")],
            "linear dampers",
        ),
        (
            [
                ("T", "energy T", r"T = m\dot x^2"),
                ("a", "definition", "m = n"),
                ("b", "definition", "n = m"),
            ],
            "circle",
        ),
    ],
)
def test_what_makes_no_page_is_refused(rows: list[tuple[str, str, str]], said: str) -> None:
    with pytest.raises(PaperError, match=said):
        checked(rows)


class _Tags(HTMLParser):
    """Elements, attributes and words of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.attributes: set[str] = set()
        self.marked = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes |= {name for name, _ in attrs}
        self.marked += ("class", "edit") in attrs


def test_a_ledger_sets_equations_marks_edits_and_runs_nothing() -> None:
    page = wrong().to_html()
    tags = _Tags()
    tags.feed(page)
    assert tags.tags.count("article") == len(wrong().rows)
    assert tags.tags.count("math") >= len(wrong().rows) - 1
    assert tags.marked == len(FAULTS)
    assert not {"script", "img", "link", "iframe", "a"} & {*tags.tags}
    assert not {"href", "src", "style", "onclick"} & tags.attributes
    assert page.index("2 of 13 wrong") < page.index("<article")
    assert page.count('type="checkbox"') == len({*wrong().status})


def test_a_letter_in_latex_has_what_is_wrong_and_no_command_of_the_paper() -> None:
    letter = wrong().to_latex()
    assert letter.count(": misprint.]") == len(FAULTS)
    assert r"\sin\theta + c\dot x = F\]" in letter
    assert r"\input" not in letter
    assert as_latex(replace(wrong(), paper="50% & _")).startswith(r"\section*{50\% \& \_}")


def test_json_keeps_its_schema() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((DOCS / "check.schema.json").read_text("utf-8"))
    data = json.loads(json.dumps(wrong().as_dict()))
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(data, schema)
    data["rows"][0]["status"] = "right"
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(data, schema)


UNITS = {"m": "kg", "l": "m", "g": "m/s^2"}


@pytest.mark.parametrize(
    ("latex", "said"),
    [
        (r"m l^2\ddot\theta + m g l\sin\theta = 0", ""),
        (r"m l^2\ddot\theta + m g\sin\theta = 0", "m*g*sin(theta) beside m*l**2*atheta"),
        (r"\omega = \sqrt{l/g}", "sqrt(l/g) beside omega"),  # after ω² = g/l
        (r"\frac{\partial V}{\partial\theta} = m g l\sin\theta", ""),
        (
            r"\frac{\partial V}{\partial\theta} = m g\sin\theta",
            "m*g*sin(theta) beside diff(V, theta)",
        ),
        (r"c = 2\zeta m\sqrt{k/m}, \quad F = k x + c\dot x", ""),
        (r"A\sin(\omega l) = 0", "omega*l inside sin"),
    ],
)
def test_units_are_solved_from_the_equations_and_told_beside_the_verdict(
    latex: str, said: str
) -> None:
    rows = [r"V = -m g l\cos\theta", r"\omega^2 = g/l", latex]
    statements = tuple(Statement(str(i), "other", it, True) for i, it in enumerate(rows))
    found = problems(Paper("", "", {}, statements, units=UNITS))
    assert found.keys() == ({"2"} if said else set())
    assert found.get("2", "").startswith(said)
    scaled = (*statements[:2], replace(statements[2], form="scaled"))
    assert not problems(Paper("", "", {}, scaled, units=UNITS))


def test_what_is_no_unit_is_refused() -> None:
    with pytest.raises(PaperError, match="m: 'stone' is not a unit"):
        problems(Paper("", "", {}, (), units={"m": "stone"}))


@pytest.mark.parametrize(
    ("latex", "status", "right"),
    [
        (r"\omega_0 = 3.13\,\mathrm{rad/s}", "confirmed", ""),  # sqrt(9.81/1) is 3.13209…
        (r"\omega_0 = \sqrt{g/l} \approx 3.1321", "confirmed", ""),
        (r"\omega_0 = 3.14", "misprint", "3.13"),
        (r"\omega_0 = 3.1320", "misprint", "3.1321"),
        (r"m g l = 1.962 \times 10^{1} \text{ J}", "confirmed", ""),
        (r"m g l = 1.96 \times 10^{2}", "misprint", "20"),
        (r"k = 3", "unread", ""),
        (r"\omega_0 = g", "unread", ""),
    ],
)
def test_a_printed_number_is_held_to_its_digits(latex: str, status: str, right: str) -> None:
    rows = [
        ("T", "energy T", r"T = \frac12 m l^2\dot\theta^2"),
        ("V", "energy V", r"V = -m g l\cos\theta"),
        ("w", "definition", r"\omega_0 = \sqrt{g/l}"),
        ("n", "value", latex),
    ]
    row = checked(rows, "[data]\nm = '2'\ng = '9.81'\nl = '1.0'\n").rows[-1]
    assert (row.status, row.repaired) == (status, right), row.evidence
