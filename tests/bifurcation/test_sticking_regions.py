"""Where two blocks at rest stick both, against closed forms and samples of the shares of
friction.
"""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.contact_pages import BLOCKS, PAD, SNAP, STACK
from tests.oracles.user_pages import model_of, replaced

pytest.importorskip("sympy")


def test_two_blocks_at_rest_stick_in_a_parallelogram() -> None:
    model = model_of(BLOCKS, "blocks")
    rng = np.random.default_rng(21)
    for beta, kappa, mu_s, N_1, N_2 in rng.uniform(0.2, 2.0, (20, 5)).tolist():
        p = model.Parameters(beta=beta, kappa=kappa, mu_s=mu_s, mu_k=0.1, N_1=N_1, N_2=N_2, V=0.0)
        found = ss.sticking_states(p)
        K = np.array([[1 + kappa, -kappa], [-kappa, beta + kappa]])
        det = (1 + kappa) * (beta + kappa) - kappa**2
        f_1, f_2 = mu_s * N_1, mu_s * N_2
        x_1 = (K[1, 1] * f_1 + kappa * f_2) / det
        x_2 = (kappa * f_1 + K[0, 0] * f_2) / det
        assert found.complete
        for name, size in (("x_1", x_1), ("x_2", x_2)):
            np.testing.assert_allclose(found[f"{name}_low"], [-size], rtol=1e-12)
            np.testing.assert_allclose(found[f"{name}_high"], [size], rtol=1e-12)
        np.testing.assert_allclose(found["measure"], [4 * f_1 * f_2 / det], rtol=1e-12)


def test_a_law_that_is_larger_one_way_holds_more_there() -> None:
    """From −μ_s to 1.5 μ_k: no share is none of the friction, and no edge is μ_s N."""
    page = BLOCKS.replace("mu_k * sgn(v)", "mu_k * (sgn(v) + sgn(v) ** 2 / 2)")
    p = model_of(page, "uneven_blocks").Parameters(mu_s=0.6, mu_k=0.5, V=0.0)
    found = ss.sticking_states(p)
    K = np.array([[1 + p.kappa, -p.kappa], [-p.kappa, p.beta + p.kappa]], dtype=float)
    N = np.array([p.N_1, p.N_2], dtype=float)
    highest, lowest = (np.linalg.solve(K, mu * N) for mu in (0.75, -0.6))
    np.testing.assert_allclose(found["x_1_high"], [highest[0]], rtol=1e-12)
    np.testing.assert_allclose(found["x_2_low"], [lowest[1]], rtol=1e-12)
    measure = 1.35**2 * N.prod() / np.linalg.det(K)
    np.testing.assert_allclose(found["measure"], [measure], rtol=1e-12)


def test_nothing_sticks_where_a_block_is_lifted_and_what_is_not_answered_says_so() -> None:
    p = model_of(BLOCKS, "blocks").Parameters(V=0.0)
    assert len(ss.sticking_states(p.replace(N_2=0.0))) == 0
    with pytest.raises(ss.errors.ParameterError, match="N_2"):
        p.replace(N_2=-1.0)
    with pytest.raises(ss.errors.ParameterError, match="belt moves at V"):
        ss.sticking_states(p.replace(V=0.1))
    with pytest.raises(ss.errors.ModelError, match="holds nothing"):
        ss.sticking_states(model_of(PAD, "pad_on_2").Parameters())


def test_both_blocks_slide_steadily_in_one_state() -> None:
    p = model_of(BLOCKS, "blocks").Parameters(N_2=1.3)
    eq = ss.equilibria(p)
    assert eq.complete
    K = np.array([[1 + p.kappa, -p.kappa], [-p.kappa, p.beta + p.kappa]], dtype=float)
    forces = float(p.mu_k) * np.array([p.N_1, p.N_2], dtype=float)
    q = np.linalg.solve(K, forces)
    np.testing.assert_allclose([eq.x_1[0], eq.x_2[0]], q, rtol=1e-12)


@pytest.mark.thorough
def test_one_block_of_two_sticks_where_the_other_slides_without_friction() -> None:
    """x₂ = κ x₁/(β + κ), and |x₁| up to where its spring and its neighbour pull by all that holds;
    with a spring g x₂³ more the ends are told from the balance of the other.
    """
    rubs = (
        "page.friction(x_2, V, slip=lambda v: mu_k * sgn(v), holds=mu_s, on=second)\n",
        "",
    )
    cubic = (
        "page.spring(k, along=x_1)",
        "page.spring(k, along=x_1)\npage.potential(g * k * x_2**4 / a**2 / 4)",
    )
    hard = ("V = page", 'g = page.parameter("g", "1", "hardening", ">= 0", 0.5)\nV = page')
    model = model_of(replaced(BLOCKS, rubs), "one_block")
    bent = model_of(replaced(BLOCKS, rubs, cubic, hard), "bent_block")
    rng = np.random.default_rng(22)
    for beta, kappa, mu_s, N_1 in rng.uniform(0.3, 1.5, (3, 4)).tolist():
        values = {"beta": beta, "kappa": kappa, "mu_s": mu_s, "mu_k": 0.1, "N_1": N_1, "V": 0.0}
        found = ss.sticking_states(model.Parameters(**values))
        most = mu_s * N_1 / (1 + kappa - kappa**2 / (beta + kappa))
        np.testing.assert_allclose(found["x_1_high"], [most], rtol=1e-12)
        np.testing.assert_allclose(found["x_2_low"], [-kappa * most / (beta + kappa)], rtol=1e-12)
        x, y = (ss.sticking_states(bent.Parameters(**values))[f"x_{i}_high"][0] for i in (1, 2))
        assert beta * y + 0.5 * y**3 - kappa * (x - y) == pytest.approx(0.0, abs=1e-9)
        assert x + kappa * (x - y) == pytest.approx(mu_s * N_1, abs=1e-9)


@pytest.mark.thorough
def test_a_repelled_mass_sticks_in_the_middle_and_at_each_stop() -> None:
    """|x| ≤ f about the middle, k_c (x − a) − x within f of 0 beyond a stop; one set for f > a."""
    rubs = """pad = page.normal_force(k * a, name="pad")
page.friction(x, V, slip=lambda v: mu_s * sgn(v) / 2, holds=mu_s, on=pad)
"""
    quantities = """V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.0)
mu_s = page.parameter("mu_s", "1", "friction", ">= 0", 0.5)
x = page"""
    page = replaced(SNAP, ("import Page", "import Page, sgn"), ("x = page", quantities)) + rubs
    model = model_of(page, "snap_that_sticks")
    for f, k_c in ((0.3, 4.0), (0.8, 1.7), (1.2, 3.0)):
        found = ss.sticking_states(model.Parameters(mu_s=f, k_c=k_c, F=0.0))
        near, far = (k_c - f) / (k_c - 1), (k_c + f) / (k_c - 1)
        low, high = ([-far], [far]) if f > 1 else ([-far, -f, near], [-near, f, far])
        assert found.complete
        np.testing.assert_allclose(found["x_low"], low, rtol=1e-12)
        np.testing.assert_allclose(found["x_high"], high, rtol=1e-12)


def test_what_sticks_on_a_block_beside_what_slides_on_a_belt() -> None:
    """x_1 by |F| ≤ 0.6 · 0.5, and k_2 x_2 + x_1 = 0.4: a line of states. ``equilibria`` has those of
    sliding alone, and says so; a page may say of dry friction that its belt stands still.
    """
    model = model_of(STACK, "stack")
    found = ss.sticking_states(model.Parameters())
    assert found.complete
    ends = [found[f"{name}_{end}"][0] for name in ("x_1", "x_2") for end in ("low", "high")]
    assert ends == pytest.approx([-0.3, 0.3, 0.1 / 1.5, 0.7 / 1.5], abs=1e-12)
    eq = ss.equilibria(model.Parameters(V=np.array([0.0, 0.3])))
    assert not eq.whole.any()
    assert "sticking_states" in eq.remarks[0]
    single = ss.load("coulomb_stick_slip").Parameters(V=np.array([0.0, 0.1]))
    assert ss.equilibria(single).whole.tolist() == [False, True]
    both = ss.sticking_states(model.Parameters(V=0.0))
    assert [both.x_2_low[0], both.x_2_high[0]] == pytest.approx([-0.6, 0.6])
