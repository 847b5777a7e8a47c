"""C99 from the same specifications as the Python modules, and from them also bounds on the rounding errors.

The bounds follow the emitted statements: rounding multiplies each monomial of a result by at most (1 + u)^k,
with u the unit roundoff and k the operations that it passes through, so k u times the same expression with
all terms positive bounds the error. What an argument is off by enters through the derivative.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import sympy as sp

from .. import nomenclature as nm
from . import c99_cost as cost
from .c99_equilibria import EQUILIBRIA
from .c99_export import EXAMPLE, MAKEFILE
from .c99_header import HEADER, SOURCE_HEAD
from .c99_motion import MOTION
from .functions import Function, Module
from .python import AlgebraPrinter
from .python import _meaning as meaning
from .statements import flatten, straight_line

_WIDTH = 124
_PUBLIC = (
    "contact_quartic", "liftoff_quartic", "f_coefficients", "f", "f_slope", "f_curvature",
    "t_quartic", "resolvent", "state", "residuals", "stiffness", "invariants", "damping", "characteristic",
    "spring_length", "friction", "rhs", "regime_rhs", "regime_jacobian", "energy",
)  # fmt: skip
#: Names that mean something else in C.
_NAMES = {"cos": "cos_theta", "sin": "sin_theta"}
#: Functions whose cost stands at the head of the source.
_TABLE = (
    "spragsym_prepare",
    "spragsym_equilibria",
    "spragsym_equilibria_batch",
    "spragsym_step",
    "scaled_line",
    "split",
    "guess",
    "examine",
    "runge_kutta",
)
_LARGEST_EXACT = 2**53
#: Largest relative error of one rounded operation.
_UNIT = sp.Symbol("unit", positive=True)
_ROUNDOFF = {_UNIT: sp.Rational(1, 2**53)}
#: Roundings in cos θ and sin θ computed from tan(θ/2), and units in cos θ₀ and sin θ₀ within one in the last place.
_INEXACT = {nm.c: 7, nm.s: 4, nm.c0: 2, nm.s0: 2}


class CPrinter(AlgebraPrinter):
    """The statements of the Python printer in C, operation for operation."""

    def _print_Symbol(self, expression: sp.Symbol) -> str:
        return _NAMES.get(expression.name, str(expression.name))

    def _print_Integer(self, expression: sp.Integer) -> str:
        if abs(int(expression)) > _LARGEST_EXACT:
            raise ArithmeticError(f"the integer {expression} would be rounded")
        return f"{int(expression)}.0"

    def _print_One(self, expression: sp.Integer) -> str:
        return "1.0"

    def _print_Zero(self, expression: sp.Integer) -> str:
        return "0.0"

    def _print_NegativeOne(self, expression: sp.Integer) -> str:
        return "-1.0"

    def _print_Rational(self, expression: sp.Rational) -> str:
        # One division of two exact numbers: the rational, rounded once.
        numerator, denominator = sp.Integer(expression.p), sp.Integer(expression.q)
        return f"({self._print_Integer(numerator)}/{self._print_Integer(denominator)})"

    def _print_Pow(self, expression: sp.Pow, rational: bool = False) -> str:
        if expression.exp == 2:
            return f"square({self._print(expression.base)})"
        if expression.exp == -2:
            return f"1.0/square({self._print(expression.base)})"
        return re.sub(r"^1/", "1.0/", super()._print_Pow(expression, rational=rational)).replace("xp.", "")

    def _print_exp(self, expression: sp.exp) -> str:
        return f"exp({self._print(expression.args[0])})"

    def _print_Abs(self, expression: sp.Abs) -> str:
        return f"fabs({self._print(expression.args[0])})"

    def _print_sign(self, expression: sp.sign) -> str:
        return f"sign({self._print(expression.args[0])})"


_PRINTER = CPrinter({"order": None})


@dataclass(frozen=True)
class _Emitted:
    """A static function of the C source."""

    name: str
    text: str
    operations: int


def render(modules: Iterable[Module], header: str) -> dict[str, str]:
    """``c/spragsym.h``, ``c/spragsym.c`` and the example that an export brings along, by path."""
    known = {function.name: function for module in modules for function in module.functions}
    public = [known[name] for name in _PUBLIC]
    statics = [_static(f"algebra_{function.name}", function) for function in public]
    statics += [_static(name, function) for name, function in _internal(known).items()]
    source = "\n".join(
        [
            SOURCE_HEAD,
            *(item.text for item in statics),
            EQUILIBRIA,
            MOTION,
            *(_wrapper(function) for function in public),
        ]
    )
    counted = cost.costs(HEADER + source, {item.name: item.operations for item in statics})
    described = {name: cost.describe(value) for name, value in counted.items()}
    described["block"] = str(cost.constants(source)["BLOCK"])
    described["table"] = "\n".join(f" * - {name}: {described[name]}" for name in _TABLE)
    return {
        "c/spragsym.h": _fill(
            HEADER, header, described, "".join(_prototype(function) for function in public)
        ),
        "c/spragsym.c": _fill(source, header, described),
        "c/main.c": EXAMPLE,
        "c/Makefile": MAKEFILE,
    }


def _fill(text: str, header: str, described: Mapping[str, str], prototypes: str = "") -> str:
    text = re.sub(r"@cost:(\w+)@", lambda match: described[match[1]], text)
    values = {
        "header": textwrap.fill(header, 118, subsequent_indent=" * "),
        "table": described["table"],
        "prototypes": prototypes,
        "block": described["block"],
    }
    return re.sub(r"@(header|table|prototypes|block)@", lambda match: values[match[1]], text)


# ------------------------------------------------------------------------------------------------------- text


def _name(symbol: sp.Symbol) -> str:
    return str(_PRINTER.doprint(symbol))


def _result(function: Function) -> str:
    count = len(list(flatten(function.results)))
    return f"double result[{count}]" if isinstance(function.results, tuple) else "double *result"


def _signature(start: str, function: Function) -> str:
    tied = "\N{NO-BREAK SPACE}"  # a type stays on the line of its name
    arguments = [f"double {_name(symbol)}" for symbol in function.arguments] + [_result(function)]
    listed = ", ".join(argument.replace(" ", tied) for argument in arguments)
    filled = textwrap.fill(f"{start}({listed})", _WIDTH, subsequent_indent="    ", break_long_words=False)
    return filled.replace(tied, " ")


def _static(name: str, function: Function) -> _Emitted:
    """The algebra itself, unchecked."""
    body = straight_line(function)
    results = list(flatten(body.results))
    targets = (
        [f"result[{index}]" for index in range(len(results))]
        if isinstance(function.results, tuple)
        else ["*result"]
    )
    used = {
        symbol
        for expression in [*dict(body.assignments).values(), *results]
        for symbol in expression.free_symbols
    }
    lines = [
        f"/* {function.summary} Source: {function.equations}. Operations: {body.operations}. */",
        _signature(f"INLINE void {name}", function) + " {",
        *(f"    (void){_name(symbol)};" for symbol in function.arguments if symbol not in used),
        *(_statement(f"const double {_name(symbol)}", expression) for symbol, expression in body.assignments),
        *(_statement(target, expression) for target, expression in zip(targets, results, strict=True)),
        "}\n",
    ]
    return _Emitted(name, "\n".join(lines), body.operations)


def _statement(target: str, expression: sp.Expr) -> str:
    line = f"    {target} = {_PRINTER.doprint(expression)};"
    return textwrap.fill(
        line, _WIDTH, subsequent_indent=" " * 8, break_long_words=False, break_on_hyphens=False
    )


def _wrapper(function: Function) -> str:
    """The public function: no null pointer in, no NaN out."""
    count = len(list(flatten(function.results)))
    passed = ", ".join([*(_name(symbol) for symbol in function.arguments), "value"])
    call = textwrap.fill(f"    algebra_{function.name}({passed});", _WIDTH, subsequent_indent=" " * 8)
    given = ", ".join(_name(symbol) for symbol in function.arguments)
    arguments = textwrap.fill(f"    const double given[] = {{{given}}};", _WIDTH, subsequent_indent=" " * 8)
    return (
        _signature(f"spragsym_status spragsym_{function.name}", function) + " {\n"
        f"{arguments}\n"
        f"    double value[{count}];\n"
        f"    if (!result || !finite_all({len(function.arguments)}, given)) {{\n"
        "        return SPRAGSYM_BAD_INPUT;\n"
        "    }\n"
        f"{call}\n"
        f"    return deliver({count}, value, result);\n"
        "}\n"
    )


def _prototype(function: Function) -> str:
    meanings = {
        _name(symbol): meaning(symbol)[0].replace("θ₀", "theta0").replace("θ", "theta")
        for symbol in function.arguments
    }
    described = "".join(f" * @param {name} {text}\n" for name, text in meanings.items())
    operations = straight_line(function).operations
    summary = textwrap.fill(f"{function.summary} Source: {function.equations}.", 118, subsequent_indent=" * ")
    return (
        f"\n/**\n * {summary}\n{described}"
        f" * @param result {function.returns}\n * Operations: {operations}.\n */\n"
        + _signature(f"spragsym_status spragsym_{function.name}", function)
        + ";\n"
    )


# ----------------------------------------------------------------------------------------------------- bounds


def _internal(known: Mapping[str, Function]) -> dict[str, Function]:
    """What the algorithms need beside the public functions, made from these by algebra and calculus."""
    f, slope, curvature, state = known["f"], known["f_slope"], known["f_curvature"], known["state"]
    depressed, measures = _depressed(known["resolvent"]), _measures(known["stiffness"], known["invariants"])
    coefficients = (nm.fa, nm.fb, nm.fd, nm.fm)
    off = {symbol: sp.Symbol(f"{symbol}_error", positive=True) for symbol in coefficients}
    angle, length = sp.Symbol("angle_error", positive=True), sp.Symbol("L_error", positive=True)
    entered = [(error, symbol) for symbol, error in off.items()]
    bounds = {
        "bound_f_coefficients": _bound(known["f_coefficients"], []),
        "bound_f": _bound(f, entered),
        "bound_f_slope": _bound(slope, entered),
        "bound_depressed": _bound(depressed, entered),
        "bound_state": _bound(state, [(angle, None)], (angle,)),
        "bound_measures": _bound(measures, [(angle, None), (length, nm.L)]),
    }
    largest = _majorants(curvature)[0][0].subs({nm.c: 1, nm.s: 1})
    return {
        "algebra_depressed": depressed,
        "algebra_measures": measures,
        **bounds,
        "curvature_f": Function(
            "curvature_f", "Bound on |f″| over all θ.", curvature.equations, coefficients, largest, "bound"
        ),
    }


def _depressed(resolvent: Function) -> Function:
    """P and Q of the resolvent without its quadratic term."""
    r0, r1, r2 = flatten(resolvent.results)
    P = sp.expand(r1 - r2**2 / 3)
    Q = sp.expand(r0 - r1 * r2 / 3 + 2 * r2**3 / 27)
    return replace(
        resolvent,
        name="depressed",
        summary="P and Q of z³ + P z + Q with z = ℓ + r2/3, the resolvent without its quadratic term.",
        results=(P, Q),
        returns="P, Q",
    )


def _measures(stiffness: Function, invariants: Function) -> Function:
    """Trace, determinant and discriminant straight from the equilibrium."""
    entries = dict(zip(invariants.arguments, flatten(stiffness.results), strict=True))
    return replace(
        stiffness,
        name="measures",
        summary=invariants.summary,
        equations=invariants.equations,
        results=invariants.results,
        returns=invariants.returns,
        shorthands={**stiffness.shorthands, **entries},
    )


def _bound(
    function: Function, entered: list[tuple[sp.Symbol, sp.Symbol | None]], squared: tuple[sp.Symbol, ...] = ()
) -> Function:
    """Bounds on the errors of the results: rounding, and ``entered`` errors of arguments or of θ (None).

    Of ``squared`` errors of θ the second order counts too, doubled, for where the first derivative vanishes.
    """
    rounding = [(count + 1) * _UNIT * majorant for majorant, count in _majorants(function)]
    spelled = [_spelled(result, function) for result in flatten(function.results)]
    carried = [
        sum((sp.Abs(_derivative(result, symbol)) * error for error, symbol in entered), sp.S.Zero)
        + sum(
            (sp.Abs(_derivative(_derivative(result, None), None)) * error**2 for error in squared), sp.S.Zero
        )
        for result in spelled
    ]
    bounds = tuple(one + other for one, other in zip(rounding, carried, strict=True))
    return Function(
        f"bound_{function.name}",
        f"Bound on the error of: {function.returns}.",
        function.equations,
        (*function.arguments, *(error for error, _ in entered)),
        bounds if isinstance(function.results, tuple) else bounds[0],
        "bounds",
        _ROUNDOFF,
    )


def _spelled(expression: sp.Expr, function: Function) -> sp.Expr:
    while expression.free_symbols - set(function.arguments):
        expression = expression.subs(function.shorthands)
    return expression


def _derivative(expression: sp.Expr, symbol: sp.Symbol | None) -> sp.Expr:
    if symbol is not None:
        return sp.factor_terms(sp.diff(expression, symbol))
    return sp.factor_terms(nm.c * sp.diff(expression, nm.s) - nm.s * sp.diff(expression, nm.c))


def _majorants(function: Function) -> list[tuple[sp.Expr, int]]:
    """For each result: its expression with all terms positive, and the most roundings a monomial meets."""
    body = straight_line(function)
    known: dict[sp.Symbol, tuple[sp.Expr, int]] = {
        symbol: (sp.Abs(symbol), _INEXACT.get(symbol, 0)) for symbol in function.arguments
    }
    for symbol, expression in body.assignments:
        known[symbol] = _majorant(expression, known)
    return [_majorant(expression, known) for expression in flatten(body.results)]


def _majorant(expression: sp.Expr, known: Mapping[sp.Symbol, tuple[sp.Expr, int]]) -> tuple[sp.Expr, int]:
    if expression.is_Symbol:
        return known[expression]
    if expression.is_Number:
        return abs(expression), 0 if expression.is_Integer else 1
    parts = [_majorant(part, known) for part in expression.args if not (expression.is_Pow and part.is_Number)]
    sizes, counts = [part[0] for part in parts], [part[1] for part in parts]
    if expression.is_Add:
        return sp.Add(*sizes), max(counts) + len(parts) - 1
    if expression.is_Mul:
        return sp.Mul(*sizes), sum(counts) + len(parts) - 1
    if expression.is_Pow and expression.exp == 2:
        return sizes[0] ** 2, 2 * counts[0] + 1
    if expression.is_Pow and expression.exp == -1 and _keeps_its_sign(expression.base, known):
        return 1 / sizes[0], counts[0] + 1
    raise ArithmeticError(f"no bound is known for the rounding of {expression}")


def _keeps_its_sign(expression: sp.Expr, known: Mapping[sp.Symbol, tuple[sp.Expr, int]]) -> bool:
    """A denominator that is one argument, or a sum of stiffness ratios, does not cancel."""
    size, _ = _majorant(expression, known)
    ratios = {sp.Abs(symbol) for symbol in (nm.alpha, nm.beta, nm.sigma, nm.nbar)}
    parts = set(sp.Add.make_args(size))
    return len(parts) == 1 or parts <= ratios
