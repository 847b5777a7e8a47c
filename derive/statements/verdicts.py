"""Verdicts on printed statements: units, conventions, equality, limit, repair, proof, cost."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeAlias

import numpy as np
import sympy as sp

from .. import algebra, units
from ..mechanics import MU
from ..pages import Model
from ..units import Dimension
from . import samples
from .objects import LAMBDA, NORMAL, Derivation, NoObject, Object, derivation, derived
from .papers import Paper, Statement
from .repair import Edit, Pool, Repair, Values, evaluated, repairs, same
from .samples import numeric
from .tree import Equation, Node, Unread, Vocabulary, printed, read_sympy, symbols
from .tree import to_latex, to_sympy

#: Repairs of one statement that are tried for a proof.
MOST_PROOFS = 12
#: Terms of either side of a residual, by whose ratios its factor is found.
MOST_TERMS = 40
#: Factors of a residual that are tried with two edits.
MOST_FACTORS = 2
Names: TypeAlias = Mapping[str, sp.Expr]


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
    difference: str = ""
    repaired: str = ""
    repaired_latex: str = ""
    edits: tuple[Mapping[str, object], ...] = ()
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


@dataclass(frozen=True)
class Item:
    """A statement that was read, with what it is held against, at samples."""

    statement: Statement
    it: Derivation
    held: Object
    equations: tuple[Equation, ...]
    values: Mapping[str, Values]
    targets: tuple[Values, ...]
    readings: tuple[Values, ...]
    defined: Mapping[str, Node]


def check(paper: Paper, model: Model) -> Checked:
    """Verdicts on every statement of a paper, for a page."""
    forms = forms_of(model)
    defined: dict[str, Node] = {}
    found = [prepared(statement, forms, paper.renamed, defined) for statement in paper.statements]
    items = [item for item in found if isinstance(item, Item)]
    conventions = _settled(items)
    rows = [_row(item, conventions) if isinstance(item, Item) else item for item in found]
    said = tuple(it.said(name) for name, it in conventions.items() if (it.sign, it.shift) != (1, 0))
    return Checked(paper.title, model.name, said, tuple(_said_once(rows)))


_FORMS: dict[tuple[str, str], dict[str, Derivation]] = {}


def forms_of(model: Model) -> dict[str, Derivation]:
    """A page in both forms, kept for the next paper."""
    key = model.name, model.digest
    if key not in _FORMS:
        both = ("units", "scaled")
        _FORMS[key] = {form: derivation(model.page, model.mechanics, form) for form in both}
    return _FORMS[key]


# ---------------------------------------------------------------------------------------- reading


def prepared(
    statement: Statement,
    forms: Mapping[str, Derivation],
    renamed: Mapping[str, str],
    defined: dict[str, Node],
) -> Item | Row:
    row = Row(statement.id, statement.about, "", statement.expect, statement.where, statement.form)
    row = replace(row, print=statement.text, note=statement.note)
    if statement.about == "other":
        return replace(row, status="other")
    word = statement.about.split(" ")[0]
    unread = replace(row, status="unread")
    for form in (statement.form,) if statement.form else ("units", "scaled"):
        it = forms["units" if word == "scale" else form]
        try:
            held = None if word == "definition" else derived(it, statement.about)
            equations = _read(statement, it, held, renamed, defined)
        except Unread as error:
            place = f"at {error.place}, {statement.text[error.place :][:20]!r}: "
            readings = f"; either {' or '.join(error.readings)}" if error.readings else ""
            unread = replace(unread, evidence=unread.evidence or f"{place}{error.reason}{readings}")
            continue
        except (NoObject, ArithmeticError) as error:
            return replace(row, status="unread", evidence=str(error))
        return _item(statement, it, held, equations, defined, replace(row, form=form))
    return unread


def _read(
    statement: Statement,
    it: Derivation,
    held: Object | None,
    renamed: Mapping[str, str],
    defined: Mapping[str, Node],
) -> tuple[Equation, ...]:
    own = held.names if held is not None else frozenset()
    text = statement.text
    if held is None or statement.about.startswith("scale"):
        own |= {text.split("=")[0].strip()}
    vocabulary = Vocabulary(
        frozenset(it.names) | defined.keys() | own,
        tuple(map(str, it.model.coordinates)),
        renamed,
    )
    if statement.is_latex:
        from .latex import read_latex

        return tuple(read_latex(text, vocabulary))
    return tuple(read_sympy(text, vocabulary))


def _item(
    statement: Statement,
    it: Derivation,
    held: Object | None,
    equations: tuple[Equation, ...],
    defined: dict[str, Node],
    row: Row,
) -> Item | Row:
    if held is None:
        left = equations[0].left
        if left.kind != "symbol":
            reason = "a definition has one name on its left side"
            return replace(row, status="unread", evidence=reason)
        known = {**it.geometry, "N": it.normal, "mu": it.friction}
        if left.value not in known:
            defined[left.value] = equations[0].right
            read = f"{left.value} = {printed(equations[0].right)}"
            return replace(row, status="definition", read=read)
        by = "objects.Derivation.geometry"
        held = Object((known[left.value],), by, names=frozenset({left.value}))
    values = samples.drawn(it, held)
    names = list(values)
    targets = tuple(numeric(entry, names)(values) for entry in held.entries)
    readings = tuple(numeric(one.entry, names)(values) for one in held.readings)
    return Item(statement, it, held, equations, values, targets, readings, dict(defined))


# ------------------------------------------------------------------------------------ comparison


def _printed_values(item: Item, conventions: Conventions) -> dict[str, Values]:
    """Values of the print's names where the page's are the samples'."""
    values = dict(item.values)
    for symbol, rate, second in zip(
        item.it.model.coordinates, item.it.model.rates, item.it.accelerations, strict=True
    ):
        convention = conventions.get(str(symbol))
        if convention is not None:
            shift = numeric(item.it.measured(convention.shift), list(values))(values)
            values[str(symbol)] = convention.sign * item.values[str(symbol)] + shift
            for name in (str(rate), str(second)):
                values[name] = convention.sign * item.values[name]
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
    """One printed side, the values it ought to have, and the same exactly."""

    tree: Node
    targets: tuple[Values, ...]
    exact: tuple[sp.Expr, ...]
    left: str


def _components(
    item: Item, conventions: Conventions, values: Mapping[str, Values], factors: bool = True
) -> list[Component]:
    """Every printed equation with what its side ought to be, once for each possible factor."""
    found = []
    equations = item.equations
    places = item.held.index
    if len(equations) > len(places):
        equations = equations[-len(places) :]
    for equation, place in zip(equations, places, strict=False):
        sign = _signs(item, conventions, place)
        target, entry = sign * item.targets[place], sign * item.held.entries[place]
        if item.held.is_value:
            tree, left = equation.right, printed(equation.left)
            if printed(equation.right) == "0":  # an expression alone is the value
                tree, left = equation.left, ""
            elif left not in item.held.names and not (
                item.held.law == "scale" and equation.left.kind == "symbol"
            ):
                continue  # 2 T = … is no value of T
            meant = tuple(one.entry for one in item.held.readings)
            found.append(Component(tree, item.readings or (target,), meant or (entry,), left))
            continue
        tree = equation.left
        if printed(equation.right) != "0":
            tree = Node("add", (equation.left, Node("neg", (equation.right,))))
        tried = [sp.S.One, sp.S.NegativeOne]
        plain = any(same(evaluated(tree, values), way * target) for way in (1, -1))
        if factors and not plain and item.held.factor in ("parameters", "monomial"):
            tried = _factors(item, conventions, tree, item.held.entries[place]) + tried
        known = list(item.values)
        found.append(
            Component(
                tree,
                tuple(numeric(factor, known)(item.values) * target for factor in tried),
                tuple(factor * entry for factor in tried),
                "",
            )
        )
    return found


def _states(it: Derivation) -> tuple[sp.Symbol, ...]:
    return (*it.model.coordinates, *it.model.rates, *it.accelerations, LAMBDA, NORMAL, MU)


def _factors(item: Item, conventions: Conventions, tree: Node, entry: sp.Expr) -> list[sp.Expr]:
    """Factors of parameters by which terms of the print are terms of the derivation, by votes."""
    whole = sp.expand(to_sympy(tree, _names(item, conventions)))
    ours = sp.Add.make_args(sp.expand(entry))[:MOST_TERMS]
    votes: dict[sp.Expr, int] = {}
    for term, own in itertools.product(sp.Add.make_args(whole)[:MOST_TERMS], ours):
        ratio = term / own
        if not ratio.has(*_states(item.it)) and ratio.is_finite is not False:
            votes[ratio] = votes.get(ratio, 0) + 1
    return sorted(votes, key=lambda it: (-votes[it], sp.count_ops(it), str(it)))[:4]


def _names(item: Item, conventions: Conventions) -> dict[str, sp.Expr]:
    """What the print's names are in the page's symbols."""
    names = dict(item.it.names)
    for symbol, rate, second in zip(
        item.it.model.coordinates, item.it.model.rates, item.it.accelerations, strict=True
    ):
        convention = conventions.get(str(symbol))
        if convention is not None:
            names[str(symbol)] = convention.sign * symbol + item.it.measured(convention.shift)
            names |= {str(it): convention.sign * it for it in (rate, second)}
    for name, tree in item.defined.items():
        names[name] = to_sympy(tree, names)
    return names


def proved(item: Item, conventions: Conventions, tree: Node, entry: sp.Expr) -> bool:
    """Whether a tree is the derived expression, by exact algebra."""
    value = _on_side(item, to_sympy(tree, _names(item, conventions)))
    laws = {NORMAL: item.it.normal, MU: item.it.friction}
    if item.held.steady:
        laws[MU] = item.it.friction_at_rest
    if item.held.factor == "constant":
        states = (*item.it.model.coordinates, *item.it.model.rates)
        return all(_zero(sp.diff(value - entry, it)) for it in states)
    return _zero(value - entry) or _zero((value - entry).subs(laws))


def _on_side(item: Item, value: sp.Expr) -> sp.Expr:
    """A value with the gap's size and sign as they are in contact, or in lift-off."""
    if item.it.model.gap is None or not item.it.model.unilateral:
        return value
    gap, side = item.it.spelled(item.it.model.gap), 1 if item.held.apart else -1
    for node in value.atoms(sp.Abs, sp.sign):
        for way in (1, -1):
            if _zero(node.args[0] - way * gap):
                known = side * gap if isinstance(node, sp.Abs) else sp.Integer(side * way)
                value = value.xreplace({node: known})
    return value


def _zero(expression: sp.Expr) -> bool:
    """Whether an expression is 0 on all unit circles."""
    return bool(normal_form(expression) == 0)


def normal_form(expression: sp.Expr) -> sp.Expr:
    """An expression modulo sin² + cos² = 1 of every angle: 0 exactly where it is 0."""
    plain = expression
    plain = plain.replace(sp.cot, lambda angle: sp.cos(angle) / sp.sin(angle))
    plain = sp.expand_trig(plain.replace(sp.tan, lambda angle: sp.sin(angle) / sp.cos(angle)))
    angles = sorted({node.args[0] for node in plain.atoms(sp.cos, sp.sin)}, key=sp.default_sort_key)
    circles = tuple((sp.Dummy("c", real=True), sp.Dummy("s", real=True)) for _ in angles)
    names: dict[sp.Expr, sp.Expr] = {}
    for angle, (cosine, sine) in zip(angles, circles, strict=True):
        names |= {sp.cos(angle): cosine, sp.sin(angle): sine}
    gap = algebra.difference(plain.xreplace(names), sp.S.Zero, circles)
    return gap.xreplace({dummy: node for node, dummy in names.items()})


def _agrees(item: Item, conventions: Conventions) -> bool:
    """Whether a statement holds at all samples, in conventions."""
    values = _printed_values(item, conventions)
    parts = _components(item, conventions, values, factors=False)
    return bool(parts) and all(
        any(_holds(item, part.tree, target, values) for target in part.targets)
        or (item.held.factor == "parameters" and _factored(part, values))
        for part in parts
    )


def _factored(part: Component, values: Mapping[str, Values]) -> bool:
    """Whether the ratio of both is the same in both states of every pair."""
    with np.errstate(all="ignore"):
        ratio = evaluated(part.tree, values) / part.targets[0]
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

    def failing(conventions: Conventions) -> int:
        return sum(not _agrees(item, conventions) for item in items)

    best: Conventions = {}
    first = fewest = failing(best)
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
                if (failed := failing(tried)) < fewest:
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


def _row(item: Item, conventions: Conventions) -> Row:
    statement, held = item.statement, item.held
    values = _printed_values(item, conventions)
    parts = _components(item, conventions, values)
    entries = [held.entries[place] for place in held.index]
    row = Row(
        statement.id,
        statement.about,
        "failed",
        statement.expect,
        statement.where,
        "scaled" if item.it.scaled else "units",
        statement.text,
        "; ".join(_said(part.left, part.tree) for part in parts),
        "; ".join(map(str, entries)),
        held.by,
        note=statement.note,
    )
    wrong = "" if item.it.scaled else _units_problem(item, parts)
    repaired: list[tuple[Component, Repair, int]] = []
    counted = ""
    for part in parts:
        hits = [
            exact
            for target, exact in zip(part.targets, part.exact, strict=True)
            if _holds(item, part.tree, target, values)
        ]
        if hits:
            right = (it for it in hits if proved(item, conventions, part.tree, it))
            if (exact := next(right, None)) is None:
                return replace(row, evidence="equal at all samples, but not by exact algebra")
            row, counted = _as_meant(row, item, exact)
            continue
        gap = to_sympy(part.tree, _names(item, conventions)) - part.exact[0]
        row = replace(row, difference=str(normal_form(gap)))
        if statement.limit and _in_limit(item, conventions, part, statement.limit):
            return replace(row, status="approximation", evidence=statement.limit)
        found = _repaired(item, conventions, part, values)
        if found is None:
            said = "no edit, and no two, give what is derived"
            return replace(row, evidence=f"{wrong}; {said}" if wrong else said)
        repair, exact, count = found
        row, counted = _as_meant(row, item, exact)
        if counted:
            gap = to_sympy(part.tree, _names(item, conventions)) - exact
            row = replace(row, difference=str(normal_form(gap)))
        repaired.append((part, repair, count))
    if not parts:
        said = f"left of = no name of this object stands alone: {', '.join(sorted(held.names))}"
        return replace(row, status="unread", evidence=said)
    if not repaired:
        word = statement.about.split(" ")[0]
        status = "definition" if word == "definition" else "confirmed"
        return replace(row, status=status, evidence=f"{held.by}, equal by exact algebra{counted}")
    trees = [_said(part.left, repair.tree) for part, repair, _ in repaired]
    texts = [to_latex(repair.tree, item.it.letters) for _, repair, _ in repaired]
    evidence = f"what is repaired equals {held.by} by exact algebra{counted}"
    return replace(
        row,
        status="misprint",
        repaired="; ".join(trees),
        repaired_latex="; ".join(texts),
        edits=tuple(_recorded(edit) for _, repair, _ in repaired for edit in repair.edits),
        alternatives=max(count for *_, count in repaired),
        evidence=f"{wrong}; {evidence}" if wrong else evidence,
        cost="; ".join(_cost(item, part, values) for part, *_ in repaired),
    )


def _as_meant(row: Row, item: Item, exact: sp.Expr) -> tuple[Row, str]:
    """A row with the value that the print means, and what is counted in it."""
    for one in item.held.readings:
        if one.entry == exact:
            return replace(row, derived=str(exact)), f"; {one.said}"
    return row, ""


def _said(left: str, tree: Node) -> str:
    return f"{left} = {printed(tree)}" if left else f"{printed(tree)} = 0"


def _recorded(edit: Edit) -> dict[str, object]:
    return {
        "kind": edit.kind,
        "at": list(edit.at),
        "old": printed(edit.old),
        "new": printed(edit.new),
    }


def _cost(item: Item, part: Component, values: Mapping[str, Values]) -> str:
    """The size of the mistake at samples: the median of the relative difference."""
    own = evaluated(part.tree, values)
    size = np.median(np.abs(own - part.targets[0]) / (np.abs(own) + np.abs(part.targets[0])))
    return f"{float(size):.2g} of both sides' size in the median of random states"


def _repaired(
    item: Item, conventions: Conventions, part: Component, values: Mapping[str, Values]
) -> tuple[Repair, sp.Expr, int] | None:
    """The most likely repair that is proved, what it is, and how many cost as little."""
    used = symbols(part.tree)
    known = {"lam", "N", "mu"} - _free(item)
    known |= item.held.names if item.held.law != "scale" else set()
    pool = Pool(
        {n: it for n, it in values.items() if n in used or n not in known},
        item.it.kinds,
        item.it.turning,
    )
    ways: list[tuple[Values, sp.Expr]] = []
    for target, exact in zip(part.targets, part.exact, strict=True):
        if not any(same(target, it) for it, _ in ways):
            ways.append((target, exact))
    good: list[tuple[Repair, sp.Expr]] = []
    for pairs in (False, True):
        found = [
            (repair, exact)
            for target, exact in (ways[:MOST_FACTORS] if pairs else ways)
            for repair in repairs(part.tree, target, pool, pairs)
        ]
        for repair, exact in sorted(found, key=lambda it: (it[0].cost, len(printed(it[0].tree)))):
            if (good and repair.cost > good[0][0].cost + 0.01) or len(good) > MOST_PROOFS:
                break
            if proved(item, conventions, repair.tree, exact):
                good.append((repair, exact))
        if good:
            break
    return (*good[0], len(good)) if good else None


def _free(item: Item) -> set[str]:
    """Names that the derived side of a statement is written in besides coordinates."""
    return {str(it) for entry in item.held.entries for it in entry.free_symbols}


def _in_limit(item: Item, conventions: Conventions, part: Component, limit: str) -> bool:
    """Whether the difference goes to 0 in a limit, as ``d*V -> oo`` (each factor by itself)."""
    what, arrow, end = limit.partition("->")
    if not arrow or end.strip() not in ("oo", "0"):
        return False
    names = _names(item, conventions)
    laws = {NORMAL: item.it.normal, MU: item.it.friction}
    value = to_sympy(part.tree, names)
    for name in (it.strip() for it in what.split("*")):
        if name not in names or not isinstance(names[name], sp.Symbol):
            return False
        known = sorted((value - part.exact[0]).free_symbols, key=str)
        positive = {it: sp.Symbol(it.name, positive=True) for it in known}
        gaps = [sp.expand((value - exact).subs(laws).xreplace(positive)) for exact in part.exact]
        at = sp.Symbol(str(names[name]), positive=True)
        if not any(sp.limit(gap, at, sp.sympify(end.strip())) == 0 for gap in gaps):
            return False
    return True


# ------------------------------------------------------------------------------------------ units


def _units_problem(item: Item, parts: Iterable[Component]) -> str:
    """What does not balance in a print with units."""
    known = dict(item.it.dimensions)
    for part in parts:
        try:
            dims = known | {
                n: _dimension(tree, known) or units.NONE for n, tree in item.defined.items()
            }
            found = _dimension(part.tree, dims)
        except units.UnitsError as error:
            return f"units: {error}"
        expected = item.held.unit
        if expected is not None and found is not None and found != expected:
            return (
                f"units: {printed(part.tree)} is in {units.spelled(found)}, not in "
                f"{units.spelled(expected)}"
            )
    return ""


def _dimension(tree: Node, known: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension of a tree, None for zero; a :class:`derive.units.UnitsError` if none."""
    names = {name: sp.Symbol(f"u_{name}") for name in symbols(tree)}
    dimensions = {names[name]: known.get(name, units.NONE) for name in names}
    match tree.kind:
        case "number":
            return None if tree.value == "0" else units.NONE
        case "add":
            whole: Dimension | None = None
            for part in tree.args:
                one = _dimension(part, known)
                if whole is not None and one is not None and one != whole:
                    raise units.UnitsError(
                        f"{printed(part)} is in {units.spelled(one)}, and is added to what is in "
                        f"{units.spelled(whole)}"
                    )
                whole = one if whole is None else whole
            return whole
        case "neg":
            return _dimension(tree.args[0], known)
        case _:
            return units.of(to_sympy(tree, names), dimensions)


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
