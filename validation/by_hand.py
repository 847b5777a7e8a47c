"""Random attack on every shipped model and on pages of other kinds, against forces written by hand from their drawings.

``python -m validation.by_hand [N] [SEED] [FILE] [MODEL …]``: N parameter sets on each model, values log-uniform over 10⁻⁶ to 10⁶ or
near the base, ends of ranges and 0 among them. With FILE each set's outcome is kept there, and what was interrupted goes on where
it was. It exits with 1 if anything contradicts the reference.

Of each set are asked

- all equilibria in contact and in lift-off: every one has to solve the reference within its error in 40 digits, and Newton's method on
  the reference from many starts may find none that is neither listed nor in an undecided box;
- a motion, on both integrators: the reference integrated by SciPy without modes and events, and the balance of energy;
- a sweep over the same motion: its mean and number of lost contacts.
"""

from __future__ import annotations

import json
import math
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np

import spragsym as ss
from tests.oracles.forces_by_hand import DRAWN, Drawn, Values
from validation.motions_by_hand import motion

#: Where the pages that are not shipped stand.
PAGES = Path(__file__).parent / "pages"
#: Starts of Newton's method, and its steps.
STARTS, STEPS = 400, 80
#: Digits in which a state is held against the reference.
DIGITS = 40


def load(name: str, derived: Path) -> Any:
    """A shipped model, or one of ``validation/pages``, derived into a folder."""
    page = PAGES / f"{name}.py"
    if not page.exists():
        return ss.load(name).search
    from spragsym.derive import folder

    folder.write_page(page, derived / name)
    return ss.load(derived / name)


def draw(model: Any, rng: np.random.Generator) -> Values:
    """One set of parameters."""
    values: Values = {}
    near = rng.random() < 0.3  # all near the base
    for name, allowed in model.Parameters.ranges.items():
        low, high = max(allowed.low, -1e6), min(allowed.high, 1e6)
        base = model.base.get(name, 1.0)
        kind = rng.random()
        if high < 1e6:
            ends = [low if not allowed.open_low else np.nextafter(low, high), np.nextafter(high, low), (low + high) / 2]
            value = rng.choice(ends) if kind < 0.08 else rng.uniform(low, high)
        elif low < 0:
            value = rng.uniform(-3.2, 3.2)
        elif kind < 0.08 and allowed.contains(0.0):
            value = 0.0
        elif near or kind < 0.3:
            value = (base or 0.1) * 10 ** rng.uniform(-0.6, 0.6)
        else:
            value = 10 ** rng.uniform(-6, 6)
        values[name] = float(value)
    return values


# ------------------------------------------------------------------------------------------------ equilibria


def equilibria(model: Any, drawn: Drawn, values: Values, contact: bool, rng: np.random.Generator) -> dict[str, Any]:
    """What is wrong with the equilibria of one set: nothing, in the best case."""
    begin = time.process_time()
    found = ss.equilibria(model.Parameters(**values), contact)
    spent = time.process_time() - begin
    states = np.array([found.coordinates[name] for name in model.coordinates])[:, : int(found.count)].T
    wrong = [
        text for state, error in zip(states, found.error, strict=False) for text in _off(drawn, values, contact, state, error)
    ]
    boxes = [(np.array(box.low), np.array(box.high)) for box in found.undecided]
    wrong += _missed(drawn, values, contact, states, boxes, found.region, found.whole, rng)
    return {"wrong": wrong, "undecided": len(boxes), "whole": found.whole, "seconds": spent}


def _off(drawn: Drawn, values: Values, contact: bool, state: Any, error: float) -> list[str]:
    """Whether a listed state is further from the reference's than its error."""
    if not np.isfinite(state).all() or not error <= 1e-12:
        return [f"a listed state {state.tolist()} with the error {error}"]
    with mp.workdps(DIGITS):
        p = {name: mp.mpf(value) for name, value in values.items()}
        mu = drawn.static_friction(p, mp)
        start = [mp.mpf(float(value)) for value in state]

        def balance(*q: Any) -> Any:
            return drawn.forces(q, [mp.mpf(0)] * len(q), p, mp, contact, mu)

        try:
            root = mp.findroot(balance, start, tol=mp.mpf(10) ** (-DIGITS), maxsteps=60, verify=False)
        except (ZeroDivisionError, ValueError) as reason:
            return [f"the reference has no state near {state.tolist()}: {reason}"]
        root = list(root) if isinstance(root, mp.matrix) else [root]
        away = max(abs(a - b) / max(1, abs(a)) for a, b in zip(root, start, strict=True))
        if away > error * (1 + mp.mpf(10) ** -6):
            return [
                f"{state.tolist()} is {mp.nstr(away, 3)} from {[mp.nstr(part, 20) for part in root]}, its error is {error:.2g}"
            ]
        if drawn.lifts and ((root[1] > 0) if contact else (root[1] < 0)):
            return [f"{state.tolist()} is on the wrong side of the gap"]
    return []


def starts(drawn: Drawn, values: Values, contact: bool, rng: np.random.Generator) -> Any:
    """Places of all sizes around 0 and around the first anchor, shape (coordinates, STARTS)."""
    n = len(drawn.masses)
    place = rng.choice([-1.0, 1.0], (n, STARTS)) * 10 ** rng.uniform(-7, 5, (n, STARTS))
    if "theta0" in values:
        third = STARTS // 3
        place[0, :third] += math.cos(values["theta0"])
        place[1, :third] += math.sin(values["theta0"])
        place[:2, third : 2 * third] = rng.uniform(-3, 3, (2, third))
    if drawn.lifts:
        place[1] = np.where(contact, -1.0, 1.0) * np.abs(place[1])
    return place


def newton(drawn: Drawn, values: Values, contact: bool, place: Any) -> Any:
    """Roots of the reference by Newton's method with derivatives by complex steps; columns that did not converge are left out."""
    n, p, still = len(place), values, np.zeros_like(place)
    mu, tiny = drawn.static_friction(p, np), 1e-150
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            f = np.array(np.broadcast_arrays(*drawn.forces(list(place + 0j), still, p, np, contact, mu)))
            jacobian = np.empty((n, n, place.shape[1]))
            for j in range(n):
                moved = place + 0j
                moved[j] += 1j * tiny
                for i, row in enumerate(drawn.forces(list(moved), still, p, np, contact, mu)):
                    jacobian[i, j] = np.imag(row) / tiny
            good = np.isfinite(jacobian).all(axis=(0, 1)) & np.isfinite(f).all(axis=0) & (np.abs(np.imag(f)).max(axis=0) == 0)
            place, still, f, jacobian = place[:, good], still[:, good], f[:, good], jacobian[:, :, good]
            if not place.shape[1]:
                return place
            step = -np.array([_solved(jacobian[:, :, k], np.real(f[:, k])) for k in range(place.shape[1])]).T
            place = place + step
    sure = np.abs(step).max(axis=0) <= 1e-9 * np.maximum(1e-12, np.abs(place).max(axis=0))
    return place[:, sure]


def _solved(matrix: Any, right: Any) -> Any:
    try:
        return np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError:
        return np.full(len(right), np.nan)


def _missed(
    drawn: Drawn, values: Values, contact: bool, states: Any, boxes: list[tuple[Any, Any]], region: Any, whole: bool, rng: Any
) -> list[str]:
    """Roots of the reference that the answer does not have."""
    wrong: list[str] = []
    known = [np.asarray(state) for state in states]
    for root in newton(drawn, values, contact, starts(drawn, values, contact, rng)).T:
        if drawn.lifts and (root[1] >= 0 if contact else root[1] <= 0):
            continue
        size = np.maximum(1.0, np.abs(root))
        if any((np.abs(root - state) / size).max() < 1e-6 for state in known):
            continue
        if any(((root >= low - 1e-6 * size) & (root <= high + 1e-6 * size)).all() for low, high in boxes):
            continue
        beyond = bool(((root < region[:, 0]) | (root > region[:, 1])).any())
        if (whole or not beyond) and _solves(drawn, values, contact, root):
            wrong.append(f"missed {root.tolist()}" + (" outside the region" if beyond else ""))
            known.append(root)
    return wrong


def _solves(drawn: Drawn, values: Values, contact: bool, root: Any) -> bool:
    """Whether Newton's method in many digits stays there, and on the side of the gap."""
    with mp.workdps(DIGITS):
        p = {name: mp.mpf(value) for name, value in values.items()}
        mu = drawn.static_friction(p, mp)
        try:
            exact = mp.findroot(
                lambda *q: drawn.forces(q, [mp.mpf(0)] * len(q), p, mp, contact, mu), [mp.mpf(float(part)) for part in root],
                tol=mp.mpf(10) ** (-DIGITS), maxsteps=30,
            )  # fmt: skip
        except (ZeroDivisionError, ValueError, TypeError):  # the last one where no pivot is a number
            return False
        exact = list(exact) if isinstance(exact, mp.matrix) else [exact]
        if any(mp.im(part) != 0 for part in exact):
            return False
        near = all(abs(part - float(value)) <= 1e-6 * max(1, abs(part)) for part, value in zip(exact, root, strict=True))
        return near and (not drawn.lifts or (exact[1] < 0 if contact else exact[1] > 0))


# ------------------------------------------------------------------------------------------------ all of it


def attacked(model: Any, drawn: Drawn, name: str, seed: int, number: int) -> dict[str, Any]:
    """One set of parameters, and what came of it."""
    rng = np.random.default_rng([seed, number, *name.encode()])
    values = draw(model, rng)
    outcome: dict[str, Any] = {"values": values}
    for kind, contact in (("contact", True), ("lift-off", False)):
        if contact or drawn.lifts:
            outcome[kind] = _tried(lambda contact=contact: equilibria(model, drawn, values, contact, rng))
    outcome["motion"] = _tried(lambda: motion(model, drawn, values, rng))
    return outcome


def _tried(ask: Any) -> dict[str, Any]:
    """The outcome of a question; an error that is none of the package's is one of the package."""
    try:
        outcome: dict[str, Any] = ask()
    except ss.SpragsymError as error:
        return {"wrong": [], "refused": str(error)[:200], "seconds": 0.0}
    except Exception as error:  # whatever it is, it is a finding
        return {"wrong": [f"{type(error).__name__}: {error}"[:300]], "seconds": 0.0}
    return outcome


def attack(name: str, count: int, seed: int, done: dict[str, Any], store: Path | None, derived: Path) -> int:
    """All sets of one model; the number of those with something wrong."""
    model, drawn = load(name, derived), DRAWN[name]
    bad, tally, slowest = 0, Counter[str](), Counter[str]()
    for number in range(count):
        key = f"{name} {seed} {number}"
        if key not in done:
            done[key] = attacked(model, drawn, name, seed, number)
            if store is not None:
                with store.open("a", encoding="utf-8") as file:
                    file.write(json.dumps([key, done[key]], default=np.ndarray.tolist) + "\n")
        outcome = done[key]
        wrong = [f"{kind}: {text}" for kind, part in outcome.items() if kind != "values" for text in part["wrong"]]
        for kind, part in outcome.items():
            if kind != "values":
                tally[f"{kind} refused"] += "refused" in part
                tally[f"{kind} undecided"] += bool(part.get("undecided"))
                tally[f"{kind} not whole"] += not part.get("whole", True)
                slowest[kind] = max(slowest[kind], round(part["seconds"], 2))
        bad += bool(wrong)
        for text in wrong:
            print(f"  {key}: {text}\n    {outcome['values']}", flush=True)
    told = ", ".join(f"{value} {kind}" for kind, value in sorted(tally.items()) if value) or "all decided"
    print(f"{name:16}{count:5} sets, {bad} with something wrong; {told}; slowest {dict(slowest)} s", flush=True)
    return bad


def main() -> None:
    """All models, or those that are named."""
    count, seed = (int(sys.argv[i]) if len(sys.argv) > i else default for i, default in ((1, 30), (2, 1)))
    store = Path(sys.argv[3]) if len(sys.argv) > 3 else None
    done = dict(json.loads(line) for line in store.read_text(encoding="utf-8").splitlines()) if store and store.exists() else {}
    with tempfile.TemporaryDirectory() as derived:
        bad = [attack(name, count, seed, done, store, Path(derived)) for name in sys.argv[4:] or DRAWN]
    raise SystemExit(int(any(bad)))


if __name__ == "__main__":
    main()
