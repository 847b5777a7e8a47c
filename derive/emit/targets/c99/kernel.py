"""The kernel's functions in C: records become structures, flags ints, and both sides of a choice are computed."""

from __future__ import annotations

import ast
import math
import re
from collections import Counter
from collections.abc import Mapping

from ...language import FLAG, REAL, KernelError, Kinds, Record, Routine, passes
from .layout import broken, comment

_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.BitAnd: "&", ast.BitOr: "|"}
_COMPARISONS = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "=="}
_PRIMITIVES = {"maximum": "larger", "minimum": "smaller", "absolute": "fabs", "sqrt": "sqrt", "cube_root": "cube_root"}
#: Binding strength of what is printed, to place brackets by.
_CHOICE, _OR, _AND, _COMPARE, _SUM, _PRODUCT, _UNARY, _ATOM = range(8)
_STRENGTH = {ast.BitOr: _OR, ast.BitAnd: _AND, ast.Add: _SUM, ast.Sub: _SUM, ast.Mult: _PRODUCT, ast.Div: _PRODUCT}


def structure(record: Record) -> str:
    """A record's definition."""
    fields = "".join(f"    {'int' if kind == FLAG else 'double'} {name};\n" for name, kind in record.fields)
    return f"{comment(record.summary)}typedef struct {{\n{fields}}} {record.name};\n"


def routine(it: Routine, kinds: Kinds, prefix: str) -> str:
    """A function's definition; generated algebra is called by ``prefix`` and its name."""
    return _Printer(it, kinds, prefix).definition()


class _Printer:
    def __init__(self, it: Routine, kinds: Kinds, prefix: str) -> None:
        self.it, self.kinds, self.prefix = it, kinds, prefix
        self.names: dict[str, str] = dict(it.arguments)
        assigned = [name for statement in it.body for name in _assigned(statement)]
        self.written = Counter(assigned)
        self.used = {
            node.id
            for statement in it.body
            for node in ast.walk(statement)
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
        }

    def definition(self) -> str:
        arguments = ", ".join(f"{self.type(kind)} {name}" for name, kind in self.it.arguments)
        head = f"INLINE {self.type(self.it.returns)} {self.it.name}({arguments}) {{"
        unused = "".join(f"    (void){name};\n" for name, _ in self.it.arguments if name not in self.used)
        body = "".join(self.explained(statement, "    ") for statement in self.it.body)
        return f"{comment(self.it.summary)}{broken(head)}\n{unused}{body}}}\n"

    def type(self, kind: str) -> str:
        return {REAL: "double", FLAG: "int"}.get(kind) or kind

    def explained(self, node: ast.stmt, indent: str) -> str:
        """A statement, below the comment that stands above it in the kernel."""
        above = self.kinds.source.lines[node.lineno - 2].strip()
        said = comment(above.removeprefix("#").strip(), indent) if above.startswith("# ") else ""
        return said + self.statement(node, indent)

    def statement(self, node: ast.stmt, indent: str) -> str:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                return self.assignment(name, value, indent)
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call(func=ast.Name(id=called), args=args)):
                return self.unpacked(_leaves(target), called, args, indent)
            case ast.For(body=body):
                inside = "".join(self.explained(statement, indent + "    ") for statement in body)
                return f"{indent}for (int i = 0; i < {passes(node)}; i++) {{\n{inside}{indent}}}\n"
            case ast.Return(value=ast.Call(func=ast.Name(id=name), args=args)) if name in self.kinds.source.records:
                values = ", ".join(self.print(argument, _SUM) for argument in args)
                return f"{broken(f'{indent}const {name} result = {{{values}}};')}\n{indent}return result;\n"
            case ast.Return(value=ast.expr() as value):
                return broken(f"{indent}return {self.print(value)};") + "\n"
        raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")

    def assignment(self, name: str, value: ast.expr, indent: str) -> str:
        kind = self.kinds.of(value, self.names)
        declared = name in self.names
        self.names[name] = kind
        start = name if declared else f"{'' if self.written[name] > 1 else 'const '}{self.type(kind)} {name}"
        return broken(f"{indent}{start} = {self.print(value)};") + "\n"

    def unpacked(self, names: list[str], called: str, args: list[ast.expr], indent: str) -> str:
        """Results of generated algebra, which C returns in an array."""
        array = f"{called}_results"
        passed = ", ".join([*(self.print(argument) for argument in args), array])
        lines = [f"{indent}double {array}[{len(names)}];", broken(f"{indent}{self.prefix}{called}({passed});")]
        for place, name in enumerate(names):
            self.names[name] = REAL
            if name in self.used:
                lines.append(f"{indent}const double {name} = {array}[{place}];")
        return "\n".join(lines) + "\n"

    def print(self, node: ast.expr, least: int = _CHOICE) -> str:
        text, strength = self.expression(node)
        return f"({text})" if strength < least else text

    def expression(self, node: ast.expr) -> tuple[str, int]:
        match node:
            case ast.Constant(value=float() as value):
                return number(value), _ATOM
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=float() as value)):
                return f"-{number(value)}", _UNARY
            case ast.Name(id=name):
                return name, _ATOM
            case ast.Attribute(value=value, attr=attribute):
                return f"{self.print(value, _ATOM)}.{attribute}", _ATOM
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return f"-{self.print(operand, _UNARY)}", _UNARY
            case ast.UnaryOp(op=ast.Invert(), operand=operand):
                return f"!{self.print(operand, _UNARY)}", _UNARY
            case ast.BinOp(left=left, op=op, right=right):
                return self.binary(left, op, right)
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                return f"{self.print(left, _SUM)} {_COMPARISONS[type(op)]} {self.print(right, _SUM)}", _COMPARE
            case ast.Call(func=ast.Name(id="where"), args=[condition, yes, no]):
                return f"{self.print(condition, _COMPARE)} ? {self.print(yes, _OR)} : {self.print(no, _OR)}", _CHOICE
            case ast.Call(func=ast.Name(id=name), args=args):
                called = _PRIMITIVES.get(name, name if name in self.kinds.source.routines else f"{self.prefix}{name}")
                return f"{called}({', '.join(self.print(argument) for argument in args)})", _ATOM
        raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")

    def binary(self, left: ast.expr, op: ast.operator, right: ast.expr) -> tuple[str, int]:
        strength = _STRENGTH[type(op)]
        if isinstance(op, ast.BitAnd | ast.BitOr):
            # In C, & and | bind more weakly than comparisons: both sides get brackets, except in a chain of the same operator.
            chained = isinstance(left, ast.BinOp) and type(left.op) is type(op)
            sides = self.print(left, strength if chained else _ATOM), self.print(right, _ATOM)
        else:
            sides = self.print(left, strength), self.print(right, strength + 1)
        return f"{sides[0]} {_OPERATORS[type(op)]} {sides[1]}", strength


def number(value: float) -> str:
    """A double with all of its digits."""
    text = repr(value)
    return text if re.search(r"[.en]", text) else f"{text}.0"


def _assigned(node: ast.stmt) -> list[str]:
    match node:
        case ast.Assign(targets=[target]):
            return _leaves(target)
        case ast.For(body=body):
            return [name for statement in body for name in _assigned(statement)] * 2
    return []


def _leaves(target: ast.expr) -> list[str]:
    if isinstance(target, ast.Tuple):
        return [name for item in target.elts for name in _leaves(item)]
    assert isinstance(target, ast.Name)
    return [target.id]


def constants(values: Mapping[str, tuple[float, str]]) -> str:
    """Named numbers with their comments."""
    lines = []
    for name, (value, text) in values.items():
        if math.isinf(value):  # C has a name for it
            continue
        lines += [comment(text)] if text else []
        lines.append(f"#define {name} {number(value)}\n")
    return "".join(lines)
