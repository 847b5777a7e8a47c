"""A box around each cusp of a model in the plane of two parameters, and the boxes left undecided."""

from dataclasses import replace

import numpy as np

from ..numerics import contractors
from ..numerics.arithmetic import cofactor
from ..numerics.certified_roots import Roots, concatenated, different
from ..numerics.interval_arrays import BoolArray, Intervals
from ..numerics.jets import constant, variables
from ..statics.mechanics.precise_balance import clusters
from .bifurcation_conditions import change, cusp
from .defining_systems import Augmented
from .families import Family
from .points import Found, search
from .symmetry import MANY, cusp_off_mirrors


def isolated(family: Family) -> Found:
    """A box for each cusp, and what is left."""
    balance, found = family.balance, search(family, cusp_off_mirrors(family))
    roots = _cusps(family, found, 0)
    for column in range(1, balance.n):
        # A cusp at which a column of the adjugate is 0, as on a mirror, is a double root with it, and regular with another one.
        hulls = clusters(roots.left, roots.left_point)[0] if roots.left_point.size <= MANY else roots.left[:, :, :0]
        for hull in np.moveaxis(hulls, 2, 0):
            spans = np.stack([-hull[0], hull[1]], axis=-1)[balance.n :]
            near = replace(family, spans=spans, asked=hull[:, : balance.n])
            more = _cusps(near, search(near, cusp_off_mirrors(near, column)), column)
            if not more.left_point.size:
                open_ = ~contractors.within(roots.left, hull[:, :, None])
                roots = different(concatenated([roots.kept(left=open_), more], roots.ends.shape[1]), found.region)
    return replace(found, roots=roots)


def _cusps(family: Family, found: Found, column: int) -> Roots:
    """The roots that are cusps, and those of which that is not known among what is left."""
    proved, unclear = told_apart(family, found, column)
    return found.roots.kept(proved).besides(found.roots.ends[:, :, unclear], found.roots.point[unclear])


def told_apart(family: Family, found: Found, column: int) -> tuple[BoolArray, BoolArray]:
    """Which roots are cusps, and of which that is not known.

    A root is a cusp if the column in use is not 0 there, and none if det K changes along another column.
    """
    ends, n = found.roots.ends, family.balance.n
    shape = ends.shape[2:]
    nonzero, none = np.zeros((2, *shape), dtype=np.bool_)
    if not shape[0]:
        return nonzero, none
    system = Augmented(family, cusp(column))
    with np.errstate(all="ignore"):
        K = system.state(variables(list(Intervals(ends)), 1), system.fixed(shape[0]), shape).slopes()
        for i in range(n):
            value = constant(cofactor(K, column, i))
            nonzero |= ~value.holds_zero() if isinstance(value, Intervals) else np.full(shape, value != 0)
        for other in set(range(n)) - {column}:
            none |= ~change(K, other).value.holds_zero()
    return nonzero & ~none, ~nonzero & ~none
