"""Generated code against other generators on the same expressions; a Markdown table.

``python -m benchmarks.bench_codegen``: K and the right-hand side with its Jacobian, from the derivation's own SymPy expressions.
Time to generate, time a call on floats, operations, size of the code, and the worst error against 50 digits. Generators that are
not installed are left out, with a line that says so.
"""

from __future__ import annotations

import importlib
import inspect
import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from derive.emit import statements
from derive.emit.targets.python import algebra
from derive.kang_nam import catalogue, mechanics, stability
from derive.kang_nam import nomenclature as nm
from derive.kang_nam.catalogue import motion
from spragsym.generated import stability as _stability
from spragsym.generated.models.kang_nam import algebra as _motion

_SIDE = nm.side
_CALLS = 2000


@dataclass(frozen=True)
class Subject:
    """Expressions of some arguments, and our generated function for them."""

    name: str
    arguments: tuple[sp.Symbol, ...]
    expressions: tuple[sp.Expr, ...]
    ours: Callable[..., Any]
    module: str
    function: str


@dataclass(frozen=True)
class Outcome:
    """One generator's result on one subject."""

    generator: str
    generate: float
    call: Callable[..., Any]
    size: str


def subjects() -> tuple[Subject, ...]:
    """K, and the accelerations with their Jacobian."""
    K = stability.stiffness()
    in_K = (nm.c, nm.s, nm.L, nm.mu0, nm.alpha, nm.sigma, nm.beta, nm.nbar)
    state = (nm.x, nm.y, nm.vx, nm.vy)
    length = mechanics.spring_length()
    equations = mechanics.motion()
    regime = {nm.mu: mechanics.smooth_friction(_SIDE), nm.n: mechanics.contact_family()}
    rates = [
        sp.solve(residual, rate)[0].subs(regime, simultaneous=True).subs(nm.L, length)
        for residual, rate in ((equations.x, equations.ax), (equations.y, equations.ay))
    ]
    jacobian = sp.Matrix(rates).jacobian(state)
    in_motion = (*state, nm.c0, nm.s0, nm.mu0, nm.kappa, nm.alpha, nm.sigma, nm.beta, nm.V, nm.creep, nm.nbar, _SIDE)

    rhs, jacobian_of_rhs = inspect.unwrap(_motion.regime_rhs), inspect.unwrap(_motion.regime_jacobian)

    def rhs_and_jacobian(*values: Any) -> tuple[Any, ...]:
        return rhs(*values, 1, xp=math), jacobian_of_rhs(*values, 1, xp=math)

    return (
        Subject("K", in_K, tuple(K), inspect.unwrap(_stability.stiffness), "stability", "stiffness"),
        Subject("rhs and Jacobian", in_motion, (*rates, *jacobian), rhs_and_jacobian, "motion", "regime_jacobian"),
    )


def main() -> None:
    """Print a table for each subject."""
    for subject in subjects():
        rng = np.random.default_rng(41)
        points = [_point(subject, rng) for _ in range(200)]
        exact = [_exact(subject, point) for point in points]
        print(f"\n**{subject.name}**, {len(subject.arguments)} arguments, {len(subject.expressions)} results\n")
        print("| generator | generate, s | µs a call | size | worst relative error |")
        print("|---|---|---|---|---|")
        for build in (_ours, _lambdify, _symforce, _wrenfold, _casadi):
            try:
                outcome = build(subject)
            except ModuleNotFoundError as error:
                print(f"| {build.__name__[1:]} | not installed: {error.name} | | | |")
                continue
            error = max(_error(outcome.call(*point), value) for point, value in zip(points, exact, strict=True))
            begin = time.perf_counter()
            for call in range(_CALLS):
                outcome.call(*points[call % len(points)])
            seconds = (time.perf_counter() - begin) / _CALLS
            print(f"| {outcome.generator} | {outcome.generate:.3f} | {1e6 * seconds:.2f} | {outcome.size} | {error:.1e} |")


def _point(subject: Subject, rng: np.random.Generator) -> list[float]:
    values = {str(symbol): float(rng.uniform(0.1, 1.0)) for symbol in subject.arguments}
    values.update({name: 1.0 for name in ("nbar", "side") if name in values})
    if "cos" in values:
        angle = float(rng.uniform(0.1, 3.0))
        values["cos"], values["sin"] = np.cos(angle), np.sin(angle)
    if "y" in values:
        values["y"] = -0.1 * values["y"]
    return list(values.values())


def _exact(subject: Subject, point: Sequence[float]) -> list[mpmath.mpf]:
    with mpmath.workdps(50):
        function = sp.lambdify(subject.arguments, subject.expressions, "mpmath")
        return [mpmath.mpf(value) for value in function(*map(mpmath.mpf, point))]


def _flat(result: Any) -> list[float]:
    if isinstance(result, tuple | list):
        return [value for item in result for value in _flat(item)]
    return [float(value) for value in np.asarray(result, dtype=float).ravel()]


def _error(result: Any, exact: list[mpmath.mpf]) -> float:
    size = max(map(abs, exact))
    return max(
        float(abs(value - true) / max(abs(true), mpmath.mpf(2) ** -20 * size))
        for value, true in zip(_flat(result), exact, strict=True)
    )


# -------------------------------------------------------------------------------------------------- generators


def _ours(subject: Subject) -> Outcome:
    modules = {module.name: module for module in (*catalogue.modules(), motion.module())}
    names = {subject.function, subject.function.replace("jacobian", "rhs")}
    wanted = tuple(one for one in modules[subject.module].functions if one.name in names)
    begin = time.perf_counter()
    texts = [algebra.definition(one) for one in wanted]
    seconds = time.perf_counter() - begin
    operations = sum(statements.straight_line(one).operations for one in wanted)
    lines = sum(text.count("\n") for text in texts)
    return Outcome("ours", seconds, subject.ours, f"{operations} operations, {lines} lines with docs")


def _lambdify(subject: Subject) -> Outcome:
    begin = time.perf_counter()
    function = sp.lambdify(subject.arguments, subject.expressions, "math", cse=True)
    seconds = time.perf_counter() - begin
    temporaries, reduced = sp.cse(subject.expressions)
    operations = sum(int(sp.count_ops(value)) for _, value in temporaries) + sum(int(sp.count_ops(value)) for value in reduced)
    return Outcome("SymPy lambdify(cse=True)", seconds, function, f"{operations} operations")


def _symforce(subject: Subject) -> Outcome:
    importlib.import_module("symforce")
    import symforce.symbolic as sf
    from symforce import codegen
    from symforce.codegen import codegen_util
    from symforce.values import Values

    # SymForce has no symbols of other packages, and d is a name that it generates itself.
    renamed = {symbol: sp.Symbol(f"{symbol}_") for symbol in subject.arguments}
    begin = time.perf_counter()
    results = {f"r{i}": sf.sympify(expression.subs(renamed)) for i, expression in enumerate(subject.expressions)}
    generated = codegen.Codegen(
        inputs=Values(**{str(symbol): sf.Symbol(str(symbol)) for symbol in renamed.values()}),
        outputs=Values(**results),
        config=codegen.PythonConfig(),
        name="subject",
    ).generate_function()
    seconds = time.perf_counter() - begin
    function = codegen_util.load_generated_function("subject", generated.function_dir)
    text = next(generated.function_dir.glob("subject.py")).read_text(encoding="utf-8")
    return Outcome("SymForce", seconds, function, f"{text.count(chr(10))} lines")


def _wrenfold(subject: Subject) -> Outcome:
    importlib.import_module("wrenfold")
    from wrenfold import code_generation, sym
    from wrenfold.type_annotations import FloatScalar

    names = [f"v{i}" for i in range(len(subject.arguments))]

    def described(**values: Any) -> Any:
        table = {str(symbol): value for symbol, value in zip(subject.arguments, values.values(), strict=True)}
        return [code_generation.OutputArg(sym.vector(*(_to_wrenfold(e, table, sym) for e in subject.expressions)), name="out")]

    # wrenfold reads its arguments from a signature.
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    model: Any = described
    model.__signature__ = inspect.Signature([inspect.Parameter(name, kind) for name in names])
    model.__annotations__ = dict.fromkeys(names, FloatScalar)
    begin = time.perf_counter()
    function, source = code_generation.generate_python(model)
    seconds = time.perf_counter() - begin
    return Outcome("wrenfold", seconds, function, f"{source.count(chr(10))} lines")


def _casadi(subject: Subject) -> Outcome:
    import casadi

    begin = time.perf_counter()
    symbols = [casadi.SX.sym(str(symbol)) for symbol in subject.arguments]
    table = {"sqrt": casadi.sqrt, "exp": casadi.exp, "Abs": casadi.fabs, "sign": casadi.sign}
    translated = sp.lambdify(subject.arguments, [_plain(e) for e in subject.expressions], [table])(*symbols)
    function = casadi.Function("subject", symbols, [casadi.vertcat(*translated)])
    seconds = time.perf_counter() - begin
    return Outcome(
        "CasADi (virtual machine)",
        seconds,
        lambda *values: np.array(function(*values)),
        f"{function.n_instructions()} instructions",
    )


def _plain(expression: sp.Expr) -> sp.Expr:
    """Without assumptions on symbols, which other packages don't take."""
    return expression.xreplace({symbol: sp.Symbol(str(symbol)) for symbol in expression.free_symbols})


def _to_wrenfold(expression: sp.Expr, table: dict[str, Any], sym: Any) -> Any:
    if expression.is_Symbol:
        return table[str(expression)]
    if expression.is_Rational:
        return sym.rational(int(expression.p), int(expression.q)) if expression.q != 1 else sym.integer(int(expression.p))
    parts = [_to_wrenfold(part, table, sym) for part in expression.args]
    if expression.is_Add:
        return sym.addition(parts)
    if expression.is_Mul:
        return sym.multiplication(parts)
    if expression.is_Pow:
        return sym.pow(*parts)
    if isinstance(expression, sp.exp):
        return sym.exp(parts[0]) if hasattr(sym, "exp") else sym.pow(sym.E, parts[0])
    raise TypeError(f"{type(expression)} has no counterpart")


if __name__ == "__main__":
    main()
