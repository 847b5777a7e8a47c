"""Cycles that pass from slip to stick in a thin layer, against a stiff integrator on the equation by hand."""

import pytest

import spragsym as ss
from tests.oracles import sticking
from tests.support import few

CASES = [("tanh", 300.0, 0.5), ("tanh", 3000.0, 3.0), ("arctan", 300.0, 0.5), ("exponential", 300.0, 0.5)]


@pytest.mark.parametrize(
    ("law", "d", "delta"), few([pytest.param(*case, id=f"{case[0]}-{case[1]:g}") for case in CASES], "tanh-300")
)
def test_the_period_is_that_of_a_stiff_integrator(law: str, d: float, delta: float) -> None:
    p = sticking.model(law).Parameters(mu_s=1.0, delta=delta, zeta=0.0, V=0.2, d=d)
    cycle = ss.cycle(p, near=(2.0, 0.0))
    found = sticking.return_time(law, cycle.parameters, cycle.state, cycle.period, 1e-9)
    assert cycle.period == pytest.approx(found, abs=cycle.error + 1e-8)
    assert abs(cycle.multipliers[0] - 1) <= cycle.error < 1e-9
    # The same by the simulation, whose tolerance, and so whose layer, is another.
    assert ss.simulate(p, start=(2.0, 0.0), t_end=200.0).period(100.0) == pytest.approx(cycle.period, abs=1e-8)
