"""Certificates of any model over random boxes: proved ones sampled, refuted ones followed, and both
against closed forms.

Of a box in which nothing is proved to jump, points are followed one by one by a path with proved
folds, which shares no tube with the certificate, and 10,000 have their jump values; of the
article's model a million, by closed forms. At a counterexample the same path must end, and a motion
from there leaves at a friction 1 % beyond that end and stays 1 % before it. Of the other claims the
equilibria at 500 points, of the article's model at 10,000, and at the counterexample are counted
and told by their eigenvalues. Last found: beside cusps tubes decided nothing where the state is
followed with ease (a126b18f).
"""

from typing import Any

import numpy as np

import spragsym as ss
from spragsym.bifurcation.paths import ModelEnd, first_end

CASES = 180
MODELS = ("kang_nam", "two_springs", "inclined_belt", "cubic_contact", "damped")
CLAIMS = ("no jump", "one equilibrium", "no flutter")
#: One more, which flutters.
STATES = (*MODELS, "mode_coupling")
#: Points of a box that is proved: those that are followed, those with jump values, for closed
#: forms; and where equilibria are counted, of any model and of the article's.
FOLLOWED, JUMPS, CLOSED, COUNTED, MANY = 4, 10_000, 1_000_000, 500, 10_000
#: Of a motion beside the end of a state: how far from it in friction, for how long, with friction
#: that works fully.
BESIDE, LONG, STEEP = 0.01, 3000.0, 400.0
#: Parts of a box.
PARTS = 300


def box(model: Any, rng: np.random.Generator) -> tuple[Any, Any]:
    """Corners about random values: two to four parameters within some percent."""
    middle = {"theta0": rng.uniform(0.3, 1.4), "mu0": rng.uniform(0.05, 1.0)}
    middle |= {
        name: model.base[name] * 2 ** rng.uniform(-1, 1)
        for name in ("kappa", "sigma")
        if name in model.base and rng.random() < 0.6
    }
    middle = {name: value for name, value in middle.items() if name in model.parameters}
    size = {name: rng.choice([0.005, 0.02, 0.05]) for name in middle}
    low, high = (
        model.Parameters(
            **{name: value * (1 + side * size[name]) for name, value in middle.items()}
        )
        for side in (-1, 1)
    )
    return low, high


def end_of(model: Any, p: Any) -> ModelEnd | None:
    """Where the state that is followed from no friction ends before that of a point."""
    return first_end(p.replace(mu0=0.0), "mu0", (0.0, float(p.mu0)))


def leaves(model: Any, p: Any, end: ModelEnd) -> bool | None:
    """Whether motions from where a state ends leave beyond that friction and stay before it; None
    where no motion tells.

    Which ones stay is told by the state just before its end: what gets no farther than that has not
    left, what gets three times as far has. In between, as beside a cusp, where the next state is
    near, a motion does not tell.
    """
    if end.kind != "fold":
        return None
    q, first = list(end.before.values()), model.coordinates[0]
    before = p.replace(mu0=end.value * (1 - BESIDE))
    eq = ss.equilibria(before)
    near = np.abs(getattr(eq, first)[: int(eq.count)] - q[0]).min()
    off = []
    for side in (-1, 1):
        motion = ss.simulate(
            p.replace(mu0=end.value * (1 + side * BESIDE), d=STEEP / float(p.V)),
            start=[*q, *[0.0] * len(q)],
            t_end=LONG,
        )
        off.append(float(np.abs(getattr(motion, first) - q[0]).max()))
    return None if off[0] > 3 * near or near < off[1] <= 3 * near else bool(off[1] > near)


def fails(eq: Any, claim: str) -> Any:
    """At which points a claim is false, by their equilibria; those that are not decided do not
    count.
    """
    if claim == "one equilibrium":
        return (eq.count > 1) | ((eq.count == 0) & eq.decided & eq.whole)
    return (
        np.abs(eq.eigenvalues.real) * np.abs(eq.eigenvalues.imag)
        > 1e-9 * np.abs(eq.eigenvalues) ** 2
    ).any(axis=(-2, -1))


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One box and one claim: what is said of it, and what contradicts."""
    claim = CLAIMS[number % len(CLAIMS)]
    names = MODELS if claim == "no jump" else STATES
    name = names[number // len(CLAIMS) % len(names)]
    model = ss.load(name)
    low, high = box(model, rng)
    sides = {
        name: (float(low[name]), float(high[name]))
        for name in model.parameters
        if low[name] < high[name]
    }
    found = ss.certify(low, claim, between=sides, method="search", max_boxes=PARTS)
    told: dict[str, Any] = {"kind": f"{claim}, {found.outcome}", "wrong": [], "motions": 0}
    if found.outcome == "refuted" and claim == "no jump":
        end = end_of(model, found.counterexample)
        left = None if end is None else leaves(model, found.counterexample, end)
        told["motions"] += left is not None
        told["wrong"] += [f"{found.counterexample!r}: {end}, leaves {left}"] * (
            end is None or left is False
        )
    elif found.outcome == "refuted":
        told["wrong"] += [f"{found.counterexample!r}: {claim}"] * (
            not fails(ss.equilibria(found.counterexample), claim)
        )
    elif found.outcome == "proved":
        bad = (
            jumping(name, low, high, rng)
            if claim == "no jump"
            else int(
                fails(
                    ss.equilibria(
                        low.replace(
                            **within(low, high, rng, MANY if name == "kang_nam" else COUNTED)
                        )
                    ),
                    claim,
                ).sum()
            )
        )
        told["wrong"] += [f"{low!r} to {high!r}: {bad} points contradict {claim}"] * bool(bad)
    return told


def jumping(name: str, low: Any, high: Any, rng: np.random.Generator) -> int:
    """Points of a box that jump: by jump values, and by states that are followed."""
    values = within(low, high, rng, CLOSED if name == "kang_nam" else JUMPS)
    jumps = np.asarray(
        ss.jump_value(
            low.replace(**values),
            "mu0",
            **({} if name == "kang_nam" else {"until": float(high.mu0)}),
        )
    )
    bad = int((jumps <= values.get("mu0", float(low.mu0))).sum())
    values = within(low, high, rng, FOLLOWED)
    points = [{key: float(value[i]) for key, value in values.items()} for i in range(FOLLOWED)]
    return bad + sum(end_of(low.model, low.replace(**point)) is not None for point in points)


def within(low: Any, high: Any, rng: np.random.Generator, number: int) -> dict[str, Any]:
    """Random points of a box by name, corners of it among them."""
    names = [
        name
        for name in low.model.parameters
        if float(getattr(low, name)) < float(getattr(high, name))
    ]
    share = {
        name: np.where(rng.random(number) < 0.3, rng.integers(0, 2, number), rng.random(number))
        for name in names
    }
    return {
        name: (1 - part) * float(getattr(low, name)) + part * float(getattr(high, name))
        for name, part in share.items()
    }
