"""What is at a root of f, and how far it can be trusted: state, error bounds, stability.

The second part of the kernel, in the same small language; the first, :mod:`.kernel`, finds the
roots.
"""

from typing import NamedTuple

from ..emit.elementary import Direction
from ..emit.language import Flag, Real, absolute, derived, maximum, minimum, where
from .kernel import INFINITY, LineBalance, Point, direction, rough, sound

# Generated algebra, and counts of roundings: a target gives them their meaning.
f, f_slope, state, stiffness, invariants = derived(5)
COUNT_F, COUNT_SLOPE, COUNT_STATE, COUNT_THETA, COUNT_K = derived(5)


class Kind(NamedTuple):
    """Code of the stability, and whether rounding errors can't change it."""

    code: Real
    certain: Flag


class Root(NamedTuple):
    """Quantities at a root of f.

    The state; the radius around θ in which exactly one root is proved, infinite where none is; a
    bound on the error of θ, L, x and y over max(1, |value|); whether it certainly is an equilibrium
    (L > 0, and y on the side that n̄ says); whether it certainly is none; its stability, and
    whether that is certain.
    """

    L: Real
    x: Real
    y: Real
    radius: Real
    error: Real
    member: Flag
    outsider: Flag
    code: Real
    known: Flag


def at_root(t: Real, point: Point, line: LineBalance, u: Real) -> Root:
    """State, error bounds and stability at a root of f that is proved to lie near θ = 2 atan t.

    Newton–Kantorovich on f at θ: a root lies within about |f|/|f′|. Then, with R = (β + n̄) sin θ₀
    + κ, L = σ/q + R/(q sin θ), y = (σ (sin θ₀ − sin θ) − κ)/q and x = cos θ₀ − L cos θ over that
    radius: sin θ changes by at most radius (|cos θ| + radius), cos θ by radius (|sin θ| + radius),
    and 1/sin θ as sin θ does, over sin² θ, but for some thousandths.

    Where y can't be told from 0, as at θ₀ under a small preload, f decides: at the border of
    contact, sin θ* = sin θ₀ − κ/σ, it is q (α sin(θ* − θ₀) − κ cos θ*), negative for acute θ* and
    positive for obtuse ones. Where f is monotone from there to the root, y < 0 if f rises, and y >
    0 if it falls.
    """
    at = direction(t)
    c_size = absolute(rough(at.cosine))
    s_size = absolute(rough(at.sine))
    b_size = absolute(rough(line.b))
    m_size = rough(line.m)
    f_size = f(c_size, s_size, line.a_size, b_size, line.d_size, -m_size)
    value = (
        absolute(rough(f(at.cosine, at.sine, line.a, line.b, line.d, line.m)))
        + COUNT_F * u * f_size
    )
    slope = rough(f_slope(at.cosine, at.sine, line.a, line.b, line.d, line.m))
    slope_size = line.a_size + b_size * s_size + (line.d_size + 2.0 * m_size * s_size) * c_size
    steepness = absolute(slope) - COUNT_SLOPE * u * slope_size
    bend = 2.0 * (line.a_size + m_size) + b_size + line.d_size
    newton = value / steepness
    h = newton * bend / steepness
    # Kantorovich's theorem asks for h ≤ 1/2, the bounds on the state below for a radius that is
    # small beside sin θ.
    proved = (steepness > 0.0) & (h < 0.4) & (newton < 1e-3 * s_size) & sound(point)
    # The root is within (1 − √(1 − 2 h))/h ≤ 1/(1 − h) Newton steps.
    radius = where(proved, 1.0001 * newton / (1.0 - h), INFINITY)

    wide_L, wide_x, wide_y = state(
        at.cosine, at.sine, point.cos0, point.sin0, point.kappa, point.sigma, point.beta, point.nbar
    )
    L = rough(wide_L)
    x = rough(wide_x)
    y = rough(wide_y)
    sin0 = rough(point.sin0)
    kappa = rough(point.kappa)
    sigma = rough(point.sigma)
    nbar = rough(point.nbar)
    stiff = rough(point.beta) + nbar
    over = 1.0 / (stiff + sigma)
    L_size = (sigma * s_size + stiff * sin0 + kappa) * over / s_size
    relative = radius / s_size
    swing = c_size + relative
    rounding = COUNT_STATE * u
    L_error = L_size * (1.01 * relative * swing + rounding)
    y_size = sigma * (sin0 + s_size) + kappa
    off = 1.01 * sigma * radius * swing + rounding * y_size
    y_error = off * over
    turn = 1.01 * radius * (s_size + radius)
    x_error = L_error * swing + L_size * (turn + rounding * c_size) + rounding
    state_error = maximum(L_error, x_error) / maximum(minimum(L, absolute(x)), 1.0)
    error = maximum(state_error, maximum(radius + COUNT_THETA * u, y_error))
    side = 1.0 - 2.0 * nbar  # the sign of y, by n̄
    reach = 2.1 * off / sigma  # sin θ and sin θ* differ by less where y may be 0
    monotone = (
        (2.0 * reach * bend < steepness * c_size)
        & (4.0 * reach < c_size * c_size)
        & (reach < rough(at.sine))
    )
    ordered = monotone & (absolute(y) <= y_error)
    member = (L > L_error) & ((side * y > y_error) | (ordered & (side * slope < 0.0)))
    outsider = (L < -L_error) | (side * y < -y_error) | (ordered & (side * slope > 0.0))
    y = where(ordered & (y * slope > 0.0), 0.0, y)
    uncertainty = maximum(relative, L_error / absolute(L)) + 8.0 * u
    kind = stability(at, wide_L, slope, uncertainty, point)
    return Root(L, x, y, radius, error, member, outsider, kind.code, proved & kind.certain)


def stability(at: Direction, L: Real, slope: Real, uncertainty: Real, point: Point) -> Kind:
    """1 stable, 2 divergent, 3 flutter, by (27).

    The sign of det K is that of f′, which is known where the root is proved. ``uncertainty`` bounds
    the errors of cos θ, and of sin θ and L over themselves.
    """
    (K11, K12), (K21, K22) = stiffness(
        at.cosine, at.sine, L, point.mu0, point.alpha, point.sigma, point.beta, point.nbar
    )
    wide_trace, determinant, wide_flutter = invariants(K11, K12, K21, K22)
    trace = rough(wide_trace)
    flutter = rough(wide_flutter)
    sigma = rough(point.sigma)
    nbar = rough(point.nbar)
    pull = sigma / absolute(rough(L))
    # With N = α + β + n̄ + 2 σ the terms of the discriminant add up to (N + 2 pull)² + 4 pull (μ₀
    # n̄ + pull), those of the trace to N + 2 pull.
    size = rough(point.alpha) + rough(point.beta) + nbar + 2.0 * sigma + 3.0 * pull
    margin = COUNT_K * uncertainty * size
    saddle = slope < 0.0
    fluttering = flutter < 0.0
    code = where(saddle, 2.0, where(fluttering, 3.0, where(trace > 0.0, 1.0, 2.0)))
    # Far from a vanishing discriminant, and from a vanishing trace where that decides.
    far = absolute(flutter) > margin * (size + 1.5 * rough(point.mu0) * nbar)
    return Kind(code, saddle | (far & (fluttering | (absolute(trace) > margin))))


def apart(low: Real, low_radius: Real, high: Real, high_radius: Real) -> Flag:
    """Whether two intervals in θ around 2 atan(low) < 2 atan(high) are disjoint: dθ = 2 dt/(1 +
    t²).
    """
    low_square = rough(low) * rough(low)
    high_square = rough(high) * rough(high)
    return 2.0 * rough(high - low) > (low_radius + high_radius) * (
        1.0 + maximum(low_square, high_square)
    )
