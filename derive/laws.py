"""The friction law: its two smooth sides, the thin layers in it that a large time step would jump
over, and its value at steady sliding.

An exponential of the sliding speed makes a layer at v = 0, as does a hyperbolic tangent, which is
±1 and an exponential: far from it all its derivatives are below rounding. Every one gets a factor
NEAR, 1 where it is felt and 0 where it is left out, and :func:`layers` says how far away a motion
is, as minus its exponent. tanh z is written as 1 − 2 exp(−2z)/(1 + exp(−2z)): where it rounds to 1,
its Taylor coefficients by (tanh z)′ = 1 − tanh² z are all zero, and a step of that length misses
the layer.
"""

import sympy as sp
from sympy import Expr, S, Symbol, expand

from .algebra import Pair, Row, Symbols
from .mechanics import SLIP, FrictionForce
from .model import PageError

#: The share of the static coefficient that is used where nothing slides, from −1, against the belt,
#: to 1, with it.
HELD = Symbol("held", real=True)


def slip(friction: FrictionForce) -> Expr:
    """The sliding speed: belt − d(along)/dt."""
    return friction.belt - friction.rate


def near(friction: FrictionForce) -> Symbols:
    """The factors of its exponentials."""
    end = friction.name and f"_on_{friction.name}"
    count = len(_layers(friction))
    return tuple(Symbol(f"near{number}{end}", real=True) for number in range(1, count + 1))


def _layers(friction: FrictionForce) -> list[tuple[Expr, Expr, Expr, Expr]]:
    """Exponentials and hyperbolic tangents of the sliding speed, in a fixed order; the limit of
    each, what it lacks, its −exponent.
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
        elif (end := _within_domains(limit(friction, argument, SLIP, sp.oo))) in (sp.oo, -sp.oo):
            far, exponent = sp.sign(end), 2 * sp.sign(end) * argument
            found.append(
                (node, far, -2 * far * sp.exp(-exponent) / (1 + sp.exp(-exponent)), exponent)
            )
    return found


def _within_domains(value: Expr) -> Expr:
    """A value of which only the sign is asked, with parameters away from 0 where that is the end of
    their domain.
    """
    return value.xreplace(
        {it: Symbol(it.name, positive=True) for it in value.free_symbols if it.is_nonnegative}
    )


def limit(friction: FrictionForce, law: Expr, speed: Symbol, end: Expr) -> Expr:
    """The limit of the friction law, or of a part of it, at an end of the sliding speed."""
    try:
        return sp.limit(law, speed, end)
    except NotImplementedError as error:
        where = "at rest" if end == 0 else "at fast sliding"
        raise PageError(
            friction.line,
            f"what {law} comes to {where} can't be told: "
            f"{str(error)[:1].lower()}{str(error)[1:]}; give its parameters domains that "
            'decide it, as "> 0"',
        ) from error


def layers(friction: FrictionForce) -> Row:
    """Minus the exponent of every exponential of the sliding speed: large where it is not felt."""
    return tuple(
        expand(exponent).subs(SLIP, friction.side * slip(friction))
        for *_, exponent in _layers(friction)
    )


def smooth_friction(friction: FrictionForce, felt: bool = False) -> Expr:
    """μ without the absolute value and the sign that kink it, for either SIDE; its exponentials
    with their NEAR unless all are felt.
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
    """Static friction coefficients with the belt and against it: not less than the kinetic ones at
    sliding speed 0.
    """
    holds = friction.holds
    assert holds is not None
    found = []
    for side, sign in ((friction.ahead, 1), (friction.behind, -1)):
        begins = sign * limit(friction, side, SLIP, S.Zero)
        more = sp.simplify(holds - begins)
        found.append(
            holds
            if more.is_nonnegative
            else begins
            if more.is_nonpositive
            else (holds + begins + sp.Abs(holds - begins)) / 2
        )
    return found[0], found[1]


def friction_held(friction: FrictionForce) -> Expr:
    """μ where a share of the static coefficient is used, in which it is linear."""
    ahead, behind = static_coefficients(friction)
    return (ahead + behind) / 2 * HELD + (ahead - behind) / 2


def friction_at_speed(friction: FrictionForce) -> Expr:
    """μ at the belt's speed: what holds a motion that has come to rest."""
    return friction.ahead.subs(SLIP, friction.still)


def slope_at_rest(friction: FrictionForce) -> Expr:
    """dμ/dv at steady sliding."""
    return sp.factor_terms(sp.diff(friction.ahead, SLIP).subs(SLIP, friction.still))


def slope_by_sizes(friction: FrictionForce) -> tuple[tuple[Pair, ...], ...]:
    """The slope as Σ c eᵃ, over each of its exponentials: c and a of all terms, once for each.

    Where exponentials are too small for floats the slope is, too, but its sign is not lost over the
    largest of them.
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
    """Friction coefficient of the statics: the limit of the law that the page names, or the law at
    the belt's speed.
    """
    named = friction.at_rest
    if named is None:
        return friction_at_speed(friction)
    fast = limit(friction, friction.ahead, SLIP, sp.oo)
    if sp.simplify(fast - named) != 0:
        raise PageError(
            friction.line,
            f"at_rest is {named}, and the friction law at fast sliding is {fast}; name that "
            "limit, or leave at_rest out for μ(V)",
        )
    return named
