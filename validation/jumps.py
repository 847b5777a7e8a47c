"""Jump values against paths of states, of the article's model and of models without closed forms;
probabilities against samples.

In turn: the values of a hundred points by closed form, each against the first jump of its path;
values of 2000 points at once, six of which are followed one by one; an interval of a probability,
and its proved bracket, against 10⁵ plain samples. Last found: last digits of values along
stiffnesses that were beyond their bound (2119e429).
"""

import warnings
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.bifurcation.paths import first_end
from spragsym.generated.quantities import PARAMETERS
from spragsym.kang_nam.jump_values import limit_point_passed
from tests.oracles import families

CASES = 120
#: Of a jump that is right, relative.
CLOSE = 1e-11
#: Two-coordinate models whose jump values have no closed forms, and how far friction rises.
MODELS, FAR = ("two_springs", "cubic_contact", "inclined_belt", "hertz_contact", "damped"), 2.0
TOLERANCES: dict[str, Any] = {
    "theta0": (0.68, 0.72),
    "mu0": (0.4, 0.6),
    "kappa": (0.006, 0.008),
    "alpha": (0.006, 0.008),
    "sigma": (0.085, 0.115),
    "beta": (0.0, 0.02),
}
#: Model, what rises, and the inclination about which there are tolerances.
BRACKETS = (
    ("two_springs", "mu0", 40.0),
    ("stribeck", "mu_s", 40.0),
    ("cubic_contact", "mu0", 45.0),
)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One of the questions."""
    if number % 10 == 9:
        return bracket(number // 10, rng) if number // 10 % 2 else probability(rng)
    return at_once(number // 4, rng) if number % 4 == 3 else values(number, rng)


def values(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Points of both families; the path goes 1 % beyond the value, or far where there is none."""
    vary, family = (
        ("mu0", "theta0")[number % 2],
        (families.random, families.near_folds)[number // 2 % 2],
    )
    p = family(rng, 100)
    known = np.asarray(ss.jump_value(p, vary))
    start, far = (0.0, 1e3) if vary == "mu0" else (1e-12, 3.14159)
    wrong = []
    for i, value in enumerate(known.tolist()):
        end = min(value * 1.01, far) if np.isfinite(value) else far
        if np.isfinite(value) and not start < value < end:
            continue
        q = ss.Parameters(**{name: float(getattr(p, name)[i]) for name in PARAMETERS})
        jumps = [jump.value for jump in ss.quasi_static_path(q, vary, [start, end]).jumps[:1]]
        if bool(jumps) != np.isfinite(value) or (
            jumps and abs(jumps[0] - value) > CLOSE * max(1.0, value)
        ):
            wrong.append(f"{q!r} along {vary}: {value} for {jumps}")
    return {
        "kind": f"values along {vary}",
        "wrong": wrong,
        "points": len(known),
        "jumping": int(np.isfinite(known).sum()),
    }


def at_once(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Points of a model at once, and some of them one after the other by a path between all
    folds.
    """
    model, size = ss.load(MODELS[number % len(MODELS)]), 2000
    scales = {
        key: model.base[key] * 2 ** rng.uniform(-1, 1, size) for key in ("kappa", "sigma", "alpha")
    }
    p = model.Parameters(theta0=rng.uniform(0.3, 1.4, size), **scales)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ss.errors.UndecidedWarning)
        known = np.asarray(ss.jump_value(p, until=FAR))
    wrong = []
    for i in range(6):
        one = model.Parameters(
            **{
                key: float(np.broadcast_to(getattr(p, key), known.shape)[i])
                for key in model.parameters
            }
        )
        end = first_end(one, "mu0", (0.0, FAR))
        if (end is None) != np.isnan(known[i]) or (
            end is not None and abs(end.value - known[i]) > 1e-9
        ):
            wrong.append(f"{one!r}: {known[i]} for {end}")
    return {
        "kind": model.name,
        "wrong": wrong,
        "points": size,
        "jumping": int(np.isfinite(known).sum()),
    }


def probability(rng: np.random.Generator) -> dict[str, Any]:
    """Whether the interval and four standard deviations of 10⁶ plain samples meet, but for one case
    in six thousand.
    """
    many, hits = 1_000_000, 0
    p = ss.Parameters(**{name: rng.uniform(*ends, many) for name, ends in TOLERANCES.items()})
    hits = int((limit_point_passed(p) == 1).sum())
    share = hits / many
    found = ss.jump_probability(TOLERANCES, n=1 << 17, rng=rng, confidence=0.9999)
    far = 4 * (share * (1 - share) / many) ** 0.5
    wrong = (
        []
        if found.low - far < share < found.high + far
        else [f"{found.low} to {found.high}, samples {share}"]
    )
    return {"kind": "probability", "wrong": wrong}


def bracket(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """The proved bracket of a probability, and the interval of samples."""
    name, vary, degrees = BRACKETS[number // 2 % len(BRACKETS)]
    model = ss.load(name)
    base = model.Parameters(theta0=np.radians(degrees))
    jump = float(ss.jump_value(base, vary, begin=0.0))
    low, high = (
        base.replace(
            theta0=np.radians(degrees + 0.5 * side),
            sigma=float(base.sigma) * (1 + 0.05 * side),
            **{vary: jump * (1 + 0.07 * side)},
        )
        for side in (-1, 1)
    )
    asked = {"vary": vary, "begin": 0.0}
    few = ss.jump_probability((low, high), **asked, n=64, rng=1, replicates=2, max_boxes=8000)
    found = ss.jump_probability((low, high), **asked, n=100_000, rng=rng)
    meet = few.proved[0] <= found.high and found.low <= few.proved[1]
    return {
        "kind": "bracket",
        "wrong": []
        if meet
        else [f"{name}: proved {few.proved}, samples {found.low} to {found.high}"],
    }
