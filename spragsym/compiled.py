"""The solver compiled by numba, from the same functions: :mod:`spragsym.kernel` and :mod:`spragsym.generated`, no second copy.

Each function is compiled with its global names bound to compiled ones. What a compiled function contains is named in its cache
entry by a hash of all sources that go into it, so that a regenerated derivation never meets an old binary.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import kernel
from .errors import MissingExtraError
from .generated import SOURCE_HASH

#: Functions of the kernel in the order in which they build on each other.
_KERNEL = ("depressed", "discriminant", "simple_root", "polish", "factors", "root_pair", "stability", "apart", "at_root")


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
    """Compiled versions of the kernel and of the generated functions that it uses, by name."""
    numba = _numba()
    compiled: dict[str, Any] = {"np": np}
    compiled.update(sqrt=math.sqrt, absolute=abs, bits=_bits(), number=_number())
    for scalar in (where, maximum, minimum, copysign, cbrt):
        bound = FunctionType(scalar.__code__, compiled, scalar.__name__)
        compiled[scalar.__name__] = numba.njit(bound, error_model="numpy", inline="always")
    for name, value in vars(kernel).items():
        if isinstance(value, FunctionType) and value.__module__ != kernel.__name__:
            compiled[name] = numba.njit(value, error_model="numpy", inline="always")
        elif isinstance(value, float):
            compiled[name] = value
    for name in _KERNEL:
        original = getattr(kernel, name)
        # Annotations name types that compiled code has no use for.
        bound = FunctionType(original.__code__, compiled, name, original.__defaults__)
        compiled[name] = numba.njit(bound, error_model="numpy", inline="always")
    return compiled


def where(condition: bool, yes: float, no: float) -> float:
    """numpy.where for scalars."""
    return yes if condition else no


def maximum(one: float, other: float) -> float:
    """numpy.maximum for scalars: NaN if either is."""
    return one if one > other or one != one else other  # noqa: PLR0124


def minimum(one: float, other: float) -> float:
    """numpy.minimum for scalars: NaN if either is."""
    return one if one < other or one != one else other  # noqa: PLR0124


def copysign(size: float, sign: float) -> float:
    """numpy.copysign for scalars; a zero counts as positive."""
    return abs(size) if sign >= 0.0 else -abs(size)


def cbrt(x: float) -> float:
    """Cube root of x >= 0 without a call, so that a loop around it can be vectorized.

    A third of the exponent through the bits, then three steps of Halley's method, each of which triples the digits.
    """
    y = number(int(float(bits(x)) * 0.3333333333333333) + 3071306043645493248)  # type: ignore[name-defined]  # noqa: F821
    for _ in range(3):
        cube = y * y * y
        y = y * (cube + 2.0 * x) / (2.0 * cube + x)
    return y if x > 0.0 else 0.0


def _bits() -> Any:
    """A float64's bits as an int64."""
    from numba import types
    from numba.extending import intrinsic

    @intrinsic
    def bits(typing_context: Any, x: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.bitcast(arguments[0], context.get_value_type(types.int64))

        return types.int64(types.float64), generate

    return bits


def _number() -> Any:
    """The float64 with an int64's bits."""
    from numba import types
    from numba.extending import intrinsic

    @intrinsic
    def number(typing_context: Any, i: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.bitcast(arguments[0], context.get_value_type(types.float64))

        return types.float64(types.int64), generate

    return number


@cache
def _compiled(function: Callable[..., Any]) -> Any:
    """One of the loops below, compiled for one set of types, and cached on disk under the fingerprint of everything in it."""
    bound = FunctionType(function.__code__, _namespace(), function.__name__)
    bound.__qualname__ = f"{function.__name__}_{_fingerprint()}"
    bound.__module__ = __name__
    return _numba().njit(_signatures()[function.__name__], error_model="numpy", cache=True, nogil=True)(bound)


def solve(values: tuple[Any, ...], contact: bool, tolerance: float, out: Any) -> NDArray[np.int64]:
    """As :func:`spragsym.solver.solve` in float64: write what is settled to ``out``, return the indices of what is not."""
    n = out.count.size
    columns = [_column(value, n) for value in values]
    state = np.empty(n, dtype=np.int8)
    slots = tuple(getattr(out, name).T for name in ("theta", "L", "x", "y", "error", "stability"))
    u = 2.0**-53
    if contact:
        _compiled(_first_roots)(*columns, tolerance, u, *(part[0] for part in slots), out.count, state)
    else:
        state[:] = _OPEN
    _compiled(_all_roots)(*columns, int(contact), tolerance, u, *slots, out.count, state)
    np.arctan(out.theta.T, out=out.theta.T)
    np.multiply(out.theta.T, 2.0, out=out.theta.T)
    return np.flatnonzero(state == _UNSETTLED)


def _column(value: Any, n: int) -> NDArray[np.float64]:
    """A parameter as a contiguous column: one type for the compiled code, whatever was broadcast."""
    return np.ascontiguousarray(np.broadcast_to(value, (n,)), dtype=np.float64)


@cache
def _signatures() -> dict[str, Any]:
    """Types of the loops' arguments: one set for each, so that each is compiled once."""
    from numba import types

    given = [types.Array(types.float64, 1, "C", readonly=True)] * 7
    column, codes, numbers = types.float64[::1], types.int8[::1], types.int64[::1]
    real, whole = types.float64, types.int64
    return {
        "_first_roots": types.void(*given, real, real, *[column] * 5, codes, numbers, codes),
        "_all_roots": types.void(
            *given, whole, real, real, *[types.float64[:, :]] * 5, types.int8[:, :], numbers, codes
        ),
        "_roots": types.void(*given, real, types.float64[:, ::1], codes),
    }


# State of a point between and after the two passes.
_SETTLED, _OPEN, _UNSETTLED = 0, 1, 2


def _first_roots(  # type: ignore[no-untyped-def]
    cos0, sin0, mu0, kappa, alpha, sigma, beta, tolerance, u,
    out_t, out_L, out_x, out_y, out_error, out_stability, out_count, state,
) -> None:  # fmt: skip
    """The positive root of the first factor of every point, in contact, without a branch, so that the loop is vectorized.

    Points that need their second factor stay open; tan(θ/2) is left in the place of θ.
    """
    for i in range(out_count.size):
        c0, s0, mu, k, al, si, be = cos0[i], sin0[i], mu0[i], kappa[i], alpha[i], sigma[i], beta[i]
        a, b, d, m = f_coefficients(c0, s0, mu, k, al, si, be, 1)  # type: ignore[name-defined]  # noqa: F821
        a_sum, d_sum = f_magnitudes(c0, s0, mu, k, al, si, be, 1)  # type: ignore[name-defined]  # noqa: F821
        D, D_error = discriminant(a, b, d, m, a_sum, d_sum, u)  # type: ignore[name-defined]  # noqa: F821
        p1, q1, p2, q2 = factors(a, b, d, m)  # type: ignore[name-defined]  # noqa: F821
        large, small, _ = root_pair(p1, q1)  # type: ignore[name-defined]  # noqa: F821
        t = where(large > 0.0, large, small)
        L, x, y, radius, error, member, outsider, code = at_root(  # type: ignore[name-defined]  # noqa: F821
            t, a, b, d, m, a_sum, d_sum, c0, s0, mu, k, al, si, be, 1, u
        )
        out_t[i], out_L[i], out_x[i], out_y[i], out_error[i], out_stability[i] = t, L, x, y, error, code
        alone = (D > D_error) | (p2 > 0.0)
        sure = member & (error <= tolerance) & (code > 0)
        state[i] = where(alone & sure, 0, where(alone, 2, 1))
        out_count[i] = 1


def _all_roots(  # type: ignore[no-untyped-def]
    cos0, sin0, mu0, kappa, alpha, sigma, beta, nbar, tolerance, u,
    out_t, out_L, out_x, out_y, out_error, out_stability, out_count, state,
) -> None:  # fmt: skip
    """Every root of the points that are open; the logic of :func:`spragsym.solver.solve`, point by point."""
    for i in range(out_count.size):
        if state[i] != 1:
            continue
        c0, s0, mu, k, al, si, be = cos0[i], sin0[i], mu0[i], kappa[i], alpha[i], sigma[i], beta[i]
        a, b, d, m = f_coefficients(c0, s0, mu, k, al, si, be, nbar)  # type: ignore[name-defined]  # noqa: F821
        a_sum, d_sum = f_magnitudes(c0, s0, mu, k, al, si, be, nbar)  # type: ignore[name-defined]  # noqa: F821
        D, D_error = discriminant(a, b, d, m, a_sum, d_sum, u)  # type: ignore[name-defined]  # noqa: F821
        p1, q1, p2, q2 = factors(a, b, d, m)  # type: ignore[name-defined]  # noqa: F821
        large, small, _ = root_pair(p1, q1)  # type: ignore[name-defined]  # noqa: F821
        t0, t1, t2, t3 = max(large, small), np.nan, np.nan, np.nan
        roots = 1
        if nbar == 0:
            t0, t1, roots = min(large, small), max(large, small), 2
        if not D > D_error and (nbar == 0 or not p2 > 0.0):
            one, other, square = root_pair(p2, q2)  # type: ignore[name-defined]  # noqa: F821
            if square < 0.0:
                one = np.nan
            if nbar == 0:
                t2, t3 = one, other
            else:
                t1, t2 = one, other
            roots += 2
            for _ in range(3):  # ascending; with a NaN anywhere the point is not settled below
                if t0 > t1:
                    t0, t1 = t1, t0
                if t1 > t2:
                    t1, t2 = t2, t1
                if t2 > t3:
                    t2, t3 = t3, t2
        good = True
        place = 0
        before, before_radius = -np.inf, 0.0
        for j in range(roots):
            t = t0 if j == 0 else t1 if j == 1 else t2 if j == 2 else t3
            L, x, y, radius, error, member, outsider, code = at_root(  # type: ignore[name-defined]  # noqa: F821
                t, a, b, d, m, a_sum, d_sum, c0, s0, mu, k, al, si, be, nbar, u
            )
            good = good and ((member and error <= tolerance and code > 0) or outsider)
            good = good and (j == 0 or apart(before, before_radius, t, radius))  # type: ignore[name-defined]  # noqa: F821
            before, before_radius = t, radius
            if member and place < out_t.shape[0]:
                out_t[place, i], out_L[place, i], out_x[place, i], out_y[place, i] = t, L, x, y
                out_error[place, i] = error
                out_stability[place, i] = code
                place += 1
        if nbar == 1 and place % 2 == 0:
            good = False
        state[i] = 0 if good else 2
        out_count[i] = place
        for j in range(place if good else 0, out_t.shape[0]):
            out_t[j, i] = out_L[j, i] = out_x[j, i] = out_y[j, i] = out_error[j, i] = np.nan
            out_stability[j, i] = 0


def roots_and_counts(values: tuple[Any, ...]) -> tuple[NDArray[np.float64], NDArray[np.int8]]:
    """The two factors' four roots in t and the number of real ones, −1 where float64 leaves it open; for benchmarks.

    ``values`` are cos θ₀, sin θ₀, μ₀, κ, α, σ, β of one length; roots have the shape (4, n), contact.
    """
    n = np.size(values[0])
    roots, count = np.empty((4, n)), np.empty(n, dtype=np.int8)
    columns = [_column(value, n) for value in values]
    _compiled(_roots)(*columns, 2.0**-53, roots, count)
    return roots, count


def _roots(cos0, sin0, mu0, kappa, alpha, sigma, beta, u, roots, count) -> None:  # type: ignore[no-untyped-def]
    for i in range(count.size):
        c0, s0, mu, k, al, si, be = cos0[i], sin0[i], mu0[i], kappa[i], alpha[i], sigma[i], beta[i]
        a, b, d, m = f_coefficients(c0, s0, mu, k, al, si, be, 1)  # type: ignore[name-defined]  # noqa: F821
        a_sum, d_sum = f_magnitudes(c0, s0, mu, k, al, si, be, 1)  # type: ignore[name-defined]  # noqa: F821
        D, bound = discriminant(a, b, d, m, a_sum, d_sum, u)  # type: ignore[name-defined]  # noqa: F821
        p1, q1, p2, q2 = factors(a, b, d, m)  # type: ignore[name-defined]  # noqa: F821
        roots[0, i], roots[1, i], _ = root_pair(p1, q1)  # type: ignore[name-defined]  # noqa: F821
        roots[2, i], roots[3, i], _ = root_pair(p2, q2)  # type: ignore[name-defined]  # noqa: F821
        count[i] = -1 if abs(D) <= bound else 4 if D < 0 else 2


