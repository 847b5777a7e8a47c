"""How the equilibria of one point are found and how far the result can be trusted, written once for
every target language.

Nothing here is run as it stands. :mod:`derive.emit.language` reads the functions below and each
target prints them: Python for arrays of any float type, C for one point and for blocks of points.
They are therefore written in a small language: functions of numbers and of the records below,
assignments, ``+ - * /``, comparisons joined by ``&``, ``|`` and ``~``, ``where`` for both sides of
a choice, loops of a fixed number of passes, and calls. There are no branches, so that many points
can be worked on side by side. ``resolvent`` and other names that are not defined here are generated
algebra (``catalogue/``). What is at a root that was found stands in :mod:`.examination`, functions
of an angle in :mod:`derive.emit.elementary`; the three are emitted as one.

What decides where double precision can't is computed a second time in double-double arithmetic, by
the same functions: a number is then the exact sum of two doubles, and ``u`` the unit roundoff of
such sums. Sizes, bounds and results stay doubles; ``rough`` is where one turns into the other.

The quartic in t = tan(θ/2) has roots that multiply to −1, so it splits into (t² + p1 t + q1)(t² +
p2 t + q2) with real factors, q1 < 0 < q2 and q1 q2 = −1: the first holds one positive and one
negative root, the second a pair of one sign or a complex one. The split comes from the root of the
resolvent cubic that lies farthest from the mean of the three. At a fold that root stays simple, so
that the two roots about to meet sit together in the second factor, which is then as accurate as the
problem allows.

Bounds on rounding errors have the form (count) u (size): ``u`` is the unit roundoff, the size is
the same expression with the absolute values of all of its terms, and the count, at the head of the
emitted file, is derived from the emitted statements by :mod:`derive.emit.bounds`.
"""

from typing import NamedTuple

from ..emit.elementary import Direction
from ..emit.language import Flag, Real, absolute, cube_root, derived, maximum, minimum, sqrt, where

# Generated algebra, and counts of roundings: a target gives them their meaning.
f_coefficients, f_magnitudes, t_quartic, resolvent = derived(4)
COUNT_P, COUNT_Q, COUNT_E1 = derived(3)

#: A parameter that is smaller, but not 0, may lose digits to underflow, which no count of roundings
#: covers.
SMALLEST_PARAMETER = 1e-250
#: From this on, and up to 1e50, numbers are far enough from underflow and overflow for the exact
#: products of double-double arithmetic.
SMALLEST_WIDE = 1e-50
#: The unit roundoff of double-double arithmetic, 2^-102: sixteen units of 2^-106, of which its
#: operations lose 15 at most.
WIDE_ROUNDOFF = 1.9721522630525295e-31
INFINITY = float("inf")


class Point(NamedTuple):
    """A parameter point of one regime: cos θ₀, sin θ₀, μ₀, κ, α, σ, β and n̄."""

    cos0: Real
    sin0: Real
    mu0: Real
    kappa: Real
    alpha: Real
    sigma: Real
    beta: Real
    nbar: Real


class LineBalance(NamedTuple):
    """Coefficients of f, the sizes of a and d, all over ``scale``, which is the largest
    coefficient.
    """

    a: Real
    b: Real
    d: Real
    m: Real
    a_size: Real
    d_size: Real
    scale: Real


class Depressed(NamedTuple):
    """P and Q of z³ + 3 P z + 2 Q, the resolvent shifted to the mean of its roots."""

    P: Real
    Q: Real


class Cubic(NamedTuple):
    """The resolvent r0 + r1 ℓ + r2 ℓ² + ℓ³, and its P and Q."""

    r0: Real
    r1: Real
    r2: Real
    P: Real
    Q: Real


class Quartic(NamedTuple):
    """Coefficients of the quartic in t, ascending."""

    e0: Real
    e1: Real
    e2: Real
    e3: Real
    e4: Real


class Discriminant(NamedTuple):
    """P³ + Q², negative for four real roots in t and positive for two, and a bound on its rounding
    error.
    """

    value: Real
    error: Real


class Above(NamedTuple):
    """Of three positive roots: whether all of them are certainly above a number, and whether
    certainly only one is.
    """

    all: Flag
    one: Flag


class Factors(NamedTuple):
    """Coefficients of the two real quadratic factors of the quartic in t."""

    p1: Real
    q1: Real
    p2: Real
    q2: Real


class Pair(NamedTuple):
    """Roots of a quadratic, the one of larger magnitude first, and a quarter of the discriminant,
    negative if they are not real.
    """

    large: Real
    small: Real
    discriminant: Real


class Guesses(NamedTuple):
    """tan(θ/2) at the roots that may be equilibria, ascending, how many there are, and whether
    there are certainly no more.
    """

    t0: Real
    t1: Real
    t2: Real
    t3: Real
    count: Real
    certain: Flag


# ------------------------------------------------------------------------------------------------
# the balance of forces


def rough(x: Real) -> Real:
    """A number as a double, for bounds and for results: itself, and of a double-double the leading
    part.
    """
    return x


def direction(t: Real) -> Direction:
    """cos θ and sin θ at t = tan(θ/2)."""
    inverse = 1.0 / (1.0 + t * t)
    return Direction((1.0 - t) * (1.0 + t) * inverse, 2.0 * t * inverse)


def ordinary(parameter: Real) -> Flag:
    """Whether a parameter is 0 or large enough for relative rounding errors."""
    return (parameter > SMALLEST_PARAMETER) | (parameter <= 0.0)


def sound(point: Point) -> Flag:
    """Whether the bounds below can count on relative rounding errors."""
    across = (rough(point.sin0) > SMALLEST_PARAMETER) & (rough(point.sigma) > SMALLEST_PARAMETER)
    along = ordinary(rough(point.mu0)) & ordinary(rough(point.alpha)) & ordinary(rough(point.beta))
    return across & along & (rough(point.kappa) > 0.0) & (pressed(point) > SMALLEST_PARAMETER)


def pressed(point: Point) -> Real:
    """(β + n̄) sin θ₀ + κ: κ is never a factor by itself, so that this sum has to be far from
    underflow.
    """
    return (rough(point.beta) + rough(point.nbar)) * rough(point.sin0) + rough(point.kappa)


def tame(parameter: Real) -> Flag:
    """Whether a parameter is 0 or far from underflow and overflow."""
    return (parameter < 1e50) & ((parameter > SMALLEST_WIDE) | (parameter <= 0.0))


def moderate(point: Point) -> Flag:
    """Whether double-double arithmetic is as good as its bounds say at this point."""
    across = (
        (rough(point.sin0) > SMALLEST_WIDE)
        & tame(rough(point.sigma))
        & tame(rough(point.beta))
        & tame(pressed(point))
    )
    return across & tame(rough(point.mu0)) & tame(rough(point.alpha)) & (rough(point.kappa) > 0.0)


def balance(point: Point) -> LineBalance:
    """f of the point: coefficients and sizes over the largest coefficient."""
    a, b, d, m = f_coefficients(
        point.cos0,
        point.sin0,
        point.mu0,
        point.kappa,
        point.alpha,
        point.sigma,
        point.beta,
        point.nbar,
    )
    a_size, d_size = f_magnitudes(
        rough(point.cos0),
        rough(point.sin0),
        rough(point.mu0),
        rough(point.kappa),
        rough(point.alpha),
        rough(point.sigma),
        rough(point.beta),
        rough(point.nbar),
    )
    # m = μ₀ σ n̄ is not negative.
    scale = maximum(
        maximum(absolute(rough(a)), absolute(rough(b))), maximum(absolute(rough(d)), rough(m))
    )
    over = 1.0 / scale
    return LineBalance(a * over, b * over, d * over, m * over, a_size * over, d_size * over, scale)


def representable(line: LineBalance) -> Flag:
    """Whether double precision can carry the quartic of this balance.

    Its largest coefficient was divided out without underflow or overflow; and the quartic is
    divided by |b|: where that is less than 1e−60 of the largest, roots share no scale.
    """
    return (line.scale > 1e-200) & (line.scale < 1e200) & (rough(line.b) <= -1e-60)


# ------------------------------------------------------------------------------------------------
# the number of roots


def depressed(r0: Real, r1: Real, r2: Real) -> Depressed:
    """The resolvent r0 + r1 ℓ + r2 ℓ² + ℓ³ without its quadratic term; P³ + Q² < 0: four real roots
    in t.
    """
    mean = r2 / 3.0
    return Depressed((r1 - r2 * mean) / 3.0, 0.5 * (r0 - mean * (r1 - 2.0 * mean * mean)))


def depressed_size(a_size: Real, b_size: Real, d_size: Real, m_size: Real) -> Depressed:
    """The sizes of P and Q."""
    r1_size = 0.25 * (a_size * a_size + b_size * b_size + d_size * d_size)
    r0_size = 0.25 * b_size * (a_size * d_size + m_size * b_size)
    mean = m_size / 3.0
    return Depressed(
        (r1_size + m_size * mean) / 3.0, 0.5 * (r0_size + mean * (r1_size + 2.0 * mean * mean))
    )


def cubic(a: Real, b: Real, d: Real, m: Real) -> Cubic:
    """The resolvent of the quartic in t, and the same without its quadratic term."""
    r0, r1, r2 = resolvent(a, b, d, m)
    it = depressed(r0, r1, r2)
    return Cubic(r0, r1, r2, it.P, it.Q)


def quartic(a: Real, b: Real, d: Real, m: Real) -> Quartic:
    """The quartic in t = tan(θ/2) whose roots are those of f."""
    e0, e1, e2, e3, e4 = t_quartic(a, b, d, m)
    return Quartic(e0, e1, e2, e3, e4)


def discriminant(line: LineBalance, it: Cubic, u: Real) -> Discriminant:
    """The sign of P³ + Q² is that of the discriminant, reversed.

    From bounds on the errors of P and Q: |P̃³ − P³| ≤ 3 (|P| + error)² error and |Q̃² − Q²| ≤ 2
    (|Q| + error) error; cubing, squaring and adding round four times more. Underflow adds less than
    1e−307.
    """
    size = depressed_size(line.a_size, absolute(rough(line.b)), line.d_size, rough(line.m))
    P_bound = absolute(rough(it.P)) + COUNT_P * u * size.P
    Q_bound = absolute(rough(it.Q)) + COUNT_Q * u * size.Q
    from_P = P_bound * P_bound * size.P * (3.0 * COUNT_P + 4.0)
    from_Q = Q_bound * size.Q * (2.0 * COUNT_Q + 4.0)
    return Discriminant(rough(it.P * it.P * it.P + it.Q * it.Q), u * (from_P + from_Q) + 1e-307)


def one_positive(line: LineBalance, e: Quartic, u: Real) -> Flag:
    """Whether certainly exactly one root in t is positive: Descartes' rule with e0 < 0 < e4, e2 ≤ 0
    and e1 < 0.
    """
    return rough(e.e1) < -2.0 * COUNT_E1 * u * (line.a_size + line.d_size)


def above(e1: Real, e2: Real, e3: Real, e4: Real, c: Real, margin: Real) -> Above:
    """Number of positive roots of e0 + e1 t + e2 t² + e3 t³ + e4 t⁴ above c ≥ 0.

    Three are positive, the fourth is real as well, and the value at c is negative. As many are
    above c as the derivatives there, over factorials, change their sign (Budan and Fourier), from
    that value to e4 > 0: three times or once.
    """
    d1 = ((4.0 * e4 * c + 3.0 * e3) * c + 2.0 * e2) * c + e1
    d2 = (6.0 * e4 * c + 3.0 * e3) * c + e2
    d3 = 4.0 * e4 * c + e3
    falls2 = d2 < -margin
    falls3 = d3 < -margin
    rises2 = d2 > margin
    rises3 = d3 > margin
    thrice = ((d1 > margin) & (falls2 | falls3)) | (rises2 & falls3)
    once = ((d1 < -margin) | (rises2 & rises3)) & (falls2 | rises3)
    return Above(thrice, once)


def one_or_three(point: Point, u: Real) -> Real:
    """The number of equilibria in contact, 1 or 3; 0 where that is open.

    Each is a positive root in t. One is positive unless all four are real and e1 > 0; then three
    are, by Descartes' rule. Of these the ones in contact have sin θ > s* = sin θ₀ − κ/σ. At the
    lower end t = c of these directions f is negative, so that none or two of the three lie below
    it. None lies beyond the upper end, where cos θ < 0 and sin θ = s < s* < sin θ₀: there f = |cos
    θ| (|b| − a s) + s (m (s* − s) + α q cos θ₀) is positive, by |b| − a s > α q s and |cos θ| >
    |cos θ₀|.

    ``margin`` is more than what the derivatives at c may be off by. All coefficients are at most 4
    and c at most 1; the largest share is that of c, which is off by √(22 u) at most, near c = 1,
    and changes a derivative by up to 44 times as much; the rest is below 480 u (1 + a_size +
    d_size).
    """
    line = balance(point)
    e = quartic(line.a, line.b, line.d, line.m)
    D = discriminant(line, cubic(line.a, line.b, line.d, line.m), u)
    margin = 512.0 * sqrt(u) * (1.0 + line.a_size + line.d_size)
    lowest = maximum(point.sin0 - point.kappa / point.sigma, 0.0)
    c = lowest / (1.0 + sqrt((1.0 - lowest) * (1.0 + lowest)))
    in_contact = above(e.e1, e.e2, e.e3, e.e4, c, margin)
    certain = sound(point) & representable(line)
    three_positive = certain & (D.value < -D.error) & (e.e1 > margin)
    one_positive_root = certain & ((D.value > D.error) | one_positive(line, e, u))
    one = one_positive_root | (three_positive & in_contact.one)
    return where(one, 1.0, where(three_positive & in_contact.all, 3.0, 0.0))


# ------------------------------------------------------------------------------------------------
# the two factors


def outermost(P: Real, Q: Real) -> Real:
    """The root of z³ + 3 P z + 2 Q of largest magnitude, which is far from the others."""
    # Takes the place of P or Q where these vanish, as at a cusp: the smallest normal number.
    smallest = 2.2250738585072014e-308
    size = absolute(Q)
    inside = P * P * P + Q * Q
    # One real root: Cardano, in the form that does not cancel for P > 0.
    w = cube_root(size + sqrt(maximum(inside, 0.0)) + smallest)
    v = P / w
    alone = where(P > 0.0, 2.0 * size / (w * w + P + v * v), w - v)
    # Three: 2 √−P cos(φ/3) with cos φ = |Q| / √−P³, from 4 z³ − 3 z = cos φ on [√3/2, 1], where
    # Newton converges at once.
    root = sqrt(maximum(-P, smallest))
    cosine = minimum(size / (root * root * root), 1.0)
    z = 0.8660254037844386 + cosine * (0.16306 - 0.02908 * cosine)
    for _ in range(2):
        z = z - ((4.0 * z * z - 3.0) * z - cosine) / (12.0 * z * z - 3.0)
    largest = where(inside < 0.0, 2.0 * root * z, alone)
    return where(Q > 0.0, -largest, largest)


def simple_root(it: Cubic) -> Real:
    """The real root of the resolvent cubic farthest from the mean of the three, to full relative
    accuracy.
    """
    # Newton's step squares the error, so that more than a double would be lost on the start.
    z = outermost(rough(it.P), rough(it.Q))
    x = z - it.r2 / 3.0
    slope = (3.0 * x + 2.0 * it.r2) * x + it.r1
    step = (((x + it.r2) * x + it.r1) * x + it.r0) / slope
    return x - where(absolute(step) < absolute(z), step, 0.0)


def polish(A1: Real, A2: Real, A3: Real, p1: Real, q1: Real, p2: Real, q2: Real) -> Factors:
    """One Newton step on both factors of t⁴ + A3 t³ + A2 t² + A1 t − 1 at once.

    The change of the second factor is the remainder over the first, modulo the second. q1 q2 = −1
    is kept by setting the smaller from the larger.
    """
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
    dq1 = r2 - dq2 - p2 * dp1 - p1 * dp2
    # Where three roots meet, the factors share a root and the step is not reliable.
    new_q1 = q1 + dq1
    new_q2 = q2 + dq2
    good = (new_q1 < 0.0) & (new_q2 > 0.0) & (absolute(dp1 + dp2 + dq1 + dq2) < INFINITY)
    q1 = where(good, new_q1, q1)
    q2 = where(good, new_q2, q2)
    larger_second = -q1 < q2
    inverse_q = -1.0 / where(larger_second, q2, q1)
    return Factors(
        where(good, p1 + dp1, p1),
        where(larger_second, inverse_q, q1),
        where(good, p2 + dp2, p2),
        where(larger_second, q2, inverse_q),
    )


def factors(e: Quartic, resolved: Cubic) -> Factors:
    """The two real quadratic factors of the quartic in t."""
    over = 1.0 / e.e4
    A1 = e.e1 * over
    A2 = e.e2 * over
    A3 = e.e3 * over
    y = -4.0 * over * simple_root(resolved)
    width = sqrt(y * y + 4.0)  # q2 − q1
    large = 0.5 * (absolute(y) + width)
    small = 1.0 / large
    q2 = where(y > 0.0, large, small)
    q1 = -where(y > 0.0, small, large)
    inverse = 1.0 / width
    return polish(A1, A2, A3, (A1 - A3 * q1) * inverse, q1, (A3 * q2 - A1) * inverse, q2)


def root_pair(p: Real, q: Real) -> Pair:
    """The two roots of t² + p t + q without cancellation."""
    half = 0.5 * p
    quarter = half * half - q
    radical = sqrt(maximum(quarter, 0.0))
    large = -half - where(half > 0.0, radical, -radical)
    return Pair(large, q / large, quarter)


def guesses(point: Point, line: LineBalance, u: Real) -> Guesses:
    """The roots that may be equilibria.

    In contact only positive ones: with sin θ < 0 < L, y = sin θ₀ − L sin θ would be positive. The
    first factor has a root of either sign; those of the second are complex, or both negative, or
    both positive.
    """
    e = quartic(line.a, line.b, line.d, line.m)
    resolved = cubic(line.a, line.b, line.d, line.m)
    D = discriminant(line, resolved, u)
    halves = factors(e, resolved)
    first = root_pair(halves.p1, halves.q1)
    second = root_pair(halves.p2, halves.q2)
    contact = point.nbar > 0.0
    spared = (D.value > D.error) | (contact & one_positive(line, e, u))
    real = second.discriminant >= 0.0
    more = real & ~spared
    # A sorting network; places without a root go to the end.
    low = where(contact, INFINITY, minimum(first.large, first.small))
    high = maximum(first.large, first.small)
    third = where(more, second.large, INFINITY)
    fourth = where(more, second.small, INFINITY)
    a1 = minimum(low, high)
    a2 = maximum(low, high)
    b1 = minimum(third, fourth)
    b2 = maximum(third, fourth)
    inner = maximum(a1, b1)
    outer = minimum(a2, b2)
    count = where(contact, 1.0, 2.0) + where(more, 2.0, 0.0)
    return Guesses(
        minimum(a1, b1),
        minimum(inner, outer),
        maximum(inner, outer),
        maximum(a2, b2),
        count,
        spared | real,
    )
