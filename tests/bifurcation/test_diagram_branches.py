"""Branches of a diagram: of equilibria each is there once and whole, and a cycle that is not
followed costs that one only.
"""

import numpy as np
import pytest

import spragsym as ss
from tests.oracles import sticking


@pytest.mark.thorough
def test_a_branch_goes_on_where_a_layer_of_the_friction_law_ends() -> None:
    """Of Leine's law: its layer is below rounding on most of the way."""
    p = sticking.model("tanh").Parameters(mu_s=1.0, delta=2.0, zeta=0.1, d=100.0)
    found = ss.diagram(p, "V", between={"V": (0.05, 1.0)}, points=2)
    (branch,) = found.equilibria
    assert (branch.values.min(), branch.values.max()) == pytest.approx((0.05, 1.0))
    np.testing.assert_allclose(
        branch.states[:, 0], np.tanh(100 * branch.values) / (1 + 2 * branch.values), atol=1e-12
    )


@pytest.mark.thorough
def test_a_cycle_that_is_not_followed_is_told_and_costs_no_other() -> None:
    model = ss.load("stick_slip")
    start = ss.cycle(model.Parameters(V=0.2), near=(0.6, 0.0))
    found = ss.diagram(
        model.Parameters(V=0.2), "V", between={"V": (0.05, 0.12)}, points=5, starts=[start]
    )
    assert len(found.cycles) == 1
    assert any(
        "at V = 0.2 was not followed: between = (0.05, 0.12)" in remark for remark in found.remarks
    )


@pytest.mark.thorough
def test_states_that_friction_holds_are_no_branches() -> None:
    """Steady sliding is at μ_s exp(−V/v_s), also as the belt stops; then |x| ≤ μ_s rests."""
    p = sticking.dry().Parameters(v_s=1.0, V=0.0)
    found = ss.diagram(p, "V", between={"V": (0.0, 0.5)}, points=2)
    (branch,) = found.equilibria
    assert (branch.values.min(), branch.values.max()) == (0.0, 0.5)
    np.testing.assert_allclose(branch.states[:, 0], 0.5 * np.exp(-branch.values), atol=1e-12)
    assert not branch.stable.any()
    (remark,) = found.remarks
    assert "holds whole sets of states for V = 0, which are no branches" in remark
    still = ss.diagram(p, "mu_s", between={"mu_s": (0.2, 0.5)}, points=2)
    assert still.equilibria == ()
    assert "sets of states for mu_s in [0.2, 0.5], which" in still.remarks[0]


@pytest.mark.thorough
def test_a_cycle_is_born_with_a_tenth_of_the_speed_at_which_it_sticks() -> None:
    """Limits of a friction that slides are no borders: at its limit it is all along."""
    p = sticking.dry().Parameters(v_s=1.0, zeta=0.2)
    onsets = ss.flutter_onsets(p, "V", between={"V": (0.1, 2.0)})
    assert onsets.V == pytest.approx([np.log(0.5 / 0.2)], rel=1e-12)
    born = ss.cycle(onset=onsets)
    assert born.amplitude == pytest.approx(0.1 * onsets.V[0], rel=1e-3)
    # Beside a wide range the parameter hardly changes where the orbit is small.
    first, _ = ss.cycle_branch(born, "V", between={"V": (0.1, 1e5)}).events
    assert first.how == "it shrinks onto an equilibrium"
    assert abs(first.value - onsets.V[0]) <= first.error < 1e-7
