"""First Lyapunov coefficients against 50 digits of the same formula from equations written by hand, and against motions.

``python -m validation.criticality [POINTS] [SEED] [MOTIONS]``: every Hopf point of some searches on each shipped page, then of
random damped sets until so many points are compared; a Markdown table. Nothing generated stands behind the reference: the
accelerations below are written down from the mechanisms, the point is found again by Newton's method, and derivatives are mpmath's.
Then the sign against motions on both sides of the cycle that is born, for so many points. Exit code 1 if anything contradicts.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import mpmath
import numpy as np
from scipy import optimize

import spragsym as ss
from spragsym.errors import ConvergenceError

DIGITS = 50
#: Digits of Newton's method, and those of differences, whose steps are STEP: they are right to some 2 · 40 digits.
WORKING, FINE = 90, 210
STEP = mpmath.mpf("1e-40")

#: Page, parameter, other parameters, range.
SHIPPED: tuple[tuple[str, str, dict[str, float], tuple[float, float] | None], ...] = (
    ("stick_slip", "V", {}, None),
    ("stick_slip", "zeta", {}, None),
    ("stick_slip", "mu_s", {"V": 0.3}, None),
    ("damped", "mu0", {"theta0": 0.7}, None),
    ("damped", "mu0", {"theta0": 2.2}, None),
    ("damped", "zeta_x", {"theta0": 0.7, "mu0": 2.5}, None),
    ("kang_nam", "mu0", {"theta0": 0.7}, None),
    ("kang_nam", "sigma", {"theta0": 0.7}, (0.01, 2.0)),
    ("cubic_contact", "mu0", {"theta0": 0.7}, None),
    ("hertz_contact", "mu0", {"theta0": 0.7}, None),
    ("inclined_belt", "mu0", {"theta0": 0.7}, None),
    ("mode_coupling", "mu0", {}, None),
    ("two_springs", "theta0", {}, None),
    ("two_springs", "mu0", {"theta0": 1.0}, None),
    ("stribeck", "V", {"theta0": 0.7}, None),
    ("stribeck", "theta0", {"V": 0.02}, None),
    ("trolley", "theta0", {}, None),
)


# ------------------------------------------------------------------------------------------- equations by hand


def accelerations(page: str, P: Mapping[str, Any], u: Sequence[Any]) -> list[Any]:
    """Accelerations at the state u = (coordinates, rates), in contact, with the belt ahead; the law of friction passes through that
    of statics at steady sliding."""
    n = len(u) // 2
    x, vx = u[0], u[n]

    def mu(speed: Any) -> Any:
        if page == "stick_slip":
            return 2 * P["mu_s"] * speed * P["v_s"] / (speed**2 + P["v_s"] ** 2)
        creep = 1 - mpmath.exp(-P["d"] * speed)
        if page == "stribeck":
            return (P["mu_k"] + (P["mu_s"] - P["mu_k"]) * mpmath.exp(-speed / P["v_s"])) * creep
        return P["mu0"] * creep

    at_rest = mu(P["V"]) if page in ("stick_slip", "stribeck") else P["mu0"]
    friction = at_rest + mu(P["V"] - vx) - mu(P["V"])
    if page == "stick_slip":
        return [friction - x - P["zeta"] * vx]
    y, vy = u[1], u[n + 1]
    if page == "mode_coupling":
        lean = P["sigma"] * (x - y) / 2
        return [-P["alpha"] * x - lean - friction * y, -P["beta"] * y + lean - 1 - y]
    depth = -y
    pressed = {
        "cubic_contact": lambda: depth + P["gamma"] * depth**3,
        "hertz_contact": lambda: depth * mpmath.sqrt(depth),
        "soft_brake": lambda: depth + P["gamma"] * depth**2,
    }
    normal = pressed.get(page, lambda: depth)()
    fx, fy = friction * normal - P["alpha"] * x, normal - P.get("beta", 0) * y - P["kappa"]

    def spring(stiffness: Any, angle: Any, rest: Any, moved: Any = 0) -> tuple[Any, Any, Any, Any]:
        """The pull of a spring, and the cosine and sine of its direction."""
        dx, dy = rest * mpmath.cos(angle) + moved - x, rest * mpmath.sin(angle) - y
        length = mpmath.sqrt(dx**2 + dy**2)
        tension = stiffness * (length - rest)
        return tension * dx / length, tension * dy / length, dx / length, dy / length

    px, py, c, s = spring(P["sigma"], P["theta0"], 1, u[2] if page == "trolley" else 0)
    fx, fy = fx + px, fy + py
    if page == "soft_brake":  # the guide's page: a torsion spring turns with the inclined one, and rests at theta0
        dx, dy = mpmath.cos(P["theta0"]) - x, mpmath.sin(P["theta0"]) - y
        turned = -1j * mpmath.log((dx + 1j * dy) / (mpmath.cos(P["theta0"]) + 1j * mpmath.sin(P["theta0"])))
        turned = (turned + 1j * mpmath.log(mpmath.sqrt(dx**2 + dy**2))) * P["tau"] / (dx**2 + dy**2)
        fx, fy = fx - turned * dy, fy + turned * dx
    if page == "two_springs":
        qx, qy, _, _ = spring(P["sigma_2"], P["theta0_2"], P["lambda_2"])
        fx, fy = fx + qx, fy + qy
    if page == "inclined_belt":
        fx, fy = fx - P["gamma_g"] * mpmath.sin(P["psi"]), fy - P["gamma_g"] * mpmath.cos(P["psi"])
    if page == "damped":
        beside = P["zeta_s"] * (c * vx + s * vy)
        fx, fy = fx - P["zeta_x"] * vx - beside * c, fy - P["zeta_y"] * vy - beside * s
    return [fx, fy, (-P["alpha_a"] * u[2] - px) / P["nu_a"]] if page == "trolley" else [fx, fy]


# ------------------------------------------------------------------------------------------------ the reference


class Reference:
    """The Hopf point nearest to an onset, and its coefficient, to fifty digits."""

    def __init__(self, page: str, p: Mapping[str, float], state: Sequence[float], vary: str, omega: float) -> None:
        self.page, self.vary, self.n = page, vary, len(state)
        with mpmath.workdps(WORKING):
            self.P = {name: mpmath.mpf(value) for name, value in p.items()}
            self.omega = mpmath.mpf(omega)
            start = [mpmath.mpf(value) for value in (*state, p[vary])]
            found = mpmath.findroot(lambda *w: self._residual(w), start, tol=mpmath.mpf(10) ** (-2 * DIGITS), maxsteps=30)
            self.P[vary], self.rest = found[self.n], [found[i] for i in range(self.n)] + [mpmath.mpf(0)] * self.n
            self.lyapunov, self.crossing = self._lyapunov(), self._crossing()

    def _field(self, u: Sequence[Any]) -> list[Any]:
        return [*u[self.n :], *accelerations(self.page, self.P, u)]

    def _along(self, order: int, rest: Sequence[Any], direction: Sequence[Any]) -> list[Any]:
        """The form of that order with one vector in all places, by central differences."""
        places, weights = {
            1: ((1, -1), (0.5, -0.5)),
            2: ((1, 0, -1), (1, -2, 1)),
            3: ((2, 1, -1, -2), (0.5, -1, 1, -0.5)),
        }[order]
        with mpmath.workdps(FINE):
            fields = [self._field([u + k * STEP * v for u, v in zip(rest, direction, strict=True)]) for k in places]
            return [
                sum(w * value for w, value in zip(weights, values, strict=True)) / STEP**order
                for values in zip(*fields, strict=True)
            ]

    def _matrix(self, rest: Sequence[Any]) -> Any:
        size = 2 * self.n
        columns = [self._along(1, rest, [int(k == j) for k in range(size)]) for j in range(size)]
        return mpmath.matrix([list(row) for row in zip(*columns, strict=True)])

    def _root(self, rest: Sequence[Any]) -> Any:
        roots, _ = mpmath.eig(self._matrix(rest))
        return min(roots, key=lambda root: abs(root - 1j * self.omega))

    def _residual(self, w: Sequence[Any]) -> list[Any]:
        self.P[self.vary] = w[self.n]
        rest = [*w[: self.n], *[mpmath.mpf(0)] * self.n]
        return [*self._field(rest)[self.n :], self._root(rest).real]

    def _crossing(self) -> Any:
        """d Re λ / d parameter by a difference along the equilibrium."""
        value, step, parts = self.P[self.vary], mpmath.mpf(10) ** (-DIGITS // 2), []
        still = [mpmath.mpf(0)] * self.n
        for sign in (1, -1):
            self.P[self.vary] = value + sign * step
            found = mpmath.findroot(lambda *q: self._field([*q, *still])[self.n :], self.rest[: self.n])
            parts.append(self._root([*found, *still]).real)
        self.P[self.vary] = value
        return (parts[0] - parts[1]) / (2 * step)

    def _derivative(self, order: int, direction: Any) -> Any:
        return mpmath.matrix(self._along(order, self.rest, list(direction)))

    def _lyapunov(self) -> Any:
        A = self._matrix(self.rest)
        roots, left, right = mpmath.eig(A, left=True, right=True)
        k = min(range(2 * self.n), key=lambda i: abs(roots[i] - 1j * self.omega))
        omega, q, row = roots[k].imag, right[:, k], left[k, :]
        q = q / mpmath.sqrt(sum(abs(value) ** 2 for value in q))
        row = row / (row * q)[0]
        bar = q.apply(mpmath.conj)

        def B(a: Any, b: Any) -> Any:
            return (self._derivative(2, a + b) - self._derivative(2, a - b)) / 4

        cubic = (self._derivative(3, q + bar) - self._derivative(3, q - bar) - 2 * self._derivative(3, bar)) / 6
        mean = mpmath.lu_solve(A, B(q, bar))
        twice = mpmath.lu_solve(2j * omega * mpmath.eye(2 * self.n) - A, B(q, q))
        return ((row * (cubic - 2 * B(q, mean) + B(bar, twice)))[0] / (2 * omega)).real


def reference_of(onsets: Any, row: int) -> Reference:
    """The reference of one of the onsets."""
    model = onsets.parameters.model
    p = {name: float(getattr(onsets, name)[row]) for name in model.parameters}
    return Reference(
        model.name, p, [float(getattr(onsets, name)[row]) for name in model.coordinates], onsets.vary[0], float(onsets.omega[row])
    )  # fmt: skip


# ------------------------------------------------------------------------------------------------- the campaign


def shipped() -> Iterator[Any]:
    """The onsets of the searches on shipped pages."""
    for name, vary, others, span in SHIPPED:
        model = ss.load(name)
        yield ss.flutter_onsets(model.Parameters(**others), vary=vary, **({"between": {vary: span}} if span else {}))


def random_onsets(rng: np.random.Generator) -> Iterator[Any]:
    """Onsets of random damped sets over several decades."""
    model = ss.load("damped")
    while True:
        values = {
            "theta0": rng.uniform(0.15, 3.0), "kappa": 10 ** rng.uniform(-3, 0), "alpha": 10 ** rng.uniform(-3, 0.2),
            "sigma": 10 ** rng.uniform(-1.5, 0.7), "beta": rng.choice([0.0, 10 ** rng.uniform(-2, 0.5)]),
            "V": rng.uniform(0.05, 1.0), "d": 10 ** rng.uniform(0.3, 1.5), "mu0": 10 ** rng.uniform(-1, 0.7),
        }  # fmt: skip
        values |= {name: 10 ** rng.uniform(-3, -0.5) for name in ("zeta_x", "zeta_y", "zeta_s")}
        vary = str(rng.choice(["mu0", "theta0", "sigma", "alpha"]))
        span = {"mu0": (0.0, 8.0), "theta0": (0.1, 3.04), "sigma": (0.02, 6.0), "alpha": (0.0, 3.0)}[vary]
        yield ss.flutter_onsets(model.Parameters(**values), vary=vary, between={vary: span})


def main(points: int = 300, seed: int = 30, motions: int = 12) -> int:
    """Print the table; exit code 1 if a bound does not hold or a motion contradicts."""
    rng = np.random.default_rng(seed)
    print(
        "| | onsets | gentle | dangerous | undecided | bounds hold | largest bound / size | largest distance / bound | ms each |"
    )
    print("|---|---|---|---|---|---|---|---|---|")
    wrong, seen = 0, []
    for title, many, enough in (("shipped pages", shipped(), 10**9), ("random damped sets", random_onsets(rng), points)):
        count, held, sharp, far, spent, told = 0, 0, 0.0, 0.0, 0.0, dict.fromkeys(("gentle", "dangerous", "undecided"), 0)
        for onsets in many:
            begin = time.process_time()
            known = np.isfinite(onsets.lyapunov)
            spent += time.process_time() - begin
            for row in range(len(onsets)):
                count, told[onsets.criticality[row]] = count + 1, told[onsets.criticality[row]] + 1
                if not known[row]:
                    continue
                exact, bound = reference_of(onsets, row), float(onsets.lyapunov_error[row])
                off = abs(float(exact.lyapunov - mpmath.mpf(float(onsets.lyapunov[row]))))
                aside = abs(float(exact.crossing - mpmath.mpf(float(onsets.crossing[row]))))
                fine = off <= bound and aside <= onsets.crossing_error[row]
                held, wrong = held + fine, wrong + (not fine)
                far = max(far, off / bound)
                if onsets.criticality[row] != "undecided":
                    sharp = max(sharp, bound / abs(float(exact.lyapunov)))
                    seen.append((onsets, row))
                if not fine:
                    print(f"{onsets.parameters.model.name} {onsets.vary} {row}: {off:.2e} of {bound:.2e}", file=sys.stderr)
            if count >= enough:
                break
        kinds = " | ".join(str(told[name]) for name in ("gentle", "dangerous", "undecided"))
        print(
            f"| {title} | {count} | {kinds} | {held} | {sharp:.1e} | {far:.2g} | {1e3 * spent / max(count, 1):.1f} |", flush=True
        )
    wrong += _by_motions(seen, motions)
    return int(wrong > 0)


def _by_motions(seen: Sequence[tuple[Any, int]], motions: int) -> int:
    """How many signs are contradicted by motions from inside and outside of the cycle that is born; prints a table."""
    rows, wrong = [], 0
    for onsets, row in reversed(seen):
        if len(rows) >= motions:
            break
        told = against_motions(onsets, row)
        if told is None:
            continue
        wrong += told != onsets.criticality[row]
        rows.append((onsets.parameters.model.name, onsets.vary[0], onsets.criticality[row], told))
    gentle = sum(row[2] == "gentle" for row in rows)
    print(f"\n{len(rows)} against motions, {gentle} of them gentle: {wrong} contradict.")
    return wrong


def against_motions(onsets: Any, row: int, longest: float = 20_000.0) -> str | None:
    """``"gentle"`` where motions from inside and outside come towards the cycle that is born, ``"dangerous"`` where both leave it;
    None where that takes too long, or where another pair of the state grows."""
    form = onsets.normal_forms[row]
    n = len(form.q) // 2
    try:
        cycle = onsets.cycle(row)
    except ConvergenceError:
        return None
    model, field, constants = onsets.parameters.model, cycle.field, cycle.loop.constants
    p = model.Parameters(**cycle.parameters)

    def still(q: Any) -> Any:
        u = [*q.tolist(), *[0.0] * n]
        return field.acceleration(u, constants, field.mode_at_rest(u, constants), math)

    found = optimize.root(still, cycle.samples.states[:n].mean(axis=1), tol=1e-13)
    if not found.success:
        return None
    rest = np.append(found.x, np.zeros(n))
    rate = 2 * form.omega * abs(form.lyapunov) * abs(form.p.conjugate() @ (cycle.state - rest)) ** 2
    span = 3.0 / rate
    others = np.abs(cycle.multipliers[1:])
    if span > longest or (np.sort(others)[:-1] > 0.999).any() or (len(others) > 1 and np.sort(others)[-2] > 0.999):
        return None
    ends = []
    for share in (0.8, 1.1):
        tr = ss.simulate(p, start=rest + share * (cycle.state - rest), t_end=span)
        late = tr.state[:, tr.t > span - 2 * cycle.period]
        early = tr.state[:, tr.t < 2 * cycle.period]
        size = [np.abs(form.p.conjugate() @ (part - rest[:, None])).mean() for part in (early, late)]
        ends.append(size[1] - size[0])
    return "gentle" if ends[0] > 0 > ends[1] else "dangerous" if ends[0] < 0 < ends[1] else "neither"


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
