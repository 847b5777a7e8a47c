"""The counts of roundings that the kernel's bounds rest on, against an independent count of the
emitted statements.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import pytest

from spragsym.derive.emit import language
from spragsym.derive.kang_nam import bounds, library
from spragsym.derive.kang_nam.catalogue import equilibrium, stability
from spragsym.generated import kernel as emitted
from spragsym.kang_nam import kernel


class Met:
    """A number that knows only how many roundings at most went into a monomial of it."""

    def __init__(self, count: int = 0) -> None:
        self.count = count

    def __add__(self, other: Any) -> Met:
        return Met(max(self.count, _met(other)) + 1)

    __radd__ = __sub__ = __rsub__ = __add__

    def __mul__(self, other: Any) -> Met:
        exact = isinstance(other, int | float) and math.frexp(abs(other))[0] == 0.5
        return self if exact else Met(self.count + _met(other) + 1)

    __rmul__ = __truediv__ = __mul__

    def __rtruediv__(self, other: Any) -> Met:
        return Met(self.count + _met(other) + 1)

    def __neg__(self) -> Met:
        return self


def _met(value: Any) -> int:
    return value.count if isinstance(value, Met) else 0


@cache
def _functions() -> dict[str, Any]:
    """The generated functions that the kernel calls and those beside them, from the derivation."""
    return {
        function.name: function
        for part in (equilibrium, stability)
        for function in part.module().functions
    }


@cache
def _derived() -> dict[str, float]:
    return bounds.counts(_kernel(), _functions())


def _independent() -> dict[str, float]:
    """Each count plus one for the size and higher orders; cos θ₀ and sin θ₀ are off by two units, a
    line's factor rounds once.
    """
    exact, angle, t = Met(), Met(2), Met()
    at = emitted.direction(t)
    line = [value * exact for value in kernel.f_coefficients(angle, angle, *[exact] * 6)]
    it = kernel.depressed(*kernel.resolvent(*line))
    L, x, y = kernel.state(at.cosine, at.sine, angle, angle, *[exact] * 4)
    eighth = Met(8)  # the uncertainty is at least eight roundings
    trace, _, flutter = kernel.invariants(eighth, eighth, eighth, *[exact] * 5)
    found = {
        "COUNT_P": it.P,
        "COUNT_Q": it.Q,
        "COUNT_E1": kernel.t_quartic(*line)[1],
        "COUNT_F": kernel.f(*at, *line),
        "COUNT_SLOPE": kernel.f_slope(*at, *line),
    }
    counts = {name: value.count + 1.0 for name, value in found.items()}
    counts["COUNT_STATE"] = max(L.count, y.count, math.ceil(x.count / 2)) + 1.0
    counts["COUNT_K"] = math.ceil(max(trace.count, flutter.count) / 8) + 1.0
    return counts


@pytest.mark.thorough
def test_derived_counts_are_the_committed_ones() -> None:
    for name, count in _derived().items():
        assert getattr(emitted, name) == count


@pytest.mark.parametrize(
    "name", ["COUNT_P", "COUNT_Q", "COUNT_E1", "COUNT_F", "COUNT_SLOPE", "COUNT_STATE", "COUNT_K"]
)
def test_no_count_is_below_the_independent_one_nor_far_above(name: str) -> None:
    """Sums are counted for any order of their terms, so that a count may be above what the printed
    order needs.
    """
    wanted = _independent()[name]
    assert wanted <= getattr(emitted, name) <= wanted + 2


def test_theta_is_off_by_four_units_at_most() -> None:
    """Of an angle below π, whose unit in the last place is 4 u."""
    assert emitted.COUNT_THETA == 4 * math.ulp(3.0) / 2.0**-53


# ------------------------------------------------------------------------------------------------
# what the counts stand on

# All of these take the whole derivation, in make check; the independent counts above hold the
# emitted ones in make test.


def _kernel() -> language.Source:
    return library.kernel()
