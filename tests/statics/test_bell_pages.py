"""Equilibria of pages with bells and steps in gaps and energies: every point is answered, none is
lost.

200 sets of each page are drawn by validation/bell_pages.py.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.bell_pages import CASES, drawn, missed
from tests.oracles.user_pages import model_of

pytest.importorskip("sympy")


def asked(name: str, **p: Any) -> Any:
    return ss.equilibria(model_of(CASES[name].hand.page, name).Parameters(**p))


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.thorough if name == "hump" else pytest.mark.validate)
        for name in CASES
    ],
)
def test_no_state_is_lost(name: str) -> None:
    rng = np.random.default_rng(list(CASES).index(name))
    case = CASES[name]
    model = model_of(case.hand.page, name)
    p = drawn(case, rng, 6)
    eq = ss.equilibria(model.Parameters(**p))
    states, wrong = missed(case, model, p, eq, rng, 15)
    assert states > 3
    assert not wrong
    assert eq.decided.all()


@pytest.mark.thorough
def test_a_state_on_a_bell_has_a_region_that_is_proved() -> None:
    """The state that SciPy finds, where guesses by Newton's method run away to 444."""
    eq = asked("hump", mu0=0.6459)
    assert eq.complete
    assert eq.x[0] == pytest.approx(1.15098553, abs=1e-8)
    assert eq.y[0] == pytest.approx(0.00381822, abs=1e-8)


@pytest.mark.thorough
def test_a_grid_over_a_bell_returns() -> None:
    """The point that never answered is the 16th."""
    mu0, theta0 = np.linspace(0.6, 0.7, 20), np.linspace(0.8, 0.9, 5)
    mu0[15], theta0[3] = 0.61616, 0.85556
    eq = asked("hump", mu0=mu0[:, None], theta0=theta0)
    assert eq.complete


@pytest.mark.validate
def test_where_no_force_bounds_the_states_what_was_searched_is_said() -> None:
    """A force with a limit, which friction exceeds far away: whether there is a state is not known
    from a search nearby.
    """
    eq = asked("step", alpha=0.0, lam=0.05, mu0=0.9, kappa=0.2)
    assert not eq.whole
    assert not eq.complete
    assert "there may be others beyond it" in eq.remarks[-1]


@pytest.mark.thorough
def test_exponentials_are_kept_whole_far_away() -> None:
    """exp(-(x - 1)²), not exp(-1) exp(2 x) exp(-x²), which is infinite times 0."""
    model = model_of(CASES["hump"].hand.page, "hump")
    field = model.algebra.contact_force(
        1e3, -0.1, *(0.5,) * len(model.about["arguments"]["motion"]), 1
    )
    assert field == pytest.approx(0.1)
