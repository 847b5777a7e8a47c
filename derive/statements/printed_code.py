"""Right-hand sides in Python, C or MATLAB, read as the accelerations that they compute.

Nothing is run: the statements of one function, in a row without branches and loops, are inserted
into each other. Its state is told by what it returns: where an entry is another entry of the state,
the latter is the rate of the former.
"""

from __future__ import annotations

import ast
import itertools
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

import sympy as sp

from .objects import Derivation
from .papers import Statement
from .tree import Unread

#: A number, or an array of these.
Value: TypeAlias = "ast.expr | list[Value]"

#: Functions of numbers, by what languages call them.
_FUNCTIONS = {
    **{it: it for it in ("sin", "cos", "tan", "sqrt", "exp", "log", "sinh", "cosh", "tanh")},
    **dict.fromkeys(("abs", "fabs", "absolute"), "Abs"),
    **dict.fromkeys(("sign", "sgn"), "sign"),
    **{"arctan": "atan", "atan": "atan", "arcsin": "asin", "asin": "asin"},
}
_ARRAYS = ("array", "asarray", "hstack", "vstack", "concatenate", "stack", "list", "tuple")
_TYPES = (
    r"(?:(?:const|static|inline|unsigned|long|double|float|int|auto|real_t|realtype)\b[\s*&]*)+"
)
_STATE = "state_"  #: what the entries of a state are called until they are known


@dataclass
class _Function:
    """A function of a file: its arguments and its statements, as Python spells them."""

    name: str
    source: str
    arguments: list[str]
    body: list[ast.stmt]
    outputs: list[str]
    first: int = 0  #: number of the first entry of an array
    has_integers: bool = False  #: whether 1/2 is 0


def accelerations(
    statement: Statement, renamed: Mapping[str, str], derivation: Derivation
) -> tuple[str, str]:
    """The function that a statement is about, and the equations of the accelerations that it
    computes, in SymPy's syntax.

    Raises
    ------
    Unread
        If there is no such function, or it can't be translated; with the reason.
    """
    kind, name = statement.file.rpartition(".")[2], statement.function
    try:
        read = {"py": _python, "m": _matlab}.get(kind, _c)(statement.text, name)
        return read.source, "; ".join(_Translation(read, renamed, derivation).equations())
    except (SyntaxError, ValueError, ArithmeticError, RecursionError) as error:
        if isinstance(error, Unread):
            raise
        raise Unread(f"{name} can't be translated: {error}") from error


# ------------------------------------------------------------------------------------------------
# languages


def _python(text: str, function: str) -> _Function:
    name = function.rpartition(".")[2]
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef) and node.name == name:
            known = [
                it.arg for it in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
            ]
            return _Function(name, ast.get_source_segment(text, node) or "", known, node.body, [])
        match node:
            case ast.Assign(targets=[ast.Name(id=own)], value=ast.Lambda() as value) if own == name:
                known = [it.arg for it in value.args.args]
                shown = ast.get_source_segment(text, node) or ""
                return _Function(name, shown, known, [ast.Return(value.body)], [])
    raise Unread(f"there is no function {function}")


def _c(text: str, function: str) -> _Function:
    text = re.sub(r"//[^\n]*|/\*.*?\*/", " ", text, flags=re.S)
    head = re.search(rf"\b{re.escape(function)}\s*\(([^)]*)\)\s*\{{", text)
    if head is None:
        raise Unread(f"there is no function {function}")
    depth, end = 1, head.end()
    while depth and end < len(text):
        depth += (text[end] == "{") - (text[end] == "}")
        end += 1
    arguments = [
        found[-1]
        for it in head[1].split(",")
        if (found := re.findall(r"[A-Za-z_]\w*", re.sub(r"\[.*?\]", "", it)))
    ]
    lines = []
    for line in text[head.end() : end - 1].split(";"):
        plain = " ".join(line.split()).replace("->", ".").replace("std::", "")
        plain = re.sub(r"\(\s*(?:double|float)\s*\)", "", plain)
        plain = re.sub(r"(?<=\d)(\.?)[fFlL]\b", r"\1", plain)
        declared = re.match(_TYPES, plain)
        parts = _apart(plain[declared.end() :], ",") if declared else [plain]
        lines += [it.strip() for it in parts if not declared or "=" in it]
    shown = text[head.start() : end].strip()
    return _Function(function, shown, arguments, _statements(lines), [], has_integers=True)


def _matlab(text: str, function: str) -> _Function:
    text = re.sub(r"%[^\n]*", "", re.sub(r"\.\.\.[^\n]*\n", " ", text))
    name = re.escape(function)
    head = re.search(rf"function\s+(?:\[?([\w\s,]*?)\]?\s*=\s*)?{name}\s*\(([^)]*)\)", text)
    anonymous = re.search(rf"^\s*{name}\s*=\s*@\s*\(([^)]*)\)", text, re.M)
    if head is None and anonymous is None:
        raise Unread(f"there is no function {function}")
    if head is not None:
        body = re.split(r"^\s*(?:function\b|end\s*;?\s*$)", text[head.end() :], flags=re.M)[0]
        outputs, inside = re.findall(r"\w+", head[1] or ""), head[2]
    else:
        assert anonymous is not None
        outputs, inside = ["returned_"], anonymous[1]
        body = "returned_ = " + _apart(text[anonymous.end() :], ";\n")[0]
    lines = [_as_python(it) for it in _apart(body, ";\n") if it.strip()]
    arguments = re.findall(r"\w+", inside)
    shown = f"{(head or anonymous or [''])[0]}{body}".strip()
    return _Function(function, shown, arguments, _statements(lines), outputs, first=1)


def _as_python(line: str) -> str:
    """A statement of MATLAB in Python's syntax."""
    line = re.sub(r"\.([*/^])", r"\1", line).replace("^", "**")
    line = re.sub(r"(?<=[\w\])])'", "", line)
    for inside in re.findall(r"\[[^\[\]]*\]", line):
        rows = [it for it in re.split(r"[;\n]", inside[1:-1]) if it.strip()]
        parts = [_apart(it, ",") for it in rows]
        parts = [
            it if len(it) > 1 else re.split(r"(?<=[\w)])\s+(?=[\w(-])", it[0].strip())
            for it in parts
        ]
        is_column = all(len(it) == 1 for it in parts)
        shown = [
            ", ".join(it) if is_column or len(parts) == 1 else f"[{', '.join(it)}]" for it in parts
        ]
        line = line.replace(inside, f"[{', '.join(shown)}]")
    if found := re.fullmatch(r"(\s*\w+\s*=)?(.*?)\\(.*)", line, re.S):
        line = f"{found[1] or ''} solve({found[2]}, {found[3]})"
    return line.strip()


def _apart(text: str, separators: str) -> list[str]:
    """The parts of a text between separators outside brackets."""
    parts, depth = [""], 0
    for sign in text:
        depth += (sign in "([{") - (sign in ")]}")
        if sign in separators and depth == 0:
            parts.append("")
        else:
            parts[-1] += sign
    return parts


def _statements(lines: Sequence[str]) -> list[ast.stmt]:
    return [one for it in lines if it for one in ast.parse(it).body]


# ------------------------------------------------------------------------------------------------
# translation


@dataclass
class _Translation:
    """The statements of a function, inserted into each other."""

    function: _Function
    renamed: Mapping[str, str]
    derivation: Derivation
    known: dict[str, Value] = field(default_factory=dict)
    #: names that the code gives to entries of the state, by array and number
    entries: dict[tuple[str, int], str] = field(default_factory=dict)

    def equations(self) -> list[str]:
        """The equations ``a = …`` of all accelerations."""
        returned: Value | None = None
        for statement in self.function.body:
            match statement:
                case ast.Assign(targets=[target], value=value):
                    self._assign(target, self.value(value))
                case ast.AnnAssign(target=target, value=ast.expr() as value):
                    self._assign(target, self.value(value))
                case ast.AugAssign(target=ast.Name() as target, op=op, value=value):
                    before = self.value(ast.Name(target.id))
                    self._assign(target, self._operation(before, op, self.value(value)))
                case ast.Return(value=ast.expr() as value):
                    if not (isinstance(value, ast.Constant) and self.function.has_integers):
                        returned = self.value(value)
                case ast.Expr(value=ast.Constant() | ast.Name()) | ast.Global() | ast.Pass():
                    continue
                case ast.Return():
                    continue
                case _:
                    said = ast.unparse(ast.fix_missing_locations(statement)).split("\n")[0]
                    raise Unread(f"{said[:60]!r} is no assignment: branches and loops are not read")
        if returned is None:
            returned = self._outputs()
        return self._solved([*_flat(returned)])

    def _outputs(self) -> Value:
        """What a function gives in its arguments, or in names."""
        arguments = [it for it in self.function.arguments if isinstance(self.known.get(it), list)]
        found = [self.known[it] for it in self.function.outputs or arguments if it in self.known]
        if not found:
            raise Unread(f"{self.function.name} returns nothing that is read")
        return found[0] if len(found) == 1 else found

    def _assign(self, target: ast.expr, value: Value) -> None:
        if isinstance(target, ast.Tuple | ast.List):
            parts = value if isinstance(value, list) else []
            if isinstance(value, ast.Name) and value.id in self.function.arguments:
                count = range(len(target.elts))
                parts = [self._entry(value.id, it) for it in count]
            if len(parts) != len(target.elts):
                raise Unread(f"{ast.unparse(target)} is no list of as many names")
            for one, part in zip(target.elts, parts, strict=True):
                self._assign(one, part)
            return
        if isinstance(target, ast.Name):
            if isinstance(value, ast.Name) and value.id.startswith(_STATE):
                _, array, number = value.id.rsplit("_", 2)
                self.entries.setdefault((array, int(number)), target.id)
            is_number = isinstance(value, ast.expr) and not _names(value)
            if not (is_number and self._page_name(target.id)):  # which keeps its letter
                self.known[target.id] = value
            return
        array, place = self._place(target)
        held = self.known.setdefault(array, [])
        if not isinstance(held, list) or not 0 <= place < 100:
            raise Unread(f"{ast.unparse(target)} is no entry of an array")
        held += [ast.Constant(0)] * (place + 1 - len(held))
        held[place] = value

    def _place(self, part: ast.expr) -> tuple[str, int]:
        """The array and the number, from 0, of one of its entries."""
        match part:
            case ast.Subscript(value=ast.Name(id=array), slice=ast.Constant(value=int() as number)):
                return array, number
            case ast.Call(func=ast.Name(id=array), args=[ast.Constant(value=int() as number), *_]):
                return array, number - self.function.first
        raise Unread(f"{ast.unparse(part)} is no entry with a number")

    def _entry(self, array: str, number: int) -> Value:
        held = self.known.get(array)
        if isinstance(held, list):
            if number >= len(held):
                raise Unread(f"{array} has no entry {number}")
            return held[number]
        if array not in self.function.arguments:
            raise Unread(f"{array} is no array that is known")
        return ast.Name(f"{_STATE}_{array}_{number}")

    def value(self, part: ast.expr) -> Value:
        """The value of an expression, in names of the page and entries of the state."""
        match part:
            case ast.Constant(value=int() | float()):
                return part
            case ast.Name(id=name) if name in self.known:
                return self.known[name]
            case ast.Name(id="pi") | ast.Attribute(attr="pi"):
                return ast.Name("pi")
            case ast.Name(id=name):
                return part if name in self.function.arguments else self._named(name)
            case ast.Attribute(attr=name):
                return self.known.get(name) or self._named(name)
            case ast.Subscript(slice=ast.Constant(value=str() as name)):
                return self._named(name)
            case ast.Subscript(value=ast.Attribute(), slice=ast.Constant(value=0)):
                return self.value(part.value)
            case ast.Subscript():
                return self._entry(*self._place(part))
            case ast.List(elts=elements) | ast.Tuple(elts=elements):
                return [self.value(it) for it in elements]
            case ast.UnaryOp(op=ast.USub(), operand=inside):
                return _each(lambda it: ast.UnaryOp(ast.USub(), it), self.value(inside))
            case ast.UnaryOp(op=ast.UAdd(), operand=inside):
                return self.value(inside)
            case ast.BinOp(left=left, op=op, right=right):
                return self._operation(self.value(left), op, self.value(right))
            case ast.Call():
                return self._call(part)
        raise Unread(f"{ast.unparse(part)[:60]!r} is not read")

    def _operation(self, left: Value, op: ast.operator, right: Value) -> Value:
        is_product = isinstance(op, ast.Mult) and self.function.first == 1 and _is_matrix(left)
        if isinstance(op, ast.MatMult) or (is_product and isinstance(right, list)):
            return _matrix(sp.Matrix(_exact(left)) * sp.Matrix(_exact(right)))
        if isinstance(left, list) and isinstance(right, list):
            return [self._operation(a, op, b) for a, b in zip(left, right, strict=True)]
        if isinstance(left, list):
            return [self._operation(it, op, right) for it in left]
        if isinstance(right, list):
            return [self._operation(left, op, it) for it in right]
        match left, op, right:
            case ast.Constant(value=int() as above), ast.Div(), ast.Constant(value=int() as below):
                if self.function.has_integers and below:
                    return ast.Constant(int(above / below))
        return ast.BinOp(left, op, right)

    def _call(self, part: ast.Call) -> Value:
        name = part.func.attr if isinstance(part.func, ast.Attribute) else ""
        name = name or (part.func.id if isinstance(part.func, ast.Name) else "")
        if isinstance(part.func, ast.Name) and (
            name in self.known or name in self.function.arguments
        ):
            return self._entry(*self._place(part))
        values = [self.value(it) for it in part.args]
        if name in _FUNCTIONS and len(values) == 1:
            return _each(lambda it: ast.Call(ast.Name(_FUNCTIONS[name]), [it], []), values[0])
        if name in ("pow", "power") and len(values) == 2:
            return self._operation(values[0], ast.Pow(), values[1])
        if name == "square":
            return self._operation(values[0], ast.Pow(), ast.Constant(2))
        if name in _ARRAYS:
            return values[0] if len(values) == 1 else values
        if name in ("zeros", "zeros_like", "empty", "empty_like"):
            return []
        if name in ("solve", "inv", "dot", "matmul"):
            first, *rest = (sp.Matrix(_exact(it)) for it in values)
            return _matrix(
                first.inv()
                if name == "inv"
                else first.LUsolve(*rest)
                if name == "solve"
                else first * rest[0]
            )
        raise Unread(f"{name or ast.unparse(part.func)} is no function that is known")

    # ---- names

    def _page_name(self, name: str) -> str:
        """What the code calls by a name, on the page; empty where the page has no such name."""
        names = self.derivation.names
        if name in self.renamed:
            said = self.renamed[name]
            return f"v{said[:-1]}" if said.endswith("'") else said
        if name in names:
            return name
        alike = {it.replace("_", "").lower(): it for it in names}
        if (found := alike.get(name.replace("_", "").lower())) is not None and len(name) > 1:
            return found
        rate = re.fullmatch(r"(?:d_?|v_?)?(\w+?)(?:_?dot|_?d|_t|p)?", name)
        if rate and rate[1] != name and (own := self._page_name(rate[1])) and f"v{own}" in names:
            return f"v{own}"
        return ""

    def _named(self, name: str) -> ast.expr:
        if not (found := self._page_name(name)):
            raise Unread(f"{name} is no name of the page; say what it is under [symbols]")
        return ast.Name(found)

    # ---- states

    def _solved(self, returned: Sequence[ast.expr]) -> list[str]:
        """The accelerations among what is returned."""
        model = self.derivation.model
        own = [str(it) for it in model.coordinates if it != model.clock]
        if len(returned) == len(own):  # of functions that return accelerations alone
            return [f"a{q} = {self._text(it, {})}" for q, it in zip(own, returned, strict=True)]
        if len(returned) != 2 * len(own):
            said = f"{len(returned)} values for {len(own)} coordinates"
            raise Unread(f"{self.function.name} returns {said}")
        rates = [(n, rate) for n, it in enumerate(returned) if (rate := _number(it)) is not None]
        every = {*range(len(returned))}
        chosen = itertools.combinations(rates, len(own))
        pairs = next((it for it in chosen if {one for pair in it for one in pair} == every), None)
        if pairs is None:
            raise Unread("no state of coordinates and their rates is told by what is returned")
        named: dict[int, str] = {}
        for (_, number), name in self.entries.items():
            said = self._page_name(name)
            for place, rate in pairs:
                if said in own and number == place:
                    named[place] = said
                if said[1:] in own and number == rate:
                    named.setdefault(place, said[1:])
        left = [it for it in own if it not in named.values()]
        for place, _ in pairs:
            if place not in named:
                named[place] = left.pop(0)
        meant = {place: named[place] for place, _ in pairs}
        meant |= {rate: f"v{named[place]}" for place, rate in pairs}
        return [f"a{named[place]} = {self._text(returned[rate], meant)}" for place, rate in pairs]

    def _text(self, value: ast.expr, meant: Mapping[int, str]) -> str:
        """An expression in SymPy's syntax, with the page's names of the entries of a state."""
        text = ast.unparse(ast.fix_missing_locations(ast.Expression(value)))

        def name(found: re.Match[str]) -> str:
            if int(found[1]) not in meant:
                raise Unread(f"entry {found[1]} of the state is neither a coordinate nor a rate")
            return meant[int(found[1])]

        text = re.sub(rf"\b{_STATE}_\w+?_(\d+)\b", name, text)
        for own in set(re.findall(r"[A-Za-z_]\w*", text)) & {*self.function.arguments}:
            text = re.sub(rf"\b{own}\b", self._named(own).id, text)
        return text


def _number(value: ast.expr) -> int | None:
    """The number of the entry of the state that a value is; None of any other one."""
    is_entry = isinstance(value, ast.Name) and value.id.startswith(_STATE)
    return int(value.id.rpartition("_")[2]) if is_entry else None


def _names(value: ast.expr) -> set[str]:
    return {it.id for it in ast.walk(value) if isinstance(it, ast.Name)}


def _flat(value: Value) -> list[ast.expr]:
    if isinstance(value, list):
        return [one for it in value for one in _flat(it)]
    return [value]


def _each(function: Callable[[ast.expr], ast.expr], value: Value) -> Value:
    return [_each(function, it) for it in value] if isinstance(value, list) else function(value)


def _exact(value: Value) -> list[object] | sp.Expr:
    """The SymPy expressions of an array."""
    if isinstance(value, list):
        return [_exact(it) for it in value]
    names = {it: sp.Symbol(it) for it in _names(value)} | {
        it: getattr(sp, it) for it in _FUNCTIONS.values()
    }
    text = ast.unparse(ast.fix_missing_locations(ast.Expression(value)))
    return sp.nsimplify(sp.sympify(text, locals=names), rational=True)


def _matrix(value: sp.Matrix) -> Value:
    """The entries of a matrix; of a column a list."""
    texts = [[sp.sstr(sp.cancel(it)) for it in row] for row in value.tolist()]
    rows: list[list[Value]] = [[ast.parse(it, mode="eval").body for it in row] for row in texts]
    return [row[0] if value.cols == 1 else row for row in rows]


def _is_matrix(value: Value) -> bool:
    return isinstance(value, list) and any(isinstance(it, list) for it in value)
