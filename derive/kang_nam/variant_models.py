"""Which printed statements no longer hold when the model changes: every printed row against the
model of a page.

A row rests on few things: the geometry of the spring, the laws of contact and friction, the balance
of forces, and so on. Each of these is compared with the article's, by exact algebra; a row holds
where all that it rests on is the article's, fails where something differs, with the difference, and
has no meaning where the model lacks what it is about. Misprints of the article are corrected before
a row is judged.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from operator import methodcaller
from typing import TypeAlias

import sympy as sp

from .. import algebra, laws, linearization, physical_checks, statics, units
from ..mechanics import DEPTH, MU, PUSHING, SIDE, Line, Mechanics
from ..motion import Motion
from ..statements.papers import Statement
from . import article, equilibrium, mechanics, stability
from . import nomenclature as nm

HOLDS, FAILS, NO_MEANING = "holds", "fails", "no meaning"
#: Differences, model less article, by what they are of.
Gaps: TypeAlias = dict[str, sp.Expr]


@dataclass(frozen=True)
class Judgement:
    """What becomes of one printed row: the difference, model less article, or why it has no
    meaning.
    """

    id: str
    where: str
    status: str
    remark: str = ""


class NoMeaning(Exception):
    """The model lacks what a row is about."""


def judge(model: Mechanics) -> list[Judgement]:
    """Every row of the article, in its order."""
    compared = _Compared(model)
    return [_judged(entry, compared) for entry in article.printed().statements]


def _judged(entry: Statement, compared: _Compared) -> Judgement:
    found = []
    try:
        for aspect in RESTS_ON[entry.id]:
            found += [f"{name}: {gap}" for name, gap in aspect(compared).items() if gap != 0]
    except NoMeaning as reason:
        return Judgement(entry.id, entry.where, NO_MEANING, str(reason))
    return Judgement(entry.id, entry.where, FAILS if found else HOLDS, "; ".join(found))


class _Compared:
    """Differences between a model and the article's, each found once."""

    def __init__(self, model: Mechanics) -> None:
        self.model = model
        self.places = {str(symbol): row for row, symbol in enumerate(model.coordinates)}
        #: Where the mass never leaves the belt there is no n̄ in what is compared.
        self.always = (
            {} if model.contact.unilateral and model.contact.gap is not None else {nm.nbar: 1}
        )

    def row(self, name: str) -> int:
        """The number of a coordinate."""
        if name not in self.places:
            raise NoMeaning(f"the model has no coordinate {name}")
        return self.places[name]

    def pairs(self) -> Iterator[tuple[str, int, int]]:
        """Indices of a matrix, and the numbers of the coordinates that they mean."""
        numbers = [(str(place), self.row(name)) for place, name in enumerate(("x", "y"), 1)]
        return (
            (i + j, row, column) for (i, row), (j, column) in itertools.product(numbers, repeat=2)
        )

    @cached_property
    def line(self) -> Line:
        """The inclined spring."""
        if not self.model.lines:
            raise NoMeaning("there is no inclined spring")
        return self.model.lines[0]

    def named(self, expression: sp.Expr) -> sp.Expr:
        """An expression of the page in the symbols of the nomenclature, where it has them."""
        entries = nm.quantities()
        names = {
            symbol: entries[str(symbol)].symbol
            for symbol in expression.free_symbols
            if str(symbol) in entries
        }
        special = {MU: nm.mu, PUSHING: nm.nbar, SIDE: nm.side}
        if self.model.lines:
            special |= {self.line.c: nm.c, self.line.s: nm.s, self.line.l: nm.L}
        return expression.subs(names | special, simultaneous=True)

    def polar(self, expression: sp.Expr) -> sp.Expr:
        """With x and y by the direction and the length of the inclined spring."""
        known = equilibrium.displacement() if self.model.lines else {}
        return sp.expand(expression.subs(known, simultaneous=True))

    def gap(self, ours: sp.Expr, theirs: sp.Expr) -> sp.Expr:
        """Model less article in these; 0 if equal."""
        circles = (*nm.UNIT_CIRCLES, *((line.c, line.s) for line in self.model.lines[1:]))
        left, right = (
            self.polar(side.subs(self.always)) for side in (self.named(ours), sp.sympify(theirs))
        )
        found = algebra.difference(left, right, circles)
        return sp.S.Zero if found == 0 else sp.factor_terms(sp.expand(found))

    def at_rest(self, row: int, pushing: int) -> sp.Expr:
        """The balance along x or y. Friction is μ₀ times the contact force, as in the article: the
        model's μ is a row of its own.
        """
        it = self.model
        force = it.residuals[self.row("xy"[row])].subs({PUSHING: pushing, MU: nm.mu0})
        return self.named(force if it.contact.gap is None else force.subs(DEPTH, -it.contact.gap))

    # ---------------------------------------------------------------------------------------------
    # aspects

    def geometry(self, row: int) -> Gaps:
        """L cos θ or L sin θ."""
        name, ours, theirs = (
            ("cos", self.line.dx, nm.c0 - nm.x),
            ("sin", self.line.dy, nm.s0 - nm.y),
        )[row]
        return {f"L {name} θ": sp.expand(self.named(ours) - theirs)}

    def rest(self) -> Gaps:
        """The undeformed length."""
        return {"undeformed length": sp.expand(self.line.rest - 1)}

    def motion(self, row: int) -> Gaps:
        """x″ or y″."""
        equations = mechanics.motion()
        # Any law of contact and friction: both stand as n and μ, and are rows of their own.
        theirs = sp.solve(equations[row], (mechanics.AX, mechanics.AY)[row])[0]
        general, place = Motion(self.model), self.row("xy"[row])
        ours = sp.expand(
            general.named[place] - general.balance(nm.n)[place] / self.model.mass[place, place]
        )
        return {"xy"[row] + "″": self.gap(ours, theirs)}

    def contact(self) -> Gaps:
        """n(y) in contact, and that there is none in lift-off."""
        it = self.model
        if it.contact.gap is None:
            raise NoMeaning("the normal force is given: there is no contact law")
        lift = sp.S.Zero if it.contact.unilateral else it.contact.law
        return {
            "n(δ)": sp.expand(it.contact.law - DEPTH),
            "n in lift-off": sp.expand(lift),
            "gap": sp.expand(self.named(it.contact.gap) - nm.y),
        }

    def friction(self) -> Gaps:
        """μ at the sliding speed."""
        if self.model.friction.along is None:
            raise NoMeaning("there is no friction")
        ours = self.named(laws.smooth_friction(self.model.friction, felt=True))
        return {"μ": _law_gap(ours - mechanics.smooth_friction(nm.side))}

    def steady(self) -> Gaps:
        """μ at rest."""
        return {
            "μ at rest": _law_gap(self.named(laws.friction_at_rest(self.model.friction)) - nm.mu0)
        }

    def balance(self, row: int, pushing: int) -> Gaps:
        """F_x or F_y."""
        theirs = equilibrium.balance_cartesian()[row].subs(nm.nbar, pushing)
        return {
            ("F_x", "F_y")[row] + ("" if pushing else " in lift-off"): self.gap(
                self.at_rest(row, pushing), theirs
            )
        }

    def linear(self, pushing: int) -> Gaps:
        """That the balance is linear in cos θ and sin θ, without which there are no D and b."""
        it = self.model
        if not pushing and not it.contact.unilateral:
            raise NoMeaning("the mass never leaves the belt: there is no lift-off")
        if len(it.coordinates) != 2:
            raise NoMeaning(f"the balance has {len(it.coordinates)} unknowns: there are no D and b")
        if len(it.lines) != 1:
            raise NoMeaning(
                f"there are {len(it.lines)} inclined springs: the balance is not linear in "
                "one direction"
            )
        for row in (0, 1):
            ours = self.polar(self.at_rest(row, pushing))
            if ours.has(*it.turned) or any(
                sp.diff(ours, one, other) != 0 for one in (nm.c, nm.s) for other in (nm.c, nm.s)
            ):
                raise NoMeaning(
                    "the balance is not linear in cos θ and sin θ: there are no D and b, and "
                    "no quartic in L"
                )
        return {}

    def matrix(self, pushing: int) -> Gaps:
        """D: the part of the balance that is linear in cos θ and sin θ."""
        self.linear(pushing)
        D = equilibrium.matrix_form()[0].subs(nm.nbar, pushing)
        ours = sp.Matrix([self.polar(self.at_rest(row, pushing)) for row in (0, 1)]).jacobian(
            [nm.c, nm.s]
        )
        return {
            f"D_{i + 1}{j + 1}": sp.factor_terms(sp.expand(ours[i, j] - D[i, j]))
            for i in (0, 1)
            for j in (0, 1)
        }

    def side(self, row: int, pushing: int) -> Gaps:
        """A component of the right side."""
        self.linear(pushing)
        theirs = equilibrium.matrix_form()[1].subs(nm.nbar, pushing)[row]
        ours = -self.polar(self.at_rest(row, pushing)).subs({nm.c: 0, nm.s: 0})
        same = algebra.difference(ours, theirs, nm.UNIT_CIRCLES) == 0
        return {
            f"b_{row + 1 if pushing else row + 3}": sp.S.Zero
            if same
            else sp.simplify(ours - theirs)
        }

    def stiffness(self) -> Gaps:
        """K."""
        rows = statics.jacobian(self.model)
        found = {f"K_{index}": rows[i][j].subs(MU, nm.mu0) for index, i, j in self.pairs()}
        return dict(zip(found, map(self.gap, found.values(), stability.stiffness()), strict=True))

    def damping(self) -> Gaps:
        """C, and the masses."""
        damped, found = linearization.damping(self.model), {}
        for (index, i, j), theirs in zip(self.pairs(), stability.damping(), strict=True):
            found[f"C_{index}"] = self.gap(damped[i, j], theirs)
            found[f"M_{index}"] = sp.expand(self.named(self.model.mass[i, j]) - int(i == j))
        return found

    def alone(self) -> Gaps:
        """That there are no unknowns besides x and y."""
        if len(self.model.coordinates) != 2:
            raise NoMeaning(
                f"the linearization has {len(self.model.coordinates)} unknowns: its "
                "determinant is of higher order"
            )
        return {}

    def group(self, name: str) -> Gaps:
        """A dimensionless quantity, or a scale, by the quantities with units."""
        ours = physical_checks.groups(self.model.page).get(name)
        if ours is None:
            raise NoMeaning(f"the model has no {name}")
        dimensional, scale = mechanics.groups()[nm.quantities()[name].symbol]
        return {name: _quotient_gap(ours, dimensional / scale)}

    def length_of(self, name: str) -> Gaps:
        """The unit of a coordinate, or of the length of the inclined spring."""
        if name == "L":
            _ = self.line
        else:
            self.row(name)
        return self.scale("length")

    def scale(self, name: str) -> Gaps:
        ours = physical_checks.scale(self.model.page, getattr(units, name.upper()))
        if ours is None:
            raise NoMeaning(f"the model has no unit of {name}")
        return {f"unit of {name}": _quotient_gap(ours, mechanics.scales()[name])}


def _quotient_gap(ours: sp.Expr, theirs: sp.Expr) -> sp.Expr:
    """What ours is where it is not theirs, symbols taken by their names; else 0."""
    by_name = {
        it: sp.Symbol(str(it), positive=True) for it in ours.free_symbols | theirs.free_symbols
    }
    return sp.S.Zero if sp.simplify(ours.subs(by_name) / theirs.subs(by_name)) == 1 else ours


def _law_gap(gap: sp.Expr) -> sp.Expr:
    """The difference of two laws, 0 if equal. Simplifying one of tanh takes minutes: what numbers
    tell from 0 is left as it stands.
    """
    others = sorted(gap.free_symbols - {nm.side}, key=str)
    place = {nm.side: 1} | {
        symbol: sp.Rational(1, 2) + sp.Rational(i, 7) for i, symbol in enumerate(others)
    }
    value = gap.subs(place).evalf(30)
    return (
        sp.factor_terms(gap)
        if value.is_comparable and abs(value) > sp.Rational(1, 10**20)
        else sp.simplify(gap)
    )


_Aspect = Callable[[_Compared], Gaps]


_C = _Compared
_GEOMETRY_X, _GEOMETRY_Y = (methodcaller("geometry", row) for row in (0, 1))
_ALONG, _ACROSS = (methodcaller("motion", row) for row in (0, 1))
_BALANCE_X, _BALANCE_Y = (methodcaller("balance", row, 1) for row in (0, 1))
_LINEAR, _MATRIX = methodcaller("linear", 1), methodcaller("matrix", 1)
_LINEAR_LIFTED, _MATRIX_LIFTED = methodcaller("linear", 0), methodcaller("matrix", 0)
_B1, _B2, _B3, _B4 = (methodcaller("side", row, pushing) for pushing in (1, 0) for row in (0, 1))

#: Row → what it rests on.
RESTS_ON: dict[str, tuple[_Aspect, ...]] = {
    "eq-1": (_ALONG,),
    "eq-2": (_ACROSS,),
    "eq-3": (_C.rest,),
    "eq-4": (_GEOMETRY_X,),
    "eq-5": (_GEOMETRY_Y,),
    "eq-6": (_GEOMETRY_X, _GEOMETRY_Y),
    "eq-7": (_C.contact,),
    "eq-8": (_ALONG,),
    "eq-9": (_ACROSS,),
    "eq-10": (_C.friction,),
    "eq-11": (_C.contact,),
    "eq-12": (_ALONG, _C.steady),
    "eq-13": (_ACROSS,),
    "eq-14": (_BALANCE_X, _C.steady),
    "eq-15": (_BALANCE_Y,),
    "eq-16": (_LINEAR,),
    "eq-17": (_MATRIX,),
    "eq-18": (_MATRIX,),
    "eq-19": (_B1, _B2),
    "eq-20": (_LINEAR,),
    "eq-21": (_MATRIX,),
    "eq-22": (_LINEAR_LIFTED,),
    "eq-23": (_LINEAR_LIFTED,),
    "eq-24": (_MATRIX_LIFTED,),
    "eq-25": (_B3, _B4),
    "eq-26": (_MATRIX_LIFTED,),
    "eq-27": (_C.alone, _C.damping),
    "eq-28": (_C.stiffness,),
    "eq-29": (_C.contact,),
    "def-tau": (methodcaller("scale", "time"),),
    "def-prime": (),
    "def-n": (methodcaller("scale", "force"),),
    **{f"def-{name}": (methodcaller("length_of", name),) for name in ("x", "y", "L")},
    **{
        f"def-{name}": (methodcaller("group", name),)
        for name in ("sigma", "alpha", "beta", "kappa")
    },
    **dict.fromkeys(("A1-c0", "A2", "A3", "A4", "A5"), (_MATRIX,)),
    **dict.fromkeys(("A1-d0", "A6", "A7", "A8", "A9"), (_MATRIX_LIFTED,)),
    "A10": (_B1,),
    "A11": (_B2,),
    "A12": (_B3,),
    "A13": (_B4,),
}
