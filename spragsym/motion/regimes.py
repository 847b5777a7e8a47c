"""Long-run behaviour of a motion: regimes, the limit that it has, and whether two limits are
one.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from itertools import zip_longest
from typing import Any, TypeAlias

import numpy as np

from ..bifurcation.connected_rest import connected
from ..bifurcation.sticking import sticking_states
from ..bifurcation.sticking_regions import is_convex
from ..core.errors import ConvergenceError, ModelError, ParameterError
from ..display import Column, named_fields
from ..models.field import SETTLED_SHARE, Field, Values
from ..models.parameters import FloatArray, ParameterSet
from ..numerics.vectors import WholeTurns, apart, in_one_turn, magnitude
from ..results.result import Named
from .holding import held_along
from .scales import scales_of

#: Equilibria of one set of parameters, found by Newton's method, that differ by less than this are
#: one, in units of the motion.
SAME_STATE = 1e-6


class Regime(IntEnum):
    """Limit of a motion: what it settles to, or approaches.

    Examples
    --------
    >>> import spragsym as ss
    >>> ss.simulate(ss.Parameters.article(theta0=0.5, V=0.1), t_end=4000.0).outcome(3000.0).regime
    <Regime.APPROACHES_EQUILIBRIUM: 5>
    """

    FAILED = 0
    """There is no result; the reason says why."""
    EQUILIBRIUM = 1
    """Rests at a steady-sliding equilibrium that attracts it, or does not repel it where nothing
    damps; or sticks for good.
    """
    LIMIT_CYCLE = 2
    """Repeats itself on a cycle that attracts it."""
    LIFT_OFF = 3
    """Has no contact with the belt, and too little energy ever to come back to it."""
    UNSETTLED = 4
    """None of these, and none that it is seen to approach: a long transient, quasi-periodic or
    irregular.
    """
    APPROACHES_EQUILIBRIUM = 5
    """Decays to an equilibrium at the rate of the linearization there, and is still on its way."""
    APPROACHES_CYCLE = 6
    """Winds onto a cycle at the rate of the cycle's multipliers, and is still on its way."""

    @property
    def attractor(self) -> str:
        """``"rest"``, ``"cycle"`` or ``"lift-off"``, that it comes to or approaches; or empty."""
        if self in (Regime.EQUILIBRIUM, Regime.APPROACHES_EQUILIBRIUM):
            return "rest"
        if self in (Regime.LIMIT_CYCLE, Regime.APPROACHES_CYCLE):
            return "cycle"
        return "lift-off" if self == Regime.LIFT_OFF else ""


#: Columns of what motions come to: two codes, then numbers.
LIMITS: tuple[Column, ...] = (
    Column("regime", "1", "what the motion settles to or approaches", Regime),
    Column("equilibrium", "1", "index of the equilibrium that it comes to; -1 for none"),
    Column("period", "s", "period of the cycle that it is on or approaches; NaN for none"),
    Column("rate", "1/s", "rate at which what the motion settles to or approaches attracts"),
    Column("distance", "1", "what is left: of the reach of a cycle, or of the unit for rest"),
    Column("cycle_mean", "{x}", "mean of {x} over one period of the cycle"),
    Column("cycle_rms", "{x}", "root mean square of {x} about zero over one period of the cycle"),
    Column("rest_{q}", "{q}", "{q} of the equilibrium that it comes to; NaN for none"),
    Column("cycle_{v}", "{v}", "{v} of the cycle where its first coordinate is largest"),
)


@dataclass(frozen=True)
class Outcome(Named):
    """The attractor that a motion reaches or approaches, and how fast.

    A number of ``rest`` or ``cycle`` is an attribute of its name too, as ``rest_x``, ``rest_y`` and
    ``cycle_vy``; NaN for none.

    Attributes
    ----------
    regime : Regime
    equilibrium : int
        For EQUILIBRIUM and APPROACHES_EQUILIBRIUM its index among ``equilibria(p)`` at the friction
        μ(V); −1 otherwise.
    rest : tuple of float, length n
        The coordinates of that equilibrium, in the order of the model, without a clock's; empty
        for none.
    rate : float
        Of the approach in the long run, exp(−rate τ), from the limit's own eigenvalues or
        multipliers; infinite where sticking ends all deviations. Along a set of states that
        friction holds nothing is approached. NaN where there is none.
    distance : float
        What is left to the limit when the motion ends: relative to the motion's reach for a cycle,
        in L_0 for rest.
    period, cycle_mean, cycle_rms : float
        Of the cycle itself: period, mean of x, the first coordinate, and root mean square of x
        about zero over one whole period. NaN for no cycle, and the last two where x turns around:
        then the cycle is one modulo a turn.
    cycle : tuple of float, length 2 n
        The cycle's state where x is largest (there x' = 0), its first coordinate that moves, or
        where that passes 0 if it turns around and never back: one point, which with the equations
        is the whole orbit. Empty for no cycle.
    names : tuple of str, length 2 n
        Of the coordinates, then of their rates. Those that come around after 2π are in the turn
        from −π + 0.0123 on.
    """

    schema = LIMITS

    regime: Regime = Regime.UNSETTLED
    equilibrium: int = -1
    rest: tuple[float, ...] = ()
    rate: float = np.nan
    distance: float = np.nan
    period: float = np.nan
    cycle_mean: float = np.nan
    cycle_rms: float = np.nan
    cycle: tuple[float, ...] = ()
    names: tuple[str, ...] = ()

    @property
    def _items(self) -> dict[str, float]:
        return self.places()

    def places(self) -> dict[str, float]:
        """The numbers of ``rest`` and ``cycle`` by their names.

        Returns
        -------
        dict
            Numbers by ``rest_`` or ``cycle_`` with the name of a component.

        Examples
        --------
        >>> import spragsym as ss
        >>> tr = ss.simulate(ss.load("stick_slip").Parameters(V=0.2), t_end=200.0)
        >>> sorted(tr.outcome().places())
        ['cycle_vx', 'cycle_x', 'rest_x']
        """
        coordinates = self.names[: len(self.names) // 2]
        rest = zip_longest(coordinates, self.rest, fillvalue=np.nan)
        cycle = zip_longest(self.names, self.cycle, fillvalue=np.nan)
        return {f"rest_{name}": value for name, value in rest} | {
            f"cycle_{name}": value for name, value in cycle
        }

    @property
    def limit(self) -> Regime:
        """The attractor behind the regime."""
        # The attractor behind a regime.
        attractor = {
            Regime.APPROACHES_EQUILIBRIUM: Regime.EQUILIBRIUM,
            Regime.APPROACHES_CYCLE: Regime.LIMIT_CYCLE,
        }
        return attractor.get(self.regime, self.regime)

    def _shown(self) -> dict[str, Any]:
        values = named_fields(self)
        for key in ("names", "rest", "cycle"):
            del values[key]
        return values | {
            name: value for name, value in self.places().items() if not np.isnan(value)
        }

    @property
    def cycle_spread(self) -> float:
        """Root mean square of x about its mean over one period."""
        if self.period > 0:
            return float(np.sqrt(max(self.cycle_rms**2 - self.cycle_mean**2, 0.0)))
        return float("nan")


#: Boxes of connected sets of rest, the least and the largest of each coordinate: (k, 2, n).
Sets: TypeAlias = FloatArray


@dataclass(frozen=True)
class RestSets:
    """The connected sets of states in which friction holds where nothing moves, of scalar
    parameters, each of them one attractor.
    """

    p: ParameterSet

    @cached_property
    def boxes(self) -> Sets | None:
        """Boxes of all sets; None where these are not told apart."""
        try:
            found = sticking_states(self.p)
        except (ParameterError, ConvergenceError, ModelError):
            return None
        if not found.complete:
            return None
        ends = [
            [found.ends[f"{name}_{end}"] for name in self.p.model.coordinates]
            for end in ("low", "high")
        ]
        return np.moveaxis(np.array(ends), 2, 0)

    @cached_property
    def convex(self) -> bool:
        """Whether all states in which friction holds are proved to form one convex set."""
        return is_convex(self.p)

    def in_one(self, one: FloatArray, other: FloatArray, near: FloatArray) -> bool | None:
        """Whether two places of rest lie in one set; None where that is not known."""
        model = self.p.model
        field, constants = model.field, model.field.constants(self.p.scalars(*self.p.ranges))
        ends = [field.at_rest(position.tolist(), constants) for position in (one, other)]
        if not all(field.stays(field.initial_mode(end, constants)) for end in ends):
            return False
        if field.clock:
            one, other = map(np.array, ends)
            return held_along(field, constants, one, other, np.append(near, 0.0)) or None
        if self.boxes is not None:
            places = [
                _sets_that_hold(each, self.boxes, field.periodic, near) for each in (one, other)
            ]
            if [len(position) for position in places] == [1, 1]:
                return places[0] == places[1]
        return self.convex or connected(self.p, one, other, near) or None


def same_limit(
    one: Outcome,
    other: Outcome,
    field: Field,
    constants: Values,
    sets: RestSets | None = None,
) -> bool | None:
    """Whether two motions of one set of parameters have one limit, by all numbers of its state, in
    units of the motion there; None where that is not known.

    Each of the ``sets`` of rest is one limit. What has no limit is not told apart.
    """
    if one.limit != other.limit:
        return False
    if one.limit not in (Regime.EQUILIBRIUM, Regime.LIMIT_CYCLE):
        return True
    periodic = field.periodic
    state, there = (each.cycle or field.at_rest(each.rest, constants) for each in (one, other))
    units = scales_of(field, constants, state).states
    if one.limit == Regime.EQUILIBRIUM:
        near = SAME_STATE * (1 + magnitude(state / units))
        if magnitude(apart(state, there, periodic) / units) < near:
            return True
        pair = np.array(one.rest), np.array(other.rest)
        return sets is not None and sets.in_one(*pair, near * units[: len(one.rest)])
    # Two cycles, by period, averages, and the one state that stands for each, all found by Newton's
    # method.
    turns = np.isnan(one.cycle_mean), np.isnan(other.cycle_mean)
    if turns[0] != turns[1]:
        return False
    averages = np.subtract([one.cycle_mean, one.cycle_rms], [other.cycle_mean, other.cycle_rms])
    off = magnitude(
        [
            *apart(one.cycle, other.cycle, periodic) / units,
            *(() if turns[0] else averages / units[0]),
        ]
    )
    reach = max(abs(each.cycle[0] - each.cycle_mean) for each in (one, other)) / units[0]
    # An x that stands still beside what moves has no reach but rounding.
    far = 10 * SETTLED_SHARE * (1.0 if turns[0] else reach)
    return bool(
        abs(one.period / other.period - 1) < SETTLED_SHARE
        and off < max(far, SAME_STATE * magnitude(one.cycle / units))
    )


def _sets_that_hold(
    rest: FloatArray, sets: Sets, periodic: WholeTurns, near: FloatArray
) -> tuple[int, ...]:
    """Rows of the sets whose boxes hold a place; boxes of several may meet."""
    found = []
    for row, (low, high) in enumerate(sets):
        place = in_one_turn(rest, periodic, low - near)
        if ((low - near <= place) & (place <= high + near)).all():
            found.append(row)
    return tuple(found)
