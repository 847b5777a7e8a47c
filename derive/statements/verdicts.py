"""Verdicts on printed statements: units, conventions, equality, limit, repair, proof, cost."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np
import sympy as sp
from sympy import Expr, Symbol

from .. import units
from ..pages import PageModel
from . import samples
from .approximations import in_limit, is_approximation, limit_of
from .book import equations_of
from .comparison import Comparison, Component, Conventions, equation_of, judged_side
from .conventions import settled
from .identities import normal_form
from .markup import repaired_print
from .objects import LAMBDA, TIME
from .papers import Paper, Statement
from .reading import Item, Verdict, opened
from .repair import CLOSE, COST, Edit, Pool, Repair, Search, Values, evaluated, same, stem
from .samples import numeric
from .tree import Node, Unread, Vocabulary, nodes, printed, read_sympy, symbols
from .tree import to_latex, to_sympy


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


def check(paper: Paper, model: PageModel, *, repair: bool = True) -> Checked:
    """Verdicts on every statement of a paper, for a page; without ``repair`` what differs fails."""
    return compared(paper, model, opened(paper, model)[1], repair=repair)


def compared(
    paper: Paper, model: PageModel, found: Sequence[Item | Verdict], *, repair: bool = True
) -> Checked:
    """Verdicts on the statements of a paper that were read."""
    items = [item for item in found if isinstance(item, Item)]
    conventions = settled(items)
    rows = [
        judged(item, conventions, repair=repair) if isinstance(item, Item) else uncompared(item)
        for item in found
    ]
    said = tuple(it.said(name) for name, it in conventions.items() if (it.sign, it.shift) != (1, 0))
    coordinates = tuple(map(str, model.mechanics.coordinates))
    return Checked(paper.title, model.name, said, tuple(_said_once(rows)), coordinates)


def repaired(paper: Paper, model: PageModel) -> Paper:
    """A paper whose expected misprints are repaired, against a page."""
    _, found = opened(paper, model)
    items = [item for item in found if isinstance(item, Item)]
    conventions, statements = settled(items), {it.id: it for it in paper.statements}
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
    """Row as begun from its statement."""
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


# --------------------------------------------------------------------------------------- verdicts


@dataclass(frozen=True)
class Right:
    """A proved repair of a side, what that side ought to be, and how many forms cost as little."""

    part: Component
    repair: Repair
    exact: Expr
    count: int

    @property
    def said(self) -> str:
        """The equation after its edits, in SymPy's syntax."""
        return equation_of(self.part.left, printed(self.repair.tree))


def judged(item: Item, conventions: Conventions | None = None, *, repair: bool = True) -> Row:
    """The verdict on one statement, in the conventions of its paper."""
    it = Comparison(item, conventions or {})
    statement, held, parts = item.statement, item.held, it.components()
    entries = [held.entries[place] for place in held.index]
    row = replace(
        _begun(statement),
        form=item.it.form,
        read="; ".join(part.said for part in parts),
        derived="; ".join(map(str, entries)),
        derived_latex=_joined(map(item.latex, entries)),
        derived_by=held.by,
    )
    if len(parts) < len(item.equations):
        said = f"left of = no name of this object stands alone: {', '.join(sorted(held.names))}"
        return replace(row, status="unread", evidence=said)
    limit = limit_of(item) if statement.limit else None
    if statement.limit and limit is None:
        said = (
            "'d*V -> oo', 'c_x, c_y -> 0', 'linear in x, y', 'quadratic in x' or 'cubic in x', of "
            "names of the page"
        )
        return replace(
            row, status="unread", evidence=f"limit = {statement.limit!r} is none; write as {said}"
        )
    wrong = "" if item.it.scaled else _units_problem(item, parts)
    limits: list[Comparison] = []
    found: list[Right] = []
    counted = ""
    for number, part in enumerate(parts):
        equal = [exact for target, exact in part.targets if it.holds(part.tree, target)]
        if equal:
            exact = next((one for one in equal if it.proved(part.tree, one)), None)
            if exact is None:
                return replace(row, evidence="equal at all samples, but not by exact algebra")
            row, counted = _as_meant(row, item, part, exact)
            continue
        own, value = it.exactly(part.tree), evaluated(part.tree, it.values)
        nearest = min(part.targets, key=lambda one: _distance(value, one[0]))
        gap = own - nearest[1]
        if limit is not None and not limits:
            limits = [Comparison(one, it.conventions) for one in in_limit(item, limit)]
        alike = [(one, one.components()[number]) for one in limits] or [(it, part)]
        is_limit = limit is not None and any(_is_right(*one) for one in alike)
        if limit is not None and (is_limit or is_approximation(it, part, limit)):
            said = "" if is_limit else "; what the print holds beyond that is not judged"
            row = replace(_with_difference(row, item, gap), evidence=statement.limit + said)
            continue
        rights = (_repaired(*one) for one in alike) if repair else ()
        best = next((one for one in rights if one is not None), None)
        if best is None:
            said = "no edit, and no two, give what is derived" if repair else ""
            row = _with_difference(row, item, gap)
            return replace(row, evidence="; ".join(one for one in (wrong, said) if one))
        row, counted = _as_meant(row, item, best.part, best.exact)
        row = _with_difference(row, item, own - it.exactly(best.repair.tree))
        found.append(best)
    if not found and row.evidence:
        return replace(row, status="approximation")
    if not found:
        status = "definition" if statement.word == "definition" else "confirmed"
        return replace(row, status=status, evidence=f"{held.by}, equal by exact algebra{counted}")
    edits = [edit for one in found for edit in one.repair.edits]
    where = f" in the limit {statement.limit}" if limit else ""
    evidence = f"what is repaired equals {held.by}{where} by exact algebra{counted}"
    return replace(
        row,
        status="misprint",
        repaired="; ".join(one.said for one in found),
        repaired_latex="; ".join(_repaired_latex(it, one) for one in found),
        edits=tuple(map(_recorded, edits)),
        marked=_marked(statement.judged, edits),
        alternatives=max(one.count for one in found),
        evidence=f"{wrong}; {evidence}" if wrong else evidence,
        cost="; ".join(dict.fromkeys(_cost(it, one) for one in found)),
    )


def _is_right(it: Comparison, part: Component) -> bool:
    """Whether a side is what it ought to be, by exact algebra."""
    return any(
        it.holds(part.tree, target) and it.proved(part.tree, exact)
        for target, exact in part.targets
    )


def _as_meant(row: Row, item: Item, part: Component, exact: Expr) -> tuple[Row, str]:
    """A row with the value that the print means, and what is counted in it."""
    if said := part.meanings[exact]:
        row = replace(row, derived=str(exact), derived_latex=item.latex(exact))
        return row, f"; {said}"
    return row, ""


def _with_difference(row: Row, item: Item, gap: Expr) -> Row:
    """A row with the difference between print and derivation."""
    # Operations in a difference that is shown.
    if sp.count_ops(gap) > 3000:
        return row
    shown = sp.factor_terms(normal_form(gap))
    return replace(row, difference=str(shown), difference_latex=item.latex(shown))


def _joined(texts: Iterable[str]) -> str:
    """LaTeX of one entry, or of several in brackets."""
    several = [*texts]
    inside = r",\; ".join(several)
    return inside if len(several) == 1 else rf"\left({inside}\right)"


def _marked(text: str, edits: Iterable[Edit]) -> str:
    """A print with what is edited in it between guillemets."""
    places = {place for edit in edits for place in (edit.at, *edit.also) if place[0] < place[1]}
    marks = [(end, "»") for _, end in places] + [(begin, "«") for begin, _ in places]
    marked = text
    for place, mark in sorted(marks, reverse=True):
        marked = f"{marked[:place]}{mark}{marked[place:]}"
    return marked if places else ""


def _repaired_latex(it: Comparison, found: Right) -> str:
    """The print with its edits, where it is read as the repair; else the repair in LaTeX."""
    item, tree, left = it.item, found.repair.tree, found.part.left
    text = repaired_print(item.statement, found.repair.edits, item.letters) or ""
    right = evaluated(tree, it.values)
    with suppress(Unread, ValueError):
        for equation in equations_of(text, item.statement, item.it, item.book):
            side, _ = judged_side(item, equation) or (equation.left, "")
            if symbols(side) <= it.values.keys() and same(evaluated(side, it.values), right):
                return text
    return equation_of(item.letters.get(left, left), to_latex(tree, item.letters))


def _recorded(edit: Edit) -> dict[str, object]:
    return {
        "kind": edit.kind,
        "at": list(edit.at),
        "old": printed(edit.old),
        "new": printed(edit.new),
    }


def _cost(it: Comparison, found: Right) -> str:
    """The size of the mistake at the base values: the median of the relative difference."""
    item = it.item
    base = samples.drawn(item.it, item.held, is_base=True)
    for name, value in item.bound.items():
        base[name] = numeric(value, base)
    at_base = Comparison(replace(item, values=base), it.conventions)
    share = _distance(evaluated(found.part.tree, at_base.values), numeric(found.exact, base))
    if not np.isfinite(share):
        return ""
    shown = share if share > CLOSE else 0.0  # what is 1 at the base values makes no difference
    return f"{shown:.2g} of both sides' size at the base values, the median of random states"


def _distance(own: Values, right: Values) -> float:
    """The median of the relative difference; not finite where no value is."""
    size = np.abs(own) + np.abs(right)
    known = np.isfinite(size)
    gap, size = np.abs(own[known] - right[known]), size[known]
    share = np.divide(gap, size, out=np.zeros_like(size), where=size > 0)
    return float(np.median(share)) if share.size else np.inf


def _repaired(it: Comparison, part: Component) -> Right | None:
    """The most likely repair that is proved."""
    targets: list[tuple[Values, Expr]] = []
    for target, exact in part.targets:
        if not any(same(target, known) for known, _ in targets):
            targets.append((target, exact))
    search = Search(part.tree, _pool(it, part))
    good: list[tuple[Repair, Expr]] = []
    for pairs in (False, True):
        # Single repairs that cost more are compared with pairs.
        if good and good[0][0].cost <= 2.0:
            break
        # Factors of a residual that are tried with two edits.
        tried = targets[:4] if pairs else targets
        found = search.repairs(np.array([target for target, _ in tried]), pairs)
        for repair, way in found:
            # Cost of a residual that is the derived one times a factor of
            # parameters.
            further = 0.005 if way > 1 else 0.0
            good.append((replace(repair, further=further), tried[way][1]))
        good = _proved_first(it, good)
    if good:
        return Right(part, *good[0], len(good))
    for _, exact in targets[:2]:  # without a factor, and of the other sign
        longer = _with_lost_term(it, part, exact)
        if longer is not None and it.proved(longer.tree, exact):
            return Right(part, longer, exact, 1)
    return None


def _pool(it: Comparison, part: Component) -> Pool:
    """Expressions that an edit of a side may bring in."""
    item = it.item
    free = {str(symbol) for entry in item.held.entries for symbol in entry.free_symbols}
    page = item.it
    hidden = {*map(str, (LAMBDA, TIME, *page.normals, *page.coefficients, *page.switches))} - free
    hidden |= {*item.held.names, part.left} if item.held.law != "scale" else set()
    own = [name for name, one in item.book.bound.items() if one == item.statement]
    hidden |= {name for name in item.bound if name.startswith(tuple(f"{it}_" for it in own))}
    targets = [target for target, _ in part.targets]
    hidden |= {name for name in item.bound if any(same(it.values[name], one) for one in targets)}
    printed_names = [symbols(side) for one in item.equations for side in (one.left, one.right)]
    stems = set(map(stem, set().union(*printed_names)))
    hidden |= {name for name in item.bound if stem(name) not in stems}
    hidden -= symbols(part.tree)
    values = {name: value for name, value in it.values.items() if name not in hidden}
    return Pool(values, item.it.kinds, item.it.turning)


def _proved_first(
    it: Comparison, found: Iterable[tuple[Repair, Expr]]
) -> list[tuple[Repair, Expr]]:
    """The repairs of least cost among those that are proved, each form once."""
    good: list[tuple[Repair, Expr]] = []
    forms: set[Expr] = set()
    for repair, exact in sorted(found, key=lambda one: (one[0].cost, len(printed(one[0].tree)))):
        # Repairs of one statement that are tried for a proof.
        if (good and repair.cost > good[0][0].cost + 0.01) or len(good) > 12:
            break
        form = to_sympy(repair.tree, {name: Symbol(name) for name in symbols(repair.tree)})
        if form not in forms and it.proved(repair.tree, exact):
            good.append((repair, exact))
            forms.add(form)
    return good


def _with_lost_term(it: Comparison, part: Component, exact: Expr) -> Repair | None:
    """A print with what it lacks, where that is one term, of brackets as well."""
    term = normal_form(exact - it.exactly(part.tree))
    # Symbols of a term with brackets that may be lost, and terms that it may have without
    # them.
    longest_term = 8
    if len(sp.Add.make_args(sp.numer(term))) > longest_term:
        return None
    vocabulary = Vocabulary(frozenset(it.item.values), (), {})
    try:
        tree = read_sympy(str(sp.factor(term)), vocabulary)[0].left
    except Unread:
        return None
    bare = tree.args[0] if tree.kind == "neg" else tree
    if bare.kind == "add" or sum(one.kind == "symbol" for one in nodes(tree)) > longest_term:
        return None
    args = part.tree.args if part.tree.kind == "add" else (part.tree,)
    new = Node("add", (*args, tree), at=part.tree.at)
    return Repair(new, (Edit("missing term", part.tree.at, part.tree, new, COST["missing term"]),))


# ------------------------------------------------------------------------------------------ units


def _units_problem(item: Item, parts: Iterable[Component]) -> str:
    """Problem of units in a print that has them."""
    names: dict[str, Expr] = {name: Symbol(name) for name in item.values}
    known = {symbol: item.it.kinds.get(name, units.NONE) for name, symbol in names.items()}
    for name, value in item.bound.items():
        names[name] = value.xreplace({it: Symbol(it.name) for it in value.free_symbols})
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
