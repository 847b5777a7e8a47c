"""What we say about the rows that are not simply confirmed: causes, second derivations and costs of
misprints, and the exact forms behind approximations.

The misprints themselves, and what is right, are found by :mod:`derive.statements`. An explanation
of a row that is no misprint, or of other edits than those that are found, fails the check.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import mpmath
from mpmath import mpf
from sympy.physics import units
from sympy.physics.units.systems.si import dimsys_SI

from . import free_body
from .free_body import DIGITS, ParameterPoint, show


@dataclass(frozen=True)
class Explanation:
    """The likely cause of a misprint, evidence by another route, and its consequence in numbers."""

    #: Kinds of the edits that make the row right. Only these are explained; any other misprint in
    #: the row still fails the check.
    edits: tuple[str, ...]
    cause: str
    #: Both are asked with :data:`.free_body.DIGITS` digits.
    evidence: Callable[[], tuple[bool, str]]
    consequence: Callable[[ParameterPoint], str]


@dataclass(frozen=True)
class Approximation:
    """A form that holds in a limit only: what it means, and in LaTeX the exact form in the
    arrangement of the print, which is a statement that the check confirms.
    """

    limit: str
    exact: str


# ------------------------------------------------------------------------------------------------
# misprints


def _below(value: mpf) -> str:
    """A rounding error for the ledger: its size varies with machine and version, so a small one is
    reported as small, without its digits.
    """
    return "below 1e-40" if abs(value) < mpf(10) ** -40 else show(value, 3)


def _length_evidence() -> tuple[bool, str]:
    point = ParameterPoint(theta0_deg=Fraction(62))
    x, y = mpf(3) / 10, -mpf(1) / 7
    theta0 = point.number("theta0")
    pythagoras = mpmath.sqrt((mpmath.cos(theta0) - x) ** 2 + (mpmath.sin(theta0) - y) ** 2)
    gap = abs(pythagoras - free_body.spring_length(point, x, y))
    return gap < mpf(10) ** (5 - DIGITS), "the distance in the complex plane agrees to 45 digits"


def _length_consequence(point: ParameterPoint) -> str:
    ((x, y),) = free_body.equilibria(point)
    length = free_body.spring_length(point, x, y)
    theta = mpmath.arg(free_body.anchor(point) - mpmath.mpc(x, y))
    printed = mpmath.sqrt((mpmath.cos(theta) - x) ** 2 + (mpmath.sin(theta) - y) ** 2)
    return (
        f"at the base equilibrium (θ₀ = {point.theta0_deg}°) the printed form gives L = "
        f"{show(printed)} where L = {show(length)}"
    )


def _preload_evidence() -> tuple[bool, str]:
    point = ParameterPoint(theta0_deg=Fraction(71), beta=Fraction(1, 3))
    x, y, one = mpf(2) / 7, -mpf(1) / 9, mpf(1)
    gap = abs(free_body.forces(point, x, y, one)[1] - free_body.energy_slope_y(point, x, y, one))
    return gap < mpf(
        10
    ) ** -20, "virtual work: the slope of the energy has the term κ and agrees to 20 digits"


def _preload_consequence(point: ParameterPoint) -> str:
    (with_preload,) = free_body.equilibria(point)
    # Without κ, (13) is solved by the undeformed state, where the contact force is zero as well.
    residual = free_body.forces(ParameterPoint(kappa=Fraction(0)), mpf(0), mpf(0), mpf(1))
    return (
        "the undeformed state x = y = 0 would be an equilibrium (residual "
        f"{_below(max(map(abs, residual)))}) without any contact force, where the base equilibrium "
        f"(θ₀ = {point.theta0_deg}°) is x = {show(with_preload[0])}, y = {show(with_preload[1])}"
    )


def _force_scale_evidence() -> tuple[bool, str]:
    contact_stiffness = units.force / units.length
    dimensions = {
        name: dimsys_SI.get_dimensional_dependencies(units.force / scale)
        for name, scale in (
            ("printed", contact_stiffness),
            ("right", contact_stiffness * units.length),
        )
    }
    holds = dimensions["right"] == {} and dimensions["printed"] == {units.length: 1}
    return holds, "dimensional analysis: N/k_c is a length, N/(k_c L_o) a number"


def _force_scale_consequence(point: ParameterPoint) -> str:
    (right,) = free_body.equilibria(point)
    (literal,) = free_body.equilibria(point, Fraction(1, 10))
    return (
        "none for L_o = 1 in the unit of length in use; taken literally with L_o = 0.1 m, n is a "
        f"tenth of −y and the base equilibrium (θ₀ = {point.theta0_deg}°) moves from x = "
        f"{show(right[0])} to {show(literal[0])} and from y = {show(right[1])} to "
        f"{show(literal[1])}"
    )


def _liftoff_polynomial(point: ParameterPoint, constant: str) -> list[mpf]:
    """Lift-off coefficients d₄ … d₀ written out from A6–A9, with the constant term of either
    reading.
    """
    theta0 = point.number("theta0")
    alpha, sigma, beta, kappa, mu0 = (
        point.number(name) for name in ("alpha", "sigma", "beta", "kappa", "mu0")
    )
    c0, s0 = mpmath.cos(theta0), mpmath.sin(theta0)
    p, q, b3, b4 = alpha + sigma, beta + sigma, -alpha * c0, -beta * s0 - kappa
    first, second = (
        (b3, b4) if constant == "right" else (-alpha * c0 - mu0 * s0, -(beta + 1) * s0 - kappa)
    )
    return [
        -((p * q) ** 2),
        2 * sigma * p * q * (p + q),
        (b4**2 - sigma**2) * p**2 - 4 * sigma**2 * p * q + (b3**2 - sigma**2) * q**2,
        2 * sigma * (p * (sigma**2 - b4**2) + q * (sigma**2 - b3**2)),
        (first**2 + second**2) * sigma**2 - sigma**4,
    ]


def _constant_evidence() -> tuple[bool, str]:
    point = ParameterPoint()
    lengths = [
        free_body.spring_length(point, x, y) for x, y in free_body.equilibria(point, contact=0)
    ]
    residuals = {
        reading: max(
            abs(mpmath.polyval(_liftoff_polynomial(point, reading), length)) for length in lengths
        )
        for reading in ("right", "printed")
    }
    return (
        bool(lengths) and residuals["right"] < mpf(10) ** -40 and residuals["printed"] > 1e-6,
        f"at the lift-off equilibrium of the free body the quartic is {_below(residuals['right'])} "
        f"with the right d_0 and {show(residuals['printed'], 3)} with the printed one",
    )


def _constant_consequence(point: ParameterPoint) -> str:
    values = {reading: _liftoff_polynomial(point, reading)[-1] for reading in ("right", "printed")}
    roots = mpmath.polyroots(_liftoff_polynomial(point, "printed"), maxsteps=200, extraprec=200)
    real = [show(mpmath.re(root), 6) for root in roots if abs(mpmath.im(root)) < 1e-20]
    ((x, y),) = free_body.equilibria(point, contact=0)
    return (
        f"d_0 = {show(values['printed'])} instead of {show(values['right'])}; the lift-off length "
        f"at θ₀ = {point.theta0_deg}° is L = {show(free_body.spring_length(point, x, y))}, the "
        f"printed quartic has the real roots {', '.join(real) or 'none'}"
    )


MISPRINTS: dict[str, Explanation] = {
    "eq-6": Explanation(
        edits=("renaming",),
        cause="the index o of θ_o is missing: (4) and (5), squared and added, give the form with "
        "θ_o",
        evidence=_length_evidence,
        consequence=_length_consequence,
    ),
    "eq-9": Explanation(
        edits=("missing term",),
        cause="the preload F_L of (2) is lost on the way; it is back in (15) as −κ",
        evidence=_preload_evidence,
        consequence=_preload_consequence,
    ),
    "eq-13": Explanation(
        edits=("missing term",),
        cause="copied from (9) with the preload missing; (15) has it as −κ",
        evidence=_preload_evidence,
        consequence=_preload_consequence,
    ),
    "def-n": Explanation(
        edits=("missing factor",),
        cause="L_o is missing: every force is scaled by k_c L_o, as κ = F_L/(k_c L_o) shows",
        evidence=_force_scale_evidence,
        consequence=_force_scale_consequence,
    ),
    "A1-d0": Explanation(
        edits=("index", "index"),
        cause="c_0 and d_0 were set in one line; in lift-off b_3, b_4 stand where b_1, b_2 stand "
        "in contact",
        evidence=_constant_evidence,
        consequence=_constant_consequence,
    ),
}

APPROXIMATIONS: dict[str, Approximation] = {
    "eq-12": Approximation(
        limit="d V → ∞ on a belt that runs forward, V > 0: at steady sliding (10) gives μ = μ_o (1 "
        "− exp(−d |V|)), not μ_o. From here on μ_o stands for the "
        "friction at steady sliding, which makes every later row exact",
        exact=r"F_x = \frac{\sigma}{L}(1-L)(\cos\theta_o - x) + \alpha x - "
        r"\mu_o \left(1 - e^{- V d}\right) n = 0",
    ),
    "eq-27": Approximation(
        limit="d V → ∞, V > 0: (8) also has the damping n μ_o d exp(−d |V|) λ in its first row, "
        "from ∂μ/∂x'",
        exact=r"\det(\lambda^2 \mathbf{I} + \lambda \begin{bmatrix} n d \mu_o e^{- V d} & 0 \\ "
        r"0 & 0 \end{bmatrix} + \mathbf{K}) = 0",
    ),
}
