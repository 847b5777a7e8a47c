"""Claims about every point of a box of parameters, and of units of measure that have tolerances
too, by closed forms.

For each claim there is a proof for many boxes, over every direction of the spring, which are cut
into cells until decided; and a search for counterexamples.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ..bifurcation.paths import first_end
from ..core.questions import NotInClosedForm
from ..design.certificates import Claim, ProvedParts, corner_values
from ..generated import catastrophe as _catastrophe
from ..models.parameters import FloatArray, ParameterSet
from ..models.quantities import Unit, checked_units
from ..numerics.affine import Affine, Rounded, cosine_and_sine, sides
from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import HALF_TURN, BoolArray, quiet
from ..results import EquilibriumType
from . import kernel
from .jump_values import first_jumps, point_at, require_usual, with_and_without_friction
from .parameters import NAMES, Parameters
from .quartic.solver import count, equilibria


def claims(
    corners: tuple[Parameters, Parameters],
    claim: str,
    *,
    vary: str | None = None,
    begin: float | None = None,
    units: Mapping[str, Unit] | None = None,
) -> ClosedClaim:
    """The closed form of :func:`spragsym.design.tube_certificates.claims`, for friction that rises.

    Notes
    -----
    Source: f, f′ and the eigenvalues of K over boxes, in affine arithmetic with every rounding
    bounded. A box that touches the border of the claim, a fold or an onset of flutter, can't be
    decided there.
    """
    low, high = corners
    require_usual(low, "mu0", begin)
    measures = checked_units(units, tuple(Parameters.ranges), ("theta0",))
    powers = [one for unit in measures.values() for one in unit.powers.items() if one[0] in NAMES]
    whole = all(name != "mu0" and power == int(power) for name, power in powers)
    if (
        claim not in CLAIMS
        or not whole
        or not (vary is None or (vary == "mu0" and claim == "no jump"))
    ):
        raise NotInClosedForm
    return ClosedClaim(low, high, claim, measures)


#: Of which boxes something is proved, and how much each side matters for the others.
Proved: TypeAlias = tuple[BoolArray, FloatArray]


class ClosedClaim(Claim):
    """One of the claims of :data:`CLAIMS`."""

    batch, most, corners = 2048, 20_000, 512
    whole: ParameterBoxes
    #: Of which model a counterexample is.
    kind: type[ParameterSet] = Parameters

    def __init__(
        self, low: Parameters, high: Parameters, claim: str, units: Mapping[str, Unit]
    ) -> None:
        self.prove, self.false = CLAIMS[claim]
        matter = {name: unit for name, unit in units.items() if set(unit.powers) & set(NAMES)}
        self.sides = (*NAMES, *matter)
        ends = corner_values(NAMES, low, high, matter)
        if claim == "no jump":  # what goes on to the largest friction goes on to every other
            ends[0][NAMES.index("mu0")] = ends[1][NAMES.index("mu0")]
        self.whole = ParameterBoxes(ends[0], ends[1], np.zeros(1, dtype=bool), matter)

    def settled(self, parts: ParameterBoxes) -> tuple[ParameterBoxes, FloatArray]:
        holds, weight = self.prove(parts)
        width = parts.high - parts.low
        matters = ((width > 0) & (weight > 0)).any(axis=0)
        # The widest where none is known to matter.
        return replace(parts, holds=holds), np.where(
            matters, weight, width / np.maximum(parts.high, 1e-300)
        )

    def point(self, values: FloatArray) -> ParameterSet:
        return self.kind(**self.whole.parameters(values))

    def fails(self, points: FloatArray) -> BoolArray:
        return self.false(Parameters(**self.whole.parameters(points)))


_MU0 = NAMES.index("mu0")


# -----------------------------------------------------------------------------------------------
# all states in contact


def _at_all_states(boxes: ParameterBoxes, slope_sign: int) -> Proved:
    """Every equilibrium in contact has f′ of a sign, or, where that is negative, a positive
    discriminant of K in λ².

    All have f′ > 0: of three the middle one has not, and of two that meet neither has, so there is
    one. All have f′ < 0, which is divergence, or a positive discriminant: there is no flutter.
    """

    def test(ground: Ground) -> Verdict:
        value, slope, _, _ = ground.balance()
        done = (value.sign() != 0) | (slope.sign() == slope_sign) | (ground.pressed().sign() < 0)
        if slope_sign > 0:
            return done, (value, slope)
        mu0, _, *springs = ground.others()
        flutter = kernel.invariants(ground.c, ground.s, ground.length(), mu0, *springs, 1)[2]
        return done | (flutter.sign() > 0), (value, slope, flutter)

    # Beyond π no direction is in contact.
    return covered(boxes, constant(0.0, boxes), constant(HALF_TURN, boxes), test)


# ------------------------------------------------------------------------------------------------
# no jump


def _no_jump(boxes: ParameterBoxes) -> Proved:
    """On the surface μ₀(θ) rises from below 0 at one direction to above the largest friction at
    another, and is 0 once between, at the reference state: so that is followed without a fold.

    Candidates for the two directions come from the middle of a box, and the proof does not depend
    on how.
    """
    result, weight = np.zeros(len(boxes), dtype=bool), np.zeros_like(boxes.low)
    # How far a trial direction lies from the state it stands for, in units of how far that
    # state moves within the box: the wide one leaves room for terms of second order, the
    # narrow one is for boxes near a fold.
    for margin in (0.7, 0.25):
        open_ = np.flatnonzero(~result)
        if open_.size:
            result[open_], weight[:, open_] = _followed_with(boxes[open_], margin)
    return result, weight


def _followed_with(boxes: ParameterBoxes, margin: float) -> Proved:
    with quiet():
        middle = boxes.middle() | {"mu0": boxes.high[_MU0]}
        *_, first, later, result = with_and_without_friction(middle)
        # A direction below the state at μ₀ = 0, one above it, and one above the state at the
        # largest friction.
        lowest, start = (
            _moved(boxes, middle | {"mu0": np.zeros_like(later)}, first[:, 0], side * margin)
            for side in (-1, 1)
        )
        highest = _moved(boxes, middle, later, margin)
        result &= (lowest.value - lowest.reach() > 0) & (highest.value + highest.reach() < math.pi)
    weight = np.zeros_like(boxes.low)
    for check in (_ends_hold, _friction_rises, _is_small):
        proved = np.flatnonzero(result)
        if proved.size:
            result[proved], weight[:, proved] = check(
                boxes[proved], lowest[proved], start[proved], highest[proved]
            )
    return result, weight


def _moved(
    boxes: ParameterBoxes, values: dict[str, FloatArray], theta: FloatArray, margin: float
) -> LinearDirection:
    """Shift of an equilibrium of the middle over the box, to first order, and a little to one side
    of that.
    """
    slopes = _change(boxes, values, theta)
    line = LinearDirection(theta, slopes)
    return LinearDirection(theta + margin * line.reach() + np.copysign(1e-9, margin), slopes)


def _change(
    boxes: ParameterBoxes,
    values: dict[str, Any],
    theta: FloatArray,
    term: Callable[[FloatArray], FloatArray] = np.positive,
) -> FloatArray:
    """Shift of an equilibrium by half of each side but μ₀, to first order: a unit changes all
    parameters that depend on it.

    With ``np.abs`` for a ``term`` the value if nothing cancelled.
    """
    c, s, c0, s0 = *kernel.cos_sin(theta), *kernel.cos_sin(values["theta0"])
    others = [values[name] for name in kernel.LINEAR]
    slope = kernel.f_slope(c, s, *kernel.f_coefficients(c0, s0, *others, 1))
    changes = _catastrophe.unfolding(c, s, c0, s0, *others)
    moved = boxes.parameters(sides(boxes.low, boxes.high))
    found = np.asarray(
        sum(
            term(-one / slope * moved[name].terms)
            for name, (one, _) in zip(NAMES, changes, strict=True)
        )
    )
    found[_MU0] = 0.0
    return found


def _ends_hold(
    boxes: ParameterBoxes, lowest: LinearDirection, start: LinearDirection, highest: LinearDirection
) -> Proved:
    """f < 0 at the lowest direction without friction, f > 0 at the highest one with the largest;
    both in contact.
    """
    result, weight = np.ones(len(boxes), dtype=bool), np.zeros_like(boxes.low)
    for line, friction, wanted in ((lowest, 0.0, -1), (highest, boxes.high[_MU0], 1)):
        ground = at(boxes, line).with_friction(friction)
        value, inside = ground.balance()[0], ground.pressed()
        holds, presses = value.sign() == wanted, inside.sign() > 0
        result &= holds & presses
        # A direction that follows the state leaves what is of second order, in each of the
        # parameters that a side changes.
        second = _change(boxes, boxes.middle() | {"mu0": friction}, line.value, np.abs)
        first = np.abs(inside.terms[:-1])
        straight = holds & ~presses & (first.sum(axis=0) > inside.error)
        weight = np.maximum(
            weight, np.where(straight, first / np.maximum(first.sum(axis=0), 1e-300), second**2)
        )
    return result, weight


def _friction_rises(
    boxes: ParameterBoxes, lowest: LinearDirection, start: LinearDirection, highest: LinearDirection
) -> Proved:
    """μ₀(θ) rises between the two directions: f′ f_μ₀ − f f_μ₀′ < 0, in which μ₀ cancels."""

    def test(ground: Ground) -> Verdict:
        value, slope, change, change_slope = ground.with_friction(0.0).balance()
        rise = slope * change - value * change_slope
        return rise.sign() < 0, (rise,)

    return covered(boxes, lowest, highest, test)


def _is_small(
    boxes: ParameterBoxes, lowest: LinearDirection, start: LinearDirection, highest: LinearDirection
) -> Proved:
    """The state at μ₀ = 0 between ``lowest`` and ``start`` has the smallest \\|x\\|.

    Without friction at most one equilibrium has cos θ of the sign of cos θ₀, and any other has
    \\|x\\| ≥ \\|cos θ₀\\|: see ``smallest_without_friction`` in derive/kang_nam/theorem.py. So L
    \\|cos θ\\| < 2 \\|cos θ₀\\| is enough, or that there is no other.
    """
    ground = at(boxes, start).with_friction(0.0)
    above, side = ground.balance()[0].sign() > 0, ground.c0.sign()
    ground = at(boxes, lowest.where(side > 0, start))
    reach = 2 * ground.c0 - ground.length() * ground.c
    is_opposite = at(boxes, start.where(side > 0, lowest)).c.sign() * side > 0
    result = above & is_opposite & (side != 0) & (reach.sign() * side > 0)
    open_ = np.flatnonzero(above & ~result)
    if open_.size:
        open_boxes = boxes[open_]
        below = _alone(open_boxes, constant(0.0, open_boxes), lowest[open_])
        result[open_] = below & _alone(open_boxes, start[open_], constant(HALF_TURN, open_boxes))
    return result, np.abs(reach.terms[:-1])


def _alone(boxes: ParameterBoxes, low: LinearDirection, high: LinearDirection) -> BoolArray:
    """No equilibrium in contact without friction between two directions."""

    def test(ground: Ground) -> Verdict:
        value = ground.with_friction(0.0).balance()[0]
        return (value.sign() != 0) | (ground.pressed().sign() < 0), (value,)

    return covered(boxes, low, high, test)[0]


def _jumps(p: Parameters) -> BoolArray:
    """The first of some points whose state jumps below its friction, by its path too."""
    found = np.zeros(p.shape, dtype=bool)
    for i in np.flatnonzero(first_jumps(p, "mu0", sides=True).value < p.mu0 * (1 - 1e-11))[:1]:
        point = Parameters(**point_at({name: p[name] for name in NAMES}, i))
        found[i] = first_end(point, "mu0", (0.0, float(point.mu0))) is not None
    return found


#: For each claim, of which boxes it is proved; and at which points it is false.
CLAIMS: dict[str, tuple[Callable[[ParameterBoxes], Proved], Callable[[Parameters], BoolArray]]] = {
    "no jump": (_no_jump, _jumps),
    "one equilibrium": (partial(_at_all_states, slope_sign=1), lambda p: count(p) == 3),
    "no flutter": (
        partial(_at_all_states, slope_sign=-1),
        lambda p: (equilibria(p).undamped == EquilibriumType.FLUTTER).any(axis=-1),
    ),
}


@dataclass(frozen=True)
class ParameterBoxes(ProvedParts):
    """Parts of a box of parameters, in the order of ``NAMES``, and then of units of measure over
    their base values.
    """

    units: Mapping[str, Unit]

    def parameters(self, sides: Iterable[Any]) -> dict[str, Any]:
        """Parameters by name from one value of each side, of any number type."""
        found = dict(zip((*NAMES, *self.units), sides, strict=True))
        for unit in self.units:
            for name, power in self.units[unit].powers.items():
                if name in NAMES:
                    factor = found[unit] ** abs(int(power))
                    found[name] = found[name] * factor if power > 0 else found[name] / factor
        return {name: found[name] for name in NAMES}

    def middle(self) -> dict[str, FloatArray]:
        """Their middles, by parameter."""
        return self.parameters(0.5 * (self.low + self.high))


class Ground(NamedTuple):
    """Means by which a claim is tested: cos θ, sin θ, cos θ₀, sin θ₀ and the parameters, over cells
    or at one θ of each box.
    """

    c: Affine
    s: Affine
    c0: Affine
    s0: Affine
    parameters: dict[str, Rounded]

    def others(self) -> list[Rounded]:
        """The parameters but θ₀, in order."""
        return [self.parameters[name] for name in kernel.LINEAR]

    def with_friction(self, mu0: FloatArray | float) -> Ground:
        """The same with another friction, or one for each box."""
        return self._replace(parameters=self.parameters | {"mu0": Rounded(mu0)})

    def balance(self) -> tuple[Affine, Affine, Affine, Affine]:
        """f, f′, f_μ₀ and f_μ₀′."""
        return kernel.f_in_differences(*self[:4], *self.others())

    def pressed(self) -> Rounded:
        """κ − σ (sin θ₀ − sin θ), which is positive where the state of a direction has y < 0."""
        return self.parameters["kappa"] - self.parameters["sigma"] * (self.s0 - self.s)

    def length(self) -> Affine:
        """L of the state of a direction."""
        return kernel.state_of(*self[:4], *self.others()[1:])[0]


@dataclass(frozen=True)
class LinearDirection(ByColumn):
    """A direction of the spring for each box that changes linearly over it: ``value`` in its
    middle, ``slopes`` to its sides.
    """

    value: FloatArray
    slopes: FloatArray

    def reach(self) -> FloatArray:
        """Largest distance from the value."""
        return np.abs(self.slopes).sum(axis=0)

    def where(self, mine: BoolArray, other: LinearDirection) -> LinearDirection:
        """This one for some boxes, another for the rest."""
        return LinearDirection(
            np.where(mine, self.value, other.value), np.where(mine, self.slopes, other.slopes)
        )


def constant(value: float, boxes: ParameterBoxes) -> LinearDirection:
    """One direction for all boxes."""
    return LinearDirection(np.full(len(boxes), value), np.zeros_like(boxes.low))


def at(boxes: ParameterBoxes, line: LinearDirection) -> Ground:
    """One direction for each point of each box."""
    none = np.zeros(len(boxes))
    return over(boxes, line, line, none, none)


def over(
    boxes: ParameterBoxes,
    low: LinearDirection,
    high: LinearDirection,
    begin: FloatArray,
    end: FloatArray,
) -> Ground:
    """All directions between two, from one share of the way to another."""
    none = np.zeros_like(begin)
    *own, share = sides(np.vstack([boxes.low, begin]), np.vstack([boxes.high, end]))
    base = Affine(low.value, np.vstack([low.slopes, none]), none)
    way = Affine(high.value, np.vstack([high.slopes, none]), none) - base
    theta = base + share * way
    return Ground(*cosine_and_sine(theta), *cosine_and_sine(own[0]), boxes.parameters(own))


#: Which cells are decided, and the quantities whose terms say which side of a box to cut where one
#: is not.
Verdict: TypeAlias = tuple[BoolArray, tuple[Rounded, ...]]


def covered(
    boxes: ParameterBoxes,
    low: LinearDirection,
    high: LinearDirection,
    test: Callable[[Ground], Verdict],
) -> Proved:
    """The boxes for which all directions between two pass a test, and how much each side matters
    for the others.
    """
    size = len(boxes)
    weight = np.zeros_like(boxes.low)
    # Cells of a box to begin with.
    cells = 4
    box = np.tile(np.arange(size), cells)
    begin = np.repeat(np.arange(cells) / cells, size)
    end = begin + 1.0 / cells
    result = np.ones(size, dtype=bool)
    # How often one is halved, at most.
    halvings = 40
    for halving in range(halvings + 1):
        if not box.size:
            break
        with quiet():
            decided, decisive = test(over(boxes[box], low[box], high[box], begin, end))
        parts = [np.abs(np.nan_to_num(quantity.terms[:, ~decided])) for quantity in decisive]
        # A box is given up where the spread of an open quantity comes from its own
        # sides: the direction adds less than this share.
        useful = [part[-1] > 0.25 * part[:-1].sum(axis=0) for part in parts]
        # Cells are halved so often in any case.
        useless = ~np.logical_or.reduce(useful) & (halving >= 4)
        abandoned = useless | (halving == halvings)
        box, begin, end = box[~decided], begin[~decided], end[~decided]
        for part in parts:
            sizes = part[:-1, abandoned]
            np.maximum.at(
                weight.T, box[abandoned], (sizes / np.maximum(sizes.sum(axis=0), 1e-300)).T
            )
        result[box[abandoned]] = False
        # A box with many open cells fails on a stretch of directions, and not at one: no cut of it
        # helps.
        # Open cells with which a box is given up.
        result[np.bincount(box, minlength=size) > 64] = False
        keep = result[box]
        box, begin, end = box[keep], begin[keep], end[keep]
        middle = 0.5 * (begin + end)
        box = np.tile(box, 2)
        begin = np.concatenate([begin, middle])
        end = np.concatenate([middle, end])
    return result, weight
