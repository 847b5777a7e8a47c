"""First Lyapunov coefficients to 50 digits from equations written by hand, and their signs by
motions.

Nothing generated stands behind the reference: forces are written down from the drawings, the point
is found again by Newton's method, and derivatives are mpmath's.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import mpmath
import numpy as np
from scipy import optimize

import spragsym as ss
from spragsym.core.errors import ConvergenceError
from tests.oracles.forces_by_hand import DRAWN, Values

DIGITS = 50
#: Digits of Newton's method, and those of differences, whose steps are STEP: they are right to some
#: 2 · 40 digits.
WORKING, FINE = 90, 210
STEP = mpmath.mpf("1e-40")


def accelerations(page: str, P: Values, u: Sequence[Any]) -> list[Any]:
    """Accelerations at the state u = (coordinates, rates), in contact, with the belt ahead; the law
    of friction passes through that of statics at steady sliding.
    """
    drawn, n = DRAWN[page], len(u) // 2
    steady, ahead = (drawn.friction(speed, P, mpmath) for speed in (P["V"], P["V"] - u[n]))
    friction = drawn.static_friction(P, mpmath) + ahead - steady
    forces = drawn.forces(u[:n], u[n:], P, mpmath, True, friction)
    return [force / mass for force, mass in zip(forces, drawn.inertia(P), strict=True)]


# ------------------------------------------------------------------------------------------------
# the reference


class Reference:
    """The Hopf point nearest to an onset, and its coefficient, to fifty digits."""

    def __init__(
        self, page: str, p: Mapping[str, float], state: Sequence[float], vary: str, omega: float
    ) -> None:
        self.page, self.vary, self.n = page, vary, len(state)
        with mpmath.workdps(WORKING):
            self.P = {name: mpmath.mpf(value) for name, value in p.items()}
            self.omega = mpmath.mpf(omega)
            start = [mpmath.mpf(value) for value in (*state, p[vary])]
            found = mpmath.findroot(
                lambda *w: self._residual(w),
                start,
                tol=mpmath.mpf(10) ** (-2 * DIGITS),
                maxsteps=30,
            )
            self.P[vary], self.rest = (
                found[self.n],
                [found[i] for i in range(self.n)] + [mpmath.mpf(0)] * self.n,
            )
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
            fields = [
                self._field([u + k * STEP * v for u, v in zip(rest, direction, strict=True)])
                for k in places
            ]
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
            found = mpmath.findroot(
                lambda *q: self._field([*q, *still])[self.n :], self.rest[: self.n]
            )
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

        cubic = (
            self._derivative(3, q + bar)
            - self._derivative(3, q - bar)
            - 2 * self._derivative(3, bar)
        ) / 6
        mean = mpmath.lu_solve(A, B(q, bar))
        twice = mpmath.lu_solve(2j * omega * mpmath.eye(2 * self.n) - A, B(q, q))
        return ((row * (cubic - 2 * B(q, mean) + B(bar, twice)))[0] / (2 * omega)).real


def reference_of(onsets: Any, row: int) -> Reference:
    """The reference of one of the onsets."""
    model = onsets.parameters.model
    p = {name: float(getattr(onsets, name)[row]) for name in model.parameters}
    return Reference(
        model.name,
        p,
        [float(getattr(onsets, name)[row]) for name in model.coordinates],
        onsets.vary[0],
        float(onsets.omega[row]),
    )


def against_motions(onsets: Any, row: int, longest: float = 20_000.0) -> str | None:
    """``"supercritical"`` where motions from inside and outside come towards the cycle that is born,
    ``"subcritical"`` where both leave it; None where that takes too long, or where another pair of
    the state grows.
    """
    form = onsets.normal_forms[row]
    n = len(form.q) // 2
    try:
        cycle = ss.cycle(onset=onsets, index=row)
    except ConvergenceError:
        return None
    model, field, constants = onsets.parameters.model, cycle.field, cycle.orbit.constants
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
    if (
        span > longest
        or (np.sort(others)[:-1] > 0.999).any()
        or (len(others) > 1 and np.sort(others)[-2] > 0.999)
    ):
        return None
    ends = []
    for share in (0.8, 1.1):
        tr = ss.simulate(p, start=rest + share * (cycle.state - rest), t_end=span)
        late = tr.state[:, tr.t > span - 2 * cycle.period]
        early = tr.state[:, tr.t < 2 * cycle.period]
        size = [
            np.abs(form.p.conjugate() @ (part - rest[:, None])).mean() for part in (early, late)
        ]
        ends.append(size[1] - size[0])
    return (
        "supercritical"
        if ends[0] > 0 > ends[1]
        else "subcritical"
        if ends[0] < 0 < ends[1]
        else "neither"
    )
