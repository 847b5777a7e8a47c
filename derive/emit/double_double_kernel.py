"""Translation of a kernel to double-double numbers: operators become calls of the arithmetic in
``double_double.py``.

The result is text in the kernel's own language, which targets print as they print the kernel. Each
statement is rewritten by the kinds of its operands: an operation on doubles stays as it is, one
with a double-double among its operands gives a double-double. Functions that are called with
doubles only are those of the plain kernel.
"""

import ast
import math
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from .definitions import SPELLED, Definition
from .language import ROUGH, KernelError, Source, parse
from .routines import items, places

#: An expression and its kind.
Typed = tuple[ast.expr, str]


def widened(
    kernel: Source,
    arithmetic: Source,
    algebra: Mapping[str, Definition],
    called: Iterable[tuple[str, tuple[str, ...]]],
) -> Source:
    """The double-double versions of functions, and all that they need.

    ``called`` has names with the kinds of their arguments. The record of a kernel among these kinds
    stands for its version on double-doubles; a function that is named earlier returns it.
    """
    program = _Program(kernel, arithmetic, algebra)
    for name, kinds in called:
        program.call(name, tuple(program.widest(kind) for kind in kinds))
    return parse("\n\n".join(program.texts))


@dataclass
class _Program:
    """The functions and records written so far, each after those that it needs."""

    kernel: Source
    arithmetic: Source
    algebra: Mapping[str, Definition]
    texts: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        records = {**self.arithmetic.records, **self.kernel.records}
        self.fields = {name: dict(record.fields) for name, record in records.items()}
        self.functions: dict[str, tuple[tuple[str, ...], str]] = {}

    def widest(self, kind: str) -> str:
        """A record of the kernel with a double-double for every number; other kinds as they are."""
        if kind in self.kernel.records and f"Wide{kind}" not in self.fields:
            return self.record(kind, ("Wide",) * len(self.fields[kind]))
        return f"Wide{kind}" if kind in self.kernel.records else kind

    def record(self, name: str, kinds: tuple[str, ...]) -> str:
        """The name of the record with fields of these kinds, which is written if it is new."""
        if not any(kind.startswith("Wide") for kind in kinds):
            return name
        wide = f"Wide{name}"
        fields = dict(zip(self.fields[name], kinds, strict=True))
        self.define(wide, f"{name} in double-double arithmetic.", fields)
        if self.fields[wide] != fields:
            raise KernelError(f"{name} is made with {fields} and with {self.fields[wide]}")
        return wide

    def several(self, number: int) -> str:
        """The name of the record of ``number`` double-doubles, returned by generated algebra."""
        name = f"Wides{number}"
        self.define(name, f"{number} double-doubles.", {f"value{i}": "Wide" for i in range(number)})
        return name

    def define(self, name: str, summary: str, fields: dict[str, str]) -> None:
        """Write a record, unless it is written already."""
        if name not in self.fields:
            self.fields[name] = fields
            listed = "".join(f"    {attribute}: {kind}\n" for attribute, kind in fields.items())
            self.texts.append(f'class {name}(NamedTuple):\n    """{summary}"""\n\n{listed}')

    def call(self, name: str, kinds: tuple[str, ...]) -> tuple[str, str]:
        """The function for arguments of these kinds, and the kind of its result."""
        routine = self.kernel.routines[name]
        if not any(kind.startswith("Wide") for kind in kinds):
            return name, routine.returns
        if name not in self.functions:
            given = dict(zip((argument for argument, _ in routine.arguments), kinds, strict=True))
            self.write(name, f"``{name}`` in double-double arithmetic.", given, routine.body)
        earlier, returned = self.functions[name]
        if earlier != kinds:
            raise KernelError(f"{name} is called with {kinds} and with {earlier}")
        return f"wide_{name}", returned

    def algebra_call(self, name: str) -> tuple[str, str]:
        """The function of generated algebra on double-doubles, and the kind of its result."""
        if name not in self.functions:
            function = self.algebra[name]
            given = {SPELLED.get(argument, argument): "Wide" for argument in function.arguments}
            self.write(name, function.summary, given, function.tree(SPELLED).body)
        return f"wide_{name}", self.functions[name][1]

    def write(
        self, name: str, summary: str, given: dict[str, str], body: Sequence[ast.stmt]
    ) -> None:
        """Write a function on double-doubles, without the comments of the plain one."""
        writer = _Writer(self, dict(given))
        written = "\n".join(
            ast.unparse(ast.fix_missing_locations(writer.statement(statement)))
            for statement in body
        )
        arguments = ", ".join(f"{argument}: {kind}" for argument, kind in given.items())
        self.functions[name] = tuple(given.values()), writer.returned
        head = f'def wide_{name}({arguments}) -> {writer.returned}:\n    """{summary}"""\n'
        self.texts.append(f"{head}{textwrap.indent(written, '    ')}\n")


class _Writer:
    """Rewrites the statements of one function."""

    def __init__(self, program: _Program, kinds: dict[str, str]) -> None:
        self.program, self.kinds = program, kinds
        self.returned = ""

    def statement(self, node: ast.stmt) -> ast.stmt:
        match node:
            case ast.Assign(targets=[ast.Name(id=name) as target], value=value):
                return ast.Assign([target], self.assigned(name, *self.expression(value)))
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call() as value):
                # Generated algebra gives double-doubles if an argument is one.
                called, kind = self.expression(value)
                self.kinds |= dict.fromkeys(places(target), "Real" if kind == "Real" else "Wide")
                return ast.Assign([ast.Tuple(items(target))], called)
            case ast.For(target=target, iter=count, body=body):
                return ast.For(target, count, [self.statement(statement) for statement in body], [])
            case ast.Return(value=ast.Tuple() as results):
                leaves = items(results)
                self.returned = self.program.several(len(leaves))
                return ast.Return(ast.Tuple([self.wide(*self.expression(leaf)) for leaf in leaves]))
            case ast.Return(value=ast.expr() as value):
                result, self.returned = self.expression(value)
                return ast.Return(result)
        raise KernelError(
            f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language"
        )

    def assigned(self, name: str, value: ast.expr, kind: str) -> ast.expr:
        earlier = self.kinds.setdefault(name, kind)
        if earlier == "Wide":
            return self.wide(value, kind)
        if earlier != kind:
            raise KernelError(f"{name} is a {earlier} and then a {kind}")
        return value

    def wide(self, value: ast.expr, kind: str) -> ast.expr:
        """A number as a double-double; a flag as it is."""
        if kind not in ("Wide", "Real", "Flag"):
            raise KernelError(f"{ast.unparse(value)} is no number")
        return _call("paired", value, ast.Constant(0.0)) if kind == "Real" else value

    def expression(self, node: ast.expr) -> Typed:
        match node:
            case ast.Constant(value=(int() | float()) as value):
                return ast.Constant(float(value)), "Real"
            case ast.Name(id=name):
                return node, self.kinds.get(name, "Real")
            case ast.Attribute(value=value, attr=attribute):
                of, kind = self.expression(value)
                return ast.Attribute(of, attribute, ast.Load()), self.program.fields[kind][
                    attribute
                ]
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                value, kind = self.expression(operand)
                return self.negative(value, kind), kind
            case ast.UnaryOp(op=ast.Invert() as op, operand=operand):
                return ast.UnaryOp(op, self.expression(operand)[0]), "Flag"
            case ast.BinOp(left=left, op=op, right=right):
                return self.binary(self.expression(left), op, self.expression(right))
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                return self.compared(self.expression(left), op, self.expression(right)), "Flag"
            case ast.Call(func=ast.Name(id=name), args=args):
                return self.called(name, [self.expression(argument) for argument in args])
        raise KernelError(f"{ast.unparse(node)} is not in the kernel's language")

    def negative(self, value: ast.expr, kind: str) -> ast.expr:
        return _call("dd_negative", value) if kind == "Wide" else ast.UnaryOp(ast.USub(), value)

    def leading(self, value: ast.expr) -> ast.expr:
        """The leading double; of a call by another call, since not every language can take a field
        of a call's result.
        """
        named = isinstance(value, ast.Name | ast.Attribute)
        return ast.Attribute(value, "high", ast.Load()) if named else _call("dd_leading", value)

    def binary(self, left: Typed, op: ast.operator, right: Typed) -> Typed:
        (one, kind), (other, other_kind) = left, right
        if "Wide" not in (kind, other_kind):
            return ast.BinOp(one, op, other), kind
        if isinstance(op, ast.Sub):
            op, right = ast.Add(), (self.negative(other, other_kind), other_kind)
        operations = {ast.Add: "dd_add", ast.Mult: "dd_multiply", ast.Div: "dd_divide"}
        name = operations.get(type(op), "")
        if not name:
            raise KernelError(f"{ast.unparse(one)} and {ast.unparse(other)} have no such operation")
        if isinstance(op, ast.Div):
            if kind == "Wide" and (power := _power_of_two(other)):
                return _call("dd_scaled", one, ast.Constant(1.0 / power)), "Wide"
            return _call(name, self.wide(*left), self.wide(*right)), "Wide"
        (one, _), (other, kind) = (left, right) if kind == "Wide" else (right, left)
        if kind != "Wide":
            name = (
                "dd_scaled"
                if isinstance(op, ast.Mult) and _power_of_two(other)
                else f"{name}_double"
            )
        return _call(name, one, other), "Wide"

    def compared(self, left: Typed, op: ast.cmpop, right: Typed) -> ast.expr:
        (one, kind), (other, other_kind) = left, right
        if "Wide" not in (kind, other_kind):
            return ast.Compare(one, [op], [other])
        # The leading part has the sign of the whole.
        if isinstance(other, ast.Constant) and other.value == 0.0:
            return ast.Compare(self.leading(one), [op], [other])
        match op:
            case ast.Lt():
                return _call("dd_less", self.wide(*left), self.wide(*right))
            case ast.Gt():
                return _call("dd_less", self.wide(*right), self.wide(*left))
        raise KernelError(
            f"{ast.unparse(one)} and {ast.unparse(other)} are not compared as double-doubles"
        )

    def called(self, name: str, typed: list[Typed]) -> Typed:
        kinds = tuple(kind for _, kind in typed)
        values = [value for value, _ in typed]
        wide = "Wide" in kinds
        if name == ROUGH:
            return (self.leading(values[0]) if wide else values[0]), "Real"
        if name in self.program.kernel.records:
            record = self.program.record(name, kinds)
            return _call(record, *values), record
        if name in self.program.kernel.routines:
            function, returned = self.program.call(name, kinds)
            return _call(function, *values), returned
        if not wide:
            return _call(name, *values), kinds[1] if name == "where" else "Real"
        routines = {
            "maximum": "dd_larger",
            "minimum": "dd_smaller",
            "absolute": "dd_absolute",
            "sqrt": "dd_sqrt",
            "where": "dd_where",
        }
        function, returned = (
            (routines[name], "Wide") if name in routines else self.program.algebra_call(name)
        )
        return _call(function, *(self.wide(*it) for it in typed)), returned


def _call(name: str, *args: ast.expr) -> ast.expr:
    return ast.Call(ast.Name(name, ast.Load()), list(args), [])


def _power_of_two(node: ast.expr) -> float:
    """The value of a constant that is a power of 2; else 0."""
    match node:
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_power_of_two(operand)
        case ast.Constant(value=float() as value) if value and math.frexp(abs(value))[0] == 0.5:
            return value
    return 0.0
