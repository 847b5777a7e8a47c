"""Folds and cusps with proofs: enclosed, none missed, and what can't be decided is not."""

import itertools
import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

import spragsym as ss
from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam import cusps, folds
from spragsym.kang_nam.folds import Angles, SurfacePoint
from spragsym.numerics import balls, polynomials
from spragsym.numerics.balls import UndecidedSign
from spragsym.numerics.polynomials import RootOf
from tests.oracles import reference
from tests.support import as_mpf

# -------------------------------------------------------------------------------------------
# proofs: the means


@pytest.mark.parametrize(
    "middle",
    [
        1 + Fraction(1, 2**53),
        3 - Fraction(3, 2**53),
        Fraction(1, 3),
        -1 - Fraction(1, 2**53),
        Fraction(0),
    ],
)
def test_the_error_of_a_float_covers_its_rounding(middle: Fraction) -> None:
    """Halfway between two floats, where half a unit is lost, to either end of an interval of any
    width that is allowed.
    """
    for width in (Fraction(0), Fraction(1, 2**70), Fraction(9, 10**16)):
        with balls.precision(200):
            ends = balls.ends(balls.between(middle - width, middle + width))
            (value,), error = balls.as_floats([balls.between(*ends)])
        assert max(abs(Fraction(value) - end) for end in ends) <= Fraction(error) * max(
            1, abs(Fraction(value))
        )


# ----------------------------------------------------------------------------------------------
# folds and cusps


def _middle(value: Any) -> mpmath.mpf:
    return as_mpf(sum(balls.ends(value)) / 2)


def _check(point: SurfacePoint, orders: int, digits: int) -> None:
    """f and its derivatives vanish there to this many digits, the state is that of the geometry,
    and it is in contact.
    """
    with mpmath.workprec(1000):
        values = [_middle(value) for value in point.parameters]
        state = theta, L, _, y = [
            _middle(value) for value in (point.theta, point.L, point.x, point.y)
        ]
    for value in (*point.parameters, point.theta, point.L, point.x, point.y):
        low, high = balls.ends(value)
        assert high - low <= max(1, abs(low)) / Fraction(10) ** digits
    with mpmath.workdps(digits + 20):
        small = mpmath.mpf(10) ** -(digits - 8) * (1 + sum(map(abs, values[1:])))
        assert all(
            abs(mpmath.diff(lambda t: reference.along(t, *values), theta, order)) < small
            for order in range(orders)
        )
        assert reference.lack_of_a_state(state, *_of_states(values)) < mpmath.mpf(10) ** -(
            digits - 4
        ) * (1 + L)
    assert L > 0
    assert y < 0


def _of_states(values: list[mpmath.mpf]) -> list[mpmath.mpf]:
    """θ₀, κ, σ, β."""
    return [values[PARAMETERS.index(name)] for name in ("theta0", "kappa", "sigma", "beta")]


def _rationals(seed: int, number: int) -> Iterator[list[Fraction]]:
    """κ, α, σ, β where folds are common, α = 0 and β = 0 among them."""
    rng = np.random.default_rng(seed)
    for trial in range(number):
        decades = ((0, 1.3), (0, 1.5), (1.3, 2.6), (0, 2.5))
        kappa, alpha, sigma, beta = (
            Fraction(int(10 ** rng.uniform(*ends)), 500) for ends in decades
        )
        yield [kappa, alpha * (trial % 3 != 1), sigma, beta * (trial % 2)]


def _with_angle_and_friction(
    rng: np.random.Generator, values: list[Fraction]
) -> dict[str, Fraction]:
    theta0, mu0 = Fraction(int(rng.integers(40, 130)), 100), Fraction(int(rng.integers(2, 15)), 10)
    return dict(zip(PARAMETERS, [theta0, mu0, *values], strict=True))


def _scanned(vary: str, fixed: dict[str, float], values: np.ndarray) -> np.ndarray:
    """Cells of a grid between whose ends the number of equilibria changes."""
    return np.flatnonzero(np.diff(ss.equilibria(ss.Parameters(**fixed | {vary: values})).count))


@pytest.mark.parametrize("vary", PARAMETERS)
def test_folds_are_enclosed_and_none_is_missed(vary: str) -> None:
    """Against the counts over a grid, whose cells hold an odd number of folds where the count
    changes, otherwise an even one.
    """
    rng = np.random.default_rng(PARAMETERS.index(vary))
    grids = {"theta0": np.linspace(1e-3, math.pi - 1e-3, 1500), "mu0": np.linspace(1e-5, 3, 1500)}
    grid = grids.get(vary, np.geomspace(1e-4, 10, 1500))
    total = 0
    for values in _rationals(PARAMETERS.index(vary), 5):
        exact = _with_angle_and_friction(rng, values)
        with balls.precision(300):
            points = [fold.point for fold in folds.proved_folds(vary, exact, 300)]
            for point in points:
                _check(point, 2, 30)
                for name, value in zip(PARAMETERS, point.parameters, strict=True):
                    if name != vary:
                        low, high = balls.ends(value)
                        assert (
                            abs(
                                _middle(value)
                                - mpmath.mpf(exact[name].numerator) / exact[name].denominator
                            )
                            < 1e-60
                        )
            where = np.array(
                [float(_middle(point.parameters[PARAMETERS.index(vary)])) for point in points]
            )
        where = where[(where > grid[0]) & (where < grid[-1])]
        cells, number = np.unique(np.searchsorted(grid, where) - 1, return_counts=True)
        fixed = {name: float(value) for name, value in exact.items()}
        assert cells[number % 2 == 1].tolist() == _scanned(vary, fixed, grid).tolist()
        total += where.size
    assert total >= 2


@pytest.mark.parametrize("vary", PARAMETERS)
def test_a_fold_says_on_which_side_there_are_three_and_which_two_meet(vary: str) -> None:
    """Against the equilibria on both sides of it."""
    place, seen = PARAMETERS.index(vary), set()
    rng = np.random.default_rng([8, place])
    for values in _rationals(70 + place, 10):
        exact = _with_angle_and_friction(rng, values)
        with balls.precision(300):
            found = list(folds.proved_folds(vary, exact, 300))
        for fold in found:
            value, theta = (
                float(sum(balls.ends(one)) / 2)
                for one in (fold.point.parameters[place], fold.point.theta)
            )
            if not 1e-3 < value < (3 if vary == "theta0" else 1e3):
                continue
            fixed = {name: float(one) for name, one in exact.items()}
            beside = ss.equilibria(
                ss.Parameters(**fixed | {vary: np.array([value * (1 - 1e-7), value * (1 + 1e-7)])})
            )
            assert fold.kind == "fold"
            assert (int(beside.count[1]) - int(beside.count[0])) / 2 == fold.side
            alone = beside.theta[int(fold.side > 0) ^ 1, 0]
            assert fold.upper == (alone < theta)
            seen.add((fold.side, fold.upper))
    assert len(seen) > 1


@pytest.mark.parametrize("alpha", ["0.007", "0", "1", "1.5 0.5", "1 0.5"])
def test_cusps_are_enclosed_and_paired(alpha: str) -> None:
    """The mirror image (π − θ, π − θ₀, −μ₀) of a cusp is one; their number is that of the real
    roots of the polynomial.
    """
    stiffness, beta, *_ = [*map(Fraction, alpha.split()), Fraction(0)]
    exact = (Fraction(7, 1000), stiffness, Fraction(1, 10), beta)
    with balls.precision(300):
        points = list(cusps.proved_cusps(exact, 300))
        assert len(points) >= {"0.007": 4, "0": 2}.get(alpha, 1)
        seen = []
        for point in points:
            _check(point, 3, 30)
            angles = [balls.cos_sin(value) for value in (point.theta, point.parameters[0])]
            seen.append([float(_middle(v)) for v in (*angles[0], *angles[1], point.parameters[1])])
        for c, s, c0, s0, mu0 in seen:
            gaps = [max(map(abs, np.subtract(other, (-c, s, -c0, s0, -mu0)))) for other in seen]
            assert sum(gap < 1e-14 for gap in gaps) == 1
        if alpha != "0":
            assert all(cusps.is_versal(point) for point in points)


@pytest.mark.parametrize(
    "values",
    [
        *(
            list(map(Fraction, values.split()))
            for values in (
                "4/3 1/2 1 0",
                "1/2 4 4 0",
                "7/1000 7/1000 1/10 0",
                "1 1 1/2 1",
                "2 3 5 1/3",
                "1/2 0 1/4 0",
                "2 0 4 1",
            )
        ),
        *_rationals(7, 8),
    ],
    ids=str,
)
def test_sines_of_cusps_are_all_real_roots_inside(values: list[Fraction]) -> None:
    """At sin θ = 1 and −1 as well, where α > 0 (the first two: there the polynomial is 0); against
    SymPy's count.
    """
    kappa, alpha, sigma, beta = values
    polynomial, roots = cusps.cusp_sines(kappa, alpha, sigma, beta, bits=50)
    coefficients = [
        sp.Rational(value.numerator, value.denominator) for value in reversed(polynomial)
    ]
    exact = sp.Poly(coefficients, sp.Symbol("s")).sqf_part()
    at_ends = [exact.eval(end) == 0 for end in (-1, 1)]
    inside = exact.count_roots(-1, 1) - (0 if alpha else sum(at_ends))
    assert len(roots) == inside
    ends = [end for end, there in zip((-1, 1), at_ends, strict=True) if there and alpha]
    assert [low for low, high in roots if low == high and abs(low) == 1] == ends
    assert roots == sorted(roots)
    for low, high in roots:
        assert high - low <= Fraction(1, 2**50)
        assert (
            low == high
            or exact.count_roots(
                *(sp.Rational(end.numerator, end.denominator) for end in (low, high))
            )
            == 1
        )


def test_a_function_that_vanishes_at_a_root_is_known_to() -> None:
    """At sin θ = 1/√3 and 3/5, which no interval of dyadic ends is: polynomials of degree 10."""
    polynomial = (Fraction(-3), Fraction(5), Fraction(9), Fraction(-15))  # (5 s − 3)(1 − 3 s²)
    ends = ((577, 578), (599, 601), (600, 600))
    third, rational, exact = (
        RootOf(polynomial, *(Fraction(n, 1000) for n in pair)) for pair in ends
    )

    def is_zero(root: RootOf, numerator: Any) -> bool:
        with balls.precision(100):
            try:
                open_ = balls.between(Fraction(-1), Fraction(1))
                return root.sign_of(open_, lambda s: (2 + s**8) * numerator(s), 10, "it") == 0
            except UndecidedSign:
                return False

    for numerator, zeros in (
        (lambda s: 1 - 3 * s * s, (True, False, False)),
        (lambda s: s * (5 * s - 3), (False, True, True)),
        (lambda s: s * s - 1, (False, False, False)),
    ):
        assert tuple(is_zero(root, numerator) for root in (third, rational, exact)) == zeros


# ------------------------------------------------------------------------------------------------
# folds at coincidences


@pytest.mark.parametrize("beta", [Fraction(0), Fraction(2, 5)])
@pytest.mark.parametrize("vary", PARAMETERS)
def test_the_curvature_vanishes_on_cusps_and_not_on_folds(vary: str, beta: Fraction) -> None:
    values = (Fraction(7, 1000), Fraction(7, 1000), Fraction(1, 10), beta)
    with balls.precision(300):
        points = list(cusps.proved_cusps(values, 300))
        for point in points:
            _, friction = (sum(balls.ends(one)) / 2 for one in point.parameters[:2])
            c, s = balls.cos_sin(point.theta / 2)
            t = s / c
            exact = dict(zip(PARAMETERS, (Fraction(1), friction, *values), strict=True))
            at = [
                polynomials.evaluate(tuple(map(balls.exact, one)), t)
                for one in folds._curvature(vary, exact)
            ]
            sizes = [abs(float(sum(balls.ends(one)) / 2)) for one in at]
            if vary in ("alpha", "beta"):  # μ₀ (3 s² − 2) and s c, times (1 + t²)²
                c, s = balls.cos_sin(point.theta)
                for one, other in zip(
                    at, (balls.exact(friction) * (3 * s * s - 2), s * c), strict=True
                ):
                    low, high = balls.ends(one - other * (1 + t * t) ** 2)
                    assert -1e-60 < low <= 0 <= high < 1e-60
            else:
                assert sizes[0] < 1e-60
                moved = exact | {"mu0": friction + Fraction(1, 100)}
                (other,) = folds._curvature(vary, moved)
                assert (
                    abs(
                        float(
                            sum(balls.ends(polynomials.evaluate(tuple(map(balls.exact, other)), t)))
                        )
                    )
                    > 1e-4
                )


def test_kinds_of_double_roots() -> None:
    """Where f″ = 0 it is a cusp. Otherwise a touch, with the third state on the side that a fold at
    that point has it.
    """
    exact = dict(zip(PARAMETERS, map(Fraction, (1.1, 0.5, 0.007, 0.007, 0.1, 0.0)), strict=True))
    with balls.precision(300):
        uppers = set()
        for fold in (
            fold for vary in ("theta0", "mu0") for fold in folds.proved_folds(vary, exact, 300)
        ):
            angles = Angles(
                *balls.cos_sin(fold.point.theta), *balls.cos_sin(fold.point.parameters[0])
            )
            for flat in (False, True):
                direction = folds._Direction(angles.s / (1 + angles.c), 2, flat)
                found = folds._classified("theta0", fold.point, angles, direction)
                assert (found.kind, found.side, found.upper) == (
                    ("cusp", 0, False) if flat else ("touch", 0, fold.upper)
                )
            uppers.add(fold.upper)
    assert uppers == {False, True}


def test_a_fold_at_exactly_90_degrees_out_of_contact_is_none() -> None:
    """α = 0, sin θ = 4/5 and sin θ₀ = 1, with μ₀ and σ from f = f′ = 0 by hand: y > 0 there, and no
    sign stays open.
    """
    s, c, kappa = Fraction(4, 5), Fraction(3, 5), Fraction(1, 10)
    mu0 = (1 - s**3 + kappa) / (s * s * c)
    sigma = mu0 * kappa * s / (s * c - (1 + kappa) * c + mu0 * s * (1 - s))
    a, b, d, m = sigma, -sigma * (1 + kappa), mu0 * (sigma - kappa), mu0 * sigma
    assert a * s * c + b * c + d * s - m * s * s == 0
    assert a * (c * c - s * s) - b * s + d * c - 2 * m * s * c == 0
    assert sigma * (1 - s) > kappa
    exact = {"mu0": mu0, "kappa": kappa, "alpha": Fraction(0), "sigma": sigma, "beta": Fraction(0)}
    with balls.precision(300):
        found = [
            sum(balls.ends(fold.point.parameters[0])) / 2
            for fold in folds.proved_folds("theta0", exact, 300)
        ]
    assert all(abs(float(angle) - math.pi / 2) > 1e-6 for angle in found)
    grid = np.linspace(1e-3, math.pi - 1e-3, 3001)
    fixed = {name: float(value) for name, value in exact.items()}
    assert len(found) == _scanned("theta0", fixed, grid).size


@pytest.mark.parametrize("vary", PARAMETERS[1:])
def test_too_few_bits_find_no_folds_and_deny_none(vary: str) -> None:
    exact = dict(zip(PARAMETERS, map(Fraction, (0.7, 0.5, 0.007, 0.007, 0.1, 0.25)), strict=True))
    with balls.precision(6), pytest.raises(UndecidedSign):
        list(folds.proved_folds(vary, exact, 6))


def test_what_does_not_depend_on_theta0_is_told_from_five_angles(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """g(v) (t² − 2) with g of both signs, and 0 at some of the angles; and what depends on both."""
    exact = dict.fromkeys(PARAMETERS, Fraction(1))

    def eliminated(of: Any) -> None:
        def polynomial(_: str, c0: Fraction, s0: Fraction, *__: Any) -> Any:
            return (), (), polynomials.interpolate(lambda t: of(s0 / (1 + c0), t), 6)

        monkeypatch.setattr(folds, "lines_and_sextic", polynomial)

    for zeros in ((1, 5), (2, 3), (3,), (1, 2, 4), (2, 4, 5)):
        eliminated(
            lambda v, t, zeros=zeros: math.prod(7 * v - zero for zero in zeros) * (t * t - 2)
        )
        assert folds._independent_of_theta0("kappa", exact) in ((-2, 0, 1), (2, 0, -1))
    for of in (
        lambda v, t: t * t - v,
        lambda v, t: (7 * v - 5) * t + (7 * v - 1) * (7 * v - 2) * (7 * v - 3) * (7 * v - 4),
    ):
        eliminated(of)
        assert folds._independent_of_theta0("kappa", exact) is None


def test_a_pitchfork_has_no_upper_pair() -> None:
    exact = dict(zip(PARAMETERS, (Fraction(1), *map(Fraction, (0, "1/10", 0, 1, 0))), strict=True))
    with balls.precision(200):
        found = [
            fold
            for vary in ("theta0", "kappa", "sigma")
            for fold in folds.proved_folds(vary, exact, 200)
        ]
    forks = [fold for fold in found if fold.kind == "pitchfork"]
    assert forks
    assert not any(fold.upper for fold in forks)


@pytest.mark.parametrize("vary", PARAMETERS)
def test_all_of_the_eliminated_polynomial_vanishes_where_there_is_no_fold_only(
    vary: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Along σ for μ₀ = 0 and α = 0 or 1 + β, and along θ₀ for μ₀ = 0 and α = κ = 1 + β."""
    seen: list[Any] = []
    plain = folds.with_multiplicity
    monkeypatch.setattr(
        folds, "with_multiplicity", lambda one, *rest: seen.append(one) or plain(one, *rest)
    )
    for mu0, alpha in itertools.product((0, 1), (0, Fraction(1, 2), Fraction(3, 2))):
        exact = dict(zip(PARAMETERS, map(Fraction, (1, mu0, "3/2", alpha, 1, "1/2")), strict=True))
        none = mu0 == 0 and alpha in {
            "sigma": (0, Fraction(3, 2)),
            "theta0": (Fraction(3, 2),),
        }.get(vary, ())
        with balls.precision(200):
            found = list(folds.proved_folds(vary, exact, 200))
        assert (() in seen) == none
        assert not (none and found)
        seen.clear()
