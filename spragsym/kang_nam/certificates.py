"""Claims about all points of a box of parameters, and of units of measure with tolerances, proved
by closed forms.

For each claim there is a proof for many boxes at once, by branch and bound over the directions of
the spring in affine arithmetic, and a search for counterexamples.
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
from ..generated.quantities import PARAMETERS
from ..models.parameters import FloatArray, ParameterSet
from ..models.quantities import Unit, checked_units
from ..numerics.affine import Affine, Rounded, cosine_and_sine, sides
from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import HALF_TURN, BoolArray, quiet
from ..results import EquilibriumType
from . import kernel
from .jump_values import first_jumps, point_at, require_usual, with_and_without_friction
from .parameters import Parameters
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
    powers = [
        one for unit in measures.values() for one in unit.powers.items() if one[0] in PARAMETERS
    ]
    whole = all(name != "mu0" and power == int(power) for name, power in powers)
    if (
        claim not in CLAIMS
        or not whole
        or (claim == "stable" and not min(low.scalars("mu0", "V", "d")) > 0)  # nothing damps
        or not (vary is None or (vary == "mu0" and claim == "no jump"))
    ):
        raise NotInClosedForm
    return ClosedClaim(low, high, claim, measures)


#: For each box whether the claim is proved; and weights that say which side of another to cut.
Proved: TypeAlias = tuple[BoolArray, FloatArray]


class ClosedClaim(Claim):
    """A claim of :data:`CLAIMS` about a box."""

    batch, most, corners = 2048, 20_000, 512
    whole: ParameterBoxes
    kind: type[ParameterSet] = Parameters  #: class of a counterexample

    def __init__(
        self, low: Parameters, high: Parameters, claim: str, units: Mapping[str, Unit]
    ) -> None:
        self.prove, self.false = CLAIMS[claim]
        matter = {name: unit for name, unit in units.items() if set(unit.powers) & set(PARAMETERS)}
        self.sides = (*PARAMETERS, *matter)
        ends = corner_values(PARAMETERS, low, high, matter)
        if claim == "no jump":  # no jump up to the largest friction is none up to any other
            ends[0][_MU0] = ends[1][_MU0]
        self.whole = ParameterBoxes(ends[0], ends[1], np.zeros(1, dtype=bool), matter)

    def settled(self, parts: ParameterBoxes) -> tuple[ParameterBoxes, FloatArray]:
        holds, weight = self.prove(parts)
        width = parts.high - parts.low
        matters = ((width > 0) & (weight > 0)).any(axis=0)
        # Without weights the relative widths decide.
        return replace(parts, holds=holds), np.where(
            matters, weight, width / np.maximum(parts.high, 1e-300)
        )

    def point(self, values: FloatArray) -> ParameterSet:
        return self.kind(**self.whole.parameters(values))

    def fails(self, points: FloatArray) -> BoolArray:
        return self.false(Parameters(**self.whole.parameters(points)))


_MU0 = PARAMETERS.index("mu0")


# -----------------------------------------------------------------------------------------------
# all states in contact


def _at_all_states(
    boxes: ParameterBoxes, slope_sign: int, holds: Callable[[Ground], Rounded] | None = None
) -> Proved:
    """Whether something holds of every equilibrium in contact: f′ has the sign ``slope_sign``, or
    else ``holds`` is positive.

    All have f′ > 0: there is one equilibrium, since the middle one of three has f′ < 0, and at a
    fold f′ = 0. All have f′ < 0 (divergence) or a positive discriminant: there is no flutter.
    """

    def test(ground: Ground) -> Verdict:
        value, slope, _, _ = ground.balance()
        done = (value.sign() != 0) | (slope.sign() == slope_sign) | (ground.pressed().sign() < 0)
        if holds is None:
            return done, (value, slope)
        other = holds(ground)
        return done | (other.sign() > 0), (value, slope, other)

    # Directions in contact lie in (0, π).
    return covered(boxes, constant(0.0, boxes), constant(HALF_TURN, boxes), test)


def _discriminant(ground: Ground) -> Rounded:
    """The discriminant of (27) in λ²."""
    mu0, _, *springs = ground.others()
    flutter: Rounded = kernel.invariants(ground.c, ground.s, ground.length(), mu0, *springs, 1)[2]
    return flutter


def _all_stable(boxes: ParameterBoxes) -> Proved:
    """Whether every equilibrium in contact is stable with the damping of the friction law: det K >
    0, and cos θ > 0 or σ sin θ cos θ + μ₀ L < 0, by ``derive/kang_nam/routh.py``.

    With det K > 0 everywhere there is one state. ``boxes`` have μ₀ > 0.
    """

    def test(ground: Ground) -> Verdict:
        value, slope, _, _ = ground.balance()
        mu0, _, _, sigma, _ = ground.others()
        coupling = sigma * ground.s * ground.c + mu0 * ground.length()
        stable = (slope.sign() > 0) & ((ground.c.sign() > 0) | (coupling.sign() < 0))
        done = (value.sign() != 0) | stable | (ground.pressed().sign() < 0)
        return done, (value, slope, coupling)

    return covered(boxes, constant(0.0, boxes), constant(HALF_TURN, boxes), test)


# ------------------------------------------------------------------------------------------------
# no jump


def _no_jump(boxes: ParameterBoxes) -> Proved:
    """Whether the reference state does not jump.

    It is proved that μ₀(θ) on the surface rises monotonically from below 0 at one direction to
    above the largest friction at another, and that the zero in between is the reference state: then
    that is followed without a fold. Candidates for the two directions are estimated at the middle
    of a box; the proof does not depend on the estimate.
    """
    result, weight = np.zeros(len(boxes), dtype=bool), np.zeros_like(boxes.low)
    # Distance of a trial direction from its state, relative to the shift of the state over the box:
    # the wide one leaves room for terms of second order, the narrow one is for boxes near a fold.
    for margin in (0.7, 0.25):
        open_ = np.flatnonzero(~result)
        if open_.size:
            result[open_], weight[:, open_] = _followed_with(boxes[open_], margin)
    return result, weight


def _followed_with(boxes: ParameterBoxes, margin: float) -> Proved:
    """The proof of :func:`_no_jump` with trial directions at a distance."""
    with quiet():
        middle = boxes.middle() | {"mu0": boxes.high[_MU0]}
        *_, first, later, result = with_and_without_friction(middle)
        # Directions below and above the state at μ₀ = 0, and above that at the largest friction.
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
    """A direction that follows an equilibrium over the box to first order, displaced to one side by
    the margin.
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
    """The first-order shift of an equilibrium by half of each side except μ₀.

    A unit changes all parameters that depend on it; with ``np.abs`` as ``term`` their contributions
    are added by size.
    """
    c, s, c0, s0 = *kernel.cos_sin(theta), *kernel.cos_sin(values["theta0"])
    others = [values[name] for name in kernel.LINEAR]
    slope = kernel.f_slope(c, s, *kernel.f_coefficients(c0, s0, *others, 1))
    changes = _catastrophe.unfolding(c, s, c0, s0, *others)
    moved = boxes.parameters(sides(boxes.low, boxes.high))
    found = np.asarray(
        sum(
            term(-one / slope * moved[name].terms)
            for name, (one, _) in zip(PARAMETERS, changes, strict=True)
        )
    )
    found[_MU0] = 0.0
    return found


def _ends_hold(
    boxes: ParameterBoxes, lowest: LinearDirection, start: LinearDirection, highest: LinearDirection
) -> Proved:
    """Whether f < 0 at the lowest direction without friction, f > 0 at the highest direction with
    the largest friction, and both are in contact.
    """
    result, weight = np.ones(len(boxes), dtype=bool), np.zeros_like(boxes.low)
    for line, friction, wanted in ((lowest, 0.0, -1), (highest, boxes.high[_MU0], 1)):
        ground = at(boxes, line).with_friction(friction)
        value, inside = ground.balance()[0], ground.pressed()
        holds, presses = value.sign() == wanted, inside.sign() > 0
        result &= holds & presses
        # Along a direction that follows the state, terms of second order remain.
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
    """Whether μ₀(θ) rises between the two directions: f′ f_μ₀ − f f_μ₀′ < 0, independent of μ₀."""

    def test(ground: Ground) -> Verdict:
        value, slope, change, change_slope = ground.with_friction(0.0).balance()
        rise = slope * change - value * change_slope
        return rise.sign() < 0, (rise,)

    return covered(boxes, lowest, highest, test)


def _is_small(
    boxes: ParameterBoxes, lowest: LinearDirection, start: LinearDirection, highest: LinearDirection
) -> Proved:
    """Whether the state at μ₀ = 0 between ``lowest`` and ``start`` has the smallest \\|x\\|.

    Without friction at most one equilibrium has cos θ of the sign of cos θ₀, and any other has
    \\|x\\| ≥ \\|cos θ₀\\|: see ``smallest_without_friction`` in derive/kang_nam/theorem.py. So L
    \\|cos θ\\| < 2 \\|cos θ₀\\| is sufficient, or that there is no other equilibrium.
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
    """Whether there is no equilibrium in contact, without friction, between two directions."""

    def test(ground: Ground) -> Verdict:
        value = ground.with_friction(0.0).balance()[0]
        return (value.sign() != 0) | (ground.pressed().sign() < 0), (value,)

    return covered(boxes, low, high, test)[0]


def _jumps(p: Parameters) -> BoolArray:
    """A mask of the first point whose state jumps below its friction, confirmed by its path."""
    found = np.zeros(p.shape, dtype=bool)
    for i in np.flatnonzero(first_jumps(p, "mu0", sides=True).value < p.mu0 * (1 - 1e-11))[:1]:
        point = Parameters(**point_at({name: p[name] for name in PARAMETERS}, i))
        found[i] = first_end(point, "mu0", (0.0, float(point.mu0))) is not None
    return found


#: For each claim its proof for boxes, and its counterexamples among points.
CLAIMS: dict[str, tuple[Callable[[ParameterBoxes], Proved], Callable[[Parameters], BoolArray]]] = {
    "no jump": (_no_jump, _jumps),
    "one equilibrium": (partial(_at_all_states, slope_sign=1), lambda p: count(p) == 3),
    "no flutter": (
        partial(_at_all_states, slope_sign=-1, holds=_discriminant),
        lambda p: (equilibria(p).undamped == EquilibriumType.FLUTTER).any(axis=-1),
    ),
    "stable": (_all_stable, lambda p: (equilibria(p)["growth_sign"] > 0).any(axis=-1)),
}


@dataclass(frozen=True)
class ParameterBoxes(ProvedParts):
    """Boxes of parameters, in the order of ``PARAMETERS``, and of units of measure over their base
    values.
    """

    units: Mapping[str, Unit]

    def parameters(self, sides: Iterable[Any]) -> dict[str, Any]:
        """Parameters by name from the values of all sides, in any number type."""
        found = dict(zip((*PARAMETERS, *self.units), sides, strict=True))
        for unit in self.units:
            for name, power in self.units[unit].powers.items():
                if name in PARAMETERS:
                    factor = found[unit] ** abs(int(power))
                    found[name] = found[name] * factor if power > 0 else found[name] / factor
        return {name: found[name] for name in PARAMETERS}

    def middle(self) -> dict[str, FloatArray]:
        """The midpoints, by parameter."""
        return self.parameters(0.5 * (self.low + self.high))


class Ground(NamedTuple):
    """cos θ, sin θ, cos θ₀, sin θ₀ and the parameters as affine forms, over cells or at one
    direction of each box.
    """

    c: Affine
    s: Affine
    c0: Affine
    s0: Affine
    parameters: dict[str, Rounded]

    def others(self) -> list[Rounded]:
        """The parameters except θ₀, in order."""
        return [self.parameters[name] for name in kernel.LINEAR]

    def with_friction(self, mu0: FloatArray | float) -> Ground:
        """The same with another friction, a number or an array over the boxes."""
        return self._replace(parameters=self.parameters | {"mu0": Rounded(mu0)})

    def balance(self) -> tuple[Affine, Affine, Affine, Affine]:
        """f, f′, f_μ₀ and f_μ₀′."""
        return kernel.f_in_differences(*self[:4], *self.others())

    def pressed(self) -> Rounded:
        """κ − σ (sin θ₀ − sin θ), which is positive if the state in a direction has y < 0."""
        return self.parameters["kappa"] - self.parameters["sigma"] * (self.s0 - self.s)

    def length(self) -> Affine:
        """L of the state in a direction."""
        return kernel.state_of(*self[:4], *self.others()[1:])[0]


@dataclass(frozen=True)
class LinearDirection(ByColumn):
    """For each box a direction that is linear in the parameters: ``value`` at its middle, and
    ``slopes``, the changes to the ends of its sides.
    """

    value: FloatArray
    slopes: FloatArray

    def reach(self) -> FloatArray:
        """The largest distance from ``value`` within a box."""
        return np.abs(self.slopes).sum(axis=0)

    def where(self, mine: BoolArray, other: LinearDirection) -> LinearDirection:
        """This direction for boxes in the mask, another one for the rest."""
        return LinearDirection(
            np.where(mine, self.value, other.value), np.where(mine, self.slopes, other.slopes)
        )


def constant(value: float, boxes: ParameterBoxes) -> LinearDirection:
    """A constant direction for all boxes."""
    return LinearDirection(np.full(len(boxes), value), np.zeros_like(boxes.low))


def at(boxes: ParameterBoxes, line: LinearDirection) -> Ground:
    """The ground at one direction of each box."""
    none = np.zeros(len(boxes))
    return over(boxes, line, line, none, none)


def over(
    boxes: ParameterBoxes,
    low: LinearDirection,
    high: LinearDirection,
    begin: FloatArray,
    end: FloatArray,
) -> Ground:
    """The ground over all directions between the shares ``begin`` and ``end`` of the way from
    ``low`` to ``high``.
    """
    none = np.zeros_like(begin)
    *own, share = sides(np.vstack([boxes.low, begin]), np.vstack([boxes.high, end]))
    base = Affine(low.value, np.vstack([low.slopes, none]), none)
    way = Affine(high.value, np.vstack([high.slopes, none]), none) - base
    theta = base + share * way
    return Ground(*cosine_and_sine(theta), *cosine_and_sine(own[0]), boxes.parameters(own))


#: A mask of decided cells; and quantities whose affine terms say which side of a box to cut.
Verdict: TypeAlias = tuple[BoolArray, tuple[Rounded, ...]]


def covered(
    boxes: ParameterBoxes,
    low: LinearDirection,
    high: LinearDirection,
    test: Callable[[Ground], Verdict],
) -> Proved:
    """Whether all directions between two pass a test, for each box; and weights of its sides.

    The directions of a box are halved until every cell passes, or the box is abandoned.
    """
    size = len(boxes)
    weight = np.zeros_like(boxes.low)
    cells = 4  # of each box to begin with
    box = np.tile(np.arange(size), cells)
    begin = np.repeat(np.arange(cells) / cells, size)
    end = begin + 1.0 / cells
    result = np.ones(size, dtype=bool)
    halvings = 40  # of a cell, at most
    for halving in range(halvings + 1):
        if not box.size:
            break
        with quiet():
            decided, decisive = test(over(boxes[box], low[box], high[box], begin, end))
        parts = [np.abs(np.nan_to_num(quantity.terms[:, ~decided])) for quantity in decisive]
        # After 4 halvings a box is abandoned if the widths of all quantities come from its sides
        # rather than from the direction.
        useful = [part[-1] > 0.25 * part[:-1].sum(axis=0) for part in parts]
        useless = ~np.logical_or.reduce(useful) & (halving >= 4)
        abandoned = useless | (halving == halvings)
        box, begin, end = box[~decided], begin[~decided], end[~decided]
        for part in parts:
            sizes = part[:-1, abandoned]
            np.maximum.at(
                weight.T, box[abandoned], (sizes / np.maximum(sizes.sum(axis=0), 1e-300)).T
            )
        result[box[abandoned]] = False
        # A box with many open cells fails over a range of directions: no cut helps.
        result[np.bincount(box, minlength=size) > 64] = False
        keep = result[box]
        box, begin, end = box[keep], begin[keep], end[keep]
        middle = 0.5 * (begin + end)
        box = np.tile(box, 2)
        begin = np.concatenate([begin, middle])
        end = np.concatenate([middle, end])
    return result, weight
