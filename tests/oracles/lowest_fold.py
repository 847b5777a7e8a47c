"""The friction of the lowest fold of all angles by a scan of first jumps, and to 50 digits by the
balance of forces.
"""

from typing import Any

import mpmath
import numpy as np

import spragsym as ss
from spragsym.kang_nam.kernel import Fixed

#: Angles of the first scan, of each refinement about its least value, and how many of those there
#: are.
COARSE, FINE, TIMES = 160, 13, 3
#: What a scan may miss of a minimum, relative, and what a value beside a cusp may exceed it by.
ABOVE, BESIDE = 1e-7, 1e-4


def first_jumps(p: ss.Parameters, angles: np.ndarray) -> np.ndarray:
    """Friction of the first jump at each of many angles, infinite where there is none."""
    value = np.asarray(ss.jump_value(p.replace(theta0=angles)))
    return np.where(np.isnan(value), np.inf, value)


def scanned(p: ss.Parameters, times: int = TIMES) -> tuple[float, float]:
    """The least friction of a first jump that a scan over all angles finds, refined about it, and
    its angle; infinite for none.
    """
    angles = np.unique(
        np.concatenate([np.geomspace(1e-9, 0.01, 8), np.linspace(0.01, np.pi - 0.01, COARSE)])
    )
    value = first_jumps(p, angles)
    for _ in range(times):
        least = int(np.argmin(value))
        if not np.isfinite(value[least]):
            break
        around = angles[[max(least - 1, 0), min(least + 1, angles.size - 1)]]
        angles = np.unique(np.append(np.linspace(*around, FINE), angles[least]))
        value = first_jumps(p, angles)
    least = int(np.argmin(value))
    return float(value[least]), float(angles[least])


def verdict(p: ss.Parameters) -> tuple[str, str]:
    """The kind of the lowest fold, and "right", "above" (something jumps below it) or "below"
    (nothing jumps at it).
    """
    found = ss.critical_friction(p)
    least, _ = scanned(p)
    if float(found) > least * (1 + 1e-12):
        return found.kind, "above"
    if not found.kind or least <= float(found) * (1 + ABOVE) + 1e-300:
        return found.kind, "right"
    # A window of angles between those of the scan, or a cusp, which is the end of the angles that
    # jump: beside it.
    beside = found.theta0 * (
        1 + np.array([0.0, *(side * 10.0**-k for k in range(4, 12, 2) for side in (-1, 1))])
    )
    return found.kind, "right" if first_jumps(p, beside[beside > 0]).min() <= float(found) * (
        1 + BESIDE
    ) + BESIDE**2 else "below"


# ------------------------------------------------------------------------------------------------
# the balance of forces, (14) and (15)


def balance(x: Any, y: Any, theta0: Any, mu0: Any, fixed: tuple[Any, ...]) -> tuple[Any, ...]:
    """F_x and F_y in contact, det ∂F/∂(x, y), a vector that is 0 under ∂F/∂(x, y) where that is
    singular, and (∂F_y/∂y, −∂F_x/∂y) F_θ₀.
    """
    kappa, alpha, sigma, beta = fixed
    rx, ry = mpmath.cos(theta0) - x, mpmath.sin(theta0) - y
    L = mpmath.sqrt(rx * rx + ry * ry)
    pull, bend = sigma * (1 / L - 1), sigma / L**3
    force = pull * rx + alpha * x + mu0 * y, pull * ry + (beta + 1) * y + kappa
    xx, xy = bend * rx * rx - pull + alpha, bend * rx * ry + mu0
    yx, yy = bend * rx * ry, bend * ry * ry - pull + beta + 1
    dx, dy = -mpmath.sin(theta0), mpmath.cos(theta0)
    stretch = bend * (rx * dx + ry * dy)
    turned = pull * dx - stretch * rx, pull * dy - stretch * ry
    return (*force, xx * yy - xy * yx, (-xy, xx), yy * turned[0] - xy * turned[1])


def in_digits(p: ss.Parameters, digits: int = 50, times: int = 2 * TIMES) -> tuple[Any, Any]:
    """Angle and friction of the lowest fold by Newton's method on the balance of forces, from where
    a scan finds the least jump.
    """
    found = ss.critical_friction(p)
    values = p.scalars(*Fixed._fields)
    friction, angle = scanned(p, times)
    path = ss.quasi_static_path(p.replace(theta0=angle), "mu0", [0.0, friction])
    with mpmath.workdps(digits + 10):
        fixed = tuple(map(mpmath.mpf, values))

        def system(x: Any, y: Any, theta0: Any, mu0: Any) -> list[Any]:
            fx, fy, det, (vx, vy), turned = balance(x, y, theta0, mu0, fixed)
            if found.kind == "turn":
                return [fx, fy, det, turned]
            across = mpmath.diff(
                lambda h: balance(x + h * vx, y + h * vy, theta0, mu0, fixed)[2], 0
            )
            return [fx, fy, det, across]

        start = float(path.x[-1]), float(path.y[-1]), angle, friction
        try:
            return mpmath.findroot(
                system,
                tuple(map(mpmath.mpf, start)),
                tol=mpmath.mpf(10) ** (-2 * digits),
                maxsteps=60,
            )[2:]
        except (
            ValueError
        ):  # from where it began Newton's method does not converge: nearer, once or twice
            if times > 4 * TIMES:
                raise
    return in_digits(p, digits, 2 * times)
