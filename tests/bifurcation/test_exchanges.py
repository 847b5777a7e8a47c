"""Mirrors that exchange coordinates or contacts: pitchforks of twins, against the same pages written
in means and half differences, and the forces themselves at random places.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.models.forces import undecorated
from tests.bifurcation.test_twins import TWINS
from tests.oracles.user_pages import model_of, replaced

pytest.importorskip("sympy")

#: V = Σ (k q²/2 − c q⁴/4 + e q⁶/6 − F q) over x and z, − P (x − z)²/4.
PAIR = """'''Two equal masses that a load drives apart.'''
from spragsym.derive.model import Page
page = Page("Two equal masses that a load drives apart.")
m, k, a = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness"), page.unit("a", "m", "size")
P = page.parameter("P", "N/m", "load over length", "real", 0.5)
F = page.parameter("F", "N", "pull on each", "real", 0.3)
c = page.parameter("c", "1", "softening", "real", 0.4)
e = page.parameter("e", "1", "hardening", ">= 0", 0.3)
x, z = page.coordinate("x", "m", "first"), page.coordinate("z", "m", "second")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(z) ** 2) / 2)
for q in (x, z):
    page.potential(k * q**2 / 2 - c * k * q**4 / (4 * a**2) + e * k * q**6 / (6 * a**4) - F * q)
page.potential(-P * (x - z) ** 2 / 4)
"""
MEANS = replaced(
    PAIR,
    (
        'x, z = page.coordinate("x", "m", "first"), page.coordinate("z", "m", "second")',
        's, d = page.coordinate("s", "m", "mean"), page.coordinate("d", "m", "half difference")\n'
        "x, z = s + d, s - d",
    ),
)


def follows(model: Any, one: Any, values: dict[str, float], mu: float) -> bool:
    """Whether F(S q) = S F(q) at a place, of a model without springs along lines."""
    p = model.Parameters(**{name: values[name] for name in model.parameters})
    mus, touch = [mu] * max(1, len(model.frictions)), [1] * len(model.contacts)
    given, function = model.arguments(p, "statics"), undecorated(model.algebra.forces)
    places, signs = one["places"], np.array(one["signs"])
    q = np.random.default_rng(91).normal(size=len(places))
    there, here = (
        np.array(function(*state, *given, *mus, *touch, xp=np)) for state in (signs * q[places], q)
    )
    return np.allclose(there, signs * here[places], atol=1e-13)


def test_forces_follow_every_exchange_where_its_equations_hold() -> None:
    """And not where one of the equations fails."""
    seen = 0
    for model in map(ss.load, ("two_blocks", "disc_between_pads", "pad_on_legs")):
        for one in model.about["exchanges"]:
            for equations in one["where"]:
                said = dict(equations)
                mu = 0.37 * all(name in model.parameters for name in said)
                values = {**model.base, **said}
                assert follows(model, one, values, mu)
                for name in said:
                    wrong = {**values, name: values[name] + 0.3}
                    assert not follows(
                        model, one, wrong, mu or 0.3 * (name not in model.parameters)
                    )
                seen += 1
    assert seen >= 4


@pytest.mark.thorough
def test_twins_part_at_a_pitchfork_beside_their_fold() -> None:
    """k x = μ F e^(2x) of both folds at x = 1/2; they part where k + 2 t = 2 μ F e^(2x)."""
    k, t, F = 0.02, 0.005, 0.01
    p = model_of(TWINS, "twins").Parameters(k=k, t=t, F=F)
    found = ss.folds(p, "mu", between={"mu": (0.2, 0.5)}, within={"x": (0.0, 2.0), "z": (0.0, 2.0)})
    assert found.decided
    assert found.kind.tolist() == ["pitchfork", "fold"]
    apart = (k + 2 * t) / (2 * k)
    wanted = [k * apart / (F * np.exp(2 * apart)), k / 2 / (F * np.e)]
    np.testing.assert_allclose(found.mu, wanted, rtol=1e-13)
    np.testing.assert_allclose([found.x, found.z], [[apart, 0.5]] * 2, rtol=1e-13)
    unlike = replaced(TWINS, ("page.normal_force(F * exp(2 * z", "page.normal_force(F * exp(3 * z"))
    about = model_of(unlike, "unlike_twins").about
    assert not any(one["where"] == [[]] for one in about.get("exchanges", ()))


@pytest.mark.thorough
@pytest.mark.parametrize("c", [0.4, -0.4])
def test_a_pair_parts_as_it_does_in_means_and_half_differences(c: float) -> None:
    """Softening springs let it snap apart, with folds beside the pitchfork; stiffening ones do
    not.
    """
    pair, means = (
        model.Parameters(P=0.5, F=0.3, c=c, e=0.3)
        for model in (model_of(PAIR, "pair"), model_of(MEANS, "pair_in_means"))
    )
    own, other = (ss.folds(p, "P", between={"P": (0.3, 1.6)}) for p in (pair, means))
    assert own.complete
    assert own.kind.tolist() == other.kind.tolist()
    np.testing.assert_allclose(own.P, other.P, rtol=1e-12)
    np.testing.assert_allclose(0.5 * (own.x + own.z), other.s, rtol=1e-12)
    np.testing.assert_allclose(np.abs(own.x - own.z) / 2, np.abs(other.d), atol=1e-12)
    jumps = [float(ss.jump_value(p, "P")) for p in (pair, means)]
    np.testing.assert_allclose(jumps[0], jumps[1], rtol=1e-13)
    assert np.isnan(jumps[0]) == (c < 0)
    ends = [ss.quasi_static_path(p, "P", np.linspace(0.5, 1.6, 12)) for p in (pair, means)]
    np.testing.assert_allclose(0.5 * (ends[0].x - ends[0].z)[-1], ends[1].d[-1], rtol=1e-12)


def test_blocks_are_twins_where_masses_of_their_statics_agree() -> None:
    exchanges = ss.load("two_blocks").about["exchanges"]
    assert exchanges[0]["places"] == [1, 0]
    assert exchanges[0]["where"] == [[["beta", 1.0], ["kappa", 1.0]]]
    disc = ss.load("disc_between_pads").about["exchanges"]
    assert disc[0] == {"places": [0, 1], "signs": [-1, -1], "contacts": [1, 0], "where": [[]]}


#: Two equal masses that snap, a x + x³ = F each, tied to one another.
SNAPPING_TWINS = '''r"""A page of the tests."""
from spragsym.derive.model import Page
page = Page("Two equal masses that snap, tied to one another.")
m, k, s = page.unit("m", "kg", "mass"), page.unit("k", "N/m", "stiffness"), page.unit("s", "m", "size")
F = page.parameter("F", "N", "load of each", "real", 0.1)
a = page.parameter("a", "1", "stiffness at 0 over k", "real", 0.2)
t = page.parameter("t", "N/m", "tie", "> 0", 0.2)
x, z = page.coordinate("x", "m", "first"), page.coordinate("z", "m", "second")
page.kinetic(m * (page.rate(x)**2 + page.rate(z)**2) / 2)
page.potential(t * (x - z)**2 / 2)
for one in (x, z):
    page.potential(k * (a * one**2 / 2 + one**4 / s**2 / 4) - F * one)
'''


@pytest.mark.thorough
def test_all_cusps_of_twins_beside_a_curve_of_their_pitchforks() -> None:
    """Where both snap as one, F = a = 0; and where they have parted, z = −x, and snap as one from
    there: a + 3 x² = 0 and x² = −a − 2 t.
    """
    t = 0.2
    p = model_of(SNAPPING_TWINS, "snapping_twins").Parameters(t=t)
    found = ss.cusps(p, ("F", "a"), between={"F": (-0.5, 0.5), "a": (-1.0, 0.5)})
    assert found.decided
    apart = np.sqrt(t)
    expected = [(-3 * t, -apart, apart), (-3 * t, apart, -apart), (0.0, 0.0, 0.0)]
    states = np.array([found["a"], found.x, found.z])
    states = states[:, np.lexsort((states[1], np.round(states[0], 9)))].T
    np.testing.assert_allclose(states, expected, rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.F, 0.0, rtol=0, atol=1e-12)
