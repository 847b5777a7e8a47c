"""Syntax trees of printed equations, and their reading from SymPy's syntax.

A tree keeps the arrangement of the print: nothing is evaluated, sorted or merged. It is written
back as SymPy's syntax or LaTeX, and turned into a SymPy expression by :func:`to_sympy`.
"""

from __future__ import annotations

import ast
import functools
import itertools
import math
import operator
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp
from sympy import Expr, S


@dataclass(frozen=True)
class Node:
    """A node of a syntax tree.

    ``kind`` is "number", "symbol", "neg", "add", "mul", "div", "pow" or "call". ``value`` is the
    text of a number, the name of a symbol or the name of a called function. ``at`` is the range of
    characters in the print, (0, 0) if the node was not printed.
    """

    kind: str
    args: tuple[Node, ...] = ()
    value: str = ""
    at: tuple[int, int] = (0, 0)

    @property
    def operation(self) -> str:
        """The name of the called function, or the kind of any other node."""
        return self.value if self.kind == "call" else self.kind


@dataclass(frozen=True)
class Equation:
    """A printed equation. An expression without "=" has the number 0 as its right side.

    ``conditions`` are the relations printed beside it, each a relation or an "And" of several.
    """

    left: Node
    right: Node
    conditions: tuple[Node, ...] = ()


@dataclass(frozen=True)
class Argument:
    """How a printed argument agrees with the argument that a function is known to have.

    ``sign`` is -1 if the print has minus that argument, which is accepted of odd functions.
    ``at_rest`` says that a friction law is printed with the sliding speed of a body at rest, in an
    equation of motion.
    """

    sign: int = 1
    at_rest: bool = False


@dataclass(frozen=True)
class Vocabulary:
    """Names that may be printed in a statement, and what is known of them."""

    symbols: frozenset[str]
    coordinates: tuple[str, ...]
    renamed: Mapping[str, str]
    #: rows and columns of the names that stand for matrices
    matrices: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    #: names of laws: a bracket behind one may be its argument and not a factor
    laws: frozenset[str] = frozenset()
    #: names that are constant in time; None: all except coordinates, their rates and laws
    fixed: frozenset[str] | None = None
    #: whether an equation is about all roots of a polynomial, so that ± stands for two of them
    has_roots: bool = False
    #: whether a new name may stand in a product on the left, to which a value is given
    gives_names: bool = False
    #: for a friction law of another argument than the sliding speed: that speed over the argument
    scales: Mapping[str, str] = field(default_factory=dict)
    #: for each name that is printed as a function: its argument, if the expression in brackets is
    #: that argument, else None
    arguments: Mapping[str, Callable[[Node], Argument | None]] = field(default_factory=dict)
    #: gives the name of a derivative from the name that is differentiated and the variable; an
    #: empty variable stands for the argument of a function
    derivative: Callable[[str, str], str] | None = None
    #: without a page, where every name is known: those with dots, which are added as they are read
    dotted: set[str] | None = None
    #: for each name that is defined as a coordinate, a rate or a column of these: which
    states: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    #: whether a name with a star on the left is one of its own, and not that of an equilibrium
    is_definition: bool = False


class Unread(ValueError):
    """A print that can't be read or is ambiguous: the reason, the offset in the print, and the
    possible readings.
    """

    def __init__(self, reason: str, place: int = 0, readings: tuple[str, ...] = ()) -> None:
        super().__init__(reason)
        self.reason, self.place, self.readings = reason, place, readings


def printed(node: Node) -> str:
    """Text of a tree in SymPy's syntax."""

    def inside(part: Node, above: int) -> str:
        text = printed(part)
        strength = {"add": 1, "neg": 1, "mul": 2, "div": 2, "pow": 3}
        return f"({text})" if strength.get(part.kind, 9) < above else text

    match node.kind:
        case "number" | "symbol":
            return node.value
        case "call":
            return f"{node.value}({', '.join(map(printed, node.args))})"
        case "neg":
            return f"-{inside(node.args[0], 2)}"
        case "add":
            text = printed(node.args[0])
            for part in node.args[1:]:
                is_minus = part.kind == "neg"
                text += f" - {inside(part.args[0], 2)}" if is_minus else f" + {printed(part)}"
            return text
        case "mul":
            return "*".join([inside(node.args[0], 2), *(inside(it, 3) for it in node.args[1:])])
        case "div":
            return f"{inside(node.args[0], 2)}/{inside(node.args[1], 3)}"
        case _:
            return f"{inside(node.args[0], 4)}**{inside(node.args[1], 4)}"


#: Functions that a print may hold, by SymPy's names.
FUNCTIONS: dict[str, Callable[..., Expr]] = {
    **{it.__name__: it for it in (sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc, sp.exp, sp.log)},
    **{it.__name__: it for it in (sp.sinh, sp.cosh, sp.tanh, sp.asinh, sp.acosh, sp.atanh)},
    **{it.__name__: it for it in (sp.sqrt, sp.asin, sp.acos, sp.atan, sp.Abs, sp.sign)},
    # Written with Abs and sign, whose values are known on each side of a contact.
    "Heaviside": lambda u: (1 + sp.sign(u)) / 2,
    "max": lambda *values: functools.reduce(lambda a, b: (a + b + sp.Abs(a - b)) / 2, values),
    "min": lambda *values: functools.reduce(lambda a, b: (a + b - sp.Abs(a - b)) / 2, values),
    "atan2": sp.atan2,
}
#: Functions of two arguments or more.
OF_SEVERAL = ("max", "min", "atan2")
#: Relations in the conditions of a choice.
RELATIONS = {name: getattr(sp, name) for name in ("Lt", "Le", "Gt", "Ge", "Ne", "Eq")}
ZERO, ONE, TWO = (Node("number", value=digit) for digit in "012")


def leaf(name: str, at: tuple[int, int] = (0, 0)) -> Node:
    """A name in a tree."""
    return Node("symbol", value=name, at=at)


def minus(tree: Node) -> Node:
    """The negative of a tree, at the same place in the print."""
    return Node("neg", (tree,), at=tree.at)


def joined(kind: str, parts: Sequence[Node], at: tuple[int, int] = (0, 0)) -> Node:
    """A sum or a product of the parts; the part itself if there is only one."""
    return Node(kind, tuple(parts), at=at) if len(parts) > 1 else parts[0]


def as_printed(known: str, inside: Node) -> Argument | None:
    """The argument of a function that is known with it in SymPy's syntax; None for another one."""
    return Argument() if printed(inside) == known else None


def undone(tree: Node, other: Node, has: Callable[[Node], bool]) -> tuple[Node, Node] | None:
    """Both sides of tree = other with the outermost operation of the tree on the other side; None
    where more than one of its parts has what is to stand alone, or it can't be undone.
    """
    inside = [it for it in tree.args if has(it)]
    others = [it for it in tree.args if not has(it)]
    if len(inside) != 1:
        return None
    match tree.kind:
        case "add":
            return inside[0], Node("add", (other, *map(minus, others)), at=tree.at)
        case "neg":
            return inside[0], minus(other)
        case "mul":
            return inside[0], Node("div", (other, joined("mul", others, tree.at)), at=other.at)
        case "div" if inside == [tree.args[0]]:
            return inside[0], Node("mul", (other, *others), at=other.at)
        case "pow" if inside == [tree.args[0]] and others[0] == replace(TWO, at=others[0].at):
            return inside[0], Node("call", (other,), "sqrt", other.at)
        case "call" if tree.value == "sqrt":
            return inside[0], Node("pow", (other, TWO), at=other.at)
    return None


def power(base: Node, exponent: Node, at: tuple[int, int]) -> Node:
    """A power.

    Raises
    ------
    Unread
        If its exponent is so high that exact algebra would take minutes, that of a power of a power
        as well.
    """
    is_sum = any(it.kind == "add" for it in nodes(base))
    highest = 8 if is_sum else 100  # an expanded sum has very many terms
    size = S.Zero if symbols(exponent) else abs(to_sympy(exponent, {}))
    whole = size * max(1, _highest_power(base))
    if not (size.is_finite and max(size, whole) <= highest):
        raise Unread(f"a power higher than {highest} is not read", at[0])
    return Node("pow", (base, exponent), at=at)


def _highest_power(tree: Node) -> Expr:
    """The highest power in a tree, of powers of powers the product."""
    inside = max(map(_highest_power, tree.args), default=S.One)
    if tree.kind != "pow" or symbols(tree.args[1]):
        return inside
    return max(S.One, _highest_power(tree.args[0]) * abs(to_sympy(tree.args[1], {})))


def as_number(text: str, at: tuple[int, int]) -> Node:
    """A printed number.

    Raises
    ------
    Unread
        If it has very many digits, or is none of double precision.
    """
    most_digits, value = 400, float(text)
    is_lost = value == 0 and bool(text.lower().partition("e")[0].strip("0."))
    if len(text) > most_digits or not math.isfinite(value) or is_lost:
        shown = text if len(text) < 20 else f"{text[:8]}…, of {len(text)} digits,"
        raise Unread(f"too large: the number {shown} is none of double precision", at[0])
    return Node("number", value=text, at=at)


def number_of(tree: Node) -> float:
    """The value of a number node, which may be pi."""
    return math.pi if tree.value == "pi" else float(tree.value)


def residual(equation: Equation) -> Node:
    """Left side minus right side."""
    return Node("add", (equation.left, minus(equation.right)))


def nodes(tree: Node) -> Iterator[Node]:
    """Every part of a tree, the tree itself first."""
    yield tree
    for part in tree.args:
        yield from nodes(part)


def symbols(tree: Node) -> frozenset[str]:
    """Names of the quantities in a tree."""
    return frozenset(node.value for node in nodes(tree) if node.kind == "symbol")


def with_part(tree: Node, path: tuple[int, ...], part: Node) -> Node:
    """The tree with one node replaced; ``path`` holds the indices of arguments that lead to it."""
    if not path:
        return part
    args = list(tree.args)
    args[path[0]] = with_part(args[path[0]], path[1:], part)
    return replace(tree, args=tuple(args))


def renamed(tree: Node, names: Mapping[str, Node]) -> Node:
    """The tree with symbols replaced simultaneously."""
    if tree.kind == "symbol":
        return names.get(tree.value, tree)
    return replace(tree, args=tuple(renamed(part, names) for part in tree.args))


def tidied(tree: Node) -> Node:
    """A tree without what an edit leaves behind: terms and powers 0, factors and powers 1, -(-a),
    -(a - b), 1/(1/a) and 2/2.
    """
    args = [tidied(it) for it in tree.args]
    values = [it.value for it in args]  # "0" and "1" are those of numbers alone
    match tree.kind:
        case "add":
            rest = _spread("add", [it for it in args if it.value != "0"])
            return joined("add", _without_opposites(rest) or [ZERO], tree.at)
        case "mul":
            rest = [it for it in args if it.value != "1"] or [ONE]
            return ZERO if "0" in values else joined("mul", _spread("mul", rest), tree.at)
        case "neg" if args[0].kind == "neg":
            return args[0].args[0]
        case "neg" if values == ["0"]:
            return ZERO
        case "div" if values[1] == "1" or values[0] == "0":
            return args[0]
        case "div" if args[0].kind == args[1].kind == "number" and values[0] == values[1]:
            return ONE
        case "pow" if values[1] in ("0", "1"):
            return args[0] if values[1] == "1" else ONE
        case "pow" if printed(args[1]) == "-1":
            above, below = args[0].args if args[0].kind == "div" else (args[0], ONE)
            return tidied(Node("div", (below, above), at=tree.at))
    return replace(tree, args=tuple(args))


def _without_opposites(terms: Sequence[Node]) -> list[Node]:
    """The terms without pairs of one and its negative."""
    rest = list[Node]()
    for term in terms:
        opposite = printed(term.args[0] if term.kind == "neg" else minus(term))
        place = next((n for n, it in enumerate(rest) if printed(it) == opposite), None)
        if place is None:
            rest.append(term)
        else:
            del rest[place]
    return rest


def _spread(kind: str, parts: Sequence[Node]) -> list[Node]:
    """Parts of an operation, with those of the same operation among them."""
    return [it for part in parts for it in (part.args if part.kind == kind else (part,))]


def to_sympy(tree: Node, names: Mapping[str, Expr], evaluate: bool = True) -> Expr:
    """The SymPy expression of a tree; ``names`` gives the expression of each symbol."""
    if tree.kind == "symbol":
        return names[tree.value]
    if tree.kind == "number":
        return sp.pi if tree.value == "pi" else sp.Rational(tree.value)
    parts = [to_sympy(part, names, evaluate) for part in tree.args]
    operations = {
        "add": sp.Add,
        "neg": operator.neg,
        "mul": sp.Mul,
        "div": operator.truediv,
        "pow": operator.pow,
        "Piecewise": lambda *pairs: sp.Piecewise(*(pair.args for pair in pairs)),
        "Tuple": sp.Tuple,
        "And": sp.And,
    }
    with sp.evaluate(evaluate):
        return (operations | FUNCTIONS | RELATIONS)[tree.operation](*parts)


def read_sympy(text: str, vocabulary: Vocabulary) -> list[Equation]:
    """Parse equations in Python's syntax, separated by semicolons; nothing is run.

    Each equation is ``left = right``, or an expression that is 0.

    Raises
    ------
    Unread
        If a part is not an expression in known names, with its offset.
    """
    equations, begin = [], 0
    for part in text.split(";"):
        equations += _read_one(part, begin, vocabulary)
        begin += len(part) + 1
    return equations


def _read_one(text: str, begin: int, vocabulary: Vocabulary) -> list[Equation]:
    """Equations of a text without semicolons, which begins at an offset of the whole text."""
    sides = text.split("=")
    trees: list[Node] = []
    for side in sides:
        space = len(side) - len(side.lstrip())
        if not trees and len(sides) > 1 and side.strip().isidentifier():
            at = (begin + space, begin + space + len(side.strip()))
            trees.append(leaf(side.strip(), at))
            begin += len(side) + 1
            continue
        for it in re.finditer(r"(?<![\w.])(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", side):
            as_number(it[0], (begin + it.start(), begin + it.end()))
        try:
            parsed = ast.parse(side.strip(), mode="eval").body
        except (SyntaxError, ValueError, RecursionError) as error:
            place = begin + space + (getattr(error, "offset", None) or 1) - 1
            raise Unread("this is no expression in SymPy's syntax", place) from error
        trees.append(_tree(parsed, begin + space, vocabulary))
        begin += len(side) + 1
    if len(trees) == 1:
        return [Equation(trees[0], ZERO)]
    return [Equation(left, right) for left, right in itertools.pairwise(trees)]


def _tree(part: ast.expr, begin: int, vocabulary: Vocabulary) -> Node:
    """The tree of a parsed Python expression whose text begins at an offset."""
    at = (begin + part.col_offset, begin + (part.end_col_offset or 0))
    binary: dict[type[ast.operator], str] = {
        ast.Add: "add",
        ast.Sub: "add",
        ast.Mult: "mul",
        ast.Div: "div",
        ast.Pow: "pow",
    }
    match part:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            return Node("number", value=str(value), at=at)
        case ast.Name(id=name):
            if name in vocabulary.symbols:
                return leaf(name, at)
            if name == "pi":
                return Node("number", value=name, at=at)
            known = ", ".join(sorted(vocabulary.symbols))
            raise Unread(f"{name} is no name of the page; known are {known}", at[0])
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return Node("neg", (_tree(inner, begin, vocabulary),), at=at)
        case ast.UnaryOp(op=ast.UAdd(), operand=inner):
            return _tree(inner, begin, vocabulary)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in binary:
            kind = binary[type(op)]
            one, other = (_tree(side, begin, vocabulary) for side in (left, right))
            if kind in ("mul", "div") and one.kind == "neg":  # -a b is -(a b)
                return Node("neg", (_flattened(kind, one.args[0], other, at),), at=at)
            if isinstance(op, ast.Pow):
                return power(one, other, at)
            if isinstance(op, ast.Sub):
                other = minus(other)
            return _flattened(kind, one, other, at)
        case ast.Call(
            func=ast.Name(id="diff" | "at_rest" as word), args=[inner, *more], keywords=[]
        ) if len(more) <= (word == "diff"):
            if (name := ast.unparse(part)) in vocabulary.symbols:
                return leaf(name, at)
            if vocabulary.derivative is None:
                raise Unread(f"{name} is no name that is known", at[0])
            # The variable is kept as text: it may be the time t, which is no name of an equation.
            by = "".join(map(ast.unparse, more)) if word == "diff" else "at rest"
            differentiated = printed(_tree(inner, begin, vocabulary))
            return leaf(vocabulary.derivative(differentiated, by), at)
        case ast.Call(func=ast.Name(id=name), args=[_, *more] as arguments, keywords=[]) if (
            name in FUNCTIONS
            and bool(more) is (name in OF_SEVERAL)
            and (name != "atan2" or len(more) == 1)
        ):
            return Node("call", tuple(_tree(it, begin, vocabulary) for it in arguments), name, at)
        case _:
            known = ", ".join(it for it in FUNCTIONS if it not in OF_SEVERAL)
            several = " and ".join(OF_SEVERAL)
            raise Unread(
                f"only + - * / **, one of {known} of one argument, and {several} of several are "
                "read",
                at[0],
            )


def _flattened(kind: str, one: Node, other: Node, at: tuple[int, int]) -> Node:
    """An operation on two nodes; a sum of a sum, or a product of a product, is one node."""
    parts = one.args if kind in ("add", "mul") and one.kind == kind else (one,)
    return Node(kind, (*parts, other), at=at)


def to_latex(tree: Node, letters: Mapping[str, str]) -> str:
    """LaTeX of a tree in the page's letters, in the arrangement of the print."""
    names = {name: sp.Symbol(name) for name in symbols(tree)}
    shown = {names[name]: letter for name, letter in letters.items() if name in names}
    return str(sp.latex(to_sympy(tree, names, evaluate=False), symbol_names=shown, order="none"))
