"""Tapes against NumPy's intervals, bit by bit, and against exact fractions."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation.defining_systems import (
    FLUTTER,
    FOLD,
    HOPF,
    Augmented,
    Family,
    cusp,
    touch,
)
from spragsym.numerics import tape
from spragsym.numerics.interval_arrays import Intervals, quiet, stacked
from spragsym.statics.balance import Balance
from spragsym.statics.systems import StateSystem
from tests.conformance.models import RESTING, load
from tests.oracles.operands import OF_THE_LIBRARY, ONE, TWO, operands

pytestmark = pytest.mark.skipif(not tape.available(), reason="no C compiler on installation")


def taped(function: Callable[..., Any], *given: Intervals) -> Intervals:
    made = tape.recorded(lambda *rows: [function(*(row[0] for row in rows))], *given)
    assert made is not None
    return made(*given)[0]


@pytest.mark.parametrize("name", [*ONE, *TWO])
def test_an_operation_gives_the_bits_of_numpy(name: str) -> None:
    rng = np.random.default_rng(80)
    function = ONE.get(name, TWO.get(name))
    given = [Intervals(operands(rng, 3000).ends[:, None]) for _ in range(1 if name in ONE else 2)]
    with quiet():
        expected = function(*(part[0] for part in given)).ends
        found = taped(function, *given).ends
    if name in OF_THE_LIBRARY:
        assert (np.isnan(found) == np.isnan(expected)).all()
        known = np.isfinite(expected)
        units = 16 * np.spacing(np.abs(expected[known]))
        assert (np.abs(found[known] - expected[known]) <= units).all()
    else:
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("name", ["sum", "product", "quotient"])
def test_what_is_exact_lies_inside(name: str) -> None:
    rng = np.random.default_rng(81)
    one, other = (10.0 ** rng.uniform(-150, 150, 2000) * rng.choice([-1, 1], 2000) for _ in "ab")
    given = [Intervals(Intervals.point(part).ends[:, None]) for part in (one, other)]
    found = taped(TWO[name], *given)
    exactly = {
        "sum": Fraction.__add__,
        "product": Fraction.__mul__,
        "quotient": Fraction.__truediv__,
    }
    for a, b, low, high in zip(one, other, found.low, found.high, strict=True):
        assert Fraction(low) <= exactly[name](Fraction(a), Fraction(b)) <= Fraction(high)


def test_what_two_results_share_is_computed_once() -> None:
    rows: list[Sequence[Any]] = []
    given = Intervals.between(np.ones((2, 5)), np.full((2, 5), 2.0))

    def function(given: Any) -> Sequence[Any]:
        rows.append(given)
        x, y = given
        return [x * y + 1, x * y - 1]

    made = tape.recorded(function, given)
    assert made is not None
    assert len(rows) == 1
    np.testing.assert_array_equal(made(given).ends, stacked(function(given), (5,)).ends)
    # Two inputs, a product, two numbers, two sums, two results.
    assert len(made.code) // 16 == 9


def test_what_looks_at_values_is_not_recorded() -> None:
    given = Intervals.between(np.ones((1, 5)), np.full((1, 5), 2.0))

    def function(given: Any) -> Sequence[Any]:
        (x,) = given
        return [x if (x.ends[1] > 0).all() else -x]

    assert tape.recorded(function, given) is None
    np.testing.assert_array_equal(tape.Tapes().evaluated("it", function, given).ends, given.ends)


def test_operations_beyond_their_arrays_are_refused() -> None:
    given = Intervals.between(np.ones((1, 5)), np.full((1, 5), 2.0))
    made = tape.recorded(lambda rows: [rows[0] * rows[0]], given)
    assert made is not None
    for field in (0, 1, 2, 3, 4, 5, 6, 8, 9, 10):  # a square and a result read one thing only
        code = np.frombuffer(made.code, dtype=np.int32).copy()
        code[field] = 10**6
        with pytest.raises(ValueError, match="beyond its arrays"):
            tape.Tape(code.tobytes(), made.numbers, made.outputs, made.slots)(given)


def systems(name: str) -> dict[str, tuple[StateSystem, np.ndarray]]:
    """Systems of a model with a column of parameters."""
    model = load(name)
    p = model.Parameters()
    out: dict[str, tuple[StateSystem, np.ndarray]] = {}
    for contact in (True, False):
        balance = Balance(model, contact)
        values = [getattr(p, code) for code in balance.parameters]
        column = np.array([[0.3 if value is None else float(value)] for value in values])
        out[f"contact {contact}"] = balance, column
    vary = tuple(code for code in balance.parameters if code in balance.balanced)
    for condition in (FOLD, touch(0), FLUTTER, HOPF):
        system = Augmented(Family.of(p, vary[:1]), condition)
        out[f"condition {len(out)}"] = system, system.family.begin
    if len(vary) > 1:
        system = Augmented(Family.of(p, vary[:2]), cusp(0))
        out["cusp"] = system, system.family.begin
    return out


@pytest.mark.thorough
@pytest.mark.parametrize("name", RESTING)
def test_systems_over_boxes_are_what_they_are_by_numpy(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng(82)
    for key, (system, column) in systems(name).items():
        count = 300
        middle = np.where(rng.random((system.n, count)) < 0.1, 0.0, rng.uniform(-1, 1, count))
        width = 10.0 ** rng.uniform(-6, 0.5, (system.n, count)) * rng.choice([0, 1, 1], count)
        unknowns = Intervals.between(middle - width, middle + width)
        with quiet():
            parameters = system.prepared_at(np.repeat(column, count, axis=1))
            found = asked(system, unknowns, parameters)
            with monkeypatch.context() as without:
                without.setattr(tape, "compiled", None)
                expected = asked(system, unknowns, parameters)
        off = {} if functions_of_the_c_library() else {"rtol": 1e-12, "atol": 1e-15}
        for part, other in zip(found, expected, strict=True):
            if off and part.dtype == np.float64:
                np.testing.assert_allclose(part, other, err_msg=f"{name}, {key}", **off)
            else:
                np.testing.assert_array_equal(part, other, err_msg=f"{name}, {key}")


@cache
def functions_of_the_c_library() -> bool:
    """Whether NumPy's functions have the bits of the C library's, which tapes call: where the
    processor has AVX-512, NumPy brings some of its own, within the bounds of both.
    """
    values = np.random.default_rng(0).uniform(0.1, 10.0, 10_000)
    return all(
        getattr(np, name)(values).tolist() == [getattr(math, name)(value) for value in values]
        for name in OF_THE_LIBRARY
        if hasattr(math, name)
    )


def asked(system: StateSystem, unknowns: Intervals, parameters: Intervals) -> list[np.ndarray]:
    return [
        system.residuals(unknowns, parameters).ends,
        system.jacobian(unknowns, parameters).ends,
        system.contracted(unknowns, parameters),
        system.excluded(unknowns, parameters),
    ]


def test_a_search_looks_at_the_same_boxes(monkeypatch: pytest.MonkeyPatch) -> None:
    p = ss.load("cubic_contact").Parameters(theta0=0.7)
    found = ss.folds(p, vary="mu0")
    monkeypatch.setattr(tape, "compiled", None)
    expected = ss.folds(p, vary="mu0")
    assert found.complete == expected.complete
    for name, column in found.data().items():
        np.testing.assert_array_equal(column, expected.data()[name])
