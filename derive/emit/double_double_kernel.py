"""A kernel a second time, on double-double numbers: operators become calls of the arithmetic in ``double_double.py``.

What comes out is text in the kernel's own language, which targets print as they print the kernel. A statement is rewritten by the
kinds of what it computes with: doubles stay doubles, and what a double-double enters becomes one. Functions that are given doubles
only are those of the plain kernel.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from .definitions import SPELLED, Definition
from .language import FLAG, REAL, KernelError, Source, parse, passes
from .routines import items, places

WIDE = "Wide"
_ROUTINES = {"maximum": "dd_larger", "minimum": "dd_smaller", "absolute": "dd_absolute", "sqrt": "dd_sqrt"}
#: An expression and its kind.
Typed = tuple[ast.expr, str]


def widened(
    kernel: Source,
    arithmetic: Source,
    algebra: Mapping[str, Definition],
    called: Iterable[tuple[str, tuple[str, ...]]],
) -> Source:
    """The functions that ``called`` names with the kinds of their arguments, and all that they need.

    Where one of these kinds is a record of the kernel, its version on double-doubles is meant; a function that is named earlier
    returns it.
    """
    program = _Program(kernel, arithmetic, algebra)
    for name, kinds in called:
        program.call(name, tuple(program.widest(kind) for kind in kinds))
    return parse("\n\n".join(program.texts))


@dataclass
class _Program:
    """What has been written so far: functions and records of double-doubles, each after those that it needs."""

    kernel: Source
    arithmetic: Source
    algebra: Mapping[str, Definition]
    texts: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        records = {**self.arithmetic.records, **self.kernel.records}
        self.fields = {name: dict(record.fields) for name, record in records.items()}
        self.functions: dict[str, tuple[tuple[str, ...], str]] = {}

    def is_wide(self, kind: str) -> bool:
        """Whether a double-double is in it."""
        return kind == WIDE or kind.startswith(WIDE)

    def widest(self, kind: str) -> str:
        """A record of the kernel with a double-double for every number; other kinds as they are."""
        if kind in self.kernel.records and f"{WIDE}{kind}" not in self.fields:
            return self.record(kind, (WIDE,) * len(self.fields[kind]))
        return f"{WIDE}{kind}" if kind in self.kernel.records else kind

    def record(self, name: str, kinds: tuple[str, ...]) -> str:
        """The record whose fields have these kinds; written where it is new."""
        if not any(map(self.is_wide, kinds)):
            return name
        wide = f"{WIDE}{name}"
        fields = dict(zip(self.fields[name], kinds, strict=True))
        self.define(wide, f"{name} in double-double arithmetic.", fields)
        if self.fields[wide] != fields:
            raise KernelError(f"{name} is made with {fields} and with {self.fields[wide]}")
        return wide

    def several(self, number: int) -> str:
        """The record of ``number`` double-doubles, which generated algebra returns."""
        name = f"{WIDE}s{number}"
        self.define(name, f"{number} double-doubles.", {f"value{i}": WIDE for i in range(number)})
        return name

    def define(self, name: str, summary: str, fields: dict[str, str]) -> None:
        """Write a record, unless it is there."""
        if name not in self.fields:
            self.fields[name] = fields
            listed = "".join(f"    {attribute}: {kind}\n" for attribute, kind in fields.items())
            self.texts.append(f'class {name}(NamedTuple):\n    """{summary}"""\n\n{listed}')

    def call(self, name: str, kinds: tuple[str, ...]) -> tuple[str, str]:
        """The function for arguments of these kinds, and the kind of its result."""
        routine = self.kernel.routines[name]
        if not any(map(self.is_wide, kinds)):
            return name, routine.returns
        if name not in self.functions:
            given = dict(zip((argument for argument, _ in routine.arguments), kinds, strict=True))
            self.write(name, f"``{name}`` in double-double arithmetic.", given, routine.body)
            self.functions[name] = kinds, self.functions[name][1]
        known, returned = self.functions[name]
        if known != kinds:
            raise KernelError(f"{name} is called with {kinds} and with {known}")
        return f"wide_{name}", returned

    def algebra_call(self, name: str) -> tuple[str, str]:
        """The function of generated algebra on double-doubles, and the kind of its result."""
        if name not in self.functions:
            function = self.algebra[name]
            given = {SPELLED.get(argument, argument): WIDE for argument in function.arguments}
            self.write(name, function.summary, given, function.tree(SPELLED).body)
        return f"wide_{name}", self.functions[name][1]

    def write(self, name: str, summary: str, given: dict[str, str], body: Sequence[ast.stmt]) -> None:
        """Write a function of double-doubles; what explains its statements stands in the plain one."""
        writer = _Writer(self, dict(given))
        written = [line for statement in body for line in writer.statement(statement, "    ")]
        arguments = ", ".join(f"{argument}: {kind}" for argument, kind in given.items())
        head = f'def wide_{name}({arguments}) -> {writer.returned}:\n    """{summary}"""\n'
        self.functions[name] = tuple(given.values()), writer.returned
        self.texts.append(head + "".join(f"{line}\n" for line in written))


class _Writer:
    """Rewrites the statements of one function."""

    def __init__(self, program: _Program, kinds: dict[str, str]) -> None:
        self.program, self.kinds = program, kinds
        self.returned = ""

    # ------------------------------------------------------------------------------------------ statements

    def statement(self, node: ast.stmt, indent: str) -> Iterator[str]:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                yield self.assigned(name, self.expression(value), indent)
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call(func=ast.Name(id=called), args=args)):
                yield self.unpacked(list(places(target)), called, args, indent)
            case ast.For(target=target, body=body):
                yield f"{indent}for {ast.unparse(target)} in range({passes(node)}):"
                for statement in body:
                    yield from self.statement(statement, indent + "    ")
            case ast.Return(value=ast.Tuple() as results):
                leaves = items(results)
                self.returned = self.program.several(len(leaves))
                values = [ast.unparse(self.wide(*self.expression(leaf))) for leaf in leaves]
                yield f"{indent}return {', '.join(values)}"
            case ast.Return(value=ast.Call(func=ast.Name(id=name), args=args)) if name in self.program.kernel.records:
                typed = [self.expression(argument) for argument in args]
                self.returned = self.program.record(name, tuple(kind for _, kind in typed))
                yield f"{indent}return {ast.unparse(_call(self.returned, *(value for value, _ in typed)))}"
            case ast.Return(value=ast.expr() as value):
                result, self.returned = self.expression(value)
                yield f"{indent}return {ast.unparse(result)}"
            case _:
                raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")

    def assigned(self, name: str, typed: Typed, indent: str) -> str:
        value, kind = typed
        known = self.kinds.setdefault(name, kind)
        if known == WIDE:
            value = self.wide(value, kind)
        elif known != kind:
            raise KernelError(f"{name} is a {known} and then a {kind}")
        return f"{indent}{name} = {ast.unparse(value)}"

    def unpacked(self, names: list[str], called: str, args: list[ast.expr], indent: str) -> str:
        """Results of generated algebra: double-doubles, if one is among what it is given."""
        typed = [self.expression(argument) for argument in args]
        wide = any(kind == WIDE for _, kind in typed)
        function = self.program.algebra_call(called)[0] if wide else called
        values = [self.wide(*it) if wide else it[0] for it in typed]
        self.kinds |= dict.fromkeys(names, WIDE if wide else REAL)
        return f"{indent}{', '.join(names)} = {ast.unparse(_call(function, *values))}"

    # ----------------------------------------------------------------------------------------- expressions

    def wide(self, value: ast.expr, kind: str) -> ast.expr:
        """A number as a double-double."""
        if kind not in (WIDE, REAL):
            raise KernelError(f"{ast.unparse(value)} is no number")
        return value if kind == WIDE else _call("paired", value, ast.Constant(0.0))

    def expression(self, node: ast.expr) -> Typed:
        match node:
            case ast.Constant(value=(int() | float()) as value):
                return ast.Constant(float(value)), REAL
            case ast.Name(id=name):
                return node, self.kinds.get(name, REAL)
            case ast.Attribute(value=value, attr=attribute):
                of, kind = self.expression(value)
                return ast.Attribute(of, attribute, ast.Load()), self.program.fields[kind][attribute]
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                value, kind = self.expression(operand)
                return self.negative(value, kind), kind
            case ast.UnaryOp(op=ast.Invert() as op, operand=operand):
                return ast.UnaryOp(op, self.expression(operand)[0]), FLAG
            case ast.BinOp(left=left, op=op, right=right):
                return self.binary(self.expression(left), op, self.expression(right))
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                return self.compared(self.expression(left), op, self.expression(right)), FLAG
            case ast.Call(func=ast.Name(id=name), args=args):
                return self.called(name, [self.expression(argument) for argument in args])
        raise KernelError(f"{ast.unparse(node)} is not in the kernel's language")

    def negative(self, value: ast.expr, kind: str) -> ast.expr:
        return _call("dd_negative", value) if kind == WIDE else ast.UnaryOp(ast.USub(), value)

    def leading(self, value: ast.expr) -> ast.expr:
        """The leading double, by a call: not every language lets one take a field of a call's result."""
        named = isinstance(value, ast.Name | ast.Attribute)
        return ast.Attribute(value, "high", ast.Load()) if named else _call("dd_leading", value)

    def binary(self, left: Typed, op: ast.operator, right: Typed) -> Typed:
        (one, kind), (other, other_kind) = left, right
        if WIDE not in (kind, other_kind):
            return ast.BinOp(one, op, other), kind
        match op:
            case ast.Add():
                return self.total(left, right), WIDE
            case ast.Sub():
                return self.total(left, (self.negative(other, other_kind), other_kind)), WIDE
            case ast.Mult():
                return self.product(left, right), WIDE
            case ast.Div():
                if kind == WIDE and (power := _power_of_two(other)):
                    return _call("dd_scaled", one, ast.Constant(1.0 / power)), WIDE
                return _call("dd_divide", self.wide(*left), self.wide(*right)), WIDE
        raise KernelError(f"{ast.unparse(one)} and {ast.unparse(other)} have no such operation")

    def total(self, left: Typed, right: Typed) -> ast.expr:
        (one, kind), (other, other_kind) = left, right
        if kind != WIDE:
            return _call("dd_add_double", other, one)
        return _call("dd_add" if other_kind == WIDE else "dd_add_double", one, other)

    def product(self, left: Typed, right: Typed) -> ast.expr:
        (one, kind), (other, other_kind) = left, right
        if kind != WIDE:
            (one, kind), (other, other_kind) = right, left
        if other_kind == WIDE:
            return _call("dd_multiply", one, other)
        return _call("dd_scaled" if _power_of_two(other) else "dd_multiply_double", one, other)

    def compared(self, left: Typed, op: ast.cmpop, right: Typed) -> ast.expr:
        (one, kind), (other, other_kind) = left, right
        if WIDE not in (kind, other_kind):
            return ast.Compare(one, [op], [other])
        if isinstance(other, ast.Constant) and other.value == 0.0:  # the leading part has the sign of the whole
            return ast.Compare(self.leading(one), [op], [other])
        match op:
            case ast.Lt():
                return _call("dd_less", self.wide(*left), self.wide(*right))
            case ast.Gt():
                return _call("dd_less", self.wide(*right), self.wide(*left))
        raise KernelError(f"{ast.unparse(one)} and {ast.unparse(other)} are not compared as double-doubles")

    def called(self, name: str, typed: list[Typed]) -> Typed:
        kinds = tuple(kind for _, kind in typed)
        values = [value for value, _ in typed]
        wide = WIDE in kinds
        if name == "rough":
            return (self.leading(values[0]) if wide else values[0]), REAL
        if name == "where" and wide:
            return _call("dd_where", values[0], *(self.wide(*it) for it in typed[1:])), WIDE
        if name == "where":
            return _call(name, *values), kinds[1]
        if name in _ROUTINES and wide:
            return _call(_ROUTINES[name], *(self.wide(*it) for it in typed)), WIDE
        if name in self.program.kernel.routines:
            function, returned = self.program.call(name, kinds)
            return _call(function, *values), returned
        if wide:
            function, returned = self.program.algebra_call(name)
            return _call(function, *(self.wide(*it) for it in typed)), returned
        return _call(name, *values), REAL


def _call(name: str, *args: ast.expr) -> ast.expr:
    return ast.Call(ast.Name(name, ast.Load()), list(args), [])


def _power_of_two(node: ast.expr) -> float:
    """The constant, if it is one; else 0."""
    match node:
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_power_of_two(operand)
        case ast.Constant(value=float() as value) if value and math.frexp(abs(value))[0] == 0.5:
            return value
    return 0.0
