"""Stability of the article's states with the damping of its friction law: the theorem against
eigenvalues and fifty digits, Hopf points in closed form against the search, certificates against
points.

Every third case is 1000 random points with three dampings; two frictions; or a box, of the
article's model or of another page. It guards the claim that a state is stable exactly if det K > 0
and K₁₂ K₂₁ > 0, whatever V and d.
"""

from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles.damped_states import eigenvalues, linearizations, signs
from tests.oracles.families import random_fixed, random_fluttering

CASES = 300
#: Of the scale of the λ: growth below it is not told by floats.
ROUNDING = 1e-11
#: Pages beside the article's, with what they lack.
PAGES: dict[str, dict[str, float]] = {
    "two_springs": {"theta0": 1.0, "mu0": 0.3},
    "damped": {"theta0": 1.0, "mu0": 0.05},
    "stick_slip": {"V": 2.0},
    "mode_coupling": {"mu0": 0.05},
}


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One case."""
    return (states, frictions, boxes)[number % 3](number, rng)


def states(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """The sign of the growth of every state, by floats where they tell it, by the theorem from
    matrices in floats, and by fifty digits.
    """
    n, wrong, seen, told, open_ = 1000, list[str](), 0, 0, 0
    p = ss.Parameters(
        theta0=np.pi * rng.uniform(1e-6, 1 - 1e-6, n),
        mu0=10 ** rng.uniform(-2, 0.7, n),
        kappa=10 ** rng.uniform(-3, -0.3, n),
        alpha=10 ** rng.uniform(-3, 0.3, n),
        sigma=10 ** rng.uniform(-2, 0.5, n),
        beta=rng.choice([0.0, 0.4, 1.5], n),
        V=10 ** rng.uniform(-1, 0.5, n),
    )
    for steepness in (0.3, 5.0, 60.0):
        q = p.replace(d=steepness)
        eq = ss.equilibria(q)
        rows = eq.states
        given = {
            name: np.broadcast_to(q[name], p.shape)[rows[0]]
            for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta", "V", "d")
        }
        x, y, sign = eq.x[rows], eq.y[rows], eq["growth_sign"][rows]
        every = eigenvalues(*linearizations(x, y, given))
        growth = every.real.max(axis=-1)
        clear = np.abs(growth) > ROUNDING * np.abs(every).max(axis=-1)
        by_digits = signs(x, y, given)
        others = {
            "eigenvalues": clear & (np.sign(growth) != sign),
            "the theorem": np.where(theorem(*linearizations(x, y, given)), -1, 1) != sign,
            "fifty digits": by_digits != sign,
        }
        seen, told = seen + sign.size, told + int(clear.sum())
        open_ += int((by_digits == 0).sum())
        for name, other in others.items():
            wrong += [f"d = {steepness}: {int(other.sum())} signs differ by {name}"] * bool(
                other.any()
            )
    return {
        "kind": "states",
        "wrong": wrong,
        "states": seen,
        "told by floats": told,
        "not told by digits": open_,
    }


def theorem(K: Any, _: Any) -> Any:
    """Whether det K > 0 and K₁₂ K₂₁ > 0."""
    return (np.linalg.det(K) > 0) & (K[:, 0, 1] * K[:, 1, 0] > 0)


def frictions(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Hopf points along θ₀ at two frictions, by closed form and by search, and how many λ grow on
    either side.
    """
    wrong, worst, found, told_by_both = list[str](), 0.0, 0, 0
    for _ in range(2):
        p = random_fluttering(rng) if rng.random() < 0.5 else random_fixed(rng)
        p = p.replace(mu0=float(10 ** rng.uniform(-2, 0.7)), V=0.5, d=float(rng.uniform(0.5, 20)))
        ours, searched = ss.flutter_onsets(p), ss.flutter_onsets(p, method="search")
        span = searched.region[-1]
        inside = (ours.theta0 > span[0]) & (ours.theta0 < span[1])
        if not searched.complete or int(inside.sum()) != len(searched):
            wrong += [f"{p!r}: {ours.theta0} for {searched.theta0}"] * searched.complete
            continue
        order, other = np.flatnonzero(inside), np.argsort(searched.theta0)
        found += len(other)
        for name in ("theta0", "x", "y", "omega"):
            gap = np.abs(ours[name][order] - searched[name][other]).max(initial=0.0)
            worst = max(worst, float(gap))
        for name in ("unstable_before", "unstable_after"):
            told, seen = ours[name][order], searched[name][other]
            wrong += [f"{p!r}: {name} {told}, by search {seen}"] * bool(
                ((told != seen) & (seen >= 0)).any()
            )
            told_by_both += int((seen >= 0).sum())
    wrong += [f"{worst:.2g} off"] * (worst > 1e-12)
    numbers = {"points": found, "numbers": told_by_both, "off": worst}
    return {"kind": "frictions", "wrong": wrong, **numbers}


def boxes(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """A certificate of "stable": what is proved at 10⁴ points of the box, what is refuted at the
    point that it names.
    """
    name = "kang_nam" if number % 9 < 6 else list(PAGES)[number // 9 % len(PAGES)]
    if name == "kang_nam":
        fixed = random_fixed(rng)
        p = fixed.replace(
            theta0=float(rng.uniform(0.1, 3.0)), mu0=float(10 ** rng.uniform(-2, 0)), V=0.5, d=5.0
        )
    else:
        p = ss.load(name).Parameters(**PAGES[name])
    sides = [one for one in p.ranges if p[one] is not None and float(p[one]) > 0]
    between = {
        side: (float(p[side]), float(p[side]) * (1 + 10 ** rng.uniform(-4, -1.4)))
        for side in rng.choice(sides, 2, replace=False).tolist()
    }
    proof = ss.certify(p, "stable", between=between, max_boxes=2000)
    points = {side: rng.uniform(*ends, 10_000) for side, ends in between.items()}
    told: Any = proof.counterexample
    checked = p.replace(**points) if proof.outcome == "proved" else told
    wrong = list[str]()
    if checked is not None:
        grows = (ss.equilibria(checked)["growth_sign"] > 0).any()
        undamped = name == "two_springs" and not grows
        wrong += [f"{p!r} {between}: {proof.outcome}, and some grow: {grows}"] * (
            bool(grows) == (proof.outcome == "proved") and not undamped
        )
    return {"kind": f"boxes of {name}", "wrong": wrong, proof.outcome: 1}
