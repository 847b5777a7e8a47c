"""Cycles that stick: their phases, and sliding bifurcations on their branches, seen by motions on both sides."""

from collections import Counter

import numpy as np
import pytest

import spragsym as ss

COULOMB = ss.load("coulomb")


def phases_of(cycle: ss.Cycle) -> Counter[str]:
    """How often each event happens in a motion over one period of a cycle, begun on it; by SciPy, which did not find it."""
    p = COULOMB.Parameters(**cycle.parameters)
    tr = ss.simulate(p, start=cycle.state, t_end=cycle.period, rtol=1e-12, backend="scipy")
    return Counter(ss.Event(kind).name for kind in tr.events.which)


def test_phases_are_the_modes_of_one_period() -> None:
    found = ss.cycle(ss.load("coulomb_stick_slip").Parameters(mu_s=0.6, mu_k=0.4, V=0.3)).phases
    assert found.side.tolist() == [1, 0, 1]
    assert found.contact.tolist() == [1, 1, 1]
    assert found.duration[1] == pytest.approx(2 * 0.2 / 0.3, abs=1e-11)
    assert 0 not in ss.cycle(ss.load("stick_slip").Parameters(V=0.2)).phases.side


@pytest.mark.thorough
def test_sliding_bifurcations_of_the_article_with_dry_friction() -> None:
    """Each event is where its name says: motions on either side of it differ by that and by nothing else."""
    pytest.importorskip("heyoka")
    p = COULOMB.Parameters(theta0=np.radians(42))
    branch = ss.cycle_branch(ss.cycle(p), "V", to=(0.25, 0.5))
    kinds = [event.kind for event in branch.events]
    assert (kinds.count("crossing-sliding"), kinds.count("grazing")) == (2, 5)  # these touch x' = V in lift-off
    for event in branch.events:
        if event.kind == "end":
            continue
        assert event.error < 1e-10
        sides = (phases_of(ss.cycle(p, event.cycle, V=event.value + way)) for way in (-2e-4, 2e-4))
        fewer, more = sorted(sides, key=lambda counts: (counts["STICK"], counts["MASS_OVERTAKES"]))
        gained, lost = dict(more - fewer), dict(fewer - more)
        if event.kind == "crossing-sliding":
            assert (gained, sum(lost.values())) == ({"STICK": 1, "SLIP": 1}, 1), event.value
        else:
            assert (gained, lost) == ({"MASS_OVERTAKES": 1, "BELT_OVERTAKES": 1}, {}), event.value
