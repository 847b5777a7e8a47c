"""Signs over whole domains: what is proved is nowhere negative, and what is not has a witness, drawn
at random.
"""

from pathlib import Path

import numpy as np
import pytest
import sympy as sp

from spragsym.derive import folder, pages, signs
from spragsym.derive.model import PageError
from tests.oracles.user_pages import shipped_page

pytestmark = pytest.mark.thorough

PARAMETERS = """theta = page.parameter("theta", "rad", "incline", "[0, 1.5]", 0.3)
eps = page.parameter("eps", "1", "share", "[0, 1]", 0.3)
q = page.parameter("q", "1", "another share", "(-2, 3)", 0.3)
x = page.coordinate("x", "m", "displacement along the belt")"""


def read(tmp_path: Path, force: str, speed: str = "V") -> pages.PageModel:
    text = shipped_page(
        "coulomb_stick_slip",
        ("import Page", "import Page, cos, exp, sin"),
        (
            "page.normal_force(N_0)",
            f"page.force(N_0 * eps * q * sin(theta), along=x)\npage.normal_force(N_0 * ({force}))",
        ),
        ("page.friction(x, V", f"page.friction(x, {speed}"),
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


def test_a_belt_s_speed_that_the_domain_of_an_angle_keeps_positive_is_taken(tmp_path: Path) -> None:
    read(tmp_path, "1", "V * sin(theta)")
    with pytest.raises(PageError, match=r"the belt's speed V\*cos\(2\*theta\) may be negative"):
        read(tmp_path, "1", "V * cos(2 * theta)")


def test_an_angle_in_the_speed_at_which_friction_is_taken_is_of_the_balance(tmp_path: Path) -> None:
    text = shipped_page(
        "stick_slip",
        ("import Page", "import Page, sin"),
        ("x = page.coordinate(", PARAMETERS.splitlines()[0] + "\nx = page.coordinate("),
        ("page.friction(x, V", "page.friction(x, V * sin(theta)"),
    )
    path = tmp_path / "mine.py"
    path.write_text(text, encoding="utf-8")
    parameters = folder.description(pages.read(path))["parameters"]
    assert {one["name"] for one in parameters if one["role"] == "both"} >= {"theta", "V", "mu_s"}


@pytest.mark.parametrize(
    "force",
    ["cos(2 * theta)", "1 + k * x / N_0", "1 + q * sin(k * x / N_0)", "q", "1 - mu_s", "-1"],
)
def test_a_force_that_pulls_somewhere_is_refused_with_the_place(force: str, tmp_path: Path) -> None:
    with pytest.raises(PageError, match=r"line \d+: the normal force .* pulls: .*it is -"):
        read(tmp_path, force)


#: Every parameter of the page stands in a spring too.
LAW = "page.spring(k_3 * L_0**2, along=x)\npage.contact(y, lambda depth: {})"


def read_law(tmp_path: Path, law: str) -> pages.PageModel:
    text = shipped_page(
        "cubic_contact",
        ("import Abs, Page", "import Abs, Page, log"),
        ("page.contact(y, lambda depth: k_c * depth + k_3 * depth**3)", LAW.format(law)),
    )
    path = tmp_path / "mine.py"
    path.write_text(text, encoding="utf-8")
    return pages.read(path)


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


@pytest.mark.parametrize(
    "law",
    [
        "k_c * L_0 * log(1 + depth / L_0)",
        "k_c * depth * (1 - depth / L_0 + (depth / L_0) ** 2)",
        "k_c * L_0 * (exp(depth / L_0) - 1)",
        "k_c * depth * (2 + sin(depth / L_0))",
    ],
)
def test_a_law_that_pushes_is_taken(law: str, tmp_path: Path) -> None:
    """It rises, has no root, or is least at ends of what is bounded."""
    read_law(tmp_path, law)


@pytest.mark.parametrize(
    ("law", "seen"),
    [
        ("k_c * depth * (1 - 2 * depth / L_0 + (depth / L_0) ** 2 / 2)", "pulls: at depth = "),
        ("k_c * depth * (1 - k_3 * L_0 * depth / k_c)", "pulls: at "),
        ("depth * (k_c - k_3 * L_0 * depth + (k_3 * L_0 * depth) ** 2 / k_c)", "not seen to push"),
    ],
)
def test_a_law_that_is_not_proved_to_push_is_refused(law: str, seen: str, tmp_path: Path) -> None:
    with pytest.raises(PageError, match=rf"line \d+: the contact law.*{seen}"):
        read_law(tmp_path, law)


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
