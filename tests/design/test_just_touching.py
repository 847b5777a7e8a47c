"""A mass whose state without a load lies exactly at the border of its contact."""

import re
import time
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym import precise
from spragsym.report.example import example
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")

TOUCHING = '''r"""A mass that rests on a belt as if it were not there."""
from spragsym.derive.model import Page, tanh
page = Page("A mass that a load presses on a belt, if there is one.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "stiffness of the belt")
a = page.unit("a", "m", "length")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.4)
P = page.parameter("P", "N", "load", "real", 0.0)
k = page.parameter("k", "N/m", "stiffness", "> 0", 0.3)
V = page.parameter("V", "m/s", "speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.potential(k * (x**2 + y**2 + (x + y)**2) / 2 + k_c * x**4 / a**2)
page.force(-P, along=y)
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu * tanh(d * v), at_rest=mu)
'''

#: Above a floor at −s a spring k holds a mass that the load F pulls down.
FLOOR = '''r"""A mass above a floor."""
from spragsym.derive.model import Page, tanh
page = Page("A mass that a spring holds above a floor.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "stiffness of the floor")
a = page.unit("a", "m", "length")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.3)
F = page.parameter("F", "N", "load", "real", 0.0)
s = page.parameter("s", "m", "height", "real", 0.0)
k = page.parameter("k", "N/m", "stiffness", "> 0", 1.0)
V = page.parameter("V", "m/s", "speed", "> 0", 0.5)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x)
page.spring(k, along=y)
page.force(-F, along=y)
page.contact(y + s, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu * tanh(20 * v / V), at_rest=mu)
'''

LEVER = 'b = page.parameter("b", "m", "lever", "> 1", 1.6)'


@pytest.mark.thorough
def test_a_state_at_the_edge_of_the_searched_region_is_decided() -> None:
    """Where the gap is a coordinate, only y ≤ 0 is searched, or y ≥ 0."""
    p = model_of(TOUCHING, "just_touching").Parameters()
    for contact in (True, False):
        eq = ss.equilibria(p, contact=contact)
        assert (eq.complete, eq.count.tolist()) == (True, 1)
        assert max(abs(float(column[0])) for column in eq.coordinates.values()) < 1e-300
    assert ss.equilibria(p.replace(P=[-1e-9, 0.0, 1e-9])).count.tolist() == [0, 1, 1]


def test_digits_of_a_state_that_just_touches() -> None:
    """With y = −s in floats, in as many digits as one likes."""
    p = model_of(FLOOR, "floor").Parameters(F=0.3, s=0.3)
    for contact in (True, False):
        (state,) = precise.equilibria(p, contact=contact, dps=40).states
        assert abs(state.numbers["y"] + mpmath.mpf(0.3)) < mpmath.mpf(10) ** -40


@pytest.mark.thorough
def test_gaps_of_exactly_zero_are_told_from_gaps_of_a_rounding() -> None:
    """Without the floor y = −F/k, so that the mass touches where F ≥ k s of the floats given."""
    rng = np.random.default_rng(5)
    F, k = rng.integers(-9, 10, 40) / 8.0, rng.choice([0.5, 1.0, 3.0, 0.7], 40)
    height = F / k
    eq = ss.equilibria(model_of(FLOOR, "floor").Parameters(F=F, k=k, s=height))
    excess = [Fraction(f) - Fraction(b) * Fraction(h) for f, b, h in zip(F, k, height, strict=True)]
    assert eq.complete
    assert eq.count.tolist() == [int(it >= 0) for it in excess]
    assert {it > 0 for it in excess if it} == {True, False}
    assert excess.count(0) > 10
    touches = [it == 0 for it in excess]
    np.testing.assert_allclose(eq["y"][touches, 0], -height[touches], rtol=1e-15)


@pytest.mark.parametrize(
    ("loads", "ends"),
    [
        ([0.0, 0.1, 0.3], []),
        ([0.3, 0.0], []),
        ([0.0], []),
        ([0.3, -0.1], [0.0]),
        ([0.0, -0.1], [0]),
    ],
)
def test_paths_begin_and_end_where_it_just_touches(loads: list[float], ends: list[float]) -> None:
    """(k + k_c) y = −F from there on; pulled up, the mass leaves the floor at once."""
    p = model_of(FLOOR, "floor").Parameters()
    if ends:
        with pytest.raises(ss.errors.ConvergenceError, match=r"leaves the contact at F = 0\.0"):
            ss.quasi_static_path(p, "F", loads)
    else:
        path = ss.quasi_static_path(p, "F", loads)
        np.testing.assert_allclose(path["y"], -np.array(loads) / 2, rtol=1e-14)
        assert path.jumps == ()


@pytest.mark.thorough
def test_a_probability_of_which_nothing_is_known_is_told_soon() -> None:
    p = model_of(TOUCHING, "just_touching").Parameters()
    begin = time.process_time()
    found = ss.jump_probability((p.replace(mu=0.36, k=0.25), p.replace(mu=0.44, k=0.35)), vary="mu")
    assert (found.low, found.high) == (0.0, 1.0)
    assert time.process_time() - begin < 30


@pytest.mark.thorough
def test_pressed_by_a_load_it_has_one_state() -> None:
    """Linear along x but for x³: a root of a polynomial."""
    eq = ss.equilibria(model_of(TOUCHING, "just_touching").Parameters(P=0.2))
    assert eq.complete
    assert eq.count == 1
    # (k + k + k_c) y + k x = −P, and k (2 x + y) + 4 x³ + μ k_c y = 0 with N = −y.
    k, mu, load = 0.3, 0.4, 0.2
    y = np.polynomial.Polynomial([-load, -k]) / (2 * k + 1)
    row = np.polynomial.Polynomial([0, 2 * k, 0, 4]) + (k + mu) * y
    (root,) = [it.real for it in row.roots() if abs(it.imag) < 1e-12 and y(it.real) < 0]
    np.testing.assert_allclose([eq["x"][0], eq["y"][0]], [root, y(root)], rtol=1e-12)


@pytest.mark.thorough
def test_the_domain_of_a_length_is_one_of_its_number(tmp_path: Path) -> None:
    """A length above 1 is one above the unit of length, of millimetres in the example of a file."""
    page = TOUCHING.replace('"stiffness", "> 0", 0.3)', '"stiffness", "> 0", 0.3)\n' + LEVER)
    page = page.replace("page.force(-P, along=y)", "page.force(-P * b / a, along=y)")
    model = model_of(page, "with_a_lever")
    text = example(model)
    (tmp_path / "lever.toml").write_text(text)
    ss.Study.from_file(tmp_path / "lever.toml", trust=True)
    short = tmp_path / "short.toml"
    short.write_text(re.sub(r'\nb = "[^"]*"', '\nb = "0.1 mm"', text))
    with pytest.raises(ss.errors.ParameterError, match="b = 0"):
        ss.Study.from_file(short, trust=True).report()
