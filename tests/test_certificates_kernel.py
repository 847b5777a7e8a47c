"""Bounds of the kernel against the true rounding error, on inputs sought to be bad.

The kernel runs in float32 with the unit roundoff of float32, and float64 is the truth: it sees every rounding of the other.
Inputs are random over decades, so that each term of a bound is the largest somewhere, then bred for the largest share of its
bound that an error takes. A share above 1 is a bound that is none; one that stays low is a bound that costs more points than it
must.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from spragsym.generated import equilibrium as generated
from spragsym.statics import kernel

Array = NDArray[Any]
U = np.float32(2.0**-24)
#: θ₀, μ₀, κ, α, σ, β: decades over which they are spread.
DECADES = ((0, 0), (-2, 1.5), (-2, 1.5), (-2, 1.5), (-2, 1.5), (-2, 1.5))


@pytest.fixture(autouse=True)
def _quiet() -> Any:
    with np.errstate(all="ignore"):
        yield


def _random(rng: np.random.Generator, n: int) -> Array:
    """Rows of parameters as float32 has them, but θ₀; zeros among μ₀, α, β, and angles next to 0, π/2 and π."""
    rows = np.stack([10.0 ** rng.uniform(*ends, n) for ends in DECADES])
    rows[0] = rng.uniform(0.01, math.pi - 0.01, n)
    near = rng.random(n) < 0.3
    rows[0, near] = rng.choice([0.0, math.pi / 2, math.pi], near.sum()) + 10.0 ** rng.uniform(-4, -1, near.sum()) * rng.choice(
        [-1, 1], near.sum()
    )
    rows[0] = np.clip(np.abs(rows[0]), 1e-4, math.pi - 1e-4)
    for index in (1, 3, 5):
        rows[index, rng.random(n) < 0.1] = 0.0
    return _stored(rows)


def _stored(rows: Array) -> Array:
    return np.concatenate([rows[:1], rows[1:].astype(np.float32).astype(float)])


def _bred(rng: np.random.Generator, rows: Array, children: int, wide: bool) -> Array:
    """Each row many times, moved a little, or in its last digits."""
    rows = np.repeat(rows, children, axis=1)
    moved = rows * (1 + rng.normal(0, 0.05 if wide else 3e-7, rows.shape))
    moved[0] = np.clip(moved[0], 1e-4, math.pi - 1e-4)
    return _stored(moved)


def _worst(share: Callable[[Array], Array], seed: int, n: int = 8000, rounds: int = 5) -> float:
    """The largest share found by random search and breeding."""
    rng = np.random.default_rng(seed)
    rows = _random(rng, n)
    shares = np.nan_to_num(share(rows), nan=-1.0)
    best = float(shares.max())
    for turn in range(rounds):
        rows = _bred(rng, rows[:, np.argsort(shares)[-80:]], 40, wide=turn % 2 == 0)
        shares = np.nan_to_num(share(rows), nan=-1.0)
        best = max(best, float(shares.max()))
    return best


def _values(rows: Array, dtype: type, true: bool) -> tuple[Any, ...]:
    """cos θ₀, sin θ₀ and the others: exact, or as the type rounds them."""
    theta0, *others = rows
    angles = np.cos(theta0), np.sin(theta0)
    if not true:
        return tuple(value.astype(dtype) for value in (*angles, *others))
    return (*angles, *others)


def _line(rows: Array, nbar: int, dtype: type = np.float32) -> tuple[Any, ...]:
    """a, b, d, m and the sizes of a and d."""
    values = _values(rows, dtype, dtype is np.float64)
    return (*kernel.f_coefficients(*values, nbar), *kernel.f_magnitudes(*values, nbar))


# -------------------------------------------------------------------------------------------------- discriminant


def _discriminant(a: Array, b: Array, d: Array, m: Array) -> Array:
    """P³ + Q² of the resolvent, as textbooks shift it: nothing of the kernel's."""
    r0, r1, r2 = generated.resolvent(a, b, d, m)
    P, Q = (3 * r1 - r2**2) / 9, (27 * r0 - 9 * r1 * r2 + 2 * r2**3) / 54
    return P**3 + Q**2


@pytest.mark.parametrize(("nbar", "least"), [(1, 0.3), (0, 0.3)])
def test_the_discriminants_bound_holds(nbar: int, least: float) -> None:
    def share(rows: Array) -> Array:
        value, error = kernel.discriminant(*_line(rows, nbar), U)
        true = _discriminant(*_line(rows, nbar, np.float64)[:4])
        assert value.dtype == np.float32
        return np.abs(value - true) / error

    assert least < _worst(share, 1) <= 1


#: Where one term is all that is left: θ₀, μ₀, κ, α, σ, β.
ALONE = {
    "d by alpha": (0.01, 0.0, 0.01, 30.0, 0.01, 0.0),
    "d by friction": (1.5, 30.0, 0.01, 0.0, 1.0, 1.0),
    "d by preload": (1.5, 30.0, 30.0, 0.0, 0.01, 0.0), "a": (0.001, 0.0, 0.01, 0.0, 30.0, 30.0),
    "b": (1.5, 0.0, 30.0, 0.01, 0.01, 0.0),
    "b by beta": (1.5, 0.0, 0.01, 0.01, 0.01, 30.0), "m": (0.001, 30.0, 0.01, 0.0, 30.0, 0.0),
    "a by alpha": (1.57, 0.0, 0.01, 30.0, 30.0, 0.0),
}  # fmt: skip


@pytest.mark.parametrize("name", ALONE)
def test_the_discriminants_bound_holds_term_by_term(name: str) -> None:
    """Next to the point where one term of the bound carries it."""
    rng = np.random.default_rng(2)
    rows = _stored(np.array(ALONE[name])[:, None] * (1 + rng.normal(0, 0.02, (6, 20000))))
    value, error = kernel.discriminant(*_line(rows, 1), U)
    true = _discriminant(*_line(rows, 1, np.float64)[:4])
    share = np.abs(value - true) / error
    assert (error > 0).all()
    assert 1e-4 < share.max() <= 1


def test_the_bound_stays_one_where_digits_underflow() -> None:
    """In float64, with D about the smallest number that it has."""
    rng = np.random.default_rng(3)
    for _ in range(300):
        a, b, d, m = (float(value) for value in rng.choice([-1, 1], 4) * 10.0 ** rng.uniform(-54.5, -52, 4))
        value, error = kernel.discriminant(*map(np.float64, (a, b, d, m, abs(a), abs(d))), np.float64(2.0**-53))
        with mpmath.workdps(60):
            P, Q = kernel.depressed(*kernel.resolvent(*map(mpmath.mpf, (a, b, d, m))))
            assert abs(mpmath.mpf(float(value)) - (P**3 + Q**2)) <= mpmath.mpf(float(error))
        assert error < 1e-300


def test_the_depressed_cubic_is_the_resolvent_shifted() -> None:
    rng = np.random.default_rng(4)
    with mpmath.workdps(60):
        for _ in range(20):
            r0, r1, r2, z = map(mpmath.mpf, rng.normal(0, 5, 4))
            P, Q = kernel.depressed(r0, r1, r2)
            x = z - r2 / 3
            assert abs(z**3 + 3 * P * z + 2 * Q - (x**3 + r2 * x**2 + r1 * x + r0)) < 1e-50


# --------------------------------------------------------------------------------------------------------- lone


@pytest.mark.parametrize("nbar", [1, 0])
def test_lone_is_said_only_where_the_sign_is_sure_and_wherever_it_is(nbar: int) -> None:
    rng = np.random.default_rng(5)
    rows = _random(rng, 40000)
    # Half of them with μ₀ such that e₁ = 2 (a + d) is about 0: it is linear in μ₀.
    moved = [np.concatenate([rows[:1], np.full_like(rows[1:2], mu), rows[2:]]) for mu in (0, 1)]
    at = [kernel.t_quartic(*_line(some, 1, np.float64)[:4])[1] for some in moved]
    zero = at[0] / (at[0] - at[1])
    near = (zero > 0) & (zero < 50) & (rng.random(40000) < 0.7)
    rows[1, near] = zero[near] * (1 + rng.choice([-1, 1], near.sum()) * 10.0 ** rng.uniform(-8, -2, near.sum()))
    rows = _stored(rows)
    line, true = _line(rows, nbar), _line(rows, nbar, np.float64)
    e1 = kernel.t_quartic(*true[:4])[1]
    said = kernel.lone(*line, U)
    assert not (said & (e1 >= 0)).any()
    size = true[4] + true[5]
    assert said[e1 < -4.2 * kernel.IN_F * float(U) * size].all()
    assert not said[e1 > -1.0 * kernel.IN_F * float(U) * size].any()
    share = np.abs(kernel.t_quartic(*line[:4])[1] - e1) / (2 * kernel.IN_F * float(U) * size)
    assert 0.05 < np.nanmax(share) <= 1


# ------------------------------------------------------------------------------------------------------ at_root


def _true_root(theta: Array, line: tuple[Array, ...]) -> Array:
    """The root of f next to θ by Newton's method in float64."""
    for _ in range(8):
        theta = theta - kernel.f(np.cos(theta), np.sin(theta), *line) / kernel.f_slope(np.cos(theta), np.sin(theta), *line)
    return theta


def _at_roots(rows: Array, nbar: int, rng: np.random.Generator, off: float) -> tuple[Array, dict[str, Array], dict[str, Array]]:
    """What the kernel says at a root that is a little off, and the truth; only where a root is proved."""
    line, true = _line(rows, nbar), _line(rows, nbar, np.float64)
    p1, q1, p2, q2 = kernel.factors(*true[:4])
    first, second = kernel.root_pair(p1, q1), kernel.root_pair(p2, q2)
    t = np.choose(rng.integers(0, 4, rows.shape[1]), [first[0], first[1], second[0], second[1]])
    t32 = (t * (1 + off * rng.normal(0, 1, t.size))).astype(np.float32)
    values = _values(rows, np.float32, False)
    names = ("L", "x", "y", "radius", "error", "member", "outsider", "code")
    got = dict(zip(names, kernel.at_root(t32, *line, *values, np.float32(nbar), U), strict=True))
    proved = np.isfinite(got["radius"])
    got = {name: np.broadcast_to(value, proved.shape)[proved] for name, value in got.items()}
    kept, true = rows[:, proved], tuple(np.broadcast_to(value, proved.shape)[proved] for value in true)
    got["theta"] = 2 * np.arctan(t32[proved].astype(float))
    theta = _true_root(got["theta"], true[:4])
    exact = _values(kept, np.float64, True)
    L, x, y = kernel.state(np.cos(theta), np.sin(theta), exact[0], exact[1], exact[3], exact[5], exact[6], nbar)
    return kept, got, {"theta": theta, "L": L, "x": x, "y": y}


@pytest.mark.parametrize("nbar", [1, 0])
@pytest.mark.parametrize(("off", "least"), [(1e-7, 0.3), (1e-5, 0.8)])
def test_radius_and_error_of_a_state_hold(nbar: int, off: float, least: float) -> None:
    """At roots to the last digit and at such that are off, where the radius is nearly all."""
    rng = np.random.default_rng([6, nbar])
    shares: list[float] = []
    radii: list[float] = []
    for _ in range(3):
        _, got, true = _at_roots(_random(rng, 40000), nbar, rng, off)
        assert got["theta"].size > 10000
        radius = np.abs(got["theta"] - true["theta"]) / got["radius"]
        each = [np.abs(got[name] - true[name]) / np.maximum(1, np.abs(got[name])) / got["error"] for name in true]
        assert np.nanmax(radius) <= 1
        radii.append(float(np.nanmax(radius)))
        shares += [float(np.nanmax(one)) for one in each]
    assert max(shares) <= 1
    assert least / 2 < max(shares)
    assert least < max(radii)


def test_the_error_holds_where_one_term_carries_it() -> None:
    """States with large L at small angles, with stiff springs, heavy preloads, and with large swings of sine and cosine."""
    rng = np.random.default_rng(7)
    for index in range(1, 6):
        for size in (100.0, 1e-3):
            rows = _random(rng, 5000)
            rows[index] = size
            for nbar in (0, 1):
                for off in (3e-8, 1e-6, 1e-4):
                    _, got, true = _at_roots(_stored(rows), nbar, rng, off)
                    for name in ("x", "y", "L"):
                        error = np.abs(got[name] - true[name]) / np.maximum(1, np.abs(got[name]))
                        assert np.nanmax(error / got["error"], initial=0) <= 1


@pytest.mark.parametrize("nbar", [1, 0])
def test_membership_and_stability_are_said_only_where_sure_and_mostly_said(nbar: int) -> None:
    rng = np.random.default_rng([8, nbar])
    for off in (1e-7, 1e-4):
        rows, got, true = _at_roots(_random(rng, 60000), nbar, rng, off)
        inside = (true["L"] > 0) & ((true["y"] < 0) == bool(nbar))
        assert not (got["member"] & ~inside).any()
        assert not (got["outsider"] & inside).any()
        assert (got["member"] | got["outsider"]).mean() > (0.98 if off < 1e-6 else 0.7)
        code = _true_code(rows, true, nbar)
        said = (got["code"] > 0) & got["member"]
        assert (got["code"][said] == code[said]).all()
        assert said[inside].mean() > (0.95 if off < 1e-6 else 0.4)
        assert set(np.unique(code[said])) >= ({1, 2, 3} if nbar else {1, 2})


def _true_code(rows: Array, state: dict[str, Array], nbar: int) -> Array:
    """By the eigenvalues of the stiffnesses, written out."""
    _, mu0, _, alpha, sigma, beta = rows
    c, s, L = np.cos(state["theta"]), np.sin(state["theta"]), state["L"]
    K11, K12 = sigma * (1 - s * s / L) + alpha, sigma / L * s * c + mu0 * nbar
    K21, K22 = sigma / L * s * c, sigma * (1 - c * c / L) + beta + nbar
    half, determinant = 0.5 * (K11 + K22), K11 * K22 - K12 * K21
    flutter = 0.25 * (K11 - K22) ** 2 + K12 * K21
    least = np.minimum(half - np.sqrt(np.abs(flutter)), determinant)
    return np.where(flutter < 0, 3, np.where((least < 0) | (half < 0), 2, 1))


@pytest.mark.parametrize("carrier", range(5))
def test_a_code_outlives_every_error_within_the_uncertainty(carrier: int) -> None:
    """cos, sin, L moved by as much as is uncertain; next to where discriminant or trace vanish, one term carrying the margin."""
    rng = np.random.default_rng([9, carrier])
    n = 40000
    theta, L = rng.uniform(0.02, 3.12, n), 10.0 ** rng.uniform(-2, 1, n) * (1 if carrier else 0.1)
    mu0, alpha, sigma, beta = (10.0 ** rng.uniform(-2, 1, n) for _ in range(4))
    for index, value in enumerate((mu0, alpha, sigma, beta), start=1):
        value *= 30.0 if index == carrier else 1.0
    c, s, nbar = np.cos(theta), np.sin(theta), (rng.random(n) < 0.8) * 1.0
    (K11, _), (K21, K22) = kernel.stiffness(c, s, L, 0.0, alpha, sigma, beta, nbar)
    critical = -((K11 - K22) ** 2) / (4 * K21) - K21
    near = (critical > 0) & (rng.random(n) < 0.6)
    mu0 = np.where(near, critical * (1 + rng.choice([-1, 1], n) * 10.0 ** rng.uniform(-6, -1, n)), mu0)
    uncertainty = 10.0 ** rng.uniform(-6, -2, n)
    (K11, K12), (K21, K22) = kernel.stiffness(c, s, L, mu0, alpha, sigma, beta, nbar)
    slope = L * (K11 * K22 - K12 * K21)
    said = kernel.stability(c, s, L, slope, uncertainty, mu0, alpha, sigma, beta, nbar)
    for _ in range(12):
        turn = theta + uncertainty * rng.choice([-1, 1], n) * np.minimum(s, 1)
        stretch = L * (1 + uncertainty * rng.choice([-1, 1], n))
        (K11, K12), (K21, K22) = kernel.stiffness(np.cos(turn), np.sin(turn), stretch, mu0, alpha, sigma, beta, nbar)
        trace, _, flutter = kernel.invariants(K11, K12, K21, K22)
        code = np.where(flutter < 0, 3, np.where((slope < 0) | (trace < 0), 2, 1))
        assert ((said == 0) | (said == code)).all()
    sure = (uncertainty < 1e-5) & ~near
    assert (said[sure] > 0).mean() > 0.8


# ------------------------------------------------------------------------------------------ factors and their means


def _monic(line: tuple[float, ...]) -> list[mpmath.mpf]:
    e0, e1, e2, e3, e4 = kernel.t_quartic(*map(mpmath.mpf, line))
    return [value / e4 for value in (e0, e1, e2, e3)]


def _lines(rng: np.random.Generator, n: int) -> list[tuple[float, ...]]:
    """a, b, d, m of random points, and of such next to a fold."""
    rows = _random(rng, n)
    a, b, d, m = (np.broadcast_to(value, n) for value in _line(rows, 1, np.float64)[:4])
    theta = rng.uniform(0.2, 2.9, n)
    s, c = np.sin(theta), np.cos(theta)
    fold = rng.random(n) < 0.5
    gap = 10.0 ** rng.uniform(-14, -2, n)
    b = np.where(fold & (a * s**3 + m * s * s * c > 0), -(a * s**3 + m * s * s * c) * (1 + gap), b)
    d = np.where(b == b, np.where(fold, -a * c**3 + m * s * (1 + c * c), d), d)
    return [tuple(map(float, row)) for row in zip(a, b, d, m, strict=True)]


def test_the_factors_multiply_to_the_quartic() -> None:
    """To a few roundings of its coefficients and roots, next to folds as elsewhere."""
    worst = 0.0
    with mpmath.workdps(60):
        for line in _lines(np.random.default_rng(10), 600):
            p1, q1, p2, q2 = (mpmath.mpf(float(value)) for value in kernel.factors(*map(np.float64, line)))
            assert q1 < 0 < q2
            A0, A1, A2, A3 = _monic(line)
            sizes = (abs(q1 * q2), abs(p1 * q2) + abs(p2 * q1), abs(q1) + abs(q2) + abs(p1 * p2), abs(p1) + abs(p2))
            gaps = (q1 * q2 - A0, p1 * q2 + p2 * q1 - A1, q1 + q2 + p1 * p2 - A2, p1 + p2 - A3)
            worst = max(worst, *(float(abs(gap) / size) * 2.0**53 for gap, size in zip(gaps, sizes, strict=True)))
    assert worst < 6


def test_the_resolvents_root_is_the_one_apart_to_a_few_roundings() -> None:
    worst = 0.0
    with mpmath.workdps(60):
        for line in _lines(np.random.default_rng(11), 500):
            coefficients = kernel.resolvent(*map(mpmath.mpf, line))
            r0, r1, r2 = coefficients
            x = far = mpmath.mpf(float(kernel.simple_root(*map(np.float64, line))))
            for _ in range(8):
                slope = (3 * far + 2 * r2) * far + r1
                far -= (((far + r2) * far + r1) * far + r0) / slope if slope else 0
            P, Q = kernel.depressed(*coefficients)
            if P**3 + Q**2 < 0:  # of three, 2 √−P cos(φ/3) with φ ≤ π/2
                assert (far + r2 / 3) ** 2 > -2.999 * P
            blur = abs(3 * far * far + 2 * coefficients[2] * far + coefficients[1])
            a, b, d, m = map(abs, map(mpmath.mpf, line))  # the coefficients with every term positive
            size = abs(far) ** 3 + m * far * far + (a * a + b * b + d * d) / 4 * abs(far) + b * (a * d + m * b) / 4
            worst = max(worst, float(abs(x - far) * blur / (size + blur * abs(far) + mpmath.mpf("1e-300"))) * 2.0**53)
    assert worst < 8


def test_polish_squares_the_error() -> None:
    """From factors a little off, one step leaves the square of that; the exact factors stay."""
    rng = np.random.default_rng(12)
    with mpmath.workdps(80):
        for _ in range(60):
            p1, q1, p2 = (mpmath.mpf(float(value)) for value in rng.normal(0, 2, 3))
            q1 = -abs(q1) - mpmath.mpf("0.1")
            q2 = -1 / q1
            monic = (p1 * q2 + p2 * q1, q1 + q2 + p1 * p2, p1 + p2)
            size = max(map(abs, (p1, q1, p2, q2)))
            signs = map(float, rng.choice([-1, 1], 4))
            off = [value + sign * mpmath.mpf(10) ** -20 for value, sign in zip((p1, q1, p2, q2), signs, strict=True)]
            for start, least in (((p1, q1, p2, q2), mpmath.mpf(10) ** -70), (off, mpmath.mpf(10) ** -34)):
                after = kernel.polish(*monic, *start)
                assert max(abs(new - old) for new, old in zip(after, (p1, q1, p2, q2), strict=True)) < least * (1 + size) ** 4


def test_root_pairs() -> None:
    """The larger first, both to a rounding or two, and the sign of the discriminant."""
    rng = np.random.default_rng(13)
    with mpmath.workdps(40):
        for _ in range(300):
            p, q = float(rng.normal()) * 10 ** rng.uniform(-3, 3), float(rng.choice([-1, 1])) * 10 ** rng.uniform(-3, 3)
            large, small, square = kernel.root_pair(np.float64(p), np.float64(q))
            exact = mpmath.mpf(p) ** 2 / 4 - q
            assert (square > 0) == (exact > 0)
            assert abs(square - exact) < 1e-15 * (p * p + abs(q))
            if square <= 1e-3 * (p * p + abs(q)):
                continue
            one = -(mpmath.mpf(p) / 2 + mpmath.sign(p) * mpmath.sqrt(exact))
            assert abs(large - one) < 1e-12 * abs(one)
            assert abs(small - q / one) < 1e-12 * abs(q / one)
            assert abs(large) >= abs(small)
    assert kernel.root_pair(np.float64(2.0), np.float64(5.0))[2] == -4.0


def test_apart_means_apart() -> None:
    """Intervals around 2 atan t, whose gap is about the sum of their radii, for t of any size and sign."""
    rng = np.random.default_rng(14)
    n = 20000
    low = rng.choice([-1, 1], n) * 10.0 ** rng.uniform(-3, 3, n)
    high = low + 10.0 ** rng.uniform(-6, -1, n) * (1 + low * low)
    gap = 2 * (np.arctan(high) - np.arctan(low))
    good = gap > 1e-7
    share = rng.uniform(0, 1, n)
    for fill in (0.5, 0.9, 1.01):
        said = kernel.apart(low, fill * gap * share, high, fill * gap * (1 - share))
        if fill > 1:
            assert not said[good].any()
        near = good & (gap < 1e-4)
        if fill < 0.6:
            assert said[near].mean() > 0.9


# ----------------------------------------------------------------------------------------------- sines and ranges


def test_cosine_and_sine_to_a_unit_in_the_last_place() -> None:
    """At random, and next to 0, π/4, π/2, 3π/4 and π."""
    rng = np.random.default_rng(15)
    places = np.array([0.0, 0.25, 0.5, 0.75, 1.0]) * math.pi
    around = [place + rng.choice([-1, 1], 120) * 10.0 ** rng.uniform(-16, -1, 120) for place in places]
    x = np.concatenate([rng.uniform(0, math.pi, 400), *around])
    x = np.concatenate([x, places[1:4], np.nextafter(places[1:4], 0), np.nextafter(places[1:4], 4), [5e-324, 1e-300]])
    x = x[(x > 0) & (x < math.pi)]
    cosine, sine = kernel.cosine_and_sine(x)
    with mpmath.workdps(50):
        for value, c, s in zip(x, cosine, sine, strict=True):
            for got, true in ((c, mpmath.cos(float(value))), (s, mpmath.sin(float(value)))):
                assert abs(mpmath.mpf(float(got)) - true) <= 0.9 * math.ulp(float(true))


def test_what_underflow_may_touch_is_not_normal() -> None:
    fine, small, none = 1.0, 1e-251, 0.0
    assert kernel.normal(*[np.float64(fine)] * 6)
    for index, name in enumerate(("sin0", "mu0", "kappa", "alpha", "sigma", "beta")):
        for value in (small, none):
            given = [np.float64(fine)] * 6
            given[index] = np.float64(value)
            assert bool(kernel.normal(*given)) == (value == none and name in ("mu0", "alpha", "beta"))
        given[index] = np.float64(1.1e-250)
        assert kernel.normal(*given)
