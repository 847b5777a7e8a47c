"""Generated functions: one algebra for every number type, and the numbers of the un-eliminated
equations.
"""

import importlib
import inspect
import pkgutil
import random
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from spragsym import generated
from spragsym.generated import catastrophe, equilibrium, linear_sprag, stability
from spragsym.generated.models.kang_nam import algebra
from spragsym.generated.quantities import PARAMETERS
from tests.oracles import reference
from tests.support import as_mpf, leaves

EPS = 2.0**-53

# -------------------------------------------------------------------------------------------------
# discovery


@dataclass(frozen=True)
class Generated:
    """One generated function and what its signature says."""

    module: str
    name: str
    call: Callable[..., Any]

    @cached_property
    def arguments(self) -> tuple[str, ...]:
        return tuple(it for it in inspect.signature(self.call).parameters if it not in ("xp", "_"))

    @cached_property
    def transcendental(self) -> bool:
        return "xp" in inspect.signature(self.call).parameters

    def __call__(self, values: dict[str, Any], xp: Any = None) -> list[Any]:
        """All results, flat."""
        options = {"xp": xp} if self.transcendental and xp is not None else {}
        return leaves(self.call(*(values[name] for name in self.arguments), **options))


MODULES = [
    module.name
    for module in pkgutil.iter_modules(generated.__path__)
    if not module.ispkg
    and not module.name.startswith("_")
    # These have tests of their own.
    and module.name not in ("kernel", "quantities", "double_double", "transition")
]
FUNCTIONS = [
    Generated(name, function, getattr(module, function))
    for name, module in (
        (name, importlib.import_module(f"spragsym.generated.{name}")) for name in MODULES
    )
    for function in module.__all__
]
#: Of the page's functions those of the motion, which come last, but for what nothing moves.
FUNCTIONS += [
    function
    for name in algebra.__all__[algebra.__all__.index("rhs") :]
    if (function := Generated("motion", name, getattr(algebra, name))).arguments
]
NAMED = {function.name: function for function in FUNCTIONS}


def each_function(test: Callable[[Generated], None]) -> Callable[[str], None]:
    """The test of one function, for all of a module."""

    @pytest.mark.parametrize("module", sorted({function.module for function in FUNCTIONS}))
    def of_module(module: str) -> None:
        for function in FUNCTIONS:
            if function.module == module:
                test(function)

    return of_module


def call(function: Callable[..., Any], values: dict[str, Any]) -> Any:
    """A function of the arguments that it names."""
    return function(*(values[name] for name in inspect.signature(function).parameters))


# ------------------------------------------------------------------------------------------------
# numbers

_RANGES: dict[str, tuple[float, float]] = {
    "L": (0.3, 1.8),
    "mu0": (0.05, 1.5),
    "mu": (0.05, 1.5),
    "n": (0, 0.5),
    "kappa": (0.002, 0.3),
    "alpha": (0.005, 0.9),
    "sigma": (0.02, 1.5),
    "beta": (0, 2),
    "a_f": (-1, 1),
    "b_f": (-1, -0.01),
    "d_f": (-1, 1),
    "m_f": (0, 1),
    "a_v": (-1, 1),
    "b_v": (-1, 1),
    "d_v": (-1, 1),
    "m_v": (-1, 1),
    "K11": (-1, 1),
    "K12": (-1, 1),
    "K21": (-1, 1),
    "K22": (-1, 1),
    "C11": (-0.1, 0.1),
    "T": (0.1, 4),
    "x": (-0.2, 0.3),
    "y": (-0.3, -0.01),
    "vx": (-0.4, 0.4),
    "vy": (-0.4, 0.4),
    "V": (0.5, 1),
    "d": (0.5, 3),
}


def rationals(seed: int) -> dict[str, Fraction]:
    """Random rationals for every argument there is; cosines and sines on the unit circle, 0 < θ, θ₀
    < π.
    """
    generator = random.Random(seed)
    point = {}
    for name, (low, high) in _RANGES.items():
        width = Fraction(high - low).limit_denominator(1000)
        point[name] = Fraction(low).limit_denominator(1000) + width * Fraction(
            generator.randint(1, 96), 97
        )
    for cosine, sine in (("cos", "sin"), ("cos0", "sin0")):
        half = Fraction(generator.randint(8, 90), 32)
        point[cosine], point[sine] = (1 - half**2) / (1 + half**2), 2 * half / (1 + half**2)
    point["nbar"], point["side"] = (
        Fraction(generator.randint(0, 1)),
        Fraction(generator.choice([-1, 1])),
    )
    point["pushing"], point["near1"] = point["nbar"], Fraction(1)
    point["ax"], point["ay"] = (Fraction(generator.randint(-96, 96), 97) for _ in range(2))
    return point


def reals(seed: int) -> dict[str, Any]:
    """The same to mpmath's precision."""
    return {name: as_mpf(value) for name, value in rationals(seed).items()}


SEEDS = range(6)


def floats(seed: int) -> dict[str, float]:
    """The same, rounded: numbers that every binary precision holds exactly."""
    return {name: float(value) for name, value in rationals(seed).items()}


def exact(function: Generated, values: dict[str, Any], digits: int) -> list[mpmath.mpf]:
    with mpmath.workdps(digits):
        given = {name: mpmath.mpf(value) for name, value in values.items()}
        return [+mpmath.mpf(item) for item in function(given, mpmath)]


def conditions(function: Generated, values: dict[str, float]) -> list[mpmath.mpf]:
    """|f| + Σ |xᵢ ∂f/∂xᵢ| for each result: what relative errors of size 1 in the arguments would do
    to it.
    """
    with mpmath.workdps(60):
        centre = exact(function, values, 60)
        total = [abs(item) for item in centre]
        step = mpmath.mpf(10) ** -20
        for name in function.arguments:
            if name in ("nbar", "pushing", "side", "near1") or values[name] == 0:  # given exactly
                continue
            moved = {key: mpmath.mpf(value) for key, value in values.items()}
            for place, item in enumerate(
                function(moved | {name: moved[name] * (1 + step)}, mpmath)
            ):
                total[place] += abs(item - centre[place]) / step
        return total


@each_function
def test_float64_is_within_a_few_ulp(function: Generated) -> None:
    """Errors are a modest multiple of what rounding the arguments costs, and inside of the
    enclosure.
    """
    for seed in SEEDS:
        values = floats(seed)
        truth = exact(function, values, 50)
        with mpmath.workprec(53):
            mpmath.iv.prec = 53
            enclosures = function(
                {name: mpmath.iv.mpf(value) for name, value in values.items()}, Intervals
            )
        rows = zip(function(values), truth, conditions(function, values), enclosures, strict=True)
        for got, right, condition, enclosure in rows:
            assert isinstance(got, float), type(got)
            with mpmath.workdps(50):
                assert abs(got - right) <= 8 * EPS * condition, (seed, got, right)
                low, high = ends(enclosure)
                slack = 4 * EPS * abs(right)  # a library's exponential is not rounded outwards
                assert low - slack <= got <= high + slack, (seed, got, enclosure)


class Intervals:
    """mpmath.iv with the sign that it lacks."""

    sqrt, exp = staticmethod(mpmath.iv.sqrt), staticmethod(mpmath.iv.exp)

    @staticmethod
    def sign(value: Any) -> Any:
        assert 0 not in value, "the sign of an interval around zero"
        return mpmath.iv.mpf(1 if value > 0 else -1)


def ends(interval: Any) -> tuple[mpmath.mpf, mpmath.mpf]:
    interval = mpmath.iv.convert(interval)
    return mpmath.mpf(interval.a.mid), mpmath.mpf(interval.b.mid)


class RationalStandIns:
    """Rational functions in place of √, exp and sgn: what a function does around them can be
    followed exactly.
    """

    @staticmethod
    def sqrt(value: Any) -> Any:
        return (value + 2) / 3

    @staticmethod
    def exp(value: Any) -> Any:
        return 1 + value * value / 7

    @staticmethod
    def sign(value: Any) -> Any:
        return value / abs(value)


@each_function
def test_fractions_stay_exact(function: Generated) -> None:
    """Fractions in, fractions out, for all functions: no rational constant of theirs passes through
    float64.
    """
    for seed in SEEDS:
        results = function(rationals(seed), RationalStandIns)
        assert all(isinstance(item, Fraction) for item in results), [type(item) for item in results]
        with mpmath.workdps(70):
            for item, right in zip(results, function(reals(seed), RationalStandIns), strict=True):
                assert abs(as_mpf(item) - right) <= mpmath.mpf(10) ** -50 * (1 + abs(right))


# ------------------------------------------------------------------------------------------------
# arrays


@each_function
def test_arrays_broadcast_constants_included(function: Generated) -> None:
    values = floats(1)
    expected = function(values)
    for name in function.arguments:  # each argument in turn is the only array
        given = {**values, name: np.full((3, 1, 2), values[name])}
        for item, scalar in zip(function(given), expected, strict=True):
            assert isinstance(item, np.ndarray)
            assert item.shape == (3, 1, 2), name
            assert item.dtype == float
            np.testing.assert_allclose(item, scalar, rtol=1e-12, atol=1e-13)
    if len(function.arguments) > 1:
        first, second, *_ = function.arguments
        columns = np.array([[values[first]], [values[first] * 1.01]])
        rows = np.array([values[second], values[second] * 1.02, values[second] * 1.03])
        for item in (table := function({**values, first: columns, second: rows})):
            assert item.shape == (2, 3)
        for i in range(2):
            for j in range(3):
                alone = function({**values, first: columns[i, 0], second: rows[j]})
                np.testing.assert_allclose(
                    [item[i, j] for item in table], alone, rtol=1e-12, atol=1e-13
                )


# ------------------------------------------------------------------------------------------------
# against the un-eliminated equations, by hand


def forces(
    point: dict[str, Any], x: Any, y: Any, mu: Any, sqrt: Callable[[Any], Any] = mpmath.sqrt
) -> tuple[Any, Any]:
    """F_x and F_y of (12) and (13): minus the sum of forces, written out from the figure of the
    model.
    """
    anchor_x, anchor_y = point["cos0"] - x, point["sin0"] - y
    length = sqrt(anchor_x**2 + anchor_y**2)
    tension = point["sigma"] * (length - 1)
    contact = -point["nbar"] * y
    return (
        point["alpha"] * x - tension * anchor_x / length - mu * contact,
        point["beta"] * y - tension * anchor_y / length - contact + point["kappa"],
    )


def at_rest(
    seed: int,
    contact: int,
    *unknowns: str,
    further: Callable[[sp.Matrix], list[sp.Expr]] = lambda K: [],
) -> tuple[dict[str, Any], list[Fraction]]:
    """A place and parameters, all rational, for which the forces vanish there, and the slopes of
    the forces.

    The unknowns solve linear equations: that the forces vanish, and what else is asked of their
    slopes.
    """
    here: dict[str, Any] = {name: sp.Rational(value) for name, value in rationals(seed).items()}
    here |= {name: sp.Symbol(name) for name in unknowns}
    here |= {
        "nbar": contact,
        "x": here["cos0"] - here["L"] * here["cos"],
        "y": here["sin0"] - here["L"] * here["sin"],
    }
    place = sp.symbols("x y")
    balance = sp.Matrix(forces(here, *place, here["mu0"], sp.sqrt))
    there = {symbol: here[symbol.name] for symbol in place}
    K = balance.jacobian(place).subs(there)
    (found,) = sp.linsolve([*balance.subs(there), *further(K)], *map(sp.Symbol, unknowns))
    solved = {sp.Symbol(name): value for name, value in zip(unknowns, found, strict=True)}

    def fraction(value: Any) -> Fraction:
        number = sp.sympify(value).subs(solved)
        return Fraction(int(number.p), int(number.q))

    return {name: fraction(value) for name, value in here.items()}, list(map(fraction, K))


def polynomial(coefficients: Iterable[Any], at: Any) -> Any:
    return sum(coefficient * at**power for power, coefficient in enumerate(coefficients))


@pytest.mark.parametrize("contact", [1, 0], ids=["contact", "liftoff"])
@pytest.mark.parametrize("seed", SEEDS)
def test_equilibria_of_the_uneliminated_equations(contact: int, seed: int) -> None:
    here, K = at_rest(seed, contact, "mu0" if contact else "alpha", "kappa")
    assert (
        polynomial(
            call(equilibrium.contact_quartic if contact else equilibrium.liftoff_quartic, here),
            here["L"],
        )
        == 0
    )
    matrix = call(equilibrium.contact_matrix if contact else equilibrium.liftoff_matrix, here)
    vector = call(equilibrium.contact_vector if contact else equilibrium.liftoff_vector, here)
    assert tuple(row[0] * here["cos"] + row[1] * here["sin"] for row in matrix) == vector
    trig = call(equilibrium.f_coefficients, here)
    assert equilibrium.f(here["cos"], here["sin"], *trig) == 0
    assert polynomial(equilibrium.t_quartic(*trig), here["sin"] / (1 + here["cos"])) == 0
    assert call(equilibrium.state, here) == (here["L"], here["x"], here["y"])
    assert call(equilibrium.residuals, here) == (0, 0)
    if contact:
        assert call(catastrophe.surface, here) == here["mu0"]
    assert leaves(call(stability.stiffness, here)) == K
    assert equilibrium.f_slope(here["cos"], here["sin"], *trig) == here["L"] * (
        K[0] * K[3] - K[1] * K[2]
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_folds_of_the_uneliminated_equations(seed: int) -> None:
    """Where the forces vanish and their Jacobian is singular every fold formula holds."""
    here, _ = at_rest(seed, 1, "mu0", "kappa", "alpha", further=lambda K: [K.det()])
    sin0, cos0 = here["sin0"], here["cos0"]
    assert polynomial(call(catastrophe.fold_quartic, here), here["mu0"]) == 0
    assert call(catastrophe.fold_angles, here) == (sin0, cos0)
    assert call(catastrophe.fold_sine, here) == sin0
    u1, w1, u2, w2 = call(catastrophe.fold_lines_mu0, here)
    assert (u1 + w1 * here["mu0"], u2 + w2 * here["mu0"]) == (0, 0)
    *in_sine, ec = call(catastrophe.fold_conic, here)
    assert polynomial(in_sine, sin0) + ec * cos0 == 0
    trig = call(equilibrium.f_coefficients, here)
    assert equilibrium.f_slope(here["cos"], here["sin"], *trig) == 0


@pytest.mark.parametrize("seed", SEEDS)
def test_flutter_onsets(seed: int) -> None:
    """Where the forces vanish and the eigenvalues of −K meet every formula of an onset holds."""
    difference = sp.Rational(rationals(seed)["a_v"])

    def meet(K: sp.Matrix) -> list[sp.Expr]:
        """(K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ = 0, with a difference that is given."""
        return [K[0, 0] - K[1, 1] - difference, K[0, 1] + difference**2 / (4 * K[1, 0])]

    here, K = at_rest(seed, 1, "mu0", "kappa", "alpha", "beta", further=meet)
    assert stability.invariants(*K)[2] == 0
    assert call(stability.flutter_friction, here) == here["mu0"]
    g0, g1, *cubic = call(stability.flutter_cubic, here)
    assert here["cos0"] * (g0 + g1 * here["sin0"]) == polynomial(cubic, here["sin0"])
    u1, w1, u2, w2 = call(stability.reference_lines, here)
    assert (u1 + w1 * here["L"], u2 + w2 * here["L"]) == (
        here["sin0"],
        here["alpha"] * here["cos0"],
    )
    assert polynomial(call(stability.flutter_quadratic, here), here["L"]) == 0
    X, Y, Z = call(stability.flutter_elimination, here)
    assert (X * X, X) == (Y * Z, Y * here["L"])


def test_motion_is_newtons_second_law() -> None:
    """Away from equilibrium, on both sides of V = x' and of y = 0, with the friction law written
    out.

    Its derivatives, its regimes and its energy are those of any model: ``test_models_generated``.
    """
    tiny = mpmath.mpf(10) ** -45
    with mpmath.workdps(50):
        for seed in range(12):
            point = reals(seed)
            point["vx"] = point["V"] - point["side"] * mpmath.mpf("0.3")
            if point["nbar"] == 0:
                point["y"] = -point["y"]

            def friction(vx: Any, p: dict[str, Any] = point) -> Any:
                slip = p["V"] - vx
                return p["mu0"] * (1 - mpmath.exp(-p["d"] * abs(slip))) * mpmath.sign(slip)

            right = forces(point, point["x"], point["y"], friction(point["vx"]))
            for ours, theirs in zip(NAMED["rhs"](point, mpmath), right, strict=True):
                assert abs(ours + theirs) < tiny
            assert abs(NAMED["friction"](point, mpmath)[0] - friction(point["vx"])) < tiny
            damping = point["nbar"] * point["y"] * mpmath.diff(friction, 0)
            assert abs(NAMED["damping"](point, mpmath)[0] - damping) < mpmath.mpf(10) ** -40


@pytest.mark.parametrize("seed", SEEDS)
def test_poles_of_the_linear_sprag_model(seed: int) -> None:
    """At the friction of a pole its linear balance is singular; two poles meet at μ_cr."""
    here = rationals(seed)
    alpha, sigma, beta, tangent = (here[name] for name in ("alpha", "sigma", "beta", "T"))
    mu0 = call(linear_sprag.pole_friction, here)
    along, across, coupling = (sigma * part / (1 + tangent**2) for part in (1, tangent**2, tangent))
    assert (alpha + along) * (beta + 1 + across) == (coupling + mu0) * coupling
    assert polynomial(call(linear_sprag.pole_quadratic, here | {"mu0": mu0}), tangent) == 0
    e0, e1, e2 = call(linear_sprag.pole_quadratic, here | {"mu0": 1})
    assert e1**2 * call(linear_sprag.critical_friction_squared, here) == 4 * e0 * e2


def f_by_hand(point: dict[str, Any], theta: Any) -> Any:
    """q sin θ F_x with L from F_y = 0, in contact, from the forces alone."""
    return (point["beta"] + 1 + point["sigma"]) * reference.along(
        theta, *(point[name] for name in PARAMETERS)
    )


def test_derivatives_of_f() -> None:
    """f, its derivatives in θ and its unfolding, against numerical derivatives of the balance of
    forces.
    """
    tiny = mpmath.mpf(10) ** -35
    with mpmath.workdps(50):
        for seed in range(4):
            point = reals(seed)
            point["nbar"] = mpmath.mpf(1)
            point["theta0"] = mpmath.atan2(point["sin0"], point["cos0"])
            theta = mpmath.atan2(point["sin"], point["cos"])
            coefficients = call(equilibrium.f_coefficients, point)
            for order, function in enumerate(
                (equilibrium.f, equilibrium.f_slope, equilibrium.f_curvature, equilibrium.f_third)
            ):
                right = mpmath.diff(lambda angle, p=point: f_by_hand(p, angle), theta, order)
                assert abs(function(point["cos"], point["sin"], *coefficients) - right) < tiny
            right = [
                mpmath.diff(
                    lambda angle, v, n=name, p=point: f_by_hand({**p, n: v}, angle),
                    (theta, point[name]),
                    (order, 1),
                )
                for name in PARAMETERS
                for order in (0, 1)
            ]
            for ours, theirs in zip(NAMED["unfolding"](point), right, strict=True):
                assert abs(ours - theirs) < tiny


def test_characteristic_polynomial_and_invariants() -> None:
    """det(λ² I + λ C + K) at random λ, as a determinant of numbers."""
    for seed in SEEDS:
        values = rationals(seed)
        k11, k12, k21, k22, c11 = (values[name] for name in ("K11", "K12", "K21", "K22", "C11"))
        coefficients = stability.characteristic(k11, k12, k21, k22, c11)
        for lam in (Fraction(0), Fraction(1), Fraction(-2), Fraction(3, 7), Fraction(5)):
            right = (lam**2 + lam * c11 + k11) * (lam**2 + k22) - k12 * k21
            assert (
                sum(
                    item * lam**power
                    for item, power in zip(coefficients, range(4, -1, -1), strict=True)
                )
                == right
            )
        trace, determinant, discriminant = stability.invariants(k11, k12, k21, k22)
        assert (trace, determinant) == (k11 + k22, k11 * k22 - k12 * k21)
        assert discriminant == trace**2 - 4 * determinant
