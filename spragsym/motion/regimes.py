"""Long-run behaviour of a motion: its regime (:class:`Regime`), its limit (:class:`Outcome`), and
whether two motions have the same limit (:func:`same_limit`).
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
from ..numerics.vectors import WholeTurns, in_one_turn, magnitude, state_difference
from ..results.result import Named
from .holding import held_along
from .scales import scales_of

#: Equilibria computed by Newton's method are the same if they differ by less than this, in units of
#: the motion.
SAME_STATE = 1e-6


class Regime(IntEnum):
    """Long-run behaviour of a motion: the kind of limit that it settles to or approaches.

    Examples
    --------
    >>> import spragsym as ss
    >>> ss.simulate(ss.Parameters.article(theta0=0.5, V=0.1), t_end=4000.0).outcome(3000.0).regime
    <Regime.APPROACHES_EQUILIBRIUM: 5>
    """

    FAILED = 0
    """No result, for the reason given."""
    EQUILIBRIUM = 1
    """Rests at a steady-sliding equilibrium that attracts it, or, without damping, does not repel
    it; or sticks for good.
    """
    LIMIT_CYCLE = 2
    """Is on a cycle that attracts it."""
    LIFT_OFF = 3
    """Has no contact with the belt, and too little energy ever to return to it: of the article's
    model, whose energy has such wells in closed form. Of others, an equilibrium if a damper brings
    the motion to rest there, else unsettled.
    """
    UNSETTLED = 4
    """None of these, and does not visibly approach one: a long transient, quasi-periodic or
    irregular.
    """
    APPROACHES_EQUILIBRIUM = 5
    """Decays to an equilibrium at the rate of its linearization, but is not yet there."""
    APPROACHES_CYCLE = 6
    """Approaches a cycle at the rate of its multipliers, but is not yet there."""

    @property
    def attractor(self) -> str:
        """``"rest"``, ``"cycle"`` or ``"lift-off"``, that it comes to or approaches; or empty."""
        if self in (Regime.EQUILIBRIUM, Regime.APPROACHES_EQUILIBRIUM):
            return "rest"
        if self in (Regime.LIMIT_CYCLE, Regime.APPROACHES_CYCLE):
            return "cycle"
        return "lift-off" if self == Regime.LIFT_OFF else ""


#: Columns of the limit of a motion: two codes, then numbers.
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
    """The attractor that a motion reaches or approaches, with the rate of approach.

    Each number of ``rest`` and ``cycle`` is an attribute by its name, too, as ``rest_x``,
    ``rest_y`` and ``cycle_vy``; NaN for none.

    Attributes
    ----------
    regime : Regime
    equilibrium : int
        For EQUILIBRIUM and APPROACHES_EQUILIBRIUM the index among ``equilibria(p)`` at the friction
        μ(V); −1 otherwise.
    rest : tuple of float, length n
        Coordinates of that equilibrium, in the order of the model, without the clock's phase; empty
        for none.
    rate : float
        Asymptotic rate of the approach exp(−rate τ), from the eigenvalues or multipliers of the
        limit; infinite if sticking ends all deviations. Deviations along a set of states held by
        friction do not decay, and do not count. NaN for no limit.
    distance : float
        Distance to the limit at the end of the motion: relative to the motion's extent for a cycle,
        over L_0 for rest.
    period, cycle_mean, cycle_rms : float
        Period of the cycle, and mean and root mean square about zero of x, the first coordinate,
        over this period. NaN for no cycle. The last two are NaN if x rotates: then the cycle is
        closed modulo a turn.
    cycle : tuple of float, length 2 n
        State of the cycle where x, its first coordinate that moves, is largest, so that x' = 0; or
        where x passes 0, if it rotates in one direction. Empty for no cycle.
    names : tuple of str, length 2 n
        Names of the coordinates, then of their rates. Coordinates of period 2π are in the turn that
        begins at −π + 0.0123.
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
        return {**super()._items, **self.places()}

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
        """The kind of attractor, whether it is reached or approached."""
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
        """Standard deviation of x over one period."""
        if self.period > 0:
            return float(np.sqrt(max(self.cycle_rms**2 - self.cycle_mean**2, 0.0)))
        return float("nan")


#: Boxes around k connected sets of rest: lower and upper end of each coordinate, (k, 2, n).
Sets: TypeAlias = FloatArray


@dataclass(frozen=True)
class RestSets:
    """The connected sets of states of rest that friction holds, for scalar parameters. Each set
    counts as one attractor.
    """

    p: ParameterSet

    @cached_property
    def boxes(self) -> Sets | None:
        """Boxes around all sets; None if the sets could not be computed completely."""
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
        """True if all states that friction holds are proved to form one convex set."""
        return is_convex(self.p)

    def in_one(self, one: FloatArray, other: FloatArray, near: FloatArray) -> bool | None:
        """True if two positions of rest, (n,), are in the same set; None if that is not known.

        ``near`` is the tolerance in each coordinate.
        """
        model = self.p.model
        field, constants = model.field, model.field.constants(self.p.scalars(*self.p.ranges))
        positions = [position.tolist() for position in (one, other)]
        if not all(field.stays(field.resting_mode(each, constants)) for each in positions):
            return False
        if field.clock:
            one, other = (np.array(field.at_rest(each, constants)) for each in positions)
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
    """True if two motions with the same parameters have the same limit; None if that is not known.

    Equilibria are compared by their coordinates, cycles by period, averages and one state, in units
    of the motion. Each of the ``sets`` of rest is one limit. Motions without a limit count as
    equal.
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
        if magnitude(state_difference(state, there, periodic) / units) < near:
            return True
        pair = np.array(one.rest), np.array(other.rest)
        return sets is not None and sets.in_one(*pair, near * units[: len(one.rest)])
    rotates = bool(np.isnan(one.cycle_mean))  # the averages of a rotating x are NaN
    if rotates != np.isnan(other.cycle_mean):
        return False
    differences, amplitude = state_difference(one.cycle, other.cycle, periodic) / units, 1.0
    if not rotates:
        averages = np.subtract([one.cycle_mean, one.cycle_rms], [other.cycle_mean, other.cycle_rms])
        differences = np.append(differences, averages / units[0])
        amplitude = max(abs(each.cycle[0] - each.cycle_mean) for each in (one, other)) / units[0]
    # The amplitude is 0 if x stands still: then rounding of the state sets the tolerance.
    tolerance = max(10 * SETTLED_SHARE * amplitude, SAME_STATE * magnitude(one.cycle / units))
    return bool(
        abs(one.period / other.period - 1) < SETTLED_SHARE and magnitude(differences) < tolerance
    )


def _sets_that_hold(
    rest: FloatArray, sets: Sets, periodic: WholeTurns, near: FloatArray
) -> tuple[int, ...]:
    """Indices of the sets whose boxes contain a position; boxes may overlap."""
    found = []
    for row, (low, high) in enumerate(sets):
        place = in_one_turn(rest, periodic, low - near)
        if ((low - near <= place) & (place <= high + near)).all():
            found.append(row)
    return tuple(found)
