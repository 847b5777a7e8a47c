"""The flow of a piecewise smooth field in ball arithmetic: enclosures of a trajectory and of the
derivative of the flow.

A set of states is carried as a point, known to a ball, and a matrix that encloses the derivative by
the start over all of the starts: by the mean value theorem a start that is off by δ is at point +
matrix δ. Every step is a Taylor polynomial with a bound on what is left out: on a polydisc of radii
R_i about the states the field is at most F_i, so that the solution is analytic for |t| < ρ = min
R_i / F_i and its coefficients are at most R_i ρ^−k (Cauchy). Where a border is crossed, all
trajectories are shown to cross once within a window of 2 η, in which the field changes by no more
than its Lipschitz constant times η.
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
    """Claim that could not be shown."""


class TooWide(NotProved):
    """Claim that a smaller set of starts, carried with more digits, may show."""


#: Balls of so many bits for as long as the context lasts.
bits = ctx.workprec


@dataclass(frozen=True)
class Accuracy:
    """Accuracy of Taylor polynomials: their order, and the bits of their coefficients."""

    order: int
    bits: int


@dataclass
class Balls:
    """A set of states in balls: a point, the derivative by the start, and how far the starts are
    off.

    The point is carried as accurately as ``fine`` says. What multiplies the small deviations, the
    derivative, need be no more accurate than ``rough``, which costs far less.
    """

    smooth: Smooth
    fine: Accuracy
    rough: Accuracy
    point: Numbers
    matrix: arb_mat
    start: Numbers

    @property
    def box(self) -> Numbers:
        """All states."""
        return _moved(self.point, self.matrix * arb_mat([[each] for each in self.start]))

    # ------------------------------------------------------------------------------------------
    # smooth steps

    def carry(self, duration: arb) -> None:
        """Carry all states on within the mode, which none may leave; only onward."""
        if not duration >= 0:
            raise ParameterError(
                f"duration = {duration} is not certainly 0 or more; a set of states is "
                "carried onward only"
            )
        left = duration
        while left > 0:
            left = left - self._step(left)
            if not left.is_exact():
                raise NotProved(
                    "time could not be kept exactly: the steps have become as short as its last bit"
                )

    def _step(self, left: arb) -> arb:
        """Carry all states on for all of a time, or as much of it as a step may be; that is
        given.
        """
        box, piece = self.box, self.smooth
        radius, bounds, slope = self._disc(box)
        # Steps are this share of the radius of convergence that is proved.
        share_of_radius = 1 / 7
        # By this factor steps stay below that share, however the product is rounded.
        step = arb(radius * share_of_radius * (1 - 1e-12))
        step = left if left < 1.2 * step else step
        ratio = (step / radius).abs_upper()
        middle = [value.mid() for value in self.point]
        center = piece.solution(middle, self.fine.order)
        with bits(self.rough.bits):
            tail = _left_out(ratio, self.rough)
            within = piece.solution(box, self.rough.order)
            derivative = piece.fundamental(within, self.rough.order, step)
            derivative += piece.filled(ball_about_zero((slope * radius).exp() * tail))
            self.matrix = derivative * self.matrix
        # By the mean value theorem: what the flow contracts, its enclosure contracts as well.
        off = derivative * arb_mat(
            [[value - mid] for value, mid in zip(self.point, middle, strict=True)]
        )
        left_out = _left_out(ratio, self.fine)
        ends = [
            polynomial(jet, step) + ball_about_zero(bound * left_out)
            for jet, bound in zip(center, bounds, strict=True)
        ]
        self.point = _moved(ends, off)
        passed = _Piece(within, [bound * tail for bound in bounds], step, box, self.box)
        for border in piece.field.borders:
            if border.kink:
                self._clear(border, passed, arb(0), step)
        return step

    def _disc(self, box: Numbers) -> tuple[float, Numbers, arb]:
        """A radius of convergence about all states, the radii of the polydisc, and a bound on the
        field's derivative there.
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
        # The square root in L is analytic there: a disc about a positive number that meets its cut
        # holds 0, and 1/L is infinite.
        still = sizes([arb(1e-3)] * len(box))
        # Radii of convergence that are tried.
        for length in (
            *(3.0, 2.0, 1.4, 1.0, 0.75, 0.55, 0.4, 0.3, 0.22, 0.16, 0.11, 0.07, 0.04, 0.02),
            0.005,
        ):
            found, room = still, 1.1
            for _ in range(6):
                radii = [arb(float(length * room * size.mid())) + arb(1e-3) for size in found]
                found, room = sizes(radii), 1.05
                if not all(size.is_finite() for size in found):
                    break
                if all(length * size <= radius for size, radius in zip(found, radii, strict=True)):
                    slope = self.smooth.steepness(disc(radii))
                    # Growth of small deviations, as an exponent, that is
                    # allowed over a radius of convergence: it multiplies
                    # what is left out.
                    if length * slope < 20:
                        return length, radii, slope
                    break
        raise NotProved("the field could not be bounded about the orbit")

    def _clear(self, border: Border, piece: _Piece, begin: arb, end: arb) -> None:
        """Show that no state leaves the mode through a border during a part of a step."""
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
        # Share of a step below which it is not halved any more where a border might be
        # met in it.
        if end - begin < piece.step * (2.0**-39.5):
            raise NotProved(
                f"whether the orbit meets {border.name} could not be decided near one place: "
                "it touches it there, or all "
                "but; at a grazing no number of digits tells: move a parameter"
            )
        middle = ((begin + end) / 2).mid()
        self._clear(border, piece, begin, middle)
        self._clear(border, piece, middle, end)

    # ---------------------------------------------------------------------------------------------
    # borders

    def keeps_clear(self, states: Numbers, but: int = -1) -> None:
        """Show that states are inside of all borders of the mode but one."""
        for i, border in enumerate(self.smooth.field.borders):
            if border.kink and i != but and not self.smooth.level(border, states) > 0:
                raise NotProved(f"{border.name} is too near to be told from what happens beside it")

    def apart(self, index: int) -> arb:
        """Difference in time between arrivals of the states at a border, about; not rigorous."""
        border = self.smooth.field.borders[index]
        speed = arb(
            self.smooth.level_rate(border, [value.mid() for value in self.point])
        ).abs_lower()
        return arb(self.smooth.level(border, self.box)).rad() / speed

    def cross(self, index: int, window: arb) -> None:
        """Carry all states over a border, which each of them crosses once within the window."""
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
        speed = most([arb(value).abs_upper() for piece in both for value in piece.rates(hull)])
        slope = most([piece.steepness(hull) for piece in both])
        if not window * speed < arb(1e-6):
            raise TooWide(
                f"the states meet {border.name} too far apart in time; more digits would do "
                "it, unless it is only touched there"
            )
        turned = border.sign(before.mode) * border.sign(after.mode)
        if not (
            before.level_rate(border, hull) < 0 and turned * after.level_rate(border, hull) < 0
        ):
            raise NotProved(f"that {border.name} is crossed, not only touched, could not be shown")
        # Within the window all that changes, the mode too, changes rates by no more than their
        # slope over the way.
        off = ball_about_zero(window * slope * window * speed)
        self.point = [
            value + window * rate + off
            for value, rate in zip(self.point, before.rates(self.point), strict=True)
        ]
        self.matrix = (
            self.smooth.filled(ball_about_zero((window * slope).exp() - 1)) + 1
        ) * self.matrix
        if not before.level(border, self.box) < 0:
            raise TooWide(f"that every state has crossed {border.name} could not be shown")
        self.smooth = after


@dataclass(frozen=True)
class _Piece:
    """All states during a step: series in time, what these leave out, and the states at both ends,
    which are known better.
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


def _left_out(ratio: arb, accuracy: Accuracy) -> arb:
    """Remainder of a Taylor polynomial over the bound on the field: the step is ``ratio`` times the
    radius of convergence.
    """
    return ratio ** (accuracy.order + 1) / (1 - ratio)


def _moved(point: Numbers, off: arb_mat) -> Numbers:
    """A point and a column of deviations."""
    return [value + off[i, 0] for i, value in enumerate(point)]


class _Methods:
    """Functions that are methods of balls and of power series; these have none for the hyperbolic
    tangent.
    """

    def __getattr__(self, name: str) -> Callable[[arb], arb]:
        return methodcaller(name)

    def tanh(self, value: arb) -> arb:
        """By the exponential, of a series."""
        return 1 - 2 / ((2 * value).exp() + 1) if isinstance(value, arb_series) else value.tanh()


class _Functions(Functions):
    @property
    def pi(self) -> arb:
        """π, as accurate as balls are now."""
        return arb.pi()


#: ``xp`` of balls, of power series in time and of jets of both; a number is a ball without width.
XP = _Functions(_Methods(), lambda value: arb(value) if isinstance(value, int | float) else value)


@contextmanager
def _terms(count: int) -> Iterator[None]:
    """Power series of ``count`` terms for as long as the context lasts."""
    before, ctx.cap = ctx.cap, count
    try:
        yield
    finally:
        ctx.cap = before


@dataclass(frozen=True)
class Smooth:
    """A smooth piece of a field in balls: the field in one mode. States are of balls, or of power
    series.
    """

    field: Field
    constants: Numbers
    mode: Mode

    def beyond(self, index: int) -> Smooth:
        """The piece behind a border."""
        return replace(self, mode=self.field.borders[index].beyond(self.mode))

    def filled(self, value: arb | int) -> arb_mat:
        """A square matrix of the size of the state, with one number in all places."""
        m = self.field.size
        return arb_mat(m, m, [value] * (m * m))

    def rates(self, state: Numbers) -> Numbers:
        """The rates of all numbers of a state."""
        return [
            *state[len(self.field.coordinates) :],
            *self.field.acceleration(state, self.constants, self.mode, XP),
        ]

    def slopes(self, state: Numbers) -> list[Numbers]:
        """Derivatives of the accelerations by the state, one operation after the other.

        Generated ones may be written out in powers: over wide balls their terms are many times as
        large as what is left of them.
        """
        accelerations = self.field.acceleration(variables(state, 1), self.constants, self.mode, XP)
        return [gradient(acceleration, self.field.size) for acceleration in accelerations]

    def level(self, border: Border, state: Numbers) -> arb:
        """A border's level at a state, positive within the piece."""
        return border.sign(self.mode) * border.level(state, self.constants, self.mode)

    def level_rate(self, border: Border, state: Numbers) -> arb:
        """The rate of that."""
        accelerations = self.field.acceleration(state, self.constants, self.mode, XP)
        return border.sign(self.mode) * border.rate(state, accelerations, self.constants, self.mode)

    def steepness(self, state: Numbers) -> arb:
        """A bound on the field's derivative over a ball of states: the largest sum of a row, and
        1.
        """
        return most(
            [
                arb(1),
                *(sum(abs(acb(value)).abs_upper() for value in row) for row in self.slopes(state)),
            ]
        )

    def solution(self, state: Numbers, order: int) -> Numbers:
        """The Taylor polynomials of the solution from a state, by Newton's method: each round knows
        twice as many coefficients.

        What a round adds to the known polynomials satisfies the linearized equation exactly, up to
        twice the order.
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
                pull = arb_mat(n, 1, [_term(rate, k - 1) for rate in rates])
                for slope, more in zip(by_state, reversed(added), strict=False):
                    pull += slope * more
                following = [row[k - 1] / k for row in rows[n:]] + [
                    value / k for value in pull.entries()
                ]
                added.append(arb_mat(m, 1, following))
                for row, value in zip(rows, following, strict=True):
                    row.append(value)
        return [arb_series(row, prec=order + 1) for row in rows]

    def fundamental(self, within: Numbers, order: int, step: arb) -> arb_mat:
        """The Taylor polynomial of the derivative of the flow at the end of a step."""
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
            # Speeds are the derivatives of positions: the upper half of the next one is the lower
            # half of this.
            parts.append(
                arb_mat(m, m, parts[k].entries()[n * m :] + total.entries()) * (arb(1) / (k + 1))
            )
        return reduce(lambda found, part: found * step + part, reversed(parts))


def _term(value: arb | arb_series, k: int) -> arb | int:
    return value[k] if isinstance(value, arb_series) else (value if k == 0 else 0)


def polynomial(series: arb_series, t: arb) -> arb:
    """A Taylor polynomial at a time."""
    return arb_poly(series.coeffs())(t)


def ball_about_zero(radius: arb | float) -> arb:
    """The ball about 0 that holds ±radius."""
    return arb(0, arb(radius).abs_upper())


def most(values: Numbers) -> arb:
    """A bound on the largest."""
    return reduce(arb.max, values).abs_upper()
