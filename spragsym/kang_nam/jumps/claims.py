"""Claims over a box of parameters: for each a proof for many boxes, and a search for counterexamples."""

import math
from collections.abc import Callable

import numpy as np

from ...bifurcation.paths import first_end
from ...generated import catastrophe as _catastrophe
from ...models.parameters import NAMES, FloatArray, Parameters
from ...numerics.affine import Affine
from ...numerics.interval_arrays import BoolArray
from ...results.equilibria import Stability
from ..quartic import kernel
from ..quartic.solver import count, equilibria
from .cells import Boxes, Ground, Line, Verdict, at, constant, covered
from .jump_values import first_jumps, point_at, small

_MU0 = NAMES.index("mu0")
#: A little more than π, beyond which no direction is in contact.
_ALL = math.pi + 1e-15
#: How far a trial direction lies from the state it stands for, in units of how far that state moves within the box: the wide one
#: leaves room for terms of second order, the narrow one is for boxes near a fold.
_MARGINS = (0.7, 0.25)


def _balance(ground: Ground, others: list[Affine]) -> tuple[Affine, Affine, Affine, Affine]:
    """f, f′, f_μ₀ and f_μ₀′."""
    return kernel.f_in_differences(ground.c, ground.s, ground.c0, ground.s0, *others)


def _not_in_contact(ground: Ground, others: list[Affine]) -> BoolArray:
    """y ≥ 0 for the state of any direction here: κ ≤ σ (sin θ₀ − sin θ)."""
    return (others[1] - others[3] * (ground.s0 - ground.s)).sign() < 0


# ----------------------------------------------------------------------------------------------- all states in contact


def _at_all_states(boxes: Boxes, slope_sign: int, discriminant: bool) -> tuple[BoolArray, FloatArray]:
    """Every equilibrium in contact has f′ of a sign, or a positive discriminant of K in λ² if that is asked for too."""

    def test(ground: Ground) -> Verdict:
        others = ground.others()
        value, slope, _, _ = _balance(ground, others)
        done = (value.sign() != 0) | (slope.sign() == slope_sign) | _not_in_contact(ground, others)
        if not discriminant:
            return Verdict(done, (value, slope))
        L, _, _ = kernel.state(ground.c, ground.s, ground.c0, ground.s0, others[1], others[3], others[4], 1)
        K = kernel.stiffness(ground.c, ground.s, L, others[0], others[2], others[3], others[4], 1)
        flutter = kernel.invariants(*K[0], *K[1])[2]
        return Verdict(done | (flutter.sign() > 0), (value, slope, flutter))

    return covered(boxes, constant(0.0, boxes), constant(_ALL, boxes), test)


def _one_equilibrium(boxes: Boxes) -> tuple[BoolArray, FloatArray]:
    """Every equilibrium has f′ > 0. Of three the middle one has not, and of two that meet neither has: so there is one."""
    return _at_all_states(boxes, 1, False)


def _no_flutter(boxes: Boxes) -> tuple[BoolArray, FloatArray]:
    """Every equilibrium in contact has f′ < 0, which is divergence, or a positive discriminant of K in λ²."""
    return _at_all_states(boxes, -1, True)


# ------------------------------------------------------------------------------------------------------------ no jump


def _no_jump(boxes: Boxes) -> tuple[BoolArray, FloatArray]:
    """On the surface μ₀(θ) rises from below 0 at one direction to above the largest friction at another, and is 0 once between,
    at the reference state: so that is followed without a fold.

    Candidates for the two directions come from the middle of a box, and the proof does not depend on how.
    """
    result, weight = _followed_with(boxes, _MARGINS[0])
    for margin in _MARGINS[1:]:
        left = np.flatnonzero(~result)
        if left.size:
            result[left], weight[:, left] = _followed_with(boxes[left], margin)
    return result, weight


def _followed_with(boxes: Boxes, margin: float) -> tuple[BoolArray, FloatArray]:
    with np.errstate(all="ignore"):
        *lines, known = _directions(boxes, margin)
    result, weight = known.copy(), np.zeros_like(boxes.low)
    for check in (_ends_hold, _rises, _is_small):
        some = np.flatnonzero(result)
        if some.size:
            result[some], weight[:, some] = check(boxes[some], *(line[some] for line in lines))
    return result, weight


def _directions(boxes: Boxes, margin: float) -> tuple[Line, Line, Line, BoolArray]:
    """A direction below the state at μ₀ = 0, one above it, one above the state at the largest friction; where they exist."""
    middle = boxes.middle() | {"mu0": boxes.high[_MU0]}
    bare = equilibria(Parameters(**middle).replace(mu0=0.0))
    full = equilibria(Parameters(**middle))
    first = np.take_along_axis(bare.theta, small(bare)[:, None], axis=-1)
    later = np.where(full.theta >= first, full.theta, np.inf).min(axis=-1)
    low, above = (_moved(boxes, middle | {"mu0": np.zeros_like(later)}, first[:, 0], side * margin) for side in (-1, 1))
    high = _moved(boxes, middle, later, margin)
    known = np.isfinite(later) & bare.decided & full.decided
    known &= (low.value - low.reach() > 0) & (high.value + high.reach() < math.pi)
    return low, above, high, known


def _moved(boxes: Boxes, values: dict[str, FloatArray], theta: FloatArray, margin: float) -> Line:
    """How an equilibrium of the middle moves over the box, to first order, and a little to one side of that."""
    slopes = boxes.change(_motion(values, theta))
    slopes[_MU0] = 0.0
    line = Line(theta, slopes)
    return Line(theta + margin * line.reach() + np.copysign(1e-9, margin), slopes)


def _motion(values: dict[str, FloatArray], theta: FloatArray) -> dict[str, FloatArray]:
    """How an equilibrium moves with each parameter: dθ/dp by name."""
    c, s, c0, s0 = np.cos(theta), np.sin(theta), np.cos(values["theta0"]), np.sin(values["theta0"])
    others = [values[name] for name in NAMES[1:]]
    slope = kernel.f_slope(c, s, *kernel.f_coefficients(c0, s0, *others, 1))
    changes = _catastrophe.unfolding(c, s, c0, s0, *others)
    return {name: -change / slope for name, (change, _) in zip(NAMES, changes, strict=True)}


def _with_friction(ground: Ground, friction: FloatArray) -> list[Affine]:
    others = ground.others()
    others[0] = Affine(friction, np.zeros_like(others[1].terms), np.zeros_like(friction))
    return others


def _ends_hold(boxes: Boxes, lowest: Line, start: Line, highest: Line) -> tuple[BoolArray, FloatArray]:
    """f < 0 at the lowest direction without friction, f > 0 at the highest one with the largest; both in contact."""
    result, weight = np.ones(len(boxes), dtype=np.bool_), np.zeros_like(boxes.low)
    none = np.zeros(len(boxes))
    for line, friction, wanted in ((lowest, none, -1), (highest, boxes.high[_MU0], 1)):
        ground = at(boxes, line)
        others = _with_friction(ground, friction)
        value = _balance(ground, others)[0]
        inside = others[1] - others[3] * (ground.s0 - ground.s)
        known = value.sign() == wanted, inside.sign() > 0
        result &= known[0] & known[1]
        # A direction that follows the state leaves what is of second order, in each of the parameters that a side changes.
        second = boxes.change(_motion(boxes.middle() | {"mu0": friction}, line.value), np.abs)
        second[_MU0] = 0.0
        first = np.abs(inside.terms[:-1])
        straight = known[0] & ~known[1] & (first.sum(axis=0) > inside.error)
        weight = np.maximum(weight, np.where(straight, first / np.maximum(first.sum(axis=0), 1e-300), second**2))
    return result, weight


def _rises(boxes: Boxes, lowest: Line, start: Line, highest: Line) -> tuple[BoolArray, FloatArray]:
    """μ₀(θ) rises between the two directions: f′ f_μ₀ − f f_μ₀′ < 0, in which μ₀ cancels."""

    def test(ground: Ground) -> Verdict:
        others = _with_friction(ground, np.zeros_like(ground.c.value))
        value, slope, change, change_slope = _balance(ground, others)
        rise = slope * change - value * change_slope
        return Verdict(rise.sign() < 0, (rise,))

    return covered(boxes, lowest, highest, test)


def _is_small(boxes: Boxes, lowest: Line, start: Line, highest: Line) -> tuple[BoolArray, FloatArray]:
    """The state at μ₀ = 0 between ``lowest`` and ``start`` has the smallest \\|x\\|.

    Without friction at most one equilibrium has cos θ of the sign of cos θ₀, and any other has \\|x\\| ≥ \\|cos θ₀\\|: see
    ``smallest_without_friction`` in derive/kang_nam/theorem.py. So L \\|cos θ\\| < 2 \\|cos θ₀\\| is enough, or that there is no
    other.
    """
    ground = at(boxes, start)
    others = _with_friction(ground, np.zeros(len(boxes)))
    above = _balance(ground, others)[0].sign() > 0
    side = ground.c0.sign()
    near = lowest.where(side > 0, start)
    ground = at(boxes, near)
    L, _, _ = kernel.state(
        ground.c, ground.s, ground.c0, ground.s0, *(ground.parameters[n] for n in ("kappa", "sigma", "beta")), 1
    )
    reach = 2 * ground.c0 - L * ground.c
    far = at(boxes, start.where(side > 0, lowest)).c.sign() * side > 0
    result = above & far & (side != 0) & (reach.sign() * side > 0)
    left = np.flatnonzero(above & ~result)
    if left.size:
        some = boxes[left]
        below = _alone(some, constant(0.0, some), lowest[left])
        result[left] = below & _alone(some, start[left], constant(_ALL, some))
    return result, np.abs(reach.terms[:-1])


def _alone(boxes: Boxes, low: Line, high: Line) -> BoolArray:
    """No equilibrium in contact without friction between two directions."""

    def test(ground: Ground) -> Verdict:
        others = _with_friction(ground, np.zeros_like(ground.c.value))
        value = _balance(ground, others)[0]
        return Verdict((value.sign() != 0) | _not_in_contact(ground, others), (value,))

    return covered(boxes, low, high, test)[0]


def _jumps(p: Parameters) -> BoolArray:
    """The first of some points whose state jumps below its friction, by its path too."""
    out = np.zeros(p.shape, dtype=np.bool_)
    for i in np.flatnonzero(first_jumps(p, "mu0", apart_from=p.mu0).value < p.mu0 * (1 - 1e-11))[:1]:
        point = point_at({name: getattr(p, name) for name in NAMES}, i)
        out[i] = first_end(point, "mu0", (0.0, float(point.mu0))) is not None
    return out


#: For each claim, of which boxes it is proved and which side to cut of the others; and at which points it is false.
CLAIMS: dict[str, tuple[Callable[[Boxes], tuple[BoolArray, FloatArray]], Callable[[Parameters], BoolArray]]] = {
    "no jump": (_no_jump, _jumps),
    "one equilibrium": (_one_equilibrium, lambda p: count(p) == 3),
    "no flutter": (_no_flutter, lambda p: (equilibria(p).stability == Stability.FLUTTER).any(axis=-1)),
}
