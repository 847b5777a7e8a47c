"""Forces of every attacked model, written by hand from its drawing: the reference of
:mod:`tests.oracles.by_hand`.

Nothing of ``derive/`` or ``generated/`` is used. Numbers are floats, arrays or mpmath's, as ``xp``
has the functions for.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

#: Parameters by name, one number or array each.
Values = dict[str, Any]
#: ``f(q, v, values, xp)``: a force on every coordinate, without contact and friction; xp is numpy
#: or mpmath.
Pull = Callable[[Sequence[Any], Sequence[Any], Values, Any], list[Any]]


@dataclass(frozen=True)
class Drawn:
    """What a drawing says of a model.

    Attributes
    ----------
    pull : callable
        Forces of springs, dampers and loads.
    normal : callable
        ``normal(depth, values, xp)`` in contact; None where the normal force is 1.
    friction : callable
        ``friction(v, values, xp)``: μ for a sliding speed v > 0; odd in v.
    at_rest : str
        The parameter that statics takes for μ; empty for μ(V).
    masses : tuple
        A number or a parameter's name for each coordinate.
    lifts : bool
        Whether the contact opens where the gap, the second coordinate, is positive.
    """

    pull: Pull
    normal: Callable[[Any, Values, Any], Any] | None
    friction: Callable[[Any, Values, Any], Any]
    at_rest: str = "mu0"
    masses: tuple[Any, ...] = (1, 1)
    lifts: bool = True

    def inertia(self, p: Values) -> list[Any]:
        """Masses as numbers."""
        return [p[mass] if isinstance(mass, str) else mass for mass in self.masses]

    def static_friction(self, p: Values, xp: Any) -> Any:
        """μ at the equilibria."""
        return p[self.at_rest] if self.at_rest else self.friction(p["V"], p, xp)

    def forces(
        self, q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any, touching: bool, mu: Any
    ) -> list[Any]:
        """All forces, with the contact's law where it touches and the friction mu."""
        total = list(self.pull(q, v, p, xp))
        n = 1 if self.normal is None else self.normal(-q[1], p, xp) if touching else 0
        # What never lifts rubs on whichever face it presses: |N|, which complex steps differentiate.
        total[0] = total[0] + mu * (n if self.lifts or self.normal is None else xp.sqrt(n * n))
        if self.normal is not None:
            total[1] = total[1] + n
        return total


def line(
    mass: Sequence[Any],
    end: Sequence[Any],
    rates: Sequence[Any],
    stiffness: Any,
    rest: Any,
    damper: Any,
    xp: Any,
) -> Any:
    """The force of a straight spring and its damper on the mass, as (F_x, F_y); ``rates`` are the
    mass's less the end's.
    """
    dx, dy = end[0] - mass[0], end[1] - mass[1]
    length = xp.sqrt(dx * dx + dy * dy)
    growing = -(dx * rates[0] + dy * rates[1]) / length
    tension = stiffness * (length - rest) + damper * growing
    return tension * dx / length, tension * dy / length


def _article(q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any) -> list[Any]:
    """The article's mass, with whatever the shipped pages add to it."""
    moved, speed = (q[2], v[2]) if "alpha_a" in p else (0, 0)
    end = xp.cos(p["theta0"]) + moved, xp.sin(p["theta0"])
    fx, fy = line(q, end, (v[0] - speed, v[1]), p["sigma"], 1, p.get("zeta_s", 0), xp)
    x = fx - p["alpha"] * q[0] - p.get("zeta_x", 0) * v[0]
    y = fy - p["beta"] * q[1] - p.get("zeta_y", 0) * v[1] - p["kappa"]
    if "sigma_2" in p:
        length = p["lambda_2"]
        second = length * xp.cos(p["theta0_2"]), length * xp.sin(p["theta0_2"])
        fx2, fy2 = line(q, second, v, p["sigma_2"], length, 0, xp)
        x, y = x + fx2, y + fy2
    if "gamma_g" in p:
        x, y = x - p["gamma_g"] * xp.sin(p["psi"]), y - p["gamma_g"] * xp.cos(p["psi"])
    return [x, y, -fx - p["alpha_a"] * q[2]] if "alpha_a" in p else [x, y]


def _mode_coupling(q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any) -> list[Any]:
    leaning = p["sigma"] * (q[0] - q[1]) / 2
    return [-p["alpha"] * q[0] - leaning, -p["beta"] * q[1] + leaning - 1]


def _stick_slip(q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any) -> list[Any]:
    return [-q[0] - p["zeta"] * v[0]]


def _carriage(q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any) -> list[Any]:
    end = xp.cos(p["theta0"]) + q[2], xp.sin(p["theta0"]) + q[3]
    fx, fy = line(q, end, (v[0] - v[2], v[1] - v[3]), p["sigma"], 1, p["zeta"], xp)
    return [
        fx - p["alpha"] * q[0],
        fy - p["kappa"],
        -fx - p["gamma"] * q[2],
        -fy - p["gamma"] * q[3],
    ]


def _penalty(q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any) -> list[Any]:
    fx, fy = line(q, (xp.cos(p["theta0"]), xp.sin(p["theta0"])), v, p["sigma"], 1, 0, xp)
    return [fx - p["alpha"] * q[0], fy - p["kappa"]]


def _towed(q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any) -> list[Any]:
    between = p["sigma"] * (q[0] - q[2]) + p["zeta"] * (v[0] - v[2])
    leaning = p["eta"] * (q[0] - q[1]) / 2
    return [-p["alpha"] * q[0] - between - leaning, leaning - 1, between]


def _rail(q: Sequence[Any], v: Sequence[Any], p: Values, xp: Any) -> list[Any]:
    """With the torque of the anchor's spring: its stiffness times the least angle by which the line
    has turned.
    """
    c0, s0 = xp.cos(p["theta0"]), xp.sin(p["theta0"])
    fx, fy = line(q, (c0, s0), v, p["sigma"], 1, 0, xp)
    dx, dy = c0 - q[0], s0 - q[1]
    square = dx * dx + dy * dy
    length = xp.sqrt(square)
    cosine, sine = (c0 * dx + s0 * dy) / length, (c0 * dy - s0 * dx) / length
    torque = p["tau"] * 2 * getattr(xp, "arctan", getattr(xp, "atan", None))(sine / (1 + cosine))
    # The angle grows by dx/dt = −vx, dy/dt = −vy: φ′ = (dx dy′ − dy dx′)/l².
    return [fx - p["alpha"] * q[0] - torque * dy / square, fy - p["kappa"] + torque * dx / square]


# ------------------------------------------------------------------------------------------------
# laws


def linear(depth: Any, p: Values, xp: Any) -> Any:
    """The article's contact."""
    return depth


def creep(v: Any, p: Values, xp: Any) -> Any:
    """The article's friction."""
    return p.get("mu0", p.get("mu_s")) * -xp.expm1(-p["d"] * v)


def _stribeck(v: Any, p: Values, xp: Any) -> Any:
    return (p["mu_k"] + (p["mu_s"] - p["mu_k"]) * xp.exp(-v / p["v_s"])) * -xp.expm1(-p["d"] * v)


def _rounded(v: Any, p: Values, xp: Any) -> Any:
    return 2 * p["mu_s"] * v * p["v_s"] / (v * v + p["v_s"] * p["v_s"])


def _falling(v: Any, p: Values, xp: Any) -> Any:
    return p["mu_s"] * -xp.expm1(-p["d"] * v) / (1 + v / p["v_s"])


def _hertz(depth: Any, p: Values, xp: Any) -> Any:
    return depth * xp.sqrt(xp.sqrt(depth * depth))  # |depth|, which complex steps differentiate


def _cubic(depth: Any, p: Values, xp: Any) -> Any:
    return depth + p["gamma"] * depth * depth * depth


#: By name: the shipped models, then those of ``tests/oracles/pages``.
DRAWN = {
    "kang_nam": Drawn(_article, linear, creep),
    "damped": Drawn(_article, linear, creep),
    "stribeck": Drawn(_article, linear, _stribeck, at_rest=""),
    "cubic_contact": Drawn(_article, _cubic, creep),
    "hertz_contact": Drawn(_article, _hertz, creep),
    "two_springs": Drawn(_article, linear, creep),
    "inclined_belt": Drawn(_article, linear, creep),
    "trolley": Drawn(_article, linear, creep, masses=(1, 1, "nu_a")),
    "mode_coupling": Drawn(_mode_coupling, linear, creep, lifts=False),
    "stick_slip": Drawn(_stick_slip, None, _rounded, at_rest="", masses=(1,), lifts=False),
    "carriage": Drawn(_carriage, linear, creep, masses=(1, 1, "nu", "nu")),
    "penalty": Drawn(
        _penalty, lambda depth, p, xp: p["depth_e"] * xp.expm1(depth / p["depth_e"]), creep
    ),
    "towed": Drawn(_towed, linear, _falling, at_rest="", masses=(1, 1, "nu")),
    "rail": Drawn(_rail, _cubic, creep, at_rest="", lifts=False),
}
