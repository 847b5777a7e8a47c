"""Equilibria, folds, cusps and onsets of flutter of models from pages: against closed forms and
polynomials in many digits.
"""

import functools

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation import points, singularities
from spragsym.bifurcation.defining_systems import Family, cusp
from spragsym.statics.balance import Balance
from tests.oracles import by_hand, families
from tests.oracles.forces_by_hand import DRAWN
from tests.oracles.user_pages import model_of, shipped_page
from tests.support import few

STATES = ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")


@functools.cache
def model(name):
    return ss.load(name).search


def same_parameters(name, p, **more):
    """The article's parameters as those of a model that has them all."""
    return model(name).Parameters(**{key: getattr(p, key) for key in STATES}, **more)


def padded(values, slots, empty=np.nan):
    out = np.full((*values.shape[:-1], slots), empty)
    out[..., : values.shape[-1]] = values
    return out


@pytest.mark.parametrize(
    "family",
    few(
        ("random", "ends", "right_angle", "frictionless", "false_double_root", "equal_stiffness"),
        "right_angle",
    ),
)
def test_the_articles_model_through_the_general_way(family):
    p = getattr(families, family)(np.random.default_rng(1), 60)
    eq, known = ss.equilibria(same_parameters("kang_nam", p)), ss.equilibria(p)
    settled = eq.decided & known.decided
    assert settled.sum() >= 58
    assert (eq.count == known.count)[settled].all()
    order = np.argsort(known.x, axis=-1)
    for name in ("x", "y"):
        want = np.take_along_axis(getattr(known, name), order, axis=-1)
        got = padded(getattr(eq, name), 3)
        assert np.nanmax(np.abs(got - want)[settled] / np.maximum(1, np.abs(want[settled]))) < 2e-12
    assert np.nanmax(eq.error) <= 1e-12
    assert eq.whole.all()


#: States of models that have what the article has not at 0: a model, the article's parameters,
#: those of its own, in contact.
DEGREES = np.radians(np.linspace(5, 175, 20))
FOLD = float(ss.folds(ss.Parameters.article()).theta0[0])
ALIKE = [
    ("kang_nam", {"theta0": DEGREES}, {}, True),
    ("kang_nam", {"theta0": DEGREES, "alpha": 0.7, "mu0": 0.9}, {}, True),
    ("two_springs", {"theta0": DEGREES}, {"sigma_2": 0.0}, True),
    ("cubic_contact", {"theta0": DEGREES}, {"gamma": 0.0}, True),
    ("inclined_belt", {"theta0": DEGREES}, {"gamma_g": 0.0}, True),
    ("damped", {"theta0": DEGREES}, {"zeta_x": 0.0, "zeta_y": 0.0, "zeta_s": 0.0}, True),
    ("kang_nam", {"theta0": np.radians([20.0, 90.0, 160.0]), "kappa": 1e-4}, {}, False),
    ("hertz_contact", {"theta0": 0.8, "alpha": 0.0}, {}, False),
    *(
        ("kang_nam", {"theta0": FOLD * np.array([1 - off, 1 + off])}, {}, True)
        for off in (1e-6, 1e-10, 1e-14)
    ),
]


@pytest.mark.parametrize(("name", "given", "more", "contact"), ALIKE)
def test_states_are_those_of_the_closed_forms(name, given, more, contact):
    p = ss.Parameters.article(**given)
    eq, known = (
        ss.equilibria(same_parameters(name, p, **more), contact=contact),
        ss.equilibria(p, contact=contact),
    )
    assert eq.complete
    assert eq.whole.all()
    assert (eq.count == known.count).all()
    slots = known.x.shape[-1]
    order = np.argsort(known.x, axis=-1)
    assert np.allclose(
        padded(eq.x, slots), np.take_along_axis(known.x, order, axis=-1), atol=1e-12, equal_nan=True
    )
    assert np.nanmax(eq.error) <= 1e-12
    if name == "hertz_contact":  # K in contact is not the article's
        return
    assert (
        padded(eq.undamped, slots, 0) == np.take_along_axis(known.undamped, order, axis=-1)
    ).all()
    if name == "kang_nam":
        got, want = (
            np.sort_complex(np.nan_to_num(one.eigenvalues.reshape(-1)).round(9))
            for one in (eq, known)
        )
        assert np.allclose(got[got != 0], want[want != 0], atol=1e-8)
        assert "alpha" not in given or (known.undamped == ss.EquilibriumType.FLUTTER).any()


# ------------------------------------------------------------------------------------------------
# other pages, by other formulations


@pytest.mark.thorough
@pytest.mark.parametrize(
    "name", ["cubic_contact", "hertz_contact", "inclined_belt", "trolley", "two_springs"]
)
def test_pages_against_forces_by_hand_in_40_digits(name):
    for changes in ({"theta0": 0.6}, {"theta0": 1.3, "mu0": 0.22, "beta": 0.1}):
        outcome = by_hand.equilibria(
            model(name), DRAWN[name], model(name).base | changes, True, np.random.default_rng(1)
        )
        assert (outcome["wrong"], outcome["undecided"]) == ([], 0)


def test_linear_models_in_closed_form():
    p = model("mode_coupling").Parameters()
    eq = ss.equilibria(p)
    alpha, sigma, beta, mu = (float(getattr(p, key)) for key in ("alpha", "sigma", "beta", "mu0"))
    K = np.array([[alpha + sigma / 2, mu - sigma / 2], [-sigma / 2, beta + sigma / 2 + 1]])
    x, y = np.linalg.solve(K, [0, -1])
    assert np.allclose([eq.x[0], eq.y[0]], [x, y], atol=1e-14)
    # (K11 − K22)² + 4 K12 K21 = 0 in mu: linear.
    onset = ss.flutter_onsets(p, "mu0", damping=False)
    assert onset.decided
    assert np.allclose(onset.mu0, sigma / 2 + (K[0, 0] - K[1, 1]) ** 2 / (2 * sigma), atol=1e-12)
    assert onset.kind.tolist() == ["flutter"]


# ------------------------------------------------------------------------------------------------
# folds, cusps, flutter


@pytest.mark.parametrize(
    ("ask", "vary", "fixed", "options"),
    [
        ("folds", "theta0", {"mu0": 0.5}, {}),
        ("folds", "mu0", {"theta0": 1.0472}, {}),
        ("folds", "kappa", {"theta0": 1.0}, {}),
        pytest.param(
            "folds", "theta0", {"mu0": 1e-7, "alpha": 0.0}, {}, marks=pytest.mark.thorough
        ),  # its pitchforks are folds
        ("flutter_onsets", "theta0", {"alpha": 0.7}, {"damping": False}),
        pytest.param(
            "cusps",
            ("theta0", "mu0"),
            {},
            {"between": {"mu0": (0.0, 2.0)}},
            marks=pytest.mark.thorough,
        ),
    ],
)
def test_points_are_those_of_the_closed_forms(ask, vary, fixed, options):
    p, names = ss.Parameters.article(**fixed), [vary] if isinstance(vary, str) else [*vary]
    known = ss.cusps(p) if ask == "cusps" else getattr(ss, ask)(p, vary, **options)
    found = getattr(ss, ask)(
        model("kang_nam").Parameters(**{"theta0": 1.0} | fixed), vary, **options
    )
    wanted = np.logical_and.reduce(
        [(getattr(known, name) > 0) & (getattr(known, name) < 10) for name in names]
    )
    assert found.decided
    assert found.whole
    for name in (*names, "x", "y"):
        assert np.allclose(
            getattr(found, name), getattr(known, name)[wanted], atol=2e-12, rtol=1e-12
        )
    assert set(found.kind) == {{"folds": "fold", "flutter_onsets": "flutter", "cusps": "cusp"}[ask]}
    assert found.error.max() < 1e-12


@pytest.mark.thorough
def test_cusps_of_a_law_whose_stiffness_has_no_slope_at_the_border():
    p = model("hertz_contact").Parameters(theta0=1.0)
    found = ss.cusps(p, ("theta0", "mu0"), between={"mu0": (0.2, 0.4)})
    assert found.complete
    assert len(found) == 1
    # The wedge between two folds opens to one side of it.
    sides = [p.replace(theta0=found.theta0[0] + off) for off in (-2e-2, 2e-2)]
    counts = [len(ss.folds(side, "mu0", between={"mu0": (0.2, 0.3)})) for side in sides]
    assert counts == [2, 0]


@pytest.mark.thorough
def test_a_root_where_the_column_in_use_vanishes_is_no_cusp():
    family = Family.of(
        model("kang_nam").Parameters(),
        ("theta0", "mu0"),
        {"theta0": (0.0, np.pi), "mu0": (0.0, 2.0)},
    )
    found = points.search(family, cusp(column=1))
    assert found.roots.point.size == 2
    cusps = singularities.told_apart(family, found, column=1)
    assert np.allclose(cusps.middle[-1], 0.200931781805090, atol=1e-12)
    assert cusps.point.size
    assert not cusps.undecided_point.size


def test_hopf_points_with_dampers_are_where_a_pair_crosses():
    p = model("damped").Parameters(theta0=np.radians(60))
    found = ss.flutter_onsets(p, "mu0")
    assert found.decided
    assert found.kind.tolist() == ["hopf"]
    sides = ss.equilibria(p.replace(mu0=found.mu0[0] * np.array([1 - 1e-6, 1 + 1e-6])))
    slots = np.abs(sides.x - found.x[0]).argmin(axis=-1)
    growth = sides.growth[[0, 1], slots]
    assert growth[0] * growth[1] < 0
    assert np.abs(growth).max() < 1e-5


@pytest.mark.by_hand("two_springs", "trolley", "kang_nam")
@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "more", "to"),  # each takes seconds, and the first lies before 1.5
    [
        ("kang_nam", {}, np.pi),
        ("inclined_belt", {"gamma_g": 0.0}, 1.5),
        ("trolley", {}, 1.5),
        ("two_springs", {"sigma_2": 0.0}, 1.5),
    ],
)
def test_pitchforks_of_a_mirrored_model_are_the_articles(name, more, to):
    known = ss.folds(ss.Parameters.article(mu0=0.0, alpha=0.0))
    assert known.kind.tolist() == ["pitchfork"] * 2
    wanted = known.theta0 < to
    p = model(name).Parameters(theta0=1.0, mu0=0.0, alpha=0.0, **more)
    found = ss.folds(p, "theta0", between={"theta0": (0.0, to)})
    assert found.complete
    assert found.kind.tolist() == ["pitchfork"] * wanted.sum()
    for column in ("theta0", "x", "y"):
        assert np.allclose(getattr(found, column), getattr(known, column)[wanted], atol=1e-12)
    assert found.error.max() < 1e-12


def forces_without_friction(name, p, q):
    """Forces and the image of the state, by the generated functions alone."""
    values = dict(
        zip(
            Balance(model(name), contact=True).codes,
            model(name).arguments(p, "motion"),
            strict=True,
        )
    )
    statics, given = (
        model(name).algebra,
        [values[part] for part in model(name).about["arguments"]["statics"]],
    )
    directions = []
    for dx, dy, _ in statics.geometry(*q, *given):
        directions += [dx / np.hypot(dx, dy), dy / np.hypot(dx, dy), np.hypot(dx, dy)]
    return np.array(statics.forces(*q, *directions, *given, 0.0, 1)), statics.mirror(*q, *given)


@pytest.mark.parametrize(
    "name", ["kang_nam", "trolley", "hertz_contact", "inclined_belt", "two_springs"]
)
def test_the_mirror_turns_the_forces(name):
    about = model(name).about["mirror"]
    signs = np.array([-1 if part in about["turned"] else 1 for part in model(name).coordinates])
    q = np.random.default_rng(3).uniform(-0.4, -0.1, signs.size)
    for zero in about["zero"]:
        p = model(name).Parameters(
            theta0=0.9, **dict.fromkeys((part for part in zero if part != "mu"), 0.0)
        )
        here, image = forces_without_friction(name, p, q)
        there, _ = forces_without_friction(name, p, image)
        assert np.allclose(there, signs * here, atol=1e-14)
        assert not np.allclose(there, here, atol=1e-3)


def growth_beside(name, p, vary, found, row, off=1e-5):
    """Growth of the state at an onset, a little before and behind it."""
    value = getattr(found, vary)[row]
    sides = ss.equilibria(p.replace(**{vary: value * np.array([1 - off, 1 + off])}))
    assert sides.complete
    slots = np.abs(sides.x - found.x[row]).argmin(axis=-1)
    return sides.growth[[0, 1], slots]


@pytest.mark.parametrize(
    ("name", "vary", "number"),
    [
        ("kang_nam", "mu0", 3),
        ("kang_nam", "kappa", 0),
        ("kang_nam", "d", 0),
        pytest.param("two_springs", "theta0", 3, marks=pytest.mark.thorough),
        ("stribeck", "theta0", 0),
        pytest.param("trolley", "mu0", 7, marks=pytest.mark.thorough),
    ],
)
def test_hopf_points_where_the_slope_of_friction_is_all_that_damps(name, vary, number):
    # At mu0 = 0, kappa = 0, d = 0 there is no damping at all, and Hurwitz's determinant vanishes
    # for all states.
    more = {"mu_s": 0.0, "mu_k": 0.0} if name == "stribeck" else {"d": 1.0} if vary != "d" else {}
    p = model(name).Parameters(theta0=0.8, **more)
    found = ss.flutter_onsets(p, vary)
    assert found.decided
    assert len(found) == number
    crossed = [
        growth_beside(name, p, vary, found, row)
        for row in range(number)
        if getattr(found, vary)[row] > 1e-3
    ]
    # One of the pairs crosses; where another grows already, the largest growth says nothing.
    assert number == 0 or any(before * behind < 0 for before, behind in crossed)


def test_a_range_that_ends_where_a_parameter_divides():
    found = ss.folds(model("stribeck").Parameters(theta0=0.8), "v_s")
    assert found.decided
    assert len(found) == 1


# ------------------------------------------------------------------------------------------------
# the plane, and paths in it


def same_path(vary, values, start, **changes):
    """A path through the general way and the article's."""
    known = ss.quasi_static_path(ss.Parameters.article(**changes), vary, values, start=start)
    p = model("kang_nam").Parameters(**{"theta0": 1.0, **changes})
    found = ss.quasi_static_path(p, vary, values, start=start)
    assert np.allclose(found.x, known.x, atol=1e-9)
    assert (found.undamped == known.undamped).all()
    assert np.allclose(
        [jump.value for jump in found.jumps], [jump.value for jump in known.jumps], atol=1e-12
    )
    return found


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("mu0", "start", "beside"),
    [
        (0.7, "small", (-0.5, 0.0, 0.4)),
        (0.7, "large", (-0.1, -1e-10, 1e-10)),
        (0.0, "small", (-1e-9, 0.0, 1e-9)),
        (0.0, "small", (1e-9, 0.0, -1e-9)),
    ],
)
def test_a_value_on_a_fold_is_the_fold_not_passed_yet(mu0, start, beside):
    # The state that arrives at the fold is the one in which two have met; the jump comes beyond it.
    # The search finds the closed form's value within its error only, and takes it for the fold all
    # the same. At a pitchfork nothing jumps.
    changes = {"mu0": mu0, "alpha": 0.007 if mu0 else 0.0}
    fold = ss.folds(ss.Parameters.article(theta0=1.0, **changes), vary="theta0").theta0[0]
    jumps = same_path("theta0", [fold + off for off in beside], start, **changes).jumps
    assert mu0 or not jumps


def test_masses_that_parameters_make_negative_are_refused():
    """Of (2 − mu_s) x'²/2: a mass of 0 at mu_s = 2."""
    pytest.importorskip("sympy")
    energy = ("m * page.rate(x) ** 2 / 2", "m * (2 - mu_s) * page.rate(x) ** 2 / 2")
    p = model_of(shipped_page("stick_slip", energy), "light").Parameters(mu_s=1.9)
    assert ss.equilibria(p).count == 1
    for friction in (2.0, 3.0, [0.1, 3.0]):
        with pytest.raises(ss.errors.ParameterError, match=r"kinetic energy .* at mu_s = [23],"):
            ss.equilibria(p.replace(mu_s=friction))
    for answer in (ss.simulate, ss.fate):
        with pytest.raises(ss.errors.ParameterError, match=r"kinetic energy .* mu_s = 3"):
            answer(p.replace(mu_s=3.0), t_end=1.0)
    sweep = ss.rms_sweep(p.replace(mu_s=[1.9, 3.0]), t_end=10.0)
    assert np.isnan(sweep["rms"]).tolist() == [False, True]
    assert "kinetic energy" in sweep.reason[1]
