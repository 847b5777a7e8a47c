"""All folds along one parameter for arrays of points, in float64 with proved error bounds.

They are those of :mod:`.folds`, from the same polynomials in t = tan(θ/2), whose positive roots are
isolated in Bernstein form (:mod:`spragsym.numerics.bernstein`). Every sign by which a fold is
classified is checked against an error bound; points that float64 can't decide are marked.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from ..generated.quantities import PARAMETERS
from ..models.parameters import FloatArray
from ..numerics import balls, bernstein
from ..numerics.affine import Rounded, as_rounded, cosine_and_sine
from ..numerics.arithmetic import Number, Polynomial
from ..numerics.balls import Ball, as_floats, ends
from ..numerics.interval_arrays import BoolArray, IndexArray, Int8Array, quiet, scale_of
from ..numerics.polynomials import on_circle
from . import kernel
from .kernel import LINEAR


@dataclass(frozen=True)
class FoldArrays:
    """Folds in contact of many points, in no order.

    ``side`` and ``upper`` are as in :class:`~.folds.Fold`.
    """

    row: IndexArray  #: the point of each fold
    value: Rounded  #: of the parameter
    t: Rounded  #: tan(θ/2)
    side: Int8Array
    upper: BoolArray
    undecided: BoolArray  #: for each point whether it is undecided, and none of its folds listed

    def rows(self, index: IndexArray) -> FoldArrays:
        """The folds of some indices."""
        value, t = self.value.rows(index), self.t.rows(index)
        return FoldArrays(
            self.row[index], value, t, self.side[index], self.upper[index], self.undecided
        )


def folds(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    """All folds along one of the six parameters within its range, for ``size`` points.

    ``given`` has the other parameters, arrays of ``size`` or single numbers.
    """
    with quiet():
        return _in_theta0(given, size) if vary == "theta0" else _along(vary, given, size)


def _along(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    values, reference, without, change, sextic = _eliminated(vary, given)
    roots = bernstein.positive_roots(sextic, size)
    direction = on_circle(roots.t)[:2]
    slope = kernel.f(*direction, *_rows(change, roots.row))
    value = -kernel.f(*direction, *_rows(without, roots.row)) / slope
    others = dict(zip(LINEAR, _rows(values, roots.row), strict=True)) | {vary: value}
    upper = roots.rising * slope.sign()
    return _kept(
        roots, value, (*direction, *_rows(reference, roots.row)), others, (-roots.rising, upper)
    )


def friction_sextic(given: Mapping[str, FloatArray]) -> Sequence[Any]:
    """Coefficients of (1 + t²)³ (f′ f_μ₀ − f f_μ₀′) in t = tan(θ/2), which is negative where μ₀ on
    the surface f = 0 rises with θ.
    """
    return _eliminated("mu0", given)[-1]


def _eliminated(
    vary: str, given: Mapping[str, FloatArray]
) -> tuple[Any, Any, Any, Any, Sequence[Any]]:
    """Parameters with 0 for the one, v, that varies; (cos θ₀, sin θ₀); coefficients (a, b, d, m) of
    f and of f_v; and those of f′ f_v − f f_v′ in t.
    """
    values = [Rounded(given[name] if name != vary else np.float64(0.0)) for name in LINEAR]
    angle = cosine_and_sine(given["theta0"])
    without, change = kernel.f_along(vary, *angle, *values)
    return values, angle, without, change, kernel.fold_sextic(*without, *change)


def _in_theta0(given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    """Folds along θ₀. For α = 0, f does not depend on cos θ₀: the condition is then the second fold
    relation, and θ₀ and π − θ₀ are both folds.
    """
    values = [Rounded(given[name]) for name in LINEAR]
    polynomial, free = _circle(values), np.broadcast_to(given["alpha"] == 0, size)
    if free.any():
        relation = math.prod(
            [Polynomial([1, 0, 1])] * 3, start=Polynomial(kernel.fold_cubics(*values)[1])
        )
        polynomial = [
            _where(free, one, other)
            for one, other in zip(relation.coefficients, polynomial, strict=True)
        ]
    roots = bernstein.positive_roots(polynomial, size)
    doubled = np.flatnonzero(free[roots.row])
    index = np.append(np.arange(roots.row.size), doubled)
    roots = bernstein.PolynomialRoots(
        roots.row[index], roots.t.rows(index), roots.rising[index], roots.undecided
    )
    others, direction = _rows(values, roots.row), on_circle(roots.t)[:2]
    sin0, cos0 = kernel.fold_sine(*direction, *others), kernel.fold_angles(*direction, *others)[1]
    inside = np.ones(index.size, dtype=np.int8)
    if doubled.size:
        square, free = 1 - sin0 * sin0, free[roots.row]
        inside, width = np.where(free, square.sign(), 1), square.sqrt()
        cos0 = _where(
            free,
            width * np.where(np.arange(index.size) < index.size - doubled.size, 1.0, -1.0),
            cos0,
        )
    trig = kernel.f_coefficients(cos0, sin0, *others, 1)
    change = kernel.f(*direction, *kernel.f_changes(cos0, sin0, *others)[0])
    curvature = kernel.f_curvature(*direction, *trig).sign()
    # The exact point lies on the unit circle, at most this far from the computed one.
    distance = np.hypot(sin0.error, cos0.error)
    theta0 = Rounded(
        np.arctan2(sin0.value, cos0.value), np.where(distance < 0.1, 1.01 * distance, 4.0) + 1e-15
    )
    parameters = dict(zip(LINEAR, others, strict=True))
    return _kept(
        roots,
        theta0,
        (*direction, cos0, sin0),
        parameters,
        (-curvature * change.sign(), curvature),
        inside,
    )


def _circle(values: list[Rounded]) -> list[Rounded]:
    """Coefficients of (1 + t²)⁶ (p B q α)² (sin² θ₀ + cos² θ₀ − 1) in t."""
    _, _, alpha, sigma, beta = values
    width = alpha * (beta + 1 + sigma)
    scale = (alpha + sigma) * (beta + 1) * width
    powers, others = (
        (one * one).coefficients for one in map(Polynomial, kernel.fold_cubics(*values))
    )
    result = [width * width * one + other for one, other in zip(powers, others, strict=True)]
    for half, binomial in enumerate((1, 6, 15, 20, 15, 6, 1)):
        result[2 * half] = result[2 * half] - scale * scale * binomial
    return result


def _kept(
    roots: bernstein.PolynomialRoots,
    value: Rounded,
    angles: tuple[Rounded, Rounded, Rounded, Rounded],
    parameters: Mapping[str, Rounded],
    signs: tuple[Int8Array, Int8Array],
    inside: Int8Array | int = 1,
) -> FoldArrays:
    """The candidates in contact with a value in its range.

    ``signs`` are those of ``side`` and ``upper``. A sign that is needed and not certain makes the
    point undecided.
    """
    L, _, y = kernel.state_of(*angles, *(parameters[name] for name in kernel.Fixed._fields))
    tests = [value.sign(), L.sign(), -y.sign(), angles[3].sign(), inside]
    excluded = functools.reduce(np.logical_or, [test < 0 for test in tests])
    open_ = functools.reduce(np.logical_or, [test == 0 for test in (*tests, *signs)]) & ~excluded
    undecided = roots.undecided.copy()
    undecided[roots.row[open_]] = True
    candidates = FoldArrays(roots.row, value, roots.t, signs[0], signs[1] > 0, undecided)
    return candidates.rows(np.flatnonzero(~excluded & ~undecided[roots.row]))


def _rows(parts: Iterable[Any], index: IndexArray) -> list[Any]:
    return [as_rounded(part).rows(index) for part in parts]


def _where(which: BoolArray, *numbers: Any) -> Rounded:
    one, other = map(as_rounded, numbers)
    return Rounded(
        *(np.where(which, getattr(one, part), getattr(other, part)) for part in ("value", "error"))
    )


# ------------------------------------------------------------------------------------------------
# refinement


#: Largest proved error of a value over max(1, |value|).
LARGEST_ERROR = 1e-12


def sharpened(
    vary: str, given: Mapping[str, FloatArray], found: FoldArrays
) -> tuple[Rounded, Rounded, IndexArray]:
    """Refined t = tan(θ/2) and values of folds, and the indices of those still above
    :data:`LARGEST_ERROR`.

    ``given`` has the other parameters of each fold.
    """
    exact = {name: Rounded(column) for name, column in given.items()}
    wide = Rounded(found.value.value, 2 * found.value.error)  # with the surface beside the fold
    steps = _sharpened(
        vary,
        exact,
        (found.t, wide),
        _cosine_and_sine,
        lambda one: Rounded(one.value),
        lambda one, other: _where(2 * other.error <= one.error, other, one),
    )
    with quiet():
        for near in itertools.islice(steps, 2):
            remaining = np.flatnonzero(~(near[1].error <= LARGEST_ERROR * scale_of(near[1].value)))
            if not remaining.size:
                break
    return *near, remaining


def _cosine_and_sine(angle: Rounded) -> tuple[Rounded, Rounded]:
    cosine, sine = cosine_and_sine(angle.value)
    return Rounded(cosine.value, cosine.error + angle.error), Rounded(
        sine.value, sine.error + angle.error
    )


def with_more_digits(vary: str, given: Mapping[str, float], t: Rounded, value: Rounded) -> float:
    """The value of one fold, refined in ball arithmetic to the digits of a float.

    Raises
    ------
    UndecidedSign
        If f_v or f″ may be 0 within the bounds.
    """

    def around(number: Rounded) -> Ball:
        middle, error = Fraction(float(number.value)), Fraction(float(number.error))
        return balls.between(middle - error, middle + error)

    def narrower(one: Ball, other: Ball) -> Ball:
        (low, high), (begin, end) = ends(one), ends(other)
        return other if 2 * (end - begin) <= high - low else one

    with balls.precision(160):  # bits
        exact = {name: balls.exact(Fraction(number)) for name, number in given.items()}
        steps = _sharpened(
            vary, exact, (around(t), around(value)), balls.cos_sin, balls.middle, narrower
        )
        *_, (_, best) = itertools.islice(steps, 3)
        return as_floats((best,))[0][0]


def _sharpened(
    vary: str,
    given: Mapping[str, Any],
    near: tuple[Any, Any],
    cos_sin: Callable[[Any], tuple[Any, Any]],
    middle: Callable[[Any], Any],
    narrower: Callable[[Any, Any], Any],
) -> Iterator[tuple[Any, Any]]:
    """Enclosures of t and the value v of a fold, narrower after each step; arrays or single balls.

    ``near`` encloses both on the fold, and v on the surface f = 0 for all directions in t. On the
    surface dv/dθ = −f′/f_v, which is 0 on the fold: so v at the midpoint of t differs from that on
    the fold by at most the width of t times the largest \\|f′/f_v\\|. An interval Newton step for
    f′ = 0 then narrows t. ``narrower`` returns the second of two enclosures if it is at most half
    as wide as the first.
    """

    level = None if vary == "theta0" else cos_sin(given["theta0"])

    def with_value(v: Number) -> tuple[Any, ...]:
        return *(level or cos_sin(v)), *(v if name == vary else given[name] for name in LINEAR)

    t, value = near
    while True:
        centre, v = middle(t), middle(value)
        (at_centre, enclosing), values = (on_circle(one) for one in (centre, t)), with_value(value)
        trig = kernel.f_coefficients(*values, 1)
        change = kernel.f_changes(*values)[PARAMETERS.index(vary)]
        # |dθ| ≤ 2 |dt|
        drift = (
            kernel.f_slope(*enclosing[:2], *trig)
            / kernel.f(*enclosing[:2], *change)
            * (2 * (t - centre))
        )
        on_surface = v - kernel.f(
            *at_centre[:2], *kernel.f_coefficients(*with_value(v), 1)
        ) / kernel.f(*at_centre[:2], *change)
        value = narrower(value, on_surface + drift)
        slope = kernel.f_slope(*at_centre[:2], *kernel.f_coefficients(*with_value(value), 1))
        t = narrower(
            t, centre - slope / kernel.f_curvature(*enclosing[:2], *trig) * enclosing.scale / 2
        )
        yield t, value
