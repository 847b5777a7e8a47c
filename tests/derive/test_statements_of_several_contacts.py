"""Printed equations of pages with several contacts, written by hand, and with planted faults."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

pytest.importorskip("sympy")

from spragsym.derive import pages
from spragsym.derive.statements import verdicts
from tests.oracles.printed import rows

NAMES = {r"\mu_u": "mu_upper", r"\mu_l": "mu_lower", "N_u": "N_upper", "N_l": "N_lower"}
#: The moments of both faces of the disc, and its balance across where both touch.
TILTS = r"J \ddot\phi + k_t \phi = (h - y) \mu_u N_u - (h + y) \mu_l N_l"
ACROSS = "(k_y + 2*k_c)*y + 2*mu0*N_0*phi"


@cache
def _page(name: str) -> pages.PageModel:
    return pages.read(pages.SHIPPED / f"{name}.py")


def _judged(about: str, text: str, name: str = "disc_between_pads") -> verdicts.Row:
    (row,) = rows(_page(name), (about, text), renamed=NAMES)
    return row


@pytest.mark.parametrize(
    ("about", "text"),
    [
        ("motion phi", TILTS),
        ("gap lower", "gap_lower = y - N_0/k_c"),
        ("normal upper", "N_upper = N_0 + k_c*y"),
        ("normal upper, contact of lower alone", "N_upper = 0"),
        ("normal lower, both", "N_lower = pushing_lower*(N_0 - k_c*y)"),
        ("equilibrium y", ACROSS),
        ("equilibrium y, contact of upper alone", "k_y*y + (1 + mu0*phi)*(N_0 + k_c*y)"),
        ("equilibrium y, lift-off", "y = 0"),
        ("stiffness 2 1, contact of lower alone", "K_21 = mu0*(N_0 - k_c*(h + 2*y))"),
        (
            "threshold flutter",
            "16*mu0**2*N_0*(h*k_c - N_0) = m*J*((k_y + 2*k_c)/m - k_t/J)**2",
        ),
    ],
)
def test_what_is_derived_of_two_faces_by_hand_is_confirmed(about: str, text: str) -> None:
    assert _judged(about, text).status == "confirmed"


def test_a_friction_that_holds_slides_in_accelerations() -> None:
    """Of two blocks, whose frictions are dry: forces over masses, with μ N of each."""
    right = "ax_2 = (mu_second*N_2 - k_2*x_2 + k_12*(x_1 - x_2))/m_2"
    assert _judged("acceleration x_2", right, "two_blocks").status == "confirmed"
    wrong = _judged("acceleration x_2", right.replace("mu_second", "mu_first"), "two_blocks")
    assert (wrong.status, wrong.edits[0]["new"]) == ("misprint", "mu_second")


@pytest.mark.parametrize(
    ("about", "right", "wrong", "new"),
    [
        ("motion phi", TILTS, (r"\mu_l N_l", r"\mu_u N_l"), "mu_lower"),
        ("motion phi", TILTS, ("N_u - (", "N_u + ("), "-"),
        (
            "normal lower, both",
            "N_lower = pushing_lower*(N_0 - k_c*y)",
            ("pushing_lower", "pushing_upper"),
            "pushing_lower",
        ),
        ("equilibrium y", ACROSS, ("2*k_c", "k_c"), "2*k_c"),
    ],
)
def test_a_planted_fault_is_a_misprint(
    about: str, right: str, wrong: tuple[str, str], new: str
) -> None:
    """One edit, and it is the planted one; where both touch is not where one does."""
    before, after = wrong
    row = _judged(about, right.replace(before, after))
    assert (row.status, len(row.edits)) == ("misprint", 1), row.evidence
    assert new in str(row.edits[0]["new"])


def test_a_force_of_one_face_is_none_where_the_other_touches() -> None:
    said = _judged("equilibrium y, contact of upper alone", ACROSS)
    assert said.status not in ("confirmed", "definition")


@pytest.mark.parametrize(
    ("about", "name", "says"),
    [
        ("normal left", "disc_between_pads", "no contact of the page; name upper, lower"),
        ("normal", "disc_between_pads", "no contact of the page; name upper, lower"),
        ("normal upper", "kang_nam", "name the only one"),
        ("motion y, contact of both", "disc_between_pads", "contact of upper alone"),
        ("gap first", "two_blocks", "has no gap"),
        ("pushing first", "two_blocks", "can't open"),
        ("motion x_1, lift-off", "two_blocks", "no side of the contacts"),
        ("equilibrium x", "forced_oscillator", "nothing rests"),
    ],
)
def test_an_object_that_the_page_lacks_is_refused_with_the_remedy(
    about: str, name: str, says: str
) -> None:
    row = _judged(about, "0 = 0", name)
    assert row.status == "unread"
    assert says in row.evidence


STOPS = '''"""A mass between two stops."""
from spragsym.derive.model import Page
page = Page("A mass on a spring between two elastic stops.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "spring")
b = page.unit("b", "m", "clearance")
k_s = page.parameter("k_s", "N/m", "stop", "> 0", 20.0, becomes="kappa")
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.contact(b - x, lambda depth: k_s * depth, name="right")
page.contact(b + x, lambda depth: k_s * depth, name="left")
'''
BOTH = r"k_s\max(x - b, 0) - k_s\max(-x - b, 0)"
OPENS = r"\begin{cases} -k_s(x + b), & x < -b\\ 0, & \text{otherwise}\end{cases}"
CASES = (
    r"\begin{cases} k_s(x - b), & x > b,\\ 0, & -b \le x \le b,\\ k_s(x + b), & x < -b\end{cases}"
)


@pytest.mark.thorough
def test_stops_that_face_each_other_never_touch_at_once(tmp_path: Path) -> None:
    """What is printed is judged where one of them touches or none, by hand."""
    (tmp_path / "page.py").write_text(STOPS)
    page = pages.read(tmp_path / "page.py")
    prints = (
        ("motion x, both", rf"m\ddot x + kx + {BOTH} = 0", "confirmed"),
        ("motion x, both", rf"m\ddot x + kx + {CASES} = 0", "confirmed"),
        ("motion x", r"m\ddot x + kx + N_R - N_L = 0", "confirmed"),
        ("motion x", r"m\ddot x + kx + N_R + N_L = 0", "misprint"),
        ("motion x, both", rf"m\ddot x + kx + {BOTH} = 0".replace("- k_s", "+ k_s"), "misprint"),
        ("motion x, both", rf"m\ddot x + kx + {CASES} = 0".replace("x + b", "x - b"), "misprint"),
        ("normal right", r"N_R = k_s\langle x - b\rangle", "confirmed"),
        ("normal left", r"N_L = k_s\langle x + b\rangle", "misprint"),
        ("normal left", rf"N_L = {OPENS}", "confirmed"),
        ("normal left", rf"N_L = {OPENS}".replace("x < -b", "x < b"), "misprint"),
        ("pushing right", r"n_R = \begin{cases} 1, & x \ge b\\ 0, & x < b\end{cases}", "confirmed"),
        ("stiffness 1 1, contact of left alone", r"k_e = k + k_s", "confirmed"),
        ("motion x, contact", r"m\ddot x + kx = 0", "unread"),
    )
    found = rows(
        page, *(it[:2] for it in prints), renamed={"N_R": "N_right", "N_L": "N_left"}, form="units"
    )
    assert [it.status for it in found] == [it[2] for it in prints]
    assert "contact of right alone" in found[-1].evidence


@pytest.mark.parametrize(
    "text",
    [
        r"N_f - N_r = \frac{\mu_0 h F - k_t\phi}{a}",
        r"N_f = \frac F2 + \frac{\mu_0 h F - k_t\phi}{2a}",
        r"N_r = \frac F2\left(1 - \frac{\mu_0 h}{a}\right) + \frac{k_t\phi}{2a}",
    ],
)
def test_forces_on_the_legs_follow_from_two_equations(text: str) -> None:
    """By hand: N_f + N_r = F, and k_t φ + a (N_f − N_r) = μ h F."""
    renamed = {"N_f": "N_front", "N_r": "N_rear", r"\mu_0": "mu0"}
    prints = [("equilibrium phi", it) for it in (text, text.replace("k_t", "2k_t"))]
    found = rows(_page("pad_on_legs"), *prints, renamed=renamed)
    assert [it.status == "confirmed" for it in found] == [True, False]


LADDER = '''"""A ladder that slides."""
from spragsym.derive.model import Page, cos, sgn, sin
page = Page("A ladder on a moving floor, held upright by a torsion spring.")
m = page.unit("m", "kg", "mass")
l = page.unit("l", "m", "half of the length")
g = page.unit("g", "m/s^2", "gravity")
J = page.parameter("J", "kg m^2", "inertia", "> 0", 0.33)
k = page.parameter("k", "N m", "torsion spring", "> 0", 0.5, becomes="kappa")
c_n = page.parameter("c_n", "N/m", "floor", "> 0", 50.0, becomes="gamma")
V = page.parameter("V", "m/s", "speed of the floor", "> 0", 1.0)
mu_d = page.parameter("mu_d", "1", "friction", ">= 0", 0.3)
x = page.coordinate("x", "m", "centre")
y = page.coordinate("y", "m", "centre")
phi = page.coordinate("phi", "rad", "angle from the vertical")
page.kinetic((m * (page.rate(x) ** 2 + page.rate(y) ** 2) + J * page.rate(phi) ** 2) / 2)
page.potential(m * g * y + k * phi**2 / 2)
page.contact(y - l * cos(phi), lambda depth: c_n * depth)
page.friction(x - l * sin(phi), V, slip=lambda v: mu_d * sgn(v), holds=mu_d)
'''
MOMENT = r"J\ddot\phi + k\phi = "


@pytest.mark.parametrize(
    ("right", "old", "new"),
    [
        (r"m(\ddot y + g)l(\sin\phi - \mu\cos\phi)", "- \\mu", "+ \\mu"),
        (r"ml\left[(\ddot y + g)\sin\phi - \ddot x\cos\phi\right]", r"\ddot x", r"\dot x"),
    ],
)
def test_a_normal_force_is_eliminated_by_a_factor_of_the_state(
    right: str, old: str, new: str, tmp_path: Path
) -> None:
    """From the moments about the centre, by N = m (y″ + g) and μ N = m x″; a fault is mended."""
    (tmp_path / "page.py").write_text(LADDER)
    page = pages.read(tmp_path / "page.py")
    faulty = right.replace(old, new)
    prints = [("motion phi", MOMENT + it) for it in (right, faulty)]
    one, other = rows(page, *prints)
    assert (one.status, other.status) == ("confirmed", "misprint")
    assert "eliminate N" in one.evidence
    assert (len(other.edits), other.repaired) == (1, one.read)
