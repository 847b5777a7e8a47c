"""The state that is followed unless told otherwise: the stable one of least strain energy."""

import math
import pickle

import numpy as np
import pytest

import spragsym as ss
from spragsym.numerics.certified_roots import in_order
from spragsym.numerics.interval_arrays import Intervals, ends_around
from spragsym.statics.balance import Balance
from spragsym.statics.reference_state import is_reference, reference_state
from spragsym.statics.search import columns


def strained(angle: float, phi: float, p: object) -> float:
    """Strain energy of the rod by hand: torsion spring k_t, at rest at phi = theta0 − psi, and
    linear contact.
    """
    depth = max(0.0, math.cos(phi) - math.cos(angle))
    return 0.5 * float(p.kappa) * (phi - angle + float(p.psi)) ** 2 + 0.5 * depth**2  # type: ignore[attr-defined]


@pytest.mark.parametrize("angle", [20.0, 30.0, 45.0])
def test_the_rod_is_followed_from_the_state_whose_spring_is_turned_least(angle: float) -> None:
    """Not from the flipped one, whose coordinate is smaller."""
    model = ss.load("sprag_rod")
    theta0 = math.radians(angle)
    p = model.Parameters(theta0=theta0, mu0=0.0)
    eq = ss.equilibria(p)
    stable = [
        float(phi)
        for phi, kind in zip(eq.phi, eq.undamped, strict=True)
        if kind == ss.EquilibriumType.STABLE
    ]
    least = min(stable, key=lambda phi: strained(theta0, phi, p))
    assert least > 0 > min(stable, key=abs)
    path = ss.quasi_static_path(p, "mu0", [0.0])
    assert path.phi[0] == pytest.approx(least, abs=1e-12)


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_of_the_article_it_is_the_state_of_smallest_displacement(friction: float) -> None:
    """Also without a spring along the belt, where a spring that has flipped over is strained
    less.
    """
    rng = np.random.default_rng(7)
    size = 400
    given = {
        "theta0": rng.uniform(0.01, 3.13, size),
        "kappa": 10 ** rng.uniform(-4, 0.5, size),
        "alpha": rng.choice([0.0, 0.01], size),
        "sigma": 10 ** rng.uniform(-3, 1, size),
        "beta": 10 ** rng.uniform(-4, 1, size),
    }
    p = ss.Parameters(mu0=friction, **given)
    eq = ss.equilibria(p)
    slot = reference_state(eq)
    stable = eq.undamped == ss.EquilibriumType.STABLE
    several = stable.sum(axis=1) > 1
    smallest = np.where(stable, np.abs(eq.x), np.inf).argmin(axis=1)
    assert several.sum() > 50
    assert (slot == smallest)[several].all()


@pytest.mark.thorough
def test_another_state_is_followed_where_it_is_chosen() -> None:
    """By paths, jump values and certificates, closed forms or not: none of them tells what is true
    of the reference state.
    """
    rod = ss.load("sprag_rod").Parameters(theta0=0.6, mu0=0.7)
    other = rod.following(phi=-0.5)
    (fold,) = ss.folds(rod, "mu0", between={"mu0": (0.0, 2.0)}).mu0
    assert ss.jump_value(rod, "mu0", until=2.0) == pytest.approx(fold, abs=1e-12)
    assert np.isnan(ss.jump_value(other, "mu0", until=2.0))
    assert ss.certify(rod).outcome == "refuted"
    assert ss.certify(other).outcome == "proved"
    article = ss.Parameters.article(theta0=0.5, mu0=0.6)
    far = article.following(x=1.8)
    assert ss.quasi_static_path(far, "mu0", [0.0, 0.3]).x[0] == pytest.approx(
        ss.equilibria(article.replace(mu0=0.0)).x[2]
    )
    assert pickle.loads(pickle.dumps(far)) == far  # noqa: S301  # written here
    assert far != article


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["kang_nam", "two_springs", "hertz_contact"])
def test_what_is_proved_to_be_the_reference_state_is_the_one_chosen_of_all(name: str) -> None:
    rng, count, model = np.random.default_rng(80), 3000, ss.load(name).search
    theta0, mu0 = rng.uniform(0.1, 3.0, count), rng.uniform(0.0, 4.0, count)
    theta0[::5], mu0[::2] = np.pi / 2, 0.0  # of mirror images none is
    ends = {"kappa": (-3, 0), "sigma": (-2, 0), "alpha": (-3, 0)}
    others = {key: 10 ** rng.uniform(*span, count) for key, span in ends.items()}
    p = model.Parameters(theta0=theta0, mu0=mu0, **others)
    eq, balance = ss.equilibria(p), Balance(model)
    point, slot = eq.states
    q = np.array([eq[key][point, slot] for key in balance.coordinates])
    bounds = Intervals.point(columns(p, balance.parameters)[:, point])
    region = (eq["region"][point] * np.array([-1.0, 1.0])).T
    found = is_reference(balance, bounds, ends_around(q, np.full(q.shape, 1e-9)), region)
    assert 0.4 < found.sum() / count
    assert not (found & (reference_state(eq)[point] != slot)).any()


def test_states_at_infinity_have_their_places() -> None:
    rows = np.array([[np.inf, 1.0, -np.inf, 2.0, -np.inf], [0.0, 5.0, 1.0, 0.0, 0.0]])
    places = in_order(rows, np.full(5, 1e-15), np.zeros(5, dtype=np.intp))
    assert places.tolist() == [4, 2, 1, 3, 0]
