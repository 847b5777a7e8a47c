"""Equilibria of shipped models and other pages, held against forces written by hand from their
drawings; and their field.

Every listed equilibrium has to solve the reference within its error in 40 digits, and Newton's
method on the reference from many starts may find none that is neither listed nor in an undecided
box.
"""

import math
import time
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np

import spragsym as ss
from tests.oracles.forces_by_hand import Drawn, Values
from tests.oracles.user_pages import replaced

#: Where the pages that are not shipped stand.
PAGES = Path(__file__).parent / "pages"
#: A mass in a rail, which pushes both ways and hardens by a cube, by what it differs from the mass
#: on a rubber belt.
RAIL = (
    "soft_brake",
    (
        ('"N/m^2", "hardening of the belt"', '"N/m^3", "hardening of the rail"'),
        ("k_2 * depth**2)", "k_2 * depth**3, unilateral=False)"),
        (", at_rest=mu0)", ")"),
    ),
)
#: Starts of Newton's method, and its steps.
STARTS, STEPS = 400, 80
#: Digits in which a state is held against the reference.
DIGITS = 40


def load(name: str, derived: Path) -> Any:
    """A shipped model, or one of ``tests/oracles/pages``, derived into a folder."""
    page = PAGES / f"{RAIL[0] if name == 'rail' else name}.py"
    if not page.exists():
        return ss.load(name).search
    from spragsym.derive import folder

    if name == "rail":
        text = replaced(page.read_text(encoding="utf-8"), *RAIL[1])
        page = derived / "rail.py"
        page.write_text(text, encoding="utf-8")
    folder.write_page(page, derived / name)
    return ss.load(derived / name)


# ------------------------------------------------------------------------------------------------
# equilibria


def equilibria(
    model: Any, drawn: Drawn, values: Values, contact: bool, rng: np.random.Generator
) -> dict[str, Any]:
    """What is wrong with the equilibria of one set: nothing, in the best case."""
    begin = time.process_time()
    # What never lifts may press on either of its faces.
    found = ss.equilibria(model.Parameters(**values), contact if drawn.lifts else None)
    spent = time.process_time() - begin
    states = np.array([found.coordinates[name] for name in model.coordinates])[
        :, : int(found.count)
    ].T
    wrong = [
        text
        for state, error in zip(states, found.error, strict=False)
        for text in _off(drawn, values, contact, state, error)
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
            root = mp.findroot(
                balance, start, tol=mp.mpf(10) ** (-DIGITS), maxsteps=60, verify=False
            )
        except (ZeroDivisionError, ValueError) as reason:
            return [f"the reference has no state near {state.tolist()}: {reason}"]
        root = list(root) if isinstance(root, mp.matrix) else [root]
        away = max(abs(a - b) / max(1, abs(a)) for a, b in zip(root, start, strict=True))
        if away > error * (1 + mp.mpf(10) ** -6):
            return [
                f"{state.tolist()} is {mp.nstr(away, 3)} from "
                f"{[mp.nstr(part, 20) for part in root]}, its error is {error:.2g}"
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
    """Roots of the reference by Newton's method with derivatives by complex steps; columns that did
    not converge are left out.
    """
    n, p, still = len(place), values, np.zeros_like(place)
    mu, tiny = drawn.static_friction(p, np), 1e-150
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            f = np.array(
                np.broadcast_arrays(*drawn.forces(list(place + 0j), still, p, np, contact, mu))
            )
            jacobian = np.empty((n, n, place.shape[1]))
            for j in range(n):
                moved = place + 0j
                moved[j] += 1j * tiny
                for i, row in enumerate(drawn.forces(list(moved), still, p, np, contact, mu)):
                    jacobian[i, j] = np.imag(row) / tiny
            good = (
                np.isfinite(jacobian).all(axis=(0, 1))
                & np.isfinite(f).all(axis=0)
                & (np.abs(np.imag(f)).max(axis=0) == 0)
            )
            place, still, f, jacobian = (
                place[:, good],
                still[:, good],
                f[:, good],
                jacobian[:, :, good],
            )
            if not place.shape[1]:
                return place
            step = -np.array(
                [_solved(jacobian[:, :, k], np.real(f[:, k])) for k in range(place.shape[1])]
            ).T
            place = place + step
    sure = np.abs(step).max(axis=0) <= 1e-9 * np.maximum(1e-12, np.abs(place).max(axis=0))
    return place[:, sure]


def _solved(matrix: Any, right: Any) -> Any:
    try:
        return np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError:
        return np.full(len(right), np.nan)


def _missed(
    drawn: Drawn,
    values: Values,
    contact: bool,
    states: Any,
    boxes: list[tuple[Any, Any]],
    region: Any,
    whole: bool,
    rng: Any,
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
        if any(
            ((root >= low - 1e-6 * size) & (root <= high + 1e-6 * size)).all()
            for low, high in boxes
        ):
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
                lambda *q: drawn.forces(q, [mp.mpf(0)] * len(q), p, mp, contact, mu),
                [mp.mpf(float(part)) for part in root],
                tol=mp.mpf(10) ** (-DIGITS),
                maxsteps=30,
            )
        except (
            ZeroDivisionError,
            ValueError,
            TypeError,
        ):  # the last one where no pivot is a number
            return False
        exact = list(exact) if isinstance(exact, mp.matrix) else [exact]
        if any(mp.im(part) != 0 for part in exact):
            return False
        near = all(
            abs(part - float(value)) <= 1e-6 * max(1, abs(part))
            for part, value in zip(exact, root, strict=True)
        )
        return near and (not drawn.lifts or (exact[1] < 0 if contact else exact[1] > 0))


# ------------------------------------------------------------------------------------------------
# motions


def field(drawn: Drawn, values: Values) -> Any:
    """The hand-written field as a whole, kinks and all."""
    n, masses = len(drawn.masses), np.array(drawn.inertia(values), dtype=float)

    def rhs(_: float, state: Any) -> Any:
        q, v = state[:n], state[n:]
        slip = values["V"] - v[0]
        mu = np.sign(slip) * drawn.friction(abs(slip), values, np)
        touching = not drawn.lifts or q[1] < 0
        return np.concatenate(
            [v, np.array(drawn.forces(q, v, values, np, touching, mu), dtype=float) / masses]
        )

    return rhs
