"""A contact whose force is its gap alone, in units of the page: N = −gap."""

import math
from pathlib import Path

import pytest
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import derived, replaced


@pytest.mark.parametrize(("law", "stiff"), [("k * depth", 1.0), ("2 * k * depth", 2.0)])
def test_a_rod_on_a_gap_that_is_a_sine(law: str, stiff: float) -> None:
    """Moments about the hinge: c (tilt − φ) − P cos φ + N cos φ − μ N sin φ = 0."""
    pytest.importorskip("sympy")
    page = Path(__file__).parents[1] / "oracles/pages/lifted_rod.py"
    text = replaced(
        page.read_text(encoding="utf-8"),
        ("y - L / 2, lambda depth: k * depth", f"y, lambda depth: {law}"),
    )
    tau, tilt, rho, mu = 0.05, 0.6, 0.1, 0.3

    def moment(phi: float) -> float:
        force = -stiff * math.sin(phi)
        return tau * (tilt - phi) + (force - rho) * math.cos(phi) - mu * force * math.sin(phi)

    found = ss.equilibria(
        ss.load(derived(text, "sine_rod")).Parameters(tau=tau, tilt=tilt, rho=rho, mu=mu)
    )
    assert found.complete
    own = found["phi"][found["phi"] > -0.5]
    assert brentq(moment, -0.5, 0.0, xtol=1e-15) == pytest.approx(own.min(), abs=1e-13)
