"""Printed against derived: one ledger row for every printed statement, decided by exact algebra."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import Any, TypeAlias

import mpmath
import sympy as sp

from . import article, unit_circles, elimination, equilibrium, explanations, mechanics, stability
from . import nomenclature as nm
from .article import Printed
from .free_body import DIGITS, Point

#: Statuses of a row that passes the check.
SOUND = ("confirmed", "misprint", "approximation", "definition")
#: The status of a row whose printed form is not the derived one, without an explanation that holds.
FAILED = "failed"
#: Expressions that are compared one by one.
Components: TypeAlias = tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Row:
    """The outcome for one printed statement; every text is LaTeX or plain words, every empty field
    means not applicable.

    ``derivation`` is the form at which the derivation itself arrives. ``derived`` equals it, as
    exact algebra has shown, and has the arrangement of ``printed``, so that the two can be compared
    by eye. In a failed row ``derived`` is the same as ``derivation``. ``derived_by`` names the
    function of this folder that derives it.
    """

    id: str
    where: str
    status: str
    derived_by: str
    printed: str
    derived: str
    derivation: str
    difference: str
    note: str = ""
    cause: str = ""
    evidence: str = ""
    consequence: str = ""
    limit: str = ""

    def recorded(self) -> dict[str, str]:
        """As the ledger has it: without what is empty, and without a derived form that is the
        printed one.
        """
        return {
            name: text
            for name, text in asdict(self).items()
            if text and (name, text) != ("derived", self.printed)
        }


@dataclass(frozen=True)
class Derived:
    """What the derivation gives where something is printed: its components, and what a printed
    relation is about.
    """

    value: sp.Expr | Components
    #: The function that derives it.
    by: Callable[..., Any]
    about: tuple[Any, ...] = ()
    #: Substitutions that bring the printed form into the derivation's terms; one comparison for
    #: each tuple of them.
    terms: tuple[tuple[tuple[sp.Expr, sp.Expr], ...], ...] = ((),)

    @property
    def components(self) -> Components:
        """Of a single one that one."""
        return _several(self.value)


def run(printed: Iterable[Printed] = article.PRINTED) -> list[Row]:
    """Check every printed statement."""
    derived = derived_forms()
    return [check(entry, derived[entry.id]) for entry in printed]


def failures(rows: Sequence[Row]) -> list[Row]:
    """Rows that do not pass the check."""
    return [row for row in rows if row.status not in SOUND]


def check(entry: Printed, derived: Derived) -> Row:
    """Compare one printed statement with the derivation and with its explanation, if there is
    one.
    """
    gaps = _differences(_components(entry.expression, derived), derived)
    base = {
        "id": entry.id,
        "where": entry.where,
        "derived_by": f"{derived.by.__module__.rpartition('.')[2]}.{derived.by.__name__}",
        "printed": entry.latex,
        "derived": _latex(derived.components),
        "derivation": _latex(derived.components),
        "difference": _latex(gaps),
        "note": explanations.NOTES.get(entry.id, ""),
    }
    differs = any(gap != 0 for gap in gaps)
    if entry.id in explanations.CORRECTIONS:
        return _misprint(entry.id, _components(entry.expression, derived), derived, differs, base)
    if entry.id in explanations.APPROXIMATIONS:
        approximation = explanations.APPROXIMATIONS[entry.id]
        if not differs:
            return _failed(base, "explained as an approximation, but the difference is zero")
        if not all(gap == 0 or approximation.vanishes(gap) for gap in gaps):
            return _failed(base, f"the difference does not vanish for {approximation.limit}")
        if not _is_derived(approximation.expression, derived):
            return _failed(
                base, "the exact form given for this approximation is not the derived one"
            )
        return Row(
            status="approximation",
            limit=approximation.limit,
            **base | {"derived": approximation.latex},
        )
    if differs:
        return _failed(base, "printed and derived differ, and nothing explains it")
    base["derived"] = entry.latex
    if entry.id in explanations.DEFINITIONS:
        return Row(status="definition", **base | {"note": explanations.DEFINITIONS[entry.id]})
    return Row(status="confirmed", **base)


def _failed(base: dict[str, str], note: str) -> Row:
    return Row(status=FAILED, **base | {"note": note})


def _misprint(
    id: str, components: Components, derived: Derived, differs: bool, base: dict[str, str]
) -> Row:
    correction = explanations.CORRECTIONS[id]
    if not differs:
        return _failed(base, "explained as a misprint, but the difference is zero")
    (gap,) = _differences(components, derived)
    if not unit_circles.equal(gap, correction.gap.subs(list(derived.terms[0]))):
        return _failed(base, "the difference is not the one that the correction explains")
    if not _is_derived(correction.expression, derived):
        return _failed(base, "the right form given for this misprint is not the derived one")
    with mpmath.workdps(DIGITS):
        holds, evidence = correction.evidence()
        if not holds:
            return _failed(base, f"the second derivation disagrees: {evidence}")
        consequence = correction.consequence(Point())
    said = {
        "cause": correction.cause,
        "evidence": evidence,
        "consequence": consequence,
        "derived": correction.latex,
    }
    return Row(status="misprint", **base | said)


def _is_derived(expression: article.Expression, derived: Derived) -> bool:
    """Whether a form of ours, in the arrangement of the print, is the derived one."""
    return not any(gap != 0 for gap in _differences(_components(expression, derived), derived))


def _components(expression: article.Expression, derived: Derived) -> Components:
    return _several(expression(*derived.about) if callable(expression) else expression)


def _several(value: sp.Expr | Components) -> Components:
    return value if isinstance(value, tuple) else (value,)


def _differences(components: Components, derived: Derived) -> Components:
    gaps = []
    for terms in derived.terms:
        for left, right in zip(components, derived.components, strict=True):
            left, right = (sp.sympify(side).subs(list(terms)) for side in (left, right))
            gap = sp.S.Zero if left == right else unit_circles.difference(left, right)
            gaps.append(sp.S.Zero if gap == 0 else sp.factor_terms(sp.simplify(gap)))
    return tuple(gaps)


def _latex(components: Components) -> str:
    texts = [nm.latex(component) for component in components]
    return texts[0] if len(texts) == 1 else r"\left(" + r",\; ".join(texts) + r"\right)"


# ------------------------------------------------------------------------------------------- what
# is derived


def derived_forms() -> dict[str, Derived]:
    """The derivation's counterpart of every printed statement, by id."""
    return {
        **_motion_forms(),
        **_scale_forms(),
        **_balance_forms(),
        **_quartic_forms(),
        **_stability_forms(),
    }


def _motion_forms() -> dict[str, Derived]:
    with_units, scaled = mechanics.measured_motion(), mechanics.motion()
    length = mechanics.measured_length()
    # (3)–(5) turn Δ, cos θ and sin θ into x and y; L is the spring's length.
    geometry = (
        (article.Delta, nm.L_0 - nm.L),
        (nm.c, (nm.L_0 * nm.c0 - nm.x) / nm.L),
        (nm.s, (nm.L_0 * nm.s0 - nm.y) / nm.L),
        (nm.L, length),
    )
    polar = ((nm.x, nm.L_0 * nm.c0 - nm.L * nm.c), (nm.y, nm.L_0 * nm.s0 - nm.L * nm.s))
    u = sp.Symbol("u", positive=True)
    below_on_above = (((nm.y, -u),), ((nm.y, sp.S.Zero),), ((nm.y, u),))
    (pushing, _), (apart, _) = mechanics.contact_force().args
    return {
        "eq-1": Derived(with_units.x, mechanics.measured_motion, terms=(geometry,)),
        "eq-2": Derived(with_units.y, mechanics.measured_motion, terms=(geometry,)),
        "eq-3": Derived(mechanics.compression(), mechanics.compression),
        "eq-4": Derived(sp.S.Zero, equilibrium.displacement, terms=(polar,)),
        "eq-5": Derived(sp.S.Zero, equilibrium.displacement, terms=(polar,)),
        "eq-6": Derived(length, mechanics.measured_length),
        "eq-7": Derived((pushing, apart), mechanics.contact_force),
        "eq-8": Derived(scaled.x, mechanics.motion),
        "eq-9": Derived(scaled.y, mechanics.motion),
        "eq-10": Derived(mechanics.friction(), mechanics.friction),
        "eq-11": Derived(mechanics.contact_law(), mechanics.contact_law, terms=below_on_above),
    }


def _scale_forms() -> dict[str, Derived]:
    scales, groups = mechanics.scales(), mechanics.groups()
    forms = {
        "def-tau": Derived(1 / scales["time"], mechanics.scales),
        "def-prime": Derived(sp.S.One, mechanics.scales),
        **{
            f"def-{name}": Derived(1 / scales["length"], mechanics.scales)
            for name in ("x", "y", "L")
        },
    }
    for symbol in (nm.sigma, nm.alpha, nm.beta, nm.kappa, nm.n):
        dimensional, scale = groups[symbol]
        forms[f"def-{symbol}"] = Derived(dimensional / scale, mechanics.groups)
    return forms


def _balance_forms() -> dict[str, Derived]:
    contact, liftoff = equilibrium.CONTACT, equilibrium.LIFTOFF
    D, b = equilibrium.matrix_form()
    friction = ((nm.mu, nm.mu0),)
    along, across = (force.subs(contact) for force in equilibrium.balance())
    at_rest = sp.Matrix(mechanics.motion()).subs(mechanics.AT_REST)
    lifted = tuple(force.subs(liftoff) for force in equilibrium.balance())
    return {
        "eq-12": Derived(at_rest[0].subs(nm.mu, mechanics.steady_friction()), mechanics.motion),
        "eq-13": Derived(at_rest[1], mechanics.motion),
        "eq-14": Derived(along, equilibrium.balance),
        "eq-15": Derived(across, equilibrium.balance),
        "eq-16": Derived(
            (along, across), equilibrium.matrix_form, about=(D.subs(contact), b.subs(contact))
        ),
        "eq-17": Derived(
            tuple(D.subs(contact)),
            equilibrium.matrix_form,
            about=(equilibrium.matrix_A().subs(contact),),
        ),
        "eq-18": Derived(
            tuple(equilibrium.matrix_A().subs(contact)), equilibrium.matrix_A, terms=(friction,)
        ),
        "eq-19": Derived(tuple(b.subs(contact)), equilibrium.matrix_form, terms=(friction,)),
        "eq-22": Derived(lifted, equilibrium.matrix_form, about=(D.subs(liftoff), b.subs(liftoff))),
        "eq-24": Derived(tuple(D.subs(liftoff)), equilibrium.matrix_form),
        "eq-25": Derived(tuple(b.subs(liftoff)), equilibrium.matrix_form),
    }


def _quartic_forms() -> dict[str, Derived]:
    D, b = equilibrium.matrix_form()
    quartic = elimination.quartic_in_L()
    # Printed in b₁ … b₄; what those stand for is checked by the rows A10–A13.
    sides = (*b.subs(equilibrium.CONTACT), *b.subs(equilibrium.LIFTOFF))
    right_sides = tuple(zip((nm.b1, nm.b2, nm.b3, nm.b4), sides, strict=True))
    # (20) and (23) for any invertible D and any b, so that the printed form is checked as an
    # identity.
    any_pair = sp.Matrix(2, 2, sp.symbols("D11 D12 D21 D22")), sp.Matrix(sp.symbols("B1 B2"))
    forms: dict[str, Derived] = {}
    for equation, vector_names, case, names in (
        ((20, 21), (nm.b1, nm.b2), equilibrium.CONTACT, ("A1-c0", "A2", "A3", "A4", "A5")),
        ((23, 26), (nm.b3, nm.b4), equilibrium.LIFTOFF, ("A1-d0", "A6", "A7", "A8", "A9")),
    ):
        matrix, vector = D.subs(case), b.subs(case)
        coefficients = tuple(value.subs(case) for value in quartic)
        forms[f"eq-{equation[0]}"] = Derived(
            elimination.unit_norm(*any_pair), elimination.unit_norm, any_pair
        )
        forms[f"eq-{equation[1]}"] = Derived(
            elimination.cleared(matrix, vector), elimination.quartic_in_L, coefficients
        )
        shorthand = elimination.quartic_in_L_shorthand()
        in_names = {
            nm.b1: vector_names[0],
            nm.b2: vector_names[1],
            nm.M: nm.mu0 * case[nm.nbar],
        }
        spelled = {nm.p: nm.alpha + nm.sigma, nm.q: nm.beta + case[nm.nbar] + nm.sigma}
        for id, value, full in zip(names, shorthand, coefficients, strict=True):
            arranged = value.subs(in_names, simultaneous=True).subs(spelled)
            if not unit_circles.equal(arranged.subs(right_sides), full):
                raise ArithmeticError(f"{id}: the quartic in shorthand is not the quartic")
            forms[id] = Derived(arranged, elimination.quartic_in_L_shorthand, terms=(right_sides,))
        for id, value in zip(
            ("A10", "A11") if case[nm.nbar] else ("A12", "A13"), vector, strict=True
        ):
            forms[id] = Derived(value, equilibrium.matrix_form)
    return forms


def _stability_forms() -> dict[str, Derived]:
    K = stability.stiffness()
    C = stability.damping()
    law = mechanics.contact_law()
    slopes = tuple(-sp.diff(value, nm.y) for value, _ in law.args)
    return {
        "eq-27": Derived(
            stability.characteristic(K, C).subs(stability.lam, article.lam),
            stability.characteristic,
            (K,),
        ),
        "eq-28": Derived(tuple(K), stability.stiffness),
        "eq-29": Derived(slopes, mechanics.contact_law),
    }
