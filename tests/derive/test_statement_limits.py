"""Prints that hold in a limit: every entry is judged, and what is wrong is repaired in the limit."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("sympy")

from spragsym.derive import pages
from spragsym.derive.kang_nam import ledger
from spragsym.derive.statements import verdicts
from tests.oracles.printed import rows

PENDULUM = pages.read(
    Path(__file__).parents[2] / "validation" / "papers" / "double_pendulum" / "page.py"
)
RENAMED = {r"\varphi_1": "theta_1", r"\varphi_2": "theta_2"}
SMALL = r"\begin{bmatrix} (m_1 + m_2) L_1^2 & m_2 L_1 L_2 \\ m_2 L_1 L_2 & m_2 L_2^2 \end{bmatrix}"
AT_REST = {"limit": "theta_1, theta_2 -> 0"}


def _row(about: str, text: str, **more: str) -> verdicts.Row:
    (row,) = rows(PENDULUM, (about, text, more), renamed=RENAMED)
    return row


def test_entries_behind_an_approximation_are_judged() -> None:
    """The mass matrix of small angles, whose last entry is wrong, is none."""
    assert _row("mass", rf"\mathbf{{M}}_0 = {SMALL}", **AT_REST).status == "approximation"
    wrong = SMALL.replace(r"m_2 L_2^2 \end", r"m_1 L_2^2 \end")
    row = _row("mass", rf"\mathbf{{M}}_0 = {wrong}", **AT_REST)
    assert (row.status, [it["kind"] for it in row.edits]) == ("misprint", ["index"])
    assert row.repaired_latex == rf"\mathbf{{M}}_0 = {SMALL}".replace(
        r"m_2 L_2^2 \end", r"m_{2} L_2^2 \end"
    )


@pytest.mark.thorough
def test_rates_are_small_with_their_angles() -> None:
    """θ₂′² sin(θ₁ − θ₂) is of third order where angles swing, and what is wrong is repaired."""
    right = r"(m_1 + m_2) (L_1\ddot\varphi_1 + g\varphi_1) + m_2 L_2\ddot\varphi_2 = 0"
    row = _row("motion theta_1", right, limit="linear in theta_1, theta_2")
    assert row.status == "approximation"
    for old, new in (("+ g", "- g"), ("L_2", "L_1")):
        row = _row("motion theta_1", right.replace(old, new), limit="linear in theta_1, theta_2")
        assert row.status == "misprint"
        assert "in the limit linear in theta_1, theta_2" in row.evidence
        assert row.repaired_latex.replace("_{2}", "_2").replace("+  g", "+ g") == right


@pytest.mark.thorough
def test_a_friction_that_falls_as_a_power_has_its_limit(tmp_path: Path) -> None:
    """∂μ/∂x′ = μ₀ d/(1 + d V)² is left out of (27) for d V → ∞, as the article's exponential is."""
    text = (pages.SHIPPED / "kang_nam.py").read_text(encoding="utf-8")
    old = "mu0 * (1 - exp(-d * Abs(v))) * sgn(v)"
    assert old in text
    path = tmp_path / "rational.py"
    path.write_text(text.replace(old, "mu0 * d * v / (1 + d * Abs(v))"), encoding="utf-8")
    judged = {row.id: row.status for row in ledger.judge(pages.read(path))}
    assert (judged["eq-12"], judged["eq-27"], judged["eq-10"]) == ("holds", "holds", "fails")


CART = pages.read(Path(__file__).parents[2] / "validation" / "papers" / "cart_pole" / "page.py")
UP = r"""\begin{bmatrix} 0 & 1 & 0 & 0 \\ 0 & 0 & \frac{m_p g}{m_c} & 0 \\ 0 & 0 & 0 & 1 \\
    0 & 0 & \frac{(m_c + m_p) g}{m_c l} & 0 \end{bmatrix}"""
STATES = r"\begin{bmatrix} x \\ \dot x \\ \theta \\ \dot\theta \end{bmatrix}"


@pytest.mark.parametrize(
    ("about", "text", "limit", "old", "new"),
    [
        # What is small to first order has small rates, and its cosine may be kept.
        (
            "motion x",
            r"(m_c + m_p)\ddot x + m_p l\ddot\theta\cos\theta = f",
            "linear in theta",
            "+ m_p l",
            "- m_p l",
        ),
        # About the state upright, the states in any order, stated or not.
        ("system", rf"\mathbf A = {UP}", "x -> 0, theta -> pi", "{m_p g}{m_c}", "{m_c g}{m_c}"),
        (
            "acceleration theta",
            r"\ddot\theta = \frac{g}{l}(\theta - \pi) + \frac{\ddot x}{l}",
            "linear in theta - pi",
            "- \\pi",
            "+ \\pi",
        ),
    ],
)
def test_a_limit_is_read_as_papers_mean_it(
    about: str, text: str, limit: str, old: str, new: str
) -> None:
    """Right to first order with what is of higher order in it, and a fault is found."""
    defined = ("definition", rf"\mathbf z = {STATES}", {"limit": ""})
    found = rows(CART, (about, text), (about, text.replace(old, new, 1)), limit=limit)
    assert [it.status for it in found] == ["approximation", "misprint"], found
    assert rows(CART, defined, (about, text), limit=limit)[1].status == "approximation"


def test_a_column_of_states_has_rates_and_its_order_is_kept() -> None:
    """z' = A z of z = (x, x', theta, theta') is none of (theta, theta', x, x')."""
    column = r"\begin{bmatrix} 0 \\ \frac{1}{m_c} \\ 0 \\ \frac{1}{m_c l} \end{bmatrix}"
    motion = rf"\dot{{\mathbf z}} = {UP}\mathbf z + {column} f"
    turned = STATES.replace(" x ", " X ").replace(r"t x", r"t X").replace(r"\theta", "x")
    for states, status in ((STATES, "approximation"), (turned.replace("X", r"\theta"), "unread")):
        *_, row = rows(
            CART,
            ("definition", rf"\mathbf z = {states}", {"limit": ""}),
            ("acceleration", motion),
            limit="linear in x, theta",
            conventions={"theta": "theta - pi"},
        )
        assert row.status == status
    names = ("definition", r"q_1 = x, \quad q_2 = \dot x, \quad T_1 = m_c, \quad T_2 = m_p")
    law = r"(T_1 + T_2)\dot q_2 + T_2 l\ddot\theta\cos\theta - m_p l\dot\theta^2\sin\theta = f"
    assert rows(CART, names, ("motion x", law))[1].status == "confirmed"
