"""A printed statement beside what it is about: at samples, and by exact algebra."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeAlias

import numpy as np
import sympy as sp
from sympy import Expr, S, Symbol
from sympy.core.relational import Relational

from ..algebra import Pair
from .derivatives import expressions
from .identities import is_zero, quotients
from .objects import LAMBDA
from .reading import Item
from .repair import Values, evaluated, same, same_but_for_constant
from .samples import numeric
from .tree import Equation, Node, printed, residual, to_sympy


@dataclass(frozen=True)
class Convention:
    """Coordinates of the print as sign · coordinate of the page + shift."""

    sign: int = 1
    shift: Expr = field(default_factory=lambda: S.Zero)

    def said(self, name: str) -> str:
        """Convention in words."""
        shift = "" if self.shift == 0 else f" + {self.shift}"
        return f"{name} of the print is {'-' if self.sign < 0 else ''}{name}{shift} of the page"


Conventions: TypeAlias = dict[str, Convention]


@dataclass(frozen=True)
class Component:
    """One printed side, and what it ought to be: values, and the same exactly."""

    tree: Node
    targets: tuple[tuple[Values, Expr], ...]
    left: str = ""
    #: what is to be said of each
    meanings: Mapping[Expr, str] = field(default_factory=dict)

    @property
    def said(self) -> str:
        """The equation, in SymPy's syntax."""
        return equation_of(self.left, printed(self.tree))


def equation_of(left: str, text: str) -> str:
    """A text beside the name that it gives a value to, or beside 0."""
    return f"{left} = {text}" if left else f"{text} = 0"


@dataclass(frozen=True)
class Comparison:
    """A statement beside its object, in the conventions of its paper."""

    item: Item
    conventions: Conventions = field(default_factory=dict)

    @cached_property
    def signs(self) -> dict[Symbol, int]:
        """Signs of the coordinates, rates and accelerations that have conventions."""
        it = self.item.it
        return {
            symbol: self.conventions[str(row[0])].sign
            for row in zip(it.model.coordinates, it.model.rates, it.accelerations, strict=True)
            for symbol in row
            if str(row[0]) in self.conventions
        }

    @cached_property
    def converted(self) -> dict[str, Expr]:
        """Names of the print that stand for something else than on the page, and for what."""
        found = {str(symbol): sign * symbol for symbol, sign in self.signs.items()}
        for name, convention in self.conventions.items():
            found[name] += self.item.it.measured(convention.shift)
        return found

    @cached_property
    def values(self) -> dict[str, Values]:
        """Values of the print's names where the page's are the samples'."""
        known = self.item.values
        changed = {name: numeric(it, known) for name, it in self.converted.items()}
        slopes = {name: self.names[name] for name in self.item.slopes} if changed else {}
        values = {**known, **changed} | {name: numeric(it, known) for name, it in slopes.items()}
        for name, tree in self.item.defined.items():
            values[name] = evaluated(tree, values)
        return values

    @cached_property
    def names(self) -> dict[str, Expr]:
        """Names of the print in the page's symbols; geometry stays in names."""
        it = self.item.it
        names = it.names | {name: Symbol(name) for name in it.geometry}
        names |= self.converted
        slopes = self.item.slopes
        names |= {name: it for name, it in self.item.bound.items() if name not in slopes}
        signs = {str(symbol): sign for symbol, sign in self.signs.items()}
        steady = self.item.held.steady
        return expressions(names, self.item.defined, slopes, it, steady=steady, signs=signs)

    def exactly(self, tree: Node) -> Expr:
        """A tree of the print in the page's symbols."""
        return to_sympy(tree, self.names)

    # --------------------------------------------------------------------------------- components

    def components(self, factors: bool = True) -> list[Component]:
        """Every printed equation with what its side ought to be, once for each possible factor."""
        item, held = self.item, self.item.held
        found = []
        for equation, place in zip(item.equations, held.index, strict=True):
            if (side := judged_side(item, equation)) is None:
                continue
            tree, left = side
            sign = self._sign(place)
            target, entry = sign * item.targets[place], sign * held.entries[place]
            if held.is_value:
                meanings = {one.entry: one.said for one in held.readings} or {entry: ""}
                known = dict(zip(meanings, item.readings or (target,), strict=True))
                if factors and held.factor == "constant":
                    free = self._constant(self.exactly(tree))
                    for one, said in [*meanings.items()]:
                        meanings[one + free - self._constant(one)] = said
                found.append(self._component(tree, left, meanings, known))
                continue
            meanings, known = {entry: "", -entry: ""}, {entry: target, -entry: -target}
            own = evaluated(tree, self.values)
            plain = any(same(own, it) for it in known.values())
            if factors and not plain and held.factor in ("parameters", "monomial"):
                meanings |= dict.fromkeys(self._multiples(tree, entry), "")
                for divisor, rest in self._quotients(entry):
                    some = (rest, -rest, *self._multiples(tree, rest))
                    meanings |= dict.fromkeys(some, f"divided by {divisor}")
            found.append(self._component(tree, "", meanings, known))
        return found

    def _component(
        self, tree: Node, left: str, meanings: Mapping[Expr, str], known: Mapping[Expr, Values]
    ) -> Component:
        """A side with what it may mean, of which the values at samples are known or found."""
        values = self.item.values
        targets = ((known[it] if it in known else numeric(it, values), it) for it in meanings)
        return Component(tree, tuple(targets), left, meanings)

    def _constant(self, energy: Expr) -> Expr:
        """Terms of an energy that hold no state."""
        it = self.item.it
        states = (*it.model.coordinates, *it.model.rates)
        return sp.expand(it.expanded(energy)).as_independent(*states, as_Add=True)[0]

    def _quotients(self, entry: Expr) -> tuple[Pair, ...]:
        """Factors of an equation that hold coordinates, by which it may be divided, and what is
        left.
        """
        model = self.item.it.model
        if self.item.held.law != "covector":
            return ()
        moving = (*model.rates, *self.item.it.accelerations)
        return quotients(self.item.it.expanded(entry), model.coordinates, moving)

    def _sign(self, place: int) -> int:
        """The sign by which an entry changes with the coordinates."""
        names = [str(symbol) for symbol in self.item.it.model.coordinates]
        signs = [self.conventions.get(name, Convention()).sign for name in names]
        match self.item.held.law:
            case "covector" | "vector":
                return signs[place]
            case "form":
                rows = math.isqrt(len(self.item.held.entries))
                signs *= rows // len(signs)
                return signs[place // rows] * signs[place % rows]
            case _:
                return 1

    def _multiples(self, tree: Node, entry: Expr) -> list[Expr]:
        """Multiples by factors of parameters by which terms of the print are derived ones, by
        votes.
        """
        it = self.item.it
        model = it.model
        forces = (*it.normals, *it.coefficients)
        states = (*model.coordinates, *model.rates, *it.accelerations, LAMBDA, *forces)

        def apart(expression: Expr) -> list[Pair]:
            """Factors of parameters, and what else stands in each term."""
            # Terms of either side of a residual, by whose ratios its factor is
            # found.
            terms = sp.Add.make_args(sp.expand(expression))[:40]
            return [term.as_independent(*states, as_Add=False) for term in terms]

        ours = apart(it.expanded(entry))
        votes: dict[Expr, int] = {}
        for factor, state in apart(self.exactly(tree)):
            for own, same_state in ours:
                if state == same_state and own != 0:
                    votes[factor / own] = votes.get(factor / own, 0) + 1
        found = sorted(votes, key=lambda it: (-votes[it], sp.count_ops(it), str(it)))[:4]
        return [factor * entry for factor in found]

    # ----------------------------------------------------------------------------------- equality

    @property
    def agrees(self) -> bool:
        """Whether the statement holds at all samples."""
        parts = self.components(factors=False)
        return bool(parts) and all(
            any(self.holds(part.tree, target) for target, _ in part.targets) or self._factored(part)
            for part in parts
        )

    def _factored(self, part: Component) -> bool:
        """Whether the ratio of both is the same in both states of every pair."""
        if self.item.held.factor != "parameters":
            return False
        own, values = evaluated(part.tree, self.values), self.item.values
        divisors = (divisor for divisor, _ in self._quotients(part.targets[0][1]))
        for divisor in (S.One, *divisors):
            with np.errstate(all="ignore"):
                ratio = own * numeric(divisor, values) / part.targets[0][0]
            if same(ratio[::2], ratio[1::2]):
                return True
        return False

    def holds(self, tree: Node, target: Values) -> bool:
        """Whether a tree has the values that it ought to have, but for a constant in an energy."""
        return self._are_same(evaluated(tree, self.values), target)

    def _are_same(self, own: Values, target: Values) -> bool:
        is_constant = self.item.held.factor == "constant"
        return (same_but_for_constant if is_constant else same)(own, target)

    def proved(self, tree: Node, entry: Expr) -> bool:
        """Whether a tree is the derived expression, by exact algebra."""
        return self._are_equal(self.exactly(tree), entry)

    def equals(self, one: Expr, other: Expr) -> bool:
        """Whether two expressions are equal, at all samples and by exact algebra."""
        values = self.item.values
        is_near = self._are_same(numeric(one, values), numeric(other, values))
        return is_near and self._are_equal(one, other)

    def _are_equal(self, one: Expr, other: Expr) -> bool:
        it, held, gap = self.item.it, self.item.held, one - other
        if held.factor == "constant":
            states = (*it.model.coordinates, *it.model.rates)
            return all(is_zero(sp.diff(it.expanded(gap), symbol)) for symbol in states)
        sides = it.sides if held.side == "both" else (held.side,)
        return all(self._vanishes(gap, side) for side in sides)

    def laws(self, side: str) -> dict[Symbol, Expr]:
        """What normal forces and friction coefficients are on a side of the contacts."""
        it = self.item.it
        forces = zip(it.normals.items(), it.model.contacts, strict=True)
        pressed = {symbol: it.pushing(one, side) * law for (symbol, law), one in forces}
        return (it.at_rest if self.item.held.steady else it.friction) | pressed

    def _vanishes(self, gap: Expr, side: str) -> bool:
        """Whether a difference is 0 on a side of the contacts: as it stands, or by the laws."""
        it = self.item.it
        touching = (it.pushing(contact, side) for contact in it.model.contacts)
        gap = gap.xreplace(dict(zip(it.switches, touching, strict=True)))
        named = dict.fromkeys((gap, gap.xreplace(self.laws(side))))
        return any(map(is_zero, named)) or any(
            is_zero(self._on_side(it.expanded(one), side)) for one in named
        )

    def _on_side(self, value: Expr, side: str) -> Expr:
        """A value with sizes and signs of the gaps, and relations to 0, as they are on a side; of
        sliding speeds where every belt is ahead.
        """
        it = self.item.it
        for contact in it.model.contacts:
            if contact.unilateral:
                gap = it.expanded(it.spelled(contact.gap))
                value = _with_sign(value, gap, -1 if contact.name in it.sides[side] else 1)
        for speed in it.speeds if self.item.held.ahead else ():
            value = _with_sign(value, it.expanded(speed), 1)
        return value


def _with_sign(value: Expr, gap: Expr, side: int) -> Expr:
    """A value with the size and the sign of a gap, and its relations to 0, where its sign is
    known.
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
    """Side of an equation that is held against the object, and the name that it gives to it."""
    left, right = equation.left, equation.right
    is_residual = printed(right) == "0"
    if not item.held.is_value and not is_residual:
        return residual(equation), ""
    if item.held.is_value and (printed(left) in item.held.names or _is_new(item, left)):
        return right, printed(left)
    return (left, "") if is_residual else None  # 2 T = … is no value of T; an expression alone is


def _is_new(item: Item, left: Node) -> bool:
    """Whether a name on the left is none of the page, or, of a scale, what is scaled."""
    known = item.held.law != "scale" and left.value in item.it.names
    return left.kind == "symbol" and not known
