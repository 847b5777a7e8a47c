"""Pages with several dry frictions that share inertias, their matrices by hand, and motions of
these by an event-driven driver with a complementarity of its own.

M q″ = −K q − C q′ + P cos(ωt) e₁ + Gᵀ N + Jᵀ f: the sliding speeds are V − J q′, and the gaps of
contacts g + G q. A friction at sliding speed 0 is held by |f| ≤ μ_s N, or slips on a side with its
rate of that sign.
"""

import itertools
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from scipy.integrate import DOP853, solve_ivp
from scipy.optimize import brentq
from sympy import sympify

HEAD = '''r"""A page of the tests."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
L = page.unit("L", "m", "length")
mu_s = page.parameter("mu_s", "1", "static", ">= 0", 0.6)
mu_k = page.parameter("mu_k", "1", "kinetic", ">= 0", 0.4)
V = page.parameter("V", "m/s", "belt", ">= 0", 0.3)
still = page.parameter("still", "m/s", "what stands still", ">= 0", 0.0)
n_1 = page.parameter("n_1", "N", "first normal force", "> 0", 0.7)
n_2 = page.parameter("n_2", "N", "second normal force", "> 0", 1.0)
n_3 = page.parameter("n_3", "N", "third normal force", "> 0", 1.3)
a = page.parameter("a", "1", "first number of the page", "> 0", 0.8)
b = page.parameter("b", "1", "second number of the page", "> 0", 1.4)
def rub(along, belt, name, normal, on=None):
    on = on or page.normal_force(normal, name=name)
    page.friction(along, belt, slip=lambda v: mu_k * sgn(v), holds=mu_s, on=on)
def move(name, unit="m"):
    return page.coordinate(name, unit, "place of " + name)
'''

TWO = """
x, y = move("x"), move("y")
page.kinetic(m * (page.rate(x)**2 + b * page.rate(y)**2) / 2)
page.spring(k, along=x)
page.spring(a * k, along=y)
"""
STACK = TWO + 'rub(x - y, still, "one", n_1)\nrub(y, V, "two", n_2)\n'
JOINT = TWO + 'rub(x, V, "two", n_2)\nrub(y - x, still, "one", n_1)\n'
FEET = TWO + 'rub(x + a * y, V, "one", n_1)\nrub(x - b * y, V, "two", n_2)\n'
WHEEL = """
x, phi = move("x"), move("phi", "rad")
page.kinetic(m * (page.rate(x)**2 + b * L**2 * page.rate(phi)**2) / 2)
page.spring(k, along=x)
page.potential(a * k * L**2 * phi**2 / 2)
rub(x + L * phi, V, "one", n_1)
rub(L * phi, still, "two", n_2)
"""
TIED = """
x, y = move("x"), move("y")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2 + b * (page.rate(x) + page.rate(y))**2) / 2)
page.spring(k, along=x)
page.spring(a * k, along=y)
rub(x, V, "one", n_1)
rub(y, V, "two", n_2)
"""
THREE = """
x, y, z = move("x"), move("y"), move("z")
page.kinetic(m * (page.rate(x)**2 + b * page.rate(y)**2 + page.rate(z)**2) / 2)
page.spring(k, along=x)
page.spring(a * k, along=y)
page.spring(k, along=z)
"""
CHAIN = (
    THREE
    + 'rub(x - y, still, "one", n_1)\nrub(y - z, still, "two", n_2)\nrub(z, V, "three", n_3)\n'
)
DUAL = THREE + 'rub(x - y, still, "one", n_1)\nrub(x - z, V, "two", n_2)\n'
PIGGYBACK = (
    THREE
    + 'rub(x - z, still, "one", n_1)\nrub(y - z, still, "two", n_2)\nrub(z, V, "three", n_3)\n'
)
LIFTING = (
    THREE
    + """
up = page.contact(-y + a * z / 2 - n_1 / (4 * k), lambda d: k * d, name="up")
lo = page.contact(y + a * z / 2 - n_1 / (4 * k), lambda d: k * d, name="lo")
rub(x + a * z, V, "up", n_1, up)
rub(x - a * z, V, "lo", n_1, lo)
"""
)
CLOCK = """
w = page.parameter("w", "1/s", "rate of the clock", "> 0", 0.9)
P = page.parameter("P", "N", "largest push", ">= 0", 0.4)
phase = page.clock(w)
page.force(P * cos(phase), along=x)
"""


@dataclass(frozen=True)
class System:
    """A page, and its matrices as they would be printed: of all pages M and K, the rows of J, the
    belts of these and their normal forces; of some contacts G and g, and ``clock``.
    """

    page: str
    M: str
    K: str
    J: str
    belts: str
    normals: str = "n_1 n_2"
    G: str = ""
    gaps: str = ""

    @property
    def text(self) -> str:
        """The text of the page, without parameters that nothing on it uses."""
        lines = HEAD.splitlines()
        used = [
            line
            for line in lines
            if "page.parameter" not in line
            or re.search(rf"\b{line.split()[0]}\b", self.page + "mu_s mu_k")
        ]
        return "\n".join(used) + self.page

    @property
    def clock(self) -> bool:
        """Whether a clock pushes the first coordinate."""
        return CLOCK in self.page


SYSTEMS = {
    "stack": System(STACK, "1 0; 0 b", "1 0; 0 a", "1 -1; 0 1", "0 V"),
    "pushed_stack": System(STACK + CLOCK, "1 0; 0 b", "1 0; 0 a", "1 -1; 0 1", "0 V"),
    "joint": System(JOINT, "1 0; 0 b", "1 0; 0 a", "1 0; -1 1", "V 0", "n_2 n_1"),
    "feet": System(FEET, "1 0; 0 b", "1 0; 0 a", "1 a; 1 -b", "V V"),
    "wheel": System(WHEEL, "1 0; 0 b", "1 0; 0 a", "1 1; 0 1", "V 0"),
    "pushed_wheel": System(WHEEL + CLOCK, "1 0; 0 b", "1 0; 0 a", "1 1; 0 1", "V 0"),
    "tied": System(TIED, "1+b b; b 1+b", "1 0; 0 a", "1 0; 0 1", "V V"),
    "chain": System(
        CHAIN,
        "1 0 0; 0 b 0; 0 0 1",
        "1 0 0; 0 a 0; 0 0 1",
        "1 -1 0; 0 1 -1; 0 0 1",
        "0 0 V",
        "n_1 n_2 n_3",
    ),
    "dual": System(DUAL, "1 0 0; 0 b 0; 0 0 1", "1 0 0; 0 a 0; 0 0 1", "1 -1 0; 1 0 -1", "0 V"),
    "piggyback": System(
        PIGGYBACK,
        "1 0 0; 0 b 0; 0 0 1",
        "1 0 0; 0 a 0; 0 0 1",
        "1 0 -1; 0 1 -1; 0 0 1",
        "0 0 V",
        "n_1 n_2 n_3",
    ),
    "lifting": System(
        LIFTING,
        "1 0 0; 0 b 0; 0 0 1",
        "1 0 0; 0 a 0; 0 0 1",
        "1 0 a; 1 0 -a",
        "V V",
        "",
        "0 -1 a/2; 0 1 a/2",
        "-n_1/4 -n_1/4",
    ),
}


def drawn(name: str, rng: np.random.Generator, equal: bool) -> tuple[dict[str, float], Any]:
    """Values of the parameters, with one coefficient where ``equal``, and a start."""
    values = {each: float(rng.uniform(0.4, 1.6)) for each in ("n_1", "n_2", "n_3", "a", "b")} | {
        "mu_k": float(rng.uniform(0.1, 0.6)),
        "V": float(rng.uniform(0.05, 0.5)),
    }
    values["mu_s"] = values["mu_k"] * (1.0 if equal else float(rng.uniform(1.05, 2.0)))
    if SYSTEMS[name].clock:
        values |= {"w": float(rng.uniform(0.4, 1.5)), "P": float(rng.uniform(0.1, 1.0))}
    count = SYSTEMS[name].M.count(";") + 1
    return values, rng.uniform(-1.5, 1.5, 2 * count)


class Driver:
    """Motions of a system by DOP853 between events, which end the steps one by one."""

    def __init__(self, name: str, values: Mapping[str, float], longest: float = 0.1) -> None:
        system = SYSTEMS[name]

        def read(text: str) -> Any:
            rows = (row.split() for row in text.split(";"))
            return np.array([[float(sympify(e).subs(values)) for e in row] for row in rows])

        self.M, self.K, self.J = map(read, (system.M, system.K, system.J))
        self.V, self.fixed = read(system.belts)[0], read(system.normals)[0]
        self.G = read(system.G) if system.G else np.zeros((0, len(self.M)))
        self.g = read(system.gaps)[0] if system.gaps else np.zeros(0)
        self.mu_s, self.mu_k = values["mu_s"], values["mu_k"]
        self.w, self.P = values.get("w", 0.0), values.get("P", 0.0)
        self.inverse, self.longest = np.linalg.inv(self.M), longest
        self.sides = np.ones(len(self.J), dtype=int)
        #: Time, number of the friction and side after each change of one.
        self.events: list[tuple[float, int, int]] = []
        #: Sides of all frictions in every mode that a motion was in.
        self.modes = set[tuple[int, ...]]()

    def normal(self, q: Any) -> Any:
        """Normal forces of the frictions."""
        return np.maximum(-(self.g + self.G @ q), 0.0) if len(self.G) else self.fixed

    def pull(self, t: float, z: Any) -> Any:
        """Forces without friction."""
        q = z[: len(self.M)]
        force = -self.K @ q
        force[0] += self.P * np.cos(self.w * t)
        return force + self.G.T @ self.normal(q) if len(self.G) else force

    def solved(self, t: float, z: Any, sides: Any) -> tuple[Any, Any]:
        """Accelerations, and the forces of friction."""
        pull, held = self.pull(t, z), np.asarray(sides) == 0
        f = sides * self.mu_k * self.normal(z[: len(self.M)])
        if held.any():
            J = self.J[held]
            free = self.inverse @ (pull + self.J.T @ f)
            f = f.astype(float)
            f[held] = np.linalg.solve(J @ self.inverse @ J.T, -J @ free)
        return self.inverse @ (pull + self.J.T @ f), f

    def slips(self, z: Any) -> Any:
        """Sliding speeds."""
        return self.V - self.J @ z[len(self.M) :]

    def decide(self, t: float, z: Any, rest: Any, lost: int | None, before: Any) -> None:
        """Sides of the frictions at ``rest``, of which one may have ``lost`` its hold."""
        limit = self.mu_s * self.normal(z[: len(self.M)])
        found = []
        for trial in itertools.product((0, 1, -1), repeat=len(rest)):
            sides = self.sides.copy()
            sides[rest] = trial
            accelerations, f = self.solved(t, z, sides)
            rates = -self.J @ accelerations
            for i in rest:
                short = 1e-8 * limit[i] * (1 if i == lost else -1)
                if not sides[i] and abs(f[i]) > limit[i] - short:
                    break
                if sides[i]:
                    alone = sides.copy()
                    alone[i] = 0
                    needed = self.solved(t, z, alone)[1][i]
                    if sides[i] * rates[i] < -1e-12 or (
                        abs(rates[i]) < 1e-7 and sides[i] * needed < limit[i] * (1 - 1e-8)
                    ):
                        break
            else:
                change = accelerations - before
                found.append((sum(map(abs, trial)), change @ self.M @ change, sides))
        least = min(count for count, *_ in found)
        changes = [change for count, change, _ in found if count == least]
        self.sides = next(
            sides
            for count, change, sides in found
            if count == least and change <= min(changes) + 1e-9
        )

    def at_rest(self, z: Any, rest: Any) -> Any:
        """The state with the sliding speeds of some frictions at 0."""
        n, J = len(self.M), self.J[rest]
        if len(rest):
            back = np.linalg.solve(J @ self.inverse @ J.T, self.slips(z)[rest])
            z = np.append(z[:n], z[n:] + self.inverse @ J.T @ back)
        return z

    def levels(self, t: float, z: Any) -> Any:
        """What is positive until an event, of frictions and of contacts."""
        n = len(self.M)
        _, f = self.solved(t, z, self.sides)
        slips, limit = self.sides * self.slips(z), self.mu_s * self.normal(z[:n])
        return np.append(
            np.where(self.sides == 0, limit - np.abs(f), slips), self.g + self.G @ z[:n]
        )

    def run(self, start: Any, end: float, begin: float = 0.0) -> Any:
        """The state at the end."""
        n, t, z = len(self.M), begin, np.array(start, dtype=float)
        self.sides = np.where(self.slips(z) >= 0, 1, -1)
        rest = np.flatnonzero(np.abs(self.slips(z)) < 1e-11)
        self.decide(t, z, rest, None, np.zeros(n))
        while t < end:
            self.modes.add(tuple(self.sides.tolist()))
            t, z, hit = self._to_event(t, z, end)
            if hit is None or hit >= len(self.J):
                continue
            before = self.solved(t, z, self.sides)[0]
            lost = hit if not self.sides[hit] else None
            rest = np.flatnonzero(
                (self.sides == 0)
                | (np.abs(self.slips(z)) < 1e-10)
                | (np.arange(len(self.J)) == hit)
            )
            z, old = self.at_rest(z, rest), self.sides.copy()
            self.decide(t, z, rest, lost, before)
            self.events += [(t, i, int(self.sides[i])) for i in np.flatnonzero(old != self.sides)]
        return z

    def _to_event(self, begin: float, z: Any, end: float) -> tuple[float, Any, int | None]:
        """Time, state and number of the first event, or of the end."""

        def rates(t: float, z: Any) -> Any:
            return np.append(z[len(self.M) :], self.solved(t, z, self.sides)[0])

        solver = DOP853(rates, begin, z, end, max_step=self.longest, rtol=1e-12, atol=1e-14)
        contacts = np.sign(self.levels(begin + 1e-9, z + 1e-9 * rates(begin, z))[len(self.J) :])

        def inside(t: float, z: Any, i: int | slice = slice(None)) -> Any:
            # A level that is 0 at the beginning is so again at the event: the quotient has that.
            found = self.levels(t, z) / (t - begin)
            found[len(self.J) :] *= contacts
            return found[i]

        def level(dense: Any, i: int, t: float) -> Any:
            return inside(t, dense(t), i)

        while solver.status == "running":
            solver.step()
            dense = solver.dense_output()
            times = np.linspace(solver.t_old, solver.t, 6)[1:]
            ends = np.array([inside(t, dense(t)) for t in times])
            passed = []
            for i in np.flatnonzero(ends.min(axis=0) < 0):
                late = times[np.flatnonzero(ends[:, i] < 0)[0]]
                early = max(solver.t_old, begin + 1e-10)
                if late <= early or inside(early, dense(early), i) <= 0:
                    passed.append((early, int(i)))
                    continue
                root = brentq(partial(level, dense, i), early, late, xtol=1e-14)
                passed.append((float(root), int(i)))
            if passed:
                t, i = min(passed)
                return t, dense(t), i
        return end, solver.y, None


def regularized(name: str, values: Mapping[str, float], start: Any, end: float, eps: float) -> Any:
    """The state at the end where friction is μ_k N tanh(v/eps), by Radau."""
    own, n = Driver(name, values), len(start) // 2

    def rates(t: float, z: Any) -> Any:
        f = own.mu_k * own.normal(z[:n]) * np.tanh(own.slips(z) / eps)
        return np.append(z[n:], own.inverse @ (own.pull(t, z) + own.J.T @ f))

    return solve_ivp(rates, (0.0, end), start, "Radau", rtol=1e-8, atol=1e-10).y[:, -1]
