"""Statements of a paper read, each beside the object that it is held against, at samples."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial

import sympy as sp

from ..pages import PageModel
from . import samples
from .matrices import entry_name, matrix_of
from .names import FREQUENCY, MATRICES
from .objects import LAMBDA, MOVING, TIME, Derivation, NoObject, Object, derivation, derived
from .papers import Paper, Statement
from .repair import Values, stem
from .samples import numeric
from .tree import Equation, Node, Unread, Vocabulary, printed, read_sympy, symbols, to_sympy


@dataclass(frozen=True)
class Book:
    """A paper beside its page: what its names mean, besides those of the page.

    A statement that gives the value of an object under a new name binds that name to the object
    as it is derived, so that a mistake is found where it stands and not where it is used. The
    names of definitions stand for what is printed.
    """

    forms: Mapping[str, Derivation]
    renamed: Mapping[str, str]
    #: names by the statements that give them
    bound: dict[str, Statement] = field(default_factory=dict)
    defined: dict[str, Node] = field(default_factory=dict)
    #: rows and columns of defined matrices
    shapes: dict[str, tuple[int, int]] = field(default_factory=dict)
    #: what defined names are printed as functions of
    arguments: dict[str, Node] = field(default_factory=dict)
    letters: dict[str, str] = field(default_factory=dict)  #: LaTeX of names, as printed

    def objects(self, it: Derivation) -> Iterator[tuple[str, Object]]:
        """Names that are bound to objects that the page has in this form."""
        for name, statement in self.bound.items():
            if statement.form in ("", it.form):
                with suppress(NoObject, ArithmeticError):
                    yield name, derived(it, statement.about)

    def values(self, it: Derivation) -> dict[str, sp.Expr]:
        """Bound names, and those of the entries of matrices, as derived."""
        found: dict[str, sp.Expr] = {}
        for name, held in self.objects(it):
            if held.shape is None:
                found[name] = held.entries[held.index[0]]
                continue
            for place in held.index:
                i, j = divmod(place, held.shape[1])
                found[entry_name(name, held.shape, i, j)] = held.entries[place]
        return found


@dataclass(frozen=True)
class Verdict:
    """A statement that is not compared: its verdict, and why."""

    statement: Statement
    status: str
    evidence: str = ""
    read: str = ""


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
    bound: Mapping[str, sp.Expr]
    defined: Mapping[str, Node]
    letters: Mapping[str, str]
    book: Book

    def latex(self, expression: sp.Expr) -> str:
        """LaTeX of an expression in the letters of the print."""
        known = {it.name: it for it in expression.free_symbols}
        names = {known[name]: text for name, text in self.letters.items() if name in known}
        return str(sp.latex(expression, symbol_names=names))


_FORMS: dict[tuple[str, str], dict[str, Derivation]] = {}


def forms_of(model: PageModel) -> dict[str, Derivation]:
    """A page in both forms, kept for the next paper."""
    key = model.name, model.digest
    if key not in _FORMS:
        both = ("units", "scaled")
        _FORMS[key] = {form: derivation(model.page, model.mechanics, form) for form in both}
    return _FORMS[key]


def opened(paper: Paper, model: PageModel) -> tuple[Book, list[Item | Verdict]]:
    """A paper's names, and its statements in order; definitions may stand behind their use."""
    book = _begun(paper, forms_of(model))
    for statement in paper.statements:
        _bind(statement, book)
    found: dict[str, Item | Verdict] = {}
    for first in (True, False):
        for statement in paper.statements:
            if (statement.word == "definition") is first:
                found[statement.id] = prepared(statement, book)
    return book, [found[statement.id] for statement in paper.statements]


def _begun(paper: Paper, forms: Mapping[str, Derivation]) -> Book:
    """The names that a paper lists; of an object by the words for it, as "damping", they are bound
    to it.
    """
    renamed, letters, bound = dict(paper.renamed), dict[str, str](), dict[str, Statement]()
    for text, meaning in paper.renamed.items():
        is_own = any(meaning in it.names for it in forms.values())
        if meaning.split(" ")[0] in MATRICES and not is_own:
            renamed[text] = re.sub(r"\W+", "_", meaning)
            bound[renamed[text]] = Statement(meaning, meaning, "", is_latex=False)
        if renamed[text].isidentifier():
            letters[renamed[text]] = text
    return Book(forms, renamed, bound, letters=letters)


def _bind(statement: Statement, book: Book) -> None:
    """Let the name on the left of an object's value stand for that object."""
    statement = replace(statement, transcribed="" if statement.is_latex else statement.transcribed)
    left, equal, _ = statement.text.partition("=")
    if not equal or statement.word in ("definition", "scale", "other", "notation"):
        return
    it = book.forms[statement.form or "units"]
    known = it.names.keys() | book.renamed.keys()
    if left.strip() in book.renamed:
        return
    try:
        (equation,) = equations_of(f"{left} = 0", statement, it, book, matrices=False)
        held = derived(it, statement.about)
    except (Unread, NoObject, ArithmeticError, ValueError):
        return
    name = equation.left.value
    if equation.left.kind == "symbol" and held.is_value and name not in known | held.names:
        book.bound[name] = statement
        letter = left.strip()
        if statement.is_latex:
            book.letters[name] = letter
        for i, j in itertools.product(*map(range, held.shape or (0, 0))):
            entry = entry_name(name, held.shape or (0, 0), i, j)
            book.letters[entry] = f"{letter}_{{{entry.rpartition('_')[2]}}}"


def equations_of(
    text: str, statement: Statement, it: Derivation, book: Book, *, matrices: bool = True
) -> list[Equation]:
    """Equations of a text in the language of a statement, with the names of its paper."""
    vocabulary = _vocabulary(statement, it, book, matrices)
    if statement.is_latex and not statement.transcribed:
        from .latex import read_latex

        is_scale = statement.word == "scale"
        found = read_latex(text.replace(r"\to", " = ") if is_scale else text, vocabulary)
    else:
        found = read_sympy(text, vocabulary)
    if FREQUENCY in it.names or not vocabulary.has_roots:
        return found
    return [Equation(_in_lambda(one.left), _in_lambda(one.right)) for one in found]


def _vocabulary(statement: Statement, it: Derivation, book: Book, matrices: bool) -> Vocabulary:
    """Names that may stand in a statement."""
    objects = book.objects(it) if matrices else ()
    shapes = {name: held.shape for name, held in objects if held.shape is not None}
    values = book.values(it)
    given = book.defined.keys() | book.shapes.keys() | book.bound.keys() | values.keys()
    has_roots = statement.word == "characteristic"
    names = {*it.names, *given, *([FREQUENCY] if has_roots else [])}
    names -= {str(TIME)} if statement.word != "scale" else set()
    return Vocabulary(
        frozenset(names),
        tuple(map(str, it.model.coordinates)),
        book.renamed,
        shapes | book.shapes,
        frozenset(map(str, (*it.normals, *it.coefficients))),
        _fixed(it, book.defined, values),
        has_roots,
        _arguments(statement, it, book),
    )


def _fixed(
    it: Derivation, defined: Mapping[str, Node], bound: Mapping[str, sp.Expr]
) -> frozenset[str]:
    """Names that are constant in time: parameters, and what is defined or bound to be one of
    these; lengths of lines, phases and names that the page has not are none.
    """
    given = {*it.parameters}
    for name, value in bound.items():
        if {str(symbol) for symbol in value.free_symbols} <= it.parameters.keys():
            given.add(name)
    return frozenset(given | dict(_in_order(defined, given)).keys())


def _in_order(trees: Mapping[str, Node], known: Collection[str]) -> Iterator[tuple[str, Node]]:
    """Those of definitions that stand on known names and on each other, each after these."""
    pending, found = dict(trees), {*known}
    while ready := [name for name, tree in pending.items() if symbols(tree) <= found]:
        found |= {*ready}
        yield from ((name, pending.pop(name)) for name in ready)


def _arguments(
    statement: Statement, it: Derivation, book: Book
) -> dict[str, Callable[[Node], bool]]:
    """Of names that are printed as functions, whether an expression is their argument: what their
    definition is printed with, or of a friction coefficient the sliding speed, at rest where the
    statement is about that.
    """
    still = {} if statement.word in (*MOVING, "friction") else dict.fromkeys(it.model.rates, 0)

    def is_printed(argument: Node, inside: Node) -> bool:
        return printed(inside) == printed(argument)

    def is_speed(speed: sp.Expr, inside: Node) -> bool:
        is_known = symbols(inside) <= it.names.keys()
        return is_known and sp.expand(to_sympy(inside, it.names) - speed) == 0

    rubbed = zip(map(str, it.coefficients), it.speeds, strict=False)
    found: dict[str, Callable[[Node], bool]] = {
        name: partial(is_speed, speed.subs(still)) for name, speed in rubbed
    }
    return found | {name: partial(is_printed, one) for name, one in book.arguments.items()}


def _in_lambda(tree: Node) -> Node:
    """Even powers of a frequency ω in those of λ = iω."""
    base, power = tree.args if tree.kind == "pow" else (tree, Node("number", value="1"))
    if base.kind == "symbol" and base.value == FREQUENCY:
        if not (power.value.isdigit() and int(power.value) % 2 == 0):
            raise Unread("of a frequency only even powers are read", tree.at[0])
        same = replace(tree, args=(replace(base, value=str(LAMBDA)), power))
        return Node("neg", (same,), at=tree.at) if int(power.value) % 4 else same
    return replace(tree, args=tuple(map(_in_lambda, tree.args)))


def prepared(statement: Statement, book: Book) -> Item | Verdict:
    """A statement read in the form in which it can be, or why it can't."""
    if statement.about in ("other", "notation"):
        status = "other" if statement.about == "other" else "definition"
        return Verdict(statement, status, statement.note and "not held against the page")
    problem = ""
    for form in (statement.form,) if statement.form else ("units", "scaled"):
        it = book.forms["units" if statement.word == "scale" else form]
        try:
            held = None if statement.word == "definition" else derived(it, statement.about)
            equations = equations_of(statement.judged, statement, it, book)
            return _item(statement, it, held, equations, book)
        except Unread as error:
            where = f"at {error.place}, {statement.judged[error.place :][:20]!r}: "
            readings = f"; either {' or '.join(error.readings)}" if error.readings else ""
            problem = problem or f"{where}{error.reason}{readings}"
        except (NoObject, ArithmeticError) as error:
            return Verdict(statement, "unread", str(error))
    return Verdict(statement, "unread", problem)


def _new_names(equations: list[Equation], it: Derivation, book: Book) -> dict[str, Node]:
    """What the names on the left stand for, where all are new: one or several, as a = b = c + d."""
    values: dict[str, Node] = {}
    others: list[tuple[str, str]] = []

    def is_new(node: Node) -> bool:
        return node.kind == "symbol" and node.value not in it.names | book.bound

    for left, right in ((one.left, one.right) for one in equations):
        if not is_new(left) or left.value in symbols(right):
            return {}
        if is_new(right) and right.value not in book.defined:
            others.append((right.value, left.value))
        else:
            values[left.value] = right
    for other, name in others:
        if name in values:
            values[other] = values[name]
        else:
            values[name] = Node("symbol", value=other)
    return values


def _defined(statement: Statement, new: Mapping[str, Node], it: Derivation, book: Book) -> Verdict:
    """The verdict on a definition, whose names are kept."""
    book.defined.update(new)
    first = next(iter(new))
    if (matrix := matrix_of([*new])) is not None:
        book.shapes[matrix[0]] = matrix[1]
    elif statement.is_latex:
        left = statement.text.partition("=")[0].strip()
        book.letters[first] = left
        if with_argument := re.fullmatch(r"([^()]*)\((.*)\)", left):
            book.letters[first] = with_argument[1]
            book.arguments[first] = equations_of(with_argument[2], statement, it, book)[0].left
    read = "; ".join(f"{name} = {printed(value)}" for name, value in new.items())
    return Verdict(statement, "definition", read=read)


def _item(
    statement: Statement,
    it: Derivation,
    held: Object | None,
    equations: list[Equation],
    book: Book,
) -> Item | Verdict:
    if held is None:
        if new := _new_names(equations, it, book):
            return _defined(statement, new, it, book)
        left = equations[0].left
        normals = dict(zip(map(str, it.normals), it.model.contacts, strict=True))
        known = it.geometry | {str(symbol): value for symbol, value in it.friction.items()}
        name = left.value if left.kind == "symbol" else ""
        if not symbols(left) <= it.names.keys():
            raise Unread(f"{printed(left)} is not in names of the page; say them under [symbols]")
        value = known[name] if name in known else to_sympy(left, it.names)
        by, own = "objects.Derivation.geometry", frozenset({printed(left)})
        held = Object((value,), by, names=own)
        if name in normals:
            held = derived(
                it, statement.about.replace("definition", f"normal {normals[name].name}")
            )
    count = len(held.index)
    if len(equations) < count:
        reason = f"{statement.about} has {count} entries, and the print {len(equations)}"
        return Verdict(statement, "unread", f"{reason}; name one of them in about")
    equations = equations[-count:]
    values = samples.drawn(it, held)
    bound = book.values(it)
    used = {name for one in equations for name in symbols(one.right) | symbols(one.left)}
    stems = {stem(name) for name in used & bound.keys()}
    bound = {name: value for name, value in bound.items() if stem(name) in stems}
    for name, value in bound.items():
        values[name] = numeric(value, values)
    defined: dict[str, Node] = {}  # not those in names that this form lacks
    defined |= _in_order(book.defined, values)
    sides = [one.right if held.is_value and one.left.kind == "symbol" else one for one in equations]
    for side in sides:
        parts = (side,) if isinstance(side, Node) else (side.left, side.right)
        unknown = {name for part in parts for name in symbols(part)} - values.keys()
        if unknown := unknown - defined.keys():
            name = min(unknown)
            raise Unread(f"{name} is no name of the page; say what it is under [symbols]")
    targets = tuple(numeric(entry, values) for entry in held.entries)
    readings = tuple(numeric(one.entry, values) for one in held.readings)
    letters = it.letters | ({} if held.law == "scale" else book.letters)
    return Item(
        statement,
        it,
        held,
        tuple(equations),
        values,
        targets,
        readings,
        bound,
        defined,
        letters,
        book,
    )
