"""Pages with a clock, as a user writes them, and their closed forms and drivers."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve

HEAD = '''r"""A mass that is shaken.

::

    P cos(omega t)
"""



from spragsym.derive.model import Page, cos, sgn, sin, sqrt, tanh

page = Page("A mass that is shaken.")

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the spring")
P = page.unit("P", "N", "amplitude of the force")
omega = page.parameter("omega", "1/s", "frequency", "> 0", 0.6)

x = page.coordinate("x", "m", "displacement")
phase = page.clock(omega)

page.kinetic(m * page.rate(x) ** 2 / 2)
'''

#: Den Hartog's: dry friction on a floor.
FRICTION = f"""{HEAD}
f = page.parameter("f", "N", "normal force", ">= 0", 0.5)
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.4)

page.spring(k, along=x)
page.force(P * cos(phase), along=x)
page.normal_force(f)
page.friction(x, 0, slip=lambda v: mu * sgn(v), holds=mu)
"""

#: Duffing's.
DUFFING = f"""{HEAD}
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.1)
g = page.parameter("g", "N/m^3", "hardening", "real", 0.05)

page.spring(k, along=x)
page.potential(g * x**4 / 4)
page.damper(c, along=x)
page.force(P * cos(phase), along=x)
"""

#: A linear one with a stop in front.
STOPPED = (
    DUFFING.replace("page.potential(g * x**4 / 4)\n", "").replace(
        'g = page.parameter("g", "N/m^3", "hardening", "real", 0.05)',
        'd = page.parameter("d", "m", "play before the stop", "real", 0.5)\n'
        'k_c = page.parameter("k_c", "N/m", "stiffness of the stop", "> 0", 5.0)',
    )
    + 'page.contact(d - x, lambda depth: k_c * depth, name="stop")\n'
)

#: Everything that may follow the clock: the end of a spring, a gap, a normal force, a belt.
MOVED = f"""{HEAD}
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.1)
a = page.parameter("a", "m", "amplitude of what moves", ">= 0", 0.3)
e = page.parameter("e", "1", "share of the normal force that varies", "[0, 1]", 0.5)
k_c = page.parameter("k_c", "N/m", "stiffness of the stop", "> 0", 5.0)
V = page.parameter("V", "m/s", "speed of the belt", ">= 0", 0.4)
f = page.parameter("f", "N", "normal force", ">= 0", 0.5)

page.potential(k * (x - a * sin(phase)) ** 2 / 2)
page.damper(c, along=x)
page.contact(x - a * cos(2 * phase) - P / k / 10, lambda depth: k_c * depth, name="stop")
page.friction(
    x,
    V + page.rate(a * sin(phase)),
    lambda v: tanh(5 * v * sqrt(m * k) / P) / 2,
    on=page.normal_force(f * (1 + e * cos(phase)), name="belt"),
)
"""


def moved(t: float, u: np.ndarray) -> list[float]:
    """Rates of x and its rate of the page ``MOVED`` at its base values, by hand."""
    x, v = u
    a, e, c, speed, f, omega = 0.3, 0.5, 0.1, 0.4, 0.5, 0.6
    gap = x - a * np.cos(2 * omega * t) - 0.1
    slip = speed + a * omega * np.cos(omega * t) - v
    rubs = np.tanh(5 * slip) / 2 * f * (1 + e * np.cos(omega * t))
    return [v, a * np.sin(omega * t) - x - c * v + 5 * max(0.0, -gap) + rubs]


def stopping_amplitude(omega: float, force: float, near: tuple[float, float]) -> float:
    """Amplitude of the mass on a floor that stops at both turns, put together from its pieces: at x
    = A it slips, where A − cos φ is the friction, and stops at −A; near (A, time of sliding).
    """
    size = 1 / (1 - omega**2)

    def pieces(unknown: np.ndarray) -> list[float]:
        largest, time = unknown
        begun = np.arccos(largest - force)
        cosine, sine = largest - force - size * np.cos(begun), omega * size * np.sin(begun)
        end = begun + omega * time
        x = force + size * np.cos(end) + cosine * np.cos(time) + sine * np.sin(time)
        v = -omega * size * np.sin(end) - cosine * np.sin(time) + sine * np.cos(time)
        return [x + largest, v]

    return float(fsolve(pieces, near, xtol=1e-13)[0])


def duffing_fold(c: float, g: float, cycle: Any, near: float) -> float:
    """Frequency at which the stroboscopic map of Duffing's oscillator has a fixed point with the
    multiplier 1, by shooting from a cycle.
    """

    def motion(begin: Any, end: float, state: Any, omega: float) -> Any:
        """State and its derivatives by the start."""

        def field(t: float, u: np.ndarray) -> list[float]:
            slope = -1 - 3 * g * u[0] ** 2
            force = np.cos(omega * t) - c * u[1] - u[0] - g * u[0] ** 3
            return [u[1], force, u[3], slope * u[2] - c * u[3], u[5], slope * u[4] - c * u[5]]

        start = [*state, 1, 0, 0, 1]
        return solve_ivp(field, (begin, end), start, "DOP853", rtol=1e-13, atol=1e-14).y[:, -1]

    def returned(unknown: np.ndarray) -> list[float]:
        """The map less the state, and det(its derivative − 1)."""
        x, v, omega = unknown
        end = motion(0.0, 2 * np.pi / omega, (x, v), omega)
        determinant = (end[2] - 1) * (end[5] - 1) - end[3] * end[4]
        return [end[0] - x, end[1] - v, determinant]

    x, phase, v, _ = cycle.state
    begin = phase / near
    turn = 2 * np.pi / near
    begun = motion(begin, np.ceil(begin / turn) * turn, (x, v), near)[:2]
    return float(fsolve(returned, [*begun, near], xtol=1e-13)[2])


def stopped(values: Mapping[str, float], x: float, v: float, begin: float, end: float) -> Any:
    """State at an end of a motion with the stop: each piece in closed form, its end by SciPy."""
    omega, c, d, k_c = (values[name] for name in ("omega", "c", "d", "k_c"))
    touches = x > d
    while True:
        stiffness, load = (1 + k_c, k_c * d) if touches else (1.0, 0.0)
        forced = 1 / (stiffness - omega**2 + 1j * omega * c)
        own = -c / 2 + 1j * np.sqrt(stiffness - c**2 / 4)
        turn = forced * np.exp(1j * omega * begin)
        x -= load / stiffness + turn.real
        v -= (1j * omega * turn).real
        # A homogeneous motion is the real part of z exp(own t).
        z = x + 1j * (own.real * x - v) / own.imag

        def state(
            t: Any,
            since: float = begin,
            z: complex = z,
            own: complex = own,
            turn: complex = turn,
            rest: float = load / stiffness,
        ) -> Any:
            free, driven = z * np.exp(own * (t - since)), turn * np.exp(1j * omega * (t - since))
            return (free + driven).real + rest, (own * free + 1j * omega * driven).real

        times = np.linspace(begin, end, 4001)
        beyond = (state(times)[0] > d) == touches
        left = np.flatnonzero(~beyond[2:]) + 2
        if not left.size:
            return state(end)
        begin = brentq(lambda t: state(t)[0] - d, times[left[0] - 1], times[left[0]], xtol=1e-15)
        (x, v), touches = state(begin), not touches


def swung(start: tuple[float, float], omega: float, c: float, a: float) -> Any:
    """What x″ + c x′ + (1 + a cos ω t) x = 0 comes to after one turn."""

    def field(t: float, u: Any) -> list[float]:
        return [u[1], -c * u[1] - (1 + a * np.cos(omega * t)) * u[0]]

    turn = 2 * np.pi / omega
    return solve_ivp(field, (0, turn), start, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
