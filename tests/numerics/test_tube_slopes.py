"""Slopes over parts of tubes in affine arithmetic: against slopes at points of the same region, and
against intervals.
"""

from dataclasses import replace

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.tubes import Place, Tubes
from spragsym.design.tube_certificates import Splitting
from spragsym.models.quantities import Unit
from spragsym.numerics import contractors, tape
from spragsym.numerics.affine import Affine
from spragsym.numerics.interval_arrays import Intervals

#: A model, parameters with a tolerance, and units with one.
Tolerances = tuple[str, dict[str, tuple[float, float]], dict[str, Unit]]
BOXES: tuple[Tolerances, ...] = (
    (
        "cubic_contact",
        {
            "theta0": (0.87, 0.91),
            "sigma": (0.10, 0.14),
            "alpha": (0.0055, 0.0065),
            "mu0": (0.2, 0.3),
        },
        {},
    ),
    ("two_springs", {"theta0": (0.60, 0.62), "sigma": (0.09, 0.11), "mu0": (0.2, 0.3)}, {}),
    ("hertz_contact", {"theta0": (0.60, 0.62), "kappa": (0.009, 0.011), "mu0": (0.2, 0.3)}, {}),
    (
        "stribeck",
        {"theta0": (0.60, 0.62), "V": (0.4, 0.5), "mu_s": (0.3, 0.31), "sigma": (0.09, 0.11)},
        {},
    ),
    (
        "cubic_contact",
        {"theta0": (0.87, 0.91), "sigma": (0.10, 0.14), "mu0": (0.2, 0.3)},
        {"k_c": Unit(0.85, 1.05, {"sigma": -1.0, "kappa": -1.0, "alpha": -1.5})},
    ),
)


def region_of(given: Tolerances) -> tuple[Splitting, Tubes, Place]:
    """States about one of the middle of a box, moved along and across at random."""
    name, ranges, units = given
    model, rng = ss.load(name).search, np.random.default_rng(2)
    low, high = (
        model.Parameters(**{key: ends[side] for key, ends in ranges.items()}) for side in (0, 1)
    )
    vary = "mu0" if "mu0" in ranges else "mu_s"
    box = Splitting(low, high, vary, ranges[vary][0], units)
    tubes = box._over(box.whole.low, box.whole.high)
    z = box.whole.base.z
    by_p = tubes.tangents(z)[1]
    by_s = rng.normal(size=z.shape) * 0.1
    by_s[-1] = 1.0
    remainder = np.full_like(z, 1e-3)
    remainder[-1] = 0.0
    half_pivot, apart = np.full(1, 0.02), tubes.apart()
    size = np.abs(by_s) * half_pivot + (np.abs(by_p) * apart).sum(axis=1) + remainder
    return (
        box,
        tubes,
        Place(
            z,
            by_s,
            half_pivot,
            by_p,
            1.001 * size,
            remainder,
            remainder,
            np.ones(1, dtype=np.bool_),
        ),
    )


@pytest.mark.parametrize("given", BOXES)
def test_slopes_at_points_of_a_region_are_enclosed_and_narrower_than_by_intervals(
    given: Tolerances,
) -> None:
    box, tubes, region = region_of(given)
    count = 3000
    others = list(range(tubes.n))
    rng = np.random.default_rng(3)
    ends = [
        rng.choice([-1.0, 1.0], (size, count)) * rng.choice([1.0, 0.3], count)
        for size in (1, len(box.free), tubes.n + 1)
    ]
    p = tubes.centre + tubes.half * ends[1]
    z = (
        region.z
        + region.by_s * region.half_pivot * ends[0]
        + region.by_p[..., 0] @ (tubes.half * ends[1])
        + region.remainder * ends[2]
    )
    points = replace(
        tubes, fixed=np.repeat(tubes.fixed, count, axis=1), centre=p, half=np.full_like(p, 1e-9)
    )
    sampled = points.floats(z)[1]
    intervals = tubes.slopes(region.box())
    assert (intervals.low <= sampled).all()
    assert (sampled <= intervals.high).all()
    for rows, columns in zip(tubes.affine_slopes(region), sampled, strict=True):
        for entry, values in zip(rows, columns, strict=True):
            one = entry.interval() if isinstance(entry, Affine) else Intervals.point([float(entry)])
            assert one.low[0] <= values.min()
            assert values.max() <= one.high[0]
    wide = contractors.product(contractors.inverse(intervals.middle[:, others]), intervals.ends)
    found = tubes.over(region)
    spread = max(
        sum(float((found.taken(row[j]).high - found.taken(row[j]).low)[0]) for j in others)
        for row in found.rows
    )
    assert spread < 0.9 * float((wide[0] + wide[1])[:, others].sum(axis=1).max())


@pytest.mark.skipif(not tape.available(), reason="no C compiler on installation")
@pytest.mark.parametrize("given", BOXES[:-1])
def test_slopes_by_a_tape_are_those_of_numpy(
    given: Tolerances, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, tubes, region = region_of(given)
    assert tubes._affine_tape is not None
    found = tubes.affine_slopes(region)
    monkeypatch.setattr(tape, "compiled", None)
    expected = tubes.affine_slopes(region)
    for part in ("value", "terms", "error"):
        np.testing.assert_allclose(
            getattr(found, part), getattr(expected, part), rtol=1e-9, atol=1e-14
        )
    assert np.abs(found.terms).max() > 1e-3


def test_slopes_by_units_are_those_of_the_forces() -> None:
    """By differences: of a parameter at the units' base values, and of a unit on which several
    depend.
    """
    _, tubes, region = region_of(BOXES[-1])
    z, step = region.z, 1e-5
    _, slopes = tubes.floats(z)
    for k in range(len(tubes.free)):
        sides = []
        for side in (-1, 1):
            centre = tubes.centre.copy()
            centre[k] += side * step
            sides.append(replace(tubes, centre=centre).floats(z)[0])
        np.testing.assert_allclose(
            slopes[:, tubes.n + 1 + k], (sides[1] - sides[0]) / (2 * step), rtol=1e-6, atol=1e-9
        )


@pytest.mark.parametrize("given", BOXES)
def test_parameters_are_prepared_as_all_anew(given: Tolerances) -> None:
    """What follows from parameters that move, and from units, has the bits of all of it."""
    _, tubes, region = region_of(given)
    bounds = Intervals.point(tubes.fixed)
    span, v = tubes._span(), region.box()[-1]
    for place, part in zip(tubes.moving, [*span, v], strict=True):
        bounds.ends[:, place] = part.ends
    expected = tubes.balance.prepared(bounds).ends
    np.testing.assert_array_equal(tubes.bounds(v).ends, expected)
    assert (expected != tubes.prepared).any()
