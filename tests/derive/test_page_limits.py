"""What a page can't say is refused by its line, in the words of the guide, and what it can say goes
through.
"""

from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("sympy")


import numpy as np

import spragsym as ss
from spragsym.derive import pages, reserved
from spragsym.derive.limits import Limit
from spragsym.derive.model import PageError
from tests.oracles.user_pages import model_of, replaced
from tests.support import ROOT

PAGE = '''r"""A mass on a belt."""
import sympy as sp
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin, sqrt, tanh

page = Page("A mass on a belt.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "length")
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.5)
F_L = page.parameter("F_L", "N", "preload", "> 0", 0.05, becomes="kappa")
k = page.parameter("k", "N/m", "stiffness", ">= 0", 0.3, becomes="sigma")
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.02, becomes="zeta")
a = page.parameter("a", "1", "share", "real", 0.5)
psi = page.parameter("psi", "rad", "angle", "(-pi, pi)", 0.4)
V = page.parameter("V", "m/s", "speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
more = []
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2 + sum(more))
page.spring(k + k_c * a**2, along=x)
page.damper(c, along=y)
page.force(0, -F_L * (1 + sin(psi) * a), at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
'''


def written(tmp_path: Path, *changes: tuple[str, str]) -> Path:
    path = tmp_path / "mine.py"
    path.write_text(replaced(PAGE, *changes), encoding="utf-8")
    return path


def loaded(*changes: tuple[str, str]) -> Any:
    return model_of(replaced(PAGE, *changes), "mine")


def accelerations(model: ss.models.Model, state: tuple[float, ...], **changes: float) -> np.ndarray:
    p = model.Parameters(**changes)
    return np.array(
        model.algebra.rhs(*state, *(float(value) for value in model.arguments(p, "motion")))
    )


# ------------------------------------------------------------------------------------------------
# what a page can't say

#: Entry of the list → the statement that is replaced, what stands in its place, and a piece of the
#: line that is named.
DAMPER, CONTACT = "page.damper(c, along=y)", "page.contact(y, lambda depth: k_c * depth)"
LAW = "lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0"
BEYOND: dict[str, tuple[Limit, str, str, str]] = {
    "two frictions": (
        Limit.PLANE,
        DAMPER,
        "page.friction(y, V, lambda v: mu0 * tanh(d * v))",
        "page.friction(x",
    ),
    "a gap with speeds": (
        Limit.CONTACT_DAMPING,
        "page.contact(y,",
        "page.contact(y + page.rate(y) / d / V,",
        "page.contact(",
    ),
    "a law with speeds": (
        Limit.CONTACT_DAMPING,
        "k_c * depth)",
        "k_c * depth - c * page.rate(y))",
        "page.contact(",
    ),
    "a law of two": (
        Limit.CONTACT_DAMPING,
        "lambda depth: k_c",
        "lambda depth, speed: c * speed + k_c",
        "page.contact(",
    ),
    "a force with speeds": (
        Limit.NORMAL_SPEED,
        CONTACT,
        "page.normal_force(F_L + c * page.rate(x))",
        "page.normal_force(",
    ),
    "a force of either sign": (
        Limit.EITHER_FACE,
        CONTACT,
        "page.normal_force(F_L + k * y)",
        "page.normal_force(",
    ),
    "a law that is not seen to push": (
        Limit.PULLING,
        "lambda depth: k_c * depth",
        "lambda depth: k_c * depth * (1 - k_c * depth / F_L + (k_c * depth / F_L)**2)",
        "page.contact(",
    ),
    "a coefficient with speeds": (
        Limit.NONLINEAR_DAMPER,
        DAMPER,
        "page.damper(c * page.rate(y)**2 / V**2, along=y)",
        "page.damper(",
    ),
    "a force of the square": (
        Limit.NONLINEAR_DAMPER,
        DAMPER,
        "page.force(-c * page.rate(y)**3 / V**2, along=y)",
        "page.force(-c",
    ),
    "Coulomb": (Limit.STICKING, LAW, "lambda v: mu0 * sgn(v), at_rest=mu0", "page.friction("),
    "a jump at rest": (
        Limit.STICKING,
        LAW,
        "lambda v: mu0 * (1 + exp(-d * Abs(v))) * sgn(v), at_rest=mu0",
        "page.friction(",
    ),
    "time": (Limit.FORCING, DAMPER, "page.force(F_L * cos(t), along=y)", "cos(t)"),
    "time of the page": (
        Limit.FORCING,
        DAMPER,
        "page.force(F_L * cos(page.time), along=y)",
        "page.time",
    ),
    "time as a symbol": (
        Limit.FORCING,
        DAMPER,
        "page.force(F_L * cos(sp.Symbol('t')), along=y)",
        "sp.Symbol",
    ),
    "friction in a plane": (
        Limit.PLANE,
        LAW,
        "lambda v: mu0 * v / sp.sqrt(v**2 + page.rate(y)**2)",
        "page.friction(",
    ),
    "a belt that turns": (
        Limit.PLANE,
        "page.friction(x, V,",
        "page.friction(x, sp.sqrt(V**2 + page.rate(y)**2),",
        "page.friction(",
    ),
    "a belt's speed of either sign": (
        Limit.PLANE,
        "page.friction(x, V,",
        "page.friction(x, V * cos(psi),",
        "page.friction(",
    ),
    "no mass": (
        Limit.WITHOUT_MASS,
        "more = []",
        "more, z = [], page.coordinate('z', 'm', 'z')",
        "more, z",
    ),
    "friction of a place": (
        Limit.FRICTION_STATE,
        LAW,
        "lambda v: mu0 * tanh(d * v) * (1 + y / L_0)",
        "page.friction(",
    ),
    "friction of a state": (
        Limit.FRICTION_STATE,
        LAW,
        "lambda v, z: mu0 * tanh(d * v) * z",
        "page.friction(",
    ),
    "a mass that depends on the speed": (
        Limit.MASS_OF_SPEED,
        "page.kinetic(",
        "page.kinetic(m * page.rate(y) ** 4 / V**2 + ",
        "page.kinetic(",
    ),
    "five coordinates": (
        Limit.FIFTH_COORDINATE,
        "more = []",
        "more = [m * page.rate(page.coordinate(f'z{i}', 'm', 'z'))**2 for i in range(3)]",
        "more = [",
    ),
}


@pytest.mark.parametrize("case", BEYOND)
def test_what_a_page_cannot_say_is_refused_in_the_words_of_the_list(
    case: str, tmp_path: Path
) -> None:
    limit, before, after, place = BEYOND[case]
    path = written(tmp_path, (before, after))
    lines = path.read_text(encoding="utf-8").splitlines()
    (number,) = [number for number, line in enumerate(lines, 1) if place in line]
    with pytest.raises(PageError) as refused:
        pages.read(path)
    assert str(refused.value).startswith(f"mine.py, line {number}: ")
    assert str(limit) in str(refused.value)


def test_the_list_is_that_of_the_guide() -> None:
    """Every entry stands there with what can be done instead, and every entry is refused above."""
    guide = " ".join(
        (ROOT / "docs" / "howto_model.md").read_text(encoding="utf-8").replace("`", "").split()
    )
    for limit in Limit:
        assert f"{limit.what}: {limit.instead}" in guide, limit.what
    assert {limit for limit, *_ in BEYOND.values()} == set(Limit)


@pytest.mark.thorough
def test_a_forced_oscillator_by_the_clock_of_the_list() -> None:
    """In the words of the list; x'' + k x = P cos(w t) from rest has a closed form."""
    text = (
        PAGE.partition("more = []")[0]
        + """
w = page.parameter("w", "1/s", "frequency of the forcing", "> 0", 1.3)
P = page.parameter("P", "N", "amplitude of the force", "> 0", 0.2)
phase = page.clock(w)
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.force(P*cos(phase), along=x)
page.spring(k_c, along=x)
page.spring(k, along=y)
page.damper(c, along=y)
page.force(-F_L * (1 + sin(psi) * a), along=y)
page.contact(y, lambda depth: k_c * depth)
page.friction(y, V, lambda v: mu0 * tanh(d * v))
"""
    )
    model = model_of(text, "clock")
    p = model.Parameters(kappa=0.05)
    tr = ss.simulate(p, t_end=30.0)
    expected = 0.2 / (1 - 1.3**2) * (np.cos(1.3 * tr.t) - np.cos(tr.t))
    np.testing.assert_allclose(tr.x, expected, atol=1e-8)


# ------------------------------------------------------------------------------------------------
# what a page can say

STATE = (0.1, -0.2, 0.3, 0.4)


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ("page.spring(k, along=x + V)", "adds what can't be added"),
        ("page.spring(k, along=x, length=V)", "undeformed length"),
        ("page.damper(c, along=x * y)", "expected is kg m.-2 s.-1"),
        ("page.force(F_L, along=x * V)", "expected is"),
        ("page.force(F_L, along=x + V)", "adds what"),
        ("page.spring(k, along=x + sp.Symbol('b'))", "does not define"),
        ("page.push(F_L, along=x)", "a page has .*kinetic, .*force"),
        ("page.spring(K, along=x)", "offers Abs"),
        ("page.contact(y, 3)", "no function"),
    ],
)
def test_a_statement_that_does_not_fit_is_refused_by_its_line(
    said: str, words: str, tmp_path: Path
) -> None:
    path = written(tmp_path, (CONTACT if "contact" in said else DAMPER, said))
    (number,) = [
        number
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if said in line
    ]
    with pytest.raises(PageError, match=rf"line {number}: .*{words}"):
        pages.read(path)


# ------------------------------------------------------------------------------------------------
# names


@pytest.mark.parametrize("name", ["model", "abs"])
def test_a_name_of_a_file_or_of_code_is_refused_by_its_line(name: str, tmp_path: Path) -> None:
    assert name in reserved.OF_FILES | reserved.OF_CODE
    with pytest.raises(PageError, match=r"line 13: .*give it another name"):
        pages.read(written(tmp_path, ('"a", "1"', f'"{name}", "1"')))


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["w0", "v"])
def test_no_name_of_a_parameter_changes_the_model(name: str) -> None:
    """Generated code names its own shorthands around it."""
    law = ("1 - exp(-d * Abs(v))", "(1 + a**2 * exp(-a * d * Abs(v))) * (1 - exp(-d * Abs(v)))")
    positive = ('"share", "real"', '"share", "> 0"')
    mine, plain = loaded(law, positive, ('"a", "1"', f'"{name}", "1"')), loaded(law, positive)
    np.testing.assert_array_equal(accelerations(mine, STATE), accelerations(plain, STATE))


# ------------------------------------------------------------------------------------------------
# what varies, and what is drawn


@pytest.mark.thorough
def test_a_search_along_a_line_of_states_ends() -> None:
    """Without spring and friction the mass rests wherever it is along the belt: one box, and why;
    it once took minutes.
    """
    model = loaded()
    eq = ss.equilibria(model.Parameters(sigma=0.0, a=0.0, mu0=0.0))
    assert not eq.complete
    assert len(eq.undecided) == 1
    assert any("no force acts on one of the coordinates" in text for text in eq.remarks)
