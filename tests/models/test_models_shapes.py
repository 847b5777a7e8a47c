"""Pages of other shapes than the shipped ones: angles that move, full mass matrices, a curved gap.

Each against the same mechanics written by hand: Lagrange's equations of a double pendulum from a
textbook, balances in mpmath.
"""

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import spragsym as ss
from tests.oracles.user_pages import model_of, shipped_page

pytest.importorskip("sympy")

HEAD = '''r"""A page of the tests."""
from spragsym.derive.model import Abs, Page, atan, cos, exp, pi, sgn, sin, sqrt
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "length")
'''
BELT = """
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 10.0)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
"""
FRICTION = "lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0"
PAGES = {
    "double_pendulum": HEAD
    + """
g = page.parameter("g", "m/s^2", "gravity", "> 0", 0.3, becomes="gamma")
nu = page.parameter("nu", "1", "second mass over first", "> 0", 0.7)
a = page.coordinate("a", "rad", "first angle")
b = page.coordinate("b", "rad", "second angle")
x1, y1 = L_0 * sin(a), -L_0 * cos(a)
x2, y2 = x1 + L_0 * sin(b), y1 - L_0 * cos(b)
page.kinetic(m * (page.rate(x1)**2 + page.rate(y1)**2) / 2 + nu * m * (page.rate(x2)**2 + page.rate(y2)**2) / 2)
page.potential(m * g * y1 + nu * m * g * y2)
""",
    "waves": HEAD
    + """
b = page.parameter("b", "1", "second wave over first", ">= 0", 0.25)
c = page.parameter("c", "1", "what breaks the mirror", ">= 0", 0.0)
a = page.coordinate("a", "rad", "angle")
page.kinetic(m * L_0**2 * page.rate(a)**2 / 2)
page.potential(k_c * L_0**2 * (cos(a) + b * cos(2 * a) + c * sin(a)))
""",
    "bumps": HEAD
    + BELT
    + f"""
k = page.parameter("k", "N/m", "stiffness along", "> 0", 0.4, becomes="sigma")
F_L = page.parameter("F_L", "N", "preload", "> 0", 0.05, becomes="kappa")
b = page.parameter("b", "m", "height of the bumps", ">= 0", 0.2)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x)
page.spring(k, along=y)
page.force(0, -F_L, at=(x, y))
page.contact(y - b * sin(3 * x / L_0), lambda depth: k_c * depth)
page.friction(x, V, {FRICTION})
""",
}


@pytest.fixture(scope="module")
def models() -> dict[str, Any]:
    return {name: model_of(text, name) for name, text in PAGES.items()}


def states(model: Any, found: Any) -> np.ndarray:
    """Equilibria of one point, shape (count, n)."""
    return np.array([found.coordinates[name][: int(found.count)] for name in model.coordinates]).T


@pytest.mark.by_hand("1e-13")
@pytest.mark.thorough
@pytest.mark.parametrize("off", [1e-13, 1e-11, 1e-9, 1e-6, -1e-12])
def test_equilibria_close_together_where_a_turn_ends_are_there_once(
    models: dict[str, Any], off: float
) -> None:
    """sin a (1 + 4 b cos a) = 0: beside ±π there are two more from b = 1/4 on, which only many
    digits tell apart.
    """
    model, b = models["waves"], 0.25 * (1 + off)
    found = ss.equilibria(model.Parameters(b=b))
    with mpmath.workdps(50):
        beside = [mpmath.acos(-1 / (4 * mpmath.mpf(b)))] if off > 0 else []
        want = [0, mpmath.pi, *beside, *(-a for a in beside)]
        assert found.complete
        assert int(found.count) == len(want)
        for a in want:
            turned = [
                abs(mpmath.mpf(value) - a + k * 2 * mpmath.pi)
                for value in found.a.tolist()
                for k in (-1, 0, 1)
            ]
            assert sum(value < 1e-14 for value in turned) == 1


@pytest.mark.thorough
@pytest.mark.parametrize("c", [1e-19, 1e-9])
def test_a_fold_where_a_turn_ends_is_there_once(models: dict[str, Any], c: float) -> None:
    """Beside the cusp at a = π, b = 1/4: found within 1e-6 of the end of the turn on both of its
    sides.
    """
    model = models["waves"]

    def fold(a: Any, b: Any) -> list[Any]:
        sines, cosines = (f(a) + k * b * f(2 * a) for f, k in ((mpmath.sin, 2), (mpmath.cos, 4)))
        return [c * mpmath.cos(a) - sines, -c * mpmath.sin(a) - cosines]

    found = ss.folds(model.Parameters(c=c), vary="b")
    assert found.decided
    assert len(found) == 1
    with mpmath.workdps(60):
        a, b = mpmath.findroot(
            fold,
            (mpmath.pi - mpmath.cbrt(c), 0.25 + mpmath.cbrt(c) ** 2 / 2),
            tol=mpmath.mpf(10) ** -100,
        )
        assert abs(float(a) - found.a[0]) < 1e-12
        assert abs(float(b) - found.b[0]) < 1e-12


def roots(balance: Any, starts: Any) -> list[tuple[float, ...]]:
    """All roots that Newton's method finds in 50 digits from many starts, each once."""
    known: list[tuple[float, ...]] = []
    with mpmath.workdps(50):
        for start in starts:
            try:
                root = mpmath.findroot(
                    balance, tuple(start), tol=mpmath.mpf(10) ** -60, maxsteps=30
                )
            except (ValueError, ZeroDivisionError):
                continue
            place = tuple(map(float, root)) if isinstance(root, mpmath.matrix) else (float(root),)
            if not any(np.allclose(place, other, atol=1e-9) for other in known):
                known.append(place)
    return known


def pendulum(t: float, s: np.ndarray, gamma: float, nu: float) -> list[float]:
    """A double pendulum of two unit lengths, masses 1 and ν: Landau and Lifshitz, Mechanics, § 5,
    problem 1.
    """
    a, b, u, v = s
    c, sine = math.cos(a - b), math.sin(a - b)
    M = np.array([[1 + nu, nu * c], [nu * c, nu]])
    right = [
        -nu * v * v * sine - (1 + nu) * gamma * math.sin(a),
        nu * u * u * sine - nu * gamma * math.sin(b),
    ]
    return [u, v, *np.linalg.solve(M, right)]


@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_a_double_pendulum_moves_as_in_the_textbook(models: dict[str, Any], backend: str) -> None:
    """Full mass matrix that depends on the place, centrifugal terms, no contact, no friction, no
    borders at all.
    """
    if backend == "heyoka":
        pytest.importorskip("heyoka")
    model, start = models["double_pendulum"], [2.0, 1.0, 0.3, -0.4]
    tr = ss.simulate(model.Parameters(), start=start, t_end=10.0, backend=backend, rtol=1e-11)
    want = solve_ivp(
        pendulum, (0, 10.0), start, args=(0.3, 0.7), rtol=1e-12, atol=1e-13, method="DOP853"
    ).y[:, -1]
    assert np.allclose(tr.state[:, -1], want, atol=1e-7)
    energy = tr.energy()
    assert np.ptp(energy) < 1e-8


@pytest.mark.thorough
def test_an_angle_that_comes_around_has_each_state_once(models: dict[str, Any]) -> None:
    """A double pendulum has four: each of its links hangs or stands; standing is π, where the
    searched turn ends.
    """
    model = models["double_pendulum"]
    eq = ss.equilibria(model.Parameters())
    assert eq.complete
    assert eq.whole.all()
    found = states(model, eq)
    assert {tuple(row) for row in np.round(found / math.pi, 12).tolist()} == {
        (0, 0),
        (0, 1),
        (1, 0),
        (1, 1),
    }
    path = ss.quasi_static_path(model.Parameters(), vary="gamma", values=np.linspace(0.1, 1.0, 5))
    assert np.allclose(
        np.sin(path.a), 0
    )  # beside a border of the search it would look for its way for minutes
    slots = [int(np.abs(found[k]).sum() < 1) for k in range(4)]
    assert [int(code) for code in eq.undamped[:4]] == [1 if hangs else 2 for hangs in slots]
    hanging = slots.index(1)
    # Frequencies of small motions: γ (1 + ν ± √(ν (1 + ν))) for these masses and lengths.
    want = sorted(0.3 * (1.7 + way * math.sqrt(0.7 * 1.7)) for way in (-1, 1) for _ in range(2))
    assert np.allclose(sorted(np.abs(eq.eigenvalues[hanging]) ** 2), want)


@pytest.mark.thorough
def test_a_curved_gap_pushes_along_its_gradient(models: dict[str, Any]) -> None:
    """Virtual work: N ∂(−gap)/∂q, and friction along the slide alone."""
    model = models["bumps"]
    eq = ss.equilibria(model.Parameters())
    assert eq.complete
    assert eq.whole.all()

    def balance(x: Any, y: Any) -> Any:
        push = mpmath.mpf("0.2") * mpmath.sin(3 * x) - y
        slope = mpmath.mpf("0.6") * mpmath.cos(3 * x)
        return [
            mpmath.mpf("0.4") * x + push * slope - push / 2,
            mpmath.mpf("0.4") * y + mpmath.mpf("0.05") - push,
        ]

    starts = [(x, y) for x in np.linspace(-2, 2, 41) for y in (-0.2, 0.1)]
    want = sorted(
        root for root in roots(balance, starts) if 0.2 * math.sin(3 * root[0]) - root[1] >= 0
    )
    assert np.allclose(states(model, eq), want, atol=1e-12)


def test_a_name_that_begins_as_those_of_answers_do_is_the_parameters_own() -> None:
    """``rest_x`` is told of a motion; ``rest_angle`` here is a parameter, in radians."""
    model = model_of(shipped_page("inclined_belt", ('"theta0"', '"rest_angle"')), "resting")
    assert (model.is_angle("rest_angle"), model.is_angle("rest_x")) == (True, False)
