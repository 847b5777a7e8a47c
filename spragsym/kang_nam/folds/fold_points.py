"""All folds along one parameter, proved complete."""

import itertools
import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any, TypeAlias, TypeVar

import numpy as np

from ...models.parameters import NAMES, RANGES, Parameters
from ...numerics import balls
from ...numerics.balls import Interval, Undecided, as_floats, decided, with_enough_bits
from ...questions import NotInClosedForm
from ...results.points import Ended, Points, in_closed_form
from . import fold_proofs

PointsT = TypeVar("PointsT", bound=Points)

#: Names of what says where a state is.
STATE = ("theta", "L", "x", "y")


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
    polynomial in tan(θ/2), whose real roots are isolated by Descartes' rule. A multiple root, which belongs to
    the other kinds, is found by exact algebra.
    """
    vary = vary or "theta0"
    if vary not in NAMES:
        raise NotInClosedForm
    found = _rows(p, vary)
    names = (*NAMES, *STATE, "error", *(f"{name}_after" for name in STATE))
    numbers: Any = np.array([each for each, _ in found], dtype=float).reshape(-1, len(names)).T.copy()
    kind, ends, when = np.array([words for _, words in found], dtype=np.str_).reshape(-1, 3).T.copy()
    values = dict(zip(names, numbers, strict=True))
    ended = Ended(ends, when, {name: values.pop(f"{name}_after") for name in STATE})
    every = Points(**in_closed_form(p, (vary,), kind, values.pop("error"), values, ended))
    return in_ranges(every, between)


def in_ranges(found: PointsT, between: Mapping[str, tuple[float, float]] | None) -> PointsT:
    """Points in the ranges of what varies, if ranges are given."""
    if between is None:
        return found
    from ...bifurcation.defining_systems import ranges

    return found.between(ranges(found.parameters.model, found.vary, between))


#: All numbers of a fold, its kind, which state ends there and which way the parameter goes then.
Row: TypeAlias = tuple[tuple[float, ...], tuple[str, str, str]]


def _rows(p: Parameters, vary: str) -> list[Row]:
    """Numbers of parameters, the state, its error, and the state that is left, NaN where there is none; sorted by ``vary``."""
    fixed = [name for name in NAMES if name != vary]
    exact = dict(zip(fixed, map(Fraction, p.scalars(*fixed)), strict=True))
    allowed, place = RANGES[vary], NAMES.index(vary)

    def attempt(bits: int) -> list[Row]:
        found = []
        for fold in fold_proofs.folds(vary, exact, bits):
            value = fold.point.parameters[place]
            row = _row(fold, value) if decided(value, f"{vary} = 0 on a fold") > 0 else None
            if row and row[0][place] < allowed.high:
                found.append((balls.ends(value), row))
        found.sort(key=lambda one: one[0][0])
        # No two folds share a value: f has at most three positive roots, too few for two double roots.
        if any(one[0][1] >= two[0][0] for one, two in itertools.pairwise(found)):
            raise Undecided("the order of two folds")
        return [row for _, row in found]

    return with_enough_bits(20, attempt, "folds")


def _row(fold: fold_proofs.Fold, value: Interval) -> Row:
    *numbers, error = fold.point.row()
    after, off = as_floats(fold.after) if fold.after else ([math.nan] * 4, 0.0)
    low, high = balls.ends(value)
    if high - low > abs(low) / 10**25:
        raise Undecided("a fold to 25 digits")
    words = ("upper" if fold.upper else "lower", "up" if fold.side < 0 else "down") if fold.kind == "fold" else ("", "")
    return (*numbers, max(error, off), *after), (fold.kind, *words)
