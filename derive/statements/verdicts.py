"""Verdicts on printed statements.

A statement is confirmed if exact algebra proves it equal to its object, an approximation if it is
so in the limit that it names, a misprint if the search for a repair finds edits that are proved
right, unread if it can't be read, and failed otherwise.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import cast

import numpy as np
import sympy as sp
from sympy import Expr, Symbol

from .. import units
from ..factors import factored
from ..pages import PageModel
from . import samples
from .approximations import LimitCase, cases, in_limit, is_approximation, limit_of
from .blame import Mended, mended
from .book import TOO_LARGE, by_name, equations_of, forms_of
from .comparison import Comparison, Component, Conventions, equation_of, judged_side
from .conventions import stated, unstated
from .identities import normal_form
from .markup import repaired_print
from .objects import LAMBDA, TIME
from .papers import Paper, Statement
from .reading import ASSERTED, BEGUN, Item, Verdict, in_motion, read_paper, too_large, unit_of
from .repair import CLOSE, COST, Edit, Pool, Repair, Search, Values, evaluated, same, stem
from .samples import numeric
from .tree import Node, Unread, Vocabulary, nodes, printed, read_sympy, symbols, tidied
from .tree import to_latex, to_sympy
from .ways import other_ways

#: Verdicts on what is right, as far as it is judged.
RIGHT = ("confirmed", "definition", "approximation")


@dataclass(frozen=True)
class Row:
    """The verdict on one statement; a field that does not apply is empty."""

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
    edit_cost: float = 0.0  #: how unlikely these edits are, 1 for a sign
    marked: str = ""
    alternatives: int = 0
    said_once_with: tuple[str, ...] = ()
    evidence: str = ""
    cost: str = ""
    note: str = ""
    units: str = ""  #: what contradicts in its units, beside its verdict

    @property
    def is_expected(self) -> bool:
        """Whether the verdict is the expected one; a definition counts as confirmed."""
        if self.status in ("definition", "premise") and self.expect == "confirmed":
            return True
        return self.status in (self.expect, "other")


@dataclass(frozen=True)
class Checked:
    """All verdicts on a paper, and the conventions of coordinates that its file states."""

    paper: str
    model: str
    conventions: tuple[str, ...]
    rows: tuple[Row, ...]
    coordinates: tuple[str, ...] = ()


def check(paper: Paper, model: PageModel, *, repair: bool = True) -> Checked:
    """Check every statement of a paper against a page.

    Without ``repair`` no misprint and no convention is sought: a statement that differs has failed.
    """
    return verdicts_on(paper, model, read_paper(paper, model)[1], repair=repair)


def verdicts_on(
    paper: Paper, model: PageModel, found: Sequence[Item | Verdict], *, repair: bool = True
) -> Checked:
    """Check the statements of a paper that :func:`read_paper` has read."""
    conventions = stated(paper.conventions, forms_of(model)["units"])
    items = {it.statement.id: it for it in found if isinstance(it, Item)}
    rows = {
        it.statement.id: verdict_on(it, conventions, repair=False)
        if isinstance(it, Item)
        else row_without_comparison(it)
        for it in found
    }
    wrong = {id: it for id, it in items.items() if rows[id].status == "failed"}
    right = [it for id, it in items.items() if rows[id].status in RIGHT]
    wrong = wrong if repair else {}
    conventional, under = _under_conventions(wrong, right, conventions)
    for id, item in wrong.items():
        rows[id] = verdict_on(item, conventions)
    while wrong and (blamed := mended(wrong, right, conventions, _holds)):
        (one, *more) = blamed.rows
        is_dearer = rows[one].status == "failed" or rows[one].edit_cost > blamed.repair.cost + 0.05
        if len(blamed.rows) < max(len(under), 1) or not (more or is_dearer):
            break
        under = [id for id in under if id not in blamed.rows]
        wrong = {id: it for id, it in wrong.items() if id not in blamed.rows}
        right += blamed.rows.values()
        rows |= _blamed(blamed, rows, conventions)
    for id in under:
        said = f"right only where {_in_words(conventional)}, which [conventions] does not say"
        evidence = "; ".join(filter(None, (said, rows[id].evidence)))
        rows[id] = replace(rows[id], status="convention", evidence=evidence)
    coordinates = tuple(map(str, model.mechanics.coordinates))
    in_words = tuple(it.said(name) for name, it in conventions.items())
    for it in (one for one in paper.statements if one.word == "code"):
        rows[it.id] = replace(rows[it.id], about=it.about)
    return Checked(
        paper.title, model.name, in_words, tuple(_said_once([*rows.values()])), coordinates
    )


def _holds(item: Item, conventions: Conventions) -> bool:
    """Whether a statement is right as it stands, as far as it is judged."""
    return verdict_on(item, conventions, repair=False).status in RIGHT


def _blamed(found: Mended, rows: Mapping[str, Row], conventions: Conventions) -> dict[str, Row]:
    """The row of a definition that is a misprint, and those that are right with it mended."""
    book = next(iter(found.rows.values())).book
    definition, mending = rows[book.definers[found.name]], found.repair
    said, new = f"right with ({definition.id}) mended", dict[str, Row]()
    for id, item in found.rows.items():
        row = verdict_on(item, conventions, repair=False)
        noted, evidence = ("; ".join(filter(None, (it, said))) for it in (row.note, row.evidence))
        new[id] = replace(row, note=noted, evidence=evidence)
    new[definition.id] = replace(
        definition,
        status="misprint",
        repaired=equation_of(found.name, printed(tidied(mending.tree))),
        repaired_latex=equation_of(
            book.letters.get(found.name, found.name), to_latex(tidied(mending.tree), book.letters)
        ),
        edits=tuple(map(_edit_as_json, mending.edits)),
        edit_cost=mending.cost,
        marked=_marked(definition.print, mending.edits),
        alternatives=found.count,
        evidence=f"with it right, and wrong without it: {', '.join(found.rows)}",
    )
    return new


def _under_conventions(
    wrong: Mapping[str, Item], right: Sequence[Item], known: Conventions
) -> tuple[Conventions, list[str]]:
    """A convention that is not stated, in which rows hold that are wrong without it, and these."""

    if not wrong:
        return {}, []
    held_against = {
        id: [*in_limit(it, limit_of(it, known))] if it.statement.limit else [it]
        for id, it in wrong.items()
    }
    conventions, rows = unstated(held_against, right, known, _holds)
    added = {name: it for name, it in conventions.items() if known.get(name) != it}
    return added, [id for id in rows if _holds(wrong[id], conventions)]


def _in_words(conventions: Conventions) -> str:
    return " and ".join(it.said(name) for name, it in conventions.items())


def repaired(paper: Paper, model: PageModel) -> Paper:
    """The paper with those statements replaced by their repairs that it expects to be misprints."""
    _, found = read_paper(paper, model)
    conventions = stated(paper.conventions, forms_of(model)["units"])
    statements = {it.id: it for it in paper.statements}
    for item in (it for it in found if isinstance(it, Item)):
        if item.statement.expect == "misprint" and (row := verdict_on(item, conventions)).repaired:
            statements[row.id] = replace(
                item.statement, text=row.repaired, is_latex=False, transcribed="", form=row.form
            )
    return replace(paper, statements=tuple(statements.values()))


def row_without_comparison(verdict: Verdict) -> Row:
    """The row of a statement that was not compared."""
    return replace(
        _row_of(verdict.statement),
        status=verdict.status,
        read=verdict.read,
        repaired=verdict.repaired,
        evidence=verdict.evidence,
    )


def _row_of(statement: Statement) -> Row:
    """The row of a statement before its verdict."""
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


# ------------------------------------------------------------------------------------------------
# verdicts


@dataclass(frozen=True)
class ProvedRepair:
    """A repair of a side that exact algebra has proved."""

    part: Component
    repair: Repair
    exact: Expr  #: the derived expression that the repaired side equals
    count: int  #: how many repairs of the same cost are proved

    @property
    def said(self) -> str:
        """The repaired equation in SymPy's syntax."""
        return equation_of(self.part.left, printed(tidied(self.repair.tree)))


def verdict_on(item: Item, conventions: Conventions | None = None, *, repair: bool = True) -> Row:
    """The verdict on one statement, in the coordinate conventions of its paper."""
    BEGUN.get()(item.statement.id)
    known = conventions or {}
    try:
        if (key := ("as it stands", *known.items())) not in item.kept:
            item.kept[key] = _in_any_way(item, known)
        row = cast(Row, item.kept[key])
        if row.status != "failed" or not repair:
            return row
        usual = [item, *(way.item for way in other_ways(item, known) if way.is_usual)]
        rows = [_verdict_on(it, known, repair) for it in usual]
        repaired = [it for it in rows if it.status == "misprint"]
        return min(repaired or rows[:1], key=lambda it: it.edit_cost)
    except TOO_LARGE as error:
        return replace(_row_of(item.statement), status="unread", evidence=too_large(error))


def _in_any_way(item: Item, conventions: Conventions) -> Row:
    """The verdict on a statement without a repair, in the first way in which it is right."""
    row = _verdict_on(item, conventions, False)
    if row.status != "failed":
        return row
    for way in other_ways(item, conventions):
        found = _verdict_on(way.item, conventions, False)
        if found.status in RIGHT:
            evidence = f"{found.evidence}; {way.said}"
            return replace(found, status=way.status or found.status, evidence=evidence)
    return row


def _verdict_on(item: Item, conventions: Conventions, repair: bool) -> Row:
    """The verdict, as the statement is read first, if nothing is too large."""
    comparison = Comparison(item, conventions)
    parts = comparison.components()
    entries = [item.subject.entries[place] for place in item.subject.index]
    row = replace(
        _row_of(item.statement),
        form=item.derivation.form,
        read="; ".join(part.said for part in parts),
        derived="; ".join(map(str, entries)),
        derived_latex=_joined(map(item.latex, entries)),
        derived_by=item.subject.by,
    )
    try:
        limit = limit_of(item, conventions) if item.statement.limit else None
    except Unread as error:
        return replace(row, status="unread", evidence=error.reason)
    if len(parts) < len(item.equations):
        names = ", ".join(sorted(item.subject.names))
        said = f"left of = no name of this object stands alone: {names}"
        return replace(row, status="unread", evidence=said)
    units_problem = _units_problem(item, parts)
    fixed = sorted(item.subject.names & item.derivation.free)
    if item.statement.word == "definition" and fixed:
        said = f"{', '.join(fixed)} has no value on the page, which this would give it"
        return replace(row, evidence=said)
    sides = [(comparison, parts)]
    if item.statement.word in ASSERTED and _has_accelerations(comparison, parts):
        along = Comparison(in_motion(item), comparison.conventions)
        sides.append((along, along.components()))
    is_free = bool(units_problem) and item.subject.factor == "constant"
    in_limits: list[Comparison] = []
    repairs: list[ProvedRepair] = []
    counted = ""
    for number, part in enumerate(parts):
        side, equal = comparison, list[Expr]()
        for side, its_parts in sides:
            if equal := _equal(side, its_parts[number]):
                break
        if equal and not is_free:
            exact = next((one for one in equal if side.proved(part.tree, one)), None)
            if exact is None:
                return replace(row, evidence="equal at all samples, but not by exact algebra")
            row, counted = _with_meaning(row, item, part, exact)
            counted += "; along the motion" if side.item.subject.along else ""
            continue
        if limit is None and (state := _at_zero(comparison, part)):
            said = f"right at {state} = 0 alone; where that is meant, say limit = '{state} -> 0'"
            return replace(row, status="unread", evidence=said)
        gap = comparison.exactly(part.tree) - _nearest_target(comparison, part)
        versions = [(one, its_parts[number]) for one, its_parts in sides]
        if limit is not None:
            in_limits = in_limits or [Comparison(one, conventions) for one in in_limit(item, limit)]
            versions = [(one, one.components()[number]) for one in in_limits]
            is_limit = any(_is_right(*one) for one in versions)
            if is_limit or any(is_approximation(comparison, part, it) for it in cases(item, limit)):
                said = "" if is_limit else "; what the print holds beyond that is not judged"
                row = replace(
                    _with_difference(row, item, gap), evidence=item.statement.limit + said
                )
                continue
        proved = filter(None, (_repaired(*one) for one in versions if repair))
        best = min(proved, key=lambda one: one.repair.cost, default=None)
        if best is None:
            said = "no edit, and no two, give what is derived" if repair else ""
            row = _with_difference(row, item, gap)
            return replace(row, evidence="; ".join(filter(None, (units_problem, said))))
        row, counted = _with_meaning(row, item, best.part, best.exact)
        edited = comparison.exactly(best.repair.tree)
        row = _with_difference(row, item, comparison.exactly(part.tree) - edited)
        repairs.append(best)
    if repairs:
        return _misprint(row, comparison, repairs, counted, units_problem)
    if row.evidence:
        return replace(row, status="approximation")
    status = "definition" if item.statement.word == "definition" else "confirmed"
    return replace(
        row, status=status, evidence=f"{row.derived_by}, equal by exact algebra{counted}"
    )


def _equal(comparison: Comparison, part: Component) -> list[Expr]:
    """The targets that a side equals at all samples; a printed 0 also what cancels to 0 there, as
    the rate of what is conserved along the motion.
    """
    is_zero = printed(part.tree) == "0"
    cancelled = 1e-10  # of samples of order 1
    return [
        exact
        for target, exact in part.targets
        if comparison.holds(part.tree, target) or (is_zero and np.abs(target).max() < cancelled)
    ]


def _has_accelerations(comparison: Comparison, parts: Iterable[Component]) -> bool:
    """Whether a side or a target of a statement holds accelerations."""
    held = {*comparison.item.derivation.accelerations}
    values = (it for part in parts for it in (comparison.exactly(part.tree), *part.meanings))
    return any(held & it.free_symbols for it in values)


def _at_zero(comparison: Comparison, part: Component) -> str:
    """The coordinates at whose 0 a side of steady sliding is right that names no state; else
    empty.
    """
    derivation, exact = comparison.item.derivation, part.targets[0][1]
    free = derivation.expanded(exact).free_symbols
    moving = [it for it in derivation.model.coordinates if it in free]
    names_state = {*moving} & derivation.expanded(comparison.exactly(part.tree)).free_symbols
    if not (comparison.item.subject.steady and moving) or names_state:
        return ""
    is_right = is_approximation(comparison, part, LimitCase(tuple(moving)))
    return ", ".join(map(str, moving)) if is_right else ""


def _nearest_target(comparison: Comparison, part: Component) -> Expr:
    """The target whose values are nearest to those of the print."""
    values = evaluated(part.tree, comparison.values)
    return min(part.targets, key=lambda one: _distance(values, one[0]))[1]


def _misprint(
    row: Row,
    comparison: Comparison,
    repairs: Sequence[ProvedRepair],
    counted: str,
    units_problem: str,
) -> Row:
    """The row of a statement with proved repairs."""
    statement = comparison.item.statement
    edits = [edit for one in repairs for edit in one.repair.edits]
    in_limit_of = f" in the limit {statement.limit}" if statement.limit else ""
    evidence = f"what is repaired equals {row.derived_by}{in_limit_of} by exact algebra{counted}"
    return replace(
        row,
        status="misprint",
        repaired="; ".join(one.said for one in repairs),
        repaired_latex="; ".join(_repaired_latex(comparison, one) for one in repairs),
        edits=tuple(map(_edit_as_json, edits)),
        edit_cost=round(sum(one.repair.cost for one in repairs), 3),
        marked=_marked(statement.judged, edits),
        alternatives=max(one.count for one in repairs),
        evidence="; ".join(filter(None, (units_problem, evidence))),
        cost="; ".join(dict.fromkeys(_cost(comparison, one) for one in repairs)),
    )


def _is_right(comparison: Comparison, part: Component) -> bool:
    """Whether a side is proved to equal one of its targets."""
    return any(
        comparison.holds(part.tree, target) and comparison.proved(part.tree, exact)
        for target, exact in part.targets
    )


def _with_meaning(row: Row, item: Item, part: Component, exact: Expr) -> tuple[Row, str]:
    """The row with the reading that the print equals, and the remark on that reading."""
    if said := part.meanings[exact]:
        row = replace(row, derived=str(exact), derived_latex=item.latex(exact))
        return row, f"; {said}"
    return row, ""


def _with_difference(row: Row, item: Item, gap: Expr) -> Row:
    """The row with the difference between print and derivation, unless that is too long to show."""
    most_operations = 3000
    if sp.count_ops(gap) > most_operations:
        return row
    shown = sp.factor_terms(normal_form(gap))
    return replace(row, difference=str(shown), difference_latex=item.latex(shown))


def _joined(texts: Iterable[str]) -> str:
    """LaTeX of one entry as it is, of several in brackets."""
    several = [*texts]
    inside = r",\; ".join(several)
    return inside if len(several) == 1 else rf"\left({inside}\right)"


def _marked(text: str, edits: Iterable[Edit]) -> str:
    """The print with guillemets around each edited part."""
    places = {place for edit in edits for place in (edit.at, *edit.also) if place[0] < place[1]}
    marks = [(end, "»") for _, end in places] + [(begin, "«") for begin, _ in places]
    marked = text
    for place, mark in sorted(marks, reverse=True):
        marked = f"{marked[:place]}{mark}{marked[place:]}"
    return marked if places else ""


def _repaired_latex(comparison: Comparison, found: ProvedRepair) -> str:
    """The print with its edits in LaTeX, if that reads as the repair; else LaTeX of the repair."""
    item, tree, left = comparison.item, found.repair.tree, found.part.left
    text = repaired_print(item.statement, found.repair.edits, item.letters) or ""
    right = evaluated(tree, comparison.values)
    with suppress(Unread, ValueError):
        for equation in equations_of(text, item.statement, item.derivation, item.book):
            equation = by_name(equation, item.derivation.names.keys() - item.subject.names)
            side, _ = judged_side(item, equation) or (equation.left, "")
            if symbols(side) <= comparison.values.keys() and same(
                evaluated(side, comparison.values), right
            ):
                return text
    return equation_of(item.letters.get(left, left), to_latex(tidied(tree), item.letters))


def _edit_as_json(edit: Edit) -> dict[str, object]:
    """An edit as the ledger records it."""
    return {
        "kind": edit.kind,
        "at": list(edit.at),
        "old": printed(edit.old),
        "new": printed(edit.new),
    }


def _cost(comparison: Comparison, found: ProvedRepair) -> str:
    """The size of a misprint in words: the median relative difference at the base values."""
    item = comparison.item
    base = samples.drawn(item.derivation, item.subject, is_base=True)
    for name, value in item.bound.items():
        base[name] = numeric(value, base)
    at_base = Comparison(replace(item, values=base), comparison.conventions)
    share = _distance(evaluated(found.part.tree, at_base.values), numeric(found.exact, base))
    if not np.isfinite(share):
        return ""
    shown = share if share > CLOSE else 0.0  # as for a lost factor that is 1 at the base values
    return f"{shown:.2g} of both sides' size at the base values, the median of random states"


def _distance(own: Values, right: Values) -> float:
    """The median over the samples of |a − b|/(|a| + |b|); inf if no value is finite."""
    size = np.abs(own) + np.abs(right)
    known = np.isfinite(size)
    gap = np.abs(own[known] - right[known])
    size = size[known]
    share = np.divide(gap, size, out=np.zeros_like(size), where=size > 0)
    return float(np.median(share)) if share.size else np.inf


def _repaired(comparison: Comparison, part: Component) -> ProvedRepair | None:
    """The cheapest proved repair of a side; None if none is found.

    Repairs by one edit are sought first, then by two; last a lost term of any form.
    """
    targets: list[tuple[Values, Expr]] = []
    for target, exact in part.targets:
        if not any(same(target, known) for known, _ in targets):
            targets.append((target, exact))
    search = Search(part.tree, _pool(comparison, part))
    proved: list[tuple[Repair, Expr]] = []
    for pairs in (False, True):
        if proved and proved[0][0].cost <= 2.0:  # two edits cost at least that
            break
        tried = targets[:4] if pairs else targets
        found = search.repairs(np.array([target for target, _ in tried]), pairs)
        for repair, target_number in found:
            # Targets 0 and 1 are the entry with either sign; a factor of parameters costs more, and
            # so does what removes a term that one reading has and another one has not.
            further = 0.005 if target_number > 1 else 0.0
            if comparison.item.subject.readings:
                further += 0.25 * any(printed(it.new) == "0" for it in repair.edits)
            proved.append((replace(repair, further=further), tried[target_number][1]))
        proved = _proved_first(comparison, proved)
    if proved:
        return ProvedRepair(part, *proved[0], len(proved))
    for _, exact in targets[:2]:  # the entry with either sign
        longer = _with_lost_term(comparison, part, exact)
        if longer is not None and comparison.proved(longer.tree, exact):
            return ProvedRepair(part, longer, exact, 1)
    return None


def _pool(comparison: Comparison, part: Component) -> Pool:
    """The names that an edit of a side may bring in.

    Excluded are the names that the statement itself gives, names with the target's own values, and
    bound names that resemble none in the print, unless they are printed in this side.
    """
    item = comparison.item
    free = {str(symbol) for entry in item.subject.entries for symbol in entry.free_symbols}
    page = item.derivation
    hidden = {*map(str, (LAMBDA, TIME, *page.normals, *page.coefficients, *page.switches))} - free
    hidden |= {*item.subject.names, part.left} if item.subject.law != "scale" else set()
    own = item.book.entries_of(item.statement)
    hidden |= {name for name in item.bound if name.startswith(own)}
    targets = [target for target, _ in part.targets]
    hidden |= {
        name for name in item.bound if any(same(comparison.values[name], one) for one in targets)
    }
    printed_names = [symbols(side) for one in item.equations for side in (one.left, one.right)]
    stems = set(map(stem, set().union(*printed_names)))
    hidden |= {name for name in item.bound if stem(name) not in stems}
    hidden -= symbols(part.tree)
    values = {name: value for name, value in comparison.values.items() if name not in hidden}
    return Pool(values, item.derivation.kinds, item.derivation.turning)


def _proved_first(
    comparison: Comparison, found: Iterable[tuple[Repair, Expr]]
) -> list[tuple[Repair, Expr]]:
    """The proved repairs of least cost, equal expressions once."""
    item, proved = comparison.item, list[tuple[Repair, Expr]]()
    forms: set[Expr] = set()
    for repair, exact in sorted(found, key=lambda one: (one[0].cost, len(printed(one[0].tree)))):
        is_dearer = bool(proved) and repair.cost > proved[0][0].cost + 0.01
        if is_dearer or len(proved) > 12:
            break
        form = to_sympy(repair.tree, {name: Symbol(name) for name in symbols(repair.tree)})
        if item.subject.factor == "constant" and _units_problem(item, [Component(repair.tree, ())]):
            continue  # a constant that is no energy
        if form not in forms and comparison.proved(repair.tree, exact):
            proved.append((repair, exact))
            forms.add(form)
    return proved


def _with_lost_term(comparison: Comparison, part: Component, exact: Expr) -> Repair | None:
    """A repair by adding the difference to the target, if that can be written as one term."""
    term = normal_form(exact - comparison.exactly(part.tree))
    longest_term = 8  # terms of its expanded numerator, and symbols of its factored form
    if len(sp.Add.make_args(sp.numer(term))) > longest_term:
        return None
    vocabulary = Vocabulary(frozenset(comparison.item.values), (), {})
    try:
        tree = read_sympy(str(factored(term)), vocabulary)[0].left
    except Unread:
        return None
    bare = tree.args[0] if tree.kind == "neg" else tree
    if bare.kind == "add" or sum(one.kind == "symbol" for one in nodes(tree)) > longest_term:
        return None
    args = part.tree.args if part.tree.kind == "add" else (part.tree,)
    new = Node("add", (*args, tree), at=part.tree.at)
    return Repair(new, (Edit("missing term", part.tree.at, part.tree, new, COST["missing term"]),))


# ------------------------------------------------------------------------------------------------
# units


def _units_problem(item: Item, parts: Iterable[Component]) -> str:
    """What is wrong with the units of a print; empty if they are consistent, or there are none."""
    if item.derivation.scaled or not item.has_units:
        return ""
    for part in parts:
        try:
            found = unit_of(part.tree, item.derivation, item.bound, item.defined)
        except units.UnitsError as error:
            return f"units: {error}"
        expected = item.subject.unit
        if expected is not None and found is not None and found != expected:
            return (
                f"units: {printed(part.tree)} is in {units.spelled(found)}, not in "
                f"{units.spelled(expected)}"
            )
    return ""


def _said_once(rows: Sequence[Row]) -> list[Row]:
    """The rows, with a note on those whose edits are the same: the page may be wrong there."""
    found = []
    for row in rows:
        key = _edit_key(row)
        others = tuple(it.id for it in rows if key and it.id != row.id and _edit_key(it) == key)
        note = "the print, or the page" if others else ""
        joined = "; ".join(filter(None, (row.note, note)))
        found.append(replace(row, said_once_with=others, note=joined))
    return found


def _edit_key(row: Row) -> tuple[object, ...]:
    """The edits of a row without the place at which they are made."""

    def essence(edit: Mapping[str, object]) -> tuple[object, ...]:
        kind = edit["kind"]
        new = str(edit["new"])
        return kind, new.removeprefix(str(edit["old"])) if kind == "missing term" else new

    return tuple(essence(edit) for edit in row.edits)
