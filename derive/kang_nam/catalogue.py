"""Which functions are generated: name, arguments, results, and the algebra of each, taken from the derivation."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from .. import algebra
from . import catastrophe, elimination, equilibrium, linear_sprag, mechanics, stability
from . import nomenclature as nm

#: Nested results: an expression, or a tuple of such.
Results = sp.Expr | tuple["Results", ...]


@dataclass(frozen=True)
class Function:
    """One generated function.

    ``results`` are written in the ``arguments`` and in shorthands, each defined in ``shorthands`` (in terms of arguments and
    of earlier shorthands). ``transcendental`` functions take the namespace of their square roots and exponentials.
    """

    name: str
    summary: str
    equations: str
    arguments: tuple[sp.Symbol, ...]
    results: Results
    returns: str
    shorthands: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    transcendental: bool = False
    #: Without shared subexpressions, where each quotient should be rounded once.
    share: bool = True
    #: Arguments beyond those of the published model, which a changed assumption brings in: last, and 0 where left out.
    further: tuple[sp.Symbol, ...] = ()

    @property
    def accepted(self) -> tuple[sp.Symbol, ...]:
        """All arguments, in order."""
        return (*self.arguments, *self.further)


@dataclass(frozen=True)
class Module:
    """One generated module."""

    name: str
    summary: str
    functions: tuple[Function, ...]


_ANGLE0 = (nm.c0, nm.s0)
_ANGLE = (nm.c, nm.s)
_STIFFNESS = (nm.alpha, nm.sigma, nm.beta)
_PARAMETERS = nm.PARAMETERS
_F = (nm.fa, nm.fb, nm.fd, nm.fm)


def _nested(matrix: sp.Matrix) -> tuple[tuple[sp.Expr, ...], ...]:
    return tuple(tuple(matrix.row(row)) for row in range(matrix.rows))


def _same(what: str, arranged: tuple[sp.Expr, ...], derived: tuple[sp.Expr, ...], names: dict[sp.Symbol, sp.Expr] | None = None) -> None:
    """Refuse an arrangement for emission that is not, exactly, what was derived."""
    for ours, theirs in zip(arranged, derived, strict=True):
        for _ in range(3):
            ours = ours.subs(names or {})
        if not algebra.equal(equilibrium.spell_out(ours), equilibrium.spell_out(theirs)):
            raise ArithmeticError(f"{what}: the arrangement for emission is not what was derived")


def _shorthands(case: dict[sp.Symbol, int] | None = None, *names: sp.Symbol) -> dict[sp.Symbol, sp.Expr]:
    """Definitions of the shorthands, in contact, in lift-off, or in n̄."""
    definitions = {**equilibrium.SHORTHANDS, **elimination.f_coefficients()}
    return {symbol: value.subs(case or {}) for symbol, value in definitions.items() if not names or symbol in names}


def further_parameters() -> tuple[sp.Symbol, ...]:
    """Dimensionless parameters that the published model does not have, in the order of :func:`derive.mechanics.groups`."""
    published = {*_PARAMETERS, nm.n, nm.V, nm.creep}
    return tuple(symbol for symbol in mechanics.groups() if symbol not in published)


def _further(listed: tuple[sp.Symbol, ...], results: Results, names: dict[sp.Symbol, sp.Expr] | None = None) -> tuple[sp.Symbol, ...]:
    """What the results depend on beside the arguments that are listed: speeds, and parameters that a variant brings in."""
    free = {symbol for leaf in _leaves(results) for symbol in sp.sympify(leaf).free_symbols}
    for value in (names or {}).values():
        free |= sp.sympify(value).free_symbols
    return tuple(symbol for symbol in (nm.vx, nm.vy, *further_parameters()) if symbol in free and symbol not in listed)


def _leaves(results: Results) -> list[sp.Expr]:
    return [leaf for item in results for leaf in _leaves(item)] if isinstance(results, tuple) else [results]


def _added(arranged: tuple[sp.Expr, ...], derived: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    """What a changed assumption adds to the arrangement of the published model: zeros, if none was changed."""
    return tuple(
        sp.factor_terms(algebra.difference(equilibrium.spell_out(theirs), equilibrium.spell_out(ours)))
        for ours, theirs in zip(arranged, derived, strict=True)
    )


def modules() -> tuple[Module, ...]:
    """Everything that is generated."""
    return (_scales(), _equilibrium(), _stability(), _catastrophe(), _linear_sprag(), _motion())


# ------------------------------------------------------------------------------------------------------ scales


def _scales() -> Module:
    scales, groups = mechanics.scales(), mechanics.groups()
    published = (nm.kappa, nm.alpha, nm.sigma, nm.beta, nm.V, nm.creep)
    dimensionless = (*published, *further_parameters())
    dimensional = tuple(groups[symbol][0] for symbol in published)
    further = tuple(groups[symbol][0] for symbol in further_parameters())
    return Module(
        "scales",
        "Between newtons, metres and seconds and the dimensionless model: text after (9).",
        (
            Function(
                "scales", "Scales of length, time and force.", "text after (9)", (nm.m_mass, nm.k_c, nm.L_0),
                (scales["length"], scales["time"], scales["force"]), "length, time, force", transcendental=True, share=False,
            ),
            Function(
                "dimensionless_groups", "The dimensionless parameters of dimensional data.", "text after (9)",
                (nm.m_mass, nm.k_c, nm.L_0, *dimensional),
                tuple(groups[symbol][0] / groups[symbol][1] for symbol in dimensionless),
                ", ".join(str(symbol) for symbol in dimensionless), transcendental=True, share=False, further=further,
            ),
        ),
    )  # fmt: skip


# ------------------------------------------------------------------------------------------------- equilibrium


def _quartic(case: dict[sp.Symbol, int]) -> tuple[tuple[sp.Expr, ...], dict[sp.Symbol, sp.Expr]]:
    """The quartic in L in the arrangement that keeps its squares together, and its shorthands."""
    b1, b2, p, q, M, sigma = nm.b1, nm.b2, nm.p, nm.q, nm.M, nm.sigma
    arranged = (
        sigma**2 * (b1**2 + b2**2 - sigma**2),
        2 * sigma * (M * b1 * b2 - q * (b1**2 - sigma**2) - p * (b2**2 - sigma**2)),
        (M * b2 - q * b1) ** 2 + p**2 * b2**2 - sigma**2 * (p**2 + q**2 + 4 * p * q),
        2 * sigma * p * q * (p + q),
        -((p * q) ** 2),
    )
    _same("quartic in L", arranged, elimination.quartic_in_L_shorthand())
    _, b = equilibrium.matrix_form()
    shorthands = {
        **_shorthands(case, nm.B, nm.M, nm.p, nm.q),
        nm.b1: -(nm.alpha * nm.c0 + nm.M * nm.s0),
        nm.b2: -(nm.B * nm.s0 + nm.kappa),
    }
    _same("right side of (16)", (shorthands[nm.b1], shorthands[nm.b2]), tuple(b))
    if case[nm.nbar] == 0:
        arranged = tuple(value.subs(nm.M, 0) for value in arranged)
        shorthands[nm.b1] = shorthands[nm.b1].subs(nm.M, 0)
        del shorthands[nm.M]
    return arranged, shorthands


def _matrix(D: sp.Matrix, case: dict[sp.Symbol, int]) -> tuple[tuple[sp.Expr, ...], ...]:
    """D of (18) or (24) with p and q kept together."""
    arranged = sp.Matrix([[nm.sigma - nm.p * nm.L, -nm.M * nm.L], [0, nm.sigma - nm.q * nm.L]])
    _same("D", tuple(arranged), tuple(D))
    return _nested(arranged if case[nm.nbar] else arranged.subs(nm.M, 0))


def _equilibrium() -> Module:
    D, b = equilibrium.matrix_form()
    contact, liftoff = equilibrium.CONTACT, equilibrium.LIFTOFF
    contact_quartic, contact_names = _quartic(contact)
    liftoff_quartic, liftoff_names = _quartic(liftoff)
    state = elimination.state()
    along, across = equilibrium.balance()
    singular = elimination.singular_lengths()
    f = elimination.f_form
    return Module(
        "equilibrium",
        "The balance of forces at steady sliding (n̄ = 1) and in lift-off (n̄ = 0), and the polynomials that hold its roots.",
        (
            Function("contact_matrix", "D of the balance in contact.", "(17), (18)", (nm.L, nm.mu0, *_STIFFNESS),
                     _matrix(D, contact), "((D11, D12), (D21, D22))", _shorthands(contact, nm.B, nm.M, nm.p, nm.q)),
            Function("contact_vector", "b of the balance in contact.", "(19), (A10), (A11)",
                     (*_ANGLE0, nm.mu0, nm.kappa, nm.alpha, nm.beta), tuple(b.subs(contact)), "b1, b2"),
            Function("contact_quartic", "Coefficients of c0 + c1 L + c2 L² + c3 L³ + c4 L⁴ = 0 in contact.",
                     "(21), (A1)–(A5)", (*_ANGLE0, *_PARAMETERS), contact_quartic, "c0, c1, c2, c3, c4", contact_names),
            Function("liftoff_matrix", "D of the balance in lift-off.", "(24)", (nm.L, *_STIFFNESS),
                     _matrix(D, liftoff), "((D11, D12), (D21, D22))", _shorthands(liftoff, nm.B, nm.M, nm.p, nm.q)),
            Function("liftoff_vector", "b of the balance in lift-off.", "(25), (A12), (A13)",
                     (*_ANGLE0, nm.kappa, nm.alpha, nm.beta), tuple(b.subs(liftoff)), "b3, b4"),
            Function("liftoff_quartic", "Coefficients of d0 + d1 L + d2 L² + d3 L³ + d4 L⁴ = 0 in lift-off, d0 as derived.",
                     "(26), (A1) corrected, (A6)–(A9)", (*_ANGLE0, nm.kappa, *_STIFFNESS), liftoff_quartic,
                     "d0, d1, d2, d3, d4", liftoff_names),
            Function("singular_lengths", "Spring lengths at which D is singular and (20) cannot give the state.", "(17)",
                     (*_STIFFNESS, nm.nbar), singular, "L at which D11 = 0, L at which D22 = 0"),
            Function("f_coefficients", "a, b, d, m of f(θ) = a sin θ cos θ + b cos θ + d sin θ − m sin² θ = q sin θ F_x(θ, L(θ)).",
                     "(12), (13) eliminated", (*_ANGLE0, *_PARAMETERS, nm.nbar), _F, "a, b, d, m", _shorthands()),
            Function("f_magnitudes", "Sums of the absolute values of the terms of a and d, against which their rounding errors are "
                     "measured.", "rounding-error analysis", (*_ANGLE0, *_PARAMETERS, nm.nbar), _magnitudes(), "|a|, |d|",
                     _shorthands(None, nm.B, nm.M, nm.q)),
            Function("f", "The scalar function whose roots are the equilibria.", "(12), (13) eliminated", (*_ANGLE, *_F), f, "f"),
            Function("f_slope", "df/dθ, which is L det K at an equilibrium.", "(12), (13) eliminated", (*_ANGLE, *_F),
                     sp.collect(catastrophe.slope, nm.s), "f′"),
            Function("f_curvature", "d²f/dθ².", "(12), (13) eliminated", (*_ANGLE, *_F), catastrophe.curvature, "f″"),
            Function("f_third", "d³f/dθ³.", "(12), (13) eliminated", (*_ANGLE, *_F), catastrophe.third, "f‴"),
            Function("t_quartic", "Coefficients of (1 + t²)² f = e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ with t = tan(θ/2).",
                     "(12), (13) eliminated", _F, elimination.quartic_in_t(), "e0, e1, e2, e3, e4"),
            Function("resolvent", "Coefficients of the cubic r0 + r1 ℓ + r2 ℓ² + ℓ³ with the discriminant of the quartic in t.",
                     "(12), (13) eliminated", _F, _resolvent(), "r0, r1, r2"),
            Function("state", "Spring length and displacement at an equilibrium with direction θ.", "(4), (5), (13) or (15)",
                     (*_ANGLE, *_ANGLE0, nm.kappa, nm.sigma, nm.beta, nm.nbar), (nm.L, state[nm.x], state[nm.y]), "L, x, y",
                     {**_shorthands(None, nm.B, nm.q), nm.L: state[nm.L]}),
            Function("residuals", "F_x and F_y at spring length L and direction θ.", "(12)–(15)",
                     (*_ANGLE, nm.L, *_ANGLE0, *_PARAMETERS, nm.nbar), _residuals(along, across), "F_x, F_y"),
        ),
    )  # fmt: skip


def _resolvent() -> tuple[sp.Expr, ...]:
    r0, r1, r2, one = elimination.resolvent_cubic()
    if one != 1:
        raise ArithmeticError("the resolvent is not monic")
    return sp.factor(r0), sp.factor(r1), r2


def _magnitudes() -> tuple[sp.Expr, sp.Expr]:
    """a and d with every term made positive, for 0 < θ₀ < π and parameters that are not negative."""
    coefficients = elimination.f_coefficients()
    return (
        coefficients[nm.fa].subs(nm.alpha, -nm.alpha),
        coefficients[nm.fd].subs({nm.c0: sp.Abs(nm.c0), nm.kappa: -nm.kappa}),
    )


def _residuals(along: sp.Expr, across: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    x, y = equilibrium.displacement()
    arranged = (
        nm.sigma * (1 - nm.L) * nm.c + nm.alpha * x + nm.mu0 * nm.nbar * y,
        nm.sigma * (1 - nm.L) * nm.s + (nm.beta + nm.nbar) * y + nm.kappa,
    )
    _same("residuals (14), (15)", arranged, (along, across))
    return arranged


# --------------------------------------------------------------------------------------------------- stability


def _stability() -> Module:
    K = stability.stiffness()
    pull = nm.sigma / nm.L
    arranged = sp.Matrix([
        [nm.p - pull * nm.s**2, pull * nm.s * nm.c + nm.M],
        [pull * nm.s * nm.c, nm.q - pull * nm.c**2],
    ])  # fmt: skip
    _same("K (28)", tuple(arranged), tuple(K))
    entries = sp.symbols("K11 K12 K21 K22")
    C = stability.damping()
    generic = sp.Matrix(2, 2, entries)
    C11 = sp.Symbol("C11")
    characteristic = sp.Poly(stability.characteristic(generic, sp.diag(C11, 0)), stability.lam).all_coeffs()
    if C[0, 1] != 0 or C[1, 0] != 0 or C[1, 1] != 0:
        characteristic = sp.Poly(stability.characteristic(generic, C), stability.lam).all_coeffs()
    determinant = stability.determinant(generic)
    crossing, crossing_names = _flutter_crossing()
    cubic, cubic_names = _flutter_cubic()
    contact = _shorthands(equilibrium.CONTACT, nm.B, nm.M, nm.p, nm.q)
    at_friction = (*_ANGLE, nm.mu0, nm.kappa, *_STIFFNESS)
    return Module(
        "stability",
        "Linearization about an equilibrium: K, its invariants, the damping that (27) leaves out, the flutter onsets.",
        (
            Function("stiffness", "K, the Jacobian of (F_x, F_y).", "(28)",
                     (*_ANGLE, nm.L, nm.mu0, *_STIFFNESS, nm.nbar), _nested(arranged), "((K11, K12), (K21, K22))",
                     _shorthands(None, nm.B, nm.M, nm.p, nm.q)),
            Function("invariants", "Trace, determinant (negative: divergence) and discriminant in λ² (negative: flutter) of K.",
                     "(27)", entries, (stability.trace(generic), determinant, stability.flutter_discriminant(generic)),
                     "trace, determinant, discriminant"),
            Function("damping", "∂F_x/∂x' at steady sliding.", "(8), (10) linearized",
                     tuple(symbol for symbol in (nm.y, nm.mu0, nm.V, nm.creep, nm.nbar) if C[0, 0].has(symbol)),
                     C[0, 0], "C11", transcendental=True, further=_further((), C[0, 0])),
            Function("characteristic", "Coefficients of det(λ² I + λ C + K), highest power first; C11 = 0 is (27).",
                     "(27) with damping", (*entries, C11), tuple(characteristic), "e4, e3, e2, e1, e0"),
            Function("reference_lines", "u1, w1, u2, w2 of sin θ₀ = u1 + w1 L and α cos θ₀ = u2 + w2 L, in contact at given θ and μ₀.",
                     "(14), (15)", at_friction, _reference_lines(), "u1, w1, u2, w2", contact),
            Function("flutter_quadratic", "Coefficients of e0 + e1 L + e2 L², which is L² times the discriminant of (27), in contact.",
                     "(27)", (*_ANGLE, nm.mu0, *_STIFFNESS), stability.flutter_quadratic(), "e0, e1, e2", contact),
            Function("flutter_elimination", "X, Y, Z: X² = Y Z at the θ of every flutter onset in contact, and L = X/Y is its length.",
                     "(27), (14), (15)", at_friction, stability.flutter_elimination(), "X, Y, Z", {**contact, **_flutter_names()}),
            Function("flutter_without_alpha", "The same for α = 0: zero at the θ of every flutter onset, where L = −u2/w2.",
                     "(27), (14), (15)", (*_ANGLE, nm.mu0, nm.kappa, nm.sigma, nm.beta), stability.flutter_without_alpha(),
                     "condition", {name: value.subs(nm.alpha, 0) for name, value in {**contact, **_flutter_names()}.items()}),
            Function("flutter_crossing", "N, J: L² times the discriminant changes by N/J per unit of θ₀, along equilibria in contact.",
                     "(27), (14), (15)", (*_ANGLE, nm.L, *_ANGLE0, nm.mu0, *_STIFFNESS), crossing, "N, J", crossing_names),
            Function("flutter_cubic", "Flutter onsets in contact at a given θ: cos θ₀ (g0 + g1 sin θ₀) = k0 + k1 sin θ₀ + … + k3 sin³ θ₀.",
                     "(27), (14), (15)", (*_ANGLE, nm.kappa, *_STIFFNESS), cubic, "g0, g1, k0, k1, k2, k3", cubic_names),
            Function("flutter_friction", "μ₀ at a flutter onset with spring length L in direction θ, in contact.", "(27)",
                     (*_ANGLE, nm.L, *_STIFFNESS), stability.flutter_friction(), "mu0", _shorthands(equilibrium.CONTACT, nm.B)),
        ),
    )  # fmt: skip


def _flutter_names() -> dict[sp.Symbol, sp.Expr]:
    """The coefficients that the elimination is written in."""
    return dict(zip((*stability.LINES, *stability.QUADRATIC), (*_reference_lines(), *stability.flutter_quadratic()), strict=True))


def _reference_lines() -> tuple[sp.Expr, ...]:
    friction, preload = nm.M / nm.B, nm.sigma * nm.s + nm.kappa
    arranged = (
        -preload / nm.B,
        nm.q * nm.s / nm.B,
        friction * preload - nm.sigma * nm.c,
        nm.p * nm.c - friction * nm.sigma * nm.s,
    )
    _same("the reference lines", arranged, stability.reference_lines())
    return arranged


def _flutter_crossing() -> tuple[tuple[sp.Expr, sp.Expr], dict[sp.Symbol, sp.Expr]]:
    """By Cramer's rule in the derivatives of the balances along and across the belt with respect to θ, L and θ₀."""
    a_t, a_l, a_0, b_t, b_l, b_0, d_t, d_l = sp.symbols("a_theta a_L a_theta0 b_theta b_L b_theta0 d_theta d_L")
    _, e1, e2 = stability.flutter_quadratic()
    names = {
        **_shorthands(equilibrium.CONTACT, nm.B, nm.M, nm.p, nm.q),
        a_t: nm.s * (nm.p * nm.L - nm.sigma) - nm.M * nm.L * nm.c,
        a_l: -nm.p * nm.c - nm.M * nm.s,
        a_0: nm.M * nm.c0 - nm.alpha * nm.s0,
        b_t: -nm.c * (nm.q * nm.L - nm.sigma),
        b_l: -nm.q * nm.s,
        b_0: nm.B * nm.c0,
        d_t: 4 * nm.sigma * nm.L * (nm.M * (nm.c**2 - nm.s**2) - 2 * (nm.alpha - nm.B) * nm.s * nm.c),
        d_l: e1 + 2 * e2 * nm.L,
    }
    crossing = (
        d_t * (a_0 * b_l - b_0 * a_l) + d_l * (a_t * b_0 - b_t * a_0),
        b_t * a_l - a_t * b_l,
    )
    local = {name: value for name, value in names.items() if name not in equilibrium.SHORTHANDS}
    _same("the crossing of a flutter onset", crossing, stability.flutter_crossing(), local)
    return crossing, names


def _flutter_cubic() -> tuple[tuple[sp.Expr, ...], dict[sp.Symbol, sp.Expr]]:
    """With L = l0 + l1 sin θ₀ and y = y0 + y1 sin θ₀: the discriminant without friction times y, and the spring's pull along."""
    l0, l1, y0, y1, e0, e1, e2, m1, m2 = sp.symbols("l0 l1 y0 y1 e0 e1 e2 m1 m2")
    c, s, sigma = nm.c, nm.s, nm.sigma
    pull = 4 * sigma * s * c**2
    names = {
        **_shorthands(equilibrium.CONTACT, nm.B, nm.p, nm.q),
        l0: (sigma * s + nm.kappa) / (nm.q * s),
        l1: nm.B / (nm.q * s),
        y0: -(sigma * s + nm.kappa) / nm.q,
        y1: sigma / nm.q,
        **dict(zip((e0, e1, e2), (value.subs(nm.M, 0) for value in stability.flutter_quadratic()), strict=True)),
        m1: -pull * sigma,
        m2: pull * nm.p,
    }
    d0, d1, d2 = e0 + l0 * (e1 + e2 * l0), l1 * (e1 + 2 * e2 * l0), e2 * l1**2
    weight = 4 * sigma * s * c * nm.alpha
    cubic = (
        weight * l0,
        weight * l1,
        d0 * y0 + l0 * (m1 + m2 * l0),
        d1 * y0 + d0 * y1 + l1 * (m1 + 2 * m2 * l0),
        d2 * y0 + d1 * y1 + m2 * l1**2,
        d2 * y1,
    )
    local = {name: value for name, value in names.items() if name not in equilibrium.SHORTHANDS}
    _same("flutter cubic", cubic, stability.flutter_cubic(), local)
    return cubic, names


# ------------------------------------------------------------------------------------------------- catastrophe


def _line(relation: sp.Expr, symbol: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """u and w of ``relation = u + w · symbol``."""
    slope = sp.diff(relation, symbol)
    if slope.has(symbol):
        raise ArithmeticError(f"the fold relations are not linear in {symbol}")
    return sp.factor_terms(relation.subs(symbol, 0)), sp.factor_terms(slope)


def _catastrophe() -> Module:
    contact = _shorthands(equilibrium.CONTACT, nm.B, nm.p, nm.q, nm.fa)
    s0, c0 = catastrophe.fold_angles()
    spelled = [
        sp.expand(equilibrium.spell_out(relation).subs(equilibrium.CONTACT)) for relation in catastrophe.fold_residuals()
    ]
    in_parameters = (*_ANGLE, *_ANGLE0, nm.mu0, nm.kappa, *_STIFFNESS)
    lines = tuple(
        Function(
            f"fold_lines_{symbol}",
            f"The two fold relations as lines in {symbol}: u1 + w1 {symbol} = 0 and u2 + w2 {symbol} = 0.", "f = f′ = 0",
            tuple(other for other in in_parameters if other != symbol),
            tuple(part for relation in spelled for part in _line(relation, symbol)), "u1, w1, u2, w2",
        )
        for symbol in _PARAMETERS
    )  # fmt: skip
    friction, quartic, quartic_names = _fold_quartic(s0, c0)
    cusp_polynomial, cusp_names = _cusp_polynomial()
    cusp_s0, cusp_ratio = _cusp_angles()
    cusp_mu = catastrophe.cusp_friction() / nm.c / nm.sigma
    return Module(
        "catastrophe",
        "The equilibrium surface, its folds (f = f′ = 0) and cusps (f″ = 0 as well), in contact.",
        (
            Function("surface", "μ₀ on the equilibrium surface over (θ, θ₀): f is linear in μ₀.", "(14), (15)",
                     (*_ANGLE, *_ANGLE0, nm.kappa, *_STIFFNESS), catastrophe.surface_in_coefficients(), "mu0",
                     {**contact, nm.fb: _shorthands()[nm.fb]}),
            Function("fold_residuals", "Both are zero exactly where f = f′ = 0.", "f = f′ = 0", (nm.c, nm.s, *_F),
                     tuple(symbol - value for symbol, value in catastrophe.fold_relations().items()), "b − b(fold), d − d(fold)"),
            *lines,
            Function("fold_angles", "sin θ₀ and cos θ₀ of the fold through θ at friction μ₀. Needs α > 0.", "f = f′ = 0",
                     (*_ANGLE, nm.mu0, nm.kappa, *_STIFFNESS), friction, "sin0, cos0", contact),
            Function("fold_sine", "sin θ₀ of the fold through θ at friction μ₀, for any α ≥ 0.", "f = f′ = 0",
                     (*_ANGLE, nm.mu0, nm.kappa, *_STIFFNESS), friction[0], "sin0", contact),
            Function("fold_quartic", "Coefficients of e0 + … + e4 μ₀⁴, whose real roots are all folds at a given θ. Needs α > 0.",
                     "f = f′ = 0", (*_ANGLE, nm.kappa, *_STIFFNESS), quartic, "e0, e1, e2, e3, e4", quartic_names),
            Function("fold_conic", "All folds at a given θ, friction eliminated: E0 + E1 sin θ₀ + E2 sin² θ₀ + Ec cos θ₀ = 0, for any α ≥ 0.",
                     "f = f′ = 0", (*_ANGLE, nm.kappa, *_STIFFNESS), _fold_conic(), "E0, E1, E2, Ec", contact),
            Function("fold_quadratic", "The same for α = 0: e0 + e1 μ₀ + e2 μ₀², and sin θ₀ as for α > 0.", "f = f′ = 0",
                     (*_ANGLE, nm.kappa, nm.sigma, nm.beta),
                     tuple(sp.factor(value.subs({nm.p: nm.sigma})) for value in catastrophe.fold_quadratic()),
                     "e0, e1, e2", _shorthands(equilibrium.CONTACT, nm.B)),
            Function("cusp_polynomial", "Coefficients of e0 + … + e9 s⁹, whose real roots s = sin θ in (−1, 1) are all cusps. "
                     "Needs α > 0 and α ≠ 1 + β.", "f = f′ = f″ = 0", (nm.kappa, *_STIFFNESS),
                     cusp_polynomial, "e0, …, e9", cusp_names),
            Function("cusp_cubic", "The same for α = 0: e0 + e1 s + e2 s² + e3 s³.", "f = f′ = f″ = 0",
                     (nm.kappa, nm.sigma, nm.beta), tuple(map(sp.factor, catastrophe.cusp_cubic())), "e0, e1, e2, e3",
                     _shorthands(equilibrium.CONTACT, nm.B)),
            Function("cusp_point", "sin θ₀, and cos θ₀ and μ₀ over cos θ, on a cusp. Needs α > 0 for the second.",
                     "f = f′ = f″ = 0", (nm.s, nm.kappa, *_STIFFNESS), (cusp_s0, cusp_ratio, cusp_mu),
                     "sin0, cos0/cos, mu0/cos", contact),
            Function("unfolding", "∂f/∂v and ∂f′/∂v for v = θ₀, μ₀, κ, α, σ, β in turn.", "f = f′ = 0",
                     (*_ANGLE, *_ANGLE0, *_PARAMETERS), _unfolding(), "((f_θ₀, f′_θ₀), …, (f_β, f′_β))",
                     _shorthands(equilibrium.CONTACT, nm.B, nm.M, nm.p, nm.q)),
            Function("cusp_sine", "sin θ₀, and μ₀ over cos θ, on a cusp, for any α ≥ 0.", "f = f′ = f″ = 0",
                     (nm.s, nm.kappa, *_STIFFNESS), (cusp_s0, cusp_mu), "sin0, mu0/cos", contact),
        ),
    )  # fmt: skip


def _fold_conic() -> tuple[sp.Expr, ...]:
    """The fold relations are lines in M, so that M drops out of u1 w2 − u2 w1, which has no pole and no c0², s0 c0."""
    a = nm.fa
    threshold = nm.kappa + nm.sigma * nm.s * (1 + nm.c**2)
    gap = nm.kappa * nm.p - a * nm.s**3
    lever = nm.sigma * nm.s**2 * nm.c
    conic = (
        gap * threshold - a * nm.c**3 * lever,
        nm.p * nm.B * threshold - nm.sigma * gap,
        -nm.p * nm.B * nm.sigma,
        -nm.q * nm.alpha * lever,
    )
    spelled = [relation.subs(nm.fa, elimination.f_coefficients()[nm.fa]) for relation in catastrophe.fold_residuals()]
    (u1, w1), (u2, w2) = ((relation.subs(nm.M, 0), sp.diff(relation, nm.M)) for relation in spelled)
    ours = conic[0] + conic[1] * nm.s0 + conic[2] * nm.s0**2 + conic[3] * nm.c0
    _same("fold conic", (ours.subs(a, elimination.f_coefficients()[a]),), (u1 * w2 - u2 * w1,))
    return conic


def _unfolding() -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """How f and f′ in contact change with each parameter: what makes a cusp a versal one."""
    f = elimination.f_in_parameters().subs(equilibrium.SHORTHANDS).subs(equilibrium.SHORTHANDS).subs(equilibrium.CONTACT)
    pairs = []
    for parameter in (nm.theta0, *_PARAMETERS):
        if parameter == nm.theta0:
            change = sp.diff(f, nm.s0) * nm.c0 - sp.diff(f, nm.c0) * nm.s0
        else:
            change = sp.diff(f, parameter)
        pair = change, algebra.rotate_derivative(change)
        pairs.append(tuple(sp.factor_terms(sp.collect(sp.expand(part), (nm.c, nm.s))) for part in pair))
    return tuple(pairs)


def _cusp_angles() -> tuple[sp.Expr, sp.Expr]:
    """sin θ₀ and cos θ₀/cos θ on a cusp with the factor 3 s² − 2 kept together."""
    S, s = 3 * nm.s**2 - 2, nm.s
    s0 = (nm.sigma * (nm.B - nm.alpha) * s**3 / (nm.p * S) - nm.kappa) / nm.B
    G = 3 * nm.kappa * nm.p * nm.q * s * S - 4 * nm.B * nm.p * nm.sigma * (1 - s**2) + 3 * nm.sigma * nm.alpha * nm.q * s**4
    ratio = (nm.B - nm.alpha) * G / (nm.B * nm.alpha * nm.p * nm.q * S**2)
    _same("cusp angles", (s0, ratio), catastrophe.cusp_angles())
    return s0, ratio


def _cusp_polynomial() -> tuple[tuple[sp.Expr, ...], dict[sp.Symbol, sp.Expr]]:
    """(α q)² N² S² + (B − α)² (1 − s²) G² − (B p α q)² S⁴ with S = 3 s² − 2, N = a s³ − κ p S, and G of cos θ₀; degree 9."""
    g0, g1, g4, r, width, k = sp.symbols("g0 g1 g4 r width k")
    s = nm.s
    names = {
        **_shorthands(equilibrium.CONTACT, nm.B, nm.p, nm.q, nm.fa),
        r: nm.alpha * nm.q,
        k: nm.kappa * nm.p,
        g0: -4 * nm.B * nm.p * nm.sigma,
        g1: -6 * k * nm.q,
        g4: 3 * nm.sigma * r,
        width: nm.B - nm.alpha,
    }
    S, first = 3 * s**2 - 2, nm.fa * s**3 - k * (3 * s**2 - 2)
    second = g0 * (1 - s**2) + g1 * (s - sp.Rational(3, 2) * s**3) + g4 * s**4
    expanded = sp.expand(
        (r * first * S) ** 2 + width**2 * (1 - s**2) * second**2 - (nm.B * nm.p * r) ** 2 * S**4
    )
    coefficients = sp.Poly(expanded, s).all_coeffs()[::-1]
    local = {name: value for name, value in names.items() if name not in equilibrium.SHORTHANDS}
    derived = catastrophe.cusp_polynomial()
    _same("cusp polynomial", tuple(coefficients), (*derived, sp.S.Zero), local)
    return tuple(_over_one_denominator(value) for value in coefficients[:10]), names


def _over_one_denominator(value: sp.Expr) -> sp.Expr:
    """A polynomial with rational coefficients as an integer one over an integer."""
    numerator, denominator = sp.fraction(sp.together(value))
    return sp.factor_terms(sp.expand(numerator)) / denominator


def _fold_quartic(
    s0: sp.Expr, c0: sp.Expr
) -> tuple[tuple[sp.Expr, sp.Expr], tuple[sp.Expr, ...], dict[sp.Symbol, sp.Expr]]:
    """sin θ₀ and cos θ₀ on a fold as polynomials in friction with named coefficients, and the quartic that they make.

    Dividing by p B and q α first keeps every coefficient of the quartic a sum of a few squares and products.
    """
    line = sp.symbols("u0 u1")
    parabola = sp.symbols("g0 g1 g2")
    s0_terms = sp.Poly(s0, nm.M).all_coeffs()[::-1]
    c0_terms = sp.Poly(sp.cancel(c0.subs(nm.s0, line[0] + line[1] * nm.M)), nm.M).all_coeffs()[::-1]
    shorthands = {
        **_shorthands(equilibrium.CONTACT, nm.B, nm.p, nm.q),
        **{name: sp.factor_terms(value) for name, value in zip(line, s0_terms, strict=True)},
        **{name: sp.factor_terms(value) for name, value in zip(parabola, c0_terms, strict=True)},
    }
    u0, u1 = line
    g0, g1, g2 = parabola
    quartic = (u0**2 + g0**2 - 1, 2 * (u0 * u1 + g0 * g1), u1**2 + g1**2 + 2 * g0 * g2, 2 * g1 * g2, g2**2)
    scale = (nm.p * nm.B * nm.q * nm.alpha) ** 2
    for ours, derived in zip(quartic, catastrophe.fold_quartic(), strict=True):
        named = {name: shorthands[name] for name in (*line, *parabola)}
        if sp.simplify(sp.expand(scale * ours.subs(named).subs(named)) - derived) != 0:
            raise ArithmeticError("the arrangement of the fold quartic is not the fold quartic")
    in_mu = {nm.M: nm.mu0}
    return (sp.factor_terms(s0.subs(in_mu)), c0.subs(nm.s0, s0).subs(in_mu)), quartic, shorthands


# ------------------------------------------------------------------------------------------------ linear model


def _linear_sprag() -> Module:
    x, y = linear_sprag.equilibrium()
    determinant = sp.Symbol("determinant")
    K = linear_sprag.stiffness()
    arranged = (nm.kappa * K[0, 1] / determinant, -nm.kappa * K[0, 0] / determinant)
    names = {determinant: stability.determinant(K)}
    if any(sp.simplify(ours.subs(names) - derived) != 0 for ours, derived in zip(arranged, (x, y), strict=True)):
        raise ArithmeticError("the arrangement of the linear displacement is not the derived one")
    factored = sp.collect(sp.expand(stability.determinant(K)), nm.mu0)
    if sp.expand(factored - names[determinant]) != 0:
        raise ArithmeticError("the determinant of the linear model is not the derived one")
    return Module(
        "linear_sprag",
        "The constant-angle model of the article's reference [17]: displacement, poles, critical friction.",
        (
            Function("displacement", "x and y at steady sliding with the spring's angle held at θ₀.", "(12), (13) linearized",
                     (*_ANGLE0, *_PARAMETERS), arranged, "x, y", {determinant: factored}),
            Function("pole_quadratic", "Coefficients of e0 + e1 T + e2 T², whose roots T = tan θ₀ are the poles.",
                     "determinant of the linear model", (nm.mu0, *_STIFFNESS), linear_sprag.pole_quadratic(), "e0, e1, e2"),
            Function("pole_friction", "μ₀ with a pole at T = tan θ₀.", "determinant of the linear model",
                     (linear_sprag.T, *_STIFFNESS), sp.factor_terms(linear_sprag.pole_friction()), "mu0"),
            Function("critical_friction_squared", "μ_cr²: for α, μ₀ > 0 there is a pole if and only if μ₀ ≥ μ_cr.", "article, Section 3",
                     _STIFFNESS, linear_sprag.critical_friction_squared(), "mu_cr²"),
        ),
    )  # fmt: skip


# ------------------------------------------------------------------------------------------------------ motion


def _motion() -> Module:
    side = sp.Symbol("side")
    state = (nm.x, nm.y, nm.vx, nm.vy)
    length = mechanics.spring_length(nm.x, nm.y, sp.S.One)
    equations = mechanics.motion()
    lengths = {nm.L: length}
    regime = {
        nm.mu: mechanics.smooth_friction(side),
        nm.n: mechanics.contact_family(),
    }
    accelerations = {
        equations.ax: sp.solve(equations.x, equations.ax)[0],
        equations.ay: sp.solve(equations.y, equations.ay)[0],
    }
    arranged = tuple(map(sp.Add, _accelerations(), _added(_accelerations(), tuple(accelerations.values()))))
    in_regime = tuple(value.subs(regime, simultaneous=True) for value in arranged)
    regimes_of_force = {nm.mu: mechanics.friction(), nm.n: _contact_force()}
    everywhere = tuple(value.subs(regimes_of_force, simultaneous=True) for value in arranged)
    jacobian, jacobian_names = _regime_jacobian(in_regime, side)
    parameters = (*_ANGLE0, *_PARAMETERS, nm.V, nm.creep)
    moving = (*state, *parameters, nm.nbar, side)
    energy = mechanics.energy()
    power = regime[nm.mu] * regime[nm.n] * nm.vx
    return Module(
        "motion",
        "The equations of motion (8)–(11): everywhere, and in each regime in which they are smooth.",
        (
            Function("spring_length", "Length of the inclined spring.", "(6) corrected", (nm.x, nm.y, *_ANGLE0), length, "L",
                     transcendental=True),
            Function("accelerations", "x″ and y″ for a given friction coefficient and contact force.", "(8), (9) corrected",
                     (nm.x, nm.y, nm.L, nm.mu, nm.n, *_ANGLE0, nm.kappa, *_STIFFNESS), arranged, "x″, y″",
                     further=_further((), arranged)),
            Function("friction", "The friction coefficient at the speed x' of the mass.", "(10)", (nm.vx, nm.mu0, nm.V, nm.creep),
                     mechanics.friction(), "mu", transcendental=True, further=_further(state, mechanics.friction())),
            Function("rhs", "x″ and y″, kinked where y = 0 and where x' = V.", "(8)–(11)",
                     (*state, *parameters), everywhere, "x″, y″", lengths, transcendental=True, further=_further(state, everywhere)),
            Function("regime_rhs", "x″ and y″ in a smooth regime: contact (nbar = 1) or not (0), belt ahead (side = 1) or behind (−1).",
                     "(8)–(10)", moving, in_regime, "x″, y″", lengths, transcendental=True, further=_further(state, in_regime)),
            Function("regime_jacobian", "Derivatives of regime_rhs with respect to x, y, x', y'.", "(8)–(10)",
                     moving, jacobian, "((∂x″/∂x, …), (∂y″/∂x, …))", jacobian_names, transcendental=True,
                     further=_further(state, jacobian, jacobian_names)),
            Function("energy", "Kinetic and stored energy, the preload's included, over k_c L_0².", "(1), (2)",
                     (*state, *_ANGLE0, nm.kappa, *_STIFFNESS, nm.nbar), energy, "energy", lengths, transcendental=True),
            Function("friction_power", "Rate at which friction changes that energy.", "(8)",
                     (nm.y, nm.vx, nm.mu0, nm.V, nm.creep, nm.nbar, side),
                     power, "power", transcendental=True, further=_further(state, power)),
        ),
    )  # fmt: skip


def _regime_jacobian(
    accelerations: tuple[sp.Expr, ...], side: sp.Symbol
) -> tuple[tuple[tuple[sp.Expr, ...], ...], dict[sp.Symbol, sp.Expr]]:
    """Derivatives of the accelerations in terms of −K and of the friction and its slope, held against direct differentiation."""
    state = (nm.x, nm.y, nm.vx, nm.vy)
    mu, slope, pull = sp.Symbol("mu", real=True), sp.Symbol("slope"), sp.Symbol("pull")
    length = mechanics.spring_length(nm.x, nm.y, sp.S.One)
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
        [sp.diff(value, symbol) + sp.diff(value, nm.L) * mechanics.replace_length(sp.diff(length, symbol)) for symbol in state[:2]]
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
        added = _added(spelled, tuple(sp.sympify(entry).subs(polar) for entry in theirs))
        rows.append(tuple(map(sp.Add, ours, added)))
    return tuple(rows), names


def _contact_force() -> sp.Expr:
    """n(y) without a case distinction, (11); held against the law of the mechanics below, on and above the belt."""
    arranged = (sp.Abs(nm.y) - nm.y) / 2
    u = sp.Symbol("u", positive=True)
    for place in (-u, sp.S.Zero, u):
        if arranged.subs(nm.y, place) != mechanics.contact_law().subs(nm.y, place):
            raise ArithmeticError("n(y) is not (11): the emitted right-hand side needs another form of the contact law")
    return arranged


def _accelerations() -> tuple[sp.Expr, sp.Expr]:
    spring = nm.sigma * (nm.L - 1) / nm.L
    return (
        spring * (nm.c0 - nm.x) - nm.alpha * nm.x + nm.mu * nm.n,
        spring * (nm.s0 - nm.y) - nm.beta * nm.y + nm.n - nm.kappa,
    )
