"""Derivatives that a paper prints, conditions beside an equation, and equations with several signs
of equality: what is judged, and what is refused.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from spragsym.derive import pages
from spragsym.derive.statements import reading, verdicts
from tests.oracles.printed import paper, rows

PAGE = pages.read(Path(__file__).parents[2] / "validation/papers/falling_friction/page.py")
CART = pages.read(Path(__file__).parents[2] / "validation/papers/cart_pole/page.py")
SPEED = {"v": "v_0 - x'", "w": "x' - v_0"}


def _only(text: str, about: str = "motion x") -> verdicts.Row:
    return rows(PAGE, (about, text), renamed=SPEED)[0]


@pytest.mark.parametrize(("print_", "order"), [(r"\mu'(v)", 1), (r"\mu''(w)", 2)])
@pytest.mark.parametrize("about", ["motion x", "damping 1 1"])
def test_the_slope_of_a_friction_law_is_that_of_the_law(
    print_: str, order: int, about: str
) -> None:
    """In a motion on either side of the belt's speed, and at steady sliding: by differences."""
    _, (item,) = reading.read_paper(paper([(about, f"{print_} = 0")], SPEED), PAGE)
    assert isinstance(item, reading.Item)
    at = item.values
    speed = at["v_0"] - at["vx"] if about == "motion x" else at["v_0"]

    def law(v: np.ndarray) -> np.ndarray:
        size = at["mu_m"] + (at["mu_s"] - at["mu_m"]) * np.exp(-np.abs(v) / at["v_s"])
        return np.sign(v) * size

    step = 1e-4
    ahead, here, behind = (law(speed + way * step) for way in (1, 0, -1))
    slope = (ahead - behind) / (2 * step) if order == 1 else (ahead - 2 * here + behind) / step**2
    far = np.abs(speed) > 2 * step
    name = "diff(mu)" if order == 1 else "diff(diff(mu))"
    sign = -1 if "w" in print_ else 1
    assert sign * at[name][far] == pytest.approx(sign * slope[far], rel=1e-4, abs=1e-4)


def test_sizes_spaces_and_braces_change_no_name() -> None:
    """An argument in brackets of any size, spaces before =, and an order in braces."""
    energy = r"U\left(x\right) \,= \frac{k x^2}{2} + \frac{k_3 x^4}{4}"
    slope = r"k_t = \frac{\mathrm{d}^{2}U}{\mathrm{d}x^{2}}"
    kinetic = r"T(x, \dot x) = \frac{m}{2} \dot x^2"
    found = rows(PAGE, ("energy V", energy), ("stiffness 1 1", slope), ("energy T", kinetic))
    assert [row.status for row in found] == ["confirmed"] * 3


@pytest.mark.parametrize(
    ("text", "status"),
    [
        (r"m\ddot x + c\dot x + kx + k_3x^3 = N_0\mu(v)", "confirmed"),
        (r"m\ddot x + c\dot x + kx + k_3x^3 = -N_0\mu(w)", "confirmed"),
        (r"m\ddot x + c\dot x + kx + k_3x^3 = N_0\mu(w)", "convention"),
        (r"m\ddot x + c\dot x + kx + k_3x^3 = N_0\mu(v_0)", "misprint"),
        (r"m\ddot x + c\dot x + kx + k_3x^3 = N_0\mu(x)", "unread"),
        (r"(m\ddot x + c\dot x + kx + k_3x^3)/N_0 = \mu(x)", "unread"),
        (r"(m\ddot x + c\dot x + kx + k_3x^3)/N_0 = \mu(v)", "confirmed"),
    ],
)
def test_the_argument_of_a_friction_law_is_read(text: str, status: str) -> None:
    """The sliding speed, minus it of an odd law, and the speed at rest, which is no other."""
    assert _only(text).status == status


@pytest.mark.parametrize(
    ("text", "about", "status"),
    [
        (r"T = \frac12 m\dot x^2 = m\frac{\dot x^2}{2}", "energy T", "confirmed"),
        (r"T = m\dot x^2 = m\frac{\dot x^2}{2}", "energy T", "misprint"),
        (r"2T = m\dot x^2", "energy T", "confirmed"),
        (r"2T = \frac12 m\dot x^2", "energy T", "misprint"),
        (r"R = m\ddot x + c\dot x + kx + k_3x^3 - N_0\mu = 0", "motion x", "confirmed"),
        (r"\dot x = \dot x, m\ddot x + c\dot x + kx + k_3x^3 = N_0\mu", "motion x", "confirmed"),
        (
            r"m\ddot x + c{\dot x} + {k}x + k_3x^3 = N_0{\mu(w)}, \dot x = \dot x",
            "motion x",
            "convention",
        ),
        (r"m\ddot x + c\dot x + kx + k_3x^3 = N_0{\mu}, \dot x = \dot x", "motion x", "confirmed"),
        (r"\dot x = 2x, m\ddot x + c\dot x + kx + k_3x^3 = N_0\mu", "motion x", "failed"),
    ],
)
def test_every_equation_of_a_print_is_judged(text: str, about: str, status: str) -> None:
    """But for a name that is given to what follows, and for what holds of any state."""
    assert _only(text, about).status == status


def test_a_name_that_is_defined_elsewhere_is_no_new_one() -> None:
    """What is printed of it beside an equation has to be what it is."""
    motion = r"m\ddot x + c\dot x + kx + k_3x^3 = N_0\mu"
    texts = [
        ("definition", r"p = m\dot x"),
        ("motion x", rf"p = m\dot x, \quad {motion}"),
        ("motion x", rf"p = 2m\dot x, \quad {motion}"),
    ]
    assert [it.status for it in rows(PAGE, *texts, renamed=SPEED)] == [
        "definition",
        "confirmed",
        "failed",
    ]


@pytest.mark.parametrize(
    ("condition", "about", "status"),
    [
        (r"\dot x < v_0", "motion x, belt ahead", "confirmed"),
        (r"\text{for } v > 0", "motion x, belt ahead", "confirmed"),
        (r"t > 0", "motion x, belt ahead", "confirmed"),
        (r"\dot x < v_0", "motion x", "unread"),
        (r"\dot x > v_0", "motion x, belt ahead", "unread"),
        (r"u > 0", "motion x, belt ahead", "unread"),
    ],
)
def test_a_condition_beside_an_equation_has_to_hold_where_it_is_judged(
    condition: str, about: str, status: str
) -> None:
    """Or the refusal says how a side is named."""
    law = r"N_0[\mu_m + (\mu_s - \mu_m)e^{-v/v_s}]"
    row = _only(rf"m\ddot x + c\dot x + kx + k_3x^3 = {law}, \quad {condition}", about)
    assert row.status == status
    assert status == "confirmed" or "say" in row.evidence


def test_a_relation_behind_an_equation_is_a_condition() -> None:
    """As in N = -k y > 0, which says a value and where it is one."""
    value = r"c_e = c + N_0\mu'(v_0)"
    for relation, status in (("< -9c", "unread"), (r"= c + N_0\mu'(v_0) \ne 0", "confirmed")):
        assert _only(f"{value} {relation}", "damping 1 1").status == status
    wrong = f"{value} = c - N_0\\mu'(v_0) \\ne 0"
    assert _only(wrong, "damping 1 1").status == "misprint"


def test_a_value_of_another_name_is_not_that_of_the_object() -> None:
    """Two scales in one statement about one of them."""
    text = r"\omega_1 = \sqrt{k/m}\,t, \qquad \omega_2 = \frac{c}{m}"
    row = _only(text, "scale time")
    assert (row.status, "other statements" in row.evidence) == ("unread", True)


@pytest.mark.parametrize(
    ("slope", "status"),
    [
        (r"\left.\frac{d\mu}{dv}\right|_{v=v_0}", "confirmed"),
        (r"\left.\left(\frac{d\mu(v)}{dv}\right)\right\vert_{v=v_0}", "confirmed"),
        (r"\mu'\big|_{v=v_0}", "confirmed"),
        (r"\mu'|_{v_0}", "confirmed"),
        (r"\left[\frac{d\mu}{dv}\right]_{v \to v_0}", "confirmed"),
        (r"\frac{d\mu}{dv}(v_0)", "confirmed"),
        (r"2\frac{d\mu}{dv}(v_0)", "misprint"),
        (r"\left.\mu\right|_{v=v_0}", "failed"),
        (r"\left.\frac{d\mu}{dv}\right|_{v=v_s}", "unread"),
        (r"\left.\frac{d\mu}{dv}\right|_{x=v_0}", "unread"),
        (r"\left.x\frac{d\mu}{dv}\right|_{v=v_0}", "unread"),
        (r"\frac{d\mu}{dv}(v_s + x)", "unread"),
    ],
)
def test_a_slope_is_taken_at_the_point_that_is_printed(slope: str, status: str) -> None:
    """Of the sliding speed at rest; at another point, or of another quantity, it is none."""
    assert _only(f"c_e = c + {slope}N_0", "damping 1 1").status == status


def test_a_value_at_a_point_is_that_of_what_moves() -> None:
    """Of a coordinate by the number there; what is constant stays, and what may not is refused."""
    found = rows(
        PAGE,
        ("energy V", r"U = kx^2/2 + k_3x^4/4"),
        ("stiffness 1 1", r"\left. k\dot x/\dot x + 3k_3x^2\right|_{\dot x = 1}"),
        ("stiffness 1 1", r"\left. k + 3k_3x^2\right|_{x = 0}"),
        ("stiffness 1 1", r"\left. \frac{d^2U}{dx^2}\right|_{x = 0}"),
        ("stiffness 1 1", r"\left. k + 3k_3x^2\right|_{k = 0}"),
    )
    assert [it.status for it in found] == ["confirmed", "confirmed", "unread", "unread", "unread"]
    assert "right at x = 0 alone" in found[2].evidence


def test_a_law_of_another_speed_is_read_again_as_one_of_the_sliding_speed() -> None:
    """Of an angular speed over a radius: what is read is the slope by the sliding speed times R."""
    folder = Path(__file__).parents[2] / "validation/papers/drill_string"
    page, renamed = pages.read(folder / "page.py"), {r"\omega": "Omega + phi_b'"}
    law = r"[\mu_{cb} + (\mu_{sb} - \mu_{cb})e^{-\nu_f R_b|\omega|}]\operatorname{sgn}\omega"
    friction = ("friction", rf"\mu(\omega) = {law}")
    slope = ("damping 2 2", r"c_{22} = c_b + c_t + W R_b\mu'(\Omega)")
    other = ("motion phi_b", r"J_b\ddot\varphi_b = \mu(R_b\omega)")
    found = rows(page, friction, slope, other, renamed=renamed | {r"\varphi_b": "phi_b"})
    assert [it.status for it in found] == ["confirmed", "confirmed", "unread"]
    assert "neither its sliding speed nor the argument" in found[2].evidence
    (again,) = rows(page, ("damping 2 2", found[1].read), is_latex=False)
    assert again.status == "confirmed"


def test_a_derivative_changes_sign_with_a_coordinate_that_is_reversed() -> None:
    """∂V/∂x is a force along x of the print, and f(x) is printed in it."""
    prints = [
        ("energy V", "U = kx^2/2 + k_3x^4/4"),
        ("motion x", r"m\ddot x + c\dot x + \frac{\partial U}{\partial x} + N_0\mu = 0"),
        ("definition", "f(x) = kx + k_3x^3"),
        ("motion x", r"m\ddot x + c\dot x + f(x) = -N_0\mu"),
        ("acceleration x", r"\ddot x = -\frac1m\frac{d}{dt}(c x) - f(x)/m - N_0\mu/m"),
        ("stiffness 1 1", "k_t = f'(x)"),
    ]
    found = verdicts.check(paper(prints, conventions={"x": "reversed"}), PAGE).rows
    assert [it.status for it in found] == ["confirmed"] * 2 + ["definition"] + ["confirmed"] * 3


def test_an_energy_counts_what_its_own_print_counts() -> None:
    """A constant force is in the potential that is printed with it, and in no other."""
    motion = r"\frac{d}{dt}\frac{\partial T}{\partial\dot x} + \frac{\partial V}{\partial x} = "
    kinetic = r"T = \frac12(m_c + m_p)\dot x^2 + m_pl\dot x\dot\theta\cos\theta + \frac12m_pl^2\dot\theta^2"
    for potential, force in ((r"-m_pgl\cos\theta", "f"), (r"-m_pgl\cos\theta - fx", "0")):
        texts = (
            ("energy V", f"V = {potential}"),
            ("energy T", kinetic),
            ("motion x", motion + force),
        )
        found = rows(CART, *texts)
        assert [it.status for it in found] == ["confirmed"] * 3
    words = {"V": "energy V", "T": "energy T"}
    (row,) = rows(CART, ("motion x", motion + "f"), renamed=words)
    assert "may count the potential of a constant force" in row.evidence
    (row,) = rows(
        CART, ("mass 1 1", r"M_{11} = \frac{\partial^2T}{\partial\dot x^2}"), renamed=words
    )
    assert row.status == "confirmed"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (r"\frac{\partial N}{\partial x} = 0", "holds N"),
        (r"\frac{\partial m}{\partial (x + m)} = 0", "which is no name"),
        (r"\frac{\partial (m x)}{\partial m} = 0", "no name; define it"),
        (r"\frac{\partial^2 m}{\partial x} = 0", "of this order"),
        (r"\frac{\partial m}{\partial N} = 0", "no coordinate, rate or parameter"),
        (r"\frac{\partial N}{\partial t} = 0", r"print \frac{d}{dt}"),
        (r"\frac{d}{dt}\ddot x = 0", "the rate of"),
        (r"\dot\mu = 0", "holds mu"),
    ],
)
def test_a_derivative_that_can_not_be_told_is_refused(text: str, said: str) -> None:
    """In words that name what stands in its way."""
    row = _only(text)
    assert row.status == "unread"
    assert said in row.evidence


def test_a_first_order_system_is_judged_entry_by_entry() -> None:
    """A of z′ = A z, of which a sign in one entry is found."""
    right = r"A = \begin{bmatrix}0 & 1\\ -\frac{k + 3k_3x^2}{m} & -\frac{c + N_0\mu'(v_0)}{m}\end{bmatrix}"
    assert _only(right, "system").status == "confirmed"
    row = _only(right.replace("{c + N_0", "{c - N_0"), "system")
    assert row.status == "misprint"
    assert [edit["kind"] for edit in row.edits] == ["sign"]


def test_a_derivative_by_another_coordinate_is_an_index() -> None:
    """As a term copied from the equation before."""
    kinetic = r"T = \frac12(m_c + m_p)\dot x^2 + m_pl\dot x\dot\theta\cos\theta + \frac12m_pl^2\dot\theta^2"
    left = r"\frac{d}{dt}\frac{\partial T}{\partial\dot\theta} - \frac{\partial T}{\partial x}"
    found = rows(CART, ("energy T", kinetic), ("motion theta", left + r" + m_pgl\sin\theta = 0"))
    assert found[1].repaired.startswith("diff(diff(T, vtheta), t) - diff(T, theta) +")
    assert [edit["kind"] for edit in found[1].edits] == ["index"]


def test_what_is_read_can_be_read_again() -> None:
    """Names of derivatives are those in which they may be written in SymPy's syntax."""
    texts = [
        ("energy V", "U(x) = kx^2/2 + k_3x^4/4"),
        ("definition", "f(x) = kx + k_3x^3"),
        ("stiffness 1 1", "k_t = f'(x) + (U''(x) - f'(x))/2"),
        ("damping 1 1", r"c_e = c + N_0\mu'(v_0)"),
        ("motion x", r"m\ddot x + c\dot x + \frac{dU}{dx} - N_0\mu(v_0) = N_0(\mu(v) - \mu(v_0))"),
        ("motion x", r"m\ddot x + c\dot x + \frac{d}{dt}(\frac{x}{1 + x^2}) = 0"),
    ]
    found = rows(PAGE, *texts, renamed=SPEED)
    assert [it.status for it in found] == ["confirmed", "definition", *["confirmed"] * 3, "failed"]
    assert "at_rest(mu)" in found[4].read
    others = rows(PAGE, *((it.about, it.read) for it in found))
    assert [it.status for it in others] == [it.status for it in found]


def test_a_derivative_of_one_form_does_not_hinder_statements_in_the_other() -> None:
    """By a unit of the page, which is no number of its scaled form."""
    found = rows(
        PAGE,
        ("energy V", r"U = \frac{kx^2}{2} + k_3x^4/4"),
        ("definition", r"q = \frac{\partial U}{\partial k}"),
        ("motion x", "ax + c*vx + x + kappa_3*x**3 - mu", {"form": "scaled", "is_latex": False}),
    )
    assert [it.status for it in found] == ["confirmed", "definition", "confirmed"]


def test_a_law_beside_its_speed_is_judged() -> None:
    """What holds of every state is left out, and not the law, which is right."""
    law = r"\mu(v) = \operatorname{sgn}(v)\left[\mu_m + (\mu_s - \mu_m)e^{-|v|/v_s}\right]"
    for text, status in ((law, "confirmed"), (law.replace("- \\mu", "+ \\mu"), "misprint")):
        assert _only(rf"{text}, \qquad v = v_0 - \dot x", "friction").status == status


def test_lagrange_s_equation_of_an_expression() -> None:
    """As it is printed without a name for the energies; the misprint is found inside."""
    kinetic = (
        r"\frac12(m_c + m_p)\dot x^2 + m_pl\dot x\dot\theta\cos\theta + \frac12m_pl^2\dot\theta^2"
    )
    text = (
        rf"\frac{{d}}{{dt}}\left[\frac{{\partial}}{{\partial\dot\theta}}\left({kinetic}\right)\right]"
        rf" - \frac{{\partial}}{{\partial\theta}}\left[{kinetic} + m_pgl\cos\theta\right] = 0"
    )
    faulty = text.replace(r"\frac12m_pl^2", r"\frac13m_pl^2")
    for print_, status in ((text, "confirmed"), (faulty, "misprint")):
        (row,) = rows(CART, ("motion theta", print_))
        assert row.status == status


@pytest.mark.thorough
def test_an_equation_of_motion_in_matrices_that_are_printed_beside_it() -> None:
    """With their arguments, and Lagrange's equation by the column of all coordinates."""
    mass = r"\begin{bmatrix} m_c + m_p & m_pl\cos\theta\\ \mathrm{sym.} & m_pl^2\end{bmatrix}"
    forces = r"\begin{bmatrix} -m_pl\dot\theta^2\sin\theta\\ m_pgl\sin\theta\end{bmatrix}"
    whole = (
        rf"\mathbf M(\mathbf q)\ddot{{\mathbf q}} + \mathbf h(\mathbf q, \dot{{\mathbf q}}) = (f, 0)^{{\mathrm T}},"
        rf"\quad \mathbf h = {forces}"
    )
    lagrange = (
        r"\frac{d}{dt}\frac{\partial L}{\partial\dot{\mathbf q}} - \frac{\partial L}{\partial\mathbf q}"
        r" = \begin{bmatrix} f\\ 0\end{bmatrix}"
    )
    energy = r"L = \frac12(m_c + m_p)\dot x^2 + m_pl\dot x\dot\theta\cos\theta + \frac12m_pl^2\dot\theta^2 + m_pgl\cos\theta"
    prints = (
        ("mass", rf"\mathbf M(\mathbf q) = {mass}"),
        ("motion", whole),
        ("energy L", energy),
        ("motion", lagrange),
        ("motion", whole.replace("+ \\mathbf h", "- \\mathbf h")),
        ("motion", lagrange.replace("f\\\\ 0", "0\\\\ f")),
    )
    found = rows(CART, *prints, renamed={"\\mathbf{q}": "coordinates"})
    assert [it.status for it in found[:4]] == ["confirmed"] * 4
    assert not {it.status for it in found[4:]} & {"confirmed", "unread"}


@pytest.mark.thorough
def test_an_equation_of_motion_is_divided_by_its_mass(tmp_path: Path) -> None:
    """Which depends on the coordinates: m r² + J of a pendulum whose length changes."""
    page = tmp_path / "page.py"
    page.write_text(
        '''"""A pendulum of changing length."""
from spragsym.derive.model import Page, cos
page = Page("A pendulum whose length changes.")
m = page.unit("m", "kg", "mass")
g = page.unit("g", "m/s^2", "gravity")
l = page.unit("l", "m", "length")
J = page.parameter("J", "kg m^2", "inertia", "> 0", 0.3)
k = page.parameter("k", "N/m", "spring", "> 0", 2.0)
r = page.coordinate("r", "m", "length")
a = page.coordinate("a", "rad", "angle")
page.kinetic((m * page.rate(r) ** 2 + (J + m * r**2) * page.rate(a) ** 2) / 2)
page.potential(k * (r - l) ** 2 / 2 - m * g * r * cos(a))
'''
    )
    text = r"\ddot a = -\frac{m r}{J + m r^2}\left(2\dot r\dot a + g\sin a\right)"
    for print_, status in ((text, "confirmed"), (text.replace(r"2\dot", r"3\dot"), "misprint")):
        (row,) = rows(pages.read(page), ("motion a", print_))
        assert row.status == status
    assert row.repaired


def test_a_quantity_of_the_page_may_be_called_t(tmp_path: Path) -> None:
    """As a thickness: it is no time, of which nothing else is there."""
    source = Path(__file__).parents[2] / "validation/papers/stick_slip/page.py"
    page = tmp_path / "page.py"
    page.write_text(source.read_text().replace('k = page.unit("k"', 'k = page.unit("t"'))
    text = r"m\ddot x + d\dot x + t x = \mu N"
    for printed_one, status in ((text, "confirmed"), (text.replace("+ t x", "+ m x"), "misprint")):
        (row,) = rows(pages.read(page), ("motion x", printed_one))
        assert row.status == status
