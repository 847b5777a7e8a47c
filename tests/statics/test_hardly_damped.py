"""Damping far below what any precision resolves leaves proved what does not depend on it."""

import numpy as np
import pytest

import spragsym as ss
from spragsym.statics.stability import Linearized
from tests.oracles.user_pages import model_of, shipped_page


@pytest.mark.parametrize("mu0", [0.41, 0.6])
def test_growth_is_proved_though_the_slope_of_the_law_is_not_told_from_0(mu0: float) -> None:
    # K as of the page's docstring, with the law μ0 tanh(d v), whose slope at v = 1 is 1e-85 for d = 100; threshold μ = 0.34.
    law = ("mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0", "mu0 * tanh(d * v)")
    page = shipped_page("mode_coupling", law, ("Abs, Page, exp, sgn", "Page, tanh"))
    eq = ss.equilibria(model_of(page, "mode_coupling_tanh").Parameters(mu0=[mu0], V=1.0, d=100.0))
    K = np.array([[1.3 + 0.25, mu0 - 0.25], [-0.25, 1.25]])
    assert eq.growth[0, 0] == pytest.approx(np.sqrt(-np.linalg.eigvals(K).astype(complex)).real.max(), rel=1e-9)
    assert (eq.growth_sign[0, 0], eq.damped[0, 0]) == (1, "grows")


def test_what_no_float_holds_neither_grows_nor_decays() -> None:
    rates = np.array([np.nan, -1.0, 1.0, 1e-5])
    every = (rates + 1j)[:, None]
    assert Linearized(rates, np.zeros(4, dtype=np.int8), every).damped.tolist() == ["", "decays", "grows", "neutral"]
