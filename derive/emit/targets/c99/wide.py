"""The kernel a second time in C, on double-double numbers: operators become calls of the arithmetic in ``double_double.py``.

A statement is printed by the types of what it computes with: doubles stay doubles, and what a double-double enters becomes one.
Functions that are given doubles only are those of the plain kernel.
"""

from __future__ import annotations

import ast
import math
from collections import Counter
from collections.abc import Sequence

from ...expressions import number
from ...language import FLAG, REAL, KernelError, Routine, passes
from .. import Material
from ..python.algebra import definition
from .algebra import c_name
from .layout import broken, comment, plain
from .kernel import PRIMITIVES

DOUBLE, WIDE, INT = "double", "Wide", "int"
_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.BitAnd: "&", ast.BitOr: "|"}
_COMPARISONS = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "=="}
_WIDELY = {"maximum": "dd_larger", "minimum": "dd_smaller", "absolute": "dd_absolute", "sqrt": "dd_sqrt"}
#: A text in C and its type.
Typed = tuple[str, str]


def render(material: Material) -> str:
    """What ``spragsym.c`` calls on double-doubles, and all that it needs."""
    program = _Program(material)
    point = program.record("Point", (WIDE,) * len(material.kernel.records["Point"].fields))
    _, line = program.call("balance", (point,))
    program.call("moderate", (point,))
    program.call("representable", (line,))
    program.call("guesses", (point, line, DOUBLE))
    program.call("at_root", (WIDE, point, line, DOUBLE))
    program.call("apart", (WIDE, DOUBLE, WIDE, DOUBLE))
    return "\n".join(program.printed)


class _Program:
    """What has been printed so far: functions and records of double-doubles, each after those that it needs."""

    def __init__(self, material: Material) -> None:
        self.source, self.algebra, self.quantities = material.kernel, material.algebra, material.quantities
        self.printed: list[str] = []
        self.fields: dict[str, dict[str, str]] = {
            name: {field: _plain_type(kind) for field, kind in record.fields} for name, record in self.source.records.items()
        }
        self.functions: dict[str, tuple[tuple[str, ...], str]] = {}

    def is_wide(self, kind: str) -> bool:
        return kind == WIDE or kind.startswith("Wide")

    def record(self, name: str, types: tuple[str, ...]) -> str:
        """The C type of a record whose fields have these types; printed where it is new."""
        plain_fields = self.fields[name]
        if not any(map(self.is_wide, types)):
            return name
        wide = f"Wide{name}"
        fields = dict(zip(plain_fields, types, strict=True))
        if wide not in self.fields:
            self.fields[wide] = fields
            listed = "".join(f"    {kind} {field};\n" for field, kind in fields.items())
            self.printed.append(f"/* {name} in double-double arithmetic. */\ntypedef struct {{\n{listed}}} {wide};\n")
        if self.fields[wide] != fields:
            raise KernelError(f"{name} is made with {fields} and with {self.fields[wide]}")
        return wide

    def call(self, name: str, types: tuple[str, ...]) -> Typed:
        """The C function for arguments of these types, and the type of its result."""
        routine = self.source.routines[name]
        if not any(map(self.is_wide, types)):
            return name, _plain_type(routine.returns)
        if name not in self.functions:
            named = dict(zip((argument for argument, _ in routine.arguments), types, strict=True))
            writer = _Writer(self, named, routine.body)
            body = "".join(writer.explained(statement, "    ") for statement in routine.body)
            self.functions[name] = types, writer.returned
            self.printed.append(_defined(routine, types, writer, body))
        known, returned = self.functions[name]
        if known != types:
            raise KernelError(f"{name} is called with {types} and with {known}")
        return f"wide_{name}", returned

    def algebra_call(self, name: str) -> str:
        """The C function of generated algebra on double-doubles."""
        if name not in self.functions:
            function = self.algebra[name]
            (tree,) = ast.parse(definition(function, self.quantities)).body
            assert isinstance(tree, ast.FunctionDef)
            arguments = [c_name(argument.arg) for argument in tree.args.args]
            writer = _Writer(self, dict.fromkeys((argument.arg for argument in tree.args.args), WIDE), tree.body)
            body = "".join(writer.statement(statement, "    ") for statement in tree.body[1:])
            returned = f", Wide result[{writer.results}]" if writer.results else ""
            kind = "void" if writer.results else "Wide"
            head = f"INLINE {kind} wide_{name}({', '.join(f'Wide {argument}' for argument in arguments)}{returned}) {{"
            unused = "".join(f"    (void){c_name(it.arg)};\n" for it in tree.args.args if it.arg not in writer.used)
            self.functions[name] = (), ""
            self.printed.append(f"/* {function.summary} */\n{broken(head)}\n{unused}{body}}}\n")
        return f"wide_{name}"


def _plain_type(kind: str) -> str:
    return {REAL: DOUBLE, FLAG: INT}.get(kind, kind)


def _defined(routine: Routine, types: tuple[str, ...], writer: _Writer, body: str) -> str:
    arguments = ", ".join(f"{kind} {name}" for (name, _), kind in zip(routine.arguments, types, strict=True))
    head = f"INLINE {writer.returned} wide_{routine.name}({arguments}) {{"
    unused = "".join(f"    (void){name};\n" for name, _ in routine.arguments if name not in writer.used)
    return f"{comment(routine.summary)}{broken(head)}\n{unused}{body}}}\n"


class _Writer:
    """Prints the statements of one function."""

    def __init__(self, program: _Program, types: dict[str, str], body: Sequence[ast.stmt]) -> None:
        self.program, self.types = program, types
        self.returned = ""
        self.results = 0
        names = [node for statement in body for node in ast.walk(statement) if isinstance(node, ast.Name)]
        self.used = {node.id for node in names if isinstance(node.ctx, ast.Load)}
        self.written = Counter(node.id for node in names if isinstance(node.ctx, ast.Store))

    # ------------------------------------------------------------------------------------------ statements

    def explained(self, node: ast.stmt, indent: str) -> str:
        above = self.program.source.lines[node.lineno - 2].strip()
        said = f"{indent}/* {plain(above.removeprefix('#').strip())} */\n" if above.startswith("# ") else ""
        return said + self.statement(node, indent)

    def statement(self, node: ast.stmt, indent: str) -> str:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                text, kind = self.expression(value)
                return self.assigned(name, text, kind, indent)
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call(func=ast.Name(id=called), args=args)):
                return self.unpacked(_leaves(target), called, args, indent)
            case ast.For(body=body):
                self.written.update(node.id for part in body for node in ast.walk(part) if isinstance(node, ast.Name))
                inside = "".join(self.explained(statement, indent + "    ") for statement in body)
                return f"{indent}for (int i = 0; i < {passes(node)}; i++) {{\n{inside}{indent}}}\n"
            case ast.Return(value=ast.Tuple() as results):
                leaves = _items(results)
                self.results = len(leaves)
                return "".join(
                    broken(f"{indent}result[{i}] = {self.wide(*self.expression(leaf))};") + "\n" for i, leaf in enumerate(leaves)
                )
            case ast.Return(value=ast.Call(func=ast.Name(id=name), args=args)) if name in self.program.source.records:
                return self.built(name, args, indent)
            case ast.Return(value=ast.expr() as value):
                text, self.returned = self.expression(value)
                return broken(f"{indent}return {text};") + "\n"
        raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")

    def assigned(self, name: str, text: str, kind: str, indent: str) -> str:
        known = self.types.get(name)
        if known is None:
            self.types[name] = kind
            fixed = "const " if self.written[name] == 1 else ""
            return broken(f"{indent}{fixed}{kind} {c_name(name)} = {text};") + "\n"
        if known == WIDE:
            text = self.wide(text, kind)
        elif known != kind:
            raise KernelError(f"{name} is a {known} and then a {kind}")
        return broken(f"{indent}{c_name(name)} = {text};") + "\n"

    def built(self, name: str, args: list[ast.expr], indent: str) -> str:
        values = [self.expression(argument) for argument in args]
        self.returned = self.program.record(name, tuple(kind for _, kind in values))
        listed = ", ".join(text for text, _ in values)
        line = f"{indent}const {self.returned} result = {{{listed}}};"
        return f"{broken(line)}\n{indent}return result;\n"

    def unpacked(self, names: list[str], called: str, args: list[ast.expr], indent: str) -> str:
        array = f"{called}_results"
        values = [self.expression(argument) for argument in args]
        wide = any(kind == WIDE for _, kind in values)
        function = self.program.algebra_call(called) if wide else f"algebra_{called}"
        passed = ", ".join([*(self.wide(*value) if wide else value[0] for value in values), array])
        kind = WIDE if wide else DOUBLE
        lines = [f"{indent}{kind} {array}[{len(names)}];", broken(f"{indent}{function}({passed});")]
        for place, name in enumerate(names):
            self.types[name] = kind
            if name in self.used:
                lines.append(f"{indent}const {kind} {name} = {array}[{place}];")
        return "\n".join(lines) + "\n"

    # ----------------------------------------------------------------------------------------- expressions

    def wide(self, text: str, kind: str) -> str:
        """A text as a double-double."""
        if kind == WIDE:
            return text
        if kind != DOUBLE:
            raise KernelError(f"{text} is no number")
        return f"paired({text}, 0.0)"

    def expression(self, node: ast.expr) -> Typed:
        match node:
            case ast.Constant(value=(int() | float()) as value):
                return number(float(value)), DOUBLE
            case ast.Name(id=name):
                return c_name(name), self.types.get(name, DOUBLE)
            case ast.Attribute(value=value, attr=attribute):
                text, kind = self.expression(value)
                return f"{text}.{attribute}", self.program.fields[kind][attribute]
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                text, kind = self.expression(operand)
                return (f"dd_negative({text})", WIDE) if kind == WIDE else (f"(-{text})", kind)
            case ast.UnaryOp(op=ast.Invert(), operand=operand):
                return f"(!{self.expression(operand)[0]})", INT
            case ast.BinOp(left=left, op=op, right=right):
                return self.binary(self.expression(left), op, self.expression(right))
            case ast.Compare(left=left, ops=[op], comparators=[right]):
                return self.compared(self.expression(left), _COMPARISONS[type(op)], self.expression(right)), INT
            case ast.Call(func=ast.Name(id=name), args=args):
                return self.called(name, [self.expression(argument) for argument in args])
        raise KernelError(f"{ast.unparse(node)} is not in the kernel's language")

    def binary(self, left: Typed, op: ast.operator, right: Typed) -> Typed:
        (one, kind), (other, other_kind) = left, right
        if WIDE not in (kind, other_kind):
            return f"({one} {_OPERATORS[type(op)]} {other})", kind
        match op:
            case ast.Add():
                return self.total(left, right), WIDE
            case ast.Sub():
                negative = (f"dd_negative({other})", WIDE) if other_kind == WIDE else (f"(-{other})", DOUBLE)
                return self.total(left, negative), WIDE
            case ast.Mult():
                return self.product(left, right), WIDE
            case ast.Div():
                if kind == WIDE and (power := _power_of_two(other)):
                    return f"dd_scaled({one}, {number(1.0 / power)})", WIDE
                return f"dd_divide({self.wide(*left)}, {self.wide(*right)})", WIDE
        raise KernelError(f"{one} and {other} have no such operation")

    def total(self, left: Typed, right: Typed) -> str:
        (one, kind), (other, other_kind) = left, right
        if kind != WIDE:
            return f"dd_add_double({other}, {one})"
        return f"dd_add({one}, {other})" if other_kind == WIDE else f"dd_add_double({one}, {other})"

    def product(self, left: Typed, right: Typed) -> str:
        (one, kind), (other, other_kind) = left, right
        if kind != WIDE:
            (one, kind), (other, other_kind) = right, left
        if other_kind == WIDE:
            return f"dd_multiply({one}, {other})"
        return f"dd_scaled({one}, {other})" if _power_of_two(other) else f"dd_multiply_double({one}, {other})"

    def compared(self, left: Typed, sign: str, right: Typed) -> str:
        (one, kind), (other, other_kind) = left, right
        if WIDE not in (kind, other_kind):
            return f"({one} {sign} {other})"
        if other == "0.0":  # the leading part has the sign of the whole
            return f"({one}.high {sign} 0.0)"
        if sign == "<":
            return f"dd_less({self.wide(*left)}, {self.wide(*right)})"
        if sign == ">":
            return f"dd_less({self.wide(*right)}, {self.wide(*left)})"
        raise KernelError(f"{one} {sign} {other} is not printed for double-doubles")

    def called(self, name: str, values: list[Typed]) -> Typed:
        kinds = tuple(kind for _, kind in values)
        texts = [text for text, _ in values]
        wide = WIDE in kinds
        if name == "rough":
            return (f"{texts[0]}.high", DOUBLE) if wide else (texts[0], DOUBLE)
        if name == "where":
            if not wide:
                return f"({texts[0]} ? {texts[1]} : {texts[2]})", kinds[1]
            return f"dd_where({texts[0]}, {self.wide(*values[1])}, {self.wide(*values[2])})", WIDE
        if name in PRIMITIVES:
            if not wide:
                return f"{PRIMITIVES[name]}({', '.join(texts)})", DOUBLE
            return f"{_WIDELY[name]}({', '.join(self.wide(*value) for value in values)})", WIDE
        if name in self.program.source.routines:
            function, returned = self.program.call(name, kinds)
            return f"{function}({', '.join(texts)})", returned
        function = self.program.algebra_call(name) if wide else f"algebra_{name}"
        passed = (self.wide(*value) if wide else value[0] for value in values)
        return f"{function}({', '.join(passed)})", WIDE if wide else DOUBLE


def _power_of_two(text: str) -> float:
    """The constant, if it is one."""
    try:
        value = float(text.strip("()"))
    except ValueError:
        return 0.0
    return value if value and math.frexp(abs(value))[0] == 0.5 else 0.0


def _leaves(target: ast.expr) -> list[str]:
    return [item.id for item in _items(target) if isinstance(item, ast.Name)]


def _items(node: ast.expr) -> list[ast.expr]:
    return [leaf for item in node.elts for leaf in _items(item)] if isinstance(node, ast.Tuple) else [node]
