"""Regions of sticking states with several frictions, where forces are linear in the coordinates and
no contact opens.

With the coefficients μ_i = h_i μ_s,i and prescribed normal forces N_i, the balance K q + b + S h =
0 maps the box of shares h_i in [−1, 1] to a parallelepiped of states. The least and the largest
value of a coordinate are its middle minus and plus the sizes of all edges along it. A column of S
is μ_s,i N_i times the gradient of the displacement that friction opposes. In these displacements
the measure of the region is 2ᵐ |det(Sᵀ K⁻¹ S)| / Π μ_s,i N_i.

If no force depends on a coordinate, as on a ramp, a column of K is 0 and the one friction has one
share at all states. They form a line along that coordinate, without ends.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import reduce
from operator import add

import numpy as np

from ..core.errors import ConvergenceError, ModelError
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import determinant
from ..numerics.interval_arrays import Intervals, matrix, quiet, stacked
from ..numerics.jets import Jet, constant, gradient, is_linear, variables
from ..numerics.vectors import TURN
from ..results.points import StickingStates
from .shares import held
from .sticking_sets import StickingSystem, sets_of, solved


class NotLinear(ModelError):
    """Raised if forces are not linear in coordinates and shares, or if a contact opens."""


@dataclass(frozen=True)
class _Linear:
    """The forces K q + b + S h of coordinates and shares, with shapes (n, n), (n,) and (n, m).

    ``most`` are μ_s N of all frictions that hold, (m, 1); None if a contact does not press.
    """

    system: StickingSystem
    K: Intervals
    b: Intervals
    S: Intervals
    most: Intervals | None

    @classmethod
    def of(cls, p: ParameterSet, own: ParameterSet) -> _Linear:
        """The linear forces of scalar parameters; ``own`` are parameters of the model with shares.

        Raises NotLinear if the forces are not linear.
        """
        key, *others = own.model.regimes
        system, shape = StickingSystem(p.model, own, key), (1,)
        balance, n = system.balance, system.balance.n
        if others or balance.opens or balance.springs:
            raise NotLinear(f"forces of {p.model.name} are not linear, or a contact opens")
        with quiet():
            zeros = [Intervals(np.zeros((2, *shape)))] * (n + len(system.rows))
            moved, shares = variables(zeros, 2), [balance.parameters[row] for row in system.rows]
            values = balance.over(Intervals.point(system.given))
            values |= dict(zip(shares, moved[n:], strict=True))
            rows = balance.at(moved[:n], values, shape).rows("forces")
            if not all(is_linear(row) for row in rows if isinstance(row, Jet)):
                raise NotLinear(
                    f"forces of {p.model.name} are not linear in coordinates and friction"
                )
            slopes = matrix([gradient(row, len(moved)) for row in rows], shape)[:, :, 0]
            b = stacked([constant(row) for row in rows], shape)[:, 0]
            origin = system.origin()
            most = abs(system.pulls(origin))
            pressed = system.pressed(origin)[0] and most.magnitude.all()
        return cls(system, slopes[:, :n], b, slopes[:, n:], most if pressed else None)


def region(p: ParameterSet, own: ParameterSet) -> StickingStates:
    """All sticking states of scalar parameters in which every friction that can hold does;
    NotLinear if forces are not linear.
    """
    linear = _Linear.of(p, own)
    if linear.most is None:
        return sets_of(p, [], ["measure"])
    with quiet():
        right = np.concatenate([linear.b.ends[:, :, None], linear.S.ends], axis=2)
        K = np.repeat(linear.K.ends[:, :, :, None], right.shape[2], axis=3)
        found = -solved(Intervals(K), Intervals(right))[..., None]
        if not np.isfinite(found.ends).all():
            raise ConvergenceError(
                "det K is 0, or too near to it: states of sticking form sets without an end, or "
                "there are none; change a parameter"
            )
        ends = list[Intervals]()
        for middle, *edges in found:
            reach = reduce(add, map(abs, edges))
            ends += [middle - reach, middle + reach]
        pairs = zip(linear.S[..., None], found, strict=True)
        products = reduce(add, (one[:, None] * other[None, 1:] for one, other in pairs))
        count = len(linear.system.rows)
        measure = abs(determinant([list(row) for row in products])) * 2**count
    return sets_of(p, [*ends, measure / math.prod(linear.most)], ["measure"])


def line(p: ParameterSet, own: ParameterSet) -> StickingStates | None:
    """All sticking states with one friction, if no force depends on one of the coordinates; else
    None.
    """
    try:
        linear = _Linear.of(p, own)
    except NotLinear:
        return None
    free = np.flatnonzero(~linear.K.ends.any(axis=(0, 1))).tolist()
    if len(free) != 1:
        return None
    if linear.most is None:
        return sets_of(p, [])
    with quiet():
        A = np.concatenate([np.delete(linear.K.ends, free, axis=2), linear.S.ends], axis=2)
        *found, share = solved(Intervals(A[..., None]), -linear.b[:, None])
    if not np.isfinite(share.ends).all():
        return None
    if share.low[0] > 1 or share.high[0] < -1:
        return sets_of(p, [])
    if share.magnitude[0] > 1:
        raise ConvergenceError(
            "whether friction is at its limit or beyond it is not known; change a parameter"
        )
    reach = Intervals.point([TURN / 2 if free[0] in linear.system.balance.periodic else np.inf])
    ends = [part for one in found for part in (one, one)]
    ends[2 * free[0] : 2 * free[0]] = [-reach, reach]
    return sets_of(p, ends)


def is_convex(p: ParameterSet) -> bool:
    """Whether all sticking states are proved to form one convex set.

    They do if forces are linear: the balance and |h_i| ≤ 1 are linear in coordinates and shares.
    """
    try:
        return _Linear.of(p, held(p)).most is not None
    except (ModelError, ConvergenceError):
        return False
