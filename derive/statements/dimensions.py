"""Dimensions of a paper's names, solved from its own equations by exact elimination.

What [units] says is given; every sum has terms of one dimension, and what a function is taken of
has none. An equation that contradicts these, and those printed before it, is told with its term.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from .. import units
from ..units import Dimension
from .alone import moving_names, read_alone
from .book import TOO_LARGE
from .papers import Paper, PaperError
from .tree import Equation, Node, Unread, printed

#: A product of powers of names, and a given dimension.
_Monomial = tuple[dict[str, Fraction], Dimension]
_FREE = ("Abs", "max", "min")  #: functions that keep the dimension of what they are taken of
_ONE = Fraction(1)


@dataclass
class _System:
    """Names that are products of powers of others, as found so far."""

    solved: dict[str, _Monomial] = field(default_factory=dict)

    def reduced(self, one: _Monomial) -> _Monomial:
        """A monomial in names that are not solved."""
        powers, given = dict(one[0]), one[1]
        while known := next((it for it in powers if it in self.solved), None):
            power, (inside, dimension) = powers.pop(known), self.solved[known]
            given = units.times(given, dimension, power)
            for name, more in inside.items():
                powers[name] = powers.get(name, Fraction(0)) + power * more
        return {name: it for name, it in powers.items() if it}, given

    def add(self, one: _Monomial) -> Dimension | None:
        """Require that a monomial has no dimension; the one that it has, if it can't."""
        powers, given = self.reduced(one)
        if not powers:
            return given if given != units.NONE else None
        name, power = next(iter(powers.items()))
        rest = {it: -other / power for it, other in powers.items() if it != name}
        self.solved[name] = rest, units.times(units.NONE, given, -1 / power)
        return None


def problems(paper: Paper) -> dict[str, str]:
    """What is wrong with the units of each statement, by its id.

    Raises
    ------
    PaperError
        If [units] holds what is no unit.
    """
    if not paper.units:
        return {}
    system = _System()
    for name, text in paper.units.items():
        try:
            system.solved[name] = {}, units.read(text)
        except units.UnitsError as error:
            raise PaperError(f"[units], {name}: {error}") from error
    system.solved.setdefault("t", ({}, units.read("s")))
    kept = [it for it in paper.statements if it.word != "notation" and it.form != "scaled"]
    moving = moving_names((it.judged for it in kept if it.is_latex), paper.renamed)
    found: dict[str, str] = {}
    for it in kept:
        try:
            is_latex = it.is_latex and not it.transcribed
            equations = read_alone(it.judged, moving, paper.renamed, is_latex=is_latex)
            wrong = next(filter(None, (_problem(one, moving, system) for one in equations)), "")
        except (Unread, ZeroDivisionError, *TOO_LARGE):
            continue
        if wrong:
            found[it.id] = wrong
    return found


def _problem(equation: Equation, moving: frozenset[str], system: _System) -> str:
    """What contradicts in an equation; it is added to the system up to there."""
    checks: list[tuple[_Monomial, str]] = []

    def over(one: _Monomial, other: _Monomial, power: Fraction = -_ONE) -> _Monomial:
        powers = dict(one[0])
        for name, it in other[0].items():
            powers[name] = powers.get(name, Fraction(0)) + power * it
        return powers, units.times(one[1], other[1], power)

    def same(parts: Sequence[Node]) -> _Monomial | None:
        terms = [(it, found) for it in parts if (found := of(it)) is not None]
        for term, its in terms[1:]:
            said = f"{printed(term)} beside {printed(terms[0][0])}"
            checks.append((over(its, terms[0][1]), said))
        return terms[0][1] if terms else None

    def of(node: Node) -> _Monomial | None:
        """The monomial of a tree; None for 0, which has any dimension."""
        match node.kind:
            case "number":
                return None if node.value == "0" else ({}, units.NONE)
            case "symbol":
                return _of_name(node.value, moving)
            case "neg":
                return of(node.args[0])
            case "add":
                return same(node.args)
            case "mul" | "div":
                whole: _Monomial = {}, units.NONE
                for number, part in enumerate(node.args):
                    factor = of(part)
                    if factor is None:
                        return None
                    is_below = node.kind == "div" and number
                    whole = over(whole, factor, -_ONE if is_below else _ONE)
                return whole
            case "pow":
                base, power = of(node.args[0]), _rational(node.args[1])
                if base is None or power is not None:
                    return base and over(({}, units.NONE), base, power or Fraction(0))
        if node.value == "sqrt":
            base = of(node.args[0])
            return base and over(({}, units.NONE), base, Fraction(1, 2))
        if node.value in _FREE:
            return same(node.args)
        for part in node.args:
            inside = of(part)
            if inside is not None and node.value not in ("sign", "Heaviside", "Piecewise"):
                checks.append((inside, f"{printed(part)} inside {node.value or 'a power'}"))
        return {}, units.NONE

    same((equation.left, equation.right))
    for one, said in checks:
        if (left := system.add(one)) is not None:
            return f"{said}: they differ by {units.spelled(left)}"
    return ""


def _of_name(name: str, moving: frozenset[str]) -> _Monomial:
    """The monomial of a name: rates and derivatives are those of what is differentiated."""
    if name.startswith("diff("):
        of, _, by = name.removeprefix("diff(").removesuffix(")").rpartition(", ")
        above, below = _of_name(of or by, moving), _of_name(by, moving)
        powers = dict(above[0])
        for it, power in below[0].items() if of else ():
            powers[it] = powers.get(it, Fraction(0)) - power
        return powers, units.times(above[1], below[1], -1 if of else 0)
    if name == "pi":
        return {}, units.NONE
    order = {"v": 1, "a": 2}.get(name[:1], 0) if name[1:] in moving else 0
    return {name[1:] if order else name: _ONE}, units.times(units.NONE, units.read("s"), -order)


def _rational(node: Node) -> Fraction | None:
    """The value of an exponent that is a rational number."""
    parts = [_rational(it) for it in node.args]
    match node.kind, parts:
        case "number", _ if node.value != "pi":
            return Fraction(node.value)
        case "neg", [Fraction() as one]:
            return -one
        case "div", [Fraction() as one, Fraction() as other] if other:
            return one / other
    return None
