"""What stands between a model and its results: definitions, chains, identities, and where a fault is
blamed.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

pytest.importorskip("sympy")

import spragsym as ss
from spragsym.cli import cli
from spragsym.derive import pages
from spragsym.derive.statements import verdicts
from tests.oracles.printed import Print, paper, rows

#: A pendulum on a cart, whose angle is 0 where it hangs.
PAGE = Path(__file__).parents[2] / "validation/papers/cart_pole/page.py"
CART = pages.read(PAGE)
T = r"T = \frac12(m_c+m_p)\dot x^2 + m_p l\dot x\dot\theta\cos\theta + \frac12 m_p l^2\dot\theta^2"
PLACES = r"x_p = x + l\sin\theta, \quad y_p = -l\cos\theta"
KNOWN: list[Print] = [
    ("energy T", T),
    ("energy V", r"V = -m_p g l\cos\theta"),
    ("definition", PLACES),
    ("definition", r"p = \frac{\partial T}{\partial\dot x}, \quad E = T + V"),
]


@pytest.mark.parametrize(
    ("text", "status", "said"),
    [
        (r"c = \frac{g}{l} = \frac{l}{g}", "misprint", "c = g/l"),
        (r"e = m_p g l = 2m_p g l", "misprint", "e = m_p*g*l"),
        (r"k_1 = \frac12 + \frac13 = \frac16", "misprint", "k_1 = 5/6"),
        (r"k_1 = \frac12 + \frac13 = \frac56", "definition", ""),
        (r"\theta = x/l", "failed", "theta has no value on the page"),
        (r"\omega_0 = \sqrt{l/g} + g", "failed", "units: "),
        (r"a_1 = a_1 + m_p", "unread", "a_1 is no name"),
        (
            r"\dot x_p = \dot x + l\dot\theta\sin\theta",
            "misprint",
            "diff(x_p, t) = vx + l*vtheta*cos",
        ),
        (
            r"p = (m_c + m_p)\dot x + 2 m_p l\dot\theta\cos\theta",
            "misprint",
            "m_p*l*vtheta*cos(theta)",
        ),
        (r"E = T - V", "misprint", "E = T + V"),
    ],
)
def test_a_definition_is_judged(text: str, status: str, said: str) -> None:
    """Every member after the first, every derivative, second definition, number and unit."""
    row = rows(CART, *KNOWN, ("definition", text))[-1]
    assert row.status == status
    assert said in row.repaired or said in row.evidence


@pytest.mark.parametrize(
    ("text", "old", "new"),
    [
        (r"\ddot x_p = \ddot x + l\ddot\theta\cos\theta - l\dot\theta^2\sin\theta", r"- l", "+ l"),
        (r"\frac{\partial V}{\partial\theta} - m_p g l\sin\theta = 0", r"\sin", r"\cos"),
        (r"\frac{d}{dt}\frac{\partial T}{\partial\dot x} = \dot p", r"\dot p", r"\dot E"),
        (r"\dot E = f\dot x", r"\dot x", r"\dot\theta"),
        (r"\dot p = f", "f", "2f"),
    ],
)
@pytest.mark.thorough
def test_an_identity_holds_by_itself_or_along_the_motion(text: str, old: str, new: str) -> None:
    """Kinematics, derivatives of energies, rates of energies and momenta; and a fault in each."""
    right, wrong = rows(
        CART, *KNOWN, ("identity", text), ("identity", text.replace(old, new, 1)), is_latex=True
    )[-2:]
    assert right.status == "confirmed"
    assert ("along the motion" in right.evidence) is (r"\dot E =" in text or text[:6] == r"\dot p")
    assert wrong.status in ("misprint", "failed")


@pytest.mark.parametrize(
    ("definition", "old", "new", "kind"),
    [
        (r"M = m_c + m_p, \quad a = m_p l", "c + m", "c - m", "sign"),
        (r"M = m_c + m_p, \quad a = m_p l", "p l", "p", "missing factor"),
        (r"M = m_c + m_p, \quad a = m_p l", "m_c + m_p", "m_c", "missing term"),
    ],
)
@pytest.mark.thorough
def test_a_fault_is_blamed_where_it_stands(definition: str, old: str, new: str, kind: str) -> None:
    """One wrong definition makes rows wrong: it is the misprint, and these are right with it."""
    prints: list[Print] = [
        ("definition", definition.replace(old, new, 1)),
        ("motion x", r"M\ddot x + a\ddot\theta\cos\theta - a\dot\theta^2\sin\theta = f"),
        (
            "energy T",
            r"T = \frac12 M\dot x^2 + a\dot x\dot\theta\cos\theta + \frac12 a l\dot\theta^2",
        ),
        ("motion theta", r"m_p l\ddot x\cos\theta + m_p l^2\ddot\theta + m_p g l\sin\theta = 0"),
    ]
    defined, *others = rows(CART, *prints)
    assert defined.status == "misprint"
    assert [it["kind"] for it in defined.edits] == [kind]
    assert {it.status for it in others} == {"confirmed"}
    assert ["right with (0) mended" in it.evidence for it in others] == [True, True, False]
    again = paper([("definition", definition), *prints[1:]])
    assert all(it.is_expected and not it.note for it in verdicts.check(again, CART).rows)


@pytest.mark.thorough
def test_a_wrong_definition_is_blamed_by_its_rates() -> None:
    """As of a place, of which only the speed is printed again; a row of its own fault is not."""
    wrong: list[Print] = [
        ("definition", PLACES.replace(r"\sin", r"\cos")),
        ("energy T", r"T = \frac12 m_c\dot x^2 + \frac12 m_p(\dot x_p^2 + \dot y_p^2)"),
        ("identity", r"\dot x_p = \dot x + l\dot\theta\cos\theta"),
        ("energy V", r"V = 2m_p g y_p"),
    ]
    defined, *others, own = rows(CART, *wrong)
    assert (defined.status, defined.edits[0]["new"]) == ("misprint", "sin(theta)")
    assert [it.status for it in others] == ["confirmed"] * 2
    assert (own.status, own.repaired) == ("misprint", "V = m_p*g*y_p")


RIGHT = r"(m_c + m_p)\ddot x + m_p l\ddot\theta\cos\theta - m_p l\dot\theta^2\sin\theta = f"
HOSTILE = [
    " + ".join(rf"{number} m_c\ddot x" for number in range(900)) + " = f",
    r"\max(x, " * 40 + "l" + ")" * 40 + " = f",
    "(" * 300 + "x" + ")" * 300 + " = f",
    r"\sin(" * 200 + "x" + ")" * 200 + " = f",
    "7" * 5000 + r"\ddot x = f",
    r"((((x^{100})^{100})^{100})^{100})^{100} = f",
]


@pytest.mark.thorough
def test_a_row_that_is_too_large_costs_itself(tmp_path: Path) -> None:
    """Its time or its size is told, others stand, and the exit code tells it from a row that is
    wrong.
    """
    texts = [RIGHT, *HOSTILE, RIGHT.replace("- m_p", "+ m_p")]
    prints = [f"about = 'motion x'\nlatex = '''{text}'''\n" for text in texts]
    prints += [f"about = 'motion x'\nsympy = 'ax*{it} = f'\n" for it in ("1e400", "1e-400")]
    doubling = "".join(rf"d_{{{i + 1}}} = d_{{{i}}}^2 + d_{{{i}}}, \quad " for i in range(60))
    prints += [f"about = 'definition'\nlatex = '''d_0 = \\cos\\theta, \\quad {doubling}'''\n"]
    entries = [f"[[statement]]\nid = '{number}'\n{text}" for number, text in enumerate(prints)]
    file = tmp_path / "paper.toml"
    file.write_text("\n".join(entries), encoding="utf-8")
    found = ss.check(file, PAGE, row_limit=2.0)
    assert found.status == ("confirmed", *["unread"] * 6, "misprint", *["unread"] * 3)
    said = [it.evidence for it in found.rows if it.status == "unread"]
    assert all("too large" in it or "a power higher" in it for it in said), said
    for kept, code in ((entries[:1], 0), (entries[3:5], 3), (entries[3:8:4], 1)):
        file.write_text("\n".join(kept), encoding="utf-8")
        result = CliRunner().invoke(cli, ["check", str(file), "--model", str(PAGE)])
        assert result.exit_code == code, result.output


def test_a_print_of_more_equations_than_entries_is_unread() -> None:
    """No equation is passed over, though all but one are right."""
    text = rf"{RIGHT} \\ \ddot x\cos\theta + l\ddot\theta + g\sin\theta = 0"
    whole = rows(CART, ("motion", text))[0]
    more = rows(
        CART, ("motion", text + r" \\ \ddot x\cos\theta + 2l\ddot\theta + g\sin\theta = 0")
    )[0]
    assert whole.status == "confirmed"
    assert (more.status, "give the others statements" in more.evidence) == ("unread", True)


@pytest.mark.parametrize(
    ("about", "text", "old", "new"),
    [
        (  # the other acceleration on the right
            "acceleration theta",
            r"\ddot\theta = -\frac{\ddot x\cos\theta + g\sin\theta}{l}",
            r"+ g",
            r"- g",
        ),
        ("motion x", RIGHT.replace("f", r"f\hphantom{x}"), "- m_p", "+ m_p"),
        ("equilibrium theta", r"g = \frac{0}{m_p l\sin\theta}", "0", "m_p"),
    ],
)
def test_an_equation_is_read_in_every_way_that_papers_mean_it(
    about: str, text: str, old: str, new: str
) -> None:
    """Solved for something, and beside a name under [symbols] that can't be read."""
    symbols = {r"\frac{a}{b}": "l", r"\mathscr{L}": "energy L"}
    assert rows(CART, (about, text), renamed=symbols)[0].status == "confirmed"
    fault = rows(CART, ("energy V", r"V = -m_p g l\cos\theta"), (about, text.replace(old, new, 1)))
    assert fault[1].status in ("misprint", "failed", "convention")
