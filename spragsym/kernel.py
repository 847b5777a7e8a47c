"""The equilibrium solver for one point, in elementwise operations.

Every function but the first runs on arrays of any float type, and all do, compiled, on scalars: no branches, no loops over
points, no state; ``u`` is the unit roundoff of the type. The algebra of the model is :mod:`spragsym.generated`; here is only how
its quartic is solved, and how far the result can be trusted.

The quartic in t = tan(θ/2) has roots that multiply to −1, so it splits into (t² + p1 t + q1)(t² + p2 t + q2) with real factors,
q1 < 0 < q2 and q1 q2 = −1: the first holds one positive and one negative root, the second a pair of one sign or a complex one.
The split comes from the root of the resolvent cubic that lies farthest from the mean of the three. At a fold that root stays
simple, so that the two roots about to meet sit together in the second factor, which is then as accurate as the problem allows.
"""

from __future__ import annotations

import inspect
from typing import Any, TypeAlias

import numpy as np

from .generated import equilibrium as _equilibrium
from .generated import stability as _stability

#: A float, an array, or a compiled scalar.
Value: TypeAlias = Any

f_coefficients = inspect.unwrap(_equilibrium.f_coefficients)
f_magnitudes = inspect.unwrap(_equilibrium.f_magnitudes)
resolvent = inspect.unwrap(_equilibrium.resolvent)
t_quartic = inspect.unwrap(_equilibrium.t_quartic)
f = inspect.unwrap(_equilibrium.f)
f_slope = inspect.unwrap(_equilibrium.f_slope)
state = inspect.unwrap(_equilibrium.state)
f_curvature = inspect.unwrap(_equilibrium.f_curvature)
f_third = inspect.unwrap(_equilibrium.f_third)
stiffness = inspect.unwrap(_stability.stiffness)
invariants = inspect.unwrap(_stability.invariants)

# Named, so that the compiled kernel can bind versions for scalars.
where, maximum, minimum = np.where, np.maximum, np.minimum
absolute, copysign, sqrt, cbrt = np.abs, np.copysign, np.sqrt, np.cbrt

# Bounds on rounding errors, in units of u, each relative to the same expression with all of its terms positive. They count the
# operations that lead there, parameters taken as exact, cos θ₀ and sin θ₀ as good to 2 u; a test counts them again.
IN_F = 22.0
IN_P = 20.0
IN_Q = 24.0
IN_STATE = 16.0
IN_THETA = 16.0
#: A parameter that is smaller, but not 0, may lose digits to underflow, which no count of roundings covers.
SMALLEST = 1e-250
#: What underflow may add to P³ + Q² at most, generously.
UNDERFLOW = 1e-307
#: Largest h = |f| max|f″| / f′² for which the radius below is taken: Kantorovich asks for 1/2.
KANTOROVICH = 0.05


def cosine_and_sine(x: Value) -> tuple[Value, Value]:
    """cos x and sin x for 0 < x < π in float64, within one unit in the last place, which not every library's are.

    x = k π/2 + (r + tail) with r at most π/4, by π/2 in two parts, of which the first leaves nothing to round; then the
    polynomials of fdlibm's k_sin.c and k_cos.c.
    """
    k = where(x > 0.7853981633974483, 1.0, 0.0) + where(x > 2.356194490192345, 1.0, 0.0)
    near = x - k * 1.5707963267948966
    rest = k * 6.123233995736766e-17
    r = near - rest
    tail = (near - r) - rest
    z = r * r
    odd = 8.33333333332248946124e-03 + z * (
        -1.98412698298579493134e-04
        + z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10))
    )
    s = r - ((z * (0.5 * tail - z * r * odd) - tail) - z * r * -1.66666666666666324348e-01)
    even = 4.16666666666666019037e-02 + z * (
        -1.38888888888741095749e-03
        + z
        * (
            2.48015872894767294178e-05
            + z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))
        )
    )
    half = 0.5 * z
    top = 1.0 - half
    c = top + (((1.0 - top) - half) + (z * z * even - r * tail))
    return where(k == 1.0, -s, where(k > 1.0, -c, c)), where(k == 1.0, c, where(k > 1.0, -s, s))


def factors(a: Value, b: Value, d: Value, m: Value) -> tuple[Value, Value, Value, Value]:
    """p1, q1, p2, q2 of the two real quadratic factors of the quartic in t."""
    e0, e1, e2, e3, e4 = t_quartic(a, b, d, m)
    scale = 1.0 / e4
    A1, A2, A3 = e1 * scale, e2 * scale, e3 * scale
    y = -4.0 * scale * simple_root(a, b, d, m)

    width = sqrt(y * y + 4.0)  # q2 − q1
    large = 0.5 * (absolute(y) + width)
    small = 1.0 / large
    q2 = where(y > 0.0, large, small)
    q1 = -where(y > 0.0, small, large)
    inverse = 1.0 / width
    p1 = (A1 - A3 * q1) * inverse
    p2 = (A3 * q2 - A1) * inverse
    p1, q1, p2, q2 = polish(A1, A2, A3, p1, q1, p2, q2)
    return polish(A1, A2, A3, p1, q1, p2, q2)


def simple_root(a: Value, b: Value, d: Value, m: Value) -> Value:
    """The real root of the resolvent cubic farthest from the mean of the three."""
    r0, r1, r2 = resolvent(a, b, d, m)
    P, Q = depressed(r0, r1, r2)
    D = P * P * P + Q * Q
    size = absolute(Q)

    # One real root: Cardano, in the form that does not cancel for P > 0.
    u = cbrt(size + sqrt(maximum(D, 0.0)))
    v = P / u
    alone = where(P > 0.0, 2.0 * size / (u * u + P + v * v), u - v)

    # Three: 2 √−P cos(φ/3) with cos φ = |Q| / √−P³, from 4 w³ − 3 w = cos φ on [√3/2, 1], where Newton converges at once.
    root = sqrt(maximum(-P, 0.0))
    cosine = minimum(size / (root * root * root), 1.0)
    w = 0.8660254037844386 + cosine * (0.16306 - 0.02908 * cosine)
    w = w - ((4.0 * w * w - 3.0) * w - cosine) / (12.0 * w * w - 3.0)
    w = w - ((4.0 * w * w - 3.0) * w - cosine) / (12.0 * w * w - 3.0)
    z = -copysign(where(D < 0.0, 2.0 * root * w, alone), Q)

    x = z - r2 / 3.0
    slope = (3.0 * x + 2.0 * r2) * x + r1
    step = (((x + r2) * x + r1) * x + r0) / slope
    return x - where(absolute(step) < absolute(z), step, 0.0)


def depressed(r0: Value, r1: Value, r2: Value) -> tuple[Value, Value]:
    """P and Q of z³ + 3 P z + 2 Q, the resolvent shifted to the mean of its roots; P³ + Q² < 0: four real roots in t."""
    mean = r2 / 3.0
    return (r1 - r2 * mean) / 3.0, 0.5 * (r0 - mean * (r1 - 2.0 * mean * mean))


def discriminant(a: Value, b: Value, d: Value, m: Value, a_sum: Value, d_sum: Value, u: Value) -> tuple[Value, Value]:
    """P³ + Q², negative for four real roots in t and positive for two, and a bound on its rounding error."""
    r0, r1, r2 = resolvent(a, b, d, m)
    P, Q = depressed(r0, r1, r2)
    # r0, r1, r2 with every term positive, and the same for P and Q.
    size = absolute(m)
    R1 = 0.25 * (a_sum * a_sum + b * b + d_sum * d_sum)
    R0 = 0.25 * absolute(b) * (a_sum * d_sum + size * absolute(b))
    mean = size / 3.0
    P_sum = (R1 + size * mean) / 3.0
    Q_sum = 0.5 * (R0 + mean * (R1 + 2.0 * mean * mean))
    P_bound = absolute(P) + IN_P * u * P_sum
    Q_bound = absolute(Q) + IN_Q * u * Q_sum
    error = u * (P_bound * P_bound * P_sum * (3.0 * IN_P + 4.0) + Q_bound * Q_sum * (2.0 * IN_Q + 4.0)) + UNDERFLOW
    return P * P * P + Q * Q, error


def lone(a: Value, b: Value, d: Value, m: Value, a_sum: Value, d_sum: Value, u: Value) -> Value:
    """Whether certainly one root in t is positive, and not three: Descartes' rule with e₀ < 0 < e₄, e₂ ≤ 0 and e₁ < 0."""
    _, e1, _, _, _ = t_quartic(a, b, d, m)
    return e1 < -2.0 * IN_F * u * (a_sum + d_sum)


def normal(sin0: Value, mu0: Value, kappa: Value, alpha: Value, sigma: Value, beta: Value) -> Value:
    """Whether the bounds below can count on relative rounding errors."""
    fine = (sin0 > SMALLEST) & (kappa > SMALLEST) & (sigma > SMALLEST)
    return fine & ((mu0 > SMALLEST) | (mu0 <= 0.0)) & ((alpha > SMALLEST) | (alpha <= 0.0)) & ((beta > SMALLEST) | (beta <= 0.0))


def polish(
    A1: Value, A2: Value, A3: Value, p1: Value, q1: Value, p2: Value, q2: Value
) -> tuple[Value, Value, Value, Value]:
    """One Newton step on both factors at once: the change of the second is the remainder over the first, modulo the second."""
    r3 = A3 - (p1 + p2)
    r2 = A2 - (q1 + q2) - p1 * p2
    r1 = A1 - p1 * q2 - p2 * q1
    r0 = -1.0 - q1 * q2
    s1 = r3 * (p2 * p2 - q2) - r2 * p2 + r1
    s0 = (r3 * p2 - r2) * q2 + r0
    du = p1 - p2
    dv = q1 - q2
    dw = dv - du * p2
    inverse = 1.0 / (dv * dw + du * du * q2)
    dp2 = (s1 * dv - s0 * du) * inverse
    dq2 = (s0 * dw + s1 * du * q2) * inverse
    dp1 = r3 - dp2
    return p1 + dp1, q1 + (r2 - dq2 - p2 * dp1 - p1 * dp2), p2 + dp2, q2 + dq2


def root_pair(p: Value, q: Value) -> tuple[Value, Value, Value]:
    """The two roots of t² + p t + q, the one of larger magnitude first, and the discriminant, negative if they are not real."""
    half = 0.5 * p
    square = half * half - q
    large = -(half + copysign(sqrt(maximum(square, 0.0)), half))
    return large, q / large, square


def at_root(
    t: Value, a: Value, b: Value, d: Value, m: Value, a_sum: Value, d_sum: Value,
    cos0: Value, sin0: Value, mu0: Value, kappa: Value, alpha: Value, sigma: Value, beta: Value, nbar: Value, u: Value,
) -> tuple[Value, Value, Value, Value, Value, Value, Value, Value]:  # fmt: skip
    """State, error bounds and linearization at a root of f that is proved to lie near t.

    Returns L, x, y; the radius around θ that holds the root, NaN where none is proved; a bound on the error of θ, L, x and y
    over max(1, |value|); whether the state is certainly an equilibrium (L > 0, and y on the side that n̄ says); whether it
    certainly is none; and the stability code, 0 where rounding errors could change it.
    """
    inverse = 1.0 / (1.0 + t * t)
    s = 2.0 * t * inverse
    c = (1.0 - t) * (1.0 + t) * inverse
    size_s, size_c = absolute(s), absolute(c)
    size_b, size_m = absolute(b), absolute(m)

    # Newton–Kantorovich on f at θ: a root lies within about |f|/|f′|.
    value = absolute(f(c, s, a, b, d, m)) + IN_F * u * f(size_c, size_s, a_sum, size_b, d_sum, -size_m)
    slope = f_slope(c, s, a, b, d, m)
    steepness = absolute(slope) - IN_F * u * (a_sum + size_b * size_s + d_sum * size_c + 2.0 * size_m * size_s)
    bend = 2.0 * (a_sum + size_m) + size_b + d_sum
    newton = value / steepness
    proved = (steepness > 0.0) & (newton * bend < KANTOROVICH * steepness) & (newton < 1e-3 * size_s)
    radius = where(proved, 1.06 * newton, np.nan)

    L, x, y = state(c, s, cos0, sin0, kappa, sigma, beta, nbar)
    stiff = beta + nbar + sigma
    # L = σ/q + rest/(q s), y = (σ (s₀ − s) − κ)/q and x = cos θ₀ − L cos θ, with their slopes in θ.
    L_sum = (sigma * size_s + (beta + nbar) * sin0 + kappa) / (stiff * size_s)
    relative = radius / size_s
    swing = size_c + relative
    rounding = IN_STATE * u
    L_error = L_sum * (1.01 * relative * swing + rounding)
    y_error = (1.01 * sigma * radius * swing + rounding * (sigma * (sin0 + size_s) + kappa)) / stiff
    x_error = L_error + L_sum * (1.01 * radius + rounding) + rounding
    error = maximum(x_error / maximum(minimum(L, absolute(x)), 1.0), maximum(radius + IN_THETA * u, y_error))
    beyond = (1.0 - 2.0 * nbar) * y  # positive on the side of the belt that n̄ says
    member = (L > L_error) & (beyond > y_error)
    outsider = (L < -L_error) | (beyond < -y_error)
    uncertainty = maximum(relative, L_error / absolute(L)) + 8.0 * u
    code = stability(c, s, L, slope, uncertainty, mu0, alpha, sigma, beta, nbar)
    return L, x, y, radius, error, member, outsider, code


def apart(low: Value, low_radius: Value, high: Value, high_radius: Value) -> Value:
    """Whether two intervals in θ around 2 atan(low) < 2 atan(high) are disjoint: dθ = 2 dt/(1 + t²)."""
    return 2.0 * (high - low) > (low_radius + high_radius) * (1.0 + maximum(low * low, high * high))


def stability(
    c: Value, s: Value, L: Value, slope: Value, uncertainty: Value,
    mu0: Value, alpha: Value, sigma: Value, beta: Value, nbar: Value,
) -> Value:  # fmt: skip
    """1 stable, 2 divergent, 3 flutter, as :class:`spragsym.Stability` has it; 0 where rounding errors could change it.

    The sign of det K is that of f′, which :func:`at_root` proves along with the root.
    """
    (K11, K12), (K21, K22) = stiffness(c, s, L, mu0, alpha, sigma, beta, nbar)
    trace, _, flutter = invariants(K11, K12, K21, K22)
    size = alpha + beta + nbar + 2.0 * sigma + 3.0 * sigma / absolute(L)
    margin = 8.0 * uncertainty * size
    divergent = (slope < 0.0) | (trace < 0.0)
    code = where(flutter < 0.0, 3, where(divergent, 2, 1))
    # Far from a vanishing discriminant; and from a vanishing trace, which decides only where det K > 0.
    safe = (absolute(flutter) > margin * (size + 2.0 * mu0 * nbar)) & ((slope < 0.0) | (absolute(trace) > margin))
    return where(safe, code, 0)
