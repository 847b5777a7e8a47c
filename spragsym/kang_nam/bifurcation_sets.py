"""All curves of folds in the plane of θ₀ and μ₀, with the cusps on them.

At a direction θ, friction is eliminated from the conditions of a fold, or of an onset of flutter.
The positive roots of the remaining polynomial in tan(θ₀/2) are all points of the curves at that θ.
Between neighbouring directions with the same number of roots the k-th root continues the k-th one.
Where the number changes, or a root enters at θ₀ = 0 or π, the interval of θ is bisected to
rounding. Directions are given by t = tan(θ/2), which has full precision at both ends.

The events at which the number of folds changes, or the friction of one is 0, are roots of
polynomials in sin θ (derived: ``fold_events``), hence in t. They are isolated exactly in 0 < θ <
π/2 by Descartes' rule. Between two events the number is counted exactly at one rational t.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np

from ..bifurcation.defining_systems import ranges
from ..core.errors import ConvergenceError
from ..core.questions import NotInClosedForm
from ..generated import catastrophe as _catastrophe
from ..models.parameters import FloatArray, Ranges, as_count
from ..numerics import polynomials
from ..numerics.arithmetic import Number
from ..numerics.chains import link, walked
from ..numerics.columns import ByColumn, selected_rows
from ..numerics.interval_arrays import BoolArray, IntArray, quiet
from ..numerics.polynomials import (
    IsolatedRoot,
    Polynomial,
    by_power,
    eigenvalues,
    evaluate,
    of_sine_in_t,
    on_circle,
    polished,
    real_roots,
)
from ..results import BifurcationSet, Curve, Points
from . import kernel
from .cusps import cusps
from .folds import folds
from .kernel import Fixed
from .parameters import Parameters


def bifurcation_set(
    p: Parameters,
    vary: Sequence[str] | None = None,
    n: int | None = None,
    *,
    between: Ranges | None = None,
) -> BifurcationSet:
    """The closed form of :func:`spragsym.bifurcation_set` in (θ₀, μ₀) for 0 < θ₀ < π and μ₀ ≥ 0.

    Notes
    -----
    Source: f = f′ = 0, two lines in μ₀ at a given direction θ; without it a conic in (cos θ₀, sin
    θ₀). Where curves begin, end, turn back in θ and reach μ₀ = 0 is isolated exactly, and how many
    folds there are in between is counted exactly, so that none is missed that holds a float; their
    points are float64, and satisfy the condition to rounding.
    """
    if vary is not None and tuple(vary) != ("theta0", "mu0"):
        raise NotInClosedForm
    between = between or {}
    ranges(p, ("theta0", "mu0"), between)  # an error where they make no sense
    fewest = 2000  # directions
    n = max(fewest, as_count("n", fewest if n is None else n, 2))
    fixed = Fixed(*p.scalars(*Fixed._fields))
    preload = fixed.kappa / max(fixed.sigma, 1 + fixed.beta)
    if preload < 1e-8:  # float64 loses curves
        raise _indistinct(fixed.kappa, "they all but coincide")
    cusp_points = cusps(p)
    ahead = (cusp_points.theta0 > 0) & (cusp_points.theta0 < math.pi) & (cusp_points.mu0 >= 0)
    cusp_points = cusp_points.select(ahead)
    fold_curves, start_directions = [], directions(fixed)
    exact_directions = np.concatenate([cusp_points.theta, *_on_borders(p, between)])
    far = 17.0  # logarithm of the largest t
    t = np.concatenate(
        [
            np.exp(np.linspace(-far, far, n // 4)),
            start_directions.t,
            np.abs(np.tan(exact_directions / 2)),
        ]
    )
    for points in curves(
        CurveCondition(fold_polynomial, _friction, start_directions.folds_at), fixed, t, 3 / n
    ):
        curve = _curve(points, fixed)
        # Equilibria never cross y = 0 for 0 < θ₀ < π (derive/kang_nam/theorem.py): one point
        # decides for the whole curve.
        if curve.y[len(curve) // 2] < 0:
            fold_curves.append(curve)
    if preload < 1e-4:  # float64 may lose curves
        _compare(fold_curves, p)
    cusp_points = cusp_points.select(_within(between, cusp_points))
    return BifurcationSet(("theta0", "mu0"), tuple(_cut(fold_curves, between)), cusp_points, True)


def _on_borders(p: Parameters, between: Ranges) -> Iterator[FloatArray]:
    """θ of all folds at the ends of the ranges, proved."""
    for name, ends in between.items():
        other = "mu0" if name == "theta0" else "theta0"
        for end in ends:
            if Parameters.ranges[name].low < end < Parameters.ranges[name].high:
                yield folds(p.replace(**{name: end}), other).theta


def _within(between: Ranges, found: Curve | Points) -> BoolArray:
    """A mask of the points within ranges."""
    inside = np.ones(len(found), dtype=bool)
    on_border = 1e-11  # by which rounding may move a fold beyond the end of a range
    for name, (low, high) in between.items():
        column = getattr(found, name)
        inside &= (low - on_border <= column) & (column <= high + on_border)
    return inside


def _cut(curves: Sequence[Curve], between: Ranges) -> Iterator[Curve]:
    """The parts of the curves within ranges."""
    for curve in curves:
        inside = _within(between, curve)
        for begin, end in np.flatnonzero(np.diff(inside, prepend=False, append=False)).reshape(
            -1, 2
        ):
            part = selected_rows(curve.values, slice(begin, end))
            yield Curve(part | {name: np.clip(part[name], *ends) for name, ends in between.items()})


def _friction(c: FloatArray, s: FloatArray, theta0: FloatArray, fixed: Fixed) -> FloatArray:
    """The friction of folds, from the better conditioned of two relations: the first has the factor
    cos θ.
    """
    u1, w1, u2, w2 = _catastrophe.fold_lines_mu0(c, s, *kernel.cos_sin(theta0), *fixed)
    return np.where(np.abs(c) > 0.3, -u1 / w1, -u2 / w2)


def _compare(curves: list[Curve], p: Parameters) -> None:
    """Raise unless the curves cross some frictions as often as there are proved folds."""
    for mu0 in (0.11, 1.3, 7.1):
        crossings = sum(int(np.count_nonzero(np.diff(curve.mu0 > mu0))) for curve in curves)
        proved = folds(p.replace(mu0=mu0)).theta0.size
        if crossings != proved:
            raise _indistinct(
                float(p.kappa), f"at mu0 = {mu0} they have {crossings} where {proved} are proved"
            )


def _indistinct(kappa: float, reason: str) -> ConvergenceError:
    return ConvergenceError(
        f"kappa = {kappa:g} is too small beside sigma and 1 + beta for curves of folds in "
        f"float64: {reason}; "
        "folds(p) proves those at one friction"
    )


def _curve(points: FloatArray, fixed: Fixed) -> Curve:
    """A curve of folds, with the state that ends at each and the state that is jumped to."""
    t, theta0, mu0 = points
    c, s, _ = on_circle(t)
    c0, s0 = kernel.cos_sin(theta0)
    with quiet():  # at the ends of a curve θ₀ may be 0 or π
        trig = kernel.f_coefficients(c0, s0, mu0, *fixed, 1)
        curvature = np.sign(kernel.f_curvature(c, s, *trig))
        changes = _catastrophe.unfolding(c, s, c0, s0, mu0, *fixed)
        after = on_circle(kernel.landing(t, trig, np.sqrt))
        (_, x, y), (_, x_after, y_after) = (
            kernel.state_of(*at[:2], c0, s0, *fixed) for at in ((c, s), after)
        )
    by_angle, by_friction = (
        (curvature * np.sign(change[0])).astype(np.int8) for change in changes[:2]
    )
    return Curve(
        {
            "theta0": theta0,
            "mu0": mu0,
            "theta": 2 * np.arctan(t),
            "x": x,
            "y": y,
            "upper": curvature > 0,
            "when_theta0": by_angle,
            "when_mu0": by_friction,
            "theta_after": np.arctan2(after.sine, after.cosine),
            "x_after": x_after,
            "y_after": y_after,
        }
    )


class CurveCondition(NamedTuple):
    """The condition on a curve: ``polynomial`` gives its coefficients in tan(θ₀/2), lowest power
    first, at (cos θ, sin θ), and ``friction`` the friction at θ₀.

    ``number`` gives the number of positive roots at tan(θ/2); without it the roots that are real to
    rounding are counted.
    """

    polynomial: Callable[[FloatArray, FloatArray, Fixed], tuple[FloatArray, ...]]
    friction: Callable[[FloatArray, FloatArray, FloatArray, Fixed], FloatArray]
    number: Callable[[FloatArray], IntArray] | None = None


@dataclass(frozen=True)
class _Columns(ByColumn):
    """All points at each t: θ₀ ascending, padded with NaN, and friction."""

    t: FloatArray
    theta0: FloatArray
    mu0: FloatArray

    @classmethod
    def at(cls, t: FloatArray, condition: CurveCondition, fixed: Fixed) -> _Columns:
        c, s, _ = on_circle(t)
        coefficients = np.stack(np.broadcast_arrays(*condition.polynomial(c, s, fixed)), axis=-1)
        coefficients /= np.abs(coefficients).max(axis=-1, keepdims=True)
        theta0 = (
            2 * np.arctan(_positive_roots(coefficients, condition.number and condition.number(t))).T
        )
        return cls(t, theta0, condition.friction(c, s, theta0, fixed))

    def goes_on(self, other: _Columns, step: float) -> BoolArray:
        """Whether both have as many points, and those with μ₀ ≥ 0 differ by at most a step in θ₀/π
        and μ₀/(1 + μ₀).
        """
        one, two = (np.stack([it.theta0 / np.pi, 1 / (1 + np.abs(it.mu0))]) for it in (self, other))
        far = (np.abs(one - two) > step).any(axis=0) & ((self.mu0 >= 0) | (other.mu0 >= 0))
        return (np.isnan(self.theta0) == np.isnan(other.theta0)).all(axis=0) & ~far.any(axis=0)


def _positive_roots(coefficients: FloatArray, number: IntArray | None) -> FloatArray:
    """The positive roots of each polynomial, ascending, padded with NaN."""
    roots = eigenvalues(coefficients)
    if number is None:
        near = 1e-12  # tan(θ₀/2) that counts as 0
        # LAPACK gives real eigenvalues with the imaginary part 0.
        inside = (roots.imag == 0) & (roots.real > near) & (roots.real < 1 / near)
    else:
        # The roots closest to the positive real axis are taken, since rounding moves roots off it.
        # Rounding may also move a nearly double complex pair onto the axis: of roots on the axis
        # those farthest from others are taken first.
        off = np.hypot(roots.imag, np.minimum(roots.real, 0.0)) / (1e-300 + np.abs(roots))
        gap = np.partition(np.abs(roots[..., None] - roots[:, None]), 1, axis=-1)[..., 1]
        inside = np.lexsort((-gap, off)).argsort(axis=-1) < number[:, None]
    real = polished(coefficients, np.sort(np.where(inside, roots.real, np.nan), axis=-1))
    if number is not None:
        return np.maximum(real, 0.0)
    residual = np.abs(evaluate(by_power(coefficients), real)) / evaluate(
        by_power(np.abs(coefficients)), real
    )
    by_rounding = 1e-13  # largest residual of a root, over the sum of the terms' sizes
    return np.sort(np.where(residual < by_rounding, real, np.nan), axis=-1)


def curves(
    condition: CurveCondition, fixed: Fixed, t: FloatArray, step: float
) -> Iterator[FloatArray]:
    """All curves with μ₀ ≥ 0, in or out of contact: t, θ₀ and μ₀ along each, of shape (3, points).

    The directions ``t`` are refined until no step along a curve is longer than ``step``.
    """
    with quiet():
        columns = _Columns.at(np.unique(t), condition, fixed)
        while True:
            before, after = columns[:-1], columns[1:]
            # Cells of a relative width of 1e-10 are not halved any more.
            open_ = ~before.goes_on(after, step) & (after.t > before.t * (1 + 1e-10))
            if not open_.any():
                break
            columns = columns.concatenated(
                _Columns.at(np.sqrt(before.t * after.t)[open_], condition, fixed)
            )
            columns = columns[np.argsort(columns.t)]
        # Friction above −1e-11 counts as 0.
        there = np.isfinite(columns.mu0) & (columns.mu0 >= -1e-11)
    number = np.where(there, np.cumsum(there).reshape(there.shape) - 1, -1)
    points = np.stack(
        [np.broadcast_to(columns.t, there.shape), columns.theta0, np.maximum(columns.mu0, 0.0)]
    )[:, there]
    for chain in walked(_links(columns, number, step)):
        if chain.size > 1:
            yield points[:, chain]


def _links(columns: _Columns, number: IntArray, step: float) -> list[set[int]]:
    """Neighbours of each point on its curve: at the next θ, or the point with which it vanishes."""
    links: list[set[int]] = [set() for _ in range(number.max(initial=-1) + 1)]
    continues = columns[:-1].goes_on(columns[1:], step)
    same = (number[:, :-1] >= 0) & (number[:, 1:] >= 0) & continues
    link(links, zip(number[:, :-1][same].tolist(), number[:, 1:][same].tolist(), strict=True))
    for index in np.flatnonzero(~continues):
        both = slice(index, index + 2)
        present = number[:, both] >= 0
        numbers = number[:, both][present].tolist()
        pairs = _pairs(columns.theta0[:, both][present], np.nonzero(present)[1])
        link(links, ((numbers[one], numbers[other]) for one, other in pairs))
    return links


def _pairs(theta0: FloatArray, side: IntArray) -> Iterator[tuple[int, int]]:
    """Pairs of roots on the same curve, between two directions with different numbers of roots.

    Roots of the two sides are paired first, the nearest first; then remaining roots of one side,
    which meet in between. Other roots end at θ₀ = 0 or π.
    """
    free, every = set(range(side.size)), itertools.combinations(range(side.size), 2)
    for _, far, *pair in sorted(
        (side[i] == side[j], abs(theta0[i] - theta0[j]), i, j) for i, j in every
    ):
        longest = 0.05  # radians
        if far < longest and free.issuperset(pair):
            free.difference_update(pair)
            yield pair[0], pair[1]


class Directions(NamedTuple):
    """Directions t = tan(θ/2) in 0 < θ < π on both sides of each event and of θ = π/2, and between
    neighbouring events.

    ``number`` has the number of folds with 0 < θ₀ < π and μ₀ of either sign, before, between and
    after the ``events``.
    """

    t: FloatArray
    events: FloatArray
    number: IntArray

    def folds_at(self, t: FloatArray) -> IntArray:
        """The number of folds in each direction."""
        return self.number[np.searchsorted(self.events, t)]


def fold_polynomial(c: Number, s: Number, fixed: Fixed) -> tuple[Any, ...]:
    """The condition for a fold at (cos θ, sin θ), a quartic in tan(θ₀/2) > 0, lowest power
    first.
    """
    e0, e1, e2, ec = _catastrophe.fold_conic(c, s, *fixed)
    return e0 + ec, 2 * e1, 4 * e2 + 2 * e0, 2 * e1, e0 - ec


def directions(fixed: Fixed) -> Directions:
    """The first directions in which folds are sought. The events beyond π/2 follow from the
    symmetry (θ, θ₀, μ) → (π − θ, π − θ₀, −μ).
    """
    exact = Fixed(*map(Fraction, fixed))  # type: ignore[arg-type]
    events = _events(exact)
    ends = [Fraction(0), *itertools.chain(*events), Fraction(1)]
    inside = [(low + high) / 2 for low, high in zip(ends[::2], ends[1::2], strict=True)]
    number = [_number(t, exact) for t in inside]
    event_t = np.array([float((root.low + root.high) / 2) for root in events])
    beside = np.append(event_t, 1.0)
    offset = 4e-14  # of directions beside an event, relative to t
    t = np.concatenate([beside * (1 - offset), beside * (1 + offset), list(map(float, inside))])
    return Directions(
        np.append(t, 1 / t),
        np.append(event_t, 1 / event_t[::-1]),
        np.array(number + number[-2::-1]),
    )


def _number(t: Fraction, exact: Fixed) -> int:
    """The exact number of folds in a direction."""
    condition = polynomials.primitive(fold_polynomial(*on_circle(t)[:2], exact))
    return len(real_roots(condition, Fraction(0), polynomials.root_bound(condition), 0))


def _events(exact: Fixed) -> list[IsolatedRoot]:
    """All events in 0 < t < 1, ascending, in disjoint intervals."""
    conditions, bits = _conditions(exact), 64
    while True:
        found = sorted(
            root
            for condition in conditions
            for root in real_roots(condition, Fraction(0), Fraction(1), bits)
        )
        after = [*(root.low for root in found[1:]), Fraction(1)]
        if all(root.high < low for root, low in zip(found, after, strict=False)):
            return found
        bits *= 2


def _conditions(exact: Fixed) -> list[Polynomial]:
    """Polynomials in t whose roots are the events, all simple and different, and not 0 or 1."""

    @cache  # the three polynomials are interpolated at common nodes
    def values(s: Fraction) -> tuple[Fraction, ...]:
        if exact.alpha:
            return tuple(_catastrophe.fold_events(s, *exact))
        return tuple(
            _catastrophe.fold_events_without_alpha(s, exact.kappa, exact.sigma, exact.beta)
        )

    def one(index: int, s: Fraction) -> Fraction:
        return values(s)[index]

    found: list[Polynomial] = []
    for index, degree in enumerate((15, 6, 6)):  # largest degrees in sin θ
        in_sine = polynomials.interpolate(partial(one, index), degree)
        if in_sine:  # else it vanishes at every θ
            condition = polynomials.squarefree(of_sine_in_t(in_sine))
            for other in [(-1, 1), *found]:
                condition = polynomials.without(
                    condition, polynomials.common_divisor(condition, other)
                )
            found.append(condition)
    return found
