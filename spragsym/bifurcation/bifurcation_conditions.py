"""Bifurcation conditions appended to the balance: of folds, of cusps, of states on the contact's border, of onsets of flutter."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..numerics.arithmetic import Matrix, Polynomial, characteristic, cofactor, determinant, hurwitz, pencil, resultant, trimmed
from ..numerics.interval_arrays import BoolArray, stacked
from ..numerics.jets import Jet
from ..numerics.polynomials import derivative
from ..statics.mechanics.state import State
from .defining_systems import Condition

#: A slope of the friction law that is as good as 0.
FLAT = 1e-100

#: det K = 0.
FOLD = Condition(lambda at: (determinant(at.slopes()),), singular=True)
#: The gap of the contact is 0.
TOUCH = Condition(lambda at: (at.gap(),), touching=True)
#: det K = 0 and the gap of the contact is 0: a curve of folds leaves the contact.
FOLD_ON_BORDER = Condition(lambda at: (determinant(at.slopes()), at.gap()), touching=True, singular=True)


def cusp(column: int = 0) -> Condition:
    """det K = 0, and K v = 0 for a direction v along which det K does not change.

    Where K has rank n − 1 the columns of its adjugate that are not 0 are multiples of v. One of them is taken: points where that
    one is 0 are roots as well, which :func:`spragsym.bifurcation.cusp_search.told_apart` tells from cusps.
    """

    def equations(at: State) -> Sequence[Any]:
        K = at.slopes()
        return determinant(K), change(K, column)

    return Condition(equations, order=1, singular=True)


def _turns(at: State) -> Sequence[Any]:
    """det K, and the force along w that the first parameter v brings: w · ∂F/∂v with w K = 0.

    A row of the adjugate stands for w: points where that row is 0 are roots as well.
    """
    K, rows = at.slopes(), at.forces()
    pushed = [_slope(row, len(K)) * cofactor(K, i, 0) for i, row in enumerate(rows)]
    return determinant(K), sum(pushed[1:], pushed[0])


#: The curve of folds turns back in the second parameter.
TURN = Condition(_turns, order=1, singular=True)


def _touch_turns(at: State) -> Sequence[Any]:
    """The gap, and the determinant of the slopes of forces and gap by the coordinates and the first parameter."""
    gap = at.gap()
    rows, n = [*at.forces(), gap], len(at.q)
    return gap, determinant([[_slope(row, k) for k in range(n + 1)] for row in rows])


#: The gap is 0, and the curve on which it is turns back in the second parameter.
TOUCH_TURN = Condition(_touch_turns, order=1, touching=True)


def _discriminant(at: State) -> Sequence[Any]:
    """The discriminant of det(K + κ M) in κ, but for a factor."""
    coefficients = characteristic(at.stiffness(), at.mass())
    if len(coefficients) == 3:
        c, b, a = coefficients
        return (b * b - 4 * a * c,)
    return (resultant(coefficients, derivative(coefficients)),)


#: Two roots κ = −λ² of det(K − κ M) meet: the discriminant of that polynomial is 0.
FLUTTER = Condition(_discriminant)
#: Two roots λ of det(λ² M + λ C + K) have the sum 0: the last but one of Hurwitz's determinants is 0.
HOPF = Condition(lambda at: (hurwitz(_characteristic(None, at)),))


def _characteristic(along: int | None, at: State) -> list[Any]:
    """Coefficients of det(λ² M + λ C + K), the lowest first.

    Where C has one entry c, of the coordinate ``along``, the odd ones are c times what they are for c = 1, and the even ones do
    not depend on it. Then 1 stands for c: else conditions on them hold where c is 0.
    """
    K = at.stiffness()
    places = range(len(K))
    C = at.damping() if along is None else [[int(i == j == along) for j in places] for i in places]
    return characteristic(K, C, at.mass())


def bogdanov_takens(along: int | None) -> Condition:
    """Two roots λ are 0: the two lowest coefficients are; ``along`` as of :func:`_characteristic`."""
    return Condition(lambda at: tuple(_characteristic(along, at)[:2]))


def zero_hopf(along: int | None) -> Condition:
    """One root λ is 0, and two others have the sum 0: the lowest coefficient is 0, and Hurwitz's determinant of the others."""

    def equations(at: State) -> Sequence[Any]:
        a = _characteristic(along, at)
        return a[0], hurwitz(a[1:])

    return Condition(equations)


def double_hopf(along: int | None) -> Condition:
    """All four roots λ of two coordinates come in pairs with the sum 0: the odd coefficients are 0."""
    return Condition(lambda at: tuple(_characteristic(along, at)[1::2]))


def undamped_mode(along: int) -> Condition:
    """:data:`HOPF` where only the coordinate ``along`` is damped, by any amount: a mode in which it does not move.

    Then det(λ² M + λ C + K) = A(λ²) + λ c B(λ²) with the only entry c of C, and B a minor of K + λ² M. A pair ± i ω is where A
    and B have a common root, however small c is; it is divided out.
    """

    def equations(at: State) -> Sequence[Any]:
        """The resultant of B and A, less a multiple of B: it does not depend on the entry in row and column ``along``."""
        rows = pencil(at.stiffness(), at.mass())
        B = cofactor(rows, along, along)
        rows[along][along] = Polynomial([0])
        return (resultant(trimmed(B), trimmed(determinant(rows))),)

    return Condition(equations)


def no_damping(along: int, on_fold: bool = False) -> Condition:
    """The damping of the coordinate ``along`` is 0, at a fold too: if nothing else damps, every pair of the state crosses."""
    return Condition(lambda at: (*(FOLD.equations(at) if on_fold else ()), at.damping()[along][along]))


def _too_flat(at: State) -> BoolArray:
    """Boxes where the slope is smaller all over than anything that floats tell from 0, and its sign unknown."""
    if at.balance.slope_is_a_sum:
        return np.zeros(at.shape, dtype=np.bool_)
    return stacked([at.slope()], at.shape)[0].magnitude <= FLAT


#: The slope of the friction law at steady sliding is 0: if nothing else damps, nothing damps there. A slope with a sign, however
#: small it is, has no root.
NO_SLOPE = Condition(
    lambda at: (at.slope(),), hopeless=lambda at: at.balance.slope_has_a_sign(at.values, at.shape), given_up=_too_flat
)
#: Kinds of points in the plane, as MatCont calls them, with what is asked of a state there.
KINDS = {"BT": bogdanov_takens, "ZH": zero_hopf, "HH": double_hopf}


def change(K: Matrix, column: int) -> Any:
    """Change of det K along a column of the adjugate, from entries that are jets in the coordinates first."""
    value = determinant(K)
    moved = [_slope(value, i) * cofactor(K, column, i) for i in range(len(K))]
    return sum(moved[1:], moved[0])


def _slope(value: Any, variable: int) -> Any:
    """The derivative of what may be a number."""
    return value.differentiated(variable) if isinstance(value, Jet) else 0
