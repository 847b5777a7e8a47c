r"""Parser of LaTeX, as papers print equations, by recursive descent.

The lexer (:mod:`.lexer`) gives items, which may be groups. Equations are separated by lines,
commas and ``=``. A side is a sum of terms, a term a product of factors, a factor a name, a number,
a bracket or a function, with its exponent. An ambiguous print is refused with its readings.
Nothing is evaluated.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from . import tree
from .layout import ACCENTS, BOLD, EQUAL, MATRICES, OVER, RELATIONS
from .layout import ROMAN, TIMES, condition_of, equation_of, equations_inside, flattened
from .layout import is_condition, label_of, printed_apart, refuse_decimal_comma
from .lexer import FRACTIONS, Cursor, Token, Tokens, nested, split, texts
from .matrices import Matrix, Value, determinant, each, identity, inverse, named, negative, node_of
from .matrices import of_blocks, paired, product, quotient, shape_of, total
from .names import Name, Names, moved
from .roots import IMAGINARY, without_signs
from .tree import ONE, ZERO, Argument, Equation, Node, Unread, Vocabulary, leaf, printed
from .tree import nodes, read_sympy, renamed, symbols

#: SymPy's names of functions by their names in LaTeX.
FUNCTIONS = {name: name for name in tree.FUNCTIONS.keys() - {"log", "sqrt", "Abs", "Heaviside"}}
FUNCTIONS |= {f"arc{name[1:]}": name for name in FUNCTIONS if name.startswith("a")}
FUNCTIONS |= {"ln": "log", "abs": "Abs", **dict.fromkeys(("sgn", "Sgn", "Sign"), "sign")}

_DERIVATIVES = {r"\dv": "d", r"\pdv": r"\partial"}  #: of the package physics


@dataclass(frozen=True)
class Factor:
    """A factor that was read.

    ``open`` is empty, or says that the factor ends with the argument of a function without
    brackets, which the next factor may continue: "number" if that argument is a number so far,
    "argument" otherwise.
    """

    value: Value
    open: str = ""


def read_latex(text: str, vocabulary: Vocabulary) -> list[Equation]:
    r"""Parse equations printed in LaTeX.

    Parameters
    ----------
    text : str
        One equation or several; ``a = b = c`` is ``a = b`` and ``a = c``. A matrix equation is one
        equation for each entry. An expression without ``=`` is one that is 0.
    vocabulary : Vocabulary
        The names that may be printed.

    Returns
    -------
    list of Equation
        In the order of the print.

    Raises
    ------
    Unread
        If a part can't be read or is ambiguous, with its offset.

    Examples
    --------
    >>> from spragsym.derive.statements.tree import Vocabulary, printed
    >>> names = Vocabulary(frozenset({"m", "k", "x", "vx", "ax"}), ("x",), {})
    >>> [equation] = read_latex(r"m\\ddot{x} + \\frac{1}{2} k x = 0", names)
    >>> printed(equation.left)
    'm*ax + 1/2*k*x'
    """
    reader = _LatexReader(vocabulary)
    items: Tokens = nested(text)
    while len(items) == 1 and (inside := equations_inside(items[0])):
        items = inside
    pieces = [it for it in printed_apart(items) if not reader.is_start(it)]
    relations = [condition_of(piece) for piece in pieces if is_condition(piece)]
    pieces = [[*it] for it in map(equation_of, pieces) if it] or relations
    if len(pieces) > 1:
        reader.give_names(pieces)
    equations = [it for piece in pieces for it in reader.equations(piece)]
    if not equations:
        raise Unread("nothing stands here", 0)
    times = reader.names.times()  # a relation as t > 0 says nothing of the state
    of_state = (one for one in relations if one[0].text.removeprefix("\\") not in times)
    conditions = tuple(reader.condition(one, one[0].at[0]) for one in of_state)
    return [replace(without_signs(it), conditions=conditions) for it in equations]


def _is_order(text: str) -> bool:
    """Whether a text is an order of a derivative or of a matrix, which has one digit."""
    return len(text) == 1 and text.isdecimal()


class _LatexReader:
    """Recursive descent over items, with the names of one vocabulary.

    Methods that take a cursor ``here`` leave it behind what they read.
    """

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.names = Names(vocabulary)
        self.matrices, self.arguments = vocabulary.matrices, vocabulary.arguments
        self.size, self.has_roots = len(vocabulary.coordinates), vocabulary.has_roots
        self.gives_names = vocabulary.gives_names
        for text, page in vocabulary.renamed.items():
            name, power, here = None, None, Cursor(())
            with suppress(Unread):
                name, power = self.name(here := Cursor(nested(text)))
            if name is None or here.item is not None or (power and name.sup):
                said = "list one letter or word, with indices, dots or primes"
                self.names.unread = f"{text} under [symbols] is not one name; {said}"
                continue  # for statements without it
            name = name if power is None else replace(name, sup=label_of(power))
            if page in tree.FUNCTIONS and page not in self.names.symbols:
                self.names.functions[name] = page
                continue
            try:
                self.names.renamed[name] = self.page(page)
            except Unread as error:
                self.names.refused[name] = error.reason
        self.scales = {name: self.page(text) for name, text in vocabulary.scales.items()}

    def page(self, text: str) -> Node:
        """The tree of a text under [symbols]: a name of the page, or an expression in such names.

        A prime behind a name is its derivative by time.
        """

        def unprimed(found: re.Match[str]) -> str:
            node = leaf(found[1])
            for _ in found[2]:
                node = self.names.rate(node)
            return node.value

        plain = re.sub(r"(\w+?)('+)", unprimed, text.strip())
        if re.fullmatch(r"\w+", plain):
            return leaf(plain)
        try:
            return read_sympy(plain, Vocabulary(self.names.symbols, (), {}))[0].left
        except Unread as error:
            raise Unread(f"{text!r} under [symbols]: {error.reason}") from error

    def is_start(self, items: Tokens) -> bool:
        """Whether the items are the value of a state at time 0, which says nothing of others."""
        *name, last = split(items, *EQUAL)[0] or items
        start = self.only_name(name) if texts(_bracket(last) or ()) == ["0"] else None
        return start is not None and self.is_state(name)

    def equations(self, items: Tokens) -> list[Equation]:
        """Equations of one piece: ``a = b = c`` is ``a = b``, ``a = c``; a number in the chain is
        compared with the side behind it, since it is no name.
        """
        for it in items:
            if it.text in (r"\approx", r"\simeq"):
                raise Unread("say in which limit, as limit = 'linear in x, y'", it.at[0])
            if it.text in RELATIONS and it.text not in EQUAL:
                raise Unread(f"{it.text} makes this no equation", it.at[0])
        sides = split(items, *EQUAL)
        values: list[Value] = []
        for side in sides:
            self.names.is_open = self.gives_names and len(sides) > 1 and not values
            values.append(self.side(side, items[0].at[0], len(sides) > 1))
        if len(values) == 1:
            values.append(ZERO)
        found: list[Equation] = []
        for before, value in itertools.pairwise(values):
            is_number = isinstance(value, Node) and value.kind == "number"
            found += paired(before if is_number else values[0], value, items[0].at[0])
        return found

    def give_names(self, pieces: Sequence[Tokens]) -> None:
        """Make known the new names that the equations of one print give a value to."""
        self.names.is_open = True
        for piece in pieces:
            with suppress(Unread):
                left, *right = split(piece, *EQUAL)
                value = self.side(left, piece[0].at[0], True)
                is_value = isinstance(value, Node) and (self.gives_names or value.kind != "add")
                self.names.symbols |= symbols(node_of(value)) if is_value else set()
                argument = _bracket(left[-1]) if left[1:] else None
                if isinstance(value, Node) and value.kind == "symbol" and argument is not None:
                    known = printed(self.number(argument))
                    self.arguments = {
                        value.value: partial(tree.as_printed, known),
                        **self.arguments,
                    }
                    self.names.functions_of_one = self.arguments.keys()
                matrix = self.expression(right[-1]) if right else ZERO
                if isinstance(value, Node) and not isinstance(matrix, Node):
                    rows, columns = matrix.shape
                    self.matrices = {**self.matrices, value.value: (rows, columns)}

    def side(self, items: Tokens, place: int, named: bool) -> Value:
        """The tree of one side of an equation.

        If ``named``, a side that is a new name, or a multiple of one, is read too.
        """
        if not items:
            raise Unread("a side of the equation is empty", place)
        here = Cursor(items)
        name, power = (None, None) if self.function(Cursor(items)) else self.name(here)
        if name not in (None, Name("diag"), Name(r"\mathbf 0")) and named and power is None:
            at = _span(items)
            known = self.names.known(name, at)
            is_function = here.text == "(" and here.place + 1 == len(items)
            if is_function and self.is_matrix(name):
                is_function = self.is_state(_bracket(here.item) or ())
            elif is_function and known is not None:
                is_function = self.names.is_open and self.is_named_law(known, here.item)
            elif is_function and not (self.names.is_open and self.gives_names):
                is_function = self.lists_names(_bracket(here.item) or ())
            if here.item is None or is_function:
                return self.matrix(known or leaf(name.spelled, at))
        value = self.expression(items)
        return node_of(value) if {*shape_of(value)} == {1} else value

    def is_named_law(self, node: Node, bracket: Token | None) -> bool:
        """Whether the bracket behind a law holds arguments that the law is not known to have: any
        speed v as in μ(v), or several arguments.
        """
        inside = _bracket(bracket) or ()
        if "," in texts(inside) and self.names.moves(node):
            return True
        try:
            argument = self.argument(node, inside)
        except Unread:
            argument = None
        return node.value in self.names.laws and argument is None

    def matrix(self, node: Node) -> Value:
        """The entries of the matrix or column that a name stands for; else the name itself."""
        if node.kind == "symbol" and node.value in self.names.columns:
            return np.array([[replace(node, value=it)] for it in self.names.columns[node.value]])
        shape = self.matrices.get(node.value) if node.kind == "symbol" else None
        return node if shape is None else named(node, shape)

    def is_matrix(self, name: Name) -> bool:
        """Whether a name stands for a matrix or a column."""
        known = self.names.known(name, (0, 0))
        return known is not None and not isinstance(self.matrix(known), Node)

    def number(self, items: Tokens) -> Node:
        """The tree of an expression, which must not be a matrix."""
        value = self.expression(items)
        return node_of(value, items[0].at[0])

    def expression(self, items: Tokens) -> Value:
        """A sum of terms."""
        items = [it for it in items if it.text != "&"]
        if not items:
            raise Unread("nothing stands here", 0)
        if len(items) == 1 and items[0].text == "{":
            return self.expression(items[0].items or ())
        signs = [number for number, it in enumerate(items) if _is_sign(items, number)]
        if signs[:1] != [0]:
            signs.insert(0, -1)
        terms: list[Value] = []
        for one, stop in itertools.pairwise([*signs, len(items)]):
            sign, place = (items[one].text, items[one].at[0]) if one >= 0 else ("", 0)
            if sign in (r"\pm", r"\mp") and not self.has_roots:
                raise Unread("two signs at once", place, ("+", "-"))
            if one + 1 == stop:
                raise Unread("a term is missing", place)
            value = self.term(items[one + 1 : stop])
            if sign in (r"\pm", r"\mp"):
                value = Node("call", (node_of(value),), sign.removeprefix("\\"), (place, place))
            terms.append(_over(negative(value), items[one:stop]) if sign == "-" else value)
        return terms[0] if len(terms) == 1 else _over(total(terms, items[0].at[0]), items)

    def term(self, items: Tokens) -> Value:
        """A product of factors, printed with or without signs between them; a slash divides it by
        one factor.
        """
        factors: list[Factor] = []
        here, explicit = Cursor(items), True
        while here.item is not None:
            sign, place = here.text, here.at
            if sign in (*TIMES, "/"):
                if not factors or here.place + 1 == len(items):
                    raise Unread(f"{sign} lacks an operand", place)
                here.take()
                if sign == "/":
                    return _over(self.slash(factors, here, place), items)
                if factors[-1].open == "number":
                    raise Unread("the argument of a function ends nowhere", place)
                explicit = True
                continue
            factor = self.factor(here)
            while here.text == "|at":
                here.place += 2
                factor = self.at_point(factor.value, here, place)
            if not explicit:
                self.juxtaposed(factors[-1], factor, sign, place)
            factors.append(factor)
            explicit = False
        whole = product([it.value for it in factors])
        return whole if len(factors) == 1 else _over(whole, items)

    def sum(self, here: Cursor) -> Value:
        """A sum over an index, of the rest of its term: over 1 to n, or over what is listed."""
        start, bounds = here.at, {"_": list[Token](), "^": list[Token]()}
        here.take()
        while here.text in bounds:
            sign = here.take().text
            bounds[sign] = flattened(_argument(here))
        index, *listed = split(bounds["_"], "=")
        values = texts([it for part in listed for it in part if it.text != ","])
        last, body = label_of(bounds["^"]), here.items[here.place :]
        if len(values) == 1 and _is_order(values[0]) and _is_order(last):
            values = [str(number) for number in range(int(values[0]), int(last) + 1)]
        elif last or len(values) < 2:
            values = []
        if len(index) != 1 or not values or not body:
            raise Unread(
                r"a sum is read from \sum_{i=1}^{3} and \sum_{i=a,b}; print its terms", start
            )
        here.place = len(here.items)
        terms = [self.term(_indexed(body, index[0].text, value)) for value in values]
        return total(terms, start)

    def slash(self, factors: list[Factor], here: Cursor, place: int) -> Value:
        """The quotient of the factors before a slash and the single factor behind it."""
        above = product([it.value for it in factors])
        if factors[-1].open:
            name = printed(node_of(factors[-1].value))
            raise Unread(f"the slash divides {name} or its argument", place)
        below = self.factor(here).value
        if here.item is not None:
            one, other = (printed(node_of(it)) for it in (above, below))
            raise Unread(
                "what stands behind the fraction is in its denominator, or is not",
                here.at,
                (f"({one})/({other})*…", f"({one})/({other}*…)"),
            )
        return quotient(above, node_of(below))

    def juxtaposed(self, before: Factor, factor: Factor, sign: str, at: int) -> None:
        """Refuse two factors without a sign between them that may be no product: an index, a mixed
        number, or an argument that goes on.
        """
        value = factor.value if isinstance(factor.value, Node) else Node("matrix")
        if value.kind == "number" and value.value != "pi" and sign != "(":
            raise Unread("a number behind a factor: an index, a digit, or a product", at)
        if sign in FRACTIONS and _numeric(before.value) and _numeric(value):
            raise Unread("a mixed number, or a product", at)
        is_rate = value.kind == "symbol" and value.value in self.names.next.values()
        moves = sign in (r"\dot", r"\ddot") or is_rate
        # No author prints a cosine in an argument without brackets.
        waves = {*("sin", "cos", "tan", "cot", "exp")} & {it.value for it in nodes(value)}
        function = waves or (value.kind in ("call", "pow") and factor.open)
        if before.open and (before.open == "number" or not (moves or function)):
            call = node_of(before.value)
            inner = call if call.kind == "call" else call.args[0]
            more = replace(inner, args=(node_of(product([inner.args[0], factor.value])),))
            readings = (printed(node_of(product([call, factor.value]))), printed(more))
            raise Unread("the argument of a function ends here, or goes on", at, readings)

    def factor(self, here: Cursor) -> Factor:
        """The next factor."""
        begin, start = here.place, here.at
        is_sign = texts(_inside(here.items[begin:][:2])) == ["d"]
        may_derive = is_sign or here.text in ("d", r"\partial", *FRACTIONS, *_DERIVATIVES)
        if may_derive and (found := self.derivative(here)):
            return found
        if function := self.function(here):
            return self.call(function, here, start)
        if here.text == r"\sum":
            return Factor(self.sum(here))
        if (value := self.of_matrix(here)) is not None:
            return self.powered(value, here, start)
        name, power = self.name(here)
        if name is None:
            return self.powered(self.base(here), here, start)
        carets = [it.at[0] for it in here.items[begin : here.place] if it.text == "^"]
        stop = carets[-1] if power is not None and carets else here.end
        return self.named(name, power, here, (start, stop))

    def named(self, name: Name, power: Tokens | None, here: Cursor, at: tuple[int, int]) -> Factor:
        """The factor that begins with a name, with its exponent and its argument in brackets."""
        known = self.names.known(name, at)
        if name == Name("e") and power is not None:
            exponent = self.number(power)
            if known is not None:
                readings = (f"exp({printed(exponent)})", f"e**({printed(exponent)})")
                raise Unread("e is Euler's number or a name of the page", at[0], readings)
            return Factor(Node("call", (exponent,), "exp", at))
        # The matrices 0 and I, where they are no names of the page.
        size = re.fullmatch(r"(\d?)(?:times(\d))?", name.sub)
        if size and known is None and power is None and not name.order:
            rows, columns = (int(one or self.size) for one in size.groups(size[1]))
            if replace(name, sub="") == Name(r"\mathbf 0"):
                zero = replace(ZERO, at=at)
                return Factor(np.full((rows, columns), zero) if size[2] else zero)
            if replace(name, sub="") == Name(r"\mathbf I") and rows == columns:
                return Factor(identity(rows))
        if known is None and self.has_roots and name.spelled in ("i", "j", "imath", "jmath"):
            return Factor(leaf(IMAGINARY, at))
        node = self.names.of(name, at)
        bracketed = _bracket(here.item) is not None
        if not isinstance(matrix := self.matrix(node), Node):
            inside = _bracket(here.item) or ()
            if bracketed and (self.is_time(inside) or self.is_state(inside)):
                here.take()
            return Factor(self.matrix_power(matrix, power or (), at[0]))
        node = self.by_own_argument(self.applied(node, here, power is not None))
        if power is not None:
            if texts(flattened(power)) == ["0"]:
                raise Unread(f"0 above {name}: an index; say it under [symbols]", at[0])
            return Factor(tree.power(node, self.number(power), (at[0], here.end)))
        is_attached = bracketed or here.text == "_"
        return self.powered(node, here, at[0]) if is_attached else Factor(node)

    def argument(self, node: Node, items: Tokens) -> Argument | None:
        """The argument that a bracket gives to a function or its derivative; None for a factor."""
        function = self.names.function_of(node)
        return None if function is None else self.arguments[function](self.number(items))

    def called(self, node: Node, items: Tokens) -> Node | None:
        """A function or its derivative with the argument in brackets; None if that is a factor."""
        argument = self.argument(node, items)
        if argument is None:
            return None
        is_odd = node.value.count("diff(") % 2 == 0
        if argument.at_rest:
            node = replace(self.names.derived(node, "at rest"), at=node.at)
        return Node("neg", (node,), at=node.at) if is_odd and argument.sign < 0 else node

    def applied(self, node: Node, here: Cursor, is_raised: bool = False) -> Node:
        """A name, and the bracket behind it if that holds the time or its argument.

        Another bracket is left where it is; without an exponent (``is_raised``) it is refused if it
        may be an argument.
        """
        bracket = _bracket(here.item)
        if bracket is None:
            return node
        called = node if self.is_time(bracket) else self.called(node, bracket)
        if called is None:
            if not is_raised:
                is_base = texts(here.items[here.place + 1 :][:1]) in (["^"], ["_"])
                self.product_only(node, bracket, here.at, is_base)
            return node
        here.take()
        return called

    def by_own_argument(self, node: Node) -> Node:
        """A derivative of a friction law by the argument with which that is printed."""
        law = node.args[0] if node.kind == "neg" else node
        scale = self.scales.get(self.names.function_of(law) or "")
        order = law.value.count("diff(")
        return node_of(product([*[moved(scale, node.at)] * order, node])) if scale else node

    def at_point(self, value: Value, here: Cursor, start: int) -> Factor:
        """A value with another value of one variable inserted, as dμ/dv at v = v_0."""
        place, items = here.at, _argument(here)
        *by, at = split(items, "=", r"\to")
        node = node_of(value, start)
        point = [*map(self.number, (*by, at))]
        moving = {*self.names.next, *self.names.next.values()}
        is_called = any(self.names.function_of(leaf(it)) is not None for it in symbols(node))

        def at_the_point(name: str) -> Node | None:
            """The tree that a name has there; None if that is not known."""
            one = leaf(name, node.at)
            if self.names.function_of(one) is not None:
                is_argument = not by or self.called(one, by[0]) is not None
                return self.called(one, at) if is_argument else None
            if printed(point[0]) == printed(point[-1]) or not self.names.moves(one):
                return one if not by or is_called or self.names.moves(point[0]) else None
            is_other = by and point[0].kind == "symbol" and name in moving
            return (point[1] if name == point[0].value else one) if is_other else None

        values = {name: at_the_point(name) for name in symbols(node)}
        if unknown := [name for name, it in values.items() if it is None or by[1:]]:
            said = "is not read; define it as a name of its own"
            raise Unread(f"the value of {unknown[0]} at this point {said}", place)
        known = {name: it for name, it in values.items() if it is not None}
        return self.powered(replace(renamed(node, known), at=(start, here.end)), here, start)

    def is_time(self, items: Tokens) -> bool:
        """Whether a bracket holds the time and nothing else."""
        return len(items) == 1 and self.is_times(texts(items))

    def is_state(self, items: Tokens) -> bool:
        """Whether a bracket behind a matrix holds its arguments, names of what moves."""
        for name in map(self.only_name, split(items, ",")):
            node = None if name is None else self.names.known(name, (0, 0))
            if node is None or not self.names.moves(node):
                return False
        return True

    def lists_names(self, items: Tokens) -> bool:
        """Whether a bracket behind a new name holds arguments: names, or a number, as in x(0)."""
        parts = split(items, ",")
        is_number = len(items) == 1 and items[0].text[0].isdigit()
        return is_number or all(self.only_name(it) is not None for it in parts)

    def is_times(self, letters: Sequence[str]) -> bool:
        """Whether all of the letters are names of time."""
        return bool(letters) and {it.removeprefix("\\") for it in letters} <= self.names.times()

    def product_only(self, node: Node, bracket: Tokens, place: int, is_base: bool) -> None:
        """Refuse f(x) where it may be a product or a function of x; of a constant f and a bracket
        that ``is_base`` of a power it is a product.
        """
        if any(it.text == "," for it in bracket):
            raise Unread(f"{node.value} is no function that is known", place)
        inside = self.number(bracket)
        bare = inside.args[0] if inside.kind == "neg" else inside
        is_function = node.value in self.names.laws or self.names.function_of(node) is not None
        is_power = is_base and not self.names.moves(node)
        if is_function or (bare.kind in ("symbol", "number") and not is_power):
            text = printed(inside)
            readings = (f"{node.value}*({text})", f"{node.value}({text})")
            said = "a product, or a function of what stands in brackets"
            if is_function:
                said += ", which is neither its sliding speed nor the argument of its definition"
            raise Unread(said, place, readings)

    def powered(self, value: Value, here: Cursor, start: int) -> Factor:
        """A value with the primes, the index + (its positive part) and the exponent behind it."""
        while here.text == "'":
            here.take()
            value = self.names.rate(node_of(value))
        if here.text == "_":
            here.take()
            if texts(_argument(replace(here))) != ["+"]:
                return self.at_point(value, here, start)
            here.take()
            value = Node("call", (node_of(value), ZERO), "max", (start, here.end))
        if here.text == "^":
            here.take()
            exponent = _argument(here)
            if not isinstance(value, Node):
                return Factor(self.matrix_power(value, exponent, start))
            value = tree.power(value, self.number(exponent), (start, here.end))
        if here.text == "^":
            raise Unread("two exponents", here.at)
        return Factor(value)

    def matrix_power(self, matrix: Matrix, exponent: Tokens, start: int) -> Matrix:
        """A matrix with an exponent: transposed, inverted, or itself without one."""
        match texts(flattened(exponent)):
            case []:
                return matrix
            case ["T" | r"\top" | "t"]:
                return matrix.T
            case ["-", "1"] if len(matrix) == len(matrix.T):
                return inverse(matrix)
        raise Unread("only the transpose and the inverse of a matrix are read", start)

    def base(self, here: Cursor) -> Value:
        """A number, a bracket, a root, a fraction or an environment, without its exponent."""
        it = here.take()
        if it.text in FRACTIONS:
            value = quotient(self.expression(_argument(here)), self.number(_argument(here)))
            return replace(node_of(value), at=(it.at[0], here.end))
        if it.text == r"\sqrt":
            return self.root(here, it.at[0])
        if it.text[-1].isdecimal():
            return tree.as_number(it.text, it.at)
        inside = it.items or ()
        if it.text in ("|", "|bare") and [one.text in MATRICES for one in inside] != [True]:
            return Node("call", (self.number(inside),), "Abs", it.at)
        if it.text in ("|", "|bare", "vmatrix"):
            table = self.table(it if it.text == "vmatrix" else inside[0])
            return replace(determinant(table), at=it.at)
        if it.text == r"\langle":  # the positive part, in Macaulay's brackets
            return Node("call", (self.number(inside), ZERO), "max", it.at)
        if it.text == r"\{" and texts(inside) in (["array"], ["matrix"]):
            it = inside[0]
        if it.text in (*MATRICES, "cases"):
            return self.environment(it)
        if it.text not in ("(", "[", "{", r"\{"):
            raise Unread(f"{it.text} is not read", it.at[0])
        if it.text == "{" and r"\over" in texts(inside):
            line = texts(inside).index(r"\over")
            return quotient(self.expression(inside[:line]), self.number(inside[line + 1 :]))
        if it.text in ("(", "[") and "," in texts(inside):  # a row, as in (x, y)ᵀ
            for number in range(len(inside)):
                refuse_decimal_comma(inside, number)
            return np.array([[self.number(part) for part in split(inside, ",")]])
        whole = self.expression(inside)
        summed = isinstance(whole, Node) and {*"+-"} & {*texts(inside)}
        if it.text == "{" and summed and len(here.items) > 1:
            raise Unread("braces do not print; write brackets", it.at[0])
        return whole

    def root(self, here: Cursor, start: int) -> Node:
        """A square root, or one of another degree."""
        degree = self.number(here.take().items or ()) if here.text == "[" else None
        value = self.number(_argument(here))
        at = (start, here.end)
        if degree is None:
            return Node("call", (value,), "sqrt", at)
        return Node("pow", (value, Node("div", (ONE, degree), at=at)), at=at)

    def environment(self, item: Token) -> Value:
        """A matrix, or a choice by conditions."""
        rows = _rows(item)
        is_choice = item.text == "cases" and all(len(row) == 2 for row in rows)
        return self.choice(rows, item) if is_choice else self.table(item)

    def table(self, item: Token) -> Matrix:
        """A matrix of the rows of an environment."""
        rows = _rows(item)
        if len({*map(len, rows)}) != 1:
            raise Unread("rows of different length", item.at[0])
        marks = [[label_of(cell).rstrip(".") in ("sym", "symm") for cell in row] for row in rows]
        is_symmetric = np.any(marks) and len(rows) == len(rows[0])
        for i, j in itertools.combinations(range(len(rows) if is_symmetric else 0), 2):
            for one, other in ((i, j), (j, i)):  # what is left out stands across the diagonal
                if marks[one][other] or not rows[one][other]:
                    rows[one][other] = rows[other][one]
        cells = [[self.expression(cell) if cell else ZERO for cell in row] for row in rows]
        return of_blocks(cells, item.at[0])

    def of_matrix(self, here: Cursor) -> Value | None:
        """A determinant, or a diagonal matrix as \\mathrm{diag}(m, m); else None, and nothing is
        read.
        """
        count, start = 2 if here.text in ROMAN else 1, here.at
        following = here.items[here.place :][: count + 1]
        word = "".join(texts(flattened(following[:count]))).removeprefix("\\")
        inside = _bracket(following[-1], ("(", "[", r"\{")) if following[count:] else None
        if word == "det" and {*texts(following[count:])} & {*MATRICES}:
            inside = following[count:]
        if word != "det" and (word != "diag" or inside is None):
            return None
        here.place += count + (inside is not None)
        if word == "det" or inside is None:
            matrix = self.factor(here).value if inside is None else self.expression(inside)
            if isinstance(matrix, Node):
                raise Unread("the determinant of what is no matrix", start)
            return replace(determinant(matrix), at=(start, here.end))
        entries = [self.number(it) for it in split(inside, ",")]
        found = np.full((len(entries), len(entries)), ZERO)
        np.fill_diagonal(found, entries)
        return found

    def choice(self, rows: list[list[list[Token]]], item: Token) -> Node:
        """A piecewise value, from rows of a value and its condition."""
        pairs = []
        for value, condition in rows:
            if value and value[-1].text == ",":
                value = value[:-1]
            pair = (self.number(value), self.condition(condition, item.at[0]))
            pairs.append(Node("call", pair, "Tuple", (value[0].at[0], condition[-1].at[1])))
        return Node("call", tuple(pairs), "Piecewise", item.at)

    def condition(self, items: Tokens, place: int) -> Node:
        """A relation, or a chain of relations, with or without a word as "if" before it.

        The word "otherwise" is the relation 0 = 0.
        """
        unread = (r"\quad", r"\qquad", ",", ".", *ROMAN)
        items = [it for it in items if it.text not in unread]
        # A word is a group of letters; "if" may also be printed as two letters.
        in_word = itertools.takewhile(lambda it: it.text in ("{", "i", "f"), items)
        count = len([*in_word])
        word = "".join(texts(flattened(items[:count]))).rstrip(".,")
        if word in ("otherwise", "else") and count == len(items):
            return Node("call", (ZERO, ZERO), "Eq", (place, place))
        if word not in ("", "if", "for", "when", "where"):
            raise Unread(f"the word {word} is not read", place)
        signs = [RELATIONS[it.text] for it in items if it.text in RELATIONS]
        if not signs:
            raise Unread("a condition without a relation", place)
        values = map(self.number, split(items[count:], *RELATIONS))
        relations = tuple(
            Node("call", (a, b), sign, (a.at[0], b.at[1]))
            for sign, (a, b) in zip(signs, itertools.pairwise(values), strict=True)
        )
        return relations[0] if len(relations) == 1 else Node("call", relations, "And")

    def function(self, here: Cursor) -> str:
        """SymPy's name of the function that comes next; else empty, and nothing is read."""
        if self.names.functions:
            name, power = self.name(ahead := replace(here))
            if name in self.names.functions and power is None:
                here.place = ahead.place
                return self.names.functions[name]
        text, following = here.text, here.items[here.place :][:6]
        if text == r"\log":
            raise Unread(r"\log is natural or decadic; print \ln", here.at, ("log", "log10"))
        count = 1
        word = text.removeprefix("\\")
        if text in ROMAN:
            count = 2
            word = re.sub(r"[\W_]", "", "".join(texts(flattened(following[:2]))))
        elif word not in FUNCTIONS:
            letters = "".join(
                it.text if re.fullmatch("[a-z]", it.text) else " " for it in following
            )
            spelled = (it for it in FUNCTIONS if it not in tree.OF_SEVERAL)
            word = max((it for it in spelled if letters.startswith(it)), key=len, default="")
            if word and {*word} <= self.names.symbols:
                raise Unread(f"{word} or a product", here.at, (word, "*".join(word)))
            count = len(word)
        if word not in FUNCTIONS:
            return ""
        here.place += count
        return FUNCTIONS[word]

    def call(self, name: str, here: Cursor, begin: int) -> Factor:
        """A function with its exponent and its argument, in brackets or without."""
        power = None
        open_end = ""
        if here.text == "^":
            here.take()
            power = self.number(_argument(here))
            if power.kind == "neg":
                readings = (f"a{name}(…)", f"1/{name}(…)")
                raise Unread("the inverse function, or its reciprocal", begin, readings)
        if here.item is None:
            raise Unread(f"{name} without an argument", begin)
        bracket = _bracket(here.item, ("(", "[", r"\{"))
        if bracket is not None or here.text == "{":
            whole = here.take().items or ()
            arguments = tuple(map(self.number, split(whole if bracket is None else bracket, ",")))
        else:
            argument, open_end = self.bare_argument(name, here)
            arguments = (argument,)
        is_several = name in tree.OF_SEVERAL
        most = 2 if name == "atan2" else len(arguments)
        if (len(arguments) > 1) is not is_several or len(arguments) > most:
            raise Unread(f"{name} with {len(arguments)} in brackets", begin)
        value = Node("call", arguments, name, (begin, here.end))
        if here.text in ("^", "'"):
            if bracket is None or here.text == "'" or power is not None:
                raise Unread(f"what is attached belongs to {name} or to its argument", begin)
            return self.powered(value, here, begin)
        return Factor(value if power is None else tree.power(value, power, value.at), open_end)

    def bare_argument(self, name: str, here: Cursor) -> tuple[Node, str]:
        """An argument without brackets: a number, a name, or a number times one of these.

        The text says how it may go on, as ``Factor.open`` does.
        """
        start, is_group = here.at, here.item is not None and here.item.items is not None
        if self.function(replace(here)) or here.text in ("+", "-"):
            raise Unread(f"the argument of {name} has no brackets", start)
        argument = node_of(self.factor(here).value)
        if argument.kind == "pow" and not is_group:
            readings = (f"{name}({printed(argument)})", f"{name}({printed(argument.args[0])})**…")
            raise Unread(f"the exponent is of {name} or of its argument", start, readings)
        if self.is_times(texts(here.items[here.place :][:1])):  # the phase, as in cos Ω t
            return node_of(product([argument, self.factor(here).value])), "argument"
        if not _numeric(argument):
            return argument, "argument"
        if here.item is None:
            return argument, "number"
        start = here.at
        if here.text in (*TIMES, "/") or self.function(replace(here)):
            raise Unread(f"the argument of {name} ends nowhere", start)
        more = node_of(self.factor(here).value)
        if more.kind == "pow":
            raise Unread(f"the exponent is of {name} or of its argument", start)
        factors: list[Value] = [argument, more]
        if self.is_times(texts(here.items[here.place :][:1])):
            factors.append(self.factor(here).value)
        return node_of(product(factors)), "argument"

    def derivative(self, here: Cursor) -> Factor | None:
        """A derivative printed with differentials, dx/dt, d/dt x or ∂V/∂x; else None, and nothing
        is read.
        """
        begin, start = here.place, here.at
        is_fraction = here.text in (*FRACTIONS, *_DERIVATIVES)
        if here.text == r"\partial" and (order := self.order_by_index(here)):
            return self.rate(self.differentiated(here, start), order, True, here, start)
        differentials = self.differentials(here)
        if differentials is None:
            here.place = begin
            return None
        sign, what, steps = differentials
        if not all(map(self.is_time, steps)):
            return self.slope(what, steps, here, start)
        is_partial = sign == r"\partial"
        if what:
            value = self.expression(what)
        elif is_fraction or is_partial:
            value = self.differentiated(here, start)
        else:
            raise Unread("a derivative of what stands behind it; print it as a fraction", start)
        return self.rate(value, len(steps), is_partial, here, start)

    def differentials(self, here: Cursor) -> tuple[str, list[Token], list[Tokens]] | None:
        """The sign d or ∂ of a fraction of differentials, what stands behind it above the line, and
        by what it is differentiated, step by step; None if no such fraction comes next.
        """
        start, following = here.at, here.items[here.place :]
        if sign := _DERIVATIVES.get(here.text):
            here.take()
            times = label_of(here.take().items or ()) if here.text == "[" else "1"
            given = [_argument(here) for _ in range(3) if here.text == "{"]
            if not given or not _is_order(times):
                raise Unread("a derivative of this order is not read", start)
            by = given[1:] or given
            return sign, [*given[0]] if given[1:] else [], by * int(times)
        if here.text in FRACTIONS:
            here.take()
            above, below = _argument(here), _argument(here)
        else:
            above, *behind = split(following, "/")
            plain = _inside(behind[0]) if behind else []
            below = plain[: 4 if "^" in texts(plain[:3]) else 2]
            here.place += len(above) + 1 + sum(map(len, behind[:1])) - len(plain) + len(below)
        up, down = (texts(flattened(part)) for part in (above, below))
        if len(down) < 2 or down[0] not in ("d", r"\partial") or up[:1] != down[:1]:
            return None
        what, power = [*_inside(above)[1:]], "1"
        if texts(what[:1]) == ["^"]:
            power, what = label_of(what[1:2]), what[2:]
        steps: list[Tokens] = []
        for part in split(_inside(below), down[0])[1:]:
            times = label_of(part[-1:]) if texts(part[-2:-1]) == ["^"] else ""
            steps += [part[:-2]] * int(times) if _is_order(times) else [part]
        if str(len(steps)) != power:
            raise Unread("a derivative of this order is not read", start)
        return down[0], what, steps

    def differentiated(self, here: Cursor, start: int) -> Value:
        """The factor behind an operator as d/dt, where it is clear that it ends."""
        if here.item is None:
            raise Unread("a derivative of nothing; print an operator multiplied out", start)
        place, bracketed = here.at, here.text == "("
        value = self.factor(here).value
        has_end = bracketed or _bracket(here.items[here.place - 1]) is not None
        is_whole = here.items[here.place - 1].text == "("
        is_power = isinstance(value, Node) and value.kind == "pow" and not is_whole
        if is_power or not (here.item is None or has_end):
            raise Unread("the derivative ends nowhere; print brackets", place)
        return value

    def rate(self, value: Value, order: int, is_partial: bool, here: Cursor, start: int) -> Factor:
        """The derivative of a value by time, of an order."""
        is_name = isinstance(value, Node) and value.kind == "symbol"
        if is_partial and is_name and node_of(value).value not in self.names.next:
            said = r"of a name by time alone; print \frac{d}{dt} where all of it is meant"
            raise Unread(f"a partial derivative {said}", start)
        at = start, here.end
        for _ in range(order):
            value = each(self.names.rate, value)
        return self.powered(each(lambda it: moved(it, at), value), here, start)

    def order_by_index(self, here: Cursor) -> int:
        """The order of ∂_t, ∂_tt or ∂_t²; 0, and nothing is read, if none of these comes next."""
        begin, marks = here.place, {"_": list[str](), "^": ["1"]}
        here.take()
        while here.text in marks:
            sign = here.take().text
            marks[sign] = texts(flattened(_argument(here)))
        power = "".join(marks["^"])
        if self.is_times(marks["_"]) and _is_order(power):
            return len(marks["_"]) * int(power)
        here.place = begin
        return 0

    def slope(self, what: list[Token], steps: Sequence[Tokens], here: Cursor, start: int) -> Factor:
        """The derivative of a name by its argument, or a partial derivative by other names."""
        named = Cursor(what)
        name, power = self.name(named)
        node = self.names.of(name, (start, here.end)) if name and power is None else ZERO
        inside = _bracket(named.item) if node.kind == "symbol" else None
        argument = None if inside is None else self.argument(node, inside)
        is_called = argument is not None and not argument.at_rest
        if node.kind != "symbol" or named.items[named.place + is_called :]:
            value = self.expression(what) if what else self.differentiated(here, start)
            node = node_of(value, start)
        column = self.expression(steps[0])
        if not isinstance(column, Node):  # as by all coordinates
            return Factor(each(lambda it: self.names.derived(node, it.value), column))
        for step in steps:
            by = self.number(step)
            argument = self.argument(node, step)
            if argument is None and by.kind != "symbol":
                raise Unread(f"a derivative by {printed(by)}, which is no name", start)
            if node.kind == "symbol":
                node = self.names.derived(node, by.value if argument is None else "")
            elif by.value in {*self.names.next, *self.names.next.values()}:
                node = self.names.partial(node, by.value)
            else:
                raise Unread("a derivative of what is no name; define it", start)
        return self.powered(self.by_own_argument(self.applied(node, here)), here, start)

    def with_index(self, name: Name, index: Tokens) -> Name:
        """A name with an index; x with the index ,tt is its second rate unless that is a name."""
        named = replace(name, sub=label_of(index))
        *parts, times = split(flattened(index), ",")
        if parts and self.is_times(texts(times)) and self.names.known(named, (0, 0)) is None:
            plain = replace(name, sub="".join(map(label_of, parts)))
            node = self.names.known(plain, (0, 0))
            if node is not None and self.names.moves(node):
                return replace(plain, order=name.order + len(times), has_dots=True)
        return named

    def only_name(self, items: Tokens) -> Name | None:
        """The name that the items are; None if they are more, or have an exponent."""
        here = Cursor(items)
        name, power = self.name(here)
        return name if here.item is None and power is None else None

    def name(self, here: Cursor) -> tuple[Name | None, Tokens | None]:
        """The next name, with indices and primes, and its exponent; else None twice, and nothing
        is read.
        """
        begin, it = here.place, here.item
        if it is None:
            return None, None
        here.take()
        if it.text == r"\Delta" and self.names.known(Name("Delta"), it.at) is None:
            of, power = self.name(here)
            if of is not None:  # a difference, as Δk
                return replace(of, base=rf"\Delta {of.base}"), power
        name: Name | None = None
        letters = re.compile(
            r"\\(?:var)?(?:alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi"
            r"|pi|rho|sigma|tau|upsilon|phi|chi|psi|omega"
            r"|Gamma|Delta|Theta|Lambda|Xi|Pi|Sigma|Phi|Psi|Omega)"
            r"|\\ell|\\[ij]math|[A-Za-z]"
        )
        if it.items is not None:
            name = self.only_name(it.items) if it.text == "{" else None
        elif it.text in (r"\dot", r"\ddot", *OVER):
            dots = texts(_argument(here)) if it.text in OVER else ["."] * it.text.count("d")
            order = len(dots) if {*dots} <= {".", r"\cdot"} else 0
            name = self.only_name(_argument(here))
            if name is None or not order:
                raise Unread("dots on what is no name", it.at[0])
            name = replace(name, order=name.order + order, has_dots=True)
        elif it.text in (*ROMAN, *BOLD, *ACCENTS):
            argument = _argument(here)
            style = "" if it.text in ROMAN else ACCENTS.get(it.text, it.text) + " "
            if texts(argument[:1]) in ([r"\dot"], [r"\ddot"]):
                inner = self.only_name(argument)
                name = inner and replace(inner, base=f"{style}{inner.base}")
            else:
                word = "".join(one.text.removeprefix("\\") for one in flattened(argument))
                name = Name(f"{style}{word}")
        elif count := self.names.word(here.items, begin):
            here.place = begin + count
            name = Name("".join(texts(here.items[begin : here.place])))
        elif letters.fullmatch(it.text):
            name = Name(it.text.removeprefix("\\"))
        if name is None:
            here.place = begin
            return None, None
        exponent: Tokens | None = None
        while here.text in ("_", "^", "'"):
            sign, place = here.text, here.at
            here.take()
            if sign == "'":
                name = replace(name, order=name.order + 1)
                continue
            argument = _argument(here)
            label = label_of(argument)
            raised = texts(flattened(argument))
            primes = raised.count(r"\prime") + raised.count("'")
            is_roman = bool(argument) and argument[0].text in ROMAN
            if sign == "_":
                if name.sub:
                    raise Unread("two indices", place)
                indexed = self.with_index(name, argument)
                if label == "+" and self.names.known(indexed, it.at) is None:
                    here.place -= 2  # the positive part
                    break
                name = indexed
            elif primes and raised[:primes] == raised[:1] * primes:
                name = replace(name, order=name.order + primes)
                exponent = argument[primes:] or exponent
            elif label in ("*", "+", "-", "ast", "star") or (
                is_roman and not (label == "T" and self.is_matrix(name))
            ):
                # An upper index, no exponent.
                name = replace(name, sup="*" if label in ("ast", "star") else label)
            elif exponent is not None:
                raise Unread("two exponents", place)
            else:
                exponent = argument
        if exponent is not None and not name.sup:
            # An upper index that is listed under [symbols], as in k^{NL}.
            listed = replace(name, sup=label_of(exponent))
            if listed in self.names.renamed:
                return listed, None
        return name, exponent


def _rows(item: Token) -> list[list[list[Token]]]:
    """Cells of the rows of an environment, without the column specification of an array."""
    inner = (item.items or ())[item.text == "array" :]
    return [split(row, "&") for row in split(inner, "\\\\") if row]


def _argument(here: Cursor) -> Tokens:
    """The argument of a command: a group, or the next token."""
    it = here.take()
    if it.items is not None and it.text == "{":
        return it.items
    if it.text in (*ROMAN, *BOLD, *ACCENTS) and here.item is not None:
        return [it, here.take()]
    if it.items is not None or it.text in (*FRACTIONS, r"\sqrt", r"\dot", r"\ddot", "^", "_"):
        raise Unread("an argument without braces", it.at[0])
    return [it]


def _indexed(items: Tokens, index: str, value: str) -> list[Token]:
    """Items with an index replaced by its value; i + 1 in braces is then a number."""
    found = []
    for it in items:
        if it.items is not None:
            inside = _indexed(it.items, index, value)
            if step := re.fullmatch(r"(\d)([+-]\d)", "".join(texts(inside))):
                inside = [replace(inside[0], text=str(int(step[1]) + int(step[2])))]
            found.append(replace(it, items=tuple(inside)))
        else:
            found.append(replace(it, text=value) if it.text == index else it)
    return found


def _inside(items: Tokens) -> Tokens:
    """Tokens without a style on the first one: \\mathrm{d} x as d x."""
    if items and items[0].text in ROMAN:
        return [*flattened(items[1:2]), *items[2:]]
    return items


def _bracket(it: Token | None, kinds: tuple[str, ...] = ("(",)) -> Tokens | None:
    """The items inside a bracket of one of the kinds, with or without braces around it; else
    None.
    """
    while it is not None and it.text == "{" and it.items is not None and len(it.items) == 1:
        it = it.items[0]
    return it.items if it is not None and it.text in kinds else None


def _is_sign(items: Tokens, number: int) -> bool:
    """Whether the item of a number is a sign before a term, not one in an exponent or index.

    Raises
    ------
    Unread
        If the sign stands behind an operator.
    """
    if items[number].text not in ("+", "-", r"\pm", r"\mp"):
        return False
    earlier, before = ["", "", *texts(items[:number])][-2:]
    if before in (*TIMES, "/") and earlier != "^":
        raise Unread("a sign behind an operator; print brackets", items[number].at[0])
    return before not in ("^", "_")


def _span(items: Tokens) -> tuple[int, int]:
    """The range of characters of the items in the print."""
    return items[0].at[0], items[-1].at[1]


def _over(value: Value, items: Tokens) -> Value:
    """A value whose place in the print is that of all items it was read from, brackets too."""
    if isinstance(value, Node) and value.kind != "number":
        return replace(value, at=_span(items))
    return value


def _numeric(value: Value) -> bool:
    """Whether a value is a number or a quotient of numbers."""
    if not isinstance(value, Node):
        return False
    if value.kind == "div":
        return all(map(_numeric, value.args))
    return value.kind == "number" and value.value != "pi"
