"""All folds along one parameter, proved complete."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeVar

import numpy as np

from ...errors import ParameterError
from ...models.parameters import NAMES, RANGES, Parameters
from ...numerics import balls
from ...numerics.adaptive_bits import as_floats, decided, with_enough_bits
from ...numerics.balls import Undecided
from ...questions import NotInClosedForm
from ...results.points import Ended, Points, in_closed_form
from . import fold_proofs

PointsT = TypeVar("PointsT", bound=Points)

#: Names of what says where a state is.
STATE = ("theta", "L", "x", "y")


@dataclass(frozen=True)
class Turn:
    """One row of :func:`folds`, and what is proved of it.

    ``side`` is 1 where there are three equilibria above its value and one below, −1 for the reverse, 0 if their number stays;
    ``upper`` says that those that meet are the upper two of three in θ; ``after`` is θ, L, x and y of the equilibrium that is
    left, NaN where there is none.
    """

    values: tuple[float, ...]
    kind: str
    side: int
    upper: bool
    after: tuple[float, ...] = (math.nan,) * 4


def folds(
    p: Parameters,
    vary: str | None = None,
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
) -> Points:
    """The closed form of :func:`spragsym.folds`: proved complete, to 1e-12 and better.

    All kinds but ``"fold"`` need a coincidence of the parameters that are fixed: ``"pitchfork"`` μ₀ = α = 0.

    Notes
    -----
    Source: f = f′ = 0. Two relations, linear in every parameter but θ₀; the one that varies is eliminated, and what remains is a
    polynomial in tan(θ/2), whose real roots are isolated by Descartes' rule or, over intervals, by Sturm's theorem. A multiple
    root, which belongs to the other kinds, is found by exact algebra.
    """
    vary = vary or "theta0"
    if vary not in NAMES:
        raise NotInClosedForm
    found = turns(p, vary)
    columns: Any = np.array([turn.values for turn in found], dtype=float).reshape(-1, 11).T.copy()
    after: Any = np.array([turn.after for turn in found], dtype=float).reshape(-1, 4).T.copy()
    kind, ends, when = np.array([(turn.kind, *_words(turn)) for turn in found], dtype=np.str_).reshape(-1, 3).T.copy()
    values = dict(zip((*NAMES, *STATE, "error"), columns, strict=True))
    ended = Ended(ends, when, dict(zip(STATE, after, strict=True)))
    every = Points(**in_closed_form(p, (vary,), kind, values.pop("error"), values, ended))
    return in_ranges(every, between)


def in_ranges(found: PointsT, between: Mapping[str, tuple[float, float]] | None) -> PointsT:
    """Those in ranges of what varies, if there are any."""
    if between is None:
        return found
    from ...bifurcation.points import ranges  # which loads the search

    return found.between(ranges(found.parameters.model, found.vary, between))


def _words(turn: Turn) -> tuple[str, str]:
    """Which state ends at a fold, and which way the parameter goes then."""
    if turn.kind != "fold":
        return "", ""
    return "upper" if turn.upper else "lower", "up" if turn.side < 0 else "down"


def turns(p: Parameters, vary: str, *, negative_friction: bool = False) -> list[Turn]:
    """The rows of :func:`folds` along one parameter, sorted by it; along ``mu0`` those of a belt that runs back, too."""
    if vary not in NAMES:
        raise ParameterError(f"vary = {vary!r} is not a parameter; choose one of {', '.join(NAMES)}")
    fixed = [name for name in NAMES if name != vary]
    exact = dict(zip(fixed, map(Fraction, p.scalars(*fixed)), strict=True))
    allowed, place = RANGES[vary], NAMES.index(vary)

    def attempt(bits: int) -> list[Turn]:
        found = []
        for fold in fold_proofs.folds(vary, exact, bits):
            value = fold.point.parameters[place]
            wanted = decided(value, f"{vary} = 0 on a fold") > 0 or (negative_friction and vary == "mu0")
            turn = _turn(fold, place) if wanted else None
            if turn and turn.values[place] < allowed.high:
                found.append((balls.ends(value), turn))
        found.sort(key=lambda one: one[0][0])
        # No two folds share a value: f has at most three positive roots, too few for two double roots.
        if any(one[0][1] >= two[0][0] for one, two in itertools.pairwise(found)):
            raise Undecided("the order of two folds")
        return [turn for _, turn in found]

    return with_enough_bits(20, attempt, "folds")


def _turn(fold: fold_proofs.Fold, place: int) -> Turn:
    values, after = fold.point.row(), [math.nan] * 4
    if fold.after:
        after, error = as_floats(fold.after)
        values = (*values[:-1], max(values[-1], error))
    low, high = balls.ends(fold.point.parameters[place])
    if high - low > abs(low) / 10**25:
        raise Undecided("a fold to 25 digits")
    return Turn(values, fold.kind, fold.side, fold.upper, tuple(after))
