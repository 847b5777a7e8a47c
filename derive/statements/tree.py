"""A printed expression as it stands: nothing is evaluated, sorted or merged."""

from __future__ import annotations

import ast
import functools
import itertools
import math
import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp
from sympy import Expr


@dataclass(frozen=True)
class Node:
    """Part of a printed expression as it stands: nothing is evaluated, sorted or merged."""

    kind: str
    args: tuple[Node, ...] = ()
    value: str = ""
    at: tuple[int, int] = (0, 0)

    @property
    def operation(self) -> str:
        """The name of a function, or the kind of another operation."""
        return self.value if self.kind == "call" else self.kind


@dataclass(frozen=True)
class Equation:
    """Two sides; the right one is the number 0 where the print is an expression that is 0. Where
    it is printed with conditions, these are relations or several of them.
    """

    left: Node
    right: Node
    conditions: tuple[Node, ...] = ()


@dataclass(frozen=True)
class Argument:
    """The argument of a function, or minus that of an odd one; of a friction law in an equation
    that is about a motion it may be the sliding speed at rest.
    """

    sign: int = 1
    at_rest: bool = False


@dataclass(frozen=True)
class Vocabulary:
    """Names that may stand in a statement."""

    symbols: frozenset[str]
    coordinates: tuple[str, ...]
    renamed: Mapping[str, str]
    #: rows and columns of the names that stand for matrices
    matrices: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    #: names of laws: what stands in brackets behind them may be their argument
    laws: frozenset[str] = frozenset()
    #: names that are constant in time; where it is left out, all but coordinates, rates and laws
    fixed: frozenset[str] | None = None
    #: whether an equation is about all roots of a polynomial, so that ± stands for two of them
    has_roots: bool = False
    #: names that are printed as functions: what an expression in brackets is to them
    arguments: Mapping[str, Callable[[Node], Argument | None]] = field(default_factory=dict)
    #: the name of a derivative, by the names of what is derived and by what; by the argument of a
    #: function where the second is empty
    derivative: Callable[[str, str], str] | None = None


class Unread(ValueError):
    """A print that can't be read, or in two ways: reason, place (offset), readings."""

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
    # In sizes and signs, of which it is known what they are on a side of a contact.
    "Heaviside": lambda u: (1 + sp.sign(u)) / 2,
    "max": lambda *values: functools.reduce(lambda a, b: (a + b + sp.Abs(a - b)) / 2, values),
    "min": lambda *values: functools.reduce(lambda a, b: (a + b - sp.Abs(a - b)) / 2, values),
}
#: Functions of two arguments or more.
OF_SEVERAL = ("max", "min")
#: Relations in the conditions of a choice.
RELATIONS = {name: getattr(sp, name) for name in ("Lt", "Le", "Gt", "Ge", "Ne", "Eq")}
ZERO, ONE = Node("number", value="0"), Node("number", value="1")


def leaf(name: str, at: tuple[int, int] = (0, 0)) -> Node:
    """A name in a tree."""
    return Node("symbol", value=name, at=at)


def minus(tree: Node) -> Node:
    """A tree with the other sign, at its place."""
    return Node("neg", (tree,), at=tree.at)


def joined(kind: str, parts: Sequence[Node], at: tuple[int, int] = (0, 0)) -> Node:
    """A sum or a product; of one part itself."""
    return Node(kind, tuple(parts), at=at) if len(parts) > 1 else parts[0]


def number_of(tree: Node) -> float:
    """The value of a number, and of pi."""
    return math.pi if tree.value == "pi" else float(tree.value)


def residual(equation: Equation) -> Node:
    """What is 0 where an equation holds: its left side less its right one."""
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
    """The tree with another part at a path of places among arguments."""
    if not path:
        return part
    args = list(tree.args)
    args[path[0]] = with_part(args[path[0]], path[1:], part)
    return replace(tree, args=tuple(args))


def renamed(tree: Node, names: Mapping[str, Node]) -> Node:
    """The tree with symbols replaced, all at once."""
    if tree.kind == "symbol":
        return names.get(tree.value, tree)
    return replace(tree, args=tuple(renamed(part, names) for part in tree.args))


def to_sympy(tree: Node, names: Mapping[str, Expr], evaluate: bool = True) -> Expr:
    """The expression of a tree, with what its symbols stand for."""
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
    """Equations in Python's syntax, between semicolons; nothing is run.

    Each is ``left = right``, or an expression that is 0.

    Raises
    ------
    Unread
        Where the text is no expression of known names, with the place.
    """
    equations, begin = [], 0
    for part in text.split(";"):
        equations += _read_one(part, begin, vocabulary)
        begin += len(part) + 1
    return equations


def _read_one(text: str, begin: int, vocabulary: Vocabulary) -> list[Equation]:
    sides = text.split("=")
    trees: list[Node] = []
    for side in sides:
        space = len(side) - len(side.lstrip())
        if not trees and len(sides) > 1 and side.strip().isidentifier():
            at = (begin + space, begin + space + len(side.strip()))
            trees.append(leaf(side.strip(), at))
            begin += len(side) + 1
            continue
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
                return Node("neg", (_longer(kind, one.args[0], other, at),), at=at)
            if isinstance(op, ast.Sub):
                other = minus(other)
            return _longer(kind, one, other, at)
        case ast.Call(
            func=ast.Name(id="diff" | "at_rest" as word), args=[inner, *more], keywords=[]
        ) if len(more) <= (word == "diff"):
            if (name := ast.unparse(part)) in vocabulary.symbols:
                return leaf(name, at)
            if vocabulary.derivative is None:
                raise Unread(f"{name} is no name that is known", at[0])
            # By t, the time, which is no name in an equation.
            by = "".join(map(ast.unparse, more)) if word == "diff" else "at rest"
            own = vocabulary.derivative(printed(_tree(inner, begin, vocabulary)), by)
            return leaf(own, at)
        case ast.Call(func=ast.Name(id=name), args=[_, *more] as arguments, keywords=[]) if (
            name in FUNCTIONS and bool(more) is (name in OF_SEVERAL)
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


def _longer(kind: str, one: Node, other: Node, at: tuple[int, int]) -> Node:
    parts = one.args if kind in ("add", "mul") and one.kind == kind else (one,)
    return Node(kind, (*parts, other), at=at)


def to_latex(tree: Node, letters: Mapping[str, str]) -> str:
    """LaTeX of a tree in the page's letters, in the arrangement of the print."""
    names = {name: sp.Symbol(name) for name in symbols(tree)}
    shown = {names[name]: letter for name, letter in letters.items() if name in names}
    return str(sp.latex(to_sympy(tree, names, evaluate=False), symbol_names=shown, order="none"))
