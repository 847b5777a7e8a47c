"""Values of a parameter at which a state runs to infinity, proved: roots of the balance in a chart at infinity.

With q = u/w and one |u_i| = 1, the rows of the balance are G(u, w, λ) but for powers of w, see
:mod:`spragsym.statics.mechanics.infinity`. At a regular root of G = 0 with w = 0 in the other u and λ one curve of states begins,
λ = λ* + λ' w + …: for w → 0 its state runs to infinity along u, on the side of λ* that λ' says.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..numerics import boxes, certified_roots
from ..numerics.arithmetic import determinant
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, stacked
from ..numerics.jets import Jet, constant, gradient, variables
from ..results.points import Points
from ..statics.mechanics.forces import TURN
from ..statics.mechanics.infinity import SCALED, NoChart, Scaled
from .families import Family

#: Directions that are searched, beyond those of 45 degrees; boxes of one chart.
BESIDE, BUDGET = 1.0 + 2.0**-6, 4000
#: Two directions nearer than this are the same one, found in two charts.
SAME = 1e-6
#: What kinds of such points begin with.
INFINITY = "infinity"


class _Chart(boxes.System):
    """G at w = 0 with u_pivot = ±1; unknowns are the other u, angles that come around, and one parameter or two.

    With two the curve of values at infinity turns back in the last one: ∂G/∂(u, first) is singular.
    """

    def __init__(self, family: Family, pivot: int, sign: int) -> None:
        self.balance, self.vary, self.pivot, self.sign = family.balance, family.vary, pivot, sign
        self.others = [i for i in range(self.balance.n) if i != pivot]
        self.n, self.order = len(self.others) + len(self.vary), len(self.vary) - 1

    def prepared(self, bounds: Intervals) -> Intervals:
        """Prepared parameters of the balance."""
        return self.balance.prepared(bounds)

    def rows(self, unknowns: Sequence[Any], parameters: Intervals) -> tuple[list[Any], Any]:
        """G and the gap but for powers of w, of intervals, or jets of them in which w is one more variable."""
        order = max((part.order for part in unknowns if isinstance(part, Jet)), default=0)
        w = Jet.variable(0, self.n, order)
        arguments = self.balance.arguments(parameters, dict(zip(self.vary, unknowns[len(self.others) :], strict=True)))
        values = {name: value if isinstance(value, int) else Scaled(value, 0, w) for name, value in arguments.items()}
        q: list[Any] = [Scaled(self.sign, 1, w)] * self.balance.n
        for i, part in zip(self.others, unknowns, strict=False):
            q[i] = part if i in self.balance.around else Scaled(part, 1, w)
        directions = self.balance.plain_directions(q, values, SCALED)
        rows = [*self.balance.by_coordinate("forces", q, directions, values, SCALED), self.balance.gap(q, values, SCALED)]
        *forces, gap = (row.value if isinstance(row, Scaled) else row for row in rows)
        return forces, gap

    def equations(self, unknowns: Sequence[Any], parameters: Intervals) -> Sequence[Any]:
        """G, and with two parameters the determinant."""
        forces, _ = self.rows(unknowns, parameters)
        if not self.order:
            return forces
        slopes = [[row.differentiated(k) if isinstance(row, Jet) else 0 for k in range(self.n - 1)] for row in forces]
        return [*forces, determinant(slopes)]

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes of directions in which the contact opens."""
        if not self.balance.opens:
            return np.zeros(unknowns.shape[1:], dtype=np.bool_)
        _, gap = self.rows(list(unknowns), parameters)
        return self.balance.sides(stacked([constant(gap)], unknowns.shape[1:])[0])[1]

    def exists(self, unknowns: Intervals, parameters: Intervals) -> IntArray:
        """On which side of the value the state is, 1 or −1; 0 where that is not known."""
        slopes = [gradient(row, self.n + 1) for row in self.rows(variables(list(unknowns), 1), parameters)[0]]
        moved = determinant([[*row[: self.n - 1], -row[self.n]] for row in slopes])
        ratio = stacked([moved, determinant([row[: self.n] for row in slopes])], unknowns.shape[1:])
        sign = (ratio.low > 0).astype(np.int64) - (ratio.high < 0)
        return sign[0] * sign[1]


def escapes(family: Family) -> Points:
    """Values of a parameter at which a state in contact runs to infinity; of two, those at which they are extreme in the second.

    The kind is ``"infinity up"`` where the state is there above the value, else ``"infinity down"``; coordinates are infinite,
    NaN those that stay. What is not proved is missing: a state runs to infinity there, others may elsewhere.
    """
    balance = family.balance
    found, known = list[list[float]](), list[FloatArray]()
    for pivot in (i for i in range(balance.n) if i not in balance.around):
        for sign in (1, -1):
            for middle, error, side in _of_chart(_Chart(family, pivot, sign), family):
                z = np.concatenate([np.insert(middle[: balance.n - 1], pivot, float(sign)), middle[balance.n - 1 :]])
                z[: balance.n] /= np.abs(np.delete(z[: balance.n], balance.around)).max()
                if any(np.abs(z - other).max() < SAME for other in known):
                    continue
                known.append(z)
                away = np.where(np.abs(z[: balance.n]) < SAME, np.nan, np.copysign(np.inf, z[: balance.n]))
                away[balance.around] = np.nan
                found.append([*z[balance.n :], *away, error, side])
    names = (*family.vary, *balance.coordinates)
    *places, errors, sides = np.array(found).reshape(-1, len(names) + 2).T
    columns = dict(zip(names, places, strict=True))
    kind = np.select([sides > 0, sides < 0], [f"{INFINITY} up", f"{INFINITY} down"], INFINITY)
    return Points(family.p, family.vary, kind, errors, family.spans, True, (), np.empty((0, len(names), 2)), (), columns)


def _of_chart(chart: _Chart, family: Family) -> list[tuple[FloatArray, float, int]]:
    """Roots in one chart, bounds on their errors, and sides."""
    balance = chart.balance
    sides = [[TURN, TURN] if i in balance.around else [BESIDE, BESIDE] for i in chart.others]
    around, fixed = np.array([*sides, *([-low, high] for low, high in family.spans)]).T[:, :, None], family.begin
    try:
        with np.errstate(all="ignore"):
            roots = certified_roots.search(chart, around, fixed, fixed, budget=BUDGET)
            unknowns = Intervals(roots.ends)
            prepared = chart.prepared(Intervals.point(np.repeat(fixed, roots.point.size, axis=1)))
            side = chart.exists(unknowns, prepared) if len(chart.vary) == 1 and roots.point.size else np.zeros(roots.point.size)
    except NoChart:
        return []
    return [(roots.middle[:, k], float(roots.error[k]), int(side[k])) for k in range(roots.point.size)]
