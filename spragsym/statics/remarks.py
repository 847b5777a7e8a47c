"""Reasons for undecided boxes, and for all that was not searched, in plain words."""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..numerics.interval_arrays import BoolArray, FloatArray, Intervals, stacked
from ..remarks import At, Remark
from .mechanics.balance import NOTHING, Balance

#: A box no wider than this, over the size of its coordinates, is one place to floats.
ONE_PLACE = 1e-9
#: A box no wider than this is around a place.
SMALL = 1e-3
#: A region this wide is no bound: it is what floats leave of none.
UNBOUNDED = 1e12

ANCHOR = "at the anchor of a spring, where its force has no value: an equilibrium may be nearer to it than floats tell"
POLE = "at an end of a spring that resists turning: its force has no bound there, and no search decides what is beside it"
BORDER = "where the contact just touches: whether what is there lies on this side of the border is not known"
PLACE = "no wider than one place is to floats: a double root may be there, two very near ones, or none"
LINE = "where the equations nearly hold: a line of roots, a degenerate one as of a pitchfork that changes its side, or none"
FREE = "along which no force acts on one of the coordinates at these parameters: a line of states, or none"
WIDE = "left from a search that ended before it was small enough to be decided: a smaller range or a smaller box helps"


def summed(kinds: Sequence[str]) -> tuple[str, ...]:
    """How many boxes are of each kind."""
    sentences = []
    for kind, number in Counter(kinds).items():
        some = f"{number} of {len(kinds)}" if number < len(kinds) else f"{number}"
        sentences.append(f"{some} undecided {'box' if len(kinds) == 1 else 'boxes'} {kind}")
    return tuple(sentences)


def kinds_of(balance: Balance, given: FloatArray, left: FloatArray, varied: Mapping[str, Any] | None = None) -> list[str]:
    """Kind of each box: where it is, and what is known of it.

    ``given`` are parameters, shape (parameters, boxes), ``left`` −low and high of the unknowns, shape (2, unknowns, boxes):
    coordinates, and behind them parameters that vary, which ``varied`` has by their names.
    """
    count, n = left.shape[2], balance.n
    if not count:
        return []
    with np.errstate(all="ignore"):
        q = list(Intervals(left[:, :n]))
        values = balance.over(Intervals.point(np.nan_to_num(given)), varied)
        pole, anchor = balance.at_poles(q, values, (count,), np.inf), np.zeros(count, dtype=np.bool_)
        for dx, dy in balance.anchors(q, values, (count,)):
            anchor |= dx.holds_zero() & dy.holds_zero()
        gap = stacked([balance.gap(q, values)], (count,))[0]
        border = gap.holds_zero() if balance.opens else np.zeros(count, dtype=np.bool_)
        relative = ((left[0] + left[1]) / np.maximum(1.0, np.abs(left).max(axis=0))).max(axis=0)
        free: BoolArray = np.zeros(count, dtype=np.bool_)
        if varied is None:
            forces = balance.residuals(Intervals(left), balance.prepared(Intervals.point(given)))
            free = np.logical_or.reduce(forces.magnitude <= NOTHING)
    pole, anchor, border = pole & ~free, anchor & ~free, border & ~free
    anchor &= ~pole & (relative <= SMALL)
    border &= ~(pole | anchor) & (relative <= SMALL)
    rest = ~(pole | anchor | border | free)
    return np.select(
        [free, pole, anchor, border, rest & (relative <= ONE_PLACE), rest & (relative <= SMALL)],
        [FREE, POLE, ANCHOR, BORDER, PLACE, LINE], WIDE,
    ).tolist()  # fmt: skip


def of_region(balance: Balance, region: FloatArray, whole: BoolArray) -> tuple[str, ...]:
    """Said where a region is not proved to hold all equilibria; ``region`` as −low and high, shape (2, n, points)."""
    if whole.all():
        return ()
    open_ = np.flatnonzero(~whole)
    hull = region[:, :, open_].max(axis=2)
    where = f" at {open_.size} of {whole.size} points" if whole.size > 1 else ""
    units = {entry["name"]: " rad" if entry["unit"] == "rad" else "" for entry in balance.model.about["coordinates"]}
    ends = zip(balance.coordinates, -hull[0], hull[1], strict=True)
    places = [
        At(name, (float(low), float(high)), unit=units[name]) if high - low < UNBOUNDED else Remark(f"any {name}")
        for name, low, high in ends
    ]
    within = ", ".join(["{}"] * len(places))
    return (Remark(f"searched within {within}{where}; there may be others beyond it", *places),)


def of_ranges(names: Sequence[str], ends: FloatArray) -> tuple[str, ...]:
    """Said of parameters whose range has no end and was cut; ends of shape (number, 2)."""
    return tuple(
        Remark("searched {}, a part of its range, which has no end; there may be others beyond it", At(name, (low, high)))
        for name, (low, high) in zip(names, ends.tolist(), strict=True)
    )
