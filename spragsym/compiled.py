"""The solver compiled by numba, from the same functions: :mod:`spragsym.kernel` and :mod:`spragsym.generated`, no second copy.

Each function is compiled with its global names bound to compiled ones. What a compiled function contains is named in its cache
entry by a hash of all sources that go into it, so that a regenerated derivation never meets an old binary.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Sequence
from functools import cache
from math import isnan
from pathlib import Path
from types import FunctionType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import kernel
from .errors import MissingExtraError
from .generated import SOURCE_HASH
from .kernel import (
    apart,
    at_root,
    cosine_and_sine,
    discriminant,
    f_coefficients,
    f_magnitudes,
    factors,
    lone,
    normal,
    root_pair,
)

#: Functions of the kernel in the order in which they build on each other.
_KERNEL = (
    "cosine_and_sine", "depressed", "discriminant", "lone", "normal", "simple_root", "polish", "factors", "root_pair",
    "stability", "apart", "at_root",
)  # fmt: skip


def _numba() -> Any:
    try:
        import numba
    except ModuleNotFoundError as error:
        raise MissingExtraError("the backend 'numba'", "numba", "fast") from error
    return numba


@cache
def _fingerprint() -> str:
    digest = hashlib.sha256(SOURCE_HASH.encode())
    for source in (kernel.__file__, __file__):
        digest.update(Path(source).read_bytes())
    return digest.hexdigest()[:16]


@cache
def _namespace() -> dict[str, Any]:
    """Compiled versions of the kernel, of the generated functions that it uses, and of the two loops below, by name."""
    numba = _numba()
    compiled: dict[str, Any] = {"np": np, "_LENGTH": _LENGTH, "_UNSURE": _UNSURE, "_MEMBER": _MEMBER, "_OUTSIDER": _OUTSIDER}
    compiled.update(sqrt=math.sqrt, absolute=abs, isnan=math.isnan)
    compiled.update(bits=_bitcast("float64", "int64"), number=_bitcast("int64", "float64"))

    def bind(function: Any, inline: str = "always") -> None:
        # Annotations name types that compiled code has no use for.
        bound = FunctionType(function.__code__, compiled, function.__name__, function.__defaults__)
        compiled[function.__name__] = numba.njit(bound, error_model="numpy", inline=inline)

    for scalar in (where, maximum, minimum, copysign, cbrt):
        bind(scalar)
    for name, value in vars(kernel).items():
        if isinstance(value, FunctionType) and value.__module__ != kernel.__name__:
            compiled[name] = numba.njit(value, error_model="numpy", inline="always")
        elif isinstance(value, float):
            compiled[name] = value
    for name in _KERNEL:
        bind(getattr(kernel, name))
    bind(_line)
    for loop in (_guess, _look):
        bind(loop, inline="never")
    return compiled


def where(condition: bool, yes: float, no: float) -> float:
    """numpy.where for scalars."""
    return yes if condition else no


def maximum(one: float, other: float) -> float:
    """numpy.maximum for scalars: NaN if either is."""
    return one if one > other or isnan(one) else other


def minimum(one: float, other: float) -> float:
    """numpy.minimum for scalars: NaN if either is."""
    return one if one < other or isnan(one) else other


def copysign(size: float, sign: float) -> float:
    """numpy.copysign for scalars; a zero counts as positive."""
    return abs(size) if sign >= 0.0 else -abs(size)


def cbrt(x: float) -> float:
    """Cube root of x >= 0 without a call, so that a loop around it can be vectorized.

    A third of the exponent through the bits, then three steps of Halley's method, each of which triples the digits.
    """
    y = number(int(float(bits(x)) * 0.3333333333333333) + 3071306043645493248)  # type: ignore[name-defined]  # noqa: F821  # bound in _namespace
    for _ in range(3):
        cube = y * y * y
        y = y * (cube + 2.0 * x) / (2.0 * cube + x)
    return y if x > 0.0 else 0.0


def _bitcast(given: str, wanted: str) -> Any:
    """A function that reads the bits of one type of number as another."""
    from numba import types
    from numba.extending import intrinsic

    signature = getattr(types, wanted)(getattr(types, given))

    @intrinsic
    def cast(typing_context: Any, value: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.bitcast(arguments[0], context.get_value_type(signature.return_type))

        return signature, generate

    return cast


@cache
def _compiled(function: Callable[..., Any]) -> Any:
    """One of the loops below, compiled for one set of types, and cached on disk under the fingerprint of everything in it."""
    bound = FunctionType(function.__code__, _namespace(), function.__name__)
    bound.__qualname__ = f"{function.__name__}_{_fingerprint()}"
    bound.__module__ = __name__
    return _numba().njit(_signatures()[function.__name__], error_model="numpy", cache=True, nogil=True)(bound)


def solve(values: Sequence[Any], contact: bool, tolerance: float, out: Any) -> NDArray[np.int64]:
    """As :func:`spragsym.solver.solve` in float64: write what is settled to ``out``, return the indices of what is not.

    ``values`` are θ₀, μ₀, κ, α, σ, β, each an array or one number for all points.
    """
    n = out.count.size
    settled = np.empty(n, dtype=np.bool_)
    slots = (getattr(out, name).T for name in ("theta", "L", "x", "y", "error", "stability"))
    columns = (_column(value, n) for value in values)
    _compiled(_solve)(*columns, float(contact), tolerance, 2.0**-53, *slots, out.count, settled)
    np.arctan(out.theta.T, out=out.theta.T)
    np.multiply(out.theta.T, 2.0, out=out.theta.T)
    return np.flatnonzero(~settled)


def _column(value: Any, n: int) -> NDArray[np.float64]:
    """A parameter as a contiguous column: one type for the compiled code, whatever was broadcast."""
    return np.ascontiguousarray(np.broadcast_to(value, (n,)), dtype=np.float64)


@cache
def _signatures() -> dict[str, Any]:
    """Types of the arguments: one set for each loop that Python calls, so that each is compiled once."""
    from numba import types

    given = [types.Array(types.float64, 1, "C", readonly=True)] * 6
    real, codes, numbers, flags = types.float64, types.int8, types.int64[::1], types.boolean[::1]
    return {
        "_solve": types.void(*given, real, real, real, *[real[:, :]] * 5, codes[:, :], numbers, flags),
        "_roots": types.void(*given, real, real[:, ::1], codes[::1]),
    }


# The solver is four loops over a few hundred points at a time, which stay in the processor's cache: guesses for all points; all
# roots that need a look, one after the other; that look; and what it means for each point. The first and the third hold the
# arithmetic and no branch, so that they are vectorized, whatever the number of equilibria.
_LENGTH = 256
# What a look at a root says.
_UNSURE, _MEMBER, _OUTSIDER = 0, 1, 2


def _solve(  # type: ignore[no-untyped-def]
    theta0, mu0, kappa, alpha, sigma, beta, nbar, tolerance, u,
    out_t, out_L, out_x, out_y, out_error, out_stability, out_count, settled,
) -> None:  # fmt: skip
    """Every point: tan(θ/2) in the place of θ, and what is settled."""
    t0, t1, t2, t3 = np.empty(_LENGTH), np.empty(_LENGTH), np.empty(_LENGTH), np.empty(_LENGTH)
    number = np.empty(_LENGTH, np.int64)
    most = 4 * _LENGTH
    r_theta0, r_mu0, r_kappa, r_alpha = np.empty(most), np.empty(most), np.empty(most), np.empty(most)
    r_sigma, r_beta, t = np.empty(most), np.empty(most), np.empty(most)
    L, x, y, radius, error = np.empty(most), np.empty(most), np.empty(most), np.empty(most), np.empty(most)
    verdict, code = np.empty(most, np.int64), np.empty(most, np.int64)
    for begin in range(0, out_count.size, _LENGTH):
        end = min(begin + _LENGTH, out_count.size)
        _guess(
            theta0[begin:end], mu0[begin:end], kappa[begin:end], alpha[begin:end], sigma[begin:end], beta[begin:end],
            nbar, u, t0, t1, t2, t3, number,
        )  # fmt: skip
        roots = 0
        for i in range(end - begin):
            for j in range(number[i]):
                t[roots] = t0[i] if j == 0 else t1[i] if j == 1 else t2[i] if j == 2 else t3[i]
                r_theta0[roots], r_mu0[roots], r_kappa[roots] = theta0[begin + i], mu0[begin + i], kappa[begin + i]
                r_alpha[roots], r_sigma[roots], r_beta[roots] = alpha[begin + i], sigma[begin + i], beta[begin + i]
                roots += 1
        _look(
            t[:roots], r_theta0, r_mu0, r_kappa, r_alpha, r_sigma, r_beta, nbar, tolerance, u,
            L, x, y, radius, error, verdict, code,
        )  # fmt: skip
        root = 0
        for i in range(end - begin):
            place = 0
            good = number[i] > 0
            for j in range(number[i]):
                good = good and verdict[root] != _UNSURE and (nbar == 0.0 or t[root] > 0.0)
                good = good and (j == 0 or apart(t[root - 1], radius[root - 1], t[root], radius[root]))
                if verdict[root] == _MEMBER and place < out_t.shape[0]:
                    out_t[place, begin + i], out_L[place, begin + i] = t[root], L[root]
                    out_x[place, begin + i], out_y[place, begin + i] = x[root], y[root]
                    out_error[place, begin + i], out_stability[place, begin + i] = error[root], code[root]
                    place += 1
                root += 1
            good = good and (nbar == 0.0 or place % 2 == 1)
            settled[begin + i] = good
            out_count[begin + i] = place if good else 0


def _line(theta0: Any, mu0: Any, kappa: Any, alpha: Any, sigma: Any, beta: Any, nbar: Any) -> Any:
    """cos θ₀ and sin θ₀, the coefficients of f, and the sums that bound their rounding errors."""
    c0, s0 = cosine_and_sine(theta0)
    a, b, d, m = f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, nbar)
    a_sum, d_sum = f_magnitudes(c0, s0, mu0, kappa, alpha, sigma, beta, nbar)
    return c0, s0, a, b, d, m, a_sum, d_sum


def _guess(theta0, mu0, kappa, alpha, sigma, beta, nbar, u, t0, t1, t2, t3, number) -> None:  # type: ignore[no-untyped-def]
    """tan(θ/2) at the roots that may be equilibria, ascending, and how many; 0 where float64 leaves that open."""
    for i in range(theta0.size):
        _, s0, a, b, d, m, a_sum, d_sum = _line(theta0[i], mu0[i], kappa[i], alpha[i], sigma[i], beta[i], nbar)
        D, D_error = discriminant(a, b, d, m, a_sum, d_sum, u)
        p1, q1, p2, q2 = factors(a, b, d, m)
        one, other, _ = root_pair(p1, q1)
        third, fourth, _ = root_pair(p2, q2)
        contact = nbar > 0.0
        more = (not D > D_error) & (not (contact & lone(a, b, d, m, a_sum, d_sum, u)))
        usual = normal(s0, mu0[i], kappa[i], alpha[i], sigma[i], beta[i])
        # A sorting network; what is left out goes to the end.
        low, high = where(contact, np.inf, minimum(one, other)), maximum(one, other)
        third = where(more, third, np.inf)
        fourth = where(more, fourth, np.inf)
        a1, a2, b1, b2 = minimum(low, high), maximum(low, high), minimum(third, fourth), maximum(third, fourth)
        inner, outer = maximum(a1, b1), minimum(a2, b2)
        t0[i], t1[i], t2[i], t3[i] = minimum(a1, b1), minimum(inner, outer), maximum(inner, outer), maximum(a2, b2)
        number[i] = where(usual, where(contact, 1, 2) + where(more, 2, 0), 0)


def _look(  # type: ignore[no-untyped-def]
    t, theta0, mu0, kappa, alpha, sigma, beta, nbar, tolerance, u, out_L, out_x, out_y, out_radius, out_error, verdict, out_code
) -> None:
    """What is at each root, and whether that is an equilibrium with all its digits, or certainly none."""
    for i in range(t.size):
        c0, s0, a, b, d, m, a_sum, d_sum = _line(theta0[i], mu0[i], kappa[i], alpha[i], sigma[i], beta[i], nbar)
        L, x, y, radius, error, member, outsider, code = at_root(
            t[i], a, b, d, m, a_sum, d_sum, c0, s0, mu0[i], kappa[i], alpha[i], sigma[i], beta[i], nbar, u
        )
        out_L[i], out_x[i], out_y[i], out_radius[i], out_error[i], out_code[i] = L, x, y, radius, error, code
        sure = member & (error <= tolerance) & (code > 0)
        verdict[i] = where(sure, _MEMBER, where(outsider, _OUTSIDER, _UNSURE))


def roots_and_counts(values: tuple[Any, ...]) -> tuple[NDArray[np.float64], NDArray[np.int8]]:
    """The two factors' four roots in t and the number of real ones, −1 where float64 leaves it open; for benchmarks.

    ``values`` are θ₀, μ₀, κ, α, σ, β of one length; roots have the shape (4, n), contact.
    """
    n = np.size(values[0])
    roots, count = np.empty((4, n)), np.empty(n, dtype=np.int8)
    columns = [_column(value, n) for value in values]
    _compiled(_roots)(*columns, 2.0**-53, roots, count)
    return roots, count


def _roots(theta0, mu0, kappa, alpha, sigma, beta, u, roots, count) -> None:  # type: ignore[no-untyped-def]
    for i in range(count.size):
        _, _, a, b, d, m, a_sum, d_sum = _line(theta0[i], mu0[i], kappa[i], alpha[i], sigma[i], beta[i], 1)
        D, bound = discriminant(a, b, d, m, a_sum, d_sum, u)
        p1, q1, p2, q2 = factors(a, b, d, m)
        roots[0, i], roots[1, i], _ = root_pair(p1, q1)
        roots[2, i], roots[3, i], _ = root_pair(p2, q2)
        count[i] = -1 if abs(D) <= bound else 4 if D < 0 else 2


