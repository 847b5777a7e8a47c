"""The lowest fold against scans of ``jump_value`` over the inclination, and against the balance of forces in 50 digits.

Run ``python -m validation.lowest [what] [sets] [seed] [store] [seconds]``, with ``what`` one of scan, digits, speed. Finished
parts go to the file ``store``, and a second call goes on from there.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from typing import Any

import mpmath
import numpy as np

import spragsym as ss
from spragsym.kang_nam.catastrophe.fixed_parameters import FIXED
from validation import parts
from validation.folds import random_fixed

#: Angles of the first scan, of each refinement about its least value, and how many of those there are.
COARSE, FINE, TIMES = 160, 13, 3
#: What a scan may miss of a minimum, relative, and what a value beside a cusp may exceed it by.
ABOVE, BESIDE = 1e-7, 1e-4


def first_jumps(p: ss.Parameters, angles: np.ndarray) -> np.ndarray:
    """Friction of the first jump at each of many angles, infinite where there is none."""
    value = np.asarray(ss.jump_value(p.replace(theta0=angles)))
    return np.where(np.isnan(value), np.inf, value)


def scanned(p: ss.Parameters, times: int = TIMES) -> tuple[float, float]:
    """The least friction of a first jump that a scan over all angles finds, refined about it, and its angle; infinite for none."""
    angles = np.unique(np.concatenate([np.geomspace(1e-9, 0.01, 8), np.linspace(0.01, np.pi - 0.01, COARSE)]))
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
    """The kind of the lowest fold, and "right", "above" (something jumps below it) or "below" (nothing jumps at it)."""
    found = ss.critical_friction(p)
    least, _ = scanned(p)
    if float(found) > least * (1 + 1e-12):
        return found.kind, "above"
    if not found.kind or least <= float(found) * (1 + ABOVE) + 1e-300:
        return found.kind, "right"
    # A window of angles between those of the scan, or a cusp, which is the end of the angles that jump: beside it.
    beside = found.theta0 * (1 + np.array([0.0, *(side * 10.0**-k for k in range(4, 12, 2) for side in (-1, 1))]))
    return found.kind, "right" if first_jumps(p, beside[beside > 0]).min() <= float(found) * (1 + BESIDE) + BESIDE**2 else "below"


def compared(part: str) -> dict[str, Any]:
    """A hundred sets: how many of each kind, and those that are wrong."""
    seed, number = map(int, part.split())
    rng = np.random.default_rng(seed)
    kinds: Counter[str] = Counter()
    wrong = []
    for _ in range(number):
        p = random_fixed(rng)
        kind, outcome = verdict(p)
        kinds[kind or "none"] += 1
        if outcome != "right":
            wrong.append([outcome, kind, *(float(getattr(p, name)) for name in FIXED)])
            print("wrong:", wrong[-1])
    return {"kinds": dict(kinds), "wrong": wrong}


def scan(number: int, seed: int = 1, store: str = "", seconds: float = np.inf) -> int:
    """How many of ``number`` random sets have a lowest fold that a scan contradicts."""
    names = [f"{1000 * seed + i} {min(100, number - 100 * i)}" for i in range(-(-number // 100))]
    done = parts.run(names, compared, store, seconds).values()
    kinds = sum((Counter(row["kinds"]) for row in done), Counter[str]())
    wrong = Counter(one[0] for row in done for one in row["wrong"])
    print(f"{kinds.total()} sets of {number}: {dict(kinds)}; {wrong['above']} above, {wrong['below']} below")
    return wrong.total()


# ------------------------------------------------------------------------------------------ the balance of forces, (14) and (15)


def balance(x: Any, y: Any, theta0: Any, mu0: Any, fixed: tuple[Any, ...]) -> tuple[Any, ...]:
    """F_x and F_y in contact, det ∂F/∂(x, y), a vector that is 0 under ∂F/∂(x, y) where that is singular, and (∂F_y/∂y, −∂F_x/∂y) F_θ₀."""
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


def in_digits(p: ss.Parameters, digits: int = 50, times: int = 2 * TIMES) -> Any:
    """The friction of the lowest fold by Newton's method on the balance of forces, from where a scan finds the least jump."""
    found = ss.critical_friction(p)
    values = p.scalars(*FIXED)
    friction, angle = scanned(p, times)
    path = ss.quasi_static_path(p.replace(theta0=angle), "mu0", [0.0, friction])
    with mpmath.workdps(digits + 10):
        fixed = tuple(map(mpmath.mpf, values))

        def system(x: Any, y: Any, theta0: Any, mu0: Any) -> list[Any]:
            fx, fy, det, (vx, vy), turned = balance(x, y, theta0, mu0, fixed)
            if found.kind == "turn":
                return [fx, fy, det, turned]
            across = mpmath.diff(lambda h: balance(x + h * vx, y + h * vy, theta0, mu0, fixed)[2], 0)
            return [fx, fy, det, across]

        start = float(path.x[-1]), float(path.y[-1]), angle, friction
        try:
            return mpmath.findroot(system, tuple(map(mpmath.mpf, start)), tol=mpmath.mpf(10) ** (-2 * digits), maxsteps=60)[3]
        except ValueError:  # from where it began Newton's method does not converge: nearer, once or twice
            if times > 4 * TIMES:
                raise
    return in_digits(p, digits, 2 * times)


def digits(number: int, seed: int = 1, store: str = "", seconds: float = np.inf) -> int:
    """How many of ``number`` random sets with a lowest fold differ from 50 digits by more than their error."""
    rng = np.random.default_rng(seed)
    sets: list[ss.Parameters] = []
    while len(sets) < number:
        p = random_fixed(rng)
        if ss.critical_friction(p).kind in ("cusp", "turn"):
            sets.append(p)

    def one(part: str) -> list[Any]:
        p = sets[int(part)]
        found, right = ss.critical_friction(p), in_digits(p)
        off = float(abs(right - found.mu0) / max(1, abs(right)))
        return [found.kind, off, bool(off <= found.error)]

    done = parts.run(map(str, range(number)), one, store, seconds).values()
    kinds, bad = Counter(row[0] for row in done), sum(not row[2] for row in done)
    print(
        f"{len(done)} sets of {number}: {dict(kinds)}; largest difference {max(row[1] for row in done):.2g}, {bad} beyond the error"
    )
    return bad


def speed(number: int, seed: int = 1, store: str = "", seconds: float = np.inf) -> int:
    """Milliseconds of the processor's time a set."""
    rng = np.random.default_rng(seed)
    spent = []
    for _ in range(number):
        p = random_fixed(rng)
        begin = time.process_time()
        ss.critical_friction(p)
        spent.append(1e3 * (time.process_time() - begin))
    print(
        f"{number} sets: {np.median(spent):.2g} ms in the middle, {max(spent):.2g} ms at most, {np.mean(spent):.2g} ms on average"
    )
    return 0


CHECKS = {"scan": (scan, 10_000), "digits": (digits, 100), "speed": (speed, 500)}


def main(what: str = "scan", number: str = "", seed: str = "1", store: str = "", seconds: str = "inf") -> int:
    """Run one check; 1 if it fails."""
    check, size = CHECKS[what]
    return int(check(int(number or size), int(seed), store, float(seconds)) > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:6]))
