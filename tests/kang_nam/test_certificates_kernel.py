"""Bounds of the kernel against the true rounding error, on inputs sought to be bad.

The kernel runs in float32 with the unit roundoff of float32, and float64 is the truth: it sees
every rounding of the other. Inputs are random over decades, so that each term of a bound is the
largest somewhere. An error above its bound is a bound that is none; a bound that no error comes
near costs more points than it must.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from numpy.typing import NDArray

import spragsym as ss
from spragsym.generated import equilibrium as generated
from spragsym.generated import kernel
from spragsym.generated.kernel import Direction, LineBalance, Point, Root

Array = NDArray[Any]
U = np.float32(2.0**-24)
#: θ₀, μ₀, κ, α, σ, β: decades over which they are spread.
DECADES = ((0, 0), (-2, 1.5), (-2, 1.5), (-2, 1.5), (-2, 1.5), (-2, 1.5))


pytestmark = pytest.mark.usefixtures("silent")


def _random(rng: np.random.Generator, n: int) -> Array:
    """Rows of parameters as float32 has them, but θ₀; zeros among μ₀, α, β, and angles next to 0,
    π/2 and π.
    """
    rows = np.stack([10.0 ** rng.uniform(*ends, n) for ends in DECADES])
    rows[0] = rng.uniform(0.01, math.pi - 0.01, n)
    near = rng.random(n) < 0.3
    rows[0, near] = rng.choice([0.0, math.pi / 2, math.pi], near.sum()) + 10.0 ** rng.uniform(
        -4, -1, near.sum()
    ) * rng.choice([-1, 1], near.sum())
    rows[0] = np.clip(np.abs(rows[0]), 1e-4, math.pi - 1e-4)
    for index in (1, 3, 5):
        rows[index, rng.random(n) < 0.1] = 0.0
    return _stored(rows)


def _stored(rows: Array) -> Array:
    return np.concatenate([rows[:1], rows[1:].astype(np.float32).astype(float)])


def _point(rows: Array, nbar: int, dtype: type = np.float32) -> Point:
    """cos θ₀, sin θ₀ and the others: as the type rounds them, exact for float64."""
    theta0, *others = rows
    return Point(
        *(value.astype(dtype) for value in (np.cos(theta0), np.sin(theta0), *others)), dtype(nbar)
    )


def _line(rows: Array, nbar: int) -> LineBalance:
    return kernel.balance(_point(rows, nbar))


def _true_line(rows: Array, nbar: int) -> LineBalance:
    """The same in float64, over the same number: what float32 rounds beside the common factor is
    all that differs.
    """
    point = _point(rows, nbar, np.float64)
    over = (np.float32(1) / _line(rows, nbar).scale).astype(float)
    values = (*kernel.f_coefficients(*point), *kernel.f_magnitudes(*point))
    return LineBalance(*(value * over for value in values), 1 / over)


class Sized:
    """A number with its size, the sum of the absolute values of its terms: how generated algebra
    cancels at most.
    """

    __array_ufunc__ = None  # an array times this is this times the array

    def __init__(self, value: Any, size: Any = None) -> None:
        self.value, self.size = value, np.abs(value) if size is None else size

    def __add__(self, other: Any) -> Sized:
        other = _sized(other)
        return Sized(self.value + other.value, self.size + other.size)

    def __neg__(self) -> Sized:
        return Sized(-self.value, self.size)

    def __sub__(self, other: Any) -> Sized:
        return self + -_sized(other)

    def __rsub__(self, other: Any) -> Sized:
        return -self + other

    def __mul__(self, other: Any) -> Sized:
        other = _sized(other)
        return Sized(self.value * other.value, self.size * other.size)

    def __truediv__(self, other: Any) -> Sized:
        """By what does not cancel."""
        other = _sized(other)
        return Sized(self.value / other.value, self.size / np.abs(other.value))

    def __rtruediv__(self, other: Any) -> Sized:
        return _sized(other) / self

    __radd__, __rmul__ = __add__, __mul__


def _sized(value: Any) -> Sized:
    return value if isinstance(value, Sized) else Sized(value)


# ------------------------------------------------------------------------------------------------
# discriminant


def _sizes_of_the_cubic(line: LineBalance) -> tuple[Sized, Sized]:
    a, b, d, m = (
        Sized(line.a, line.a_size),
        Sized(line.b),
        Sized(line.d, line.d_size),
        Sized(line.m),
    )
    r0, r1, r2 = generated.resolvent.__wrapped__(a, b, d, m)
    mean = r2 / 3
    return (r1 - r2 * mean) / 3, (r0 - mean * (r1 - 2 * mean * mean)) / 2


@pytest.mark.parametrize("u", [2.0**-53, 1e-6, 1e-2])
def test_the_discriminants_bound_has_every_term_and_nothing_else(u: float) -> None:
    """P and Q off by all that their counts allow, then four roundings: at least that, and little
    more.
    """
    line = _true_line(_random(np.random.default_rng(30), 20000), 1)
    P, Q = _sizes_of_the_cubic(line)
    off_P, off_Q = (
        count * u * part.size for count, part in ((kernel.COUNT_P, P), (kernel.COUNT_Q, Q))
    )
    P_size, Q_size = np.abs(P.value) + off_P, np.abs(Q.value) + off_Q
    by_P = off_P * (3 * P.value**2 + 3 * np.abs(P.value) * off_P + off_P**2)
    by_Q = off_Q * (2 * np.abs(Q.value) + off_Q)
    needed = by_P + by_Q + 4 * u * (np.abs(P.value) ** 3 + Q.value**2)
    enough = (
        3 * P_size**2 * off_P + 2 * Q_size * off_Q + 4 * u * (P_size**2 * P.size + Q_size * Q.size)
    )
    value, error = kernel.discriminant(line, kernel.cubic(*line[:4]), u)
    np.testing.assert_allclose(value, P.value**3 + Q.value**2, atol=1e-13, rtol=1e-9)
    assert (error >= needed * (1 - 1e-9)).all()
    assert (error <= enough * (1 + 1e-9) + 1e-307).all()


# ------------------------------------------------------------------------------------------------
# one positive


@pytest.mark.parametrize("nbar", [1, 0])
def test_one_positive_is_said_only_where_the_sign_is_sure_and_wherever_it_is(nbar: int) -> None:
    rng = np.random.default_rng(5)
    rows = _random(rng, 40000)
    # Half of them with μ₀ such that e₁ = 2 (a + d) is about 0: it is linear in μ₀.
    at = []
    for mu0 in (0.0, 1.0):
        a, _, d, _ = kernel.f_coefficients(*_point(rows, 1, np.float64)._replace(mu0=mu0))
        at.append(a + d)
    zero = at[0] / (at[0] - at[1])
    near = (zero > 0) & (zero < 50) & (rng.random(40000) < 0.7)
    rows[1, near] = zero[near] * (
        1 + rng.choice([-1, 1], near.sum()) * 10.0 ** rng.uniform(-8, -2, near.sum())
    )
    rows = _stored(rows)
    line, true = _line(rows, nbar), _true_line(rows, nbar)
    assert (np.abs([line.a, line.d]) <= np.array([line.a_size, line.d_size]) * (1 + 1e-5)).all()
    e1, off = 2 * (true.a + true.d), 2 * kernel.COUNT_E1 * float(U) * (true.a_size + true.d_size)
    said = kernel.one_positive(line, kernel.quartic(*line[:4]), U)
    assert not (said & (e1 >= 0)).any()
    assert said[e1 < -2.1 * off].all()
    assert not said[e1 > -0.5 * off].any()
    assert 0.05 < np.nanmax(np.abs(2.0 * (line.a + line.d) - e1) / off) <= 1


# ------------------------------------------------------------------------------------------------
# at_root


def _true_root(theta: Array, line: Any) -> Array:
    """The root of f next to θ by Newton's method in float64."""
    for _ in range(8):
        theta = theta - kernel.f(np.cos(theta), np.sin(theta), *line) / kernel.f_slope(
            np.cos(theta), np.sin(theta), *line
        )
    return theta


def _at_roots(
    rows: Array, nbar: int, rng: np.random.Generator, off: float
) -> tuple[dict[str, Array], dict[str, Array]]:
    """What the kernel says at a root that is a little off, and the truth; only where a root is
    proved.
    """
    line, true = _line(rows, nbar), _true_line(rows, nbar)
    halves = kernel.factors(kernel.quartic(*true[:4]), kernel.cubic(*true[:4]))
    first, second = kernel.root_pair(halves.p1, halves.q1), kernel.root_pair(halves.p2, halves.q2)
    t = np.choose(
        rng.integers(0, 4, rows.shape[1]), [first.large, first.small, second.large, second.small]
    )
    t32 = (t * (1 + off * rng.normal(0, 1, t.size))).astype(np.float32)
    got = kernel.at_root(t32, _point(rows, nbar), line, U)._asdict()
    proved = np.isfinite(got["radius"])
    got = {name: np.broadcast_to(value, proved.shape)[proved] for name, value in got.items()}
    got["theta"] = 2 * np.arctan(t32[proved].astype(float))
    theta = _true_root(
        got["theta"], [np.broadcast_to(value, proved.shape)[proved] for value in true[:4]]
    )
    exact = _point(rows[:, proved], nbar, np.float64)
    L, x, y = kernel.state(
        np.cos(theta),
        np.sin(theta),
        exact.cos0,
        exact.sin0,
        exact.kappa,
        exact.sigma,
        exact.beta,
        nbar,
    )
    return got, {"theta": theta, "L": L, "x": x, "y": y}


@pytest.mark.parametrize("nbar", [1, 0])
@pytest.mark.parametrize(("off", "least"), [(1e-7, 0.3), (1e-5, 0.8)])
def test_radius_and_error_of_a_state_hold(nbar: int, off: float, least: float) -> None:
    """At roots to the last digit and at such that are off, where the radius is nearly all."""
    rng = np.random.default_rng([6, nbar])
    shares: list[float] = []
    radii: list[float] = []
    for _ in range(3):
        got, true = _at_roots(_random(rng, 40000), nbar, rng, off)
        assert got["theta"].size > 10000
        radius = np.abs(got["theta"] - true["theta"]) / got["radius"]
        each = [
            np.abs(got[name] - true[name]) / np.maximum(1, np.abs(got[name])) / got["error"]
            for name in true
        ]
        assert np.nanmax(radius) <= 1
        radii.append(float(np.nanmax(radius)))
        shares += [float(np.nanmax(one)) for one in each]
    assert max(shares) <= 1
    assert least / 2 < max(shares)
    assert least < max(radii)


# ------------------------------------------------------------------------------------------------
# factors and their means


def test_apart_means_apart() -> None:
    """Beside 0, where θ moves by twice as much as t, and where the larger of the two numbers says
    how much less.
    """
    assert kernel.apart(0.0, 0.099, 0.1, 0.098)
    assert not kernel.apart(0.0, 1.0, 1.0, 0.0)
    assert not kernel.apart(-1.0, 0.0, 0.0, 1.0)


# -----------------------------------------------------------------------------------------------
# sines and ranges


def test_cosine_and_sine_to_a_unit_in_the_last_place() -> None:
    """At random, and next to 0, π/4, π/2, 3π/4 and π."""
    rng = np.random.default_rng(15)
    places = np.array([0.0, 0.25, 0.5, 0.75, 1.0]) * math.pi
    around = [
        place + rng.choice([-1, 1], 120) * 10.0 ** rng.uniform(-16, -1, 120) for place in places
    ]
    x = np.concatenate([rng.uniform(0, math.pi, 400), *around])
    x = np.concatenate(
        [
            x,
            places[1:4],
            np.nextafter(places[1:4], 0),
            np.nextafter(places[1:4], 4),
            [5e-324, 1e-300],
        ]
    )
    x = x[(x > 0) & (x < math.pi)]
    cosine, sine = kernel.cosine_and_sine(x)
    with mpmath.workdps(50):
        for value, c, s in zip(x, cosine, sine, strict=True):
            for got, true in ((c, mpmath.cos(float(value))), (s, mpmath.sin(float(value)))):
                assert abs(mpmath.mpf(float(got)) - true) <= 0.8 * math.ulp(float(true))


def test_arc_tangent_to_a_unit_in_the_last_place() -> None:
    """At random over decades, of both signs, and next to where its pieces meet."""
    rng = np.random.default_rng(16)
    places = np.array([0.4375, 0.5, 0.6875, 1.0, 1.1875, 1.5, 2.4375])
    t = np.concatenate(
        [
            10.0 ** rng.uniform(-300, 300, 400),
            rng.uniform(0, 3, 2500),
            places,
            np.nextafter(places, 0),
        ]
    )
    t = np.concatenate([t, -t, [0.0]])
    with mpmath.workdps(50):
        for value, angle in zip(t, kernel.arctangent(t), strict=True):
            assert abs(mpmath.mpf(float(angle)) - mpmath.atan(float(value))) <= 0.9 * math.ulp(
                float(angle)
            )


# ------------------------------------------------------------------------------------------------
# ranges

FINE = Point(0.5, 0.8, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0)


def test_what_underflow_may_touch_is_not_sound() -> None:
    assert kernel.sound(FINE._replace(kappa=5e-324))  # beside (β + n̄) sin θ₀
    for name in ("sin0", "mu0", "kappa", "alpha", "sigma", "beta"):
        fine = FINE._replace(beta=0.0, nbar=0.0) if name == "kappa" else FINE
        for value in (0.0, 0.99e-250, 1e-250):
            assert bool(kernel.sound(fine._replace(**{name: value}))) == (
                value == 0 and name in ("mu0", "alpha", "beta")
            )
        assert kernel.sound(fine._replace(**{name: 1.01e-250}))


# ------------------------------------------------------------------------------------------------
# each term of a state's bounds, alone


def _forced(theta: Any, newton: Any) -> tuple[Any, LineBalance]:
    """t and coefficients of an f whose Newton step at θ is as given, its slope 1, and which has no
    curvature and no roundings.
    """
    t = np.tan(theta / 2)
    c, s = np.cos(theta), np.sin(theta)
    a = -(1 - newton * c / s) / (s * s)
    return t, LineBalance(a, 0 * t, newton / s - a * c, 0 * t, 0 * t, 0 * t, 1.0)


def _directions(rng: np.random.Generator, n: int) -> tuple[Array, Point]:
    """Directions of either sign, and points in contact."""
    theta0, theta = rng.uniform(0.01, 3.13, n), rng.choice([-1, 1], n) * rng.uniform(0.01, 3.13, n)
    return theta, Point(
        np.cos(theta0), np.sin(theta0), *(10.0 ** rng.uniform(-2, 1.5, (5, n))), nbar=1.0
    )


def _moved(theta: Any, radius: Any, point: Point) -> list[Any]:
    """By how much θ, L, x and y change at most within the radius, and each at θ."""
    rest = point.cos0, point.sin0, point.kappa, point.sigma, point.beta, point.nbar
    here = kernel.state(np.cos(theta), np.sin(theta), *rest)
    change = [0.0, 0.0, 0.0]
    for part in (-1.0, -0.5, 0.5, 1.0):
        turned = theta + part * radius
        there = kernel.state(np.cos(turned), np.sin(turned), *rest)
        change = [
            np.maximum(most, np.abs(new - old))
            for most, new, old in zip(change, there, here, strict=True)
        ]
    return [(radius, 1.0), *zip(change, here, strict=True)]


def _needed(parts: Any) -> Any:
    """The error over max(1, |value|), but for θ and y, whose bounds are not divided."""
    (theta, _), (L_off, L), (x_off, x), (y_off, _) = parts
    parts = theta, L_off / np.maximum(1, np.abs(L)), x_off / np.maximum(1, np.abs(x)), y_off
    return np.max(np.broadcast_arrays(*parts), axis=0)


@pytest.mark.parametrize("size", [1e-6, 0.9e-3])
def test_the_radius_moves_the_state_by_no_more_than_the_error(size: float) -> None:
    """Without roundings, u = 0: at least the change over the radius, and where terms add up little
    more.
    """
    rng = np.random.default_rng(20)
    n = 40000
    theta, point = _directions(rng, n)
    point = point._replace(nbar=rng.integers(0, 2, n) * 1.0)
    _, _, _, kappa, _, sigma, *_ = point
    t, line = _forced(theta, size * np.abs(np.sin(theta)))
    root = kernel.at_root(t, point, line, 0.0)
    np.testing.assert_allclose(root.radius, 1.0001 * size * np.abs(np.sin(theta)), rtol=1e-5)
    inside = np.where(root.L > 0, root.radius, np.nan)  # of others no error is said
    needed = _needed(_moved(theta, inside, point))
    assert not (root.error < needed * (1 - 1e-6)).any()
    # Where σ is small L and x move by all that is counted, and the smaller of the two divides.
    tight = (sigma < 0.03 * kappa) & (sigma < 0.03) & (theta > 0) & (np.abs(np.cos(theta)) > 0.3)
    dividing = np.minimum(root.L, np.abs(root.x))
    x_off, x = _moved(theta, inside, point)[2]
    most = np.maximum(_needed(_moved(theta, inside, point)), x_off / np.maximum(1, dividing))
    assert tight.sum() > 400
    for zone in (
        dividing < 0.6,
        (dividing > 1.2) & (root.L > 1.3 * np.abs(x)),
        (dividing > 1.2) & (np.abs(x) > 1.05 * root.L),
    ):
        assert (tight & zone).sum() > 10
        assert (root.error < 1.06 * most)[tight & zone].all()


def _border(
    share: float,
    radius: float,
    u: float,
    bend: float,
    nbar: int,
    which: str,
    theta: float,
    sigma: float,
) -> Root:
    """A root where L or y is ``share`` of what the radius and the roundings may change, by the
    choice of κ; f rises there.
    """
    beta, mu0, alpha = 0.7, 0.5, 0.3
    point = Point(math.cos(1.0), math.sin(1.0), mu0, 0.0, alpha, sigma, beta, float(nbar))
    stiff = beta + nbar
    q = stiff + sigma
    s = math.sin(theta)
    # L = 0 at κ = −σ s − (β + n̄) sin θ₀, y = 0 at κ = σ (sin θ₀ − s)
    zero = -sigma * s - stiff * point.sin0 if which == "L" else sigma * (point.sin0 - s)
    assert zero > 0
    point = point._replace(kappa=zero)
    index = ("L", "x", "y").index(which)
    moved = _moved(theta, 1.0001 * radius, point)[1 + index][0]
    terms = (
        (sigma * abs(s) + stiff * point.sin0 + zero) / (q * abs(s)),
        0.0,
        (sigma * (point.sin0 + abs(s)) + zero) / q,
    )
    moved *= (
        2 if which == "L" else 1
    )  # the bound takes all of L for what moves, of which σ/q, half of it here, does not
    off = share * (moved + kernel.COUNT_STATE * u * terms[index])
    # dL/dκ = 1/(q s), dy/dκ = −1/q
    point = point._replace(kappa=zero + off * (q * s if which == "L" else -q))
    t, line = _forced(theta, radius / (1 + radius * bend))
    root = kernel.at_root(t, point, line._replace(d_size=bend), u)
    assert getattr(root, which) == pytest.approx(off, rel=1e-5, abs=1e-14) or (
        which == "y" and root.y == 0 < off
    )
    return root


@pytest.mark.parametrize(
    ("radius", "u", "bend"), [(1e-5, 0.0, 3e4), (1e-4, 0.0, 0.0), (0.0, 1e-4, 0.0)]
)
@pytest.mark.parametrize(("nbar", "which"), [(0, "L"), (0, "y"), (1, "y")])
def test_a_root_is_a_member_or_an_outsider_exactly_where_its_errors_leave_no_doubt(
    radius: float, u: float, bend: float, nbar: int, which: str
) -> None:
    # Where f is monotone up to the border y = 0, no doubt is left: f rises, so that the mass is in
    # contact.
    for sigma, theta in itertools.product(
        (4.0, 30.0), (-0.7, -2.2, -1.4) if which == "L" else (0.3, 2.9, 0.6)
    ):
        side = 1 if which == "L" or not nbar else -1
        for share, sure in ((0.97, False), (1.05, True)):
            good, bad = (
                _border(way * side * share, radius, u, bend, nbar, which, theta, sigma)
                for way in (1, -1)
            )
            ordered = which == "y" and not bend and not sure
            assert bool(bad.outsider) == (sure or (ordered and nbar == 0))
            assert bool(bad.member) == (ordered and nbar == 1)
            if which == "y":
                assert bool(good.member) == (sure or (ordered and nbar == 1))
                assert bool(good.outsider) == (ordered and nbar == 0)


def test_where_the_sine_is_stationary_its_second_order_counts() -> None:
    """At θ = π/2, y moves by σ radius²/(2 q), towards positive values: less than that below 0 is no
    contact for certain.
    """
    radius, sigma, beta = 9e-4, 30.0, 0.1
    t, line = _forced(math.pi / 2, radius)
    q = sigma + beta + 1
    for share, member in ((0.9, False), (2.3, True)):
        point = Point(0.1, 1.0, 0.5, share * sigma * radius**2 / 2, 0.3, sigma, beta, 1.0)
        root = kernel.at_root(t, point, line, 0.0)
        assert root.y == pytest.approx(-share * sigma * radius**2 / (2 * q), rel=1e-6)
        assert bool(root.member) == member


@pytest.mark.parametrize("nbar", [0, 1])
def test_the_error_has_the_roundings_of_every_part(nbar: int) -> None:
    """At exact roots, with a large u: COUNT_STATE for each term of L, y and cos θ₀, twice that for
    L cos θ.
    """
    rng = np.random.default_rng(21)
    n, u = 40000, 1e-4
    theta, point = _directions(rng, n)
    point = point._replace(nbar=float(nbar))
    t, line = _forced(theta, 0.0)
    root = kernel.at_root(t, point, line, u)
    c, s = np.cos(theta), np.sin(theta)
    rest = point.cos0, point.sin0, point.kappa, point.sigma, point.beta, nbar
    L, _, y = kernel.state(c, Sized(s), *rest)
    count = kernel.COUNT_STATE * u
    off_x = count * (2 * L.size * np.abs(c) + np.abs(point.cos0))
    parts = [
        (kernel.COUNT_THETA * u, 1.0),
        (count * L.size, root.L),
        (off_x, root.x),
        (count * y.size, root.y),
    ]
    inside = root.L > 0
    assert (root.error >= _needed(parts) * (1 - 1e-6))[inside].all()
    smaller = np.maximum(1, np.minimum(root.L, np.abs(root.x)))
    largest = np.maximum(off_x + count * (1 - np.abs(point.cos0)), parts[1][0])
    most = np.maximum(np.maximum(parts[0][0], largest / smaller), parts[3][0])
    assert (root.error <= most * (1 + 1e-3))[inside].all()
    for carrier in (parts[1][0] / smaller, off_x / smaller, parts[3][0]):
        assert (carrier > 0.9 * root.error)[inside].any()


@pytest.mark.parametrize("theta", [math.pi / 2, -math.pi / 2])
@pytest.mark.parametrize(("radius", "u"), [(5e-4, 1e-5), (1e-9, 1e-5)])
def test_stability_is_told_how_far_cosine_sine_and_length_may_be_off(
    monkeypatch: pytest.MonkeyPatch, theta: float, radius: float, u: float
) -> None:
    """For their sizes: the radius where cos θ is 0, or the roundings of L, whatever its size and
    sign; and 8 u.
    """
    told = []
    plain = kernel.stability
    monkeypatch.setattr(kernel, "stability", lambda *given: told.append(given[3]) or plain(*given))
    t, line = _forced(theta, radius)
    root = kernel.at_root(t, FINE._replace(cos0=0.0, sin0=1.0, kappa=30.0), line, u)
    assert abs(root.L) > 8
    L_size = (1.0 + 2.0 * 1.0 + 30.0) / 3.0
    assert told == [
        pytest.approx(max(radius, kernel.COUNT_STATE * u * L_size / abs(root.L)) + 8 * u, rel=2e-3)
    ]


# ------------------------------------------------------------------------------------------------
# one or three


@pytest.mark.thorough
def test_roots_above_a_number_are_counted() -> None:
    """Three positive roots and a negative one, and c between them: all of the three are above, or
    one.
    """
    rng, seen = np.random.default_rng(91), set()
    for _ in range(4000):
        positive, negative = np.sort(10.0 ** rng.uniform(-1, 1, 3)), -(10.0 ** rng.uniform(-1, 1))
        coefficients = np.polynomial.polynomial.polyfromroots(
            [*positive, negative]
        ) * 10.0 ** rng.uniform(-1, 1)
        c = rng.choice([rng.uniform(0, positive[0]), rng.uniform(positive[1], positive[2])])
        found = kernel.above(*coefficients[1:], c, 0.0)
        assert (bool(found.all), bool(found.one)) == (c < positive[0], c > positive[0])
        seen.add(bool(found.all))
    assert seen == {False, True}


@pytest.mark.parametrize("seed", [1, 2])
def test_one_or_three_is_the_number_wherever_it_is_said(seed: int) -> None:
    """In float32, whose roundings are felt, against the roots in float64; and it is said of most
    points.
    """
    rng = np.random.default_rng([92, seed])
    rows = _random(rng, 60000)
    said = np.broadcast_to(kernel.one_or_three(_point(rows, 1), U), 60000)
    theta0, *others = rows
    exact = kernel.one_or_three(_point(rows, 1, np.float64), 2.0**-53)
    true = ss.equilibria(ss.Parameters(theta0, *others)).count
    assert (np.abs(rows[0] - math.pi / 2) < 1).any()
    assert ((said == 0) | (said == true)).all()
    assert ((exact == 0) | (exact == true)).all()
    assert set(said[rows[4] * np.sin(theta0) > rows[2]]) == {0, 1, 3}
    assert (said == 0).mean() < 0.2
    assert (exact == 0).mean() < 1e-3


def test_no_root_lies_beyond_the_upper_end_of_contact() -> None:
    """|b| − a s > α q s for s < s* = sin θ₀ − κ/σ, as polynomials with positive coefficients; and
    what f is then.
    """
    s, rise, excess, alpha, beta, sigma, mu0, cosine, cos0 = sp.symbols(
        "s rise excess alpha beta sigma mu0 c c0", positive=True
    )
    level, B = s + rise, beta + 1
    a, b, d, m = kernel.f_coefficients(
        cos0, level + excess, mu0, sigma * excess, alpha, sigma, beta, 1
    )
    surplus = sp.Poly(
        sp.expand(-b - a * s - alpha * (B + sigma) * s), s, rise, excess, alpha, beta, sigma
    )
    assert all(coefficient > 0 for coefficient in surplus.coeffs())
    f = kernel.f(-cosine, s, a, b, d, m)
    assert sp.expand(f - (cosine * (-b - a * s) + s * (m * rise + alpha * (B + sigma) * cos0))) == 0


def _patched(
    monkeypatch: pytest.MonkeyPatch, line: LineBalance, e1: float, value: float, found: kernel.Above
) -> list[Any]:
    """One point whose quartic, discriminant and roots in contact are as given; what is asked of the
    last.
    """
    asked: list[Any] = []
    monkeypatch.setattr(kernel, "balance", lambda _: line)
    monkeypatch.setattr(kernel, "quartic", lambda *_: kernel.Quartic(-0.5, e1, -2.0, 3.0, 0.5))
    monkeypatch.setattr(kernel, "discriminant", lambda *_: kernel.Discriminant(value, 1.0))
    monkeypatch.setattr(kernel, "above", lambda *given: (asked.append(given), found)[1])
    return asked


def test_one_or_three_by_every_certificate(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every combination, written out as the docstring has it; at the border of an error nothing is
    certain.
    """
    u = 2.0**-52
    line = LineBalance(0.1, -0.5, 0.1, 1.0, 0.25, 0.75, 1.0)
    margin = 2.0**-16  # 512 √u (1 + 0.25 + 0.75)
    below = -2.0 * kernel.COUNT_E1 * u
    for value, e1, every, one in itertools.product(
        (-1.5, -1.0, 0.0, 1.0, 1.5),
        (-1.0, 0.9 * below, 0.0, margin, 1.01 * margin),
        (False, True),
        (False, True),
    ):
        asked = _patched(monkeypatch, line, e1, value, kernel.Above(every, one))
        three = value < -1 and e1 > margin
        wanted = 1 if value > 1 or e1 < below or (three and one) else 3 if three and every else 0
        assert kernel.one_or_three(FINE, u) == wanted
        assert asked[-1][:4] == (e1, -2.0, 3.0, 0.5)
        assert asked[-1][5] == margin
        for change in ({"mu0": 1e-260}, {"sin0": 1e-251}):
            assert kernel.one_or_three(FINE._replace(**change), u) == 0
        _patched(monkeypatch, line._replace(scale=1e201), e1, value, kernel.Above(every, one))
        assert kernel.one_or_three(FINE, u) == 0


# ------------------------------------------------------------------------------------------------
# Newton and Kantorovich


def _steep(rng: np.random.Generator, n: int) -> tuple[Array, Array, LineBalance]:
    """θ, steps and coefficients with slope 1 and that Newton step, two of the four of any size."""
    theta = rng.choice([-1, 1], n) * rng.uniform(0.05, 3.09, n)
    c, s = np.cos(theta), np.sin(theta)
    newton = 10.0 ** rng.uniform(-7, -3.5, n) * np.abs(s)
    free = rng.choice([-1, 1], (2, n)) * 10.0 ** rng.uniform(-1, 5, (2, n))
    values, slopes = np.array([c * s, c, s, -s * s]), np.array([c * c - s * s, -s, c, -2 * s * c])
    order = np.argsort(rng.random((4, n)), axis=0)
    columns = np.arange(n)
    one, other, *rest = order
    left = [
        newton - sum(values[k, columns] * part for k, part in zip(rest, free, strict=True)),
        1 - sum(slopes[k, columns] * part for k, part in zip(rest, free, strict=True)),
    ]
    determinant = (
        values[one, columns] * slopes[other, columns]
        - values[other, columns] * slopes[one, columns]
    )
    line = np.empty((4, n))
    line[one, columns] = (
        left[0] * slopes[other, columns] - left[1] * values[other, columns]
    ) / determinant
    line[other, columns] = (
        left[1] * values[one, columns] - left[0] * slopes[one, columns]
    ) / determinant
    line[rest[0], columns], line[rest[1], columns] = free
    a, b, d, m = line
    return theta, newton, LineBalance(a, b, d, np.abs(m), np.abs(a), np.abs(d), 1.0)


def test_a_root_is_proved_where_kantorovichs_theorem_proves_it() -> None:
    """Without roundings: h below 2/5, the step below a thousandth of sin θ; the radius is the
    theorem's, or a little more.
    """
    rng = np.random.default_rng(22)
    theta, _, line = _steep(rng, 200000)
    t = np.tan(theta / 2)
    c, s = kernel.direction(t)
    value = np.abs(line.a * c * s + line.b * c + line.d * s - line.m * s * s)
    slope = np.abs(
        line.a * np.cos(2 * theta) - line.b * s + line.d * c - line.m * np.sin(2 * theta)
    )
    bend = 2 * np.abs(line.a) + 2 * line.m + np.abs(line.b) + np.abs(line.d)  # f″, term by term
    newton, h = value / slope, value * bend / slope**2
    good = slope > 1e-6 * bend  # the rest cancels too much to be a reference
    root = kernel.at_root(t, FINE, line, 0.0)
    proved = np.isfinite(root.radius)
    wanted = (h < 0.4) & (newton < 1e-3 * np.abs(s))
    clear = good & (np.abs(h / 0.4 - 1) > 1e-3) & (np.abs(newton / (1e-3 * np.abs(s)) - 1) > 1e-3)
    np.testing.assert_array_equal(proved[clear], wanted[clear])
    for low, high in ((0.38, 0.4), (0.4, 0.42)):
        assert (clear & (h > low) & (h < high) & (newton < 1e-3 * np.abs(s))).sum() > 30
    for name in ("a", "b", "d", "m"):
        heavy = np.abs(getattr(line, name)) > 0.2 * bend
        assert (clear & heavy & (h > 0.3) & (h < 0.5)).sum() > 30
    some = proved & clear & (value > 1e-10 * bend)
    theorem = newton * 2 / (1 + np.sqrt(1 - 2 * np.minimum(h, 0.5)))
    assert (root.radius >= theorem * (1 - 1e-6))[some].all()
    assert (root.radius <= 1.0002 * newton / (1 - h))[some].all()


@pytest.mark.parametrize("u", [1e-7, 1e-3, 6e-3])
def test_the_radius_has_the_roundings_of_f_and_of_its_slope(u: float) -> None:
    """Every term of both as large as it can be made in turn, against sizes that the algebra
    gives.
    """
    rng = np.random.default_rng(23)
    n = 60000
    theta = rng.choice([-1, 1], n) * rng.uniform(0.3, 2.84, n)
    t = np.tan(theta / 2)
    c, s = kernel.direction(t)
    a, b, d, m = rng.choice([-1, 1], (4, n)) * 10.0 ** rng.uniform(-3, 0, (4, n))
    few = 10.0 ** rng.uniform(
        -9, 1, (2, n)
    )  # sizes may be anything: they stand for terms that cancelled
    line = LineBalance(a, -np.abs(b), d, np.abs(m), few[0], few[1], 1.0)
    arguments = Sized(c), Sized(s), Sized(a, few[0]), Sized(line.b), Sized(d, few[1]), Sized(line.m)
    value, slope = kernel.f(*arguments), kernel.f_slope(*arguments)
    bend = 2 * (few[0] + line.m) + np.abs(line.b) + few[1]
    size_of_slope = slope.size - few[0] * (c * c + s * s) + few[0]
    above = np.abs(value.value) + kernel.COUNT_F * u * value.size
    below = np.abs(slope.value) - kernel.COUNT_SLOPE * u * size_of_slope
    newton = above / below
    h = newton * bend / below
    wanted = (below > 0) & (h < 0.4) & (newton < 1e-3 * np.abs(s))
    clear = np.abs(h / 0.4 - 1) > 1e-6
    root = kernel.at_root(t, FINE, line, u)
    np.testing.assert_array_equal(np.isfinite(root.radius)[clear], wanted[clear])
    some = wanted & clear
    np.testing.assert_allclose(root.radius[some], (1.0001 * newton / (1 - h))[some], rtol=1e-7)
    if u < 1e-4:
        assert some.sum() > 30


# --------------------------------------------------------------------------------------------
# margins of stability

STIFFNESSES = {
    "mu0": (1e6, 1.0, 1.0, 1.0, 1.0),
    "alpha": (0.0, 1e3, 1e-3, 0.0, 1.0),
    "sigma": (0.0, 0.0, 1e3, 0.0, 1e3),
    "beta": (0.0, 0.0, 1e-3, 1e3, 1.0),
    "pull": (0.0, 0.0, 1.0, 0.0, 1e-6),
    "nbar": (0.0, 0.0, 1e-6, 0.0, 1.0),
    "pull and mu0": (1e6, 0.0, 1.0, 0.0, 1e-4),
    "all": (1.0, 1.0, 1.0, 1.0, 1.0),
    "trace alone": (0.0, 1.0, 1.0, 1.0, 0.5001),
}


@pytest.mark.parametrize("name", STIFFNESSES)
def test_margins_cover_discriminant_and_trace(name: str) -> None:
    """cos θ and sin θ at 1, since their errors are not relative: the border is at the sizes of
    both, with COUNT_K.
    """
    for nbar in (0.0, 1.0):
        _check_margins(
            Point(0.0, 1.0, *STIFFNESSES[name][:1], 1.0, *STIFFNESSES[name][1:4], nbar),
            STIFFNESSES[name][4],
        )


def _check_margins(point: Point, L: float) -> None:
    _, _, mu0, _, alpha, sigma, beta, nbar = point
    (K11, K12), (K21, K22) = kernel.stiffness(
        Sized(1.0), Sized(1.0), Sized(L), Sized(mu0), alpha, sigma, beta, nbar
    )
    trace, _, flutter = kernel.invariants(K11, K12, K21, K22)
    if flutter.value:
        border = abs(flutter.value) / (kernel.COUNT_K * flutter.size)
        code, certain = kernel.stability(Direction(1.0, 1.0), L, 1.0, border * (1 + 1e-9), point)
        assert not certain
        assert code == (3 if flutter.value < 0 else 1 if trace.value > 0 else 2)
    if trace.value and flutter.value > 0:
        border = abs(trace.value) / (kernel.COUNT_K * trace.size)
        assert not kernel.stability(Direction(1.0, 1.0), L, 1.0, border * (1 + 1e-9), point).certain


@pytest.mark.parametrize("ratio", [3.0, 100.0, 1e6])
def test_a_margin_covers_friction_where_flutter_alone_decides(ratio: float) -> None:
    """The terms of the discriminant, where friction is this multiple of σ/L, and cos θ = −1, sin θ
    = 1 make it negative.
    """
    pull, alpha, sigma, beta, nbar = 1e4, 0.0, 1.0, 0.0, 1.0
    mu0 = ratio * pull
    (K11, K12), (K21, K22) = kernel.stiffness(
        -1.0, 1.0, sigma / pull, mu0, alpha, sigma, beta, nbar
    )
    _, _, flutter = kernel.invariants(K11, K12, K21, K22)
    assert flutter < 0
    terms = (alpha + beta + nbar + 2 * sigma + 2 * pull) ** 2 + 4 * pull * (mu0 * nbar + pull)
    border = -flutter / (kernel.COUNT_K * terms)
    point = Point(0.0, 1.0, mu0, 1.0, alpha, sigma, beta, nbar)
    at = Direction(-1.0, 1.0)
    assert kernel.stability(at, sigma / pull, 1.0, border * (1 + 1e-9), point) == (3.0, False)
    assert kernel.stability(at, sigma / pull, 1.0, border / 1.3, point) == (3.0, True)
