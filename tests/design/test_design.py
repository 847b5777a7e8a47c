"""Jump values, gradients, margins, certificates, probabilities and designs, each against other
evidence than its own.
"""

import functools
import math
from collections.abc import Callable, Iterable
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.stats import truncnorm

import spragsym as ss
from spragsym.design import sampling
from spragsym.design.design_space import space
from spragsym.design.probability import estimate
from spragsym.kang_nam import jump_values
from spragsym.kang_nam.certificates import CLAIMS, ParameterBoxes
from spragsym.kang_nam.jump_values import limit_point_passed
from spragsym.numerics import bernstein
from spragsym.numerics.affine import Rounded
from tests.oracles import families, reference
from tests.support import box_of, few

BASE = ss.Parameters.article()
NAMES = ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")


def one(p: ss.Parameters, i: int) -> ss.Parameters:
    return ss.Parameters(
        **{name: float(np.broadcast_to(getattr(p, name), p.shape)[i]) for name in NAMES}
    )


# ------------------------------------------------------------------------------------------------
# jump values


@pytest.mark.parametrize(
    ("vary", "direction"),
    [
        ("mu0", "up"),
        ("theta0", "up"),
        *(
            pytest.param(name, way, marks=pytest.mark.thorough)
            for name, way in (
                ("kappa", "down"),
                ("kappa", "up"),
                ("sigma", "up"),
                ("alpha", "down"),
                ("beta", "up"),
            )
        ),
    ],
)
def test_a_jump_value_is_the_first_jump_of_the_path(vary: str, direction: str) -> None:
    p = (
        families.near_folds(np.random.default_rng(6), 150)
        if vary not in ("mu0", "theta0")
        else None
    )
    p = p or families.random(np.random.default_rng(7), 150)
    values = np.asarray(ss.jump_value(p, vary, direction=direction))
    jumping, still = np.flatnonzero(np.isfinite(values)), np.flatnonzero(np.isnan(values))
    assert jumping.size >= 5
    for i in [*jumping[:5], *still[:3]]:
        point, value = one(p, i), values[i]
        start = {"mu0": 0.0, "theta0": 1e-12}.get(vary, float(getattr(point, vary)))
        end = (
            (3.14159 if vary == "theta0" else 1e3 + 2 * start)
            if direction == "up"
            else start * 1e-3
        )
        path = ss.quasi_static_path(point, vary, [start, end])
        first = [jump.value for jump in path.jumps[:1]]
        if np.isnan(value) or not min(start, end) < value < max(start, end):
            assert not first
        else:
            assert value == pytest.approx(first[0], rel=1e-11)


def test_values_on_folds_and_in_symmetric_systems() -> None:
    # μ₀ = α = 0: nothing jumps at a pitchfork.
    assert math.isnan(ss.jump_value(BASE.replace(mu0=0.0, alpha=0.0), "theta0"))
    assert ss.jump_value(BASE.replace(theta0=0.5, alpha=0.0)) == pytest.approx(
        ss.quasi_static_path(BASE.replace(theta0=0.5, alpha=0.0), "mu0", [0.0, 9.0]).jumps[0].value,
        rel=1e-12,
    )
    # Just above the cusp in θ₀ there is no jump, just below there is one, at its friction.
    cusp = ss.cusps(BASE)
    at = int(np.flatnonzero((cusp.mu0 > 0) & (cusp.theta0 > 0))[0])
    beside = ss.jump_value(BASE.replace(theta0=cusp.theta0[at] + np.array([-1e-6, 1e-6])))
    assert beside[0] == pytest.approx(cusp.mu0[at], abs=1e-6)
    assert math.isnan(beside[1])
    # A start exactly on the fold: the state on it jumps where that is passed, and not the other
    # way.
    point = BASE.replace(theta0=0.5, mu0=0.95)
    (kappa,) = ss.folds(point, "kappa").kappa
    assert ss.jump_value(point.replace(kappa=kappa), "kappa") == kappa
    assert math.isnan(ss.jump_value(point.replace(kappa=kappa), "kappa", direction="down"))


@pytest.mark.thorough
def test_exact_arithmetic_gives_the_same_values(monkeypatch: pytest.MonkeyPatch) -> None:
    p = families.random(np.random.default_rng(9), 12)
    for vary in ("mu0", "theta0"):
        quick = ss.jump_value(p, vary)
        slow = [jump_values.exactly(one(p, i), vary)[0] for i in range(12)]
        np.testing.assert_allclose(quick, slow, rtol=1e-12)


# In the wedge of a cusp nearly all points are nearer to a fold than their values are known.
@pytest.mark.parametrize("family", sorted(set(families.FAMILIES) - {"cusp wedge"}))
def test_what_has_jumped_is_what_jumps_below_its_friction(family: str) -> None:
    p = families.FAMILIES[family](np.random.default_rng(40), 40 if "light" in family else 3000)
    found, value = limit_point_passed(p), np.asarray(ss.jump_value(p))
    # A value has 1e-12; nearer than that to the friction the event is the one that knows.
    clear = ~(np.abs(value - p.mu0) <= 1e-12 * np.maximum(1.0, value))
    assert clear.sum() > 10
    assert not np.isnan(found).any()
    np.testing.assert_array_equal(found[clear] == 1, (value <= p.mu0)[clear])


def test_many_inclinations_are_told_from_one_fold() -> None:
    p = families.near_folds(np.random.default_rng(6), 60)
    for i in np.flatnonzero(np.isfinite(ss.jump_value(p, "theta0"))):
        fold = float(ss.jump_value(one(p, int(i)), "theta0"))
        assert limit_point_passed(
            one(p, int(i)).replace(theta0=fold + np.array([1e-3, -1e-12, 1e-12])), "theta0"
        ).tolist() == [1, 0, 1]


@pytest.mark.thorough
def test_beside_a_fold_what_has_jumped_is_what_the_path_says() -> None:
    p = families.near_folds(np.random.default_rng(6), 4000)
    found, value = limit_point_passed(p), np.asarray(ss.jump_value(p))
    close = np.flatnonzero(np.abs(value - p.mu0) <= 1e-13 * value)
    assert close.size > 10
    for i in close[:30]:
        (mu0,), at = one(p, int(i)).scalars("mu0"), float(value[i])
        path = ss.quasi_static_path(one(p, int(i)), "mu0", [0.0, mu0])
        # A value equal to the fold as a float counts as the fold itself, which a path has not
        # passed.
        assert bool(found[i]) == bool(path.jumps) or mu0 == at


def test_signs_between_two_places_are_those_of_the_polynomial() -> None:
    # (t − 1)(t − 2)(t − 4), between places of t.
    coefficients = [Rounded(np.full(6, value)) for value in (-8.0, 14.0, -7.0, 1.0)]
    low, high = np.array([0.1, 0.1, 1.5, 2.1, 2.1, 4.1]), np.array([0.9, 1.5, 1.9, 3.9, 8.0, 9.0])
    place = [t / (t + bernstein.SCALE) for t in (low, high)]
    found = bernstein.signs_between(coefficients, *place, np.zeros(6))
    assert found.at_low.tolist() == [-1, -1, 1, -1, -1, 1]
    assert found.negative.tolist() == [True, False, False, True, False, False]
    assert found.positive.tolist() == [False, True, True, False, True, True]
    # A root within the uncertainty of an end leaves that open.
    near = bernstein.signs_between(
        coefficients, place[0], np.full(6, 1.0 / (1.0 + bernstein.SCALE)), np.full(6, 1e-9)
    )
    assert not near.negative[0]
    assert not near.positive[0]


@pytest.mark.parametrize("vary", few(["mu0", "theta0", "sigma"], "mu0"))
def test_gradients_are_those_of_forty_digits(vary: str) -> None:
    """f = f′ = 0 solved with 50 digits from the forces, at parameters moved by 1e-15 both ways."""
    p = BASE.replace(theta0=0.6, mu0=0.70, beta=0.1)
    direction = "down" if vary == "sigma" else "up"
    found = ss.jump_gradient(p, vary, direction=direction)
    first = jump_values.first_jumps(p, vary, direction)
    theta0, (x, y) = float(first.value) if vary == "theta0" else 0.6, first.state.tolist()
    theta = math.atan2(math.sin(theta0) - y, math.cos(theta0) - x)
    with mpmath.workdps(50):
        given = {name: mpmath.mpf(float(getattr(p, name))) for name in NAMES}

        def at(moved: dict[str, Any]) -> Any:
            def both(angle: Any, value: Any) -> list[Any]:
                along = functools.partial(reference.along, **moved | {vary: value})
                return [along(angle), mpmath.diff(along, angle)]

            return mpmath.findroot(
                both, (mpmath.mpf(theta), mpmath.mpf(float(found.value))), tol=1e-60
            )[1]

        assert abs(at(given) - float(found.value)) < 1e-13
        for name in NAMES:
            step = mpmath.mpf(10) ** -12
            up, down = (at({**given, name: given[name] + side * step}) for side in (1, -1))
            truth = mpmath.mpf(0) if name == vary else (up - down) / (2 * step)
            assert abs(truth - float(getattr(found, name))) <= 1e-10 * (1 + abs(truth)), name


# ------------------------------------------------------------------------------------------------
# certificates


def boxes(
    seed: int, number: int, sizes: tuple[float, ...]
) -> Iterable[tuple[ss.Parameters, ss.Parameters]]:
    p = families.random(np.random.default_rng(seed), number)
    for i in range(number):
        values = {name: float(getattr(p, name)[i]) for name in NAMES}
        off = sizes[i % len(sizes)]
        low, high = (
            {name: value * (1 + side * off) for name, value in values.items()} for side in (-1, 1)
        )
        high["theta0"] = min(high["theta0"], 3.1415)
        yield ss.Parameters(**low), ss.Parameters(**high)


HOLDS: dict[str, Callable[[ss.Parameters], Any]] = {
    "no jump": lambda p: ~(ss.jump_value(p) <= p.mu0),
    "one equilibrium": lambda p: ss.count(p) == 1,
    "no flutter": lambda p: ~(ss.equilibria(p).undamped == ss.EquilibriumType.FLUTTER).any(axis=-1),
}


@pytest.mark.thorough
@pytest.mark.parametrize("claim", few(HOLDS, "no jump", "no flutter"))
def test_what_is_proved_holds_at_random_points_and_what_is_refuted_does_not(claim: str) -> None:
    rng = np.random.default_rng(11)
    seen = set()
    for low, high in boxes(12, 14, (0.01, 0.08)):
        found = ss.certify(low, claim, between=box_of(low, high), max_boxes=400)
        seen.add(found.outcome)
        corners = {name: (float(getattr(low, name)), float(getattr(high, name))) for name in NAMES}
        if found.outcome == "proved":
            inside = {name: rng.uniform(*ends, 2000) for name, ends in corners.items()}
            inside = {
                name: np.concatenate([values, rng.choice(corners[name], 100)])
                for name, values in inside.items()
            }
            assert HOLDS[claim](ss.Parameters(**inside)).all()
            assert found.undecided == 0.0
        elif found.outcome == "refuted":
            point = found.counterexample
            assert point is not None
            assert all(
                ends[0] <= float(getattr(point, name)) <= ends[1] for name, ends in corners.items()
            )
            assert not HOLDS[claim](point)
            if claim == "no jump":
                assert ss.quasi_static_path(point, "mu0", [0.0, float(point.mu0)]).jumps
    assert {"proved", "refuted"} <= seen


@pytest.mark.parametrize("claim", HOLDS)
def test_a_proof_does_not_lean_on_the_search_for_counterexamples(claim: str) -> None:
    """Points at which a claim is false are boxes that its proof alone must refuse."""
    p = families.random(np.random.default_rng(31), 3000)
    wrong = np.flatnonzero(~HOLDS[claim](p))[:20]
    assert wrong.size >= 5
    corner = np.array([getattr(p, name)[wrong] for name in NAMES])
    proved, _ = CLAIMS[claim][0](
        ParameterBoxes(corner, corner, np.zeros(wrong.size, dtype=bool), {})
    )
    assert not proved.any()


@pytest.mark.thorough
def test_a_box_that_touches_the_fold_ends_undecided() -> None:
    low = BASE.replace(theta0=0.5, mu0=0.5)
    (fold,) = (float(value) for value in ss.folds(low, "mu0").mu0)
    found = ss.certify(low, between={"mu0": (0.5, fold)}, max_boxes=60)
    assert found.outcome == "undecided"
    assert found.undecided == 1.0
    assert ss.certify(low, between={"mu0": (0.5, fold * (1 - 1e-9))}).outcome == "proved"
    assert ss.certify(low, between={"mu0": (0.5, fold * (1 + 1e-9))}).outcome == "refuted"
    # With width in θ₀ only the boxes at the fold's side stay open.
    wide = ss.certify(low, between={"theta0": (0.45, 0.5), "mu0": (0.5, fold)}, max_boxes=60)
    assert wide.outcome == "undecided"
    assert 0 < wide.undecided < 0.2


# -------------------------------------------------------------------------------------------
# margins and new designs


def test_the_margin_of_friction_alone_is_the_jump_value() -> None:
    p = BASE.replace(theta0=0.6)
    margin = ss.jump_margin(p, {"mu0": 0.05}, options=ss.MarginOptions(prove=True))
    assert margin.distance == pytest.approx((ss.jump_value(p) - 0.5) / 0.05, rel=1e-9)
    assert 0.5 * margin.distance < margin.proved < margin.distance
    jumped = ss.jump_margin(p.replace(mu0=0.9), {"mu0": 0.05})
    assert jumped.distance == 0.0
    assert ss.jump_margin(BASE.replace(theta0=3.0, mu0=0.1), {"kappa": 1e-6}).parameters is None


def test_no_point_of_the_fold_is_nearer_than_the_margin() -> None:
    p = BASE.replace(theta0=0.7)
    scale = {"theta0": 0.02, "sigma": 0.01}
    margin = ss.jump_margin(p, scale)
    turn = np.linspace(0, 2 * np.pi, 721)[:, None]
    radius = margin.distance * np.array([0.5, 0.9, 0.999, 1.002])
    around = p.replace(
        theta0=0.7 + 0.02 * radius * np.cos(turn), sigma=0.1 + 0.01 * radius * np.sin(turn)
    )
    jumps = ss.jump_value(around) <= 0.5
    assert jumps.any(axis=0).tolist() == [False, False, False, True]
    assert ss.jump_value(margin.parameters) == pytest.approx(0.5, rel=1e-9)
    # Where the gradient of the jump value is, there is the nearest point.
    slopes = ss.jump_gradient(margin.parameters)
    along = np.array([float(slopes.theta0) * 0.02, float(slopes.sigma) * 0.01])
    way = np.array([margin.change["theta0"] / 0.02, margin.change["sigma"] / 0.01])
    assert abs(along @ way) == pytest.approx(np.linalg.norm(along) * np.linalg.norm(way), rel=1e-6)


def test_a_new_design_keeps_the_target_and_a_smaller_change_does_not() -> None:
    p = BASE.replace(theta0=0.7)
    better = ss.redesign(p, "theta0", {"mu0": 0.7})
    angle = brentq(
        lambda value: float(ss.jump_value(p.replace(theta0=value))) - 0.7, 0.5, 0.7, xtol=1e-15
    )
    assert 0.7 + better.change["theta0"] == pytest.approx(angle, rel=1e-9)
    assert not ss.quasi_static_path(better.parameters, "mu0", [0.0, 0.7]).jumps
    half = p.replace(theta0=0.7 + 0.999 * better.change["theta0"])
    assert ss.quasi_static_path(half, "mu0", [0.0, 0.7]).jumps
    both = ss.redesign(p, ("theta0", "sigma"), {"mu0": 0.7})
    assert both.distance < better.distance
    assert both.jump["mu0"] >= 0.7 * (1 - 1e-12)
    assert ss.redesign(p, "sigma", {"mu0": 0.4}).distance == 0.0


# ------------------------------------------------------------------------------------------------
# probability

TOLERANCES: dict[str, Any] = {
    "theta0": (0.68, 0.72),
    "mu0": (0.4, 0.6),
    "kappa": (0.006, 0.008),
    "alpha": 0.007,
    "sigma": (0.085, 0.115),
    "beta": 0.0,
}


def estimated(
    function: sampling.Function, variables: int, n: int, seed: int, indices: bool
) -> ss.results.JumpProbability:
    tasks = sampling.chunks(n, np.random.default_rng(seed).integers(0, 2**62, 16).tolist())
    records = sampling.sums(function, [(j,) for j in range(variables)], indices, tasks)
    return estimate(
        records,
        [task.replicate for task in tasks],
        0.95,
        [str(j) for j in range(variables * indices)],
    )


def test_chunks_that_are_asked_together_have_their_own_sums() -> None:
    tasks = sampling.chunks(1 << 15, [5, 6])

    def function(points: np.ndarray) -> np.ndarray:
        return np.where(points[:, 1] < 0.01, np.nan, np.floor(points.sum(axis=1)))

    def asked(*some: sampling.Chunk) -> list[list[float]]:
        return sampling.sums(function, [(0,), (1, 2)], True, some)

    assert len(tasks) == 8
    assert asked(*tasks) == [asked(task)[0] for task in tasks]


def test_indices_of_a_linear_model_are_its_squares() -> None:
    weights = np.array([1.0, 2.0, 3.0, 0.5])
    found = estimated(lambda u: (u @ weights + 7.0) / 14.0, 4, 8192, 1, True)
    share = weights**2 / (weights @ weights)
    np.testing.assert_allclose([*found.first.values()], share, atol=2e-3)
    np.testing.assert_allclose([*found.total.values()], share, atol=2e-3)
    assert 14 * found.probability == pytest.approx(7 + weights.sum() / 2, rel=1e-5)


@pytest.mark.parametrize("share", few([0.3, 0.002]))
def test_intervals_hold_the_truth_as_often_as_they_say(share: float) -> None:
    """100 studies of x₁ + x₂ < s, whose probability is s²/2: a fair interval holds it 88 to 100
    times, in 999 of 1000.
    """
    limit = math.sqrt(2 * share)
    studies = [
        estimated(lambda u: (u.sum(axis=-1) < limit).astype(float), 2, 1024, seed, False)
        for seed in range(100)
    ]
    assert 88 <= sum(study.low <= share <= study.high for study in studies) <= 100
    assert np.median([study.high - study.low for study in studies]) < 6 * math.sqrt(share / 1024)
    # Where the function has no value it may be 1, and all of them are no more than all.
    assert (
        estimated(lambda u: np.where(u[..., 0] < share, math.nan, 1.0), 2, 1024, 1, False).high
        == 1.0
    )


@pytest.mark.parametrize("name", ["m", "k", "k_c", "L_0"])
def test_a_design_at_a_limit_is_allowed(name: str) -> None:
    """Where the range has no least number."""
    values = dict(
        m=0.35, k=180e3, k_x=9e3, k_y=0.0, k_c=1.5e6, F_L=420.0, L_0=0.038, theta0=0.9, mu0=0.3
    )
    designs = space(ss.PhysicalParameters(**values), [name], "change")
    assert 0 < getattr(designs.made(designs.limits()[0]), name) < 1e-6 * values[name]


# ------------------------------------------------------------------------------------------------
# what varies together


@pytest.mark.thorough
def test_a_probability_with_correlated_normals_is_that_of_plain_samples() -> None:
    names, mean, sd = (
        ("sigma", "alpha", "mu0"),
        np.array([0.1, 0.02, 0.55]),
        np.array([0.01, 0.003, 0.04]),
    )
    law: dict[str, Any] = {
        name: truncnorm(-6, 6, *each) for name, *each in zip(names, mean, sd, strict=True)
    }
    law |= {"kappa": 0.007, "beta": 0.0, "theta0": 0.7}
    correlation = {("sigma", "alpha"): 0.95, ("mu0", "sigma"): -0.4, ("alpha", "mu0"): -0.4}
    found = ss.jump_probability(law, correlation=correlation, n=1 << 13, rng=1)
    matrix = np.array([[1, 0.95, -0.4], [0.95, 1, -0.4], [-0.4, -0.4, 1]])
    sample = np.random.default_rng(2).multivariate_normal(
        mean, matrix * np.outer(sd, sd), 100_000, check_valid="raise"
    )
    p = ss.Parameters(
        **{"kappa": 0.007, "beta": 0.0, "theta0": 0.7} | dict(zip(names, sample.T, strict=True))
    )
    plain = float((np.asarray(ss.jump_value(p)) <= p.mu0).mean())
    off = 3 * math.sqrt(plain * (1 - plain) / 1e5)
    assert found.low - off < plain < found.high + off
    independent = ss.jump_probability(law, n=1 << 13, rng=1)
    assert independent.low > found.high or independent.high < found.low
    # All three hang together: one group, which decides all.
    assert [set(title.split(", ")) for title in found.total] == [{"sigma", "alpha", "mu0"}]
    assert next(iter(found.total.values())) == pytest.approx(1.0, abs=0.05)


# ------------------------------------------------------------------------------------------------
# mistakes

AT, LATER = BASE.replace(theta0=0.7), BASE.replace(theta0=1.2)
#: A question that makes no sense, and what its error names.
MISTAKES: list[tuple[Callable[[], Any], str]] = [
    (lambda: ss.jump_value(BASE, "V"), "theta0"),
    (lambda: ss.jump_value(BASE), "theta0"),
    (lambda: ss.jump_value(AT, direction="down"), "direction = 'down'"),
    (lambda: ss.jump_value(AT, "kappa", direction="left"), "direction = 'left'"),
    (lambda: ss.certify(LATER, "no sprag"), "'no sprag'.*no flutter"),
    (lambda: ss.certify(LATER, between={"mu0": (0.5, 0.1)}), r"between\['mu0'\] = \(0\.5, 0\.1\)"),
    (lambda: ss.certify(LATER.replace(mu0=[0.6, 0.7])), "low"),
    (lambda: ss.jump_margin(AT, {}), "scale"),
    (lambda: ss.jump_margin(AT, {"k_x": 1.0}), "'k_x' in scale"),
    (lambda: ss.jump_margin(AT, {"mu0": -1.0}), r"scale\['mu0'\] = -1"),
    (lambda: ss.redesign(AT, "beta", {"mu0": 0.7}), "beta = 0.*change="),
    (lambda: ss.redesign(AT, "sigma", {"sigma": 0.7}), "sigma is the target"),
    (lambda: ss.redesign(AT, "theta0", {"theta0": 0.7}), "theta0 is the target"),
    (lambda: ss.redesign(AT, "sigma", {}), r"target = \{\}"),
    (lambda: ss.redesign(AT, {"sigma": -0.01}, {"mu0": 0.7}), r"change\['sigma'\] = -0\.01"),
    (lambda: ss.jump_probability({}), "distribution.*theta0"),
    (lambda: ss.jump_probability(TOLERANCES | {"U": 1.0}), "'U' in distribution"),
    (lambda: ss.jump_probability(TOLERANCES | {"mu0": (0.6, 0.4)}), r"mu0 = \(0\.6, 0\.4\)"),
    (lambda: ss.jump_probability(TOLERANCES | {"mu0": (-0.1, 0.4)}), r"mu0\[0\] = -0\.1"),
    (lambda: ss.jump_probability(TOLERANCES | {"mu0": (0.1, 0.2, 0.3)}), "mu0 has 3 numbers"),
    (lambda: ss.jump_probability(dict.fromkeys(NAMES, 0.5)), "no quantity of distribution varies"),
    (lambda: ss.jump_probability((BASE, None)), "distribution"),
    (lambda: ss.jump_probability(TOLERANCES, n=1), "n = 1"),
    (lambda: ss.jump_probability(TOLERANCES, confidence=1.0), r"confidence = 1\.0"),
    (lambda: ss.jump_probability(TOLERANCES, replicates=1), "replicates = 1"),
    (lambda: ss.jump_probability(TOLERANCES, n=16, rng=-1), "rng = -1"),
    (lambda: with_correlation({("sigma", "beta"): 0.5}), "beta.*two of the quantities that vary"),
    (lambda: with_correlation({("sigma", "mu0"): 1.5}), "is not in"),
    (lambda: with_correlation({("sigma", "mu0"): -1.5}), "is not in"),
    (lambda: with_correlation({("sigma", "mu0"): 0.5, ("mu0", "sigma"): 0.5}), "twice"),
    (
        lambda: with_correlation(
            {("sigma", "mu0"): 0.9, ("mu0", "kappa"): 0.9, ("sigma", "kappa"): -0.9}
        ),
        "all be true at once",
    ),
]


def with_correlation(correlation: Any) -> Any:
    return ss.jump_probability(TOLERANCES, correlation=correlation, n=16, rng=0)


@pytest.mark.parametrize("number", range(len(MISTAKES)))
def test_a_mistake_is_named(number: int) -> None:
    call, named = MISTAKES[number]
    with pytest.raises(ss.errors.ParameterError, match=named):
        call()


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"n": None}, "n = None"),
        ({"n": 2**50}, r"n = 1125899906842624 is not an integer in \[2, "),
        ({"replicates": 10**9}, "replicates = 1000000000 is not an integer"),
        ({"rng": "x"}, "rng = 'x' is no seed"),
        ({"begin": "x"}, "begin = 'x'"),
        ({"sobol": "yes"}, "sobol = 'yes' is neither True nor False"),
        ({"confidence": [0.5, 0.9]}, "confidence has the shape"),
    ],
)
def test_samples_are_a_number_and_a_seed(given: Any, words: str) -> None:
    p = ss.Parameters.article(theta0=0.5)
    with pytest.raises(ss.errors.SpragsymError, match=words):
        ss.jump_probability((p, p.replace(mu0=0.9)), **given)
