"""States of the shipped models by other formulations, in 50 digits: one scalar equation in the spring's direction, or one polynomial."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

import spragsym as ss

#: Parts of the half circle between which a change of sign is looked for.
PARTS = 400


def linear(n: Any) -> Any:
    """Depth at which the contact of the article pushes with n."""
    return n


def hertz(n: Any) -> Any:
    """The same for (depth)^(3/2)."""
    return mp.cbrt(n) ** 2


def cubic(gamma: Any) -> Callable[[Any], Any]:
    """The same for depth + γ depth³, by Cardano's formula."""

    def depth(n: Any) -> Any:
        half = n / (2 * gamma)
        root = mp.sqrt(half**2 + 1 / (27 * mp.mpf(gamma) ** 3))
        return mp.cbrt(half + root) - mp.cbrt(root - half)

    return depth


def one_spring(p: Any, depth: Callable[[Any], Any], loads: tuple[Any, Any] = (0, 0), anchor: Any = None) -> list[tuple[Any, ...]]:
    """All states in contact of a model with one inclined spring, as (x, y) or (x, y, x_a), sorted.

    With the direction θ given, the balance across the belt is one equation in the normal force, whose left side falls with it; then
    all else follows, and the balance along the belt is a function of θ. Its changes of sign on a grid are refined.

    Parameters
    ----------
    p : Parameters
    depth : callable
        Penetration by normal force.
    loads : pair
        Forces against x and y beside those of the article.
    anchor : number, optional
        Stiffness that holds the anchor along the belt; without it the anchor is fixed.
    """
    theta0, mu, kappa, alpha, sigma, beta = (
        mp.mpf(float(getattr(p, name))) for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")
    )
    c0, s0 = mp.cos(theta0), mp.sin(theta0)

    def state(theta: Any) -> tuple[Any, tuple[Any, ...]] | None:
        c, s = mp.cos(theta), mp.sin(theta)
        push = kappa + loads[1] + sigma * (s - s0)
        if push <= 0:
            return None
        n = mp.findroot(lambda n: push - (beta + sigma) * depth(n) - n, (mp.mpf(0), push), solver="anderson", tol=1e-90)
        y = -depth(n)
        L = (s0 - y) / s
        if L <= 0:
            return None
        stretch = sigma * (c - L * c)
        moved = 0 if anchor is None else stretch / anchor
        x = c0 - L * c + moved
        rest = alpha * x + stretch - mu * n + loads[0]
        return rest, (x, y) if anchor is None else (x, y, moved)

    def rest(theta: Any) -> Any:
        found = state(theta)
        assert found is not None  # between two angles that have one
        return found[0]

    grid = [mp.pi * (k + mp.mpf(1) / 3) / PARTS for k in range(PARTS)]
    known = [state(theta) for theta in grid]
    roots = []
    for k in range(PARTS - 1):
        one, two = known[k], known[k + 1]
        if one and two and one[0] * two[0] < 0:
            found = state(mp.findroot(rest, (grid[k], grid[k + 1]), solver="anderson", tol=1e-80))
            assert found is not None  # as above
            roots.append(found[1])
    return sorted(roots)


def two_springs(p: Any) -> list[tuple[Any, Any]]:
    """All states in contact of two inclined springs: Sylvester's resultant of the balance in the tangents of both half angles."""
    names = ("mu0", "kappa", "alpha", "sigma", "beta", "sigma_2", "lambda_2")
    mu, kappa, alpha, sigma, beta, sigma_2, lambda_2 = (sp.Rational(float(getattr(p, name))) for name in names)
    angles = [mp.mpf(float(getattr(p, name))) for name in ("theta0", "theta0_2")]
    c0, s0, c02, s02 = (sp.Rational(str(f(angle))) for angle in angles for f in (mp.cos, mp.sin))
    t1, t2 = sp.symbols("t1 t2")
    (c1, s1), (c2, s2) = (((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)) for t in (t1, t2))
    w = lambda_2 * sigma_2
    y = (-kappa - sigma * (s1 - s0) - w * (s2 - s02)) / (beta + 1 + sigma + sigma_2)
    x = (-mu * y - sigma * (c1 - c0) - w * (c2 - c02)) / (alpha + sigma + sigma_2)
    ends = ((c0 - x, s0 - y), (lambda_2 * c02 - x, lambda_2 * s02 - y))
    along = [sp.numer(sp.together(dx * s - dy * c)) for (dx, dy), (c, s) in zip(ends, ((c1, s1), (c2, s2)), strict=True)]
    polynomials = [sp.Poly(part / max(map(abs, sp.Poly(part, t2, t1).coeffs())), t2, t1) for part in along]
    resultant = sp.Poly(sp.resultant(*polynomials), t1)
    second = sp.lambdify((t1, t2), polynomials[1].as_expr(), "mpmath")
    lengths = [dx * c + dy * s for (dx, dy), (c, s) in zip(ends, ((c1, s1), (c2, s2)), strict=True)]
    values = sp.lambdify((t1, t2), [x, y, *lengths], "mpmath")
    found = []
    for factor, _ in resultant.factor_list()[1]:
        for root in factor.nroots(n=60, maxsteps=500):
            if abs(sp.im(root)) > 1e-40:
                continue
            one = mp.mpf(sp.re(root))
            slices = sp.Poly(polynomials[0].as_expr().subs(t1, sp.Float(str(one), 60)), t2)
            for two in slices.nroots(n=50, maxsteps=500):
                if abs(sp.im(two)) < 1e-20 and abs(second(one, mp.mpf(sp.re(two)))) < 1e-18:
                    x_, y_, L1, L2 = values(one, mp.mpf(sp.re(two)))
                    if L1 > 0 and L2 > 0 and y_ < 0:
                        found.append((x_, y_))
    return sorted(found)


#: Parts of the turn from −π to π between which a change of sign is looked for.
TURN_PARTS = 40_000


def turned_spring(p: Any, contact: bool) -> list[tuple[Any, Any]]:
    """All states of ``tests/oracles/pages/soft_brake.py``, an inclined spring with a torsion spring at its anchor, as (x, y), sorted.

    With the angle φ of the torsion spring given, the balance along the spring is a quadratic equation in its length, linear in
    lift-off, and the balance across it a function of φ on each branch of its roots. Changes of sign on a grid are refined, which is
    ever finer towards the ends of the branches; two roots within one part of the grid are missed.
    """
    names = ("theta0", "mu0", "kappa", "alpha", "sigma", "tau", "gamma")
    theta0, mu, kappa, alpha, sigma, tau, gamma = (mp.mpf(float(getattr(p, name))) for name in names)
    exact = (theta0, mu * contact, kappa, alpha, sigma, tau, gamma)
    rough = tuple(map(float, exact))
    grid = _towards_ends(np.pi * (2 * (np.arange(TURN_PARTS) + 1 / 3) / TURN_PARTS - 1), contact, rough)
    found = []
    for branch in (0, 1):
        with np.errstate(all="ignore"):
            lacking = _turned(grid, branch, contact, rough, np)[2]
        for k in np.flatnonzero(lacking[:-1] * lacking[1:] <= 0).tolist():
            ends = tuple(mp.mpf(float(grid[k + i])) for i in (0, 1))
            phi = mp.findroot(
                lambda phi, b=branch: _turned(phi, b, contact, exact, mp)[2], ends, solver="anderson", tol=1e-80, verify=False
            )
            x, y, lacks, length = _turned(phi, branch, contact, exact, mp)
            if length > 0 and (y < 0) == contact and abs(lacks) < 1e-30 * (1 + tau):  # a pole of the branch changes sign, too
                found.append((x, y))
    return sorted(found)


def _towards_ends(grid: Any, contact: bool, numbers: tuple[float, ...]) -> Any:
    """The grid with points at halved distances from where the quadratic equation ceases to have roots."""
    with np.errstate(all="ignore"):
        there = np.isfinite(_turned(grid, 0, contact, numbers, np)[3])
        last = np.flatnonzero(there[:-1] != there[1:])
        first = np.where(there[last], grid[last], grid[last + 1])
        inside, outside = first, np.where(there[last], grid[last + 1], grid[last])
        for _ in range(60):
            middle = (inside + outside) / 2
            known = np.isfinite(_turned(middle, 0, contact, numbers, np)[3])
            inside, outside = np.where(known, middle, inside), np.where(known, outside, middle)
    return np.unique(np.concatenate([grid, *(inside + (first - inside) * 2.0**-j for j in range(48))]))


def _turned(phi: Any, branch: int, contact: bool, numbers: tuple[Any, ...], xp: Any) -> tuple[Any, Any, Any, Any]:
    """x, y, what the torque lacks to balance, and the length that balances the forces along the spring on a branch."""
    theta0, mu, kappa, alpha, sigma, tau, gamma = numbers
    X, Y = xp.cos(theta0), xp.sin(theta0)
    c, s = xp.cos(theta0 + phi), xp.sin(theta0 + phi)
    pull = (mu * c + s) * contact
    quadratic = -pull * gamma * s**2
    linear = -alpha * c**2 - sigma - pull * s * (1 - 2 * gamma * Y)
    constant = alpha * X * c + s * kappa + sigma - pull * (gamma * Y**2 - Y)
    root = xp.sqrt(linear**2 - 4 * quadratic * constant)
    root = root if xp is np else mp.re(root)
    # Without cancellation; the first branch is that of a linear law.
    larger = -(linear + xp.sign(linear) * root) / 2
    length = constant / larger if branch == 0 else larger / (quadratic + (0 if xp is np else mp.mpf("1e-400")))
    x, y = X - length * c, Y - length * s
    n = (gamma * y**2 - y) * contact
    return x, y, length * ((kappa - n) * c - (alpha * x - mu * n) * s) - tau * phi, length


def loads(p: Any) -> tuple[Any, Any]:
    """Weight on an inclined belt."""
    weight, psi = mp.mpf(float(p.gamma_g)), mp.mpf(float(p.psi))
    return weight * mp.sin(psi), weight * mp.cos(psi)


#: For each page its states in 50 digits.
PAGES: dict[str, Callable[[Any], list[tuple[Any, ...]]]] = {
    "cubic_contact": lambda p: one_spring(p, cubic(float(p.gamma))),
    "hertz_contact": lambda p: one_spring(p, hertz),
    "inclined_belt": lambda p: one_spring(p, linear, loads(p)),
    "trolley": lambda p: one_spring(p, linear, anchor=mp.mpf(float(p.alpha_a))),
    "two_springs": two_springs,
}


def compare(name: str, p: Any) -> tuple[bool, float]:
    """Whether the number of states is the same, and the largest error over its bound."""
    eq = ss.equilibria(p, method="search")
    with mp.workdps(50):
        want = PAGES[name](p)
        if not eq.complete or int(eq.count) != len(want):
            return False, np.inf
        got = [eq.coordinates[key] for key in eq.coordinates]
        ratios = [
            float(abs(mp.mpf(float(column[slot])) - value) / max(1, abs(value)) / mp.mpf(float(eq.error[slot])))
            for slot, state in enumerate(want)
            for column, value in zip(got, state, strict=True)
        ]
    return True, max(ratios, default=0.0)
