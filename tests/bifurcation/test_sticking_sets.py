"""Sets of states in which friction holds, of forces that are not linear, several frictions or beside
contacts that open: against closed forms, and least values by SciPy of forces written by hand.
"""

import itertools
from collections.abc import Mapping

import numpy as np
import pytest
from scipy.optimize import brentq, minimize

import spragsym as ss
from tests.oracles.contact_pages import BLOCKS, PAD
from tests.oracles.user_pages import model_of, replaced

pytest.importorskip("sympy")

#: The front leg of a pad is held by dry friction, the rear one has none.
HELD_PAD = replaced(
    PAD,
    ('"> 0", 0.5)\ndef', '">= 0", 0.5)\ndef'),
    (
        "page.friction(x + h * phi, V, law, at_rest=mu0, on=front)\n"
        "page.friction(x + h * phi, V, law, at_rest=mu0, on=rear)\n",
        "page.friction(x + h * phi, V, slip=lambda v: mu0 * sgn(v), holds=mu0, on=front)\n",
    ),
)
#: Two blocks on springs that harden, the second in front of a stop.
HARD_BLOCKS = (
    replaced(
        BLOCKS,
        (
            "page.spring(k, along=x_1)",
            "page.spring(k, along=x_1)\npage.potential(g * k * (x_1**4 + x_2**4) / a**2 / 4)",
        ),
        (
            "V = page",
            'g = page.parameter("g", "1", "hardening", ">= 0", 0.5)\n'
            's = page.parameter("s", "m", "play", "real", 0.3)\nV = page',
        ),
    )
    + 'page.contact(s - x_2, lambda depth: 2 * k * depth, name="stop")\n'
)
#: The first block in two wells, x³ − x.
WELLS = replaced(
    BLOCKS,
    ("page.spring(k, along=x_1)", "page.potential(k * x_1**4 / a**2 / 4 - k * x_1**2 / 2)"),
)


@pytest.mark.thorough
@pytest.mark.parametrize("mu", [0.3, 1.6, 2.2])
def test_a_leg_holds_a_pad_whose_other_leg_may_lift(mu: float) -> None:
    """With both legs on T = μ (F/2 + a φ) and φ = h T/(2 k_c a² + k_t), up to where the rear lifts,
    φ = F/(2 k_c a); beyond it the front bears F.
    """
    F, k_t, h, k_x = 0.05, 0.3, 0.8, 0.5
    found = ss.sticking_states(
        model_of(HELD_PAD, "held_pad").Parameters(mu0=mu, k_t=k_t, h=h, F=F, k_x=k_x, V=0.0)
    )
    turned = h / (2 + k_t)
    least, most = mu * F / 2 / (1 + mu * turned), mu * F / 2 / (1 - mu * turned)
    lifts = most > F / 2 / turned
    most = mu * F if lifts else most
    phi = (h * most - F) / k_t if lifts else turned * most
    assert found.complete
    assert found.error[0] < 1e-12
    ends = [found[f"{name}_{end}"][0] for name in ("x", "phi", "y") for end in ("low", "high")]
    y = phi - F if lifts else -F / 2
    wanted = [-least / k_x, most / k_x, -turned * least, phi, -F / 2, y]
    np.testing.assert_allclose(ends, wanted, rtol=1e-11)


def _least_by_slsqp(v: Mapping[str, float]) -> list[float]:
    """Least and largest of both coordinates over shares of friction, from several starts."""

    def balance(z: np.ndarray) -> list[float]:
        x, y, one, other = z
        pull, stop = v["kappa"] * (x - y), 2 * max(0.0, y - v["s"])
        return [
            x + v["g"] * x**3 + pull - one * v["mu_s"] * v["N_1"],
            v["beta"] * y + v["g"] * y**3 - pull + stop - other * v["mu_s"] * v["N_2"],
        ]

    rng, found = np.random.default_rng(3), list[float]()
    for row, sign in itertools.product((0, 1), (1, -1)):
        tried = [
            minimize(
                lambda z, sign=sign, row=row: sign * z[row],
                rng.uniform(-1, 1, 4),
                constraints={"type": "eq", "fun": balance},
                bounds=[(-5, 5)] * 2 + [(-1, 1)] * 2,
                method="SLSQP",
                options={"maxiter": 300, "ftol": 1e-14},
            )
            for _ in range(6)
        ]
        reached = [one.fun for one in tried if np.abs(balance(one.x)).max() < 1e-10]
        found.append(sign * min(reached))
    return found


@pytest.mark.thorough
def test_hardening_blocks_before_a_stop_stick_as_far_as_slsqp_finds() -> None:
    rng = np.random.default_rng(31)
    model = model_of(HARD_BLOCKS, "hard_blocks")
    names = ("beta", "kappa", "mu_s", "N_1", "N_2", "g", "s")
    for row in rng.uniform(0.2, 1.2, (2, 7)):
        values = dict(zip(names, row.tolist(), strict=True)) | {"mu_k": 0.1}
        found = ss.sticking_states(model.Parameters(**values, V=0.0))
        assert found.complete
        assert len(found) == 1
        ends = [found[f"x_{i}_{end}"][0] for i in (1, 2) for end in ("low", "high")]
        np.testing.assert_allclose(ends, _least_by_slsqp(values), rtol=1e-9)


@pytest.mark.thorough
def test_a_block_sticks_in_each_of_its_wells_apart() -> None:
    """In the outer wells x_1 is least and largest where both frictions are at their limits on one
    side; where friction holds it over the humps between, that one set is not told apart is said.
    """
    kappa, beta, N_2 = 0.2, 1.0, 0.5
    model = model_of(WELLS, "blocks_in_wells")
    values = {"mu_k": 0.05, "N_1": 1.0, "N_2": N_2, "beta": beta, "kappa": kappa, "V": 0.0}

    def x_1(mu: float, one: float, other: float, low: float, high: float) -> float:
        def balance(x: float) -> float:
            y = (kappa * x + other * mu * N_2) / (beta + kappa)
            return x**3 - x + kappa * (x - y) - one * mu

        return float(brentq(balance, low, high, xtol=1e-15))

    found = ss.sticking_states(model.Parameters(mu_s=0.1, **values))
    assert found.complete
    hump = np.sqrt((1 - kappa + kappa**2 / (beta + kappa)) / 3)
    inner = x_1(0.1, 1, 1, -hump, hump)
    outer = x_1(0.1, 1, 1, hump, 2.0)
    near = x_1(0.1, -1, -1, hump, 2.0)
    np.testing.assert_allclose(found["x_1_low"], [-outer, inner, near], rtol=1e-12)
    np.testing.assert_allclose(found["x_1_high"], [-near, -inner, outer], rtol=1e-12)
    meeting = ss.sticking_states(model.Parameters(mu_s=0.6, **values))
    assert not meeting.complete
    assert any("connected" in remark for remark in meeting.remarks)
    np.testing.assert_allclose(meeting["x_1_high"], [x_1(0.6, 1, 1, hump, 2.0)], rtol=1e-12)
