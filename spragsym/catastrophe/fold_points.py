"""All folds along one parameter, proved complete."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..errors import ParameterError
from ..exact.escalation import decided, with_enough_bits
from ..exact.intervals import Arithmetic, arithmetic
from ..exact.polynomials import Undecided
from ..parameters import NAMES, RANGES, FloatArray, Parameters
from . import fold_proofs


@dataclass(frozen=True)
class Folds(Result):
    """Points at which equilibria meet, sorted by the parameter that varies; one array for each parameter and coordinate.

    ``error`` bounds |error| / max(1, |value|) of all of them. ``kind`` says what happens as the parameter passes:

    - ``"fold"``: two equilibria appear or vanish together, the ordinary case;
    - ``"pitchfork"``: one becomes three, or three become one, all of them in one point (μ₀ = α = 0, a symmetric system);
    - ``"cusp"``: three meet in one point, and one is left on both sides;
    - ``"touch"``: two meet, and there are as many on both sides.

    All but the first need a coincidence of the parameters that are fixed.
    """

    vary: str
    theta0: FloatArray
    mu0: FloatArray
    kappa: FloatArray
    alpha: FloatArray
    sigma: FloatArray
    beta: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    error: FloatArray
    kind: NDArray[np.str_]


@dataclass(frozen=True)
class Turn:
    """One row of :class:`Folds`, and what :mod:`spragsym.catastrophe.paths` has to know of it, proved.

    ``side`` is 1 where there are three equilibria above its value and one below, −1 for the reverse, 0 if their number stays;
    ``upper`` says that those that meet are the upper two of three in θ; ``rounded`` is −1 where the float of its value
    lies below the true one and 1 where it lies above: with all other parameters rational they are never equal (Lindemann).
    """

    values: tuple[float, ...]
    kind: str
    side: int
    upper: bool
    rounded: int


def folds(p: Parameters, vary: str = "theta0", *, negative_friction: bool = False, arith: Arithmetic | None = None) -> Folds:
    """All folds in contact along one parameter, the others fixed: proved complete, to 1e-12 and better.

    Parameters
    ----------
    p : Parameters
        Scalars. The one that varies is not used, and may be left out if it is ``theta0`` or ``mu0``.
    vary : str
        ``"theta0"``, ``"mu0"``, ``"kappa"``, ``"alpha"``, ``"sigma"`` or ``"beta"``.
    negative_friction : bool
        Also list folds with μ₀ < 0: mirror images, for a belt that runs the other way.

    Returns
    -------
    Folds
        Those with L > 0, y < 0 and the varying parameter in its range.

    Raises
    ------
    ParameterError
        For a ``vary`` that is not a parameter, or a parameter that is missing or an array.
    ConvergenceError
        At parameters so close to a coincidence that 6144 bits do not tell it from one.

    Notes
    -----
    Source: f = f′ = 0. Two relations, linear in every parameter but θ₀; the one that varies is eliminated, and what remains is a
    polynomial in tan(θ/2), whose real roots are isolated by Descartes' rule or, over intervals, by Sturm's theorem. A multiple
    root, which belongs to the other kinds, is found by exact algebra.

    Examples
    --------
    >>> import numpy as np
    >>> found = folds(Parameters.article())
    >>> print(np.degrees(found.theta0))
    [ 44.5593177  155.05941879]
    >>> print(folds(Parameters.article(mu0=0.0, alpha=0.0)).kind)
    ['pitchfork' 'pitchfork']
    """
    found = turns(p, vary, negative_friction=negative_friction, arith=arith)
    rows, kinds = [turn.values for turn in found], [turn.kind for turn in found]
    if negative_friction and vary != "mu0" and p.scalars("mu0") != (0.0,):
        mirrored = _mirrored_folds(p, vary, arith)
        rows, kinds = rows + mirrored[0], kinds + mirrored[1]
    order = sorted(range(len(rows)), key=lambda i: rows[i][NAMES.index(vary)])
    columns: Any = np.array([rows[i] for i in order], dtype=float).reshape(-1, 11).T.copy()
    return Folds(vary, *(*columns, np.array([kinds[i] for i in order], dtype=np.str_)))


def turns(p: Parameters, vary: str, *, negative_friction: bool = False, arith: Arithmetic | None = None) -> list[Turn]:
    """The rows of :func:`folds` along one parameter, sorted by it; ``negative_friction`` matters for ``mu0`` only."""
    if vary not in NAMES:
        raise ParameterError(f"vary = {vary!r} is not a parameter; choose one of {', '.join(NAMES)}")
    fixed = [name for name in NAMES if name != vary]
    exact = dict(zip(fixed, map(Fraction, p.scalars(*fixed)), strict=True))
    chosen = arith or arithmetic()
    allowed, place = RANGES[vary], NAMES.index(vary)

    def attempt(bits: int) -> list[Turn]:
        found = []
        for fold in fold_proofs.folds(chosen, vary, exact, bits):
            value = fold.point.parameters[place]
            wanted = decided(chosen, value, f"{vary} = 0 on a fold") > 0 or (negative_friction and vary == "mu0")
            turn = _turn(chosen, fold, place) if wanted else None
            if turn and turn.values[place] < allowed.high:
                found.append((chosen.ends(value), turn))
        found.sort(key=lambda one: one[0][0])
        # No two folds share a value: f has at most three positive roots, too few for two double roots.
        if any(one[0][1] >= two[0][0] for one, two in itertools.pairwise(found)):
            raise Undecided("the order of two folds")
        return [turn for _, turn in found]

    return with_enough_bits(chosen, 20, attempt, "folds")


def _turn(arith: Arithmetic, fold: fold_proofs.Fold, place: int) -> Turn:
    values = fold.point.row(arith)
    low, high = arith.ends(fold.point.parameters[place])
    rounded = 1 if high < values[place] else -1 if low > values[place] else 0
    if rounded == 0 or high - low > abs(low) / 10**25:
        raise Undecided("a fold and the float next to it")
    return Turn(values, fold.kind, fold.side, fold.upper, rounded)


def _mirrored_folds(p: Parameters, vary: str, arith: Arithmetic | None) -> tuple[list[tuple[float, ...]], list[str]]:
    """Folds at −μ₀: those at μ₀ of the mirror image, reflected back; and their kinds."""
    reflected = p if vary == "theta0" else p.replace(theta0=math.pi - float(p.theta0))
    found = folds(reflected, vary, arith=arith)
    columns = (
        math.pi - found.theta0, -found.mu0, found.kappa, found.alpha, found.sigma, found.beta,
        math.pi - found.theta, found.L, -found.x, found.y, found.error,
    )  # fmt: skip
    return [tuple(map(float, row)) for row in zip(*columns, strict=True)], found.kind.tolist()
