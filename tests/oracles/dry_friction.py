"""Motions with dry friction by an event-driven driver of its own: SciPy's DOP853 between events, on
forces written by hand.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import mpmath
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

import spragsym as ss
from tests.oracles.user_pages import model_of, shipped_page

Values = Mapping[str, float]

#: Leine's oscillator, whose friction falls with the sliding speed.
LEINE = shipped_page(
    "coulomb_stick_slip",
    ("import Page", "import Abs, Page"),
    ('">= 0", 0.5)', '">= 0", 0.2)'),
    (
        'page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 0.6)',
        'page.parameter("mu0", "1", "static", ">= 0", 1.0)',
    ),
    (
        'mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0", 0.4)',
        'ratio = page.parameter("ratio", "1", "least over static", "[0, 1]", 0.0)\n'
        'delta = page.parameter("delta", "s/m", "how fast friction falls", ">= 0", 3.0)',
    ),
    ("mu_k * sgn(v)", "mu_s * (ratio + (1 - ratio) / (1 + delta * Abs(v))) * sgn(v)"),
)

#: A pendulum on a slider brushes a belt with its tip; friction falls with the sliding speed.
TIP = """'''A pendulum on a slider.'''
from spragsym.derive.model import Abs, Page, cos, sgn, sin

page = Page("The tip of a pendulum on a slider brushes a belt.")
m = page.unit("m", "kg", "mass of slider and bob")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length of the pendulum")
N = page.parameter("N", "N", "normal force", "> 0", 0.5)
mu0 = page.parameter("mu0", "1", "static friction coefficient", ">= 0", 0.6)
ratio = page.parameter("ratio", "1", "least over static friction coefficient", "[0, 1]", 0.5)
delta = page.parameter("delta", "s/m", "how fast friction falls", ">= 0", 3.0)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.2)
x = page.coordinate("x", "m", "place of the slider")
phi = page.coordinate("phi", "rad", "angle of the pendulum")
vx, w = page.rate(x), page.rate(phi)
page.kinetic(m * (vx**2 + vx * l * w * cos(phi) + l**2 * w**2 / 2))
page.potential(k * x**2 / 2 + k * l**2 * (1 - cos(phi)))
page.normal_force(N)
page.friction(
    x + l * sin(phi), V, slip=lambda v: mu0 * (ratio + (1 - ratio) / (1 + delta * Abs(v))) * sgn(v), holds=mu0
)
"""

#: The mass that sticks and slips, pushed in time by a rotor that a motor turns; by ``fall``
#: friction falls before it rises.
FORCED = shipped_page(
    "coulomb_stick_slip",
    ("import Page", "import Page, cos, sqrt"),
    ('">= 0", 0.5)', '">= 0", 0.1)'),
    (
        'page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 0.6)',
        'page.parameter("mu0", "1", "friction", ">= 0", 0.4)',
    ),
    (
        'mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0", 0.4)',
        'w = page.parameter("w", "1/s", "speed of the rotor", "> 0")\nP = page.parameter("P", '
        '"N", "largest push", ">= 0", 1.0)\n'
        'fall = page.parameter("fall", "1", "how much friction falls", "[0, 1]", 0.0)\n'
        'phi = page.coordinate("phi", "rad", "angle of the rotor")\nu, r = N_0 / sqrt(k * m), '
        "N_0 / k",
    ),
    (
        "page.kinetic(m * page.rate(x) ** 2 / 2)",
        "page.kinetic(m * (page.rate(x) ** 2 + (r * page.rate(phi)) ** 2) / 2)\npage.force(P "
        "* cos(phi), along=x)\n"
        "page.force(sqrt(k * m) * r**2 * w, along=phi)\npage.damper(sqrt(k * m) * r**2, along=phi)",
    ),
    ("mu_k * sgn(v)", "mu_s * (sgn(v) - fall * (v / u - 3 * (v / u) ** 3 / 10))"),
)

#: Parameters of each model, and ranges from which they are drawn; the reach of starts.
DRAWN = {
    "coulomb": ("theta0", "mu0", "ratio", "kappa", "alpha", "sigma", "V"),
    "leine": ("mu0", "ratio", "delta", "V"),
    "tip": ("mu0", "ratio", "delta", "V", "N"),
}
RANGES = {
    "theta0": (0.3, 1.2),
    "mu0": (0.3, 0.9),
    "ratio": (0.2, 1.1),
    "kappa": (0.004, 0.02),
    "alpha": (0.003, 0.02),
    "sigma": (0.05, 0.2),
    "V": (-0.02, 0.5),
    "delta": (0.0, 5.0),
    "N": (0.3, 1.0),
}
REACH = {"coulomb": (1.0, 0.1, 0.3, 0.1), "leine": (1.5, 1.5), "tip": (1.0, 1.0, 1.0, 1.0)}


def drawn(name: str, *seed: int) -> tuple[dict[str, float], Any]:
    """Values of the parameters and a start: some with one friction coefficient, some on a belt that
    stands.
    """
    rng = np.random.default_rng(seed)
    values = {each: max(rng.uniform(*RANGES[each]), 0.0) for each in DRAWN[name]}
    return values | {"ratio": min(values["ratio"], 1.0)}, rng.uniform(
        -1, 1, len(REACH[name])
    ) * REACH[name]


def model(name: str) -> Any:
    """The model of a name."""
    return (
        ss.load(name)
        if name == "coulomb"
        else model_of({"leine": LEINE, "tip": TIP, "forced": FORCED}[name], name)
    )


def parts(
    name: str, p: Values, q: Any, v: Any, contact: bool
) -> tuple[Any, Any, Any, float, float]:
    """M, forces without friction, J = ∂slide/∂q, J′v, and the normal force."""
    if name == "leine":
        return np.eye(1), -q, np.ones(1), 0.0, 1.0
    if name == "tip":
        c, s = math.cos(q[1]), math.sin(q[1])
        return (
            np.array([[2, c], [c, 1]]),
            np.array([-q[0] + s * v[1] ** 2, -s]),
            np.array([1.0, c]),
            -s * v[1] ** 2,
            p["N"],
        )
    if name == "forced":
        slip = p["V"] - v[1]
        push = p["P"] * math.cos(q[0]) - p["mu0"] * p["fall"] * (slip - 0.3 * slip**3)
        return np.eye(2), np.array([p["w"] - v[0], push - q[1]]), np.eye(2)[1], 0.0, 1.0
    dx, dy = math.cos(p["theta0"]) - q[0], math.sin(p["theta0"]) - q[1]
    pull, normal = p["sigma"] * (1 - 1 / math.hypot(dx, dy)), -q[1] * contact
    return (
        np.eye(2),
        np.array([pull * dx - p["alpha"] * q[0], pull * dy - p["kappa"] + normal]),
        np.eye(2)[0],
        0.0,
        normal,
    )


class Driver:
    """A motion between its events, which are told with the states at them; two that a step holds
    both are missed.
    """

    def __init__(self, name: str, p: Values, longest: float = 0.2) -> None:
        self.name, self.p, self.longest, self.side, self.contact = name, p, longest, 1, True
        self.events: list[tuple[str, float, Any]] = []

    def solved(self, z: Any, side: int) -> tuple[Any, float, float, float]:
        """Rates, the sliding speed, and how far the force of friction is from its limits with the
        belt and against it.
        """
        (q, v), p = np.split(z, 2), self.p
        M, Q, J, rest, N = parts(self.name, p, q, v, self.contact)
        slip, free, response = p["V"] - float(J @ v), np.linalg.solve(M, Q), np.linalg.solve(M, J)
        ratio = p.get("ratio", 1.0)
        falls = (1 - ratio) / (1 + p.get("delta", math.inf) * max(abs(slip), 1e-300))
        F = side * N * p["mu0"] * (ratio + falls) if side else -(J @ free + rest) / (J @ response)
        return np.concatenate([v, free + response * F]), slip, p["mu0"] * N - F, p["mu0"] * N + F

    def resolve(self, z: Any) -> None:
        """What follows where nothing slides: where the force that would hold it is too large, the
        belt gets ahead of it.
        """
        _, _, ahead, behind = self.solved(z, 0)
        self.side = 0 if self.contact and min(ahead, behind) >= 0 else 1 if ahead < behind else -1

    def levels(self) -> list[Any]:
        """What is positive until an event; the sliding speed begins at 0 but for rounding where it
        slips.
        """
        found = [lambda _, z: self.side * self.solved(z, self.side)[1] + 1e-13]
        if not self.side:
            found = [lambda _, z: self.solved(z, 0)[2], lambda _, z: self.solved(z, 0)[3]]
        if self.name == "coulomb":
            found.append(lambda _, z: -z[1] if self.contact else z[1])
        for level in found:
            # as SciPy wants it
            level.terminal, level.direction = True, -1  # type: ignore[attr-defined]
        return found

    def run(self, start: Any, end: float) -> Any:
        """The state at the end."""
        z, t, self.contact = np.array(start), 0.0, self.name != "coulomb" or start[1] <= 0
        slip = self.solved(z, 1)[1]
        self.side = 1 if slip > 0 else -1
        if abs(slip) < 1e-12:
            self.resolve(z)
        while True:
            part = solve_ivp(
                lambda _, y: self.solved(y, self.side)[0],
                (t, end),
                z,
                method="DOP853",
                rtol=1e-12,
                atol=1e-15,
                events=self.levels(),
                max_step=self.longest,
            )
            z, t, hit = (
                part.y[:, -1],
                float(part.t[-1]),
                [len(times) > 0 for times in part.t_events],
            )
            if not any(hit):
                return z
            if self.name == "coulomb" and hit[-1]:
                self.contact = not self.contact
                event = "CONTACT_REGAINED" if self.contact else "CONTACT_LOST"
            elif self.side:
                self.resolve(z)
                event = ("STICK", "BELT_OVERTAKES", "MASS_OVERTAKES")[self.side]
            else:
                self.side, event = 1 if hit[0] else -1, "SLIP"
            self.events.append((event, t, z))


def along(
    name: str, p: Values, near: ss.results.Cycle, longest: float
) -> tuple[list[tuple[float, str]], float]:
    """Events of one period, and the period, of the cycle near one of other parameters, closed by
    this driver.
    """
    fixed = 2 * (name == "coulomb")  # where x is largest; or at one angle of the rotor

    def run(place: Any) -> tuple[Driver, Any]:
        driver, start = Driver(name, p, longest), np.insert(place[:-1], fixed, near.state[fixed])
        off = driver.run(start, place[-1]) - start
        return driver, off - 2 * math.pi * np.round(off / (2 * math.pi))

    begun = np.append(np.delete(near.state, fixed), near.period)
    place, _, found, why = fsolve(
        lambda place: run(place)[1], begun, xtol=1e-11, epsfcn=1e-12, full_output=True
    )
    assert found == 1, why
    return [(t, event) for event, t, _ in run(place)[0].events], place[-1]


def derivatives(
    name: str, cycle: ss.results.Cycle, varied: Sequence[str], step: float = 5e-6
) -> Any:
    """Of the state after the period by the state and then by parameters, as differences of this
    driver's motions.
    """
    m, here = len(cycle.state), np.array([*cycle.state, *map(cycle.parameters.get, varied)])

    def after(place: Any, longest: float) -> Any:
        p = cycle.parameters | dict(zip(varied, place[m:], strict=True))
        return Driver(name, p, longest).run(place[:m], cycle.period)

    most = next(
        each for each in (0.2, 0.01) if np.abs(after(here, each) - cycle.state).max() < 1e-9
    )  # else it does not close
    return np.transpose(
        [after(here + way, most) - after(here - way, most) for way in step * np.eye(len(here))]
    ) / (2 * step)


def leine(digits: int) -> tuple[str, str]:
    """Period and half of the range of stick-slip at delta = 3 and V = 0.2: the equation of slip by
    Taylor series of many digits.
    """
    with mpmath.workdps(digits + 3):
        V = mpmath.mpf("0.2")
        slip = mpmath.odefun(lambda _, z: [z[1], 1 / (1 + 3 * (V - z[1])) - z[0]], 0, [1, V])
        times = [
            mpmath.findroot(lambda t, v=v: slip(t)[1] - v, near, solver="anderson")
            for v, near in ((0, (0.5, 2)), (0, (3, 4.2)), (V, (4.2, 4.35)))
        ]
        high, low, end = (slip(t)[0] for t in times)
        return mpmath.nstr(times[2] + (1 - end) / V, digits), mpmath.nstr((high - low) / 2, digits)
