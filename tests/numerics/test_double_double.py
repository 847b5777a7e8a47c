"""Double-double arithmetic: its bounds against exact fractions, and the rung that stands on it
against proofs and other bits.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym.generated import double_double as dd
from spragsym.generated import kernel
from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam.quartic import adaptive_precision, block, compiled
from spragsym.numerics.double_double import DoubleDouble, cosine_and_sine
from tests.oracles.families import FAMILIES
from tests.oracles.true_errors import worst_errors, wrong_counts

#: The unit in which the bounds of single operations are known.
UNIT = Fraction(1, 2**106)


def _exactly(high: Any, low: Any) -> Fraction:
    return Fraction(float(high)) + Fraction(float(low))


def _pairs(rng: np.random.Generator, n: int) -> list[tuple[float, float]]:
    """Numbers of two parts, among them those that lie next to halves of the last place, where the
    most is lost.
    """
    high = rng.uniform(1, 2, n) * 2.0 ** rng.integers(-30, 30, n) * rng.choice([-1.0, 1.0], n)
    edge = np.where(rng.random(n) < 0.5, 0.5 - 2.0**-50, rng.uniform(-0.5, 0.5, n))
    low = np.spacing(high) * edge * rng.choice([-1.0, 1.0], n)
    total = high + low
    return [*zip(total.tolist(), (low - (total - high)).tolist(), strict=True)]


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("operation", "truth", "bound"),
    [
        (dd.dd_add, lambda x, y: x + y, 3),
        (dd.dd_multiply, lambda x, y: x * y, 7),
        (dd.dd_divide, lambda x, y: x / y, 15),
    ],
    ids=["sum", "product", "quotient"],
)
def test_errors_stay_within_their_bounds(
    operation: Callable[..., Any], truth: Callable[..., Fraction], bound: int
) -> None:
    """And come near them: a bound that is three times too large would hide a wrong operation."""
    rng, worst = np.random.default_rng(41), Fraction(0)
    given = [*zip(_pairs(rng, 6000), _pairs(rng, 6000), strict=True)]
    given += [
        (x, (-x[0] * (1 + k * 2.0**-52), -x[1] * 0.7))
        for k in range(-8, 8)
        for x in _pairs(rng, 60)
    ]  # cancelling
    for x, y in given:
        got = operation(dd.Wide(*x), dd.Wide(*y))
        exact = truth(_exactly(*x), _exactly(*y))
        assert got.high == got.high + got.low
        if exact:
            worst = max(worst, abs(_exactly(*got) - exact) / abs(exact) / UNIT)
        else:
            assert _exactly(*got) == 0
    assert worst <= bound
    assert worst > Fraction(bound, 4)


def test_operations_with_one_double_lose_less() -> None:
    rng = np.random.default_rng(42)
    for x, y in zip(_pairs(rng, 4000), _pairs(rng, 4000), strict=True):
        both = _exactly(*x), Fraction(y[0])
        for operation, exact in (
            (dd.dd_add_double, both[0] + both[1]),
            (dd.dd_multiply_double, both[0] * both[1]),
        ):
            got = operation(dd.Wide(*x), y[0])
            assert abs(_exactly(*got) - exact) <= 2 * UNIT * abs(exact)


def test_transformations_are_exact() -> None:
    rng = np.random.default_rng(43)
    for a, b in rng.uniform(-1, 1, (4000, 2)) * 2.0 ** rng.integers(-200, 200, (4000, 2)):
        large, small = (a, b) if abs(a) >= abs(b) else (b, a)
        assert (
            _exactly(*dd.two_sum(a, b))
            == Fraction(a) + Fraction(b)
            == _exactly(*dd.fast_two_sum(large, small))
        )
        assert _exactly(*dd.two_product(a, b)) == Fraction(a) * Fraction(b)


def test_the_roundoff_of_the_kernel_covers_every_operation() -> None:
    """2^-102 is sixteen units, and a quotient loses fifteen; two of it cover the cosine and sine of
    θ₀, as counted.
    """
    assert Fraction(kernel.WIDE_ROUNDOFF) == 16 * UNIT
    edges = [
        x for quarter in (0.25, 0.5, 0.75, 1.0) for x in np.nextafter(quarter * np.pi, [0.0, 4.0])
    ]
    angles = [
        *np.random.default_rng(44).uniform(0, np.pi, 1500),
        0.5 * np.pi,
        1e-300,
        5e-9,
        *edges[:-1],
    ]
    cosine, sine = cosine_and_sine(np.array(angles))
    with mpmath.workdps(60):
        for i, angle in enumerate(angles):
            for got, exact in (
                (cosine, mpmath.cos(mpmath.mpf(angle))),
                (sine, mpmath.sin(mpmath.mpf(angle))),
            ):
                found = mpmath.mpf(float(got.high[i])) + mpmath.mpf(float(got.low[i]))
                assert abs(found - exact) <= 2 * kernel.WIDE_ROUNDOFF * abs(exact)


def test_what_is_not_known_of_double_doubles_is_refused() -> None:
    """What is, the kernel uses: its bits are those of C."""
    x = DoubleDouble(np.ones(2))
    assert (x >= x).all()
    with pytest.raises(TypeError):
        np.exp(x)
    with pytest.raises(TypeError):
        np.concatenate([x, x])


# ------------------------------------------------------------------------------------------------
# the rung


def _hard(n: int) -> ss.Parameters:
    parts = [
        FAMILIES[name](np.random.default_rng([46, i]), n)
        for i, name in enumerate(("near folds", "cusp wedge", "light preload"))
    ]
    return ss.Parameters(
        *(
            np.concatenate([np.broadcast_to(getattr(p, name), p.shape) for p in parts])
            for name in PARAMETERS
        )
    )


def test_the_cusp_wedge_needs_no_intervals(monkeypatch: pytest.MonkeyPatch) -> None:
    """Counts and digits by an independent reference; what double-double arithmetic can't settle
    would fail here.
    """
    monkeypatch.setattr(
        adaptive_precision,
        "equilibria",
        lambda *_, **__: pytest.fail("a point went on to intervals"),
    )
    p, rng = FAMILIES["cusp wedge"](np.random.default_rng(47), 500), np.random.default_rng(48)
    for backend in ("numpy", "auto"):
        ss.kang_nam.set_backend(backend)
        eq = ss.equilibria(p)
        assert eq.escalated.mean() > 0.8
        assert wrong_counts(p, eq) == 0
        worst, ratio = worst_errors(p, eq, rng, 40)
        assert ratio <= 1
        assert worst <= 1e-12
    ss.kang_nam.set_backend("auto")


@pytest.mark.skipif(
    not compiled.available(), reason="the compiled solver was not built: no C compiler"
)
@pytest.mark.parametrize("contact", [True, False])
def test_c_and_numpy_have_the_same_bits(contact: bool) -> None:
    p = _hard(300)
    values = [np.ascontiguousarray(value) for value in p.broadcast(*PARAMETERS)]
    found = []
    for solve in (compiled.solve_widely, block.solve_widely):
        out = block.Slots(p.shape[0], 3 if contact else 4)
        with np.errstate(all="ignore"):
            left = solve(values, contact, out, 0, p.shape[0])
        out.count[left] = 0
        found.append((left, out))
    np.testing.assert_array_equal(found[0][0], found[1][0])
    np.testing.assert_array_equal(found[0][1].count, found[1][1].count)
    for name in block.COLUMNS:
        np.testing.assert_array_equal(found[0][1].padded(name), found[1][1].padded(name))
