"""Pages at random against mechanics assembled from their energies in numbers.

A page is carried through, or refused by a line of its own. Energies, dampers, loads, gap and laws
are evaluated as they are written; forces, masses, stiffnesses and damping follow by complex steps
and by differences in 40 digits. Of each page are asked

- accelerations at random states, on both sides of the gap and of the sliding speed;
- the states of some parameter sets, in contact and in lift-off: each solves the reference, on its
  side of the gap, and Newton's method from many starts finds none that is neither listed, nor in an
  undecided box, nor outside of what was searched, where that is said;
- the growth of each state with damping, by the eigenvalues of the reference;
- the onsets of flutter along one parameter: at each that is listed a pair of eigenvalues of the
  reference lies on the imaginary axis, and where a map of eigenvalues, of states of the reference
  followed over that range, shows that a pair has crossed it, one is listed.
"""

import itertools
import re
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np

import spragsym as ss
from validation.page_writer import Drawn, draw

CASES = 60

#: Parameter sets of a page, states at which accelerations are compared, starts of Newton's method
#: and its steps.
SETS, PLACES, STARTS, STEPS = 3, 6, 300, 60
DIGITS = 40
#: Relative differences that rounding may make, of accelerations and of growth.
ACCELERATION, GROWTH = 1e-9, 1e-6
#: Nearer than this to its border, a state may be on either side.
EDGE = 1e-9
#: Values of the parameter along which onsets are asked for, its range as shares of a value, and how
#: clearly eigenvalues grow.
VALUES, SPAN, CLEAR = 13, (0.05, 4.0), 1e-6
_TINY = 1e-30


class Reference:
    """The mechanics of a page in numbers: of numpy, complex for derivatives by complex steps, or of
    mpmath.

    A state has the coordinates along its first axis; further axes are points.
    """

    def __init__(self, page: Drawn, values: dict[str, float], exact: bool = False) -> None:
        self.page, self.exact = page, exact
        number: Callable[[float], Any] = mp.mpf if exact else float
        xp: Any = mp if exact else np
        self.names: dict[str, Any] = {
            name: getattr(xp, name)
            for name in ("exp", "log", "sqrt", "cos", "sin", "tanh", "atan" if exact else "arctan")
        }
        self.names |= {
            "atan": self.names.pop("arctan", None) or mp.atan,
            "pi": xp.pi,
            "m": 1,
            "k_c": 1,
            "L_0": 1,
        }
        self.names |= {
            "sgn": lambda u: np.sign(np.real(u)) if not exact else mp.sign(u),
            "Abs": self._abs,
        }
        self.names |= {name: number(value) for name, value in values.items()}
        self.n = len(page.coordinates)

    def _abs(self, u: Any) -> Any:
        return abs(u) if self.exact else np.where(np.real(u) < 0, -1, 1) * u

    def of(self, text: str, q: Sequence[Any], **more: Any) -> Any:
        """A part of the page at a place."""
        known = {name: value for (name, _), value in zip(self.page.coordinates, q, strict=True)}
        # our own text
        return eval(_compiled(text), {"__builtins__": {}}, self.names | known | more) + 0 * q[0]  # noqa: S307

    # ---------------------------------------------------------------------------------------------
    # derivatives

    def slopes(self, function: Callable[[Sequence[Any]], Any], q: Sequence[Any]) -> list[Any]:
        """Derivatives by the coordinates."""
        found = []
        for place in range(self.n):
            if self.exact:
                h = mp.mpf(10) ** (-mp.mp.dps // 3)
                up, down = (
                    function([part + sign * h * (i == place) for i, part in enumerate(q)])
                    for sign in (1, -1)
                )
                found.append((up - down) / (2 * h))
            else:
                moved = [part + 1j * _TINY * (i == place) for i, part in enumerate(q)]
                found.append(np.imag(function(moved)) / _TINY)
        return found

    def rows(
        self, function: Callable[[Sequence[Any]], Sequence[Any]], q: Sequence[Any], h: Any
    ) -> list[list[Any]]:
        """Derivatives of several functions by central differences: a row for each function."""
        columns = []
        for place in range(self.n):
            up, down = (
                function([part + sign * h * (i == place) for i, part in enumerate(q)])
                for sign in (1, -1)
            )
            columns.append([(a - b) / (2 * h) for a, b in zip(up, down, strict=True)])
        return [[column[row] for column in columns] for row in range(self.n)]

    # ---------------------------------------------------------------------------------------------
    # energies and forces

    def potential(self, q: Sequence[Any]) -> Any:
        """Of springs and potentials."""
        total = 0 * q[0]
        for k, along, length in self.page.springs:
            total = (
                total
                + self.of(k, q)
                * (self.of(along, q) - (self.of(length, q) if length else 0)) ** 2
                / 2
            )
        for k, a, b, length in self.page.lines:
            total = (
                total
                + self.of(k, q)
                * (self.names["sqrt"](self._square(a, b, q)) - self.of(length, q)) ** 2
                / 2
            )
        for k, a, b, rest in self.page.torsions:
            total = total + self.of(k, q) * self._turn(a, b, rest, q) ** 2 / 2
        for energy in self.page.potentials:
            total = total + self.of(energy, q)
        return total

    def _square(self, a: Any, b: Any, q: Sequence[Any]) -> Any:
        return (self.of(b[0], q) - self.of(a[0], q)) ** 2 + (
            self.of(b[1], q) - self.of(a[1], q)
        ) ** 2

    def _turn(self, a: Any, b: Any, rest: str, q: Sequence[Any]) -> Any:
        """The least turning of a line, by the tangent of its half."""
        dx, dy = self.of(b[0], q) - self.of(a[0], q), self.of(b[1], q) - self.of(a[1], q)
        c, s = self.names["cos"](self.of(rest, q)), self.names["sin"](self.of(rest, q))
        x, y = dx * c + dy * s, dy * c - dx * s
        return 2 * self.names["atan"](y / (self.names["sqrt"](x * x + y * y) + x))

    def gap(self, q: Sequence[Any]) -> Any:
        return self.of(self.page.contact[0], q) if self.page.contact else -1 + 0 * q[0]

    def normal(self, q: Sequence[Any], touching: Any) -> Any:
        """The normal force where the contact acts."""
        if self.page.normal:
            return self.of(self.page.normal, q)
        if not self.page.contact:
            return 0 * q[0]
        depth = -self.gap(q)
        if self.exact:
            return self.of(self.page.contact[1], q, depth=depth) if touching else 0 * q[0]
        return np.where(
            touching, self.of(self.page.contact[1], q, depth=np.where(touching, depth, 1.0)), 0.0
        )

    def forces(self, q: Sequence[Any], touching: Any, mu: Any) -> list[Any]:
        """At rest, with a friction coefficient."""
        total = [-slope for slope in self.slopes(self.potential, q)]
        for parts, places in self.page.forces:
            for part, place in zip(parts, places, strict=True):
                along = self.slopes(lambda at, place=place: self.of(place, at), q)
                total = [
                    force + self.of(part, q) * slope
                    for force, slope in zip(total, along, strict=True)
                ]
        push = self.normal(q, touching)
        if self.page.contact:
            total = [
                force + push * slope
                for force, slope in zip(total, self.slopes(self.gap, q), strict=True)
            ]
        if self.page.friction:
            total = [
                force + mu * self.pressed(push) * slope
                for force, slope in zip(total, self.slide(q), strict=True)
            ]
        return total

    def pressed(self, push: Any) -> Any:
        """What rubs: what never lifts presses on the one face or on the other."""
        lifts = self.page.contact and self.page.contact[2]
        return push if lifts else self._abs(push)

    def slide(self, q: Sequence[Any]) -> list[Any]:
        return (
            self.slopes(lambda at: self.of(self.page.friction[0], at), q)
            if self.page.friction
            else [0 * part for part in q]
        )

    def friction(self, v: Any) -> Any:
        return (
            self.of(self.page.friction[2], [v * 0] * self.n, v=v) if self.page.friction else 0 * v
        )

    def belt(self) -> Any:
        return self.names[self.page.friction[1]] if self.page.friction else 0

    def at_rest(self) -> Any:
        """The friction coefficient of the states."""
        if not self.page.friction:
            return 0
        zero = [self.belt() * 0] * self.n
        return (
            self.of(self.page.friction[3], zero)
            if self.page.friction[3]
            else self.friction(self.belt())
        )

    def damping(self, q: Sequence[Any], touching: Any) -> list[list[Any]]:
        """C of the dampers alone."""
        C = [[0 * q[0]] * self.n for _ in range(self.n)]
        ways = [
            (c, self.slopes(lambda at, along=along: self.of(along, at), q))
            for c, along in self.page.dampers
        ]
        for c, a, b in self.page.line_dampers:
            ways.append(
                (c, self.slopes(lambda at, a=a, b=b: self.names["sqrt"](self._square(a, b, at)), q))
            )
        for c, way in ways:
            C = [
                [C[i][j] + self.of(c, q) * way[i] * way[j] for j in range(self.n)]
                for i in range(self.n)
            ]
        return C

    def mass(self, q: Sequence[Any]) -> list[list[Any]]:
        M = [[0 * q[0]] * self.n for _ in range(self.n)]
        for mass, parts in self.page.kinetic:
            for part in parts:
                way = self.slopes(lambda at, part=part: self.of(part, at), q)
                M = [
                    [M[i][j] + self.of(mass, q) * way[i] * way[j] for j in range(self.n)]
                    for i in range(self.n)
                ]
        return M

    def accelerations(self, q: Sequence[Any], v: Sequence[Any]) -> Any:
        """M q″ + d(M)/dt v − ∂T/∂q = forces, in mpmath."""
        touching = self.gap(q) <= 0 or not self.page.contact or not self.page.contact[2]
        slip = self.belt() - sum(s * rate for s, rate in zip(self.slide(q), v, strict=True))
        pull = self.forces(q, touching, self.friction(slip))
        C, h = self.damping(q, touching), mp.mpf(10) ** (-mp.mp.dps // 4)
        changes = [
            [
                [(a - b) / (2 * h) for a, b in zip(*rows, strict=True)]
                for rows in zip(*pair, strict=True)
            ]
            for pair in (
                [
                    self.mass([part + sign * h * (i == place) for i, part in enumerate(q)])
                    for sign in (1, -1)
                ]
                for place in range(self.n)
            )
        ]  # of every coordinate
        right = []
        for i in range(self.n):
            value = pull[i] - sum(C[i][j] * v[j] for j in range(self.n))
            for j, k in itertools.product(range(self.n), repeat=2):
                value -= (changes[k][i][j] - changes[i][j][k] / 2) * v[j] * v[k]
            right.append(value)
        return mp.lu_solve(mp.matrix(self.mass(q)), mp.matrix(right))

    def eigenvalues(self, q: Sequence[Any], touching: bool) -> list[Any]:
        """Of the linearization with damping."""
        mu, h = self.at_rest(), mp.mpf(10) ** (-mp.mp.dps // 4)
        K = self.rows(lambda at: [-force for force in self.forces(at, touching, mu)], q, h)
        C = self.damping(q, touching)
        if self.page.friction:
            v = self.belt()
            step = mp.mpf(10) ** (-mp.mp.dps // 4) * (v if v > 0 else 1)
            slope = (
                (self.friction(v + step) - self.friction(v + step / 2)) / (step / 2)
                if v == 0
                else (self.friction(v + step) - self.friction(v - step)) / (2 * step)
            )
            s, push = self.slide(q), self.normal(q, touching)
            C = [
                [C[i][j] + self.pressed(push) * slope * s[i] * s[j] for j in range(self.n)]
                for i in range(self.n)
            ]
        M = mp.matrix(self.mass(q))
        n = self.n
        A = mp.zeros(2 * n)
        for i in range(n):
            A[i, n + i] = 1
        for block, start in ((K, 0), (C, n)):
            solved = mp.inverse(M) * mp.matrix(block)
            for i, j in itertools.product(range(n), repeat=2):
                A[n + i, start + j] = -solved[i, j]
        return list(mp.eig(A, left=False, right=False))


_CODE: dict[str, Any] = {}


def _compiled(text: str) -> Any:
    return _CODE.setdefault(text, compile(text, "<page>", "eval"))


# ------------------------------------------------------------------------------------------------
# comparisons


def sets(model: Any, page: Drawn, rng: np.random.Generator) -> list[dict[str, float]]:
    """The base values, and values around them; now and then 0 where it is allowed."""
    found = [dict(model.base)]
    for _ in range(SETS - 1):
        values = {}
        for name, base in model.base.items():
            allowed = model.Parameters.ranges[name]
            value = (
                base
                * float(np.exp(rng.uniform(-0.7, 0.7)))
                * (rng.choice([-1, 1]) if allowed.contains(-base) else 1)
            )
            values[name] = (
                0.0
                if rng.random() < 0.05 and allowed.contains(0.0)
                else value
                if allowed.contains(value)
                else base
            )
        found.append(values)
    return found


def accelerated(
    model: Any, page: Drawn, values: dict[str, float], rng: np.random.Generator
) -> list[str]:
    """Where accelerations differ."""
    wrong = []
    p = model.Parameters(**values)
    given = [float(value) for value in model.arguments(p, "motion")]
    n = len(page.coordinates)
    with mp.workdps(DIGITS):
        reference = Reference(page, values, exact=True)
        for _ in range(PLACES):
            q, v = rng.uniform(-0.8, 0.8, n), rng.uniform(-0.6, 0.6, n)
            got = np.array(model.algebra.rhs(*q, *v, *given), dtype=float)
            want = np.array(
                [
                    float(value)
                    for value in reference.accelerations(
                        list(map(mp.mpf, map(float, q))), list(map(mp.mpf, map(float, v)))
                    )
                ]
            )
            scale = 1 + np.abs(want).max()
            if not np.abs(got - want).max() <= ACCELERATION * scale:
                wrong.append(
                    f"accelerations at {q.tolist()}, {v.tolist()}: {got.tolist()}, not "
                    f"{want.tolist()}"
                )
    return wrong


def states(
    model: Any, page: Drawn, values: dict[str, float], contact: bool, rng: np.random.Generator
) -> tuple[list[str], dict[str, Any]]:
    """What is wrong with the states of one set, and what was found."""
    # What never lifts may press on either of its faces.
    faces = page.contact and not page.contact[2]
    found = ss.equilibria(model.Parameters(**values), contact=None if faces else contact)
    count = int(found.count)
    listed = np.array([found.coordinates[name] for name in model.coordinates], dtype=float)[
        :, :count
    ].T
    wrong: list[str] = []
    touching = contact or not page.contact
    with mp.workdps(DIGITS):
        exact = Reference(page, values, exact=True)
        mu = exact.at_rest()
        for state, error, growth in zip(listed, found.error, found.growth, strict=False):
            wrong += _off(exact, state, float(error), float(growth), contact, touching, mu)
    boxes = [
        (np.array(box.low, dtype=float), np.array(box.high, dtype=float)) for box in found.undecided
    ]
    wrong += _missed(page, values, contact, touching, listed, boxes, found, rng)
    told = {"count": count, "complete": bool(found.complete), "boxes": len(boxes)}
    return wrong, told


def _off(
    exact: Reference,
    state: Any,
    error: float,
    growth: float,
    contact: bool,
    touching: bool,
    mu: Any,
) -> list[str]:
    """What is wrong with a listed state."""
    start = [mp.mpf(float(value)) for value in state]
    q = _solved(exact, start, touching, mu)
    if q is None:
        return [f"{state.tolist()}: the reference has no regular state there"]
    away = max(abs(a - b) / max(1, abs(a)) for a, b in zip(q, start, strict=True))
    if not away <= error * (1 + mp.mpf(10) ** -6) + mp.mpf(10) ** -16:
        return [
            f"{state.tolist()} is {mp.nstr(away, 3)} from a state of the reference, its error "
            f"is {error:.2g}"
        ]
    wrong = []
    gap = exact.gap(q)
    if (
        exact.page.contact
        and exact.page.contact[2]
        and ((gap > EDGE) if contact else (gap < -EDGE))
    ):
        wrong.append(
            f"{state.tolist()}, {'contact' if contact else 'lift-off'}: its gap is "
            f"{mp.nstr(gap, 5)}"
        )
    roots = exact.eigenvalues(q, touching)
    want, size = float(max(map(mp.re, roots))), float(max(map(abs, roots)))
    if not abs(growth - want) <= GROWTH * (size + abs(want)) ** 1.0 * (
        1 if abs(want) > 1e-4 * size else 1e2
    ):
        wrong.append(f"{state.tolist()}: grows by {growth}, not {want}")
    return wrong


def _solved(exact: Reference, q: Sequence[Any], touching: bool, mu: Any) -> list[Any] | None:
    """The state of the reference that Newton's method finds from a place."""
    q = list(q)
    for _ in range(8):
        F = exact.forces(q, touching, mu)
        K = exact.rows(lambda at: exact.forces(at, touching, mu), q, mp.mpf(10) ** (-DIGITS // 4))
        try:
            step = mp.lu_solve(mp.matrix(K), mp.matrix(F))
        except ZeroDivisionError:
            return None
        q = [part - change for part, change in zip(q, step, strict=True)]
    return None if any(mp.im(part) for part in q) else q  # complex beyond where a law is defined


def onsets(
    model: Any, page: Drawn, values: dict[str, float], rng: np.random.Generator
) -> tuple[list[str], dict[str, Any]]:
    """What is wrong with the onsets along one parameter, and what was found."""
    vary = (
        "mu0"
        if "mu0" in model.base and rng.random() < 0.5
        else str(rng.choice([name for name, base in model.base.items() if base]))
    )
    allowed = model.Parameters.ranges[vary]
    low, high = sorted(share * model.base[vary] for share in SPAN)
    inside = 1e-3 * (high - low)  # an end may not belong to its range
    low, high = max(low, allowed.low + inside), min(high, allowed.high - inside)
    found = ss.flutter_onsets(model.Parameters(**values), vary, between={vary: (low, high)})
    at = np.asarray(getattr(found, vary), dtype=float)
    places = np.array([getattr(found, name) for name in model.coordinates], dtype=float)
    wrong = []
    with mp.workdps(DIGITS):
        for value, q, kind in zip(at, places.T, found.kind, strict=True):
            exact = Reference(page, {**values, vary: float(value)}, exact=True)
            state = _solved(exact, [mp.mpf(float(part)) for part in q], True, exact.at_rest())
            roots = [] if state is None else exact.eigenvalues(state, True)
            size = max(map(abs, roots), default=1)
            # Where two frequencies meet, roots move as the square root of what is rounded.
            near = CLEAR if kind == "hopf" else 1e-4
            if not any(
                abs(mp.re(root)) < near * size and abs(mp.im(root)) > CLEAR * size for root in roots
            ):
                wrong.append(
                    f"onset at {vary} = {value!r}, {q.tolist()} ({kind}): no pair on the axis"
                )
    followed = _map_of_eigenvalues(model, page, values, vary, np.linspace(low, high, VALUES))
    crossed = 0
    for branch in followed:
        for (one, q, grows), (two, _, then) in itertools.pairwise(branch):
            if grows is None or then is None or (grows - then) % 2 or grows == then:
                continue
            crossed += 1
            inside = (np.array(found.region[:-1, 0]) <= q).all() and (
                q <= np.array(found.region[:-1, 1])
            ).all()
            if found.decided and inside and not ((at >= one) & (at <= two)).any():
                wrong.append(
                    f"missed: a pair crosses the axis between {vary} = {one!r} and {two!r}, "
                    f"near {q.tolist()}"
                )
    return wrong, {
        "count": len(at),
        "complete": bool(found.complete),
        "boxes": len(found.undecided),
        "crossed": crossed,
    }


def _map_of_eigenvalues(
    model: Any, page: Drawn, values: dict[str, float], vary: str, along: Any
) -> list[list[tuple[float, Any, int | None]]]:
    """States that are followed: the value, the place, and how many eigenvalues grow; None where
    that is not clear.
    """
    first = ss.equilibria(model.Parameters(**{**values, vary: float(along[0])}))
    starts = np.array([first.coordinates[name] for name in model.coordinates], dtype=float)[
        :, : int(first.count)
    ].T
    branches = []
    with mp.workdps(DIGITS):
        for start in starts:
            branch: list[tuple[float, Any, int | None]] = []
            q: list[Any] | None = [mp.mpf(float(part)) for part in start]
            for value in along:
                exact = Reference(page, {**values, vary: float(value)}, exact=True)
                before = q
                q = _solved(exact, before or [], True, exact.at_rest())
                far = q is None or max(
                    abs(a - b) for a, b in zip(q, before or [], strict=True)
                ) > mp.mpf("0.2")
                if q is None or far or (page.contact and page.contact[2] and exact.gap(q) > -EDGE):
                    break
                roots = exact.eigenvalues(q, True)
                size = max(map(abs, roots))
                clear = all(
                    abs(mp.re(root)) > CLEAR * size or abs(mp.re(root)) < mp.mpf(10) ** -12 * size
                    for root in roots
                )
                grows = sum(mp.re(root) > CLEAR * size for root in roots)
                branch.append(
                    (
                        float(value),
                        np.array([float(part) for part in q]),
                        int(grows) if clear else None,
                    )
                )
            branches.append(branch)
    return branches


def _missed(
    page: Drawn,
    values: dict[str, float],
    contact: bool,
    touching: bool,
    listed: Any,
    boxes: Any,
    found: Any,
    rng: np.random.Generator,
) -> list[str]:
    """States that Newton's method finds from many starts, and that are not there."""
    reference = Reference(page, values)
    n, mu = reference.n, reference.at_rest()
    place = rng.normal(size=(n, STARTS)) * np.exp(rng.uniform(-4, 1.5, STARTS))
    for i, (_, unit) in enumerate(page.coordinates):
        if unit == "rad":
            place[i] = rng.uniform(-3.1, 3.1, STARTS)
    mask = np.ones(STARTS, dtype=bool) if touching else np.zeros(STARTS, dtype=bool)

    def forces(at: Any) -> list[Any]:
        return [
            np.broadcast_to(np.real(force), mask.shape)
            for force in reference.forces(list(at), mask, mu)
        ]

    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            F = np.array(forces(place))
            K = np.array(reference.rows(forces, list(place), 1e-6))
            good = np.isfinite(K).all(axis=(0, 1)) & np.isfinite(F).all(axis=0)
            K[:, :, ~good] = np.eye(n)[:, :, None]
            F = np.where(good, F, 0.0)
            K += 1e-14 * np.eye(n)[:, :, None]
            step = np.linalg.solve(np.moveaxis(K, 2, 0), F.T[:, :, None])[:, :, 0].T
            place = place - np.clip(step, -1.0, 1.0)
        left = np.abs(forces(place)).max(axis=0)
        gap = np.broadcast_to(np.real(reference.gap(list(place))), mask.shape)
    good = (left < 1e-11) & (np.abs(place).max(axis=0) < 1e3)
    if page.contact and page.contact[2]:
        good &= (gap < -1e-7) if contact else (gap > 1e-7)
    wrong: list[str] = []
    seen: list[Any] = []
    around = found.parameters.model.whole_turns

    def less_turns(off: Any) -> Any:
        """Rows of places or differences, less whole turns."""
        for angle, moved in around.items():
            whole = 2 * np.pi * np.round(off[..., angle, None] / (2 * np.pi))
            off = off - whole * [moved.get(k, 0) for k in range(n)]
        return off

    region = np.array(found.region, dtype=float)
    for q in place[:, good].T:
        turned = less_turns(q)
        if any(np.abs(turned - one).max() < 1e-5 for one in seen):
            continue
        seen.append(turned)
        apart = less_turns(listed - turned) if len(listed) else listed
        if len(listed) and (np.abs(apart).max(axis=1) < 1e-5 * (1 + np.abs(turned).max())).any():
            continue
        if any(
            (np.abs(less_turns(turned - (low + high) / 2)) <= (high - low) / 2 + 1e-6).all()
            for low, high in boxes
        ):
            continue
        inside = (turned >= region[:, 0] - 1e-9).all() and (turned <= region[:, 1] + 1e-9).all()
        if not inside and not found.complete:
            continue
        if not inside and not getattr(found, "whole", True):
            continue
        wrong.append(
            f"missed {'in contact' if contact else 'in lift-off'}: {turned.tolist()} "
            f"(complete {found.complete})"
        )
    return wrong[:3]


# ------------------------------------------------------------------------------------------------
# pages


def judged(seed: int, number: int) -> dict[str, Any]:
    """The outcome of one page."""
    from spragsym.derive import folder
    from spragsym.derive.model import PageError

    page = draw(seed, number)
    rng = np.random.default_rng([seed, number, 1])
    begin = time.process_time()
    out: dict[str, Any] = {"page": number, "n": len(page.coordinates)}
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / f"page{number}.py"
        path.write_text(page.text(), encoding="utf-8")
        try:
            folder.write_page(path, Path(place) / "out")
        except PageError as error:
            return {
                **out,
                "kind": "refused",
                "said": re.sub(r"line \d+", "line …", str(error)),
                "line": error.line,
            }
        out["derived"] = round(time.process_time() - begin, 2)
        model = ss.load(Path(place) / "out")
        wrong: list[str] = []
        told: list[Any] = []
        for values in sets(model, page, rng):
            wrong += accelerated(model, page, values, rng)
            lifts = bool(page.contact and page.contact[2])
            for contact in (True, False)[: 1 + lifts]:
                more, one = states(model, page, values, contact, rng)
                wrong += [f"{text} at {values}" for text in more]
                told.append(one)
        more, crossings = onsets(model, page, dict(model.base), rng)
        wrong += more
    return {
        **out,
        "kind": "wrong" if wrong else "right",
        "wrong": wrong[:6],
        "states": told,
        "onsets": crossings,
        "seconds": round(time.process_time() - begin, 1),
    }
