"""How many eigenvalues grow on both sides of onsets and folds, against those of the states there.

A case is one parameter of one shipped model, without damping every second time. What is told of a
point is held against eigenvalues of the equilibria a little below and above it, searched for anew.
"""

from itertools import product
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.models.load import shipped
from spragsym.results import Points

#: Angles and speeds of models that have no base value of these.
GIVEN = {"theta0": 0.7, "phi0": 0.7}
#: Models in which nothing damps.
UNDAMPED = ("coulomb", "coulomb_stick_slip")
#: A pair that grows less, over the size of the λ, is not told by floats: with damping, and without,
#: where pairs may be next to each other.
ROUNDING = {True: 1e-12, False: 1e-10}
ASKED = [
    (name, vary, damping)
    for name in shipped()
    if not ss.load(name).clock
    for vary, damping in product(ss.load(name).parameters, (None, False))
]
CASES = 4 * len(ASKED)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One parameter of one model, at its base values first, then at random ones."""
    name, vary, damping = ASKED[number % len(ASKED)]
    model = ss.load(name)
    given = {one: model.base.get(one, GIVEN.get(one, 1.0)) for one in model.parameters}
    if number >= len(ASKED):
        drawn = {one: value * 10 ** rng.uniform(-0.6, 0.6) for one, value in given.items()}
        ranges = model.Parameters.ranges
        given |= {one: value for one, value in drawn.items() if ranges[one].contains(value)}
    p = model.Parameters(**given)
    value = float(p[vary])
    high = p.ranges[vary].high
    between = {vary: (0.1 * value, min(0.99 * high, 6.0 * value)) if value else (0.0, 1.0)}
    try:
        onsets = ss.flutter_onsets(p, vary, between=between, damping=damping)
        folds = ss.folds(p, vary, between=between) if damping is None else None
    except ss.errors.ParameterTypeError as error:  # a question that the model has no answer to
        return {"kind": "refused", "wrong": [], "said": str(error)}
    found = {"onsets": 0, "folds": 0, "undecided": 0, "not seen": 0}
    wrong = list[str]()
    for kind, points in (("onsets", onsets), ("folds", folds)):
        for row in range(0 if points is None else len(points)):
            told = [int(points.unstable_before[row]), int(points.unstable_after[row])]
            seen = beside(points, row) if kind == "onsets" else meeting(points, row)
            found[kind] += 1
            found["undecided"] += told[0] < 0
            found["not seen"] += seen is None
            if told[0] >= 0 and seen is not None and told != seen:
                wrong.append(f"{name}, {vary} = {points[vary][row]:.12g}: {told}, seen {seen}")
    return {"kind": name, "wrong": wrong, **found}


def beside(points: Points, row: int) -> list[int] | None:
    """How many λ grow in the nearest equilibria on both sides of an onset; None where floats do not
    tell.
    """
    found, damping = list[int](), points.kind[row] == "hopf"
    for side in (-2e-4, 2e-4):
        value = float(points[points.vary[0]][row])
        places, λ = states(points, row, value + side * (value or 1.0), damping)
        off = np.abs(places).max(axis=0)
        if off.min(initial=np.inf) > 0.01:  # it has met another in a fold before
            return None
        found.append(grown(λ[off.argmin()], damping))
    return None if min(found) < 0 else found


def meeting(points: Points, row: int) -> list[int] | None:
    """The numbers of two equilibria that are about to meet in a fold, the smaller first."""
    value = float(points[points.vary[0]][row])
    for side in (-1e-6, 1e-6):
        places, λ = states(points, row, value * (1 + side), damping=True)
        off = np.abs(places).max(axis=0)
        two = np.argsort(off)[:2]
        if points.kind[row] == "fold" and len(two) == 2 and off[two].max() < 0.05:
            damping = points.parameters.model.name not in UNDAMPED
            found = sorted(grown(one, damping) for one in λ[two])
            return None if found[0] < 0 else found
    return None


def states(points: Points, row: int, value: float, damping: bool) -> tuple[Any, Any]:
    """All equilibria at a value: where they are, from a point, and their λ."""
    eq = ss.equilibria(points.parameters.replace(**{points.vary[0]: value}))
    places = [np.ravel(eq[name])[: int(eq.count)] for name in points.parameters.model.coordinates]
    here = [float(points[name][row]) for name in points.parameters.model.coordinates]
    λ = eq.damped_eigenvalues if damping else eq.eigenvalues
    return np.array(places) - np.array(here)[:, None], λ[: int(eq.count)]


def grown(λ: Any, damping: bool) -> int:
    """How many λ of a state grow; −1 where rounding may decide. Without damping pairs of a stable
    state do not decay.
    """
    growth, least = λ.real / np.abs(λ).max(), ROUNDING[damping]
    told = (np.abs(growth) > least) | ((np.abs(growth) < 0.01 * least) & (not damping))
    return int((growth > least).sum()) if told.all() else -1
