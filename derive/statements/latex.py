r"""LaTeX as papers print equations, read into trees.

A print is a sequence of items (:mod:`.lexer`); an expression is its terms, a term its factors, a
factor a name, a number, a bracket or a function with what is attached to it. What can be taken in
two ways is refused, with both readings. Nothing is evaluated.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from .lexer import Item, Items, nested
from .matrices import Matrix, Value, determinant, identity, inverse, named, negative, node_of
from .matrices import paired, product, quotient, total
from .names import LAWS, Name, Names, moved
from .tree import ZERO, Equation, Node, Unread, Vocabulary, printed, read_sympy

_PLAIN = [
    "sin",
    "cos",
    "tan",
    "cot",
    "sec",
    "csc",
    "sinh",
    "cosh",
    "tanh",
    "exp",
    "asin",
    "acos",
    "atan",
    "asinh",
    "acosh",
    "atanh",
]
#: Functions by their print, and what SymPy calls them.
FUNCTIONS = {
    **{name: name for name in _PLAIN},
    **{f"arc{name[1:]}": name for name in _PLAIN if name.startswith("a")},
    **{"ln": "log", "sgn": "sign", "sign": "sign", "abs": "Abs", "atan2": "atan2"},
    **{"min": "Min", "max": "Max"},
}
_FRACTIONS = (r"\frac", r"\dfrac", r"\tfrac")
_ROMAN = (r"\mathrm", r"\text", r"\mathit", r"\mathsf", r"\operatorname", r"\textrm", r"\rm")
_BOLD = (r"\mathbf", r"\boldsymbol", r"\bm", r"\vec", r"\mathcal", r"\bar", r"\hat", r"\tilde")
_ACCENTS = {r"\overline": r"\bar", r"\widehat": r"\hat", r"\widetilde": r"\tilde"}
_MATRICES = ("matrix", "pmatrix", "bmatrix", "Bmatrix", "smallmatrix", "array", "cases")
#: The matrix I, where it is not a name of the page.
_IDENTITY = Name(r"\mathbf I")
_TIMES = (r"\cdot", r"\times", "*", r"\ast")
_EQUAL = ("=", ":=", r"\equiv", r"\triangleq", r"\coloneqq")
_RELATIONS = {
    "<": "Lt", r"\lt": "Lt", r"\le": "Le", r"\leq": "Le", r"\leqslant": "Le", ">": "Gt",
    r"\gt": "Gt", r"\ge": "Ge", r"\geq": "Ge", r"\geqslant": "Ge", r"\ne": "Ne", r"\neq": "Ne",
    "=": "Eq",
}  # fmt: skip
_LETTERS = re.compile(
    r"\\(?:var)?(?:alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|pi|rho"
    r"|sigma|tau|upsilon|phi|chi|psi|omega|Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Phi|Psi|Omega)"
    r"|\\ell|[A-Za-z]"
)


@dataclass(frozen=True)
class Factor:
    """A factor, and the function whose argument has no brackets, so that it may go on."""

    value: Value
    open: str = ""


def read_latex(text: str, vocabulary: Vocabulary) -> list[Equation]:
    r"""Equations of a print in LaTeX.

    Parameters
    ----------
    text : str
        One equation or several; ``a = b = c`` is ``a = b`` and ``a = c``. A matrix equation is one
        equation for each entry. An expression without ``=`` is one that is 0.
    vocabulary : Vocabulary
        The names that may stand in it.

    Returns
    -------
    list of Equation
        In the order of the print.

    Raises
    ------
    Unread
        What can't be read, or can be read in two ways, with its place.

    Examples
    --------
    >>> from spragsym.derive.statements.tree import Vocabulary, printed
    >>> names = Vocabulary(frozenset({"m", "k", "x", "vx", "ax"}), ("x",), {})
    >>> [equation] = read_latex(r"m\\ddot{x} + \\frac{1}{2} k x = 0", names)
    >>> printed(equation.left)
    'm*ax + 1/2*k*x'
    """
    reader = _Reader(vocabulary)
    items = nested(text)
    while len(items) == 1 and items[0].items is not None and items[0].text == "{":
        items = items[0].items
    equations = [it for piece in _pieces(items) for it in reader.equations(piece)]
    if not equations:
        raise Unread("nothing stands here", 0)
    return equations


def _pieces(items: Items) -> list[list[Item]]:
    """Equations that stand beside or below each other."""
    pieces: list[list[Item]] = [[]]
    broken = False
    for number, it in enumerate(items):
        if it.items is None and it.text in ("&", r"\;"):
            continue
        if it.items is None and it.text in ("\\\\", r"\quad", r"\qquad", ",", ";"):
            following = items[number + 1] if number + 1 < len(items) else None
            if it.text == "," and _digits(items[number - 1 : number]) and _digits([following]):
                raise Unread("a comma between digits: a decimal comma, or two values", it.at[0])
            broken = broken or it.text == "\\\\"
            pieces.append([])
            continue
        ended = it.items is None and it.text == "." and number == len(items) - 1
        if not ended:
            first = not pieces[-1] and broken
            goes_on = it.text in ("+", "-", *_TIMES, *_EQUAL) and it.items is None
            rest = [one.text for one in items[number:] if one.items is None]
            line = rest[1 : rest.index("\\\\")] if "\\\\" in rest else rest[1:]
            if first and goes_on and (it.text in _EQUAL or not {*line} & {*_EQUAL}):
                joined = [piece for piece in pieces[:-1] if piece]
                pieces = [*joined[:-1], joined[-1] if joined else []]
            pieces[-1].append(it)
            broken = False
    pieces = [piece for piece in pieces if piece]
    if len(pieces) > 1:
        for piece in pieces:
            if not any(it.text in _EQUAL for it in piece):
                raise Unread("this part is no equation", piece[0].at[0])
    return pieces


def _digits(items: Iterable[Item | None]) -> bool:
    return any(it is not None and it.items is None and it.text[0].isdigit() for it in items)


class _Reader:
    """Recursive descent over items, with the names of one vocabulary."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.names = Names(vocabulary)
        self.matrices = vocabulary.matrices
        self.size = len(vocabulary.coordinates)
        for text, page in vocabulary.renamed.items():
            key = nested(text)
            name, place, power = self.name(key, 0)
            if name is None or place < len(key) or power:
                raise Unread(f"{text} under [symbols] is not one name", 0)
            self.names.renamed[name,] = self.page(page)

    def page(self, text: str) -> Node:
        """A name or an expression in the page's names; a prime is a rate."""
        found = re.fullmatch(r"(\w+?)('*)", text.strip())
        if found is None:
            empty = Vocabulary(self.names.symbols, (), {})
            return read_sympy(text, empty)[0].left
        node = Node("symbol", value=found[1])
        for _ in found[2]:
            node = self.names.rate(node)
        return node

    def equations(self, items: Items) -> list[Equation]:
        """Equations of one piece: each side with the first one."""
        sides: list[list[Item]] = [[]]
        for it in items:
            if it.items is None and it.text in _EQUAL:
                sides.append([])
            elif it.items is None and it.text in _RELATIONS:
                raise Unread(f"{it.text} makes this no equation", it.at[0])
            else:
                sides[-1].append(it)
        values = [self.side(side, items[0].at[0], len(sides) > 1) for side in sides]
        if len(values) == 1:
            values.append(_number("0"))
        found: list[Equation] = []
        for number, value in enumerate(values[1:], 1):
            zero = isinstance(value, Node) and value.kind == "number"
            found += paired(values[number - 1 if zero else 0], value, items[0].at[0])
        return found

    def side(self, items: Items, place: int, named: bool) -> Value:
        """A side of an equation; a name alone on it need not be one of the page."""
        name, stop, power = self.name(items, 0) if items else (None, 0, None)
        if name is not None and named and power is None:
            argument = stop + 1 == len(items) and items[stop].text == "("
            at = (items[0].at[0], items[-1].at[1])
            known = self.names.known(name, at)
            law = argument and (known is None or known.value in LAWS)
            if stop == len(items) or law:
                return self.matrix(known or Node("symbol", value=name.spelled, at=at))
        if not items:
            raise Unread("a side of the equation is empty", place)
        value = self.expression(items)
        single = isinstance(value, Matrix) and len(value.rows) == 1 == len(value.rows[0])
        return node_of(value) if single else value

    def matrix(self, node: Node) -> Value:
        """What a name stands for: entries, where it is one of a matrix."""
        shape = self.matrices.get(node.value) if node.kind == "symbol" else None
        return node if shape is None else named(node, shape)

    def expression(self, items: Items) -> Value:
        """A sum of terms."""
        items = [it for it in items if not (it.items is None and it.text == "&")]
        if not items:
            raise Unread("nothing stands here", 0)
        if len(items) == 1 and items[0].text == "{" and items[0].items is not None:
            return self.expression(items[0].items)
        terms: list[Value] = []
        start = 0
        signs = [number for number, it in enumerate(items) if _is_sign(items, number)]
        if signs[:1] != [0]:
            signs.insert(0, -1)
        for one, stop in zip(signs, [*signs[1:], len(items)], strict=True):
            start = one + 1
            if items[one].text in (r"\pm", r"\mp") and one >= 0:
                raise Unread("two signs at once", items[one].at[0], ("+", "-"))
            if start == stop:
                raise Unread("a term is missing", items[max(one, 0)].at[0])
            value = self.term(items[start:stop])
            minus = one >= 0 and items[one].text == "-"
            terms.append(negative(value, items[one].at[0]) if minus else value)
        return terms[0] if len(terms) == 1 else total(terms, items[0].at[0])

    def term(self, items: Items) -> Value:
        """A product of factors, by juxtaposition or by a sign, over one factor behind a slash."""
        factors: list[Factor] = []
        place, explicit = 0, True
        while place < len(items):
            it = items[place]
            plain = it.items is None
            if plain and it.text in (*_TIMES, "/") and (not factors or place + 1 == len(items)):
                raise Unread(f"{it.text} lacks an operand", it.at[0])
            if plain and it.text in _TIMES:
                if factors[-1].open == "number":
                    raise Unread("the argument of a function ends nowhere", it.at[0])
                place, explicit = place + 1, True
                continue
            if plain and it.text == "/":
                return self.slash(factors, items, place)
            factor, after = self.factor(items, place)
            if not explicit:
                self.juxtaposed(factors[-1], factor, items, place)
            factors.append(factor)
            place, explicit = after, False
        return product([it.value for it in factors])

    def slash(self, factors: list[Factor], items: Items, place: int) -> Value:
        """What stands before a slash over the one factor behind it."""
        above = product([it.value for it in factors])
        if factors[-1].open:
            name = printed(node_of(factors[-1].value))
            raise Unread(f"the slash divides {name} or its argument", items[place].at[0])
        below, after = self.factor(items, place + 1)
        if after < len(items):
            one, other = (printed(node_of(it)) for it in (above, below.value))
            raise Unread(
                "what stands behind the fraction is in its denominator, or is not",
                items[after].at[0],
                (f"({one})/({other})*…", f"({one})/({other}*…)"),
            )
        return quotient(above, node_of(below.value))

    def juxtaposed(self, before: Factor, factor: Factor, items: Items, place: int) -> None:
        """Refuse factors that stand beside each other and may be something else than a product."""
        at, value = items[place].at[0], factor.value
        if isinstance(value, Node) and value.kind == "number" and value.value != "pi":
            raise Unread("a number behind a factor: an index, a digit, or a product", at)
        if items[place].text in _FRACTIONS and _numeric(before.value) and _numeric(value):
            raise Unread("a mixed number, or a product", at)
        moves = items[place].text in (r"\dot", r"\ddot") or (
            isinstance(value, Node) and value.kind == "symbol" and value.value in self.rates
        )
        function = isinstance(value, Node) and value.kind in ("call", "pow") and factor.open
        if before.open and not ((moves or function) and before.open != "number"):
            call = node_of(before.value)
            one = printed(node_of(value)) if isinstance(value, Node) else "…"
            inner = call if call.kind == "call" else call.args[0]
            more = replace(inner, args=(node_of(product([inner.args[0], value])),))
            readings = (f"{printed(call)}*{one}", printed(more))
            raise Unread("the argument of a function ends here, or goes on", at, readings)

    @property
    def rates(self) -> set[str]:
        """Rates and accelerations."""
        return {*self.names.next.values()}

    def factor(self, items: Items, place: int) -> tuple[Factor, int]:
        """A factor from here, and the place behind it."""
        it = items[place]
        if (it.items is None and it.text in _FRACTIONS) or it.text == "d":
            found = self.derivative(items, place)
            if found is not None:
                return found
        if function := self.function(items, place):
            return self.call(*function, items, place)
        if it.items is None and it.text == r"\det" and _bracket(items, place + 1, ("(", "[")):
            inside = self.expression(_bracket(items, place + 1, ("(", "[")) or ())
            if not isinstance(inside, Matrix):
                raise Unread("the determinant of what is no matrix", it.at[0])
            whole = replace(determinant(inside), at=(it.at[0], items[place + 1].at[1]))
            return self.powered(whole, items, place + 2, it.at[0])
        name, after, power = self.name(items, place)
        if name is not None:
            raised = [one.at[0] for one in items[place:after] if one.text == "^"]
            stop = raised[-1] if power is not None and raised else items[after - 1].at[1]
            return self.named(name, power, items, after, (it.at[0], stop))
        value, after = self.base(items, place)
        return self.powered(value, items, after, it.at[0])

    def named(
        self, name: Name, power: Items | None, items: Items, place: int, at: tuple[int, int]
    ) -> tuple[Factor, int]:
        """A name with its exponent, or as a function of time."""
        bracket = _bracket(items, place)
        euler = name == Name("e") and self.names.known(name, at) is None
        if power is not None and name == Name("e") and not euler:
            exponent = printed(node_of(self.expression(power)))
            readings = (f"exp({exponent})", f"e**({exponent})")
            raise Unread("e is Euler's number or a name of the page", at[0], readings)
        if euler and power is not None:
            value = Node("call", (node_of(self.expression(power)),), "exp", at)
            return Factor(value), place
        if name == _IDENTITY and self.names.known(name, at) is None and power is None:
            return Factor(identity(self.size)), place
        node = self.names.of(name, at)
        if isinstance(matrix := self.matrix(node), Matrix):
            return Factor(self.matrix_power(matrix, power or (), at[0])), place
        if bracket is not None and power is None:
            if self.is_time(bracket):
                return self.powered(node, items, place + 1, at[0])
            self.product_only(node, bracket, items[place].at[0])
        if power is None:
            return Factor(node), place
        place += bracket is not None and self.is_time(bracket)
        return Factor(_power(node, node_of(self.expression(power)), at)), place

    def is_time(self, items: Items) -> bool:
        """Whether a bracket holds the time alone."""
        only = len(items) == 1 and items[0].items is None
        return only and items[0].text.removeprefix("\\") in self.names.times()

    def product_only(self, node: Node, bracket: Items, place: int) -> None:
        """Refuse f(x), a product or a function of x."""
        if any(it.items is None and it.text == "," for it in bracket):
            raise Unread(f"{node.value} is no function that is known", place)
        inside = node_of(self.expression(bracket))
        bare = inside.args[0] if inside.kind == "neg" else inside
        if bare.kind in ("symbol", "number") or node.value in LAWS:
            text = printed(inside)
            readings = (f"{node.value}*({text})", f"{node.value}({text})")
            raise Unread("a product, or a function of what stands in brackets", place, readings)

    def powered(self, value: Value, items: Items, place: int, start: int) -> tuple[Factor, int]:
        """A value with primes and an exponent behind it."""
        while place < len(items) and items[place].items is None and items[place].text == "'":
            value, place = self.names.rate(node_of(value)), place + 1
        if place < len(items) and items[place].items is None and items[place].text == "_":
            raise Unread("an index behind what has no name", items[place].at[0])
        if place < len(items) and items[place].items is None and items[place].text == "^":
            exponent, place = _argument(items, place + 1)
            if isinstance(value, Matrix):
                return Factor(self.matrix_power(value, exponent, start)), place
            at = (start, items[place - 1].at[1])
            value = _power(value, node_of(self.expression(exponent)), at)
        if place < len(items) and items[place].text == "^" and items[place].items is None:
            raise Unread("two exponents", items[place].at[0])
        return Factor(value), place

    def matrix_power(self, matrix: Matrix, exponent: Items, start: int) -> Matrix:
        """A matrix transposed, inverted or as it stands."""
        match [it.text for it in _flat(exponent)]:
            case []:
                return matrix
            case ["T"] | [r"\top"] | ["t"]:
                return Matrix(tuple(zip(*matrix.rows, strict=True)))
            case ["-", "1"] if len(matrix.rows) == len(matrix.rows[0]):
                return inverse(matrix)
        raise Unread("only the transpose and the inverse of a matrix are read", start)

    def base(self, items: Items, place: int) -> tuple[Value, int]:
        """A number, a bracket, a root, a fraction or an environment."""
        it = items[place]
        if it.items is None:
            if it.text[0].isdigit() or it.text[0] == ".":
                return Node("number", value=it.text, at=it.at), place + 1
            if it.text in _FRACTIONS:
                above, middle = _argument(items, place + 1)
                below, after = _argument(items, middle)
                value = quotient(self.expression(above), node_of(self.expression(below)))
                return replace(node_of(value), at=(it.at[0], items[after - 1].at[1])), after
            if it.text == r"\sqrt":
                return self.root(items, place)
            raise Unread(f"{it.text} is not read", it.at[0])
        if it.text in ("|", "|bare"):
            return Node("call", (node_of(self.expression(it.items)),), "Abs", it.at), place + 1
        if it.text in _MATRICES:
            return self.environment(it, pieces=False), place + 1
        if it.text not in ("(", "[", "{", r"\{"):
            raise Unread(f"{it.text} is not read", it.at[0])
        if it.text == r"\{" and [one.text for one in it.items] in (["array"], ["matrix"]):
            return self.environment(it.items[0], pieces=False), place + 1
        value = self.expression(it.items)
        summed = isinstance(value, Node) and value.kind in ("add", "neg")
        if it.text == "{" and summed and len(items) > 1:
            raise Unread("braces do not print; write brackets", it.at[0])
        return value, place + 1

    def root(self, items: Items, place: int) -> tuple[Value, int]:
        """A square root, or one of another degree."""
        start, degree = items[place].at[0], None
        if items[place + 1 : place + 2] and items[place + 1].text == "[":
            degree = node_of(self.expression(items[place + 1].items or ()))
            place += 1
        argument, after = _argument(items, place + 1)
        value = node_of(self.expression(argument))
        at = (start, items[after - 1].at[1])
        if degree is None:
            return Node("call", (value,), "sqrt", at), after
        return Node("pow", (value, Node("div", (_number("1"), degree), at=at)), at=at), after

    def environment(self, item: Item, *, pieces: bool) -> Value:
        """A matrix, or a choice by conditions."""
        inner = list(item.items or ())
        if item.text == "array":
            inner = inner[1:]
        rows: list[list[list[Item]]] = [[[]]]
        for it in inner:
            if it.items is None and it.text == "\\\\":
                rows.append([[]])
            elif it.items is None and it.text == "&":
                rows[-1].append([])
            else:
                rows[-1][-1].append(it)
        rows = [row for row in rows if row != [[]]]
        if item.text == "cases" and all(len(row) == 2 for row in rows):
            return self.choice(rows, item)
        if any(len(row) != len(rows[0]) for row in rows):
            raise Unread("rows of different length", item.at[0])
        read = (tuple(node_of(self.expression(cell)) for cell in row) for row in rows)
        return Matrix(tuple(read))

    def choice(self, rows: list[list[list[Item]]], item: Item) -> Node:
        """Values with the conditions under which they hold."""
        pairs = []
        for value, condition in rows:
            value = value[:-1] if value and value[-1].text == "," else value
            pair = (node_of(self.expression(value)), self.condition(condition, item.at[0]))
            pairs.append(Node("call", pair, "Tuple", (value[0].at[0], condition[-1].at[1])))
        return Node("call", tuple(pairs), "Piecewise", item.at)

    def condition(self, items: Items, place: int) -> Node:
        """A relation, or a chain of them, behind a word as "if"."""
        kept: list[Item] = []
        words = ""
        for it in items:
            if it.items is None and it.text in (
                r"\quad",
                r"\qquad",
                r"\text",
                r"\mathrm",
                ",",
                ".",
            ):
                continue
            following = it.items is not None and it.text == "{" and not kept
            if following or (not kept and it.text in ("i", "f")):
                words += "".join(one.text for one in _flat([it]))
                continue
            kept.append(it)
        if words in ("otherwise", "else") and not kept:
            return Node("call", (ZERO, ZERO), "Eq", (place, place))
        if words not in ("", "if", "for", "when", "where"):
            raise Unread(f"the word {words} is not read", place)
        parts: list[list[Item]] = [[]]
        signs: list[str] = []
        for it in kept:
            if it.items is None and it.text in _RELATIONS:
                signs.append(_RELATIONS[it.text])
                parts.append([])
            else:
                parts[-1].append(it)
        if not signs:
            raise Unread("a condition without a relation", place)
        values = [node_of(self.expression(part)) for part in parts]
        pairs = zip(signs, values, values[1:], strict=False)
        relations = tuple(Node("call", (a, b), sign, (a.at[0], b.at[1])) for sign, a, b in pairs)
        return relations[0] if len(relations) == 1 else Node("call", relations, "And")

    def function(self, items: Items, place: int) -> tuple[str, int] | None:
        """A function that stands here, by SymPy's name, and the place behind it."""
        it = items[place]
        if it.items is None and it.text == r"\log":
            raise Unread(r"\log is natural or decadic; print \ln", it.at[0], ("log", "log10"))
        if it.items is None and it.text.removeprefix("\\") in FUNCTIONS and len(it.text) > 1:
            return FUNCTIONS[it.text.removeprefix("\\")], place + 1
        if it.items is None and it.text in _ROMAN and place + 1 < len(items):
            word = re.sub(r"[\W_]", "", "".join(one.text for one in _flat([items[place + 1]])))
            return (FUNCTIONS[word], place + 2) if word in FUNCTIONS else None
        letters = ""
        for one in items[place : place + 5]:
            if one.items is not None or not re.fullmatch("[a-z]", one.text):
                break
            letters += one.text
        for word in sorted(FUNCTIONS, key=len, reverse=True):
            if letters.startswith(word):
                if {*word} <= self.names.symbols:
                    product = "*".join(word)
                    raise Unread(f"{word} or a product", it.at[0], (word, product))
                return FUNCTIONS[word], place + len(word)
        return None

    def call(self, name: str, place: int, items: Items, start: int) -> tuple[Factor, int]:
        """A function with its argument, in brackets or without."""
        power, begin = None, items[start].at[0]
        if place < len(items) and items[place].items is None and items[place].text == "^":
            exponent, place = _argument(items, place + 1)
            power = node_of(self.expression(exponent))
            if power.kind == "neg":
                readings = (f"a{name}(…)", f"1/{name}(…)")
                raise Unread("the inverse function, or its reciprocal", begin, readings)
        if place >= len(items):
            raise Unread(f"{name} without an argument", begin)
        bracket = _bracket(items, place, (*"([", r"\{"))
        braces = items[place].items is not None and items[place].text == "{"
        if bracket is not None or braces:
            inside = bracket if bracket is not None else items[place].items or ()
            groups: list[list[Item]] = [[]]
            for it in inside:
                if it.items is None and it.text == ",":
                    groups.append([])
                else:
                    groups[-1].append(it)
            arguments = tuple(node_of(self.expression(group)) for group in groups)
            place, is_open = place + 1, ""
        else:
            argument, place, is_open = self.bare_argument(name, items, place)
            arguments = (argument,)
        value = Node("call", arguments, name, (begin, items[place - 1].at[1]))
        following = items[place] if place < len(items) else None
        if following is not None and following.items is None and following.text in ("^", "'"):
            if bracket is None or following.text == "'" or power is not None:
                raise Unread(f"what is attached belongs to {name} or to its argument", begin)
            return self.powered(value, items, place, begin)
        if power is not None:
            value = _power(value, power, value.at)
        return Factor(value, is_open), place

    def bare_argument(self, name: str, items: Items, place: int) -> tuple[Node, int, str]:
        """An argument without brackets: a number, a name, or a number times one of these."""
        start = place
        if self.function(items, place) or items[place].text in ("+", "-"):
            raise Unread(f"the argument of {name} has no brackets", items[place].at[0])
        factor, place = self.factor(items, place)
        argument = node_of(factor.value)
        if argument.kind == "pow" and items[start].items is None:
            readings = (f"{name}({printed(argument)})", f"{name}({printed(argument.args[0])})**…")
            raise Unread(
                f"the exponent is of {name} or of its argument", items[start].at[0], readings
            )
        if not _numeric(argument):
            return argument, place, "argument"
        following = items[place] if place < len(items) else None
        closed = following is None or (
            following.items is None
            and (following.text in (*_TIMES, "/") or self.function(items, place) is not None)
        )
        if following is None:
            return argument, place, "number"
        if closed:
            raise Unread(f"the argument of {name} ends nowhere", following.at[0])
        factor, place = self.factor(items, place)
        more = node_of(factor.value)
        if more.kind == "pow":
            raise Unread(f"the exponent is of {name} or of its argument", following.at[0])
        return node_of(product([argument, more])), place, "argument"

    def derivative(self, items: Items, place: int) -> tuple[Factor, int] | None:
        """A derivative by time, as a fraction of differentials or its operator."""
        start = items[place].at[0]
        if items[place].text in _FRACTIONS:
            above, middle = _argument(items, place + 1)
            below, after = _argument(items, middle)
        else:
            texts = [it.text if it.items is None else "" for it in items[place:]]
            if "/" not in texts:
                return None
            middle = place + texts.index("/")
            above = list(items[place:middle])
            after = middle + (5 if "^" in texts[texts.index("/") :][:4] else 3)
            below = list(items[middle + 1 : after])
        up, down = _flat(above), _flat(below)
        texts = [it.text for it in down]
        if len(texts) < 2 or texts[0] not in ("d", r"\partial") or up[0].text != texts[0]:
            return None
        if texts[0] == r"\partial":
            raise Unread("a partial derivative is not read", start)
        if texts[1].removeprefix("\\") not in self.names.times():
            raise Unread(f"a derivative by {texts[1]}, or a fraction", start)
        order = 2 if texts[2:] == ["^", "2"] else 1
        if (order == 1 and texts[2:]) or (order == 2 and [it.text for it in up[1:3]] != ["^", "2"]):
            raise Unread("a derivative of this order is not read", start)
        what: Items = _inside(above)[1 + 2 * (order == 2) :]
        if items[place].text == "d" and not what:
            raise Unread("a derivative of what stands behind it; print it as a fraction", start)
        if what:
            value = node_of(self.expression(what))
        else:
            if after >= len(items):
                raise Unread("a derivative of nothing", start)
            bracketed = items[after].text == "("
            factor, stop = self.factor(items, after)
            value = node_of(factor.value)
            clear = bracketed or _bracket(items, stop - 1) is not None
            if value.kind == "pow" or (stop < len(items) and not clear):
                raise Unread("the derivative ends nowhere; print brackets", items[after].at[0])
            after = stop
        for _ in range(order):
            value = self.names.rate(value)
        return self.powered(moved(value, (start, items[after - 1].at[1])), items, after, start)

    def name(self, items: Items, place: int) -> tuple[Name | None, int, Items | None]:
        """A name with indices and primes, the place behind it, and its exponent."""
        it = items[place]
        order, after = 0, place + 1
        if it.items is not None:
            inner = it.items if it.text == "{" else ()
            name, stop, power = self.name(inner, 0) if inner else (None, 0, None)
            if name is None or stop < len(inner) or power is not None:
                return None, place, None
        elif it.text in (r"\dot", r"\ddot"):
            argument, after = _argument(items, after)
            name, stop, power = self.name(argument, 0)
            if name is None or stop < len(argument) or power is not None:
                raise Unread("dots on what is no name", it.at[0])
            name = replace(name, order=name.order + it.text.count("d"))
        elif it.text in (*_ROMAN, *_BOLD, *_ACCENTS):
            argument, after = _argument(items, after)
            word = "".join(one.text.removeprefix("\\") for one in _flat(argument))
            style = "" if it.text in _ROMAN else _ACCENTS.get(it.text, it.text) + " "
            name = Name(f"{style}{word}")
        elif count := self.names.word(items, place):
            name, after = (
                Name("".join(one.text for one in items[place : place + count])),
                place + count,
            )
        elif _LETTERS.fullmatch(it.text):
            name = Name(it.text.removeprefix("\\"))
        else:
            return None, place, None
        exponent: Items | None = None
        while after < len(items) and items[after].items is None and items[after].text in "_^'":
            sign, place = items[after].text, items[after].at[0]
            if sign == "'":
                order, after = order + 1, after + 1
                continue
            argument, after = _argument(items, after + 1)
            texts = [one.text for one in _flat(argument)]
            label = "".join(text.removeprefix("\\") for text in texts)
            primes = len([text for text in texts if text in (r"\prime", "'")])
            if sign == "_":
                if name.sub:
                    raise Unread("two indices", place)
                name = replace(name, sub=label)
            elif primes and texts[:primes] == texts[:1] * primes:
                order += primes
                exponent = list(argument)[primes:] or exponent
            elif (argument and argument[0].text in _ROMAN) or label in (
                "*",
                "+",
                "-",
                "ast",
                "star",
            ):
                name = replace(name, sup=label)
            elif exponent is not None:
                raise Unread("two exponents", place)
            else:
                exponent = argument
        return replace(name, order=name.order + order), after, exponent


def _argument(items: Items, place: int) -> tuple[Items, int]:
    """The argument of a command: a group, or the next token."""
    if place >= len(items):
        raise Unread("an argument is missing", items[-1].at[1])
    it = items[place]
    if it.items is not None and it.text == "{":
        return it.items, place + 1
    if it.items is None and it.text in (*_ROMAN, *_BOLD, *_ACCENTS) and place + 1 < len(items):
        return items[place : place + 2], place + 2
    if it.items is not None or it.text in (*_FRACTIONS, r"\sqrt", r"\dot", r"\ddot", "^", "_"):
        raise Unread("an argument without braces", it.at[0])
    return [it], place + 1


def _flat(items: Items) -> list[Item]:
    """Tokens without braces and styles."""
    flat: list[Item] = []
    for it in items:
        if it.items is not None and it.text == "{":
            flat += _flat(it.items)
        elif it.items is not None or it.text not in _ROMAN:
            flat.append(it)
    return flat


def _inside(items: Items) -> Items:
    """Items without a style on the first of them: \\mathrm{d} x as d x."""
    if items and items[0].items is None and items[0].text in _ROMAN:
        return [*_flat(items[1:2]), *items[2:]]
    return items


def _bracket(items: Items, place: int, kinds: tuple[str, ...] = ("(",)) -> Items | None:
    """What stands in a bracket here, with braces around it or without."""
    it = items[place] if 0 <= place < len(items) else None
    while it is not None and it.text == "{" and it.items is not None and len(it.items) == 1:
        it = it.items[0]
    return it.items if it is not None and it.items is not None and it.text in kinds else None


def _is_sign(items: Items, number: int) -> bool:
    """Whether a sign stands between terms, not in an exponent or behind another operator."""
    it = items[number]
    if it.items is not None or it.text not in ("+", "-", r"\pm", r"\mp"):
        return False
    before = items[number - 1] if number else None
    if before is not None and before.items is None:
        if before.text in ("^", "_"):
            return False
        if before.text in (*_TIMES, "/"):
            raise Unread("a sign behind an operator; print brackets", it.at[0])
    return True


def _number(text: str) -> Node:
    return Node("number", value=text)


def _numeric(value: Value) -> bool:
    """Whether it is a number or a quotient of numbers."""
    if not isinstance(value, Node):
        return False
    if value.kind == "div":
        return all(map(_numeric, value.args))
    return value.kind == "number" and value.value != "pi"


def _power(base: Value, exponent: Node, at: tuple[int, int]) -> Node:
    return Node("pow", (node_of(base), exponent), at=at)
