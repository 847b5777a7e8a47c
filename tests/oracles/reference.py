"""An independent reference for equilibria: counts by Descartes' rule on exact polynomials, states
by Newton's method on forces.

Nothing is shared with the solver but the parameters. The quartic comes from its own elimination, by
hand, in the half angle's cotangent; counts are decided in Arb balls; states are refined on the
un-eliminated balance of forces in mpmath.
"""

import itertools
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath


def count_contact(
    theta0: float, mu0: float, kappa: float, alpha: float, sigma: float, beta: float
) -> int:
    """Number of equilibria in contact, decided with as many bits as it takes."""
    return _decided(_count, theta0, mu0, kappa, alpha, sigma, beta)


def count_liftoff(
    theta0: float, mu0: float, kappa: float, alpha: float, sigma: float, beta: float
) -> int:
    """Number of equilibria in lift-off, by certified roots of the quartic, decided with as many
    bits as it takes.
    """
    return _decided(_count_liftoff, theta0, mu0, kappa, alpha, sigma, beta)


def _decided(count: Callable[[list[object]], int | None], *parameters: float) -> int:
    import flint

    bits = 128
    while bits <= 4096:
        flint.ctx.prec = bits
        values = [flint.arb(flint.fmpq(*Fraction(v).as_integer_ratio())) for v in parameters]
        decided = count(values)
        if decided is not None:
            return decided
        bits *= 2
    raise ArithmeticError("no precision decides the count")


def _count_liftoff(values: list[object]) -> int | None:
    import flint

    e, _ = _quartic(values, push=0)
    # balls, of which mypy knows nothing
    theta0, _, kappa, _, sigma, beta = values  # type: ignore[misc]
    s0 = theta0.sin()  # type: ignore[attr-defined]  # a ball
    try:
        roots = flint.acb_poly(e).roots(tol=flint.arb(2) ** (-flint.ctx.prec // 2))
    except ValueError:  # not isolated with these bits
        return None
    found = 0
    for root in roots:
        if not root.imag.contains(0):
            continue
        # Roots are isolated and come in conjugate pairs: one whose ball meets the real axis is
        # real.
        s = 2 * root.real / (1 + root.real**2)
        L = (sigma * s + beta * s0 + kappa) / ((beta + sigma) * s)
        inside, outside = [L > 0, s0 - L * s > 0], [L < 0, s0 - L * s < 0]
        if not all(inside) and not any(outside):
            return None
        found += all(inside)
    return found


def _quartic(values: list[object], push: int = 1) -> tuple[list[object], object]:
    """Coefficients of the equation for r = cot(θ/2), and s*; from F_x q sin θ = 0 with (1 + r²)²
    cleared.
    """
    # balls, of which mypy knows nothing
    theta0, mu, kappa, alpha, sigma, beta = values  # type: ignore[misc]
    s0, c0 = theta0.sin_cos()  # type: ignore[attr-defined]  # balls, of which mypy knows nothing
    big, mu = beta + push, mu * push  # type: ignore[operator]  # balls
    q = big + sigma
    # F_x = σ c + α c0 + μ s0 − L (p c + μ s), L = (σ s + B s0 + κ)/(q s); times q s. sin θ =
    # 2r/(1+r²), cos θ = (r²−1)/(1+r²).
    sc = sigma * q - sigma * (alpha + sigma)
    c1 = -(big * s0 + kappa) * (alpha + sigma)
    s1 = q * (alpha * c0 + mu * s0) - mu * (big * s0 + kappa)
    s2 = -mu * sigma
    # (1+r²)²: s c → 2r(r²−1); c → (r²−1)(r²+1); s → 2r(1+r²); s² → 4r².
    return [-c1, 2 * s1 - 2 * sc, 4 * s2, 2 * s1 + 2 * sc, c1], s0 - kappa / sigma


def _count(values: list[object]) -> int | None:
    e, threshold = _quartic(values)
    a, b, c, d, f = e[4], e[3], e[2], e[1], e[0]
    delta0 = c * c - 3 * b * d + 12 * a * f
    delta1 = 2 * c * c * c - 9 * b * c * d + 27 * b * b * f + 27 * a * d * d - 72 * a * c * f
    discriminant = 4 * delta0 * delta0 * delta0 - delta1 * delta1
    if discriminant < 0:
        return 1  # two real roots, one of each sign, and an odd number in contact
    if not discriminant > 0:
        return None
    # Four real roots: Descartes' rule is exact for them, on the half line or, moved there, on the
    # arc s > s*.
    if threshold < 0:
        return _variations(e)
    if not threshold > 0:
        return None
    # s > s* is r between r1 and 1/r1: put r = (r1 + u/r1)/(1 + u), u > 0.
    r1 = (1 - (1 - threshold * threshold).sqrt()) / threshold
    r2 = 1 / r1
    moved: list[object] = [0] * 5
    for power, coefficient in enumerate(e):
        term: list[object] = [coefficient]
        for factor in [(r1, r2)] * power + [(1, 1)] * (4 - power):
            term = [
                x * factor[0] + y * factor[1] for x, y in zip([*term, 0], [0, *term], strict=True)
            ]
        moved = [x + y for x, y in zip(moved, term, strict=True)]
    return _variations(moved)


def _variations(coefficients: list[object]) -> int | None:
    """Changes of sign; a coefficient whose sign is open counts if both signs give the same number,
    as next to opposite ones.
    """
    choices = []
    for value in coefficients:
        if value > 0:  # type: ignore[operator]  # balls, of which mypy knows nothing
            choices.append((1,))
        elif value < 0:  # type: ignore[operator]  # balls, of which mypy knows nothing
            choices.append((-1,))
        else:
            choices.append((1, -1))
    counts = {
        sum(x != y for x, y in itertools.pairwise(signs)) for signs in itertools.product(*choices)
    }
    return counts.pop() if len(counts) == 1 else None


def refine(
    x: float,
    y: float,
    theta0: float,
    mu0: float,
    kappa: float,
    alpha: float,
    sigma: float,
    beta: float,
    contact: bool,
    digits: int = 50,
) -> tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf, mpmath.mpf]:
    """θ, L, x, y by Newton's method on the forces (12) and (13), from a state that is known to a
    few digits.
    """
    with mpmath.workdps(digits):
        c0, s0 = mpmath.cos(mpmath.mpf(theta0)), mpmath.sin(mpmath.mpf(theta0))
        mu0, kappa, alpha, sigma, beta = (mpmath.mpf(v) for v in (mu0, kappa, alpha, sigma, beta))
        push = 1 if contact else 0
        x, y = mpmath.mpf(x), mpmath.mpf(y)
        for _ in range(60):
            dx, dy = c0 - x, s0 - y
            L = mpmath.sqrt(dx * dx + dy * dy)
            fx = sigma * (1 / L - 1) * dx + alpha * x + mu0 * push * y
            fy = sigma * (1 / L - 1) * dy + (beta + push) * y + kappa
            kxx = sigma * (1 - dy * dy / L**3) + alpha
            kyy = sigma * (1 - dx * dx / L**3) + beta + push
            kyx = sigma * dx * dy / L**3
            kxy = kyx + mu0 * push
            det = kxx * kyy - kxy * kyx
            step = (kyy * fx - kxy * fy) / det, (kxx * fy - kyx * fx) / det
            x, y = x - step[0], y - step[1]
            if max(abs(step[0]), abs(step[1])) < mpmath.mpf(10) ** (10 - digits):
                break
        L = mpmath.sqrt((c0 - x) ** 2 + (s0 - y) ** 2)
        return mpmath.atan2(s0 - y, c0 - x), L, x, y


def along(theta: Any, theta0: Any, mu0: Any, kappa: Any, alpha: Any, sigma: Any, beta: Any) -> Any:
    """sin θ times the force along the belt in contact, with the L sin θ that balances across it: f
    over q, not eliminated.
    """
    s, c, s0, c0 = mpmath.sin(theta), mpmath.cos(theta), mpmath.sin(theta0), mpmath.cos(theta0)
    length = (sigma * s + (beta + 1) * s0 + kappa) / (beta + 1 + sigma)  # L sin θ
    return sigma * (s - length) * c + alpha * (c0 * s - length * c) + mu0 * s * (s0 - length)


def lack_of_a_state(
    state: tuple[Any, Any, Any, Any], theta0: Any, kappa: Any, sigma: Any, beta: Any
) -> Any:
    """By how much θ, L, x, y in contact miss the balance across the belt, over the stiffnesses, and
    the geometry.
    """
    theta, L, x, y = state
    s, s0 = mpmath.sin(theta), mpmath.sin(theta0)
    across = ((beta + 1 + sigma) * L * s - sigma * s - (beta + 1) * s0 - kappa) / (1 + beta + sigma)
    return max(
        abs(across), abs(mpmath.cos(theta0) - L * mpmath.cos(theta) - x), abs(s0 - L * s - y)
    )
