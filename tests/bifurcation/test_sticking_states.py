"""States of sticking on a belt that stands still, against closed forms: intervals of each
coordinate.
"""

import math

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation import sticking
from spragsym.core.errors import ParameterError
from tests.oracles import dry_friction
from tests.oracles.user_pages import model_of, shipped_page

#: A pendulum in a bearing.
BEARING = shipped_page(
    "coulomb_stick_slip",
    ("import Page", "import Page, cos"),
    ('"x", "m", "displacement along the belt"', '"x", "rad", "angle"'),
    ("page.rate(x) ** 2", "(N_0 / k * page.rate(x)) ** 2"),
    ("page.friction(x,", "page.friction(N_0 / k * x,"),
    ("page.spring(k, along=x)", "page.potential(N_0**2 / k * (1 - cos(x)))"),
)

#: A mass that is pressed by a share of N_0.
SHARED = shipped_page(
    "coulomb_stick_slip",
    ("page.normal_force(N_0)", "page.normal_force(N_0 * w)"),
    (
        "x = page.coordinate",
        'w = page.parameter("w", "1", "share of the force", ">= 0", 1.0)\nx = page.coordinate',
    ),
)


@pytest.mark.thorough
def test_nothing_sticks_that_a_given_force_does_not_press() -> None:
    model = model_of(SHARED, "shared")
    for w, ends in ((0.5, [0.3]), (0.0, []), (1e-9, [6e-10])):
        found = ss.sticking_states(model.Parameters(mu_s=0.6, mu_k=0.4, V=0.0, w=w))
        assert found.x_high == pytest.approx(ends, rel=1e-12)
        assert -found.x_low == pytest.approx(ends, rel=1e-12)
        assert found.complete
    with pytest.raises(ParameterError, match="w"):
        model.Parameters(mu_s=0.6, mu_k=0.4, V=0.0, w=-0.5)


@pytest.mark.parametrize(
    ("degrees", "mu0", "given", "sets"),
    [
        (49.0, 0.5, {}, 1),  # the curve turns back at two folds
        (30.0, 0.5, {}, 2),
        (44.5593177, 0.5, {}, 2),  # a fold 1e-9 beyond the limit of the force
        (30.0, 0.5, {"alpha": 0.0, "ratio": 0.3}, 3),
        (90.0, 0.5, {}, 1),  # y turns back at x = 0
        (90.0, 0.0, {}, 1),
    ],
)
def test_sets_of_the_articles_model_hold_its_equilibria_at_all_coefficients(
    degrees: float, mu0: float, given: dict[str, float], sets: int
) -> None:
    """At coefficients of either sign, by the quartic: a belt that runs the other way is the mirror
    image.
    """
    theta0 = math.radians(degrees)
    found = ss.sticking_states(
        ss.load("coulomb").Parameters(theta0=theta0, mu0=mu0, V=0.0, **given)
    )
    mu, x, y = mu0 * np.sin(np.linspace(0.0, math.pi / 2, 3001)), [], []
    own = {name: value for name, value in given.items() if name != "ratio"}
    for way, begin in ((1, theta0), (-1, math.pi - theta0)):
        eq = ss.equilibria(ss.Parameters.article(theta0=begin, mu0=mu, **own))
        x, y = [*x, *(way * eq.x[eq.states])], [*y, *eq.y[eq.states]]
    assert found.complete
    assert found.x_low.size == sets
    inside = (found.x_low[:, None] - found.error[:, None] <= x) & (
        x <= found.x_high[:, None] + found.error[:, None]
    )
    assert inside.sum(axis=0) == pytest.approx(1)
    for row, here in zip(found, inside, strict=True):
        for name, column in (("x", np.array(x)[here]), ("y", np.array(y)[here])):
            assert (column.min(), column.max()) == pytest.approx(
                (row[f"{name}_low"], row[f"{name}_high"]), rel=1e-7, abs=1e-12
            )


@pytest.mark.parametrize(
    ("mu_s", "ends"),
    [
        (0.6, [(-36.86989765, 36.86989765), (143.13010235, 216.86989765)]),
        (math.nextafter(1.0, 2.0), [(-180, 180)]),
    ],
)
def test_an_angle_goes_on_beyond_half_a_turn(mu_s: float, ends: list[tuple[float, float]]) -> None:
    """A bearing holds a pendulum where |sin φ| ≤ μ_s; where μ_s > 1, anywhere."""
    found = ss.sticking_states(model_of(BEARING, "bearing").Parameters(mu_s=mu_s, V=0.0))
    assert list(zip(np.degrees(found.x_low), np.degrees(found.x_high), strict=True)) == [
        pytest.approx(end) for end in ends
    ]


def test_the_slope_of_the_friction_by_the_share() -> None:
    """Of a law that is steeper one way, so that μ is not 0 at half of the limits."""
    law = ("slip=lambda v: mu_k * sgn(v)", "slip=lambda v: mu_k * (sgn(v) + sgn(v) ** 2 / 2)")
    uneven = model_of(shipped_page("coulomb_stick_slip", law), "uneven").Parameters(
        mu_s=0.5, mu_k=0.4, V=0.0
    )
    found, own = ss.sticking_states(uneven), sticking.held(uneven, [""])
    low, high = (own._model.algebra.friction_at_rest(0.5, 0.4, 0.0, share) for share in (-1, 1))
    assert [found.x_low[0], found.x_high[0], low, high] == pytest.approx([-0.5, 0.6, -0.5, 0.6])
    assert own._model.algebra.friction_by_parameters(0.5, 0.4, 0.0)[-1] == pytest.approx(
        (high - low) / 2
    )


@pytest.mark.thorough
def test_two_sets_of_the_pendulum_whose_tip_sticks() -> None:
    """tan φ = −F/k l and x = −F/k for |F| ≤ μ_s N = 0.3."""
    found = ss.sticking_states(dry_friction.model("tip").Parameters(V=0.0))
    assert (-found.x_low, found.x_high) == (pytest.approx(0.3), pytest.approx(0.3))
    assert found.phi_high == pytest.approx([math.atan(0.3), math.pi + math.atan(0.3)])


def test_what_does_not_stand_still_and_what_only_touches_the_limit() -> None:
    with pytest.raises(
        ss.errors.ConvergenceError, match="share of the static coefficient of friction"
    ):
        ss.sticking_states(model_of(BEARING, "bearing").Parameters(mu_s=1.0, V=0.0))
    with pytest.raises(ss.errors.ParameterError, match="the belt moves at V"):
        ss.sticking_states(ss.load("coulomb_stick_slip").Parameters())
