"""Onsets of flutter of a model along one parameter, proved: with dampers and the slope of the friction law, or without."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from itertools import chain
from typing import TypeAlias

import numpy as np

from ..models.parameters import ParameterSet
from ..numerics.certified_roots import concatenated
from ..numerics.interval_arrays import ComplexArray, FloatArray, Intervals
from ..questions import Method, question
from ..remarks import At, Remark
from ..results.points import Points
from ..statics import stability
from ..statics.damping import damped_by_friction_alone, is_conservative, is_damped, only_damped, slope_over
from ..statics.mechanics.balance import NOTHING
from .bifurcation_conditions import FLAT, FLUTTER, HOPF, NO_SLOPE, no_damping, undamped_mode
from .defining_systems import Augmented, Condition
from .families import Family
from .onsets import Onsets, onsets_of
from .points import Found, arranged, matrices, nothing, search
from .seen import VALUES, with_seen

#: ω of the points of a search that M, C and K are taken at.
Frequencies: TypeAlias = Callable[[FloatArray, FloatArray, FloatArray], list[float]]
#: Points of one search, their kinds and their ω.
_Part: TypeAlias = tuple[Found, list[str], list[float]]


@question
def flutter_onsets(
    p: ParameterSet,
    vary: str | None = None,
    *,
    damping: bool | None = None,
    between: Mapping[str, tuple[float, float]] | None = None,
    within: Mapping[str, tuple[float, float]] | None = None,
    method: Method = "auto",
) -> Onsets:
    """Onsets of flutter in contact along one parameter, the others fixed; ``complete`` says whether these are all.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the one that varies is not used.
    vary : str, optional
        A parameter; without it ``theta0``, or the model's first one.
    damping : bool, optional
        True for Hopf points of the full linearization, det(λ² M + λ C + K) = 0 with dampers and slope of the friction law; False
        for (27), without C, as the article's flutter. Without it True, unless C is 0.
    between, within, method
        As for :func:`spragsym.folds`; a closed form is there for (27) along θ₀.

    Returns
    -------
    Onsets
        Of the kind ``"hopf"``, where a pair ± i ω crosses the imaginary axis, or ``"flutter"``, where two frequencies meet;
        or ``"detected"``: floats see a pair cross there, where the search was not complete, and no proof succeeds;
        ``omega`` is the frequency, ``criticality`` whether it is super- or subcritical. Where all damping changes its sign
        at once, by a falling friction law against a damper, every pair of a state crosses, and each has a row. Closed forms add
        ``branch``, which counts the equilibria from below in θ, from 0, ``count``, how many there are, and ``side``: 1 where
        the state flutters at slightly larger θ₀, −1 where it does at slightly smaller θ₀, 0 where the boundary is only touched.

    Raises
    ------
    ParameterError
        For a parameter that is missing or an array.
    ConvergenceError
        At parameters of the article's model so degenerate that onsets can't be told apart.

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant of order 2 n − 1, or the discriminant of det(K − κ M) in κ. Where one coordinate
    only is damped, that entry of C is a factor of Hurwitz's determinant and taken out: what is left, and the entry, or the
    slope of the friction law where it is that, are searched for on their own. An end of the range at which C vanishes is no
    onset. Points where a real pair ± λ has the sum 0, or two real λ meet, are roots as well and left out.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> found = ss.flutter_onsets(ss.Parameters.article(alpha=0.7), damping=False)
    >>> print(np.degrees(found.theta0).round(6), found.side)
    [135.389588 166.068824] [ 1 -1]
    >>> onsets = ss.flutter_onsets(ss.load("stick_slip").Parameters(), vary="V")
    >>> onsets.V.round(4).tolist(), onsets.criticality.tolist()
    ([0.101, 1.4035], ['gentle', 'dangerous'])
    """
    family = Family.of(p, (p.model.one(vary),), between, within)
    balance, over = family.balance, family.over
    along = damped_by_friction_alone(balance, over)
    slope = None if along is None else slope_over(balance, over)
    only = only_damped(balance, over) if along is None else along
    if damping is None:
        damping = is_damped(balance, over) if slope is None else bool(slope.magnitude.max() > NOTHING)

    conservative = is_conservative(balance, over)
    sought: list[tuple[Condition | None, str, Frequencies]]
    if not damping:
        # Where K is symmetric all κ are real and stay so as K changes: where two meet they pass each other.
        sought = [(None if conservative else FLUTTER, "flutter", meeting)]
    elif only is None or balance.n == 1:
        sought = [(HOPF, "hopf", _crossing)]
    else:
        # Where K is symmetric damping takes energy from all modes, or gives to all: no pair crosses.
        sought = [] if conservative else [(undamped_mode(only), "hopf", partial(_without, only))]
        if slope is None:
            sought.append((no_damping(only), "hopf", _every))
        elif conservative or slope.holds_zero().any():
            sought.append((NO_SLOPE, "hopf", _every))
    parts, seen = list[_Part](), list[_Part]()
    for condition, kind, frequencies in sought:
        out = nothing(family) if condition is None else search(family, condition)
        if condition is not None and out.roots.left.shape[2]:
            out, more, omega = with_seen(Augmented(family, condition), out)
            followed = np.isfinite(omega)
            alone, others = (replace(out, roots=more.kept(some)) for some in (followed, ~followed))
            seen.append((alone, ["detected"] * int(followed.sum()), omega[followed].tolist()))
            seen.append(_part(family, others, "detected", frequencies))
        parts.append(_part(family, out, kind, frequencies))
    parts[1:1] = seen
    return onsets_of(_joined(family, parts, flat=sought[-1][0] is NO_SLOPE))


# ------------------------------------------------------------------------------------------------------- frequencies


def _part(family: Family, found: Found, kind: str, frequencies: Frequencies) -> _Part:
    """A row for each frequency that a root has; none for roots whose λ are real."""
    rows, omega = list[int](), list[float]()
    for row, each in enumerate(zip(*matrices(family, found.roots.middle), strict=True)):
        some = frequencies(*each)
        omega += some
        rows += [row] * len(some)
    return replace(found, roots=found.roots.kept(np.array(rows, dtype=np.int64))), [kind] * len(rows), omega


def _crossing(M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of the two roots λ of det(λ² M + λ C + K) whose sum is the nearest to 0, unless they are real."""
    omega = stability.frequency(stability.roots(M, C, K))
    return [omega] if omega else []


def _squares(M: FloatArray, K: FloatArray) -> ComplexArray:
    """The roots κ of det(K − κ M)."""
    return np.linalg.eigvals(np.linalg.solve(M, K)).astype(complex)


def meeting(M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of the two roots κ of det(K − κ M) that are the nearest to each other, unless they are negative."""
    squares = _squares(M, K)
    if squares.size < 2:
        return []
    apart = np.abs(squares[:, None] - squares[None]) + np.where(np.eye(squares.size), np.inf, 0.0)
    one = squares[np.unravel_index(apart.argmin(), apart.shape)[0]]
    return [float(np.sqrt(one.real))] if one.real > 0 else []


def _without(along: int, M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of a mode in which the coordinate ``along`` does not move: the root of its minor that is the nearest to one of all."""
    others = [i for i in range(len(K)) if i != along]
    squares = _squares(M[np.ix_(others, others)], K[np.ix_(others, others)])
    one = squares[np.abs(squares[:, None] - _squares(M, K)[None]).min(axis=1).argmin()]
    return [float(np.sqrt(one.real))] if one.real > 0 else []


def _every(M: FloatArray, C: FloatArray, K: FloatArray) -> list[float]:
    """ω of all modes that oscillate."""
    squares = _squares(M, K)
    scale = 1e-12 * np.abs(squares).max()
    return sorted(float(np.sqrt(one.real)) for one in squares if one.real > 0 and abs(one.imag) <= scale)


def _joined(family: Family, parts: list[_Part], flat: bool) -> Points:
    """All parts in one result; ``flat`` where the last is of places without slope."""
    found, kinds, frequencies = zip(*parts, strict=True)
    kind, omega = np.array([*chain(*kinds)], dtype=np.str_), np.array([*chain(*frequencies)])
    every = concatenated([one.roots for one in found], family.balance.n + 1)
    remarks = _undamped(family, found[-1].roots.left) if flat else ()
    remarks += _at_ends(family, found[0].region[:, -1, 0], every.left)
    if detected := int((kind == "detected").sum()):
        remarks += (f"{detected} onsets are numerically detected between two of {VALUES} values, and not proved",)
    elif every.left.shape[2] and not flat:
        remarks += (f"floats see no other onset between two of {VALUES} values of {family.vary[0]}",)
    region = np.minimum.reduce([one.region for one in found])
    whole = np.logical_and.reduce([one.whole for one in found])
    return arranged(family, Found(every, region, whole), kind, {"omega": omega}, remarks)


def _at_ends(family: Family, span: FloatArray, left: FloatArray) -> tuple[str, ...]:
    """Remarks on undecided boxes at an end of the range."""
    remarks = []
    for end in (-span[0], span[1]) if left.shape[2] else ():
        here = int(((-left[0, -1] <= end) & (end <= left[1, -1])).sum())
        why = ""
        if is_conservative(family.balance, Intervals.point(family.at(np.array([[end]])))):
            why = ": K is symmetric there, so that no pair crosses, but whether one does beside it is not known"
        text = f"{here} of {left.shape[2]} undecided boxes hold the end {{}} of the range{why}"
        remarks += [Remark(text, At(family.vary[0], (float(end),), "g"))] if here else []
    return tuple(remarks)


def _undamped(family: Family, left: FloatArray) -> tuple[str, ...]:
    """Remarks on undecided boxes where the friction law has practically no slope."""
    balance = family.balance
    if balance.model.about["friction"] is None or not left.shape[2]:
        return ()
    over = Intervals.between(family.at(-left[0, -1:]), family.at(left[1, -1:]))
    size = slope_over(balance, over).magnitude
    flat = size <= FLAT
    most = f"{size[flat].max(initial=0.0):.0e}"
    text = f"the slope of the friction law, and with it its damping, is at most {most}: too little for floats"
    return (f"in {int(flat.sum())} of {flat.size} undecided boxes {text}",) if flat.any() else ()
