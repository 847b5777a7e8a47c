"""Equilibria of several contacts: every combination of those that touch, against linear systems by
hand and closed forms.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from tests.oracles.contact_pages import FOUR, HEAD, LADDER, PAD, RANGES, SHOES, THREE, balanced, pad
from tests.oracles.user_pages import model_of, replaced

pytest.importorskip("sympy")


def drawn(model: Any, number: int, seed: int) -> tuple[Any, list[dict[str, float]]]:
    rng = np.random.default_rng(seed)
    names = [name for name in model.parameters if name in RANGES]
    values = {name: rng.uniform(*RANGES[name], number) for name in names}
    rows = [{name: float(values[name][row]) for name in names} for row in range(number)]
    return model.Parameters(**values), rows


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("page", "names", "number"),
    [
        (PAD, ("front", "rear"), 20),
        (THREE, ("front", "rear", "middle"), 20),
        (FOUR, ("front", "rear", "middle", "stop"), 6),
    ],
    ids=["two", "three", "four"],
)
def test_all_combinations_of_touches_are_found(
    page: str, names: tuple[str, ...], number: int
) -> None:
    model = model_of(page, f"pad_on_{len(names)}")
    p, rows = drawn(model, number, len(names))
    eq = ss.equilibria(p)
    assert eq.complete
    seen = set[str]()
    for row, values in enumerate(rows):
        expected = [
            (", ".join(touching), q)
            for touching, q in balanced(*pad(values, names))
            if touching  # states in lift-off are asked for by contact=False
        ]
        assert eq.count[row] == len(expected)
        found = {eq["touching"][row, slot]: slot for slot in range(eq.count[row])}
        for touching, q in expected:
            got = [eq[name][row, found[touching]] for name in model.coordinates]
            np.testing.assert_allclose(got, q, rtol=0, atol=1e-12)
            seen.add(touching)
    assert len(seen) >= len(names)


def test_one_combination_is_asked_for_by_name() -> None:
    model = model_of(PAD, "pad_on_2")
    p, _ = drawn(model, 20, 2)
    every = ss.equilibria(p)
    for contact, touching in ((True, "front, rear"), (("front",), "front"), (["rear"], "rear")):
        one = ss.equilibria(p, contact=contact)
        assert one.complete
        wanted = (every["touching"] == touching).sum(axis=-1)
        assert one.count.tolist() == wanted.tolist()
    assert ss.equilibria(p, contact=("front", "rear")).contact is True
    assert ss.equilibria(p, contact=False).count.tolist() == [0] * 20
    assert ss.count(p).tolist() == every.count.tolist()


def test_the_rear_leg_lifts_at_the_friction_of_the_closed_form() -> None:
    model = model_of(PAD, "pad_on_2")
    rng = np.random.default_rng(5)
    k_t, h = rng.uniform(0.05, 1.0, 20), rng.uniform(0.2, 1.5, 20)
    lifts = (2 + k_t) / (2 * h)
    for side, touching in ((1 - 1e-12, "front, rear"), (1 + 1e-12, "front")):
        eq = ss.equilibria(model.Parameters(mu0=side * lifts, k_t=k_t, h=h))
        assert eq.complete
        assert eq["touching"][:, 0].tolist() == [touching] * 20


def test_the_normal_forces_of_a_leading_and_a_trailing_shoe() -> None:
    model = model_of(SHOES, "shoes")
    rng = np.random.default_rng(6)
    F, l, b, c = (rng.uniform(*ends, 20) for ends in ((0.01, 0.1), (1, 2), (0.5, 1), (0.5, 1)))
    mu = rng.uniform(0.1, 0.95, 20) * b / c
    shoes = {"F": F, "l": l, "b": b, "c": c}
    eq = ss.equilibria(model.Parameters(mu0=mu, **shoes))
    assert eq.complete
    assert eq.count.tolist() == [1] * 20
    leading, trailing = eq["contact_force_leading"][:, 0], eq["contact_force_trailing"][:, 0]
    np.testing.assert_allclose(leading, F * l / (b - mu * c), rtol=1e-12)
    np.testing.assert_allclose(trailing, F * l / (b + mu * c), rtol=1e-12)
    locked = ss.equilibria(model.Parameters(mu0=1.01 * b / c, **shoes))
    assert locked.complete
    assert not locked.count.any()


@pytest.mark.thorough
def test_a_ladder_slides_at_the_inclination_of_the_closed_form() -> None:
    model = model_of(LADDER, "ladder")
    rng = np.random.default_rng(7)
    mu, nu = rng.uniform(0.1, 1.0, 4), rng.uniform(0.0, 0.9, 4)
    within = {"alpha": (0.01, 1.56), "x": (-3.0, 3.0), "y": (-3.0, 3.0)}
    eq = ss.equilibria(model.Parameters(mu0=mu, nu=nu), within=within)
    assert eq.decided.all()
    assert eq.count.tolist() == [1] * 4
    assert set(eq["touching"][:, 0].tolist()) == {"floor, wall"}
    np.testing.assert_allclose(np.tan(eq["alpha"][:, 0]), (1 - mu * nu) / (2 * mu), rtol=1e-11)


def a_study(model: ss.Model) -> ss.Study:
    """Base values in SI, one of each unit."""
    quantities = {entry["quantity"]: entry["base"] for entry in model.about["parameters"]}
    units = {entry["name"]: 1.0 for entry in model.about["units"]}
    return ss.Study(quantities | units, model=model.where)


def test_data_with_units_have_the_friction_that_works_at_every_contact() -> None:
    """Statics takes the coefficient times the share of it that works, the same of both legs."""
    model = model_of(PAD, "pad_on_2")
    at_work = a_study(model).operating_point
    assert float(at_work["mu0"]) == 0.3 * np.tanh(20.0)
    laws = [model.friction(at_work, "friction_at_rest", name) for name in model.rubbing]
    assert laws == [at_work["mu0"]] * 2
    with pytest.raises(ss.errors.ParameterError, match="contact = None of pad_on_2 is one of 'f"):
        model.friction(at_work)
    law = "V, lambda v: mu0 * tanh(v / V), at_rest=mu0, on=trailing"
    study = a_study(model_of(replaced(SHOES, ("V, law, at_rest=mu0, on=trailing", law)), "shoes"))
    with pytest.raises(ss.errors.ModelError, match="work at different shares of mu0"):
        study.operating_point  # noqa: B018  # a property


def test_every_question_is_answered_of_two_legs() -> None:
    """What is not, of other pages, says so: see the tests of three and four contacts."""
    model = model_of(PAD, "pad_on_2")
    p = model.Parameters()
    for name in ("check", "explore", "export to fmu", "prove_cycle", "report", "sticking_states"):
        assert not model.refusal(name)
    with pytest.raises(ss.errors.ParameterTypeError, match="nor some of front, rear"):
        ss.equilibria(p, contact=("left",))


@pytest.mark.thorough
def test_a_table_without_a_spring_stands_on_no_single_leg() -> None:
    """Its weight is on that leg by one row, and nothing by the moments: no force is both."""
    p = model_of(THREE, "pad_on_3").Parameters(k_t=0.0)
    eq = ss.equilibria(p)
    mu0, F, h, k_x, s = p.scalars("mu0", "F", "h", "k_x", "s")
    assert eq.complete
    assert eq["touching"].tolist() == ["front, rear, middle"]
    expected = [mu0 * F / k_x, -(F + 2 * s) / 4, mu0 * h * F / 2]
    np.testing.assert_allclose([eq[name][0] for name in ("x", "y", "phi")], expected, rtol=1e-13)


#: A drawer that is pulled beside its middle: on one guide, or none, its spring along x − e ψ holds
#: nothing in one direction, and nothing balances the couple M.
DRAWER = (
    HEAD
    + """
M = page.parameter("M", "N m", "couple", ">= 0", 0.02)
e = page.parameter("e", "m", "distance of the pull from the middle", "> 0", 1.5)
k = page.parameter("k", "N/m", "stiffness of the pull", "> 0", 0.5)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
phi = page.coordinate("phi", "rad", "turning")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2 + a**2 * page.rate(phi)**2) / 2)
page.spring(k, along=x - e * phi)
page.force(M, along=phi)
front = page.contact(-y - a * phi, lambda depth: k_c * depth, name="front")
rear = page.contact(y - a * phi, lambda depth: k_c * depth, name="rear")
page.friction(x, V, law, at_rest=mu0, on=front)
page.friction(x, V, law, at_rest=mu0, on=rear)
"""
)


@pytest.mark.thorough
def test_where_no_force_balances_a_couple_no_state_is_left_open() -> None:
    hardening = DRAWER.replace("k_c * depth,", "k_c * depth + k_c * depth**3 / a**2,", 1)
    hard = model_of(hardening, "hard_drawer").Parameters()
    assert ss.equilibria(hard, contact=("front",)).complete
    p = model_of(DRAWER, "drawer").Parameters()
    for touching in ("front",), ("rear",), ():
        alone = ss.equilibria(p, contact=touching)
        assert alone.complete
        assert alone.count == 0
    # Without the couple every turning is a state, and no region has them all.
    assert not ss.equilibria(p.replace(M=0.0), contact=False).complete
    ranges = {"mu0": (0.1, 0.3), "M": (0.01, 0.02)}
    proof = ss.certify(p, "one equilibrium", between=ranges)
    assert (proof.outcome, proof.boxes < 100) == ("proved", True)


#: A table between two nuts of a screw, whose gaps leave each other's depth 2 δ at most, and no
#: bound is seen of the table alone.
NUTS = (
    HEAD
    + """
delta = page.parameter("delta", "m", "preload of the nuts", "> 0", 0.05)
k_m = page.parameter("k_m", "N m", "stiffness of the motor", "> 0", 0.3)
k_x = page.parameter("k_x", "N/m", "workpiece", "> 0", 0.1)
F = page.parameter("F", "N", "cutting force", "real", 0.02)
x = page.coordinate("x", "m", "table")
phi = page.coordinate("phi", "rad", "screw")
page.kinetic(m * (page.rate(x)**2 + a**2 * page.rate(phi)**2) / 2)
page.potential(k_m * phi**2 / 2 + k_x * x**2 / 2 - F * x)
left = page.contact(x - a * phi - delta, lambda depth: k_c * depth, name="left")
right = page.contact(a * phi - x - delta, lambda depth: k_c * depth * (1 + depth / a), name="right")
page.friction(3 * a * phi + x / 3, V, law, at_rest=mu0, on=left)
page.friction(3 * a * phi + x / 3, V, law, at_rest=mu0, on=right)
"""
)


def test_two_faces_of_a_slot_bound_each_other() -> None:
    p = model_of(NUTS, "nuts").Parameters(mu0=0.1)
    eq = ss.equilibria(p)
    assert eq.complete
    assert ss.folds(p, "mu0", between={"mu0": (0.0, 0.2)}).complete
    x, phi = eq["x"][0], eq["phi"][0]
    left, depth = 0.05 - (x - phi), 0.05 + x - phi
    right = depth * (1 + depth)
    rows = [
        0.02 - 0.1 * x + left - right + 0.1 * (left + right) / 3,
        -0.3 * phi - left + right + 0.1 * (left + right) * 3,
    ]
    assert np.abs(rows).max() < 1e-14


def test_an_angle_that_moves_no_equilibrium_is_no_axis_of_their_picture() -> None:
    theta = 'theta = page.parameter("theta", "rad", "of the creep", "[0, 1]", 0.3)\nx = page.coord'
    page = replaced(PAD, ("x = page.coord", theta)).replace("phi, V,", "phi, V * sin(theta),")
    model = model_of(page, "creeping_pad")
    assert (model.inclination, model.coefficient) == ("theta", "mu0")
    assert "theta" not in model.plane
    assert model.plane[0] == "mu0"
