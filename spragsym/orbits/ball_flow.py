"""Rigorous integration of a piecewise smooth field in ball arithmetic: enclosures of a set of
trajectories and of the derivative of the flow.

The set is represented in mean value form (:class:`Balls`): a point, which is a ball, and a matrix
that encloses the derivative by the initial state over the whole set. By the mean value theorem the
trajectory whose initial state deviates by δ is at point + matrix δ.

Each step is a Taylor polynomial with a bound of the remainder by Cauchy's estimate: if the field is
at most F_i on a polydisc of radii R_i around the states, the solution is analytic for
|t| < ρ = min R_i / F_i, and its coefficients are at most R_i ρ^−k. At a border all trajectories are
shown to cross it exactly once within a time window of 2 η, in which the rates change by at most the
field's Lipschitz constant times the distance covered.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import reduce
from operator import methodcaller
from typing import Any, TypeAlias

from flint import acb, arb, arb_mat, arb_poly, arb_series, ctx

from ..core.errors import ParameterError
from ..models.field import Border, Field, Mode
from ..numerics.jets import Functions, constant, gradient, variables

#: Balls, or power series, such as one for each number of a state.
Numbers: TypeAlias = list[Any]


class NotProved(Exception):
    """The proof fails, for the reason in the message."""


class TooWide(NotProved):
    """The proof fails, but may succeed for a smaller set of initial states with more digits."""


#: Context manager that sets the precision of balls in bits.
bits = ctx.workprec


@dataclass(frozen=True)
class Accuracy:
    """Order of Taylor polynomials, and precision of their coefficients in bits."""

    order: int
    bits: int


@dataclass
class Balls:
    """A set of states: ``point`` + ``matrix`` · ``start``, where ``start`` are balls around 0, the
    deviations of the initial states.

    Methods integrate it in place. The point needs the accuracy ``fine``. The matrix multiplies
    small deviations only: the accuracy ``rough`` suffices, which costs far less.
    """

    smooth: Smooth
    fine: Accuracy
    rough: Accuracy
    point: Numbers
    matrix: arb_mat
    start: Numbers

    @property
    def box(self) -> Numbers:
        """Interval enclosure of the set: a ball for each component."""
        return _moved(self.point, self.matrix * arb_mat([[each] for each in self.start]))

    def carry(self, duration: arb) -> None:
        """Integrate the set over an exact duration ≥ 0 within its mode; NotProved if a state may
        leave the mode.
        """
        if not duration >= 0:
            raise ParameterError(
                f"duration = {duration} is not certainly 0 or more; a set of states is "
                "carried onward only"
            )
        remaining = duration
        while remaining > 0:
            remaining = remaining - self._step(remaining)
            if not remaining.is_exact():
                raise NotProved(
                    "time could not be kept exactly: the steps have become as short as its last bit"
                )

    def _step(self, remaining: arb) -> arb:
        """One Taylor step, of ``remaining`` time at most; returns its length."""
        box, piece = self.box, self.smooth
        radius, bounds, slope = self._disc(box)
        # A step is a seventh of the radius of convergence; the factor covers rounding.
        step = arb(radius * (1 / 7) * (1 - 1e-12))
        step = remaining if remaining < 1.2 * step else step
        ratio = (step / radius).abs_upper()
        middle = [value.mid() for value in self.point]
        center = piece.solution(middle, self.fine.order)
        with bits(self.rough.bits):
            rough_remainder = _remainder(ratio, self.rough)
            within = piece.solution(box, self.rough.order)
            derivative = piece.fundamental(within, self.rough.order, step)
            derivative += piece.filled(ball_about_zero((slope * radius).exp() * rough_remainder))
            self.matrix = derivative * self.matrix
        # The mean value form also for the radius of the point: where the flow contracts, the
        # enclosure contracts, too.
        deviation = derivative * arb_mat(
            [[value - mid] for value, mid in zip(self.point, middle, strict=True)]
        )
        remainder = _remainder(ratio, self.fine)
        ends = [
            polynomial(jet, step) + ball_about_zero(bound * remainder)
            for jet, bound in zip(center, bounds, strict=True)
        ]
        self.point = _moved(ends, deviation)
        tails = [bound * rough_remainder for bound in bounds]
        passed = _Piece(within, tails, step, box, self.box)
        for border in piece.field.borders:
            if border.kink:
                self._clear(border, passed, arb(0), step)
        return step

    def _disc(self, box: Numbers) -> tuple[float, Numbers, arb]:
        """A radius of convergence ρ of the solutions from all states, the radii R_i of the
        polydisc, and a bound of the field's derivative on it.

        ρ is the first of a decreasing list for which radii with ρ F_i ≤ R_i are found, by
        iteration.
        """

        def disc(radii: Numbers) -> Numbers:
            return [
                acb(value + ball_about_zero(r), ball_about_zero(r))
                for value, r in zip(box, radii, strict=True)
            ]

        def sizes(radii: Numbers) -> Numbers:
            return [abs(acb(rate)).abs_upper() for rate in self.smooth.rates(disc(radii))]

        if not all(value.rad() < 1e-2 for value in box):
            raise TooWide(
                "the enclosure of the states has grown too wide: more digits would do it, or "
                "the orbit is too stiff"
            )
        # The square root in a spring's length L is analytic on the disc: a disc around a positive
        # number that meets its cut contains 0, where 1/L is infinite.
        initial = sizes([arb(1e-3)] * len(box))
        for radius in (
            *(3.0, 2.0, 1.4, 1.0, 0.75, 0.55, 0.4, 0.3, 0.22, 0.16, 0.11, 0.07, 0.04, 0.02),
            0.005,
        ):
            found, margin = initial, 1.1
            for _ in range(6):
                radii = [arb(float(radius * margin * size.mid())) + arb(1e-3) for size in found]
                found, margin = sizes(radii), 1.05
                if not all(size.is_finite() for size in found):
                    break
                if all(radius * size <= each for size, each in zip(found, radii, strict=True)):
                    slope = self.smooth.steepness(disc(radii))
                    # The remainder of the derivative has the factor exp(radius × slope).
                    if radius * slope < 20:
                        return radius, radii, slope
                    break
        raise NotProved("the field could not be bounded about the orbit")

    def _clear(self, border: Border, piece: _Piece, begin: arb, end: arb) -> None:
        """Show that no state leaves the mode through a border in a part of a step: the level is
        positive, or monotonic with positive ends, or that holds for both halves of the part.
        """
        state, smooth = piece.at(begin.union(end)), self.smooth
        if smooth.level(border, state) > 0:
            return
        rate = smooth.level_rate(border, state)
        if rate > 0 or rate < 0:
            ends = [smooth.level(border, piece.at(t)) for t in (begin, end)]
            if any(level < 0 for level in ends):
                raise NotProved(
                    f"the orbit meets {border.name} at a place where the cycle is said not to "
                    "cross it"
                )
            if not all(level > 0 for level in ends):
                raise TooWide(
                    f"that no state meets {border.name} where the cycle does not cross it "
                    "could not be shown"
                )
            return
        if end - begin < piece.step * (2.0**-39.5):
            raise NotProved(
                f"whether the orbit meets {border.name} could not be decided near one place: "
                "it touches it there, or all "
                "but; at a grazing no number of digits tells: move a parameter"
            )
        middle = ((begin + end) / 2).mid()
        self._clear(border, piece, begin, middle)
        self._clear(border, piece, middle, end)

    def keeps_clear(self, states: Numbers, but: int = -1) -> None:
        """Show that states are inside all borders of the mode, except the border ``but``."""
        for i, border in enumerate(self.smooth.field.borders):
            if border.kink and i != but and not self.smooth.level(border, states) > 0:
                raise NotProved(f"{border.name} is too near to be told from what happens beside it")

    def apart(self, index: int) -> arb:
        """Estimated time between the first and the last arrival at a border; not rigorous."""
        border = self.smooth.field.borders[index]
        speed = arb(
            self.smooth.level_rate(border, [value.mid() for value in self.point])
        ).abs_lower()
        return arb(self.smooth.level(border, self.box)).rad() / speed

    def cross(self, index: int, window: arb) -> None:
        """Integrate the set over a border with index ``index``, in a time window during which each
        state is shown to cross it exactly once.
        """
        if not window > 0:
            raise ParameterError(
                f"window = {window} is not positive; a set of states is carried onward only"
            )
        before, box = self.smooth, self.box
        border, after = before.field.borders[index], before.beyond(index)
        if not before.level(border, box) > 0:
            raise TooWide(f"that no state has met {border.name} yet could not be shown")
        hull = [value + ball_about_zero(1e-6) for value in box]
        self.keeps_clear(hull, but=index)
        both = (before, after)
        speed = largest([arb(value).abs_upper() for piece in both for value in piece.rates(hull)])
        slope = largest([piece.steepness(hull) for piece in both])
        if not window * speed < arb(1e-6):
            raise TooWide(
                f"the states meet {border.name} too far apart in time; more digits would do "
                "it, unless it is only touched there"
            )
        # Both levels are positive inside their own mode.
        sign = border.sign(before.mode) * border.sign(after.mode)
        if not (before.level_rate(border, hull) < 0 and sign * after.level_rate(border, hull) < 0):
            raise NotProved(f"that {border.name} is crossed, not only touched, could not be shown")
        # The field is continuous: within the window, across the border too, rates change by at
        # most the Lipschitz constant times the distance covered.
        error = ball_about_zero(window * slope * window * speed)
        self.point = [
            value + window * rate + error
            for value, rate in zip(self.point, before.rates(self.point), strict=True)
        ]
        growth = self.smooth.filled(ball_about_zero((window * slope).exp() - 1))
        self.matrix = (growth + 1) * self.matrix
        if not before.level(border, self.box) < 0:
            raise TooWide(f"that every state has crossed {border.name} could not be shown")
        self.smooth = after


@dataclass(frozen=True)
class _Piece:
    """The set of states during a step: Taylor series in time with remainder bounds ``tails``, and
    tighter enclosures ``first`` and ``last`` at the two ends.
    """

    series: Numbers
    tails: Numbers
    step: arb
    first: Numbers
    last: Numbers

    def at(self, t: arb) -> Numbers:
        """The states at a time, or over a ball of times."""
        if t.is_exact() and (t == 0 or t == self.step):
            return self.first if t == 0 else self.last
        return [
            polynomial(each, t) + ball_about_zero(tail)
            for each, tail in zip(self.series, self.tails, strict=True)
        ]


def _remainder(ratio: arb, accuracy: Accuracy) -> arb:
    """Bound of a Taylor polynomial's remainder, relative to R_i: Σ_{k > order} ratio^k, with
    ``ratio`` the step over the radius of convergence.
    """
    return ratio ** (accuracy.order + 1) / (1 - ratio)


def _moved(point: Numbers, column: arb_mat) -> Numbers:
    """A point plus a column of deviations."""
    return [value + column[i, 0] for i, value in enumerate(point)]


class _Methods:
    """Namespace whose functions call the methods of balls and power series."""

    def __getattr__(self, name: str) -> Callable[[arb], arb]:
        return methodcaller(name)

    def tanh(self, value: arb) -> arb:
        """tanh; power series have no method for it, and use the exponential."""
        return 1 - 2 / ((2 * value).exp() + 1) if isinstance(value, arb_series) else value.tanh()


class _Functions(Functions):
    @property
    def pi(self) -> arb:
        """π with the present precision."""
        return arb.pi()


#: Namespace ``xp`` for balls, for power series in time, and for jets of both; numbers become exact
#: balls.
XP = _Functions(_Methods(), lambda value: arb(value) if isinstance(value, int | float) else value)


@contextmanager
def _terms(count: int) -> Iterator[None]:
    """Context in which power series have ``count`` terms."""
    before, ctx.cap = ctx.cap, count
    try:
        yield
    finally:
        ctx.cap = before


@dataclass(frozen=True)
class Smooth:
    """The field in one mode, evaluated on states of balls or of power series."""

    field: Field
    constants: Numbers
    mode: Mode

    def beyond(self, index: int) -> Smooth:
        """The field in the mode beyond a border."""
        return replace(self, mode=self.field.borders[index].beyond(self.mode))

    def filled(self, value: arb | int) -> arb_mat:
        """The (m, m) matrix whose entries all have one value."""
        m = self.field.size
        return arb_mat(m, m, [value] * (m * m))

    def rates(self, state: Numbers) -> Numbers:
        """Rates of all components of a state."""
        return [
            *state[len(self.field.coordinates) :],
            *self.field.acceleration(state, self.constants, self.mode, XP),
        ]

    def slopes(self, state: Numbers) -> list[Numbers]:
        """Derivatives of the accelerations by the state, (n, m), by automatic differentiation.

        The generated derivatives may be expanded polynomials, which overestimate over wide balls.
        """
        accelerations = self.field.acceleration(variables(state, 1), self.constants, self.mode, XP)
        return [gradient(acceleration, self.field.size) for acceleration in accelerations]

    def level(self, border: Border, state: Numbers) -> arb:
        """Level of a border at a state, with the sign that is positive inside the mode."""
        return border.sign(self.mode) * border.level(state, self.constants, self.mode)

    def level_rate(self, border: Border, state: Numbers) -> arb:
        """Rate of :meth:`level`."""
        accelerations = self.field.acceleration(state, self.constants, self.mode, XP)
        return border.sign(self.mode) * border.rate(state, accelerations, self.constants, self.mode)

    def steepness(self, state: Numbers) -> arb:
        """Bound of the field's derivative over a ball of states, in the maximum norm. It is at
        least 1, the row sum of coordinates.
        """
        rows = self.slopes(state)
        sums = [sum(abs(acb(value)).abs_upper() for value in row) for row in rows]
        return largest([arb(1), *sums])

    def solution(self, state: Numbers, order: int) -> Numbers:
        """Taylor polynomials in time of the solution from a state, one per component.

        Newton's method for power series: each iteration doubles the number of known coefficients.
        The added coefficients satisfy the equation linearized about the known polynomials exactly,
        up to twice the order.
        """
        n, m = len(self.field.coordinates), self.field.size
        rows = [[arb(value)] for value in state]
        while len(rows[0]) <= order:
            terms, count = len(rows[0]), min(2 * len(rows[0]), order + 1)
            with _terms(count):
                series = [arb_series(row, prec=count) for row in rows]
                accelerations = self.field.acceleration(
                    variables(series, 1), self.constants, self.mode, XP
                )
            rates = [constant(each) for each in accelerations]
            slopes = [gradient(each, m) for each in accelerations]
            by_state = [
                arb_mat(n, m, [_term(value, k) for row in slopes for value in row])
                for k in range(count - terms)
            ]
            added: list[arb_mat] = []
            for k in range(terms, count):
                acceleration = arb_mat(n, 1, [_term(rate, k - 1) for rate in rates])
                for slope, earlier in zip(by_state, reversed(added), strict=False):
                    acceleration += slope * earlier
                of_coordinates = [row[k - 1] / k for row in rows[n:]]
                of_rates = [value / k for value in acceleration.entries()]
                coefficients = [*of_coordinates, *of_rates]
                added.append(arb_mat(m, 1, coefficients))
                for row, value in zip(rows, coefficients, strict=True):
                    row.append(value)
        return [arb_series(row, prec=order + 1) for row in rows]

    def fundamental(self, within: Numbers, order: int, step: arb) -> arb_mat:
        """Fundamental matrix of the variational equation along the solutions ``within``, at the end
        of a step, as a Taylor polynomial without remainder.
        """
        n, m = len(self.field.coordinates), self.field.size
        with _terms(order + 1):
            rows = self.slopes(within)
        slopes = [
            arb_mat(n, m, [_term(value, k) for row in rows for value in row]) for k in range(order)
        ]
        parts = [self.filled(0) + 1]
        for k in range(order):
            total = slopes[0] * parts[k]
            for i in range(1, k + 1):
                total += slopes[i] * parts[k - i]
            # Rates are the derivatives of coordinates: the upper half of the next coefficient is
            # the lower half of this one.
            parts.append(
                arb_mat(m, m, parts[k].entries()[n * m :] + total.entries()) * (arb(1) / (k + 1))
            )
        return reduce(lambda found, part: found * step + part, reversed(parts))


def _term(value: arb | arb_series, k: int) -> arb | int:
    """Coefficient k of a power series or a constant."""
    if isinstance(value, arb_series):
        return value[k]
    return value if k == 0 else 0


def polynomial(series: arb_series, t: arb) -> arb:
    """Value of a Taylor polynomial at a time."""
    return arb_poly(series.coeffs())(t)


def ball_about_zero(radius: arb | float) -> arb:
    """The ball around 0 that contains ±radius."""
    return arb(0, arb(radius).abs_upper())


def largest(values: Numbers) -> arb:
    """Upper bound of the largest of several balls."""
    return reduce(arb.max, values).abs_upper()
