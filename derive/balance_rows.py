"""What the rows of the balance and of the stiffness have in common: forces that act between two
coordinates, and symmetry.
"""

import itertools

import sympy as sp

from . import symmetry
from .algebra import equal, expanded
from .mechanics import Mechanics


def sums(model: Mechanics) -> sp.Matrix:
    """T, the unit matrix with further entries ±1: in the rows of T F a spring between two
    coordinates acts in as few as may be.

    Its force stands with both signs in two rows of F, and their sum is without it. det T is 1, so
    that T F and F vanish together, and det(T K) is det K. A row of coordinates that the mirror
    turns is added to another such row only.
    """
    n = len(model.coordinates)
    T, rows, turned = sp.eye(n), list(model.residuals), symmetry.mirror(model).centres
    for i, j in itertools.combinations(range(n), 2):
        if (model.coordinates[i] in turned) != (model.coordinates[j] in turned):
            continue
        for sign in (1, -1):
            total = expanded(rows[j] + sign * rows[i])
            if _directions(model, total) < _directions(model, rows[j]):
                rows[j] = total
                T[j, :] += sign * T[i, :]
    return T


def _directions(model: Mechanics, row: sp.Expr) -> set[sp.Symbol]:
    """Directions and lengths of springs that a row holds."""
    return row.free_symbols & set(model.directions)


def symmetric(model: Mechanics, stiffness: sp.Matrix) -> bool:
    """Whether K is symmetric where the friction coefficient is 0: not with a force that follows a
    coordinate, for one.
    """
    K = stiffness.subs(dict.fromkeys(model.coefficients, 0))
    circles = tuple((line.c, line.s) for line in model.lines)
    return all(equal(K[i, j], K[j, i], circles) for i in range(K.rows) for j in range(i))
