"""What the rows of the balance and of the stiffness have in common: forces that act between two
coordinates, and symmetry.
"""

import itertools

import sympy as sp
from sympy import Expr, Matrix

from . import symmetry
from .algebra import Row, equal, expanded
from .mechanics import Mechanics, NormalForce


def sums(model: Mechanics) -> Matrix:
    """T, of det T = 1: in the rows of T F springs between two coordinates and normal forces whose
    direction turns act in as few as may be.

    The force of a spring stands with both signs in two rows of F, and their sum is without it. A
    normal force stands in each row with the slope of its gap and of what its friction opposes;
    where one of these is a number, its row tells the force, and others are without it. T F and F
    vanish together, and where they do, the determinant of their derivatives is det K. A row of
    coordinates that the mirror turns is added to another such row only.
    """
    n = len(model.coordinates)
    T, rows, turned = sp.eye(n), list(model.residuals), symmetry.mirror(model).centres
    for contact in model.contacts:
        along = _along_force(model, contact)
        pivot = next((i for i, part in enumerate(along) if part.is_Number and part != 0), None)
        if pivot is None or not any(part.has(*model.coordinates) for part in along):
            continue
        for i in range(n):
            alike = (model.coordinates[i] in turned) == (model.coordinates[pivot] in turned)
            if i != pivot and along[i] != 0 and alike:
                factor = along[i] / along[pivot]
                rows[i] = expanded(rows[i] - factor * rows[pivot])
                T[i, :] -= factor * T[pivot, :]
    for i, j in itertools.combinations(range(n), 2):
        if (model.coordinates[i] in turned) != (model.coordinates[j] in turned):
            continue
        for sign in (1, -1):
            total = expanded(rows[j] + sign * rows[i])
            if _directions(model, total) < _directions(model, rows[j]):
                rows[j] = total
                T[j, :] += sign * T[i, :]
    return T


def without_coordinates(
    model: Mechanics, rows: Row, stiffness: Matrix
) -> dict[int, list[tuple[Expr, Expr]]]:
    """Sums of rows in which no coordinate stands: where such a sum is not 0 nothing balances it,
    and these contacts touch in no state.

    ``stiffness`` has the derivatives of the rows. Each sum stands under the number of one of its
    rows, behind a factor that is 1 for its combination of contacts that touch and 0 for others. K
    is singular there whatever the coordinates, and the sum is F times a vector that Kᵀ turns to 0.
    """
    found: dict[int, list[tuple[Expr, Expr]]] = {}
    F = Matrix(rows)
    moving = {*model.coordinates, *model.directions, *model.turned}
    opening = [one for one in model.pushings if F.has(one)]
    for touching in itertools.product((1, 0), repeat=len(opening)):
        there = dict(zip(opening, touching, strict=True))
        K = stiffness.subs(there).applyfunc(sp.expand)
        if not all(entry.is_polynomial(*moving) for entry in K) or sp.expand(K.det()) != 0:
            continue
        factor = sp.prod(one if closed else 1 - one for one, closed in there.items())
        for vector in K.T.nullspace():
            weights = (vector * sp.lcm_list([sp.denom(sp.cancel(it)) for it in vector])).applyfunc(
                sp.cancel
            )
            total = expanded((weights.T * F.subs(there))[0])
            some = [i for i, weight in enumerate(weights) if weight != 0]
            row = next((i for i in reversed(some) if weights[i].is_nonzero), None)
            alone = total != 0 and not total.free_symbols & moving
            if alone and len(some) > 1 and row is not None:
                found.setdefault(row, []).append((factor, total / weights[row]))
    return found


def _along_force(model: Mechanics, contact: NormalForce) -> list[Expr]:
    """What of a contact's force stands in each row, but for the sign; nothing of a given one, and
    of one that rubs on either of two faces.
    """
    if contact.gap is None or contact.either_face:
        return []
    rubbing = [one for one in model.frictions if one.normal is contact and one.along is not None]
    return [
        expanded(
            sp.diff(contact.gap, symbol)
            + sum(one.mu * sp.diff(one.along, symbol) for one in rubbing)
        )
        for symbol in model.coordinates
    ]


def _directions(model: Mechanics, row: Expr) -> set[sp.Symbol]:
    """Directions and lengths of springs that a row holds."""
    return row.free_symbols & set(model.directions)


def symmetric(model: Mechanics, stiffness: Matrix) -> bool:
    """Whether K is symmetric where the friction coefficient is 0: not with a force that follows a
    coordinate, for one.
    """
    return _symmetric(model, stiffness.subs(dict.fromkeys(model.coefficients, 0)))


def circulatory(model: Mechanics, stiffness: Matrix) -> list[bool]:
    """Whether each friction makes K asymmetric: not one that opposes a coordinate with a normal
    force of that coordinate alone. K is linear in the coefficients.
    """
    return [not _symmetric(model, stiffness.diff(mu)) for mu in model.coefficients]


def _symmetric(model: Mechanics, K: Matrix) -> bool:
    circles = tuple((line.c, line.s) for line in model.lines)
    return all(equal(K[i, j], K[j, i], circles) for i in range(K.rows) for j in range(i))
