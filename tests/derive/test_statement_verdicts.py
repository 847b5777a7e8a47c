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
from spragsym.derive.model import PageError
from spragsym.derive.statements import verdicts
from spragsym.derive.statements.tree import Vocabulary, printed, read_sympy, tidied
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
        (  # times a rate
            "motion theta",
            r"l\ddot\theta\dot\theta + \ddot x\dot\theta\cos\theta + g\dot\theta\sin\theta = 0",
            "+ g",
            "- g",
        ),
        (  # without the other acceleration
            "motion x",
            r"(m_c + m_p\sin^2\theta)\ddot x = f + m_p(l\dot\theta^2 + g\cos\theta)\sin\theta",
            "f + m_p",
            "f - m_p",
        ),
        (  # in units in which m_p = l = g = 1
            "acceleration theta",
            r"\ddot\theta = -\ddot x\cos\theta - \sin\theta",
            r"- \sin",
            r"+ \sin",
        ),
        ("identity", r"\ddot\theta - \ddot\theta = 0", r"\ddot\theta -", r"\theta -"),
    ],
)
def test_an_equation_is_read_in_every_way_that_papers_mean_it(
    about: str, text: str, old: str, new: str
) -> None:
    """Solved, multiplied, scaled, and beside a name under [symbols] that can't be read."""
    symbols = {r"\frac{a}{b}": "l", r"\mathscr{L}": "energy L"}
    assert rows(CART, (about, text), renamed=symbols)[0].status == "confirmed"
    fault = rows(CART, ("energy V", r"V = -m_p g l\cos\theta"), (about, text.replace(old, new, 1)))
    assert fault[1].status in ("misprint", "failed", "convention")


@pytest.mark.thorough
def test_a_linearized_print_without_a_limit_is_told() -> None:
    """Right to first order, with what to say; a fault in it is repaired there."""
    right, wrong = rows(
        CART,
        ("motion theta", r"\ddot x + l\ddot\theta + g\theta = 0"),
        ("motion theta", r"\ddot x + l\ddot\theta - g\theta = 0"),
    )
    assert right.status == "approximation"
    assert "say limit = 'linear in theta'" in right.evidence
    assert (wrong.status, wrong.repaired) == ("misprint", "ax + l*atheta + g*theta = 0")


HEAD = """
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "spring")
l = page.unit("l", "m", "length")
"""
MASS = 'x = page.coordinate("x", "m", "displacement")\npage.kinetic(m*page.rate(x)**2/2)\n'
ANGLE = 'theta = page.coordinate("theta", "rad", "angle")\n'
RUB = 'mu_c = page.parameter("mu_c", "1", "friction", ">= 0", 0.3)\npage.normal_force(k*l)\n'


@pytest.mark.parametrize(
    ("page", "about", "text", "old", "new"),
    [
        (  # nothing acts along φ
            'r = page.coordinate("r", "m", "distance")\nphi = page.coordinate("phi", "rad", "angle")\n'
            "v = page.rate\npage.kinetic(m*(v(r)**2 + r**2*v(phi)**2)/2)\npage.potential(k*r**2/2)",
            "motion phi",
            r"r\ddot\phi + 2\dot r\dot\phi = 0",
            "+ 2",
            "- 2",
        ),
        (  # a drag
            f'{MASS}b = page.parameter("b", "kg/m", "drag", ">= 0", 0.1)\npage.spring(k, along=x)\n'
            "page.force(-b*Abs(page.rate(x))*page.rate(x), along=x)",
            "motion x",
            r"m\ddot x + b|\dot x|\dot x + kx = 0",
            "+ k",
            "- k",
        ),
        (  # a support that a clock moves
            f'{ANGLE}a = page.parameter("a", "m", "way", ">= 0", 0.1)\n'
            'Omega = page.parameter("Omega", "rad/s", "speed", "> 0", 1.0)\ns = page.clock(Omega)\n'
            "up = page.rate(a*cos(s) - l*cos(theta))\n"
            "page.kinetic(m*(page.rate(l*sin(theta))**2 + up**2)/2)",
            "motion theta",
            r"l\ddot\theta - a\Omega^2\cos\Omega t\sin\theta = 0",
            "- a",
            "+ a",
        ),
        (  # a floor at rest, under smooth friction
            f"{MASS}{RUB}page.friction(x, 0, lambda v: mu_c*tanh(v*m/k))".replace(
                "v*m/k", "v/(l*sqrt(k/m))"
            ),
            "motion x",
            r"m\ddot x = -\mu_c k l\tanh\frac{\dot x}{l\sqrt{k/m}}",
            "= -",
            "= ",
        ),
        (  # a name as theta0 beside theta
            f'{ANGLE}theta0 = page.parameter("theta0", "rad", "slope", "[0, pi/2]", 0.1)\n'
            "page.kinetic(m*l**2*page.rate(theta)**2/2)\n"
            "page.potential(-k*l**2*cos(theta - theta0))",
            "motion theta",
            r"m\ddot\theta + k\sin(\theta - \theta_0) = 0",
            r"\sin",
            r"\cos",
        ),
    ],
)
def test_a_page_needs_no_equilibrium(
    page: str, about: str, text: str, old: str, new: str, tmp_path: Path
) -> None:
    """Equations of motion are judged of pages that are refused where equilibria are asked."""
    file = tmp_path / "page.py"
    words = "from spragsym.derive.model import Abs, Page, cos, sin, sqrt, tanh"
    file.write_text(f'"""A model."""\n{words}\npage = Page("A model.")\n{HEAD}{page}\n', "utf-8")
    with pytest.raises(PageError):
        pages.read(file)
    model = pages.read(file, only_equations=True)
    right, wrong = rows(model, (about, text), (about, text.replace(old, new, 1)))
    assert (right.status, wrong.status in ("misprint", "convention")) == ("confirmed", True)


@pytest.mark.thorough
def test_a_friction_coefficient_is_a_size_beside_its_sign() -> None:
    """μ N sgn v where the law of the page has the sign in it."""
    page = pages.read(PAGE.parents[1] / "stick_slip/page.py")
    law = r"m\ddot x + d\dot x + kx = \mu N\operatorname{sgn}(v_b - \dot x)"
    right, wrong, plain = rows(
        page,
        ("motion x", law),
        ("motion x", law.replace("+ d", "- d")),
        ("motion x", r"m\ddot x + d\dot x + kx = \mu N"),
    )
    assert [it.status for it in (right, wrong, plain)] == ["confirmed", "misprint", "confirmed"]


def test_what_stands_beside_equations_and_what_is_unread_says_nothing() -> None:
    """Values at time 0, a speed of no place, a star of its own, and names of a row that is unread."""
    start, _, speed, _, star, energy, unread, using = rows(
        CART,
        ("motion x", rf"{RIGHT}, \quad x(0) = x_0, \quad \dot x(0) = 0"),
        ("definition", r"\dot x_p = \dot x + l\dot\theta\cos\theta"),
        ("identity", r"\ddot x_p = \ddot x + l\ddot\theta\cos\theta - l\dot\theta^2\sin\theta"),
        ("definition", r"\theta^* = \pi"),
        ("identity", r"\cos\theta^* = -1"),
        ("energy V", r"\mathscr{V} = -m_p g l\cos\theta"),
        ("energy T", r"K = \frac12\qq"),
        ("identity", r"\frac{\partial K}{\partial\dot x} = m_c\dot x"),
    )
    assert [it.status for it in (start, speed, star, energy)] == ["confirmed"] * 4
    assert [it.status for it in (unread, using)] == ["unread"] * 2
    (row,) = rows(CART, ("motion x", RIGHT.replace("f", "f + 2x - 2x")), is_latex=True)
    assert row.status == "confirmed"


def test_a_repair_is_shown_without_what_an_edit_leaves() -> None:
    """Neither a term and its negative, nor a factor 1 or a power 0."""
    names = Vocabulary(frozenset("abv"), (), {})
    for text, shown in (
        ("a + b - a", "b"),
        ("a - (a + b) + b*v**0", "a - (a + b) + b"),
        ("a-a", "0"),
    ):
        assert printed(tidied(read_sympy(text, names)[0].left)) == shown


@pytest.mark.thorough
def test_hamiltons_equations_and_multipliers_are_judged() -> None:
    """Of a function of momenta, which stay where it is differentiated, and a force of constraint."""
    page = pages.read(PAGE.parents[1] / "pendulum/page.py")
    turned = r"\dot p = -\frac{\partial H}{\partial\theta} - \frac{b p}{m l^2}"
    drawn = r"\frac{u_0 - b\dot\theta}{l}"
    statuses = [
        it.status
        for it in rows(
            page,
            ("definition", r"p = m l^2\dot\theta"),
            ("energy H", r"H = \frac{p^2}{2 m l^2} - m g l\cos\theta - u_0\theta"),
            ("identity", r"\dot\theta = \frac{\partial H}{\partial p}"),
            ("identity", turned),
            ("identity", turned.replace("= -", "= ")),
            ("definition", r"x = l\sin\theta, \quad y = -l\cos\theta"),
            ("identity", rf"m\ddot x = -\lambda x + {drawn}\cos\theta"),
            ("identity", rf"m\ddot y = -m g - \lambda y + {drawn}\sin\theta"),
            ("identity", r"\lambda l = m l\dot\theta^2 + m g\cos\theta"),
            ("identity", r"\lambda l = m l\dot\theta^2 - m g\cos\theta"),
            renamed={r"\lambda": "multiplier"},
        )
    ]
    hamilton = ["definition", *["confirmed"] * 3, "misprint"]
    assert statuses == [*hamilton, *["definition"] * 2, *["confirmed"] * 2, "misprint"]
