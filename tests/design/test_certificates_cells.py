"""Certificates over boxes: that cells cover every direction, halves every point, and that shares
and counts add up.
"""

from collections.abc import Mapping
from fractions import Fraction
from types import MappingProxyType
from typing import Any

import mpmath
import numpy as np
import pytest

from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam import certificates
from spragsym.kang_nam.certificates import Ground, LinearDirection, ParameterBoxes, Verdict
from spragsym.models.quantities import Unit
from tests.support import as_fraction

#: κ = P u₁⁻¹ u₂⁻², α = P u₁⁻¹ and σ = P u₂²; the belt's speed is nothing to equilibria.
UNITS = {
    "u1": Unit(0.1, 2.0, {"kappa": -1, "alpha": -1}),
    "u2": Unit(0.1, 2.0, {"kappa": -2, "sigma": 2, "V": -0.5}),
}


def random_boxes(
    seed: int, count: int, units: Mapping[str, Unit] = MappingProxyType({})
) -> ParameterBoxes:
    rng = np.random.default_rng(seed)
    sides = len(PARAMETERS) + len(units)
    low = rng.uniform(0.1, 1.5, (sides, count))
    high = low + rng.uniform(0, 0.3, (sides, count)) * rng.integers(0, 2, (sides, count))
    return ParameterBoxes(low, high, np.zeros(count, dtype=bool), units)


# ------------------------------------------------------------------------------------------------
# cells


def value_at(number: Any, at: np.ndarray, k: int) -> Fraction:
    """value + Σ terms ε of box k, exactly."""
    terms = zip(number.terms[:, k], at, strict=True)
    return Fraction(float(number.value[k])) + sum(
        Fraction(float(term)) * as_fraction(mpmath.mpf(share)) for term, share in terms
    )


@pytest.mark.thorough
@pytest.mark.parametrize("units", [{}, UNITS], ids=["parameters", "units"])
@pytest.mark.parametrize("fixed", [True, False])
def test_the_ground_holds_every_point_of_a_cell(fixed: bool, units: Any) -> None:
    """cos θ and sin θ at the shares of the way that the cell has, θ₀ and the parameters at those of
    the box.
    """
    boxes = random_boxes(2, 20, units)
    rng, n = np.random.default_rng(3), len(boxes.low)
    low = LinearDirection(rng.uniform(0, 1, 20), rng.uniform(-0.6 / n, 0.6 / n, (n, 20)))
    high = LinearDirection(
        low.value + rng.uniform(0, 1, 20), rng.uniform(-0.6 / n, 0.6 / n, (n, 20))
    )
    begin = rng.choice([0.0, 0.25, 0.5], 20)
    end = begin + 0.25
    ground = (
        certificates.at(boxes, low) if fixed else certificates.over(boxes, low, high, begin, end)
    )
    with mpmath.workprec(150):
        for k in range(20):
            for at in rng.choice([-1.0, 1.0, 0.0, 0.5], (6, n + 1)):
                ends = [value.slopes[:, k] @ at[:n] + value.value[k] for value in (low, high)]
                share = begin[k] + (end[k] - begin[k]) * (1 + at[n]) / 2
                theta = ends[0] if fixed else ends[0] + share * (ends[1] - ends[0])
                middle, half = (
                    (boxes.low[:, k] + boxes.high[:, k]) / 2,
                    (boxes.high[:, k] - boxes.low[:, k]) / 2,
                )
                point = [mpmath.mpf(one) for one in middle + half * at[:n]]
                known = [
                    (ground.c, mpmath.cos(theta)),
                    (ground.s, mpmath.sin(theta)),
                    (ground.c0, mpmath.cos(point[0])),
                    (ground.s0, mpmath.sin(point[0])),
                ]
                for name, true in zip(PARAMETERS, point, strict=False):
                    powers = (unit.powers.get(name, 0) for unit in units.values())
                    factors = [
                        of**power
                        for of, power in zip(point[len(PARAMETERS) :], powers, strict=True)
                    ]
                    known.append((ground.parameters[name], true * mpmath.fprod(factors)))
                for number, true in known:
                    allowed = Fraction(float(number.error[k])) + Fraction(1, 10**15)
                    assert abs(as_fraction(true) - value_at(number, at, k)) <= allowed
    assert [
        one is ground.parameters[name]
        for one, name in zip(ground.others(), PARAMETERS[1:], strict=True)
    ] == [True] * 5
    assert max(ground.c.error.max(), ground.s.error.max()) < (0.13 if fixed else 0.6)


def whole(count: int) -> ParameterBoxes:
    return ParameterBoxes(
        np.full((6, count), 0.5), np.full((6, count), 0.5), np.zeros(count, dtype=bool), {}
    )


def flat(ends: Any) -> LinearDirection:
    values = np.array(ends, dtype=float)
    return LinearDirection(values, np.zeros((6, values.size)))


def test_every_direction_is_looked_at() -> None:
    """A claim that fails in a narrow stretch fails for the boxes whose directions have it, wherever
    that is.
    """
    begin, end = (
        flat([0.0, 0.0, 0.31, 0.0, 0.29, 0.5, 0.2999]),
        flat([1.0, 0.29, 1.0, 0.301, 0.31, 0.6, 0.3]),
    )

    def test(ground: Ground) -> Verdict:
        angle = np.arctan2(ground.s.value, ground.c.value)
        reach = np.maximum(ground.c.radius(), ground.s.radius()) * 1.5 + 1e-9
        return np.abs(angle - 0.3) > reach + 1e-4, (ground.c,)

    assert certificates.covered(whole(7), begin, end, test)[0].tolist() == [
        False,
        True,
        True,
        False,
        False,
        True,
        False,
    ]


# ------------------------------------------------------------------------------------------------
# certificates


def test_halves_make_up_the_box() -> None:
    boxes = random_boxes(4, 60)
    boxes.high[:, 0] = boxes.low[:, 0]  # a point
    weight = np.abs(np.random.default_rng(5).normal(size=(6, 60)))
    halves = boxes.divided(weight, 0)
    lower, upper = halves[:60], halves[60:]
    assert (lower.low == boxes.low).all()
    assert (upper.high == boxes.high).all()
    changed = lower.high != boxes.high
    assert (changed == (upper.low != boxes.low)).all()
    assert (lower.high == upper.low)[changed].all()
    assert np.abs(lower.high - (boxes.low + boxes.high) / 2)[changed].max() < 1e-15
    width = boxes.high - boxes.low
    for k in range(60):
        if not width[:, k].any():
            assert not changed[:, k].any()
        else:
            assert changed[:, k].sum() == 1
            assert changed[:, k].argmax() == (weight[:, k] * (width[:, k] > 0)).argmax()
