"""Functions of the equations of motion, everywhere and in each smooth regime."""

from __future__ import annotations

import sympy as sp

from ...emit.function import Function, Module
from .. import mechanics
from .. import nomenclature as nm
from .arrangement import ANGLE0, STIFFNESS, added, further


def module() -> Module:
    side = nm.side
    state = (nm.x, nm.y, nm.vx, nm.vy)
    length = mechanics.spring_length()
    equations = mechanics.motion()
    lengths = {nm.L: length}
    directions = {**lengths, nm.c: (nm.c0 - nm.x) / nm.L, nm.s: (nm.s0 - nm.y) / nm.L}
    regime = {
        nm.mu: mechanics.smooth_friction(side),
        nm.n: mechanics.contact_family(),
    }
    accelerations = {
        equations.ax: sp.solve(equations.x, equations.ax)[0],
        equations.ay: sp.solve(equations.y, equations.ay)[0],
    }
    arranged = tuple(map(sp.Add, _accelerations(), added(_accelerations(), tuple(accelerations.values()))))
    in_regime = tuple(value.subs(regime, simultaneous=True) for value in arranged)
    regimes_of_force = {nm.mu: mechanics.friction(), nm.n: _contact_force()}
    everywhere = tuple(value.subs(regimes_of_force, simultaneous=True) for value in arranged)
    jacobian, jacobian_names = _regime_jacobian(in_regime, side)
    slopes = _by_parameters(in_regime, length)
    parameters = (*ANGLE0, *nm.PARAMETERS, nm.V, nm.creep)
    moving = (*state, *parameters, nm.nbar, side)
    energy = _energy()
    power = regime[nm.mu] * regime[nm.n] * nm.vx
    return Module(
        "motion",
        "The equations of motion (8)–(11): everywhere, and in each regime in which they are smooth.",
        (
            Function("spring_length", "Length of the inclined spring.", "(6) corrected", (nm.x, nm.y, *ANGLE0), length, "L",
                     transcendental=True),
            Function("accelerations", "x″ and y″ for a given friction coefficient and contact force.", "(8), (9) corrected",
                     (nm.x, nm.y, nm.L, nm.mu, nm.n, *ANGLE0, nm.kappa, *STIFFNESS), arranged, "x″, y″",
                     further=further((), arranged)),
            Function("friction", "The friction coefficient at the speed x' of the mass.", "(10)", (nm.vx, nm.mu0, nm.V, nm.creep),
                     mechanics.friction(), "mu", transcendental=True, further=further(state, mechanics.friction())),
            Function("rhs", "x″ and y″, kinked where y = 0 and where x' = V.", "(8)–(11)",
                     (*state, *parameters), everywhere, "x″, y″", lengths, transcendental=True, further=further(state, everywhere)),
            Function("regime_rhs", "x″ and y″ in a smooth regime: contact (nbar = 1) or not (0), belt ahead (side = 1) or behind (−1).",
                     "(8)–(10)", moving, in_regime, "x″, y″", lengths, transcendental=True, further=further(state, in_regime)),
            Function("regime_jacobian", "Derivatives of regime_rhs with respect to x, y, x', y'.", "(8)–(10)",
                     moving, jacobian, "((∂x″/∂x, …), (∂y″/∂x, …))", jacobian_names, transcendental=True,
                     further=further(state, jacobian, jacobian_names)),
            Function("regime_by_parameters", "Derivatives of regime_rhs with respect to θ₀ (in radians), μ₀, κ, α, σ, β, V, d.", "(8)–(10)",
                     moving, slopes, "((∂x″/∂θ₀, …), (∂y″/∂θ₀, …))", lengths, transcendental=True,
                     further=further(state, slopes, lengths)),
            Function("energy", "Kinetic and stored energy, the preload's included, over k_c L_0².", "(1), (2)",
                     (*state, *ANGLE0, nm.kappa, *STIFFNESS, nm.nbar), energy, "energy", directions, transcendental=True),
            Function("friction_power", "Rate at which friction changes that energy.", "(8)",
                     (nm.y, nm.vx, nm.mu0, nm.V, nm.creep, nm.nbar, side),
                     power, "power", transcendental=True, further=further(state, power)),
        ),
    )  # fmt: skip


def _regime_jacobian(
    accelerations: tuple[sp.Expr, ...], side: sp.Symbol
) -> tuple[tuple[tuple[sp.Expr, ...], ...], dict[sp.Symbol, sp.Expr]]:
    """Derivatives of the accelerations in terms of −K, the friction and its slope; compared with direct differentiation."""
    state = (nm.x, nm.y, nm.vx, nm.vy)
    mu, slope, pull = sp.Symbol("mu", real=True), sp.Symbol("slope"), sp.Symbol("pull")
    length = mechanics.spring_length()
    friction = mechanics.smooth_friction(side)
    force = mechanics.contact_family()
    names = {
        nm.L: length,
        nm.c: (nm.c0 - nm.x) / nm.L,
        nm.s: (nm.s0 - nm.y) / nm.L,
        pull: nm.sigma / nm.L,
        mu: friction,
        slope: sp.diff(friction, nm.vx),
    }
    stiffness_x, stiffness_y = (
        [
            sp.diff(value, symbol) + sp.diff(value, nm.L) * mechanics.replace_length(sp.diff(length, symbol))
            for symbol in state[:2]
        ]
        for value in accelerations
    )
    derived = (
        (*stiffness_x, *(sp.diff(accelerations[0], symbol) for symbol in state[2:])),
        (*stiffness_y, *(sp.diff(accelerations[1], symbol) for symbol in state[2:])),
    )
    coupling = -pull * nm.s * nm.c
    arranged = (
        (pull * nm.s**2 - nm.alpha - nm.sigma, coupling + mu * sp.diff(force, nm.y), slope * force, sp.S.Zero),
        (coupling, pull * nm.c**2 - nm.beta - nm.nbar - nm.sigma, sp.S.Zero, sp.S.Zero),
    )
    polar = {nm.x: nm.c0 - nm.L * nm.c, nm.y: nm.s0 - nm.L * nm.s}
    values = {pull: names[pull], mu: friction, slope: names[slope]}
    rows = []
    for ours, theirs in zip(arranged, derived, strict=True):
        spelled = tuple(entry.subs(values).subs(polar) for entry in ours)
        surplus = added(spelled, tuple(sp.sympify(entry).subs(polar) for entry in theirs))
        rows.append(tuple(map(sp.Add, ours, surplus)))
    return tuple(rows), names


def _by_parameters(accelerations: tuple[sp.Expr, ...], length: sp.Expr) -> tuple[tuple[sp.Expr, ...], ...]:
    """Derivatives of the accelerations by the parameters, written in L: cos θ₀ and sin θ₀ both follow θ₀."""

    def total(value: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
        return sp.diff(value, symbol) + sp.diff(value, nm.L) * mechanics.replace_length(sp.diff(length, symbol))

    def by_angle(value: sp.Expr) -> sp.Expr:
        return nm.c0 * total(value, nm.s0) - nm.s0 * total(value, nm.c0)

    others = (*nm.PARAMETERS, nm.V, nm.creep)
    return tuple((by_angle(value), *(sp.diff(value, symbol) for symbol in others)) for value in accelerations)


def _contact_force() -> sp.Expr:
    """n(y) without a case distinction, (11); held against the law of the mechanics below, on and above the belt."""
    arranged = (sp.Abs(nm.y) - nm.y) / 2
    u = sp.Symbol("u", positive=True)
    for place in (-u, sp.S.Zero, u):
        if arranged.subs(nm.y, place) != mechanics.contact_law().subs(nm.y, place):
            raise ArithmeticError("n(y) is not (11): the emitted right-hand side needs another form of the contact law")
    return arranged


def _energy() -> sp.Expr:
    """The energy with the spring's as k (L − 1)²/2, which loses no digits where the spring is hardly compressed."""
    ground = nm.alpha * nm.x**2 / 2 + nm.beta * nm.y**2 / 2 + nm.nbar * nm.y**2 / 2 + nm.kappa * nm.y
    arranged = ground + nm.sigma * (1 - nm.L) ** 2 / 2 + nm.vx**2 / 2 + nm.vy**2 / 2
    polar = {nm.x: nm.c0 - nm.L * nm.c, nm.y: nm.s0 - nm.L * nm.s}
    (surplus,) = added((arranged.subs(polar),), (mechanics.energy().subs(polar),))
    return arranged + surplus


def _accelerations() -> tuple[sp.Expr, sp.Expr]:
    spring = nm.sigma * (nm.L - 1) / nm.L
    return (
        spring * (nm.c0 - nm.x) - nm.alpha * nm.x + nm.mu * nm.n,
        spring * (nm.s0 - nm.y) - nm.beta * nm.y + nm.n - nm.kappa,
    )
