"""Which state is followed, and where it ends, where mirrors and ties leave that open: own pages
against closed forms.
"""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import spragsym as ss
from spragsym.bifurcation import branches
from spragsym.statics.search import balance_of
from tests.oracles.dimensional_pages import dimensional, units
from tests.oracles.user_pages import model_of, replaced

pytest.importorskip("sympy")

#: U = k sin² φ/2 + P cos φ: U'' = 1 − P and U'''' = P − 4 at φ = 0, so that the two others, cos φ =
#: P, lie below P = 1, unstable.
ROD = r'''r"""An upright rod under a load, propped at its tip by a side spring."""
from spragsym.derive.model import Page, cos, sin

page = Page("A propped upright rod under a load.")
m = page.unit("m", "kg", "mass at the tip")
k = page.unit("k", "N/m", "side spring")
l = page.unit("l", "m", "length")
P = page.parameter("P", "N", "load", ">= 0", 0.5, becomes="P")
e = page.parameter("e", "1", "offset of the side spring over the length", "real", 0.0)
phi = page.coordinate("phi", "rad", "angle from upright")
page.kinetic(m * l**2 * page.rate(phi) ** 2 / 2)
page.potential(k * (l * sin(phi) - e * l) ** 2 / 2)
page.force(0, -P, at=(l * sin(phi), l * cos(phi)))
'''


@pytest.fixture(scope="module")
def rod() -> Any:
    return model_of(ROD, "rod")


def fold_of_rod(e: Any) -> Any:
    """F = sin φ cos φ − e cos φ − P sin φ: det K = 0 where sin³ φ = e, and there P = (1 −
    e^(2/3))^(3/2).
    """
    return (1 - np.abs(e) ** (2 / 3)) ** 1.5


@pytest.mark.validate
@pytest.mark.parametrize("start", ["small", "large", 0])
def test_a_value_may_be_the_very_float_of_a_pitchfork(start: int | str, rod: Any) -> None:
    """There the state in which three meet is known: F = sin φ (cos φ − P) = −φ³/2 at P = 1, and φ =
    π.
    """
    path = ss.quasi_static_path(rod.Parameters(), "P", [0.5, 1.0, 1.5], start=start)
    fork = 0.0 if start != "large" else np.pi
    assert path.phi == pytest.approx([{0: -np.pi / 3}.get(start, fork), fork, np.pi], abs=1e-12)  # type: ignore[call-overload]
    assert [jump.value for jump in path.jumps] == ([] if start == "large" else [1.0])
    assert ss.quasi_static_path(rod.Parameters(), "P", [1.0]).phi.tolist() == [0.0]
    begun = ss.quasi_static_path(rod.Parameters(), "P", [1.0, 0.5])
    assert begun.phi == pytest.approx([0.0, 0.0], abs=1e-12)


#: F_φ = 6 φ − P sin φ, beside x = −1, 0 and 1: three pitchforks at P = 6, which no float beside it
#: is told apart from.
TRIPLETS = replaced(
    ROD,
    ("P = page", 'x = page.coordinate("x", "m", "another place")\nP = page'),
    (
        "k * (l * sin(phi) - e * l) ** 2 / 2",
        "3 * k * l**2 * (phi - e) ** 2 + k * (x**2 - l**2) ** 2 / l**2",
    ),
    ("page.kinetic(", "page.kinetic(m * page.rate(x) ** 2 / 2 + "),
)


@pytest.mark.by_hand("values0")
@pytest.mark.thorough
@pytest.mark.parametrize("values", [[5.0, 6.0, 7.0], [7.0, 6.0, 5.0]])
def test_pitchforks_at_one_value_are_told_apart(values: list[float]) -> None:
    path = ss.quasi_static_path(model_of(TRIPLETS, "triplets").Parameters(), "P", values)
    bent = brentq(lambda angle: 6 * angle - 7 * np.sin(angle), 0.5, 2.0)
    assert path.phi == pytest.approx([bent if value > 6 else 0.0 for value in values], abs=1e-9)
    assert (path.jumps, path.x.tolist()) == ((), [1.0] * len(values))


#: F = x/(1 + x²): a fold at F = 1/2, x = 1, both floats; the other state is at 1/F and leaves what
#: is searched below F = 0.1.
FADING = '''"""A mass on a spring that fades."""
from spragsym.derive.model import Page, log

page = Page("A mass on a spring that fades.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness at first")
b = page.unit("b", "m", "length over which it fades")
F = page.parameter("F", "N", "force", "real", 0.1)
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.potential(k * b**2 * log(1 + x**2 / b**2) / 2 - F * x)
'''


@pytest.fixture(scope="module")
def fading() -> Any:
    return model_of(FADING, "fading")


@pytest.mark.thorough
def test_what_rises_may_be_the_only_parameter(fading: Any) -> None:
    p = fading.Parameters(F=0.3)
    found = ss.jump_margin(p, {"F": 0.1}, vary="F", begin=0.0)
    assert found.distance == pytest.approx(2.0, rel=1e-9)
    ends = ss.jump_value(p, "F", begin=0.2, until=[0.4, 0.6])
    assert ends == pytest.approx([np.nan, 0.5], nan_ok=True)


@pytest.mark.thorough
def test_its_value_is_the_limit_of_that_of_imperfect_ones(rod: Any) -> None:
    e = np.array([1e-2, 1e-4, 1e-6, 0.0])
    found = ss.jump_value(rod.Parameters(e=e), "P", begin=0.5, until=1.5)
    assert found == pytest.approx(fold_of_rod(e), abs=1e-14)


@pytest.mark.thorough
def test_a_path_and_its_jump_are_the_same_in_any_units() -> None:
    """The article's model in kilograms and metres of random sizes, along a stiffness whose values
    are as small or large.
    """
    model, rng, found = dimensional("kang_nam"), np.random.default_rng(75), []
    for kilogram in (1.0, *10 ** rng.uniform((-6.0, 3.0), (-3.0, 6.0))):
        of_parameters, of_state = units(model, (kilogram, 10 ** rng.uniform(-3.0, 3.0), 1.0))
        given = {"theta0": 0.855, "mu0": 0.55, "V": 0.5}
        values = {name: value for name, value in model.base.items() if value is not None} | given
        p = model.Parameters(**{name: of_parameters[name] * one for name, one in values.items()})
        path = ss.quasi_static_path(
            p, "kappa", np.linspace(0.0005, 0.05, 5) * of_parameters["kappa"], start=0
        )
        (jump,) = path.jumps
        found.append([jump.value / of_parameters["kappa"], *path.x / of_state[0]])
    np.testing.assert_allclose(found[1:], [found[0]] * 2, rtol=1e-10)


TWO_WELLS = """'''Two wells.'''
from spragsym.derive.model import Page

page = Page("A mass in two wells.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "half the distance of the wells")
P = page.parameter("P", "N", "push", "real", 0.1)
x = page.coordinate("x", "m", "place")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.potential(-k * x**2 / 2 + k * x**4 / (4 * l**2))
page.force(P, along=x)
"""


def test_the_sign_of_a_determinant_is_sure_where_no_error_of_the_state_turns_it() -> None:
    """K = 3 x² − 1: of states drawn with the errors that they may have, up to and beyond the folds
    at x² = 1/3.
    """
    model, rng = model_of(TWO_WELLS, "two_wells"), np.random.default_rng(75)
    P = rng.uniform(-0.38, 0.38, 30)
    eq = ss.equilibria(model.Parameters(P=P))
    known = np.isfinite(eq["x"])
    away = np.abs(np.abs(eq["x"]) - 3.0**-0.5) / np.maximum(1.0, np.abs(eq["x"]))
    share = 10.0 ** rng.uniform(-3.0, 3.0, known.shape)
    balance = balance_of(model, eq.contact)
    none = np.empty(0), np.empty(0, dtype=str), np.empty((1, 0))
    along = branches.Along(balance, model.Parameters(P=P), "P", *none)
    stated = SimpleNamespace(
        states=eq.states, coordinates=eq.coordinates, parameters=eq.parameters, error=share * away
    )
    found = branches._states(along, stated)
    sure = np.concatenate([found[value].proved for value in P.tolist()])
    # An interval of x encloses K a little wider than it is.
    assert not sure[share[known] > 1.0].any()
    assert sure[share[known] < 0.3].all()


STOPPED = '''r"""A detent with a far stop."""
from spragsym.derive.model import Page, cos, tanh
page = Page("A slider on a guide, held by a spring and a detent, with a stop far away.")
m, k = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness")
L = page.unit("L", "m", "length")
P = page.parameter("P", "N", "push", "real", 0.0)
B = page.parameter("B", "N m", "detent", ">= 0", 1.0)
s = page.parameter("s", "m", "place of the stop", "real", 2.5)
mu = page.parameter("mu", "1", "friction of the guide", ">= 0", 0.0)
V = page.parameter("V", "m/s", "speed of the guide", "> 0", 1.0)
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * page.rate(x)**2 / 2)
page.spring(k, along=x)
page.potential(B * (1 - cos(3 * x / L)))
page.force(P, along=x)
guide = page.normal_force(k * L, name="guide")
stop = page.contact(s - x, lambda depth: 100 * k * depth, name="stop")
page.friction(x, V, lambda v: mu * tanh(v / V), at_rest=mu, on=guide)
'''


def test_a_stop_that_does_not_touch_at_the_origin_stores_nothing() -> None:
    """x = 0 has no strain energy; the well near 2π/3 has, however near to the stop it is."""
    p = model_of(STOPPED, "stopped").Parameters()
    states = ss.equilibria(p)
    assert (states.x[: states.count] > 1.0).any()
    path = ss.quasi_static_path(p, "P", [0.0, 0.1])
    assert abs(path.x[0]) < 1e-12
