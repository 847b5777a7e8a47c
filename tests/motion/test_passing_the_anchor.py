"""A spring that is passed through its anchor, where its direction jumps: two harmonic arcs, in
closed form.
"""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import spragsym as ss
from spragsym.motion.sweeps import rms_sweep

P = ss.Parameters.article(theta0=np.pi / 2)  # the anchor is at (0, 1)
KAPPA, SIGMA = P.scalars("kappa", "sigma")
OMEGA = np.sqrt(SIGMA)


def arc(t: float, y: float, v: float, rest: float) -> tuple[float, float]:
    """y″ = ω² (rest − y) from y and v on."""
    c, s = np.cos(OMEGA * t), np.sin(OMEGA * t)
    return rest + (y - rest) * c + v / OMEGA * s, (rest - y) * OMEGA * s + v * c


def height(t: float) -> float:
    """The spring pulls down above its anchor as if its end were at y = 2, and below it as if at y =
    0.
    """
    above, below = 2 - KAPPA / SIGMA, -KAPPA / SIGMA
    passed = brentq(lambda t: arc(t, 1.5, -0.6, above)[0] - 1, 0, 2, xtol=1e-15)
    return (
        arc(t, 1.5, -0.6, above)[0]
        if t < passed
        else arc(t - passed, *arc(passed, 1.5, -0.6, above), below)[0]
    )


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
@pytest.mark.parametrize("aside", [0.0, 1e-13, 1e-10])
def test_a_spring_passes_its_anchor(backend: str, aside: float) -> None:
    pytest.importorskip(backend)
    motion = ss.simulate(P, start=(aside, 1.5, 0.0, -0.6), t_end=2.0, backend=backend)
    assert motion.y[-1] == pytest.approx(height(2.0), abs=1e-8)


def test_a_sweep_passes_it() -> None:
    swept = rms_sweep(P, x0=np.zeros(2), y0=1.5, vy0=-0.6, V=0.5, d=10.0, t_end=2.0, transient=0.5)
    assert swept.mean_y == pytest.approx(quad(height, 0.5, 2.0, points=[0.7])[0] / 1.5, abs=1e-7)


def test_only_a_motion_that_comes_near_an_anchor_has_its_length_compiled(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    heyoka, asked, p = pytest.importorskip("heyoka"), [], P.replace(V=0.5, d=10.0)
    whole = heyoka.cfunc
    monkeypatch.setattr(heyoka, "cfunc", lambda *given: (asked.append(given), whole(*given))[1])
    # Tolerances of their own: an integrator is compiled once for each.
    ss.simulate(p, start=(0, 0, 0.1, 0), t_end=5, backend="heyoka", rtol=3e-12)
    assert not asked
    ss.simulate(p, start=(0, 1.5, 0, -0.6), t_end=5, backend="heyoka", rtol=3e-12)
    assert asked
