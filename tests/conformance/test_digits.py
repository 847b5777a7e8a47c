"""Equilibria of every model to any number of digits."""

import math
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym import precise
from spragsym.models.forces import named, undecorated
from spragsym.numerics.decimals import exactly
from spragsym.statics.balance import Balance
from tests.conformance import models
from tests.conformance.models import ALIKE, MODELS, answers, load
from tests.support import few


def a_set(name: str, **changes: Any) -> Any:
    """Base values, half a radian where there is none."""
    return models.a_set(name, math.degrees(0.5), **changes)


def has_digits(p: Any) -> bool:
    """Whether equilibria of the model are told to any number of digits."""
    return answers(p.model, "precise_equilibria", lambda: precise.equilibria(p))


@pytest.mark.by_hand(*ALIKE[1:])
@pytest.mark.parametrize("name", few(MODELS, "damped", "stick_slip"))
def test_digits_are_those_of_the_floats_and_of_more_digits(name: str) -> None:
    """The same states, types, directions and lengths; 25 digits hold those of 60."""
    p = a_set(name)
    if not has_digits(p):
        return
    for contact in p.model.regimes:
        floats = ss.equilibria(p, contact)
        few, many = (precise.equilibria(p, contact=contact, dps=dps) for dps in (25, 60))
        assert len(few) == len(many) == int(floats.count)
        assert few.complete == floats.complete
        order = sorted(
            range(len(few)), key=lambda slot: float(few[slot].numbers[p.model.coordinates[0]])
        )
        slots = np.argsort(floats[p.model.coordinates[0]][: len(few)])
        for place, slot in zip(order, slots.tolist(), strict=True):
            assert (
                few[place].undamped
                == many[place].undamped
                == ss.EquilibriumType(int(floats.undamped[slot]))
            )
            for one, decimal in (
                few[place].decimals(26).items()
            ):  # of a number that is known exactly too
                value, truth = float(floats[one][slot]), many[place].numbers[one]
                assert value == pytest.approx(float(truth), rel=1e-11, abs=1e-11), one
                number, error = map(exactly, decimal)
                assert error < Fraction(1, 10**24) * max(1, abs(number))
                exact, rest = map(exactly, many[place].decimals()[one])
                assert abs(number - exact) <= error + rest


def test_a_state_that_flutters_is_told_so_in_digits() -> None:
    """Beyond the onset, μ = ((1 + β − α)² + σ²)/(2 σ), and not before."""
    p = models.a_set("mode_coupling")
    alpha, beta, sigma = (float(p[name]) for name in ("alpha", "beta", "sigma"))
    onset = ((1 + beta - alpha) ** 2 + sigma**2) / (2 * sigma)
    for share, expected in ((0.999, "STABLE"), (1.001, "FLUTTER")):
        (state,) = precise.equilibria(p.replace(mu0=share * onset), dps=20)
        assert state.undamped.name == expected


@pytest.mark.by_hand(
    "damped", "stribeck", "cubic_contact", "inclined_belt", "trolley", "pad_on_disc"
)
@pytest.mark.parametrize("name", few(MODELS, "kang_nam", "stick_slip", "hertz_contact"))
def test_the_forces_vanish_to_as_many_digits(name: str) -> None:
    """Forces by mpmath, which the search does not use."""
    p = a_set(name)
    if not has_digits(p):
        return
    model = p.model
    balance = undecorated(model.algebra.forces)
    with mpmath.workdps(80):
        values: dict[str, Any] = {one: mpmath.mpf(float(p[one])) for one in model.parameters}
        for angle, (cosine, sine) in model.about["angles"].items():
            values |= {cosine: mpmath.cos(values[angle]), sine: mpmath.sin(values[angle])}
        motion = [values[one] for one in model.about["arguments"]["motion"]]
        laws = [
            undecorated(getattr(model.algebra, named("friction_at_rest", name)))
            for name in model.rubbing
        ]
        frictions = [law(*motion, xp=mpmath) for law in laws]
        statics = [values[one] for one in model.about["arguments"]["statics"]]
        for contact in model.regimes:
            for state in precise.equilibria(p, contact=contact, dps=60):
                q = [state.numbers[one] for one in model.coordinates]
                directions: list[Any] = []
                for dx, dy, _ in undecorated(model.algebra.geometry)(*q, *statics, xp=mpmath):
                    length = mpmath.hypot(dx, dy)
                    directions += [dx / length, dy / length, length]
                if model.about.get("torsions"):
                    pairs = undecorated(model.algebra.turnings)(
                        *q, *directions, *statics, xp=mpmath
                    )
                    directions += [mpmath.atan2(sine, cosine) for cosine, sine in pairs]
                pushing = Balance(model, contact).indicators
                forces = balance(*q, *directions, *statics, *frictions, *pushing, xp=mpmath)
                assert max(map(abs, forces)) < mpmath.mpf(10) ** -55


@pytest.mark.parametrize("contact", [True, False])
@pytest.mark.parametrize(
    "given",
    [{"theta0_deg": "49"}, {"theta0_deg": "30", "kappa": "1/70"}, {"theta0": 0.8, "mu0": 0}],
)
def test_the_search_is_a_second_witness_of_the_closed_forms(
    given: dict[str, Any], contact: bool
) -> None:
    closed, search = (
        precise.equilibria(**given, contact=contact, dps=50, method=way)
        for way in ("closed", "search")
    )
    assert len(closed) == len(search)
    assert closed.complete
    assert search.complete
    for one, other in zip(sorted(closed, key=lambda state: state.x), search, strict=True):
        assert one.undamped == other.undamped
        assert one.names == other.names
        for name in one.names:
            (mine, error), (its, rest) = (
                map(exactly, state.decimals()[name]) for state in (one, other)
            )
            assert abs(mine - its) <= error + rest < Fraction(1, 10**49)


#: Around the anchor of a torsion spring only numbers that floats hold are searched in polar
#: coordinates.
UNDECIDED = pytest.mark.xfail(raises=ss.errors.ConvergenceError, strict=True)
BESIDE = [
    pytest.param(name, id=name, marks=[UNDECIDED] if name == "soft_brake" else ())
    for name in MODELS
]


@pytest.mark.by_hand(*ALIKE)
@pytest.mark.parametrize("name", few(BESIDE, "kang_nam", "stick_slip", "sprag_rod", "pressed"))
def test_numbers_beside_floats_have_the_same_states(name: str) -> None:
    """Isolated over a box of parameters, each state on its side of the contact's border."""
    p = a_set(name)
    if not has_digits(p):
        return
    given = {one: Fraction(float(p[one])) for one in p.model.parameters}
    beside: dict[str, Any] = {
        f"{one}_" if one == "method" else one: value - Fraction(1, 10**20)
        for one, value in given.items()
        if value
    }
    for contact in p.model.regimes:
        both: Any = (
            precise.equilibria(p, contact=contact, dps=25),
            precise.equilibria(p, contact=contact, dps=25, **beside),
        )
        there, here = (
            sorted(found, key=lambda state: state.numbers[p.model.coordinates[0]]) for found in both
        )
        assert [state.undamped for state in there] == [state.undamped for state in here]
        for one, other in zip(there, here, strict=True):
            for column, value in one.numbers.items():
                assert 0 <= abs(value - other.numbers[column]) < 1e-16


@pytest.mark.parametrize(
    "weight", ["1.000000000000000000000000000001", "0.999999999999999999999999999999"]
)
def test_a_state_beside_the_border_of_the_contact_is_on_its_side(weight: str) -> None:
    """Where W = P all forces vanish at x = y = 0: 1e-30 beside that no float tells the side."""
    pytest.importorskip("sympy")
    p = a_set("pressed", P=1.0)
    touches = Fraction(weight) > 1
    assert len(precise.equilibria(p, W=weight)) == touches
    assert len(precise.equilibria(p, W=weight, contact=False)) == (not touches)
    # At W = P it is on the border, with a contact force of 0.
    for contact in (True, False):
        (state,) = precise.equilibria(p, W=1, contact=contact).states
        assert max(abs(number) for number in state.numbers.values()) < 1e-50


def _are_one(one: Any, other: Any, bound: Fraction) -> None:
    """Two enclosures of the same numbers, both narrow."""
    assert one.names == other.names
    assert one.versal == other.versal
    for name in one.names:
        (mine, error), (its, rest) = (map(exactly, cusp.decimals()[name]) for cusp in (one, other))
        assert abs(mine - its) <= error + rest < bound


@pytest.mark.thorough
@pytest.mark.parametrize(
    "given",
    [{}, {"kappa": "1/50", "sigma": "1/7"}, {"kappa": 0.0078125, "alpha": 0.0078125, "sigma": 0.5}],
)
def test_search_and_the_polynomial_have_the_same_cusps(given: dict[str, Any]) -> None:
    """Those of the plane that a page allows: θ₀ in (0, π), μ₀ ≥ 0."""
    closed, search = (
        precise.cusps(**given, dps=50),
        precise.cusps(**given, dps=50, method="search", between={"mu0": (0, 3)}),
    )
    within = [one for one in closed if 0 < one.theta0 < math.pi and 0 <= one.mu0 < 3]
    assert len(search) == len(within) > 0
    for one, other in zip(within, search, strict=True):
        _are_one(one, other, Fraction(1, 10**49))
    assert closed.complete
    assert precise.cusps(**given, dps=50, vary=("mu0", "theta0")) == closed
    assert search.complete == all(
        Fraction(value) == float(Fraction(value)) for value in ({"kappa": "0.007"} | given).values()
    )
    assert set(search.region) == {"x", "y", "theta0", "mu0"}


@pytest.mark.by_hand("soft_brake", "two_springs", *ALIKE)
@pytest.mark.parametrize("name", few([name for name in MODELS if len(load(name).axes) == 2]))
def test_cusps_to_digits_are_those_of_floats(name: str) -> None:
    p = a_set(name)
    vary = p.model.axes
    between = {"mu0": (0.0, 2.0)} if "mu0" in vary else None
    floats = ss.cusps(p, vary, between=between, method="search")
    few, many = (
        precise.cusps(p, vary=vary, between=between, dps=dps, method="search") for dps in (25, 60)
    )
    assert len(few) == len(many) == len(floats)
    assert few.complete == many.complete == floats.complete
    assert list(few.region.values()) == [tuple(ends) for ends in floats.region.tolist()]
    order = np.lexsort([floats[one] for one in vary])
    for one, other, slot in zip(few, many, order.tolist(), strict=True):
        _are_one(one, other, Fraction(1, 10**24))
        for column, number in one.numbers.items():
            assert float(number) == pytest.approx(float(floats[column][slot]), rel=1e-11, abs=1e-11)
