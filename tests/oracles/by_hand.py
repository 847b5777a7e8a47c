"""Equilibria and motions of shipped models and other pages, held against forces written by hand from their drawings.

Every listed equilibrium has to solve the reference within its error in 40 digits, and Newton's method on the reference from many
starts may find none that is neither listed nor in an undecided box. A motion, on both integrators, is held against one that SciPy
integrates without modes and events, and against the balance of energy.
"""

from __future__ import annotations

import itertools
import math
import time
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np

import spragsym as ss
from tests.oracles.forces_by_hand import Drawn, Values

#: Where the pages that are not shipped stand.
PAGES = Path(__file__).parent / "pages"
#: Starts of Newton's method, and its steps.
STARTS, STEPS = 400, 80
#: Digits in which a state is held against the reference.
DIGITS = 40
#: Steps after which a motion is given up.
MAX_STEPS = 4000
RTOL = 1e-9
#: Calls of the field after which the reference is given up.
CALLS = 100_000


def load(name: str, derived: Path) -> Any:
    """A shipped model, or one of ``tests/oracles/pages``, derived into a folder."""
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


# ------------------------------------------------------------------------------------------------ motions


def start_of(drawn: Drawn, rng: np.random.Generator) -> tuple[Any, int]:
    """Rest at 0, a place on the gap's border, one in lift-off, the belt's speed, or anything."""
    n = len(drawn.masses)
    start = np.zeros(2 * n)
    kind = rng.integers(6)
    if kind >= 2:
        start += rng.normal(0, 0.3, 2 * n)
    if n > 1 and kind == 3:
        start[1] = 0.0
    if n > 1 and kind == 4:
        start[[1, n + 1]] = abs(start[[1, n + 1]])
    return start, int(kind)


def field(drawn: Drawn, values: Values) -> Any:
    """The hand-written field as a whole, kinks and all."""
    n, masses = len(drawn.masses), np.array(drawn.inertia(values), dtype=float)

    def rhs(_: float, state: Any) -> Any:
        q, v = state[:n], state[n:]
        slip = values["V"] - v[0]
        mu = np.sign(slip) * drawn.friction(abs(slip), values, np)
        touching = not drawn.lifts or q[1] < 0
        return np.concatenate([v, np.array(drawn.forces(q, v, values, np, touching, mu), dtype=float) / masses])

    return rhs


def motion(model: Any, drawn: Drawn, values: Values, rng: np.random.Generator) -> dict[str, Any]:
    """What is wrong with a motion of one set."""
    start, kind = start_of(drawn, rng)
    if kind == 1:
        start[len(drawn.masses)] = values["V"]
    if "depth_e" in values:
        start[1] = max(start[1], -5 * values["depth_e"])  # no number holds the force much deeper
    rhs = field(drawn, values)
    t_end = float(min(20.0, 30.0 / _fastest(rhs, start)) * 10 ** rng.uniform(-1, 0))
    outcome = {"wrong": [], "seconds": 0.0, "kind": int(kind), "t_end": t_end, "start": start.tolist()}
    try:
        reference, sure = _reference(rhs, start, t_end)
    except TimeoutError:
        return {**outcome, "refused": "the reference takes too long"}
    for backend in ("heyoka", "scipy"):
        begin = time.process_time()
        for rtol in (RTOL, RTOL / 1000):  # stiff creep multiplies the tolerance
            try:
                tr = ss.simulate(
                    model.Parameters(**values), start=start, t_end=t_end, rtol=rtol, backend=backend, max_steps=MAX_STEPS
                )
            except ss.ConvergenceError as error:
                outcome["refused"] = str(error)
                wrong = []
                break
            outcome["seconds"] = max(outcome["seconds"], time.process_time() - begin)
            wrong = [f"{backend}: {text}" for text in _off_motion(drawn, values, tr, reference, sure)]
            if not wrong:
                break
        outcome["wrong"] += wrong
    return outcome


def _off_motion(drawn: Drawn, values: Values, tr: Any, reference: Any, sure: float) -> list[str]:
    """Whether a motion ends elsewhere than the reference, or its energy does not balance."""
    if not np.isfinite(tr.state).all():
        return ["a number that is none"]
    wrong, n = [], len(drawn.masses)
    away = np.abs(tr.state[:, -1] - reference).max()
    if away > 1e-6 * max(1e-3, float(np.abs(tr.state).max())) + 30 * sure:
        wrong.append(f"the end is {away:.2g} from the reference's, sure to {sure:.1g}")
    energy, power = tr.energy(), tr.power()
    kinetic = np.abs(tr.state[n:] ** 2 * np.array(drawn.inertia(values), dtype=float)[:, None]).max()
    scale = np.abs(energy).max() + kinetic + tr.integral(np.abs(power))
    rounding = 1e-14 * max(map(abs, values.values())) * max(1.0, values.get("lambda_2", 1.0)) ** 2  # of springs' energies at rest
    off = abs(energy[-1] - energy[0] - tr.integral(power))
    if not off <= 1e-5 * scale + rounding:
        wrong.append(f"the energy is off by {off / scale:.2g} of its size")
    return wrong


def _fastest(rhs: Any, start: Any) -> float:
    """A rate of the field near the start, by differences."""
    base = rhs(0.0, start)
    rates = [np.abs((rhs(0.0, start + 1e-6 * unit) - base) / 1e-6).max() for unit in np.eye(len(start))]
    return float(np.sqrt(max(max(rates), 1e-6)))


def _reference(rhs: Any, start: Any, t_end: float) -> tuple[Any, float]:
    """The end of the motion by an implicit method on the field as a whole, and the difference of two tolerances."""
    from scipy.integrate import solve_ivp

    calls = itertools.count()

    def counted(t: float, state: Any) -> Any:
        if next(calls) > CALLS:
            raise TimeoutError
        return rhs(t, state)

    with np.errstate(all="ignore"):
        ends = [
            solve_ivp(counted, (0.0, t_end), start, method="LSODA", rtol=rtol, atol=rtol * 1e-3, max_step=t_end / 500).y[:, -1]
            for rtol in (1e-8, 1e-10)
        ]
    return ends[1], float(np.abs(ends[1] - ends[0]).max())
