"""Generated functions: one algebra for every number type, and the numbers of the un-eliminated equations."""

from __future__ import annotations

import importlib
import inspect
import itertools
import pkgutil
import random
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp

from spragsym import generated
from spragsym.derive.kang_nam import catastrophe as folds
from spragsym.derive.kang_nam import elimination, unit_circles
from spragsym.derive.kang_nam import equilibrium as balance
from spragsym.derive.kang_nam import linear_sprag as linear_model
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.derive.kang_nam import stability as linearized
from spragsym.generated import catastrophe, equilibrium, laws, linear_sprag, scales, stability
from spragsym.generated._where import where
from spragsym.generated.models.kang_nam import algebra
from tests.support import as_mpf, few

EPS = 2.0**-53

# -------------------------------------------------------------------------------------------------- discovery


@dataclass(frozen=True)
class Generated:
    """One generated function and what its signature says."""

    module: str
    name: str
    call: Callable[..., Any]

    @cached_property
    def arguments(self) -> tuple[str, ...]:
        return tuple(name for name in inspect.signature(self.call).parameters if name != "xp")

    @cached_property
    def transcendental(self) -> bool:
        return "xp" in inspect.signature(self.call).parameters

    def __call__(self, values: dict[str, Any], xp: Any = None) -> list[Any]:
        """All results, flat."""
        options = {"xp": xp} if self.transcendental and xp is not None else {}
        return list(flat(self.call(*(values[name] for name in self.arguments), **options)))


def flat(result: Any) -> Iterator[Any]:
    if isinstance(result, tuple):
        for item in result:
            yield from flat(item)
    else:
        yield result


MODULES = [
    module.name
    for module in pkgutil.iter_modules(generated.__path__)
    if not module.ispkg
    and not module.name.startswith("_")
    and module.name not in ("kernel", "quantities", "double_double")  # they have tests of their own
]
FUNCTIONS = [
    Generated(name, function, getattr(module, function))
    for name, module in ((name, importlib.import_module(f"spragsym.generated.{name}")) for name in MODULES)
    for function in module.__all__
]
#: Of the page's functions those of the motion, which come last.
FUNCTIONS += [Generated("motion", name, getattr(algebra, name)) for name in algebra.__all__[algebra.__all__.index("rhs") :]]
each_function = pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f"{f.module}.{f.name}")
NAMED = {function.name: function for function in FUNCTIONS}


def call(function: Callable[..., Any], values: dict[str, Any]) -> Any:
    """A function of the arguments that it names."""
    return function(*(values[name] for name in inspect.signature(function).parameters))


def test_discovery() -> None:
    assert {"equilibrium", "stability", "catastrophe", "linear_sprag", "laws", "scales"} <= set(MODULES)
    assert len({(function.module, function.name) for function in FUNCTIONS}) == len(FUNCTIONS)


# ---------------------------------------------------------------------------------------------------- numbers

_RANGES: dict[str, tuple[float, float]] = {
    "L": (0.3, 1.8), "mu0": (0.05, 1.5), "mu": (0.05, 1.5), "n": (0, 0.5), "kappa": (0.002, 0.3),
    "alpha": (0.005, 0.9), "sigma": (0.02, 1.5),
    "beta": (0, 2), "a_f": (-1, 1), "b_f": (-1, -0.01), "d_f": (-1, 1), "m_f": (0, 1),
    "a_v": (-1, 1), "b_v": (-1, 1), "d_v": (-1, 1), "m_v": (-1, 1),
    "K11": (-1, 1), "K12": (-1, 1), "K21": (-1, 1), "K22": (-1, 1), "C11": (-0.1, 0.1), "T": (0.1, 4),
    "x": (-0.2, 0.3), "y": (-0.3, -0.01), "vx": (-0.4, 0.4), "vy": (-0.4, 0.4), "V": (0.5, 1), "d": (0.5, 3),
    "m": (0.2, 5), "k_c": (5, 500), "L_0": (0.1, 2), "F_L": (0.1, 3), "k_x": (0.1, 10), "k": (0.5, 50),
    "k_y": (0.1, 10), "V_dim": (0.1, 2), "d_dim": (0.1, 9),
}  # fmt: skip


def rationals(seed: int) -> dict[str, Fraction]:
    """Random rationals for every argument there is; cosines and sines on the unit circle, 0 < θ, θ₀ < π."""
    generator = random.Random(seed)
    point = {}
    for name, (low, high) in _RANGES.items():
        width = Fraction(high - low).limit_denominator(1000)
        point[name] = Fraction(low).limit_denominator(1000) + width * Fraction(generator.randint(1, 96), 97)
    for cosine, sine in (("cos", "sin"), ("cos0", "sin0")):
        half = Fraction(generator.randint(8, 90), 32)
        point[cosine], point[sine] = (1 - half**2) / (1 + half**2), 2 * half / (1 + half**2)
    point["nbar"], point["side"] = Fraction(generator.randint(0, 1)), Fraction(generator.choice([-1, 1]))
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
    """|f| + Σ |xᵢ ∂f/∂xᵢ| for each result: what relative errors of size 1 in the arguments would do to it."""
    with mpmath.workdps(60):
        centre = exact(function, values, 60)
        total = [abs(item) for item in centre]
        step = mpmath.mpf(10) ** -20
        for name in function.arguments:
            if name in ("nbar", "pushing", "side", "near1") or values[name] == 0:  # given exactly
                continue
            moved = {key: mpmath.mpf(value) for key, value in values.items()}
            for place, item in enumerate(function(moved | {name: moved[name] * (1 + step)}, mpmath)):
                total[place] += abs(item - centre[place]) / step
        return total


@each_function
def test_float64_is_within_a_few_ulp(function: Generated) -> None:
    """Errors are a modest multiple of what rounding the arguments costs, and inside of the enclosure."""
    for seed in SEEDS:
        values = floats(seed)
        truth = exact(function, values, 50)
        with mpmath.workprec(53):
            mpmath.iv.prec = 53
            enclosures = function({name: mpmath.iv.mpf(value) for name, value in values.items()}, Intervals)
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


@each_function
def test_intervals_enclose(function: Generated) -> None:
    for seed in SEEDS:
        values = floats(seed)
        truth = exact(function, values, 80)
        mpmath.iv.prec = 120
        try:
            given = {name: mpmath.iv.mpf(value) for name, value in values.items()}
            for enclosure, right in zip(function(given, Intervals), truth, strict=True):
                with mpmath.workdps(80):
                    low, high = ends(enclosure)
                    assert low <= right <= high
                    assert high - low <= 1e-28 * (1 + abs(right)), "an enclosure that says nothing"
        finally:
            mpmath.iv.prec = 53


@each_function
def test_intervals_of_arguments_enclose(function: Generated) -> None:
    """Arguments a percent wide: the enclosure holds the values inside, and not only the one in the middle."""
    for seed in SEEDS:
        values = rationals(seed)
        ends_of = {
            name: (float(value) - abs(float(value)) / 200, float(value) + abs(float(value)) / 200)
            for name, value in values.items()
        }
        wide = {name: mpmath.iv.mpf(pair) for name, pair in ends_of.items()}
        wide |= {name: mpmath.iv.mpf(int(values[name])) for name in ("nbar", "side")}
        try:
            enclosures = function(wide, Intervals)
        except ZeroDivisionError:
            continue
        generator = random.Random(seed)
        for _ in range(3):
            inside = {name: value * (1 + Fraction(generator.randint(-9, 9), 2000)) for name, value in values.items()}
            inside |= {name: values[name] for name in ("nbar", "side")}
            with mpmath.workdps(30):
                given = {name: as_mpf(value) for name, value in inside.items()}
                for enclosure, right in zip(enclosures, function(given, mpmath), strict=True):
                    low, high = ends(enclosure)
                    assert low <= right <= high


class RationalStandIns:
    """Rational functions in place of √, exp and sgn: what a function does around them can be followed exactly."""

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
    """Fractions in, fractions out, for all functions: no rational constant of theirs passes through float64."""
    for seed in SEEDS:
        results = function(rationals(seed), RationalStandIns)
        assert all(isinstance(item, Fraction) for item in results), [type(item) for item in results]
        with mpmath.workdps(70):
            for item, right in zip(results, function(reals(seed), RationalStandIns), strict=True):
                assert abs(as_mpf(item) - right) <= mpmath.mpf(10) ** -50 * (1 + abs(right))


def test_functions_with_roots_and_exponentials_are_among_them() -> None:
    assert {function.name for function in FUNCTIONS if function.transcendental} >= {"friction", "rhs", "regime_rhs", "energy"}


# ----------------------------------------------------------------------------------------------------- arrays


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
                np.testing.assert_allclose([item[i, j] for item in table], alone, rtol=1e-12, atol=1e-13)


def test_empty_arrays_keep_their_shape() -> None:
    empty = np.empty((0, 2))
    (_, d12), (d21, _) = equilibrium.contact_matrix(empty, 0.5, 0.007, 0.1, 0.0)
    assert d12.shape == d21.shape == (0, 2)


def test_keyword_arguments_count_as_arguments() -> None:
    kappa = np.array([0.007, 0.008])
    coefficients = equilibrium.contact_quartic(0.6, 0.8, mu0=0.5, kappa=kappa, alpha=0.007, sigma=0.1, beta=0.0)
    assert [item.shape for item in coefficients] == [(2,)] * 5
    assert equilibrium.contact_matrix(L=Fraction(1), mu0=0, alpha=0, sigma=0, beta=0)[1][0] == 0


def test_shapes_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="broadcast"):
        equilibrium.liftoff_vector(0.6, 0.8, 0.007, np.zeros(2), np.zeros(3))


# ---------------------------------------------------------------------------- against the derived expressions


def _spelled(values: Iterable[Any], case: dict[Any, int] | None = None) -> tuple[sp.Expr, ...]:
    return tuple(balance.spell_out(sp.sympify(value)).subs(case or {}) for value in values)


def _state() -> tuple[sp.Expr, ...]:
    state = elimination.state()
    return state[nm.L], state[nm.x].subs(nm.L, state[nm.L]), state[nm.y]


def _cusp_point() -> tuple[sp.Expr, ...]:
    sin0, ratio = folds.cusp_angles()
    return sin0, ratio, (folds.cusp_friction() / nm.c / nm.sigma).subs(elimination.f_coefficients())


def _in_lines(value: sp.Expr) -> sp.Expr:
    """The elimination in parameters, for the coefficients that it is written in."""
    coefficients = (*linearized.reference_lines(), *linearized.flutter_quadratic())
    names = (*linearized.LINES, *linearized.QUADRATIC)
    return value.subs(dict(zip(names, coefficients, strict=True)))


def _fold_lines(name: sp.Symbol) -> tuple[sp.Expr, ...]:
    relations = [relation.expand() for relation in _spelled(folds.fold_residuals(), CONTACT)]
    return tuple(part for relation in relations for part in (relation.subs(name, 0), relation.diff(name)))


def _fold_conic() -> tuple[sp.Expr, ...]:
    u1, w1, u2, w2 = _fold_lines(nm.mu0)
    conic = sp.Poly(u1 * w2 - u2 * w1, nm.s0, nm.c0)
    assert set(conic.monoms()) == {(0, 0), (1, 0), (2, 0), (0, 1)}
    return tuple(conic.coeff_monomial(power) for power in (1, nm.s0, nm.s0**2, nm.c0))


def _fold_events() -> tuple[sp.Expr, ...]:
    """The discriminant of the quartic in S = sin θ₀ that is left of conic and circle, without its further factor (4 Ec E2)²."""
    e0, e1, e2, ec = (unit_circles.reduce_circles(sp.expand(value)) for value in (*_fold_conic()[:3], _fold_conic()[3] / nm.c))
    square, S = sp.expand(ec**2 * (1 - nm.s**2)), sp.Symbol("S")
    symbols = sp.symbols("e0 e1 e2 square")
    in_sine = sp.Poly((symbols[0] + symbols[1] * S + symbols[2] * S**2) ** 2 - symbols[3] * (1 - S**2), S)
    meeting = sp.cancel(27 * 256 * sp.discriminant(in_sine) / (4 * symbols[3] * symbols[2]) ** 2)
    s0, c0 = (value.subs(nm.M, 0) for value in folds.fold_angles())
    rest = (nm.p * nm.B * nm.q * nm.alpha) ** 2 * (s0**2 + (c0.subs(nm.s0, s0) / nm.c) ** 2 * (1 - nm.s**2) - 1)
    values = dict(zip(symbols, (e0, e1, e2, square), strict=True))
    return meeting.subs(values), e0**2 - square, *_spelled([rest.subs(nm.c**2, 1 - nm.s**2)], CONTACT)


def _fold_events_without_alpha() -> tuple[sp.Expr, ...]:
    """Without α the conic is a parabola in sin θ₀: its discriminant, and its values at 0 and 1."""
    e0, e1, e2 = (unit_circles.reduce_circles(sp.expand(value.subs(nm.alpha, 0))) for value in _fold_conic()[:3])
    S = sp.Symbol("S")
    parabola = e0 + e1 * S + e2 * S**2
    return sp.discriminant(parabola, S), parabola.subs(S, 0), parabola.subs(S, 1)


CONTACT, LIFTOFF = balance.CONTACT, balance.LIFTOFF
#: What the derivation gives, before it is arranged for emission; spelled out in parameters.
DERIVED: dict[str, Callable[[], tuple[sp.Expr, ...]]] = {
    "contact_matrix": lambda: _spelled(balance.matrix_form()[0], CONTACT),
    "contact_vector": lambda: _spelled(balance.matrix_form()[1], CONTACT),
    "liftoff_matrix": lambda: _spelled(balance.matrix_form()[0], LIFTOFF),
    "liftoff_vector": lambda: _spelled(balance.matrix_form()[1], LIFTOFF),
    "contact_quartic": lambda: _spelled(elimination.quartic_in_L(), CONTACT),
    "liftoff_quartic": lambda: _spelled(elimination.quartic_in_L(), LIFTOFF),
    "singular_lengths": lambda: _spelled(elimination.singular_lengths()),
    "f_coefficients": lambda: _spelled(elimination.f_coefficients()[name] for name in (nm.fa, nm.fb, nm.fd, nm.fm)),
    "f": lambda: (elimination.f_form,),
    "t_quartic": elimination.quartic_in_t,
    "resolvent": lambda: elimination.resolvent_cubic()[:3],
    "state": lambda: _spelled(_state()),
    "residuals": lambda: _spelled(balance.balance()),
    "stiffness": lambda: _spelled(linearized.stiffness()),
    "reference_lines": lambda: _spelled(linearized.reference_lines(), CONTACT),
    "flutter_quadratic": lambda: _spelled(linearized.flutter_quadratic(), CONTACT),
    "flutter_elimination": lambda: _spelled(map(_in_lines, linearized.flutter_elimination()), CONTACT),
    "flutter_without_alpha": lambda: _spelled([_in_lines(linearized.flutter_without_alpha())], {**CONTACT, nm.alpha: 0}),
    "flutter_crossing": lambda: _spelled(linearized.flutter_crossing(), CONTACT),
    "flutter_cubic": lambda: _spelled(linearized.flutter_cubic(), CONTACT),
    "flutter_friction": lambda: _spelled([linearized.flutter_friction()], CONTACT),
    "surface": lambda: _spelled([folds.surface()], CONTACT),
    "fold_residuals": lambda: tuple(name - value for name, value in folds.fold_relations().items()),
    "fold_angles": lambda: _spelled((s0 := folds.fold_angles()[0], folds.fold_angles()[1].subs(nm.s0, s0)), CONTACT),
    "fold_sine": lambda: _spelled(folds.fold_angles()[:1], CONTACT),
    **{f"fold_lines_{name}": partial(_fold_lines, name) for name in nm.PARAMETERS},
    "fold_conic": _fold_conic,
    "fold_events": _fold_events,
    "fold_events_without_alpha": _fold_events_without_alpha,
    "fold_quartic": lambda: _spelled(folds.fold_quartic(), CONTACT),
    "fold_quadratic": lambda: tuple(value.subs(nm.alpha, 0) for value in _spelled(folds.fold_quadratic(), CONTACT)),
    "cusp_polynomial": lambda: _spelled(folds.cusp_polynomial(), CONTACT),
    "cusp_cubic": lambda: _spelled(folds.cusp_cubic(), CONTACT),
    "cusp_point": lambda: _spelled(_cusp_point(), CONTACT),
    "cusp_sine": lambda: _spelled(_cusp_point()[::2], CONTACT),
    "displacement": linear_model.equilibrium,
    "pole_quadratic": linear_model.pole_quadratic,
    "pole_friction": lambda: (linear_model.pole_friction(),),
    "critical_friction_squared": lambda: (linear_model.critical_friction_squared(),),
}
#: Emitted up to a factor that is free of the unknown.
UP_TO_A_FACTOR = {"fold_quartic"}


@pytest.mark.parametrize("name", few(DERIVED, *(set(DERIVED) - {"cusp_polynomial", "flutter_cubic"})))
def test_fractions_equal_the_derived_value(name: str) -> None:
    function, expressions = NAMED[name], DERIVED[name]()
    for seed in SEEDS[:3]:
        values = rationals(seed)
        by_name = {key: sp.Rational(value.numerator, value.denominator) for key, value in values.items()}
        ours = [sp.Rational(item.numerator, item.denominator) for item in function(values)]
        derived = [item.xreplace({symbol: by_name[symbol.name] for symbol in item.free_symbols}) for item in expressions]
        if name in UP_TO_A_FACTOR:
            derived = [item * ours[-1] / derived[-1] for item in derived]
        assert ours == derived


# --------------------------------------------------------------- against the un-eliminated equations, by hand


def forces(point: dict[str, Any], x: Any, y: Any, mu: Any) -> tuple[Any, Any]:
    """F_x and F_y of (12) and (13): minus the sum of forces, written out from the figure of the model."""
    anchor_x, anchor_y = point["cos0"] - x, point["sin0"] - y
    length = mpmath.sqrt(anchor_x**2 + anchor_y**2)
    tension = point["sigma"] * (length - 1)
    contact = -point["nbar"] * y
    return (
        point["alpha"] * x - tension * anchor_x / length - mu * contact,
        point["beta"] * y - tension * anchor_y / length - contact + point["kappa"],
    )


def equilibrium_points(contact: int) -> Iterator[tuple[dict[str, Any], Any, Any]]:
    """Random parameters with the equilibria that Newton's method finds on (12) and (13), at 50 digits."""
    for seed in range(8 if contact else 20):
        generator = random.Random(seed)
        point = reals(seed)
        theta0 = mpmath.mpf(generator.randint(10, 170)) * mpmath.pi / 180
        point |= {"cos0": mpmath.cos(theta0), "sin0": mpmath.sin(theta0), "nbar": mpmath.mpf(contact)}
        point["alpha"] /= 10
        if not contact:  # springs weak enough for the mass to stand above the anchor, off the belt
            point["beta"], point["kappa"] = point["beta"] / 50, point["kappa"] / 20
        for direction in range(6):
            angle = (direction + mpmath.mpf("0.37")) * mpmath.pi / (3 if contact == 0 else 6)
            start = point["cos0"] - mpmath.cos(angle), point["sin0"] - mpmath.sin(angle)
            try:
                x, y = mpmath.findroot(lambda x, y, p=point: forces(p, x, y, p["mu0"]), start, maxsteps=60)
            except (ValueError, ZeroDivisionError):
                continue
            if (y < 0) == (contact == 1):
                yield point, x, y


@pytest.mark.thorough
@pytest.mark.parametrize("contact", [1, pytest.param(0, marks=pytest.mark.thorough)], ids=["contact", "liftoff"])
def test_equilibria_of_the_uneliminated_equations(contact: int) -> None:
    found = 0
    tiny = mpmath.mpf(10) ** -44
    with mpmath.workdps(50):
        for point, x, y in equilibrium_points(contact):
            found += 1
            length = mpmath.hypot(point["cos0"] - x, point["sin0"] - y)
            here = {**point, "L": length, "cos": (point["cos0"] - x) / length, "sin": (point["sin0"] - y) / length}
            quartic = call(equilibrium.contact_quartic if contact else equilibrium.liftoff_quartic, here)
            assert abs(mpmath.polyval(quartic[::-1], length)) < tiny * max(map(abs, quartic))
            a_f, b_f, d_f, m_f = call(equilibrium.f_coefficients, here)
            here |= {"a_f": a_f, "b_f": b_f, "d_f": d_f, "m_f": m_f}
            assert abs(call(equilibrium.f, here)) < tiny
            t = here["sin"] / (1 + here["cos"])
            assert abs(mpmath.polyval(equilibrium.t_quartic(a_f, b_f, d_f, m_f)[::-1], t)) < tiny * (1 + abs(t)) ** 4
            for ours, right in zip(call(equilibrium.state, here), (length, x, y), strict=True):
                assert abs(ours - right) < tiny
            assert all(abs(value) < tiny for value in call(equilibrium.residuals, here))
            matrix = call(equilibrium.contact_matrix if contact else equilibrium.liftoff_matrix, here)
            vector = call(equilibrium.contact_vector if contact else equilibrium.liftoff_vector, here)
            for row, side in zip(matrix, vector, strict=True):
                assert abs(row[0] * here["cos"] + row[1] * here["sin"] - side) < tiny
            if contact and abs(here["cos"]) > 0.01:
                assert abs(call(catastrophe.surface, here) - point["mu0"]) < tiny * 1000

            def force(row: int, p: dict[str, Any] = point) -> Callable[[Any, Any], Any]:
                return lambda u, v: forces(p, u, v, p["mu0"])[row]

            K = [[mpmath.diff(force(row), (x, y), order) for order in ((1, 0), (0, 1))] for row in range(2)]
            for ours, right in zip(flat(call(stability.stiffness, here)), (K[0][0], K[0][1], K[1][0], K[1][1]), strict=True):
                assert abs(ours - right) < mpmath.mpf(10) ** -40
            determinant = K[0][0] * K[1][1] - K[0][1] * K[1][0]
            assert abs(call(equilibrium.f_slope, here) - length * determinant) < mpmath.mpf(10) ** -40
    assert found >= 8


def slope_of(function: Generated, point: dict[str, Any], name: str) -> Any:
    return mpmath.diff(lambda value: function({**point, name: value}, mpmath)[0], point[name])


def test_motion_is_newtons_second_law() -> None:
    """Away from equilibrium, on both sides of V = x' and of y = 0, with the friction law written out."""
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

            def acceleration(x: Any, y: Any, vx: Any, vy: Any, p: dict[str, Any] = point) -> Any:
                return [-value for value in forces(p, x, y, friction(vx, p))]

            state = tuple(point[name] for name in ("x", "y", "vx", "vy"))
            right = acceleration(*state)
            for name in ("rhs", "regime_rhs"):
                for ours, theirs in zip(NAMED[name](point, mpmath), right, strict=True):
                    assert abs(ours - theirs) < tiny
            orders = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
            slopes = [mpmath.diff(lambda *s, i=i: acceleration(*s)[i], state, order) for i in range(2) for order in orders]
            for ours, theirs in zip(NAMED["regime_jacobian"](point, mpmath), slopes, strict=True):
                assert abs(ours - theirs) < mpmath.mpf(10) ** -40

            def changed(name: str, value: Any, p: dict[str, Any] = point) -> dict[str, Any]:
                if name != "theta0":
                    return {**p, name: value}
                turn = mpmath.expj(value) * mpmath.mpc(p["cos0"], p["sin0"])
                return {**p, "cos0": turn.real, "sin0": turn.imag}

            names = ("theta0", "mu0", "kappa", "alpha", "sigma", "beta", "V", "d")
            slopes = [
                mpmath.diff(lambda value, i=i, name=name, s=state: acceleration(*s, changed(name, value))[i], point.get(name, 0))
                for i in range(2) for name in names
            ]  # fmt: skip
            for ours, theirs in zip(NAMED["regime_by_parameters"](point, mpmath), slopes, strict=True):
                assert abs(ours - theirs) < mpmath.mpf(10) ** -35

            # Energy changes at the rate of the friction's power, and of nothing else.
            gradient = [slope_of(NAMED["energy"], point, name) for name in ("x", "y", "vx", "vy")]
            rate = mpmath.fdot(gradient, (point["vx"], point["vy"], *right))
            assert abs(rate - NAMED["friction_power"](point, mpmath)[0]) < mpmath.mpf(10) ** -40
            assert abs(NAMED["friction"](point, mpmath)[0] - friction(point["vx"])) < tiny
            rest = {**point, "vx": mpmath.mpf(0)}
            slope = -rest["nbar"] * -rest["y"] * slope_of(NAMED["friction"], rest, "vx")
            assert abs(NAMED["damping"](rest, mpmath)[0] - slope) < mpmath.mpf(10) ** -40


def test_linear_sprag_against_its_linear_balance() -> None:
    with mpmath.workdps(50):
        for seed in range(6):
            point = reals(seed)
            c0, s0, sigma, mu0 = (point[name] for name in ("cos0", "sin0", "sigma", "mu0"))
            x, y = linear_sprag.displacement(c0, s0, mu0, point["kappa"], point["alpha"], sigma, point["beta"])
            along_spring = sigma * (x * c0 + y * s0)
            assert abs(point["alpha"] * x + along_spring * c0 + mu0 * y) < mpmath.mpf(10) ** -45
            assert abs((point["beta"] + 1) * y + along_spring * s0 + point["kappa"]) < mpmath.mpf(10) ** -45
            # At the friction of a pole that balance is singular, and the quadratic in tan θ₀ vanishes.
            T = abs(s0 / c0)
            stiffnesses = point["alpha"], sigma, point["beta"]
            pole = linear_sprag.pole_friction(T, *stiffnesses)
            cosine = 1 / mpmath.sqrt(1 + T**2)
            matrix = mpmath.matrix([
                [point["alpha"] + sigma * cosine**2, sigma * cosine**2 * T + pole],
                [sigma * cosine**2 * T, point["beta"] + 1 + sigma * (T * cosine) ** 2],
            ])  # fmt: skip
            assert abs(mpmath.det(matrix)) < mpmath.mpf(10) ** -45
            e0, e1, e2 = linear_sprag.pole_quadratic(pole, *stiffnesses)
            assert abs(e0 + e1 * T + e2 * T**2) < mpmath.mpf(10) ** -44
            # μ_cr is the least friction of a pole.
            critical = mpmath.sqrt(linear_sprag.critical_friction_squared(*stiffnesses))
            least = linear_sprag.pole_friction(mpmath.sqrt(e0 / e2), *stiffnesses)
            assert abs(critical - least) < mpmath.mpf(10) ** -45
            assert pole >= critical


BASE = {"kappa": "0.007", "alpha": "0.007", "sigma": "0.1", "beta": "0", "nbar": "1"}


@pytest.mark.parametrize("degrees", ["44.559317702565", "155.059418789789"])
def test_folds_of_the_uneliminated_equations(degrees: str) -> None:
    """F_x = F_y = det K = 0 solved for x, y, θ₀ at the base values and μ₀ = 0.5; then every fold formula."""
    with mpmath.workdps(40):
        point: dict[str, Any] = {name: mpmath.mpf(value) for name, value in BASE.items()} | {"mu0": mpmath.mpf("0.5")}

        def at(x: Any, y: Any, theta0: Any) -> dict[str, Any]:
            cos0, sin0 = mpmath.cos(theta0), mpmath.sin(theta0)
            length = mpmath.hypot(cos0 - x, sin0 - y)
            return {**point, "cos0": cos0, "sin0": sin0, "cos": (cos0 - x) / length, "sin": (sin0 - y) / length, "L": length}

        def fold(x: Any, y: Any, theta0: Any) -> tuple[Any, Any, Any]:
            here = at(x, y, theta0)
            pull = here["sigma"] / here["L"]
            along = here["alpha"] + here["sigma"] - pull * here["sin"] ** 2
            across = here["beta"] + 1 + here["sigma"] - pull * here["cos"] ** 2
            coupling = pull * here["sin"] * here["cos"]
            return *forces(here, x, y, here["mu0"]), along * across - (coupling + here["mu0"]) * coupling

        start = best_start(fold, mpmath.radians(mpmath.mpf(degrees)))
        x, y, theta0 = mpmath.findroot(fold, start)
        assert abs(mpmath.degrees(theta0) - mpmath.mpf(degrees)) < mpmath.mpf(10) ** -11
        here = at(x, y, theta0)
        tiny = mpmath.mpf(10) ** -34
        assert abs(mpmath.polyval(call(catastrophe.fold_quartic, here)[::-1], here["mu0"])) < tiny * 1e4
        sin0, cos0 = call(catastrophe.fold_angles, here)
        assert abs(sin0 - here["sin0"]) < tiny
        assert abs(cos0 - here["cos0"]) < tiny * 100
        for name in ("mu0", "kappa", "alpha", "sigma", "beta"):
            u1, w1, u2, w2 = call(getattr(catastrophe, f"fold_lines_{name}"), here)
            assert abs(u1 + w1 * here[name]) < tiny
            assert abs(u2 + w2 * here[name]) < tiny
        assert abs(call(catastrophe.fold_sine, here) - sin0) < tiny
        e0, e1, e2, ec = call(catastrophe.fold_conic, here)
        assert abs(e0 + e1 * here["sin0"] + e2 * here["sin0"] ** 2 + ec * here["cos0"]) < tiny
        here |= dict(zip(("a_f", "b_f", "d_f", "m_f"), call(equilibrium.f_coefficients, here), strict=True))
        assert all(abs(value) < tiny for value in call(catastrophe.fold_residuals, here))
        assert abs(call(equilibrium.f, here)) < tiny
        assert abs(call(equilibrium.f_slope, here)) < tiny


def f_by_hand(point: dict[str, Any], theta: Any) -> Any:
    """q sin θ F_x with L from F_y = 0, in contact, from the forces alone."""
    c, s = mpmath.cos(theta), mpmath.sin(theta)
    cos0, sin0 = mpmath.cos(point["theta0"]), mpmath.sin(point["theta0"])
    q = point["beta"] + 1 + point["sigma"]
    length = (point["sigma"] * s + (point["beta"] + 1) * sin0 + point["kappa"]) / (q * s)
    here = {**point, "cos0": cos0, "sin0": sin0, "nbar": 1}
    return q * s * forces(here, cos0 - length * c, sin0 - length * s, point["mu0"])[0]


def test_derivatives_of_f() -> None:
    """f, its derivatives in θ and its unfolding, against numerical derivatives of the balance of forces."""
    tiny = mpmath.mpf(10) ** -35
    with mpmath.workdps(50):
        for seed in range(4):
            point = reals(seed)
            point["nbar"] = mpmath.mpf(1)
            point["theta0"] = mpmath.atan2(point["sin0"], point["cos0"])
            theta = mpmath.atan2(point["sin"], point["cos"])
            coefficients = call(equilibrium.f_coefficients, point)
            for order, function in enumerate((equilibrium.f, equilibrium.f_slope, equilibrium.f_curvature, equilibrium.f_third)):
                right = mpmath.diff(lambda angle, p=point: f_by_hand(p, angle), theta, order)
                assert abs(function(point["cos"], point["sin"], *coefficients) - right) < tiny
            right = [
                mpmath.diff(lambda angle, v, n=name, p=point: f_by_hand({**p, n: v}, angle), (theta, point[name]), (order, 1))
                for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta") for order in (0, 1)
            ]  # fmt: skip
            for ours, theirs in zip(NAMED["unfolding"](point), right, strict=True):
                assert abs(ours - theirs) < tiny


def test_magnitudes_bound_their_terms() -> None:
    for seed in SEEDS:
        values = rationals(seed)
        a, d = call(equilibrium.f_magnitudes, values)
        stiff = values["beta"] + values["nbar"]
        friction = values["mu0"] * values["nbar"]
        terms = (stiff + values["sigma"]) * values["alpha"] * abs(values["cos0"])
        assert a == values["sigma"] * (stiff + values["alpha"])
        assert d == terms + friction * values["sigma"] * values["sin0"] + friction * values["kappa"]


def test_characteristic_polynomial_and_invariants() -> None:
    """det(λ² I + λ C + K) at random λ, as a determinant of numbers."""
    for seed in SEEDS:
        values = rationals(seed)
        k11, k12, k21, k22, c11 = (values[name] for name in ("K11", "K12", "K21", "K22", "C11"))
        coefficients = stability.characteristic(k11, k12, k21, k22, c11)
        for lam in (Fraction(0), Fraction(1), Fraction(-2), Fraction(3, 7), Fraction(5)):
            right = (lam**2 + lam * c11 + k11) * (lam**2 + k22) - k12 * k21
            assert sum(item * lam**power for item, power in zip(coefficients, range(4, -1, -1), strict=True)) == right
        trace, determinant, discriminant = stability.invariants(k11, k12, k21, k22)
        assert (trace, determinant) == (k11 + k22, k11 * k22 - k12 * k21)
        assert discriminant == trace**2 - 4 * determinant


def best_start(fold: Callable[..., tuple[Any, Any, Any]], theta0: Any) -> tuple[Any, Any, Any]:
    """The coarse grid point with the least residual at a given θ₀."""
    grid = [
        (mpmath.cos(theta0) - mpmath.cos(angle) * 1, mpmath.mpf(depth) / 200)
        for angle in (mpmath.pi * step / 40 for step in range(1, 40))
        for depth in range(-12, 0)
    ]
    x, y = min(grid, key=lambda place: max(abs(value) for value in fold(*place, theta0)))
    return x, y, theta0


def test_cusp_at_the_base_values() -> None:
    """Against what continuation programs agree on: θ₀ = 68.0209585077443°, μ₀ = 0.200931781805090."""
    with mpmath.workdps(40):
        kappa, alpha, sigma, beta = (mpmath.mpf(BASE[name]) for name in ("kappa", "alpha", "sigma", "beta"))
        coefficients = catastrophe.cusp_polynomial(kappa, alpha, sigma, beta)
        roots = mpmath.polyroots(coefficients[::-1], maxsteps=200, extraprec=200)
        found = []
        for root in roots:
            if abs(mpmath.im(root)) > 1e-25 or abs(mpmath.re(root)) >= 1:
                continue
            s = mpmath.re(root)
            sin0, cosine_ratio, mu_ratio = catastrophe.cusp_point(s, kappa, alpha, sigma, beta)
            for ours, same in zip(catastrophe.cusp_sine(s, kappa, alpha, sigma, beta), (sin0, mu_ratio), strict=True):
                assert abs(ours - same) < mpmath.mpf(10) ** -35
            for c in (mpmath.sqrt(1 - s**2), -mpmath.sqrt(1 - s**2)):
                mu0, cos0 = mu_ratio * c, cosine_ratio * c
                assert abs(sin0**2 + cos0**2 - 1) < mpmath.mpf(10) ** -25
                f = equilibrium.f_coefficients(cos0, sin0, mu0, kappa, alpha, sigma, beta, mpmath.mpf(1))
                for derivative in (equilibrium.f, equilibrium.f_slope, equilibrium.f_curvature):
                    assert abs(derivative(c, s, *f)) < mpmath.mpf(10) ** -25
                if mu0 > 0:
                    found.append((mpmath.degrees(mpmath.atan2(sin0, cos0)), mu0))
        theta0, mu0 = min(found, key=lambda cusp: abs(cusp[0] - 68))
        assert abs(theta0 - mpmath.mpf("68.0209585077443")) < 1e-12
        assert abs(mu0 - mpmath.mpf("0.200931781805090")) < 1e-14


@pytest.mark.thorough
def test_flutter_onsets() -> None:
    """Where the cubic in sin θ₀ meets cos θ₀, an equilibrium is an onset: there the eigenvalues of −K meet."""
    checked = 0
    with mpmath.workdps(40):
        for seed in range(10):
            point = reals(seed)
            kappa, alpha, sigma, beta = (point[name] for name in ("kappa", "alpha", "sigma", "beta"))
            c, s = point["cos"], point["sin"]
            g0, g1, *k = stability.flutter_cubic(c, s, kappa, alpha, sigma, beta)

            def gap(angle: Any, g0: Any = g0, g1: Any = g1, k: list[Any] = k) -> Any:
                sine = mpmath.sin(angle)
                return mpmath.cos(angle) * (g0 + g1 * sine) - mpmath.polyval(k[::-1], sine)

            angles = [mpmath.pi * (i + mpmath.mpf("0.5")) / 400 for i in range(400)]
            for low, high in itertools.pairwise(angles):
                if gap(low) * gap(high) > 0:
                    continue
                angle = mpmath.findroot(gap, (low, high), solver="anderson", tol=1e-70)
                cos0, sin0 = mpmath.cos(angle), mpmath.sin(angle)
                length = (sigma * s + (beta + 1) * sin0 + kappa) / ((beta + 1 + sigma) * s)
                mu0 = stability.flutter_friction(c, s, length, alpha, sigma, beta)
                x, y = cos0 - length * c, sin0 - length * s
                here = {**point, "cos0": cos0, "sin0": sin0, "nbar": mpmath.mpf(1)}
                assert max(abs(value) for value in forces(here, x, y, mu0)) < mpmath.mpf(10) ** -20
                K = stability.stiffness(c, s, length, mu0, alpha, sigma, beta, mpmath.mpf(1))
                _, _, discriminant = stability.invariants(*flat(K))
                assert abs(discriminant) < mpmath.mpf(10) ** -20
                # The two conditions that the elimination starts from, and its result.
                u1, w1, u2, w2 = stability.reference_lines(c, s, mu0, kappa, alpha, sigma, beta)
                assert abs(u1 + w1 * length - sin0) < mpmath.mpf(10) ** -20
                assert abs(u2 + w2 * length - alpha * cos0) < mpmath.mpf(10) ** -20
                X, Y, Z = stability.flutter_elimination(c, s, mu0, kappa, alpha, sigma, beta)
                assert abs(X * X - Y * Z) < mpmath.mpf(10) ** -18 * (X * X + abs(Y * Z))
                assert abs(X / Y - length) < mpmath.mpf(10) ** -18
                checked += 1
    assert checked >= 3


def test_scales_make_the_unit_coefficients() -> None:
    """Mass, contact stiffness and undeformed length are 1, and the groups are the article's ratios."""
    m, k_c, L_0, F_L, k_x, k, k_y, V, d = (Fraction(n) for n in (3, 200, 2, 5, 7, 11, 13, 17, 19))
    with mpmath.workdps(30):
        numbers = [mpmath.mpf(int(value)) for value in (m, k_c, L_0, F_L, k_x, k, k_y, V, d)]
        length, time, force = scales.scales(*numbers[:3], xp=mpmath)
        assert length == 2
        assert abs(time - mpmath.sqrt(mpmath.mpf(3) / 200)) < 1e-28
        assert force == 400
        groups = scales.dimensionless_groups(*numbers, xp=mpmath)
        right = (numbers[3] / 400, *(stiffness / 200 for stiffness in numbers[4:7]), 17 * time / 2, 19 * 2 / time)
        assert all(abs(ours - theirs) < 1e-27 for ours, theirs in zip(groups, right, strict=True))


def test_spring_length_and_accelerations_of_the_undeformed_state() -> None:
    assert laws.spring_length(0.6, -0.2, 0.6, 0.8) == pytest.approx(1.0, abs=EPS)
    # At rest, out of contact and undeformed, the preload alone accelerates.
    along, across = algebra.rhs(0.0, 0.0, 0.0, 0.0, 0.6, 0.8, mu0=0.3, kappa=0.007, alpha=0.1, sigma=0.2, beta=0.3, V=0.5, d=10.0)
    assert (along, across) == pytest.approx((0.0, -0.007), abs=EPS)


def test_docstrings_count_operations_and_name_their_source() -> None:
    for function in FUNCTIONS:
        documentation = inspect.getdoc(function.call) or ""
        assert "Source: " in documentation, function.name
        assert "Operations: " in documentation, function.name
        assert all(f"\n{name} : number or array\n" in documentation for name in function.arguments), function.name


@pytest.mark.parametrize("share", [0.0, 0.03, 0.4, 0.97, 1.0])
@pytest.mark.parametrize("shape", [(3,), (5000,), (2, 3000)])
def test_the_choice_between_numbers_is_that_of_numpy_bit_for_bit(share: float, shape: tuple[int, ...]) -> None:
    """For every share of flags, of arrays and single numbers, of one shape or several, and of any type."""
    rng = np.random.default_rng(5)
    flag = rng.random(shape) < share
    one, other = rng.normal(0, 1, (2, *shape))
    one[..., :2], other[..., 1:3] = (np.nan, -0.0), (np.inf, 0.0)
    row, long = other.reshape(-1)[: shape[-1]], one.astype(np.longdouble)
    pairs = [(one, other), (1.0, other), (one, -0.0), (1.0, np.float64(2.0)), (row, one), (long, other)]
    cases: list[tuple[Any, ...]] = [(flag, *pair) for pair in pairs]
    cases += [(flag.reshape(-1)[: shape[-1]], one, row), (flag[..., ::2], one[..., ::2], other[..., ::2]), (flag, 1, other)]
    cases += [(flag, one.astype(np.float32), np.float32(1.0)), (bool(flag.flat[0]), one, other)]
    for case in cases:
        got, wanted = where(*case), np.where(*case)
        assert got.dtype == wanted.dtype
        assert got.shape == wanted.shape
        assert got.tobytes() == wanted.tobytes() or wanted.dtype == np.longdouble
        np.testing.assert_array_equal(got, wanted)
