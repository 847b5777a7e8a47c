"""From energies and forces to the dimensionless equations of motion, (1)–(11).

One mass slides on a moving belt. Springs k_x and k_y tie it to the ground, a spring k of undeformed length L_0 leans on
it under the angle θ₀, and the belt carries it through the contact stiffness k_c. The assumptions stand in
:func:`potential_energy`, :func:`applied_force`, :func:`contact_force` and :func:`friction_law`, and nowhere else. Change one of
them, and ``python -m derive --variant --out DIR`` derives the equations of motion anew, says which printed rows no longer hold, and
writes the new model. The elimination, the closed forms and the theorem are made for the forces of the article: where a change
takes away what they rest on, the derivation stops, says what does not hold, and writes nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp
from sympy.physics.mechanics import LagrangesMethod, Point, ReferenceFrame, dynamicsymbols

from . import nomenclature as nm

# ---------------------------------------------------------------------------------------------- assumptions


def spring_length(x: sp.Expr, y: sp.Expr, L_0: sp.Expr) -> sp.Expr:
    """Distance from the spring's anchor, at L_0 (cos θ₀, sin θ₀), to the mass at (x, y): (4)–(6)."""
    return sp.sqrt((L_0 * nm.c0 - x) ** 2 + (L_0 * nm.s0 - y) ** 2)


def potential_energy(x: sp.Expr, y: sp.Expr) -> sp.Expr:
    """Energy stored in the springs to ground and in the inclined spring, compressed by Δ of (3), whose angle follows the mass."""
    stretch = spring_length(x, y, nm.L_0) - nm.L_0
    return (nm.k_x * x**2 + nm.k_y * y**2 + nm.k * stretch**2) / 2


def applied_force(mu: sp.Expr, N: sp.Expr, vx: sp.Expr, vy: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Forces with no potential: the belt pushes with N, drags with μ N, and F_L presses down."""
    return mu * N, N - nm.F_L


def contact_force(y: sp.Expr, stiffness: sp.Expr) -> sp.Expr:
    """Unilateral contact, (7): the belt pushes when the mass dips below it and never pulls."""
    return sp.Piecewise((-stiffness * y, y < 0), (0, True))


def friction_law(slip: sp.Expr, mu0: sp.Expr, creep: sp.Expr) -> sp.Expr:
    """Regularized Coulomb friction, (10), at the sliding speed ``slip`` = V − x'."""
    return mu0 * (1 - sp.exp(-creep * sp.Abs(slip))) * sp.sign(slip)


# ------------------------------------------------------------------------------------- equations of motion


@dataclass(frozen=True)
class Motion:
    """Residuals of the two equations of motion, ``acceleration terms − forces = 0``, and the symbols in them."""

    x: sp.Expr
    y: sp.Expr
    ax: sp.Symbol
    ay: sp.Symbol


#: Accelerations, with dimensions and without.
AX, AY = sp.symbols("x_tt y_tt", real=True)


@cache
def dimensional_motion() -> Motion:
    """Lagrange's equations, (1) and (2), for a contact force N and a friction coefficient μ yet to be given."""
    qx, qy = dynamicsymbols("qx qy")
    ux, uy = dynamicsymbols("qx qy", 1)
    frame, origin = ReferenceFrame("belt"), Point("O")
    origin.set_vel(frame, 0)
    mass = origin.locatenew("mass", qx * frame.x + qy * frame.y)
    mass.set_vel(frame, ux * frame.x + uy * frame.y)

    kinetic = nm.m_mass * mass.vel(frame).magnitude() ** 2 / 2
    force_x, force_y = applied_force(nm.mu, nm.N, ux, uy)
    method = LagrangesMethod(
        kinetic - potential_energy(qx, qy),
        [qx, qy],
        forcelist=[(mass, force_x * frame.x + force_y * frame.y)],
        frame=frame,
    )
    time = dynamicsymbols._t
    plain = [
        (qx.diff(time, 2), AX), (qy.diff(time, 2), AY), (ux, nm.vx), (uy, nm.vy), (qx, nm.x), (qy, nm.y),
    ]  # fmt: skip
    residual_x, residual_y = (row.doit().subs(plain) for row in method.form_lagranges_equations())
    return Motion(residual_x, residual_y, AX, AY)


@cache
def scales() -> dict[str, sp.Expr]:
    """Scales of length, time and force of the text after (9), found by asking that L_0, the inertia and the contact become 1."""
    length, time, force = sp.symbols("length time_scale force", positive=True)
    (solution,) = sp.solve(
        [
            nm.L_0 / length - 1,
            nm.m_mass * length / (time**2 * force) - 1,
            nm.k_c * length / force - 1,
        ],
        [length, time, force],
        dict=True,
    )
    return {"length": solution[length], "time": solution[time], "force": solution[force]}


@cache
def groups() -> dict[sp.Symbol, tuple[sp.Symbol, sp.Expr]]:
    """Each dimensionless quantity of the text after (9) with the dimensional one behind it and the scale between the two."""
    length, time, force = (scales()[name] for name in ("length", "time", "force"))
    stiffness, speed = force / length, length / time
    return {
        nm.sigma: (nm.k, stiffness),
        nm.alpha: (nm.k_x, stiffness),
        nm.beta: (nm.k_y, stiffness),
        nm.kappa: (nm.F_L, force),
        nm.n: (nm.N, force),
        nm.V: (nm.V_dim, speed),
        nm.creep: (nm.d_dim, 1 / speed),
    }


def further_parameters() -> tuple[sp.Symbol, ...]:
    """Dimensionless parameters that the published model does not have, in the order of :func:`groups`."""
    published = {*nm.PARAMETERS, nm.n, nm.V, nm.creep}
    return tuple(symbol for symbol in groups() if symbol not in published)


@cache
def motion() -> Motion:
    """The dimensionless equations of motion, (8) and (9), at rest (12) and (13), in x, y and the spring length L."""
    with_units = dimensional_motion()
    length, time, force = (scales()[name] for name in ("length", "time", "force"))
    scaled = {
        nm.x: length * nm.x, nm.y: length * nm.y,
        nm.vx: length / time * nm.vx, nm.vy: length / time * nm.vy,
        AX: length / time**2 * AX, AY: length / time**2 * AY,
    }  # fmt: skip
    ratios = {dimensional: symbol * scale for symbol, (dimensional, scale) in groups().items()}

    def nondimensional(residual: sp.Expr) -> sp.Expr:
        value = residual.subs(scaled, simultaneous=True).subs(ratios, simultaneous=True) / force
        return replace_length(sp.expand(sp.simplify(value)))

    return Motion(nondimensional(with_units.x), nondimensional(with_units.y), AX, AY)


def replace_length(expression: sp.Expr) -> sp.Expr:
    """Write the symbol L for the square root of (6) wherever it stands."""
    square = sp.expand(spring_length(nm.x, nm.y, sp.S.One) ** 2)

    def is_length(node: sp.Basic) -> bool:
        return isinstance(node, sp.Pow) and node.exp.is_Rational and node.exp.q == 2 and sp.expand(node.base - square) == 0

    return expression.replace(is_length, lambda node: nm.L ** (2 * node.exp))


@cache
def contact_law() -> sp.Expr:
    """n(y), (11): the contact law over the force scale; less its slope is n̄, (29)."""
    force, length = scales()["force"], scales()["length"]
    (pushing, _), (apart, _) = contact_force(nm.y * length, nm.k_c).args
    return sp.Piecewise((sp.simplify(pushing / force), nm.y < 0), (sp.simplify(apart / force), True))


@cache
def contact_family() -> sp.Expr:
    """n as one expression for contact (n̄ = 1) and lift-off (n̄ = 0)."""
    (pushing, _), (apart, _) = contact_law().args
    return nm.nbar * pushing + (1 - nm.nbar) * apart


@cache
def friction() -> sp.Expr:
    """μ at the dimensionless sliding speed V − x', (10)."""
    return friction_law(nm.V - nm.vx, nm.mu0, nm.creep)


def smooth_friction(side: sp.Expr) -> sp.Expr:
    """(10) where sgn(V − x') = ``side``, without the absolute value and the sign that kink it at V = x'."""
    slip = sp.Symbol("slip", positive=True)
    return side * friction_law(slip, nm.mu0, nm.creep).subs(slip, side * (nm.V - nm.vx))


@cache
def sliding_forces() -> tuple[sp.Expr, sp.Expr]:
    """Left sides of (8) and (9) without the accelerations, near steady sliding, where the belt outruns the mass."""
    equations = motion()
    sliding = {AX: 0, AY: 0, nm.mu: smooth_friction(sp.S.One), nm.n: contact_family()}
    return equations.x.subs(sliding), equations.y.subs(sliding)


@cache
def steady_friction() -> sp.Expr:
    """μ at steady sliding, x' = 0 < V: μ₀ (1 − exp(−d V)) exactly, μ₀ in the limit that (12) takes."""
    return smooth_friction(sp.S.One).subs(nm.vx, 0)


@cache
def energy() -> sp.Expr:
    """Kinetic and potential energy over k_c L_0², with the preload and, for n̄ = 1, the contact spring."""
    length, force = scales()["length"], scales()["force"]
    ratios = {dimensional: symbol * scale for symbol, (dimensional, scale) in groups().items()}
    scaled = {nm.x: length * nm.x, nm.y: length * nm.y}
    stored = potential_energy(nm.x, nm.y).subs(scaled, simultaneous=True).subs(ratios, simultaneous=True) / (force * length)
    preload_and_contact = sp.integrate(nm.kappa - contact_family(), nm.y)
    return replace_length(sp.simplify(stored)) + preload_and_contact + (nm.vx**2 + nm.vy**2) / 2
