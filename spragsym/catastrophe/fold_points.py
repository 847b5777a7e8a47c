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
from ..exact.adaptive_bits import as_floats, decided, with_enough_bits
from ..exact.intervals import Arithmetic, arithmetic
from ..exact.polynomials import Undecided
from ..parameters import NAMES, RANGES, FloatArray, Parameters
from . import fold_proofs


@dataclass(frozen=True)
class Folds(Result):
    """Points at which equilibria meet, sorted by the parameter that varies; one array for each parameter and coordinate.

    Arrays have the shape (points,); angles are radians, lengths over L_0.

    ``error`` bounds |error| / max(1, |value|) of all of them. ``kind`` says what happens as the parameter passes:

    - ``"fold"``: two equilibria appear or vanish together, the ordinary case;
    - ``"pitchfork"``: one becomes three, or three become one, all of them in one point (μ₀ = α = 0, a symmetric system);
    - ``"cusp"``: three meet in one point, and one is left on both sides;
    - ``"touch"``: two meet, and there are as many on both sides.

    All but the first need a coincidence of the parameters that are fixed.

    At a ``"fold"`` a stable state and a divergent one meet. ``ends`` says which stable state it is, the ``"lower"`` or the
    ``"upper"`` one in θ, ``when`` the parameter goes ``"up"`` or ``"down"``; ``theta_after``, ``L_after``, ``x_after`` and
    ``y_after`` are the equilibrium that is left there, to which it jumps. Empty, and NaN, for the other kinds.
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
    ends: NDArray[np.str_]
    when: NDArray[np.str_]
    theta_after: FloatArray
    L_after: FloatArray
    x_after: FloatArray
    y_after: FloatArray


@dataclass(frozen=True)
class Turn:
    """One row of :class:`Folds`, and what :mod:`spragsym.catastrophe.paths` has to know of it, proved.

    ``side`` is 1 where there are three equilibria above its value and one below, −1 for the reverse, 0 if their number stays;
    ``upper`` says that those that meet are the upper two of three in θ; ``rounded`` is −1 where the float of its value
    lies below the true one and 1 where it lies above: with all other parameters rational they are never equal (Lindemann).
    ``after`` is θ, L, x and y of the equilibrium that is left, NaN where there is none.
    """

    values: tuple[float, ...]
    kind: str
    side: int
    upper: bool
    rounded: int
    after: tuple[float, ...] = (math.nan,) * 4


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
    if negative_friction and vary != "mu0" and p.scalars("mu0") != (0.0,):
        reflected = p if vary == "theta0" else p.replace(theta0=math.pi - float(p.theta0))
        found += [_mirrored(turn, vary) for turn in turns(reflected, vary, arith=arith)]
    found.sort(key=lambda turn: turn.values[NAMES.index(vary)])
    columns: Any = np.array([turn.values for turn in found], dtype=float).reshape(-1, 11).T.copy()
    after: Any = np.array([turn.after for turn in found], dtype=float).reshape(-1, 4).T.copy()
    words = [(turn.kind, *_words(turn)) for turn in found]
    return Folds(vary, *columns, *np.array(words, dtype=np.str_).reshape(-1, 3).T.copy(), *after)


def _words(turn: Turn) -> tuple[str, str]:
    """Which state ends at a fold, and which way the parameter goes then."""
    if turn.kind != "fold":
        return "", ""
    return "upper" if turn.upper else "lower", "up" if turn.side < 0 else "down"


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
    values, after = fold.point.row(arith), [math.nan] * 4
    if fold.after:
        after, error = as_floats(arith, fold.after)
        values = (*values[:-1], max(values[-1], error))
    low, high = arith.ends(fold.point.parameters[place])
    rounded = 1 if high < values[place] else -1 if low > values[place] else 0
    if rounded == 0 or high - low > abs(low) / 10**25:
        raise Undecided("a fold and the float next to it")
    return Turn(values, fold.kind, fold.side, fold.upper, rounded, tuple(after))


def _mirrored(turn: Turn, vary: str) -> Turn:
    """A fold at μ₀ of the mirror image, reflected back to −μ₀."""
    theta0, mu0, kappa, alpha, sigma, beta, theta, L, x, y, error = turn.values
    values = (math.pi - theta0, -mu0, kappa, alpha, sigma, beta, math.pi - theta, L, -x, y, error)
    after = (math.pi - turn.after[0], turn.after[1], -turn.after[2], turn.after[3])
    side = -turn.side if vary == "theta0" else turn.side
    return Turn(values, turn.kind, side, not turn.upper, turn.rounded, after)
