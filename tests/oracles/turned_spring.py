"""States of a spring with a torsion spring at its anchor, in 50 digits: one scalar equation in the
torsion spring's angle.
"""

from typing import Any

import mpmath as mp
import numpy as np

#: Parts of the turn from −π to π between which a change of sign is looked for.
TURN_PARTS = 40_000


def turned_spring(p: Any, contact: bool) -> list[tuple[Any, Any]]:
    """All states of ``tests/oracles/pages/soft_brake.py``, an inclined spring with a torsion spring
    at its anchor, as (x, y), sorted.

    With the angle φ of the torsion spring given, the balance along the spring is a quadratic
    equation in its length, linear in lift-off, and the balance across it a function of φ on each
    branch of its roots. Changes of sign on a grid are refined, which is ever finer towards the ends
    of the branches; two roots within one part of the grid are missed.
    """
    names = ("theta0", "mu0", "kappa", "alpha", "sigma", "tau", "gamma")
    theta0, mu, kappa, alpha, sigma, tau, gamma = (
        mp.mpf(float(getattr(p, name))) for name in names
    )
    exact = (theta0, mu * contact, kappa, alpha, sigma, tau, gamma)
    rough = tuple(map(float, exact))
    grid = _towards_ends(
        np.pi * (2 * (np.arange(TURN_PARTS) + 1 / 3) / TURN_PARTS - 1), contact, rough
    )
    found = []
    for branch in (0, 1):
        with np.errstate(all="ignore"):
            lacking = _turned(grid, branch, contact, rough, np)[2]
        for k in np.flatnonzero(lacking[:-1] * lacking[1:] <= 0).tolist():
            ends = tuple(mp.mpf(float(grid[k + i])) for i in (0, 1))
            phi = mp.findroot(
                lambda phi, b=branch: _turned(phi, b, contact, exact, mp)[2],
                ends,
                solver="anderson",
                tol=1e-80,
                verify=False,
            )
            x, y, lacks, length = _turned(phi, branch, contact, exact, mp)
            if (
                length > 0 and (y < 0) == contact and abs(lacks) < 1e-30 * (1 + tau)
            ):  # a pole of the branch changes sign, too
                found.append((x, y))
    return sorted(found)


def _towards_ends(grid: Any, contact: bool, numbers: tuple[float, ...]) -> Any:
    """The grid with points at halved distances from where the quadratic equation ceases to have
    roots.
    """
    with np.errstate(all="ignore"):
        there = np.isfinite(_turned(grid, 0, contact, numbers, np)[3])
        last = np.flatnonzero(there[:-1] != there[1:])
        first = np.where(there[last], grid[last], grid[last + 1])
        inside, outside = first, np.where(there[last], grid[last + 1], grid[last])
        for _ in range(60):
            middle = (inside + outside) / 2
            known = np.isfinite(_turned(middle, 0, contact, numbers, np)[3])
            inside, outside = np.where(known, middle, inside), np.where(known, outside, middle)
    return np.unique(
        np.concatenate([grid, *(inside + (first - inside) * 2.0**-j for j in range(48))])
    )


def _turned(
    phi: Any, branch: int, contact: bool, numbers: tuple[Any, ...], xp: Any
) -> tuple[Any, Any, Any, Any]:
    """x, y, what the torque lacks to balance, and the length that balances the forces along the
    spring on a branch.
    """
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
    length = (
        constant / larger
        if branch == 0
        else larger / (quadratic + (0 if xp is np else mp.mpf("1e-400")))
    )
    x, y = X - length * c, Y - length * s
    n = (gamma * y**2 - y) * contact
    return x, y, length * ((kappa - n) * c - (alpha * x - mu * n) * s) - tau * phi, length
