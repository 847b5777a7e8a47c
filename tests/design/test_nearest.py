"""The nearest design that jumps: of several sheets the nearest one, whatever was found first."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from spragsym.design.design_space import nearest

#: Centres and radii of discs; the nearest point of each lies on the line to its centre.
DISCS = (
    (np.array([5.0, 0.0, 0.0]), 1.0),
    (np.array([0.0, -2.0, 2.0]), 1.0),
    (np.array([-1.5, 3.0, 3.0]), 0.8),
)
LIMITS = (np.full(3, -10.0), np.full(3, 10.0))


def in_a_disc(z: Any) -> Any:
    return np.any(
        [np.linalg.norm(z - centre, axis=-1) <= radius for centre, radius in DISCS], axis=0
    )


def on_disc(which: int | None) -> Callable[[Any], Any]:
    """The nearest point of the disc that a point lies on, of one from the origin, if any."""

    def improved(z: Any) -> Any:
        if not z.any() and which is None:
            return None
        number = (
            which
            if not z.any()
            else int(np.argmin([np.linalg.norm(z - centre) - radius for centre, radius in DISCS]))
        )
        assert number is not None
        centre, radius = DISCS[number]
        return centre * (1 - radius / np.linalg.norm(centre))

    return improved


@pytest.mark.parametrize("first", [None, 0, 1, 2])
def test_of_several_sheets_the_nearest_one_is_found_whichever_comes_first(
    first: int | None,
) -> None:
    found = nearest(in_a_disc, LIMITS, on_disc(first))
    assert found is not None
    assert np.linalg.norm(found) == pytest.approx(8**0.5 - 1.0, abs=1e-12)


def test_a_border_that_nothing_improves_is_come_to_along_a_ray() -> None:
    found = nearest(in_a_disc, LIMITS, lambda _: None)
    assert found is not None
    assert np.linalg.norm(found) == pytest.approx(8**0.5 - 1.0, rel=3e-3)
    assert nearest(lambda z: np.zeros(z.shape[:-1], dtype=bool), LIMITS, lambda _: None) is None


@pytest.mark.parametrize("beyond", [1e-5, 1e-4, 1e-3])
def test_no_point_beyond_the_border_on_its_ray_is_taken(beyond: float) -> None:
    """What is found from a coarse bracket may lie beyond where its ray meets the border."""
    border = 1.2345
    found = nearest(
        lambda z: np.abs(z[..., 0]) >= border,
        (np.array([-10.0]), np.array([10.0])),
        lambda z: np.array([border * (1 + beyond)]) if z.any() else None,
    )
    assert found is not None
    assert abs(found[0]) == pytest.approx(border, rel=1e-9)
