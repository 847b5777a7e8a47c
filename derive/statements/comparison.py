"""Comparison of a printed statement with its object, by values at samples and by exact algebra.

Both sides may differ by what the object leaves open: the coordinate conventions of the paper, a
constant in an energy, a factor of parameters in an equation of motion.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TypeAlias, cast

import sympy as sp
from sympy import Dummy, Expr, S, Symbol
from sympy.core.relational import Relational

from ..algebra import Pair
from .book import with_defined
from .derivatives import expressions
from .identities import is_zero, quotients
from .objects import LAMBDA, derived
from .reading import BEGUN, Item
from .repair import Values, evaluated, same, same_but_for_constant, same_but_for_factor
from .samples import in_motion, numeric
from .tree import Equation, Node, printed, residual, to_sympy


@dataclass(frozen=True)
class Convention:
    """How a paper counts a coordinate: (print) = sign · (page) + shift."""

    sign: int = 1
    shift: Expr = field(default_factory=lambda: S.Zero)

    def said(self, name: str) -> str:
        """The convention in words, for the coordinate of a name."""
        shift = "" if self.shift == 0 else f" + {self.shift}"
        return f"{name} of the print is {'-' if self.sign < 0 else ''}{name}{shift} of the page"


Conventions: TypeAlias = dict[str, Convention]


@dataclass(frozen=True)
class Component:
    """One printed side with its targets: expressions it may equal, each with values at samples.

    ``left`` is the name that the equation gives a value to, empty for a residual.
    """

    tree: Node
    targets: tuple[tuple[Values, Expr], ...]
    left: str = ""
    #: a remark on each target, often empty
    meanings: Mapping[Expr, str] = field(default_factory=dict)

    @property
    def said(self) -> str:
        """The equation, in SymPy's syntax."""
        return equation_of(self.left, printed(self.tree))


def equation_of(left: str, text: str) -> str:
    """An equation in SymPy's syntax: ``left = text``, or ``text = 0`` without a left side."""
    return f"{left} = {text}" if left else f"{text} = 0"


@dataclass(frozen=True)
class Comparison:
    """A statement with its object, in the coordinate conventions of its paper."""

    item: Item
    conventions: Conventions = field(default_factory=dict)

    @cached_property
    def signs(self) -> dict[Symbol, int]:
        """Signs of those coordinates, rates and accelerations that have conventions."""
        return {
            symbol: self.conventions[str(row[0])].sign
            for row in self.item.derivation.moved
            for symbol in row
            if str(row[0]) in self.conventions
        }

    @cached_property
    def converted(self) -> dict[str, Expr]:
        """Page expressions of the coordinates, rates and accelerations that have conventions."""
        found = {str(symbol): sign * symbol for symbol, sign in self.signs.items()}
        for name, convention in self.conventions.items():
            found[name] += self.item.derivation.measured(convention.shift)
        return found | dict(self.item.meant)

    @cached_property
    def values(self) -> dict[str, Values]:
        """Values of the print's names at the samples, which are states of the page."""
        known = self.item.values
        changed = dict(self.converted)
        if changed:
            changed |= {name: self.names.get(name, sp.nan) for name in self.item.slopes}
        values = {**known} | {name: numeric(it, known) for name, it in changed.items()}
        return with_defined(values, self.item.defined)

    @cached_property
    def names(self) -> dict[str, Expr]:
        """Expressions of the print's names in the page's symbols; lengths and inclinations of lines
        keep symbols of their own.
        """
        derivation = self.item.derivation
        names = derivation.names | {name: Symbol(name) for name in derivation.geometry}
        names |= self.converted
        slopes = self.item.slopes
        names |= {name: it for name, it in self.item.bound.items() if name not in slopes}
        signs = {str(symbol): sign for symbol, sign in self.signs.items()}
        steady = self.item.subject.steady
        return expressions(names, self.item.defined, slopes, derivation, steady=steady, signs=signs)

    def exactly(self, tree: Node) -> Expr:
        """The expression of a printed tree in the page's symbols."""
        return to_sympy(tree, self.names)

    # --------------------------------------------------------------------------------------------
    # components

    def components(self, factors: bool = True) -> list[Component]:
        """The compared side of every printed equation, with its targets.

        Targets are the readings of a value, or the entry of a residual with either sign; if
        ``factors`` also those multiples and quotients of it that the print suggests. They are kept
        with the statement, since they take long to find.
        """
        key = (*self.conventions.items(), factors)
        if key not in self.item.kept:
            self.item.kept[key] = self._components(factors)
        return cast(list[Component], self.item.kept[key])

    def _components(self, factors: bool) -> list[Component]:
        item, subject = self.item, self.item.subject
        found = []
        for equation, place in zip(item.equations, subject.index, strict=True):
            if (side := judged_side(item, equation)) is None:
                continue
            tree, left = side
            sign = self._sign(place)
            target, entry = sign * item.targets[place], sign * subject.entries[place]
            if subject.is_value:
                meanings = {one.entry: one.said for one in subject.readings} or {entry: ""}
                sampled = dict(zip(meanings, item.readings or (target,), strict=True))
                if (coupled := self._coupled(tree, place)) is not None:
                    meanings, sampled = {sign * coupled: "with other accelerations in it"}, {}
                if factors and subject.factor == "constant":
                    free = self._constant(self.exactly(tree))
                    for reading, said in [*meanings.items()]:
                        meanings[reading + free - self._constant(reading)] = said
                found.append(self._component(tree, left, meanings, sampled))
                continue
            meanings, sampled = {entry: "", -entry: ""}, {entry: target, -entry: -target}
            print_values = evaluated(tree, self.values)
            is_entry = any(same(print_values, it) for it in sampled.values())
            is_equation = subject.factor in ("parameters", "monomial")
            for alone in (equation.left, equation.right) if factors and not is_entry else ():
                symbol = item.derivation.names.get(alone.value, S.Zero)
                slope = sp.expand(sp.diff(entry, symbol)) if symbol.is_Symbol else S.Zero
                if is_equation and slope != 0 and not slope.has(symbol):  # solved for it
                    is_left = alone is equation.left
                    meanings[entry / slope if is_left else -entry / slope] = ""
            if factors and not is_entry and is_equation:
                own = self.exactly(tree)
                if subject.steady:  # whose entries hold the laws of the normal forces
                    own = own.xreplace(self.laws(subject.side))
                meanings |= dict.fromkeys(self._multiples(own, entry), "")
                quotients = self._quotients(entry)
                for divisor, rest in quotients:
                    divided = (rest, -rest, *self._multiples(own, rest))
                    meanings |= dict.fromkeys(divided, f"divided by {divisor}")
                if subject.law == "covector":
                    below = self._denominator(own)
                    if below != 1:
                        cleared = self._multiples(sp.cancel(own * below), entry)
                        meanings |= {it / below: f"times {below}" for it in cleared}
                    bases = (entry, *(rest for _, rest in quotients))
                    times = (self._multiplied(own, it) for it in bases)
                    others = (*itertools.chain(*times), *self._inserted(own, place))
                    others += (*self._eliminated(own, place),)
                    for without, said in others:
                        base = sign * without
                        both = (base, -base, *self._multiples(own, base))
                        meanings |= dict.fromkeys(both, said)
                    meanings |= self._combined(own, print_values, [*meanings], place)
            found.append(self._component(tree, "", meanings, sampled))
        return found

    def _component(
        self, tree: Node, left: str, meanings: Mapping[Expr, str], sampled: Mapping[Expr, Values]
    ) -> Component:
        """A side with its targets; their values at samples are computed unless in ``sampled``."""
        values = self.item.values
        targets = ((sampled[it] if it in sampled else numeric(it, values), it) for it in meanings)
        return Component(tree, tuple(targets), left, meanings)

    def _coupled(self, tree: Node, place: int) -> Expr | None:
        """The equation of motion solved for an acceleration, where the print has others on its
        right; else None.
        """
        derivation, subject = self.item.derivation, self.item.subject
        second = derivation.accelerations[place] if place < len(derivation.accelerations) else None
        others = {*derivation.accelerations} - {second}
        if self.item.statement.word != "acceleration" or not self.exactly(tree).has(*others):
            return None
        row = derived(derivation, f"motion, {subject.side}").entries[place]
        return self.item.limited(sp.expand(second - row / sp.diff(row, second)))

    def _denominator(self, own: Expr) -> Expr:
        """What of a print's denominators depends on the state."""
        below = sp.factor(sp.fraction(sp.together(own))[1])
        return below.as_independent(*self.item.derivation.states, as_Add=False)[1]

    def _combined(
        self, own: Expr, own_values: Values, bases: Sequence[Expr], place: int
    ) -> dict[Expr, str]:
        """A derived equation with a multiple of another one, as of the one for N, which the print
        is; none of a print that is no such sum.
        """
        model = self.item.derivation.model
        rows = zip(model.coordinates, self.item.subject.entries, strict=True)
        others = [row for number, row in enumerate(rows) if number != place]
        for base, (name, other) in itertools.product(bases, others):
            for multiple in self._multiples(own - base, other):
                if same(own_values, numeric(base + multiple, self.item.values)):
                    return {base + multiple: f"with a multiple of the equation of {name}"}
        return {}

    def _multiplied(self, own: Expr, entry: Expr) -> Iterator[tuple[Expr, str]]:
        """A derived equation times the coordinates and rates that the print has in each term, or
        all but one.
        """
        derivation = self.item.derivation
        terms, of_ours = (sp.Add.make_args(sp.expand(it)) for it in (own, entry))

        def lacking(state: Expr, among: Sequence[Expr]) -> int:
            return sum(state not in it.as_powers_dict() for it in among)

        times = [
            it
            for it in derivation.states
            if len(terms) > 2 and lacking(it, terms) <= 1 and lacking(it, of_ours) > 1
        ]
        if times:
            yield entry * sp.Mul(*times), f"times {sp.Mul(*times)}"

    def _inserted(self, own: Expr, place: int) -> Iterator[tuple[Expr, str]]:
        """A derived equation solved for its acceleration where the print has no other one."""
        derivation, entry = self.item.derivation, self.item.subject.entries[place]
        if place >= len(derivation.accelerations) or self.item.subject.steady:
            return
        second = derivation.accelerations[place]
        others = {*derivation.accelerations} - {second}
        if own.has(second) and entry.has(*others) and not own.has(*others):
            solved = derived(derivation, f"acceleration, {self.item.subject.side}").entries[place]
            slope, gap = sp.diff(own, second), self.item.limited(second - solved)
            said = "with the other accelerations inserted"
            yield gap * slope, said
            yield sp.fraction(sp.together(gap))[0], said

    def _eliminated(self, own: Expr, place: int) -> Iterator[tuple[Expr, str]]:
        """A derived equation without the normal forces that the print lacks, which other equations
        give: by N itself, or by μ N, the friction, and N.
        """
        derivation, entries = self.item.derivation, self.item.subject.entries
        lacking = [force for force in derivation.normals if not own.has(force)]
        if not entries[place].has(*lacking):
            return
        rubs = itertools.product(derivation.coefficients, lacking)
        frictions: dict[Expr, Expr] = {mu * force: Dummy() for mu, force in rubs}
        for products in ({}, frictions):
            rows = [sp.expand(row).subs(products) for row in entries]
            found = [rows[place]]
            for force in (*products.values(), *lacking):
                for base, other in itertools.product([*found], rows):
                    slope = sp.diff(other, force)
                    if other != rows[place] and slope != 0 and base.has(force):
                        found.append(sp.expand(base - sp.diff(base, force) / slope * other))
            back = {symbol: product for product, symbol in products.items()}
            without = (one.subs(back) for one in found[1:])
            said = "with multiples of other equations, which eliminate N"
            yield from ((one, said) for one in without if not one.has(*lacking))

    def _constant(self, energy: Expr) -> Expr:
        """The terms of an energy that do not depend on the state."""
        derivation = self.item.derivation
        whole = sp.expand(derivation.expanded(energy))
        return whole.as_independent(*derivation.states, as_Add=True)[0]

    def _quotients(self, entry: Expr) -> tuple[Pair, ...]:
        """Divisors in coordinates by which a printed equation of motion may be divided, each with
        the quotient: its own factors, and the mass of its own acceleration.
        """
        derivation, subject = self.item.derivation, self.item.subject
        model, accelerations = derivation.model, derivation.accelerations
        if subject.law != "covector":
            return ()
        place = next(it for it, one in enumerate(subject.entries) if entry in (one, -one))
        entry = derivation.expanded(entry)
        found = quotients(entry, model.coordinates, (*model.rates, *accelerations))
        mass = sp.diff(entry, accelerations[place])
        if mass.has(*model.coordinates):
            found += ((mass, sp.expand(entry / mass)),)
        return found

    def _sign(self, place: int) -> int:
        """The sign of an entry in the print's coordinates, by its law of transformation."""
        model = self.item.derivation.model
        names = [str(symbol) for symbol in model.coordinates if symbol != model.clock]
        signs = [self.conventions.get(name, Convention()).sign for name in names]
        match self.item.subject.law:
            case "covector" | "vector":
                return signs[place]
            case "form":
                rows = math.isqrt(len(self.item.subject.entries))
                signs = [signs[it] for it in self.item.subject.rows] or signs * (rows // len(signs))
                return signs[place // rows] * signs[place % rows]
            case _:
                return 1

    def _multiples(self, own: Expr, entry: Expr) -> list[Expr]:
        """The derived entry times factors of parameters that may bring it to the printed form.

        Terms of both that are equal apart from parameters vote for the ratio of their factors; the
        four ratios with most votes are taken.
        """
        derivation = self.item.derivation
        moving = (*derivation.states, *derivation.accelerations)
        states = (*moving, LAMBDA, *derivation.laws)

        def apart(expression: Expr) -> list[Pair]:
            """The factor of parameters and the remaining factor of each of the first 40 terms."""
            terms = sp.Add.make_args(sp.expand(expression))[:40]
            pairs = [term.as_independent(*states, as_Add=False) for term in terms]
            whole: dict[Expr, list[Expr]] = {}
            for factor, state in pairs:
                whole.setdefault(state, []).append(factor)
            # Also the factors of one state together, as of an equation with a multiple of another.
            together = ((sp.Add(*it), state) for state, it in whole.items() if it[1:])
            return [*pairs, *together]

        ours = apart(derivation.expanded(entry))
        votes: dict[Expr, int] = {}
        for factor, state in apart(derivation.expanded(own)):
            for factor_of_ours, same_state in ours:
                if state == same_state and factor_of_ours != 0:
                    ratio = factor / factor_of_ours
                    if factor.is_Add or factor_of_ours.is_Add:
                        ratio = sp.factor(ratio)
                    votes[ratio] = votes.get(ratio, 0) + 1
        found = sorted(votes, key=lambda it: (-votes[it], sp.count_ops(it), str(it)))[:4]
        return [factor * entry for factor in found]

    # --------------------------------------------------------------------------------------------
    # equality

    @property
    def agrees(self) -> bool:
        """Whether the statement holds at all samples, up to a factor of parameters."""
        BEGUN.get()(self.item.statement.id)
        parts = self.components(factors=False)
        return bool(parts) and all(
            any(self.holds(part.tree, target) for target, _ in part.targets) or self._factored(part)
            for part in parts
        )

    def _factored(self, part: Component) -> bool:
        """Whether print and target have the same ratio in both states of every pair, so that they
        differ by a factor of parameters.
        """
        if self.item.subject.factor != "parameters":
            return False
        print_values, values = evaluated(part.tree, self.values), self.item.values
        target, entry = part.targets[0]
        divisors = (S.One, *(divisor for divisor, _ in self._quotients(entry)))
        divided = (print_values * numeric(divisor, values) for divisor in divisors)
        return any(same_but_for_factor(it, target) for it in divided)

    def holds(self, tree: Node, target: Values) -> bool:
        """Whether a tree has its target's values, up to a constant in an energy."""
        return self._are_same(evaluated(tree, self.values), target)

    def _are_same(self, own: Values, target: Values) -> bool:
        is_constant = self.item.subject.factor == "constant"
        return (same_but_for_constant if is_constant else same)(own, target)

    def proved(self, tree: Node, entry: Expr) -> bool:
        """Whether a tree is proved to equal a derived expression."""
        return self._are_equal(self.exactly(tree), entry)

    def equals(self, one: Expr, other: Expr) -> bool:
        """Whether two expressions are equal, at all samples and by exact algebra."""
        values = self.item.values
        is_near = self._are_same(numeric(one, values), numeric(other, values))
        return is_near and self._are_equal(one, other)

    def _are_equal(self, one: Expr, other: Expr) -> bool:
        derivation, subject, gap = self.item.derivation, self.item.subject, one - other
        if subject.factor == "constant":
            gap = derivation.expanded(gap)
            return all(is_zero(sp.diff(gap, symbol)) for symbol in derivation.states)
        return all(self._vanishes(gap, side) for side in derivation.meant(subject.side))

    def laws(self, side: str) -> dict[Symbol, Expr]:
        """Expressions of the normal forces and friction coefficients on a side of the contacts."""
        derivation = self.item.derivation
        forces = zip(derivation.normals.items(), derivation.model.contacts, strict=True)
        pressed = {symbol: derivation.pushing(one, side) * law for (symbol, law), one in forces}
        return (derivation.at_rest if self.item.subject.steady else derivation.friction) | pressed

    def _vanishes(self, gap: Expr, side: str) -> bool:
        """Whether a difference is proved to be 0 on a side of the contacts, as it stands or with
        the laws of forces inserted.
        """
        derivation, subject = self.item.derivation, self.item.subject
        if subject.along:
            gap = gap.xreplace(in_motion(derivation, replace(subject, side=side)))
        touching = (derivation.pushing(contact, side) for contact in derivation.model.contacts)
        gap = gap.xreplace(dict(zip(derivation.switches, touching, strict=True)))
        named = dict.fromkeys((gap, gap.xreplace(self.laws(side))))
        return any(map(is_zero, named)) or any(
            is_zero(self._on_side(derivation.expanded(one), side)) for one in named
        )

    def _on_side(self, value: Expr, side: str) -> Expr:
        """An expression with |g|, sign(g) and relations to 0 resolved for each gap g on a side, and
        for the sliding speeds if every belt is ahead.
        """
        derivation = self.item.derivation
        for contact in derivation.model.contacts:
            if contact.unilateral:
                is_closed = contact.name in derivation.sides[side]
                value = _with_sign(value, derivation.gaps[contact.name], -1 if is_closed else 1)
        for speed in derivation.speeds if self.item.subject.ahead else ():
            value = _with_sign(value, derivation.expanded(speed), 1)
        return value


def _with_sign(value: Expr, gap: Expr, side: int) -> Expr:
    """An expression with |g|, sign(g) and relations of g to 0 resolved, for a gap g of known sign
    ``side``.
    """
    for node in value.atoms(sp.Abs, sp.sign, Relational):
        size = node.lhs - node.rhs if isinstance(node, Relational) else node.args[0]
        for sign in (1, -1):
            if is_zero(size - sign * gap):
                known = side * gap if isinstance(node, sp.Abs) else sp.Integer(side * sign)
                if isinstance(node, Relational):
                    known = node.func(known, 0)
                value = value.xreplace({node: known})
    return value


def judged_side(item: Item, equation: Equation) -> tuple[Node, str] | None:
    """The side of an equation that is compared with the object, and the name that the equation
    gives to it; None if the equation does not give the value of a name.
    """
    left, right = equation.left, equation.right
    is_residual = printed(right) == "0"
    if not item.subject.is_value and not is_residual:
        return residual(equation), ""
    if item.subject.is_value and (printed(left) in item.subject.names or _is_new(item, left)):
        return right, printed(left)
    return (left, "") if is_residual else None


def _is_new(item: Item, left: Node) -> bool:
    """Whether a left side is a name that the page has not; of a scale, any name."""
    known = item.subject.law != "scale" and left.value in item.derivation.names
    return left.kind == "symbol" and not known
