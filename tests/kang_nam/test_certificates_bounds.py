"""The counts of roundings that the kernel's bounds rest on, against an independent count of the emitted statements."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import pytest
import sympy as sp

from spragsym.derive.emit import language
from spragsym.derive.emit.statements import flatten
from spragsym.derive.kang_nam import bounds, emission
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.derive.kang_nam.bounds import Counted
from spragsym.derive.kang_nam.catalogue import equilibrium, stability
from spragsym.generated import kernel as emitted
from spragsym.kang_nam.statics import kernel


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
    return {function.name: function for part in (equilibrium, stability) for function in part.module().functions}


@cache
def _derived() -> dict[str, float]:
    return bounds.counts(_kernel(), _functions())


def _independent() -> dict[str, float]:
    """Each count plus one for the size and higher orders; cos θ₀ and sin θ₀ are off by two units, a line's factor rounds once."""
    exact, angle, t = Met(), Met(2), Met()
    at = emitted.direction(t)
    line = [value * exact for value in kernel.f_coefficients(angle, angle, *[exact] * 6)]
    it = kernel.depressed(*kernel.resolvent(*line))
    L, x, y = kernel.state(at.cosine, at.sine, angle, angle, *[exact] * 4)
    eighth = Met(8)  # the uncertainty is at least eight roundings
    (K11, K12), (K21, K22) = kernel.stiffness(eighth, eighth, eighth, *[exact] * 5)
    trace, _, flutter = kernel.invariants(K11, K12, K21, K22)
    found = {
        "COUNT_P": it.P, "COUNT_Q": it.Q, "COUNT_E1": kernel.t_quartic(*line)[1], "COUNT_F": kernel.f(*at, *line),
        "COUNT_SLOPE": kernel.f_slope(*at, *line),
    }  # fmt: skip
    counts = {name: value.count + 1.0 for name, value in found.items()}
    counts["COUNT_STATE"] = max(L.count, y.count, math.ceil(x.count / 2)) + 1.0
    counts["COUNT_K"] = math.ceil(max(trace.count, flutter.count) / 8) + 1.0
    return counts


@pytest.mark.thorough
def test_derived_counts_are_the_committed_ones() -> None:
    for name, count in _derived().items():
        assert getattr(emitted, name) == count


@pytest.mark.parametrize("name", ["COUNT_P", "COUNT_Q", "COUNT_E1", "COUNT_F", "COUNT_SLOPE", "COUNT_STATE", "COUNT_K"])
def test_no_count_is_below_the_independent_one_nor_far_above(name: str) -> None:
    """Sums are counted for any order of their terms, so that a count may be above what the printed order needs."""
    wanted = _independent()[name]
    assert wanted <= getattr(emitted, name) <= wanted + 2


def test_theta_is_off_by_four_units_at_most() -> None:
    """Of an angle below π, whose unit in the last place is 4 u."""
    assert emitted.COUNT_THETA == 4 * math.ulp(3.0) / 2.0**-53


def test_each_rule_of_counting() -> None:
    x, y = sp.symbols("x y", positive=True)
    a, b = Counted(x, 3), Counted(y, 5)
    for value, size, count, cancels in (
        (a + b, x + y, 6, False), (a - b, x + y, 6, True), (1 - a, 1 + x, 4, True), (2 + b, 2 + y, 6, False), (-a, x, 3, False),
        (a * b, x * y, 9, False), (a * 3, 3 * x, 4, False), (0.5 * a, x / 2, 3, False), (a / b, x / y, 9, False),
        (a / 4.0, x / 4, 3, False), (1 / a, 1 / x, 4, False), ((a - b) * a, x * (x + y), 10, True),
        (a * (a - b), x * (x + y), 10, True), ((a - b) / a, (x + y) / x, 10, True), ((a - b) + a, 2 * x + y, 7, True),
        (a + (a - b), 2 * x + y, 7, True), (a * -3, 3 * x, 4, False), (-2 * a, 2 * x, 3, False),
        (Counted(sp.Integer(2)) * a, 2 * x, 3, False), (a * Counted(sp.Integer(2), 1), 2 * x, 5, False),
    ):  # fmt: skip
        assert sp.simplify(value.size - size) == 0
        assert (value.count, value.cancels) == (count, cancels)
    with pytest.raises(ArithmeticError, match="may cancel"):
        a / (a - b)
    with pytest.raises(ArithmeticError, match="may cancel"):
        1 / (1 - a)


def test_each_rule_of_following() -> None:
    x, y, z = sp.symbols("x y z", positive=True)
    known = {x: Counted(x, 3), y: Counted(y, 5), z: Counted(z, 1, True)}
    for expression, size, count, cancels in (
        (x, x, 3, False), (x + y, x + y, 6, False), (x + y + 1, x + y + 1, 7, False), (x - y, x + y, 6, True),
        (x + z, x + z, 4, True), (x * y, x * y, 9, False), (2 * x, 2 * x, 3, False), (-x, x, 3, False), (3 * x, 3 * x, 4, False),
        (x / 3, x / 3, 5, False), (x / 4, x / 4, 3, False), (x * y * 2, 2 * x * y, 9, False), (z * x, x * z, 5, True),
        (x**2, x**2, 7, False), (z**2, z**2, 3, True), (1 / x, 1 / x, 4, False), (sp.Abs(z, evaluate=False), z, 1, True),
        (sp.Integer(-3), 3, 0, False), (sp.Rational(1, 3), sp.Rational(1, 3), 1, False),
        (sp.Rational(-1, 3), sp.Rational(1, 3), 1, False), (x - 2, x + 2, 4, True),
        (sp.Rational(3, 4), sp.Rational(3, 4), 0, False),
    ):  # fmt: skip
        value = bounds._follow(expression, known)
        assert sp.simplify(value.size - size) == 0
        assert value.count == count, expression
        assert value.cancels == cancels, expression
    for nothing in (sp.sin(x), x**3):
        with pytest.raises(ArithmeticError, match="no bound"):
            bounds._follow(nothing, known)


def test_sizes_that_do_not_cover_are_refused() -> None:
    x, y = sp.symbols("x y", positive=True)
    bounds._covers(x * y + x, x * y)
    bounds._covers(x * y + x / 2, x * y)
    bounds._covers(x, x)
    with pytest.raises(ArithmeticError, match="does not cover"):
        bounds._covers(2 * x, x + y)
    sure, open_ = Counted(x), Counted(x, 0, True)
    bounds._same_sizes((sure, sure, sure, sure), (sure, sure))
    for coefficients, given in (
        ((sure, open_, sure, sure), (sure, sure)), ((sure, sure, sure, open_), (sure, sure)),
        ((sure, sure, sure, sure), (Counted(y), sure)), ((sure, sure, sure, sure), (sure, Counted(2 * x))),
    ):  # fmt: skip
        with pytest.raises(ArithmeticError):
            bounds._same_sizes(coefficients, given)


# ------------------------------------------------------------------------------------------- what the counts stand on
# All of these take the whole derivation, in make check; the independent counts above hold the emitted ones in make test.


def _counts(name: str, places: set[int], factors: int) -> dict[str, float]:
    """The counts, were some results of a generated function times this many factors 1 + β, 2 + β, …: two roundings each."""
    function = _functions()[name]
    further = sp.Mul(*(k + nm.beta for k in range(1, factors + 1)))
    results = tuple(value * further if i in places else value for i, value in enumerate(flatten(function.results)))
    return bounds.counts(_kernel(), _functions() | {name: replace(function, results=results)})


def _kernel() -> language.Source:
    return emission.kernel()


@pytest.mark.thorough
@pytest.mark.parametrize(("place", "more"), [(0, 160), (1, 80), (2, 160)])
def test_x_is_bounded_once_with_L_and_once_with_itself(place: int, more: int) -> None:
    """Where x decides, its roundings count half."""
    few, many = (_counts("state", {place}, factors)["COUNT_STATE"] for factors in (80, 160))
    assert many - few == more


@pytest.mark.thorough
def test_a_rounding_is_an_eighth_of_the_uncertainty() -> None:
    """The kernel adds 8 u to it. In 4 K₁₂ K₂₁ the roundings of an entry count twice."""
    few, many = (_counts("stiffness", {0, 1, 2, 3}, factors)["COUNT_K"] for factors in (80, 160))
    assert many - few == 2 * 160 / 8
    few, many = (_counts("stiffness", {0}, factors)["COUNT_K"] for factors in (80, 160))
    assert many - few == 2 * 160 / 8  # (K₁₁ − K₂₂)²


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("printed", "instead"), [("(r1_size + m_size * mean) / 3.0", "r1_size / 3.0"), ("0.5 * (r0_size + mean", "0.5 * (mean")]
)
def test_a_kernel_whose_size_is_too_small_is_refused(printed: str, instead: str) -> None:
    source = _kernel()
    assert source.text.count(printed) == 1
    with pytest.raises(ArithmeticError, match="does not cover"):
        bounds.counts(replace(source, text=source.text.replace(printed, instead)), _functions())


@pytest.mark.thorough
def test_magnitudes_that_are_not_those_of_the_coefficients_are_refused() -> None:
    function = _functions()["f_magnitudes"]
    for place in (0, 1):
        results = tuple(2 * value if i == place else value for i, value in enumerate(function.results))
        with pytest.raises(ArithmeticError, match="where the terms add up"):
            bounds.counts(_kernel(), _functions() | {"f_magnitudes": replace(function, results=results)})
