"""Computer-assisted proof of a cycle in ball arithmetic, by Krawczyk's operator of the return map.

A box of initial states on the section x' = 0 is integrated rigorously over the period
(:mod:`.ball_flow`). If Krawczyk's operator maps the box of states and periods into itself, there is
exactly one cycle in it (:func:`_krawczyk`). Before that, the approximate cycle is refined to the
digits of the proof, without rigour (:func:`_refined`).

``python -m spragsym.orbits.ball_proof`` reads a claim as JSON from standard input and writes the
result to standard output. It is a process of its own because python-flint has one precision for all
threads.
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
    """Prove a claim: with the requested digits or, if the box is too wide, with more, up to 25."""
    digits = claim["digits"]
    most_digits = 25
    while True:
        try:
            with bits(accuracy_for(digits).bits):
                return {"digits": digits, **proved(field, claim | {"digits": digits})}
        except TooWide as reason:
            if digits >= most_digits:
                raise NotProved(
                    f"{reason} (of half width 1e-{digits}); give more digits"
                ) from reason
            digits = min(math.ceil(1.5 * digits), most_digits)


def proved(field: Field, claim: dict[str, Any]) -> dict[str, Any]:
    """Prove a claim with its digits: the result of :func:`_krawczyk`.

    To be called with the precision of :func:`accuracy_for`. Raises NotProved with the reason, or
    TooWide if a smaller box may succeed.
    """
    digits = claim["digits"]
    # The derivative of the flow never needs more than 60 digits.
    radius, fine, rough = 10.0**-digits, accuracy_for(digits), accuracy_for(min(digits, 60))
    slopes, n = np.array(claim["slopes"]), len(field.coordinates)
    moved = [i for i in range(field.size) if i != n]
    sizes = np.linalg.svd(slopes, compute_uv=False)
    if not sizes[-1] > 1e-14 * sizes[0]:
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
        # Half-width of the window in which all states cross the border: first a generous one; once
        # the states are near the border, twice the time between their arrivals.
        half = arb(min(radius * 1e5, 1e-6))
        for _ in range(2):
            before = (time - half).mid()
            if before > clock:
                balls.carry(before - clock)
                clock = before
            if not time > clock:
                raise NotProved(
                    "two borders are crossed so soon after each other that their windows of "
                    f"{2 * float(half.mid()):.1e} meet"
                )
            narrower = 2 * balls.apart(index)
            if not narrower < half:
                break
            half = arb(float(narrower.mid()))
        window = (2 * (time - clock)).mid()
        balls.cross(index, window)
        clock += window
    if not period > clock:
        raise NotProved("a border is crossed where the orbit begins and ends; begin it elsewhere")
    balls.carry(period - clock)  # the difference is exact
    if balls.smooth.mode != mode:
        raise NotProved("the motion does not come back in the smooth piece in which it began")
    return _krawczyk(balls, state, period, radius, inverse, moved)


def accuracy_for(digits: int) -> Accuracy:
    """Order and precision for a proof to a number of digits, with a reserve for the growth of
    deviations along the orbit.

    Steps are a seventh of the radius of convergence, so that each order gives 0.845 digits.
    """
    return Accuracy(math.ceil(1.3 * digits) + 18, math.ceil(3.33 * (1.2 * digits + 45)))


def _refined(
    begun: Smooth, claim: dict[str, Any], inverse: arb_mat, moved: list[int]
) -> tuple[Numbers, arb, list[tuple[int, arb]]]:
    """State, period and crossing times of the cycle to the digits of the proof; not rigorous.

    Simplified Newton's method with the fixed ``inverse`` of the Jacobian in double precision, for
    the components ``moved`` of the state and the period. Each iteration uses as many digits as it
    can gain.
    """
    digits = claim["digits"]
    state = [arb(value) for value in claim["state"]]
    period = arb(claim["period"])
    state[len(begun.field.coordinates)] = arb(0)  # the section x' = 0, exactly
    # An iteration gains up to 12 digits.
    gain = 12
    gap, slow, working = 1.0, 0, min(digits, 2 * gain)
    for _ in range(14 + digits // 6):
        with bits(accuracy_for(working).bits):
            end, times = _traced(begun, state, period, claim["crossings"], working)
        gaps = [(a - b).mid() for a, b in zip(end, state, strict=True)]
        steps = [step.mid() for step in (inverse * arb_mat([[each] for each in gaps])).entries()]
        for i, column in enumerate(moved):
            state[column] = (state[column] - steps[i]).mid()
        period = (period - steps[-1]).mid()
        previous, gap = gap, max(_size(each) for each in gaps)
        if working == digits and (
            gap < 10.0 ** -(1.1 * digits + 6) or previous < min(gap, 10.0 ** -(1.05 * digits))
        ):
            return state, period, times
        slow = slow + 1 if gap >= previous / 3 else 0
        if slow > 1 or gap >= 1:
            break
        known = math.ceil(gain - math.log10(gap)) if gap else digits
        working = min(digits, max(working, known))
    raise NotProved(
        "Newton's method in many digits does not converge from the cycle as given: it stays "
        f"open by {gap:.1e}"
    )


def _size(value: arb) -> float:
    """Absolute value of a ball's midpoint, infinite if it is not finite."""
    size = abs(float(value.mid()))
    return size if math.isfinite(size) else math.inf


def _traced(
    piece: Smooth, state: Numbers, period: arb, crossings: list[Any], digits: int
) -> tuple[Numbers, list[tuple[int, arb]]]:
    """The state after one period to many digits, and the crossings as (index of the border, time);
    not rigorous.

    ``crossings`` are approximate: (time, index). Each is located by Newton's method.
    """
    clock, now, times, order = arb(0), state, [], accuracy_for(digits).order
    smallest = arb(10) ** -(1.1 * digits + 16)
    # Rate of a level below which the border counts as only touched.
    slowest = 1e-7
    for about, border in [*crossings, (period, -1)]:
        target = arb(about)
        if not target > clock:
            raise NotProved("two crossings can't be told apart in time")
        while True:
            jets = piece.solution(now, order)
            last = max(abs(jet[order]).mid() for jet in jets)
            step = 1.0
            if last > 0:
                step = min(0.5 * float(((smallest / last) ** (arb(1) / order)).mid()), 1.0)
            left = (target - clock).mid()
            if float(left) <= step:
                break
            now = [polynomial(jet, arb(step)).mid() for jet in jets]
            clock = (clock + arb(step)).mid()
        if border >= 0:
            that, guess = piece.field.borders[border], left
            uncrossed = (
                f"in many digits the orbit does not cross {that.name} near t = {about:.6g}, "
                "where the cycle is said to: none "
                "like it was found at these parameters"
            )
            for _ in range(10):
                there = [polynomial(jet, left).mid() for jet in jets]
                rate, level = piece.level_rate(that, there), piece.level(that, there)
                if not abs(rate) > slowest:
                    if abs(level) < slowest:
                        raise NotProved(
                            f"{that.name} is touched, or crossed at hardly any speed: next to a "
                            "grazing the return has no derivative to stand on; move a parameter"
                        )
                    raise NotProved(uncrossed)
                left = (left - level / rate).mid()
                if not abs(left - guess) < 0.1:
                    raise NotProved(uncrossed)
        now = [polynomial(jet, left).mid() for jet in jets]
        clock = (clock + left).mid()
        if border >= 0:
            # Rounded to the last bit of the period, so that differences of times are exact.
            times.append((border, (clock + period).mid() - period))
            piece = piece.beyond(border)
    return now, times


def _krawczyk(
    balls: Balls, state: Numbers, period: arb, radius: float, inverse: arb_mat, moved: list[int]
) -> dict[str, Any]:
    """Krawczyk's test for the cycle, in the components ``moved`` of the state and the period.

    ``balls`` is the box of ``radius`` around ``state`` after one ``period``. With Y the approximate
    ``inverse`` of the Jacobian J, the box contains exactly one cycle if
    |Y · gap| + |1 − Y J| · radius < radius in every component. Returns state, period, error bound,
    multipliers and stability, all numbers as :func:`spoken`; raises TooWide otherwise.
    """
    near = [value + ball_about_zero(1e-6) for value in balls.box]
    balls.keeps_clear(near)
    rates = [arb(rate) for rate in balls.smooth.rates(near)]
    if not all(abs(rate) * radius < 1e-6 for rate in rates):
        raise NotProved("the period's ball is too wide")
    # Relative change of the derivative of the flow over the ball of periods.
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
    """Balls that contain the multipliers, as (real, imaginary, radius), the trivial one first; and
    ``stable``: all others inside the unit circle, one outside, or None if not decided.
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
    multipliers = []
    for value in [*trivial, *others]:
        radius = max(spoken(value.real, "rad"), spoken(value.imag, "rad"), key=Fraction)
        multipliers.append([spoken(value.real), spoken(value.imag), radius])
    decided = len(trivial) == 1 and (inside or outside)
    return {"multipliers": multipliers, "stable": inside if decided else None}


def spoken(value: arb, part: str = "mid") -> str:
    """Midpoint ("mid") or radius ("rad") of a ball, exactly, as the text of a fraction."""
    mantissa, exponent = (int(number) for number in getattr(value, part)().man_exp())
    return str(Fraction(mantissa) * Fraction(2) ** exponent)


def main() -> None:
    """Read a claim from standard input; write the proof, or the reason why there is none."""
    claim = json.load(sys.stdin)
    try:
        found = {"proved": True, **shown(exact_field(claim["field"]), claim)}
    except (NotProved, ParameterError) as reason:
        found = {"proved": False, "reason": str(reason)}
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main()
