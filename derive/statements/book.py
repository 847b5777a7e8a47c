"""The names of a paper beside its page: those that it lists, those of objects and of definitions,
and what may stand in each statement.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial

import sympy as sp
from sympy import Expr

from ..pages import PageModel
from .derivatives import Slope, expressions, of_value
from .matrices import entry_name
from .names import MATRICES, function_behind
from .objects import LAMBDA, MOVING, TIME, Derivation, NoObject, Object, derivation, derived
from .papers import Paper, Statement
from .repair import Values, evaluated, stem
from .samples import numeric
from .tree import Argument, Equation, Node, Unread, Vocabulary
from .tree import minus, printed, read_sympy, symbols, to_sympy


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
    #: derivatives that are printed, by name
    slopes: dict[str, Slope] = field(default_factory=dict)
    #: what is counted in bound energies, by form and name
    meant: dict[tuple[str, str], Expr] = field(default_factory=dict)
    letters: dict[str, str] = field(default_factory=dict)  #: LaTeX of names, as printed

    def objects(self, it: Derivation) -> Iterator[tuple[str, Object]]:
        """Names that are bound to objects that the page has in this form."""
        for name, statement in self.bound.items():
            if statement.form in ("", it.form):
                with suppress(NoObject, ArithmeticError):
                    yield name, derived(it, statement.about)

    def values(self, it: Derivation) -> dict[str, Expr]:
        """Bound names, and those of the entries of matrices, as derived."""
        found: dict[str, Expr] = {}
        for name, held in self.objects(it):
            if held.shape is None:
                found[name] = _meant(name, held, it, self)
                continue
            for place in held.index:
                i, j = divmod(place, held.shape[1])
                found[entry_name(name, held.shape, i, j)] = held.entries[place]
        return found


_FORMS: dict[tuple[str, str], dict[str, Derivation]] = {}


def forms_of(model: PageModel) -> dict[str, Derivation]:
    """A page in both forms, kept for the next paper."""
    key = model.name, model.digest
    if key not in _FORMS:
        both = ("units", "scaled")
        _FORMS[key] = {form: derivation(model.page, model.mechanics, form) for form in both}
    return _FORMS[key]


def begun(paper: Paper, forms: Mapping[str, Derivation]) -> Book:
    """The names that a paper lists; of an object by the words for it, as "damping", they are bound
    to it.
    """
    renamed, letters, bound = dict(paper.renamed), dict[str, str](), dict[str, Statement]()
    for text, meaning in paper.renamed.items():
        is_own = any(meaning in it.names for it in forms.values())
        if meaning.split(" ")[0] in (*MATRICES, "energy") and not is_own:
            renamed[text] = re.sub(r"\W+", "_", meaning)
            bound[renamed[text]] = Statement(meaning, meaning, "", is_latex=False)
        if renamed[text].isidentifier():
            letters[renamed[text]] = text
    it = forms["units"]
    for row in zip(it.model.coordinates, it.model.rates, it.accelerations, strict=True):
        name, rate, second = map(str, row)
        if letter := letters.get(name):
            dotted = {rate: rf"\dot{{{letter}}}", second: rf"\ddot{{{letter}}}"}
            letters = dotted | letters
    return Book(forms, renamed, bound, letters=letters)


def bind(statement: Statement, book: Book) -> None:
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
    named = by_name(equation).left
    name = named.value
    if named.kind == "symbol" and held.is_value and name not in known:
        book.bound[name] = statement
        letter = left.strip()
        if named is not equation.left:
            letter = left[named.at[0] : named.at[1]]
        if statement.is_latex:
            print_name(name, letter, statement, it, book)
        for i, j in itertools.product(*map(range, held.shape or (0, 0))):
            entry = entry_name(name, held.shape or (0, 0), i, j)
            whole = f"({letter})" if "_" in letter else letter
            book.letters[entry] = f"{whole}_{{{entry.rpartition('_')[2]}}}"


def by_name(equation: Equation) -> Equation:
    """The value of a name of which a multiple is printed, as in 2 T = m v²."""
    left, right = equation.left, equation.right
    if left.kind == "neg" and left.args[0].kind == "symbol":
        return replace(equation, left=left.args[0], right=minus(right))
    if left.kind == "mul" and [it.kind for it in left.args] == ["number", "symbol"]:
        value = Node("div", (right, left.args[0]), at=right.at)
        return replace(equation, left=left.args[1], right=value)
    return equation


def print_name(name: str, left: str, statement: Statement, it: Derivation, book: Book) -> None:
    """Keep how a name is printed, and the argument with which it is, as in f(x) = …."""
    left = re.sub(r"\\(?:left|right)(?=[()])|\\[,;:!]", "", left).strip()
    book.letters[name] = left
    if with_argument := re.fullmatch(r"([^()]*)\((.*)\)", left):
        book.letters[name] = with_argument[1]
        with suppress(Unread):  # several arguments are not kept
            argument = equations_of(with_argument[2], statement, it, book)[0].left
            book.arguments[name] = argument


def equations_of(
    text: str, statement: Statement, it: Derivation, book: Book, *, matrices: bool = True
) -> list[Equation]:
    """Equations of a text in the language of a statement, with the names of its paper."""
    vocabulary = _vocabulary(statement, it, book, matrices)
    if statement.is_latex and not statement.transcribed:
        from .latex import read_latex

        is_scale = statement.word == "scale"
        for sign in (r"\to",) * is_scale + (r"\approx", r"\simeq") * bool(statement.limit):
            text = text.replace(sign, f"{'=':^{len(sign)}}")
        found = read_latex(text, vocabulary)
    else:
        found = read_sympy(text, vocabulary)
    if "frequency" in it.names or not vocabulary.has_roots:
        return found
    return [replace(it, left=_in_lambda(it.left), right=_in_lambda(it.right)) for it in found]


def _vocabulary(statement: Statement, it: Derivation, book: Book, matrices: bool) -> Vocabulary:
    """Names that may stand in a statement."""
    objects = book.objects(it) if matrices else ()
    shapes = {name: held.shape for name, held in objects if held.shape is not None}
    values = _expressions(it, book)
    given = book.defined.keys() | book.shapes.keys() | book.bound.keys() | values.keys()
    has_roots = statement.word == "characteristic"
    names = {*it.names, *given, *(["frequency"] if has_roots else [])}
    names -= {str(TIME)} if statement.word != "scale" else set()
    return Vocabulary(
        frozenset(names),
        tuple(map(str, it.model.coordinates)),
        book.renamed,
        shapes | book.shapes,
        frozenset(map(str, (*it.normals, *it.coefficients))),
        frozenset(name for name, value in values.items() if _is_fixed(value, it)),
        has_roots,
        _arguments(statement, it, book, values),
        partial(_slope, it, book),
    )


def _is_ambiguous(statement: Statement, it: Derivation) -> bool:
    """Whether a name is bound by words alone to an object that may mean several values."""
    return not statement.text and bool(derived(it, statement.about).readings)


def _slope(it: Derivation, book: Book, of: str, by: str) -> str:
    """The name of a derivative, which is kept; beside one by a coordinate or a rate those by the
    others, one of which may be meant where a print is wrong.
    """
    own = Slope(of, by)
    if not by and own.law({*map(str, it.coefficients)}) is None:
        argument = book.arguments.get(function_behind(of, book.arguments) or "")
        if argument is None or argument.kind != "symbol":
            raise Unread(f"the derivative of {of}, which is printed as no function; say by what")
        own = Slope(of, argument.value)
    if of in book.bound and _is_ambiguous(book.bound[of], it):
        raise Unread(
            f"{of} may count the potential of a constant force or leave it out; print it in a "
            f"statement about {book.bound[of].about}"
        )
    rows = [[*map(str, row)] for row in (it.model.coordinates, it.model.rates)]
    added, letters = dict[str, Slope](), it.letters
    for each in next((row for row in rows if own.by in row), [own.by]):
        one = Slope(of, each)
        added[one.name] = one
        letter, by_letter = (book.letters.get(name, letters.get(name, name)) for name in (of, each))
        book.letters[one.name] = one.latex(letter, by_letter if by else "")
    values = _expressions(it, book, added)
    if of not in values:
        raise Unread(f"the derivative of {of}, which is no name that is known")
    if own.name not in values:
        of_value(values[of], own.by, it)  # which says why
    book.slopes.update(added)
    return own.name


def _is_fixed(value: Expr, it: Derivation) -> bool:
    """Whether a value is constant in time, a parameter or made of these; lengths of lines, phases
    and names that the page has not are none.
    """
    return {str(symbol) for symbol in value.free_symbols} <= it.parameters.keys()


def in_order(trees: Mapping[str, Node], known: Collection[str]) -> Iterator[tuple[str, Node]]:
    """Those of definitions that stand on known names and on each other, each after these."""
    pending, found = dict(trees), {*known}
    while ready := [name for name, tree in pending.items() if symbols(tree) <= found]:
        found |= {*ready}
        yield from ((name, pending.pop(name)) for name in ready)


def _arguments(
    statement: Statement, it: Derivation, book: Book, names: Mapping[str, Expr]
) -> dict[str, Callable[[Node], Argument | None]]:
    """Of names that are printed as functions, what an expression is to them: the argument with
    which a definition is printed, or of a friction coefficient the sliding speed.
    """
    is_moving = statement.word in (*MOVING, "friction", "definition")
    still = dict.fromkeys(it.model.rates, 0)

    def as_printed(argument: Node, inside: Node) -> Argument | None:
        return Argument() if printed(inside) == printed(argument) else None

    def as_speed(speed: Expr, is_odd: bool, inside: Node) -> Argument | None:
        value = to_sympy(inside, names) if symbols(inside) <= names.keys() else sp.nan
        for sign in (1, -1) if is_odd else (1,):
            for at_rest in (False, True):
                meant = speed.subs(still) if at_rest else speed
                if sp.expand(value - sign * meant) == 0:
                    return Argument(sign, at_rest and is_moving)
        return None

    found: dict[str, Callable[[Node], Argument | None]] = {}
    for symbol, speed, friction in zip(
        it.coefficients, it.speeds, it.model.frictions, strict=False
    ):
        is_odd = sp.expand(friction.ahead + friction.behind) == 0
        found[str(symbol)] = partial(as_speed, speed, is_odd)
    return found | {name: partial(as_printed, one) for name, one in book.arguments.items()}


def _expressions(
    it: Derivation, book: Book, more: Mapping[str, Slope] | None = None
) -> dict[str, Expr]:
    """What names of the page, of objects, definitions and derivatives are, in names of the page."""
    known = {**it.names, **book.values(it)}
    return expressions(known, book.defined, {**book.slopes, **(more or {})}, it)


def _in_lambda(tree: Node) -> Node:
    """Even powers of a frequency ω in those of λ = iω."""
    base, power = tree.args if tree.kind == "pow" else (tree, Node("number", value="1"))
    if base.kind == "symbol" and base.value == "frequency":
        if not (power.value.isdigit() and int(power.value) % 2 == 0):
            raise Unread("of a frequency only even powers are read", tree.at[0])
        same = replace(tree, args=(replace(base, value=str(LAMBDA)), power))
        return Node("neg", (same,), at=tree.at) if int(power.value) % 4 else same
    return replace(tree, args=tuple(map(_in_lambda, tree.args)))


def _meant(name: str, held: Object, it: Derivation, book: Book) -> Expr:
    """The value that a name is bound to; of those that it may mean the one that is printed."""
    key = it.form, name
    if key not in book.meant:
        book.meant[key] = held.entries[held.index[0]]
        statement = book.bound[name]
        if held.readings and statement.text:
            with suppress(Unread, NoObject, KeyError):
                *_, equation = equations_of(statement.judged, statement, it, book)
                equation = by_name(equation)
                # By its names, since a print may count its coordinates in another way.
                own = to_sympy(equation.right, _expressions(it, book)).free_symbols
                book.meant[key] = min(
                    (reading.entry for reading in held.readings),
                    key=lambda entry: len(own ^ entry.free_symbols),
                )
    return book.meant[key]


def _used(equations: Iterable[Equation], book: Book) -> set[str]:
    """Names in equations, and in the definitions of these."""
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
    held: Object,
    values: dict[str, Values],
    it: Derivation,
    book: Book,
) -> tuple[dict[str, Expr], dict[str, Node]]:
    """What names of objects and of definitions in equations are; of the first the values are added
    to those at samples.
    """
    objects = book.values(it)
    whole = expressions({**it.names, **objects}, book.defined, book.slopes, it, steady=held.steady)
    names = (objects.keys() | book.slopes.keys()) & whole.keys()
    stems = {stem(name) for name in _used(equations, book) & names}
    bound = {name: whole[name] for name in sorted(names) if stem(name) in stems}
    for name, value in bound.items():
        values[name] = numeric(value, values)
    # Not those in names that this form lacks.
    return bound, dict(in_order(book.defined, values))


def with_defined(values: Mapping[str, Values], defined: Mapping[str, Node]) -> dict[str, Values]:
    """Values of the names of definitions beside those that they stand on."""
    found = dict(values)
    for name, tree in defined.items():
        found[name] = evaluated(tree, found)
    return found
