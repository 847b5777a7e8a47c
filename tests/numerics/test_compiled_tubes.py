"""Tubes by compiled code beside those by NumPy: the same are proved, with the same boxes."""

from dataclasses import replace

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.tubes import Tubes
from spragsym.bifurcation.turning_points import _moved_on
from spragsym.numerics import plans
from spragsym.statics.balance import Balance

pytestmark = pytest.mark.skipif(not plans.available(), reason="there was no compiler")

#: Models with a spring at an angle, a law that is no polynomial, two springs, three coordinates,
#: and a torsion spring.
MODELS = ("kang_nam", "hertz_contact", "two_springs", "trolley", "sprag_rod")


def states(name: str, count: int) -> tuple[Tubes, np.ndarray]:
    """Points at random parameters, each with a state in contact, and these."""
    model = ss.load(name).search
    rng = np.random.default_rng(5)
    vary = "mu0" if "mu0" in model.parameters else model.parameters[-1]
    given = {vary: rng.uniform(0.05, 0.8, count)}
    if "theta0" in model.parameters:
        given["theta0"] = rng.uniform(0.3, 1.5, count)
    p = model.Parameters(**given)
    eq = ss.equilibria(p)
    rows = np.flatnonzero(eq.count > 0)
    columns = p.broadcast(*model.parameters)
    fixed = np.array([np.broadcast_to(one, count)[rows] for one in columns])
    z = np.array([*(eq.coordinates[one][rows, 0] for one in model.coordinates), given[vary][rows]])
    return Tubes.of_points(Balance(model), vary, fixed), z


@pytest.mark.parametrize("name", MODELS)
def test_the_same_tubes_are_proved(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Along what varies and along a coordinate, over short ways and over some that are too long."""
    tubes, z = states(name, 600)
    rng = np.random.default_rng(6)
    some = []
    for pivot in (tubes.n, 0):
        of = replace(tubes, pivot=pivot)
        by_s, _ = of.tangents(z)
        size = 10.0 ** rng.uniform(-6, 0, z.shape[1])
        beside = np.abs(z) * 10.0 ** rng.uniform(-12, -4, z.shape[1])
        half = np.where(np.arange(size.size) % 5, size, 0.0)
        some.append((of, (z, by_s, np.zeros((tubes.n + 1, 0, half.size)), half, beside)))
    with_compiled = [of._one_state(*given) for of, given in some]
    assert all(of._tapes is not None for of, _ in some)
    monkeypatch.setattr(plans, "compiled_for", lambda n: None)
    for (of, given), one in zip(some, with_compiled, strict=True):
        other = of._one_state(*given)
        assert 0.1 * one.proved.size < one.proved.sum() < 0.99 * one.proved.size
        np.testing.assert_array_equal(one.proved, other.proved)
        np.testing.assert_array_equal(one.radius > 0, other.radius > 0)
        np.testing.assert_allclose(one.radius, other.radius, rtol=1e-9)
        np.testing.assert_allclose(one.remainder, other.remainder, rtol=1e-9, atol=1e-24)
        np.testing.assert_allclose(one.half_width, other.half_width, rtol=1e-9, atol=1e-24)


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("width", [None, 0.0, 0.01])
def test_states_and_their_slopes_are_those_in_floats(
    name: str, width: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Newton's method comes to the same states, from beside them, and the slopes there, by free
    parameters too, are the same but for rounding.
    """
    tubes, z = states(name, 600)
    free = () if width is None else (tubes.balance.balanced[0],)
    tubes = Tubes.of_points(tubes.balance, tubes.vary, tubes.fixed, free)
    tubes = replace(tubes, half=np.full(tubes.half.shape, width or 0.0))
    start = z * (1 + 1e-4 * np.random.default_rng(8).standard_normal(z.shape))
    pivots = [replace(tubes, pivot=pivot) for pivot in (tubes.n, 0)]
    assert all(of._tapes is not None for of in pivots)
    found = [(of.corrected(start), *of.tangents(z)) for of in pivots]
    monkeypatch.setattr(plans, "compiled_for", lambda n: None)
    for of, (state, *slopes) in zip(pivots, found, strict=True):
        assert (state[of.pivot] == start[of.pivot]).all()
        by_s, by_p = of.tangents(z)
        steep = 1 + np.abs(by_s).max(axis=0)
        np.testing.assert_allclose(state / steep, of.corrected(start) / steep, atol=1e-11)
        assert (by_p != 0).any() == bool(width)
        for one, other in zip(slopes, (by_s, by_p), strict=True):
            assert (np.abs(one - other) <= 1e-11 * steep**2).all()


@pytest.mark.parametrize("name", MODELS)
def test_tubes_bend_as_their_slopes_change(name: str) -> None:
    """The sign of d²v/ds² over a tube is that of each change of dv/ds, in floats, at places in it;
    of wide tubes it is left open.
    """
    tubes, z = states(name, 400)
    size = 10.0 ** np.random.default_rng(7).uniform(-6, -0.5, z.shape[1])
    known = open_ = 0
    for pivot in range(tubes.n):
        of = replace(tubes, pivot=pivot)
        by_s, _ = of.tangents(z)
        none = np.zeros((tubes.n + 1, 0, size.size))
        tube = of._one_state(z, by_s, none, size, 0.5 * np.abs(by_s) * size)
        rows = np.flatnonzero(tube.proved & (size > 1e-5))
        bent = of[rows].bends(tube[rows], by_s[:, rows])
        places = [
            of[rows].corrected((z + by_s * share * size)[:, rows]) for share in (-0.9, 0.0, 0.9)
        ]
        slopes = np.array([of[rows].tangents(place)[0][-1] for place in places])
        clear = np.abs(np.diff(slopes, axis=0)) > 1e-11 * (1 + np.abs(slopes).max(axis=0))
        signs = np.sign(np.diff(slopes, axis=0))
        assert (signs == bent)[clear & (bent != 0)].all()
        known, open_ = known + (bent != 0).sum(), open_ + (bent == 0).sum()
    assert known > 0.1 * (known + open_)
    assert open_ > 0


@pytest.mark.parametrize("name", ["kang_nam", "hertz_contact", "two_springs"])
def test_no_state_moves_on_over_its_fold(name: str) -> None:
    """From beside a fold up to near it in one segment, by the sign of d²v/ds²; over it in none."""
    p = ss.load(name).search.Parameters(theta0=np.radians(40.0))
    found = ss.folds(p, "mu0", method="search")
    fold = np.array([found[one][:1] for one in (*p.model.coordinates, "mu0")])
    columns = np.array([np.atleast_1d(p[one]) for one in p.model.parameters])
    of = replace(Tubes.of_points(Balance(p.model), "mu0", columns), pivot=0)
    bent = 0
    for way in (-0.01, 0.01):
        start = fold.copy()
        start[0] += way
        here = of.place(start)
        assert here.proved.all()
        by_s = of.tangents(here.z)[0]
        for share, on in ((0.97, True), (1.03, False), (1.5, False)):
            step = -way * np.array([share])
            good = _moved_on(
                of,
                here[np.arange(1)],
                by_s.copy(),
                np.arange(1),
                step,
                np.sign(by_s[-1]),
            )
            assert good[0] == on
            tube = of.segment(here, here.z + by_s * step)[2]
            bent += bool(of.rises(tube, by_s) == 0 and of.bends(tube, by_s) != 0)
    assert bent == 6
