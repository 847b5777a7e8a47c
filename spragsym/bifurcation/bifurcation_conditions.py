"""Bifurcation conditions beside the balance: of folds, of cusps, and of the two kinds of onset of flutter."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..numerics.determinants import Polynomial, cofactor, determinant, hurwitz, of_pencil, resultant, trimmed
from ..numerics.interval_arrays import stacked
from ..numerics.jets import Jet
from .defining_systems import State

#: A slope of the friction law that is as good as 0.
FLAT = 1e-100


class Plain:
    """A condition without inequalities, of which halving tells more."""

    #: Whether det K = 0 is one of its equations.
    singular = False
    #: Whether one is that the gap is 0.
    touching = False

    def given_up(self, at: State) -> NDArray[np.bool_] | None:
        """No box."""
        return None

    def hopeless(self, at: State) -> NDArray[np.bool_]:
        """No box."""
        return np.zeros(at.shape, dtype=np.bool_)


class Fold(Plain):
    """det K = 0."""

    order = 0
    singular = True

    def equations(self, at: State) -> Sequence[Any]:
        """The determinant."""
        return (determinant(at.slopes()),)


class Touch(Plain):
    """The gap of the contact is 0."""

    order = 0
    touching = True

    def equations(self, at: State) -> Sequence[Any]:
        """The gap."""
        return (at.gap(),)


class Cusp(Plain):
    """det K = 0, and K v = 0 for a direction v along which det K does not change.

    Where K has rank n − 1 the columns of its adjugate that are not 0 are multiples of v. One of them is taken: points where that
    one is 0 are roots as well, which :func:`spragsym.bifurcation.cusp_search.told_apart` tells from cusps.
    """

    order = 1
    singular = True

    def __init__(self, column: int = 0) -> None:
        self.column = column

    def equations(self, at: State) -> Sequence[Any]:
        """The determinant, and its change along the column."""
        K = at.slopes()
        return determinant(K), change(K, self.column)


class Turn(Plain):
    """det K = 0, and the curve of folds turns back in the second parameter: w · ∂F/∂v = 0 for the first one, v, with w K = 0.

    A row of the adjugate stands for w: points where that row is 0 are roots as well.
    """

    order = 1
    singular = True

    def equations(self, at: State) -> Sequence[Any]:
        """The determinant, and the force along w that the first parameter brings."""
        K, rows = at.slopes(), at.forces()
        total: Any = 0
        for i in range(len(K)):
            total = total + _slope(rows[i], len(K)) * cofactor(K, i, 0)
        return determinant(K), total


class FoldOnBorder(Plain):
    """det K = 0 and the gap of the contact is 0: a curve of folds leaves the contact."""

    order = 0
    touching = True
    singular = True

    def equations(self, at: State) -> Sequence[Any]:
        """The determinant and the gap."""
        return determinant(at.slopes()), at.gap()


class TouchTurn(Plain):
    """The gap is 0, and the curve on which it is turns back in the second parameter."""

    order = 1
    touching = True

    def equations(self, at: State) -> Sequence[Any]:
        """The gap, and the determinant of the slopes of forces and gap by the coordinates and the first parameter."""
        gap = at.gap()
        rows, n = [*at.forces(), gap], len(at.q)
        return gap, determinant([[_slope(row, k) for k in range(n + 1)] for row in rows])


class Flutter(Plain):
    """Two roots κ = −λ² of det(K − κ M) meet: the discriminant of that polynomial is 0."""

    order = 0

    def equations(self, at: State) -> Sequence[Any]:
        """The discriminant, but for a factor."""
        K, M = at.stiffness(), at.mass()
        n = len(K)
        coefficients = determinant([[Polynomial([K[i][j], -M[i][j]]) for j in range(n)] for i in range(n)]).padded(n + 1)
        if n == 2:
            c, b, a = coefficients
            return (b * b - 4 * a * c,)
        return (resultant(coefficients, [k * coefficients[k] for k in range(1, n + 1)]),)


class Hopf(Plain):
    """Two roots λ of det(λ² M + λ C + K) have the sum 0: the last but one of Hurwitz's determinants is 0."""

    order = 0

    def equations(self, at: State) -> Sequence[Any]:
        """The determinant."""
        return (hurwitz(characteristic(at)),)


class Damped(Plain):
    """A condition on the coefficients of det(λ² M + λ C + K).

    Where C has one entry c, of the coordinate ``along``, the odd ones are c times what they are for c = 1, and the even ones do
    not depend on it. Then 1 stands for c: else all holds where c is 0.
    """

    order = 0

    def __init__(self, along: int | None = None) -> None:
        self.along = along

    def coefficients(self, at: State) -> list[Any]:
        """Of λ, the lowest first."""
        if self.along is None:
            return characteristic(at)
        K = at.stiffness()
        places = range(len(K))
        return of_pencil(at.mass(), [[int(i == j == self.along) for j in places] for i in places], K)

    def equations(self, at: State) -> Sequence[Any]:
        """The values that must vanish, which each such condition has."""
        raise NotImplementedError


class BogdanovTakens(Damped):
    """Two roots λ are 0: the two lowest coefficients are."""

    def equations(self, at: State) -> Sequence[Any]:
        """The coefficients."""
        return tuple(self.coefficients(at)[:2])


class ZeroHopf(Damped):
    """One root λ is 0, and two others have the sum 0."""

    def equations(self, at: State) -> Sequence[Any]:
        """The lowest coefficient, and Hurwitz's determinant of the others."""
        a = self.coefficients(at)
        return a[0], hurwitz(a[1:])


class DoubleHopf(Damped):
    """All four roots λ of two coordinates come in pairs with the sum 0: the odd coefficients are 0."""

    def equations(self, at: State) -> Sequence[Any]:
        """The coefficients."""
        a = self.coefficients(at)
        return a[1], a[3]


class UndampedMode(Plain):
    """As :class:`Hopf`, where only the coordinate ``along`` is damped, by whatever it may be: a mode in which it does not move.

    Then det(λ² M + λ C + K) = A(λ²) + λ c B(λ²) with the only entry c of C, and B a minor of K + λ² M. A pair ± i ω is where A
    and B have a common root, however small c is; it is divided out.
    """

    order = 0

    def __init__(self, along: int) -> None:
        self.along = along

    def equations(self, at: State) -> Sequence[Any]:
        """The resultant of B and A, less a multiple of B: it does not depend on the entry in row and column ``along``."""
        K, M = at.stiffness(), at.mass()
        n = len(K)
        rows = [[Polynomial([K[i][j], M[i][j]]) for j in range(n)] for i in range(n)]
        B = cofactor(rows, self.along, self.along)
        rows[self.along][self.along] = Polynomial([0])
        return (resultant(trimmed(B), trimmed(determinant(rows))),)


class NoDamping(Plain):
    """The damping of the coordinate ``along`` is 0: if nothing else damps, every pair of the state crosses there."""

    order = 0

    def __init__(self, along: int) -> None:
        self.along = along

    def equations(self, at: State) -> Sequence[Any]:
        """The entry of C."""
        return (at.damping()[self.along][self.along],)


class FoldWithoutDamping(NoDamping):
    """That at a fold."""

    def equations(self, at: State) -> Sequence[Any]:
        """The determinant, and the entry of C."""
        return (determinant(at.slopes()), *super().equations(at))


class NoSlope(Plain):
    """The slope of the friction law at steady sliding is 0: if nothing else damps, nothing damps there."""

    order = 0

    def equations(self, at: State) -> Sequence[Any]:
        """The slope."""
        return (at.slope(),)

    def hopeless(self, at: State) -> NDArray[np.bool_]:
        """Boxes where the slope has a sign, however small it is."""
        return at.balance.slope_has_a_sign(at.values, at.shape)

    def given_up(self, at: State) -> NDArray[np.bool_]:
        """Boxes where the slope is smaller all over than anything that floats tell from 0, and its sign unknown."""
        if at.balance.slope_is_a_sum:
            return np.zeros(at.shape, dtype=np.bool_)
        out: NDArray[np.bool_] = stacked([at.slope()], at.shape)[0].magnitude <= FLAT
        return out


def characteristic(at: State) -> list[Any]:
    """Coefficients of det(λ² M + λ C + K), the lowest first."""
    return of_pencil(at.mass(), at.damping(), at.stiffness())


def change(K: Sequence[Sequence[Any]], column: int) -> Any:
    """Change of det K along a column of the adjugate, from entries that are jets in the coordinates first."""
    value = determinant(K)
    total: Any = 0
    for i in range(len(K)):
        total = total + _slope(value, i) * cofactor(K, column, i)
    return total


def _slope(value: Any, variable: int) -> Any:
    """The derivative of what may be a number."""
    return value.differentiated(variable) if isinstance(value, Jet) else 0
