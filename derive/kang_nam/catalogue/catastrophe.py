"""Functions of the equilibrium surface, its folds and its cusps."""

import sympy as sp
from sympy import Symbol, diff, expand

from ...algebra import Names, Pair, Row
from ...emit.function import Function, Module
from ...factors import factored
from .. import catastrophe, elimination, equilibrium, lowest_fold, theorem
from ..nomenclature import B, M, PARAMETERS, alpha, beta, c, c0, fa, fa_v, fb, fb_v, fd, fd_v
from ..nomenclature import fm, fm_v, kappa, mu0, p, q, s, s0, sigma, theta0
from ..unit_circles import by_inclination, rotate_derivative
from .arrangement import (
    ANGLE,
    ANGLE0,
    F_COEFFICIENTS,
    POINT,
    WITHOUT_FRICTION,
    require_same,
    in_contact,
)


def _line(relation: sp.Expr, symbol: Symbol) -> Pair:
    """u and w of ``relation = u + w · symbol``."""
    slope = diff(relation, symbol)
    if slope.has(symbol):
        raise ArithmeticError(f"the fold relations are not linear in {symbol}")
    return sp.factor_terms(relation.subs(symbol, 0)), sp.factor_terms(slope)


def module() -> Module:
    contact = in_contact()
    sine0, cosine0 = catastrophe.fold_angles()
    spelled = [
        expand(equilibrium.spell_out(relation).subs(equilibrium.CONTACT))
        for relation in catastrophe.fold_residuals()
    ]
    friction = tuple(
        value.subs(M, mu0) for value in (sp.factor_terms(sine0), cosine0.subs(s0, sine0))
    )
    quartic, quartic_names = catastrophe.fold_quartic()
    events, events_without_alpha, conic_names, line_names = _fold_events()
    sextic, sextic_names = _fold_sextic()
    cusp_polynomial, cusp_names = _cusp_polynomial()
    cusp_s0, cusp_ratio = catastrophe.cusp_angles()
    cusp_mu = catastrophe.cusp_friction() / c / sigma
    return Module(
        "catastrophe",
        "The equilibrium surface, its folds (f = f′ = 0) and cusps (f″ = 0 as well), in contact.",
        (
            Function(
                "surface",
                "μ₀ on the equilibrium surface over (θ, θ₀): f is linear in μ₀.",
                "(14), (15)",
                (*ANGLE, *ANGLE0, *WITHOUT_FRICTION),
                catastrophe.surface_in_coefficients(),
                "mu0",
                contact,
            ),
            Function(
                "fold_lines_mu0",
                "The two fold relations as lines in mu0: u1 + w1 mu0 = 0 and u2 + w2 mu0 = 0.",
                "f = f′ = 0",
                (*ANGLE, *ANGLE0, *WITHOUT_FRICTION),
                tuple(part for it in spelled for part in _line(it, mu0)),
                "u1, w1, u2, w2",
            ),
            Function(
                "fold_angles",
                "sin θ₀ and cos θ₀ of the fold through θ at friction μ₀. Needs α > 0.",
                "f = f′ = 0",
                (*ANGLE, *PARAMETERS),
                friction,
                "sin0, cos0",
                contact,
            ),
            Function(
                "fold_sine",
                "sin θ₀ of the fold through θ at friction μ₀, for any α ≥ 0.",
                "f = f′ = 0",
                (*ANGLE, *PARAMETERS),
                friction[0],
                "sin0",
                contact,
            ),
            Function(
                "fold_quartic",
                "Coefficients of e0 + … + e4 μ₀⁴, whose real roots are all folds at a given "
                "θ. Needs α > 0.",
                "f = f′ = 0",
                (*ANGLE, *WITHOUT_FRICTION),
                quartic,
                "e0, e1, e2, e3, e4",
                {**contact, **quartic_names},
            ),
            Function(
                "fold_conic",
                "All folds at a given θ, friction eliminated: E0 + E1 sin θ₀ + E2 sin² θ₀ + "
                "Ec cos θ₀ = 0, for any α ≥ 0.",
                "f = f′ = 0",
                (*ANGLE, *WITHOUT_FRICTION),
                catastrophe.fold_conic(),
                "E0, E1, E2, Ec",
                contact,
            ),
            Function(
                "fold_events",
                "Polynomials in s = sin θ that are 0 at a θ < π/2 where two folds meet, where one "
                "has θ₀ = 0 or π, and where one has μ₀ = 0. Needs α > 0.",
                "f = f′ = 0",
                (s, *WITHOUT_FRICTION),
                events,
                "meeting, border, frictionless",
                {**contact, **conic_names},
            ),
            Function(
                "fold_events_without_alpha",
                "The same for α = 0: 0 where two folds meet, where two have θ₀ = 0 and π, and "
                "where they meet at π/2.",
                "f = f′ = 0",
                (s, kappa, sigma, beta),
                events_without_alpha,
                "meeting, border, middle",
                {
                    name: sp.sympify(value).subs({p: sigma, alpha: 0})
                    for name, value in {**contact, **line_names}.items()
                },
            ),
            Function(
                "fold_quadratic",
                "The same for α = 0: e0 + e1 μ₀ + e2 μ₀², and sin θ₀ as for α > 0.",
                "f = f′ = 0",
                (*ANGLE, kappa, sigma, beta),
                tuple(factored(value.subs({p: sigma})) for value in catastrophe.fold_quadratic()),
                "e0, e1, e2",
                contact,
            ),
            Function(
                "f_changes",
                "Derivatives of a, b, d, m of f in contact by v = θ₀, μ₀, κ, α, σ, β in turn.",
                "(12), (13) eliminated",
                POINT,
                _changes(),
                "((a_θ₀, b_θ₀, d_θ₀, m_θ₀), …, (a_β, b_β, d_β, m_β))",
                contact,
            ),
            Function(
                "f_in_differences",
                "f, f′ and their derivatives by μ₀ in contact, with sin θ − sin θ₀ and cos θ₀ "
                "− cos θ kept "
                "together: over a box of parameters, or near small deformation, little is lost.",
                "(12), (13) eliminated",
                (*ANGLE, *POINT),
                _in_differences(),
                "f, f′, f_μ₀, f′_μ₀",
                contact,
            ),
            Function(
                "fold_sextic",
                "Coefficients of e0 + … + e6 t⁶ = (1 + t²)³ (f′ f_v − f f_v′) with t = tan(θ/2), "
                "whose roots are all folds along a parameter v but θ₀; minus its sign is that of "
                "dv/dθ on the surface.",
                "f = f′ = 0",
                (*F_COEFFICIENTS, fa_v, fb_v, fd_v, fm_v),
                sextic,
                "e0, …, e6",
                sextic_names,
            ),
            Function(
                "fold_cubics",
                "Coefficients in t = tan(θ/2) of (1 + t²)³ times p B sin θ₀ and p B q α cos θ₀, on "
                "the fold through θ at friction μ₀.",
                "f = f′ = 0",
                PARAMETERS,
                _fold_cubics(),
                "(S0, …, S6), (C0, …, C6)",
                contact,
            ),
            Function(
                "cusp_polynomial",
                "Coefficients of e0 + … + e9 s⁹, whose real roots s = sin θ in (−1, 1) are all "
                "cusps. Needs α > 0 and α ≠ 1 + β.",
                "f = f′ = f″ = 0",
                WITHOUT_FRICTION,
                cusp_polynomial,
                "e0, …, e9",
                cusp_names,
            ),
            Function(
                "cusp_cubic",
                "The same for α = 0: e0 + e1 s + e2 s² + e3 s³.",
                "f = f′ = f″ = 0",
                (kappa, sigma, beta),
                tuple(map(factored, catastrophe.cusp_cubic())),
                "e0, e1, e2, e3",
                contact,
            ),
            Function(
                "cusp_point",
                "sin θ₀, and cos θ₀ and μ₀ over cos θ, on a cusp. Needs α > 0 for the second.",
                "f = f′ = f″ = 0",
                (s, *WITHOUT_FRICTION),
                (cusp_s0, cusp_ratio, cusp_mu),
                "sin0, cos0/cos, mu0/cos",
                contact,
            ),
            Function(
                "unfolding",
                "∂f/∂v and ∂f′/∂v for v = θ₀, μ₀, κ, α, σ, β in turn.",
                "f = f′ = 0",
                (*ANGLE, *POINT),
                _unfolding(),
                "((f_θ₀, f′_θ₀), …, (f_β, f′_β))",
                contact,
            ),
            Function(
                "cusp_sine",
                "sin θ₀, and μ₀ over cos θ, on a cusp, for any α ≥ 0.",
                "f = f′ = f″ = 0",
                (s, *WITHOUT_FRICTION),
                (cusp_s0, cusp_mu),
                "sin0, mu0/cos",
                contact,
            ),
            *_turning(),
        ),
    )


def _fold_events() -> tuple[Row, Row, Names, Names]:
    """Quantities that are 0 at an event, for α > 0 and for α = 0, in the coefficients of the conic,
    and names for these.

    With v = tan(θ₀/2) the conic is a quartic, and 27 times its discriminant is 4 P³ − Q²; the
    cosine enters by its square.
    """
    e0, e1, e2, square, middle, product, P, Q = sp.symbols("e0 e1 e2 ec_2 middle product P Q")
    *conic, last = catastrophe.fold_conic()
    kept = dict(zip((e0, e1, e2), conic, strict=True))
    parts = {
        product: e0**2 - square,
        middle: 4 * e2 + 2 * e0,
        P: 12 * product - 12 * e1**2 + middle**2,
        Q: 72 * product * middle + 36 * e1**2 * middle - 216 * e1**2 * e0 - 2 * middle**3,
    }
    sine, cosine = fa * s**3 - kappa * p, fa * (1 - s**2)
    rest = (q * alpha * sine) ** 2 + (1 - s**2) * (p * B * cosine) ** 2 - (p * B * q * alpha) ** 2
    names = {**kept, square: (last / c) ** 2 * (1 - s**2), **parts}
    events = (4 * P**3 - Q**2, product, rest)
    derived = catastrophe.fold_events((e0, e1, e2, square))
    require_same("meetings of folds, and their borders", events[:2], derived[:2], parts)
    require_same("folds without friction", events[2:], derived[2:], elimination.f_coefficients())
    # e0 + e1 + e2, in which little is lost
    at_middle = sigma * (
        kappa**2
        + (1 - s)
        * (kappa * B * (1 + s + s**2) - kappa * sigma * (1 - s - s**2) - B * sigma * (1 - s))
    )
    spelled = {**kept, fa: sigma * B, p: sigma}
    require_same(
        "folds at θ₀ = π/2",
        (at_middle,),
        ((e0 + e1 + e2).subs(spelled).subs(spelled).subs(alpha, 0),),
    )
    without_alpha = (e1**2 - 4 * e0 * e2, e0, at_middle)
    return events, without_alpha, names, kept


def _changes() -> tuple[Row, ...]:
    """Derivatives of a, b, d and m by each parameter, in the order of f."""
    rows = []
    for parameter in (theta0, *PARAMETERS):
        row = []
        for symbol in F_COEFFICIENTS:
            value = equilibrium.spell_out(elimination.f_coefficients()[symbol]).subs(
                equilibrium.CONTACT
            )
            change = by_inclination(value) if parameter == theta0 else diff(value, parameter)
            row.append(sp.factor_terms(change))
        rows.append(tuple(row))
    return tuple(rows)


def _in_differences() -> Row:
    """q sin θ F_x as a sum over springs: the inclined one, the one along the belt, and friction."""
    if not all(step.holds for step in theorem.smallest_without_friction()):
        raise ArithmeticError(
            "the reference state without friction is not what certificates over boxes take it to be"
        )
    rise, push = B * (s - s0) - kappa, -(sigma * (s - s0) + kappa)
    along = B * (s * c0 - c * s0) + sigma * s * (c0 - c) - kappa * c
    along_slope = B * (c * c0 + s * s0) + sigma * (c * (c0 - c) + s**2) + kappa * s
    friction, friction_slope = s * push, c * (push - sigma * s)
    value = sigma * c * rise + alpha * along + mu0 * friction
    slope = sigma * (B * c**2 - s * rise) + alpha * along_slope + mu0 * friction_slope
    f = equilibrium.spell_out(elimination.f_in_parameters()).subs(equilibrium.CONTACT)
    by_friction = diff(f, mu0)
    derived = (
        f,
        rotate_derivative(f),
        by_friction,
        rotate_derivative(by_friction),
    )
    arranged = (value, slope, friction, friction_slope)
    require_same("f in differences", arranged, derived, in_contact())
    return arranged


def _fold_sextic() -> tuple[Row, Names]:
    """In the six minors of the coefficients of f and of f_v: c³ ab − s³ ad + s² am − bd + s (2 −
    s²) bm + s² c dm.
    """
    pairs = (
        ("ab", fa, fb),
        ("ad", fa, fd),
        ("am", fa, fm),
        ("bd", fb, fd),
        ("bm", fb, fm),
        ("dm", fd, fm),
    )
    change = catastrophe.CHANGE
    ab, ad, am, bd, bm, dm = (Symbol(name) for name, _, _ in pairs)
    names = {Symbol(name): one * change[other] - other * change[one] for name, one, other in pairs}
    sextic = (
        ab - bd,
        4 * bm,
        4 * (am + dm) - 3 * (ab + bd),
        -8 * ad,
        4 * (am - dm) + 3 * (ab - bd),
        4 * bm,
        -ab - bd,
    )
    require_same("fold sextic", sextic, catastrophe.fold_sextic(), names)
    return sextic, names


def _fold_cubics() -> tuple[Row, Row]:
    """With p B sin θ₀ = a s³ + m s² c − p κ = S, p B q α cos θ₀ = p B (m s (1 + c²) − a c³ + M κ) −
    m S.
    """
    a, m, width, load = fa, fm, p * B, p * kappa
    sine = (-load, sp.S.Zero, 4 * m - 3 * load, 8 * a, -4 * m - 3 * load, sp.S.Zero, -load)
    push = M * kappa
    bare = (push - a, 4 * m, 3 * (a + push), 0, 3 * (push - a), 4 * m, a + push)
    cosine = tuple(width * one - m * other for one, other in zip(bare, sine, strict=True))
    spelled = elimination.f_coefficients()
    for ours, derived in zip((sine, cosine), catastrophe.fold_cubics(), strict=True):
        derived = tuple(value.subs(spelled) for value in derived)
        require_same("fold cubics", tuple(sp.sympify(value) for value in ours), derived, spelled)
    return sine, cosine


def _unfolding() -> tuple[Pair, ...]:
    """Derivatives of f and f′ in contact by each parameter: what makes a cusp a versal one."""
    pairs = []
    for row in _changes():
        change = elimination.f_form.subs(
            dict(zip(F_COEFFICIENTS, row, strict=True)), simultaneous=True
        )
        pair = change, rotate_derivative(change)
        pairs.append(tuple(sp.factor_terms(sp.collect(expand(part), (c, s))) for part in pair))
    return tuple(pairs)


def _cusp_polynomial() -> tuple[Row, Names]:
    """(α q)² N² S² + (B − α)² (1 − s²) G² − (B p α q)² S⁴ with S = 3 s² − 2, N = a s³ − κ p S, and
    G of cos θ₀; degree 9.
    """
    g0, g1, g4, r, width, k = sp.symbols("g0 g1 g4 r width k")
    names = {
        **in_contact(),
        r: alpha * q,
        k: kappa * p,
        g0: -4 * B * p * sigma,
        g1: -6 * k * q,
        g4: 3 * sigma * r,
        width: B - alpha,
    }
    S, first = 3 * s**2 - 2, fa * s**3 - k * (3 * s**2 - 2)
    second = g0 * (1 - s**2) + g1 * (s - sp.Rational(3, 2) * s**3) + g4 * s**4
    expanded = expand(
        (r * first * S) ** 2 + width**2 * (1 - s**2) * second**2 - (B * p * r) ** 2 * S**4
    )
    coefficients = sp.Poly(expanded, s).all_coeffs()[::-1]
    local = {name: value for name, value in names.items() if name not in equilibrium.SHORTHANDS}
    derived = catastrophe.cusp_polynomial()
    require_same("cusp polynomial", tuple(coefficients), (*derived, sp.S.Zero), local)
    # Each as a polynomial with integer coefficients over an integer.
    quotients = (sp.fraction(sp.together(value)) for value in coefficients[:10])
    return tuple(
        sp.factor_terms(expand(numerator)) / denominator for numerator, denominator in quotients
    ), names


def _turning() -> tuple[Function, ...]:
    """Functions of the points at which the curve of folds turns back in μ₀."""
    first, second = sp.symbols("a_:3"), sp.symbols("c_:3")
    slope, circle = lowest_fold.quadratics_in_parts()
    names = {
        **in_contact(),
        **lowest_fold.PARTS,
        **dict(zip((*first, *second), (*slope, *circle), strict=True)),
    }
    outer, upper, _ = lowest_fold.minors(first, second)
    weight, constant, along = lowest_fold.turning_line()
    cosine = sp.factor_terms(constant + along * s0) / weight
    return (
        Function(
            "turning_polynomial",
            "Coefficients of e0 + … + e9 s⁹, among whose roots s = sin θ in (0, 1] are all points "
            "at which the curve of folds turns back in μ₀. Needs α > 0.",
            "f = f′ = f_θ₀ = 0",
            WITHOUT_FRICTION,
            lowest_fold.turning_polynomial(),
            "e0, …, e9",
            in_contact(),
        ),
        Function(
            "turning_sine",
            "Numerator and denominator of sin θ₀ where the curve of folds turns back in μ₀.",
            "f = f′ = f_θ₀ = 0",
            (s, *WITHOUT_FRICTION),
            (-outer, upper),
            "numerator, denominator",
            names,
        ),
        Function(
            "turning_cosine",
            "cos θ cos θ₀ where the curve of folds turns back in μ₀. Needs α > 0.",
            "f = f_θ₀ = 0",
            (s, s0, *WITHOUT_FRICTION),
            cosine,
            "cos cos0",
            in_contact(),
        ),
    )
