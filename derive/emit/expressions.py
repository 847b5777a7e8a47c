"""Printer of the kernel's expressions in a target's syntax, with the brackets that are needed."""

import ast
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from enum import IntEnum, auto

from .language import ROUGH, KernelError, Routine, Source


class Strength(IntEnum):
    """Precedence of printed expressions, the weakest first: an operand of weaker precedence than
    its operation is put into brackets.
    """

    CHOICE = auto()
    OR = auto()
    AND = auto()
    COMPARE = auto()
    SUM = auto()
    PRODUCT = auto()
    UNARY = auto()
    ATOM = auto()


@dataclass(frozen=True)
class Syntax:
    """What differs between the syntaxes of targets."""

    #: Names of the functions for the language's primitives. Without one for ``where`` a choice is
    #: ``c ? a : b``.
    primitives: Mapping[str, str]
    #: Operators for ``&``, ``|`` and ``~``.
    logic: Mapping[type[ast.operator] | type[ast.unaryop], str]
    algebra: Callable[[str], str]  #: how a generated function is called
    routine: Callable[[str], str] = str  #: how a function of the kernel is called
    #: Other operators for arithmetic and comparisons, as ``.*`` for arrays.
    signs: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Expressions:
    """Printer of a kernel's expressions."""

    source: Source
    syntax: Syntax

    def print(self, node: ast.expr, least: int = Strength.CHOICE) -> str:
        """The text of an expression, in brackets if its precedence is below ``least``."""
        text, strength = self._expression(node)
        return f"({text})" if strength < least else text

    def listed(self, nodes: list[ast.expr]) -> str:
        """Arguments, separated by commas."""
        return ", ".join(self.print(node) for node in nodes)

    def _expression(self, node: ast.expr) -> tuple[str, int]:
        match node:
            case ast.Constant(value=float() as value):
                return number(value), Strength.ATOM
            case ast.Name(id=name):
                return name, Strength.ATOM
            case ast.Attribute(value=value, attr=attribute):
                return f"{self.print(value, Strength.ATOM)}.{attribute}", Strength.ATOM
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return f"-{self.print(operand, Strength.UNARY)}", Strength.UNARY
            case ast.UnaryOp(op=ast.Invert(), operand=operand):
                return (
                    f"{self.syntax.logic[ast.Invert]}{self.print(operand, Strength.UNARY)}",
                    Strength.UNARY,
                )
            case ast.BinOp(left=left, op=op, right=right):
                return self._binary(left, op, right)
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                comparisons = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "=="}
                sign = comparisons[type(op)]
                return (
                    f"{self.print(left, Strength.SUM)} {self.syntax.signs.get(sign, sign)} "
                    f"{self.print(right, Strength.SUM)}",
                    Strength.COMPARE,
                )
            case ast.Call(func=ast.Name(id="where" as name), args=[condition, yes, no]) if (
                name not in self.syntax.primitives
            ):
                return (
                    f"{self.print(condition, Strength.COMPARE)} ? {self.print(yes, Strength.OR)} : "
                    f"{self.print(no, Strength.OR)}",
                    Strength.CHOICE,
                )
            case ast.Call(func=ast.Name(id=name), args=[argument]) if name == ROUGH:
                return self._expression(argument)
            case ast.Call(func=ast.Name(id=name), args=args):
                return f"{self.called(name)}({self.listed(args)})", Strength.ATOM
        raise KernelError(
            f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language"
        )

    def called(self, name: str) -> str:
        """The name by which a primitive, a routine or a generated function is called."""
        if name in self.syntax.primitives:
            return self.syntax.primitives[name]
        if name in self.source.routines:
            return self.syntax.routine(name)
        return self.syntax.algebra(name)

    def _binary(self, left: ast.expr, op: ast.operator, right: ast.expr) -> tuple[str, int]:
        strengths = {
            ast.BitOr: Strength.OR,
            ast.BitAnd: Strength.AND,
            ast.Add: Strength.SUM,
            ast.Sub: Strength.SUM,
            ast.Mult: Strength.PRODUCT,
            ast.Div: Strength.PRODUCT,
        }
        strength = strengths[type(op)]
        if isinstance(op, ast.BitAnd | ast.BitOr):
            # Both sides have brackets, except in a chain of the same operator: a reader need not
            # know the precedence of logical operators.
            chained = isinstance(left, ast.BinOp) and type(left.op) is type(op)
            sides = (
                self.print(left, strength if chained else Strength.ATOM),
                self.print(right, Strength.ATOM),
            )
            return f"{sides[0]} {self.syntax.logic[type(op)]} {sides[1]}", strength
        arithmetic = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
        sign = arithmetic[type(op)]
        return (
            f"{self.print(left, strength)} {self.syntax.signs.get(sign, sign)} "
            f"{self.print(right, strength + 1)}",
            strength,
        )


def printed(source: Source, asked: Iterable[str]) -> list[Routine]:
    """The routines that are printed: those asked for, and all that they call but ``ROUGH``."""
    needed: set[str] = set()
    further = [source.routines[name] for name in asked]
    while further:
        routine = further.pop()
        needed.add(routine.name)
        called = source.routines.keys() & set(routine.calls) - needed
        further += [source.routines[name] for name in sorted(called)]
    return [it for name, it in source.routines.items() if name in needed - {ROUGH}]


def number(value: float) -> str:
    """The shortest decimal that reads back as the same double."""
    text = repr(value)
    return text if re.search(r"[.en]", text) else f"{text}.0"
