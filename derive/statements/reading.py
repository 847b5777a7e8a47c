"""Reading of a paper: each statement parsed, with its object and the values of both at samples."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from functools import cached_property

import sympy as sp
from sympy import Expr, S, Symbol

from .. import units
from ..pages import PageModel
from ..units import Dimension
from . import samples
from .book import TOO_LARGE, Book, book_of, bind, by_name, equations_of, forms_of, meanings, named
from .book import is_hamiltonian, print_name, states_of, with_defined
from .derivatives import Slope
from .matrices import matrix_of
from .objects import Derivation, NoObject, Object, derived
from .papers import Paper, Statement
from .printed_code import accelerations
from .printed_values import verdict_on_value
from .repair import Values, evaluated, same, same_but_for_factor
from .samples import numeric
from .tree import ONE, ZERO, Equation, Node, Unread, joined, minus, nodes, printed, renamed
from .tree import residual, symbols, to_sympy


#: Words of statements whose equations hold on the page by themselves, and not about an object.
ASSERTED = ("definition", "identity")


@dataclass(frozen=True)
class Verdict:
    """A statement without a comparison: its verdict and the reason."""

    statement: Statement
    status: str
    evidence: str = ""
    read: str = ""
    repaired: str = ""


@dataclass(frozen=True)
class Item:
    """A parsed statement with the object that it is about.

    ``values`` are those of the page's names at the samples, ``targets`` those of the entries of
    ``subject``, and ``readings`` those of its readings.
    """

    statement: Statement
    derivation: Derivation
    subject: Object
    equations: tuple[Equation, ...]
    values: Mapping[str, Values]
    targets: tuple[Values, ...]
    readings: tuple[Values, ...]
    bound: Mapping[str, Expr]  #: names that the paper gives to objects, as derived
    defined: Mapping[str, Node]  #: names of definitions, as printed
    slopes: Mapping[str, Slope]  #: names of derivatives
    letters: Mapping[str, str]  #: LaTeX of names
    book: Book
    limited: Callable[[Expr], Expr] = lambda value: value  #: the limit in which the object is taken
    #: names of the page that mean something else in this print
    meant: Mapping[str, Expr] = field(default_factory=dict)
    has_units: bool = True  #: whether the units of a print in units can be judged

    @cached_property
    def kept(self) -> dict[object, object]:
        """What was found out about the statement as it is, by whoever compares it."""
        return {}

    def latex(self, expression: Expr) -> str:
        """LaTeX of an expression in the letters of the print."""
        known = {it.name: it for it in expression.free_symbols}
        names = {known[name]: text for name, text in self.letters.items() if name in known}
        return str(sp.latex(expression, symbol_names=names))


#: Told of every statement by its id before it is read or judged, as by whoever limits its time.
BEGUN: ContextVar[Callable[[str], None]] = ContextVar("BEGUN", default=lambda _: None)


def read_paper(paper: Paper, model: PageModel) -> tuple[Book, list[Item | Verdict]]:
    """The names of a paper, and its statements in order.

    Definitions are read first, since they may be printed behind their use.
    """
    book = book_of(paper, forms_of(model))
    for statement in paper.statements:
        BEGUN.get()(statement.id)
        with suppress(*TOO_LARGE):  # which is told where it is read
            bind(statement, book)
    found: dict[str, Item | Verdict] = {}
    for are_definitions in (True, False):
        pending = [it for it in paper.statements if (it.word == "definition") is are_definitions]
        while pending:  # also those of names that are defined behind them
            found |= {it.id: read_statement(it, book) for it in pending}
            unread = [it for it in pending if getattr(found[it.id], "status", "") == "unread"]
            pending = unread if len(unread) < len(pending) else []
    while lost := _names_of_unread(found, book):
        for kept in (book.bound, book.defined, book.definers):
            for name in lost & kept.keys():
                del kept[name]
        book.meant.clear()
        readable = [
            it for it in paper.statements if getattr(found[it.id], "status", "") != "unread"
        ]
        found |= {it.id: read_statement(it, book) for it in readable}
    return book, [found[statement.id] for statement in paper.statements]


def _names_of_unread(found: Mapping[str, Item | Verdict], book: Book) -> set[str]:
    """Names that stand for nothing, since the statements that would give them can't be read."""
    unread = {id for id, it in found.items() if getattr(it, "status", "") == "unread"}
    bound = {name for name, it in book.bound.items() if it.id in unread}
    return bound | {name for name, id in book.definers.items() if id in unread}


def read_statement(statement: Statement, book: Book) -> Item | Verdict:
    """Read one statement, in its form or in the first form in which it can be read.

    The result is a Verdict if the statement is a definition or can't be read.
    """
    if statement.about in ("other", "notation"):
        status = "other" if statement.about == "other" else "definition"
        return Verdict(statement, status, statement.note and "not held against the page")
    problem = ""
    BEGUN.get()(statement.id)
    if statement.word == "value":
        try:
            status, read, right, said = verdict_on_value(statement, book)
            return Verdict(statement, status, said, read, right)
        except Unread as error:
            return Verdict(statement, "unread", error.reason)
        except (NoObject, ArithmeticError, *TOO_LARGE) as error:
            return Verdict(statement, "unread", str(error))
    if statement.word == "code":
        try:
            statement = _of_code(statement, book)
        except Unread as error:
            return Verdict(replace(statement, text=""), "unread", error.reason)
    for form in (statement.form,) if statement.form else ("units", "scaled"):
        derivation = book.forms["units" if statement.word == "scale" else form]
        try:
            equations = equations_of(statement.judged, statement, derivation, book)
            _check_size([side for one in equations for side in (one.left, one.right)], book.defined)
            return _item(statement, derivation, equations, book)
        except Unread as error:
            where = f"at {error.place}, {statement.judged[error.place :][:20]!r}: "
            readings = f"; either {' or '.join(error.readings)}" if error.readings else ""
            problem = problem or f"{where}{error.reason}{readings}"
        except TOO_LARGE as error:
            return Verdict(statement, "unread", too_large(error))
        except (NoObject, ArithmeticError) as error:
            return Verdict(statement, "unread", str(error))
    return Verdict(statement, "unread", problem)


def _of_code(statement: Statement, book: Book) -> Statement:
    """The statement about the accelerations that a function of a file of code computes."""
    problem = Unread("")
    for form in (statement.form,) if statement.form else ("units", "scaled"):
        try:
            shown, text = accelerations(statement, book.renamed, book.forms[form])
            return replace(statement, about="acceleration", text=shown, transcribed=text, form=form)
        except Unread as error:
            problem = error if not problem.reason else problem
    raise problem


def _check_size(trees: Sequence[Node], defined: Mapping[str, Node]) -> None:
    """Refuse trees that are very long with their definitions written out."""
    most, sizes = 5000, dict[str, int]()  # parts

    def size(tree: Node) -> int:
        if tree.value in defined and tree.value not in sizes:
            sizes[tree.value] = most  # where definitions go round
            sizes[tree.value] = size(defined[tree.value])
        return sizes.get(tree.value, 1 + sum(map(size, tree.args)))

    if (parts := max(map(size, trees))) > most:
        said = f"{parts:.1e}" if parts > 1e6 else parts
        raise Unread(f"too large: written out it has {said} parts, more than {most}")


def too_large(error: BaseException) -> str:
    """What is too large to be read or judged, by the error in which it ends."""
    said = {
        RecursionError: "brackets and functions inside each other, too many for Python",
        MemoryError: "more memory than a row may have",
        OverflowError: "a number beyond those of double precision",
    }
    return f"too large: {next((text for it, text in said.items() if isinstance(error, it)), error)}"


def in_motion(item: Item) -> Item:
    """The statement with the accelerations that the equations of motion give."""
    subject = replace(item.subject, along=True)
    values = samples.drawn(item.derivation, subject)
    for name, value in item.bound.items():
        values[name] = numeric(value, values)
    targets = tuple(numeric(entry, values) for entry in subject.entries)
    return replace(item, subject=subject, values=values, targets=targets)


def _opens(equations: list[Equation]) -> bool:
    """Whether equations say what a normal force is in an open contact too."""
    inside = {one.value for equation in equations for one in nodes(equation.right)}
    return bool(inside & {"Piecewise", "max", "min", "Heaviside"})


def _new_names(
    equations: list[Equation], statement: Statement, derivation: Derivation, book: Book
) -> tuple[dict[str, Equation], list[Equation]]:
    """The equations that give new names their values, by these, and the remaining equations, which
    claim something: a second value of a name, or one of a name that is known.

    In a = b = c + d, both a and b stand for c + d.
    """
    values: dict[str, Equation] = {}
    equal_names: list[Equation] = []
    known: list[Equation] = []
    definers = book.definers
    given = {it for it in meanings(derivation, book) if definers.get(it) != statement.id}

    def is_new(node: Node) -> bool:
        return node.kind == "symbol" and node.value not in given

    for printed_one in equations:
        equation = by_name(printed_one, given | values.keys())
        left, right = equation.left, equation.right
        if not is_new(left) and is_new(right) and right.value not in values:
            left, right = right, left
            equation = replace(equation, left=left, right=right)
        if not is_new(left) or left.value in values or left.value in symbols(right):
            known.append(equation)
        elif is_new(right) and right.value not in book.defined:
            equal_names.append(equation)
        else:
            values[left.value] = equation
    for one in equal_names:
        name, other = one.left.value, one.right.value
        if name in values:
            values[other] = values[name]
        else:
            values[name] = one
    return values, known


def _defined(
    statement: Statement, new: Mapping[str, Equation], derivation: Derivation, book: Book
) -> Verdict:
    """Keep the names of a definition in the book, and give its verdict."""
    values = {name: one.right for name, one in new.items()}
    _check_size([*values.values()], book.defined | values)
    book.defined.update(values)
    book.definers.update(dict.fromkeys(new, statement.id))
    for base, group in itertools.groupby(new, lambda name: name.rpartition("_")[0]):
        names = [*group]
        is_print = statement.is_latex and not statement.transcribed
        is_whole = not is_print or len({new[name].left.at for name in names}) == 1
        matrix = matrix_of(names) if is_whole else None  # T_1 and T_2 are no vector
        if matrix is not None and base not in derivation.names:
            book.shapes[base] = matrix[1]
        for name in names if statement.is_latex and matrix is None else ():
            left = statement.text[slice(*new[name].left.at)]
            if statement.transcribed:
                left = statement.text.partition("=")[0]
            print_name(name, left, statement, derivation, book)
    read = "; ".join(f"{name} = {printed(one.right)}" for name, one in new.items())
    whole = {} if derivation.scaled else meanings(derivation, book)
    bound = {name: at for name, at in whole.items() if name not in derivation.names | book.defined}
    defined = {name: book.defined[name] for name in whole if name in book.defined}
    try:
        for one in (one for name, one in new.items() if name in whole):
            unit_of(one.right, derivation, bound, defined)
    except units.UnitsError as error:
        return Verdict(statement, "failed", f"units: {error}", read)
    return Verdict(statement, "definition", read=read)


def unit_of(
    tree: Node, derivation: Derivation, bound: Mapping[str, Expr], defined: Mapping[str, Node]
) -> Dimension | None:
    """The dimension of a printed side; None for 0, and where a definition has no dimension, which
    is told where it stands.

    Raises
    ------
    UnitsError
        If its units do not fit together.
    """
    names: dict[str, Expr] = {name: Symbol(name) for name in derivation.names}
    known = {Symbol(it): derivation.kinds.get(it, units.NONE) for it in names}
    for name, value in bound.items():
        names[name] = value.xreplace({it: Symbol(it.name) for it in value.free_symbols})
    for name, part in defined.items():
        if symbols(part) <= names.keys():
            with suppress(units.UnitsError):
                dimension = units.of(to_sympy(part, names, evaluate=False), known)
                names[name] = S.Zero if dimension is None else Symbol(name)
                known[Symbol(name)] = dimension or units.NONE
    if not symbols(tree) <= names.keys():
        return None
    return units.of(to_sympy(tree, names, evaluate=False), known)


def _definitions_beside(
    equations: list[Equation], derivation: Derivation, book: Book
) -> dict[str, Equation]:
    """The equations that give a value to a new name of another equation, as ζ = c/(2 m ω), by these
    names.
    """
    known, found = derivation.names | book.bound, dict[str, Equation]()
    fixed = derivation.parameters.keys() | book.defined.keys()
    for one in equations:
        solved = by_name(one, known | book.defined | found)
        name, others = solved.left.value, [it for it in equations if it is not one]
        is_new = solved.left.kind == "symbol" and name not in {*known, *symbols(solved.right)}
        is_used = any(name in symbols(it.left) | symbols(it.right) for it in others)
        is_again = any(name == it.left.value for it in others)
        if is_new and is_used and not is_again and symbols(one.left) <= fixed | {name}:
            found[name] = solved
    return found


def _known_names(
    equations: list[Equation], subject: Object, derivation: Derivation, book: Book
) -> Object:
    """The object of equations whose left sides are known: names of the page, of objects and of
    definitions, and expressions of these.

    Raises
    ------
    Unread
        If a name on the left has no value.
    """
    normals = dict(zip(map(str, derivation.normals), derivation.model.contacts, strict=True))
    known = {
        name: (value, "objects.Derivation.geometry") for name, value in derivation.geometry.items()
    }
    for symbol, value in derivation.friction.items():
        known[str(symbol)] = value, "laws.smooth_friction"
    for name, value in book.values(derivation).items():
        known[name] = value, book.bound[name].about if name in book.bound else "matrices"
    values = meanings(derivation, book)
    found: list[tuple[Expr, str]] = []
    for left in (one.left for one in equations):
        name = left.value if left.kind == "symbol" else ""
        if name in normals:
            normal = derived(derivation, f"normal {normals[name].name}, {subject.side}")
            found.append((normal.entries[0], normal.by))
        elif name in known:
            found.append(known[name])
        elif symbols(left) <= values.keys():
            by = "definition" if name in book.defined else "statements.derivatives.expressions"
            found.append((to_sympy(left, values), by))
        else:
            raise Unread(f"{printed(left)} is not in names of the page; say them under [symbols]")
    entries, origins = zip(*found, strict=True)
    names = frozenset(printed(one.left) for one in equations)
    index = tuple(range(len(entries)))
    by = ", ".join(dict.fromkeys(origins))
    return replace(subject, entries=entries, by=by, index=index, names=names)


def _of_multipliers(
    equations: list[Equation], statement: Statement, book: Book
) -> tuple[list[str], list[Equation]]:
    """The multipliers that get their values from equations, which are kept in the book, and the
    other equations. Each is linear in what it gives a value.
    """
    found: list[str] = []
    for name in sorted(book.multipliers):
        if book.definers.get(name, statement.id) != statement.id:
            continue
        for one in equations:
            tree = residual(one)
            if name not in symbols(tree):
                continue
            first, second = (renamed(tree, {name: it}) for it in (ZERO, ONE))
            book.defined[name] = Node("div", (first, Node("add", (first, minus(second)))))
            book.definers[name] = statement.id
            found.append(name)
            equations = [it for it in equations if it is not one]
            break
    return found, equations


def _sides_by_length(equation: Equation) -> Equation:
    """An equation with its longer side on the right, where faults are sought; of one with 0 there,
    the last term is moved to the left.
    """
    left, right = equation.left, equation.right
    if printed(right) == "0" and left.kind == "add":
        *terms, last = left.args
        left, right = minus(last), joined("add", terms, left.at)
    if len([*nodes(left)]) > len([*nodes(right)]):
        left, right = right, left
    return replace(equation, left=left, right=right)


def _says_nothing(equation: Equation, subject: Object, values: Mapping[str, Values]) -> bool:
    """Whether an equation makes no claim: it only names an expression, as F in F = a x = 0, or
    holds in any state, as 1 = cos² + sin².
    """
    sides = equation.left, equation.right
    if not all(symbols(side) <= values.keys() for side in sides):
        is_name = sides[0].kind == "symbol" and sides[0].value not in values
        return is_name and not subject.is_value
    left, right = (evaluated(side, values) for side in sides)
    return same(left, right)


def _check_conditions(conditions: tuple[Node, ...], known: Mapping[str, Values]) -> None:
    """Refuse conditions beside an equation that do not hold at every sample."""
    for condition in conditions:
        if not (symbols(condition) <= known.keys() and evaluated(condition, known).all()):
            raise Unread(
                "this condition does not hold wherever the equation is judged; say in about where "
                "it is meant, as 'motion x, belt ahead'",
                condition.at[0],
            )


def _entries(equations: list[Equation], subject: Object, derivation: Derivation) -> tuple[int, ...]:
    """Numbers of the entries that the names left of equations of values say, as K_12 or x″.

    Raises
    ------
    Unread
        If they are others than those that the statement is about.
    """
    model, names = derivation.model, [it.left.value for it in equations]
    is_chain = len(equations) > len(subject.index)  # as K = A = B
    lefts = [*dict.fromkeys(names)] if is_chain else names
    places: dict[str, int] = {}
    if subject.law == "vector":
        rows = zip(model.coordinates, derivation.accelerations, strict=True)
        for place, (name, second) in enumerate(rows):
            places |= dict.fromkeys((str(name), f"{name}_0", str(second)), place)
    if subject.law == "form":
        size = math.isqrt(len(subject.entries))
        for left in lefts:
            if (mark := re.search(r"([1-9])([1-9])$", left)) and max(map(int, mark[0])) <= size:
                places[left] = (int(mark[1]) - 1) * size + int(mark[2]) - 1
    if len(subject.index) == 1:  # which may be numbered otherwise
        places = {}
    found = [places.get(*pair) for pair in zip(lefts, subject.index, strict=False)]
    if sorted(found) != [*subject.index] or len(lefts) > len(found):
        said = "each entry has to stand there once, and what else is printed in other statements"
        raise Unread(f"left of = stand {', '.join(lefts)}; {said}")
    return tuple(found[lefts.index(name)] for name in names) if is_chain else tuple(found)


def _in_order(
    subject: Object,
    equations: Sequence[Equation],
    known: Mapping[str, Values],
    derivation: Derivation,
    book: Book,
) -> Object:
    """The linearization in the order of the states that the paper states, or, where it states none,
    in that of the usual ones with which the print agrees most: all coordinates and then all rates,
    each coordinate with its rate, or all rates first.
    """
    n = len(derivation.places(""))
    moved = [(str(one), str(rate)) for one, rate, _ in derivation.moved[:n]]
    names = [one for row in zip(*moved, strict=True) for one in row]
    stated = [it for it in states_of(derivation, book).values() if {*it} == {*names}]
    usual = [names, [one for pair in moved for one in pair], [*names[n:], *names[:n]]]
    subjects = []
    for own in stated or usual:
        order = [names.index(it) for it in own]
        entries = tuple(subject.entries[2 * n * i + j] for i in order for j in order)
        said = f"{subject.by}, of the states {', '.join(own)}" if own != names else subject.by
        places = tuple(it % n for it in order)
        subjects.append(replace(subject, entries=entries, by=said, rows=places))

    def agreeing(one: Object) -> int:
        found = 0
        for it, place in zip(equations, one.index, strict=False):
            is_known = symbols(it.right) <= known.keys()
            found += is_known and same(
                evaluated(it.right, known), numeric(one.entries[place], known)
            )
        return found

    return max(subjects, key=agreeing)


def _as_matched(
    equations: list[Equation],
    index: Sequence[int],
    targets: Sequence[Values],
    known: Mapping[str, Values],
) -> list[Equation]:
    """Residuals in the order of the entries of which they are multiples; others in their own."""
    others, found = [*equations], dict[int, Equation]()
    for place in index if len(index) > 1 else ():
        for equation in others:
            tree = residual(equation)
            is_known = symbols(tree) <= known.keys()
            if is_known and same_but_for_factor(evaluated(tree, known), targets[place]):
                found[place] = equation
                others = [one for one in others if one is not equation]
                break
    return [found[place] if place in found else others.pop(0) for place in index]


def _item(
    statement: Statement,
    derivation: Derivation,
    equations: list[Equation],
    book: Book,
) -> Item | Verdict:
    """A statement's equations with the object that they are about.

    Every printed equation that makes a claim is compared with it, of an object with several entries
    as many as these.
    """
    if statement.word in ASSERTED:
        subject = derived(derivation, f"identity{statement.about[len(statement.word) :]}")
        if statement.word == "definition":
            new, equations = _new_names(equations, statement, derivation, book)
            verdict = _defined(statement, new, derivation, book) if new else None
            if verdict is not None and (not equations or verdict.status == "failed"):
                return verdict
        else:
            given, equations = _of_multipliers(equations, statement, book)
            if given and not equations:
                said = f"{', '.join(given)} has its value from this equation"
                return Verdict(statement, "definition", said)
            equations = [*map(_sides_by_length, equations)]
        subject = _known_names(equations, subject, derivation, book)
    else:
        opens = statement.word == "normal" and "," not in statement.about and _opens(equations)
        subject = derived(derivation, statement.about + (", both" if opens else ""))
        new = _definitions_beside(equations, derivation, book)
        if new and len(equations) - len(new) >= len(subject.index):
            _defined(statement, new, derivation, book)
            equations = [one for one in equations if one not in new.values()]
    count = len(subject.index)
    if len(equations) < count:
        reason = f"{statement.about} has {count} entries, and the print {len(equations)}"
        return Verdict(statement, "unread", f"{reason}; name one of them in about")
    if is_hamiltonian(statement):
        for one in (it for it in equations if it.left.kind == "symbol"):
            if one.left.value not in derivation.names:
                book.defined[one.left.value] = one.right
                book.definers[one.left.value] = statement.id
    if subject.is_value and statement.word not in ASSERTED:
        known_names = derivation.names.keys() - subject.names
        equations = [by_name(one, known_names) for one in equations]
    values = samples.drawn(derivation, subject)
    bound, defined = named(equations, subject, values, derivation, book)
    known = with_defined(values, defined)
    claims = [
        one
        for one in equations
        if one.left.value in subject.names
        or one.left.value.startswith(book.entries_of(statement))
        or not _says_nothing(one, subject, known)
    ]
    equations = claims if len(claims) >= count else equations[-count:]
    if statement.word == "system":
        subject = _in_order(subject, equations, known, derivation, book)
    targets = tuple(numeric(entry, values) for entry in subject.entries)
    if subject.is_value:
        subject = replace(subject, index=_entries(equations, subject, derivation))
    elif count == 1:
        subject = replace(subject, index=subject.index * len(equations))
    elif len(equations) > count:
        said = "the print more equations; give the others statements of their own"
        raise Unread(f"{statement.about} has {count} entries, and {said}")
    else:
        equations = _as_matched(equations, subject.index, targets, known)
    _check_conditions(equations[0].conditions, known)
    sides = [
        one.right if subject.is_value and one.left.kind == "symbol" else one for one in equations
    ]
    for side in sides:
        parts = (side,) if isinstance(side, Node) else (side.left, side.right)
        unknown = {name for part in parts for name in symbols(part)} - values.keys()
        if unknown := unknown - defined.keys():
            name = min(unknown)
            raise Unread(f"{name} is no name of the page; say what it is under [symbols]")
    readings = tuple(numeric(one.entry, values) for one in subject.readings)
    listed = {} if subject.law == "scale" else book.letters
    letters = derivation.letters | {
        name: letter
        for name, letter in listed.items()
        if letter in statement.text or derivation.letters.get(name, letter) not in statement.text
    }
    return Item(
        statement,
        derivation,
        subject,
        tuple(equations),
        values,
        targets,
        readings,
        bound,
        defined,
        {name: slope for name, slope in book.slopes.items() if name in bound},
        letters,
        book,
    )
