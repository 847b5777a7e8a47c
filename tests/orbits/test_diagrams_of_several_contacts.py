"""Diagrams and curves of events of pages with several contacts."""

import numpy as np
import pytest

pytest.importorskip("sympy")

import spragsym as ss
from tests.oracles.contact_pages import BLOCKS, PAD
from tests.oracles.user_pages import model_of


@pytest.mark.validate
def test_a_diagram_has_a_branch_for_each_combination_of_contacts() -> None:
    """To the friction of the closed form at which the rear leg lifts, and from there on; a value at
    which states are looked for is that friction itself.
    """
    p = model_of(PAD, "pad_on_2").Parameters(k_t=0.3, h=1.2)
    lifts = (2 + 0.3) / (2 * 1.2)
    low, high = 0.6 * lifts, 1.2 * lifts
    found = ss.diagram(p, "mu0", between={"mu0": (low, high)}, points=5)
    assert [one.mode for one in found.equilibria] == ["contact", "contact of front alone"]
    both, front = found.equilibria
    assert both.values[[0, -1]] == pytest.approx([low, lifts], abs=2e-7 * (high - low))
    assert front.values[[0, -1]] == pytest.approx([lifts, high], abs=2e-7 * (high - low))
    for branch, touching in ((both, "front, rear"), (front, "front")):
        rows = [1, len(branch.values) // 2, -2]
        eq = ss.equilibria(p.replace(mu0=branch.values[rows]))
        for row, state in enumerate(branch.states[rows]):
            slot = eq["touching"][row].tolist().index(touching)
            known = [eq[name][row, slot] for name in ("x", "y", "phi")]
            np.testing.assert_allclose(state, known, rtol=0, atol=1e-12)


@pytest.mark.validate
def test_a_fold_of_cycles_of_two_blocks_is_followed_in_two_parameters() -> None:
    """Where the curve is, the branch at that stiffness between the blocks turns back."""
    model = model_of(BLOCKS, "blocks")

    def fold(kappa: float) -> ss.results.CycleEvent:
        p = model.Parameters(V=0.2, kappa=kappa)
        cycle = ss.cycle(p, near=(0.6, 0.6, 0.2, 0.2))
        branch = ss.cycle_branch(cycle, "V", between={"V": (0.19, 0.25)})
        (found,) = branch.of("fold")
        return found

    curve = ss.cycle_events(fold(0.8), ("V", "kappa"), points=2)
    V, kappa = curve.values[-1]
    assert kappa != 0.8
    assert fold(kappa).value == pytest.approx(V, rel=1e-9)
