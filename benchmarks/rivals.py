"""What one would use instead of spragsym to find equilibria: NumPy's, SciPy's and mpmath's solvers
on the published equations.
"""

from collections.abc import Callable
from typing import Any, TypeAlias

import mpmath
import numpy as np
import scipy.optimize
from numpy.typing import NDArray

import spragsym as ss
from spragsym.generated.equilibrium import (
    contact_matrix,
    contact_quartic,
    contact_vector,
    f_coefficients,
    residuals,
    state,
    t_quartic,
)
from spragsym.generated.quantities import PARAMETERS
from spragsym.numerics.polynomials import eigenvalues

Array: TypeAlias = NDArray[np.float64]


def companion_roots(coefficients: Array) -> NDArray[np.complex128]:
    """Roots of quartics, (n, 5) ascending coefficients → (n, 4), as eigenvalues of companion
    matrices; NaN where these overflow.
    """
    with np.errstate(all="ignore"):
        roots = eigenvalues(coefficients).astype(np.complex128, copy=False)
        roots[~np.isfinite(coefficients[:, :4] / coefficients[:, 4:]).all(axis=1)] = np.nan
    return roots


def real_parts(roots: NDArray[np.complex128]) -> tuple[Array, NDArray[np.bool_]]:
    """Real parts, and which of the roots pass for real."""
    return roots.real, np.abs(roots.imag) < 1e-9 * np.abs(roots)


def length_quartic(p: ss.Parameters) -> Array:
    """Coefficients of the published quartic in L, (21), (n, 5), ascending."""
    theta0, *values = p.broadcast(*PARAMETERS)
    return np.stack(contact_quartic(np.cos(theta0), np.sin(theta0), *values), axis=-1)


# ------------------------------------------------------------------------------------------------
# for speed


def roots_loop(p: ss.Parameters) -> list[int]:
    """numpy.roots of the published quartic, and how many roots are real and positive."""
    return [
        int(np.sum((abs(r.imag) < 1e-9) & (r.real > 0)))
        for r in (np.roots(row[::-1]) for row in length_quartic(p))
    ]


def eigvals(p: ss.Parameters) -> NDArray[Any]:
    """Eigenvalues of companion matrices of the published quartic, and how many are real and
    positive.
    """
    roots = companion_roots(length_quartic(p))
    return np.count_nonzero((abs(roots.imag) < 1e-9) & (roots.real > 0), axis=-1)


def fsolve_starts(p: ss.Parameters) -> list[int]:
    """scipy.optimize.root on F_x, F_y from eight directions, and how many different roots it
    finds.
    """
    counts = []
    for theta0, *values in zip(*p.broadcast(*PARAMETERS), strict=True):
        c0, s0 = np.cos(theta0), np.sin(theta0)
        found: list[Array] = []

        def balance(
            z: Array, c0: float = c0, s0: float = s0, values: list[float] = values
        ) -> tuple[float, float]:
            # a pair for SciPy
            return residuals(np.cos(z[0]), np.sin(z[0]), z[1], c0, s0, *values, 1)  # type: ignore[return-value]

        for start in np.linspace(0.2, 2.9, 8):
            outcome = scipy.optimize.root(balance, (start, 1.0))
            if outcome.success and all(np.abs(outcome.x - other).max() > 1e-6 for other in found):
                found.append(outcome.x)
        counts.append(len(found))
    return counts


def polyroots(p: ss.Parameters) -> list[int]:
    """mpmath.polyroots of the quartic in t at 50 digits."""
    counts = []
    with mpmath.workdps(50):
        for theta0, *values in zip(*p.broadcast(*PARAMETERS), strict=True):
            angle = mpmath.mpf(float(theta0))
            numbers = [mpmath.mpf(float(value)) for value in values]
            quartic = t_quartic(*f_coefficients(mpmath.cos(angle), mpmath.sin(angle), *numbers, 1))
            roots = mpmath.polyroots(quartic[::-1], maxsteps=200, extraprec=200)
            counts.append(sum(abs(mpmath.im(r)) < 1e-20 and mpmath.re(r) > 0 for r in roots))
    return counts


# ------------------------------------------------------------------------------------------------
# for accuracy


def states_from_roots(p: ss.Parameters) -> list[Array]:
    """:func:`states_from_lengths` with numpy.roots, one point at a time."""
    return states_from_lengths(
        p, lambda quartics: np.array([np.roots(row[::-1]) for row in quartics])
    )


def states_from_lengths(
    p: ss.Parameters, solve: Callable[[Array], NDArray[np.complex128]] = companion_roots
) -> list[Array]:
    """Roots of the published quartic, states by solving (16), those with L > 0 and y < 0: (L, x, y)
    of each.
    """
    theta0, mu0, kappa, alpha, sigma, beta = p.broadcast(*PARAMETERS)
    c0, s0 = np.cos(theta0), np.sin(theta0)
    rows = []
    with np.errstate(all="ignore"):
        for i, (row, real) in enumerate(zip(*real_parts(solve(length_quartic(p))), strict=True)):
            found = []
            for L in row[real & (row > 0)]:
                D = np.array(contact_matrix(L, mu0[i], alpha[i], sigma[i], beta[i]))
                try:
                    c, s = np.linalg.solve(
                        D, contact_vector(c0[i], s0[i], mu0[i], kappa[i], alpha[i], beta[i])
                    )
                except np.linalg.LinAlgError:
                    continue
                if s0[i] - L * s < 0:
                    found.append([L, c0[i] - L * c, s0[i] - L * s])
            rows.append(np.array(found).reshape(-1, 3))
    return rows


def states_from_half_angles(p: ss.Parameters) -> list[Array]:
    """Roots of the quartic in tan(θ/2), states by the explicit formulas, those with L > 0 and y <
    0: (L, x, y) of each.
    """
    theta0, mu0, kappa, alpha, sigma, beta = p.broadcast(*PARAMETERS)
    c0, s0 = np.cos(theta0), np.sin(theta0)
    quartic = np.stack(
        t_quartic(*f_coefficients(c0, s0, mu0, kappa, alpha, sigma, beta, 1)), axis=-1
    )
    rows = []
    for i, (row, real) in enumerate(zip(*real_parts(companion_roots(quartic)), strict=True)):
        theta = 2 * np.arctan(row[real])
        L, x, y = state(np.cos(theta), np.sin(theta), c0[i], s0[i], kappa[i], sigma[i], beta[i], 1)
        good = (L > 0) & (y < 0)
        rows.append(np.stack([L, x, y], axis=-1)[good])
    return rows
