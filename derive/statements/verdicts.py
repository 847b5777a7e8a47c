"""Verdicts on printed statements: units, conventions, equality, limit, repair, proof, cost."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import TypeAlias

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from .. import algebra, units
from ..algebra import Pair
from ..mechanics import MU, PUSHING
from ..pages import Model
from . import samples
from .markup import repaired_print
from .objects import BOTH, CONTACT, LAMBDA, LIFT_OFF, NORMAL, TIME, Derivation
from .papers import Paper, Statement
from .reading import Item, Verdict, equations_of, opened
from .repair import COST, Edit, Pool, Repair, Search, Values, evaluated, same, stem
from .samples import numeric
from .tree import Equation, Node, Unread, Vocabulary, nodes, printed, read_sympy, symbols
from .tree import to_latex, to_sympy

#: Repairs of one statement that are tried for a proof.
MOST_PROOFS = 12
#: Terms of either side of a residual, by whose ratios its factor is found.
MOST_TERMS = 40
#: Factors of a residual that are tried with two edits.
MOST_FACTORS = 4
#: Operations in a difference that is shown.
LARGEST_SHOWN = 3000
#: Cost of a residual that is the derived one times a factor of parameters.
OTHER_FACTOR = 0.005
#: Single repairs that cost more are compared with pairs.
CHEAPEST_PAIR = 2.0
#: Symbols of a term with brackets that may be lost, and terms that it may have without them.
LONGEST_TERM = 8
Names: TypeAlias = Mapping[str, sp.Expr]
_SMALL, _LINEAR = sp.Dummy("small", positive=True), "linear in "


@dataclass(frozen=True)
class Row:
    """The verdict on one statement; every empty field means not applicable."""

    id: str
    about: str
    status: str
    expect: str
    where: str = ""
    form: str = ""
    print: str = ""
    read: str = ""
    derived: str = ""
    derived_by: str = ""
    derived_latex: str = ""
    difference: str = ""
    difference_latex: str = ""
    repaired: str = ""
    repaired_latex: str = ""
    edits: tuple[Mapping[str, object], ...] = ()
    marked: str = ""
    alternatives: int = 0
    said_once_with: tuple[str, ...] = ()
    evidence: str = ""
    cost: str = ""
    note: str = ""

    @property
    def is_expected(self) -> bool:
        """A verdict that is the expected one; a right definition is confirmed as well."""
        return self.status in (self.expect, "other") or (self.status, self.expect) == (
            "definition",
            "confirmed",
        )


@dataclass(frozen=True)
class Checked:
    """All verdicts on a paper, and the conventions in which they hold."""

    paper: str
    model: str
    conventions: tuple[str, ...]
    rows: tuple[Row, ...]
    coordinates: tuple[str, ...] = ()


@dataclass(frozen=True)
class Convention:
    """Coordinates of the print as sign · coordinate of the page + shift."""

    sign: int = 1
    shift: sp.Expr = field(default_factory=lambda: sp.S.Zero)

    def said(self, name: str) -> str:
        """In words."""
        shift = "" if self.shift == 0 else f" + {self.shift}"
        return f"{name} of the print is {'-' if self.sign < 0 else ''}{name}{shift} of the page"


Conventions: TypeAlias = dict[str, Convention]


def check(paper: Paper, model: Model, *, repair: bool = True) -> Checked:
    """Verdicts on every statement of a paper, for a page; without ``repair`` what differs fails."""
    return compared(paper, model, opened(paper, model)[1], repair=repair)


def compared(
    paper: Paper, model: Model, found: Sequence[Item | Verdict], *, repair: bool = True
) -> Checked:
    """Verdicts on the statements of a paper that were read."""
    items = [item for item in found if isinstance(item, Item)]
    conventions = _settled(items)
    rows = [
        judged(item, conventions, repair=repair) if isinstance(item, Item) else uncompared(item)
        for item in found
    ]
    said = tuple(it.said(name) for name, it in conventions.items() if (it.sign, it.shift) != (1, 0))
    coordinates = tuple(map(str, model.mechanics.coordinates))
    return Checked(paper.title, model.name, said, tuple(_said_once(rows)), coordinates)


def repaired(paper: Paper, model: Model) -> Paper:
    """A paper whose expected misprints are repaired, against a page."""
    _, found = opened(paper, model)
    items = [item for item in found if isinstance(item, Item)]
    conventions, statements = _settled(items), {it.id: it for it in paper.statements}
    for item in items:
        if item.statement.expect == "misprint" and (row := judged(item, conventions)).repaired:
            statements[row.id] = replace(
                item.statement, text=row.repaired, is_latex=False, transcribed="", form=row.form
            )
    return replace(paper, statements=tuple(statements.values()))


def uncompared(verdict: Verdict) -> Row:
    """The row of a statement that is held against nothing."""
    return replace(
        _begun(verdict.statement),
        status=verdict.status,
        read=verdict.read,
        evidence=verdict.evidence,
    )


def _begun(statement: Statement) -> Row:
    """What a row has from its statement."""
    return Row(
        statement.id,
        statement.about,
        "failed",
        statement.expect,
        statement.where,
        statement.form,
        statement.text,
        note=statement.note,
    )


# ------------------------------------------------------------------------------------ comparison


def _converted(item: Item, conventions: Conventions) -> dict[str, sp.Expr]:
    """Names of the print that stand for something else than on the page, and for what."""
    found: dict[str, sp.Expr] = {}
    model = item.it.model
    for moving in zip(model.coordinates, model.rates, item.it.accelerations, strict=True):
        if (convention := conventions.get(str(moving[0]))) is not None:
            found |= {str(symbol): convention.sign * symbol for symbol in moving}
            found[str(moving[0])] += item.it.measured(convention.shift)
    return found


def _printed_values(item: Item, conventions: Conventions) -> dict[str, Values]:
    """Values of the print's names where the page's are the samples'."""
    known = list(item.values)
    changed = _converted(item, conventions).items()
    values = {**item.values, **{name: numeric(it, known)(item.values) for name, it in changed}}
    for name, tree in item.defined.items():
        values[name] = evaluated(tree, values)
    return values


def _signs(item: Item, conventions: Conventions, place: int) -> int:
    """The sign by which an entry changes with the coordinates."""
    names = [str(symbol) for symbol in item.it.model.coordinates]
    signs = [conventions.get(name, Convention()).sign for name in names]
    match item.held.law:
        case "covector" | "vector":
            return signs[place]
        case "form":
            return signs[place // len(signs)] * signs[place % len(signs)]
        case _:
            return 1


@dataclass(frozen=True)
class Component:
    """One printed side, and what it ought to be: values, and the same exactly."""

    tree: Node
    ways: tuple[tuple[Values, sp.Expr], ...]
    left: str = ""


def _components(
    item: Item, conventions: Conventions, values: Mapping[str, Values], factors: bool = True
) -> list[Component]:
    """Every printed equation with what its side ought to be, once for each possible factor."""
    found = []
    for equation, place in zip(item.equations, item.held.index, strict=True):
        sign = _signs(item, conventions, place)
        target, entry = sign * item.targets[place], sign * item.held.entries[place]
        if (side := judged_side(item, equation)) is None:
            continue
        tree, left = side
        if item.held.is_value:
            meant = [one.entry for one in item.held.readings] or [entry]
            ways = zip(item.readings or (target,), meant, strict=True)
            found.append(Component(tree, tuple(ways), left))
            continue
        tried = [sp.S.One, sp.S.NegativeOne]
        plain = any(same(evaluated(tree, values), way * target) for way in (1, -1))
        if factors and not plain and item.held.factor in ("parameters", "monomial"):
            tried += _factors(item, conventions, tree, item.held.entries[place])
        known = list(item.values)
        ways_of = ((numeric(it, known)(item.values) * target, it * entry) for it in tried)
        found.append(Component(tree, tuple(ways_of)))
    return found


def judged_side(item: Item, equation: Equation) -> tuple[Node, str] | None:
    """What of an equation is held against the object, and the name that it gives to it."""
    left, right = equation.left, equation.right
    is_zero = printed(right) == "0"
    if not item.held.is_value and not is_zero:
        return Node("add", (left, Node("neg", (right,), at=right.at))), ""
    if item.held.is_value and (printed(left) in item.held.names or _is_new(item, left)):
        return right, printed(left)
    return (left, "") if is_zero else None  # 2 T = … is no value of T; an expression alone is


def _is_new(item: Item, left: Node) -> bool:
    """Whether a name on the left is none of the page, or, of a scale, what is scaled."""
    known = item.held.law != "scale" and left.value in item.it.names
    return left.kind == "symbol" and not known


def _states(it: Derivation) -> tuple[sp.Symbol, ...]:
    return (*it.model.coordinates, *it.model.rates, *it.accelerations, LAMBDA, NORMAL, MU)


def _factors(item: Item, conventions: Conventions, tree: Node, entry: sp.Expr) -> list[sp.Expr]:
    """Factors of parameters by which terms of the print are terms of the derivation, by votes."""

    def apart(expression: sp.Expr) -> list[Pair]:
        """Factors of parameters, and what else stands in each term."""
        terms = sp.Add.make_args(sp.expand(expression))[:MOST_TERMS]
        return [it.as_independent(*_states(item.it), as_Add=False) for it in terms]

    ours = apart(item.it.expanded(entry))
    votes: dict[sp.Expr, int] = {}
    for factor, state in apart(to_sympy(tree, _names(item, conventions))):
        for own, same_state in ours:
            if state == same_state and own != 0:
                votes[factor / own] = votes.get(factor / own, 0) + 1
    return sorted(votes, key=lambda it: (-votes[it], sp.count_ops(it), str(it)))[:4]


def _names(item: Item, conventions: Conventions) -> dict[str, sp.Expr]:
    """What the print's names are in the page's symbols; lengths and angles of lines stay names."""
    names = item.it.names | {name: sp.Symbol(name) for name in item.it.geometry}
    names |= _converted(item, conventions)
    names |= item.bound
    for name, tree in item.defined.items():
        names[name] = to_sympy(tree, names)
    return names


def proved(item: Item, conventions: Conventions, tree: Node, entry: sp.Expr) -> bool:
    """Whether a tree is the derived expression, by exact algebra."""
    names = _names(item, conventions)
    if _is_short(item, tree, names, entry):
        return True
    gap = to_sympy(tree, names) - entry
    if item.held.factor == "constant":
        states = (*item.it.model.coordinates, *item.it.model.rates)
        return all(_zero(sp.diff(item.it.expanded(gap), it)) for it in states)
    sides = (CONTACT, LIFT_OFF) if item.held.side == BOTH else (item.held.side,)
    return all(_vanishes(item, gap, side) for side in sides)


def _is_short(item: Item, tree: Node, names: Names, entry: sp.Expr) -> bool:
    """Whether a tree is the derived expression in shorthands, whatever they stand for."""
    held = item.held
    if held.short is None or entry not in (held.entries[0], -held.entries[0]):
        return False
    symbol_of = {value: symbol for symbol, value in held.short[1].items()}
    known = {name: symbol_of.get(value, value) for name, value in names.items()}
    entry = held.short[0] if entry == held.entries[0] else -held.short[0]
    return _zero(to_sympy(tree, known) - entry)


def _vanishes(item: Item, gap: sp.Expr, side: str) -> bool:
    """Whether a difference is 0 on a side of the contact: as it stands, or by the page's laws."""
    is_open = side == LIFT_OFF and item.it.model.contact.unilateral
    mu = item.it.friction_at_rest if item.held.steady else item.it.friction
    laws = {NORMAL: sp.S.Zero if is_open else item.it.normal, MU: mu}
    gap = gap.xreplace({PUSHING: sp.S.Zero if is_open else sp.S.One})
    named = dict.fromkeys((gap, gap.xreplace(laws)))
    if any(map(_zero, named)):
        return True
    sign = -1 if side == CONTACT else 1
    return any(_zero(_on_side(item, item.it.expanded(it), sign)) for it in named)


def _on_side(item: Item, value: sp.Expr, side: int) -> sp.Expr:
    """A value with the gap's size and sign, and relations to 0, as they are on a side."""
    if item.it.model.contact.gap is None or not item.it.model.contact.unilateral:
        return value
    gap = item.it.expanded(item.it.spelled(item.it.model.contact.gap))
    for node in value.atoms(sp.Abs, sp.sign, Relational):
        size = node.lhs - node.rhs if isinstance(node, Relational) else node.args[0]
        for way in (1, -1):
            if _zero(size - way * gap):
                known = side * gap if isinstance(node, sp.Abs) else sp.Integer(side * way)
                if isinstance(node, Relational):
                    known = node.func(known, 0)
                value = value.xreplace({node: known})
    return value


def _zero(expression: sp.Expr) -> bool:
    """Whether an expression is 0 on all unit circles."""
    plain, names, circles = _on_circles(expression)
    return not plain.has(sp.Piecewise) and algebra.equal(plain.xreplace(names), sp.S.Zero, circles)


def normal_form(expression: sp.Expr) -> sp.Expr:
    """An expression modulo sin² + cos² = 1 of every angle: 0 exactly where it is 0."""
    plain, names, circles = _on_circles(expression)
    if plain.has(sp.Piecewise):  # a choice that is not made is compared with nothing
        return plain
    gap = algebra.difference(plain.xreplace(names), sp.S.Zero, circles)
    return gap.xreplace({dummy: node for node, dummy in names.items()})


def _on_circles(plain: sp.Expr) -> tuple[sp.Expr, dict[sp.Expr, sp.Expr], algebra.Circles]:
    """An expression in cosines and sines of angles, and what stands for these."""
    if plain.has(sp.tan, sp.cot):
        plain = plain.replace(sp.cot, lambda angle: sp.cos(angle) / sp.sin(angle))
        plain = plain.replace(sp.tan, lambda angle: sp.sin(angle) / sp.cos(angle))
    plain = sp.expand_trig(plain)
    angles = sorted({node.args[0] for node in plain.atoms(sp.cos, sp.sin)}, key=sp.default_sort_key)
    circles = tuple((sp.Dummy("c", real=True), sp.Dummy("s", real=True)) for _ in angles)
    names: dict[sp.Expr, sp.Expr] = {}
    for angle, (cosine, sine) in zip(angles, circles, strict=True):
        names |= {sp.cos(angle): cosine, sp.sin(angle): sine}
    return plain, names, circles


def agrees(item: Item, conventions: Conventions) -> bool:
    """Whether a statement holds at all samples, in conventions."""
    values = _printed_values(item, conventions)
    parts = _components(item, conventions, values, factors=False)
    return bool(parts) and all(
        any(_holds(item, part.tree, target, values) for target, _ in part.ways)
        or (item.held.factor == "parameters" and _factored(part, values))
        for part in parts
    )


def _factored(part: Component, values: Mapping[str, Values]) -> bool:
    """Whether the ratio of both is the same in both states of every pair."""
    with np.errstate(all="ignore"):
        ratio = evaluated(part.tree, values) / part.ways[0][0]
    return same(ratio[::2], ratio[1::2])


def _holds(item: Item, tree: Node, target: Values, values: Mapping[str, Values]) -> bool:
    own = evaluated(tree, values)
    if item.held.factor == "constant":  # the same difference in both states of a pair
        gap, size = own - target, np.abs(own) + np.abs(target)
        return bool((np.abs(gap[::2] - gap[1::2]) <= 1e-9 * size[::2]).all())
    return same(own, target)


# ------------------------------------------------------------------------------------ conventions


def _settled(items: Sequence[Item]) -> Conventions:
    """The signs and origins of coordinates in which the fewest statements fail.

    One statement that would hold otherwise is no convention but a misprint: it takes two.
    """

    def failing(conventions: Conventions, most: int) -> int:
        """How many fail, or ``most``; those that failed last stand first, and end it early."""
        failed = []
        for item in order:
            if not agrees(item, conventions):
                failed.append(item)
                if len(failed) == most:
                    break
        order.sort(key=lambda item: not any(item is one for one in failed))
        return len(failed)

    order = [*items]
    best: Conventions = {}
    first = fewest = failing(best, len(order) + 1)
    if fewest < 2:
        return best
    it = items[0].it
    choices = {str(entry.symbol): _choices(it, entry.unit) for entry in it.page.coordinates}
    for count in (1, 2):
        for names in itertools.combinations(choices, count):
            if count == 2 and len(choices) > 2:
                continue
            for ways in itertools.product(*(choices[name] for name in names)):
                tried = best | dict(zip(names, ways, strict=True))
                if (failed := failing(tried, fewest)) < fewest:
                    best, fewest = tried, failed
                if not fewest:
                    break
    return best if fewest <= first - 2 else {}


def _choices(it: Derivation, unit: str) -> list[Convention]:
    shifts: list[sp.Expr] = [sp.S.Zero]
    if unit == "rad":
        shifts += [sp.pi, sp.pi / 2, -sp.pi / 2]
    else:
        same_unit = [datum for datum in (*it.page.units, *it.page.parameters) if datum.unit == unit]
        shifts += [way * datum.symbol for datum in same_unit for way in (1, -1)]
    return [Convention(sign, shift) for shift in shifts for sign in (1, -1)]


# --------------------------------------------------------------------------------------- verdicts


def judged(item: Item, conventions: Conventions | None = None, *, repair: bool = True) -> Row:
    """The verdict on one statement, in the conventions of its paper."""
    conventions = conventions or {}
    statement, held = item.statement, item.held
    values = _printed_values(item, conventions)
    parts = _components(item, conventions, values)
    entries = [held.entries[place] for place in held.index]
    row = replace(
        _begun(statement),
        form=item.it.form,
        read="; ".join(_said(part.left, part.tree) for part in parts),
        derived="; ".join(map(str, entries)),
        derived_latex=_joined(map(item.latex, entries)),
        derived_by=held.by,
    )
    if len(parts) < len(item.equations):
        said = f"left of = no name of this object stands alone: {', '.join(sorted(held.names))}"
        return replace(row, status="unread", evidence=said)
    wrong = "" if item.it.scaled else _units_problem(item, parts)
    edited: list[tuple[Component, Repair, int]] = []
    costly: list[tuple[Component, sp.Expr]] = []
    counted = ""
    for part in parts:
        hits = [exact for target, exact in part.ways if _holds(item, part.tree, target, values)]
        if hits:
            right = (it for it in hits if proved(item, conventions, part.tree, it))
            if (exact := next(right, None)) is None:
                return replace(row, evidence="equal at all samples, but not by exact algebra")
            row, counted = _as_meant(row, item, exact)
            continue
        names = _names(item, conventions)
        own = to_sympy(part.tree, names)
        if statement.limit and _in_limit(item, conventions, part, statement.limit):
            row = _told(row, item, own - part.ways[0][1])
            return replace(row, status="approximation", evidence=statement.limit)
        found = _repaired(item, conventions, part, values) if repair else None
        if found is None:
            said = "no edit, and no two, give what is derived" if repair else ""
            row = _told(row, item, own - part.ways[0][1])
            return replace(row, evidence="; ".join(it for it in (wrong, said) if it))
        best, exact, count = found
        row, counted = _as_meant(row, item, exact)
        row = _told(row, item, own - to_sympy(best.tree, names))
        edited.append((part, best, count))
        costly.append((part, exact))
    if not edited:
        status = "definition" if statement.word == "definition" else "confirmed"
        return replace(row, status=status, evidence=f"{held.by}, equal by exact algebra{counted}")
    trees = [_said(part.left, best.tree) for part, best, _ in edited]
    texts = [_repaired_latex(item, part.left, best, values) for part, best, _ in edited]
    evidence = f"what is repaired equals {held.by} by exact algebra{counted}"
    return replace(
        row,
        status="misprint",
        repaired="; ".join(trees),
        repaired_latex="; ".join(texts),
        edits=tuple(_recorded(edit) for _, best, _ in edited for edit in best.edits),
        marked=_marked(statement.judged, [it for _, best, _ in edited for it in best.edits]),
        alternatives=max(count for *_, count in edited),
        evidence=f"{wrong}; {evidence}" if wrong else evidence,
        cost="; ".join(
            dict.fromkeys(_cost(item, conventions, part, exact) for part, exact in costly)
        ),
    )


def _as_meant(row: Row, item: Item, exact: sp.Expr) -> tuple[Row, str]:
    """A row with the value that the print means, and what is counted in it."""
    for one in item.held.readings:
        if one.entry == exact:
            row = replace(row, derived=str(exact), derived_latex=item.latex(exact))
            return row, f"; {one.said}"
    return row, ""


def _told(row: Row, item: Item, gap: sp.Expr) -> Row:
    """A row with the difference between print and derivation."""
    if sp.count_ops(gap) > LARGEST_SHOWN:
        return row
    shown = sp.factor_terms(normal_form(gap))
    return replace(row, difference=str(shown), difference_latex=item.latex(shown))


def _joined(texts: Iterable[str]) -> str:
    """LaTeX of one entry, or of several in brackets."""
    several = [*texts]
    inside = r",\; ".join(several)
    return inside if len(several) == 1 else rf"\left({inside}\right)"


def _said(left: str, tree: Node) -> str:
    return f"{left} = {printed(tree)}" if left else f"{printed(tree)} = 0"


def _marked(text: str, edits: Iterable[Edit]) -> str:
    """A print with what is edited in it between guillemets."""
    places = {place for edit in edits for place in (edit.at, *edit.also) if place[0] < place[1]}
    marks = [(end, "»") for _, end in places] + [(begin, "«") for begin, _ in places]
    marked = text
    for place, mark in sorted(marks, reverse=True):
        marked = f"{marked[:place]}{mark}{marked[place:]}"
    return marked if places else ""


def _repaired_latex(item: Item, left: str, repair: Repair, values: Mapping[str, Values]) -> str:
    """The print with its edits, where it is read as the repair; else the repair in LaTeX."""
    text = repaired_print(item.statement, repair.edits, item.letters) or ""
    right = evaluated(repair.tree, values)
    with suppress(Unread, ValueError):
        for equation in equations_of(text, item.statement, item.it, item.book):
            tree, _ = judged_side(item, equation) or (equation.left, "")
            if symbols(tree) <= values.keys() and same(evaluated(tree, values), right):
                return text
    shown = to_latex(repair.tree, item.letters)
    return f"{item.letters.get(left, left)} = {shown}" if left else f"{shown} = 0"


def _recorded(edit: Edit) -> dict[str, object]:
    return {
        "kind": edit.kind,
        "at": list(edit.at),
        "old": printed(edit.old),
        "new": printed(edit.new),
    }


def _cost(item: Item, conventions: Conventions, part: Component, exact: sp.Expr) -> str:
    """The size of the mistake at the base values: the median of the relative difference."""
    base = samples.drawn(item.it, item.held, is_base=True)
    for name, value in item.bound.items():
        base[name] = numeric(value, list(base))(base)
    own = evaluated(part.tree, _printed_values(replace(item, values=base), conventions))
    right = numeric(exact, list(base))(base)
    size = np.abs(own) + np.abs(right)
    known = size[np.isfinite(size)]
    if not known.size:
        return ""
    share = np.divide(np.abs(own - right), size, out=np.zeros_like(size), where=size > 0)
    middle = float(np.median(share[np.isfinite(size)]))
    return f"{middle:.2g} of both sides' size at the base values, the median of random states"


def _repaired(
    item: Item, conventions: Conventions, part: Component, values: Mapping[str, Values]
) -> tuple[Repair, sp.Expr, int] | None:
    """The most likely repair that is proved, what it is, and how many forms cost as little."""
    used = symbols(part.tree)
    known = {"lam", "N", "mu", str(PUSHING), str(TIME)} - _free(item)
    known |= {*item.held.names, part.left} if item.held.law != "scale" else set()
    stems = {
        stem(name) for one in item.equations for name in symbols(one.left) | symbols(one.right)
    }
    known |= {name for name in item.bound if stem(name) not in stems}
    pool = Pool(
        {n: it for n, it in values.items() if n in used or n not in known},
        item.it.kinds,
        item.it.turning,
    )
    ways: list[tuple[Values, sp.Expr]] = []
    for target, exact in part.ways:
        if not any(same(target, it) for it, _ in ways):
            ways.append((target, exact))
    search = Search(part.tree, pool)
    good: list[tuple[Repair, sp.Expr]] = []
    for pairs in (False, True):
        if good and good[0][0].cost <= CHEAPEST_PAIR:
            break
        tried = ways[:MOST_FACTORS] if pairs else ways
        found = search.repairs(np.array([target for target, _ in tried]), pairs)
        for repair, way in found:
            further = OTHER_FACTOR if way > 1 else 0.0
            good.append((replace(repair, further=further), tried[way][1]))
        good = _proved_first(item, conventions, good)
    if good:
        return *good[0], len(good)
    for _, exact in ways[:2]:  # without a factor, and of the other sign
        longer = _with_lost_term(item, conventions, part, exact)
        if longer is not None and proved(item, conventions, longer.tree, exact):
            return longer, exact, 1
    return None


def _proved_first(
    item: Item, conventions: Conventions, found: Iterable[tuple[Repair, sp.Expr]]
) -> list[tuple[Repair, sp.Expr]]:
    """The repairs of least cost among those that are proved, each form once."""
    good: list[tuple[Repair, sp.Expr]] = []
    forms: set[sp.Expr] = set()
    for repair, exact in sorted(found, key=lambda it: (it[0].cost, len(printed(it[0].tree)))):
        if (good and repair.cost > good[0][0].cost + 0.01) or len(good) > MOST_PROOFS:
            break
        form = to_sympy(repair.tree, {name: sp.Symbol(name) for name in symbols(repair.tree)})
        if form not in forms and proved(item, conventions, repair.tree, exact):
            good.append((repair, exact))
            forms.add(form)
    return good


def _with_lost_term(
    item: Item, conventions: Conventions, part: Component, exact: sp.Expr
) -> Repair | None:
    """A print with what it lacks, where that is one term, of brackets as well."""
    term = normal_form(exact - to_sympy(part.tree, _names(item, conventions)))
    if len(sp.Add.make_args(sp.numer(term))) > LONGEST_TERM:
        return None
    term = sp.factor(term)
    vocabulary = Vocabulary(frozenset(item.values), (), {})
    try:
        tree = read_sympy(str(term), vocabulary)[0].left
    except Unread:
        return None
    bare = tree.args[0] if tree.kind == "neg" else tree
    if bare.kind == "add" or sum(it.kind == "symbol" for it in nodes(tree)) > LONGEST_TERM:
        return None
    args = part.tree.args if part.tree.kind == "add" else (part.tree,)
    new = Node("add", (*args, tree), at=part.tree.at)
    return Repair(new, (Edit("missing term", part.tree.at, part.tree, new, COST["missing term"]),))


def _free(item: Item) -> set[str]:
    """Names that the derived side of a statement is written in besides coordinates."""
    return {str(it) for entry in item.held.entries for it in entry.free_symbols}


def _in_limit(item: Item, conventions: Conventions, part: Component, limit: str) -> bool:
    """Whether the difference goes to 0 in a limit: as ``d*V -> oo``, each factor by itself, or
    ``linear in x, y``, faster than these, which are small together.
    """
    what, arrow, end = limit.removeprefix(_LINEAR).partition("->")
    is_linear = what != limit and not arrow
    names = _names(item, conventions)
    laws = {NORMAL: item.it.normal, MU: item.it.friction}
    value = to_sympy(part.tree, names).subs(laws)
    factors = [names.get(name.strip(), sp.nan) for name in what.split("," if is_linear else "*")]
    if not all(it.is_Symbol for it in factors) or (
        not is_linear and end.strip() not in ("oo", "0")
    ):
        return False
    for _, exact in part.ways:
        gap = value - exact.subs(laws)
        whole = item.it.expanded(gap)
        if is_linear:
            small = whole.subs({it: _SMALL * it for it in factors}, simultaneous=True)
            if all(_zero(it.subs(_SMALL, 0)) for it in (small, sp.diff(small, _SMALL))):
                return True
            continue
        for form in map(normal_form, (gap, whole)):
            if all(_has_limit_zero(form, str(it), end.strip()) for it in factors):
                return True
    return False


def _has_limit_zero(gap: sp.Expr, name: str, end: str) -> bool:
    """Whether a difference goes to 0 with a quantity, the others of which are positive."""
    positive = {it: sp.Symbol(it.name, positive=True) for it in gap.free_symbols}
    at, point = sp.Symbol(name, positive=True), sp.sympify(end)
    collected: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(gap.xreplace(positive))):
        coefficient, rest = term.as_independent(at, as_Add=False)
        collected[rest] = collected.get(rest, sp.S.Zero) + coefficient
    kept = {rest for rest, coefficient in collected.items() if sp.expand(coefficient) != 0}
    return all(sp.limit(rest, at, point) == 0 for rest in kept)


# ------------------------------------------------------------------------------------------ units


def _units_problem(item: Item, parts: Iterable[Component]) -> str:
    """What does not balance in a print with units."""
    names: dict[str, sp.Expr] = {name: sp.Symbol(name) for name in item.values}
    known = {symbol: item.it.kinds.get(name, units.NONE) for name, symbol in names.items()}
    for name, tree in item.defined.items():
        names[name] = to_sympy(tree, names, evaluate=False)
    for part in parts:
        try:
            found = units.of(to_sympy(part.tree, names, evaluate=False), known)
        except units.UnitsError as error:
            return f"units: {error}"
        expected = item.held.unit
        if expected is not None and found is not None and found != expected:
            return (
                f"units: {printed(part.tree)} is in {units.spelled(found)}, not in "
                f"{units.spelled(expected)}"
            )
    return ""


def _said_once(rows: Sequence[Row]) -> list[Row]:
    """Edits that several statements share are said once: it may be the page that is wrong."""
    found = []
    for row in rows:
        key = _edit_key(row)
        others = tuple(it.id for it in rows if key and it.id != row.id and _edit_key(it) == key)
        note = "the print, or the page" if others else ""
        joined = "; ".join(part for part in (row.note, note) if part)
        found.append(replace(row, said_once_with=others, note=joined))
    return found


def _edit_key(row: Row) -> tuple[object, ...]:
    def essence(edit: Mapping[str, object]) -> tuple[object, ...]:
        kind = edit["kind"]
        new = str(edit["new"])
        return kind, new.removeprefix(str(edit["old"])) if kind == "missing term" else new

    return tuple(essence(edit) for edit in row.edits)
