"""Friction laws: their smooth sides, their boundary layers, and the coefficient at steady sliding.

An exponential of the sliding speed v, or a hyperbolic tangent, has a boundary layer at v = 0. Far
from it all derivatives are below rounding, so that an integrator with an error estimate would step
over it. Every such term therefore gets a switch, 1 near the layer and 0 where the term is left out,
and :func:`layers` gives minus its exponent as the distance from the layer. tanh z is written as
1 − 2 exp(−2z)/(1 + exp(−2z)): with (tanh z)′ = 1 − tanh² z all Taylor coefficients would be 0 where
tanh z rounds to 1.
"""

import sympy as sp
from sympy import Expr, S, Symbol, expand

from .algebra import Pair, Row, Symbols
from .mechanics import SLIP, FrictionForce
from .model import PageError


def slip(friction: FrictionForce) -> Expr:
    """The sliding speed: belt − d(along)/dt."""
    return friction.belt - friction.rate


def near(friction: FrictionForce) -> Symbols:
    """The switches of the law's boundary layers."""
    end = friction.name and f"_on_{friction.name}"
    count = len(_layers(friction))
    return tuple(Symbol(f"near{number}{end}", real=True) for number in range(1, count + 1))


def _layers(friction: FrictionForce) -> list[tuple[Expr, Expr, Expr, Expr]]:
    """The exponentials and hyperbolic tangents of the sliding speed, in a fixed order.

    Each comes with its limit far from the layer, the difference from that, and minus the exponent.
    """
    nodes = {
        node
        for side in (friction.ahead, friction.behind)
        for node in side.atoms(sp.exp, sp.tanh)
        if node.has(SLIP)
    }
    found = []
    for node in sorted(nodes, key=sp.default_sort_key):
        argument = node.args[0]
        if isinstance(node, sp.exp):
            found.append((node, S.Zero, node, -argument))
        elif (end := _within_domains(limit(friction, argument, sp.oo))) in (sp.oo, -sp.oo):
            far, exponent = sp.sign(end), 2 * sp.sign(end) * argument
            found.append(
                (node, far, -2 * far * sp.exp(-exponent) / (1 + sp.exp(-exponent)), exponent)
            )
    return found


def _within_domains(value: Expr) -> Expr:
    """An expression with nonnegative parameters assumed positive, for the sign of its limit."""
    return value.xreplace(
        {it: Symbol(it.name, positive=True) for it in value.free_symbols if it.is_nonnegative}
    )


def limit(friction: FrictionForce, law: Expr, end: Expr) -> Expr:
    """The limit of a friction law, or of a part of it, at an end of the sliding speed.

    Raises
    ------
    PageError
        If SymPy does not find it.
    """
    try:
        return sp.limit(law, SLIP, end)
    except NotImplementedError as error:
        where = "at rest" if end == 0 else "at fast sliding"
        raise PageError(
            friction.line,
            f"what {law} comes to {where} can't be told: {str(error)[:1].lower()}{str(error)[1:]}; "
            'give its parameters domains that decide it, as "> 0"',
        ) from error


def layers(friction: FrictionForce) -> Row:
    """Distances from the boundary layers: minus the exponent of every exponential of the speed."""
    return tuple(
        expand(exponent).subs(SLIP, friction.side * slip(friction))
        for *_, exponent in _layers(friction)
    )


def smooth_friction(friction: FrictionForce, felt: bool = False) -> Expr:
    """The friction coefficient as a smooth function of the sliding speed, for given SIDE.

    Boundary layers have their switches (:func:`near`), unless all are ``felt``.
    """
    ahead, behind = friction.ahead, friction.behind
    found = _layers(friction)
    if not felt:
        factors = {
            node: far + factor * tail
            for (node, far, tail, _), factor in zip(found, near(friction), strict=True)
        }
        ahead, behind = (side.xreplace(factors) for side in (ahead, behind))
    side = friction.side
    if expand(ahead + behind) == 0:
        return side * ahead.subs(SLIP, side * slip(friction))
    forward, backward = ahead.subs(SLIP, slip(friction)), behind.subs(SLIP, -slip(friction))
    return ((1 + side) * forward + (1 - side) * backward) / 2


def static_coefficients(friction: FrictionForce) -> Pair:
    """Static friction coefficients with the belt and against it: the larger of ``holds`` and the
    kinetic coefficient at sliding speed 0.
    """
    kinetic = limit(friction, friction.ahead, S.Zero), -limit(friction, friction.behind, S.Zero)
    ahead, behind = (sp.Max(friction.holds, it).rewrite(sp.Abs) for it in kinetic)
    return ahead, behind


def friction_held(friction: FrictionForce) -> Expr:
    """The friction coefficient while it sticks, linear in its share ``held``."""
    ahead, behind = static_coefficients(friction)
    return (ahead + behind) / 2 * friction.held + (ahead - behind) / 2


def friction_at_speed(friction: FrictionForce) -> Expr:
    """The friction coefficient at the belt's speed, that of a motion at rest."""
    return friction.ahead.subs(SLIP, friction.still)


def slope_at_rest(friction: FrictionForce) -> Expr:
    """dμ/dv at steady sliding."""
    return sp.factor_terms(sp.diff(friction.ahead, SLIP).subs(SLIP, friction.still))


def slope_by_sizes(friction: FrictionForce) -> tuple[tuple[Pair, ...], ...]:
    """The slope Σ c exp(a), divided by each of its exponentials: lists of (c, a).

    Where the slope underflows in floats, its sign is still that of the sum over the largest
    exponential.
    """
    terms: dict[Expr, Expr] = {}
    for term in sp.Add.make_args(expand(slope_at_rest(friction))):
        coefficient, power = term.as_independent(sp.exp)
        power = sp.powsimp(power)
        coefficient, exponent = (
            (coefficient, power.args[0]) if isinstance(power, sp.exp) else (term, S.Zero)
        )
        terms[exponent] = terms.get(exponent, S.Zero) + coefficient
    ordered = sorted(terms, key=sp.default_sort_key)
    return tuple(
        tuple((sp.factor_terms(terms[a]), expand(a - top)) for a in ordered) for top in ordered
    )


def friction_at_rest(friction: FrictionForce) -> Expr:
    """The friction coefficient that statics takes: the page's ``at_rest``, or the law at the belt's
    speed.

    Raises
    ------
    PageError
        If ``at_rest`` is not the limit of the law at fast sliding.
    """
    named = friction.at_rest
    if named is None:
        return friction_at_speed(friction)
    fast = limit(friction, friction.ahead, sp.oo)
    if sp.simplify(fast - named) != 0:
        raise PageError(
            friction.line,
            f"at_rest is {named}, and the friction law at fast sliding is {fast}; name that "
            "limit, or leave at_rest out for μ(V)",
        )
    return named
