"""Row operations on the balance of forces F = 0 and the stiffness matrix K, and symmetry of K.

Sums of rows in which stiff forces cancel give narrower intervals than the rows themselves.
"""

import itertools

import sympy as sp
from sympy import Expr, Matrix

from . import symmetry
from .algebra import Row, equal, expanded
from .mechanics import Mechanics, NormalForce


def sums(model: Mechanics) -> Matrix:
    """A matrix T with det T = 1, such that as few rows of T F as possible hold the forces of
    springs between two coordinates, and normal forces of varying direction.

    The force of such a spring is in two rows of F with opposite signs, and cancels in their sum. A
    normal force is in each row with a factor from the slopes of its gap and of the displacement
    that its friction opposes; a row with a constant factor eliminates it from the others. T F and F
    have the same zeros, and there the same determinant of the derivatives, det K. Rows that the
    mirror reflects and rows that it does not are not added to each other.
    """
    n = len(model.coordinates)
    T, rows, images = sp.eye(n), list(model.residuals), symmetry.mirror(model).images
    reflected = [symbol in images for symbol in model.coordinates]
    for contact in model.contacts:
        along = _along_force(model, contact)
        pivot = next((i for i, part in enumerate(along) if part.is_Number and part != 0), None)
        if pivot is None or not any(part.has(*model.coordinates) for part in along):
            continue
        for i in range(n):
            if i != pivot and along[i] != 0 and reflected[i] == reflected[pivot]:
                factor = along[i] / along[pivot]
                rows[i] = expanded(rows[i] - factor * rows[pivot])
                T[i, :] -= factor * T[pivot, :]
    for i, j in itertools.combinations(range(n), 2):
        if reflected[i] != reflected[j]:
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
    """Sums of rows that depend on no coordinate, for combinations of touching contacts.

    If such a sum is not 0, there is no equilibrium with that combination. It is wᵀ F for a vector w
    with Kᵀ w = 0, of a K that is singular at all coordinates.

    Parameters
    ----------
    model : Mechanics
    rows : tuple
        The rows F.
    stiffness : Matrix
        Their derivatives K by the coordinates.

    Returns
    -------
    dict
        By the index of one row of a sum: a factor that is 1 for the combination of contacts and 0
        for others, and the sum scaled to that row.
    """
    found: dict[int, list[tuple[Expr, Expr]]] = {}
    F = Matrix(rows)
    moving = {*model.coordinates, *model.directions, *model.turned}
    opening = [one for one in model.pushings if F.has(one)]
    for touching in itertools.product((1, 0), repeat=len(opening)):
        combination = dict(zip(opening, touching, strict=True))
        K = stiffness.subs(combination).applyfunc(sp.expand)
        if not all(entry.is_polynomial(*moving) for entry in K) or sp.expand(K.det()) != 0:
            continue
        factor = sp.prod(one if closed else 1 - one for one, closed in combination.items())
        for vector in K.T.nullspace():
            weights = (vector * sp.lcm_list([sp.denom(sp.cancel(it)) for it in vector])).applyfunc(
                sp.cancel
            )
            total = expanded((weights.T * F.subs(combination))[0])
            nonzero = [i for i, weight in enumerate(weights) if weight != 0]
            row = next((i for i in reversed(nonzero) if weights[i].is_nonzero), None)
            is_constant = total != 0 and not total.free_symbols & moving
            if is_constant and len(nonzero) > 1 and row is not None:
                found.setdefault(row, []).append((factor, total / weights[row]))
    return found


def _along_force(model: Mechanics, contact: NormalForce) -> list[Expr]:
    """The factors of a contact's normal force in the rows, up to the sign; none of a given force,
    or of a contact with two faces.
    """
    if contact.gap is None or contact.either_face:
        return []
    rubbing = [one for one in model.frictions if one.normal is contact]
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
    """Whether K is symmetric without friction; a follower force, for example, is not."""
    return _symmetric(model, stiffness.subs(dict.fromkeys(model.coefficients, 0)))


def circulatory(model: Mechanics, stiffness: Matrix) -> list[bool]:
    """For each friction, whether it makes K asymmetric.

    K is linear in the coefficients, so that each is judged by its own term.
    """
    return [not _symmetric(model, stiffness.diff(mu)) for mu in model.coefficients]


def _symmetric(model: Mechanics, K: Matrix) -> bool:
    circles = tuple((line.c, line.s) for line in model.lines)
    return all(equal(K[i, j], K[j, i], circles) for i in range(K.rows) for j in range(i))
