"""Certificates of any model over random boxes: proved ones sampled, refuted ones followed, and both against closed forms.

Run ``python -m validation.certificates [number] [seed] [store] [seconds] [claim]``: boxes of the models in turn. Finished
parts go to the file ``store``, and a second call goes on from there. Of a box in which nothing is proved to jump, points are
followed one by one by a path with proved folds, which shares no tube with the certificate, and 10,000 have their jump values; of the
article's model a million points are held against its closed forms. At a counterexample the same path must end, and a motion from
there leaves at a friction 1 % beyond that end and stays 1 % before it. Of the other claims, "one equilibrium" and "no
flutter", the equilibria at 500 points, of the article's model at 10,000, and at the counterexample are counted and told by their
eigenvalues. ``python -m validation.certificates brackets [samples]`` holds the proved bracket of the probability of a jump
against samples, for three models with three tolerances. Exits with 1 if anything contradicts.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.models.catastrophe.paths import ModelEnd, first_end
from validation import parts

MODELS = ("kang_nam", "two_springs", "inclined_belt", "cubic_contact", "damped")
#: One more, which flutters.
STATES = (*MODELS, "mode_coupling")
#: Points of a box that is proved: those that are followed, those with jump values, for closed forms; and where equilibria are counted,
#: of any model and of the article's.
FOLLOWED, JUMPS, CLOSED, COUNTED, MANY = 4, 10_000, 1_000_000, 500, 10_000
#: Of a motion beside the end of a state: how far from it in friction, for how long, with friction that works fully.
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
        model.Parameters(**{name: value * (1 + side * size[name]) for name, value in middle.items()}) for side in (-1, 1)
    )
    return low, high


def end_of(model: Any, p: Any) -> ModelEnd | None:
    """Where the state that is followed from no friction ends before that of a point."""
    return first_end(model, p.replace(mu0=0.0), "mu0", (0.0, float(p.mu0)))


def leaves(model: Any, p: Any, end: ModelEnd) -> bool | None:
    """Whether motions from where a state ends leave beyond that friction and stay before it; None where no motion tells.

    Which ones stay is told by the state just before its end: what gets no farther than that has not left, what gets three times as
    far has. In between, as beside a cusp, where the next state is near, a motion does not tell.
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
            p.replace(mu0=end.value * (1 + side * BESIDE), d=STEEP / float(p.V)), start=[*q, *[0.0] * len(q)], t_end=LONG
        )
        off.append(float(np.abs(getattr(motion, first) - q[0]).max()))
    return None if off[0] > 3 * near or near < off[1] <= 3 * near else bool(off[1] > near)


def fails(eq: Any, claim: str) -> Any:
    """At which points a claim is false, by their equilibria; those that are not decided do not count."""
    if claim == "one equilibrium":
        return (eq.count > 1) | ((eq.count == 0) & eq.decided & eq.whole)
    return (np.abs(eq.eigenvalues.real) * np.abs(eq.eigenvalues.imag) > 1e-9 * np.abs(eq.eigenvalues) ** 2).any(axis=(-2, -1))


def about_states(number: int, seed: int, claim: str) -> dict[str, Any]:
    """One box for a claim about all states."""
    rng = np.random.default_rng([seed, number, len(claim)])
    name = STATES[number % len(STATES)]
    low, high = box(ss.load(name).search, rng)
    begin = time.process_time()
    found = ss.certify(low, high, claim, method="search", max_boxes=PARTS)
    told = {"model": name, "outcome": found.outcome, "parts": found.boxes, "seconds": round(time.process_time() - begin, 2)}
    wrong = False
    if found.outcome == "refuted":
        wrong = not fails(ss.equilibria(found.counterexample), claim)
    if found.outcome == "proved":
        points = low.replace(**within(low, high, rng, MANY if name == "kang_nam" else COUNTED))
        wrong = bool(fails(ss.equilibria(points), claim).any())
    return {**told, "wrong": int(wrong)}


def within(low: Any, high: Any, rng: np.random.Generator, number: int) -> dict[str, Any]:
    """Random points of a box by name, corners of it among them."""
    names = [name for name in low.model.parameters if float(getattr(low, name)) < float(getattr(high, name))]
    share = {name: np.where(rng.random(number) < 0.3, rng.integers(0, 2, number), rng.random(number)) for name in names}
    return {name: (1 - part) * float(getattr(low, name)) + part * float(getattr(high, name)) for name, part in share.items()}


def one(number: int, seed: int) -> dict[str, Any]:
    """One box: what is said of it, and what contradicts."""
    rng = np.random.default_rng([seed, number])
    name = MODELS[number % len(MODELS)]
    model = ss.load(name).search
    low, high = box(model, rng)
    begin = time.process_time()
    found = ss.certify(low, high, "no jump", method="search", max_boxes=PARTS)
    told = {
        "model": name,
        "outcome": found.outcome,
        "parts": found.boxes,
        "seconds": round(time.process_time() - begin, 2),
        "wrong": 0,
    }
    if found.outcome == "refuted":
        end = end_of(model, found.counterexample)
        left = None if end is None else leaves(model, found.counterexample, end)
        told["wrong"] = int(end is None or left is False)
        told["motion"] = "leaves" if left else "not told"
    if found.outcome == "proved":
        if name != "kang_nam":
            values = within(low, high, rng, JUMPS)
            jumps = np.asarray(model.jump_value(low.replace(**values), "mu0", until=float(high.mu0)))
            told["wrong"] = int((jumps <= values["mu0"]).sum())
        values = within(low, high, rng, FOLLOWED)
        told["wrong"] += sum(
            end_of(model, low.replace(**{key: float(value[i]) for key, value in values.items()})) is not None
            for i in range(FOLLOWED)
        )
    if name == "kang_nam" and found.outcome == "proved":
        values = within(low, high, rng, CLOSED)
        friction = values.pop("mu0")
        p = ss.Parameters.article(
            **{key: float(getattr(low, key)) for key in ("theta0", "kappa", "alpha", "sigma", "beta")} | values
        )
        told["wrong"] += int((np.asarray(ss.jump_value(p)) < friction).sum())
    return told


#: Model, what rises, and the inclination about which there are tolerances.
BRACKETS = (("two_springs", "mu0", 40.0), ("stribeck", "mu_s", 40.0), ("cubic_contact", "mu0", 45.0))


def brackets(samples: str = "100000") -> int:
    """The proved bracket of the probability, its width and how long it took, beside the interval of samples."""
    wrong = 0
    for name, vary, degrees in BRACKETS:
        model = ss.load(name)
        base = model.Parameters(theta0=np.radians(degrees))
        jump = float(model.jump_value(base, vary, begin=0.0))
        low, high = (
            base.replace(
                theta0=np.radians(degrees + 0.5 * side),
                sigma=float(base.sigma) * (1 + 0.05 * side),
                **{vary: jump * (1 + 0.07 * side)},
            )
            for side in (-1, 1)
        )
        begin = time.perf_counter()
        few = model.jump_probability((low, high), vary=vary, begin=0.0, n=64, rng=1, replicates=2, max_boxes=8000)
        spent = time.perf_counter() - begin
        found = model.jump_probability((low, high), vary=vary, begin=0.0, n=int(samples), rng=2)
        wrong += not (few.proved[0] <= found.high and found.low <= few.proved[1])
        print(
            f"{name}: proved {few.proved[0]:.4f} to {few.proved[1]:.4f}, {few.proved[1] - few.proved[0]:.4f} wide, in {spent:.0f} s; "
            f"{found.n} samples {found.low:.4f} to {found.high:.4f}",
            flush=True,
        )
    return int(wrong > 0)


def main(number: str = "200", seed: str = "1", store: str = "", seconds: str = "inf", claim: str = "no jump") -> int:
    """The boxes; 1 if anything contradicts."""

    def work(part: str) -> dict[str, Any]:
        return one(int(part), int(seed)) if claim == "no jump" else about_states(int(part), int(seed), claim)

    done = parts.run(map(str, range(int(number))), work, store, float(seconds)).values()
    counts = Counter((told["model"], told["outcome"]) for told in done)
    for name in MODELS if claim == "no jump" else STATES:
        print(name, {outcome: count for (model, outcome), count in sorted(counts.items()) if model == name})
    motions = Counter(told["motion"] for told in done if "motion" in told)
    if motions:
        print("motions at counterexamples:", dict(motions))
    wrong = sum(told["wrong"] for told in done)
    spent = [told["seconds"] for told in done]
    print(
        f"{len(done)} boxes of {number}: {wrong} contradictions; {np.median(spent):.2g} s of processor time in the middle, {max(spent):.2g} at most"
    )
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(brackets(*sys.argv[2:3]) if sys.argv[1:2] == ["brackets"] else main(*sys.argv[1:6]))
