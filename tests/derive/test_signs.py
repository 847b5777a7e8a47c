"""Signs over whole domains: what is proved is nowhere negative, and what is not has a witness, drawn
at random.
"""

from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from spragsym.derive import pages, signs
from spragsym.derive.model import PageError
from tests.oracles.user_pages import shipped_page

pytestmark = pytest.mark.thorough

PARAMETERS = """theta = page.parameter("theta", "rad", "incline", "[0, 1.5]", 0.3)
eps = page.parameter("eps", "1", "share", "[0, 1]", 0.3)
q = page.parameter("q", "1", "another share", "(-2, 3)", 0.3)
x = page.coordinate("x", "m", "displacement along the belt")"""


def read(tmp_path: Path, force: str) -> pages.Model:
    text = shipped_page(
        "coulomb_stick_slip",
        ("import Page", "import Page, cos, exp, sin"),
        (
            "page.normal_force(N_0)",
            f"page.force(N_0 * eps * q * sin(theta), along=x)\npage.normal_force(N_0 * ({force}))",
        ),
        ('x = page.coordinate("x", "m", "displacement along the belt")', PARAMETERS),
    )
    path = tmp_path / "mine.py"
    path.write_text(text, encoding="utf-8")
    return pages.read(path)


@pytest.mark.parametrize(
    "force",
    [
        "cos(theta)",
        "sin(theta) + cos(theta)",
        "1 + eps * sin(k * x / N_0)",
        "1 + (k * x / N_0) ** 2",
        "2 + q",
    ],
)
def test_a_force_that_presses_is_taken(force: str, tmp_path: Path) -> None:
    read(tmp_path, force)


@pytest.mark.parametrize(
    "force",
    ["cos(2 * theta)", "1 + k * x / N_0", "1 + q * sin(k * x / N_0)", "q", "1 - mu_s", "-1"],
)
def test_a_force_that_pulls_somewhere_is_refused_with_the_place(force: str, tmp_path: Path) -> None:
    with pytest.raises(PageError, match=r"line \d+: the normal force .* pulls: .*it is -"):
        read(tmp_path, force)


def test_a_law_that_pulls_at_some_parameters_is_refused(tmp_path: Path) -> None:
    """At the base value it pushes everywhere."""
    text = shipped_page(
        "cubic_contact",
        ('">= 0", 100.0, becomes="gamma"', '"real", 100.0, becomes="gamma"'),
    )
    path = tmp_path / "mine.py"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(PageError, match=r"the contact law pulls: at .*gamma = -"):
        pages.read(path)


def test_no_proof_of_a_drawn_expression_has_a_counterexample(tmp_path: Path) -> None:
    """Sums over bounded quantities, of which each knows its own least value on a grid."""
    model = read(tmp_path, "1").mechanics
    names = {str(symbol): symbol for symbol in model.arguments}
    eps, q, x = names["eps"], names["q"], model.coordinates[0]
    (angle,) = model.angles
    c, s = angle.c, angle.s
    rng = np.random.default_rng(75)
    grid = [
        np.linspace(0, 1, 9),
        np.linspace(-2, 3, 9),
        np.linspace(0, 1.5, 9),
        np.linspace(0, 6.3, 33),
    ]
    at_eps, at_q, at_theta, at_x = np.meshgrid(*grid, indexing="ij")
    proved = refuted = 0
    for _ in range(30):
        a, b, d, e = (int(n) for n in rng.integers(-2, 4, 4))
        law = a + b * eps * sp.sin(x) + d * c + e * q * s
        values = a + b * at_eps * np.sin(at_x) + d * np.cos(at_theta) + e * at_q * np.sin(at_theta)
        holds, where = signs.is_nonnegative(model, law), signs.witness(model, law)
        assert not (holds and values.min() < -1e-12)
        assert bool(where) == bool(values.min() < -0.02) or abs(values.min()) < 0.02
        proved += holds
        refuted += bool(where)
    assert proved >= 3
    assert refuted >= 10
