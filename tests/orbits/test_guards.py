"""What ends a search or a branch, on stand-ins of which the answer is known by hand."""

import importlib
from types import SimpleNamespace

import numpy as np
import pytest

import spragsym as ss
from spragsym.core.errors import ConvergenceError
from spragsym.orbits import basin_boundaries, branch, exponents, fate_boundaries, orbit, system


def test_a_line_along_the_boundary_does_not_cross_it() -> None:
    """Newton's method has no step where the side changes across the line alone."""
    walk = SimpleNamespace(
        component=lambda *_: (0.3, np.array([0.0, 1.0])),
        saddle=SimpleNamespace(growth=1.0),
        plane=np.eye(2),
    )
    with pytest.raises(ConvergenceError, match="not crossed along that direction"):
        basin_boundaries._Walk.refined(walk, np.zeros(2), np.array([1.0, 0.0]), 1.0)


def test_the_boundary_of_a_plane_is_found_by_newtons_method() -> None:
    """Of a motion that is off it by x + 2 y − 1, along a direction (1, 1): at x = y = 1/3."""
    walk = SimpleNamespace(
        component=lambda state, _: (state @ [1.0, 2.0] - 1.0, np.array([1.0, 2.0])),
        saddle=SimpleNamespace(growth=1.0),
        plane=np.eye(2),
    )
    begun = np.array([0.33, 0.33])
    state, change, _ = basin_boundaries._Walk.refined(walk, begun, np.array([1.0, 1.0]), 1.0)
    assert state == pytest.approx([1 / 3, 1 / 3], rel=1e-12)
    assert change < 1e-11


def test_fates_that_alternate_are_told_by_those_at_both_ends() -> None:
    """In the order of the parameter."""
    fates = [
        SimpleNamespace(value=value, verdict=SimpleNamespace(described=lambda name=name: name))
        for name, value in (("rest", 0.25), ("a cycle", 0.75))
    ]
    samples = SimpleNamespace(vary="mu0", rough=(1e-9, 0.0), fine=(1e-12, 0.0))
    samples.described = lambda *ends: fate_boundaries._FateSamples.described(samples, *ends)
    bracket = fate_boundaries._Bracket(samples, *fates, kept=0)
    said = str(bracket.alternating(0.5, 1e-7))
    assert said.startswith(
        "it comes to rest at mu0 = 0.25 and it comes to a cycle at mu0 = 0.75, and between the two "
        "fates alternate more closely than rounding can tell: within 1e-07 of mu0 = 0.5"
    )


def test_boundaries_keep_a_limit_of_time() -> None:
    p, options = ss.Parameters.article(), ss.MotionOptions(seconds=0.0)
    with pytest.raises(ConvergenceError, match=r"0 s of processor time were not enough"):
        ss.fate_boundary(
            p, "theta0", between={"theta0": (0.7, 0.8)}, V=0.5, d=10.0, options=options
        )
    with pytest.raises(ConvergenceError, match=r"0 s .* were over before a first point was found"):
        ss.basin_boundary(p.replace(theta0=0.7), V=0.5, d=10.0, options=options)


def test_the_error_of_an_end_that_was_lost_is_from_the_last_step(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As a share of that step, and the shortest step of the range."""
    monkeypatch.setattr(branch, "_at_border", lambda _: None)
    points = [
        SimpleNamespace(
            value=value,
            orbit=SimpleNamespace(period=1.0),
            setting=SimpleNamespace(period=1.0, spans=[10.0]),
            alone=True,
        )
        for value in (0.1, 0.3, 0.7)
    ]
    options = ss.BranchOptions()
    for followed, step in ((points, 0.4), (points[:1], 0.0)):
        event = branch._lost(followed, ConvergenceError("no step"), options)
        error = options.scatter * step + options.shortest_step * 10.0
        assert event.error == pytest.approx(error, rel=1e-12)
        assert event.how == "it could not be followed farther: no step"


def test_what_a_taylor_polynomial_leaves_out_is_the_rest_of_a_geometric_series() -> None:
    """Over the bound on the field: ratio^(order + 1) + ratio^(order + 2) + …."""
    flint = pytest.importorskip("flint")
    ball_flow = importlib.import_module("spragsym.orbits.ball_flow")
    left = ball_flow._remainder(flint.arb(0.25), SimpleNamespace(order=5))
    assert float(left) == pytest.approx(sum(0.25**k for k in range(6, 60)), rel=1e-14)


def test_averages_of_two_cycles_are_compared_in_the_unit_of_the_first_coordinate(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whatever that of the others is: 1e-5 of the extent apart they are two, 1e-7 apart one."""
    monkeypatch.setattr(orbit, "units_of", lambda _: np.array([2.0, 200.0]))
    monkeypatch.setattr(orbit, "extent", lambda *_: 1.0)
    monkeypatch.setattr(orbit, "apart", lambda *_: 0.0)
    cycles = [
        SimpleNamespace(period=1.0, rms=rms, mean=0.0, orbit=None, state=np.zeros(2))
        for rms in (1.0, 1.0 + 2e-5, 1.0 + 2e-7)
    ]
    assert not orbit.same_cycle(cycles[0], cycles[1])
    assert orbit.same_cycle(cycles[0], cycles[2])


@pytest.mark.parametrize(
    ("unit", "said"), [(0.01, "errors of integration"), (1.0, "a longer motion")]
)
def test_of_an_exponent_that_is_not_told_from_0_the_remedy_depends_on_the_time_unit(
    unit: float, said: str
) -> None:
    """The least error, 1e-5 in units of the motion, is 1e-3 per time where its unit is 0.01."""
    motion = SimpleNamespace(
        moves=True,
        exponents=np.array([0.1, 1e-5]),
        error=np.array([0.0, 1e-4]),
        options=SimpleNamespace(significance=2.0, least_error=1e-5),
        unit=unit,
        flow=np.zeros(9),
        volumes=np.array([1.0, -1.0]),
        interval=1.0,
    )
    assert said in exponents.Rates.undecided(motion, 0.0)


@pytest.mark.parametrize(
    ("implicit", "left", "is_long"), [(False, 20.0, False), (False, 20.1, True), (True, 1e9, False)]
)
def test_a_look_of_a_million_steps_is_too_long(implicit: bool, left: float, is_long: bool) -> None:
    """Of a motion of 100,000 steps from t = 1 to 3, 20 more take a million."""
    samples = SimpleNamespace(steps=np.empty(100_000))
    motion = SimpleNamespace(implicit=implicit, t=np.array([1.0, 3.0]), samples=samples)
    assert system._is_long(motion, left) is is_long
