"""Equilibria of every model to any number of digits."""

from __future__ import annotations

import copy
import math
import pickle
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
from spragsym import precise
from spragsym.exact.decimals import exactly
from spragsym.exact.intervals import Balls
from spragsym.exact.krawczyk import narrowed
from spragsym.models.forces import undecorated
from spragsym.models.load import shipped

MODELS = shipped()


def a_set(name: str, **changes: Any) -> Any:
    """Base values, half a radian where there is none."""
    model = ss.load(name)
    return model.Parameters(**({"theta0": 0.5} if "theta0" in model.parameters else {}) | changes)


@pytest.mark.parametrize("name", MODELS)
def test_digits_are_those_of_the_floats_and_of_more_digits(name: str) -> None:
    """The same states, types, directions and lengths; 25 digits hold those of 60."""
    p = a_set(name)
    for contact in p.model.regimes:
        floats = p.model.equilibria(p, contact)
        few, many = (precise.equilibria(p, contact=contact, dps=dps) for dps in (25, 60))
        assert len(few) == len(many) == int(floats.count)
        assert few.complete == floats.complete
        order = sorted(range(len(few)), key=lambda slot: float(few[slot].numbers[p.model.coordinates[0]]))
        slots = np.argsort(getattr(floats, p.model.coordinates[0])[: len(few)])
        for place, slot in zip(order, slots.tolist(), strict=True):
            assert few[place].stability == many[place].stability == ss.Stability(int(floats.stability[slot]))
            for one, decimal in few[place].decimals().items():
                value, truth = float(getattr(floats, one)[slot]), many[place].numbers[one]
                assert value == pytest.approx(float(truth), rel=1e-11, abs=1e-11), one
                number, error = map(exactly, decimal)
                assert error < Fraction(1, 10**24) * max(1, abs(number))
                exact, rest = map(exactly, many[place].decimals()[one])
                assert abs(number - exact) <= error + rest


@pytest.mark.parametrize("name", MODELS)
def test_the_forces_vanish_to_as_many_digits(name: str) -> None:
    """Forces by mpmath, which the search does not use."""
    p = a_set(name)
    model = p.model
    balance = undecorated(model.statics.forces)
    with mpmath.workdps(80):
        values: dict[str, Any] = {one: mpmath.mpf(float(getattr(p, one))) for one in model.parameters}
        for angle, (cosine, sine) in model.about["angles"].items():
            values |= {cosine: mpmath.cos(values[angle]), sine: mpmath.sin(values[angle])}
        law = undecorated(model.statics.friction_at_rest)
        mu = law(*(values[one] for one in model.about["arguments"]["motion"]), xp=mpmath)
        statics = [values[one] for one in model.about["arguments"]["statics"]]
        for contact in model.regimes:
            for state in precise.equilibria(p, contact=contact, dps=60):
                q = [state.numbers[one] for one in model.coordinates]
                directions: list[Any] = []
                for dx, dy, _ in undecorated(model.statics.geometry)(*q, *statics, xp=mpmath):
                    length = mpmath.hypot(dx, dy)
                    directions += [dx / length, dy / length, length]
                if model.about.get("torsions"):
                    pairs = undecorated(model.statics.turnings)(*q, *directions, *statics, xp=mpmath)
                    directions += [mpmath.atan2(sine, cosine) for cosine, sine in pairs]
                forces = balance(*q, *directions, *statics, mu, int(contact), xp=mpmath)
                assert max(map(abs, forces)) < mpmath.mpf(10) ** -55


@pytest.mark.parametrize("contact", [True, False])
@pytest.mark.parametrize("given", [{"theta0_deg": "49"}, {"theta0_deg": "30", "kappa": "1/70"}, {"theta0": 0.8, "mu0": 0}])
def test_the_search_is_a_second_witness_of_the_closed_forms(given: dict[str, Any], contact: bool) -> None:
    closed, search = (precise.equilibria(**given, contact=contact, dps=50, method=way) for way in ("closed", "search"))
    assert len(closed) == len(search)
    assert closed.complete
    assert search.complete
    for one, other in zip(sorted(closed, key=lambda state: state.x), search, strict=True):
        assert one.stability == other.stability
        assert one.names == other.names
        for name in one.names:
            (mine, error), (its, rest) = (map(exactly, state.decimals()[name]) for state in (one, other))
            assert abs(mine - its) <= error + rest < Fraction(1, 10**49)


@pytest.mark.parametrize("name", MODELS)
def test_numbers_beside_floats_have_the_same_states(name: str) -> None:
    """Isolated over a box of parameters, each state on its side of the contact's border."""
    p = a_set(name)
    given = {one: Fraction(float(getattr(p, one))) for one in p.model.parameters}
    beside: dict[str, Any] = {one: value + Fraction(1, 10**20) for one, value in given.items() if value}
    for contact in p.model.regimes:
        both: Any = (precise.equilibria(p, contact=contact, dps=25), precise.equilibria(p, contact=contact, dps=25, **beside))
        there, here = (sorted(found, key=lambda state: state.numbers[p.model.coordinates[0]]) for found in both)
        assert [state.stability for state in there] == [state.stability for state in here]
        for one, other in zip(there, here, strict=True):
            for column, value in one.numbers.items():
                assert 0 <= abs(value - other.numbers[column]) < 1e-16


def test_a_root_that_newton_meets_elsewhere_is_not_that_of_the_box() -> None:
    """x³ = x from the middle of a box around 0 leads to −1."""

    class Cubic:
        bits = 200

        def values(self, unknowns: Any) -> Any:
            (x,) = unknowns
            return [x**3 - x]

        def slopes(self, unknowns: Any) -> Any:
            (x,) = unknowns
            return [[3 * x**2 - 1]]

    box = np.array([[0.01], [0.95]])
    assert narrowed(Cubic(), box, box) is None
    near = np.array([[0.01], [0.02]])
    found = narrowed(Cubic(), near, box)
    assert found is not None
    assert max(map(abs, Balls().ends(found[0]))) < 1e-40


def test_an_angle_that_is_known_worse_than_coordinates_gets_more_digits() -> None:
    states = precise.equilibria(a_set("trolley", theta0=3.0, sigma=0.5), dps=30)
    assert max(state.error for state in states) < 1e-30


def test_a_set_is_taken_exactly_and_numbers_by_name_replace_its_own() -> None:
    p = ss.Parameters.article(theta0=0.8)
    assert precise.equilibria(p) == precise.equilibria(theta0=0.8, mu0=0.5, kappa=0.007, alpha=0.007, sigma=0.1, beta=0)
    assert precise.equilibria(p, kappa="0.007")[0] != precise.equilibria(p)[0]
    state = precise.equilibria(p)[0]
    assert pickle.loads(pickle.dumps(state)) == copy.deepcopy(state) == state  # noqa: S301  # our own
    with pytest.raises(AttributeError, match="phi"):
        _ = state.phi


def test_numbers_that_no_float_is_are_taken_exactly_by_any_model() -> None:
    """x = μ(V) of the mass on one spring, as its page says: rational for rational parameters."""
    p = ss.load("stick_slip").Parameters()
    (state,) = precise.equilibria(p, V="1/3", mu_s="2/7", v_s="1/10", dps=40)
    exact = 2 * Fraction(2, 7) * Fraction(1, 10) * Fraction(1, 3) / (Fraction(1, 3) ** 2 + Fraction(1, 10) ** 2)
    number, error = map(exactly, state.decimals()["x"])
    assert abs(number - exact) <= error < Fraction(1, 10**39)


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda: precise.equilibria(0.8), "theta0=0.8"),
        (lambda: precise.equilibria(ss.Parameters.article(theta0=[0.5, 0.8])), r"shape \(2,\)"),
        (lambda: precise.equilibria(a_set("stick_slip"), theta0=1), "theta0 is no parameter of stick_slip"),
        (lambda: precise.equilibria(a_set("stick_slip"), contact=False), "no lift-off"),
        (lambda: precise.equilibria(a_set("stick_slip"), method="closed"), "closed"),
        (lambda: precise.equilibria(a_set("stick_slip"), V="x"), "V = 'x' is not a number"),
        (lambda: precise.equilibria(a_set("stick_slip", V=0.0), V=math.nan), "V = nan"),
        (lambda: precise.cusps(a_set("two_springs")), "two_springs"),
        (lambda: precise.cusps(theta0=0.8), "theta0 is not asked: the answer is for all theta0"),
        (lambda: precise.cusps(theta0_deg=49), "theta0_deg is not asked: the answer is for all theta0"),
    ],
)
def test_what_is_wrong_is_named(ask: Any, told: str) -> None:
    with pytest.raises(ss.SpragsymError, match=told):
        ask()
