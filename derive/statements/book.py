"""Names of a paper and their meanings on the page.

A paper lists names under [symbols], gives names to objects of the page (energies, matrices) in its
statements, and defines names of its own. From these follows the vocabulary of each statement.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial

import sympy as sp
from sympy import Expr

from ..pages import PageModel
from .derivatives import Slope, expressions, of_value
from .matrices import entry_name
from .names import MATRICES, function_behind
from .objects import LAMBDA, MOVING, TIME, Derivation, NoObject, Object, derivation_of, derived
from .papers import Paper, Statement
from .repair import Values, evaluated, stem
from .samples import numeric
from .tree import Argument, Equation, Node, Unread, Vocabulary, as_printed
from .tree import printed, read_sympy, symbols, to_sympy, undone


#: Errors in which a print ends that is too large.
TOO_LARGE = (RecursionError, MemoryError, OverflowError)


@dataclass(frozen=True)
class Book:
    """The names of a paper, besides those of the page.

    A statement that gives the value of an object a new name binds that name to the object as
    derived, so that a misprint is found where it is printed and not where the name is used. The
    names of definitions stand for what is printed.
    """

    forms: Mapping[str, Derivation]
    renamed: Mapping[str, str]
    #: names of objects, with the statements that give them
    bound: dict[str, Statement] = field(default_factory=dict)
    defined: dict[str, Node] = field(default_factory=dict)
    #: the statements, by their ids, in which names are defined
    definers: dict[str, str] = field(default_factory=dict)
    #: rows and columns of defined matrices
    shapes: dict[str, tuple[int, int]] = field(default_factory=dict)
    #: arguments of defined names that are printed as functions
    arguments: dict[str, Node] = field(default_factory=dict)
    #: derivatives that are printed, by name
    slopes: dict[str, Slope] = field(default_factory=dict)
    #: the reading of each bound name, by form and name
    meant: dict[tuple[str, str], Expr] = field(default_factory=dict)
    letters: dict[str, str] = field(default_factory=dict)  #: LaTeX of names, as printed
    data: Mapping[str, str] = field(default_factory=dict)  #: printed values of names
    #: names of multipliers: forces of constraint, whose values the paper's equations give
    multipliers: frozenset[str] = frozenset()

    def entries_of(self, statement: Statement) -> tuple[str, ...]:
        """Beginnings of the names of the entries of the matrix that a statement is about."""
        return tuple(f"{it}_" for it, one in self.bound.items() if one.about == statement.about)

    def objects(self, derivation: Derivation) -> Iterator[tuple[str, Object]]:
        """Names and objects of those statements that apply to the page in this form."""
        for name, statement in self.bound.items():
            if statement.form in ("", derivation.form):
                with suppress(NoObject, ArithmeticError):
                    yield name, derived(derivation, statement.about)

    def values(self, derivation: Derivation) -> dict[str, Expr]:
        """Derived expressions of bound names, and of the entries of bound matrices."""
        found: dict[str, Expr] = {}
        for name, subject in self.objects(derivation):
            if subject.shape is None:
                found[name] = _meant(name, subject, derivation, self)
                continue
            for place in subject.index:
                i, j = divmod(place, subject.shape[1])
                found[entry_name(name, subject.shape, i, j)] = subject.entries[place]
        return found


_FORMS: dict[tuple[str, str], dict[str, Derivation]] = {}


def forms_of(model: PageModel) -> dict[str, Derivation]:
    """The derivations of a page with units and scaled, cached by its digest."""
    key = model.name, model.digest
    if key not in _FORMS:
        both = ("units", "scaled")
        _FORMS[key] = {form: derivation_of(model.page, model.mechanics, form) for form in both}
    return _FORMS[key]


def book_of(paper: Paper, forms: Mapping[str, Derivation]) -> Book:
    """The book of the names under [symbols].

    A name whose meaning is the word for an object, as "damping", is bound to that object.
    """
    renamed, letters, bound = dict(paper.renamed), dict[str, str](), dict[str, Statement]()
    multipliers = {it for it in renamed.values() if re.fullmatch(r"multiplier(_\w+)?", it)}
    multipliers -= set().union(*(it.names.keys() for it in forms.values()))
    for text, meaning in paper.renamed.items():
        is_own = any(meaning in it.names for it in forms.values())
        if meaning.split(" ")[0] in (*MATRICES, "energy") and not is_own:
            renamed[text] = re.sub(r"\W+", "_", meaning)
            bound[renamed[text]] = Statement(meaning, meaning, "", is_latex=False)
        if renamed[text].isidentifier():
            letters[renamed[text]] = text
    derivation = forms["units"]
    for row in derivation.moved:
        name, rate, second = map(str, row)
        if letter := letters.get(name):
            dotted = {rate: rf"\dot{{{letter}}}", second: rf"\ddot{{{letter}}}"}
            letters = dotted | letters
    return Book(
        forms,
        renamed,
        bound,
        letters=letters,
        multipliers=frozenset(multipliers),
        data=paper.data,
    )


def bind(statement: Statement, book: Book) -> None:
    """Bind the name on the left of a statement to the object whose value it gives, if it is new."""
    statement = replace(statement, transcribed="" if statement.is_latex else statement.transcribed)
    left, equal, _ = statement.text.partition("=")
    if not equal or statement.word in ("definition", "scale", "value", "other", "notation"):
        return
    if is_hamiltonian(statement):  # whose momenta are in its print alone
        return
    derivation = book.forms[statement.form or "units"]
    if statement.word == "friction" and statement.is_latex:
        with suppress(Unread, NoObject):
            head = re.split(r"\\left\(|\(", left)[0]
            (name,) = derived(derivation, statement.about).names
            if equations_of(f"{head} = 0", statement, derivation, book)[0].left.value == name:
                print_name(name, left, statement, derivation, book)
    known = derivation.names.keys() | book.renamed.keys()
    if left.strip() in book.renamed:
        return
    try:
        (equation,) = equations_of(f"{left} = 0", statement, derivation, book, matrices=False)
        subject = derived(derivation, statement.about)
    except (Unread, NoObject, ArithmeticError, ValueError):
        return
    named = by_name(equation, known - subject.names).left
    name = named.value
    if named.kind == "symbol" and subject.is_value and name not in known:
        book.bound[name] = statement
        letter = left.strip()
        if named is not equation.left:
            letter = left[named.at[0] : named.at[1]]
        if statement.is_latex:
            print_name(name, letter, statement, derivation, book)
        for i, j in itertools.product(*map(range, subject.shape or (0, 0))):
            entry = entry_name(name, subject.shape or (0, 0), i, j)
            whole = f"({letter})" if "_" in letter else letter
            book.letters[entry] = f"{whole}_{{{entry.rpartition('_')[2]}}}"


def is_hamiltonian(statement: Statement) -> bool:
    """Whether a statement is about Hamilton's function."""
    return statement.about.partition(",")[0] == "energy H"


def by_name(equation: Equation, known: Container[str]) -> Equation:
    """An equation solved for the one new name on its left, as 2 T = m v² and ω² = k/m."""
    left, right = equation.left, equation.right
    while left.kind != "symbol":
        sides = undone(left, right, lambda it: any(name not in known for name in symbols(it)))
        if sides is None:
            return equation
        left, right = sides
    return replace(equation, left=left, right=right)


def print_name(
    name: str, left: str, statement: Statement, derivation: Derivation, book: Book
) -> None:
    """Keep the LaTeX of a name, and its argument if it is printed with one, as in f(x) = …."""
    left = re.sub(r"\\(?:left|right)(?=[()])|\\[,;:!]", "", left).strip()
    book.letters[name] = left
    if with_argument := re.fullmatch(r"([^()]*)\((.*)\)", left):
        book.letters[name] = with_argument[1]
        with suppress(Unread):  # several arguments are not kept
            argument = equations_of(with_argument[2], statement, derivation, book)[0].left
            book.arguments[name] = argument


def equations_of(
    text: str, statement: Statement, derivation: Derivation, book: Book, *, matrices: bool = True
) -> list[Equation]:
    """Parse a text in the language of a statement, with the names of its paper.

    ``matrices=False`` leaves out the names of matrices.
    """
    vocabulary = _vocabulary(statement, derivation, book, matrices)
    if statement.is_latex and not statement.transcribed:
        from .latex import read_latex

        equal_signs: list[str] = []
        if statement.word == "scale":
            equal_signs.append(r"\to")
        if statement.limit:
            equal_signs += [r"\approx", r"\simeq"]
        for sign in equal_signs:  # of the same length, so that offsets stay
            text = text.replace(sign, "=".center(len(sign)))
        found = read_latex(text, vocabulary)
    else:
        found = read_sympy(text, vocabulary)
    if "frequency" in derivation.names or not vocabulary.has_roots:
        return found
    return [replace(it, left=_in_lambda(it.left), right=_in_lambda(it.right)) for it in found]


def _vocabulary(
    statement: Statement, derivation: Derivation, book: Book, matrices: bool
) -> Vocabulary:
    """The vocabulary of a statement."""
    objects = book.objects(derivation) if matrices else ()
    shapes = {name: held.shape for name, held in objects if held.shape is not None}
    values = meanings(derivation, book)
    given = book.defined.keys() | book.shapes.keys() | book.bound.keys() | values.keys()
    given |= book.multipliers
    has_roots, gives_names = statement.word == "characteristic", statement.word == "definition"
    is_steady = False
    with suppress(NoObject, ArithmeticError):
        subject = derived(derivation, statement.about)
        gives_names, is_steady = gives_names or subject.is_value, subject.steady
    names = {*derivation.names, *given, *(["frequency"] if has_roots else [])}
    renamed = dict(book.renamed)
    if is_steady:  # nothing moves, and a speed is that of the belt
        at_rest = ((text, re.sub(r"\w+'+", "0", page)) for text, page in renamed.items())
        renamed |= {text: page for text, page in at_rest if page != "0"}
    model = derivation.model
    if statement.word != "scale" and derivation.names[str(TIME)] == TIME:
        names.remove(str(TIME))
        if model.clock is not None:  # of which the phase is ω t
            phase = f"{model.clock}/({derivation.spelled(model.speed)})"
            renamed = dict.fromkeys(("t", r"\tau")[: 1 + derivation.scaled], phase) | renamed
    return Vocabulary(
        frozenset(names),
        tuple(str(it) for it in model.coordinates if it != model.clock),
        renamed,
        shapes | book.shapes,
        frozenset(map(str, derivation.laws)),
        frozenset(name for name, value in values.items() if _is_fixed(value, derivation)),
        has_roots,
        gives_names,
        {name: str(ratio) for name, ratio in _scales(derivation, book).items() if ratio != 1},
        _arguments(statement, derivation, book, values),
        partial(_slope, derivation, book),
        states=states_of(derivation, book, statement.id),
        is_definition=statement.word == "definition",
    )


def states_of(derivation: Derivation, book: Book, but: str = "") -> dict[str, tuple[str, ...]]:
    """Names of a paper that are defined as a coordinate or a rate, or as a column of these, with
    the page's names; without those of the statement ``but``, which is read as it stands.
    """
    states = {*map(str, derivation.states)}
    found: dict[str, tuple[str, ...]] = {
        name: (tree.value,)
        for name, tree in book.defined.items()
        if tree.value in states and book.definers.get(name) != but
    }
    for name, shape in book.shapes.items():
        entries = [found.get(entry_name(name, shape, i, 0), ()) for i in range(shape[0])]
        if shape[1] == 1 and all(entries):
            found[name] = sum(entries, ())
    return found


def _slope(derivation: Derivation, book: Book, of: str, by: str) -> str:
    """Keep the derivative of a name by another, and give its name.

    Beside the derivative by a coordinate or a rate, those by all others are kept, for a repair.

    Raises
    ------
    Unread
        If there is no such derivative, or it has several readings.
    """
    slope = Slope(of, by)
    if not by and slope.law({*map(str, derivation.coefficients)}) is None:
        argument = book.arguments.get(function_behind(of, book.arguments) or "")
        if argument is None or argument.kind != "symbol":
            raise Unread(f"the derivative of {of}, which is printed as no function; say by what")
        slope = Slope(of, argument.value)
    listed = book.bound.get(of)  # for an object, and printed in no statement
    if listed and not listed.text and derived(derivation, listed.about).readings:
        raise Unread(
            f"{of} may count the potential of a constant force or a contact or leave it out; print "
            f"it in a statement about {listed.about}"
        )
    rows = [[*map(str, row)] for row in (derivation.model.coordinates, derivation.model.rates)]
    added, letters = dict[str, Slope](), derivation.letters
    for other in next((row for row in rows if slope.by in row), [slope.by]):
        other_slope = Slope(of, other)
        added[other_slope.name] = other_slope
        letter, by_letter = (
            book.letters.get(name, letters.get(name, name)) for name in (of, other)
        )
        book.letters[other_slope.name] = other_slope.latex(letter, by_letter if by else "")
    values = meanings(derivation, book, added)
    if of not in values:
        said = "say what it is in a statement about definition"
        raise Unread(f"the derivative of {of}, which is no name that is known; {said}")
    if slope.name not in values:
        of_value(values[of], slope.by, derivation)  # raises, and says why
    book.slopes.update(added)
    return slope.name


def _is_fixed(value: Expr, derivation: Derivation) -> bool:
    """Whether an expression holds parameters only, and so is constant in time."""
    return {str(symbol) for symbol in value.free_symbols} <= derivation.parameters.keys()


def _scales(derivation: Derivation, book: Book) -> dict[str, Expr]:
    """The sliding speed of each friction over the argument with which its law is printed, as R of
    μ(φ′); none if that is no constant length.
    """
    found: dict[str, Expr] = {}
    for symbol, speed in zip(derivation.coefficients, derivation.speeds, strict=False):
        argument = book.arguments.get(str(symbol))
        if argument is not None and symbols(argument) <= derivation.names.keys():
            ratio = sp.cancel(speed / to_sympy(argument, derivation.names))
            if _is_fixed(ratio, derivation) and ratio.is_nonnegative:
                found[str(symbol)] = ratio
    return found


def _arguments(
    statement: Statement, derivation: Derivation, book: Book, names: Mapping[str, Expr]
) -> dict[str, Callable[[Node], Argument | None]]:
    """For each name that is printed as a function: the test of an expression for its argument.

    A definition has the argument with which it is printed, a friction coefficient its sliding
    speed, or minus that if its law is odd.
    """
    is_moving = statement.word in (*MOVING, "friction", "definition")
    scales = _scales(derivation, book)
    still = dict.fromkeys(derivation.model.rates, 0)

    def as_speed(speed: Expr, is_odd: bool, inside: Node) -> Argument | None:
        value = to_sympy(inside, names) if symbols(inside) <= names.keys() else sp.nan
        for sign in (1, -1) if is_odd else (1,):
            for at_rest in (False, True):
                meant = speed.subs(still) if at_rest else speed
                if sp.expand(value - sign * meant) == 0:
                    return Argument(sign, at_rest and is_moving)
        return None

    found: dict[str, Callable[[Node], Argument | None]] = {
        name: partial(as_printed, printed(one)) for name, one in book.arguments.items()
    }
    for symbol, speed, friction in zip(
        derivation.coefficients, derivation.speeds, derivation.model.frictions, strict=False
    ):
        is_odd = sp.expand(friction.ahead + friction.behind) == 0
        found[str(symbol)] = partial(as_speed, speed / scales.get(str(symbol), 1), is_odd)
    return found


def meanings(
    derivation: Derivation, book: Book, more: Mapping[str, Slope] | None = None
) -> dict[str, Expr]:
    """Expressions, in the page's symbols, of all names: of the page, of objects, of definitions and
    of derivatives.
    """
    known = {**derivation.names, **book.values(derivation)}
    return expressions(known, book.defined, {**book.slopes, **(more or {})}, derivation)


def _in_lambda(tree: Node) -> Node:
    """A tree with the even powers of a frequency ω written in λ = iω: ω² is −λ²."""
    base, power = tree.args if tree.kind == "pow" else (tree, Node("number", value="1"))
    if base.kind == "symbol" and base.value == "frequency":
        if not (power.value.isdigit() and int(power.value) % 2 == 0):
            raise Unread("of a frequency only even powers are read", tree.at[0])
        same = replace(tree, args=(replace(base, value=str(LAMBDA)), power))
        return Node("neg", (same,), at=tree.at) if int(power.value) % 4 else same
    return replace(tree, args=tuple(map(_in_lambda, tree.args)))


def _meant(name: str, subject: Object, derivation: Derivation, book: Book) -> Expr:
    """The expression that a name is bound to: of an object's readings the one whose symbols differ
    least from those in the print.
    """
    key = derivation.form, name
    if key not in book.meant:
        book.meant[key] = subject.entries[subject.index[0]]
        statement = book.bound[name]
        if subject.readings and statement.text:
            try:
                *_, equation = equations_of(statement.judged, statement, derivation, book)
                equation = by_name(equation, derivation.names.keys() - subject.names)
                # Only symbols are compared: the print's coordinates may have other signs.
                own = to_sympy(equation.right, meanings(derivation, book)).free_symbols
            except (
                Unread,
                NoObject,
                KeyError,
                *TOO_LARGE,
            ):  # as of a name that is defined behind it
                return book.meant.pop(key)
            book.meant[key] = min(
                (reading.entry for reading in subject.readings),
                key=lambda entry: len(own ^ entry.free_symbols),
            )
    return book.meant[key]


def used(equations: Iterable[Equation], book: Book) -> set[str]:
    """Names in equations, in the definitions of these names, and so on."""
    found: set[str] = set()
    pending = {name for one in equations for name in symbols(one.right) | symbols(one.left)}
    while pending:
        found |= pending
        inside = [symbols(book.defined[name]) for name in pending & book.defined.keys()]
        inside += [frozenset({book.slopes[name].of}) for name in pending & book.slopes.keys()]
        pending = set().union(*inside) - found
    return found


def named(
    equations: Sequence[Equation],
    subject: Object,
    values: dict[str, Values],
    derivation: Derivation,
    book: Book,
) -> tuple[dict[str, Expr], dict[str, Node]]:
    """Expressions of the bound names and derivatives in equations, and trees of the defined names.

    The values of the former at the samples are added to ``values``.
    """
    objects = book.values(derivation)
    if subject.steady and subject.law == "covector":  # a state that has a name is looked for
        states = (
            (name, one.index) for name, one in book.objects(derivation) if one.law == "vector"
        )
        objects |= {name: derivation.model.coordinates[index[0]] for name, index in states}
    whole = expressions(
        {**derivation.names, **objects},
        book.defined,
        book.slopes,
        derivation,
        steady=subject.steady,
    )
    names = (objects.keys() | book.slopes.keys()) & whole.keys()
    stems = {stem(name) for name in used(equations, book) & names}
    bound = {name: whole[name] for name in sorted(names) if stem(name) in stems}
    for name, value in bound.items():
        values[name] = numeric(value, values)
    # Each after those that it uses; definitions in names that this form of the page lacks are left
    # out.
    defined: dict[str, Node] = {}
    for name in (it for it in whole if it in book.defined):
        if symbols(book.defined[name]) <= values.keys() | defined.keys():
            defined[name] = book.defined[name]
    return bound, defined


def with_defined(values: Mapping[str, Values], defined: Mapping[str, Node]) -> dict[str, Values]:
    """Values at samples, with those of defined names added."""
    found = dict(values)
    for name, tree in defined.items():
        found[name] = evaluated(tree, found)
    return found
