"""A block that friction brings to rest: its speed decays to 0 and is never reversed; and one that
runs away in a finite time.
"""

import pytest

import spragsym as ss
from spragsym.motion.sweeps import rms_sweep
from tests.oracles.user_pages import model_of, shipped_page


@pytest.mark.thorough
@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_coming_to_rest_is_no_reversal(backend: str) -> None:
    pytest.importorskip(backend)
    page = shipped_page(
        "stick_slip",
        ("page.spring(k, along=x)", "page.spring(k * s, along=x)"),
        ("V = page", 's = page.parameter("s", "1", "share", ">= 0", 0.0)\nV = page'),
    )
    block = model_of(page, "block").Parameters(V=0.0, zeta=0.0, s=0.0)
    assert len(ss.simulate(block, start=(0.0, 1.0), t_end=100.0, backend=backend).events) == 0
    # A swing that dies out turns back once for each half of a period, however small it is.
    swing = ss.simulate(
        block.replace(s=1.0, mu_s=0.02), start=(0.0, 1.0), t_end=30.0, backend=backend
    )
    assert len(swing.events) == 10
    # A sweep counts the same, and leaves out what its transient leaves out.
    starts = {"x0": [0.0, 0.0], "vx0": [1.0, 0.9], "t_end": 100.0, "backend": backend}
    assert rms_sweep(block, transient=0.0, **starts).slip_reversed.tolist() == [0, 0]
    assert rms_sweep(block, transient=50.0, **starts).slip_reversed.tolist() == [0, 0]
    swung = rms_sweep(
        block.replace(s=1.0, mu_s=0.02), vx0=1.0, t_end=30.0, transient=0.0, backend=backend
    )
    assert swung.slip_reversed == 10


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_a_motion_that_grows_beyond_all_bounds_is_told_so(backend: str) -> None:
    pytest.importorskip(backend)
    page = shipped_page(
        "stick_slip", ("page.spring(k, along=x)", "page.force(k**3 * x**3 / N_0**2, along=x)")
    )
    p = model_of(page, "runaway").Parameters(mu_s=0.0, zeta=0.0)
    with pytest.raises(ss.errors.ConvergenceError, match="grows beyond all bounds"):
        ss.simulate(p, start=(2.0, 0.0), t_end=50.0, backend=backend)


#: x'' = 16 x, so that x = exp(4 t), and y'' = -x y, whose swings are faster and faster.
FASTER = (
    ("rate(x) ** 2 / 2", "rate(x) ** 2 / 2 + m * page.rate(y) ** 2 / 2"),
    ('belt")', 'belt")\ny = page.coordinate("y", "m", "across")'),
    ("page.spring(k, along=x)", "page.force(16 * k * x, along=x)"),
    ("page.normal", "page.force(-x * y * k**2 / N_0, along=y)\npage.normal"),
)


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_a_motion_that_runs_away_in_ever_shorter_steps_is_told_so(backend: str) -> None:
    pytest.importorskip(backend)
    p = model_of(shipped_page("stick_slip", *FASTER), "faster").Parameters(mu_s=0.0, zeta=0.0)
    with pytest.raises(ss.errors.ConvergenceError, match="grows beyond all bounds: by t = "):
        ss.simulate(p, start=(1, 1, 4, 0), t_end=50.0, backend=backend, rtol=1e-6, max_steps=4000)
