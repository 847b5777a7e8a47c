"""The proof of a cycle in balls: it runs as a process of its own, since python-flint's precision is
one for all threads.

``python -m spragsym.orbits.ball_proof`` reads a claim as JSON from standard input and writes what
was proved to standard output.
"""

import json
import math
import sys
from fractions import Fraction
from typing import Any

import numpy as np
from flint import acb_mat, arb, arb_mat

from ..core.errors import ParameterError
from ..models.field import Field, exact_field
from .ball_flow import (
    XP,
    Accuracy,
    Balls,
    NotProved,
    Numbers,
    Smooth,
    TooWide,
    ball_about_zero,
    bits,
    polynomial,
)


def shown(field: Field, claim: dict[str, Any]) -> dict[str, Any]:
    """Proved parts of a claim: where its digits leave the box of starts too wide, with more of
    them, up to 25.
    """
    digits = claim["digits"]
    # Digits up to which more of them are tried than were asked for.
    enough = 25
    while True:
        try:
            with bits(accuracy_for(digits).bits):
                return {"digits": digits, **proved(field, claim | {"digits": digits})}
        except TooWide as reason:
            if digits >= enough:
                raise NotProved(
                    f"{reason} (of half width 1e-{digits}); give more digits"
                ) from reason
            digits = min(math.ceil(1.5 * digits), enough)


def proved(field: Field, claim: dict[str, Any]) -> dict[str, Any]:
    """Proved parts of a claim, all numbers exactly, as :func:`spoken`; within the bits of
    :func:`accuracy_for`.
    """
    digits = claim["digits"]
    # The derivative of the flow is carried as accurately as for so many digits, however many the
    # orbit has.
    slope_digits = 60
    radius, fine = 10.0**-digits, accuracy_for(digits)
    rough = accuracy_for(min(digits, slope_digits))
    slopes, n = np.array(claim["slopes"]), len(field.coordinates)
    moved = [i for i in range(field.size) if i != n]
    # A derivative of the return that is as nearly singular as this is that of a fold: Newton's
    # method has nothing to stand on.
    nearly_singular = 1e-14
    sizes = np.linalg.svd(slopes, compute_uv=False)
    if not sizes[-1] > nearly_singular * sizes[0]:
        raise NotProved(
            "a second multiplier is 1 or nearly so: at a fold, or where branches meet, no "
            "cycle is alone"
        )
    inverse = arb_mat(np.linalg.inv(slopes).tolist())
    mode = field.exact(field.initial_mode(claim["state"], field.constants(claim["values"])))
    begun = Smooth(
        field, list(field.constants([arb(value) for value in claim["values"]], XP)), mode
    )
    state, period, times = _refined(begun, claim, inverse, moved)

    start = [arb(0, radius) if i in moved else arb(0) for i in range(field.size)]
    balls = Balls(begun, fine, rough, [value.mid() for value in state], begun.filled(0) + 1, start)
    clock = arb(0)
    for index, time in times:
        # Half of the window in which a border is crossed, before the states tell, in units of the
        # radius of the starts.
        window_radii = 1e5
        # Half of it at most.
        half = arb(min(radius * window_radii, 1e-6))
        for _ in range(2):  # the states tell how wide the window need be once they are near
            before = (time - half).mid()
            if before > clock:
                balls.carry(before - clock)
                clock = before
            if not time > clock:
                raise NotProved(
                    "two borders are crossed so soon after each other that their windows of "
                    f"{2 * float(half.mid()):.1e} meet"
                )
            # Twice the time in which what happens there happens.
            near = 2 * balls.apart(index)
            if not near < half:
                break
            half = arb(float(near.mid()))
        window = (2 * (time - clock)).mid()
        balls.cross(index, window)
        clock += window
    if not period > clock:
        raise NotProved("a border is crossed where the orbit begins and ends; begin it elsewhere")
    balls.carry(period - clock)  # no rounding so far: it refuses a time that is not exact
    if balls.smooth.mode != mode:
        raise NotProved("the motion does not come back in the smooth piece in which it began")
    return _krawczyk(balls, state, period, radius, inverse, moved)


def accuracy_for(digits: int) -> Accuracy:
    """With what a proof to ``digits`` digits works: beyond those, room for what an orbit magnifies.

    Steps are a seventh of the radius of convergence, so that an order gives 0.845 digits.
    """
    return Accuracy(math.ceil(1.3 * digits) + 18, math.ceil(3.33 * (1.2 * digits + 45)))


# ------------------------------------------------------------------------------ the orbit to many
# digits, not yet proved


def _refined(
    begun: Smooth, claim: dict[str, Any], inverse: arb_mat, moved: list[int]
) -> tuple[Numbers, arb, list[tuple[int, arb]]]:
    """State, period and crossing times to the digits of the proof, by Newton's method with a fixed
    slope.

    Each round works with as many digits as it may gain.
    """
    digits = claim["digits"]
    state = [arb(value) for value in claim["state"]]
    period = arb(claim["period"])
    # Exactly: the section is where the first coordinate is largest.
    state[len(begun.field.coordinates)] = arb(0)
    # Digits beyond those that are known, with which the next round works: what it gains.
    ahead = 12
    missed, slow, now = 1.0, 0, min(digits, 2 * ahead)
    # Rounds of Newton's method with the slopes of double precision.
    first_rounds = 14
    # Digits that each gains at least.
    for _ in range(first_rounds + digits // 6):
        with bits(accuracy_for(now).bits):
            end, times = _traced(begun, state, period, claim["crossings"], now)
        gaps = [(a - b).mid() for a, b in zip(end, state, strict=True)]
        steps = [step.mid() for step in (inverse * arb_mat([[gap] for gap in gaps])).entries()]
        for i, column in enumerate(moved):
            state[column] = (state[column] - steps[i]).mid()
        period = (period - steps[-1]).mid()
        before, missed = missed, max(_size(gap) for gap in gaps)
        if now == digits and (
            missed < 10.0 ** -(1.1 * digits + 6) or before < min(missed, 10.0 ** -(1.05 * digits))
        ):
            return state, period, times
        slow = slow + 1 if missed >= before / 3 else 0
        if slow > 1 or missed >= 1:
            break
        now = min(digits, max(now, math.ceil(ahead - math.log10(missed)) if missed else digits))
    raise NotProved(
        "Newton's method in many digits does not converge from the cycle as given: it stays "
        f"open by {missed:.1e}"
    )


def _size(value: arb) -> float:
    """A ball's middle in size; what is no number counts as infinite."""
    size = abs(float(value.mid()))
    return size if math.isfinite(size) else math.inf


def _traced(
    piece: Smooth, state: Numbers, period: arb, crossings: list[Any], digits: int
) -> tuple[Numbers, list[tuple[int, arb]]]:
    """The end of one round to many digits, and when it crosses which border; not rigorous."""
    clock, now, times, order = arb(0), state, [], accuracy_for(digits).order
    least = arb(10) ** -(1.1 * digits + 16)
    # A border that is crossed at less than this speed is touched.
    slowest = 1e-7
    for about, border in [*crossings, (period, -1)]:
        target = arb(about)
        if not target > clock:
            raise NotProved("two crossings can't be told apart in time")
        while True:
            jets = piece.solution(now, order)
            size = max(abs(jet[order]).mid() for jet in jets)
            reach = (
                min(0.5 * float(((least / size) ** (arb(1) / order)).mid()), 1.0)
                if size > 0
                else 1.0
            )
            left = (target - clock).mid()
            if float(left) <= reach:
                break
            now = [polynomial(jet, arb(reach)).mid() for jet in jets]
            clock = (clock + arb(reach)).mid()
        if border >= 0:
            that, begun = piece.field.borders[border], left
            uncrossed = (
                f"in many digits the orbit does not cross {that.name} near t = {about:.6g}, "
                "where the cycle is said to: none "
                "like it was found at these parameters"
            )
            for _ in range(10):
                there = [polynomial(jet, left).mid() for jet in jets]
                change, level = piece.level_rate(that, there), piece.level(that, there)
                if not abs(change) > slowest:
                    raise NotProved(
                        f"{that.name} is touched, or crossed at hardly any speed: next to a "
                        "grazing the return has no derivative "
                        "to stand on; move a parameter"
                        if abs(level) < slowest
                        else uncrossed
                    )
                left = (left - level / change).mid()
                if not abs(left - begun) < 0.1:
                    raise NotProved(uncrossed)
        now = [polynomial(jet, left).mid() for jet in jets]
        clock = (clock + left).mid()
        if border >= 0:
            # To the last bit of the period, no more: so that times from one crossing to the next
            # are exact.
            times.append((border, (clock + period).mid() - period))
            piece = piece.beyond(border)
    return now, times


# ------------------------------------------------------------------------------------------------
# the theorem


def _krawczyk(
    balls: Balls, state: Numbers, period: arb, radius: float, inverse: arb_mat, moved: list[int]
) -> dict[str, Any]:
    """Krawczyk's operator on the return after a period, in the moved parts of the start and the
    period.
    """
    near = [value + ball_about_zero(1e-6) for value in balls.box]
    balls.keeps_clear(near)
    rates = [arb(rate) for rate in balls.smooth.rates(near)]
    if not all(abs(rate) * radius < 1e-6 for rate in rates):
        raise NotProved("the period's ball is too wide")
    # Over the ball of the period the derivative of the flow changes by no more than this share.
    share = ((balls.smooth.steepness(near) * radius).exp() - 1).abs_upper()
    rows = balls.matrix.tolist()
    sizes = [sum(value.abs_upper() for value in column) for column in zip(*rows, strict=True)]
    monodromy = [
        [value + ball_about_zero(share * size) for value, size in zip(row, sizes, strict=True)]
        for row in rows
    ]
    slopes = [
        [*(row[j] - int(i == j) for j in moved), rate]
        for i, (row, rate) in enumerate(zip(monodromy, rates, strict=True))
    ]
    gaps = [[value - begun] for value, begun in zip(balls.point, state, strict=True)]
    inside = [
        correction.abs_upper() + sum(value.abs_upper() for value in row) * radius
        for correction, row in zip(
            (inverse * arb_mat(gaps)).entries(),
            (1 - inverse * arb_mat(slopes)).tolist(),
            strict=True,
        )
    ]
    if not all(value < radius for value in inside):
        worst = max(float((value / radius).mid()) for value in inside)
        raise TooWide(
            f"Newton's operator does not map the box into itself: {worst:.3g} times its size"
        )
    return {
        "state": [spoken(value) for value in state],
        "period": spoken(period),
        "error": max((spoken(value.upper()) for value in inside), key=Fraction),
        **_multipliers(monodromy),
    }


def _multipliers(monodromy: list[list[arb]]) -> dict[str, Any]:
    """Balls that hold the eigenvalues, the trivial one first, and whether all others are inside of
    the unit circle.
    """
    try:
        eigenvalues = acb_mat(monodromy).eig()
    except (ValueError, ArithmeticError):
        eigenvalues = []
    trivial = [value for value in eigenvalues if (value - 1).contains(0)]
    others = [value for value in eigenvalues if not (value - 1).contains(0)]
    others.sort(key=lambda value: (-float(abs(value).mid()), -float(value.imag.mid())))
    inside = all(abs(value) < 1 for value in others)
    outside = any(abs(value) > 1 for value in others)
    return {
        "multipliers": [
            [
                spoken(value.real),
                spoken(value.imag),
                max(spoken(value.real, "rad"), spoken(value.imag, "rad"), key=Fraction),
            ]
            for value in [*trivial, *others]
        ],
        "stable": inside if len(trivial) == 1 and (inside or outside) else None,
    }


def spoken(value: arb, part: str = "mid") -> str:
    """The middle (or the radius) of a ball, every bit of it, as a fraction in text."""
    mantissa, exponent = (int(number) for number in getattr(value, part)().man_exp())
    return str(Fraction(mantissa) * Fraction(2) ** exponent)


def main() -> None:
    """Read a claim, write what was proved or why not."""
    claim = json.load(sys.stdin)
    try:
        found = {"proved": True, **shown(exact_field(claim["field"]), claim)}
    except (NotProved, ParameterError) as reason:
        found = {"proved": False, "reason": str(reason)}
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main()
